//! The shape of grooves: walls, floor and rounded corners, from their sizes.
//!
//! A groove is made in a frame of its own, `along` its mouth and `into` the metal, and then placed on the contour.

use super::item_file::GrooveKind;
use crate::turning::contour::{Curve, Piece, SurfaceKind, Turn};
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

impl GrooveKind {
    /// The surface that it makes.
    pub const fn surface(self) -> SurfaceKind {
        match self {
            Self::GrindingRelief | Self::Corner => SurfaceKind::GrindingRelief,
            Self::ThreadRelief => SurfaceKind::ThreadRelief,
            Self::Rectangular => SurfaceKind::RectangularGroove,
            Self::Trapezoid => SurfaceKind::TrapezoidGroove,
            Self::Pulley => SurfaceKind::PulleyGroove,
            Self::Face => SurfaceKind::FaceGroove,
        }
    }

    /// Whether it needs the angle between its walls.
    pub const fn has_angle(self) -> bool {
        matches!(self, Self::Trapezoid | Self::Pulley)
    }

    /// Whether its corners must be rounded.
    pub const fn needs_radius(self) -> bool {
        matches!(self, Self::Pulley)
    }
}

/// The sizes of a groove.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes {
    pub kind: GrooveKind,
    pub width: Half,
    pub depth: Half,
    /// Rounding of the corners of the floor; if none, they are sharp.
    pub radius: Option<Half>,
    /// The tangent of half the angle between the walls; 0 if they are upright.
    pub slant: f64,
    /// Whether the shoulder is at the beginning, so that the 45° of a relief are at its end.
    pub shoulder_first: bool,
}

/// The place of a groove on the contour: its beginning, whether its mouth is parallel or perpendicular to the axis,
/// its direction, and the side of the metal.
#[derive(Clone, Copy, Debug)]
pub(super) struct GrooveFrame {
    pub at: Point,
    /// Whether the mouth is parallel to the axis.
    pub on_cylinder: bool,
    /// Across the axis for a mouth on a face, and into the metal for one on a cylinder: +1 outwards, −1 inwards.
    pub radial: i64,
    /// Into the metal for a mouth on a face: +1 towards the chuck, −1 towards the free end. On a cylinder always +1.
    pub axial: i64,
    /// The turn of concave arcs.
    pub hollow: Turn,
}

impl GrooveFrame {
    fn place(self, along: Half, into: Half) -> Point {
        let times = |sign: i64, length: Half| Half::new(sign * length.halves());
        let (radius, z) = if self.on_cylinder { (into, along) } else { (along, into) };
        Point { radius: self.at.radius + times(self.radial, radius), z: self.at.z + times(self.axial, z) }
    }
}

/// The pieces of a groove.
///
/// # Errors
/// The code of the mistake: its walls meet above the floor, or the rounding is too large for it.
pub(super) fn pieces(sizes: Sizes, frame: GrooveFrame) -> Result<Vec<Piece>, &'static str> {
    let (width, depth) = (sizes.width, sizes.depth);
    let at = |along, into| frame.place(along, into);
    let start = at(Half::ZERO, Half::ZERO);
    let (corners, end) = match sizes.kind {
        GrooveKind::Corner => {
            if depth >= width {
                return Err("groove-walls-meet");
            }
            let back = Half::ZERO - width;
            // Along the cylinder, into the corner and a depth behind the face, and out along it.
            let corners = vec![at(depth, depth), at(width + depth, depth), at(width + depth, back + depth)];
            (corners, at(width, back))
        }
        kind => {
            let inset = match kind {
                GrooveKind::GrindingRelief | GrooveKind::ThreadRelief => depth,
                _ => Half::from(depth.to_mm() * sizes.slant),
            };
            let relief = matches!(kind, GrooveKind::GrindingRelief | GrooveKind::ThreadRelief);
            let first = if relief && sizes.shoulder_first { Half::ZERO } else { inset };
            let last = if relief && !sizes.shoulder_first { Half::ZERO } else { inset };
            if first + last > width {
                return Err("groove-walls-meet");
            }
            (vec![at(first, depth), at(width - last, depth)], at(width, Half::ZERO))
        }
    };
    rounded(start, &corners, end, sizes.radius, frame.hollow)
}

/// A chain of lines with rounded corners: tangent arcs, with ends rounded to half a micrometre.
fn rounded(
    start: Point,
    corners: &[Point],
    end: Point,
    radius: Option<Half>,
    hollow: Turn,
) -> Result<Vec<Piece>, &'static str> {
    let mut pieces = Vec::new();
    let mut from = start;
    for (index, corner) in corners.iter().enumerate() {
        let next = corners.get(index + 1).copied().unwrap_or(end);
        let (before, after) = (from.to(*corner), corner.to(next));
        let cut = radius.map_or(0.0, |radius| radius.to_mm() * half_turn(before, after));
        // Half a micrometre is allowed: both ends of a line are rounded.
        if cut > before.length() + 0.0005 || cut > after.length() + 0.0005 {
            return Err("groove-radius-too-large");
        }
        let (into, out) = (corner.moved(before.unit().times(-cut)), corner.moved(after.unit().times(cut)));
        pieces.push(Piece::line(from, into));
        if let Some(radius) = radius.filter(|_| into != out) {
            pieces.push(Piece { from: into, to: out, curve: Curve::Arc { radius, turn: hollow } });
        }
        from = if radius.is_some() { out } else { *corner };
    }
    pieces.push(Piece::line(from, end));
    pieces.retain(|piece| !piece.is_nothing());
    Ok(pieces)
}

