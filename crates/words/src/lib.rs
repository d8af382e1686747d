//! All words of technolog: the message catalogue, one folder of [Fluent](https://projectfluent.org) files for each
//! language, in `languages/`.
//!
//! A message has a name, such as `no-cutter`, and gaps for figures, `{ $diameter }`. Its remedy is the attribute
//! `.help`. A message that a language lacks is shown in English. Keys of files, ids and text of the user are figures
//! and are never translated.
//!
//! Architecture invariant: nothing here knows about planning; every other room gives a [`Note`].

mod catalogue;
pub mod check;
mod registered;

use std::borrow::Cow;
use std::fmt;

pub use catalogue::Language;
pub use registered::LANGUAGES;
use technolog_note::IntoFigure as _;
pub use technolog_note::{Figure, Note, Word};

/// A language of the answers.
#[derive(Clone, Copy)]
pub struct Lang(&'static Language);

impl Lang {
    /// Ukrainian.
    pub const UK: Self = Self(&registered::UK);
    /// English, the fallback for messages that another language lacks.
    pub const EN: Self = Self(&registered::EN);

    /// All registered languages; the first one is the default.
    pub fn all() -> impl Iterator<Item = Self> {
        LANGUAGES.iter().map(|language| Self(language))
    }

    /// A language that is not registered: a folder under translation.
    pub const fn of(language: &'static Language) -> Self {
        Self(language)
    }

    /// The language of an environment variable `LANG`; Ukrainian where it names none that is known.
    pub fn of_environment(variable: Option<&str>) -> Self {
        let primary = variable.unwrap_or_default().split(['_', '.', '-', '@']).next().unwrap_or_default();
        Self::all().find(|lang| lang.tag().eq_ignore_ascii_case(primary)).unwrap_or(Self::UK)
    }

    /// The messages that it lacks and shows in English.
    pub fn untranslated(self) -> Vec<String> {
        check::differences(self.0, &registered::EN).0
    }

    /// Its tag (BCP 47), which is its folder: `uk`.
    pub const fn tag(self) -> &'static str {
        self.0.tag
    }

    /// The codes that a note can have: the messages that are whole sentences of plans, programs and audits.
    pub fn codes() -> Vec<String> {
        let (entries, _) = check::entries(&registered::EN);
        entries.into_iter().filter(|(_, entered)| !is_wording(entered.file)).map(|(name, _)| name).collect()
    }

    /// A message without figures; its name if no language has it.
    pub fn word(self, key: &str) -> &str {
        self.plain(key, None).unwrap_or(key)
    }

    /// The text of a note. A note without a message shows its code and figures, so that nothing is lost.
    #[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
    pub fn say(self, note: &Note) -> String {
        let known = figures_of(note);
        let figures: Vec<(&str, &Figure)> = known.iter().map(|(name, figure)| (*name, &**figure)).collect();
        let Some(mut text) = self.message(note.code(), None, &figures) else {
            let figures: Vec<String> =
                figures.iter().map(|(name, value)| format!("{name} = {}", value.text())).collect();
            return if figures.is_empty() {
                note.code().to_owned()
            } else {
                format!("{} ({})", note.code(), figures.join(", "))
            };
        };
        if note.figure("more").is_some() && !self.mentions(note.code(), "more") {
            text.push_str(&self.message("and-more-alike", None, &figures).unwrap_or_default());
        }
        if note.figure("scheme").is_some() && !self.mentions(note.code(), "scheme") {
            text = format!("{}: {text}", self.message("of-scheme", None, &figures).unwrap_or_default());
        }
        text
    }

    /// The remedy for a note.
    #[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
    pub fn remedy(self, note: &Note) -> Option<String> {
        let known = figures_of(note);
        let figures: Vec<(&str, &Figure)> = known.iter().map(|(name, figure)| (*name, &**figure)).collect();
        self.message(note.code(), Some("help"), &figures)
    }

    /// A message without figures, if there is one.
    pub fn find(self, key: &str) -> Option<&'static str> {
        self.plain(key, None)
    }

    /// Another form of a message without figures, if there is one: `also` of a column.
    pub fn find_form(self, key: &str, form: &str) -> Option<&'static str> {
        self.plain(key, Some(form))
    }

    /// A word of a vocabulary; its id where it has no translation, as designations have none.
    pub fn term<'i>(self, vocabulary: &str, id: &'i str) -> &'i str {
        self.plain(&format!("{vocabulary}-{id}"), None).unwrap_or(id)
    }

    /// Another form of a word, such as `verb` of an operation.
    pub fn form<'i>(self, vocabulary: &str, id: &'i str, form: &str) -> &'i str {
        self.plain(&format!("{vocabulary}-{id}"), Some(form)).unwrap_or(id)
    }

    /// A single figure: a number as written in this language, a word translated.
    pub fn figure(self, figure: &Figure) -> String {
        match figure {
            Figure::Text(text) => text.to_string(),
            Figure::Number(number) => self.0.number(number),
            Figure::Word(Word { vocabulary, id }) => self.term(vocabulary, id).to_owned(),
            Figure::Named(named) => {
                let own = named.names.iter().find(|(tag, _)| *tag == self.tag()).or(named.names.last());
                own.map_or_else(|| self.figure(&Figure::Word(named.word.clone())), |(_, name)| name.clone())
            }
            Figure::List(parts, between) => {
                let texts: Vec<String> = parts.iter().map(|part| self.figure(part)).collect();
                if *between == ", " { joined_list(&texts) } else { texts.join(between) }
            }
            Figure::Note(note) => self.say(note),
            Figure::Stored(text) => text.clone(),
            Figure::Called(name) => self.called(name),
            Figure::Remark(text) => self.remark(text).into_owned(),
        }
    }

    /// A name that the user gave, as it stands in a sentence: in quotation marks, unless it is a designation such as
    /// `B2`, which nobody takes for a word.
    pub fn called(self, name: &str) -> String {
        if is_designation_of_part(name) {
            return name.to_owned();
        }
        let figure = Figure::Text(name.to_owned().into());
        self.message("called", None, &[("name", &figure)]).unwrap_or_else(|| name.to_owned())
    }

    /// A remark of a table row: the data from which it was inferred, or why it is not confirmed. English where this
    /// language lacks it.
    pub fn remark(self, english: &str) -> Cow<'_, str> {
        with_latin_table_names(self.0.remarks().get(english).copied().unwrap_or(english))
    }

    /// A place in a source, such as `textbook 1.2.1, l. 270-273`, with its words in this language. Names, numbers and
    /// addresses stay as they are.
    pub fn place(self, source: &str) -> String {
        let known = self.0.places();
        let english = with_latin_table_names(source);
        // An address or an id is one word, whatever characters it contains.
        let inside = |letter: char| letter.is_alphanumeric() || "_/-@".contains(letter);
        let mut text = String::with_capacity(english.len());
        let (mut rest, mut before) = (&*english, ' ');
        // Between lines and pages a hyphen means `to`; elsewhere it belongs to a designation.
        let mut in_numbers = false;
        while let Some(first) = rest.chars().next() {
            let ends = |word: &str| {
                let after = rest[word.len()..].chars().next();
                !word.ends_with(inside) || !after.is_some_and(inside)
            };
            let found = known.iter().find(|(word, _)| rest.starts_with(word) && ends(word));
            let (length, put) = match found.filter(|_| !inside(before)) {
                Some((word, translation)) => {
                    in_numbers = matches!(*word, "l." | "p.");
                    (word.len(), *translation)
                }
                None => {
                    in_numbers &= first.is_ascii_digit() || ", -".contains(first);
                    (first.len_utf8(), if in_numbers && first == '-' { "–" } else { &rest[..first.len_utf8()] })
                }
            };
            text.push_str(put);
            before = rest[..length].chars().next_back().unwrap_or(' ');
            rest = &rest[length..];
        }
        if known.is_empty() { text } else { with_dashes(&text) }
    }

    fn plain(self, key: &str, form: Option<&str>) -> Option<&'static str> {
        self.0.plain(key, form).or_else(|| registered::EN.plain(key, form))
    }

    fn message(self, key: &str, form: Option<&str>, figures: &[(&str, &Figure)]) -> Option<String> {
        let shown = |figure: &Figure| self.figure(figure);
        self.0.message(key, form, figures, &shown).or_else(|| registered::EN.message(key, form, figures, &shown))
    }

    fn mentions(self, key: &str, figure: &str) -> bool {
        self.0.mentions(key, figure).or_else(|| registered::EN.mentions(key, figure)).unwrap_or_default()
    }
}

