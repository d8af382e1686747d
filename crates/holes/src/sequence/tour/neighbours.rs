//! The near nodes of every node, nearest first: where the search looks for better edges.

use super::Space;

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
    /// Of every node, by comparing all pairs: a few milliseconds for a thousand.
    pub(super) fn of(space: &Space<'_>) -> Self {
        let count = space.nodes();
        let mut all = Self { starts: Vec::with_capacity(count + 1), nodes: Vec::with_capacity(count * MOST) };
        for node in 0..count {
            all.starts.push(all.nodes.len());
            let mut near = near(space, node);
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
fn near(space: &Space<'_>, node: usize) -> Vec<(i64, u32)> {
    let (mut nearest, mut quarters) = (Shortest::new(NEAREST), [const { Shortest::new(OF_QUARTER) }; 4]);
    let Some(&at) = space.points.get(node) else {
        return (0..space.points.len().min(MOST)).map(|other| (0, other as u32)).collect();
    };
    for (other, &point) in space.points.iter().enumerate().filter(|(other, _)| *other != node) {
        let cost = space.metric.cost(at, point);
        nearest.offer(cost, other as u32);
        // Every direction belongs to one quarter, an axis to the quarter it begins.
        let (right, up) = ((point.x - at.x).micrometres(), (point.y - at.y).micrometres());
        let quarter = match (right, up) {
            (1.., 0..) => 0,
            (..=0, 1..) => 1,
            (..=-1, _) => 2,
            _ => 3,
        };
        quarters[quarter].offer(cost, other as u32);
    }
    let closing = space.free_ends.then_some((0, space.points.len() as u32));
    let quarters = quarters.iter().flat_map(Shortest::iter);
    closing.into_iter().chain(nearest.iter()).chain(quarters).collect()
}

/// The few cheapest of many, cheapest first, the first of equals kept.
struct Shortest {
    most: usize,
    held: usize,
    list: [(i64, u32); NEAREST],
}

impl Shortest {
    const fn new(most: usize) -> Self {
        Self { most, held: 0, list: [(i64::MAX, 0); NEAREST] }
    }

    #[inline]
    fn offer(&mut self, cost: i64, node: u32) {
        if cost >= self.list[self.most - 1].0 {
            return;
        }
        let mut place = self.held.min(self.most - 1);
        while place > 0 && self.list[place - 1].0 > cost {
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
