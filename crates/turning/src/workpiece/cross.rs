//! Whether contours meet. Arcs are replaced by chains of chords within half a micrometre of them.

use crate::turning::contour::{Curve, Piece};
use crate::turning::length::Half;
use crate::turning::point::Point;

/// How far a chord may be from its arc, mm: the rounding of points.
const SAGITTA: f64 = 0.0005;
/// The most chords of one arc. Half circles from R 6000 mm on reach it; their chords are then farther from the arc.
const MOST_CHORDS: f64 = 6000.0;

/// The ends of a piece with points of its arc between them.
pub(super) fn flat(piece: Piece) -> Vec<Point> {
    let mut points = vec![piece.from];
    if let (Curve::Arc { radius, .. }, Some(centre)) = (piece.curve, piece.centre()) {
        let radius = radius.to_mm();
        let spoke = |point: Point| centre.times(-1.0).plus(point.vector());
        let (first, last) = (spoke(piece.from), spoke(piece.to));
        let swept = libm::atan2(first.cross(last), first.dot(last));
        // For half a circle the sign is uncertain; the direction of the arc decides it.
        let left = piece.direction_at_start().dot(first.left()) > 0.0;
        let swept = if left { swept.abs() } else { -swept.abs() };
        let step = 2.0 * libm::acos((1.0 - SAGITTA / radius).max(0.0));
        let chords = libm::ceil(swept.abs() / step).clamp(1.0, MOST_CHORDS);
        let mut index = 1.0;
        while index < chords {
            points.push(Point::at(centre.plus(first.turned(swept * index / chords))));
            index += 1.0;
        }
    }
    points.push(piece.to);
    points
}

/// The least and the greatest radius and Z of a piece.
fn room(points: &[Point]) -> Option<(Point, Point)> {
    let first = *points.first()?;
    Some(points.iter().fold((first, first), |(low, high), point| {
        (
            Point { radius: low.radius.min(point.radius), z: low.z.min(point.z) },
            Point { radius: high.radius.max(point.radius), z: high.z.max(point.z) },
        )
    }))
}

/// A chain of chords with its bounding box.
pub(super) struct Chain {
    points: Vec<Point>,
    room: Option<(Point, Point)>,
}

impl Chain {
    pub fn of(piece: Piece) -> Self {
        let points = flat(piece);
        let room = room(&points);
        Self { points, room }
    }

    /// Whether two chains have a point in common, other than common ends.
    pub fn meets(&self, other: &Self) -> bool {
        let (Some((low, high)), Some((other_low, other_high))) = (self.room, other.room) else { return false };
        let apart = |low: Half, high: Half, other_low: Half, other_high: Half| high < other_low || other_high < low;
        if apart(low.z, high.z, other_low.z, other_high.z)
            || apart(low.radius, high.radius, other_low.radius, other_high.radius)
        {
            return false;
        }
        let chords = |chain: &Self| -> Vec<(Point, Point)> {
            chain.points.iter().copied().zip(chain.points.iter().copied().skip(1)).collect()
        };
        let (ours, theirs) = (chords(self), chords(other));
        let (our_ends, their_ends) = (self.ends(), other.ends());
        ours.iter().any(|one| {
            theirs.iter().any(|two| {
                let shared = [one.0, one.1].into_iter().find(|point| {
                    [two.0, two.1].contains(point)
                        && our_ends.contains(&Some(*point))
                        && their_ends.contains(&Some(*point))
                });
                match shared {
                    Some(shared) => same_way(shared, *one, *two),
                    None => cross(*one, *two),
                }
            })
        })
    }

    fn ends(&self) -> [Option<Point>; 2] {
        [self.points.first().copied(), self.points.last().copied()]
    }
}

/// Twice the area of a triangle, positive if the third point is to the left.
fn area(a: Point, b: Point, c: Point) -> i128 {
    let part = |half: Half| i128::from(half.halves());
    part(b.z - a.z) * part(c.radius - a.radius) - part(b.radius - a.radius) * part(c.z - a.z)
}

