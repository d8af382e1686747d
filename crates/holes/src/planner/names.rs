//! Names of groups that a reader of the plan cannot tell apart.

use std::collections::BTreeMap;

use crate::knowledge::alike::latin;
use crate::note::{Finding, Note, Severity};
use crate::part::Part;

/// Groups whose names differ only in letters that look the same in both alphabets. It is almost certainly a typing
/// mistake; if not, the plan still cannot be read.
pub(super) fn lookalike_names(part: &Part) -> impl Iterator<Item = Finding> {
    let mut names: BTreeMap<String, usize> = BTreeMap::new();
    for hole in &part.holes {
        *names.entry(latin(&hole.name)).or_default() += 1;
    }
    let twice = names.into_iter().filter(|(_, count)| *count > 1);
    twice.map(|(name, count)| {
        let note = Note::new("names-look-alike").with("name", name).with("count", count);
        Finding::of_part(Severity::Doubtful, note)
    })
}
