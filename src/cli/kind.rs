//! A file of the wrong kind for a command: its probable kind, and the command for it.

use std::borrow::Cow;

use technolog::cases::{FileKind, other_kind};
use technolog::knowledge::Diagnostic;
use technolog::words::say;

use super::diagnostics::Texts;
use super::{CliError, Context};

/// The single problem of a file of another kind; otherwise the problems that were found in it.
pub fn or_other(
    file: &str,
    text: &str,
    wanted: FileKind,
    problems: Vec<Diagnostic>,
    context: &Context,
) -> Vec<Diagnostic> {
    match wrong_kind(file, text, wanted, context) {
        Some(problem) => vec![problem],
        None => problems,
    }
}

/// Checks that a text is of the wanted kind, if its kind can be recognised.
///
/// # Errors
/// It is of another kind.
pub fn refuse_other(file: &str, text: &str, wanted: FileKind, context: &Context) -> Result<(), CliError> {
    let Some(problem) = wrong_kind(file, text, wanted, context) else { return Ok(()) };
    let texts = Texts::default().with(file, file.to_owned(), Cow::Owned(text.to_owned()));
    Err(CliError::Unusable { problems: vec![problem], texts })
}

/// The problem of a file of another kind; none if it may be of the wanted one.
pub fn wrong_kind(file: &str, text: &str, wanted: FileKind, context: &Context) -> Option<Diagnostic> {
    let (kind, place) = other_kind(file, text, wanted)?;
    let [is, wanted] = [kind, wanted].map(|kind| context.word(kind.name()));
    let message = say!(context.lang, "cli-other-kind", is = is, wanted = wanted);
    let help = match kind {
        FileKind::Part => say!(context.lang, "cli-kind-command", command = format!("technolog plan {file}")),
        FileKind::Turned => say!(context.lang, "cli-kind-turned", file = file),
        FileKind::Plan => say!(context.lang, "cli-kind-command", command = format!("technolog audit {file}")),
        FileKind::Cases => say!(context.lang, "cli-kind-command", command = format!("technolog test {file}")),
        FileKind::Program => say!(context.lang, "cli-kind-command", command = format!("technolog check {file}")),
        FileKind::Setting => say!(context.lang, "cli-kind-setting-of", file = file),
        FileKind::Marks => say!(context.lang, "cli-kind-marks-of", file = file),
        FileKind::Table => context.word("cli-kind-table-of").to_owned(),
        FileKind::List | FileKind::Yaml => context.word("cli-kind-help").to_owned(),
    };
    Some(Diagnostic::error("other-kind", message, place).help(help))
}
