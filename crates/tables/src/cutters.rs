//! Check: every cutter has the figures that planning needs. They depend on the operations and the shank of its table,
//! so [`CutterRow`] has all of them as optional.

use technolog_knowledge::lint::row_place;
use technolog_knowledge::table::{Table, ToolHead};
use technolog_knowledge::vocabulary::{Operation, Shank};
use technolog_knowledge::{Diagnostic, Knowledge};
use technolog_note::{Note, note};

use crate::rules::ToolTables;
use crate::tools::CutterRow;

/// Reports cutters that lack a figure, and tables that the rule `tool-tables` names but that have no cutters.
pub fn check(knowledge: &Knowledge) -> Vec<Diagnostic> {
    let of_cutters = knowledge.tables().filter_map(|table| Some((table, table.tool.as_ref()?)));
    let mut findings: Vec<Diagnostic> = of_cutters.flat_map(|(table, head)| lacking(table, head)).collect();
    // A row that breaks its contract has been reported there.
    for rule in knowledge.rows::<ToolTables<'_>>().unwrap_or_default() {
        let named = rule.tables.iter().filter_map(|id| knowledge.table(id).ok());
        findings.extend(named.filter(|table| table.tool.is_none()).map(|table| {
            let message = note!("lint-table-tool-tables-row-no", row = rule.row.number(), table = table.id);
            let place = row_place(rule.row.table, rule.row.index);
            Diagnostic::error("no-cutters", message, place).help(note!("lint-say-head-what-they-for"))
        }));
    }
    findings
}

/// The first row of a table that lacks a figure, for each figure.
pub(crate) fn lacking(table: &Table, head: &ToolHead) -> Vec<Diagnostic> {
    let mut reported: Vec<Note> = Vec::new();
    let mut findings = Vec::new();
    for (index, row) in table.rows::<CutterRow<'_>>().enumerate() {
        let Ok(row) = row else { continue };
        for (figure, there) in needed(&row, head) {
            if there || reported.contains(&figure) {
                continue;
            }
            let message = note!("lint-table-row-cutter-without", table = table.id, index = index + 1, figure = figure);
            reported.push(figure);
            let finding = Diagnostic::error("cutter-lacks", message, row_place(table, index));
            findings.push(finding.help(note!("lint-shank-transitions-ask-for")));
        }
    }
    findings
}

fn column(name: &str) -> Note {
    note!("lint-column-named", name = name)
}

/// The required figures of a cutter, by column, and whether the cutter has each.
fn needed(row: &CutterRow<'_>, head: &ToolHead) -> Vec<(Note, bool)> {
    let makes = |operation: &[Operation]| head.operations.iter().any(|own| operation.contains(own));
    let bores = makes(&[Operation::RoughBore, Operation::SemiFinishBore, Operation::FinishBore]);
    let opens = makes(&[Operation::Counterbore, Operation::Countersink, Operation::Chamfer]);
    let steps = opens && makes(&[Operation::Drill]);
    let taps = makes(&[Operation::Tap]);
    let mut needed = vec![(column("designation"), row.designations().next().is_some())];
    if bores {
        let range = row.diameter_min.is_some() && row.diameter_max.is_some();
        needed.push((note!("lint-diameter-min-diameter-max-bar"), {
            range && row.bar_diameter.is_some() && row.stage.is_some()
        }));
    } else {
        needed.push((column("diameter"), row.diameter.is_some()));
    }
    if steps {
        needed
            .push((note!("lint-step-diameter-step-length"), row.step_diameter.is_some() && row.step_length.is_some()));
    } else if makes(&[Operation::Countersink, Operation::Chamfer]) {
        needed.push((note!("lint-cone-angle-tip-diameter"), row.cone_angle.is_some() && row.tip_diameter.is_some()));
    }
    if taps {
        let clamped = row.shank_diameter.is_some() && row.length.is_some();
        needed.push((note!("lint-thread-shank-diameter-length"), row.thread.is_some() && clamped));
    }
    let reaches = row.reach.or(row.flute_length).or(row.projection).or(row.cutting_length);
    let deep = !makes(&[Operation::CentreDrill]) && (!opens || steps || makes(&[Operation::Counterbore]));
    // A shell cutter goes as deep as its arbor.
    if deep && head.shank != Shank::Shell {
        needed.push((note!("lint-reach-flute-length-projection-cutting"), reaches.is_some()));
    }
    needed.push(match head.shank {
        Shank::Cylindrical if taps => return needed,
        Shank::Cylindrical => (note!("lint-shank-length-with-length-flute"), {
            let length = row.length.or(row.cutting_length).is_some();
            row.shank_length.map_or(row.flute_length.or(row.cutting_length).is_some(), |_| length)
        }),
        Shank::Morse => {
            (note!("lint-morse-projection-length"), { row.morse.is_some() && row.projection.or(row.length).is_some() })
        }
        Shank::Shell => (note!("lint-bore-length"), row.bore.is_some() && row.length.is_some()),
        Shank::Taper => (column("length"), row.length.is_some()),
    });
    needed
}
