//! The near nodes of every node, nearest first: where the search looks for better edges.

use super::Space;
use super::places::{Bounds, Places, Quest};
use crate::part::Point;

/// The nearest nodes of each.
const NEAREST: usize = 6;
/// And the nearest of each quarter around it, so that holes on a circle also see those of the next circle.
const OF_QUARTER: usize = 2;
/// The longest list.
const MOST: usize = 12;

/// The lists of near nodes, one after the other.
pub(super) struct Neighbours {
    starts: Vec<usize>,
    nodes: Vec<(i64, u32)>,
}

impl Neighbours {
    /// Of every node.
    pub(super) fn of(space: &Space<'_>) -> Self {
        let count = space.nodes();
        let places = Places::of(space.points);
        let mut all = Self { starts: Vec::with_capacity(count + 1), nodes: Vec::with_capacity(count * MOST) };
        for node in 0..count {
            all.starts.push(all.nodes.len());
            let mut near = near(space, &places, node);
            near.sort_unstable();
            near.dedup();
            all.nodes.extend(near.into_iter().take(MOST));
        }
        all.starts.push(all.nodes.len());
        all
    }

    /// The near nodes of a node with the cost of going there, the cheapest first.
    pub(super) fn near(&self, node: u32) -> &[(i64, u32)] {
        let node = node as usize;
        &self.nodes[self.starts[node]..self.starts[node + 1]]
    }
}

/// The candidates of a node with their cost: its nearest, those of its quarters, and the node without place.
fn near(space: &Space<'_>, places: &Places<'_>, node: usize) -> Vec<(i64, u32)> {
    let Some(&at) = space.points.get(node) else {
        return (0..space.points.len().min(MOST)).map(|other| (0, other as u32)).collect();
    };
    let [a, b, c, d] = [const { Shortest::new(OF_QUARTER) }; 4];
    let mut around = Around { space, node, at, nearest: Shortest::new(NEAREST), quarters: [a, b, c, d] };
    places.seek(&mut around);
    let closing = space.free_ends.then_some((0, space.points.len() as u32));
    let quarters = around.quarters.iter().flat_map(Shortest::iter);
    closing.into_iter().chain(around.nearest.iter()).chain(quarters).collect()
}

/// The quest for what is near a point, in all directions and in each quarter.
struct Around<'s> {
    space: &'s Space<'s>,
    node: usize,
    at: Point,
    nearest: Shortest,
    quarters: [Shortest; 4],
}

impl Around<'_> {
    /// Every direction belongs to one quarter, an axis to the quarter it begins.
    fn quarter(&self, point: Point) -> usize {
        match ((point.x - self.at.x).micrometres(), (point.y - self.at.y).micrometres()) {
            (1.., 0..) => 0,
            (..=0, 1..) => 1,
            (..=-1, _) => 2,
            _ => 3,
        }
    }
}

impl Quest for Around<'_> {
    fn least(&self, _: usize, bounds: &Bounds) -> Option<i64> {
        let cost = self.space.metric.cost(self.at, bounds.nearest(self.at));
        // A box lies within one quarter where its corners do; in several its best may be of any.
        let Bounds { low, high } = *bounds;
        let corners = [low, high, Point { x: low.x, y: high.y }, Point { x: high.x, y: low.y }];
        let of_quarter = |corner: Point| self.quarters[self.quarter(corner)].worst();
        let worst = corners.map(of_quarter).into_iter().chain([self.nearest.worst()]).max();
        (worst >= Some(cost)).then_some(cost)
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

/// The few cheapest of many, cheapest first, of equals those first in the list of points.
struct Shortest {
    most: usize,
    held: usize,
    list: [(i64, u32); NEAREST],
}

impl Shortest {
    const fn new(most: usize) -> Self {
        Self { most, held: 0, list: [(i64::MAX, u32::MAX); NEAREST] }
    }

    /// What costs more has no place.
    const fn worst(&self) -> i64 {
        self.list[self.most - 1].0
    }

    #[inline]
    fn offer(&mut self, cost: i64, node: u32) {
        if (cost, node) >= self.list[self.most - 1] {
            return;
        }
        let mut place = self.held.min(self.most - 1);
        while place > 0 && self.list[place - 1] > (cost, node) {
            self.list[place] = self.list[place - 1];
            place -= 1;
        }
        self.list[place] = (cost, node);
        self.held = (self.held + 1).min(self.most);
    }

    fn iter(&self) -> impl Iterator<Item = (i64, u32)> {
        self.list[..self.held].iter().copied()
    }
}
