//! A lower bound for the length of a path: the length of a shortest 1-tree over all pairs of points, under prices
//! that bring it near to a tour (`prices.rs`).
//!
//! Every set of prices gives a valid bound; the search for good prices only raises it. Most rounds build the tree
//! from edges between near points, which is quick and shows how to change the prices. Only trees over all pairs count
//! as bounds.

use super::prices::Prices;
use super::tour::Space;

/// The most nodes that the search for a bound may join to trees, over all its rounds.
const JOINED: usize = 800_000;

/// The usual number of rounds for a bound over so many nodes.
pub fn rounds(nodes: usize) -> usize {
    (JOINED / (nodes + nodes * nodes / 20_000).max(1)).clamp(25, 3000)
}

/// A lower bound for every path of the space, found in so many rounds. `path` is the cost of a known path; the search
/// ends when the bound reaches it.
///
/// In the unit of [`Space::cost`].
pub fn lower_bound(space: &Space<'_>, path: i64, rounds: usize) -> i64 {
    if space.nodes() < 3 {
        // Two nodes have one edge, used both ways; one node has no path.
        return if space.nodes() == 2 { 2 * space.cost(0, 1) } else { 0 };
    }
    let mut prices = Prices::new(space);
    let best = prices.ascend(path, rounds);
    best.max(prices.tree_over_all())
}
