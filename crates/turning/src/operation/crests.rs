//! The turned cylinder of an outer thread: in the middle of the tolerance of its crests, not at the nominal diameter
//! of the drawing.

use crate::turning::contour::{Contour, Piece, Profile, Side, Surface, SurfaceKind};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::workpiece::Workpiece;

/// The cotangent of 30°.
const RAMP: f64 = 1.732_050_807_569;

/// The cotangent of 4°, which an edge with φ1 = 5° follows downwards.
const FALL: f64 = 14.300_666_256_712;

/// The cylinder of a thread, and its turned radius.
struct Lowered {
    thread: Piece,
    /// Where the groove or neck before it begins; its own beginning if there is none.
    begins: Half,
    /// Where the groove or neck behind it ends; its own end if there is none. None if nothing stands behind it.
    ends: Option<Half>,
    radius: Half,
}

/// A contour of a side with the cylinders of outer threads as turned. Neighbouring elements are joined to them.
pub fn turned(contour: Contour, profile: &Profile, workpiece: &Workpiece) -> Contour {
    let pieces = lowered(profile, workpiece).iter().fold(contour.pieces, lower);
    Contour { side: contour.side, pieces }
}

fn lowered(profile: &Profile, workpiece: &Workpiece) -> Vec<Lowered> {
    let mut all = Vec::new();
    for (index, surface) in profile.surfaces.iter().enumerate() {
        let outer = profile.side == Side::Outer && surface.kind == SurfaceKind::Thread;
        let ([thread], true) = (surface.pieces.as_slice(), outer) else { continue };
        let crests = workpiece.thread_on(&surface.name).and_then(|one| one.crests.as_ref());
        let (before, from) = profile.surfaces.split_at(index);
        let level = thread.from.radius;
        // A neck, or a groove, which begins and ends at the level of its thread.
        let under = |surface: &&Surface| {
            let flush = |piece: &Piece| piece.is_cylinder() && piece.from.radius == level;
            surface.pieces.iter().all(|piece| piece.radii().1 <= level && !flush(piece))
        };
        let before = before.iter().rev().take_while(under).last().and_then(|first| first.pieces.first());
        let begins = before.filter(|first| first.from.radius == level).map_or(thread.from.z, |first| first.from.z);
        let behind = from.iter().skip(1).take_while(under).last().and_then(|last| last.pieces.last());
        let ends = match behind {
            Some(last) if last.to.radius == level => Some(last.to.z),
            None if from.len() > 1 => Some(thread.to.z),
            _ => None,
        };
        all.extend(crests.map(|crests| Lowered { thread: *thread, begins, ends, radius: crests.middle_radius() }));
    }
    all
}

