//! The exact optimum of the paper's model.
//!
//! The remaining stock is described by two numbers: how many levels and how many slices are gone. From each such state
//! two passes lead on, so the states are a grid without cycles, and the shortest way through it is found by working
//! backwards once over all states: each is looked at once, after both that it leads to. As the way to a pass depends
//! on where the one before ended, a state also says which direction that one had.
//!
//! A general search over a graph (petgraph's Dijkstra, which the tests hold this against) keeps a queue and marks that a
//! grid without cycles does not need; benches/turning.rs has both.

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

/// The longitudinal and the transverse pass of a state; none where no stock is left.
#[inline]
pub fn moves(grid: &Grid, levels: usize, slices: usize) -> Option<[Move; 2]> {
    if grid.done(levels, slices) {
        return None;
    }
    let (level, slice) = (grid.levels.get(levels)?, grid.slices.get(slices)?);
    Some(both(level, slice, grid.radius(levels), grid.face(slices)))
}

/// Both passes where the stock has that radius and that face.
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

/// Where the pass before this state ended, if it had that direction.
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
    /// By levels, slices and the direction of the pass before.
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
            // From this number of slices on nothing is left to cut.
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

    /// Both passes of a state, each with the cost from where it leads to; none where no stock is left.
    #[inline]
    fn begun(&self, levels: usize, slices: usize) -> Option<[(Move, Cost); 2]> {
        let [longitudinal, transverse] = moves(self.grid, levels, slices)?;
        let after_longitudinal = self.costs[(levels + 1) * self.width + slices][0];
        let after_transverse = self.costs[levels * self.width + slices + 1][1];
        Some([(longitudinal, after_longitudinal), (transverse, after_transverse)])
    }

    /// The cheapest cost that begins with either of both passes.
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

    /// The passes of the optimum; where both directions cost the same to the last, longitudinal.
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

/// Why a pass was taken: what is left to pay after either.
fn reason(objective: Objective, each: [Cost; 2], taken: usize) -> Note {
    let (own, other) = (each[taken], each[1 - taken]);
    let shown = |cost: Cost| match objective {
        Objective::Path | Objective::PathAndPasses { .. } => {
            Half::new(i64::try_from(cost.main).unwrap_or(i64::MAX)).to_string()
        }
        Objective::Passes => cost.main.to_string(),
        Objective::Time { .. } => crate::units::round_to(super::cost::minutes(cost.main).0, 4).to_string(),
    };
    let code = match (objective, own.main == other.main) {
        (_, true) => "pass-as-good",
        (Objective::Path | Objective::PathAndPasses { .. }, _) => "pass-shorter",
        (Objective::Time { .. }, _) => "pass-quicker",
        (Objective::Passes, _) => "pass-fewer",
    };
    Note::new(code).with("left", Figure::number(shown(own))).with("otherwise", Figure::number(shown(other)))
}

/// A move of the grid as a pass.
pub fn pass(grid: &Grid, levels: usize, slices: usize, made: Move, reason: Note) -> Pass {
    let (radius, face) = (grid.radius(levels), grid.face(slices));
    // A longitudinal pass takes from its new radius out, a transverse one from the step out; both from the face on.
    let near = Point { radius: made.end.radius, z: face };
    let depth = match made.start.kind {
        PassDirection::Longitudinal => radius - made.end.radius,
        PassDirection::Transverse => made.end.z - face,
    };
    let far = Point { radius, z: made.end.z };
    Pass { kind: made.start.kind, from: made.start.at, to: made.end, depth, removed: vec![(near, far)], reason }
}
