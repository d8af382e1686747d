//! What the program before may have left: what every control asks of it alike.

use std::collections::BTreeSet;

use super::setting::Before;
use super::{Fault, Subject, TextSpan};
use crate::note::Note;

/// A group of modes that a block may rely on.
pub(super) struct ReliedOn {
    /// Its number in `own`.
    pub group: usize,
    /// The word that sets it.
    pub word: String,
    /// Whether the block relies on it.
    pub used: bool,
    /// Whether habit may hold it ([`Before::Unsaid`]).
    pub by_habit: bool,
}

/// What is told of those groups that a block relies on and that the program has never set: there what the program before has
/// left acts. Each is told once.
pub(super) fn never_set(
    own: &mut [bool],
    before: Before,
    relied_on: impl IntoIterator<Item = ReliedOn>,
) -> Vec<(&'static str, Note, Subject)> {
    let mut words = [Vec::new(), Vec::new()];
    for ReliedOn { group, word, used, by_habit } in relied_on {
        if used && !std::mem::replace(&mut own[group], true) {
            words[usize::from(by_habit && before == Before::Unsaid)].push(word);
        }
    }
    let told = ["mode-left-over", "habit-left-over"].into_iter().zip(words).filter(|(_, words)| !words.is_empty());
    let note = |code: &'static str, words: Vec<String>| match code {
        "mode-left-over" => Note::new(code).with("words", words.join(", ")).with("before", before.word()),
        _ => Note::new(code).with("words", words.join(", ")),
    };
    // What they are about is joined at the end (`as_one`).
    told.map(|(code, words)| (code, note(code, words.clone()), Subject::Missing(words))).collect()
}

/// Whether a way along X or Y comes before the program has brought Z anywhere: the quill may be down. It is told once.
pub(super) fn height_unknown(known: &mut bool, lifts: bool, goes: bool) -> bool {
    *known |= lifts;
    goes && !std::mem::replace(known, true)
}

/// What a program never sets is told once, where it first relies on any of it: the head of the program lacks it.
pub(super) fn as_one(faults: &mut Vec<Fault>) {
    for code in ["mode-left-over", "habit-left-over"] {
        let of_code = faults.iter().filter(|fault| fault.code == code);
        let all: Vec<(TextSpan, Option<Subject>)> = of_code.map(|fault| (fault.span, fault.subject.clone())).collect();
        let Some(first) = all.iter().map(|(span, _)| *span).min().filter(|_| all.len() > 1) else { continue };
        let mut known = BTreeSet::new();
        let missing = all.iter().filter_map(|(_, subject)| match subject {
            Some(Subject::Missing(words)) => Some(words),
            _ => None,
        });
        let words: Vec<&str> = missing.flatten().map(String::as_str).filter(|word| known.insert(*word)).collect();
        let words = words.join(", ");
        faults.retain(|fault| fault.code != code || fault.span == first);
        for fault in faults.iter_mut().filter(|fault| fault.code == code) {
            fault.note = fault.note.clone().with("words", words.clone());
        }
    }
}
