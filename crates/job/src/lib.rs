//! The job: motions and technology as one tree, made from a plan and the same for every control.
//!
//! A job gives the position of the part on the machine, the order of the tools, the points of each tool and the
//! cycles there. Writers print it in the language of a control, drawings show it, and programs are compared with it.
//! Heights are Z in the drawing of the part, in the current set-up.
//!
//! - `make` turns a plan into the tree; `cycle` is the cycle of one transition, by the rule `machining-cycle`;
//! - `part_position` is the position of the part on the machine, `stand` what a setter is told of it; `on_table` checks that it lies on the table within reach;
//!   `clearance` checks what the tools pass over;
//! - `collisions` are tools in what the file says stands over the face;
//! - `envelope` is how thick the tools are over their cutters;
//! - `time` is the duration of the work: cutting, rapids and manual work;
//! - `norm` is the norm of time of the operation: per piece and per lot;
//! - `unfinished` is what the job leaves undone of the part.
//!
//! Architecture invariant: a job depends on no control and makes no decision that a rule can make.

mod clearance;
mod collisions;
mod cycle;
mod envelope;
mod make;
mod norm;
mod on_table;
mod part_position;
mod slot_path;
mod stand;
mod time;
mod unfinished;

// The types of other crates, under one name each in the whole program.
use technolog_core::{error, machine, motion, note, part, plan, shop, zone};
use technolog_knowledge::{self as knowledge, units};
use technolog_tables as tables;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::motion::{Position, Sense};
use crate::note::{Because, Finding};
use crate::part::{Face, Point, Slot, Standing};
use crate::plan::{Operation, Plan};
use crate::shop::Shop;
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute, Seconds};

pub use cycle::{Feeding, cycle};
pub use envelope::{Body, BodyKind, Envelope};
pub use make::make;
pub use norm::{GivenTimes, Norm, NormItem, NormedWork, norm, norm_of};
pub use shop::convention;
pub use slot_path::{SlotMotion, SlotMove, Turn};
use time::timed;
pub use time::{Duration, Hands};
pub use unfinished::{Left, Unfinished};

/// Everything that a machine does for a part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Job {
    /// The part's name.
    pub part: String,
    /// The id of the machine.
    pub machine: String,
    /// The position of the axes for a tool change, machine coordinates.
    pub change_at: Position,
    /// The set-ups in order; one without work is left out.
    pub setups: Vec<SetUp>,
    /// The offset register of every tool with its length correction, as G43 adds it.
    pub correctors: Vec<(u32, Micrometres)>,
    /// What is left undone of the part when all of it is done.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unfinished: Vec<Unfinished>,
    /// How thick each tool is over its cutter.
    #[serde(skip)]
    pub envelopes: Vec<Envelope>,
    /// Findings: the quill does not reach, or the part does not fit under the tools.
    pub findings: Vec<Finding>,
    /// What of them its plan says: what a program would be refused for, but clamps whose height nobody says make no plan wrong,
    /// because its program asks for them.
    #[serde(skip)]
    pub of_plan: Vec<Finding>,
}

/// The function of a zero, counted from 0 through all set-ups: G54 of the first, G55 of the second.
fn frame(zero: usize) -> u8 {
    54 + u8::try_from(zero).unwrap_or(u8::MAX).min(5)
}

/// Writes into a plan what its job says of it: how its time is spent, how the part stands, and what prevents programs from running
/// on the machine.
///
/// # Errors
/// The knowledge base has no answer.
pub fn tell(plan: &mut Plan, job: &Job, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    timed(plan, job, shop)?;
    plan.setup.stands = stand::stands(plan, job, shop)?;
    let new: Vec<Finding> = job.of_plan.iter().filter(|finding| !plan.findings.contains(finding)).cloned().collect();
    plan.findings.extend(new);
    Ok(())
}

impl Job {
    /// Every stop in the order of the work.
    pub fn stops(&self) -> impl Iterator<Item = (&SetUp, &ToolWork, &Stop)> {
        self.setups.iter().flat_map(|setup| {
            setup.works.iter().flat_map(move |work| work.stops.iter().map(move |stop| (setup, work, stop)))
        })
    }
}

/// One clamping of the part on the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SetUp {
    /// From 1.
    pub number: u32,
    /// The face that is up.
    pub face: Face,
    /// The functions of its zeros: several where the drawing dimensions its holes from opposite sides. On a blank of nominal size
    /// all of them are `zero`.
    #[serde(skip)]
    pub frames: Vec<u8>,
    /// The zero of the part's drawing, machine coordinates, measured with the reference tool. In the second set-up
    /// the part is turned over about the line through its middle along Y: its X has the opposite direction.
    pub zero: Position,
    /// Height of the support under the part, above the table.
    pub supports: Micrometres,
    /// From the table to the spindle nose with the quill retracted: the setting of the knee.
    pub nose: Micrometres,
    /// The work of each tool, in order.
    pub works: Vec<ToolWork>,
    /// What stands over the face.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub standing: Vec<Standing>,
}

