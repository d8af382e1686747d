//! Problems within a page: framed lines of their files on a terminal, findings elsewhere; files that cannot be read.

use std::fmt::Display;
use std::io::{self, ErrorKind};

use technolog::document::{Block, Document, Finding, Inlines, Severity as Colour};
use technolog::knowledge::{Diagnostic, Severity, input};
use technolog::words::say;

use unicode_width::UnicodeWidthStr;

use super::diagnostics::{Texts, below, hidden, render_all};
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

/// What the system says, in the language of the answers.
pub fn of_system(error: &io::Error, lang: Lang) -> String {
    lang.say(&input::of_system(error))
}

/// A page without its title on a terminal, where the command stands above its answer.
pub fn untitled(page: Document, format: Format) -> Document {
    if format == Format::Text { Document { title: Inlines::default(), ..page } } else { page }
}

/// The blocks of these problems, in the order in which they are given: of many the gravest, and how many there are
/// beside them, `more` of which were left out before.
pub fn blocks(problems: Vec<Diagnostic>, more: usize, texts: &Texts, format: Format, context: &Context) -> Vec<Block> {
    let lang = context.lang;
    let (shown, hidden_now) = context.amount.of(problems, |problem| problem.severity);
    let more = more + hidden_now;
    match format {
        Format::Text if shown.is_empty() => Vec::new(),
        Format::Text => {
            let screen = Screen::of(context.output.as_deref());
            let told = render_all(&shown, texts, lang) + &below(more, lang);
            vec![Block::Code(if screen.narrow { wrapped(&told, screen.width) } else { told })]
        }
        _ => {
            let more = hidden(more, lang).map(|more| Block::Paragraph(more.into()));
            shown.iter().map(|problem| finding(problem, lang).into()).chain(more).collect()
        }
    }
}

/// Sentences that are wider than the screen go on under themselves. Lines of files are cut already.
fn wrapped(text: &str, width: usize) -> String {
    let mut shown = String::with_capacity(text.len());
    for line in text.lines() {
        let is_of_file =
            line.split_once(" |").is_some_and(|(number, _)| number.trim().bytes().all(|b| b.is_ascii_digit()));
        let mut room = width;
        // Behind the frame of a help, else a little further in.
        let indent = line.find(" = ").filter(|at| line[..*at].trim().is_empty()).map_or(2, |at| at + " = ".len());
        for (at, word) in line.split(' ').enumerate() {
            let more = word.width() + usize::from(at > 0);
            if at > 0 && !is_of_file && more > room {
                shown.push('\n');
                shown.push_str(&" ".repeat(indent));
                room = width.saturating_sub(indent);
            } else if at > 0 {
                shown.push(' ');
            }
            shown.push_str(word);
            room = room.saturating_sub(more);
        }
        shown.push('\n');
    }
    shown
}

fn finding(problem: &Diagnostic, lang: Lang) -> Finding {
    let (severity, word) = match problem.severity {
        Severity::Error => (Colour::Error, "cli-error"),
        Severity::Warning => (Colour::Doubtful, "cli-warning"),
        Severity::Note => (Colour::Note, "cli-note"),
    };
    Finding {
        place: problem.place.as_ref().map(ToString::to_string),
        help: problem.help.as_ref().map(|help| Inlines::sentence(&lang.say(help))),
        ..Finding::new(severity, lang.word(word), Inlines::sentence(&lang.say(&problem.message)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_wider_than_the_screen_go_on_below_and_lines_of_files_do_not() {
        let text =
            "error[x]: one two three four\n  |\n9 | a line of a file that is long\n  |\n  = help: five six seven\n";
        let shown = "error[x]: one two\n  three four\n  |\n9 | a line of a file that is long\n  |\n  = help: five six\n    seven\n";
        assert_eq!(wrapped(text, 19), shown);
        assert_eq!(wrapped(text, 80), text);
    }
}
