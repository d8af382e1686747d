//! Proof: every cutter has what planning asks of it. Which columns these are depends on what its table is for and how it is
//! held, so that [`CutterRow`] can leave out any of them.

use technolog_knowledge::lint::row_place;
use technolog_knowledge::table::{Table, ToolHead};
use technolog_knowledge::vocabulary::{Operation, Shank};
use technolog_knowledge::{Diagnostic, Knowledge};

use crate::rules::ToolTables;
use crate::tools::CutterRow;

/// Cutters that lack a figure, and tables that the rule `tool-tables` names and that are none of cutters.
pub fn check(knowledge: &Knowledge) -> Vec<Diagnostic> {
    let of_cutters = knowledge.tables().filter_map(|table| Some((table, table.tool.as_ref()?)));
    let mut findings: Vec<Diagnostic> = of_cutters.flat_map(|(table, head)| lacking(table, head)).collect();
    // What is no row by its contract was found there.
    for rule in knowledge.rows::<ToolTables<'_>>().unwrap_or_default() {
        let named = rule.tables.iter().filter_map(|id| knowledge.table(id).ok());
        findings.extend(named.filter(|table| table.tool.is_none()).map(|table| {
            let message = format!("table tool-tables, row {}: {} is no table of cutters", rule.row.number(), table.id);
            let place = row_place(rule.row.table, rule.row.index);
            Diagnostic::error("no-cutters", message, place).help("say in its head what they are for: `tool:`")
        }));
    }
    findings
}

/// The first row of a table that lacks a figure, for each figure.
pub(crate) fn lacking(table: &Table, head: &ToolHead) -> Vec<Diagnostic> {
    let mut said: Vec<&str> = Vec::new();
    let mut findings = Vec::new();
    for (index, row) in table.rows::<CutterRow<'_>>().enumerate() {
        let Ok(row) = row else { continue };
        for (figure, there) in needed(&row, head) {
            if there || said.contains(&figure) {
                continue;
            }
            said.push(figure);
            let message = format!("table {}, row {}: a cutter without {figure}", table.id, index + 1);
            let finding = Diagnostic::error("cutter-lacks", message, row_place(table, index));
            findings.push(finding.help("its shank or its transitions ask for it"));
        }
    }
    findings
}

/// What a cutter must have, in words of columns, and whether it has it.
fn needed(row: &CutterRow<'_>, head: &ToolHead) -> Vec<(&'static str, bool)> {
    let makes = |operation: &[Operation]| head.operations.iter().any(|own| operation.contains(own));
    let bores = makes(&[Operation::RoughBore, Operation::SemiFinishBore, Operation::FinishBore]);
    let opens = makes(&[Operation::Counterbore, Operation::Countersink, Operation::Chamfer]);
    let steps = opens && makes(&[Operation::Drill]);
    let taps = makes(&[Operation::Tap]);
    let mut needed = vec![("`designation`", row.designations().next().is_some())];
    if bores {
        let range = row.diameter_min.is_some() && row.diameter_max.is_some();
        needed.push(("`diameter_min`, `diameter_max`, `bar_diameter` and `stage`", {
            range && row.bar_diameter.is_some() && row.stage.is_some()
        }));
    } else {
        needed.push(("`diameter`", row.diameter.is_some()));
    }
    if steps {
        needed.push(("`step_diameter` and `step_length`", row.step_diameter.is_some() && row.step_length.is_some()));
    } else if makes(&[Operation::Countersink, Operation::Chamfer]) {
        needed.push(("`cone_angle` and `tip_diameter`", row.cone_angle.is_some() && row.tip_diameter.is_some()));
    }
    if taps {
        let clamped = row.shank_diameter.is_some() && row.length.is_some();
        needed.push(("`thread`, `shank_diameter` and `length`", row.thread.is_some() && clamped));
    }
    let reaches = row.reach.or(row.flute_length).or(row.projection).or(row.cutting_length);
    let deep = !makes(&[Operation::CentreDrill]) && (!opens || steps || makes(&[Operation::Counterbore]));
    // A shell cutter goes as deep as its arbor.
    if deep && head.shank != Shank::Shell {
        needed.push(("`reach`, `flute_length`, `projection` or `cutting_length`", reaches.is_some()));
    }
    needed.push(match head.shank {
        Shank::Cylindrical if taps => return needed,
        Shank::Cylindrical => ("`shank_length` with `length`, or `flute_length`, or `cutting_length`", {
            let length = row.length.or(row.cutting_length).is_some();
            row.shank_length.map_or(row.flute_length.or(row.cutting_length).is_some(), |_| length)
        }),
        Shank::Morse => ("`morse`, and `projection` or `length`", {
            row.morse.is_some() && row.projection.or(row.length).is_some()
        }),
        Shank::Shell => ("`bore` and `length`", row.bore.is_some() && row.length.is_some()),
        Shank::Taper => ("`length`", row.length.is_some()),
    });
    needed
}
