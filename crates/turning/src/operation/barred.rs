//! Tools that the proof rejected for a work, so that the next candidate is planned.

use crate::note::{Figure, Finding, IntoFigure, Note, Severity};
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::jobs::{Job, Work as JobWork};

use super::{Operation, SetUpWork, proof};

/// A tool that must not do a work again.
#[derive(Clone, Debug, PartialEq)]
pub struct Barred {
    /// The number of the set-up.
    pub set_up: u8,
    /// The side.
    pub side: Side,
    /// The work.
    pub stage: Stage,
    /// The grooves and threads that must be left; empty for roughing and finishing.
    pub surfaces: Vec<SurfaceName>,
    /// The designation of the tool.
    pub tool: String,
    /// The finding of the proof.
    pub why: Note,
}

/// The work for which a tool is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// To rough zones.
    Roughing,
    /// To finish contours.
    Finishing,
    /// To cut grooves, hollows and threads: what a tool cannot cut safely is left, so that the rest can be made.
    Cutting,
}

impl Stage {
    /// The stage of a job; none if its tool is not chosen among turning tools.
    const fn of(work: JobWork) -> Option<Self> {
        match work {
            JobWork::Face | JobWork::Rough => Some(Self::Roughing),
            JobWork::Finish => Some(Self::Finishing),
            JobWork::Groove | JobWork::Thread => Some(Self::Cutting),
            JobWork::Centre
            | JobWork::Drill
            | JobWork::Flatten
            | JobWork::Countersink
            | JobWork::CoreDrill
            | JobWork::Ream
            | JobWork::Tap
            | JobWork::PartOff => None,
        }
    }
}

impl Barred {
    /// Whether another bars the same tool from the same work, whatever the proof found.
    pub fn is_same(&self, other: &Self) -> bool {
        (self.set_up, self.side, self.stage) == (other.set_up, other.side, other.stage)
            && (&self.tool, &self.surfaces) == (&other.tool, &other.surfaces)
    }

    /// The finding for the page; what is left for it is wrong.
    pub fn finding(&self) -> Finding {
        let told = |code: &'static str| {
            Note::new(code).with("number", self.set_up).with("tool", self.tool.clone()).with("why", self.why.clone())
        };
        if self.surfaces.is_empty() {
            return Finding::of_part(Severity::Note, told("tool-barred"));
        }
        let surfaces = Figure::list(self.surfaces.iter().map(IntoFigure::into_figure));
        Finding::of_part(Severity::Wrong, told("cut-barred").with("surfaces", surfaces))
    }
}

/// The tools that the proof rejects in an operation, where others could be tried.
pub(super) fn rejected(operation: &Operation) -> Vec<Barred> {
    let mut barred = Vec::new();
    for (set_up, proven) in operation.set_ups.iter().zip(&operation.proven) {
        for (block, why) in proof::unsafe_places(operation, proven) {
            let Some(job) = job_of(set_up, block) else { continue };
            let Some(stage) = Stage::of(job.work) else { continue };
            let (set_up, side, tool) = (set_up.set_up.number, job.side, job.tool.designation.clone());
            let surfaces = if stage == Stage::Cutting { job.surfaces.clone() } else { Vec::new() };
            barred.push(Barred { set_up, side, stage, surfaces, tool, why });
        }
    }
    barred
}

/// The job that a block of the proof belongs to. Blocks count from 1 through all jobs of a set-up.
fn job_of(set_up: &SetUpWork, block: usize) -> Option<&Job> {
    set_up.jobs.get(index_of(set_up, block)?)
}

/// The same by its index.
pub(super) fn index_of(set_up: &SetUpWork, block: usize) -> Option<usize> {
    let mut last = 0;
    set_up.jobs.iter().position(|job| {
        last += job.path.moves.len();
        block <= last
    })
}
