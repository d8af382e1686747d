//! A* over the staircases, with a counted effort: no clock is asked, so the same shaft gives the same answer.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::super::cost::Objective;
use super::staircase::{Cut, Lines, Stairs};

/// How the search weighs what is spent against what is at least left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Greed {
    /// As it is: the first end is the best, and what waits is a bound.
    Exact,
    /// What is left counts a quarter more: a good end is met sooner, and nothing is proven.
    Quick,
}

/// A sequence of cuts.
#[derive(Clone, Debug)]
pub struct Found {
    /// What it costs.
    pub cost: u64,
    /// The cuts in order.
    pub cuts: Vec<Cut>,
}

/// What a search came to.
#[derive(Clone, Debug)]
pub struct Ended {
    /// A sequence cheaper than what was known, if one was met.
    pub found: Option<Found>,
    /// No sequence costs less than the smaller of this and what was known; of an exact search alone.
    pub bound: u64,
    /// Staircases that were looked at.
    pub states: usize,
}

/// What is known of a staircase: what it cost with the number of passes, and the one before it with the cut between.
struct Met {
    spent: (u64, u32),
    before: Option<(usize, Cut)>,
    stairs: Stairs,
    done: bool,
}

/// Looks for a sequence cheaper than `known`. `effort` counts the cuts that are weighed, those of
/// long staircases several times.
pub fn search(lines: &Lines, objective: Objective, greed: Greed, known: u64, effort: usize) -> Ended {
    let weighed = |least: u64| if greed == Greed::Quick { least + least / 4 } else { least };
    let mut met: Vec<Met> = vec![Met { spent: (0, 0), before: None, stairs: lines.bar(), done: false }];
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
            let found = Found { cost: spent.0, cuts: way(&met, number) };
            return Ended { bound: found.cost, found: Some(found), states };
        }
        if spent_effort >= effort {
            // All that waits costs at least this much; what was left out costs no less than what is known.
            return Ended { found: None, bound: estimate, states };
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
                    // The quick search may come to a staircase anew more cheaply; it does not look at it again.
                    if other.done || other.spent <= cost {
                        continue;
                    }
                    (other.spent, other.before) = (cost, before);
                    number
                }
                None => {
                    numbers.insert(next.clone(), met.len());
                    met.push(Met { spent: cost, before, stairs: next, done: false });
                    met.len() - 1
                }
            };
            // Among equals the one with fewer passes, then the one nearer to its end.
            waiting.push(Reverse((cost.0 + weighed(least), cost.1, least, number)));
        }
    }
    // Nothing waits: whatever was left out costs no less than what is known.
    Ended { found: None, bound: known, states }
}

fn way(met: &[Met], mut number: usize) -> Vec<Cut> {
    let mut cuts = Vec::new();
    while let Some((before, cut)) = met.get(number).and_then(|here| here.before) {
        cuts.push(cut);
        number = before;
    }
    cuts.reverse();
    cuts
}
