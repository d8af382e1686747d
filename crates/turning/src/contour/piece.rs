//! A piece of a contour: a straight line or an arc between two exact points.

use serde::Serialize;

use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

/// The side to which an arc bends, seen along it with Z to the right and the radius upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Turn {
    /// Counter-clockwise: on an outer contour from the free end a concave arc, such as a fillet.
    Left,
    /// Clockwise: on an outer contour from the free end a convex arc, such as a ball.
    Right,
}

impl Turn {
    /// The other side.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// The curve of a piece between its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Curve {
    /// A straight line.
    Line,
    /// An arc of at most half a circle.
    Arc {
        /// Its radius, at least half the distance of its ends.
        #[serde(rename = "radius_mm")]
        radius: Half,
        /// To which side it bends.
        turn: Turn,
    },
}

/// A line or an arc from one point to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Piece {
    /// Where it begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// Its curve.
    pub curve: Curve,
}

impl Piece {
    /// A straight line.
    pub const fn line(from: Point, to: Point) -> Self {
        Self { from, to, curve: Curve::Line }
    }

    /// An arc of at most half a circle.
    pub const fn arc(from: Point, to: Point, radius: Half, turn: Turn) -> Self {
        Self { from, to, curve: Curve::Arc { radius, turn } }
    }

    /// The same piece in the other direction.
    #[must_use]
    pub const fn reversed(self) -> Self {
        let curve = match self.curve {
            Curve::Line => Curve::Line,
            Curve::Arc { radius, turn } => Curve::Arc { radius, turn: turn.other() },
        };
        Self { from: self.to, to: self.from, curve }
    }

    /// Perpendicular to the axis: a face.
    pub fn is_face(self) -> bool {
        self.curve == Curve::Line && self.from.z == self.to.z
    }

    /// Parallel to the axis: a cylinder.
    pub fn is_cylinder(self) -> bool {
        self.curve == Curve::Line && self.from.radius == self.to.radius
    }

    /// Without any length.
    pub fn is_nothing(self) -> bool {
        self.from == self.to
    }

    /// From its beginning straight to its end.
    pub fn chord(self) -> Vector {
        self.from.to(self.to)
    }

    /// The centre of an arc, as a vector from zero; none for a line. If rounding left the radius slightly less than
    /// half the chord, it is the middle of the chord.
    pub fn centre(self) -> Option<Vector> {
        let Curve::Arc { radius, turn } = self.curve else { return None };
        let chord = self.chord();
        let half = chord.length() / 2.0;
        let height = libm::sqrt((radius.to_mm() * radius.to_mm() - half * half).max(0.0));
        let towards = match turn {
            Turn::Left => chord.unit().left(),
            Turn::Right => chord.unit().left().times(-1.0),
        };
        Some(self.from.vector().plus(chord.times(0.5)).plus(towards.times(height)))
    }

    /// Its direction at its beginning, 1 mm long.
    pub fn direction_at_start(self) -> Vector {
        self.direction_at(self.from)
    }

    /// Its direction at its end, 1 mm long.
    pub fn direction_at_end(self) -> Vector {
        self.direction_at(self.to)
    }

    /// Its direction at a point of it, 1 mm long.
    pub fn direction_at(self, point: Point) -> Vector {
        match (self.curve, self.centre()) {
            (Curve::Arc { turn, .. }, Some(centre)) => {
                let spoke = point.vector().minus(centre).unit();
                match turn {
                    Turn::Left => spoke.left(),
                    Turn::Right => spoke.left().times(-1.0),
                }
            }
            _ => self.chord().unit(),
        }
    }

    /// Its length along itself, mm.
    pub fn length_mm(self) -> f64 {
        let chord = self.chord().length();
        match self.curve {
            Curve::Line => chord,
            Curve::Arc { radius, .. } => {
                let radius = radius.to_mm();
                2.0 * radius * libm::asin((chord / 2.0 / radius.max(f64::MIN_POSITIVE)).min(1.0))
            }
        }
    }

