//! The contour of a turned part or blank in the half section: a chain of lines and arcs.
//!
//! A contour runs from the free end towards the chuck. The metal is on its right, towards the axis, for an outer
//! contour, and on its left for a bore.

pub mod field;
pub mod piece;
pub mod resized;
pub mod surface;

use serde::Serialize;

use super::length::Half;
use super::point::Point;
pub use crate::tables::turning::part::Side;
pub use field::Field;
use piece::both;
pub use piece::{Curve, Piece, Turn};
pub use resized::{Resized, Slopes, resized};
pub use surface::{Profile, Surface, SurfaceKind, SurfaceName};

/// A chain of pieces: each begins where the one before it ends.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Contour {
    /// Where its metal lies.
    pub side: Side,
    /// Its pieces from the free end.
    pub pieces: Vec<Piece>,
}

impl Contour {
    /// Straight lines through points; lines without length are left out.
    pub fn through(side: Side, points: &[Point]) -> Self {
        let lines = points.iter().zip(points.iter().skip(1)).map(|(from, to)| Piece::line(*from, *to));
        Self { side, pieces: lines.filter(|piece| !piece.is_nothing()).collect() }
    }

    /// The face of the free end, as far as it begins with one that leads outwards, and the rest.
    pub fn split_at_face(&self) -> (&[Piece], &[Piece]) {
        let faces = self.pieces.iter().take_while(|piece| piece.is_face() && piece.to.radius > piece.from.radius);
        self.pieces.split_at(faces.count())
    }

    /// With the face of its end, from a radius outwards, where it begins with none.
    #[must_use]
    pub fn with_face(mut self, within: Half) -> Self {
        let begins = self.pieces.first().filter(|first| !first.is_face() && first.from.radius > within);
        if let Some(start) = begins.map(|first| first.from) {
            self.pieces.insert(0, Piece::line(Point { radius: within, z: start.z }, start));
        }
        self
    }

    /// Where it begins, at the free end.
    pub fn start(&self) -> Option<Point> {
        self.pieces.first().map(|piece| piece.from)
    }

    /// Where it ends, towards the chuck.
    pub fn end(&self) -> Option<Point> {
        self.pieces.last().map(|piece| piece.to)
    }

    /// Its ends and corners in order.
    pub fn corners(&self) -> Vec<Point> {
        self.start().into_iter().chain(self.pieces.iter().map(|piece| piece.to)).collect()
    }

    /// Whether each piece begins where the one before it ends.
    pub fn hangs_together(&self) -> bool {
        self.pieces.iter().zip(self.pieces.iter().skip(1)).all(|(one, next)| one.to == next.from)
    }

    /// Whether no piece runs back towards the free end, so that each Z has one radius, or a face.
    pub fn is_monotone(&self) -> bool {
        let forward = |piece: &Piece| {
            piece.to.z >= piece.from.z
                && piece.extremes().iter().all(|point| (piece.from.z..=piece.to.z).contains(&point.z))
        };
        self.pieces.iter().all(forward)
    }

    /// The whole pieces with a point between two Z, these included. The pieces must be in the order of Z.
    #[must_use]
    pub fn near(&self, from: Half, to: Half) -> Self {
        Self { side: self.side, pieces: touching(&self.pieces, from, to).to_vec() }
    }

    /// Whether it has only cylinders and faces.
    pub fn is_stepped(&self) -> bool {
        self.pieces.iter().all(|piece| piece.is_face() || piece.is_cylinder())
    }

    /// The least and the greatest radius at a Z. For a monotone contour they differ only on a face. None beyond its
    /// ends.
    pub fn radii_at(&self, z: Half) -> Option<(Half, Half)> {
        let points = self.pieces.iter().flat_map(|piece| piece.at_z(z));
        points.map(|point| (point.radius, point.radius)).reduce(both)
    }

    /// Where it crosses, touches or lies on the horizontal of a radius, in its own order. A point that two pieces share
    /// appears once.
    pub fn at_radius(&self, radius: Half) -> Vec<Point> {
        let mut points: Vec<Point> = self.pieces.iter().flat_map(|piece| piece.at_radius(radius)).collect();
        points.dedup();
        points
    }

