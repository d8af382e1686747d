//! Check: every input of the domain has a row or a declared gap, and no declaration is wider than its gap.

use super::region::{self, Region};
use crate::diagnostic::{Diagnostic, Place};
use crate::table::{Table, TableKind};
use technolog_note::note;

/// The most gaps listed for one table; further ones are counted.
const LISTED: usize = 5;

/// Reports gaps with a witness input, and declared gaps that are covered. Returns the gaps.
pub(super) fn check(table: &Table, findings: &mut Vec<Diagnostic>) -> Vec<Region> {
    if table.kind != TableKind::Decision || table.inputs().any(|(_, column)| column.is_unbounded()) {
        return Vec::new();
    }
    let rows = region::regions_of_rows(table);
    for (index, gap) in table.uncovered.iter().enumerate() {
        let place = gap.place.clone();
        for (row, own) in rows.iter().enumerate() {
            if !region::is_disjoint(&gap.sets, own) {
                let message = note!(
                    "lint-table-declared-gap-wider-than",
                    table = table.id,
                    row = row + 1,
                    intersection = region::witness(table, &region::intersection(&gap.sets, own))
                );
                findings
                    .push(Diagnostic::error("wide-gap", message, place.clone()).help(note!("lint-narrow-declaration")));
                break;
            }
        }
        let before = table.uncovered[..index].iter().map(|gap| &gap.sets);
        if region::is_empty(&gap.sets) || region::minus(&gap.sets, before).is_empty() {
            let message = note!("lint-table-this-declared-gap-declares", table = table.id);
            findings.push(
                Diagnostic::error("wide-gap", message, place)
                    .help(note!("lint-lies-outside-domain-inside-declarations")),
            );
        }
    }
    let declared = table.uncovered.iter().map(|gap| &gap.sets);
    let gaps = region::minus(&region::domain(table), rows.iter().chain(declared));
    for gap in gaps.iter().take(LISTED) {
        let message = note!("lint-table-no-row-for", table = table.id, witness = region::witness(table, gap));
        findings
            .push(Diagnostic::error("gap", message, rows_place(table)).help(note!("lint-add-row-declare-gap-source")));
    }
    if gaps.len() > LISTED {
        let message = note!("lint-table-more-gaps", table = table.id, gaps = gaps.len() - LISTED);
        findings.push(Diagnostic::error("gap", message, rows_place(table)));
    }
    gaps
}

/// Where the rows of a table begin.
fn rows_place(table: &Table) -> Place {
    let line = table.rows.first().map_or(1, |row| row.line);
    Place { file: table.file.as_str().into(), line, column: 1, width: 1 }
}
