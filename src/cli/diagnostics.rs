//! Diagnostics for people: file, line and column, the line itself with a caret under the fault, and the remedy.

mod lines;

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use technolog::document::cleaned;
use technolog::knowledge::{Diagnostic, Severity};
use technolog::note::Note;
use technolog::words::say;
use unicode_width::UnicodeWidthStr;

use technolog::report::Doubts;

use self::lines::{Lines, Stretch};
use super::words::Lang;

/// The greatest width of shown lines.
const WIDTH: usize = 120;
/// The most characters of a sentence that are shown: it may quote a whole file of the user.
const LONGEST: usize = 4_000;
/// The most problems that are shown; the rest are counted.
const MOST_SHOWN: usize = 50;

/// How many of many problems are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Amount {
    /// The most severe [`MOST_SHOWN`].
    Some,
    /// All of them.
    All,
}

impl Amount {
    /// How a page shows unconfirmed rows.
    pub const fn doubts(self) -> Doubts {
        match self {
            Self::Some => Doubts::Counted,
            Self::All => Doubts::EachRow,
        }
    }

    /// The shown ones, in order, and the number of others. Among equally severe ones the first are shown.
    pub fn select<T, G: Ord>(self, all: Vec<T>, grave: impl Fn(&T) -> G) -> (Vec<T>, usize) {
        if self == Self::All || all.len() <= MOST_SHOWN {
            return (all, 0);
        }
        let mut gravest: Vec<usize> = (0..all.len()).collect();
        gravest.sort_by_key(|&index| grave(&all[index]));
        let mut shown = vec![false; all.len()];
        gravest.iter().take(MOST_SHOWN).for_each(|&index| shown[index] = true);
        let hidden = all.len() - MOST_SHOWN;
        (all.into_iter().zip(shown).filter_map(|(one, shown)| shown.then_some(one)).collect(), hidden)
    }
}

/// The line below the shown ones; none if all are shown.
pub fn hidden(count: usize, lang: Lang) -> Option<String> {
    (count > 0).then(|| say!(lang, "cli-problems-hidden", count = count))
}

/// The texts that places are in, by the file name the places use.
#[derive(Debug, Default)]
pub struct Texts(BTreeMap<String, Text>);

#[derive(Debug)]
struct Text {
    shown: String,
    content: Cow<'static, str>,
}

impl Texts {
    /// Adds a text; `shown` is the name by which the user knows the file.
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
}

/// The shown problems, as in [`render_all`], and the number of others.
pub fn render(problems: Vec<Diagnostic>, texts: &Texts, amount: Amount, lang: Lang) -> String {
    let (shown, more) = amount.select(problems, |problem| problem.severity);
    render_all(&shown, texts, lang) + &below(more, lang)
}

/// The line below problems on a terminal if there are more.
pub fn below(more: usize, lang: Lang) -> String {
    hidden(more, lang).map(|more| format!("\n{more}\n")).unwrap_or_default()
}

/// All problems, separated by empty lines, in the language of the reader.
pub fn render_all(problems: &[Diagnostic], texts: &Texts, lang: Lang) -> String {
    render_within(usize::MAX, problems, texts, lang)
}

/// As [`render_all`]; sentences wider than `width` columns are wrapped, lines of files are cut to [`WIDTH`].
pub fn render_within(width: usize, problems: &[Diagnostic], texts: &Texts, lang: Lang) -> String {
    let mut lines: BTreeMap<&str, Lines<'_>> = BTreeMap::new();
    for place in problems.iter().filter_map(|problem| problem.place.as_ref()) {
        if let Some((file, text)) = texts.0.get_key_value(place.file.as_ref()) {
            lines.entry(file).or_insert_with(|| Lines::of(&text.content));
        }
    }
    let shown: Vec<String> = problems.iter().map(|problem| problem_text(problem, texts, &lines, width, lang)).collect();
    shown.join("\n")
}

