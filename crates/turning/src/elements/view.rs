//! A contour as the tool sees it: from outside, feeding to the right. A bore is turned inside out, and a tool of the
//! other hand gets the mirror image, so that reach is calculated for one case only.

use crate::turning::contour::{Contour, Curve, Piece, Profile, Side, Turn};
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

use super::Hand;

/// A part of a piece that only rises or only falls, and does not change its direction along Z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Bit {
    /// The index of its surface.
    pub surface: usize,
    /// The index of its piece on the contour; none for a part of a bridge.
    pub origin: Option<usize>,
    /// Its course, as the tool sees it.
    pub piece: Piece,
}

/// The direction of the view.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// The largest radius of a bore, from which radii count inwards; none for an outer contour.
    top: Option<Half>,
    mirrored: bool,
}

impl View {
    pub fn new(profile: &Profile, hand: Hand) -> Self {
        let most = || profile.contour().radii().map_or(Half::ZERO, |(_, most)| most);
        Self { top: (profile.side == Side::Inner).then(most), mirrored: hand == Hand::Left }
    }

    /// The bits of a profile in the order of the feed.
    pub fn bits(self, profile: &Profile) -> Vec<Bit> {
        let pieces = profile.surfaces.iter().enumerate();
        let pieces = pieces.flat_map(|(surface, one)| one.pieces.iter().map(move |piece| (surface, *piece)));
        let mut seen: Vec<Bit> = Vec::new();
        for (origin, (surface, piece)) in pieces.enumerate() {
            let bit = |piece| Bit { surface, origin: Some(origin), piece };
            seen.extend(quarters(self.forth(piece)).into_iter().map(bit));
        }
        if self.mirrored {
            // `forth` reversed each piece, so the bits of a piece are in the order of the feed; now the pieces are put
            // in it.
            let mut order: Vec<Vec<Bit>> = seen.chunk_by(|a, b| a.origin == b.origin).map(<[Bit]>::to_vec).collect();
            order.reverse();
            seen = order.concat();
        }
        seen
    }

    /// A piece of the part as the tool sees it.
    fn forth(self, piece: Piece) -> Piece {
        let flipped = self.top.map_or(piece, |top| piece.inside_out(top));
        if self.mirrored {
            flipped.mapped(true, |at| Point::new(at.radius, Half::ZERO - at.z)).reversed()
        } else {
            flipped
        }
    }

    /// Bits as pieces of the part from the free end. Bits of one piece are joined, and so are lines along or across the
    /// axis that continue each other.
    pub fn back(self, bits: &[Bit]) -> Vec<Piece> {
        let mut joined: Vec<Bit> = Vec::new();
        for bit in bits.iter().filter(|bit| !bit.piece.is_nothing()) {
            match joined.last_mut() {
                Some(last) if goes_on(last, bit) => last.piece = last.piece.between(last.piece.from, bit.piece.to),
                _ => joined.push(*bit),
            }
        }
        // The transformation is its own inverse.
        let mut pieces: Vec<Piece> = joined.into_iter().map(|bit| self.forth(bit.piece)).collect();
        if self.mirrored {
            pieces.reverse();
        }
        pieces
    }

    /// A point back.
    pub fn point(self, at: Point) -> Point {
        self.forth(Piece::line(at, at)).from
    }

    /// Whether the order of the feed is the reverse of that of the part.
    pub const fn mirrored(self) -> bool {
        self.mirrored
    }
}

/// Whether one bit is the end of the other.
fn goes_on(last: &Bit, next: &Bit) -> bool {
    let (a, b) = (last.piece, next.piece);
    let one_arc = last.origin.is_some() && last.origin == next.origin && a.curve == b.curve && a.curve != Curve::Line;
    let same_way = a.chord().dot(b.chord()) > 0.0;
    let one_line = (a.is_face() && b.is_face() || a.is_cylinder() && b.is_cylinder()) && same_way;
    let one_slope = last.origin.is_some() && last.origin == next.origin && a.curve == Curve::Line;
    a.to == b.from && (one_arc || one_line || one_slope)
}

/// A piece cut where it is level or upright.
pub fn quarters(piece: Piece) -> Vec<Piece> {
    let mut corners = piece.extremes();
    let away = |at: &Point| piece.from.to(*at).length();
    corners.sort_by(|a, b| away(a).total_cmp(&away(b)));
    // An extreme within a micrometre of an end is the rounded end.
    corners
        .retain(|at| *at == piece.from || *at == piece.to || (away(at) > 0.0015 && at.to(piece.to).length() > 0.0015));
    corners.dedup();
    corners.iter().zip(corners.iter().skip(1)).map(|(from, to)| piece.between(*from, *to)).collect()
}

/// Pieces as the tool sees them, as an outer contour.
pub fn outer(pieces: Vec<Piece>) -> Contour {
    Contour { side: Side::Outer, pieces }
}

/// The steepest rise and the steepest fall of a piece, degrees in [0, 180]; above 90 it runs back.
pub fn steepness(piece: Piece) -> (f64, f64) {
    let start = upright(piece.direction_at_start());
    let (least, most) = match piece.curve {
        Curve::Line => (start, start),
        Curve::Arc { radius, turn } => {
            let swept = (piece.length_mm() / radius.to_mm().max(f64::MIN_POSITIVE)).to_degrees();
            if turn == Turn::Left { (start, start + swept) } else { (start - swept, start) }
        }
    };
    let rise = if least < -180.0 { 180.0 } else { most.clamp(0.0, 180.0) };
    let fall = if most > 180.0 { 180.0 } else { (-least).clamp(0.0, 180.0) };
    (rise, fall)
}

/// A direction in degrees; straight back counts as rising.
fn upright(direction: Vector) -> f64 {
    let degrees = direction.degrees();
    if degrees <= -180.0 { 180.0 } else { degrees }
}