/// A dash between lines far into a text or between tables, `10273–10277` and `A.11–A.29`, whatever stands before them.
fn with_dashes(text: &str) -> String {
    const DIGITS: usize = 5;
    let of_digits = |part: &str| part.len() == DIGITS && part.bytes().all(|byte| byte.is_ascii_digit());
    let of_table = |part: &str| part.strip_prefix("A.").is_some_and(|number| number.parse::<u8>().is_ok());
    let ends = |sign: char| !sign.is_ascii_alphanumeric() && sign != '.';
    let mut parts = text.split('-').peekable();
    let mut said = String::with_capacity(text.len());
    while let Some(part) = parts.next() {
        said.push_str(part);
        let Some(next) = parts.peek() else { break };
        let from = part.rsplit(ends).next().unwrap_or_default();
        let to = next.split(ends).next().unwrap_or_default();
        let spans = of_digits(from) && of_digits(to) || of_table(from) && of_table(to.trim_end_matches('.'));
        said.push(if spans { '–' } else { '-' });
    }
    said
}

/// The textbook prints the Cyrillic letter; on all pages a table has one name, that of the command line.
fn with_latin_table_names(text: &str) -> Cow<'_, str> {
    if text.contains("А.") { text.replace("А.", "A.").into() } else { text.into() }
}

