//! The contour that this lathe leaves: the main contour with the allowances for other machines.

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::allowances::{Over, equidistant_over};
use crate::turning::contour::{Contour, Curve, Piece, Profile, Side, Surface};
use crate::turning::jobs::limits::Limits;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::zones::TurnedSide;

use super::tools::Bench;

/// The main contour with the allowances for other machines, each piece with its surface. None, with a finding, if it
/// cannot be made.
///
/// # Errors
/// The knowledge base is broken.
pub(super) fn left(
    stretch: &TurnedSide,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Vec<Owned>>, KnowledgeError> {
    let whole = &stretch.main.contour;
    let main = &if bench.elsewhere.is_empty() { whole.clone() } else { parted(whole, &stretch.profile, bench) };
    let surfaces: Vec<Option<usize>> = main.pieces.iter().map(|piece| surface_of(piece, &stretch.profile)).collect();
    let later = |surface: &Option<usize>| {
        let surface = surface.and_then(|index| stretch.profile.surfaces.get(index));
        surface.and_then(|surface| bench.later(&surface.name)).unwrap_or(Half::ZERO)
    };
    let distances: Vec<Half> = surfaces.iter().map(later).collect();
    if distances.iter().all(|distance| *distance == Half::ZERO) {
        return Ok(Some(main.pieces.iter().copied().zip(surfaces).collect()));
    }
    let fall = Limits::of(bench.knowledge).ratio(JobLimit::AllowanceEndFall)?;
    Ok(match equidistant_over(main, &distances) {
        Ok(over) => {
            let is_face = |over: &Over| main.pieces.get(over.of).is_some_and(|piece| piece.is_face());
            let steps = over.iter().map(|over| over.piece.is_face() && !is_face(over)).collect::<Vec<_>>();
            let own = |over: Over| (over.piece, surfaces.get(over.of).copied().flatten());
            Some(without_steps(over.into_iter().map(own).zip(steps).collect(), fall, main.side))
        }
        Err(error) => {
            findings.push(Finding::of_part(Severity::Error, Note::new("no-intermediate-contour").with("why", error)));
            None
        }
    })
}

/// A piece and the index of its surface in the profile.
pub(super) type Owned = (Piece, Option<usize>);

/// The contour, with a mark at each step that is no face of the part, with its slopes led on to the raised cylinders beside them, in place of a step as high as the allowance: no nose
/// makes the corner of such a step, and after grinding the whole slope is there. From a raised cylinder down to one of the same
/// diameter there is a slope that a contouring tool follows: no trailing edge goes down upright.
fn without_steps(pieces: Vec<(Owned, bool)>, fall: f64, side: Side) -> Vec<Owned> {
    let mut kept: Vec<Owned> = Vec::new();
    let mut rest = pieces.into_iter().peekable();
    while let Some(((piece, surface), is_step)) = rest.next() {
        let step = is_step.then_some(piece);
        let beside = step.zip(kept.last().copied()).zip(rest.peek().copied());
        if let Some(((step, (before, _)), ((after, _), _))) = beside
            && let Some(slope) = eased(before, step, after, fall, side)
        {
            if let Some(last) = kept.last_mut() {
                last.0.to = slope.from;
            }
            kept.push((slope, surface));
            if let Some(next) = rest.peek_mut() {
                next.0.0.from = slope.to;
            }
            continue;
        }
        let led = beside.and_then(|((step, (before, _)), ((after, _), _))| {
            // Each seen from both ends.
            let (back, front) = (after.reversed(), before.reversed());
            let own = led_on(before, step, after).map(|slope| (slope, after));
            let own = own.or_else(|| Some((before, led_on(back, step.reversed(), front)?.reversed())));
            let own = own.or_else(|| Some((before, led_into(before, step, after)?)));
            own.or_else(|| Some((led_into(back, step.reversed(), front)?.reversed(), after)))
        });
        match (led, kept.last_mut(), rest.peek_mut()) {
            (Some((before, after)), Some(last), Some(next)) => {
                let corner = if before.is_cylinder() { after.from } else { before.to };
                last.0 = Piece { to: corner, ..before };
                next.0.0 = Piece { from: corner, ..after };
            }
            _ => kept.push((piece, surface)),
        }
    }
    kept
}

/// The slope in place of a step down from a raised cylinder, or up to one, `run` times as long as high (`allowance-end-fall`): over
/// what is beside the cylinder, or over the cylinder where a slope falls from it. None where a slope beside it is as steep, which is led
/// on itself, where a cylinder rises to the raised one, or where one of both is too short.
fn eased(before: Piece, step: Piece, after: Piece, run: f64, side: Side) -> Option<Piece> {
    let falls = (step.to.radius < step.from.radius) == (side == Side::Outer);
    if falls {
        return falling(before, step, after, run);
    }
    let rises = !before.is_cylinder();
    rises.then(|| falling(after.reversed(), step.reversed(), before.reversed(), run)).flatten().map(Piece::reversed)
}

/// The same for a step down behind the cylinder, in the order of the way; backwards, Z falls.
fn falling(cylinder: Piece, step: Piece, beside: Piece, run: f64) -> Option<Piece> {
    let (down, along) = ((step.to.radius - step.from.radius).to_mm(), beside.direction_at_start());
    let shallow = beside.curve == Curve::Line && along.radius.abs() * run < along.z.abs();
    if !cylinder.is_cylinder() || !shallow {
        return None;
    }
    let by = Half::from(down.abs() * run * along.z.signum());
    if along.radius * down > 0.0 {
        let from = Point { radius: cylinder.to.radius, z: step.from.z - by };
        let within = (from.z - cylinder.from.z).to_mm() * along.z > 0.0;
        return within.then(|| Piece::line(from, step.to));
    }
    let to = beside.at_z(step.to.z + by).first().copied()?;
    let within = (beside.to.z - to.z).to_mm() * along.z > 0.0;
    within.then(|| Piece::line(step.from, to))
}

/// A slope led on over the step behind it to the cylinder above; none if these are no slope, step and cylinder, or if the
/// cylinder is too short for it.
fn led_on(slope: Piece, step: Piece, cylinder: Piece) -> Option<Piece> {
    let along = slope.direction_at_end();
    let rise = (step.to.radius - step.from.radius).to_mm();
    let sloping = slope.curve == Curve::Line && along.z != 0.0 && along.radius * rise > 0.0;
    if !sloping || !cylinder.is_cylinder() {
        return None;
    }
    let z = step.from.z + Half::from(rise * along.z / along.radius);
    let within = (cylinder.to.z - z).to_mm() * along.z > 0.0;
    within.then_some(Piece { to: Point { radius: step.to.radius, z }, ..slope })
}

/// A slope or a rounding that rises behind the step at the end of a raised cylinder, from where that cylinder runs into it: no nose
/// makes the notch between the two. None if these are no cylinder, a step down and a rise, or if it rises less than the step.
fn led_into(cylinder: Piece, step: Piece, rise: Piece) -> Option<Piece> {
    let (down, up) = (step.to.radius - step.from.radius, rise.to.radius - rise.from.radius);
    let opposite = (down < Half::ZERO) != (up < Half::ZERO) && up != Half::ZERO;
    if !cylinder.is_cylinder() || rise.is_face() || !opposite {
        return None;
    }
    let within = |at: &Point| at.z != rise.from.z && at.z != rise.to.z;
    let corner = rise.at_radius(cylinder.to.radius).into_iter().find(within)?;
    Some(rise.between(corner, rise.to))
}

/// A contour with its lines divided at the ends of surfaces: two cylinders of one diameter are one line of the main
/// contour, but perhaps only one of them is ground later.
fn parted(contour: &Contour, profile: &Profile, bench: &Bench<'_, '_>) -> Contour {
    let later = |surface: &Surface| bench.later(&surface.name).is_some();
    // Grooves lie between them, or nothing.
    let surfaces: Vec<&Surface> = profile.surfaces.iter().filter(|surface| !surface.is_groove()).collect();
    let beside = surfaces.iter().zip(surfaces.iter().skip(1));
    // What is ground begins and ends at its own edge, so that a groove beside it has the step.
    let ends = beside.filter_map(|(one, next)| {
        let (before, behind) = (one.pieces.last()?, next.pieces.first()?);
        let flush = before.is_cylinder() && behind.is_cylinder() && before.to.radius == behind.from.radius;
        match (later(one), later(next)) {
            (false, true) if flush => Some(behind.from),
            (true, false) if flush => Some(before.to),
            _ => None,
        }
    });
    let ends: Vec<Point> = ends.collect();
    let mut pieces = Vec::new();
    for piece in &contour.pieces {
        let mut from = piece.from;
        if piece.is_cylinder() {
            let inside = |end: &&Point| end.radius == piece.from.radius && piece.from.z < end.z && end.z < piece.to.z;
            let mut cuts: Vec<Point> = ends.iter().filter(inside).copied().collect();
            cuts.sort_by_key(|cut| cut.z);
            cuts.dedup();
            for cut in cuts {
                pieces.push(piece.between(from, cut));
                from = cut;
            }
        }
        pieces.push(piece.between(from, piece.to));
    }
    Contour { side: contour.side, pieces }
}

/// The index of the surface of a piece of the main contour: the first one that touches it and has a piece on the same
/// line or circle.
fn surface_of(piece: &Piece, profile: &Profile) -> Option<usize> {
    let lies_on = |other: &Piece| touches(piece, other) && same_carrier(piece, other);
    // At the common end of two surfaces on one line both touch it: the one over the middle of the piece comes first.
    let over_middle = |other: &Piece| {
        let (least, most) = (other.from.z.min(other.to.z), other.from.z.max(other.to.z));
        let middle = Half::new((piece.from.z.halves() + piece.to.z.halves()) / 2);
        least <= middle && middle <= most && lies_on(other)
    };
    let of = |test: &dyn Fn(&Piece) -> bool| profile.surfaces.iter().position(|one| one.pieces.iter().any(test));
    let shares = |other: &Piece| overlaps(piece, other) && lies_on(other);
    of(&over_middle).or_else(|| of(&shares)).or_else(|| of(&lies_on))
}

/// Whether two pieces share more than an end, along the axis or across it.
fn overlaps(one: &Piece, other: &Piece) -> bool {
    let spans = |a: (Half, Half), b: (Half, Half)| a.0.min(a.1).max(b.0.min(b.1)) < a.0.max(a.1).min(b.0.max(b.1));
    spans((one.from.z, one.to.z), (other.from.z, other.to.z))
        || spans((one.from.radius, one.to.radius), (other.from.radius, other.to.radius))
}

fn touches(one: &Piece, other: &Piece) -> bool {
    let spans = |a: (Half, Half), b: (Half, Half)| a.0.min(a.1) <= b.0.max(b.1) && b.0.min(b.1) <= a.0.max(a.1);
    spans((one.from.z, one.to.z), (other.from.z, other.to.z))
        && spans((one.from.radius, one.to.radius), (other.from.radius, other.to.radius))
}

/// Whether two pieces are on one line or circle, to two micrometres: ends of pieces are rounded.
fn same_carrier(one: &Piece, other: &Piece) -> bool {
    const NEAR: f64 = 0.002;
    match (one.curve, other.curve, one.centre(), other.centre()) {
        (Curve::Line, Curve::Line, ..) => {
            let along = other.chord().unit();
            [one.from, one.to].into_iter().all(|point| along.cross(other.from.to(point)).abs() < NEAR)
        }
        (Curve::Arc { radius: a, .. }, Curve::Arc { radius: b, .. }, Some(here), Some(there)) => {
            (a - b).to_mm().abs() < NEAR && Point::at(here).to(Point::at(there)).length() < 10.0 * NEAR
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::at;

    fn contour(points: &[(f64, f64)]) -> Vec<Owned> {
        let points: Vec<Point> = points.iter().map(|(radius, z)| at(*radius, *z)).collect();
        points.windows(2).map(|ends| (Piece::line(ends[0], ends[1]), None)).collect()
    }

    /// A contour in which every face of 0.2 is a step over an allowance.
    fn stepped(points: &[(f64, f64)]) -> Vec<(Owned, bool)> {
        let is_step = |piece: &Piece| piece.is_face() && piece.length_mm() < 0.21;
        contour(points).into_iter().map(|one| (one, is_step(&one.0))).collect()
    }

    /// A chamfer of 45° that rises to a cylinder with 0.2 goes on by 0.2 along the axis; one that falls behind it begins 0.2
    /// earlier; a face of the part stays.
    #[test]
    fn a_chamfer_goes_on_to_the_raised_cylinder() {
        let points = [(18.0, 0.0), (20.0, 2.0), (20.2, 2.0), (20.2, 30.0), (20.0, 30.0), (18.0, 32.0), (25.0, 32.0)];
        let led = [(18.0, 0.0), (20.2, 2.2), (20.2, 29.8), (18.0, 32.0), (25.0, 32.0)];
        assert_eq!(without_steps(stepped(&points), COT_25, Side::Outer), contour(&led));
        let faced = [(20.2, 0.0), (20.2, 30.0), (24.0, 30.0), (25.0, 31.0), (25.0, 40.0)];
        assert_eq!(without_steps(stepped(&faced), COT_25, Side::Outer), contour(&faced));
    }

    /// cot 25°.
    const COT_25: f64 = 2.144_507;

    /// From 0.2 over a cylinder down to the plain one behind it by 25°: 0.2/tan 25° = 0.4289 long.
    #[test]
    fn an_allowance_ends_with_a_slope() {
        let points = [(20.2, 0.0), (20.2, 30.0), (20.0, 30.0), (20.0, 50.0)];
        let sloped = [(20.2, 0.0), (20.2, 30.0), (20.0, 30.429), (20.0, 50.0)];
        assert_eq!(without_steps(stepped(&points), COT_25, Side::Outer), contour(&sloped));
        let rising = [(20.0, 0.0), (20.0, 30.0), (20.2, 30.0), (20.2, 50.0)];
        assert_eq!(without_steps(stepped(&rising), COT_25, Side::Outer), contour(&rising));
    }

    /// By hand: 0.2 over a cylinder before a slope of 45° end 0.2 farther on, where the slope is 0.2 high; the same backwards.
    #[test]
    fn an_allowance_runs_into_a_rise() {
        let points = [(20.2, 0.0), (20.2, 30.0), (20.0, 30.0), (25.0, 35.0)];
        let led = [(20.2, 0.0), (20.2, 30.2), (25.0, 35.0)];
        assert_eq!(without_steps(stepped(&points), COT_25, Side::Outer), contour(&led));
        let back = [(25.0, 0.0), (20.0, 5.0), (20.2, 5.0), (20.2, 30.0)];
        let led = [(25.0, 0.0), (20.2, 4.8), (20.2, 30.0)];
        assert_eq!(without_steps(stepped(&back), COT_25, Side::Outer), contour(&led));
    }

    /// By hand, 0.2·cot 25° = 0.4289: beside slopes of 2.5 % an allowance of 0.2 ends so far on. Where the slope falls from the seat that
    /// is over the seat itself, where it rises over the slope, which is there 0.0107 higher.
    #[test]
    fn an_allowance_ends_beside_a_shallow_slope() {
        let before = [(19.0, 0.0), (20.0, 40.0), (20.2, 40.0), (20.2, 60.0), (20.0, 60.0), (21.0, 100.0)];
        let eased = [(19.0, 0.0), (20.0, 40.0), (20.2, 40.429), (20.2, 60.0), (20.0105, 60.429), (21.0, 100.0)];
        assert_eq!(without_steps(stepped(&before), COT_25, Side::Outer), contour(&eased));
    }

    /// A slope of 25° would end beyond a cylinder of 0.3 mm, one of 5° all the more.
    #[test]
    fn a_cylinder_too_short_keeps_its_step() {
        let points = [(19.0, 0.0), (20.0, 11.0), (20.2, 11.0), (20.2, 11.3)];
        assert_eq!(without_steps(stepped(&points), COT_25, Side::Outer), contour(&points));
    }
}