/// A problem: fault, place, the line itself with a mark under the place, and the remedy.
fn problem_text(
    problem: &Diagnostic,
    texts: &Texts,
    lines: &BTreeMap<&str, Lines<'_>>,
    width: usize,
    lang: Lang,
) -> String {
    let level = lang.word(match problem.severity {
        Severity::Error => "cli-error",
        Severity::Warning => "cli-warning",
        Severity::Note => "cli-note",
    });
    let words = |note: &Note| cleaned(&lang.say(note)).chars().take(LONGEST).collect::<String>();
    let help = problem.help.as_ref().map(|help| format!("{}: {}", lang.word("cli-help"), words(help)));
    let code = if problem.code.is_empty() { String::new() } else { format!("[{}]", problem.code) };
    let title = folded(&format!("{level}{code}: {}", words(&problem.message)), 2, width);
    let Some(place) = &problem.place else {
        // Below a line of a file the help belongs to its frame; otherwise it is a line of its own.
        let help = help.map(|help| folded(&help, 2, width));
        return [Some(title), help].into_iter().flatten().map(|line| line + "\n").collect();
    };
    let number = place.line.to_string();
    let margin = " ".repeat(number.len());
    let where_it_is = format!("{}:{}:{}", cleaned(texts.shown(&place.file)), place.line, place.column);
    let mut shown = vec![title, format!("{margin}--> {where_it_is}")];
    let room = WIDTH.saturating_sub(number.len() + 3);
    if let Some(stretch) = lines.get(place.file.as_ref()).and_then(|lines| lines.around(place, room)) {
        let [line, mark] = marked(&stretch);
        shown.extend([format!("{margin} |"), format!("{number} | {line}"), format!("{margin} | {mark}")]);
    }
    if let Some(help) = help {
        let frame = format!("{margin} = ");
        shown.extend([format!("{margin} |"), folded(&format!("{frame}{help}"), frame.len(), width)]);
    }
    shown.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// A sentence wrapped to that width, with an indent after the first line.
fn folded(sentence: &str, indent: usize, width: usize) -> String {
    let mut shown = String::with_capacity(sentence.len());
    let mut room = width;
    for (at, word) in sentence.split(' ').enumerate() {
        let more = word.width() + usize::from(at > 0);
        if at > 0 && more > room {
            shown.push('\n');
            shown.push_str(&" ".repeat(indent));
            room = width.saturating_sub(indent);
        } else if at > 0 {
            shown.push(' ');
        }
        shown.push_str(word);
        room = room.saturating_sub(more);
    }
    shown
}

/// A line of a file, and the mark under the fault.
fn marked(stretch: &Stretch<'_>) -> [String; 2] {
    let shown = |text: &str| cleaned(&text.replace('\t', "    "));
    let dots = |cut: bool| if cut { "..." } else { "" };
    let before = format!("{}{}", dots(stretch.cut_before), shown(stretch.before));
    let meant = shown(stretch.marked);
    let mark = " ".repeat(before.width()) + &"^".repeat(meant.width().max(1));
    [format!("{before}{meant}{}{}", shown(stretch.behind), dots(stretch.cut_behind)), mark]
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
    use technolog::knowledge::Place;

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
        insta::assert_snapshot!(render_all(&[problem(2, 12, 4)], &texts("ключ: 1\nназва: {є: bad1}\n"), Lang::UK), @r"
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
    fn sentences_wider_than_the_screen_go_on_below_and_lines_of_files_do_not() {
        let text = "a line of a file that is long, and no screen's matter";
        let place = Place { file: "a.yaml".into(), line: 1, column: 3, width: 4 };
        let problem = Diagnostic::error("x", "one two three four five", Some(place)).help("six seven eight");
        insta::assert_snapshot!(render_within(20, &[problem], &texts(text), Lang::EN), @r"
        error[x]: one two
          three four five
         --> тека/a.yaml:1:3
          |
        1 | a line of a file that is long, and no screen's matter
          |   ^^^^
          |
          = help: six seven
            eight
        ");
    }

    #[test]
    fn a_place_outside_its_text_still_says_where() {
        let texts = texts("a: 1\n");
        for (line, column) in [(1, 1), (1, 5), (1, 6), (1, 400), (2, 1), (0, 0), (u32::MAX, u32::MAX)] {
            let shown = render_all(&[problem(line, column, u32::MAX)], &texts, Lang::EN);
            assert!(shown.contains("тека/a.yaml:"), "{line}:{column}: {shown}");
            assert!(shown.contains("зробіть інакше"), "{line}:{column}: {shown}");
        }
    }

    #[test]
    fn of_many_problems_the_gravest_are_shown_and_the_others_counted() {
        let of = |line: u32| {
            let problem = problem(line, 1, 1);
            if line.is_multiple_of(100) { problem } else { Diagnostic { severity: Severity::Note, ..problem } }
        };
        let texts = texts("");
        let places = |amount| {
            let shown = render((1..=200).map(of).collect(), &texts, amount, Lang::EN);
            let place =
                |line: &str| line.trim_start().strip_prefix("--> тека/a.yaml:")?.split(':').next()?.parse().ok();
            (shown.lines().filter_map(place).collect::<Vec<u32>>(), shown.lines().last().unwrap().to_owned())
        };
        let (some, last) = places(Amount::Some);
        assert_eq!(some, (1..=48).chain([100, 200]).collect::<Vec<_>>());
        assert_eq!(last, "and 150 more: `--all-problems` shows all");
        assert_eq!(places(Amount::All).0, (1..=200).collect::<Vec<_>>());
        assert_eq!(render(vec![], &texts, Amount::Some, Lang::EN), "");
    }

    #[test]
    fn what_steers_a_terminal_is_shown_as_a_sign() {
        let texts = texts("a: \u{1b}[31mred\u{202e}\t1\n");
        let message = "key \u{1b}[2J\nerror[none]: all is well";
        let problem = Diagnostic::error("x", message, Place { file: "a.yaml".into(), line: 1, column: 14, width: 1 });
        let shown = render_all(&[problem], &texts, Lang::EN);
        insta::assert_snapshot!(shown, @r"
        error[x]: key �[2J error[none]: all is well
         --> тека/a.yaml:1:14
          |
        1 | a: �[31mred�    1
          |                 ^
        ");
    }
}
