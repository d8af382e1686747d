//! The points of a contour, bit by bit, with the limits of all before and behind each: where no point within them can count, none is
//! looked at.

use crate::turning::length::Half;
use crate::turning::point::Point;

/// Limits of some points: the greatest distances across both edges, and the least Z.
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
    bits: Vec<Vec<Point>>,
    /// The limits of all points before each bit; none where there are no points.
    before: Vec<Option<Bound>>,
    /// The same behind it.
    after: Vec<Option<Bound>>,
}

impl Metal {
    pub fn new(bits: Vec<Vec<Point>>, bound: impl Fn(Point) -> Bound) -> Self {
        let own = |points: &Vec<Point>| points.iter().map(|at| bound(*at)).reduce(Bound::and);
        let so_far = |all: &mut Option<Bound>, one: Option<Bound>| {
            let before = *all;
            *all = before.into_iter().chain(one).reduce(Bound::and);
            Some(before)
        };
        let before = bits.iter().map(own).scan(None, so_far).collect();
        let mut after: Vec<Option<Bound>> = bits.iter().rev().map(own).scan(None, so_far).collect();
        after.reverse();
        Self { bits, before, after }
    }

    /// The points of a bit.
    pub fn of(&self, bit: usize) -> &[Point] {
        self.bits.get(bit).map_or(&[], Vec::as_slice)
    }

    /// Whether a point before a bit counts, if one within these limits may.
    pub fn before(&self, bit: usize, may: impl Fn(Bound) -> bool, counts: impl Fn(Point) -> bool) -> bool {
        let any = || self.bits.iter().take(bit).flatten().any(|at| counts(*at));
        self.before.get(bit).copied().flatten().is_some_and(may) && any()
    }

    /// Whether a point behind a bit counts, if one within these limits may.
    pub fn after(&self, bit: usize, may: impl Fn(Bound) -> bool, counts: impl Fn(Point) -> bool) -> bool {
        let any = || self.bits.iter().skip(bit + 1).flatten().any(|at| counts(*at));
        self.after.get(bit).copied().flatten().is_some_and(may) && any()
    }
}
