//! What stands over the face of a part while it is machined: clamps and obstacles, with their outlines and heights.

use serde::Serialize;

use super::{Clamp, Part, Point};
use crate::units::Micrometres;

/// A clamp or an obstacle, in the coordinates of the drawing as the part lies in a set-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Standing {
    /// Where it is, for messages.
    pub at: Point,
    /// Its outline, seen from above.
    pub outline: Outline,
    /// How high it stands over the face, mm.
    pub height: Micrometres,
    /// Whether it is the plan's own proposal, whose height is that of a strap of a catalog and may be chosen lower.
    #[serde(skip)]
    pub proposed: bool,
}

/// An outline seen from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outline {
    /// Everything nearer to the point than this.
    Round(Point, Micrometres),
    /// A rectangle along the axes: its lowest and highest corners.
    Box(Point, Point),
}

impl Part {
    /// What stands over the face in a set-up, from 1. The clamps of the file are those of the first, and without an outline
    /// as wide as `foot` about the point where they press; one without a height is not known to be in the way.
    pub fn standing(&self, set_up: u32, foot: Micrometres) -> Vec<Standing> {
        let clamps = self.fixture.clamps.iter().filter(|_| set_up == 1).filter_map(|clamp| {
            Some(Standing { at: clamp.at, outline: clamp.outline(foot), height: clamp.height?, proposed: false })
        });
        let obstacles = self.fixture.obstacles.iter().filter(|obstacle| obstacle.set_up == set_up).map(|obstacle| {
            let [a, b] = obstacle.outline.map(|corner| if set_up == 2 { self.turned_over(corner) } else { corner });
            let (low, high) = (Point { x: a.x.min(b.x), y: a.y.min(b.y) }, Point { x: a.x.max(b.x), y: a.y.max(b.y) });
            let at = Point { x: (low.x + high.x).half(), y: (low.y + high.y).half() };
            Standing { at, outline: Outline::Box(low, high), height: obstacle.height, proposed: false }
        });
        clamps.chain(obstacles).collect()
    }

    /// The position of a point when the part is turned over about the line through its middle along Y.
    pub fn turned_over(&self, at: Point) -> Point {
        let middle = self.middle().x;
        Point { x: middle + middle - at.x, y: at.y }
    }
}

impl Clamp {
    /// The outline of the file; without one everything nearer than `foot` to the point where it presses.
    pub fn outline(&self, foot: Micrometres) -> Outline {
        self.outline.map_or(Outline::Round(self.at, foot), |[low, high]| Outline::Box(low, high))
    }
}

impl Outline {
    /// Whether it has more than an edge in common with another one.
    pub fn overlaps(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Round(at, own), other) | (other, Self::Round(at, own)) => other.is_hit(*at, *at, *own),
            (Self::Box(low, high), Self::Box(other_low, other_high)) => {
                low.x < other_high.x && other_low.x < high.x && low.y < other_high.y && other_low.y < high.y
            }
        }
    }

    /// Whether a tool of this radius hits it on a rapid. A machine whose axes each go at their own rate goes at 45° until
    /// one has arrived, another one straight: neither may hit.
    pub fn is_hit_by_rapid(&self, from: Point, to: Point, radius: Micrometres) -> bool {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let both = dx.abs().min(dy.abs());
        let toward = |offset: Micrometres| if offset < Micrometres::ZERO { -both } else { both };
        let corner = Point { x: from.x + toward(dx), y: from.y + toward(dy) };
        [(from, to), (from, corner), (corner, to)].iter().any(|(a, b)| self.is_hit(*a, *b, radius))
    }

    /// Whether a tool of this radius hits it on a straight way.
    pub fn is_hit(&self, from: Point, to: Point, radius: Micrometres) -> bool {
        match self {
            Self::Round(at, own) => distance(from, to, *at) < (*own + radius).to_mm(),
            Self::Box(low, high) => {
                // From a rectangle that the way does not enter it is nearest at an end of the way, or at a corner.
                let ends = [from, to].into_iter().map(|at| outside(at, *low, *high));
                let corners = [*low, *high, Point { x: low.x, y: high.y }, Point { x: high.x, y: low.y }];
                let corners = corners.into_iter().map(|corner| distance(from, to, corner));
                crosses(from, to, *low, *high) || ends.chain(corners).any(|away| away < radius.to_mm())
            }
        }
    }
}

