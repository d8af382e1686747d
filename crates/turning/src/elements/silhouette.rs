//! The contour as seen from outside, across the axis: where it runs back towards the free end, it goes upright from the
//! foremost point instead. What a contouring tool could still reach there (a face that leans back by up to φ − 90°) is
//! left to finishing, because roughing works in levels over a contour that does not run back.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;

use super::bridge::BridgeSpan;
use super::view::Bit;

/// The outline of bits as seen from outside, with the bridges it needs.
pub(super) fn silhouette(bits: Vec<Bit>) -> (Vec<Bit>, Vec<BridgeSpan>) {
    let mut seen: Vec<Bit> = Vec::new();
    let mut spans = Vec::new();
    for bit in bits {
        let here = seen.last().map_or(bit.piece.from, |last| last.piece.to);
        if bit.piece.to.z < here.z && bit.piece.to.radius >= here.radius {
            spans.push(upright(&mut seen, bit));
        } else if bit.piece.from == here && bit.piece.to.z >= here.z {
            seen.push(bit);
        } else if let Some(at) = forward(bit.piece, here.z) {
            // After an undercut the outline goes on where the contour is visible again.
            seen.push(Bit { piece: Piece::line(here, at), origin: None, ..bit });
            seen.push(Bit { piece: bit.piece.between(at, bit.piece.to), ..bit });
        }
    }
    seen.retain(|bit| !bit.piece.is_nothing());
    (seen, spans)
}

/// Removes what lies under the end of a bit that runs back and outwards, and goes upright to that end.
fn upright(seen: &mut Vec<Bit>, bit: Bit) -> BridgeSpan {
    let lip = bit.piece.to;
    let mut under = vec![bit];
    let mut foot = bit.piece.from;
    while let Some(last) = seen.pop() {
        foot = last.piece.from;
        if last.piece.from.z < lip.z {
            foot = last.piece.at_z(lip.z).last().copied().unwrap_or(last.piece.from);
            seen.push(Bit { piece: last.piece.between(last.piece.from, foot), ..last });
            under.push(Bit { piece: last.piece.between(foot, last.piece.to), ..last });
            break;
        }
        under.push(last);
    }
    under.reverse();
    under.retain(|bit| !bit.piece.is_nothing());
    let foot = Point::new(foot.radius.min(lip.radius), lip.z);
    let over = Bit { surface: bit.surface, origin: None, piece: Piece::line(foot, lip) };
    seen.push(over);
    BridgeSpan { bits: (0, 0), under, over: vec![over], open: false }
}

/// Where a piece passes a Z on its way towards the chuck.
fn forward(piece: Piece, z: Half) -> Option<Point> {
    (piece.to.z > z).then(|| piece.at_z(z).last().copied().unwrap_or(piece.from))
}
