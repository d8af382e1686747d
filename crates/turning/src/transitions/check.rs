//! Conditions for a zone and a tool before a toolpath is made.

use crate::error::{Refusal, Tried};
use crate::turning::contour::{Contour, Curve, Piece};
use crate::turning::length::Half;
use crate::turning::reasons::reasons;
use crate::units::round_to;

use super::in_process_stock::InProcessStock;
use super::monotone::{MonotoneContour, clipped, radius_on};
use super::{PreparedZone, Scheme, Settings, Stock, Tool};

/// The tolerance of every angle, degrees.
const ROUNDING_DEGREES: f64 = 0.01;

/// More passes than this over one zone are a typing mistake: nobody would turn them, and the time for finding them
/// grows with the square of their number.
pub const MOST_PASSES: i64 = 1000;

/// How much the rounding of its ends to half a micrometre may change the direction of a piece, degrees: it rotates
/// the chord and moves the centre of an arc.
fn rounding_degrees(piece: &Piece) -> f64 {
    const END_MM: f64 = 0.0005;
    let chord = piece.chord().length();
    let bent = if let Curve::Arc { radius, .. } = piece.curve { END_MM / radius.to_mm().max(END_MM) } else { 0.0 };
    ROUNDING_DEGREES.max((END_MM / chord.max(END_MM) + bent).to_degrees())
}

