//! The path of a tool with a round nose: a contour as the reference point of the tool meets it.
//!
//! While the nose, a circle of radius r, touches a contour from outside, its centre is on the offset of the contour
//! at r, and the reference point one [`Tip`] away from there. So the offset, moved by the tip, is for the reference
//! point what the contour is for the nose: a point outside it is free, and a toolpath along it cuts exactly the
//! contour, except where an inner corner is tighter than r. Cylinders and faces that rise towards the chuck do not
//! move; cones and arcs do.
//!
//! Blank and contour are both converted in this way, and every toolpath over them is then free of gouges by
//! construction. The proof of turning does not use this.

use crate::turning::allowances::{EquidistantError, Over, equidistant_over};
use crate::turning::contour::{Contour, Curve, Piece, Side, Turn};
use crate::turning::jobs::Tip;
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

/// A contour that does not end on the axis is extended straight by so many radii before it is offset, so that its end
/// is that of a longer contour: beyond the blank the nose rolls over no corner.
const BEYOND: f64 = 4.0;

/// A round nose and the reference point beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nose {
    /// Its radius r.
    pub radius: Half,
    /// The position of the reference point.
    pub tip: Tip,
}

impl Nose {
    /// A monotone contour as the reference point meets it, over the same range of Z. It may extend beyond the axis by
    /// r: a face is clean when the centre of the nose is on the axis.
    ///
    /// # Errors
    /// The contour has no offset at r.
    pub fn seen(&self, contour: &Contour) -> Result<Contour, EquidistantError> {
        self.met(contour, false)
    }

    /// The same for a finishing pass: over a step that is lower than r the nose rolls.
    ///
    /// # Errors
    /// The contour has no offset at r.
    pub fn finished(&self, contour: &Contour) -> Result<Contour, EquidistantError> {
        self.met(contour, true)
    }

    fn met(&self, contour: &Contour, rolls: bool) -> Result<Contour, EquidistantError> {
        let (Some(start), Some(end)) = (contour.start(), contour.end()) else { return Ok(contour.clone()) };
        if self.radius == Half::ZERO {
            return Ok(contour.clone());
        }
        let longer = self.extended(contour);
        let offset = equidistant_over(&longer, &vec![self.radius; longer.pieces.len()])?;
        let offset =
            if rolls { self.over_low_steps(&longer, &offset) } else { offset.iter().map(|over| over.piece).collect() };
        let tip = self.tip.of(self.radius);
        let pieces = offset.iter().map(|piece| piece.mapped(false, |point| point.moved(tip)));
        let moved = Contour { side: contour.side, pieces: pieces.collect() };
        Ok(self.within(&moved, start, end))
    }

    /// The offset with the nose rolling over each step that is lower than its radius: it never touches the face of such a step, only
    /// the edge. Along the offset of the face it would leave r − √(r² − (r − h)²) before the edge of a step of the height h.
    fn over_low_steps(&self, contour: &Contour, offset: &[Over]) -> Vec<Piece> {
        let mut pieces: Vec<Piece> = offset.iter().map(|over| over.piece).collect();
        for at in 1..offset.len().saturating_sub(1) {
            let [Some(before), Some(step), Some(behind)] = [at - 1, at, at + 1].map(|at| offset.get(at)) else {
                continue;
            };
            if before.of + 1 != step.of || step.of + 1 != behind.of {
                continue;
            }
            let (Some(face), Some(next)) = (contour.pieces.get(step.of), contour.pieces.get(behind.of)) else {
                continue;
            };
            let Some(from) = pieces.get(at - 1).copied() else { continue };
            let Some([first, over, last]) = self.rolled(contour.side, from, face, behind.piece, next) else { continue };
            for (at, piece) in [(at - 1, first), (at, over), (at + 1, last)] {
                if let Some(own) = pieces.get_mut(at) {
                    *own = piece;
                }
            }
        }
        pieces
    }

    /// The way of the centre along a line, over the edge of the low step behind it, and along the line behind that.
    fn rolled(&self, side: Side, from: Piece, step: &Piece, behind: Piece, next: &Piece) -> Option<[Piece; 3]> {
        let rise = step.to.radius - step.from.radius;
        let (height, turn) = match side {
            Side::Outer => (rise, Turn::Right),
            Side::Inner => (Half::ZERO - rise, Turn::Left),
        };
        let lines = [from, behind, *next].iter().all(|piece| piece.curve == Curve::Line && !piece.is_face());
        if !step.is_face() || !lines || height <= Half::ZERO || height >= self.radius {
            return None;
        }
        let (edge, radius) = (step.to.vector(), self.radius.to_mm());
        // Where the nose meets the edge: the line enters the circle round it.
        let (along, to_edge) = (from.chord().unit(), edge.minus(from.from.vector()));
        let (foot, off) = (to_edge.dot(along), to_edge.cross(along));
        let meets = foot - libm::sqrt(radius * radius - off * off);
        // Where it leaves the edge: upright over the line behind.
        let direction = next.direction_at_start();
        let normal = if side == Side::Outer { direction.left() } else { direction.left().times(-1.0) };
        let leaves = edge.plus(normal.times(radius));
        let (first, last) = (from.from.moved(along.times(meets)), Point::at(leaves));
        let within = meets > 0.0 && last.z < behind.to.z && first.z < last.z;
        within.then(|| {
            [
                from.between(from.from, first),
                Piece::arc(first, last, self.radius, turn),
                behind.between(last, behind.to),
            ]
        })
    }

