//! Finding a cutter: the tables in the order of the rule `tool-tables`, the first row that fits, and
//! for every row of the right size that does not, the inequality that fails.

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::Micrometres;
use crate::knowledge::{Input, Knowledge, RowRef, Table};
use crate::machine::Machine;
use crate::note::{Because, Note};
use crate::plan::Operation;

/// A cutter of a catalog, as planning uses it.
#[derive(Clone, Debug)]
pub struct Cutter<'k> {
    /// Its row.
    pub row: RowRef<'k>,
    /// What its table says of all its cutters.
    pub head: &'k ToolHead,
    /// The designation that fits the hole (through or blind, lead angle).
    pub designation: &'k str,
    /// Its own diameter; for a boring bar the diameter it is set to.
    pub diameter: Micrometres,
    /// How it was chosen.
    pub because: Because,
    /// Why its table is asked in this order.
    pub order: Because,
}

/// What is asked of a cutter.
#[derive(Clone, Copy, Debug)]
pub struct CutterNeed<'a> {
    /// The transition.
    pub operation: Operation,
    /// The diameter it must leave.
    pub diameter: Micrometres,
    /// The nominal size of the catalog's cutter, where it is ground to another size.
    pub nominal: Micrometres,
    /// The diameter of the hole it enters; zero in solid metal.
    pub enters: Micrometres,
    /// How far it must reach into the hole.
    pub reach: Micrometres,
    /// Whether the hole goes through.
    pub through: bool,
    /// The lead angle of a reamer, by the rule `reamer-lead`.
    pub lead: &'a str,
}

