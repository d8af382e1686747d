//! What each cut of a program is: by the words of its tool, or by its motion where that can be one thing only.

use std::collections::BTreeSet;

use crate::motion::Position;
use crate::part::Part;
use crate::plan::Operation;
use crate::tables::audit::{ToolKind, ToolStage};
use crate::units::Micrometres;

use super::Placed;
use super::told::ToldTools;

/// A cut as a transition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Meant {
    pub operation: Operation,
    /// Whether the motion says it and no word.
    pub derived: bool,
}

/// The transitions of the cuts, in their order; none where nothing sure is known.
///
/// A spot goes no deeper than the radius of its hole or thread and `chamfer`, which it may break. `drilled` are the holes that are no
/// finer than drills leave them.
pub(super) fn meant(
    placed: &[Placed],
    part: &Part,
    told: &ToldTools,
    shift: Position,
    (chamfer, drilled): (Micrometres, &BTreeSet<&str>),
) -> Vec<Option<Meant>> {
    let all = (0..placed.len()).map(|at| one(at, placed, part, told, shift, (chamfer, drilled)));
    let mut all: Vec<Option<Meant>> = all.collect();
    // What a tool is at one point of a group it is at all: where a later cut is forgotten, too.
    for at in 0..placed.len() {
        let same = |other: &Placed| (&other.hole, other.cut.section) == (&placed[at].hole, placed[at].cut.section);
        if all[at].is_none() && !placed[at].cut.mills {
            all[at] = placed.iter().zip(&all).find_map(|(other, meant)| meant.filter(|_| same(other)));
        }
    }
    all
}

fn one(
    at: usize,
    placed: &[Placed],
    part: &Part,
    told: &ToldTools,
    shift: Position,
    (chamfer, drilled): (Micrometres, &BTreeSet<&str>),
) -> Option<Meant> {
    let own = placed.get(at)?;
    let here = |other: &&Placed| other.hole == own.hole && other.cut.at == own.cut.at;
    let of = |other: &Placed| told.of(other.cut.tool).and_then(|tool| tool.kind);
    // A tool that comes to a point again does there what it did.
    let other_tool = |other: &&Placed| here(other) && other.cut.section != own.cut.section;
    let before: Vec<&Placed> = placed.iter().take(at).filter(other_tool).collect();
    let after: Vec<&Placed> = placed.iter().skip(at + 1).filter(here).collect();
    let hole = part.holes.iter().find(|hole| hole.name == own.hole)?;
    let depth = part.datum.top - (own.cut.deepest + shift.z);
    let thread = hole.thread_at(None).map_or(Micrometres::ZERO, |thread| thread.size);
    let most = hole.diameter.nominal.max(thread).half() + chamfer;
    let spot = |other: &Placed| match of(other) {
        Some(kind) => kind == ToolKind::Centring,
        None => part.datum.top - (other.cut.deepest + shift.z) <= most,
    };
    let tool = told.of(own.cut.tool);
    let stage = tool.and_then(|tool| tool.stage);
    let opened = hole.state.diameter().is_some() || before.iter().any(|other| !spot(other));
    if let Some(operation) = tool.and_then(|tool| tool.operation) {
        // The list names it; a drill that widens is named so by its place.
        return Some(Meant { operation, derived: false });
    }
    // What goes straight down and out again behind one drill, in a hole as drills leave it, is the second drill.
    let coarse = hole.thread.is_none() && drilled.contains(&*hole.name);
    let Some(kind) = of(own) else {
        let operation = if own.cut.turned_round {
            Operation::Tap
        } else if own.cut.mills {
            return None;
        } else if !opened
            && before.is_empty()
            && spot(own)
            && after.iter().any(|other| part.datum.top - (other.cut.deepest + shift.z) > depth.ratio(2, 1))
        {
            Operation::CentreDrill
        } else if !opened && !spot(own) {
            Operation::Drill
        } else if coarse
            && !spot(own)
            && !own.cut.out_at_feed
            && before.iter().filter(|other| !spot(other)).count() == 1
        {
            Operation::DrillOut
        } else {
            return None;
        };
        return Some(Meant { operation, derived: true });
    };
    let later = |kind: ToolKind| after.iter().any(|other| of(other) == Some(kind));
    let operation = match kind {
        ToolKind::Centring if opened && hole.countersink.is_some() => Operation::Countersink,
        ToolKind::Centring if opened => Operation::Chamfer,
        ToolKind::Centring => Operation::CentreDrill,
        ToolKind::Drill if opened => Operation::DrillOut,
        ToolKind::Drill => Operation::Drill,
        ToolKind::CoreDrill => Operation::CoreDrill,
        ToolKind::Ream if stage == Some(ToolStage::Rough) || later(kind) => Operation::RoughReam,
        ToolKind::Ream => Operation::FinishReam,
        ToolKind::Bore => match stage {
            Some(ToolStage::Rough) => Operation::RoughBore,
            Some(ToolStage::SemiFinish) => Operation::SemiFinishBore,
            Some(ToolStage::Finish) => Operation::FinishBore,
            // Which stage a bar without a word makes only the last of several tells.
            None if later(kind) => return None,
            None => Operation::FinishBore,
        },
        // What of a hole is milled, its bore, a floor or an opening, the circles alone do not say.
        ToolKind::Mill => return None,
        ToolKind::Tap => Operation::Tap,
        ToolKind::Countersink if hole.countersink.is_none() && hole.chamfer.is_some() => Operation::Chamfer,
        ToolKind::Countersink => Operation::Countersink,
        ToolKind::Chamfer => Operation::Chamfer,
        ToolKind::Counterbore => Operation::Counterbore,
    };
    Some(Meant { operation, derived: false })
}
