//! Files with mistakes: any text with stretches cut out or replaced, and what reading it must guarantee.

use proptest::prelude::*;
use technolog::part::{Part, read_part};

use super::KNOWLEDGE;

/// A file with one to three stretches of up to five letters replaced by random ones.
pub fn damaged(
    files: impl Strategy<Value = String>,
    litter: impl Strategy<Value = String>,
) -> impl Strategy<Value = String> {
    let spoils = prop::collection::vec((any::<prop::sample::Index>(), 0_usize..6, litter), 1..4);
    (files, spoils).prop_map(|(text, spoils)| {
        let mut characters: Vec<char> = text.chars().collect();
        for (index, cut, litter) in spoils {
            let at = index.index(characters.len() + 1);
            let end = (at + cut).min(characters.len());
            characters.splice(at..end, litter.chars());
        }
        characters.into_iter().collect()
    })
}

/// The part, or nothing where it is refused: then with problems that say something and lie inside the text.
pub fn read_or_refused(text: &str) -> Result<Option<Part>, TestCaseError> {
    let lines = text.split(['\n', '\r']).count();
    match read_part("part.yaml", text, &KNOWLEDGE) {
        Ok(part) => Ok(Some(part)),
        Err(problems) => {
            prop_assert!(!problems.is_empty());
            for problem in problems {
                let place = problem.place.as_ref();
                prop_assert!(place.is_some(), "{problem:?}\n{text}");
                let line = place.map_or(0, |place| place.line as usize);
                prop_assert!(line >= 1 && line <= lines + 1, "{problem:?}\n{text}");
                prop_assert!(!problem.message.is_empty());
            }
            Ok(None)
        }
    }
}
