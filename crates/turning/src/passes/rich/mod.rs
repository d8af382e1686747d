//! Richer moves: passes that stop anywhere on a grid and take less than the full depth.
//!
//! The remaining stock is a staircase that rises towards the chuck ([`staircase`]). A pass cuts a corner of it: to
//! one line of radii, up to one line of Z. The best sequence is found by A* over the staircases ([`search`]). The
//! search is exact if it ends; if it is stopped early, it still gives a lower bound.

pub mod search;
pub mod staircase;

use serde::Serialize;

use crate::note::{Figure, Note};

use super::cost::Objective;
use super::grid::Grid;
use super::pass::Pass;

/// The proof of the search over rich moves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SearchProof {
    /// Whether no sequence on this grid is better.
    pub optimal_on_the_grid: bool,
    /// No sequence on this grid costs less: mm or passes, as the objective counts.
    pub lower_bound: f64,
    /// The number of staircases examined.
    pub states: usize,
    /// The number of lines of radii and of Z on which passes may run and stop.
    pub lines: (usize, usize),
}

/// The best sequence with rich moves, if it costs less than `known`, and the proof.
pub fn find(grid: &Grid, objective: Objective, known: u64, effort: usize) -> (Option<Vec<Pass>>, SearchProof) {
    let lines = staircase::Lines::of(grid);
    // The search counts the length in place of the time.
    let counted = if matches!(objective, Objective::Time { .. }) { Objective::Path } else { objective };
    // First a quick search for a good sequence, so that the second search can leave out everything that cannot be
    // better.
    let quick = search::search(&lines, objective, search::Greed::Quick, known, effort / 4);
    let best_cost = quick.found.as_ref().map_or(known, |sequence| sequence.cost);
    let exact = search::search(&lines, objective, search::Greed::Exact, best_cost, effort);
    let bound = exact.bound.min(exact.found.as_ref().map_or(best_cost, |sequence| sequence.cost));
    let best = exact.found.or(quick.found);
    let cost = best.as_ref().map_or(known, |sequence| sequence.cost);
    let proof = SearchProof {
        optimal_on_the_grid: bound >= cost,
        lower_bound: counted.shown(bound),
        states: quick.states + exact.states,
        lines: (lines.radii.len(), lines.zs.len()),
    };
    let passes = best.map(|sequence| {
        let mut left = sequence.cost;
        let mut stairs = lines.bar();
        let mut passes = Vec::new();
        for cut in sequence.cuts {
            let reason = Note::new("pass-of-search").with("unit", counted.unit());
            let reason = reason.with("left", Figure::number(counted.shown(left).to_string()));
            passes.push(lines.pass(&stairs, cut, reason));
            left = left.saturating_sub(cut.cost(objective));
            lines.cut(&mut stairs, cut);
        }
        passes
    });
    (passes, proof)
}
