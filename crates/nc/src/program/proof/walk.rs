//! Turns steps into stays: everything done at one point of the part, between the motion to it and the motion away.
//!
//! Motions are those of the tool tip, in the coordinates of the drawing as the part lies in the set-up: machine
//! position minus the zero, and along Z minus the length of the tool over the reference tool. That length does not
//! change when a correction ends: it is the value that the program uses for the tool most often between two tool
//! changes, or else in the whole program.

use std::collections::{BTreeMap, BTreeSet};

use super::cuts::same_position;
use crate::motion::{Axis, BlockRef, Motion, MotionStep, Plane, Position, Sense, Side, Turning, geometry};
use crate::units::Micrometres;

/// A place of the tip.
pub(super) type Tip = [Micrometres; 3];

/// The position of the drawing's zero and of the part's face in a set-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct SetUpFrame {
    /// The zero, machine coordinates, measured with the reference tool.
    pub zero: Position,
    /// Z of the face that is up, in the drawing.
    pub top: Micrometres,
}

/// A point of a set-up where the job cuts the face itself, and the height below which a tool cuts there.
pub(super) type FacedPoint = (usize, [Micrometres; 2], Micrometres);

/// The height below which a tool cuts at a point.
pub(super) fn top_at(setup: usize, at: [Micrometres; 2], faced: &[FacedPoint], top: Micrometres) -> Micrometres {
    let here = |(of, point, _): &&FacedPoint| *of == setup && point.iter().zip(at).all(|(a, b)| same_position(*a, b));
    faced.iter().find(here).map_or(top, |(.., top)| *top)
}

/// How the tip moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TipMotion {
    /// At rapid.
    Rapid,
    /// Straight at feed.
    Feed(f64),
    /// Round a point of the XY plane at feed; `turned` is how far, rad.
    Round { centre: [Micrometres; 2], radius: f64, sense: Sense, turned: f64, feed: f64 },
    /// It waited, s.
    Dwell(f64),
    /// The spindle was switched.
    Spindle,
}

/// One motion of the tip, with the state it was made in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TipMove {
    pub motion: TipMotion,
    pub from: Tip,
    pub to: Tip,
    /// Where the axes stand after it, machine coordinates.
    pub machine: Position,
    /// The spindle during it; for a switch, after it.
    pub turning: Turning,
    pub speed: f64,
    pub coolant: bool,
    /// The active offset register, none where the program gives the value, and the added value.
    pub corrector: (Option<u32>, Micrometres),
    pub block: BlockRef,
    /// Its place among the steps.
    pub order: usize,
}

impl TipMove {
    /// Whether it goes along X or Y.
    pub fn across(&self) -> bool {
        matches!(self.motion, TipMotion::Round { .. }) || self.from[0] != self.to[0] || self.from[1] != self.to[1]
    }

    /// The feed, of a motion at feed.
    pub const fn feed(&self) -> Option<f64> {
        match self.motion {
            TipMotion::Feed(feed) | TipMotion::Round { feed, .. } => Some(feed),
            _ => None,
        }
    }

    /// Whether the axes move.
    pub const fn moves(&self) -> bool {
        matches!(self.motion, TipMotion::Rapid | TipMotion::Feed(_) | TipMotion::Round { .. })
    }

    /// Whether it is below the face anywhere.
    pub fn below(&self, top: Micrometres) -> bool {
        self.from[2] < top || self.to[2] < top
    }
}

/// Everything done at a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PointVisit {
    /// The number of the tool change before it, from 1; 0 before the first.
    pub section: usize,
    /// The tool in the spindle, as the program calls it.
    pub tool: u32,
    /// The place of its set-up in the job.
    pub setup: usize,
    /// The point, drawing coordinates.
    pub at: [Micrometres; 2],
    /// The point, machine coordinates.
    pub machine: [Micrometres; 2],
    /// The motion to this point; none after a tool change or at the beginning of the program.
    pub travel: Option<TipMove>,
    /// The block that brought the tool here.
    pub block: BlockRef,
    /// What followed.
    pub moves: Vec<TipMove>,
}

