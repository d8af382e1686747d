//! A plan as stated: what the file contains, how it is printed, and where; nothing else.

use std::collections::BTreeMap;
use technolog_note::{Note, note};

use crate::error::KnowledgeError;
use crate::knowledge::diagnostic::{Diagnostic, Place};
use crate::knowledge::yaml::Node;
use crate::note::Severity;
use crate::part::Part;
use crate::plan::{CuttingMethod, Feature, Operation};
use crate::tables::audit::PlanPart;

use super::finding::Section;
use super::quantity::{Id, Quantity, Scope};
use super::sheet::Unsaid;

/// A stated value with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedValue<T> {
    /// What it means.
    pub value: T,
    /// Where it stands.
    pub place: Place,
}

/// A text as written.
pub type Text = StatedValue<String>;

/// A number as written.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedFigure {
    /// Its value, in the unit of its quantity.
    pub value: f64,
    /// As it is printed.
    pub text: String,
    /// The value of one unit in its last place: 0.01 for `26.52`.
    pub last_place: f64,
    /// Where it stands.
    pub place: Place,
}

/// The figures of one part of a plan.
pub type Figures = BTreeMap<Quantity, StatedFigure>;

/// A plan as stated.
#[derive(Clone, Debug)]
pub struct Stated {
    /// Its name.
    pub name: String,
    /// The file as the user knows it.
    pub file: String,
    /// The part it is for.
    pub part: Part,
    /// The method of its cutting conditions; the program's plan for comparison uses the same.
    pub method: CuttingMethod,
    /// What it says it covers; nothing said is everything.
    pub scope: Option<Vec<PlanPart>>,
    /// Whether `technolog plan` wrote it: then its figures are rounded as that command rounds, and its route is
    /// listed hole by hole.
    pub is_own: bool,
    /// The file of a plan of the program, as a tree with places.
    pub tree: Option<Node>,
    /// The route, in the order of work.
    pub rows: Vec<Row>,
    /// The tools, in the order of the file.
    pub tools: Vec<Tool>,
    /// Conditions, each for one or more rows.
    pub conditions: Vec<Conditions>,
    /// How the part is clamped.
    pub clamping: Option<Clamping>,
    /// The program that carries it out.
    pub program: Option<Program>,
    /// Where the time goes.
    pub times: Figures,
    /// The numbers of the tools in the order of their changes, where the plan states it apart from the rows.
    pub changes: Option<Vec<u32>>,
    /// Whose work it is, where the plan says so.
    pub author: Author,
    /// Whether it is a list of tools and nothing else.
    pub is_list: bool,
    /// What a list of tools does not say of its part, where the part is made of the list itself.
    pub unsaid: Option<Unsaid>,
    /// What is to be said of how it is written: figures that there cannot be, columns that were not read.
    pub remarks: Vec<Remark>,
}

/// Whose work a plan is.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Author {
    /// The student.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub student: Option<String>,
    /// The group.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub group: Option<String>,
    /// The variant of the task.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub variant: Option<String>,
}

/// Something to be said of how a plan is written.
#[derive(Clone, Debug)]
pub struct Remark {
    /// Where.
    pub place: Place,
    /// What.
    pub note: Note,
    /// How grave.
    pub severity: Severity,
    /// Where in the report.
    pub section: Section,
    /// The figure, with its text.
    pub figure: Option<(Quantity, String)>,
    /// Whether the proof of a program says it better, where it can be made.
    pub unless_proven: bool,
}

impl Stated {
    /// Whether the plan is read out of a program.
    pub fn is_of_program(&self) -> bool {
        self.program.as_ref().is_some_and(|program| program.alone.is_some())
    }

    /// Whether the plan covers that part.
    pub fn covers(&self, part: PlanPart) -> bool {
        self.scope.as_ref().is_none_or(|scope| scope.contains(&part))
    }

