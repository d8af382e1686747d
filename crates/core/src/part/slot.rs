//! Straight slots with round ends, a hole that runs from one point to another; and rectangular pockets, which have corners instead.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Micrometres;

use super::{Hole, Point, standing};

/// How a slot runs: from the middle of its first end radius, which is its point, to that of the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
pub struct Slot {
    /// Along X, mm.
    pub x: Micrometres,
    /// Along Y, mm.
    pub y: Micrometres,
    /// Of a pocket the radius of its corners, mm: its ends are straight, half of its width beyond those points. Absent where the
    /// ends are round.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corner: Option<Micrometres>,
    /// How it runs out of the blank, where it does; the first of its ends then lies beside the blank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub open: Option<OpenEnds>,
}

/// How far the ends of a slot that runs out of the blank lie beyond where the drawing has it end: the whole mill then stands beside
/// the blank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
pub struct OpenEnds {
    /// The first, mm.
    pub first: Micrometres,
    /// The other, mm; absent where the slot is closed there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub far: Option<Micrometres>,
}

impl Slot {
    /// From the middle of one end radius to that of the other, mm.
    pub fn length(self) -> Micrometres {
        Micrometres::from_mm_rounded(libm::hypot(self.x.to_mm(), self.y.to_mm()))
    }

    /// Its length over all as drawn, where it is so wide: from the edge of the blank, where it is open.
    pub fn drawn(self, width: Micrometres) -> Micrometres {
        match self.open {
            None => self.length() + width,
            Some(open) => self.length() - open.first + open.far.map_or(width.half(), |far| Micrometres::ZERO - far),
        }
    }

    /// Its ends in the blank, where its first one is: those that are not open.
    pub fn closed(self, at: Point) -> impl Iterator<Item = Point> {
        let first = self.open.is_none().then_some(at);
        let far = self.open.is_none_or(|open| open.far.is_none()).then(|| self.far(at));
        first.into_iter().chain(far)
    }

    /// Its ends beside the blank, where its first one is.
    pub fn outside(self, at: Point) -> impl Iterator<Item = Point> {
        let first = self.open.map(|_| at);
        let far = self.open.and_then(|open| open.far).map(|_| self.far(at));
        first.into_iter().chain(far)
    }

    /// The middle of the other end radius, where the first one is.
    pub fn far(self, at: Point) -> Point {
        Point { x: at.x + self.x, y: at.y + self.y }
    }

    /// The direction in which it runs; of a square pocket that of X.
    pub fn direction(self) -> [f64; 2] {
        let (x, y) = (self.x.to_mm(), self.y.to_mm());
        let length = libm::hypot(x, y);
        if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] }
    }

    /// The line between the middles of its ends where the first one is; for drawings.
    pub fn middle(self, at: Point) -> Way {
        Way { from: at, to: self.far(at), thinner: Micrometres::ZERO, corner: self.corner }
    }

    /// The lines over which it extends where its first end is and it is so wide: of a pocket beside its middle line those between the
    /// middles of its corner radii, about which it is thinner.
    pub fn ways(self, at: Point, width: Micrometres) -> Vec<Way> {
        let mut ways = vec![self.middle(at)];
        if let Some(corner) = self.corner {
            let (far, thinner) = (self.far(at), width.half() - corner);
            let [x, y] = self.direction().map(|share| Micrometres::from_mm_rounded(share * thinner.to_mm()));
            // Beside an end: along its direction and to its left.
            let point = |end: Point, along: bool, left: bool| {
                let sign = |value: Micrometres, plus: bool| if plus { value } else { Micrometres::ZERO - value };
                Point { x: end.x + sign(x, along) - sign(y, left), y: end.y + sign(y, along) + sign(x, left) }
            };
            let corners =
                [point(at, false, false), point(far, true, false), point(far, true, true), point(at, false, true)];
            let line = |from, to| Way { from, to, thinner, corner: None };
            ways.extend((0..4).map(|one| line(corners[one], corners[(one + 1) % 4])));
            ways.extend(corners.iter().zip([at, far, far, at]).map(|(corner, end)| line(end, *corner)));
        }
        ways
    }

    /// Whether it lies along X or along Y: its walls are then cut by one axis of the machine alone.
    pub fn along_axis(self) -> bool {
        self.x == Micrometres::ZERO || self.y == Micrometres::ZERO
    }
}

/// The line over which the axis of a hole extends, seen from above: of a round hole its point alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// One end.
    pub from: Point,
    /// The other.
    pub to: Point,
    /// How much nearer to it the wall is than half of the width: nothing but along the walls of a pocket.
    pub thinner: Micrometres,
    /// Of the middle line of a pocket the radius of its corners.
    pub corner: Option<Micrometres>,
}