fn lower(mut pieces: Vec<Piece>, by: &Lowered) -> Vec<Piece> {
    let Lowered { thread, begins, ends, radius } = by;
    let is_it = |piece: &Piece| {
        piece.is_cylinder()
            && piece.from.radius == thread.from.radius
            && piece.from.z <= thread.from.z
            && thread.to.z <= piece.to.z
    };
    let Some(index) = pieces.iter().position(is_it) else { return pieces };
    let Some(whole) = pieces.get(index).copied() else { return pieces };
    let down = |point: Point| Point { radius: *radius, z: point.z };
    let mut made = Vec::new();
    // The elements before it.
    let mut from = down(thread.from);
    if whole.from.z < thread.from.z {
        // Down in what is cut away later, and no more steeply than edges follow a fall.
        let top = Point { z: (*begins).max(whole.from.z).min(thread.from.z), ..thread.from };
        let fall = Half::from((thread.from.radius - *radius).to_mm() * FALL);
        from = down(Point { z: thread.from.z.max(top.z + fall).min(whole.to.z), ..thread.from });
        made.push(Piece { to: top, ..whole });
        made.push(Piece::line(top, from));
    } else if let Some(before) = index.checked_sub(1).and_then(|before| pieces.get_mut(before)) {
        match before.at_radius(*radius).last() {
            Some(meets) if !before.is_cylinder() => {
                from = *meets;
                before.to = from;
            }
            _ => made.push(Piece::line(before.to, from)),
        }
    }
    // The cylinder itself, and the elements after it.
    let mut to = down(whole.to);
    let mut behind = Vec::new();
    if let Some(ends) = ends.filter(|ends| whole.to.z > *ends) {
        // Up at 30°, nearly as a nose rolls over a step that is lower than its radius: before an upright one it would stop
        // a whole radius too soon.
        let up = Point { radius: whole.to.radius, z: ends };
        let ramp = Half::from((up.radius - *radius).to_mm() * RAMP);
        to = down(Point { z: (up.z - ramp).max(from.z), ..up });
        behind.push(Piece::line(to, up));
        behind.push(Piece { from: up, ..whole });
    } else if let Some(after) = pieces.get_mut(index + 1) {
        match after.at_radius(*radius).first() {
            Some(meets) if !after.is_cylinder() => {
                to = *meets;
                after.from = to;
            }
            // A face that rises from the thread begins lower.
            _ if after.is_face() => after.from = to,
            _ => behind.push(Piece::line(to, after.from)),
        }
    }
    made.push(Piece::line(from, to));
    made.extend(behind);
    made.retain(|piece| !piece.is_nothing());
    pieces.splice(index..=index, made);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::at;

    fn after(points: &[Point], thread: (f64, f64), ends: f64) -> Vec<Point> {
        let pieces = points.windows(2).map(|ends| Piece::line(ends[0], ends[1])).collect();
        let by = Lowered {
            thread: Piece::line(at(15.0, thread.0), at(15.0, thread.1)),
            begins: Half::from(thread.0),
            ends: Some(Half::from(ends)),
            radius: Half::from(14.9),
        };
        let pieces = lower(pieces, &by);
        assert!(pieces.windows(2).all(|beside| beside[0].to == beside[1].from), "{pieces:?}");
        pieces.first().map(|piece| piece.from).into_iter().chain(pieces.iter().map(|piece| piece.to)).collect()
    }

    /// Chamfer, thread, the bridge over its relief, a face.
    #[test]
    fn a_chamfer_ends_sooner_and_a_face_begins_lower() {
        let drawn = [at(13.0, 0.0), at(15.0, 2.0), at(15.0, 40.0), at(16.0, 40.0)];
        let turned = [at(13.0, 0.0), at(14.9, 1.9), at(14.9, 40.0), at(16.0, 40.0)];
        assert_eq!(after(&drawn, (2.0, 35.0), 40.0), turned);
    }

    /// The relief as it is cut.
    #[test]
    fn the_wall_of_a_relief_begins_lower() {
        let drawn = [at(13.0, 0.0), at(15.0, 2.0), at(15.0, 35.0), at(13.5, 35.0), at(13.5, 40.0)];
        let turned = [at(13.0, 0.0), at(14.9, 1.9), at(14.9, 35.0), at(13.5, 35.0), at(13.5, 40.0)];
        assert_eq!(after(&drawn, (2.0, 35.0), 40.0), turned);
    }

    /// A cylinder of the same diameter behind it stays.
    #[test]
    fn what_is_no_thread_stays() {
        let drawn = [at(15.0, 0.0), at(15.0, 60.0)];
        let turned = [at(14.9, 0.0), at(14.9, 34.827), at(15.0, 35.0), at(15.0, 60.0)];
        assert_eq!(after(&drawn, (0.0, 35.0), 35.0), turned);
        // Down by 0.1·cot 4°.
        let turned = [at(15.0, 0.0), at(15.0, 10.0), at(14.9, 11.43), at(14.9, 34.827), at(15.0, 35.0), at(15.0, 60.0)];
        assert_eq!(after(&drawn, (10.0, 35.0), 35.0), turned);
    }
}