    /// The least and the greatest radius of it anywhere.
    pub fn radii(&self) -> Option<(Half, Half)> {
        self.pieces.iter().map(|piece| piece.radii()).reduce(both)
    }

    /// The least radius of its walls: of all of it but the faces.
    pub fn narrowest(&self) -> Option<Half> {
        let walls = self.pieces.iter().filter(|piece| !piece.is_face());
        walls.flat_map(|piece| [piece.from.radius, piece.to.radius]).min()
    }

    /// The part turned over: Z = `length` becomes Z = 0, and the contour runs from the free end again.
    #[must_use]
    pub fn turned_over(&self, length: Half) -> Self {
        let place = |point: Point| Point { radius: point.radius, z: length - point.z };
        // Mirrored and reversed, an arc still bends to the same side.
        let pieces = self.pieces.iter().rev().map(|piece| piece.mapped(true, place).reversed()).collect();
        Self { side: self.side, pieces }
    }

    /// Inside out: radii count inwards from `top`. A bore becomes an outer contour and an outer contour a bore, so code
    /// for outer contours also works for bores.
    #[must_use]
    pub fn inside_out(&self, top: Half) -> Self {
        let side = match self.side {
            Side::Outer => Side::Inner,
            Side::Inner => Side::Outer,
        };
        Self { side, pieces: self.pieces.iter().map(|piece| piece.inside_out(top)).collect() }
    }
}

impl Half {
    /// A radius so much farther off the metal of a side: outwards outside, inwards in a bore.
    #[must_use]
    pub fn off(self, by: Self, side: Side) -> Self {
        match side {
            Side::Outer => self + by,
            Side::Inner => self - by,
        }
    }
}

/// The pieces with a point between two Z, these included. They must be in the order of Z.
pub fn touching(pieces: &[Piece], from: Half, to: Half) -> &[Piece] {
    let (_, ahead) = pieces.split_at(pieces.partition_point(|piece| piece.to.z < from));
    ahead.split_at(ahead.partition_point(|piece| piece.from.z <= to)).0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::at;

    /// A pin of radius 10 with a fillet of 5 into a flange of radius 30 with a chamfer of 2.
    fn pin() -> Contour {
        let mut pin = Contour::through(Side::Outer, &[at(0.0, 0.0), at(10.0, 0.0), at(10.0, 20.0)]);
        pin.pieces.push(Piece::arc(at(10.0, 20.0), at(15.0, 25.0), Half::from(5.0), Turn::Left));
        pin.pieces.push(Piece::line(at(15.0, 25.0), at(28.0, 25.0)));
        pin.pieces.push(Piece::line(at(28.0, 25.0), at(30.0, 27.0)));
        pin.pieces.push(Piece::line(at(30.0, 27.0), at(30.0, 40.0)));
        pin
    }

    #[test]
    fn a_contour_tells_its_radii_and_crossings() {
        let pin = pin();
        assert!(pin.hangs_together() && pin.is_monotone() && !pin.is_stepped());
        assert_eq!(pin.radii_at(Half::from(24.0)), Some((Half::from(12.0), Half::from(12.0))));
        assert_eq!(pin.radii_at(Half::from(25.0)), Some((Half::from(15.0), Half::from(28.0))));
        assert_eq!(pin.radii_at(Half::from(41.0)), None);
        assert_eq!(pin.at_radius(Half::from(12.0)), [at(12.0, 24.0)]);
        assert_eq!(pin.at_radius(Half::from(10.0)), [at(10.0, 0.0), at(10.0, 20.0)]);
    }

    #[test]
    fn turning_over_and_inside_out_twice_change_nothing() {
        let pin = pin();
        let over = pin.turned_over(Half::from(40.0));
        assert!(over.hangs_together());
        assert_eq!(over.radii_at(Half::from(16.0)), Some((Half::from(12.0), Half::from(12.0))));
        assert_eq!(over.turned_over(Half::from(40.0)), pin);
        let out = pin.inside_out(Half::from(50.0));
        assert_eq!(out.radii_at(Half::from(24.0)), Some((Half::from(38.0), Half::from(38.0))));
        assert_eq!(out.inside_out(Half::from(50.0)), pin);
    }
}
