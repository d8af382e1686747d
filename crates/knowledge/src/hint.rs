//! Finds the known key that an unknown one means.

use technolog_note::{Note, note};

use crate::alike::latin;
use crate::diagnostic::{edit_distance, nearest_few};
use crate::key_words::WORDS;
use crate::yaml::{Key, Node};

/// The hint for an unknown key.
pub(crate) enum Hint<'k> {
    /// The meant key.
    Meant(&'k str),
    /// The same key but for Cyrillic letters.
    Alphabet(&'k str),
    /// The meant key is already there, in that line.
    Stands(&'k str, u32),
}

impl<'k> Hint<'k> {
    /// The key that was meant.
    pub(crate) const fn key(&self) -> &'k str {
        match self {
            Self::Meant(key) | Self::Alphabet(key) | Self::Stands(key, _) => key,
        }
    }

    /// As a sentence.
    pub(crate) fn to_note(&self) -> Note {
        match *self {
            Self::Meant(key) => note!("cli-did-you-mean", name = key),
            Self::Alphabet(key) => note!("yaml-write-key-in-latin-letters", near = key),
            Self::Stands(key, line) => note!("yaml-meant-key-stands-already", near = key, line = line),
        }
    }
}

/// A key that is present in a mapping, and its line.
pub(crate) type Present<'k> = (&'k str, u32);

/// The known keys that are present in a mapping.
pub(crate) fn present<'k>(known: &[&'k str], entries: &[(Key, Node)]) -> Vec<Present<'k>> {
    let of = |there: &Key| known.iter().find(|key| **key == there.text).map(|key| (*key, there.place.line));
    entries.iter().filter_map(|(there, _)| of(there)).collect()
}

/// The key meant by `typed`, if one of `known` is near enough. A key that is already present is never proposed: the
/// reader would refuse it.
pub(crate) fn for_typed<'k>(typed: &str, known: &[&'k str], present: &[Present<'_>]) -> Option<Hint<'k>> {
    let line = |key: &str| present.iter().find(|(there, _)| *there == key).map(|(_, line)| *line);
    let or_stands = |hint: fn(&'k str) -> Hint<'k>, key: &'k str| match line(key) {
        Some(line) => Hint::Stands(key, line),
        None => hint(key),
    };
    let folded = latin(typed);
    if folded != typed
        && let Some(key) = known.iter().find(|key| **key == folded)
    {
        return Some(or_stands(Hint::Alphabet, key));
    }
    let free_first = |keys: Vec<&'k str>| {
        let free = keys.iter().find(|key| line(key).is_none());
        free.or(keys.first()).copied()
    };
    let words = |typed: &str| Some(translated(typed, known)).filter(|keys| !keys.is_empty());
    let key = match words(typed).or_else(|| words(&folded)).unwrap_or_default() {
        keys if !keys.is_empty() => free_first(keys),
        _ if folded.chars().any(|letter| letter.is_ascii_alphabetic()) => {
            free_first(nearest_few(&folded, known.iter().copied()))
        }
        _ => None,
    };
    key.map(|key| or_stands(Hint::Meant, key))
}

/// The known keys that a Ukrainian word names, the likeliest first. One error in four letters is accepted.
fn translated<'k>(typed: &str, known: &[&'k str]) -> Vec<&'k str> {
    let typed = typed.trim().to_lowercase().replace([' ', '-'], "_");
    // Short words and those of Latin letters are too near to each other for errors.
    let limit = if typed.is_ascii() { 0 } else { typed.chars().count() / 4 };
    let named = |keys: &&str| -> Vec<&'k str> {
        keys.split(' ').filter_map(|key| known.iter().find(|known| **known == key).copied()).collect()
    };
    let typed: Vec<char> = typed.chars().collect();
    // The cheapest test first: most words are too short or too long.
    let near = WORDS.iter().filter(|(word, _)| word.chars().count().abs_diff(typed.len()) <= limit);
    let near = near.filter(|(_, keys)| keys.split(' ').any(|key| known.contains(&key)));
    let near = near.filter_map(|(word, keys)| Some((edit_distance(&typed, word, limit)?, keys)));
    near.min_by_key(|(distance, _)| *distance).map(|(_, keys)| named(keys)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::yaml::{NodeKind, parse};
    use technolog_words::Lang;

    const KNOWN: &[&str] =
        &["name", "diameter", "depth", "through", "thread", "step", "steps", "state", "state_diameter", "cone"];

    /// The hint for the last key of the mapping, in both languages.
    fn hint_for(text: &str) -> Option<[String; 2]> {
        let root = parse("t.yaml", text).0.unwrap();
        let NodeKind::Map(entries) = &root.kind else { panic!("{text}") };
        let hint = for_typed(&entries.last().unwrap().0.text, KNOWN, &present(KNOWN, entries))?;
        Some([Lang::EN, Lang::UK].map(|lang| lang.say(&hint.to_note())))
    }

    #[test]
    fn a_key_that_was_meant_is_proposed() {
        for (typed, meant) in [
            ("diametr", "diameter"),
            ("діаметр", "diameter"),
            ("Діаметр", "diameter"),
            ("диаметр", "diameter"),
            ("глибина", "depth"),
            ("наскрізний", "through"),
            ("наскрізь", "through"),
            ("D", "diameter"),
            ("nmae", "name"),
            ("різь", "thread"),
            ("крок", "step"),
            ("назва", "name"),
            // Half of each alphabet.
            ("diameтр", "diameter"),
        ] {
            let both = [format!("did you mean `{meant}`?"), format!("можливо, `{meant}`?")];
            assert_eq!(hint_for(&format!("{typed}: 1\n")), Some(both), "{typed}");
        }
        for typed in ["colour", "колір", "верстат", "як", "y", "nose", "wide", "count", "hole"] {
            assert_eq!(hint_for(&format!("{typed}: 1\n")), None, "{typed}");
        }
    }

    #[test]
    fn letters_of_the_other_alphabet_are_named() {
        for (typed, meant) in [("dіameter", "diameter"), ("nаme", "name"), ("stеp", "step")] {
            let both = [
                format!("some letters are Cyrillic; write `{meant}` in Latin letters"),
                format!("деякі букви тут кириличні; напишіть `{meant}` латиницею"),
            ];
            assert_eq!(hint_for(&format!("{typed}: 1\n")), Some(both), "{typed}");
        }
    }

    #[test]
    fn a_key_that_stands_already_is_not_proposed() {
        for typed in ["diametr", "діаметр", "dіameter"] {
            let [en, uk] = hint_for(&format!("diameter: 1\n{typed}: 1\n")).unwrap();
            assert_eq!(en, "`diameter` already stands at line 1; remove this key or correct it", "{typed}");
            assert_eq!(uk, "`diameter` уже стоїть у рядку 1; приберіть цей ключ або виправте його", "{typed}");
        }
        // Of two equally near keys, the free one.
        assert_eq!(hint_for("step: 1\nstepe: 1\n").unwrap()[0], "did you mean `steps`?");
    }
}