/// An event of a program that is no motion at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Event {
    /// The program waits for the operator.
    Stop,
    /// Radius correction is active, which no drilling needs.
    Radius,
    /// A tool change: its position, and whether the spindle turned, the coolant flowed and a length correction was
    /// active until then.
    Change { at: Position, turned: bool, coolant: bool, corrected: bool },
    /// The program ends there; whether the spindle turns and the coolant flows.
    End { at: Position, turns: bool, coolant: bool },
}

/// A program as stays and events.
#[derive(Clone, Debug, Default)]
pub(super) struct TipHistory {
    pub visits: Vec<PointVisit>,
    /// Machine functions that move nothing, with their place among the steps.
    pub functions: Vec<(usize, String)>,
    /// With their place among the steps, and the stay they happened at.
    pub events: Vec<(usize, BlockRef, Event)>,
}

struct WalkState {
    at: Position,
    section: usize,
    tool: u32,
    turning: Turning,
    speed: f64,
    coolant: bool,
    corrector: (Option<u32>, Micrometres),
    /// The length of the tool of every section over the reference tool.
    longer: BTreeMap<usize, Micrometres>,
    /// The block that stopped the spindle last.
    stopped_by: Option<BlockRef>,
}

/// Walks through the steps. The part is turned over before step `turned_over`, if the job has a second set-up.
/// `references` are tools, by their program numbers, that need no correction; `faced` points where the face itself is
/// cut, so that circles on it are no travel.
pub(super) fn walk(
    steps: &[MotionStep],
    start: Position,
    frames: &[SetUpFrame],
    turned_over: usize,
    references: &BTreeSet<u32>,
    faced: &[FacedPoint],
) -> TipHistory {
    let mut walk = TipHistory::default();
    let mut state = WalkState {
        at: start,
        section: 0,
        tool: 0,
        turning: Turning::Stopped,
        speed: 0.0,
        coolant: false,
        corrector: (Some(0), Micrometres::ZERO),
        longer: longer(steps, references),
        stopped_by: None,
    };
    for (order, step) in steps.iter().enumerate() {
        let setup = usize::from(order >= turned_over).min(frames.len().saturating_sub(1));
        let Some(frame) = frames.get(setup) else { return walk };
        take(&mut walk, &mut state, (order, step), setup, frame, faced);
        state.at = step.at;
    }
    walk
}

/// The value added along Z after every tool change: the most frequent one there; without any, that of the same tool
/// elsewhere, except for a reference tool, which needs none.
fn longer(steps: &[MotionStep], references: &BTreeSet<u32>) -> BTreeMap<usize, Micrometres> {
    let (mut section, mut tool) = (0, 0);
    let mut tools: BTreeMap<usize, u32> = BTreeMap::new();
    let mut used: BTreeMap<usize, BTreeMap<Micrometres, usize>> = BTreeMap::new();
    let mut by_tool: BTreeMap<u32, BTreeMap<Micrometres, usize>> = BTreeMap::new();
    for step in steps {
        match &step.motion {
            Motion::ToolChange { tool: next } => {
                (section, tool) = (section + 1, *next);
                tools.insert(section, tool);
            }
            Motion::LengthCorrection { axis: Axis::Z, value, .. } if *value != Micrometres::ZERO => {
                *used.entry(section).or_default().entry(*value).or_default() += 1;
                *by_tool.entry(tool).or_default().entry(*value).or_default() += 1;
            }
            _ => {}
        }
    }
    let most = |values: Option<&BTreeMap<Micrometres, usize>>| {
        values.and_then(|values| values.iter().max_by_key(|(_, count)| **count)).map(|(value, _)| *value)
    };
    let elsewhere = |tool: u32| most(by_tool.get(&tool)).filter(|_| !references.contains(&tool));
    tools
        .into_iter()
        .filter_map(|(section, tool)| Some((section, most(used.get(&section)).or_else(|| elsewhere(tool))?)))
        .collect()
}