impl Way {
    /// The distance of a point, mm.
    pub fn nearest(self, at: Point) -> Micrometres {
        Micrometres::from_mm_rounded(standing::distance(self.from, self.to, at))
    }

    /// The distance of a point to hold against half of the width, mm.
    pub fn distance(self, at: Point) -> Micrometres {
        self.nearest(at) + self.thinner
    }

    /// The distance of another one to hold against half of both widths, mm; where they cross only what both are thinner.
    pub fn apart(self, other: Self) -> Micrometres {
        // On which side of a way a point lies.
        let side = |way: Self, at: Point| {
            let [ax, ay, bx, by, px, py] =
                [way.from.x, way.from.y, way.to.x, way.to.y, at.x, at.y].map(|one| i128::from(one.micrometres()));
            ((bx - ax) * (py - ay) - (by - ay) * (px - ax)).signum()
        };
        let parts = |way: Self, of: Self| side(way, of.from) * side(way, of.to) < 0;
        if parts(self, other) && parts(other, self) {
            return self.thinner + other.thinner;
        }
        let ends = [self.nearest(other.from), self.nearest(other.to), other.nearest(self.from), other.nearest(self.to)];
        ends.into_iter().min().unwrap_or_default() + self.thinner + other.thinner
    }
}

impl Hole {
    /// The lines over which its axes extend: its points, or of a slot the line between the middles of its end radii; of a pocket
    /// those of its walls, too.
    pub fn ways(&self) -> impl Iterator<Item = Way> + '_ {
        let slot = self.slot.unwrap_or_default();
        self.at.iter().flat_map(move |at| slot.ways(*at, self.diameter.nominal))
    }

    /// Its points, or the middle line of its slot or pocket: for drawings.
    pub fn middles(&self) -> impl Iterator<Item = Way> + '_ {
        let slot = self.slot.unwrap_or_default();
        self.at.iter().map(move |at| slot.middle(*at))
    }

    /// Its slot or pocket where it is only so wide yet: what is left on the walls is left in the corners, too.
    pub fn slot_to(&self, width: Micrometres) -> Option<Slot> {
        let middle = (self.diameter.smallest() + self.diameter.largest()).half();
        self.slot.map(|slot| Slot { corner: slot.corner.map(|corner| corner - (middle - width).half()), ..slot })
    }

    /// Its points, and of a slot those of its other end.
    pub fn ends(&self) -> impl Iterator<Item = Point> + '_ {
        let far = self.slot.into_iter().flat_map(|slot| self.at.iter().map(move |at| slot.far(*at)));
        self.at.iter().copied().chain(far)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn way(from: [i64; 2], to: [i64; 2]) -> Way {
        let point = |[x, y]: [i64; 2]| Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) };
        Way { from: point(from), to: point(to), thinner: Micrometres::ZERO, corner: None }
    }

    /// Distances that a drawing shows without computing.
    #[test]
    fn slots_beside_behind_and_across_each_other_are_as_far_apart_as_they_are() {
        let along = way([0, 0], [40, 0]);
        let mm = |mm: i64| Micrometres::from_mm(mm);
        assert_eq!(along.apart(way([10, 7], [30, 7])), mm(7), "beside it");
        assert_eq!(along.apart(way([43, 4], [80, 4])), mm(5), "3 on, 4 aside");
        assert_eq!(along.apart(way([20, -5], [20, 5])), mm(0), "across it");
        assert_eq!(along.apart(way([20, 6], [20, 30])), mm(6), "its end toward the middle");
        assert_eq!(along.distance(Point { x: mm(-3), y: mm(4) }), mm(5));
        assert_eq!(along.apart(way([10, 2], [10, 2])), mm(2), "a round hole");
    }

    /// A pocket 60 × 40 about the zero with corners of 8 mm: the middles of its corner radii lie at ±22, ±12.
    #[test]
    fn a_pocket_reaches_into_its_corners_and_no_further() {
        let mm = |mm: i64| Micrometres::from_mm(mm);
        let slot = Slot { x: mm(20), y: mm(0), corner: Some(mm(8)), open: None };
        let ways = slot.ways(Point { x: mm(-10), y: mm(0) }, mm(40));
        let room = |x, y| {
            let least = ways.iter().map(|way| way.distance(Point { x: mm(x), y: mm(y) })).min().unwrap();
            least - mm(20)
        };
        assert_eq!(room(0, 25), mm(5), "beside a long wall");
        assert_eq!(room(37, 11), mm(7), "beside an end wall, where a round end would be further");
        assert_eq!(room(28, 20), mm(2), "beside a corner: 6 and 8 from the middle of its radius");
        assert!(room(25, 15) < mm(0), "in a corner");
    }
}