    /// The point so far along it from its beginning, mm.
    pub fn at_length(self, length: f64) -> Point {
        match (self.curve, self.centre()) {
            (Curve::Arc { radius, turn }, Some(centre)) => {
                let sign = if turn == Turn::Left { 1.0 } else { -1.0 };
                let angle = sign * length / radius.to_mm().max(f64::MIN_POSITIVE);
                Point::at(centre.plus(self.from.vector().minus(centre).turned(angle)))
            }
            _ => self.from.moved(self.chord().unit().times(length)),
        }
    }

    /// Its outermost points in each direction: its ends, and points where an arc is horizontal or vertical.
    pub fn extremes(self) -> Vec<Point> {
        let mut points = vec![self.from, self.to];
        if let (Curve::Arc { radius, .. }, Some(centre)) = (self.curve, self.centre()) {
            let radius = radius.to_mm();
            for spoke in [
                Vector::new(radius, 0.0),
                Vector::new(-radius, 0.0),
                Vector::new(0.0, radius),
                Vector::new(0.0, -radius),
            ] {
                let point = Point::at(centre.plus(spoke));
                if self.holds(point) {
                    points.push(point);
                }
            }
        }
        points
    }

    /// The least and the greatest radius of it.
    pub fn radii(self) -> (Half, Half) {
        let radii = self.extremes().into_iter().map(|point| (point.radius, point.radius));
        radii.fold((self.from.radius, self.from.radius), both)
    }

    /// Whether a point of its line or circle lies between its ends.
    pub fn holds(self, point: Point) -> bool {
        let (before, after) = (self.from.to(point), point.to(self.to));
        match self.curve {
            Curve::Line => self.chord().dot(before) >= 0.0 && self.chord().dot(after) >= 0.0,
            // An arc is at most half a circle, so its points lie on the convex side of the chord.
            Curve::Arc { turn: Turn::Left, .. } => self.chord().cross(before) <= 0.0,
            Curve::Arc { turn: Turn::Right, .. } => self.chord().cross(before) >= 0.0,
        }
    }

    /// Where it crosses or touches the horizontal of a radius, in its own order; for a cylinder on that radius, both
    /// ends.
    pub fn at_radius(self, radius: Half) -> Vec<Point> {
        self.crossings(
            radius,
            |point| point.radius,
            |radius, z| Point { radius, z },
            |vector| (vector.radius, vector.z),
        )
    }

    /// Where it crosses or touches the vertical of a Z, in its own order; for a face at that Z, both ends.
    pub fn at_z(self, z: Half) -> Vec<Point> {
        self.crossings(z, |point| point.z, |z, radius| Point { radius, z }, |vector| (vector.z, vector.radius))
    }

    /// Crossings on either axis; `level` is a value of the coordinate `first`.
    fn crossings(
        self,
        level: Half,
        first: impl Fn(Point) -> Half,
        point: impl Fn(Half, Half) -> Point,
        parts: impl Fn(Vector) -> (f64, f64),
    ) -> Vec<Point> {
        let (from, to) = (first(self.from), first(self.to));
        let mut points = Vec::new();
        match (self.curve, self.centre()) {
            (Curve::Arc { radius, .. }, Some(centre)) => {
                let (along, across) = parts(centre);
                let off = level.to_mm() - along;
                let inside = radius.to_mm() * radius.to_mm() - off * off;
                if inside >= 0.0 {
                    let half = libm::sqrt(inside);
                    for other in [across - half, across + half] {
                        let at = point(level, Half::from(other));
                        if self.holds(at) {
                            points.push(at);
                        }
                    }
                }
                // The ends are exact, the circle through them is not.
                for end in [self.from, self.to] {
                    if first(end) == level {
                        points.retain(|at| at.to(end).length() > 0.01);
                        points.push(end);
                    }
                }
            }
            _ if from == level && to == level => points.extend([self.from, self.to]),
            _ if (from <= level && level <= to) || (to <= level && level <= from) => {
                let share = (level - from).to_mm() / (to - from).to_mm();
                let at = self.from.moved(self.chord().times(share));
                let (_, other) = parts(at.vector());
                points.push(point(level, Half::from(other)));
            }
            _ => {}
        }
        points.sort_by(|a, b| self.from.to(*a).length().total_cmp(&self.from.to(*b).length()));
        points.dedup();
        points
    }

