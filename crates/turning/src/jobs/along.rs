//! One pass along a whole contour: the toolpath of finishing.

use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};
use crate::turning::toolpath::{Purpose, Toolpath};

/// The clearances of the tool.
#[derive(Clone, Copy, Debug)]
pub struct Clearance {
    /// The distance before the metal where the feed begins.
    pub approach: Half,
    /// The retract from a finished surface.
    pub retract: Half,
    /// The greatest height of a wall that the edge may cut while it rises.
    pub wall: Half,
    /// The least distance of the tool from the axis, in a bore: its bar must not touch the wall on the other side.
    pub nearest: Half,
}

/// The toolpath along a contour through the stock above it, both offset for the reference point of the tool
/// ([`crate::turning::nose`]).
///
/// 1. A face at the free end is cut first, from outside towards the axis: there the secondary edge cuts, and the
///    starting corner of the rest is left clean.
/// 2. So is a wall higher than the edge: if the tool cut it upwards, its holder would hit the metal above.
/// 3. The rest begins on the extension of its first piece, off the metal by the approach, and is followed to its end.
/// 4. The tool retracts on both axes and leaves above all metal.
///
/// For a bore the same, inside out.
pub fn along(contour: &Contour, standing: &Contour, clearance: Clearance) -> Toolpath {
    seen_outside(contour, standing, clearance.nearest, |contour, standing, ceiling| {
        outside(contour, standing, ceiling, clearance)
    })
}

/// The toolpath along a hollow from lip to lip, down to its beginning and up from its end. It begins and ends above
/// the metal beside it, at a home point outside the whole side.
pub fn dip(contour: &Contour, standing: &Contour, clearance: Clearance) -> Toolpath {
    seen_outside(contour, standing, clearance.nearest, |contour, standing, ceiling| {
        let Clearance { approach, retract, .. } = clearance;
        let limited = |radius: Half| ceiling.map_or(radius, |ceiling: Half| radius.min(ceiling));
        let (Some(start), Some(end), Some(first)) = (contour.start(), contour.end(), standing.start()) else {
            return Toolpath::default();
        };
        let most = standing.radii().map_or(Half::ZERO, |(_, most)| most);
        let clear = limited(most + approach);
        let home = Point { radius: clear, z: first.z - approach };
        let mut path = Toolpath::at(home);
        path.go(Point { radius: clear, z: start.z }, Purpose::Rapid);
        path.go(Point { radius: limited(start.radius + approach).min(clear), z: start.z }, Purpose::Rapid);
        path.go(start, Purpose::Finish);
        for piece in joined(&contour.pieces) {
            path.follow(piece, Purpose::Finish);
        }
        // A larger nose has left its round before the wall behind: away from it at feed, then out.
        let (radius, off) = (limited(end.radius + retract), end.z - retract);
        let fits = contour.pieces.last().is_some_and(|last| last.from.z < off);
        let z = if fits { off } else { end.z };
        if fits {
            path.go(Point { radius, z }, Purpose::Return);
        }
        path.go(Point { radius: clear, z }, Purpose::Rapid);
        path.go(home, Purpose::Rapid);
        path
    })
}

/// A toolpath is made for the outside; a bore is turned inside out first.
fn seen_outside(
    contour: &Contour,
    standing: &Contour,
    nearest: Half,
    make_path: impl FnOnce(&Contour, &Contour, Option<Half>) -> Toolpath,
) -> Toolpath {
    if contour.side == Side::Outer {
        return make_path(contour, standing, None);
    }
    let most = |contour: &Contour| contour.radii().map_or(Half::ZERO, |(_, most)| most);
    let top = most(contour).max(most(standing));
    let seen = make_path(&contour.inside_out(top), &standing.inside_out(top), Some(top - nearest));
    seen.inside_out(top)
}

