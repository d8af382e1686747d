//! Check: the tables that are queried with a vocabulary have an answer for each of its words.
//!
//! The gaps themselves are found table by table ([`super::coverage`]); this finding lists all tables of a word, for
//! an author who adds one.

use super::region::Region;
use super::rows::row_place;
use crate::diagnostic::Diagnostic;
use crate::knowledge::Knowledge;
use crate::table::{Cell, Table};
use technolog_note::note;

/// Words for which tables with such an input have a gap and no row that names them; one finding for each word.
pub(super) fn check(knowledge: &Knowledge, gaps: &[(&Table, Vec<Region>)], findings: &mut Vec<Diagnostic>) {
    for vocabulary in knowledge.tables() {
        let Some(column) = vocabulary.column_index(WORD) else { continue };
        for (row, content) in vocabulary.rows.iter().enumerate() {
            let Cell::Value(word) = &content.cells[column] else { continue };
            let word = word.to_string();
            let lacking: Vec<&str> = gaps
                .iter()
                .filter(|(table, gaps)| has_gap_for(table, gaps, &vocabulary.id, &word))
                .map(|(table, _)| table.id.as_str())
                .collect();
            if !lacking.is_empty() {
                let message = note!(
                    "lint-has-no-row-own-leaves",
                    vocabulary = vocabulary.id,
                    word = word,
                    lacking = lacking.join(", ")
                );
                findings.push(
                    Diagnostic::error("word-without-rows", message, row_place(vocabulary, row))
                        .help(note!("lint-add-rows-for-declare-gap")),
                );
            }
        }
    }
}

/// The column of a vocabulary that holds its words.
const WORD: &str = "word";

/// Whether a table uses the words of a vocabulary, has a gap for this one and no row that names it.
fn has_gap_for(table: &Table, gaps: &[Region], vocabulary: &str, word: &str) -> bool {
    let inputs = table.inputs().enumerate().filter(|(_, (_, column))| column.vocabulary.as_deref() == Some(vocabulary));
    inputs.filter_map(|(position, (index, column))| Some((position, index, column.rank_of_text(word)?))).any(
        |(position, index, rank)| {
            let names = |cell: &Cell| match cell {
                Cell::Test(_, text) => text.split([' ', '|', '(', ')']).any(|named| named == word),
                _ => false,
            };
            gaps.iter().any(|gap| gap[position].contains(rank))
                && !table.rows.iter().any(|row| names(&row.cells[index]))
        },
    )
}
