//! Finding a cutter: the tables in the order of the rule `tool-tables`, the first row that fits, and
//! for every row of the right size that does not, the inequality that fails. Which rows are of the right size stands in
//! [`super::sizes`], what else rules one out in [`super::reach`].

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::Micrometres;
use crate::knowledge::{Input, Knowledge, RowRef, Table};
use crate::machine::Machine;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::{CutterFault, NoSize, Unfit};

use super::reach::refuse;
use super::sizes::{fitting, nothing_of_size, own_diameter};

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
    /// The id of a thread.
    pub thread: Option<&'a str>,
    /// Full angle of a cone, thousandths of a degree.
    pub angle_millideg: Option<u32>,
    /// The wider cylinder through which it reaches its place; absent at a face.
    pub within: Option<Micrometres>,
    /// Where its cut begins below the face, and how wide the hole is above that: a shank that passes there
    /// need not be counted.
    pub below: Option<(Micrometres, Micrometres)>,
    /// Room between an end mill and the hole it goes round in.
    pub clearance: Micrometres,
    /// By how much a reamer or core drill of the catalog may be ground down.
    pub grind_limit: Micrometres,
}

impl CutterNeed<'_> {
    /// A cutter of that diameter and any reach, with nothing else asked of it.
    pub fn plain(operation: Operation, diameter: Micrometres) -> Self {
        Self {
            operation,
            diameter,
            nominal: diameter,
            enters: Micrometres::ZERO,
            reach: Micrometres::ZERO,
            through: true,
            lead: "",
            thread: None,
            angle_millideg: None,
            within: None,
            below: None,
            clearance: Micrometres::ZERO,
            grind_limit: Micrometres::ZERO,
        }
    }
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
) -> Result<(Vec<Cutter<'k>>, Vec<Unfit>), KnowledgeError> {
    let rule = knowledge.table("tool-tables")?;
    let answer =
        rule.decide(&[("operation", Input::Text(need.operation.name())), ("diameter", Input::Length(need.nominal))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, need.operation.name()))?;
    let tables: Vec<&Table> =
        row.texts("tables")?.into_iter().map(|id| knowledge.table(id)).collect::<Result<_, _>>()?;
    // Only where no catalog has the size itself is a larger cutter ground down to it.
    let grindable = need.operation.is_reaming() || need.operation == Operation::CoreDrill;
    let ground = grindable && tables.iter().all(|table| fitting(table, need, false).is_empty());
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    for table in tables {
        let Some(head) = &table.tool else { continue };
        if !head.operations.contains(&need.operation) {
            continue;
        }
        for candidate in fitting(table, need, ground) {
            if let Some(why) = refuse(candidate, need, machine) {
                rejected.push(why);
                continue;
            }
            let note =
                |code: &str| Note::new(code).with("operation", need.operation.name()).with("order", tables_of(row));
            let mut because = Because::row(candidate, note("cutter"));
            if ground {
                let own = own_diameter(candidate).unwrap_or_default();
                because.note = Note::new("cutter-ground-down").with("own", own).with("size", need.diameter);
                because.unconfirmed =
                    Some("the catalogs have no cutter of this size; it must be ground to order".to_owned());
            }
            cutters.push(Cutter {
                row: candidate,
                head,
                designation: designation(candidate, need)?,
                diameter: own_diameter(candidate).unwrap_or(need.diameter),
                because,
                order: Because::row(row, note("tool-tables")),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(Unfit::NoSize(nothing_of_size(need, row, knowledge)));
    }
    Ok((cutters, rejected))
}

/// Step drills of both diameters, in the order of the tables; class A before B, as the tables have them.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn step_drills<'k>(
    need: &CutterNeed<'_>,
    wide: Micrometres,
    pilot: Micrometres,
    opening: Operation,
    knowledge: &'k Knowledge,
) -> Result<(Vec<Cutter<'k>>, Vec<Unfit>), KnowledgeError> {
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    for table in knowledge.tables().filter(|table| table.column_index("step_diameter").is_some()) {
        let Some(head) = &table.tool else { continue };
        // A flat step for screw heads, or a cone for the chamfer of a thread.
        if !head.operations.contains(&opening) {
            continue;
        }
        for row in table.all_rows() {
            if own_diameter(row) != Some(need.diameter) || row.length_if_any("step_diameter") != Some(wide) {
                continue;
            }
            let designation = designation(row, need)?;
            let length = row.length("step_length")?;
            if length < pilot {
                let fault = CutterFault::DoesNotReach { reach: length, needed: pilot };
                rejected.push(Unfit::Cutter { tool: designation.to_owned(), table: table.id.clone(), fault });
                continue;
            }
            let note = Note::new("step-drill").with("narrow", need.diameter).with("wide", wide);
            cutters.push(Cutter {
                row,
                head,
                designation,
                diameter: need.diameter,
                because: Because::row(row, note.clone()),
                order: Because::table(table, note),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(Unfit::NoSize(NoSize::NoStepDrill { narrow: need.diameter, wide }));
    }
    Ok((cutters, rejected))
}

pub(super) fn tables_of(row: RowRef<'_>) -> String {
    row.value("tables").map(ToString::to_string).unwrap_or_default()
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
