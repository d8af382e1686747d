//! The near points of every point: nearly all edges of short trees and tours join near points.

use super::super::places::{Bounds, PointBoxes, Query};
use super::Space;
use crate::part::Point;

/// The number of nearest points.
const NEAREST: usize = 6;
/// The number of nearest points in each quadrant, so that holes on a circle also have neighbours on the next circle.
const OF_QUARTER: usize = 2;
/// The longest list.
const MOST: usize = 12;

/// The near points of every point with the cost of going there, the cheapest first.
pub(super) fn near_points(space: &Space<'_>) -> Vec<Vec<(i64, u32)>> {
    let places = PointBoxes::of(space.points);
    (0..space.points.len()).map(|point| neighbours_of(space, &places, point)).collect()
}

/// The nearest points of a point, and those of its quadrants.
fn neighbours_of(space: &Space<'_>, places: &PointBoxes<'_>, node: usize) -> Vec<(i64, u32)> {
    let [a, b, c, d] = [const { Shortest::new(OF_QUARTER) }; 4];
    let at = space.points[node];
    let mut around = NearQuery { space, node, at, nearest: Shortest::new(NEAREST), quarters: [a, b, c, d] };
    places.seek(&mut around);
    let quarters = around.quarters.iter().flat_map(Shortest::iter);
    let mut near: Vec<(i64, u32)> = around.nearest.iter().chain(quarters).collect();
    near.sort_unstable();
    near.dedup();
    near.truncate(MOST);
    near
}

/// The query for near points, in all directions and in each quadrant.
struct NearQuery<'s> {
    space: &'s Space<'s>,
    node: usize,
    at: Point,
    nearest: Shortest,
    quarters: [Shortest; 4],
}

impl NearQuery<'_> {
    /// Every direction belongs to one quadrant, an axis to the quadrant that it begins.
    fn quarter(&self, point: Point) -> usize {
        match ((point.x - self.at.x).micrometres(), (point.y - self.at.y).micrometres()) {
            (1.., 0..) => 0,
            (..=0, 1..) => 1,
            (..=-1, _) => 2,
            _ => 3,
        }
    }
}

impl Query for NearQuery<'_> {
    fn lower_bound(&self, _: usize, bounds: &Bounds) -> Option<i64> {
        let cost = self.space.metric.cost(self.at, bounds.nearest(self.at));
        // A box lies within one quadrant if its corners do; otherwise its best point may be in any of them.
        let Bounds { low, high, first } = *bounds;
        let corners = [low, high, Point { x: low.x, y: high.y }, Point { x: high.x, y: low.y }];
        let of_quarter = |corner: Point| self.quarters[self.quarter(corner)].worst();
        let worst = corners.map(of_quarter).into_iter().chain([self.nearest.worst()]).max();
        (worst > Some((cost, first))).then_some(cost)
    }

    fn meet(&mut self, other: usize) {
        if other == self.node {
            return;
        }
        let point = self.space.points[other];
        let cost = self.space.metric.cost(self.at, point);
        self.nearest.offer(cost, other as u32);
        self.quarters[self.quarter(point)].offer(cost, other as u32);
    }
}

/// The few cheapest of many, cheapest first; among equals, the first in the list of points.
struct Shortest {
    most: usize,
    count: usize,
    list: [(i64, u32); NEAREST],
}

impl Shortest {
    const fn new(most: usize) -> Self {
        Self { most, count: 0, list: [(i64::MAX, u32::MAX); NEAREST] }
    }

    /// The limit: what costs more is not kept.
    const fn worst(&self) -> (i64, u32) {
        self.list[self.most - 1]
    }

    #[inline]
    fn offer(&mut self, cost: i64, node: u32) {
        if (cost, node) >= self.list[self.most - 1] {
            return;
        }
        let mut place = self.count.min(self.most - 1);
        while place > 0 && self.list[place - 1] > (cost, node) {
            self.list[place] = self.list[place - 1];
            place -= 1;
        }
        self.list[place] = (cost, node);
        self.count = (self.count + 1).min(self.most);
    }

    fn iter(&self) -> impl Iterator<Item = (i64, u32)> {
        self.list[..self.count].iter().copied()
    }
}
