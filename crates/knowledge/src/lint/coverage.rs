//! Proof: every input of the domain has a row or a declared gap, and no declaration is wider than its gap.

use super::region::{self, Region};
use crate::diagnostic::{Diagnostic, Place};
use crate::table::{Kind, Table};

/// More gaps than this of one table are counted, not listed.
const LISTED: usize = 5;

/// Gaps with a witness input, and declarations of gaps that are not gaps. Gives the gaps.
pub(super) fn check(table: &Table, findings: &mut Vec<Diagnostic>) -> Vec<Region> {
    if table.kind != Kind::Decision || table.inputs().any(|(_, column)| column.is_unbounded()) {
        return Vec::new();
    }
    let rows = region::of_rows(table);
    for (index, gap) in table.uncovered.iter().enumerate() {
        let place = gap.place.clone();
        for (row, own) in rows.iter().enumerate() {
            if !region::is_disjoint(&gap.sets, own) {
                let message = format!(
                    "table {}: the declared gap is wider than the gap: row {} answers {}",
                    table.id,
                    row + 1,
                    region::witness(table, &region::intersection(&gap.sets, own))
                );
                findings.push(Diagnostic::error("wide-gap", message, place.clone()).help("narrow the declaration"));
                break;
            }
        }
        let before = table.uncovered[..index].iter().map(|gap| &gap.sets);
        if region::is_empty(&gap.sets) || region::minus(&gap.sets, before).is_empty() {
            let message = format!("table {}: this declared gap declares nothing", table.id);
            findings.push(
                Diagnostic::error("wide-gap", message, place)
                    .help("it lies outside the domain or inside the declarations before it; remove it"),
            );
        }
    }
    let declared = table.uncovered.iter().map(|gap| &gap.sets);
    let gaps = region::minus(&region::domain(table), rows.iter().chain(declared));
    for gap in gaps.iter().take(LISTED) {
        let message = format!("table {}: no row for {}", table.id, region::witness(table, gap));
        findings.push(
            Diagnostic::error("gap", message, rows_place(table))
                .help("add the row, or declare the gap of the source under `uncovered` with its reason"),
        );
    }
    if gaps.len() > LISTED {
        let message = format!("table {}: and {} more gaps", table.id, gaps.len() - LISTED);
        findings.push(Diagnostic::error("gap", message, rows_place(table)));
    }
    gaps
}

/// Where the rows of a table begin.
fn rows_place(table: &Table) -> Place {
    let line = table.rows.first().map_or(1, |row| row.line);
    Place { file: table.file.as_str().into(), line, column: 1, width: 1 }
}
