//! The feeds along a finishing pass: each move has that of the surface which the nose touches on it.

use crate::turning::contour::{Curve, Piece};
use crate::turning::length::Half;
use crate::turning::nose::Nose;
use crate::turning::point::{Point, Vector};
use crate::turning::toolpath::{Move, Purpose, Toolpath};
use crate::units::MillimetresPerRev;

/// The feed of a surface.
pub(super) struct OwnFeed<'a> {
    /// Its pieces, in the coordinates of the set-up.
    pub pieces: &'a [Piece],
    /// The feed.
    pub feed: MillimetresPerRev,
}

/// Distances that differ by no more are equal, mm: the nose touches both surfaces.
const SAME: f64 = 0.005;

/// A finishing path with the feed of each surface on its moves; `base` is that of the pass.
///
/// The middle of a move tells its surface: the one nearest to the centre of the nose. On a corner between two it has the slower
/// feed. A move along a cylinder that lies on several surfaces is divided where the nose passes from one to the next.
pub(super) fn with_feeds(path: &Toolpath, feeds: &[OwnFeed<'_>], nose: Nose, base: MillimetresPerRev) -> Toolpath {
    let mut made = Toolpath::at(path.from);
    for (piece, purpose) in path.pieces() {
        if purpose != Purpose::Finish {
            made.moves.push(Move::along(piece, purpose));
            continue;
        }
        for part in divided(piece, feeds, nose) {
            let own = touched(part, feeds, nose).filter(|feed| *feed != base);
            // Equal feeds along one cylinder stay one move.
            let on = made
                .moves
                .last_mut()
                .filter(|last| part.from != piece.from && last.feed == own && last.purpose == Purpose::Finish);
            match on {
                Some(last) => last.to = part.to,
                None => made.moves.push(Move { feed: own, ..Move::along(part, purpose) }),
            }
        }
    }
    made
}

/// A move along a cylinder, divided at the ends of the surfaces; any other as it is.
fn divided(piece: Piece, feeds: &[OwnFeed<'_>], nose: Nose) -> Vec<Piece> {
    if !piece.is_cylinder() {
        return vec![piece];
    }
    let tip = Half::from(nose.tip.of(nose.radius).z);
    let (first, last) = (piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z));
    let ends = feeds
        .iter()
        .flat_map(|one| [one.pieces.first().map(|piece| piece.from), one.pieces.last().map(|piece| piece.to)]);
    // A wall ends the cylinder itself; there the reference point and not the nose is beside it.
    let mut at: Vec<Half> = ends.flatten().filter(|end| on_cylinder(*end, piece)).map(|end| end.z + tip).collect();
    at.retain(|z| first < *z && *z < last);
    at.sort_unstable();
    at.dedup();
    if piece.from.z > piece.to.z {
        at.reverse();
    }
    let mut from = piece.from;
    let mut parts = Vec::new();
    for z in at {
        let to = Point { z, ..from };
        parts.push(Piece::line(from, to));
        from = to;
    }
    parts.push(Piece::line(from, piece.to));
    parts
}

/// Whether a point lies on the surface that a move along a cylinder makes.
fn on_cylinder(point: Point, piece: Piece) -> bool {
    (point.radius - piece.from.radius).to_mm().abs() <= SAME
}

/// The feed of the surface that the nose touches in the middle of a move.
fn touched(piece: Piece, feeds: &[OwnFeed<'_>], nose: Nose) -> Option<MillimetresPerRev> {
    let centre = middle(piece).minus(nose.tip.of(nose.radius));
    let beside = |piece: &Piece| {
        let [one, other] = [piece.from, piece.to].map(|end| end.z.to_mm());
        (one.min(other) - centre.z).max(centre.z - one.max(other))
    };
    // What lies farther off along the axis alone is no nearer.
    let near = |one: &OwnFeed<'_>| {
        let nearer = |least: f64, piece: &Piece| {
            if beside(piece) > least { least } else { least.min(distance(centre, *piece)) }
        };
        one.pieces.iter().fold(f64::INFINITY, nearer)
    };
    let distances: Vec<(f64, MillimetresPerRev)> = feeds.iter().map(|one| (near(one), one.feed)).collect();
    let least = distances.iter().map(|(distance, _)| *distance).fold(f64::INFINITY, f64::min);
    let touching = distances.into_iter().filter(|(distance, _)| *distance <= least + SAME).map(|(_, feed)| feed);
    touching.min_by(|one, other| one.0.total_cmp(&other.0))
}

/// The point halfway along a piece.
fn middle(piece: Piece) -> Vector {
    let half = piece.from.vector().plus(piece.to.vector()).times(0.5);
    match (piece.curve, piece.centre()) {
        (Curve::Arc { radius, .. }, Some(centre)) => {
            // Half a circle at most: its middle is on the far side of the chord from the centre, or beside it.
            let out = half.minus(centre);
            let out = if out.length() > 1e-6 { out } else { piece.chord().left() };
            let point = Point::at(centre.plus(out.unit().times(radius.to_mm())));
            if piece.holds(point) { point.vector() } else { centre.minus(out.unit().times(radius.to_mm())) }
        }
        _ => half,
    }
}

/// The distance of a place from a piece, mm.
fn distance(place: Vector, piece: Piece) -> f64 {
    let from_ends = place.minus(piece.from.vector()).length().min(place.minus(piece.to.vector()).length());
    let foot = match (piece.curve, piece.centre()) {
        (Curve::Arc { radius, .. }, Some(centre)) => centre.plus(place.minus(centre).unit().times(radius.to_mm())),
        _ => {
            let along = piece.chord().unit();
            piece.from.vector().plus(along.times(place.minus(piece.from.vector()).dot(along)))
        }
    };
    if piece.holds(Point::at(foot)) { from_ends.min(place.minus(foot).length()) } else { from_ends }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::{Contour, Side};
    use crate::turning::jobs::Tip;
    use crate::turning::point::at;

    /// A pin with two seats of one diameter, a cone and a wall. The nose touches the second seat where the reference point is
    /// 0.8 past its beginning at Z 10; the cone rises by 30° from Z 30, so that its offset begins at
    /// 30 + 0.8·(1 − tan 15°) = 30.5856.
    #[test]
    fn each_move_has_the_feed_of_the_surface_that_the_nose_touches() {
        let points = [at(10.0, 0.0), at(10.0, 10.0), at(10.0, 30.0), at(15.7735, 40.0), at(20.0, 40.0)];
        let nose = Nose { radius: Half::from(0.8), tip: Tip { radial: -1, axial: 1 } };
        let pin = Contour::through(Side::Outer, &points);
        let feed = |index: usize| MillimetresPerRev([0.1, 0.2, 0.3, 0.2][index]);
        let pieces: Vec<[Piece; 1]> = pin.pieces.iter().map(|piece| [*piece]).collect();
        let feeds: Vec<OwnFeed<'_>> =
            pieces.iter().enumerate().map(|(index, pieces)| OwnFeed { pieces, feed: feed(index) }).collect();
        let whole = Contour::through(Side::Outer, &[points[0], points[2], points[3], points[4]]);
        let seen = nose.seen(&whole).unwrap();
        let mut path = Toolpath::at(at(10.0, -2.0));
        seen.pieces.iter().for_each(|piece| {
            path.go(piece.from, Purpose::Finish);
            path.follow(*piece, Purpose::Finish);
        });
        path.go(at(25.0, 39.5), Purpose::Rapid);
        let made = with_feeds(&path, &feeds, nose, MillimetresPerRev(0.2));
        let told: Vec<(Half, Half, Option<f64>)> =
            made.moves.iter().map(|one| (one.to.radius, one.to.z, one.feed.map(|feed| feed.0))).collect();
        let half = Half::from;
        assert_eq!(told[0], (half(10.0), Half::ZERO, Some(0.1)));
        assert_eq!(told[1], (half(10.0), half(10.8), Some(0.1)));
        let cone = told[2];
        assert_eq!((cone.0, cone.2), (half(10.0), None));
        assert!((cone.1.to_mm() - 30.5856).abs() < 0.002, "{told:?}");
        assert_eq!(told[3].2, Some(0.3));
        assert_eq!(told.last(), Some(&(half(25.0), half(39.5), None)));
        assert_eq!(told[told.len() - 2].2, None);
    }
}
