//! A length that no path can be shorter than.
//!
//! A tour is a tree over all nodes but one, with two edges more at that one, and two edges at every node. Drop
//! the last condition, and the shortest such 1-tree is found at once; give every node a price that each of its
//! edges pays, and take the prices back twice, and no tour changes its length, but the tree gets longer where a
//! node had too few or too many edges (Held and Karp, 1970, 1971). Every price gives a true bound; the search for
//! good prices only makes it high. All figures are whole numbers, so that the bound holds to the last digit.
//!
//! Most rounds look for the tree among the edges of near nodes alone, which is quick and says where prices should
//! go; only trees over all pairs count as bounds, and their edges join the near ones.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::tour::{Space, near_edges};

/// The most nodes for which a bound is looked for: some rounds compare all pairs of nodes.
pub const BOUND_NODES: usize = 6000;

/// The nodes that the search for a bound may join to trees, in all its rounds.
const JOINED: usize = 2_600_000;
/// Among so many rounds, one compares all pairs.
const ALL_PAIRS: usize = 100;
/// The first step of the prices, in edges of mean length: holes in circles are far apart between the circles, and
/// a price must get there.
const FIRST_STEP: f64 = 2.5;
/// The last steps are so much smaller, besides their going to nothing.
const SHRINK: f64 = 1.0 / 150.0;
/// The part of the last direction that is kept: nodes that are now one and now the other settle, and those of a
/// circle go together.
const KEPT: f64 = 0.9;

/// The rounds that a bound over so many nodes gets where nobody asks for another number.
pub fn rounds(nodes: usize) -> usize {
    (JOINED / nodes.max(1)).clamp(200, 3000)
}

/// A lower bound of every path of the space, found in so many rounds; `path` is the cost of a known one, at which
/// the search ends. Zero for more than [`BOUND_NODES`] nodes.
///
/// In the unit of [`Space::cost`].
pub fn lower_bound(space: &Space<'_>, path: i64, rounds: usize) -> i64 {
    let count = space.nodes();
    if !(3..=BOUND_NODES).contains(&count) {
        // Two nodes have one edge, there and back; without any there is no way.
        return if count == 2 { 2 * space.cost(0, 1) } else { 0 };
    }
    let mut near = vec![Vec::new(); count];
    near_edges(space, |from, to| join(space, &mut near, from, to));
    let mut prices = Prices::new(count);
    let mut best = prices.tree_over_all(space, &mut near);
    let mut promising = (i64::MIN, prices.of.clone());
    let mut step = FIRST_STEP * best as f64 / count as f64;
    let shrink = libm::pow(SHRINK, 1.0 / rounds.max(1) as f64);
    for round in 1..=rounds {
        let tree = prices.tree_among(space, &near);
        if tree > promising.0 {
            promising = (tree, prices.of.clone());
        }
        if round % ALL_PAIRS == 0 {
            best = best.max(prices.tree_over_all(space, &mut near));
        }
        if prices.is_tour() || best >= path {
            break;
        }
        prices.change(step * (rounds - round) as f64 / rounds as f64);
        step *= shrink;
    }
    prices.of = promising.1;
    best.max(prices.tree_over_all(space, &mut near))
}

/// The edges of near nodes: of each node the others with the cost of going there.
type Near = [Vec<(i64, u32)>];

fn join(space: &Space<'_>, near: &mut Near, from: usize, to: usize) {
    if near[from].iter().all(|&(_, known)| known as usize != to) {
        let cost = space.cost(from, to);
        near[from].push((cost, to as u32));
        near[to].push((cost, from as u32));
    }
}

struct Prices {
    /// What each edge of a node pays.
    of: Vec<i64>,
    /// Edges of each node in the last tree.
    edges: Vec<i64>,
    /// Where the prices are going.
    direction: Vec<f64>,
    /// The cheapest edge of each node into the tree, and from where; nothing is cheaper for a node of the tree.
    cheapest: Vec<i64>,
    towards: Vec<u32>,
    waiting: BinaryHeap<Reverse<(i64, u32)>>,
}

/// The cheapest edge of a node of the tree.
const INSIDE: i64 = i64::MIN;