/// The tangent of half the angle at a corner: a tangent arc of radius r begins r times it before the corner.
fn half_turn(before: Vector, after: Vector) -> f64 {
    let angle = libm::atan2(before.cross(after).abs(), before.dot(after));
    libm::tan(angle / 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::at;

    fn sizes(kind: GrooveKind, width: f64, depth: f64) -> Sizes {
        Sizes {
            kind,
            width: Half::from(width),
            depth: Half::from(depth),
            radius: None,
            slant: 0.0,
            shoulder_first: false,
        }
    }

    /// On a cylinder of radius 20, from Z 10.
    fn outside() -> GrooveFrame {
        GrooveFrame { at: at(20.0, 10.0), on_cylinder: true, radial: -1, axial: 1, hollow: Turn::Left }
    }

    fn corners(pieces: &[Piece]) -> Vec<Point> {
        pieces.first().map(|piece| piece.from).into_iter().chain(pieces.iter().map(|piece| piece.to)).collect()
    }

    /// Worked by hand from the sizes.
    #[test]
    fn walls_and_floors_stand_where_the_sizes_say() {
        let drawn = |sizes| corners(&pieces(sizes, outside()).unwrap());
        let rectangular = sizes(GrooveKind::Rectangular, 5.0, 3.0);
        assert_eq!(drawn(rectangular), [at(20.0, 10.0), at(17.0, 10.0), at(17.0, 15.0), at(20.0, 15.0)]);
        // Walls at 45°: on each side the floor is narrower by the depth of the groove.
        let trapezoid = Sizes { slant: 1.0, ..sizes(GrooveKind::Trapezoid, 8.0, 3.0) };
        assert_eq!(drawn(trapezoid), [at(20.0, 10.0), at(17.0, 13.0), at(17.0, 15.0), at(20.0, 18.0)]);
        let relief = sizes(GrooveKind::GrindingRelief, 3.0, 0.25);
        assert_eq!(drawn(relief), [at(20.0, 10.0), at(19.75, 10.25), at(19.75, 13.0), at(20.0, 13.0)]);
        let mirrored = Sizes { shoulder_first: true, ..relief };
        assert_eq!(drawn(mirrored), [at(20.0, 10.0), at(19.75, 10.0), at(19.75, 12.75), at(20.0, 13.0)]);
        let corner = sizes(GrooveKind::Corner, 2.0, 0.5);
        // A depth below the cylinder, a depth behind the face, and out of the face 2 above the cylinder.
        let expected = [at(20.0, 10.0), at(19.5, 10.5), at(19.5, 12.5), at(21.5, 12.5), at(22.0, 12.0)];
        assert_eq!(drawn(corner), expected);
    }

    #[test]
    fn a_face_is_grooved_along_the_axis() {
        let frame = GrooveFrame { at: at(10.0, 0.0), on_cylinder: false, radial: 1, axial: 1, hollow: Turn::Left };
        let drawn = corners(&pieces(sizes(GrooveKind::Face, 4.0, 2.0), frame).unwrap());
        assert_eq!(drawn, [at(10.0, 0.0), at(10.0, 2.0), at(14.0, 2.0), at(14.0, 0.0)]);
    }

    /// Upright walls: the arc is a quarter, and takes its radius off the wall and off the floor.
    #[test]
    fn corners_are_rounded_by_tangent_arcs() {
        let round = Sizes { radius: Some(Half::from(1.0)), ..sizes(GrooveKind::Rectangular, 5.0, 3.0) };
        let drawn = pieces(round, outside()).unwrap();
        assert_eq!(
            corners(&drawn),
            [at(20.0, 10.0), at(18.0, 10.0), at(17.0, 11.0), at(17.0, 14.0), at(18.0, 15.0), at(20.0, 15.0)]
        );
        assert_eq!(drawn[1].centre().map(Point::at), Some(at(18.0, 11.0)));
        let full = Sizes { radius: Some(Half::from(2.5)), ..round };
        assert_eq!(pieces(full, outside()).unwrap().len(), 4, "the two arcs meet, no floor is left");
        let large = Sizes { radius: Some(Half::from(2.6)), ..round };
        assert_eq!(pieces(large, outside()), Err("groove-radius-too-large"));
        let shallow = Sizes { slant: 2.0, ..sizes(GrooveKind::Trapezoid, 8.0, 3.0) };
        assert_eq!(pieces(shallow, outside()), Err("groove-walls-meet"));
    }

    /// A belt groove of 34°: the arc is tangent to wall and floor, within the rounding of its ends.
    #[test]
    fn arcs_are_tangent_to_slanting_walls() {
        let slant = libm::tan(17.0_f64.to_radians());
        let belt = Sizes { radius: Some(Half::from(1.0)), slant, ..sizes(GrooveKind::Pulley, 13.0, 10.8) };
        let drawn = pieces(belt, outside()).unwrap();
        for pair in drawn.windows(2) {
            let (out, into) = (pair[0].direction_at_end(), pair[1].direction_at_start());
            assert!(out.cross(into).abs() < 1e-3 && out.dot(into) > 0.0, "{pair:?}");
        }
    }
}
