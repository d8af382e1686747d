//! The three allowances of fig. 12.2 as areas: between the blank and the rough contour, over the additional elements,
//! and between the rough contour and the finished one.
//!
//! Each area lies between two contours of the half section. It has a size in the section and, turned about the axis, a
//! volume.

use serde::Serialize;

use crate::turning::contour::{Contour, Curve, Piece, Side, Turn};
use crate::turning::point::Point;

/// An area of the half section, mm².
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize)]
#[serde(transparent)]
pub struct SquareMillimetres(pub f64);

/// A volume of revolution, mm³.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize)]
#[serde(transparent)]
pub struct CubicMillimetres(pub f64);

/// What is removed between two contours.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Area {
    /// Its size in the half section, mm².
    pub area_mm2: SquareMillimetres,
    /// The volume of its ring, mm³.
    pub volume_mm3: CubicMillimetres,
    /// Its closed boundary, for drawings. It has no width where both contours touch.
    pub boundary: Vec<Piece>,
}

/// The three allowances of one side of the part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Areas {
    /// 1: between the blank and the rough contour.
    pub rough_main: Area,
    /// 2: between the main contour, which bridges the additional elements, and the part.
    pub additional: Area,
    /// 3: between the rough contour and the main contour.
    pub finish: Area,
}

/// The areas 1, 2 and 3 of one side, from contours of that side: the blank, its rough contour, the main contour with
/// its bridges, and the part.
///
/// The rough contour ends above the ends of the part, where the blank may go on. All contours are joined by straight
/// lines at their ends, so stock beyond the end (the rest in the chuck) counts only where the blank's own contour
/// includes it. In the lecture area 2 begins at the rough contour. Over a bridge that counts the finishing layer twice,
/// so here it begins at the main contour, and the three areas add up to everything between blank and part.
pub fn areas(blank: &Contour, rough: &Contour, main: &Contour, part: &Contour) -> Areas {
    Areas {
        rough_main: between(blank, &down_to(rough, blank)),
        additional: between(main, part),
        finish: between(rough, main),
    }
}

/// A rough contour from the radius at which its blank begins. The free end of a part with a bore is faced as far down as
/// the blank has metal, at the same Z.
fn down_to(rough: &Contour, blank: &Contour) -> Contour {
    let mut rough = rough.clone();
    let face = rough.pieces.first().copied().filter(|first| rough.side == Side::Outer && first.is_face());
    if let (Some(first), Some(start)) = (face, blank.start())
        && start.radius < first.from.radius
    {
        rough.pieces.insert(0, Piece::line(Point { radius: start.radius, z: first.from.z }, first.from));
    }
    rough
}

/// The area between two contours of one side with the same ends; `upper` is farther from the metal.
pub fn between(upper: &Contour, lower: &Contour) -> Area {
    let mut boundary: Vec<Piece> = upper.pieces.clone();
    let closing = |from: Option<Point>, to: Option<Point>| match (from, to) {
        (Some(from), Some(to)) if from != to => Some(Piece::line(from, to)),
        _ => None,
    };
    boundary.extend(closing(upper.end(), lower.end()));
    boundary.extend(lower.pieces.iter().rev().map(|piece| piece.reversed()));
    boundary.extend(closing(lower.start(), upper.start()));
    let sign = if upper.side == Side::Outer { 1.0 } else { -1.0 };
    let [area, volume] = [under, about].map(|of| sign * boundary.iter().map(|piece| of(*piece)).sum::<f64>());
    Area { area_mm2: SquareMillimetres(area), volume_mm3: CubicMillimetres(volume), boundary }
}

/// The area under a piece down to the axis, ∫ r dz, mm²; negative for a piece that runs towards the free end.
///
/// Under the chord it is a trapezium. Between chord and arc it is a segment of the circle, R²/2·(α − sin α), which is
/// subtracted for a left turn.
fn under(piece: Piece) -> f64 {
    let (from, to) = (piece.from.vector(), piece.to.vector());
    (to.z - from.z) * (from.radius + to.radius) / 2.0 + segment(piece).map_or(0.0, |segment| segment.area)
}

/// The volume under a piece turned about the axis, π ∫ r² dz, mm³; negative for a piece that runs towards the free end.
///
/// Under the chord it is a frustum, π·Δz·(r₁² + r₁r₂ + r₂²)/3. By Pappus, the segment adds its area times the path of
/// its centroid, which lies 4R·sin³(α/2)/(3(α − sin α)) from the centre of the arc.
fn about(piece: Piece) -> f64 {
    let (from, to) = (piece.from.vector(), piece.to.vector());
    let squares = from.radius * from.radius + from.radius * to.radius + to.radius * to.radius;
    let ring = segment(piece).map_or(0.0, |segment| 2.0 * segment.moment);
    std::f64::consts::PI * ((to.z - from.z) * squares / 3.0 + ring)
}

/// A segment of a circle between an arc and its chord.
struct Segment {
    /// Its area, mm²; negative for a left turn, which lies below its chord when it runs towards the chuck.
    area: f64,
    /// Its area times the radius of its centroid, mm³.
    moment: f64,
}

/// The segment of an arc; none for a line.
fn segment(piece: Piece) -> Option<Segment> {
    let (Curve::Arc { radius, turn }, Some(centre)) = (piece.curve, piece.centre()) else { return None };
    let (chord, radius) = (piece.chord(), radius.to_mm());
    let half = libm::asin((chord.length() / 2.0 / radius).min(1.0));
    let sign = if turn == Turn::Left { -1.0 } else { 1.0 };
    let (full, sine) = (2.0 * half, libm::sin(half));
    let area = sign * radius * radius / 2.0 * (full - libm::sin(full));
    // From the centre towards the arc. An arc that turns right lies to the left of its chord.
    let out = chord.unit().left().times(sign);
    let first = 2.0 / 3.0 * radius * radius * radius * sine * sine * sine;
    Some(Segment { area, moment: area * centre.radius + sign * first * out.radius })
}