    /// An error of the knowledge base as a mistake of the file, where the file is the reason. Checked tables lack
    /// nothing for a part that was read, so the reason is a figure of the part inside a plan of the program.
    pub fn at_fault(&self, error: &KnowledgeError) -> Option<Diagnostic> {
        let part = self.tree.as_ref()?.get("part")?;
        let message = note!("planfile-part-this-plan-cannot-planned", error = error);
        let help = note!("planfile-mend-part-plan-write-plan");
        Some(Diagnostic::error("bad-plan", message, part.place.clone()).help(help))
    }
}

/// A row of the route: one transition of one group of holes.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its number in the plan.
    pub number: u32,
    /// Where it stands.
    pub place: Place,
    /// What is done.
    pub operation: StatedValue<Operation>,
    /// The group of holes.
    pub hole: Option<Text>,
    /// What of the hole it makes, where the plan says so.
    pub feature: Option<Feature>,
    /// The step of a stepped hole.
    pub step: Option<usize>,
    /// The set-up it is done in, from 1, where the plan says so.
    pub setup: Option<u32>,
    /// Whether it is done on another machine.
    pub elsewhere: bool,
    /// The number of its tool.
    pub tool: Option<StatedValue<u32>>,
    /// The scheme it belongs to.
    pub scheme: Option<Text>,
    /// The table of the scheme.
    pub table: Option<Text>,
    /// Count, diameter, diameter before, depth, passes.
    pub figures: Figures,
}

impl Row {
    /// Whether the row works on the main cylinder of its hole, by what the plan states: it names no step and no other
    /// feature.
    pub fn of_main_cylinder(&self) -> bool {
        self.step.is_none() && self.feature.is_none_or(|feature| feature == Feature::Bore)
    }

    /// Whether the row widens or threads the main cylinder; centring and edges leave it as it is.
    pub fn opens_main_cylinder(&self) -> bool {
        let operation = self.operation.value;
        self.of_main_cylinder() && operation != Operation::CentreDrill && !operation.is_of_edge()
    }
}

/// A tool with its holder.
#[derive(Clone, Debug)]
pub struct Tool {
    /// Its number: T1 is 1.
    pub number: u32,
    /// Where it stands.
    pub place: Place,
    /// The cutter.
    pub designation: Option<Text>,
    /// The standard it is said to be of.
    pub standard: Option<Text>,
    /// Its table, where the plan names it.
    pub table: Option<Text>,
    /// How it is held: `cylindrical`, `morse`, `shell`, `taper`.
    pub shank: Option<Text>,
    /// The holder.
    pub holder: Option<Text>,
    /// The standard of the holder.
    pub holder_standard: Option<Text>,
    /// `G43` or `G44`: how the correction is called.
    pub correction_word: Option<Text>,
    /// Dimensions, lengths, corrections.
    pub figures: Figures,
}

/// A factor by its name.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Its name, as in the table `card-corrections` or of the author's own.
    pub name: Text,
    /// Its value; absent if the plan only names it.
    pub value: Option<StatedFigure>,
}

/// Cutting conditions.
#[derive(Clone, Debug)]
pub struct Conditions {
    /// Where they stand.
    pub place: Place,
    /// The rows they are for, by their places in the route.
    pub rows: Vec<usize>,
    /// Whether the plan says that something other than the cutting speed limited them.
    pub is_limited: bool,
    /// Whether a mill moves in circles: the simple formulas do not apply.
    pub rounds: bool,
    /// The factors of feed, speed, force and power.
    pub factors: BTreeMap<Quantity, Vec<Factor>>,
    /// Everything else.
    pub figures: Figures,
}

impl Conditions {
    /// The feed used: the one taken, where it is stated beside the computed one.
    pub fn feed(&self) -> Quantity {
        if self.figures.contains_key(&Quantity::FeedTaken) { Quantity::FeedTaken } else { Quantity::Feed }
    }
}