fn take(
    walk: &mut TipHistory,
    state: &mut WalkState,
    (order, step): (usize, &MotionStep),
    setup: usize,
    frame: &SetUpFrame,
    faced: &[FacedPoint],
) {
    let how = match &step.motion {
        Motion::Rapid => TipMotion::Rapid,
        Motion::Feed { feed_mm_per_min } => TipMotion::Feed(feed_mm_per_min.0),
        Motion::Arc { plane: Plane::Xy, sense, centre, turns, feed_mm_per_min } => {
            let middle = [centre[0].to_mm(), centre[1].to_mm()];
            let [start, end] = [state.at, step.at].map(|at| geometry::in_plane(at, Plane::Xy));
            let turned = geometry::sweep(start, end, middle, *sense) + std::f64::consts::TAU * f64::from(*turns);
            let centre = [centre[0] - frame.zero.x, centre[1] - frame.zero.y];
            let radius = geometry::distance(start, middle);
            TipMotion::Round { centre, radius, sense: *sense, turned, feed: feed_mm_per_min.0 }
        }
        // An arc in another plane does not go round a hole: it counts as a straight cut.
        Motion::Arc { feed_mm_per_min, .. } => TipMotion::Feed(feed_mm_per_min.0),
        Motion::Dwell { seconds } => TipMotion::Dwell(*seconds),
        Motion::Spindle { turning, speed_rpm } => {
            if state.turning != Turning::Stopped && *turning == Turning::Stopped {
                state.stopped_by = Some(step.block);
            }
            (state.turning, state.speed) = (*turning, speed_rpm.0);
            TipMotion::Spindle
        }
        Motion::Coolant { on } => {
            state.coolant = *on;
            return;
        }
        Motion::LengthCorrection { axis: Axis::Z, corrector, value } => {
            state.corrector = (*corrector, *value);
            return;
        }
        Motion::ToolChange { tool } => {
            let turned = state.turning != Turning::Stopped || state.stopped_by == Some(step.block);
            let event = Event::Change {
                at: step.at,
                turned,
                coolant: state.coolant,
                corrected: state.corrector.1 != Micrometres::ZERO,
            };
            walk.events.push((order, step.block, event));
            state.section += 1;
            state.tool = *tool;
            state.turning = Turning::Stopped;
            let tip = tip(step.at, state, frame);
            walk.visits.push(point_visit(state, setup, tip, step, None));
            return;
        }
        Motion::Stop { .. } => {
            walk.events.push((order, step.block, Event::Stop));
            return;
        }
        Motion::End => {
            let turns = state.turning != Turning::Stopped;
            walk.events.push((order, step.block, Event::End { at: step.at, turns, coolant: state.coolant }));
            return;
        }
        Motion::RadiusCorrection { side, .. } => {
            if *side != Side::Off {
                walk.events.push((order, step.block, Event::Radius));
            }
            return;
        }
        Motion::Auxiliary { word } => {
            walk.functions.push((order, word.clone()));
            return;
        }
        Motion::LengthCorrection { .. } => return,
    };
    let (from, to) = (tip(state.at, state, frame), tip(step.at, state, frame));
    let made = TipMove {
        motion: how,
        from,
        to,
        machine: step.at,
        turning: state.turning,
        speed: state.speed,
        coolant: state.coolant,
        corrector: state.corrector,
        block: step.block,
        order,
    };
    let nowhere = made.moves() && from == to && !made.across();
    if nowhere {
        return;
    }
    if walk.visits.is_empty() {
        walk.visits.push(point_visit(state, setup, from, step, None));
    }
    let cuts_the_face = walk.visits.last().filter(|_| made.feed().is_some());
    let top = cuts_the_face.map_or(frame.top, |last| top_at(last.setup, last.at, faced, frame.top));
    if made.across() && !made.below(top) {
        walk.visits.push(point_visit(state, setup, to, step, Some(made)));
    } else if let Some(last) = walk.visits.last_mut() {
        // A part turned over at the same point is a new part for the tool.
        if last.setup != setup && last.moves.is_empty() && last.travel.is_none() {
            last.setup = setup;
            last.at = [from[0], from[1]];
        }
        last.moves.push(made);
    }
}

fn tip(at: Position, state: &WalkState, frame: &SetUpFrame) -> Tip {
    let longer = state.longer.get(&state.section).copied().unwrap_or_default();
    [at.x - frame.zero.x, at.y - frame.zero.y, at.z - frame.zero.z - longer]
}

fn point_visit(state: &WalkState, setup: usize, at: Tip, step: &MotionStep, travel: Option<TipMove>) -> PointVisit {
    PointVisit {
        section: state.section,
        tool: state.tool,
        setup,
        at: [at[0], at[1]],
        machine: [step.at.x, step.at.y],
        travel,
        block: step.block,
        moves: Vec::new(),
    }
}
