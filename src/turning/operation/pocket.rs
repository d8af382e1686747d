//! The parts of a zone that are worked one after the other: all of it, part after part, or the closed ones by themselves
//! with a line from lip to lip in their place until then (lecture 12.4, l. 504-518; fig. 12.3 г).

use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::transitions::Stock;
use crate::turning::zones::{Kind, Part, Zone};

use super::clip;

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
    let stock = |rough: &Contour, blank: &Contour, from: Half, to: Half| Stock {
        rough: clip::between(rough, from, to),
        blank: clip::between(blank, from, to),
        from,
        to,
    };
    match zone.scheme.parts_worked.as_str() {
        "each" => zone
            .parts
            .iter()
            .enumerate()
            .map(|(index, part)| Piecework { stock: stock(rough, blank, part.from_z, part.to_z), scheme: index })
            .collect(),
        "joined" => {
            let mut closed = Vec::new();
            let mut bridged = rough.clone();
            for part in zone.parts.iter().filter(|part| part.kind == Kind::Closed) {
                if let Some((over, pocket)) = bridge(&bridged, part) {
                    closed.push(pocket);
                    bridged = over;
                }
            }
            let first = Piecework { stock: stock(&bridged, blank, zone.from_z, zone.to_z), scheme: 0 };
            std::iter::once(first).chain(closed).collect()
        }
        _ => vec![Piecework { stock: stock(rough, blank, zone.from_z, zone.to_z), scheme: 0 }],
    }
}

/// A contour with the pocket of a closed part bridged level from its lower lip, and the pocket under the bridge.
fn bridge(rough: &Contour, part: &Part) -> Option<(Contour, Piecework)> {
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
    let under = cut(rough, from, to);
    let mut pieces = cut(rough, rough.start()?, from);
    pieces.push(over);
    pieces.extend(cut(rough, to, rough.end()?));
    let pocket = Stock {
        rough: Contour { side: rough.side, pieces: under },
        blank: Contour { side: rough.side, pieces: vec![over] },
        from: from.z,
        to: to.z,
    };
    Some((Contour { side: rough.side, pieces }, Piecework { stock: pocket, scheme: 1 }))
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