/// The clamping.
#[derive(Clone, Debug)]
pub struct Clamping {
    /// Where it stands.
    pub place: Place,
    /// The row whose torque it is computed for.
    pub row: Option<StatedValue<usize>>,
    /// The group of holes, where the plan names it instead.
    pub hole: Option<Text>,
    /// The screw.
    pub screw: Option<Text>,
    /// The clamp's designation.
    pub designation: Option<Text>,
    /// Its standard.
    pub standard: Option<Text>,
    /// Where the clamps press, mm.
    pub at: Vec<crate::part::Point>,
    /// The figures.
    pub figures: Figures,
}

/// The program of a plan.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its file, as the plan names it.
    pub file: Text,
    /// Its text.
    pub text: String,
    /// The control.
    pub control: String,
    /// The place of the control in the plan.
    pub place: Place,
    /// The setting: its name and text.
    pub setting: Option<(String, String)>,
    /// What is added to its coordinates to have the drawing's.
    pub shift: crate::motion::Position,
    /// Where the plan is read out of it: then it cannot differ from its plan.
    pub alone: Option<Alone>,
}

/// What is known of a program without a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Alone {
    /// Whether it can be held against the drawing: every cut is known.
    pub is_proven: bool,
    /// Whether the operator's zeros and lengths are given: without them nobody knows how far the axes go.
    pub is_set: bool,
}

impl Stated {
    /// A figure, where it is stated.
    pub fn figure(&self, id: Id) -> Option<&StatedFigure> {
        let figures = match id.scope {
            Scope::Constant => return None,
            Scope::Row(at) => &self.rows.get(at)?.figures,
            Scope::Tool(at) => &self.tools.get(at)?.figures,
            Scope::Conditions(at) => {
                let conditions = self.conditions.get(at)?;
                if let Some(factors) = conditions.factors.get(&id.quantity) {
                    return factors.get(id.index)?.value.as_ref();
                }
                &conditions.figures
            }
            Scope::Clamping => &self.clamping.as_ref()?.figures,
            Scope::Times => &self.times,
        };
        figures.get(&id.quantity)
    }

    /// The place of a tool in the list, by its number.
    pub fn tool_at(&self, number: u32) -> Option<usize> {
        self.tools.iter().position(|tool| tool.number == number)
    }

    /// The tool of a row.
    pub fn tool_of(&self, row: &Row) -> Option<usize> {
        self.tool_at(row.tool.as_ref()?.value)
    }

    /// The conditions of a row.
    pub fn conditions_of(&self, row: usize) -> Option<usize> {
        self.conditions.iter().position(|conditions| conditions.rows.contains(&row))
    }

    /// The rows of a tool.
    pub fn rows_of_tool(&self, number: u32) -> impl Iterator<Item = (usize, &Row)> {
        let own = move |row: &&Row| row.tool.as_ref().is_some_and(|tool| tool.value == number);
        self.rows.iter().enumerate().filter(move |(_, row)| own(row))
    }

    /// The rows of a group of holes in order.
    pub fn rows_of_hole<'a>(&'a self, hole: &'a str) -> impl Iterator<Item = (usize, &'a Row)> {
        let own = move |row: &&Row| row.hole.as_ref().is_some_and(|name| name.value == hole);
        self.rows.iter().enumerate().filter(move |(_, row)| own(row))
    }

    /// Whether a later row of the group mills, which makes the bottom flat.
    pub fn mill_follows(&self, hole: &str, row: usize) -> bool {
        self.rows_of_hole(hole).any(|(other, own)| other > row && own.operation.value == Operation::Mill)
    }

    /// The row that drills out what a row drills, if one does.
    pub fn drilled_out(&self, hole: &str, row: usize) -> Option<usize> {
        let first = self.rows.get(row).is_some_and(|own| own.operation.value == Operation::Drill);
        let out = |(other, own): &(usize, &Row)| *other > row && own.operation.value == Operation::DrillOut;
        self.rows_of_hole(hole).find(out).filter(|_| first).map(|(other, _)| other)
    }

    /// Whether a row of a group is followed by a reamer.
    pub fn reamer_follows(&self, hole: &str, row: usize) -> bool {
        self.rows_of_hole(hole).any(|(other, own)| other > row && own.operation.value.is_reaming())
    }
}
