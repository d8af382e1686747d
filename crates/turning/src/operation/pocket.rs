//! The parts of a zone that are worked one after the other (lecture 12.4, l. 504-518; fig. 12.3 г).
//!
//! 1. If the open parts have a scheme of their own, they come first: everything above their floor, from the free end
//!    on, because stock in front of them would block the tool.
//! 2. Then the rest below that floor, with closed parts bridged level from lip to lip.
//! 3. Then the closed parts, one by one from the free end.
//!
//! Neighbours of one kind stay together: a division at every face would cost a return for each (lecture, fig. 12.5 a).

use crate::tables::turning::passes::PartsWorked;
use crate::turning::allowances::areas::between;
use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::transitions::Stock;
use crate::turning::transitions::monotone::MonotoneContour;
use crate::turning::zones::{Zone, ZoneKind, ZonePart};

use super::clip;

/// A stock to be cleared by one scheme.
#[derive(Clone, Debug)]
pub(super) struct Piecework {
    /// The stock to remove, in the coordinates of the set-up.
    pub stock: Stock,
    /// Its index in the schemes of the zone.
    pub scheme: usize,
}

/// The parts of a zone that are cleared separately, in the order of work: a chain of contours from the blank down to
/// the rough contour. Each covers the whole zone, so that each work knows the stock beside it.
///
/// A shaped blank may be below the floor of the open part, or below a bridge. Then everything is one work, by the last
/// scheme of the rule, which leaves an even allowance.
///
/// An open part shallower than `least` is no work of its own: no pass is worth going along it, and the pass along the contour takes
/// it with the rest.
pub(super) fn pieceworks(zone: &Zone, rough: &Contour, blank: &Contour, least: Half) -> Vec<Piecework> {
    let (from, to) = (zone.from_z, zone.to_z);
    let within = |contour: &Contour| clip::between(contour, from, to);
    let (rough, blank) = (within(rough), within(blank));
    let stock = |rough: &Contour, blank: &Contour| Stock { rough: rough.clone(), blank: blank.clone(), from, to };
    let each = zone.scheme.parts_worked == PartsWorked::Each;
    let last = zone.scheme.schemes.len().saturating_sub(1);
    if !each && zone.scheme.parts_worked != PartsWorked::Joined {
        return vec![Piecework { stock: stock(&rough, &blank), scheme: 0 }];
    }
    if !blank.pieces.iter().all(|piece| piece.is_cylinder()) {
        return vec![Piecework { stock: stock(&rough, &blank), scheme: last }];
    }
    let mut chain = vec![(rough.clone(), last)];
    let mut lowest = rough;
    for part in zone.parts.iter().rev().filter(|part| part.kind == ZoneKind::Closed) {
        if let Some(over) = bridge(&lowest, part) {
            chain.push((over.clone(), last));
            lowest = over;
        }
    }
    // The last bridge is cleared first; the pockets come last.
    if let Some((_, scheme)) = chain.last_mut().filter(|_| each) {
        *scheme = 1.min(last);
    } else if let Some((_, scheme)) = chain.last_mut() {
        *scheme = 0;
    }
    let half_open = zone.parts.iter().any(|part| part.kind == ZoneKind::HalfOpen);
    if let Some(level) = floor(zone, lowest.side).filter(|_| each) {
        if !half_open {
            if let Some((_, scheme)) = chain.last_mut() {
                *scheme = 0;
            }
        } else if deep_enough(&blank, level, least) {
            chain.push((raised(&lowest, level), 0));
        }
    }
    let mut before = blank;
    let mut works = Vec::new();
    for (contour, scheme) in chain.into_iter().rev() {
        let stock = stock(&contour, &before);
        if stands(&stock) {
            works.push(Piecework { stock, scheme });
            before = contour;
        }
    }
    works
}

/// The floor of the open parts.
fn floor(zone: &Zone, side: Side) -> Option<Half> {
    let open = zone.parts.iter().filter(|part| part.kind == ZoneKind::Open);
    match side {
        Side::Outer => open.map(|part| part.least_radius).min(),
        Side::Inner => open.map(|part| part.greatest_radius).max(),
    }
}

/// The greater of a monotone outer contour and a level; for a bore the smaller.
pub(super) fn raised(contour: &Contour, level: Half) -> Contour {
    let top = contour.radii().map_or(Half::ZERO, |(_, most)| most);
    match contour.side {
        Side::Outer => {
            let (from, to) = (contour.start().unwrap_or_default().z, contour.end().unwrap_or_default().z);
            let pieces = MonotoneContour::of(contour).clamped(level, Half::new(i64::MAX), from, to);
            Contour { side: Side::Outer, pieces }
        }
        Side::Inner => raised(&contour.inside_out(top), top - level).inside_out(top),
    }
}

