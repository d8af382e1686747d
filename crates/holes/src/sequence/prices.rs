//! Prices of nodes, added to each edge of a node, so that a shortest tree comes near to a tour.
//!
//! A tour is a tree over all nodes but one, with two more edges at that one, and it has two edges at every node.
//! Without the last condition, the shortest such 1-tree is found directly. Give every node a price that is added to
//! each of its edges, and subtract twice the sum of the prices: no tour changes its length, but the tree gets longer
//! where a node had too few or too many edges (Held and Karp, 1970, 1971). Under good prices the tree is nearly a
//! tour: its length is a lower bound for every tour ([`super::bound`]), and its edges are likely edges of a short
//! tour (`tour/candidates.rs`).
//!
//! All figures are whole numbers. The node outside the tree is the first point, or the node without position that
//! closes an open path: the tree is always over points.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::places::PointBoxes;
use super::spanning::shortest_tree;
use super::tour::{Space, near_edges};

/// The first step of the prices, in edges of mean length. Circles of holes are far apart, and a price must cover that
/// distance; with fewer rounds than this the steps are proportionally smaller.
const FIRST_STEP: f64 = 10.0;
const ENOUGH: usize = 120;
/// The factor by which the last steps are smaller, besides their decrease to zero.
const SHRINK: f64 = 1.0 / 1000.0;
/// The share of the last direction that is kept: nodes that alternate settle, and the nodes of one circle move
/// together.
const KEPT: f64 = 0.9;

/// One round in so many looks at all pairs.
const ALL_PAIRS: usize = 100;

/// The edges from which most trees are built: those between near nodes, and those of trees over all pairs.
pub(super) type Edges = Vec<Vec<(i64, u32)>>;

/// Prices of the nodes of a space, and the trees under them.
pub(super) struct Prices<'s> {
    space: &'s Space<'s>,
    places: PointBoxes<'s>,
    /// The price of each node.
    pub(super) by_node: Vec<i64>,
    /// For each node, the other nodes with the cost of the edge; none for the node outside the tree.
    pub(super) edges: Edges,
    /// Edges of each node in the last tree.
    degrees: Vec<i64>,
    /// The direction in which the prices change.
    direction: Vec<f64>,
    /// The cheapest edge from each node into the tree, and its other end; [`INSIDE`] for a node of the tree.
    cheapest: Vec<i64>,
    towards: Vec<u32>,
    waiting: BinaryHeap<Reverse<(i64, u32)>>,
}

/// The cheapest edge of a node of the tree.
const INSIDE: i64 = i64::MIN;

impl<'s> Prices<'s> {
    /// Zero prices, for three nodes or more.
    pub(super) fn new(space: &'s Space<'s>) -> Self {
        let count = space.nodes();
        let mut prices = Self {
            space,
            places: PointBoxes::of(space.points()),
            by_node: vec![0; count],
            edges: vec![Vec::new(); count],
            degrees: vec![0; count],
            direction: vec![0.0; count],
            cheapest: vec![0; count],
            towards: vec![0; count],
            waiting: BinaryHeap::new(),
        };
        let beside = space.outside_node();
        near_edges(space, |from, to| {
            if from != beside && to != beside {
                prices.join(from, to);
            }
        });
        prices
    }

    fn join(&mut self, from: usize, to: usize) {
        if self.edges[from].iter().all(|&(_, known)| known as usize != to) {
            let cost = self.space.cost(from, to);
            self.edges[from].push((cost, to as u32));
            self.edges[to].push((cost, from as u32));
        }
    }

    /// The cost of an edge with the prices of its nodes.
    pub(super) fn priced(&self, cost: i64, from: usize, to: usize) -> i64 {
        cost + self.by_node[from] + self.by_node[to]
    }