/// Every cutter that fits, in the order of the tables of the rule `tool-tables`, and why others of the
/// right size do not.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn cutters<'k>(
    need: &CutterNeed<'_>,
    knowledge: &'k Knowledge,
    machine: &Machine<'_>,
) -> Result<(Vec<Cutter<'k>>, Vec<Note>), KnowledgeError> {
    let rule = knowledge.table("tool-tables")?;
    let answer =
        rule.decide(&[("operation", Input::Text(need.operation.name())), ("diameter", Input::Length(need.nominal))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, need.operation.name()))?;
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    for id in row.texts("tables")? {
        let table = knowledge.table(id)?;
        let Some(head) = &table.tool else { continue };
        if !head.operations.iter().any(|operation| operation == need.operation.name()) {
            continue;
        }
        for candidate in fitting(table, need) {
            if let Some(why) = refuse(candidate, need, machine) {
                rejected.push(why);
                continue;
            }
            let note =
                |code: &str| Note::new(code).with("operation", need.operation.name()).with("order", tables_of(row));
            cutters.push(Cutter {
                row: candidate,
                head,
                designation: designation(candidate, need)?,
                diameter: own_diameter(candidate).unwrap_or(need.diameter),
                because: Because::row(candidate, note("cutter")),
                order: Because::row(row, note("tool-tables")),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(nothing_of_size(need, row, knowledge));
    }
    Ok((cutters, rejected))
}

fn tables_of(row: RowRef<'_>) -> String {
    row.value("tables").map(ToString::to_string).unwrap_or_default()
}

/// The diameter printed for a cutter of one size; nothing for a boring bar, which is set.
fn own_diameter(row: RowRef<'_>) -> Option<Micrometres> {
    row.length("diameter").ok()
}

/// Rows of the right size: smallest first for centring, the bar's range for boring, equality otherwise.
fn fitting<'k>(table: &'k Table, need: &CutterNeed<'_>) -> Vec<RowRef<'k>> {
    let rows = table.all_rows();
    if need.operation.is_boring() {
        let stage = if need.operation == Operation::RoughBore { "rough" } else { "finish" };
        return rows
            .filter(|row| row.text("stage") == Ok(stage))
            .filter(|row| {
                let range = (row.length("diameter_min"), row.length("diameter_max"));
                matches!(range, (Ok(low), Ok(high)) if low <= need.diameter && need.diameter <= high)
            })
            .collect();
    }
    if need.operation == Operation::CentreDrill {
        return rows.filter(|row| own_diameter(*row).is_some_and(|diameter| diameter >= need.diameter)).collect();
    }
    rows.filter(|row| own_diameter(*row) == Some(need.nominal)).collect()
}

/// Why a row of the right size cannot be used.
fn refuse(row: RowRef<'_>, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<Note> {
    let name = row.table.result.first().and_then(|column| row.text(column).ok()).unwrap_or_default();
    let note = |code: &str| Note::new(code).with("tool", name).with("table", &row.table.id);
    if matches!(need.operation, Operation::Drill | Operation::DrillOut) && need.diameter > machine.drill_max {
        return Some(note("drill-too-large").with("diameter", need.diameter).with("limit", machine.drill_max));
    }
    if need.operation.is_boring()
        && let Ok(bar) = row.length("bar_diameter")
        && bar >= need.enters
    {
        return Some(note("bar-does-not-enter").with("bar", bar).with("hole", need.enters));
    }
    let reach = ["reach", "flute_length", "projection", "cutting_length"]
        .into_iter()
        .filter(|_| need.operation != Operation::CentreDrill)
        .find_map(|column| row.length(column).ok())?;
    // A reamer's teeth are shorter than the hole; it is its neck that must reach.
    let reach = if need.operation.is_reaming() { reach_of_reamer(row).unwrap_or(reach) } else { reach };
    (reach < need.reach).then(|| note("does-not-reach").with("reach", reach).with("needed", need.reach))
}

/// How deep a reamer goes: to the end of its neck, which is all that stands out of the holder.
fn reach_of_reamer(row: RowRef<'_>) -> Option<Micrometres> {
    if let Ok(projection) = row.length("projection") {
        return Some(projection);
    }
    let length = row.length("length").ok()?;
    match row.length("shank_length") {
        Ok(shank) => Some(length - shank),
        // A shell reamer goes as deep as its arbor, which the holder checks.
        Err(_) => Some(Micrometres::new(i64::MAX / 4)).filter(|_| row.length("bore").is_ok()).or(Some(length)),
    }
}

fn designation<'k>(row: RowRef<'k>, need: &CutterNeed<'_>) -> Result<&'k str, KnowledgeError> {
    let by_bottom = if need.through { "designation_through" } else { "designation_blind" };
    let by_lead = if need.lead == "5deg" { "designation_5deg" } else { "designation_15deg" };
    for column in ["designation", by_bottom, by_lead] {
        if row.table.column_index(column).is_some() {
            return Ok(row.text(column)?);
        }
    }
    Ok(row.text("designation")?)
}

/// No row has that size: says so, with the nearest sizes below and above.
fn nothing_of_size(need: &CutterNeed<'_>, rule: RowRef<'_>, knowledge: &Knowledge) -> Note {
    let sizes: Vec<Micrometres> = rule
        .texts("tables")
        .unwrap_or_default()
        .into_iter()
        .filter_map(|id| knowledge.table(id).ok())
        .flat_map(|table| table.all_rows().flat_map(sizes_of).collect::<Vec<_>>())
        .collect();
    let below = sizes.iter().filter(|size| **size < need.nominal).max();
    let above = sizes.iter().filter(|size| **size > need.nominal).min();
    let show = |size: Option<&Micrometres>| size.map_or_else(|| "-".to_owned(), |size| format!("Ø{size}"));
    Note::new("no-cutter-of-size")
        .with("operation", need.operation.name())
        .with("diameter", need.nominal)
        .with("below", show(below))
        .with("above", show(above))
        .with("tables", tables_of(rule))
}

/// The sizes a row stands for: a cutter's diameter, a boring bar's range.
fn sizes_of(row: RowRef<'_>) -> Vec<Micrometres> {
    ["diameter", "diameter_min", "diameter_max"].into_iter().filter_map(|column| row.length(column).ok()).collect()
}

/// The diameters of every drill that this machine can hold and that reaches, ascending, each once.
///
/// # Errors
/// The knowledge cannot answer.
pub fn drill_diameters(
    reach_of: impl Fn(Micrometres) -> Micrometres,
    through: bool,
    knowledge: &Knowledge,
    machine: &Machine<'_>,
) -> Result<Vec<Micrometres>, KnowledgeError> {
    let mut diameters: Vec<Micrometres> = knowledge
        .tables()
        .filter(|table| table.tool.as_ref().is_some_and(|head| head.operations.iter().any(|name| name == "drill")))
        .flat_map(Table::all_rows)
        .filter_map(own_diameter)
        .filter(|diameter| *diameter <= machine.drill_max)
        .collect();
    diameters.sort_unstable();
    diameters.dedup();
    let mut usable = Vec::with_capacity(diameters.len());
    for diameter in diameters {
        let need = CutterNeed {
            operation: Operation::Drill,
            diameter,
            nominal: diameter,
            enters: Micrometres::ZERO,
            reach: reach_of(diameter),
            through,
            lead: "",
        };
        if super::find_tool(&need, knowledge, machine)?.is_ok() {
            usable.push(diameter);
        }
    }
    Ok(usable)
}
