//! Unconfirmed rows: a page counts them in one line, and lists them on request.

use std::collections::BTreeSet;

use crate::note::{Figure, Finding, Note};

/// How unconfirmed rows are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubts {
    /// In one line, with their number.
    Counted,
    /// Each with its reason.
    EachRow,
}

impl Doubts {
    /// The findings that a page lists, and the line that counts the others.
    pub(crate) fn split<'f>(self, findings: impl Iterator<Item = &'f Finding>) -> (Vec<&'f Finding>, Option<Note>) {
        let counted = |finding: &&Finding| self == Self::Counted && is_of_row(&finding.note);
        let (counted, listed): (Vec<_>, Vec<_>) = findings.partition(counted);
        let rows = unconfirmed(counted.into_iter());
        let tables: BTreeSet<&str> = rows.iter().map(|(table, _)| table.as_str()).collect();
        let line = Note::new("unconfirmed-counted")
            .with("count", rows.len())
            .with("tables", Figure::list(tables.into_iter().map(|table| Figure::Text(table.to_owned().into()))));
        (listed, (!rows.is_empty()).then_some(line))
    }
}

/// The unconfirmed rows that findings name, each by its table and its number.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
pub(crate) fn unconfirmed<'f>(findings: impl Iterator<Item = &'f Finding>) -> BTreeSet<(String, String)> {
    let mut rows = BTreeSet::new();
    for finding in findings.filter(|finding| finding.note.code() == "unconfirmed") {
        let table = finding.note.figure_text("table").unwrap_or_default();
        let written = finding.note.figure_text("row").unwrap_or_default();
        rows.extend(written.split(", ").map(|row| (table.clone(), row.to_owned())));
    }
    rows
}

/// Whether a finding says that a row is not confirmed, or that its tool must be ground, which the list of tools says too.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
pub fn is_of_row(note: &Note) -> bool {
    matches!(note.code(), "unconfirmed" | "to-be-ground")
}
