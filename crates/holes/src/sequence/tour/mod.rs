//! The shortest path over points: exact for few points, approximate for many.
//!
//! A path is a closed tour over the nodes of a [`Space`]. The path of a tool begins and ends at the tool-change
//! position, which is node 0. A path with two free ends is closed by a node at distance zero from all others. The
//! clock is not used: work is counted in tries, and random numbers come from a fixed seed, so the same points and
//! tries always give the same path.

mod candidates;
mod exact;
mod local;
mod neighbours;
mod rows;
mod search;

use crate::part::Point;

use super::metric::Metric;
use super::places::{Bounds, PointBoxes, Query};

pub use exact::EXACT_POINTS;

/// The effort of a search: tries for each point of the path, where it is too long to be solved exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort(pub u32);

/// The least and the most tries for a visit of a plan, with one try for each point, so that a part of a thousand
/// holes is planned without a noticeable wait.
const PLAN_TRIES: (u64, u64) = (40, 300);

/// Shorter paths get as many tries as a path of so many points, because they take almost no time.
const FEW: usize = 50;

impl Effort {
    /// The tries for so many points.
    pub fn tries(self, points: usize) -> u64 {
        u64::from(self.0) * points.max(FEW) as u64
    }
}

/// The usual number of tries: about half a second; preparation takes longer for more points.
pub fn usual_tries(points: usize) -> u64 {
    const MOST: u64 = 10_000;
    MOST.saturating_sub(points as u64).max(200)
}

/// Points and the costs of moving between them.
#[derive(Clone, Debug)]
pub struct Space<'p> {
    points: &'p [Point],
    metric: Metric,
    /// Whether a node without position closes the path; its two ends are then free.
    free_ends: bool,
}

impl<'p> Space<'p> {
    /// The space of closed tours over the points.
    pub const fn closed(points: &'p [Point], metric: Metric) -> Self {
        Self { points, metric, free_ends: false }
    }

    /// The space of paths over the points that begin and end wherever it is shortest.
    pub const fn open(points: &'p [Point], metric: Metric) -> Self {
        Self { points, metric, free_ends: true }
    }

    /// The number of nodes: the points, and the node that closes an open path.
    pub const fn nodes(&self) -> usize {
        self.points.len() + self.free_ends as usize
    }

    /// The points.
    pub const fn points(&self) -> &'p [Point] {
        self.points
    }

    /// The node outside every tree over the others ([`super::prices`]).
    pub(super) const fn outside_node(&self) -> usize {
        if self.free_ends { self.points.len() } else { 0 }
    }

    /// The cost between two nodes: micrometres, or microseconds where rapids have an acceleration.
    #[inline]
    pub fn cost(&self, from: usize, to: usize) -> i64 {
        match (self.points.get(from), self.points.get(to)) {
            (Some(&from), Some(&to)) => self.metric.cost(from, to),
            // To and from the node without place.
            _ => 0,
        }
    }

    /// The metric.
    pub const fn metric(&self) -> Metric {
        self.metric
    }

    /// The cost of a tour through the nodes in that order and back to the first.
    pub fn round(&self, order: &[usize]) -> i64 {
        let back = order.last().zip(order.first()).map_or(0, |(&last, &first)| self.cost(last, first));
        order.windows(2).map(|pair| self.cost(pair[0], pair[1])).sum::<i64>() + back
    }

    /// The cost of a path over the points in that order: back to the first for a closed tour, to the last for an open
    /// path.
    pub fn length(&self, order: &[usize]) -> i64 {
        if self.free_ends { order.windows(2).map(|pair| self.cost(pair[0], pair[1])).sum() } else { self.round(order) }
    }
}

/// A path over all points of a space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Path {
    /// The points in order, from 0; a closed tour begins with point 0.
    pub order: Vec<usize>,
    /// Its cost.
    pub cost: i64,
    /// Whether no path is shorter, by proof.
    pub optimal: bool,
    /// The number of tries made.
    pub tries: u64,
}

/// The shortest path found with that effort; up to [`EXACT_POINTS`] points besides the start of a tour it is proven
/// the shortest.
pub fn path(space: &Space<'_>, effort: Effort) -> Path {
    let most = effort.tries(space.points.len());
    path_while(space, &mut |tries| tries < most)
}

