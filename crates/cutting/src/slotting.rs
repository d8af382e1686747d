//! The ways of an end mill in a slot: along its middle in solid metal, then round along its walls.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::part::Slot;
use crate::plan;
use crate::shop::Shop;
use crate::tables::cutting::{MillingDepth, MillingStep};
use crate::tables::holes::HoleDefault;
use crate::tables::rules::PlungeFeedFor;
use crate::units::{Micrometres, round_to};

use super::milling::{Rounds, parts};
use super::{AnotherFeed, Cut, CutterShape};

/// The passes of one slot or pocket.
///
/// In solid metal the first pass goes along the middle: t = D, the whole mill stands in the metal, and a level is no deeper than
/// the row `slot` of `milling-depth`. The passes that widen it take no more than the row `radial`. Where the slot is there already,
/// only they are left, and a level is as deep as in a hole. The path of all levels, mm, beside the way down:
///
/// - along the middle: length in every level, each from the end where the one above it ended, and once more where their number is
///   odd: the mill comes out where it went in;
/// - round along the walls, with r = (d - D)/2, d the width of the pass: 2·length straight, 2·π·r on the arcs of the ends; in a
///   pocket 2·length + 8·(r - c) straight, 2·π·c in the corners, c the radius of the way of the mill's middle there;
/// - onto the walls by a quarter of l, the less of r and D/2, and off them by a quarter of l/2, each with the way from or to the
///   middle.
///
/// Along a wall the middle of the mill is as fast as its teeth there. On an arc the wall lies further out, and the middle is fed by
/// r/(r + D/2) of that, r the radius of its own way (Sandvik Coromant, heat resistant super alloys, p. 110: vf =
/// (Dm - Dc)/Dm·vfm); but by no less than the convention `least-feed-per-tooth-mm`: a chip as thin as the edge is round is rubbed,
/// not cut. The quarter off a wall, which cuts nothing after its first moment, is fed no slower than the tightest of the others.
/// `feed_per_tooth` is that along the walls, mm.
pub(super) fn rounds(
    cut: &Cut,
    mill: CutterShape,
    slot: Slot,
    feed_per_tooth: f64,
    shop: &Shop<'_>,
) -> Result<(Rounds, Vec<Because>), KnowledgeError> {
    let step = |step: MillingStep| shop.knowledge.need(step.name(), |row: &MillingDepth<'_>| row.name == step);
    let solid = cut.from == Micrometres::ZERO;
    let (d, width, along) = (mill.diameter.to_mm(), cut.diameter.to_mm(), slot.length().to_mm());
    let radial = step(MillingStep::Radial)?;
    let axial = step(if solid { MillingStep::Slot } else { MillingStep::Axial })?;
    let before = if solid { d } else { cut.from.to_mm() };
    let stock = (width - before) / 2.0;
    let widening = if stock > 0.0 { parts(stock, radial.share * d) } else { 0 };
    let levels = parts(cut.depth.to_mm(), mill.cutting_length.to_mm().min(axial.share * d));

    let each = f64::from(levels);
    let radius = |pass: u32| (before + 2.0 * stock * f64::from(pass) / f64::from(widening) - d) / 2.0;
    // In a corner the ways further in are rounded less.
    let in_corner =
        |pass: u32| slot.corner.map(|own| (own.to_mm() - d / 2.0 - radius(widening) + radius(pass)).max(0.0));
    // The radii of the arcs with how long all of each are, mm.
    let (mut turns, mut beside) = (Vec::new(), 0.0);
    let mut tightest = f64::INFINITY;
    for pass in 1..=widening {
        let r = radius(pass);
        let (on, off) = (r.min(d / 2.0), r.min(d / 2.0) / 2.0);
        let turned = in_corner(pass).unwrap_or(r);
        let quarter = std::f64::consts::FRAC_PI_2;
        turns.extend([(turned, 4.0 * quarter * turned), (on, quarter * on), (off, quarter * off)]);
        let ends = if slot.corner.is_some() { 8.0 * (r - turned) } else { 0.0 };
        beside += 2.0 * along + ends + libm::hypot(on, r - on) + libm::hypot(off, r - off);
        tightest = [turned, on].into_iter().filter(|own| *own > 0.0).fold(tightest, f64::min);
    }
    let middle = if solid { each * along + f64::from(levels % 2) * along } else { 0.0 };
    let straight = middle + each * beside;
    let on_arcs: f64 = turns.iter().map(|(_, length)| length).sum();
    let least = shop.convention(HoleDefault::LeastFeedPerTooth)?.to_mm();
    let slowest = (tightest / (tightest + d / 2.0)).max(least / feed_per_tooth).min(1.0);
    let arcs: Vec<AnotherFeed> = turns
        .into_iter()
        .map(|(r, length)| AnotherFeed { share: (r / (r + d / 2.0)).max(slowest), travel: each * length })
        .collect();

    let radial_depth = if solid { d } else { stock / f64::from(widening.max(1)) };
    let axial_depth = cut.depth.to_mm() / each;
    let passes = widening + u32::from(solid);
    let note = Note::new("slot-passes")
        .with("passes", passes)
        .with("levels", levels)
        .with("t", round_to(radial_depth, 3))
        .with("b", round_to(axial_depth, 3))
        .with("path", round_to(straight + each * on_arcs, 1));
    let mut because = vec![Because::row(axial.row, note)];
    if widening > 0 {
        let note = Note::new("slot-arc-feed")
            .with("passes", widening)
            .with("percent", round_to(slowest * 100.0, 1))
            .with("least", least);
        because.push(Because::row(radial.row, note));
    }
    let (mut path, mut plunge) = (straight, None);
    if solid {
        let material_group = shop.material.group;
        let row = shop.knowledge.ask(&PlungeFeedFor { material_group })?.need(material_group)?;
        plunge = Some(AnotherFeed { share: row.share, travel: cut.travel.to_mm() });
        because.push(Because::row(row.row, Note::new("plunge-feed").with("percent", round_to(row.share * 100.0, 0))));
    } else {
        path += cut.travel.to_mm();
    }
    let planned = plan::Rounds {
        from_diameter_mm: if solid { mill.diameter } else { cut.from },
        mill_diameter_mm: mill.diameter,
        passes,
        levels,
        finish_mm: None,
        plunge_feed_mm_per_min: None,
        arc_feed_mm_per_min: None,
        along_middle: solid,
    };
    Ok((Rounds { radial_depth, axial_depth, centre_share: 1.0, path, planned, plunge, arcs }, because))
}
