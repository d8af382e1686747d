//! The proof that a program makes a part: its cuts are compared with the job, stop by stop.
//!
//! It uses the steps of an interpreter, so it is the same for every control.
//!
//! ```text
//! steps → walk (stays: what was done at one point) → cuts (one way in and out) → matching (which stop of the job each
//! cut makes, with which tool) → compare (cut beside cycle) and around (what is no cut) → Proof
//! ```
//!
//! - every stop of the job needs a cut: a stop without one is missing, a cut without a stop is superfluous;
//! - a cut is compared with its stop: tool and offset register, beginning, depth, steps, circles, retract, speed,
//!   feed, dwell, coolant, and its place in the order of transitions;
//! - any other motion is reported too. So a program without findings does what the job says, and nothing else.
//!
//! The position of the part and the values of the offset registers are given. docs/proof.md lists every comparison
//! and its severity.
//!
//! Architecture invariant: the proof depends on no control and chooses nothing; the job says what is right.

mod around;
mod compare;
mod cuts;
mod finding;
mod matching;
mod milled;
mod obstacles;
mod planned_job;
mod slotted;
mod tools;
mod walk;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::job::{Cycle, CycleKind, Job, SetUp, Stop, ToolWork};
use crate::knowledge::Knowledge;
use crate::motion::{BlockRef, MotionStep, Position};
use crate::note::{Figure, IntoFigure, Note, Severity};
use crate::part::{Part, Point};
use crate::plan::{Operation, Plan, Transition};
use crate::tables::controls::Convention;
use crate::tables::standards::GeneralTolerance;
use crate::units::Micrometres;

use cuts::{Descent, TOLERANCE};
pub use finding::{Code, DeviationFigure, Name, ProgramFinding};
pub use planned_job::PlannedJob;
use walk::{SetUpFrame, TipHistory};

/// The input of a proof: what a program is compared with.
#[derive(Clone, Copy, Debug)]
pub struct ProofInput<'a> {
    /// The plan of the part.
    pub plan: &'a Plan,
    /// Its job.
    pub job: &'a Job,
    /// The drawing's zero in each set-up of the job, machine coordinates.
    pub zeros: &'a [Position],
    /// Where the axes stand when the program begins, machine coordinates.
    pub start: Position,
    /// What may differ from the job.
    pub tolerated: &'a Tolerated,
    /// The machine function that must act before a tap, where the control has one: without it the spindle does not
    /// follow the feed.
    pub tap_word: Option<&'a str>,
    /// How grave a tool change is to which the spindle turns.
    pub turning_at_change: Severity,
    /// Whether the operator uses offset registers of his own: then numbers and values may differ from the plan's.
    pub own_correctors: bool,
}

/// How far a program may differ from its job.
#[derive(Clone, Debug)]
pub struct Tolerated {
    /// The overrun of the tool at a through hole, by the rule `approach`: a program may have less by this much and
    /// still make the hole.
    pub overrun: Micrometres,
    /// How far a reamer may come out of a through hole over free room.
    pub reamer_overrun: Micrometres,
    /// The general tolerances of depths.
    pub depths: Vec<DepthTolerance>,
    /// The factor on the planned speed or feed that is still another choice.
    pub overload: f64,
    /// The same factor for the feed of a centring tool.
    pub spot_overload: f64,
    /// The factor on the planned dwell from which it is a mistake.
    pub overlong: f64,
    /// How far the feed of a tap may be off the pitch of its thread, as a part of it.
    pub tap_near: f64,
}

/// The general tolerance of depths over the one and up to the other.
#[derive(Clone, Copy, Debug)]
pub struct DepthTolerance {
    over: Micrometres,
    up_to: Micrometres,
    /// How far they may be off to either side.
    off: Micrometres,
}

impl Tolerated {
    /// The tolerances of the knowledge base for a part.
    ///
    /// # Errors
    /// A table lacks a figure.
    pub fn read(part: &Part, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let row = crate::zone::approach(part, true, knowledge)?;
        let overload = crate::job::convention(Convention::Overload, knowledge)?.0;
        let overlong = crate::job::convention(Convention::Overlong, knowledge)?.0;
        let spot_overload = crate::job::convention(Convention::SpotOverload, knowledge)?.0;
        let tap_near = crate::job::convention(Convention::TapFeedNear, knowledge)?.0;
        let reamer_overrun =
            Micrometres::from_mm_rounded(crate::job::convention(Convention::ReamerOverrunMost, knowledge)?.0);
        let rows = knowledge.rows::<GeneralTolerance<'_>>()?.into_iter();
        let depths = rows.map(|row| DepthTolerance { over: row.over, up_to: row.up_to, off: row.medium }).collect();
        Ok(Self { overrun: row.overrun, reamer_overrun, depths, overload, spot_overload, overlong, tap_near })
    }