/// The toolpath outside; `ceiling` is as near to the axis as the tool may come, for a bore seen inside out.
fn outside(contour: &Contour, standing: &Contour, ceiling: Option<Half>, clearance: Clearance) -> Toolpath {
    let Clearance { approach, retract, wall, .. } = clearance;
    let limited = |radius: Half| ceiling.map_or(radius, |ceiling| radius.min(ceiling));
    let (Some(start), Some(end)) = (contour.start(), contour.end()) else { return Toolpath::default() };
    let most = |contour: &Contour| contour.radii().map_or(Half::ZERO, |(_, most)| most);
    let clear = limited(most(contour).max(most(standing)) + approach);
    let first_z = standing.start().map_or(start.z, |first| first.z.min(start.z));
    let home = Point { radius: clear, z: first_z - approach };
    let mut path = Toolpath::at(home);
    let (face, rest) = contour.split_at_face();
    if let (Some(first), Some(last), None) = (face.first(), face.last(), ceiling) {
        let stands = standing.radii_at(first.from.z).map_or(last.to.radius, |(_, most)| most.max(last.to.radius));
        let outside = Point { radius: stands + approach, z: first.from.z };
        path.go(Point { radius: outside.radius, z: home.z }, Purpose::Rapid);
        path.go(outside, Purpose::Rapid);
        path.go(first.from, Purpose::Finish);
        path.go(Point { radius: first.from.radius, z: first.from.z - retract }, Purpose::Rapid);
    }
    if ceiling.is_none() {
        for (before, face) in walls(rest, wall) {
            let stands = standing.radii_at(face.from.z).map_or(face.to.radius, |(_, most)| most.max(face.to.radius));
            // Metal above the foot, with the rounding of the roughing nose, is cut with the piece before it.
            let foot = standing
                .radii_at((face.from.z - approach).max(before.from.z))
                .map_or(face.from.radius, |(_, most)| most);
            let (above, foot) = (stands + approach, foot.max(face.from.radius) + approach);
            if foot >= face.to.radius {
                continue;
            }
            path.go(Point { radius: clear, z: path.end().z }, Purpose::Rapid);
            path.go(Point { radius: clear, z: face.from.z }, Purpose::Rapid);
            path.go(Point { radius: above, z: face.from.z }, Purpose::Rapid);
            path.go(Point { radius: foot, z: face.from.z }, Purpose::Finish);
            let off = face.from.z - retract;
            path.go(Point { radius: foot + retract, z: off }, Purpose::Rapid);
            path.go(Point { radius: clear, z: off }, Purpose::Rapid);
        }
    }
    if let Some(first) = rest.first() {
        // On the axis there is metal all round, so the tool enters along the axis.
        let ahead = if first.from.radius <= Half::ZERO { Vector::new(1.0, 0.0) } else { first.direction_at_start() };
        let before = first.from.moved(ahead.times(-approach.to_mm()));
        let before = Point { radius: limited(before.radius), z: before.z };
        let z = before.z.min(home.z).min(path.end().z);
        path.go(Point { radius: path.end().radius, z }, Purpose::Rapid);
        path.go(Point { radius: before.radius, z }, Purpose::Rapid);
        path.go(before, Purpose::Rapid);
        path.go(first.from, Purpose::Finish);
        for piece in joined(rest) {
            path.follow(piece, Purpose::Finish);
        }
        path.go(Point { radius: limited(end.radius + retract), z: end.z - retract }, Purpose::Rapid);
    }
    // A bore is left along its wall, past its narrowest place: a bar has no room for crossing the bore.
    let aside = if ceiling.is_some() {
        limited((most(contour) + retract).max(path.end().radius))
    } else {
        clear.max(path.end().radius)
    };
    path.go(Point { radius: aside, z: path.end().z }, Purpose::Rapid);
    path.go(Point { radius: aside, z: home.z }, Purpose::Rapid);
    path.go(home, Purpose::Rapid);
    path
}

/// Walls higher than that, with the piece before each.
fn walls(pieces: &[Piece], higher: Half) -> impl Iterator<Item = (&Piece, &Piece)> {
    let pairs = pieces.iter().zip(pieces.iter().skip(1));
    pairs.filter(move |(_, face)| face.is_face() && face.to.radius - face.from.radius > higher)
}

