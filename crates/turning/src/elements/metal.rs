//! The points of a contour as a tree over their order. A query skips every branch in which no point can count.

use std::ops::Range;

use crate::turning::length::Half;
use crate::turning::point::Point;

/// The most points of a branch without branches of its own.
const LEAF: usize = 8;

/// Limits of all points of a branch: the greatest distances across both edges, and the least Z.
#[derive(Clone, Copy)]
pub(super) struct Bound {
    pub behind: f64,
    pub ahead: f64,
    pub least_z: Half,
}

impl Bound {
    fn and(self, other: Self) -> Self {
        Self {
            behind: self.behind.max(other.behind),
            ahead: self.ahead.max(other.ahead),
            least_z: self.least_z.min(other.least_z),
        }
    }
}

/// The points of each bit of a contour.
pub(super) struct Metal {
    points: Vec<Point>,
    /// Where the points of each bit end.
    ends: Vec<usize>,
    root: Option<Branch>,
}

struct Branch {
    bound: Bound,
    points: Range<usize>,
    halves: Option<Box<[Branch; 2]>>,
}

impl Metal {
    pub fn new(bits: &[Vec<Point>], bound: impl Fn(Point) -> Bound) -> Self {
        let points = bits.concat();
        let ends = bits.iter().scan(0, |end, points| {
            *end += points.len();
            Some(*end)
        });
        let bounds: Vec<Bound> = points.iter().map(|at| bound(*at)).collect();
        Self { ends: ends.collect(), root: Branch::of(0, &bounds), points }
    }

    /// The points of a bit.
    pub fn of(&self, bit: usize) -> &[Point] {
        self.points.get(self.range(bit)).unwrap_or_default()
    }

    /// Whether a point before a bit counts. A branch is skipped if no point within its limits may count.
    pub fn before(&self, bit: usize, may: impl Fn(Bound) -> bool, counts: impl Fn(Point) -> bool) -> bool {
        self.any(0..self.range(bit).start, &may, &counts)
    }

    /// Whether a point behind a bit counts.
    pub fn after(&self, bit: usize, may: impl Fn(Bound) -> bool, counts: impl Fn(Point) -> bool) -> bool {
        self.any(self.range(bit).end..self.points.len(), &may, &counts)
    }

    fn range(&self, bit: usize) -> Range<usize> {
        let end = |bit: usize| self.ends.get(bit).copied().unwrap_or(self.points.len());
        bit.checked_sub(1).map_or(0, end)..end(bit)
    }

    fn any(&self, within: Range<usize>, may: &impl Fn(Bound) -> bool, counts: &impl Fn(Point) -> bool) -> bool {
        self.root.as_ref().is_some_and(|root| {
            root.any(&within, may, &|index: usize| self.points.get(index).is_some_and(|at| counts(*at)))
        })
    }
}

impl Branch {
    /// A branch of points, the first of them with that index; none without points.
    fn of(first: usize, bounds: &[Bound]) -> Option<Self> {
        let bound = bounds.iter().copied().reduce(Bound::and)?;
        let (one, other) = bounds.split_at(bounds.len() / 2);
        let halves = if bounds.len() > LEAF {
            Self::of(first, one).zip(Self::of(first + one.len(), other)).map(|(one, other)| Box::new([one, other]))
        } else {
            None
        };
        Some(Self { bound, points: first..first + bounds.len(), halves })
    }

    fn any(&self, within: &Range<usize>, may: &impl Fn(Bound) -> bool, counts: &impl Fn(usize) -> bool) -> bool {
        let (start, end) = (self.points.start.max(within.start), self.points.end.min(within.end));
        if start >= end || !may(self.bound) {
            return false;
        }
        match &self.halves {
            Some(halves) => halves.iter().any(|half| half.any(within, may, counts)),
            None => (start..end).any(counts),
        }
    }
}