/// The shortest path found while `go_on` returns true. `go_on` gets the number of tries made so far, so a clock may
/// end the search, and the same number of tries gives the same path again.
pub fn path_while(space: &Space<'_>, go_on: &mut dyn FnMut(u64) -> bool) -> Path {
    let optimal = space.nodes() <= EXACT_POINTS + 1;
    let (tour, tries) = if optimal {
        (exact::tour(space), 0)
    } else {
        let mut book: Vec<u32> = nearest_rule(space).order.iter().map(|&node| node as u32).collect();
        // The node without position is the last one.
        book.extend(book.len() as u32..space.nodes() as u32);
        search::tour(space, book, go_on)
    };
    let order = from_the_start(space, tour);
    Path { cost: space.length(&order), order, optimal, tries }
}

/// The path of a visit of a plan: found quickly, and along rows where these cost no more.
pub(super) fn plan_path(space: &Space<'_>) -> Path {
    let most = (space.nodes() as u64).clamp(PLAN_TRIES.0, PLAN_TRIES.1);
    rows::at_no_cost(space, path_while(space, &mut |tries| tries < most))
}

/// A path found at once, where only its length is needed.
pub(super) fn quick_path(space: &Space<'_>) -> Path {
    path_while(space, &mut |_| false)
}

/// Calls `edge` for every edge from a point to one of its near points, for some edges twice.
pub(super) fn near_edges(space: &Space<'_>, mut edge: impl FnMut(usize, usize)) {
    for (point, near) in neighbours::near_points(space).iter().enumerate() {
        near.iter().for_each(|&(_, other)| edge(point, other as usize));
    }
}

/// The rule of the book (textbook Appendix Г): from each point to the nearest one not yet visited, by straight
/// distance; among equals the first of the list. It begins at point 0.
pub fn nearest_rule(space: &Space<'_>) -> Path {
    let places = PointBoxes::of(space.points);
    let boxes = places.boxes();
    let mut left: Vec<u32> = vec![0; space.points.len()];
    boxes.iter().flatten().for_each(|&number| left[number as usize] += 1);
    let mut order = Vec::with_capacity(space.points.len());
    let mut visited = vec![false; space.points.len()];
    let mut next = (!space.points.is_empty()).then_some(0);
    while let Some(here) = next {
        visited[here] = true;
        boxes[here].iter().for_each(|&number| left[number as usize] -= 1);
        order.push(here);
        let mut nearest = Nearest { points: space.points, here, left: &left, visited: &visited, found: None };
        places.seek(&mut nearest);
        next = nearest.found.map(|(_, point)| point);
    }
    Path { cost: space.length(&order), order, optimal: false, tries: 0 }
}

/// The query for the nearest point not yet visited, with its distance.
struct Nearest<'s> {
    points: &'s [Point],
    here: usize,
    /// The number of points in each box not yet visited.
    left: &'s [u32],
    visited: &'s [bool],
    found: Option<(i64, usize)>,
}

impl Query for Nearest<'_> {
    fn lower_bound(&self, number: usize, bounds: &Bounds) -> Option<i64> {
        let here = self.points[self.here];
        let cost = Metric::Euclid.cost(here, bounds.nearest(here));
        let first = (cost, bounds.first as usize);
        (self.left[number] > 0 && self.found.is_none_or(|found| first < found)).then_some(cost)
    }

    fn meet(&mut self, point: usize) {
        let cost = Metric::Euclid.cost(self.points[self.here], self.points[point]);
        if !self.visited[point] && self.found.is_none_or(|found| (cost, point) < found) {
            self.found = Some((cost, point));
        }
    }
}

/// The tour opened at its beginning: at point 0, or at the node without position, which is left out. Of the two
/// directions, the one whose second point is earlier in the list.
fn from_the_start(space: &Space<'_>, mut tour: Vec<usize>) -> Vec<usize> {
    let first = space.outside_node();
    if let Some(at) = tour.iter().position(|&node| node == first) {
        tour.rotate_left(at);
    }
    if tour.len() > 2 && tour.last() < tour.get(1) {
        tour[1..].reverse();
    }
    tour.retain(|&node| node < space.points.len());
    tour
}

#[cfg(test)]
mod tests;
