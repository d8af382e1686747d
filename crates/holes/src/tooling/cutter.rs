//! Finds a cutter: the tables in the order of the rule `tool-tables`, the first row that fits, and for every other
//! row of the right size the inequality that fails. [`super::sizes`] says which rows have the right size,
//! [`super::reach`] what else excludes a row.

use std::rc::Rc;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::Table;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::Micrometres;
use crate::note::{Because, Figure, Note, TO_BE_GROUND};
use crate::plan::Operation;
use crate::reason::{CutterFault, NoSize, Unfit};
use crate::shop::Shop;
use crate::tables::rules::{Lead, ToolTables, ToolTablesFor};
use crate::tables::tools::CutterRow;

use super::reach::refuse;
use super::sizes::{fitting, nothing_of_size};

/// A cutter of a catalog, as planning uses it.
#[derive(Clone, Debug)]
pub struct Cutter<'s, 'k> {
    /// Its row.
    pub row: &'s CutterRow<'k>,
    /// The head of its table.
    pub head: &'k ToolHead,
    /// The designation that fits the hole (through or blind, lead angle).
    pub designation: &'k str,
    /// Its own diameter; for a boring bar the diameter it is set to.
    pub diameter: Micrometres,
    /// The rule or request by which it was chosen.
    pub reason: CutterReason<'k>,
    /// The cutters that were rejected before it.
    pub rejected: Vec<Note>,
}

/// Why a cutter was chosen, as data: most cutters are considered and not taken, so the text is made last.
#[derive(Clone, Debug)]
pub enum CutterReason<'k> {
    /// By the order of the tables for a transition.
    Order {
        /// The rule that names the tables.
        rule: Rc<ToolTables<'k>>,
        /// The transition.
        operation: Operation,
        /// The size of the catalog, where it is ground down.
        ground: Option<Micrometres>,
        /// The size that is required.
        size: Micrometres,
    },
    /// Both diameters of a step drill.
    Steps {
        /// The table of step drills.
        table: &'k Table,
        /// The narrow diameter.
        narrow: Micrometres,
        /// The wide one.
        wide: Micrometres,
    },
    /// A plan names it.
    Named,
}

impl Cutter<'_, '_> {
    /// The reason for the choice.
    pub fn because(&self) -> Because {
        let because = match &self.reason {
            CutterReason::Order { ground: Some(own), size, .. } => Because {
                unconfirmed: Some(TO_BE_GROUND.to_owned()),
                ..Because::row(self.row.row, Note::new("cutter-ground-down").with("own", own).with("size", size))
            },
            CutterReason::Order { rule, operation, ground: None, .. } => {
                Because::row(self.row.row, ordered("cutter", rule, *operation))
            }
            CutterReason::Steps { narrow, wide, .. } => Because::row(self.row.row, steps(*narrow, *wide)),
            CutterReason::Named => Because::row(self.row.row, Note::new("named")),
        };
        because.with_rejected(self.rejected.clone())
    }

    /// The reason for the order of the tables.
    pub fn order(&self) -> Because {
        match &self.reason {
            CutterReason::Order { rule, operation, .. } => {
                Because::row(rule.row, ordered("tool-tables", rule, *operation))
            }
            CutterReason::Steps { table, narrow, wide } => Because::table(table, steps(*narrow, *wide)),
            CutterReason::Named => Because::row(self.row.row, Note::new("named")),
        }
    }
}

fn ordered(code: &'static str, rule: &ToolTables<'_>, operation: Operation) -> Note {
    Note::new(code).with("operation", Figure::operation(operation.name())).with("order", rule.tables.join(", "))
}

fn steps(narrow: Micrometres, wide: Micrometres) -> Note {
    Note::new("step-drill").with("narrow", narrow).with("wide", wide)
}

/// What is required of a cutter.
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
    /// The passes in which a boring bar opens the hole from there.
    pub passes: u32,
    /// How far it must reach into the hole.
    pub reach: Micrometres,
    /// The length of a drill's flutes that must stay open over the hole.
    pub chip_room: Micrometres,
    /// How far its holder must stay over the face.
    pub over_face: Micrometres,
    /// Whether the hole goes through.
    pub through: bool,
    /// The lead angle of a reamer, by the rule `reamer-lead`.
    pub lead: Option<Lead>,
    /// The id of a thread.
    pub thread: Option<&'a str>,
    /// Full angle of a cone, thousandths of a degree.
    pub angle_millideg: Option<u32>,
    /// The wider cylinder through which the cutter enters; absent at a face.
    pub entry_cylinder: Option<Micrometres>,
    /// The depth where its cut begins below the face, and the diameter of the hole above that: a shank that passes
    /// there need not be counted.
    pub hole_above: Option<(Micrometres, Micrometres)>,
    /// Clearance between an end mill and the hole in which it moves round.
    pub clearance: Micrometres,
    /// How much wider than its front a countersink must be to go round the edge; absent where it is sunk.
    pub round: Option<Micrometres>,
    /// How wide a mill may be that cuts its way down; absent where it only goes into the hole.
    pub plunges: Option<Plunging>,
    /// By how much a reamer or core drill of the catalog may be ground down.
    pub grind_limit: Micrometres,
}

/// How wide a mill may be that cuts its way straight down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plunging {
    /// The widest that need not enter the hole; zero where every mill must enter it.
    pub widest: Micrometres,
    /// The widest whose end teeth do not reach its middle: that must lie over the hole. Zero where there is metal.
    pub without_middle: Micrometres,
}

