//! A* over the staircases. It is limited by a number of steps, not by a clock, so that the same shaft gives the same
//! answer.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::super::cost::Objective;
use super::staircase::{Lines, StairPass, Stairs};

/// The weight of the least remaining cost in the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Greed {
    /// Unweighted: the first goal reached is optimal, and the open states give a lower bound.
    Exact,
    /// The remaining cost counts a quarter more: a good solution comes sooner, but nothing is proven.
    Quick,
}

/// A sequence of cuts.
#[derive(Clone, Debug)]
pub struct CutSequence {
    /// Its cost.
    pub cost: u64,
    /// The cuts in order.
    pub cuts: Vec<StairPass>,
}

/// The result of a search.
#[derive(Clone, Debug)]
pub struct SearchOutcome {
    /// A sequence cheaper than the known one, if there is one.
    pub found: Option<CutSequence>,
    /// No sequence costs less than the smaller of this and the known cost; only of an exact search.
    pub bound: u64,
    /// The number of staircases examined.
    pub states: usize,
}

/// A node of the search: the cost so far with the number of passes, and the predecessor with the cut between.
struct SearchNode {
    spent: (u64, u32),
    before: Option<(usize, StairPass)>,
    stairs: Stairs,
    done: bool,
}

/// Searches for a sequence cheaper than `known`. `effort` is the number of cuts to compare; those of long staircases
/// count several times.
pub fn search(lines: &Lines, objective: Objective, greed: Greed, known: u64, effort: usize) -> SearchOutcome {
    let weighed = |least: u64| if greed == Greed::Quick { least + least / 4 } else { least };
    let mut met: Vec<SearchNode> = vec![SearchNode { spent: (0, 0), before: None, stairs: lines.bar(), done: false }];
    let mut numbers: BTreeMap<Stairs, usize> = BTreeMap::from([(lines.bar(), 0)]);
    let whole = lines.at_least(&lines.bar(), objective);
    let mut waiting = BinaryHeap::from([Reverse((weighed(whole), 0_u32, 0_u64, 0_usize))]);
    let (mut cuts, mut spent_effort, mut states) = (Vec::new(), 0, 0);
    while let Some(Reverse((estimate, _, _, number))) = waiting.pop() {
        let Some(here) = met.get_mut(number).filter(|here| !here.done) else { continue };
        here.done = true;
        states += 1;
        let (spent, stairs) = (here.spent, here.stairs.clone());
        if stairs == lines.floor {
            let better = CutSequence { cost: spent.0, cuts: cuts_to(&met, number) };
            return SearchOutcome { bound: better.cost, found: Some(better), states };
        }
        if spent_effort >= effort {
            // Every open state costs at least this much; every state left out costs at least as much as the known
            // solution.
            return SearchOutcome { found: None, bound: estimate, states };
        }
        lines.cuts(&stairs, &mut cuts);
        // A long staircase takes more time and room.
        spent_effort += cuts.len() * (1 + stairs.len() / 32);
        for &cut in &cuts {
            let mut next = stairs.clone();
            lines.cut(&mut next, cut);
            let cost = (spent.0 + cut.cost(objective), spent.1 + 1);
            let least = lines.at_least(&next, objective);
            if cost.0 + least >= known {
                continue;
            }
            let before = Some((number, cut));
            let number = match numbers.get(&next) {
                Some(&number) => {
                    let other = &mut met[number];
                    // The quick search may reach a staircase again at a lower cost, but does not expand it again.
                    if other.done || other.spent <= cost {
                        continue;
                    }
                    (other.spent, other.before) = (cost, before);
                    number
                }
                None => {
                    numbers.insert(next.clone(), met.len());
                    met.push(SearchNode { spent: cost, before, stairs: next, done: false });
                    met.len() - 1
                }
            };
            // Among equals the one with fewer passes first, then the one nearer to its end.
            waiting.push(Reverse((cost.0 + weighed(least), cost.1, least, number)));
        }
    }
    // No open states: every state left out costs at least as much as the known solution.
    SearchOutcome { found: None, bound: known, states }
}

fn cuts_to(met: &[SearchNode], mut number: usize) -> Vec<StairPass> {
    let mut cuts = Vec::new();
    while let Some((before, cut)) = met.get(number).and_then(|here| here.before) {
        cuts.push(cut);
        number = before;
    }
    cuts.reverse();
    cuts
}
