//! Cylinders that are made at another radius than drawn: between the limits of their fit, not at the nominal size.

use crate::turning::length::Half;
use crate::turning::point::Point;

use super::{Piece, Side};

/// The slopes that lead from one radius as made to another (table `turning-job-limits`).
#[derive(Clone, Copy, Debug, Default)]
pub struct Slopes {
    /// The length of one that rises over its height: a nose rolls over it.
    pub rise: f64,
    /// The same of one that falls: an edge follows it.
    pub fall: f64,
    /// The longest way along a slope of the drawing, mm; farther a slope of our own is put in.
    pub far: f64,
}

/// A cylinder that is made at another radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resized {
    /// Its radius on the drawing.
    pub drawn: Half,
    /// Its radius as made.
    pub made: Half,
    /// Where it begins, at the free end.
    pub from: Half,
    /// Where it ends.
    pub to: Half,
}

impl Resized {
    /// The same of the part turned over.
    #[must_use]
    pub fn turned_over(self, length: Half) -> Self {
        Self { from: length - self.to, to: length - self.from, ..self }
    }

    fn overlaps(&self, piece: &Piece) -> bool {
        piece.is_cylinder() && piece.from.radius == self.drawn && self.from < piece.to.z && piece.from.z < self.to
    }
}

/// Pieces, each with a mark, with their cylinders as made; what is beside them meets them there. Metal that a cylinder of the
/// drawing has beyond them is made like its neighbour.
///
/// Pieces that end where a cylinder of another set-up begins end on that as it is made.
pub fn resized<T: Copy>(mut pieces: Vec<(Piece, T)>, side: Side, all: &[Resized], slopes: Slopes) -> Vec<(Piece, T)> {
    let follows = pieces.last().filter(|(last, _)| !last.is_cylinder()).and_then(|&(last, mark)| {
        let begins = |one: &&Resized| one.made != one.drawn && last.to == Point { radius: one.drawn, z: one.from };
        all.iter().find(begins).map(|one| (Piece::line(last.to, Point { z: one.to, ..last.to }), mark))
    });
    pieces.extend(follows);
    let mut made: Vec<(Piece, T)> = Vec::with_capacity(pieces.len());
    let mut moved = Vec::new();
    for (piece, mark) in pieces {
        let mut own: Vec<&Resized> = all.iter().filter(|one| one.overlaps(&piece)).collect();
        own.sort_by_key(|one| one.from);
        if own.iter().all(|one| one.made == one.drawn) {
            made.push((piece, mark));
            continue;
        }
        let first = made.len();
        made.extend(stepped(piece, side, &own, slopes).into_iter().map(|piece| (piece, mark)));
        moved.push((first, made.len()));
    }
    // From behind, because steps are put in.
    for (first, end) in moved.into_iter().rev() {
        meet_behind(&mut made, side, end, slopes);
        meet_before(&mut made, side, first, slopes);
    }
    if follows.is_some() {
        made.pop();
    }
    made.retain(|(piece, _)| !piece.is_nothing());
    made
}

/// Whether a step towards the chuck goes away from what is turned off before it.
fn rises(step: Half, side: Side) -> bool {
    (step > Half::ZERO) == (side == Side::Outer)
}

/// How far along a slope takes to another radius.
fn way(step: Half, side: Side, slopes: Slopes) -> Half {
    Half::from(step.to_mm().abs() * if rises(step, side) { slopes.rise } else { slopes.fall })
}

/// A cylinder as its parts are made, with a slope from each to the next.
fn stepped(piece: Piece, side: Side, own: &[&Resized], slopes: Slopes) -> Vec<Piece> {
    let mut made = Vec::new();
    let Some(first) = own.first() else { return vec![piece] };
    let mut from = Point { radius: first.made, z: piece.from.z };
    for (one, next) in own.iter().zip(own.iter().skip(1)) {
        let length = way(next.made - one.made, side, slopes);
        // In what lies between them, if anything does.
        let begins =
            if rises(next.made - one.made, side) { next.from - length } else { (next.from - length).max(one.to) };
        let foot = Point { radius: one.made, z: begins.max(from.z).min(piece.to.z) };
        let head = Point { radius: next.made, z: (foot.z + length).min(piece.to.z) };
        made.extend([Piece::line(from, foot), Piece::line(foot, head)]);
        from = head;
    }
    made.push(Piece::line(from, Point { z: piece.to.z, ..from }));
    made.retain(|piece| !piece.is_nothing());
    made
}

