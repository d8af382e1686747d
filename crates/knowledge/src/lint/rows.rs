//! Check: rows are distinguishable and inside the domain, every input is bounded, and a row whose reason says that
//! nothing confirms it has the mark `unconfirmed`.

use std::collections::BTreeMap;
use technolog_note::note;

use super::region::{self, Region};
use crate::diagnostic::{Diagnostic, Place};
use crate::table::{Cell, HitPolicy, Table, TableKind};

/// Duplicate rows, rows outside the domain, inputs without a domain, duplicate keys.
pub(super) fn check(table: &Table, findings: &mut Vec<Diagnostic>) {
    if table.rows.is_empty() {
        findings.push(Diagnostic::error(
            "no-rows",
            note!("lint-table-has-no-rows", file = table.file, table = table.id),
            None,
        ));
    }
    marks(table, findings);
    match table.kind {
        TableKind::Decision => decision(table, findings),
        TableKind::Catalog => keys(table, findings),
    }
}

/// A reason with these words is no confirmation.
const NOTHING: &str = "nothing at hand confirms";

/// A row whose reason says that nothing confirms it, but without the mark that plans show.
fn marks(table: &Table, findings: &mut Vec<Diagnostic>) {
    for (row, content) in table.rows.iter().enumerate() {
        let admits = content.reason.as_deref().is_some_and(|reason| reason.contains(NOTHING));
        // A choice cannot be confirmed: who looked for a page held it for a figure of the world.
        if admits && (content.unconfirmed.is_none() || content.is_choice) {
            let message = note!("lint-table-row-reason-says-has", table = table.id, row = row + 1, phrase = NOTHING);
            findings.push(
                Diagnostic::error("no-mark", message, row_place(table, row))
                    .help(note!("lint-say-unconfirmed-what-confirmed-reason")),
            );
        }
    }
}

/// Where a row begins; `row` counts from 0.
pub fn row_place(table: &Table, row: usize) -> Place {
    let row = &table.rows[row];
    let first = row.places.iter().flatten().min();
    Place { file: table.file.as_str().into(), line: row.line, column: first.map_or(1, |place| place.column), width: 1 }
}

/// The place where the columns of a table are declared, for faults of a column.
pub(super) fn head_place(table: &Table) -> Place {
    Place { file: table.file.as_str().into(), line: table.columns_line, column: 1, width: 1 }
}

/// The place of a cell, or of its row if the cell is left out.
pub(super) fn cell_place(table: &Table, row: usize, column: usize) -> Place {
    table.rows[row].places.get(column).cloned().flatten().unwrap_or_else(|| row_place(table, row))
}

fn decision(table: &Table, findings: &mut Vec<Diagnostic>) {
    for (_, column) in table.inputs().filter(|(_, column)| column.is_unbounded()) {
        findings.push(
            Diagnostic::error(
                "no-domain",
                note!("lint-table-input-has-no-domain", file = table.file, table = table.id, column = column.name),
                None,
            )
            .help(note!("lint-give-column-domain")),
        );
    }
    let boxes = region::regions_of_rows(table);
    for (row, content) in table.rows.iter().enumerate() {
        for (index, column) in table.inputs() {
            let Cell::Test(set, text) = &content.cells[index] else { continue };
            let outside = set.difference(&column.allowed());
            // A one-sided test such as `> 30` extends to infinity by its form; only stated ends count.
            let stated = outside.intervals().iter().any(|&(low, high)| {
                (low != i64::MIN && high != i64::MAX) || set.intersection(&column.allowed()).is_empty()
            });
            if stated {
                let (table_id, row_number, name) = (&table.id, row + 1, &column.name);
                let message = match column.domain_text.as_deref() {
                    Some(domain) => note!(
                        "lint-table-row-reaches-outside-domain",
                        table = table_id,
                        row = row_number,
                        text = text,
                        domain = domain,
                        column = name
                    ),
                    None => note!(
                        "lint-table-row-reaches-outside-type",
                        table = table_id,
                        row = row_number,
                        text = text,
                        column = name
                    ),
                };
                findings.push(Diagnostic::error("outside-domain", message, cell_place(table, row, index)));
            }
        }
        for (other, earlier) in boxes[..row].iter().enumerate() {
            if boxes[row] == *earlier && table.same_outputs(row, other) {
                let message = note!("lint-table-row-says-same-row", table = table.id, row = row + 1, other = other + 1);
                findings.push(
                    Diagnostic::error("duplicate-row", message, row_place(table, row))
                        .help(note!("lint-remove-one-them")),
                );
            }
        }
        dead(table, row, &boxes, findings);
    }
}

/// A row that can never apply under the table's hit policy.
fn dead(table: &Table, row: usize, boxes: &[Region], findings: &mut Vec<Diagnostic>) {
    let stronger = |other: usize| match table.hit {
        HitPolicy::First => other < row,
        HitPolicy::Priority => table.rows[other].priority > table.rows[row].priority,
        _ => false,
    };
    let others = boxes.iter().enumerate().filter(|(other, _)| stronger(*other)).map(|(_, others)| others);
    if region::is_empty(&boxes[row]) || region::minus(&boxes[row], others).is_empty() {
        let message = note!("lint-table-row-can-never-win", table = table.id, row = row + 1);
        findings.push(
            Diagnostic::error("dead-row", message, row_place(table, row))
                .help(note!("lint-rows-before-domain-leave-no")),
        );
    }
}

fn keys(table: &Table, findings: &mut Vec<Diagnostic>) {
    let key: Vec<usize> = table.key.iter().filter_map(|name| table.column_index(name)).collect();
    if key.is_empty() {
        findings.push(Diagnostic::error(
            "no-key",
            note!("lint-catalog-names-no-key", file = table.file, table = table.id),
            None,
        ));
        return;
    }
    let mut seen: BTreeMap<Vec<String>, usize> = BTreeMap::new();
    for (row, content) in table.rows.iter().enumerate() {
        let values: Vec<String> = key
            .iter()
            .map(|&column| match &content.cells[column] {
                Cell::Value(value) => value.to_string(),
                _ => String::new(),
            })
            .collect();
        if let Some(first) = seen.insert(values.clone(), row) {
            let message = note!(
                "lint-table-row-has-key-row",
                table = table.id,
                row = row + 1,
                first = first + 1,
                values = values.join(", ")
            );
            findings.push(Diagnostic::error("duplicate-row", message, cell_place(table, row, key[0])));
        }
    }
}
