//! Check: rows that match the same input do not contradict each other, including partial overlaps.

use super::region;
use super::rows::row_place;
use crate::diagnostic::Diagnostic;
use crate::table::{HitPolicy, Table, TableKind};
use technolog_note::note;

/// Contradicting overlaps under each hit policy:
///
/// - `unique`: any overlap;
/// - `any`: an overlap with different outputs;
/// - `priority`: an overlap with equal priority and different outputs;
/// - `first`: an overlap with different outputs where neither row is a special case of the other, so that only the
///   order decides;
/// - `collect`: an overlap that collects the same outputs twice.
pub(super) fn check(table: &Table, findings: &mut Vec<Diagnostic>) {
    if table.kind != TableKind::Decision {
        return;
    }
    let boxes = region::regions_of_rows(table);
    for later in 0..boxes.len() {
        for earlier in 0..later {
            if region::is_disjoint(&boxes[earlier], &boxes[later]) {
                continue;
            }
            let same = table.same_outputs(earlier, later);
            let contradicts = match table.hit {
                HitPolicy::Unique => true,
                HitPolicy::Any => !same,
                HitPolicy::Priority => !same && table.rows[earlier].priority == table.rows[later].priority,
                HitPolicy::First => {
                    !same
                        && !region::is_inside(&boxes[earlier], &boxes[later])
                        && !region::is_inside(&boxes[later], &boxes[earlier])
                }
                HitPolicy::Collect => same,
            };
            if contradicts {
                let message = note!(
                    "lint-table-rows-line-both-match",
                    table = table.id,
                    earlier = earlier + 1,
                    line = table.rows[earlier].line,
                    later = later + 1,
                    intersection = region::witness(table, &region::intersection(&boxes[earlier], &boxes[later]))
                );
                findings.push(
                    Diagnostic::error("overlap", message, row_place(table, later))
                        .help(note!("lint-narrow-one-two-so-one")),
                );
            }
        }
    }
}