/// The figures of a note; for a stored note, of the kinds that they seem to have.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
fn figures_of(note: &Note) -> Vec<(&str, Cow<'_, Figure>)> {
    let known = note.figures().map(|(name, figure)| match figure {
        Figure::Stored(text) => (name, Cow::Owned(stored(name, text))),
        figure => (name, Cow::Borrowed(figure)),
    });
    let mut known: Vec<(&str, Cow<'_, Figure>)> = known.collect();
    // A sentence about one table has no plural.
    let tables = known
        .iter()
        .find(|(name, _)| ["tables", "order"].contains(name))
        .map(|(_, tables)| tables.text().split(", ").count());
    known.extend(tables.map(|count| ("tables-count", Cow::Owned(count.into_figure()))));
    known
}

/// A figure of a stored note; only its name shows its kind.
fn stored(name: &str, text: &str) -> Figure {
    const OPERATIONS: [&str; 7] = ["operation", "instead", "transitions", "better", "scheme", "same", "first"];
    const WORDS: [&str; 12] = [
        "kind",
        "method",
        "variant",
        "direction",
        "rival",
        "take",
        "by",
        "name",
        "shank",
        "bound",
        "feature",
        "stages",
    ];
    const NAMES: [&str; 2] = ["hole", "called"];
    let list = |one: fn(String) -> Figure| {
        let between = if text.contains(" + ") { " + " } else { ", " };
        Figure::List(text.split(between).map(|part| one(part.to_owned())).collect(), between)
    };
    let is_number = |text: &str| text.parse::<f64>().is_ok() && !is_designation(text);
    let parameter = text.split_once(' ').filter(|(name, number)| ["Ra", "Rz"].contains(name) && is_number(number));
    if is_number(text) {
        Figure::number(text.to_owned())
    } else if let Some((name, number)) = parameter {
        Figure::List(vec![Figure::Text(name.to_owned().into()), Figure::number(number.to_owned())], " ")
    } else if NAMES.contains(&name) {
        Figure::Called(text.to_owned())
    } else if OPERATIONS.contains(&name) {
        list(Figure::operation)
    } else if WORDS.contains(&name) {
        list(Figure::word)
    } else {
        Figure::Text(text.to_owned().into())
    }
}

/// Whether digits are a name, such as that of the scheme `07`.
fn is_designation(digits: &str) -> bool {
    digits.len() > 1 && digits.starts_with('0') && !digits.contains('.')
}

/// Whether a name consists of capital letters and digits, such as the letters of holes on drawings.
fn is_designation_of_part(name: &str) -> bool {
    name.chars().all(|sign| sign.is_uppercase() || sign.is_ascii_digit())
}

/// Whether the messages of a file are words of pages and commands, not sentences of notes.
fn is_wording(file: &str) -> bool {
    file.starts_with("page-")
        || ["cli", "columns", "general", "help", "operations", "terms", "units"]
            .contains(&file.trim_end_matches(".ftl"))
}

/// The text of a message in a language, with or without figures: `say!(lang, "holes-counted", count = 5)`.
#[macro_export]
macro_rules! say {
    ($lang:expr, $key:literal) => { $lang.word($key) };
    ($lang:expr, $key:literal, $($name:ident = $value:expr),+ $(,)?) => {
        $lang.say(&$crate::Note::new($key)$(.with(stringify!($name), $value))+)
    };
}

impl PartialEq for Lang {
    fn eq(&self, other: &Self) -> bool {
        self.tag() == other.tag()
    }
}

impl Eq for Lang {}

impl fmt::Debug for Lang {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.tag())
    }
}

impl std::str::FromStr for Lang {
    type Err = Note;

    fn from_str(text: &str) -> Result<Self, Note> {
        let known = || Figure::list(Lang::all().map(|lang| Figure::Text(lang.tag().into())));
        Self::all()
            .find(|lang| lang.tag() == text)
            .ok_or_else(|| Note::new("no-such-language").with("language", text).with("known", known()))
    }
}
/// A list of texts. If one of them is a number with a decimal comma, the separator is a semicolon, because a comma
/// would be ambiguous.
pub fn joined_list(texts: &[String]) -> String {
    let has_comma = |one: &String| {
        let mut parts = one.split(',');
        let (before, behind) = (parts.next().unwrap_or_default(), parts.next());
        before.ends_with(|sign: char| sign.is_ascii_digit())
            && behind.is_some_and(|behind| behind.starts_with(|sign: char| sign.is_ascii_digit()))
    };
    texts.join(if texts.iter().any(has_comma) { "; " } else { ", " })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_between_numbers_is_never_taken_for_one_of_decimals() {
        let list = |numbers: &[&str]| Figure::list(numbers.iter().map(|number| Figure::number((*number).to_owned())));
        for (numbers, uk, en) in [
            (&["150.5", "0"][..], "150,5; 0", "150.5, 0"),
            (&["1", "-2", "3"], "1, −2, 3", "1, -2, 3"),
            (&["2.5"], "2,5", "2.5"),
        ] {
            assert_eq!(Lang::UK.figure(&list(numbers)), uk);
            assert_eq!(Lang::EN.figure(&list(numbers)), en);
        }
        assert_eq!(joined_list(&["A, B".to_owned(), "C".to_owned()]), "A, B, C");
    }
}