/// Whether a cylindrical blank stands over a level by a depth somewhere.
fn deep_enough(blank: &Contour, level: Half, least: Half) -> bool {
    let Some((low, high)) = blank.radii() else { return false };
    let depth = if blank.side == Side::Outer { high - level } else { level - low };
    depth >= least
}

/// Whether there is stock between the contours. Common pieces at both ends are skipped: there is none between them.
fn stands(stock: &Stock) -> bool {
    let (rough, blank) = (&stock.rough.pieces, &stock.blank.pieces);
    let same = |(one, other): &(&Piece, &Piece)| one == other;
    let before = rough.iter().zip(blank).take_while(same).count();
    let behind = rough.iter().skip(before).rev().zip(blank.iter().skip(before).rev()).take_while(same).count();
    let rest = |contour: &Contour| {
        let pieces = contour.pieces.get(before..contour.pieces.len() - behind).unwrap_or_default();
        Contour { side: contour.side, pieces: pieces.to_vec() }
    };
    !rough.is_empty() && between(&rest(&stock.blank), &rest(&stock.rough)).area_mm2.0 > 1e-4
}

/// A contour with a closed part bridged level from its lower lip.
fn bridge(rough: &Contour, part: &ZonePart) -> Option<Contour> {
    let outer = rough.side == Side::Outer;
    let (first, last) = (part.contour.first()?.from, part.contour.last()?.to);
    // For a bore, the lower lip is the one with the larger radius.
    let lip = if outer { first.radius.min(last.radius) } else { first.radius.max(last.radius) };
    let crossed = |piece: &Piece| piece.at_radius(lip).first().copied();
    let from = part.contour.iter().find_map(crossed)?;
    let to = part.contour.iter().rev().find_map(|piece| piece.at_radius(lip).last().copied())?;
    if from.z >= to.z {
        return None;
    }
    let over = Piece::line(from, to);
    let mut pieces = cut(rough, rough.start()?, from);
    pieces.push(over);
    pieces.extend(cut(rough, to, rough.end()?));
    Some(Contour { side: rough.side, pieces })
}

/// Points nearer than this to a piece are on it: ends of pieces are rounded.
const NEAR: Half = Half::new(4);

/// The pieces of a contour between two of its points.
pub(super) fn cut(contour: &Contour, from: Point, to: Point) -> Vec<Piece> {
    let lies = |piece: &Piece, point: Point| {
        if point.z < piece.from.z - NEAR || piece.to.z + NEAR < point.z {
            return false;
        }
        let on = if piece.is_face() { piece.at_radius(point.radius) } else { piece.at_z(point.z) };
        on.iter().any(|at| at.to(point).length() < NEAR.to_mm())
    };
    let mut pieces = Vec::new();
    let mut inside = false;
    for piece in &contour.pieces {
        let (mut start, mut end) = (piece.from, piece.to);
        if !inside && piece.to != from && lies(piece, from) {
            inside = true;
            start = from;
        }
        if inside {
            let last = lies(piece, to) && piece.from != to;
            if last {
                end = to;
            }
            pieces.push(piece.between(start, end));
            if last {
                break;
            }
        }
    }
    pieces.retain(|piece| !piece.is_nothing());
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::Turn;
    use crate::turning::point::at;

    /// A pin of radius 10, a fillet of 10 up to 20, a cylinder. The centre of the fillet is (20, 20), so its radius is
    /// 14 at z = 20 + √(100 − 36) = 28.
    fn pin() -> Contour {
        let mut pin = Contour::through(Side::Outer, &[at(10.0, 0.0), at(10.0, 20.0)]);
        pin.pieces.push(Piece::arc(at(10.0, 20.0), at(20.0, 30.0), Half::from(10.0), Turn::Left));
        pin.pieces.push(Piece::line(at(20.0, 30.0), at(20.0, 40.0)));
        pin
    }

    #[test]
    fn a_contour_is_parted_at_a_level() {
        let over = raised(&pin(), Half::from(14.0));
        assert_eq!(over.corners(), [at(14.0, 0.0), at(14.0, 28.0), at(20.0, 30.0), at(20.0, 40.0)]);
        assert!(over.hangs_together());
    }

    #[test]
    fn a_bore_is_parted_the_other_way() {
        let bore = pin().inside_out(Half::from(50.0));
        let over = raised(&bore, Half::from(36.0));
        assert_eq!(over, raised(&pin(), Half::from(14.0)).inside_out(Half::from(50.0)));
    }
}
