//! The shortest tour by dynamic programming (Held and Karp, 1962).

use super::Space;

/// The most points beside the first one for which the shortest tour is found exactly.
pub const EXACT_POINTS: usize = 12;

/// The cost of a missing path; several of them can be added without overflow.
const NONE: i64 = i64::MAX / 64;

/// The shortest closed tour over all nodes of a small space, from node 0.
///
/// `best[set][last]` is the cost of the shortest path from node 0 over the nodes of the set to its node `last`; among
/// equals the first in the list is kept.
pub(super) fn tour(space: &Space<'_>) -> Vec<usize> {
    let count = space.nodes().saturating_sub(1);
    if count == 0 {
        return (0..space.nodes()).collect();
    }
    let sets = 1_usize << count;
    // Each row has a fixed number of columns, whatever the count, so the loop over it is quick.
    let mut best = vec![[NONE; EXACT_POINTS]; sets];
    let mut costs = [[NONE; EXACT_POINTS]; EXACT_POINTS];
    for (last, costs) in costs.iter_mut().enumerate().take(count) {
        best[1 << last][last] = space.cost(0, last + 1);
        for (before, cost) in costs.iter_mut().enumerate().take(count) {
            *cost = space.cost(before + 1, last + 1);
        }
    }
    for set in 1..sets {
        for last in nodes_of(set) {
            let before = set & !(1 << last);
            // There is no path to a node outside the set: it is compared with the others and is never the least.
            if before != 0 {
                let ways = best[before].iter().zip(&costs[last]).map(|(so_far, cost)| so_far + cost);
                best[set][last] = ways.fold(NONE, i64::min);
            }
        }
    }
    // Back along the costs: the node before is the first one with the right cost.
    let mut set = sets - 1;
    let mut last = (0..count).min_by_key(|&last| (best[set][last] + space.cost(0, last + 1), last));
    let mut tour = vec![0];
    while let Some(node) = last {
        tour.push(node + 1);
        let cost = best[set][node];
        set &= !(1 << node);
        last = nodes_of(set).find(|&before| best[set][before] + costs[node][before] == cost);
    }
    tour
}

fn nodes_of(set: usize) -> impl Iterator<Item = usize> {
    let mut left = set;
    std::iter::from_fn(move || {
        (left != 0).then(|| {
            let node = left.trailing_zeros() as usize;
            left &= left - 1;
            node
        })
    })
}
