//! The variants for comparison with the optimum: longitudinal only, transverse only, and one direction per step.

use crate::note::{Figure, Note};
use crate::turning::length::Half;

use super::cost::{Cost, Objective};
use super::grid::{Cylinder, Grid};
use super::optimum::{moves, pass};
use super::pass::{Pass, PassDirection, PassEnd};
use crate::turning::point::Point;

/// The cost of passes in that order, with the return to the home point.
pub fn total(passes: &[Pass], objective: Objective, bar: Half) -> Cost {
    after(None, passes, objective, bar).plus(objective.home(passes.last().map(Pass::end), bar))
}

/// The cost of passes in that order, behind one that has ended there.
fn after(mut before: Option<PassEnd>, passes: &[Pass], objective: Objective, bar: Half) -> Cost {
    let mut sum = Cost::ZERO;
    for pass in passes {
        sum = sum.plus(objective.pass(pass.start(), pass.length(), before, bar));
        before = Some(pass.end());
    }
    sum
}

/// Every pass in one direction.
pub fn one_direction(grid: &Grid, kind: PassDirection) -> Vec<Pass> {
    let (mut levels, mut slices, mut passes) = (0, 0, Vec::new());
    while let Some([longitudinal, transverse]) = moves(grid, levels, slices) {
        let made = if kind == PassDirection::Longitudinal { longitudinal } else { transverse };
        passes.push(pass(
            grid,
            levels,
            slices,
            made,
            Note::new("pass-of-variant").with("direction", Figure::word(kind.name())),
        ));
        if kind == PassDirection::Longitudinal { levels += 1 } else { slices += 1 }
    }
    passes
}

/// The best of all combinations of one direction per step. The steps are cleared from the free end, each over its own
/// length down to its diameter before the next.
///
/// The combinations need not be tried one by one: the cost of a step depends on the previous one only through where its
/// last pass ended. So the best sequence that ends a step in either direction is kept, step by step.
pub fn per_step(grid: &Grid, objective: Objective) -> Vec<Pass> {
    let mut best: Vec<(Cost, Vec<Pass>)> = vec![(Cost::ZERO, Vec::new())];
    for (index, cylinder) in grid.cylinders.iter().enumerate() {
        let mut next: Vec<(Cost, Vec<Pass>)> = Vec::new();
        for kind in [PassDirection::Longitudinal, PassDirection::Transverse] {
            let own = of_step(grid, index, cylinder, kind);
            let cost = |before: &[Pass]| after(before.last().map(Pass::end), &own, objective, grid.bar);
            let ends = best.iter().map(|(spent, passes)| (spent.plus(cost(passes)), passes));
            if let Some((spent, passes)) = ends.min_by_key(|(spent, _)| *spent) {
                next.push((spent, passes.iter().cloned().chain(own).collect()));
            }
        }
        best = next;
    }
    let home = |(spent, passes): &(Cost, Vec<Pass>)| spent.plus(objective.home(passes.last().map(Pass::end), grid.bar));
    best.into_iter().min_by_key(home).map(|(_, passes)| passes).unwrap_or_default()
}

/// The passes that clear one step over its own length.
fn of_step(grid: &Grid, index: usize, cylinder: &Cylinder, kind: PassDirection) -> Vec<Pass> {
    let reason = Note::new("pass-of-step").with("step", index + 1).with("direction", Figure::word(kind.name()));
    let rectangle = |near, far| vec![(near, far)];
    match kind {
        PassDirection::Longitudinal => {
            let over = grid.levels.iter().filter(|level| level.to >= cylinder.radius);
            over.map(|level| {
                let from = Point { radius: level.to, z: cylinder.from };
                let far = Point { radius: level.from, z: cylinder.to };
                let to = Point { radius: level.to, z: cylinder.to };
                Pass { kind, from, to, depth: level.depth, removed: rectangle(from, far), reason: reason.clone() }
            })
            .collect()
        }
        PassDirection::Transverse => {
            let own = grid.slices.iter().filter(|slice| slice.step == index);
            own.map(|slice| {
                let from = Point { radius: grid.bar, z: slice.to };
                let to = Point { radius: slice.bottom, z: slice.to };
                let near = Point { radius: slice.bottom, z: slice.from };
                Pass { kind, from, to, depth: slice.depth, removed: rectangle(near, from), reason: reason.clone() }
            })
            .collect()
        }
    }
}