    /// The general tolerance, to either side, of a depth; none of one for which the standard has no row.
    fn depth_of(&self, depth: Micrometres) -> Micrometres {
        let row = self.depths.iter().find(|row| row.over < depth && depth <= row.up_to);
        row.map(|row| row.off).unwrap_or_default()
    }
}

/// The result of a proof: the stops that a program makes, and every deviation.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Proof {
    /// The stops of the job that it makes, in the order of the program.
    pub visits: Vec<MadeStop>,
    /// The stops that it does not make.
    pub missing: Vec<MissingStop>,
    /// The cuts that make no stop.
    pub superfluous: Vec<SuperfluousCut>,
    /// Every deviation, the gravest first.
    pub findings: Vec<ProgramFinding>,
}

impl Proof {
    /// Whether the part is not made as planned.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|finding| finding.severity <= Severity::Wrong)
    }
}

/// A stop of the job that the program makes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MadeStop {
    /// The group of holes.
    pub hole: String,
    /// The transition of the group, from 0.
    pub transition: usize,
    /// Its pass, from 1.
    pub pass: u32,
    /// The point, in the drawing's coordinates as the part lies.
    pub at: Point,
    /// The tool of the program.
    pub tool: u32,
    /// The block that brings the tool there.
    #[serde(flatten)]
    pub block: BlockRef,
}

/// A stop of the job that the program does not make.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MissingStop {
    /// The group of holes.
    pub hole: String,
    /// The transition of the group, from 0.
    pub transition: usize,
    /// What it is.
    pub operation: Operation,
    /// Its pass, from 1.
    pub pass: u32,
    /// The point.
    pub at: Point,
    /// The tool of the plan.
    pub tool: u32,
}

/// A cut that makes no stop of the job.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SuperfluousCut {
    /// The point.
    pub at: Point,
    /// How deep it goes, in the drawing.
    pub z: Micrometres,
    /// The tool of the program.
    pub tool: u32,
    /// The block that brings the tool there.
    #[serde(flatten)]
    pub block: BlockRef,
}

/// A stop of the job with what it belongs to.
#[derive(Clone, Copy, Debug)]
struct StopTask<'a> {
    /// Place of the set-up in the job.
    setup: usize,
    /// Place of the work among all works.
    work: usize,
    tool: &'a ToolWork,
    stop: &'a Stop,
    cycle: &'a Cycle,
    transition: &'a Transition,
}

impl StopTask<'_> {
    /// Z reached by the steps of a deep hole before the first one in the metal: the step of a small drill may be
    /// shorter than the approach. Without such steps, the beginning of the feed.
    fn reached_in_air(&self, metal: Micrometres) -> Micrometres {
        let (CycleKind::Peck { step, .. } | CycleKind::ChipBreak { step, .. }) = self.cycle.kind else {
            return self.cycle.begin;
        };
        let room = (self.cycle.begin - metal).micrometres().max(0);
        self.cycle.begin - Micrometres::new(room / step.micrometres().max(1) * step.micrometres())
    }
}

/// Compares the steps of a program with a job.
pub fn prove(steps: &[MotionStep], input: &ProofInput<'_>) -> Proof {
    let tasks = tasks(input);
    let frame = |zero: &Position| SetUpFrame { zero: *zero, top: input.plan.part.datum.top };
    let mut frames: Vec<SetUpFrame> = input.zeros.iter().map(frame).collect();
    if frames.is_empty() {
        // A job without work has no set-up, but its program has a beginning and an end.
        frames.push(frame(&Position::default()));
    }
    let turned_over = matching::turned_over(steps, input, &frames, &tasks);
    let made = ObservedCuts::of(steps, input, &frames, turned_over);
    let tools = tools::tools(&made, &tasks, input);
    let matched = matching::matched(&made.cuts, &tools, &tasks);

    let mut findings = tools.findings.clone();
    compare::all(&made, &matched, &tools, &tasks, input, &mut findings);
    obstacles::all(&made, &tools, input, &mut findings);
    around::all(&made, &matched, &tasks, input, turned_over, &mut findings);
    let mut proof = Proof { findings: folded(findings), ..Proof::default() };
    for (cut, task) in made.cuts.iter().zip(&matched.task_of) {
        let at = Point::from(cut.at);
        match task.and_then(|task| tasks.get(task)) {
            Some(StopTask { stop, .. }) => proof.visits.push(MadeStop {
                hole: stop.hole.clone(),
                transition: stop.transition,
                pass: stop.pass,
                at: stop.at,
                tool: cut.tool,
                block: cut.place,
            }),
            None => {
                proof.superfluous.push(SuperfluousCut { at, z: cut.deepest(), tool: cut.tool, block: cut.place });
            }
        }
    }
    for (task, cut) in tasks.iter().zip(&matched.cut_of) {
        if cut.is_none() {
            proof.missing.push(MissingStop {
                hole: task.stop.hole.clone(),
                transition: task.stop.transition,
                operation: task.cycle.operation,
                pass: task.stop.pass,
                at: task.stop.at,
                tool: task.tool.tool,
            });
        }
    }
    proof
}

