//! The shortest tour by dynamic programming (Held and Karp, 1962).

use super::Space;

/// The most points beside the first one for which the shortest tour is found exactly.
pub const EXACT_POINTS: usize = 12;

/// The shortest closed tour over all nodes of a small space, from node 0.
///
/// `best[set][last]` is the cost of the shortest way from node 0 over the nodes of the set to its node `last`;
/// among equals the first in the list is kept.
pub(super) fn tour(space: &Space<'_>) -> Vec<usize> {
    let count = space.nodes().saturating_sub(1);
    if count == 0 {
        return (0..space.nodes()).collect();
    }
    let sets = 1_usize << count;
    let mut best = vec![i64::MAX; sets * count];
    let costs: Vec<i64> = (0..count * count).map(|pair| space.cost(pair / count + 1, pair % count + 1)).collect();
    for last in 0..count {
        best[(1 << last) * count + last] = space.cost(0, last + 1);
    }
    for set in 1..sets {
        for last in nodes_of(set) {
            let so_far = best[set * count + last];
            let mut free = !set & (sets - 1);
            while free != 0 {
                let next = free.trailing_zeros() as usize;
                free &= free - 1;
                let longer = so_far.saturating_add(costs[last * count + next]);
                let known = &mut best[(set | 1 << next) * count + next];
                *known = longer.min(*known);
            }
        }
    }
    // Back along the costs: the node before is the first from which the cost is right.
    let mut set = sets - 1;
    let mut last =
        (0..count).min_by_key(|&last| (best[set * count + last].saturating_add(space.cost(0, last + 1)), last));
    let mut tour = vec![0];
    while let Some(node) = last {
        tour.push(node + 1);
        let cost = best[set * count + node];
        set &= !(1 << node);
        last = nodes_of(set)
            .find(|&before| best[set * count + before].saturating_add(costs[before * count + node]) == cost);
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
