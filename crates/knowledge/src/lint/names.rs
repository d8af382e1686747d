//! Check: a column name has one meaning. A quantity has the same unit in every table, so that a mistyped unit differs
//! from the others.

use std::collections::BTreeMap;
use technolog_note::note;

use crate::column::{Column, ColumnType};
use crate::diagnostic::Diagnostic;
use crate::knowledge::Knowledge;
use crate::table::Table;
use crate::units::Unit;

/// With at least so many tables, the majority is assumed to be right.
const MANY: usize = 3;

/// Columns whose unit differs from that of the same name in most other tables.
pub(super) fn check(knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    let mut uses: BTreeMap<&str, Vec<(&Table, &Column)>> = BTreeMap::new();
    for table in knowledge.tables() {
        for column in &table.columns {
            if matches!(column.ty, ColumnType::Length | ColumnType::Number) {
                uses.entry(&column.name).or_default().push((table, column));
            }
        }
    }
    for (name, columns) in uses {
        let mut by_unit: BTreeMap<Unit, usize> = BTreeMap::new();
        for (_, column) in &columns {
            *by_unit.entry(column.unit).or_default() += 1;
        }
        let Some((&usual, &count)) = by_unit.iter().max_by_key(|(_, count)| **count) else { continue };
        if by_unit.len() < 2 || count < MANY {
            continue;
        }
        for (table, _) in columns.iter().filter(|(_, column)| column.unit != usual) {
            let message =
                note!("lint-table-column-other-tables", table = table.id, name = name, usual = usual, count = count);
            findings.push(
                Diagnostic::error("wrong-unit", message, super::rows::head_place(table))
                    .help(note!("lint-mend-unit-give-quantity-name")),
            );
        }
    }
}
