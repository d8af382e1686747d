//! The exact optimum of the paper's model.
//!
//! Two numbers describe the stock that is left: how many levels and how many slices are removed. From each such state
//! two passes are possible, so the states are a grid without cycles. The shortest path through it is found backwards in
//! one run over all states, each after the two that it leads to. The cost of a pass depends on where the previous one
//! ended, so a state also has the direction of the previous pass.
//!
//! A general search over a graph (petgraph's Dijkstra, with which the tests compare this) needs a queue and marks,
//! which a grid without cycles does not; benches/turning.rs measures both.

use crate::note::{Figure, Note};
use crate::turning::length::Half;

use super::cost::{Cost, Objective};
use super::grid::{Grid, Level, Slice};
use super::pass::{Pass, PassDirection, PassEnd, PassStart};
use crate::turning::point::Point;

/// A pass that a state allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Move {
    /// Where it begins.
    pub start: PassStart,
    /// Where it ends.
    pub end: Point,
    /// Its length in metal.
    pub length: Half,
}

/// The longitudinal and the transverse pass of a state; none if no stock is left.
#[inline]
pub fn moves(grid: &Grid, levels: usize, slices: usize) -> Option<[Move; 2]> {
    if grid.done(levels, slices) {
        return None;
    }
    let (level, slice) = (grid.levels.get(levels)?, grid.slices.get(slices)?);
    Some(both(level, slice, grid.radius(levels), grid.face(slices)))
}

/// Both passes for a radius and a face of the stock.
#[inline]
fn both(level: &Level, slice: &Slice, radius: Half, face: Half) -> [Move; 2] {
    let longitudinal = Move {
        start: PassStart { kind: PassDirection::Longitudinal, at: Point { radius: level.to, z: face } },
        end: Point { radius: level.to, z: level.end },
        length: level.end - face,
    };
    let transverse = Move {
        start: PassStart { kind: PassDirection::Transverse, at: Point { radius, z: slice.to } },
        end: Point { radius: slice.bottom, z: slice.to },
        length: radius - slice.bottom,
    };
    [longitudinal, transverse]
}

/// Where the previous pass ended, if it had that direction.
#[inline]
pub fn ended(grid: &Grid, levels: usize, slices: usize, kind: PassDirection) -> Option<PassEnd> {
    let at = match kind {
        PassDirection::Longitudinal => {
            grid.levels.get(levels.checked_sub(1)?).map(|level| Point { radius: level.to, z: level.end })
        }
        PassDirection::Transverse => {
            grid.slices.get(slices.checked_sub(1)?).map(|slice| Point { radius: slice.bottom, z: slice.to })
        }
    };
    at.map(|at| PassEnd { kind, at })
}

/// The cheapest cost from every state to the end.
#[derive(Debug)]
pub struct CostToGo<'g> {
    grid: &'g Grid,
    objective: Objective,
    /// By levels, slices and the direction of the previous pass.
    costs: Vec<[Cost; 2]>,
    width: usize,
}

const KINDS: [PassDirection; 2] = [PassDirection::Longitudinal, PassDirection::Transverse];

impl<'g> CostToGo<'g> {
    /// Works backwards over all states.
    pub fn of(grid: &'g Grid, objective: Objective) -> Self {
        let width = grid.slices.len() + 1;
        let mut all = Self { grid, objective, costs: vec![[Cost::ZERO; 2]; (grid.levels.len() + 1) * width], width };
        for levels in (0..=grid.levels.len()).rev() {
            let radius = grid.radius(levels);
            // From this number of slices on there is nothing left to cut.
            let live = grid.levels.get(levels).map_or(0, |level| {
                (1 + grid.slices.partition_point(|slice| slice.to < level.end)).min(grid.slices.len())
            });
            if matches!(objective, Objective::Time { .. }) {
                for slices in live..width {
                    let home = |kind| objective.home(ended(grid, levels, slices, kind), grid.bar);
                    all.costs[levels * width + slices] = KINDS.map(home);
                }
            }
            let Some(level) = grid.levels.get(levels) else { continue };
            for (slices, slice) in grid.slices.iter().enumerate().take(live).rev() {
                let at = levels * width + slices;
                let [longitudinal, transverse] = both(level, slice, radius, slice.from);
                let (after_longitudinal, after_transverse) = (all.costs[at + width][0], all.costs[at + 1][1]);
                for (index, kind) in KINDS.into_iter().enumerate() {
                    let before = ended(grid, levels, slices, kind);
                    let cost = |pass: Move| objective.pass(pass.start, pass.length, before, grid.bar);
                    let one = cost(longitudinal).plus(after_longitudinal);
                    let other = cost(transverse).plus(after_transverse);
                    all.costs[at][index] = if other < one { other } else { one };
                }
            }
        }
        all
    }