impl Prices {
    fn new(count: usize) -> Self {
        Self {
            of: vec![0; count],
            edges: vec![0; count],
            direction: vec![0.0; count],
            cheapest: vec![0; count],
            towards: vec![1; count],
            waiting: BinaryHeap::new(),
        }
    }

    /// Nothing but node 1 in the tree. Node 0 stands beside it.
    fn begin(&mut self) {
        self.edges.fill(0);
        self.cheapest.fill(i64::MAX);
        self.towards.fill(1);
        self.cheapest[0] = INSIDE;
        self.cheapest[1] = INSIDE;
    }

    /// Takes a node into the tree; gives the cost of its edge.
    fn take(&mut self, node: usize) -> i64 {
        self.edges[node] += 1;
        self.edges[self.towards[node] as usize] += 1;
        std::mem::replace(&mut self.cheapest[node], INSIDE)
    }

    /// The cost of the shortest 1-tree (Prim) over all pairs less twice the prices: a lower bound.
    fn tree_over_all(&mut self, space: &Space<'_>, near: &mut Near) -> i64 {
        let count = space.nodes();
        self.begin();
        let (mut total, mut newest) = (0, 1_usize);
        let mut outside: Vec<usize> = (2..count).collect();
        while !outside.is_empty() {
            let (mut least, mut chosen) = (i64::MAX, 0);
            for (at, &node) in outside.iter().enumerate() {
                let cost = space.cost(newest, node) + self.of[newest] + self.of[node];
                if cost < self.cheapest[node] {
                    self.cheapest[node] = cost;
                    self.towards[node] = newest as u32;
                }
                if self.cheapest[node] < least {
                    (least, chosen) = (self.cheapest[node], at);
                }
            }
            newest = outside.swap_remove(chosen);
            total += self.take(newest);
            join(space, near, newest, self.towards[newest] as usize);
        }
        let all = (1..count).map(|node| (space.cost(0, node), node as u32));
        let (beside, ends) = self.two_cheapest(all);
        for end in ends {
            join(space, near, 0, end);
        }
        total + beside - 2 * self.of.iter().sum::<i64>()
    }

    /// The same among the edges of near nodes: never less, and so no bound.
    fn tree_among(&mut self, space: &Space<'_>, near: &Near) -> i64 {
        self.begin();
        self.waiting.clear();
        let (mut total, mut newest) = (0, 1_usize);
        for _ in 2..space.nodes() {
            for &(cost, node) in &near[newest] {
                let cost = cost + self.of[newest] + self.of[node as usize];
                if cost < self.cheapest[node as usize] {
                    self.cheapest[node as usize] = cost;
                    self.towards[node as usize] = newest as u32;
                    self.waiting.push(Reverse((cost, node)));
                }
            }
            while let Some(Reverse((cost, node))) = self.waiting.pop() {
                // A node waits again when it becomes cheaper.
                if self.cheapest[node as usize] == cost {
                    newest = node as usize;
                    total += self.take(newest);
                    break;
                }
            }
        }
        total + self.two_cheapest(near[0].iter().copied()).0 - 2 * self.of.iter().sum::<i64>()
    }

    /// The two cheapest edges of node 0: what they cost together, and where they lead.
    fn two_cheapest(&mut self, edges: impl Iterator<Item = (i64, u32)>) -> (i64, [usize; 2]) {
        let mut two = [(i64::MAX, 0); 2];
        for (cost, node) in edges {
            let edge = (cost + self.of[0] + self.of[node as usize], node as usize);
            if edge < two[0] {
                two = [edge, two[0]];
            } else if edge < two[1] {
                two[1] = edge;
            }
        }
        self.edges[0] = 2;
        self.edges[two[0].1] += 1;
        self.edges[two[1].1] += 1;
        (two[0].0 + two[1].0, two.map(|(_, node)| node))
    }

    /// Whether the last tree is a tour: every node has two edges.
    fn is_tour(&self) -> bool {
        self.edges.iter().all(|&edges| edges == 2)
    }

    /// Raises the price of nodes with many edges and lowers that of leaves.
    fn change(&mut self, step: f64) {
        for ((price, edges), direction) in self.of.iter_mut().zip(&self.edges).zip(&mut self.direction) {
            *direction = KEPT * *direction + (1.0 - KEPT) * (edges - 2) as f64;
            *price += (step * *direction).round() as i64;
        }
    }
}
