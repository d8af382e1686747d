//! Raises a contour to a level, which separates the upper part of a stock from the lower one.

use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;

/// The greater of a monotone outer contour and a level; for a bore the smaller.
pub(super) fn raised(contour: &Contour, level: Half) -> Contour {
    let above = contour.side == Side::Outer;
    let mut pieces: Vec<Piece> = Vec::new();
    let mut put = |piece: Piece| match pieces.last_mut() {
        _ if piece.is_nothing() => {}
        Some(last) if last.is_cylinder() && piece.is_cylinder() && last.to == piece.from => last.to = piece.to,
        _ => pieces.push(piece),
    };
    for piece in &contour.pieces {
        let mut points = vec![piece.from];
        points.extend(piece.at_radius(level).into_iter().filter(|at| *at != piece.from && *at != piece.to));
        points.push(piece.to);
        for (from, to) in points.iter().zip(points.iter().skip(1)) {
            let part = piece.between(*from, *to);
            // The extremes of the part say on which side of the level it lies; its ends may touch the level.
            let (least, most) = part.radii();
            let kept = if above { most > level } else { least < level };
            if kept {
                put(part);
            } else {
                let on = |point: &Point| Point { radius: level, z: point.z };
                put(Piece::line(on(from), on(to)));
            }
        }
    }
    Contour { side: contour.side, pieces }
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
