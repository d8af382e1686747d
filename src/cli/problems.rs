//! Problems within a page: framed lines of their files on a terminal, findings elsewhere; and files that cannot be
//! read.

use std::fmt::Display;
use std::io::{self, ErrorKind};

use technolog::document::{Block, Document, FindingBlock, Inlines, Severity as Colour};
use technolog::knowledge::{Diagnostic, Severity, input};
use technolog::words::say;

use super::diagnostics::{Texts, below, hidden, render_within};
use super::output::Screen;
use super::{CliError, Context, Format, Lang};

/// A file or a folder that cannot be read.
pub fn unreadable(path: impl Display, error: &io::Error, lang: Lang) -> CliError {
    let path = path.to_string();
    let message = match error.kind() {
        ErrorKind::NotFound => say!(lang, "cli-not-found", path = path),
        ErrorKind::PermissionDenied => say!(lang, "cli-not-permitted", path = path),
        ErrorKind::IsADirectory => say!(lang, "cli-is-a-folder", path = path),
        _ => say!(lang, "cli-cannot-read", path = path, error = of_system(error, lang)),
    };
    Diagnostic::error("unreadable", message, None).help(lang.word("cli-check-path")).into()
}

/// The system's error message, in the language of the answers.
pub fn of_system(error: &io::Error, lang: Lang) -> String {
    lang.say(&input::of_system(error))
}

/// A page without its title on a terminal, where the command is above its answer.
pub fn untitled(page: Document, format: Format) -> Document {
    if format == Format::Text { Document { title: Inlines::default(), ..page } } else { page }
}

/// The blocks of problems, in the given order: of many the most severe, with the number of others, including `more`
/// that were left out before.
pub fn blocks(problems: Vec<Diagnostic>, more: usize, texts: &Texts, format: Format, context: &Context) -> Vec<Block> {
    let lang = context.lang;
    let (shown, hidden_now) = context.amount.select(problems, |problem| problem.severity);
    let more = more + hidden_now;
    match format {
        Format::Text if shown.is_empty() => Vec::new(),
        Format::Text => {
            let screen = Screen::of(context.output.as_deref());
            let width = if screen.narrow { screen.width } else { usize::MAX };
            vec![Block::Code(render_within(width, &shown, texts, lang) + &below(more, lang))]
        }
        _ => {
            let more = hidden(more, lang).map(|more| Block::Paragraph(more.into()));
            shown.iter().map(|problem| finding(problem, lang).into()).chain(more).collect()
        }
    }
}

fn finding(problem: &Diagnostic, lang: Lang) -> FindingBlock {
    let (severity, word) = match problem.severity {
        Severity::Error => (Colour::Error, "cli-error"),
        Severity::Warning => (Colour::Doubtful, "cli-warning"),
        Severity::Note => (Colour::Note, "cli-note"),
    };
    FindingBlock {
        place: problem.place.as_ref().map(ToString::to_string),
        help: problem.help.as_ref().map(|help| Inlines::sentence(&lang.say(help))),
        ..FindingBlock::new(severity, lang.word(word), Inlines::sentence(&lang.say(&problem.message)))
    }
}
