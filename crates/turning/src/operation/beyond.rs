//! How the contours of a set-up go on behind their ends, so that a round nose leaves nothing there: over what the set-up before has
//! made, into the hole that it has opened, into the stock, past the blade.

use super::Stage;
use super::clip;
use super::opened;
use super::tools::{self, Bench};
use crate::error::KnowledgeError;
use crate::turning::contour::{Contour, Piece, Side, Surface};
use crate::turning::length::Half;
use crate::turning::nose::Nose;
use crate::turning::point::Point;
use crate::units::Micrometres;

/// The overrun at the end of a set-up's range: the round nose of the tool must leave no metal that the other set-up does not
/// reach. In the first set-up it is at the same radius, over a falling contour or into the stock beyond.
///
/// # Errors
/// The knowledge base lacks the table of motions.
pub(super) fn run_out(left: &Contour, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let ends_open = left.end().is_some_and(|end| end.radius > Half::ZERO);
    let [approach, _] = bench.approach_and_retract()?;
    Ok(if ends_open { approach } else { Half::ZERO })
}

/// How far the outside goes on behind its end where the part is parted off there and the next set-up turns some of it: past the
/// blade's face by the roundest nose, whose round would stand in the way of that set-up.
pub(super) fn past_parting(left: &Contour, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let end = left.end().map(|end| end.z).filter(|end| *end < bench.workpiece.length());
    let (Some(end), Some(face), Side::Outer) = (end, bench.parted, left.side) else { return Ok(Half::ZERO) };
    let tools = tools::candidates(Side::Outer, Stage::Finishing, bench)?;
    let nose = tools.iter().map(|tool| tools::nose(tool).radius).max().unwrap_or(Half::ZERO);
    Ok(face - end + nose)
}

/// How far a contour rises at its end along the axis, in its own lengths; none where it ends with a face or a fall.
/// In the second set-up a chamfer or a rounding goes on into the air over the cylinder that was made before, and a cylinder into
/// the air over a fall, or the round nose leaves metal at its end.
fn slope_at_end(left: &Contour) -> Option<f64> {
    let last = left.pieces.last().filter(|_| left.side == Side::Outer)?;
    let along = last.direction_at_end();
    (along.z > LEAST_RUN && along.radius >= -1e-9).then(|| along.radius.max(0.0) / along.z)
}

/// A contour of the second set-up led on behind its end, where the round nose would leave metal: straight along its slope, over what
/// the first set-up made, or along that, where it rises from there; and over the cylinder behind a thread, whose own is turned
/// smaller. None elsewhere.
pub(super) fn led_on(left: &Contour, threaded: bool, by: Half, bench: &Bench<'_, '_>) -> Option<Contour> {
    let end = left.end().filter(|_| by > Half::ZERO)?;
    let slope = slope_at_end(left)?;
    let part = bench.workpiece.outer.contour().turned_over(bench.workpiece.length());
    let beyond = clip::between(&part, end.z, end.z + by);
    let over = |point: &Point| end.radius + Half::from((point.z - end.z).to_mm() * slope) >= point.radius;
    if beyond.pieces.iter().flat_map(|piece| piece.extremes()).all(|point| over(&point)) {
        // A cylinder that goes on in the same radius is made already.
        let flush = left.pieces.iter().chain(beyond.pieces.first()).rev().take(2).all(|piece| piece.is_cylinder());
        return (!flush || threaded && bench.elsewhere.is_empty()).then(|| leading_on(left.clone(), by, slope));
    }
    let rises = |piece: &Piece| !piece.is_face() && piece.to.radius >= piece.from.radius;
    let follows = beyond.start() == Some(end) && beyond.pieces.iter().all(rises);
    // An allowance for another machine stands there.
    (follows && bench.elsewhere.is_empty()).then(|| {
        let pieces = left.pieces.iter().chain(&beyond.pieces).copied().collect();
        Contour { side: left.side, pieces }
    })
}

