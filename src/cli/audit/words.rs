//! The words of the command `audit`.

use std::fmt::Display;

use technolog::words::say;

use super::super::words::Lang;

/// A file of a folder that is left out.
pub fn no_plan(lang: Lang, file: impl Display) -> String {
    say!(lang, "audit-skipped-file", file = file.to_string())
}

/// A folder in which there is nothing to audit.
pub fn no_plans(lang: Lang, folder: impl Display) -> String {
    say!(lang, "audit-no-plans", folder = folder.to_string())
}

/// What to do then.
pub fn what_is_a_plan(lang: Lang) -> &'static str {
    lang.word("audit-what-is-a-plan")
}

/// A folder where one plan is needed.
pub fn folder_against(lang: Lang) -> &'static str {
    lang.word("audit-folder-against")
}

/// What to do then.
pub fn name_a_plan(lang: Lang) -> &'static str {
    lang.word("audit-name-a-plan")
}