/// Whether two chords with a common end leave it in the same direction.
fn same_way(shared: Point, one: (Point, Point), two: (Point, Point)) -> bool {
    let far = |chord: (Point, Point)| if chord.0 == shared { chord.1 } else { chord.0 };
    let (a, b) = (far(one), far(two));
    area(shared, a, b) == 0 && shared.to(a).dot(shared.to(b)) > 0.0
}

/// Whether two chords have a point in common; exact.
fn cross(one: (Point, Point), two: (Point, Point)) -> bool {
    let (a, b) = (area(one.0, one.1, two.0).signum(), area(one.0, one.1, two.1).signum());
    let (c, d) = (area(two.0, two.1, one.0).signum(), area(two.0, two.1, one.1).signum());
    if a == 0 && b == 0 {
        let between = |low: Half, high: Half, value: Half| (low.min(high)..=low.max(high)).contains(&value);
        let on = |chord: (Point, Point), point: Point| {
            between(chord.0.z, chord.1.z, point.z) && between(chord.0.radius, chord.1.radius, point.radius)
        };
        return on(one, two.0) || on(one, two.1) || on(two, one.0) || on(two, one.1);
    }
    a * b <= 0 && c * d <= 0
}

/// The indices of the first two pieces that meet other than at common ends.
pub(super) fn crossing(pieces: &[Piece]) -> Option<(usize, usize)> {
    let chains: Vec<Chain> = pieces.iter().map(|piece| Chain::of(*piece)).collect();
    chains.iter().enumerate().find_map(|(one, chain)| {
        let two = chains.iter().take(one).position(|other| other.meets(chain))?;
        Some((two, one))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::Turn;
    use crate::turning::point::at;

    #[test]
    fn chords_lie_on_the_arc_to_half_a_micrometre() {
        for (turn, sign) in [(Turn::Right, 1.0), (Turn::Left, -1.0)] {
            let arc = Piece::arc(at(20.0, 0.0), at(20.0, 20.0), Half::from(10.0), turn);
            let points = flat(arc);
            assert!(points.len() > 100);
            assert!(points.contains(&at(20.0 + sign * 10.0, 10.0)), "half a circle, {turn:?}");
            for point in &points {
                assert!((at(20.0, 10.0).to(*point).length() - 10.0).abs() < 0.0005);
            }
        }
    }

    #[test]
    fn pieces_may_share_ends_and_nothing_else() {
        let line = |a, b| Piece::line(a, b);
        let up = line(at(0.0, 0.0), at(10.0, 0.0));
        assert_eq!(crossing(&[up, line(at(10.0, 0.0), at(10.0, 5.0))]), None);
        assert_eq!(crossing(&[up, line(at(10.0, 0.0), at(5.0, 0.0))]), Some((0, 1)), "back along the face");
        assert_eq!(crossing(&[up, line(at(5.0, -1.0), at(5.0, 1.0))]), Some((0, 1)));
        assert_eq!(crossing(&[up, line(at(5.0, 0.0), at(5.0, 1.0))]), Some((0, 1)), "it touches");
        assert_eq!(crossing(&[up, line(at(5.0, 0.001), at(5.0, 1.0))]), None);
        // A tangent line leaves a fillet without meeting it again.
        let fillet = Piece::arc(at(10.0, 0.0), at(15.0, 5.0), Half::from(5.0), Turn::Left);
        assert_eq!(crossing(&[line(at(10.0, -9.0), at(10.0, 0.0)), fillet, line(at(15.0, 5.0), at(30.0, 5.0))]), None);
        // A chord beneath a ball meets it at both ends.
        let ball = Piece::arc(at(10.0, 0.0), at(10.0, 16.0), Half::from(10.0), Turn::Right);
        assert_eq!(crossing(&[ball, line(at(10.0, 16.0), at(10.0, 0.0))]), None, "they share both ends");
        assert_eq!(crossing(&[ball, line(at(10.0, 16.0), at(10.0, -1.0))]), Some((0, 1)));
    }
}