/// A bore that narrows towards the hole that the set-up before has opened, led on into its air for the roundest nose of a bar.
pub(super) fn into_hole(left: &Contour, bench: &Bench<'_, '_>) -> Result<Option<Contour>, KnowledgeError> {
    let bars = tools::candidates(Side::Inner, Stage::Finishing, bench)?;
    let roundest = bars.iter().map(tools::nose).max_by_key(|nose| nose.radius);
    let hole = |nose: Nose| {
        let end = left.end().filter(|end| is_bored_behind(*end, nose.radius + nose.radius, bench));
        bench.opened.max(end.map_or(Micrometres::ZERO, |end| end.radius.diameter()))
    };
    Ok(roundest.and_then(|nose| opened::into_hole(left, hole(nose), nose)))
}

/// Whether the set-up before has bored behind the end of a contour of the second one, as far and at least as wide.
fn is_bored_behind(end: Point, by: Half, bench: &Bench<'_, '_>) -> bool {
    let Some(inner) = &bench.workpiece.inner else { return false };
    let bored = inner.contour().turned_over(bench.workpiece.length());
    let beyond = clip::between(&bored, end.z, end.z + by);
    let reaches = beyond.end().is_some_and(|last| last.z == end.z + by);
    reaches && beyond.pieces.iter().all(|piece| piece.radii().0 >= end.radius)
}

/// A bore that ends with a shoulder lower than the roundest nose of a bar, led on into what the set-up before has bored behind it, so
/// that the nose rolls over the edge. None where the shoulder is higher, or nothing is bored behind it.
pub(super) fn over_low_shoulder(left: &Contour, bench: &Bench<'_, '_>) -> Result<Option<Contour>, KnowledgeError> {
    let bars = tools::candidates(Side::Inner, Stage::Finishing, bench)?;
    let nose = bars.iter().map(|bar| tools::nose(bar).radius).max().unwrap_or(Half::ZERO);
    let Some(last) = left.pieces.last() else { return Ok(None) };
    let (by, height) = (nose + nose, last.from.radius - last.to.radius);
    Ok((height < nose && is_bored_behind(last.to, by, bench)).then(|| longer(left.clone(), by)))
}

/// A contour that rises more steeply at its end, nearly as a wall, is not led on.
const LEAST_RUN: f64 = 0.2;

/// A contour led on along a slope at its end.
pub(super) fn leading_on(mut contour: Contour, by: Half, slope: f64) -> Contour {
    let Some(end) = contour.end() else { return contour };
    if slope == 0.0 {
        return longer(contour, by);
    }
    let radius = end.radius + Half::from(by.to_mm() * slope);
    contour.pieces.push(Piece::line(end, Point { radius, z: end.z + by }));
    contour
}

/// The allowance that another machine finishes on the surface behind the end of a contour of the first set-up; zero without one.
pub(super) fn ground_behind(left: &Contour, bench: &Bench<'_, '_>) -> Half {
    let part = bench.workpiece.profile(left.side);
    let end = left.end();
    let begins =
        |surface: &&Surface| surface.pieces.first().is_some_and(|first| Some(first.from) == end && !first.is_face());
    let behind = part.and_then(|part| part.surfaces.iter().find(begins));
    behind.and_then(|surface| bench.later(&surface.name)).unwrap_or(Half::ZERO)
}

/// A contour that steps away from the part by so much at its end.
pub(super) fn off_the_part(mut contour: Contour, by: Half) -> Contour {
    if let Some(end) = contour.end().filter(|_| by > Half::ZERO) {
        let to = Point { radius: end.radius.off(by, contour.side), z: end.z };
        match contour.pieces.last_mut().filter(|last| last.is_face()) {
            Some(last) => last.to = to,
            None => contour.pieces.push(Piece::line(end, to)),
        }
    }
    contour
}

/// A contour extended along the axis at its end.
pub(super) fn longer(mut contour: Contour, by: Half) -> Contour {
    let Some(last) = contour.pieces.last_mut().filter(|_| by > Half::ZERO) else { return contour };
    let end = Point { radius: last.to.radius, z: last.to.z + by };
    if last.is_cylinder() {
        last.to = end;
    } else {
        let on = Piece::line(last.to, end);
        contour.pieces.push(on);
    }
    contour
}