reasons! {
    /// Why a scheme gives no toolpath over a zone.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(missing_docs)] // the figures have the names of those of the sentences
    pub enum Unsuited {
        /// A contour is not connected, or runs back.
        NotMonotone { contour: &'static str } = note!("zone-contour-not-monotone"),
        /// The contours are of different sides or ranges of Z.
        ContoursDiffer = note!("zone-contours-differ"),
        /// A depth or distance that is not above zero.
        NotPositive = note!("zone-settings-not-positive"),
        /// The rough contour is above its blank there; Z from the chuck.
        RoughAboveBlank { z: Half } = note!("rough-above-blank"),
        /// A toolpath against a stop over a contour that is not stepped.
        StopNeedsSteps = note!("stop-needs-steps"),
        /// A flank is steeper than the tool's angle, degrees.
        TooSteep { z: Half, angle: f64 as round_to(*angle, 2), limit: f64 } = note!("flank-too-steep"),
        /// There is no offset curve at that distance.
        NoEquidistant { distance: Half } = note!("no-equidistant"),
        /// More passes to be turned than [`MOST_PASSES`].
        TooManyPasses { passes: i64, most: i64 } = note!("too-many-passes"),
    }
}

/// Checks that toolpaths over a zone are possible at all.
///
/// # Errors
/// A reason, whose sentence has a remedy: contours that are not connected, run back, or differ in their
/// stretch of Z or their side; a rough contour above its blank; lengths that are not positive.
pub fn zone(
    stock: &Stock,
    ground: &MonotoneContour,
    blank: &MonotoneContour,
    settings: &Settings,
) -> Tried<(), Unsuited> {
    let not = |why: Unsuited| Err(Refusal::Not(why));
    for (contour, own) in [("rough", &stock.rough), ("blank", &stock.blank)] {
        if own.pieces.is_empty() || !own.hangs_together() || !own.is_monotone() {
            return not(Unsuited::NotMonotone { contour });
        }
    }
    if stock.rough.side != stock.blank.side || !same_stretch(stock, ground, blank) {
        return not(Unsuited::ContoursDiffer);
    }
    if settings.depth <= Half::ZERO || settings.approach <= Half::ZERO || settings.retract <= Half::ZERO {
        return not(Unsuited::NotPositive);
    }
    match above(ground, blank) {
        Some(z) => not(Unsuited::RoughAboveBlank { z: Half::ZERO - z }),
        None => Ok(()),
    }
}

/// Checks that a scheme suits a zone.
///
/// # Errors
/// A reason, as of [`zone`]: too many passes, a toolpath against a stop over a contour that is not stepped, a
/// contour steeper than the tool's angles.
pub fn scheme(zone: &PreparedZone, settings: &Settings, scheme: Scheme) -> Tried<(), Unsuited> {
    let not = |why: Unsuited| Err(Refusal::Not(why));
    let (ground, stock) = (&zone.rough, &zone.stock);
    let across = scheme == Scheme::Descent;
    let stock_high = || Some(zone.top - ground.lowest(ground.from(), ground.to())?);
    let high = if across { Some(stock.to - stock.from) } else { stock_high() };
    if let Some(passes) = high.map(|high| high.parts(settings.depth)).filter(|passes| *passes > MOST_PASSES) {
        return not(Unsuited::TooManyPasses { passes, most: MOST_PASSES });
    }
    if scheme == Scheme::LoopAgainstStop && !is_roller(&stock.rough, ground) {
        return not(Unsuited::StopNeedsSteps);
    }
    match &zone.steep {
        Some(steep) if scheme != Scheme::Descent => not(steep.clone()),
        _ => Ok(()),
    }
}

/// The first flank of a contour that is steeper than the tool's angle.
pub fn steep(ground: &MonotoneContour, tool: &Tool) -> Option<Unsuited> {
    let (piece, angle, limit) = ground.pieces.iter().find_map(|piece| too_steep(piece, tool))?;
    Some(Unsuited::TooSteep { z: Half::ZERO - piece.from.z, angle, limit })
}

fn same_stretch(stock: &Stock, ground: &MonotoneContour, blank: &MonotoneContour) -> bool {
    let (from, to) = (stock.from, stock.to);
    from < to && [ground, blank].iter().all(|one| one.from() == from && one.to() == to)
}

/// Where a rough contour is above its blank.
fn above(ground: &MonotoneContour, blank: &MonotoneContour) -> Option<Half> {
    let standing = InProcessStock::of(blank);
    let over = |piece: &Piece| {
        standing.over(piece.from.z, piece.to.z).iter().find_map(|cell| {
            let top = clipped(&cell.top, piece.from.z.max(cell.from), piece.to.z.min(cell.to))?;
            let middle = Half::new((top.from.z + top.to.z).halves().div_euclid(2));
            let places = [top.from.z, middle, top.to.z];
            places.into_iter().find(|z| (radius_on(piece, *z) - radius_on(&top, *z)).halves() > 1)
        })
    };
    ground.pieces.iter().filter(|piece| !piece.is_face()).find_map(over)
}

/// Cylinders and faces that rise towards the chuck.
fn is_roller(rough: &Contour, ground: &MonotoneContour) -> bool {
    rough.is_stepped() && ground.pieces.iter().all(|piece| piece.to.radius >= piece.from.radius)
}

/// A piece that rises more steeply than the main angle, or falls more steeply than the secondary one, with its steepest
/// angle and the limit.
fn too_steep<'p>(piece: &'p Piece, tool: &Tool) -> Option<(&'p Piece, f64, f64)> {
    let angles = [piece.direction_at_start().degrees(), piece.direction_at_end().degrees()];
    let rises = piece.to.radius > piece.from.radius;
    let angle = angles.iter().map(|angle| libm::fabs(*angle)).fold(0.0, libm::fmax);
    let limit = if rises { tool.main.0 } else { tool.secondary.0 };
    (piece.from.radius != piece.to.radius && angle > limit + rounding_degrees(piece)).then_some((piece, angle, limit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::Turn;
    use crate::turning::point::Point;
    use crate::units::Degrees;

    /// A fillet of 0.3855 whose upright end runs back by 0.02° because of rounding; found by an operation of a random
    /// part. 0.5 µm over 0.54 mm and over 0.3855 mm are 0.053° and 0.074°.
    #[test]
    fn rounding_of_a_small_arc_is_no_angle() {
        let at = |radius: f64, z: f64| Point { radius: Half::from(radius), z: Half::from(z) };
        let tool = Tool { nose_radius: Half::ZERO, main: Degrees(90.0), secondary: Degrees(90.0) };
        let fillet = Piece::arc(at(43.7545, 64.1495), at(44.14, 64.5255), Half::from(0.3855), Turn::Left);
        assert!(too_steep(&fillet, &tool).is_none());
        let cone = Piece::line(at(43.0, 64.0), at(44.0, 63.996));
        assert!(too_steep(&cone, &tool).is_some(), "4 µm back over 1 mm are 0.23°");
    }
}