    /// The contour with straight ends: a line at an end is extended, an arc is followed by a line.
    fn extended(&self, contour: &Contour) -> Contour {
        let mut pieces = contour.pieces.clone();
        let reach = BEYOND * self.radius.to_mm();
        if let Some(first) = pieces.first_mut().filter(|first| !first.is_face() && first.from.radius > Half::ZERO) {
            let from = beyond(first.from, first.direction_at_start().times(-reach));
            if first.curve == Curve::Line {
                first.from = from;
            } else {
                let line = Piece::line(from, first.from);
                pieces.insert(0, line);
            }
        }
        if let Some(last) = pieces.last_mut().filter(|last| last.to.radius > Half::ZERO) {
            let to = beyond(last.to, last.direction_at_end().times(reach));
            if last.curve == Curve::Line {
                last.to = to;
            } else {
                let line = Piece::line(last.to, to);
                pieces.push(line);
            }
        }
        Contour { side: contour.side, pieces }
    }

    /// The range of Z of the contour. Faces at its ends stay.
    fn within(&self, moved: &Contour, start: Point, end: Point) -> Contour {
        let mut pieces = Vec::new();
        for piece in &moved.pieces {
            if piece.is_face() {
                if (start.z..=end.z).contains(&piece.from.z) {
                    pieces.push(*piece);
                }
                continue;
            }
            let (from, to) = (piece.from.z.max(start.z), piece.to.z.min(end.z));
            if from >= to {
                continue;
            }
            let at = |z: Half, own: Point| if z == own.z { Some(own) } else { piece.at_z(z).first().copied() };
            if let (Some(from), Some(to)) = (at(from, piece.from), at(to, piece.to)) {
                pieces.push(piece.between(from, to));
            }
        }
        // A face at the end does not become longer.
        if let Some(last) = pieces.last_mut().filter(|last| last.is_face()) {
            let rises = last.to.radius > last.from.radius;
            last.to.radius = if rises { last.to.radius.min(end.radius) } else { last.to.radius.max(end.radius) };
        }
        pieces.retain(|piece| !piece.is_nothing());
        Contour { side: moved.side, pieces }
    }
}

/// A bore whose bottom is followed only down to this distance from the axis; the rest stays.
#[must_use]
pub fn up_to(mut bore: Contour, nearest: Option<Half>) -> Contour {
    let Some(nearest) = nearest.filter(|_| bore.side == Side::Inner) else { return bore };
    if let Some(bottom) = bore.pieces.last_mut().filter(|last| last.is_face() && last.to.radius < nearest) {
        bottom.to.radius = nearest.min(bottom.from.radius);
    }
    bore.pieces.retain(|piece| !piece.is_nothing());
    bore
}

/// A point moved along the axis and not beyond it: an extended cone ends on the axis.
fn beyond(from: Point, by: Vector) -> Point {
    let radius = from.radius.to_mm();
    let share = if by.radius < -radius { radius / -by.radius } else { 1.0 };
    from.moved(by.times(share))
}