/// What stands before a cylinder ends on it.
fn meet_before<T: Copy>(made: &mut Vec<(Piece, T)>, side: Side, first: usize, slopes: Slopes) {
    let Some((cylinder, mark)) = made.get(first).copied() else { return };
    let Some(index) = first.checked_sub(1) else { return };
    let (before, around) = (made[index].0, index.checked_sub(1).map(|index| made[index].0));
    if before.to == cylinder.from {
        return;
    }
    if before.is_cylinder() {
        return slope(made, side, first, slopes);
    }
    match met(before.reversed(), around.map(Piece::reversed), cylinder.reversed(), slopes) {
        Some(Met { beside, around, meets }) => {
            made[index].0 = beside.reversed();
            if let (Some(around), Some(index)) = (around, index.checked_sub(1)) {
                made[index].0 = around.reversed();
            }
            made[first].0.from = meets;
        }
        None => {
            let head = Point {
                z: (before.to.z + way(cylinder.from.radius - before.to.radius, side, slopes)).min(cylinder.to.z),
                ..cylinder.from
            };
            made[first].0.from = head;
            made.insert(first, (Piece::line(before.to, head), mark));
        }
    }
}

/// What stands behind a cylinder begins on it; `end` is its index.
fn meet_behind<T: Copy>(made: &mut Vec<(Piece, T)>, side: Side, end: usize, slopes: Slopes) {
    let Some(last) = end.checked_sub(1) else { return };
    let (Some((cylinder, mark)), Some((behind, _))) = (made.get(last).copied(), made.get(end).copied()) else { return };
    let around = made.get(end + 1).map(|(piece, _)| *piece);
    if behind.from == cylinder.to {
        return;
    }
    if behind.is_cylinder() {
        return slope(made, side, end, slopes);
    }
    match met(behind, around, cylinder, slopes) {
        Some(Met { beside, around, meets }) => {
            made[end].0 = beside;
            if let (Some(around), Some(piece)) = (around, made.get_mut(end + 1)) {
                piece.0 = around;
            }
            made[last].0.to = meets;
        }
        None => {
            let foot = Point {
                z: (behind.from.z - way(behind.from.radius - cylinder.to.radius, side, slopes)).max(cylinder.from.z),
                ..cylinder.to
            };
            made[last].0.to = foot;
            made.insert(end, (Piece::line(foot, behind.from), mark));
        }
    }
}

/// A slope from a cylinder to the next one, whose index is given.
fn slope<T: Copy>(made: &mut Vec<(Piece, T)>, side: Side, index: usize, slopes: Slopes) {
    let Some([(one, mark), (next, behind)]) = made.get(index - 1..=index).and_then(|both| both.first_chunk().copied())
    else {
        return;
    };
    let fits = [(one.from.z, one.to.z, one.from.radius), (next.from.z, next.to.z, next.from.radius)];
    let fits = fits.map(|(from, to, radius)| Resized { drawn: radius, made: radius, from, to });
    let whole = Piece { to: Point { z: next.to.z, ..one.to }, ..one };
    let mut steps: Vec<(Piece, T)> =
        stepped(whole, side, &fits.each_ref(), slopes).into_iter().map(|piece| (piece, mark)).collect();
    if let Some(last) = steps.last_mut() {
        last.1 = behind;
    }
    made.splice(index - 1..=index, steps);
}

/// How a piece beside a cylinder meets it.
struct Met {
    beside: Piece,
    /// The piece beside that one, if it moves too.
    around: Option<Piece>,
    meets: Point,
}

