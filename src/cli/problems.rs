//! Problems within a page: framed lines of their files on a terminal, findings elsewhere; files that cannot be read.

use std::fmt::Display;
use std::io::{self, ErrorKind};

use technolog::document::{Block, Document, Finding, Inlines, Severity as Colour};
use technolog::knowledge::{Diagnostic, Severity};
use technolog::words::say;

use super::diagnostics::{Texts, render_as_said};
use super::{CliError, Format, Lang};

/// A file or a folder that cannot be read.
pub fn unreadable(path: impl Display, error: &io::Error, lang: Lang) -> CliError {
    let path = path.to_string();
    let message = match error.kind() {
        ErrorKind::NotFound => say!(lang, "cli-not-found", path = path),
        ErrorKind::PermissionDenied => say!(lang, "cli-not-permitted", path = path),
        ErrorKind::IsADirectory => say!(lang, "cli-is-a-folder", path = path),
        _ => say!(lang, "cli-cannot-read", path = path, error = error.to_string()),
    };
    Diagnostic::error("unreadable", message, None).help(lang.word("cli-check-path")).into()
}

/// A page without its title on a terminal, where the command stands above its answer.
pub fn untitled(page: Document, format: Format) -> Document {
    if format == Format::Text { Document { title: Inlines::default(), ..page } } else { page }
}

/// The blocks of these problems, in the order in which they are given.
pub fn blocks(problems: &[Diagnostic], texts: &Texts, format: Format, lang: Lang) -> Vec<Block> {
    match format {
        Format::Text if problems.is_empty() => Vec::new(),
        Format::Text => vec![Block::Code(render_as_said(problems, texts, lang))],
        _ => problems.iter().map(|problem| finding(problem, lang).into()).collect(),
    }
}

fn finding(problem: &Diagnostic, lang: Lang) -> Finding {
    let (severity, word) = match problem.severity {
        Severity::Error => (Colour::Error, "cli-error"),
        Severity::Warning => (Colour::Doubtful, "cli-warning"),
        Severity::Note => (Colour::Note, "cli-note"),
    };
    Finding {
        place: problem.place.as_ref().map(ToString::to_string),
        help: problem.help.as_deref().map(Inlines::sentence),
        ..Finding::new(severity, lang.word(word), Inlines::sentence(&problem.message))
    }
}