#[cfg(test)]
mod tests {
    use crate::turning::point::at;
    use std::f64::consts::PI;

    use super::*;
    use crate::turning::allowances::equidistant;
    use crate::turning::length::Half;

    /// A bar over a length.
    fn bar(radius: Half, from: Half, to: Half) -> Contour {
        Contour::through(Side::Outer, &[Point::new(Half::ZERO, from), Point::new(radius, from), Point::new(radius, to)])
    }

    fn axis(length: f64) -> Contour {
        Contour::through(Side::Outer, &[at(0.0, 0.0), at(0.0, length)])
    }

    #[track_caller]
    fn is(area: &Area, mm2: f64, mm3: f64) {
        assert!((area.area_mm2.0 - mm2).abs() < 1e-6 * mm2.abs().max(1.0), "{:?}, not {mm2}", area.area_mm2);
        assert!((area.volume_mm3.0 - mm3).abs() < 1e-6 * mm3.abs().max(1.0), "{:?}, not {mm3}", area.volume_mm3);
    }

    /// Cylinder, cone, ball, hollow fillet and torus by the formulas of solid geometry.
    #[test]
    fn known_solids_have_their_volumes() {
        let cylinder = Contour::through(Side::Outer, &[at(10.0, 0.0), at(10.0, 30.0)]);
        is(&between(&cylinder, &axis(30.0)), 300.0, PI * 100.0 * 30.0);
        let cone = Contour::through(Side::Outer, &[at(0.0, 0.0), at(6.0, 8.0)]);
        is(&between(&cone, &axis(8.0)), 24.0, PI * 36.0 * 8.0 / 3.0);
        let half_circle = Piece::arc(at(0.0, 0.0), at(0.0, 20.0), Half::from(10.0), Turn::Right);
        let ball = Contour { side: Side::Outer, pieces: vec![half_circle] };
        is(&between(&ball, &axis(20.0)), PI * 50.0, 4.0 / 3.0 * PI * 1000.0);
        // Half a torus of radius 3 about a circle of radius 20: by Pappus πr²/2 at 20 + 4r/3π from the axis.
        let ring = Contour {
            side: Side::Outer,
            pieces: vec![Piece::arc(at(20.0, 0.0), at(20.0, 6.0), Half::from(3.0), Turn::Right)],
        };
        let base = Contour::through(Side::Outer, &[at(20.0, 0.0), at(20.0, 6.0)]);
        let size = PI * 4.5;
        is(&between(&ring, &base), size, size * 2.0 * PI * (20.0 + 4.0 / PI));
        // The same arc as a round groove.
        let groove = Contour {
            side: Side::Outer,
            pieces: vec![Piece::arc(at(20.0, 0.0), at(20.0, 6.0), Half::from(3.0), Turn::Left)],
        };
        is(&between(&base, &groove), size, size * 2.0 * PI * (20.0 - 4.0 / PI));
        // A bore of radius 8 widened to 10 over 15 mm.
        let [before, after] =
            [8.0, 10.0].map(|radius| Contour::through(Side::Inner, &[at(radius, 0.0), at(radius, 15.0)]));
        is(&between(&before, &after), 30.0, PI * (100.0 - 64.0) * 15.0);
    }

    /// A bush of Ø60 and Ø32 inside is faced from a bar by 28.3 mm: the whole bar goes, not a cone about its axis.
    #[test]
    fn a_face_about_a_bore_is_taken_down_to_the_axis() {
        let main = Contour::through(Side::Outer, &[at(16.0, 0.0), at(30.0, 0.0)]);
        let rough = Contour::through(Side::Outer, &[at(16.0, -0.7), at(30.0, -0.7)]);
        let blank = bar(Half::from(30.0), Half::from(-29.0), Half::from(-0.7));
        is(&areas(&blank, &rough, &main, &main).rough_main, 30.0 * 28.3, PI * 900.0 * 28.3);
    }

    /// A pin of Ø40 × 30 from a bar of Ø50 with a groove of 3 × 2; 0.5 is left on the diameter and 0.2 on the face.
    /// Worked by hand.
    #[test]
    fn the_three_allowances_of_a_grooved_pin() {
        let corners = [at(0.0, 0.0), at(20.0, 0.0), at(20.0, 10.0), at(18.0, 10.0), at(18.0, 13.0), at(20.0, 13.0)];
        let part = Contour::through(Side::Outer, &[corners.as_slice(), &[at(20.0, 30.0)]].concat());
        let main = Contour::through(Side::Outer, &[at(0.0, 0.0), at(20.0, 0.0), at(20.0, 30.0)]);
        let rough = equidistant(&main, &[Half::from(0.2), Half::from(0.25)]).unwrap();
        let blank = bar(Half::from(25.0), Half::from(-2.0), Half::from(30.0));
        let areas = areas(&blank, &rough, &main, &part);
        is(&areas.additional, 6.0, PI * (400.0 - 324.0) * 3.0);
        is(&areas.finish, 30.0 * 0.25 + 20.25 * 0.2, PI * (20.25 * 20.25 * 30.2 - 400.0 * 30.0));
        is(&areas.rough_main, 25.0 * 32.0 - 20.25 * 30.2, PI * (625.0 * 32.0 - 20.25 * 20.25 * 30.2));
        let all: f64 = [&areas.rough_main, &areas.additional, &areas.finish].iter().map(|area| area.volume_mm3.0).sum();
        let whole = between(&blank, &part);
        assert!((all - whole.volume_mm3.0).abs() < 1e-6);
    }
}
