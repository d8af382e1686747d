//! Findings of a plan, and the reasons of its decisions with their rows.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use crate::knowledge::vocabulary::Severity;
pub use technolog_note::{Figure, IntoFigure, Note, Word};

use crate::knowledge::{Answer, Column, RowRef, Source, Table};

/// What a plan says of a tool that no catalog has in its size.
pub const TO_BE_GROUND: &str = "the catalogs have no cutter of this size; it must be ground to order";

/// A finding about the whole part that a row is not confirmed; none where it is.
pub fn doubtful_row(row: RowRef<'_>) -> Option<Finding> {
    let doubt = Because::row(row, Note::new("unconfirmed")).doubt()?;
    Some(Finding::of_part(Severity::Doubtful, doubt))
}

/// A remark on a plan for its reader.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Finding {
    /// How grave.
    pub severity: Severity,
    /// The group of holes it concerns; absent: the whole part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hole: Option<String>,
    /// What it says.
    #[serde(flatten)]
    pub note: Note,
}

impl Finding {
    /// A finding about a group of holes.
    pub fn of_hole(severity: Severity, hole: &str, note: Note) -> Self {
        Self { severity, hole: Some(hole.to_owned()), note }
    }

    /// A finding about the whole part.
    pub fn of_part(severity: Severity, note: Note) -> Self {
        Self { severity, hole: None, note }
    }

    /// Sorts findings for output and removes duplicates: the most severe first, those of a hole together, those of
    /// one table by their rows.
    pub fn in_order(findings: &mut Vec<Self>) {
        findings
            .sort_by(|a, b| (a.severity, &a.hole).cmp(&(b.severity, &b.hole)).then_with(|| a.note.in_order(&b.note)));
        findings.dedup();
    }
}

/// The reason of a decision: its row, and the rejected candidates.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Because {
    /// The table.
    pub table: String,
    /// The number of the row, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub row: Option<usize>,
    /// Where the row's figures come from: `seed`, `standard` or `reconstructed`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<Source>,
    /// Where it stands.
    pub place: String,
    /// The data from which the row was inferred, if it was.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// Why the row is not fully trusted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unconfirmed: Option<String>,
    /// What was decided.
    #[serde(flatten)]
    pub note: Note,
    /// The rejected candidates, each with its reason.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rejected: Vec<Note>,
}

impl Because {
    /// A decision by a row.
    pub fn row(row: RowRef<'_>, note: Note) -> Self {
        let content = row.row();
        Self {
            table: row.table.id.clone(),
            row: Some(row.number()),
            source: Some(content.source),
            place: row.place().to_owned(),
            reason: content.reason.clone(),
            unconfirmed: content.unconfirmed.clone(),
            note,
            rejected: Vec::new(),
        }
    }

    /// A decision by a decision table: the row that applies, and the other rows with the first column that failed.
    pub fn answer(answer: &Answer<'_>, note: Note) -> Self {
        let mut by_column: BTreeMap<&str, (&Column, Vec<usize>)> = BTreeMap::new();
        for (row, column) in answer.rejected() {
            by_column.entry(&column.name).or_insert((column, Vec::new())).1.push(row.number());
        }
        let rejected = by_column
            .into_values()
            .map(|(column, rows)| Note::new("rows-rejected").with("column", column.named()).with("rows", runs(&rows)))
            .collect();
        match answer.winner() {
            Some(row) => Self::row(row, note).with_rejected(rejected),
            None => Self::table(answer.table(), note).with_rejected(rejected),
        }
    }

    /// A decision by a whole table, for example because it has no row.
    pub fn table(table: &Table, note: Note) -> Self {
        Self {
            table: table.id.clone(),
            row: None,
            source: None,
            place: table.place.clone(),
            reason: None,
            unconfirmed: None,
            note,
            rejected: Vec::new(),
        }
    }

    /// Adds rejected candidates.
    #[must_use]
    pub fn with_rejected(mut self, rejected: Vec<Note>) -> Self {
        self.rejected = rejected;
        self
    }

    /// A note that the row is not confirmed, with the reason; none where it is. That its tool must be ground is no doubt
    /// about the row.
    pub fn doubt(&self) -> Option<Note> {
        let why = self.unconfirmed.as_ref()?;
        let code = if why == TO_BE_GROUND { "to-be-ground" } else { "unconfirmed" };
        let row = self.row.map_or_else(|| "-".into_figure(), IntoFigure::into_figure);
        Some(Note::new(code).with("table", &self.table).with("row", row).with("why", Figure::Remark(why.clone())))
    }

    /// Whether the row was inferred or is not fully trusted.
    pub fn is_doubtful(&self) -> bool {
        self.unconfirmed.is_some() || self.source == Some(Source::Reconstructed)
    }
}

/// Row numbers with ranges joined: `1–3, 5`.
fn runs(rows: &[usize]) -> String {
    let runs: Vec<String> = rows
        .chunk_by(|a, b| a + 1 == *b)
        .map(|run| match run {
            [one] => one.to_string(),
            _ => format!("{}–{}", run[0], run[run.len() - 1]),
        })
        .collect();
    runs.join(", ")
}