    /// Improves the prices in so many rounds, until the bound equals the cost of a known path; returns the best
    /// bound.
    ///
    /// Most rounds build the tree from the known edges, which is quick and shows how to change the prices. Sometimes
    /// a tree over all pairs finds edges that are not among them, and gives a bound; the best prices so far are then
    /// forgotten.
    pub(super) fn ascend(&mut self, path: i64, rounds: usize) -> i64 {
        let mut bound = self.tree_over_all();
        let mut at_bound = self.by_node.clone();
        let mut best = (bound, self.by_node.clone());
        let mean = bound as f64 / self.by_node.len() as f64;
        let mut step = FIRST_STEP * mean * rounds.min(ENOUGH) as f64 / ENOUGH as f64;
        let shrink = libm::pow(SHRINK, 1.0 / rounds.max(1) as f64);
        for round in 1..=rounds {
            let tree = if round % ALL_PAIRS == 0 {
                let tree = self.tree_over_all();
                if tree > bound {
                    bound = tree;
                    at_bound.copy_from_slice(&self.by_node);
                }
                best.0 = bound;
                best.1.copy_from_slice(&at_bound);
                tree
            } else {
                self.tree_among_edges()
            };
            if tree > best.0 {
                best.0 = tree;
                best.1.copy_from_slice(&self.by_node);
            }
            if bound >= path || self.is_tour() {
                break;
            }
            self.change(step * (rounds - round) as f64 / rounds as f64);
            step *= shrink;
        }
        self.by_node = best.1;
        bound
    }

    /// The cost of the shortest 1-tree over all pairs less twice the prices: a lower bound. Its edges are added to
    /// the known ones.
    pub(super) fn tree_over_all(&mut self) -> i64 {
        self.degrees.fill(0);
        let mut total = 0;
        for (from, to) in shortest_tree(self.space, &self.places, &self.by_node, &self.edges) {
            total += self.priced(self.space.cost(from, to), from, to);
            self.degrees[from] += 1;
            self.degrees[to] += 1;
            self.join(from, to);
        }
        total + self.beside_tree() - 2 * self.by_node.iter().sum::<i64>()
    }

    /// The same over the known edges only (Prim). It is never less, and so no bound.
    fn tree_among_edges(&mut self) -> i64 {
        self.degrees.fill(0);
        self.cheapest.fill(i64::MAX);
        self.waiting.clear();
        let beside = self.space.outside_node();
        let mut newest = usize::from(beside == 0);
        self.cheapest[beside] = INSIDE;
        self.cheapest[newest] = INSIDE;
        let mut total = 0;
        for _ in 2..self.by_node.len() {
            let own = self.by_node[newest];
            for &(cost, node) in &self.edges[newest] {
                let cost = cost + own + self.by_node[node as usize];
                if cost < self.cheapest[node as usize] {
                    self.cheapest[node as usize] = cost;
                    self.towards[node as usize] = newest as u32;
                    self.waiting.push(Reverse((cost, node)));
                }
            }
            while let Some(Reverse((cost, node))) = self.waiting.pop() {
                // A node is queued again when it becomes cheaper.
                if self.cheapest[node as usize] == cost {
                    newest = node as usize;
                    self.cheapest[newest] = INSIDE;
                    self.degrees[newest] += 1;
                    self.degrees[self.towards[newest] as usize] += 1;
                    total += cost;
                    break;
                }
            }
        }
        total + self.beside_tree() - 2 * self.by_node.iter().sum::<i64>()
    }

    /// Adds the two cheapest edges of the node outside the tree; returns their cost.
    fn beside_tree(&mut self) -> i64 {
        let beside = self.space.outside_node();
        let two = self.cheapest_beside(2);
        for &(_, end) in &two {
            self.degrees[end as usize] += 1;
        }
        self.degrees[beside] = 2;
        two.iter().map(|&(cost, _)| cost).sum()
    }

    /// The cheapest edges of the node outside the tree, over all nodes, with their priced costs; `most` of them.
    pub(super) fn cheapest_beside(&self, most: usize) -> Vec<(i64, u32)> {
        let beside = self.space.outside_node();
        let mut least: Vec<(i64, u32)> = Vec::with_capacity(most + 1);
        for node in (0..self.by_node.len()).filter(|&node| node != beside) {
            let edge = (self.priced(self.space.cost(beside, node), beside, node), node as u32);
            if least.len() < most || least.last().is_some_and(|last| edge < *last) {
                let place = least.partition_point(|known| *known < edge);
                least.insert(place, edge);
                least.truncate(most);
            }
        }
        least
    }

    /// Whether the last tree is a tour: every node has two edges.
    fn is_tour(&self) -> bool {
        self.degrees.iter().all(|&edges| edges == 2)
    }

    /// Raises the price of nodes with many edges and lowers that of leaves.
    fn change(&mut self, step: f64) {
        for ((price, edges), direction) in self.by_node.iter_mut().zip(&self.degrees).zip(&mut self.direction) {
            *direction = KEPT * *direction + (1.0 - KEPT) * (edges - 2) as f64;
            *price += (step * *direction).round() as i64;
        }
    }
}
