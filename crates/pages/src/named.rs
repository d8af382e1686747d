//! Tables by their names for people: pages of a language that has a letter of its own for the tables of the textbook write
//! `А.7`, and any other table by its title. Files, answers in JSON and the command line know tables by their ids.

use crate::document::Document;
use crate::knowledge::Knowledge;

use super::Lang;

/// The id by which a table of the textbook is known begins so.
const NUMBERED: &str = "A.";

/// A page whose tables are named so.
#[must_use]
pub fn named(page: Document, knowledge: &Knowledge, lang: Lang) -> Document {
    match lang.find("table-letter") {
        Some(letter) => page.reworded(&|text| worded(text, letter, knowledge, lang)),
        None => page,
    }
}

/// A table by its title, with the id that the command line knows it by; of the textbook's by its number alone.
pub(crate) fn titled(id: &str, knowledge: &Knowledge, lang: Lang) -> String {
    match (lang.find("table-letter").filter(|_| !id.starts_with(NUMBERED)), knowledge.table(id)) {
        (Some(_), Ok(table)) => format!("{} `{id}`", lang.called(table.title.text(lang.tag()))),
        _ => id.to_owned(),
    }
}

/// The text with its tables named; none if it names none.
fn worded(text: &str, letter: &str, knowledge: &Knowledge, lang: Lang) -> Option<String> {
    let mut told = String::new();
    let mut kept = 0;
    // An id of one word may be a word of the text, unless that speaks of tables: the word for one, less its ending.
    let table = lang.word("plan-table").to_lowercase();
    let stem = table.char_indices().next_back().map_or("", |(end, _)| &table[..end]);
    let of_tables = text.to_lowercase().contains(stem);
    for (at, word) in words(text) {
        let name = match word.strip_prefix(NUMBERED) {
            Some(number) if number.starts_with(|first: char| first.is_ascii_digit()) => format!("{letter}.{number}"),
            None if word.contains('-') || (of_tables && word.len() > 3) => match knowledge.table(word) {
                Ok(table) => lang.called(table.title.text(lang.tag())),
                Err(_) => continue,
            },
            _ => continue,
        };
        told.push_str(&text[kept..at]);
        told.push_str(&name);
        kept = at + word.len();
    }
    told.push_str(&text[kept..]);
    (kept > 0).then_some(told)
}

/// Whatever may be an id, with its place: what stands between spaces and marks, less the full stop of a sentence.
fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let apart = |sign: char| sign.is_whitespace() || "()[]«»\"“”,;:–…*+=".contains(sign);
    let mut end = 0;
    let pieces = text.split_inclusive(apart).map(move |piece| {
        let at = end;
        end += piece.len();
        (at, piece.trim_end_matches(apart).trim_end_matches('.'))
    });
    pieces.filter(|(_, word)| word.is_ascii())
}
