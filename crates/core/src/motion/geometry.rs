//! Arcs in a plane: their angle, their length, and their extent.
//!
//! Positions are exact. Angles and lengths of arcs are floating point by `libm`, so that they are the same on every
//! machine.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{Axis, Motion, Plane, Position, Sense};
use crate::units::Micrometres;

/// A point of a plane, mm.
pub type Point = [f64; 2];

/// A position as a point of a plane.
pub fn in_plane(at: Position, plane: Plane) -> Point {
    let [a, b, _] = plane.axes();
    [at.get(a).to_mm(), at.get(b).to_mm()]
}

/// The distance of two points, mm.
pub fn distance(a: Point, b: Point) -> f64 {
    libm::hypot(b[0] - a[0], b[1] - a[1])
}

/// The angle of an arc from its start to its end, rad, always positive; a full turn if both are the same point.
pub fn sweep(from: Point, to: Point, centre: Point, sense: Sense) -> f64 {
    if from == to {
        return TAU;
    }
    let angle = |point: Point| libm::atan2(point[1] - centre[1], point[0] - centre[0]);
    let turned = match sense {
        Sense::Counterclockwise => angle(to) - angle(from),
        Sense::Clockwise => angle(from) - angle(to),
    };
    // Reduced to 0..2π.
    if turned < 0.0 { turned + TAU } else { turned }
}

/// The length of a motion, mm; zero for anything without motion.
///
/// A straight line by Pythagoras; an arc and a helix by their developed length.
pub fn length(motion: &Motion, from: Position, to: Position) -> f64 {
    match motion {
        Motion::Arc { plane, sense, centre, turns, .. } => {
            let centre = [centre[0].to_mm(), centre[1].to_mm()];
            let (start, end) = (in_plane(from, *plane), in_plane(to, *plane));
            let angle = sweep(start, end, centre, *sense) + TAU * f64::from(*turns);
            let across = plane.axes()[2];
            libm::hypot(angle * distance(start, centre), (to.get(across) - from.get(across)).to_mm())
        }
        Motion::Rapid | Motion::Feed { .. } => {
            let along = |axis| (to.get(axis) - from.get(axis)).to_mm();
            libm::hypot(libm::hypot(along(Axis::X), along(Axis::Y)), along(Axis::Z))
        }
        _ => 0.0,
    }
}

/// The least and greatest coordinate of a motion along every axis, without its start unless an arc passes it again.
pub fn reach(motion: &Motion, from: Position, to: Position) -> [(Micrometres, Micrometres); 3] {
    let mut reached = Axis::ALL.map(|axis| (to.get(axis), to.get(axis)));
    let Motion::Arc { plane, sense, centre, turns, .. } = motion else { return reached };
    let middle = [centre[0].to_mm(), centre[1].to_mm()];
    let (start, end) = (in_plane(from, *plane), in_plane(to, *plane));
    let radius = distance(start, middle);
    let swept = sweep(start, end, middle, *sense) + TAU * f64::from(*turns);
    let first = libm::atan2(start[1] - middle[1], start[0] - middle[0]);
    // The four quadrant points of a circle.
    for quarter in 0..4_i32 {
        let angle = f64::from(quarter) * FRAC_PI_2;
        let ahead = match sense {
            Sense::Counterclockwise => angle - first,
            Sense::Clockwise => first - angle,
        };
        let angle = if ahead < 0.0 { ahead + TAU } else { ahead };
        if angle > swept {
            continue;
        }
        let [a, b, _] = plane.axes();
        let (axis, value) = match quarter {
            0 => (a, middle[0] + radius),
            1 => (b, middle[1] + radius),
            2 => (a, middle[0] - radius),
            _ => (b, middle[1] - radius),
        };
        let value = Micrometres::from_mm_rounded(value);
        let (low, high) = &mut reached[axis.index()];
        *low = (*low).min(value);
        *high = (*high).max(value);
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MillimetresPerMinute;

    fn at(x: i64, y: i64) -> Position {
        Position::of([Micrometres::from_mm(x), Micrometres::from_mm(y), Micrometres::ZERO])
    }

    fn arc(centre: [i64; 2], sense: Sense) -> Motion {
        Motion::Arc {
            plane: Plane::Xy,
            sense,
            centre: centre.map(Micrometres::from_mm),
            turns: 0,
            feed_mm_per_min: MillimetresPerMinute(100.0),
        }
    }

    #[test]
    fn a_quarter_circle_reaches_no_further_than_its_ends_and_three_quarters_do() {
        let quarter = reach(&arc([0, 0], Sense::Counterclockwise), at(10, 0), at(0, 10));
        assert_eq!((quarter[0].0.to_mm(), quarter[1].1.to_mm()), (0.0, 10.0));
        let rest = reach(&arc([0, 0], Sense::Clockwise), at(10, 0), at(0, 10));
        assert_eq!((rest[0].0.to_mm(), rest[1].0.to_mm()), (-10.0, -10.0));
    }

    #[test]
    fn a_full_circle_is_two_pi_long() {
        let length = length(&arc([0, 0], Sense::Clockwise), at(10, 0), at(10, 0));
        assert!((length - 20.0 * std::f64::consts::PI).abs() < 1e-9);
    }
}
