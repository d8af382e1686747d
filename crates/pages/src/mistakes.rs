//! The mistakes of files in the language of the reader.
//!
//! The rooms that read files know no language: they say in English what is wrong and what to do. Here stand the same
//! sentences in Ukrainian, each under the English one with its places to fill in, `{0}`, `{1}`, …; what is filled in may
//! be a sentence or a word of the table too. A sentence that is not in the table stays English, as the messages for
//! authors of knowledge do. A test holds the table against every sentence in the rooms that read users' files.

mod cases;
mod files;
mod parts;

use std::borrow::Cow;

use super::Lang;
use crate::knowledge::Diagnostic;
use technolog_audit::quantity::Quantity;

/// English, Ukrainian.
type Pair = (&'static str, &'static str);

/// Every sentence.
fn pairs() -> impl Iterator<Item = Pair> {
    let names = Quantity::ALL.iter().map(|quantity| {
        let [uk, en] = [Lang::UK, Lang::EN].map(|lang| technolog_core::words::quantity_noun(*quantity, lang));
        (en, uk)
    });
    files::SENTENCES.iter().chain(parts::SENTENCES).chain(cases::SENTENCES).copied().chain(names)
}

/// Whether a sentence has a Ukrainian one; its places to fill in are numbered.
pub fn is_known(english: &str) -> bool {
    pairs().any(|(known, _)| known == english)
}

/// A problem as people read it.
#[must_use]
pub fn told(problem: &Diagnostic, lang: Lang) -> Diagnostic {
    let text = |text: &String| said(text, lang).into_owned();
    Diagnostic { message: text(&problem.message), help: problem.help.as_ref().map(text), ..problem.clone() }
}

/// A sentence about a mistake in the language of the reader.
pub fn said(english: &str, lang: Lang) -> Cow<'_, str> {
    match lang {
        _ if lang == Lang::UK => ukrainian(english).map_or(Cow::Borrowed(english), Cow::Owned),
        _ => Cow::Borrowed(english),
    }
}

fn ukrainian(english: &str) -> Option<String> {
    // Of several that fit, the one that says most by itself.
    let fitting = pairs().filter_map(|(known, uk)| Some((known, uk, filled_in(english, &pieces(known))?)));
    let own = |known: &str| pieces(known).iter().map(|piece| piece.len()).sum::<usize>();
    let (_, uk, values) = fitting.max_by_key(|(known, ..)| own(known))?;
    let mut text = String::new();
    let mut rest = uk;
    while let Some(at) = rest.find('{') {
        let (before, from) = rest.split_at(at);
        text.push_str(before);
        let number =
            from.get(1..2).and_then(|digit| digit.parse::<usize>().ok()).filter(|_| from.get(2..3) == Some("}"));
        match number.and_then(|number| values.get(number)) {
            Some(value) => {
                text.push_str(&said(value, Lang::UK));
                rest = &from[3..];
            }
            None => {
                text.push('{');
                rest = &from[1..];
            }
        }
    }
    Some(text + rest)
}

/// What stands around the places to fill in: one more than there are places.
fn pieces(template: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut rest = template;
    for number in 0..10 {
        let Some((before, after)) = rest.split_once(&format!("{{{number}}}")) else { break };
        pieces.push(before);
        rest = after;
    }
    pieces.push(rest);
    pieces
}

/// What is filled in, where the text is made of these pieces.
fn filled_in<'t>(text: &'t str, pieces: &[&str]) -> Option<Vec<&'t str>> {
    let (first, others) = pieces.split_first()?;
    let rest = text.strip_prefix(first)?;
    let Some(next) = others.first() else { return rest.is_empty().then(Vec::new) };
    // The last place takes whatever is left before the end.
    let ends: Vec<usize> = if others.len() == 1 {
        rest.len().checked_sub(next.len()).filter(|_| rest.ends_with(next)).into_iter().collect()
    } else {
        rest.match_indices(next).map(|(at, _)| at).collect()
    };
    ends.into_iter().filter(|end| *end > 0).find_map(|end| {
        let (value, behind) = rest.split_at_checked(end)?;
        let mut values = vec![value];
        values.extend(filled_in(behind, others)?);
        Some(values)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_filled_in_is_told_too() {
        for (english, uk) in [
            ("unknown key `rout`", "невідомий ключ `rout`"),
            ("a list is expected here, not nothing", "тут очікується список, а не нічого"),
            ("hole P: Ø10 at [1, 2] is not inside the blank", "отвір P: Ø10 у точці [1, 2] не вміщується в заготовці"),
            (
                "`1,5` is not a number: write the decimal point, not a comma",
                "`1,5` - не число: пишіть десяткову крапку, а не кому",
            ),
            ("it may be drill, tap", "може бути drill, tap"),
            ("`-5` cannot be the depth: it must be above zero", "`-5` - не глибина: має бути більше нуля"),
            ("nobody knows this sentence", "nobody knows this sentence"),
        ] {
            assert_eq!(said(english, Lang::UK), uk);
            assert_eq!(said(english, Lang::EN), english);
        }
    }

    #[test]
    fn every_place_to_fill_in_is_in_both() {
        for (en, uk) in pairs() {
            for number in 0..10 {
                let place = format!("{{{number}}}");
                assert_eq!(en.matches(&place).count(), uk.matches(&place).count(), "{en}");
            }
            assert!(!said(en, Lang::UK).is_empty());
        }
    }
}
