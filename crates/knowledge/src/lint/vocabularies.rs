//! Proof: every word of a vocabulary is answered by the tables that are asked with it.
//!
//! The gaps themselves are found table by table ([`super::coverage`]); this is the one finding that lists the tables, for
//! whoever adds a word.

use super::rows::row_place;
use crate::column::Column;
use crate::diagnostic::Diagnostic;
use crate::knowledge::Knowledge;
use crate::table::{Cell, Table};

/// Words that no row of a table with such an input is for, one finding for each word.
pub(super) fn check(knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    for vocabulary in knowledge.tables() {
        let Some(column) = vocabulary.column_index(WORD) else { continue };
        for (row, content) in vocabulary.rows.iter().enumerate() {
            let Cell::Value(word) = &content.cells[column] else { continue };
            let word = word.to_string();
            let lacking: Vec<&str> = knowledge
                .tables()
                .filter(|table| lacks(table, &vocabulary.id, &word))
                .map(|table| table.id.as_str())
                .collect();
            if !lacking.is_empty() {
                let message = format!("{}: `{word}` has no row in {}", vocabulary.id, lacking.join(", "));
                findings.push(
                    Diagnostic::error("word-without-rows", message, row_place(vocabulary, row))
                        .help("add rows for it, or declare the gap under `uncovered` with its reason"),
                );
            }
        }
    }
}

/// The column of a vocabulary that holds its words.
const WORD: &str = "word";

/// Whether a table takes the words of a vocabulary and has neither a row nor a declared gap for this one.
fn lacks(table: &Table, vocabulary: &str, word: &str) -> bool {
    let of = |column: &Column| column.vocabulary.as_deref() == Some(vocabulary);
    table.inputs().enumerate().any(|(position, (index, column))| {
        let Some(rank) = of(column).then(|| column.rank_of_text(word)).flatten() else { return false };
        let answered =
            table.rows.iter().any(|row| matches!(&row.cells[index], Cell::Test(set, _) if set.contains(rank)));
        let declared = table.uncovered.iter().any(|gap| gap.sets.get(position).is_some_and(|set| set.contains(rank)));
        !answered && !declared
    })
}
