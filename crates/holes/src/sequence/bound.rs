//! A length that no path can be shorter than: that of a shortest 1-tree over all pairs of points, under prices that
//! bring it near to a tour (`prices.rs`).
//!
//! Every price gives a true bound; the search for good prices only makes it high. Most rounds look for the tree among the
//! edges of near points alone, which is quick and says where prices should go; only trees over all pairs count as bounds.

use super::prices::Prices;
use super::tour::Space;

/// The nodes that the search for a bound may join to trees, in all its rounds.
const JOINED: usize = 800_000;

/// The rounds that a bound over so many nodes gets unless another number is given.
pub fn rounds(nodes: usize) -> usize {
    (JOINED / (nodes + nodes * nodes / 20_000).max(1)).clamp(25, 3000)
}

/// A lower bound of every path of the space, found in so many rounds; `path` is the cost of a known one, at which
/// the search ends.
///
/// In the unit of [`Space::cost`].
pub fn lower_bound(space: &Space<'_>, path: i64, rounds: usize) -> i64 {
    if space.nodes() < 3 {
        // Two nodes have one edge, there and back; without any there is no way.
        return if space.nodes() == 2 { 2 * space.cost(0, 1) } else { 0 };
    }
    let mut prices = Prices::new(space);
    let best = prices.ascend(path, rounds);
    best.max(prices.tree_over_all())
}
