//! A length that no path can be shorter than.
//!
//! A tour is a tree over all nodes but one, with two edges more at that one, and two edges at every node. Drop
//! the last condition, and the shortest such 1-tree is found at once; give every node a price that each of its
//! edges pays, and take the prices back twice, and no tour changes its length, but the tree gets longer where a
//! node had too few or too many edges (Held and Karp, 1970, 1971). Every price gives a true bound; the search for
//! good prices only makes it high. All figures are whole numbers, so that the bound holds to the last digit.

use super::tour::Space;

/// The most nodes for which a bound is looked for: each round compares all pairs of nodes.
pub const BOUND_NODES: usize = 6000;

/// The pairs of nodes that the search for a bound may compare, in all its rounds.
const COMPARED: usize = 1_000_000_000;

/// The rounds that a bound over so many nodes gets where nobody asks for another number.
pub fn rounds(nodes: usize) -> usize {
    (COMPARED / (nodes * nodes).max(1)).clamp(50, 3000)
}

/// A lower bound of every path of the space, found in so many rounds; `path` is the cost of a known one, which
/// says how far there is to go. Zero for more than [`BOUND_NODES`] nodes.
///
/// In the unit of [`Space::cost`].
pub fn lower_bound(space: &Space<'_>, path: i64, rounds: usize) -> i64 {
    let count = space.nodes();
    if !(3..=BOUND_NODES).contains(&count) {
        // Two nodes have one edge, there and back; without any there is no way.
        return if count == 2 { 2 * space.cost(0, 1) } else { 0 };
    }
    let mut prices = Prices::new(count);
    let mut best = 0;
    // Steps shrink with the square of the rounds left (after Volgenant and Jonker, 1982), from half the length of
    // an edge: holes in circles are far apart between the circles, and a price must get there.
    let mut first = None;
    for round in 0..rounds {
        let tree = prices.one_tree(space);
        best = best.max(tree);
        if prices.faults() == 0 || best >= path {
            break;
        }
        let first = *first.get_or_insert(tree as f64 / (2.0 * count as f64));
        let left = (rounds - round) as f64 / rounds as f64;
        prices.change(first * left * left);
    }
    best
}

struct Prices {
    /// What each edge of a node pays.
    of: Vec<i64>,
    /// Edges of each node in the last tree, and in the one before.
    edges: Vec<i64>,
    before: Vec<i64>,
    // Room for the tree: nodes outside it, their cheapest edge into it.
    outside: Vec<u32>,
    cheapest: Vec<i64>,
    towards: Vec<u32>,
}

impl Prices {
    fn new(count: usize) -> Self {
        let zeros = || vec![0_i64; count];
        Self {
            of: zeros(),
            edges: zeros(),
            before: vec![2; count],
            outside: Vec::new(),
            cheapest: Vec::new(),
            towards: Vec::new(),
        }
    }

    /// The cost of the shortest 1-tree less twice the prices: a lower bound. Node 0 stands beside the tree.
    fn one_tree(&mut self, space: &Space<'_>) -> i64 {
        let count = space.nodes();
        std::mem::swap(&mut self.edges, &mut self.before);
        self.edges.fill(0);
        // The tree (Prim), from node 1.
        self.outside.clear();
        self.outside.extend(2..count as u32);
        self.cheapest.clear();
        self.cheapest.resize(count - 2, i64::MAX);
        self.towards.clear();
        self.towards.resize(count - 2, 1);
        let mut total = 0;
        let mut newest = 1_usize;
        while !self.outside.is_empty() {
            let own = self.of[newest];
            let (mut least, mut chosen) = (i64::MAX, 0);
            for (at, ((&node, cheapest), towards)) in
                self.outside.iter().zip(&mut self.cheapest).zip(&mut self.towards).enumerate()
            {
                let cost = space.cost(newest, node as usize) + own + self.of[node as usize];
                if cost < *cheapest {
                    *cheapest = cost;
                    *towards = newest as u32;
                }
                if *cheapest < least {
                    (least, chosen) = (*cheapest, at);
                }
            }
            total += least;
            newest = self.outside.swap_remove(chosen) as usize;
            self.cheapest.swap_remove(chosen);
            let towards = self.towards.swap_remove(chosen) as usize;
            self.edges[newest] += 1;
            self.edges[towards] += 1;
        }
        // The two cheapest edges of node 0.
        let (mut first, mut second) = ((i64::MAX, 0), (i64::MAX, 0));
        for node in 1..count {
            let edge = (space.cost(0, node) + self.of[0] + self.of[node], node);
            if edge < first {
                (first, second) = (edge, first);
            } else if edge < second {
                second = edge;
            }
        }
        self.edges[0] = 2;
        self.edges[first.1] += 1;
        self.edges[second.1] += 1;
        total + first.0 + second.0 - 2 * self.of.iter().sum::<i64>()
    }

    /// The sum of the squares by which the nodes miss two edges.
    fn faults(&self) -> i64 {
        self.edges.iter().map(|edges| (edges - 2) * (edges - 2)).sum()
    }

    /// Raises the price of nodes with many edges and lowers that of leaves, with some of the last direction, so
    /// that nodes that are now one and now the other settle.
    fn change(&mut self, step: f64) {
        for ((price, edges), before) in self.of.iter_mut().zip(&self.edges).zip(&self.before) {
            *price += (step * (0.7 * (edges - 2) as f64 + 0.3 * (before - 2) as f64)).round() as i64;
        }
    }
}
