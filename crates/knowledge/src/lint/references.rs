//! Check: everything that a table refers to exists.

use std::collections::BTreeSet;
use technolog_note::note;

use super::rows::cell_place;
use crate::diagnostic::{Diagnostic, nearest};
use crate::knowledge::Knowledge;
use crate::table::{Cell, Table};

/// The name by which a column refers to ids of tables: `refers: {table: tables, column: id}`.
const TABLES: &str = "tables";

/// Ids of tables that do not exist.
fn check_tables(table: &Table, index: usize, knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    for (row, content) in table.rows.iter().enumerate() {
        let Cell::Value(value) = &content.cells[index] else { continue };
        for id in value.items().iter().map(ToString::to_string).filter(|id| knowledge.table(id).is_err()) {
            let message = note!("lint-table-row-there-no-table", table = table.id, row = row + 1, id = id);
            let finding = Diagnostic::error("dangling-reference", message, cell_place(table, row, index));
            findings.push(match nearest(&id, knowledge.tables().map(|table| table.id.as_str())) {
                Some(near) => finding.help(note!("lint-nearest", near = near)),
                None => finding,
            });
        }
    }
}

/// Values of a column with `refers` that the other table does not have.
pub(super) fn check(table: &Table, knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    for (index, column) in table.columns.iter().enumerate() {
        let Some((other, field)) = &column.refers else { continue };
        if other == TABLES {
            check_tables(table, index, knowledge, findings);
            continue;
        }
        let target =
            knowledge.table(other).ok().and_then(|target| target.column_index(field).map(|field| (target, field)));
        let Some((target, field_index)) = target else {
            let message = note!(
                "lint-table-column-refers-which-does",
                file = table.file,
                table = table.id,
                column = column.name,
                other = other,
                field = field
            );
            let code = if knowledge.table(other).is_ok() { "dangling-reference" } else { "absent-table" };
            findings.push(Diagnostic::error(code, message, None));
            continue;
        };
        let known: BTreeSet<String> = target
            .rows
            .iter()
            .filter_map(|row| match &row.cells[field_index] {
                Cell::Value(value) => Some(value),
                _ => None,
            })
            .flat_map(|value| value.items().iter().map(ToString::to_string))
            .collect();
        for (row, content) in table.rows.iter().enumerate() {
            let Cell::Value(value) = &content.cells[index] else { continue };
            for item in value.items().iter().map(ToString::to_string).filter(|item| !known.contains(item)) {
                let message = note!(
                    "lint-table-row-has-no",
                    table = table.id,
                    row = row + 1,
                    other = other,
                    field = field,
                    item = item
                );
                let finding = Diagnostic::error("dangling-reference", message, cell_place(table, row, index));
                findings.push(match nearest(&item, known.iter().map(String::as_str)) {
                    Some(near) => finding.help(note!("lint-nearest", near = near)),
                    None => finding,
                });
            }
        }
    }
}
