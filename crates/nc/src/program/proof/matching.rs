//! Matches cuts with the stops of the job.

use std::collections::BTreeMap;

use super::cuts::{Descent, TOLERANCE, same_position};
use super::tools::Tools;
use super::walk::SetUpFrame;
use super::{ObservedCuts, ProofInput, StopTask};
use crate::motion::{Motion, MotionStep};
use crate::units::Micrometres;

/// Cuts and stops, each with its partner.
#[derive(Clone, Debug, Default)]
pub(super) struct Matched {
    /// The task of each cut.
    pub task_of: Vec<Option<usize>>,
    /// The cut of each task.
    pub cut_of: Vec<Option<usize>>,
}

/// Tasks by set-up and X: a plate may have thousands.
pub(super) struct TaskIndex(BTreeMap<(usize, Micrometres), Vec<usize>>);

impl TaskIndex {
    pub fn of(tasks: &[StopTask<'_>]) -> Self {
        let mut places: BTreeMap<_, Vec<usize>> = BTreeMap::new();
        for (number, task) in tasks.iter().enumerate() {
            places.entry((task.setup, task.stop.at.x)).or_default().push(number);
        }
        Self(places)
    }

    /// The tasks at the point of a cut, in the order of the job.
    pub fn at(&self, cut: &Descent, tasks: &[StopTask<'_>]) -> Vec<usize> {
        let [x, y] = cut.at;
        let found = self.0.range((cut.setup, x - TOLERANCE)..=(cut.setup, x + TOLERANCE));
        let mut found: Vec<usize> = found.flat_map(|(_, numbers)| numbers.iter().copied()).collect();
        found.retain(|&number| tasks.get(number).is_some_and(|task| same_position(task.stop.at.y, y)));
        found.sort_unstable();
        found
    }
}

/// Whether a cut goes as deep as a task asks.
pub(super) fn fits(cut: &Descent, task: &StopTask<'_>) -> bool {
    same_position(cut.deepest(), task.cycle.end)
}

/// Assigns a task to each cut: first by tool, point and depth, in the order of the program; then cuts by another
/// tool; then cuts of another depth.
pub(super) fn matched(cuts: &[Descent], tools: &Tools, tasks: &[StopTask<'_>]) -> Matched {
    let places = TaskIndex::of(tasks);
    let mut matched = Matched { task_of: vec![None; cuts.len()], cut_of: vec![None; tasks.len()] };
    for round in 0..3 {
        for (number, cut) in cuts.iter().enumerate() {
            // A tip that only moves into the part at rapid makes no hole.
            if matched.task_of[number].is_some() || cut.begin().is_none() {
                continue;
            }
            let own = tools.of_section(cut.section);
            let free = places.at(cut, tasks).into_iter().filter(|&task| matched.cut_of[task].is_none());
            let mut free = free.filter(|&task| (own == Some(tasks[task].tool.tool)) == (round != 1));
            let found = match round {
                2 => free.min_by_key(|&task| ((tasks[task].cycle.end - cut.deepest()).abs(), task)),
                _ => free.find(|&task| fits(cut, &tasks[task])),
            };
            if let Some(task) = found {
                matched.task_of[number] = Some(task);
                matched.cut_of[task] = Some(number);
            }
        }
    }
    matched
}

/// The step before which the part is turned over: at the stop or, without one, at the tool change for which most cuts
/// fit. None if the job has one set-up.
pub(super) fn turned_over(
    steps: &[MotionStep],
    input: &ProofInput<'_>,
    frames: &[SetUpFrame],
    tasks: &[StopTask<'_>],
) -> usize {
    let never = steps.len();
    if frames.len() < 2 {
        return never;
    }
    let places = TaskIndex::of(tasks);
    let score = |at: usize| {
        let cuts = ObservedCuts::of(steps, input, frames, at).cuts;
        cuts.iter().filter(|cut| places.at(cut, tasks).into_iter().any(|task| fits(cut, &tasks[task]))).count()
    };
    let at = |wanted: fn(&Motion) -> bool| {
        steps.iter().enumerate().filter(move |(_, step)| wanted(&step.motion)).map(|(at, _)| at)
    };
    let stops = at(|motion| matches!(motion, Motion::Stop { .. }));
    let changes = at(|motion| matches!(motion, Motion::ToolChange { .. }));
    let mut best = (0, never);
    for place in stops.chain(changes) {
        let fitting = score(place);
        if fitting > best.0 {
            best = (fitting, place);
        }
    }
    best.1
}