/// One tool from its change to the next.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToolWork {
    /// The index of its visit in the plan, from 0; a work may be a part of the visit.
    #[serde(skip)]
    pub visit: usize,
    /// The function of the zero that its points are counted from: 54 for G54.
    #[serde(skip)]
    pub frame: u8,
    /// Its number in the plan.
    pub tool: u32,
    /// Its place in the magazine: what a program calls T.
    pub place: u32,
    /// The number of its offset register.
    pub corrector: u32,
    /// Its designation.
    pub designation: String,
    /// What it does first: its name for people.
    pub operation: Operation,
    /// Its diameter.
    pub diameter_mm: Micrometres,
    /// The wide diameter of a step drill, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub also_diameter_mm: Option<Micrometres>,
    /// The diameter of the catalog that it is ground down from, where it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ground_from_mm: Option<Micrometres>,
    /// What the operator has to do before it.
    pub pauses: Vec<Pause>,
    /// The diameter that the bar of a boring tool is set to; none for other tools.
    #[serde(skip)]
    pub bar_mm: Option<Micrometres>,
    /// Whether the coolant flows.
    pub coolant: bool,
    /// Why, where a rule decided it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub because: Vec<Because>,
    /// The cycles it runs; stops name them by their place here.
    pub cycles: Vec<Cycle>,
    /// Whether it goes higher only over straps that the plan proposes itself, and may choose lower.
    #[serde(skip)]
    pub over_straps: bool,
    /// The points, in order.
    pub stops: Vec<Stop>,
}

/// What the operator does while the program waits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "pause", rename_all = "kebab-case")]
pub enum Pause {
    /// Puts a tool of the plan into a place of the magazine.
    LoadTool {
        /// The tool's number in the plan.
        tool: u32,
        /// The place.
        place: u32,
    },
    /// Turns the part over.
    TurnOver,
    /// Sets the bar of a boring tool.
    SetBar {
        /// The diameter it shall bore, mm.
        diameter_mm: Micrometres,
    },
}

/// A point and what is done there.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Stop {
    /// Its cycle, by its place in [`ToolWork::cycles`].
    pub cycle: usize,
    /// The group of holes.
    pub hole: String,
    /// The transition of the group, from 0.
    pub transition: usize,
    /// The pass of that transition, from 1.
    pub pass: u32,
    /// The point, in the drawing's coordinates as the part lies in this set-up.
    pub at: Point,
}

/// The motions of a tool for one transition at one point.
///
/// The tool comes at rapid to `begin` above the point, works down to `end`, and retracts to `out`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cycle {
    /// The transition.
    pub operation: Operation,
    /// The manner of infeed and retract.
    pub kind: CycleKind,
    /// The spindle's speed.
    pub speed_rpm: RevsPerMinute,
    /// The feed.
    pub feed_mm_per_min: MillimetresPerMinute,
    /// Z where the feed begins.
    pub begin: Micrometres,
    /// Z of the tip at the bottom.
    pub end: Micrometres,
    /// Z at which the tool moves on to the next point.
    pub out: Micrometres,
    /// How long it turns at the bottom.
    pub dwell_s: Option<Seconds>,
    /// Why.
    pub because: Vec<Because>,
}

impl Cycle {
    /// Whether both make the same motions, for whatever purpose.
    pub fn same_motions(&self, other: &Self) -> bool {
        let figures = |cycle: &Self| (cycle.speed_rpm, cycle.feed_mm_per_min, cycle.begin, cycle.end, cycle.out);
        self.kind == other.kind && figures(self) == figures(other) && self.dwell_s == other.dwell_s
    }
}

/// The manner of infeed and retract.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "cycle", rename_all = "kebab-case")]
pub enum CycleKind {
    /// In at feed, out at rapid.
    Drill,
    /// In and out at feed.
    FeedOut,
    /// In at feed, out at rapid with the spindle stopped.
    BoreStop,
    /// In by steps; after each step out of the hole, and back at rapid to `clearance` above the metal.
    Peck {
        /// Depth of a step.
        step: Micrometres,
        /// Clearance left at the return.
        clearance: Micrometres,
    },
    /// In by steps; after each step back by `retreat`.
    ChipBreak {
        /// Depth of a step.
        step: Micrometres,
        /// The retract.
        retreat: Micrometres,
    },
    /// In with the pitch of the thread, out with the spindle reversed.
    Tap {
        /// The pitch.
        pitch: Micrometres,
    },
    /// Along circles around the point, all at the working feed: at each level out to the first circle, round, out to
    /// the next, and back to the middle.
    Circles {
        /// The feed down, where it is another than that of the circles.
        #[serde(skip_serializing_if = "Option::is_none")]
        plunge_mm_per_min: Option<MillimetresPerMinute>,
        /// Z of the levels, downwards.
        levels: Vec<Micrometres>,
        /// Radii of the mill's centre, outwards.
        radii: Vec<Micrometres>,
        /// The direction: with a clockwise spindle counterclockwise is climb milling.
        sense: Sense,
    },
    /// In a slot, all at feed: at each level along its middle where that is solid, and round along its walls
    /// ([`Cycle::slot_path`]). It begins and ends at the point.
    Slot(SlotCycle),
}

/// The feed of a mill's middle on an arc.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SlotArc {
    /// The radius of its way.
    pub radius: Micrometres,
    /// The feed there.
    pub mm_per_min: MillimetresPerMinute,
}

/// The ways of a mill in a slot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SlotCycle {
    /// The feed down, where the mill cuts there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plunge_mm_per_min: Option<MillimetresPerMinute>,
    /// The feed of the mill's middle on arcs of those radii of its own way, from the tightest on; none where it only goes along the
    /// middle.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub arcs: Vec<SlotArc>,
    /// From the point to the middle of the other end radius, as the part lies in the set-up.
    pub run: Slot,
    /// Z of the levels, downwards.
    pub levels: Vec<Micrometres>,
    /// Whether it goes along the middle first.
    pub along_middle: bool,
    /// How far from the middle line the mill's own middle goes round, outwards.
    pub radii: Vec<Micrometres>,
    /// Of a pocket the radius of the way of the mill's middle in the corners of the last way round; in those before it smaller by as
    /// much as they lie further in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<Micrometres>,
    /// The largest radius by which it comes onto a wall: that of the mill.
    pub lead: Micrometres,
    /// The direction: with a clockwise spindle counterclockwise is climb milling.
    pub sense: Sense,
}
