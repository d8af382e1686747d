//! The few edges of every node that are most likely in a short tour; the search tries only these.
//!
//! The measure is how much longer the shortest tree under good prices becomes if it must contain the edge (Helsgaun,
//! 2000). For edges of the tree it is zero; for any other edge it is the difference to the dearest edge on the path
//! through the tree that it would replace. Near is not always likely: between two rows of holes a longer edge may be
//! needed, and within a row the second-nearest never is.

use super::super::prices::Prices;
use super::Space;

/// The number of edges of each node.
const MOST: usize = 6;
/// For the node without position, where a path may begin: all nodes near its best ends are tried.
const OF_NO_PLACE: usize = 12;
/// The most nodes that the search for good prices may join to trees, over all rounds, and the limits of the number of
/// rounds.
const JOINED: usize = 500_000;
const ROUNDS: (usize, usize) = (20, 500);

/// The lists of likely edges, one after the other.
pub(super) struct Candidates {
    starts: Vec<usize>,
    nodes: Vec<(i64, u32)>,
}

impl Candidates {
    /// The candidates of a space with three nodes or more.
    pub(super) fn of(space: &Space<'_>) -> Self {
        let count = space.nodes();
        let mut prices = Prices::new(space);
        prices.ascend(i64::MAX, (JOINED / count).clamp(ROUNDS.0, ROUNDS.1));
        let tree = Tree::of(&prices);
        let beside = space.outside_node();
        let likely = prices.cheapest_beside(if space.free_ends { OF_NO_PLACE } else { MOST });
        let second = likely.get(1).map_or(0, |&(cost, _)| cost);
        let mut all = Self { starts: vec![0], nodes: Vec::with_capacity(count * MOST) };
        let mut own: Vec<(i64, i64, u32)> = Vec::new();
        for node in 0..count {
            own.clear();
            if node == beside {
                own.extend(likely.iter().map(|&(cost, other)| (cost, space.cost(node, other as usize), other)));
                all.nodes.extend(own.iter().map(|&(_, cost, other)| (cost, other)));
            } else {
                let cost = space.cost(node, beside);
                own.push(((prices.priced(cost, node, beside) - second).max(0), cost, beside as u32));
                own.extend(prices.edges[node].iter().map(|&(cost, other)| {
                    let dearest = tree.dearest(node as u32, other);
                    (prices.priced(cost, node, other as usize) - dearest, cost, other)
                }));
                own.sort_unstable();
                all.nodes.extend(own.iter().take(MOST).map(|&(_, cost, other)| (cost, other)));
            }
            all.starts.push(all.nodes.len());
        }
        all
    }

    /// The likely edges of a node, with their other ends and costs; the likeliest first.
    #[inline]
    pub(super) fn of_node(&self, node: u32) -> &[(i64, u32)] {
        let node = node as usize;
        &self.nodes[self.starts[node]..self.starts[node + 1]]
    }
}

/// A shortest tree, kept as the history of its building (Kruskal): the smaller of two trees that an edge joins hangs
/// below the larger one. So every path to the root is short, and its edges get dearer.
struct Tree {
    /// The parent of each node, and the cost of the edge to it.
    above: Vec<(u32, i64)>,
}

impl Tree {
    fn of(prices: &Prices<'_>) -> Self {
        let mut edges: Vec<(i64, u32, u32)> = Vec::new();
        for (node, own) in prices.edges.iter().enumerate() {
            let once = own.iter().filter(|&&(_, other)| other as usize > node);
            edges.extend(once.map(|&(cost, other)| (prices.priced(cost, node, other as usize), node as u32, other)));
        }
        edges.sort_unstable();
        let count = prices.by_node.len() as u32;
        let mut tree = Self { above: (0..count).map(|node| (node, i64::MAX)).collect() };
        let mut sizes = vec![1_u32; count as usize];
        for (cost, from, to) in edges {
            let (one, other) = (tree.top(from), tree.top(to));
            if one != other {
                let (low, high) = if sizes[one as usize] < sizes[other as usize] { (one, other) } else { (other, one) };
                tree.above[low as usize] = (high, cost);
                sizes[high as usize] += sizes[low as usize];
            }
        }
        tree
    }

    fn top(&self, mut node: u32) -> u32 {
        while self.above[node as usize].0 != node {
            node = self.above[node as usize].0;
        }
        node
    }

    /// The cost of the dearest edge on the path between two nodes.
    fn dearest(&self, mut one: u32, mut other: u32) -> i64 {
        let mut dearest = i64::MIN;
        while one != other {
            let lower = if self.above[one as usize].1 <= self.above[other as usize].1 { &mut one } else { &mut other };
            let (above, cost) = self.above[*lower as usize];
            if above == *lower {
                // Only the node outside the tree.
                return cost;
            }
            dearest = cost;
            *lower = above;
        }
        dearest
    }
}