/// The distance from a point to a rectangle, mm; zero inside.
fn outside(at: Point, low: Point, high: Point) -> f64 {
    let away = |value: Micrometres, low: Micrometres, high: Micrometres| {
        (low - value).max(value - high).max(Micrometres::ZERO).to_mm()
    };
    libm::hypot(away(at.x, low.x, high.x), away(at.y, low.y, high.y))
}

/// Whether a straight way goes through the inside of a rectangle.
fn crosses(from: Point, to: Point, low: Point, high: Point) -> bool {
    // The share of the way that lies between the sides, axis by axis.
    let (mut begin, mut end) = (0.0_f64, 1.0_f64);
    for (from, to, low, high) in [(from.x, to.x, low.x, high.x), (from.y, to.y, low.y, high.y)] {
        let [from, to, low, high] = [from, to, low, high].map(Micrometres::to_mm);
        if from == to {
            if from <= low || from >= high {
                return false;
            }
            continue;
        }
        let (a, b) = ((low - from) / (to - from), (high - from) / (to - from));
        (begin, end) = (begin.max(a.min(b)), end.min(a.max(b)));
    }
    begin < end
}

/// The distance from a point to a straight way, mm.
pub(super) fn distance(a: Point, b: Point, at: Point) -> f64 {
    let [ax, ay, bx, by, px, py] = [a.x, a.y, b.x, b.y, at.x, at.y].map(Micrometres::to_mm);
    let (dx, dy) = (bx - ax, by - ay);
    let square = dx * dx + dy * dy;
    let share = if square > 0.0 { (((px - ax) * dx + (py - ay) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(px - ax - share * dx, py - ay - share * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Feet of 20 mm 30 and 30 mm apart: 42.4 mm from middle to middle, though squares of 40 about them would overlap.
    #[test]
    fn outlines_overlap_as_they_stand() {
        let round = |x, y| Outline::Round(point(x, y), Micrometres::from_mm(20));
        let square = |x, y| Outline::Box(point(x, y), point(x + 40, y + 40));
        assert!(!round(0, 0).overlaps(&round(30, 30)) && round(0, 0).overlaps(&round(30, 26)));
        assert!(!square(0, 0).overlaps(&square(40, 0)) && square(0, 0).overlaps(&square(39, 39)));
        for (near, at) in
            [(true, square(14, 14)), (false, square(15, 15)), (false, square(-60, 0)), (true, square(-59, 0))]
        {
            assert_eq!([round(0, 0).overlaps(&at), at.overlaps(&round(0, 0))], [near, near], "{at:?}");
        }
    }

    fn point(x: i64, y: i64) -> Point {
        Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) }
    }

    /// From the origin to X100 Y40 both axes move to X40 Y40, then one along X; or straight.
    #[test]
    fn a_rapid_goes_at_45_degrees_or_straight() {
        let near = |x, y| Outline::Round(point(x, y), Micrometres::from_mm(5));
        let hit = |outline: Outline| outline.is_hit_by_rapid(point(0, 0), point(100, 40), Micrometres::ZERO);
        assert!(hit(near(70, 42)) && hit(near(20, 22)) && hit(near(70, 28)));
        assert!(!hit(near(70, 18)));
    }

    #[test]
    fn a_tool_hits_a_rectangle_within_its_radius() {
        let outline = Outline::Box(point(10, 10), point(20, 30));
        let hit = |from, to, radius| outline.is_hit(from, to, Micrometres::from_mm(radius));
        assert!(hit(point(0, 20), point(40, 20), 0), "through it");
        assert!(hit(point(15, 20), point(15, 20), 0), "down on it");
        assert!(!hit(point(0, 5), point(40, 5), 5) && hit(point(0, 5), point(40, 5), 6), "past its side");
        assert!(!hit(point(0, 0), point(7, 6), 5) && hit(point(0, 0), point(7, 7), 5), "near its corner");
    }
}
