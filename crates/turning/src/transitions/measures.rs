//! Measures of a toolpath, and the best of several toolpaths.

use serde::Serialize;

use crate::note::{Figure, Note};
use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Minutes, round_to};

use super::in_process_stock::InProcessStock;
use super::monotone::clipped;
use super::{Feeds, PreparedZone, Transition, descent};

/// The measures of a toolpath.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ToolpathMeasures {
    /// The length cut in metal, mm. Along a perpendicular face nothing is cut: the tool has cut up to it before.
    pub cutting_mm: f64,
    /// Length at a feed without metal, mm: to the metal, along clean surfaces, back along the contour.
    pub beside_mm: f64,
    /// The rapids, mm.
    pub rapid_mm: f64,
    /// Feeds and rapids together. A rapid moves both axes at once, so its time is that of the longer motion.
    pub time_min: Minutes,
    /// Working passes.
    pub passes: usize,
    /// The number of returns to begin another pass.
    pub returns: usize,
}

/// Measures a toolpath on a fresh blank. `edge` is the width of the edge of a tool that cuts across the axis.
pub fn measure(
    path: &Toolpath,
    zone: &PreparedZone,
    feeds: &Feeds,
    passes: usize,
    edge: Option<Half>,
) -> ToolpathMeasures {
    let mut standing = zone.whole.clone();
    let (mut cutting, mut beside, mut rapid, mut time) = (0.0, 0.0, 0.0, 0.0);
    for (piece, purpose) in path.pieces() {
        let length = piece.length_mm();
        let rate = feeds.rate(purpose).0;
        if purpose == Purpose::Rapid {
            rapid += length;
            let chord = piece.chord();
            time += libm::fmax(libm::fabs(chord.z), libm::fabs(chord.radius)) / rate;
            continue;
        }
        let metal = metal(&standing, &piece, edge).min(length);
        cutting += metal;
        beside += length - metal;
        time += length / rate;
        cut(&mut standing, &piece, purpose, edge);
    }
    ToolpathMeasures {
        cutting_mm: round_to(cutting, 3),
        beside_mm: round_to(beside, 3),
        rapid_mm: round_to(rapid, 3),
        time_min: Minutes(round_to(time, 4)),
        passes,
        returns: passes.saturating_sub(1),
    }
}

/// Removes the metal of a move. If the tool has an edge, a cut removes the metal under it.
pub(super) fn cut(standing: &mut InProcessStock, piece: &Piece, purpose: Purpose, edge: Option<Half>) {
    if purpose == Purpose::Rapid {
        return;
    }
    standing.lower(piece);
    if let (Some(edge), Purpose::Cut) = (edge, purpose) {
        standing.lower(&descent::slice(piece.to, edge));
    }
}

/// The length of a piece through metal, mm.
fn metal(standing: &InProcessStock, piece: &Piece, edge: Option<Half>) -> f64 {
    if piece.from.z != piece.to.z {
        let forth = if piece.to.z < piece.from.z { piece.reversed() } else { *piece };
        let parts = standing.metal(&forth).into_iter().filter_map(|(from, to)| clipped(&forth, from, to));
        return parts.map(|part| part.length_mm()).sum();
    }
    if piece.to.radius > piece.from.radius {
        return 0.0;
    }
    let top = match edge {
        Some(edge) => standing.highest(piece.to.z - edge, piece.to.z),
        None => standing.least_at(piece.to.z),
    };
    let top = top.map_or(piece.to.radius, |top| top.min(piece.from.radius));
    (top - piece.to.radius).max(Half::ZERO).to_mm()
}

/// The best of several toolpaths over a zone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Best {
    /// The quickest.
    pub scheme: &'static str,
    /// The next.
    pub next: &'static str,
    /// By how much it is quicker, min.
    pub margin_min: Minutes,
    /// The same as a share of the next one's time, per cent.
    pub margin_percent: f64,
    /// The same as a sentence.
    pub note: Note,
}

/// The toolpath with the least time, the first among equals; none if there are fewer than two. A toolpath that cuts
/// nothing, because the stock is thinner than a pass, is not compared. If an even allowance is needed, only those
/// that are [`Transition::uniform`] must be passed.
pub fn best<'t>(transitions: impl IntoIterator<Item = &'t Transition>) -> Option<Best> {
    let mut order: Vec<&Transition> = transitions.into_iter().filter(|one| one.measures.passes > 0).collect();
    let time = |one: &Transition| one.measures.time_min.0;
    order.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let [best, next, ..] = order.as_slice() else { return None };
    let margin = time(next) - time(best);
    let percent = if time(next) > 0.0 { margin / time(next) * 100.0 } else { 0.0 };
    let note = Note::new(if margin > 0.0 { "scheme-quickest" } else { "transition-as-quick" })
        .with("variant", Figure::word(best.scheme.name()))
        .with("rival", Figure::word(next.scheme.name()))
        .with("margin", round_to(margin, 4))
        .with("percent", round_to(percent, 1));
    Some(Best {
        scheme: best.scheme.name(),
        next: next.scheme.name(),
        margin_min: Minutes(round_to(margin, 4)),
        margin_percent: round_to(percent, 2),
        note,
    })
}