    /// The part between two of its points, in its own direction.
    #[must_use]
    pub const fn between(self, from: Point, to: Point) -> Self {
        Self { from, to, curve: self.curve }
    }

    /// The piece with each point mapped. An arc bends to the other side if the mapping mirrors.
    #[must_use]
    pub fn mapped(self, mirrors: bool, place: impl Fn(Point) -> Point) -> Self {
        let curve = match self.curve {
            Curve::Arc { radius, turn } if mirrors => Curve::Arc { radius, turn: turn.other() },
            curve => curve,
        };
        Self { from: place(self.from), to: place(self.to), curve }
    }

    /// Inside out: radii count inwards from `top`.
    #[must_use]
    pub fn inside_out(self, top: Half) -> Self {
        self.mapped(true, |point| point.inside_out(top))
    }
}

/// The smaller of two minima and the greater of two maxima.
pub(super) fn both(one: (Half, Half), other: (Half, Half)) -> (Half, Half) {
    (one.0.min(other.0), one.1.max(other.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::at;

    /// A quarter fillet of 5 from a cylinder of radius 20 into a face: its centre is 5 outwards of its beginning.
    #[test]
    fn a_fillet_turns_left_about_a_centre_above_it() {
        let fillet = Piece::arc(at(20.0, 10.0), at(25.0, 15.0), Half::from(5.0), Turn::Left);
        assert_eq!(Point::at(fillet.centre().unwrap()), at(25.0, 10.0));
        assert!((fillet.length_mm() - 5.0 * std::f64::consts::FRAC_PI_2).abs() < 1e-9);
        assert!((fillet.direction_at_start().degrees()).abs() < 1e-6);
        assert!((fillet.direction_at_end().degrees() - 90.0).abs() < 1e-6);
        // By the triangle 3-4-5: 1 outwards of the lowest point is 3 along.
        assert_eq!(fillet.at_radius(Half::from(21.0)), [at(21.0, 13.0)]);
        assert_eq!(fillet.at_z(Half::from(14.0)), [at(22.0, 14.0)]);
    }

    /// Half a ball of 10 from axis to axis: convex, outermost in its middle.
    #[test]
    fn a_ball_turns_right_and_is_crossed_twice() {
        let ball = Piece::arc(at(0.0, 0.0), at(0.0, 20.0), Half::from(10.0), Turn::Right);
        assert_eq!(ball.at_radius(Half::from(8.0)), [at(8.0, 4.0), at(8.0, 16.0)]);
        assert!(ball.extremes().contains(&at(10.0, 10.0)));
        assert_eq!(ball.reversed().at_radius(Half::from(8.0)), [at(8.0, 16.0), at(8.0, 4.0)]);
        assert_eq!(ball.at_radius(Half::from(10.5)), []);
    }

    #[test]
    fn a_line_is_crossed_where_it_is() {
        let cone = Piece::line(at(10.0, 0.0), at(20.0, 5.0));
        assert_eq!(cone.at_radius(Half::from(12.0)), [at(12.0, 1.0)]);
        let cylinder = Piece::line(at(10.0, 0.0), at(10.0, 5.0));
        assert_eq!(cylinder.at_radius(Half::from(10.0)), [at(10.0, 0.0), at(10.0, 5.0)]);
        assert_eq!(cylinder.at_z(Half::from(2.0)), [at(10.0, 2.0)]);
    }
}
