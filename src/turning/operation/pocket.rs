//! The parts of a zone that are worked one after the other (lecture 12.4, l. 504-518; fig. 12.3 г).
//!
//! 1. Closed parts are bridged level from lip to lip; each is a stock of its own, the last in the order.
//! 2. Where the open parts have a scheme of their own, they come first: all that stands above their floor, from the free
//!    end on, because nobody comes to them past what stands before them.
//! 3. Then what is left below that floor.
//!
//! Neighbours of one kind stay together: parting at every face costs a return for each (lecture, fig. 12.5 a).

use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::transitions::Stock;
use crate::turning::zones::{Kind, Part, Zone};

use super::clip;
use super::level::{lowered, raised};

/// A stock to be cleared by one scheme.
#[derive(Clone, Debug)]
pub(super) struct Piecework {
    /// What stands, in the coordinates of the set-up.
    pub stock: Stock,
    /// Its place in the schemes of the zone.
    pub scheme: usize,
}

/// What of a zone is cleared by itself, in the order of work.
pub(super) fn pieceworks(zone: &Zone, rough: &Contour, blank: &Contour) -> Vec<Piecework> {
    let (from, to) = (zone.from_z, zone.to_z);
    let stock = |rough: &Contour, blank: &Contour, from: Half, to: Half| Stock {
        rough: clip::between(rough, from, to),
        blank: clip::between(blank, from, to),
        from,
        to,
    };
    let each = zone.scheme.parts_worked == "each";
    if !each && zone.scheme.parts_worked != "joined" {
        return vec![Piecework { stock: stock(rough, blank, from, to), scheme: 0 }];
    }
    let last = zone.scheme.schemes.len().saturating_sub(1);
    let mut pockets = Vec::new();
    let mut bridged = rough.clone();
    for part in zone.parts.iter().filter(|part| part.kind == Kind::Closed) {
        if let Some((over, pocket)) = bridge(&bridged, part) {
            pockets.push(Piecework { stock: pocket, scheme: last });
            bridged = over;
        }
    }
    let mut works = Vec::new();
    let has = |kind: Kind| zone.parts.iter().any(|part| part.kind == kind);
    match floor(zone, rough.side).filter(|_| each && has(Kind::HalfOpen)) {
        Some((level, end)) => {
            // Of a shaped blank the upper part may begin later.
            let over = raised(blank, level)
                .pieces
                .into_iter()
                .find(|piece| !piece.is_face() && lies_over(piece, level, rough.side));
            let begin = over.map_or(from, |piece| piece.from.z.max(from));
            works.push(Piecework { stock: stock(&raised(&bridged, level), blank, begin, to), scheme: 0 });
            let rest = stock(&lowered(&bridged, level), &lowered(blank, level), from, end);
            works.push(Piecework { stock: rest, scheme: 1.min(last) });
        }
        None => works.push(Piecework { stock: stock(&bridged, blank, from, to), scheme: 0 }),
    }
    works.extend(pockets);
    works.retain(|work| stands(&work.stock));
    works
}

/// The floor of the open parts, and Z where the last of the other parts ends.
fn floor(zone: &Zone, side: Side) -> Option<(Half, Half)> {
    let open = zone.parts.iter().filter(|part| part.kind == Kind::Open);
    let level = match side {
        Side::Outer => open.map(|part| part.least_radius).min(),
        Side::Inner => open.map(|part| part.greatest_radius).max(),
    };
    let end = zone.parts.iter().filter(|part| part.kind == Kind::HalfOpen).map(|part| part.to_z).max();
    level.zip(end)
}

/// Whether a piece lies above a level anywhere; of a bore below.
fn lies_over(piece: &Piece, level: Half, side: Side) -> bool {
    let over = |radius: Half| if side == Side::Outer { radius > level } else { radius < level };
    piece.extremes().iter().any(|point| over(point.radius))
}

/// Whether anything stands between the contours of a stock.
fn stands(stock: &Stock) -> bool {
    let area = crate::turning::allowances::areas::between(&stock.blank, &stock.rough).area_mm2.0;
    !stock.rough.pieces.is_empty() && area > 1e-4
}

/// A contour with the pocket of a closed part bridged level from its lower lip, and the pocket under the bridge.
fn bridge(rough: &Contour, part: &Part) -> Option<(Contour, Stock)> {
    let outer = rough.side == Side::Outer;
    let (first, last) = (part.contour.first()?.from, part.contour.last()?.to);
    // From inside a bore the lower lip is that of the larger radius.
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
    // Over the whole part: what stands before the lips is no air.
    let bridged = Contour { side: rough.side, pieces };
    let pocket = Stock {
        rough: clip::between(rough, part.from_z, part.to_z),
        blank: clip::between(&bridged, part.from_z, part.to_z),
        from: part.from_z,
        to: part.to_z,
    };
    Some((bridged, pocket))
}

/// The pieces of a contour between two of its points.
fn cut(contour: &Contour, from: Point, to: Point) -> Vec<Piece> {
    let lies = |piece: &Piece, point: Point| {
        let on = if piece.is_face() { piece.at_radius(point.radius) } else { piece.at_z(point.z) };
        on.iter().any(|at| at.to(point).length() < 0.002)
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