/// The least radius of the concave arcs of a contour: a nose with a larger radius does not reach all of it. None without
/// such arcs. Sharp inner corners do not count, because no nose reaches them.
pub fn tightest(contour: &Contour) -> Option<Half> {
    let hollow = contour.pieces.iter().filter_map(|piece| match piece.curve {
        Curve::Arc { radius, turn }
            if (turn == crate::turning::contour::Turn::Left) == (contour.side == Side::Outer) =>
        {
            Some(radius)
        }
        _ => None,
    });
    hollow.min()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::Turn;
    use crate::turning::point::at;

    const RIGHT: Tip = Tip { radial: -1, axial: 1 };
    const BORING: Tip = Tip { radial: 1, axial: 1 };

    fn nose(radius: f64, tip: Tip) -> Nose {
        Nose { radius: Half::from(radius), tip }
    }

    /// The tangents to the nose along and across the axis meet in the reference point, so cylinders and faces stay.
    #[test]
    fn a_stepped_shaft_is_seen_as_it_is() {
        let points = [at(10.0, 0.0), at(10.0, 20.0), at(15.0, 20.0), at(15.0, 40.0)];
        let shaft = Contour::through(Side::Outer, &points);
        assert_eq!(nose(0.8, RIGHT).seen(&shaft).unwrap(), shaft);
        let bore = Contour::through(Side::Inner, &[at(15.0, 0.0), at(15.0, 20.0), at(10.0, 20.0), at(10.0, 40.0)]);
        assert_eq!(nose(0.4, BORING).seen(&bore).unwrap(), bore);
    }

    /// A face that begins on the axis is clean when the centre of the nose is on the axis: X −2r on the diameter.
    #[test]
    fn a_face_ends_one_radius_beyond_the_axis() {
        let pin = Contour::through(Side::Outer, &[at(0.0, 0.0), at(10.0, 0.0), at(10.0, 20.0)]);
        let seen = nose(0.8, RIGHT).seen(&pin).unwrap();
        assert_eq!(seen.corners(), [at(-0.8, 0.0), at(10.0, 0.0), at(10.0, 20.0)]);
    }

    /// By hand, a cone that falls by β = 28.6° (5.4522 over 10) with r = 0.8: its normal leans back by β, so the line
    /// moves along it by r, and the reference point by (−r, r) more: off the cone by r·(1 − cos β + sin β) = 0.4806 mm
    /// to the outside, which is 0.5474 on the radius.
    #[test]
    fn a_falling_cone_moves_outwards_and_a_rising_one_inwards() {
        let cone = Contour::through(Side::Outer, &[at(25.0, 0.0), at(25.0 - 5.4522, 10.0)]);
        let seen = nose(0.8, RIGHT).seen(&cone).unwrap();
        let radius = seen.radii_at(Half::from(5.0)).unwrap().0.to_mm();
        assert!((radius - (25.0 - 2.7261 + 0.5474)).abs() < 0.001, "{radius}");
        // Rising by 45°: off by r·(1 − cos 45° − sin 45°) = −0.3314, on the radius −0.4686.
        let cone = Contour::through(Side::Outer, &[at(10.0, 0.0), at(20.0, 10.0)]);
        let seen = nose(0.8, RIGHT).seen(&cone).unwrap();
        let radius = seen.radii_at(Half::from(5.0)).unwrap().0.to_mm();
        assert!((radius - (15.0 - 0.4686)).abs() < 0.001, "{radius}");
    }

    /// By hand for r 0.8 and a step of 0.25: the centre at the height r over the cylinder meets the edge √(r² − (r − h)²) = 0.5809
    /// before the face, so the reference point, r further towards the chuck, turns off 0.2191 behind it, and is r behind it on top.
    #[test]
    fn a_step_lower_than_the_nose_is_rolled_over() {
        let shaft = Contour::through(Side::Outer, &[at(20.0, 0.0), at(20.0, 20.0), at(20.25, 20.0), at(20.25, 40.0)]);
        let seen = nose(0.8, RIGHT).finished(&shaft).unwrap();
        assert_eq!(seen.corners(), [at(20.0, 0.0), at(20.0, 20.219), at(20.25, 20.8), at(20.25, 40.0)]);
        assert!(matches!(seen.pieces[1].curve, Curve::Arc { turn: Turn::Right, .. }));
        let bore = Contour::through(Side::Inner, &[at(20.25, 0.0), at(20.25, 20.0), at(20.0, 20.0), at(20.0, 40.0)]);
        let seen = nose(0.8, BORING).finished(&bore).unwrap();
        assert_eq!(seen.corners(), [at(20.25, 0.0), at(20.25, 20.219), at(20.0, 20.8), at(20.0, 40.0)]);
        assert!(matches!(seen.pieces[1].curve, Curve::Arc { turn: Turn::Left, .. }));
    }

    /// The middle of a fillet stays, and its radius is less by r.
    #[test]
    fn a_fillet_is_seen_smaller_by_the_nose() {
        let mut pin = Contour::through(Side::Outer, &[at(10.0, 0.0), at(10.0, 20.0)]);
        pin.pieces.push(Piece::arc(at(10.0, 20.0), at(15.0, 25.0), Half::from(5.0), Turn::Left));
        pin.pieces.push(Piece::line(at(15.0, 25.0), at(25.0, 25.0)));
        let seen = nose(0.8, RIGHT).seen(&pin).unwrap();
        let corners = [at(10.0, 0.0), at(10.0, 20.8), at(14.2, 25.0), at(25.0, 25.0)];
        assert_eq!(seen.corners(), corners);
        assert_eq!(tightest(&pin), Some(Half::from(5.0)));
    }
}