/// A piece that begins where a cylinder of the drawing ended begins on the cylinder as made: a face is longer or shorter, a slope
/// goes on or ends sooner, a rounding moves along its face. None if it does not meet it so: then a slope is put in.
fn met(beside: Piece, around: Option<Piece>, cylinder: Piece, slopes: Slopes) -> Option<Met> {
    let radius = cylinder.to.radius;
    let shift = radius - beside.from.radius;
    if beside.is_face() {
        let meets = Point { radius, ..beside.from };
        return Some(Met { beside: Piece { from: meets, ..beside }, around: None, meets });
    }
    if matches!(beside.curve, super::Curve::Arc { .. }) {
        let around = around.filter(|around| around.is_face())?;
        let moved = |point: Point| Point { radius: point.radius + shift, z: point.z };
        let face = Piece { from: moved(around.from), ..around };
        let beside = beside.mapped(false, moved);
        let is_left = (face.to.radius - face.from.radius).halves().signum()
            == (around.to.radius - around.from.radius).halves().signum();
        return is_left.then_some(Met { beside, around: Some(face), meets: beside.from });
    }
    let chord = beside.chord();
    let along = Half::from(shift.to_mm() * chord.z / chord.radius);
    let meets = Point { radius, z: beside.from.z + along };
    let ahead = |from: Point, to: Point| (to.z - from.z).to_mm() * chord.z > 0.0;
    let near = chord.radius.abs() > 1e-9 && along.to_mm().abs() <= slopes.far;
    (near && ahead(meets, beside.to) && ahead(cylinder.from, meets)).then_some(Met {
        beside: Piece { from: meets, ..beside },
        around: None,
        meets,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::{Contour, Turn};
    use crate::turning::point::at;

    fn one(drawn: f64, made: f64, from: f64, to: f64) -> Resized {
        let [drawn, made, from, to] = [drawn, made, from, to].map(Half::from);
        Resized { drawn, made, from, to }
    }

    /// Up at 30°, down at 4°.
    const SLOPES: Slopes = Slopes { rise: 1.732_051, fall: 14.300_666, far: 0.5 };

    fn after(contour: Contour, all: &[Resized]) -> Contour {
        let marked = contour.pieces.into_iter().map(|piece| (piece, ())).collect();
        let pieces = resized(marked, contour.side, all, SLOPES).into_iter().map(|(piece, ())| piece).collect();
        let made = Contour { side: contour.side, pieces };
        assert!(made.hangs_together(), "{made:?}");
        made
    }

    /// A chamfer of 45° ends sooner and one that falls begins later, faces are longer; larger, it is the other way round.
    #[test]
    fn chamfers_and_faces_meet_the_cylinder() {
        let drawn = [at(9.0, 0.0), at(10.0, 1.0), at(10.0, 30.0), at(15.0, 30.0)];
        let made = after(Contour::through(Side::Outer, &drawn), &[one(10.0, 9.985, 1.0, 30.0)]);
        assert_eq!(made.corners(), [at(9.0, 0.0), at(9.985, 0.985), at(9.985, 30.0), at(15.0, 30.0)]);
        let made = after(Contour::through(Side::Outer, &drawn), &[one(10.0, 10.004, 1.0, 30.0)]);
        assert_eq!(made.corners(), [at(9.0, 0.0), at(10.004, 1.004), at(10.004, 30.0), at(15.0, 30.0)]);
        let falls = [at(10.0, 0.0), at(10.0, 29.0), at(9.0, 30.0)];
        let made = after(Contour::through(Side::Outer, &falls), &[one(10.0, 9.985, 0.0, 29.0)]);
        assert_eq!(made.corners(), [at(9.985, 0.0), at(9.985, 29.015), at(9.0, 30.0)]);
    }

    /// k6 before d9 on one diameter: down by 0.06, at 4° behind the seat. The other way round up at 30° before it.
    #[test]
    fn two_fits_on_one_diameter_get_a_slope() {
        let drawn = [at(15.0, 0.0), at(15.0, 60.0)];
        let fits = [one(15.0, 15.005, 0.0, 20.0), one(15.0, 14.945, 20.0, 60.0)];
        let made = after(Contour::through(Side::Outer, &drawn), &fits);
        assert_eq!(made.corners(), [at(15.005, 0.0), at(15.005, 20.0), at(14.945, 20.858), at(14.945, 60.0)]);
        let fits = [one(15.0, 14.945, 0.0, 20.0), one(15.0, 15.005, 20.0, 60.0)];
        let made = after(Contour::through(Side::Outer, &drawn), &fits);
        assert_eq!(made.corners(), [at(14.945, 0.0), at(14.945, 19.896), at(15.005, 20.0), at(15.005, 60.0)]);
    }

    /// A fillet of 2 keeps its radius and moves along its face; one that leads to a slope gets a step.
    #[test]
    fn a_fillet_moves_along_its_face() {
        let mut drawn = Contour::through(Side::Outer, &[at(10.0, 0.0), at(10.0, 20.0)]);
        drawn.pieces.push(Piece::arc(at(10.0, 20.0), at(12.0, 22.0), Half::from(2.0), Turn::Left));
        drawn.pieces.push(Piece::line(at(12.0, 22.0), at(15.0, 22.0)));
        let made = after(drawn, &[one(10.0, 9.985, 0.0, 20.0)]);
        assert_eq!(made.corners(), [at(9.985, 0.0), at(9.985, 20.0), at(11.985, 22.0), at(15.0, 22.0)]);
    }

    /// What is beside, drawn at the same diameter, and what is not named stay.
    #[test]
    fn other_cylinders_stay() {
        let drawn = [at(10.0, 0.0), at(10.0, 20.0), at(12.0, 20.0), at(12.0, 40.0)];
        let contour = Contour::through(Side::Outer, &drawn);
        assert_eq!(after(contour.clone(), &[one(10.0, 9.9, 30.0, 40.0)]), contour);
        assert_eq!(after(contour.clone(), &[one(12.0, 12.0, 20.0, 40.0)]), contour);
    }
}