impl CutterNeed<'_> {
    /// The diameter after the first pass: all passes take the same.
    pub(super) fn first_pass(&self) -> Micrometres {
        self.enters + (self.diameter - self.enters).ratio(1, i64::from(self.passes.max(1)))
    }

    /// A cutter of that diameter and any reach, without further requirements.
    pub fn plain(operation: Operation, diameter: Micrometres) -> Self {
        Self {
            operation,
            diameter,
            nominal: diameter,
            enters: Micrometres::ZERO,
            passes: 1,
            reach: Micrometres::ZERO,
            chip_room: Micrometres::ZERO,
            over_face: Micrometres::ZERO,
            through: true,
            lead: None,
            thread: None,
            angle_millideg: None,
            entry_cylinder: None,
            hole_above: None,
            clearance: Micrometres::ZERO,
            round: None,
            plunges: None,
            grind_limit: Micrometres::ZERO,
        }
    }
}

/// The tables that a rule names, with the head of each.
pub(super) type Tables<'s, 'k> = Vec<(&'k ToolHead, &'s [CutterRow<'k>])>;

/// All cutters that fit, in the order of the tables of the rule `tool-tables`, and why others of the right size do
/// not.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn cutters<'s, 'k>(
    need: &CutterNeed<'_>,
    shop: &'s Shop<'k>,
) -> Result<(Vec<Cutter<'s, 'k>>, Vec<Unfit>), KnowledgeError> {
    let question = ToolTablesFor { operation: need.operation, diameter: need.nominal };
    let rule = Rc::new(shop.knowledge.ask(&question)?.need(need.operation.name())?);
    let mut tables: Tables<'s, 'k> = Vec::with_capacity(rule.tables.len());
    for id in &rule.tables {
        let cutters = shop.shelf.cutters_of(id)?;
        tables.push((cutters.head, cutters.rows()?));
    }
    // A larger cutter is ground down only where no catalog has the size itself.
    let ground = is_grindable(need.operation) && tables.iter().all(|(_, rows)| fitting(rows, need, false).is_empty());
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    for (head, rows) in &tables {
        // A slot mill has two teeth and short ones: it is taken only to go down.
        let goes_down = need.operation != Operation::Mill || need.plunges.is_some();
        if !head.operations.contains(&need.operation) || (head.centre_cutting && !goes_down) {
            continue;
        }
        for candidate in fitting(rows, need, ground) {
            if let Some(why) = refuse(candidate, head, need, &shop.machine) {
                rejected.push(why);
                continue;
            }
            cutters.push(Cutter {
                row: candidate,
                head,
                designation: designation(candidate, need)?,
                diameter: candidate.diameter.unwrap_or(need.diameter),
                reason: CutterReason::Order {
                    rule: Rc::clone(&rule),
                    operation: need.operation,
                    ground: ground.then(|| candidate.diameter.unwrap_or_default()),
                    size: need.diameter,
                },
                rejected: Vec::new(),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(Unfit::NoSize(nothing_of_size(need, &rule, &tables)));
    }
    Ok((cutters, rejected))
}

/// Step drills of both diameters, in the order of the tables; class A before B, as the tables have them.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn step_drills<'s, 'k>(
    need: &CutterNeed<'_>,
    wide: Micrometres,
    pilot: Micrometres,
    opening: Operation,
    shop: &'s Shop<'k>,
) -> Result<(Vec<Cutter<'s, 'k>>, Vec<Unfit>), KnowledgeError> {
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    // A flat step for screw heads, or a cone for the chamfer of a thread.
    for tables in shop.shelf.cutters().iter().filter(|tables| tables.head.operations.contains(&opening)) {
        let (table, head) = (tables.table, tables.head);
        for row in tables.rows()? {
            if row.diameter != Some(need.diameter) || row.step_diameter != Some(wide) {
                continue;
            }
            let designation = designation(row, need)?;
            let length = stated(row, "step_length", row.step_length)?;
            if length < pilot {
                let fault = CutterFault::DoesNotReach { reach: length, needed: pilot };
                rejected.push(Unfit::Cutter { tool: designation.to_owned(), table: table.id.clone(), fault });
                continue;
            }
            cutters.push(Cutter {
                row,
                head,
                designation,
                diameter: need.diameter,
                reason: CutterReason::Steps { table, narrow: need.diameter, wide },
                rejected: Vec::new(),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(Unfit::NoSize(NoSize::NoStepDrill { narrow: need.diameter, wide }));
    }
    Ok((cutters, rejected))
}

/// Whether a larger cutter may be ground down to the size that is required.
pub(super) fn is_grindable(operation: Operation) -> bool {
    operation.is_reaming() || operation == Operation::CoreDrill
}

/// A figure that the row of a cutter must have in every table.
///
/// # Errors
/// The row lacks it.
pub(super) fn stated<T>(row: &CutterRow<'_>, what: &str, figure: Option<T>) -> Result<T, KnowledgeError> {
    figure.ok_or_else(|| {
        let why = note!("order-row-has-no-which-shank", row = row.row.number(), what = what);
        KnowledgeError::missing(&row.row.table.id, why)
    })
}

pub(super) fn designation<'k>(row: &CutterRow<'k>, need: &CutterNeed<'_>) -> Result<&'k str, KnowledgeError> {
    let by_bottom = if need.through { row.designation_through } else { row.designation_blind };
    let by_lead = if need.lead == Some(Lead::Deg5) { row.designation_5deg } else { row.designation_15deg };
    stated(row, "designation", row.designation.or(by_bottom).or(by_lead))
}
