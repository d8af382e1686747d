//! Diagnostics for people: file, line and column, the line itself, a caret under what is meant, and
//! what to do.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use serde::Serialize;
use technolog::knowledge::{Diagnostic, Place, Severity};

use super::words::Lang;
/// Lines of files are shown no wider than this.
const WIDTH: usize = 120;

/// The texts that places are in, by the file name the places use.
#[derive(Debug, Default)]
pub struct Texts(BTreeMap<String, Text>);

#[derive(Debug)]
struct Text {
    shown: String,
    content: Cow<'static, str>,
}

impl Texts {
    /// With one more text; `shown` is the name by which the user knows the file.
    #[must_use]
    pub fn with(mut self, file: &str, shown: String, content: Cow<'static, str>) -> Self {
        self.0.insert(file.to_owned(), Text { shown, content });
        self
    }

    /// Every file with its text.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(file, text)| (file.as_str(), text.content.as_ref()))
    }

    /// The name by which the user knows a file.
    fn shown<'a>(&'a self, file: &'a str) -> &'a str {
        self.0.get(file).map_or(file, |text| &text.shown)
    }

    fn line(&self, place: &Place) -> Option<&str> {
        let index = usize::try_from(place.line).ok()?.checked_sub(1)?;
        self.0.get(place.file.as_ref())?.content.lines().nth(index)
    }
}

/// Every problem, one under the other, with an empty line between, in the language of the reader.
pub fn render(problems: &[Diagnostic], texts: &Texts, lang: Lang) -> String {
    let shown: Vec<String> = problems.iter().map(|problem| one(problem, texts, lang)).collect();
    shown.join("\n")
}

fn one(problem: &Diagnostic, texts: &Texts, lang: Lang) -> String {
    let level = match problem.severity {
        Severity::Error => Level::ERROR.with_name(lang.word("cli-error")),
        Severity::Warning => Level::WARNING.with_name(lang.word("cli-warning")),
        Severity::Note => Level::NOTE.with_name(lang.word("cli-note")),
    };
    let message = lang.say(&problem.message);
    let help = problem.help.as_ref().map(|help| lang.say(help));
    let title = level.primary_title(message.as_str()).id(problem.code);
    let mut group = Group::with_title(title);
    if let Some(place) = &problem.place {
        let shown = texts.shown(&place.file);
        let line_number = usize::try_from(place.line).unwrap_or(usize::MAX);
        group = match texts.line(place) {
            Some(line) => group.element(
                Snippet::source(line)
                    .line_start(line_number)
                    .path(shown)
                    .annotation(AnnotationKind::Primary.span(span(line, place))),
            ),
            None => {
                let column = usize::try_from(place.column).unwrap_or(usize::MAX);
                group.element(Origin::path(shown).line(line_number).char_column(column))
            }
        };
    }
    let mut reports = Vec::new();
    let level = Level::HELP.with_name(lang.word("cli-help"));
    match (&help, &problem.place) {
        // Under a line of a file the help hangs on its frame; without one it stands on its own.
        (Some(help), Some(_)) => reports.push(group.element(level.message(help.as_str()))),
        (Some(help), None) => reports.extend([group, Group::with_title(level.primary_title(help.as_str()))]),
        (None, _) => reports.push(group),
    }
    let renderer = Renderer::plain().term_width(WIDTH);
    let shown: Vec<String> = reports.into_iter().map(|group| renderer.render(&[group])).collect();
    shown.iter().flat_map(|text| text.lines()).map(|line| format!("{}\n", line.trim_end())).collect()
}

/// The bytes of a line that a place means; a place counts characters.
fn span(line: &str, place: &Place) -> Range<usize> {
    let byte = |characters: usize| line.char_indices().nth(characters).map_or(line.len(), |(byte, _)| byte);
    let first = usize::try_from(place.column).unwrap_or(1).saturating_sub(1);
    let width = usize::try_from(place.width).unwrap_or(1).max(1);
    byte(first)..byte(first.saturating_add(width))
}

/// A problem for programs.
#[derive(Debug, Serialize)]
pub struct Json<'a> {
    severity: &'static str,
    code: &'a str,
    message: String,
    file: Option<&'a str>,
    line: Option<u32>,
    column: Option<u32>,
    help: Option<String>,
}

impl<'a> Json<'a> {
    /// The same problem, as an object.
    pub fn of(problem: &'a Diagnostic, texts: &'a Texts, lang: Lang) -> Self {
        let place = problem.place.as_ref();
        Self {
            severity: match problem.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "note",
            },
            code: problem.code,
            message: lang.say(&problem.message),
            file: place.map(|place| texts.shown(&place.file)),
            line: place.map(|place| place.line),
            column: place.map(|place| place.column),
            help: problem.help.as_ref().map(|help| lang.say(help)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(line: u32, column: u32, width: u32) -> Diagnostic {
        Diagnostic::error("x", "щось не так", Place { file: "a.yaml".into(), line, column, width })
            .help("зробіть інакше")
    }

    fn texts(content: &'static str) -> Texts {
        Texts::default().with("a.yaml", "тека/a.yaml".to_owned(), Cow::Borrowed(content))
    }

    #[test]
    fn a_place_counts_characters_and_the_caret_stands_under_them() {
        insta::assert_snapshot!(render(&[problem(2, 12, 4)], &texts("ключ: 1\nназва: {є: bad1}\n"), Lang::UK), @r"
        помилка[x]: щось не так
         --> тека/a.yaml:2:12
          |
        2 | назва: {є: bad1}
          |            ^^^^
          |
          = підказка: зробіть інакше
        ");
    }

    #[test]
    fn a_place_outside_its_text_still_says_where() {
        let texts = texts("a: 1\n");
        for (line, column) in [(1, 1), (1, 5), (1, 6), (1, 400), (2, 1), (0, 0), (u32::MAX, u32::MAX)] {
            let shown = render(&[problem(line, column, u32::MAX)], &texts, Lang::EN);
            assert!(shown.contains("тека/a.yaml:"), "{line}:{column}: {shown}");
            assert!(shown.contains("зробіть інакше"), "{line}:{column}: {shown}");
        }
    }
}