/// The pieces, with collinear lines joined.
fn joined(pieces: &[Piece]) -> Vec<Piece> {
    let mut joined: Vec<Piece> = Vec::new();
    for piece in pieces {
        match joined.last_mut() {
            Some(last) if last.is_cylinder() && piece.is_cylinder() && last.to == piece.from => last.to = piece.to,
            _ => joined.push(*piece),
        }
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::at;

    const CLEARANCE: Clearance =
        Clearance { approach: Half::new(4000), retract: Half::new(1000), wall: Half::new(20_000), nearest: Half::ZERO };

    /// A pin of radius 10 with a flange of 15, 0.5 to finish everywhere; the nose has 0.8.
    #[test]
    fn the_face_comes_first_and_the_rest_is_one_way() {
        let pin = [at(-0.8, 0.0), at(10.0, 0.0), at(10.0, 20.0), at(15.0, 20.0), at(15.0, 40.0)];
        let rough = [at(-0.8, -0.5), at(10.5, -0.5), at(10.5, 19.5), at(15.5, 19.5), at(15.5, 40.0)];
        let path = along(&Contour::through(Side::Outer, &pin), &Contour::through(Side::Outer, &rough), CLEARANCE);
        let ends: Vec<Point> = path.moves.iter().map(|one| one.to).collect();
        let home = at(17.5, -2.5);
        let expected = [
            at(12.5, -2.5),
            at(12.5, 0.0),
            at(-0.8, 0.0),
            at(-0.8, -0.5),
            at(-0.8, -2.5),
            at(10.0, -2.5),
            at(10.0, -2.0),
            at(10.0, 0.0),
            at(10.0, 20.0),
            at(15.0, 20.0),
            at(15.0, 40.0),
            at(15.5, 39.5),
            at(17.5, 39.5),
            home,
        ];
        assert_eq!((path.from, ends), (home, expected.to_vec()));
    }

    /// A flange of 30 on the pin, higher than the 10 that the edge may cut upwards: its wall is cut first, from outside down
    /// to 2 over the 0.5 that stand on the pin.
    #[test]
    fn a_high_wall_is_cut_downwards() {
        let pin = [at(10.0, 0.0), at(10.0, 20.0), at(30.0, 20.0), at(30.0, 40.0)];
        let rough = [at(10.5, 0.0), at(10.5, 19.5), at(30.5, 19.5), at(30.5, 40.0)];
        let path = along(&Contour::through(Side::Outer, &pin), &Contour::through(Side::Outer, &rough), CLEARANCE);
        let ends: Vec<(Point, Purpose)> = path.moves.iter().map(|one| (one.to, one.purpose)).collect();
        let wall = [
            (at(32.5, 20.0), Purpose::Rapid),
            (at(12.5, 20.0), Purpose::Finish),
            (at(13.0, 19.5), Purpose::Rapid),
            (at(32.5, 19.5), Purpose::Rapid),
        ];
        assert_eq!(ends.get(..4), Some(&wall[..]), "{ends:?}");
        let rest: Vec<Point> = ends.iter().filter(|one| one.1 == Purpose::Finish).skip(1).map(|one| one.0).collect();
        assert_eq!(rest, [at(10.0, 0.0), at(10.0, 20.0), at(30.0, 20.0), at(30.0, 40.0)]);
    }

    /// A bore of 20 with a step of 25 at its mouth: in at the mouth, out towards the axis and along it.
    #[test]
    fn a_bore_is_left_through_its_mouth() {
        let bore = [at(12.5, 0.0), at(12.5, 10.0), at(10.0, 10.0), at(10.0, 30.0)];
        let rough = [at(12.2, 0.0), at(12.2, 9.5), at(9.7, 9.5), at(9.7, 30.0)];
        let path = along(&Contour::through(Side::Inner, &bore), &Contour::through(Side::Inner, &rough), CLEARANCE);
        let ends: Vec<Point> = path.moves.iter().map(|one| one.to).collect();
        let home = at(7.7, -2.0);
        assert_eq!(path.from, home);
        assert_eq!(ends.first(), Some(&at(12.5, -2.0)));
        assert_eq!(ends.get(ends.len() - 3..), Some([at(9.5, 29.5), at(9.5, -2.0), home].as_slice()));
    }
}