    /// Both passes of a state, each with the cost from there to the end; none if no stock is left.
    #[inline]
    fn begun(&self, levels: usize, slices: usize) -> Option<[(Move, Cost); 2]> {
        let [longitudinal, transverse] = moves(self.grid, levels, slices)?;
        let after_longitudinal = self.costs[(levels + 1) * self.width + slices][0];
        let after_transverse = self.costs[levels * self.width + slices + 1][1];
        Some([(longitudinal, after_longitudinal), (transverse, after_transverse)])
    }

    /// The cheapest cost of the two passes.
    #[inline]
    fn each(&self, begun: &[(Move, Cost); 2], before: Option<PassEnd>) -> [Cost; 2] {
        begun.map(|(pass, after)| self.objective.pass(pass.start, pass.length, before, self.grid.bar).plus(after))
    }

    /// The cost of the optimum.
    pub fn optimum(&self) -> Cost {
        match self.begun(0, 0) {
            Some(begun) => self.each(&begun, None).into_iter().min().unwrap_or_default(),
            None => Cost::ZERO,
        }
    }

    /// The passes of the optimum. If both directions cost exactly the same, longitudinal.
    pub fn passes(&self) -> Vec<Pass> {
        let (mut levels, mut slices, mut before, mut passes) = (0, 0, None, Vec::new());
        while let Some(begun) = self.begun(levels, slices) {
            let each = self.each(&begun, before);
            let taken = usize::from(each[1] < each[0]);
            let reason = reason(self.objective, each, taken);
            let pass = pass(self.grid, levels, slices, begun[taken].0, reason);
            before = Some(pass.end());
            passes.push(pass);
            if taken == 0 { levels += 1 } else { slices += 1 }
        }
        passes
    }
}

/// Why a pass was taken: the remaining cost after either pass.
fn reason(objective: Objective, each: [Cost; 2], taken: usize) -> Note {
    let (own, other) = (each[taken], each[1 - taken]);
    let shown = |cost: Cost| Figure::number(objective.shown(cost.main).to_string());
    let code = match (objective, own.main == other.main) {
        (_, true) => "pass-as-good",
        (Objective::Path | Objective::PathAndPasses { .. }, _) => "pass-shorter",
        (Objective::Time { .. }, _) => "pass-quicker",
        (Objective::Passes, _) => "pass-fewer",
    };
    Note::new(code).with("unit", objective.unit()).with("left", shown(own)).with("otherwise", shown(other))
}

/// A move of the grid as a pass.
pub fn pass(grid: &Grid, levels: usize, slices: usize, made: Move, reason: Note) -> Pass {
    let (radius, face) = (grid.radius(levels), grid.face(slices));
    // A longitudinal pass removes from its new radius outwards, a transverse one from the step outwards; both from the
    // face on.
    let near = Point { radius: made.end.radius, z: face };
    let depth = match made.start.kind {
        PassDirection::Longitudinal => radius - made.end.radius,
        PassDirection::Transverse => made.end.z - face,
    };
    let far = Point { radius, z: made.end.z };
    Pass { kind: made.start.kind, from: made.start.at, to: made.end, depth, removed: vec![(near, far)], reason }
}
