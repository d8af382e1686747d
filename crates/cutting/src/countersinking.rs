//! Counterboring, countersinking and chamfering.

use crate::error::Tried;
use crate::plan;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::units::{Micrometres, MillimetresPerRev};

use super::{Cut, DraftConditions, drilling, feed, figures};

/// Conditions by the coefficients of core drilling (Косилова/Мещеряков т.2, tables 29, 30, 32; facts 1.2-1.4).
///
/// The handbook has no coefficients for tools that widen the mouth of a hole; the rule `stand-in-operation` takes
/// those of core drilling, whose teeth and depth of cut are nearest. The feed has a table of its own,
/// `counterboring-feed`.
///
/// - V = Cv·D^q / (T^m·t^x·s^y)·Kv, m/min;
/// - M = 10·Cm·D^q·t^x·s^y·Kp, N·m; P = 10·Cp·D^q·t^x·s^y·Kp, N;
/// - t = (D - d)/2, mm: for a cone that of its full depth, where the load is largest.
pub(super) fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    if let Some(around) = cut.around {
        return going_round(cut, around, taken, shop);
    }
    let (instead, reason) = figures::stand_in_operation(cut.operation, shop)?;
    let mut feed = feed::tabulated(cut, shop)?.with_feed(taken);
    feed.because.push(reason);
    drilling::by_tables(&Cut { operation: instead, ..*cut }, feed, shop)
}

/// A countersink that goes round an edge, with the conditions of sinking the same cone at its own diameter there: its teeth cut the
/// same depth, each for a part of a turn, and chips no thicker, so the loads are at most those.
///
/// The feed is that at the edge; the centre moves on a smaller circle, s = s0·(D - a)/D, mm/rev, with a the diameter of the
/// countersink at the face (as `milling`). The path is the way down in the middle, out, once round, and back: π·(D - a) + (D - a),
/// mm.
fn going_round(
    cut: &Cut,
    around: Micrometres,
    taken: Option<MillimetresPerRev>,
    shop: &Shop<'_>,
) -> Tried<DraftConditions, Uncut> {
    let circle = (cut.diameter - around).to_mm();
    let share = circle / cut.diameter.to_mm();
    let sunk = Cut { diameter: around, from: around - (cut.diameter - cut.from), around: None, ..*cut };
    let mut draft = draft(&sunk, taken.map(|feed| MillimetresPerRev(feed.0 / share)), shop)?;
    draft.feed = MillimetresPerRev(draft.feed.0 * share);
    for law in [&mut draft.loads.torque, &mut draft.loads.thrust].into_iter().flatten() {
        law.factor /= libm::pow(share, law.exponent);
    }
    draft.motion.path = cut.travel.to_mm() + circle * (std::f64::consts::PI + 1.0);
    draft.rounds = Some(plan::Rounds {
        from_diameter_mm: cut.from,
        mill_diameter_mm: around,
        passes: 1,
        levels: 1,
        finish_mm: None,
        plunge_feed_mm_per_min: None,
        arc_feed_mm_per_min: None,
        along_middle: false,
    });
    Ok(draft)
}
