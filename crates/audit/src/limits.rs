//! The size limits of a plan; docs/limits.md lists them.

use technolog_note::note;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Problems;

/// Rows of a route, and conditions. Each is compared with what the others say of it.
pub const MOST_ROWS: usize = 3_000;
/// Tools of a plan.
pub const MOST_TOOLS: usize = 500;
/// Factors of a figure of the card. Each is looked for by its name among those of other conditions.
pub const MOST_FACTORS: usize = 100;
/// The most names listed as possible meanings.
const MOST_LISTED: usize = 20;

/// The items of a list of rows, as many as a plan may have; more are refused at the first of them.
pub(super) fn rows<'n, T>(items: &'n [T], place: impl Fn(&T) -> &Place, problems: &mut Problems) -> &'n [T] {
    if let Some(beyond) = items.get(MOST_ROWS) {
        let message = note!("planfile-too-many-rows", count = items.len(), most = MOST_ROWS);
        problems.error_help::<()>("too-many-rows", message, place(beyond), note!("planfile-check-or-split"));
    }
    items.get(..MOST_ROWS).unwrap_or(items)
}

/// The same of tools.
pub(super) fn tools<'n, T>(items: &'n [T], place: impl Fn(&T) -> &Place, problems: &mut Problems) -> &'n [T] {
    if let Some(beyond) = items.get(MOST_TOOLS) {
        let message = note!("planfile-too-many-tools", count = items.len(), most = MOST_TOOLS);
        problems.error_help::<()>("too-many-tools", message, place(beyond), note!("planfile-check-or-split"));
    }
    items.get(..MOST_TOOLS).unwrap_or(items)
}

/// The same of factors.
pub(super) fn factors<'n, T>(items: &'n [T], place: impl Fn(&T) -> &Place, problems: &mut Problems) -> &'n [T] {
    if let Some(beyond) = items.get(MOST_FACTORS) {
        let message = note!("planfile-too-many-factors", count = items.len(), most = MOST_FACTORS);
        problems.error_help::<()>("too-many-factors", message, place(beyond), note!("planfile-check-or-split"));
    }
    items.get(..MOST_FACTORS).unwrap_or(items)
}

/// Names one after the other, of many the first.
pub(super) fn listed(names: impl ExactSizeIterator<Item = impl ToString>) -> String {
    let more = if names.len() > MOST_LISTED { ", …" } else { "" };
    names.take(MOST_LISTED).map(|name| name.to_string()).collect::<Vec<_>>().join(", ") + more
}
