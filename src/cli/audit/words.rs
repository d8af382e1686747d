//! The words of the command `audit`.

use std::fmt::Display;

use super::super::words::Lang;

/// A file of a folder that is left out.
pub fn no_plan(lang: Lang, file: impl Display) -> String {
    match lang {
        Lang::Uk => format!("{file}: не план, пропущено"),
        Lang::En => format!("{file}: no plan, skipped"),
    }
}

/// A folder in which there is nothing to audit.
pub fn no_plans(lang: Lang, folder: impl Display) -> String {
    match lang {
        Lang::Uk => format!("у теці `{folder}` немає жодного плану"),
        Lang::En => format!("there is no plan in the folder `{folder}`"),
    }
}

/// What to do then.
pub const fn what_is_a_plan(lang: Lang) -> &'static str {
    lang.pick(
        "плани - це файли .yaml, .yml і .json, як їх описує docs/audit.md",
        "plans are files .yaml, .yml and .json as docs/audit.md describes them",
    )
}

/// A folder where one plan is needed.
pub const fn folder_against(lang: Lang) -> &'static str {
    lang.pick("порівняти можна лише два плани, не теку", "only two plans can be compared, no folder")
}

/// What to do then.
pub const fn name_a_plan(lang: Lang) -> &'static str {
    lang.pick("назвіть файл плану", "name a plan file")
}
