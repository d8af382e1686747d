//! Straight slots with round ends: a hole that runs from one point to another.

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
}

impl Slot {
    /// From the middle of one end radius to that of the other, mm.
    pub fn length(self) -> Micrometres {
        Micrometres::from_mm_rounded(libm::hypot(self.x.to_mm(), self.y.to_mm()))
    }

    /// The middle of the other end radius, where the first one is.
    pub fn far(self, at: Point) -> Point {
        Point { x: at.x + self.x, y: at.y + self.y }
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
}

impl Way {
    /// The distance of a point, mm.
    pub fn distance(self, at: Point) -> Micrometres {
        Micrometres::from_mm_rounded(standing::distance(self.from, self.to, at))
    }

    /// The distance of another one, mm; nothing where they cross.
    pub fn apart(self, other: Self) -> Micrometres {
        // On which side of a way a point lies.
        let side = |way: Self, at: Point| {
            let [ax, ay, bx, by, px, py] =
                [way.from.x, way.from.y, way.to.x, way.to.y, at.x, at.y].map(|one| i128::from(one.micrometres()));
            ((bx - ax) * (py - ay) - (by - ay) * (px - ax)).signum()
        };
        let parts = |way: Self, of: Self| side(way, of.from) * side(way, of.to) < 0;
        if parts(self, other) && parts(other, self) {
            return Micrometres::ZERO;
        }
        let ends = [self.distance(other.from), self.distance(other.to)];
        ends.into_iter().chain([other.distance(self.from), other.distance(self.to)]).min().unwrap_or_default()
    }
}

impl Hole {
    /// The lines over which its axes extend: its points, or of a slot the line between the middles of its end radii.
    pub fn ways(&self) -> impl Iterator<Item = Way> + '_ {
        self.at.iter().map(|at| Way { from: *at, to: self.slot.map_or(*at, |slot| slot.far(*at)) })
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
        Way { from: point(from), to: point(to) }
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
}
