//! The outside that the first set-up leaves to the second one: what it has turned already, beyond the end of its own surfaces too, is
//! no stock any more.

use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::jobs::Work as JobWork;
use crate::turning::length::Half;

use super::work::ZoneWork;
use super::{SetUpWork, SideWork, clip};

/// The outside as the set-ups before have left it, in the coordinates of the part turned over; none where there was none before, or
/// where it did not clear its stock.
pub(super) fn turned(before: &[SetUpWork], length: Half) -> Option<Contour> {
    let first = before.last()?;
    let outer = |side: &&SideWork| side.side == Side::Outer && side.zones.iter().all(ZoneWork::is_cleared);
    let layers = &first.sides.iter().find(outer)?.layers;
    let finished = first.jobs.iter().any(|job| job.side == Side::Outer && job.work == JobWork::Finish);
    let left = if finished { &layers.left } else { &layers.rough };
    Some(left.turned_over(length))
}

/// What stands of a blank where the set-up before has turned all of its range; the blank itself where it has not. A collar of which
/// it has turned the last millimetre only is as deep to turn as ever.
pub(super) fn standing(blank: Contour, turned: &Contour) -> Contour {
    let (Some(start), Some(end), Some(from)) = (blank.start(), blank.end(), turned.start()) else { return blank };
    let left = clip::between(turned, start.z, end.z);
    let (Some(rim), Some(last)) = (left.start(), left.end()) else { return blank };
    if from.z > start.z || rim.z != start.z || last.z != end.z {
        return blank;
    }
    let mut pieces = left.pieces;
    if let Some(face) = blank.pieces.first().filter(|face| face.is_face() && face.from.radius < rim.radius) {
        pieces.insert(0, Piece::line(face.from, rim));
    }
    Contour { side: blank.side, pieces }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::Point;
    use crate::turning::point::at;

    fn outer(points: &[Point]) -> Contour {
        Contour::through(Side::Outer, points)
    }

    /// A bar of 18 parted 1 mm behind a pin of 16 that was turned past its end; and one of 60 before a collar of 40 of which the last
    /// 2 mm are turned.
    #[test]
    fn what_was_turned_is_no_stock() {
        let bar = outer(&[at(0.0, -1.0), at(9.0, -1.0), at(9.0, 1.0)]);
        let pin = outer(&[at(8.0, -1.0), at(8.0, 49.0), at(7.0, 50.0)]);
        assert_eq!(standing(bar, &pin).corners(), [at(0.0, -1.0), at(8.0, -1.0), at(8.0, 1.0)]);
        let bar = outer(&[at(0.0, -1.0), at(30.0, -1.0), at(30.0, 20.0)]);
        let collar = outer(&[at(20.0, 18.0), at(20.0, 20.0), at(15.0, 20.0), at(15.0, 60.0)]);
        assert_eq!(standing(bar.clone(), &collar), bar);
    }
}
