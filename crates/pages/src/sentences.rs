//! The words of notes, by the message catalogue.

use crate::note::Note;

use super::Lang;

/// A note as a sentence.
pub fn sentence(note: &Note, lang: Lang) -> String {
    lang.say(note)
}

/// What to do about a mistake of a program, of a list of points or of a shaft.
pub fn remedy(note: &Note, lang: Lang) -> Option<String> {
    lang.remedy(note)
}

/// A word that stands in a table as an id.
pub fn term(id: &str, lang: Lang) -> &str {
    lang.term("word", id)
}
