//! The shortest tree over all pairs of points, without looking at all pairs (Borůvka, 1926).
//!
//! In every round each tree of the forest takes its cheapest edge to another tree. A point searches for its edge in
//! boxes of points. A box is skipped where its nearest place with the least price of its points already costs too
//! much, or where all its points are of the same tree. Edges are ordered by cost and ends, so that no two are equal.

use super::metric::Metric;
use super::places::{Bounds, PointBoxes, Query};
use super::tour::Space;
use crate::part::Point;

/// An edge, by its cost and the lower and the higher of its nodes.
type Edge = (i64, u32, u32);

/// More than any edge.
const NONE: Edge = (i64::MAX, u32::MAX, u32::MAX);
/// The mark of a box with points of several trees.
const MIXED: u32 = u32::MAX;

/// The edges of a shortest tree over all points but the one outside it, under prices that are added to each edge of a
/// node. Some known edges of each node shorten the search.
pub(super) fn shortest_tree(
    space: &Space<'_>,
    places: &PointBoxes<'_>,
    prices: &[i64],
    known: &[Vec<(i64, u32)>],
) -> Vec<(usize, usize)> {
    let points = space.points();
    let boxes = places.boxes();
    let beside = space.outside_node();
    let inside = |node: &usize| *node != beside;
    let mut least = vec![i64::MAX; points.len().max(1)];
    for (node, own) in boxes.iter().enumerate().filter(|(node, _)| inside(node)) {
        own.iter().for_each(|&number| least[number as usize] = least[number as usize].min(prices[node]));
    }
    let mut trees: Vec<u32> = (0..points.len() as u32).collect();
    // The last edge found by each point, for itself or for its tree: as trees only grow, no cheaper edge remains for
    // it.
    let mut found = vec![(i64::MIN, 0, 0); points.len()];
    let mut edges = Vec::with_capacity(points.len());
    loop {
        let mut of_boxes = vec![None; least.len()];
        for (node, own) in boxes.iter().enumerate().filter(|(node, _)| inside(node)) {
            for &number in own {
                let tree = &mut of_boxes[number as usize];
                *tree = Some(if tree.is_none_or(|tree| tree == trees[node]) { trees[node] } else { MIXED });
            }
        }
        let mut cheapest = vec![NONE; points.len()];
        // Edges found earlier and still valid cost nothing, and save most of the searches.
        let still = |edge: Edge| edge.0 != i64::MIN && edge != NONE && trees[edge.1 as usize] != trees[edge.2 as usize];
        for node in (0..points.len()).filter(inside).filter(|&node| still(found[node])) {
            let own = &mut cheapest[trees[node] as usize];
            *own = found[node].min(*own);
        }
        for node in (0..points.len()).filter(inside) {
            let tree = trees[node];
            for &(cost, other) in known[node].iter().filter(|(_, other)| trees[*other as usize] != tree) {
                let own = &mut cheapest[tree as usize];
                *own = edge(cost, prices, node, other as usize).min(*own);
            }
        }
        for node in (0..points.len()).filter(inside) {
            let tree = trees[node] as usize;
            if still(found[node]) || found[node] >= cheapest[tree] {
                continue;
            }
            let mut outside = Outside {
                points,
                metric: space.metric(),
                prices,
                beside,
                node,
                trees: &trees,
                of_boxes: &of_boxes,
                least: &least,
                best: cheapest[tree],
            };
            places.seek(&mut outside);
            cheapest[tree] = outside.best;
            found[node] = outside.best;
        }
        let before = edges.len();
        for (_, from, to) in cheapest.into_iter().filter(|edge| *edge != NONE) {
            let (one, other) = (root(&mut trees, from), root(&mut trees, to));
            if one != other {
                trees[one.max(other) as usize] = one.min(other);
                edges.push((from as usize, to as usize));
            }
        }
        if edges.len() == before {
            return edges;
        }
        for node in 0..points.len() as u32 {
            trees[node as usize] = root(&mut trees, node);
        }
    }
}

fn edge(cost: i64, prices: &[i64], from: usize, to: usize) -> Edge {
    (cost + prices[from] + prices[to], from.min(to) as u32, from.max(to) as u32)
}

/// The tree of a node while trees are joined; the nodes on the way to the root are linked to it directly.
fn root(trees: &mut [u32], mut node: u32) -> u32 {
    while trees[node as usize] != node {
        trees[node as usize] = trees[trees[node as usize] as usize];
        node = trees[node as usize];
    }
    node
}

/// The query for the cheapest edge from a node to another tree.
struct Outside<'s> {
    points: &'s [Point],
    metric: Metric,
    prices: &'s [i64],
    beside: usize,
    node: usize,
    trees: &'s [u32],
    /// The tree of all points of a box, or [`MIXED`]; none where the box has no point that counts.
    of_boxes: &'s [Option<u32>],
    /// The least price in each box.
    least: &'s [i64],
    best: Edge,
}

impl Query for Outside<'_> {
    fn lower_bound(&self, number: usize, bounds: &Bounds) -> Option<i64> {
        if self.of_boxes[number].is_none_or(|tree| tree == self.trees[self.node]) {
            return None;
        }
        let at = self.points[self.node];
        let cost = self.metric.cost(at, bounds.nearest(at)) + self.least[number] + self.prices[self.node];
        // Every edge to a later point of the box costs more.
        let (low, high) = (self.node.min(bounds.first as usize) as u32, self.node.max(bounds.first as usize) as u32);
        ((cost, low, high) < self.best).then_some(cost)
    }

    fn meet(&mut self, other: usize) {
        if other == self.beside || self.trees[other] == self.trees[self.node] {
            return;
        }
        let cost = self.metric.cost(self.points[self.node], self.points[other]);
        self.best = self.best.min(edge(cost, self.prices, self.node, other));
    }
}
