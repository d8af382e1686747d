//! Contours cut to a range of Z.

use crate::turning::contour::{Contour, Piece};
use crate::turning::length::Half;

/// The part of a monotone contour between two Z. Faces at its ends are kept if they are walls of that part: at its end
/// those that rise, at its beginning those that fall.
pub(super) fn between(contour: &Contour, from: Half, to: Half) -> Contour {
    let mut pieces: Vec<Piece> = Vec::new();
    for piece in &contour.pieces {
        if piece.is_face() {
            let rises = piece.to.radius > piece.from.radius;
            let inside = from < piece.from.z && piece.from.z < to;
            if inside || (piece.from.z == to && rises) || (piece.from.z == from && !rises) {
                pieces.push(*piece);
            }
            continue;
        }
        let (start, end) = (piece.from.z.max(from), piece.to.z.min(to));
        if start >= end {
            continue;
        }
        let at = |z: Half, own| if z == own { None } else { piece.at_z(z).first().copied() };
        let begin = at(start, piece.from.z).unwrap_or(piece.from);
        let stop = at(end, piece.to.z).unwrap_or(piece.to);
        if begin.z < stop.z {
            pieces.push(piece.between(begin, stop));
        }
    }
    // A wall at the beginning is not connected if no piece begins where it ends.
    Contour { side: contour.side, pieces }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::Side;
    use crate::turning::point::at;

    #[test]
    fn the_end_face_goes_and_the_shoulder_ahead_stays() {
        let pin = Contour::through(
            Side::Outer,
            &[at(0.0, 0.0), at(10.0, 0.0), at(12.0, 2.0), at(12.0, 20.0), at(30.0, 20.0), at(30.0, 40.0)],
        );
        let first = between(&pin, Half::ZERO, Half::from(20.0));
        assert_eq!(first.corners(), [at(10.0, 0.0), at(12.0, 2.0), at(12.0, 20.0), at(30.0, 20.0)]);
        let cut = between(&pin, Half::from(1.0), Half::from(10.0));
        assert_eq!(cut.corners(), [at(11.0, 1.0), at(12.0, 2.0), at(12.0, 10.0)]);
        assert!(cut.hangs_together());
    }
}