/// The cuts of a program and all motions around them.
#[derive(Clone, Debug)]
struct ObservedCuts {
    walk: TipHistory,
    cuts: Vec<Descent>,
    /// Motions above the face: the stay, the cut they lead to, the motion.
    above: Vec<(usize, Option<usize>, walk::TipMove)>,
}

impl ObservedCuts {
    fn of(steps: &[MotionStep], input: &ProofInput<'_>, frames: &[SetUpFrame], turned_over: usize) -> Self {
        let works = input.job.setups.iter().flat_map(|setup| &setup.works).filter(|_| !input.own_correctors);
        let needs_none = |tool: u32| input.job.correctors.contains(&(tool, Micrometres::ZERO));
        let references = works.filter(|work| needs_none(work.corrector)).map(|work| work.place).collect();
        let faced = faced(input);
        let walk = walk::walk(steps, input.start, frames, turned_over, &references, &faced);
        let (mut cuts, mut above) = (Vec::new(), Vec::new());
        for (number, stay) in walk.visits.iter().enumerate() {
            let Some(frame) = frames.get(stay.setup) else { continue };
            let before = cuts.len();
            let top = walk::top_at(stay.setup, stay.at, &faced, frame.top);
            let (mut own, high) = cuts::cuts(number, stay, top);
            cuts.append(&mut own);
            above.extend(high.into_iter().map(|(leads, made)| (number, leads.map(|at| before + at), made)));
        }
        Self { walk, cuts, above }
    }
}

/// Points where the job cuts the face itself, because its stock is above the drawing: by set-up and point the height
/// below which a tool cuts there.
fn faced(input: &ProofInput<'_>) -> Vec<walk::FacedPoint> {
    let top = input.plan.part.datum.top;
    let mut faced = Vec::new();
    for (number, setup) in input.job.setups.iter().enumerate() {
        for work in &setup.works {
            for stop in &work.stops {
                if let Some(cycle) = work.cycles.get(stop.cycle).filter(|cycle| cycle.end >= top) {
                    faced.push((number, [stop.at.x, stop.at.y], cycle.end + TOLERANCE + TOLERANCE));
                }
            }
        }
    }
    faced
}

fn tasks<'a>(input: &ProofInput<'a>) -> Vec<StopTask<'a>> {
    let mut tasks = Vec::new();
    let mut work = 0;
    let setups: &'a [SetUp] = &input.job.setups;
    for (setup, of) in setups.iter().enumerate() {
        for tool in &of.works {
            for stop in &tool.stops {
                let hole = input.plan.holes.iter().find(|hole| hole.name == stop.hole);
                let transition = hole.and_then(|hole| hole.transitions.get(stop.transition));
                if let (Some(cycle), Some(transition)) = (tool.cycles.get(stop.cycle), transition) {
                    tasks.push(StopTask { setup, work, tool, stop, cycle, transition });
                }
            }
            work += 1;
        }
    }
    tasks
}

/// Equal findings at several points of a group are merged, with their count; the gravest first, then in the program's
/// order.
fn folded(findings: Vec<ProgramFinding>) -> Vec<ProgramFinding> {
    let mut kept: Vec<(ProgramFinding, usize)> = Vec::new();
    let mut known: BTreeMap<(Severity, Note), usize> = BTreeMap::new();
    for finding in findings {
        let alike = finding.note.clone();
        let alike = if finding.hole().is_some() { alike.without(Name::At.name()) } else { alike };
        match known.get(&(finding.severity, alike.clone())) {
            Some(&at) => kept[at].1 += 1,
            None => {
                known.insert((finding.severity, alike), kept.len());
                kept.push((finding, 0));
            }
        }
    }
    let mut findings: Vec<ProgramFinding> = kept
        .into_iter()
        .map(|(finding, more)| if more > 0 { finding.with(Name::More, more) } else { finding })
        .collect();
    findings.sort_by_key(|finding| (finding.severity, finding.block.is_none(), finding.block));
    findings
}

/// A point as sentences show it: `X10 Y-5.5`.
fn shown(at: [Micrometres; 2]) -> Figure {
    let [x, y] = at.map(IntoFigure::into_figure);
    Figure::List(vec!["X".into_figure(), x, " Y".into_figure(), y], "")
}
