//! Makes pieces of a contour from the outline of all strips.

use crate::turning::contour::{Curve, Piece, Turn};
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

use super::equidistant::{Over, Parallel, SAME};
use super::union::Corner;

/// A stretch of the outline lies on an offset if its middle is no farther from it, mm: half a micrometre.
const ON_IT: f64 = 5e-4;

/// Lines are parallel below this sine of the angle between them: the directions of short lines are not exact.
const PARALLEL: f64 = 1e-3;

/// An arc with a shorter chord is written as a line, mm: it bends by nanometres only.
const SHORT: f64 = 2e-3;

/// An arc is written as two halves if its rounded centre would be farther from the true one, mm.
const OFF_CENTRE: f64 = 1e-3;

/// Half a circle with its rounding, radians.
const HALF_CIRCLE: f64 = std::f64::consts::PI + 1e-6;

/// One end of the contour below the outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// The corner of the part.
    pub corner: Vector,
    /// The direction from there to the end of its offset, 1 long; along the axis if the part ends on it.
    pub out: Vector,
    /// The distance of the offset from the corner, mm.
    pub reach: f64,
    /// How far the outline can be from the corner where the strip of another piece covers that end, mm.
    pub far: f64,
}

/// Both ends, and the corners of the foundation between which the outline is read.
pub(super) struct Ends {
    /// At the free end.
    pub from: End,
    /// Towards the chuck.
    pub to: End,
    /// The upper corner of the foundation beyond the free end.
    pub left: Vector,
    /// The upper corner beyond the end towards the chuck.
    pub right: Vector,
    /// How far along Z a point of the outline can be from the piece below it, mm.
    pub reach: f64,
}

/// A stretch of the outline.
#[derive(Clone, Copy, Debug)]
struct OutlinePiece {
    from: Vector,
    to: Vector,
    sweep: f64,
}

impl OutlinePiece {
    fn reversed(self) -> Self {
        Self { from: self.to, to: self.from, sweep: -self.sweep }
    }

    fn chord(self) -> Vector {
        self.to.minus(self.from)
    }

    /// The point at a share of its length.
    fn at(self, share: f64) -> Vector {
        if self.sweep == 0.0 {
            return self.from.plus(self.chord().times(share));
        }
        // The chord of the first part is turned from the whole chord by half the remaining angle.
        let part = self.sweep * share;
        let length = self.chord().length() * libm::sin(part / 2.0) / libm::sin(self.sweep / 2.0);
        let turn = (part - self.sweep) / 2.0;
        let ahead = self.chord().unit();
        self.from.plus(ahead.times(length * libm::cos(turn))).plus(ahead.left().times(length * libm::sin(turn)))
    }

    /// Whether another stretch continues the same line or circle in the same direction; together at most half a circle.
    fn goes_on_as(self, next: Self) -> bool {
        if self.sweep == 0.0 && next.sweep == 0.0 {
            let whole = next.to.minus(self.from);
            return whole.unit().cross(self.chord()).abs() < SAME / 10.0 && self.chord().dot(next.chord()) > 0.0;
        }
        let together = self.sweep + next.sweep;
        let apart = next.centre().minus(self.centre()).length();
        self.sweep * next.sweep > 0.0 && together.abs() < HALF_CIRCLE && apart < SAME
    }

    /// The centre of an arc.
    fn centre(self) -> Vector {
        let height = self.chord().length() / 2.0 / libm::tan(self.sweep / 2.0);
        self.at(0.0).plus(self.chord().times(0.5)).plus(self.chord().unit().left().times(height))
    }

    /// The remainder after a share of its length.
    fn rest(self, share: f64) -> Self {
        Self { from: self.at(share), to: self.to, sweep: self.sweep * (1.0 - share) }
    }
}

/// The outline between its ends as pieces, each with the offset that it lies on.
pub(super) fn read_back(whole: &[Corner], ends: &Ends, parallels: &[Parallel]) -> Option<Vec<Over>> {
    let mut stretches = above_foundation(whole, ends)?;
    trim(&mut stretches, ends.from, -1.0);
    stretches = stretches.into_iter().rev().map(OutlinePiece::reversed).collect();
    trim(&mut stretches, ends.to, 1.0);
    stretches = stretches.into_iter().rev().map(OutlinePiece::reversed).collect();
    let mut merged: Vec<(OutlinePiece, usize)> = Vec::new();
    for stretch in stretches {
        let of = parallel_of(stretch, parallels, ends.reach).or(merged.last().map(|(_, of)| *of)).unwrap_or(0);
        match merged.last_mut() {
            Some((last, its)) if *its == of && last.goes_on_as(stretch) => {
                *last = OutlinePiece { from: last.from, to: stretch.to, sweep: last.sweep + stretch.sweep };
            }
            _ => merged.push((stretch, of)),
        }
    }
    let over = merged
        .into_iter()
        .flat_map(|(stretch, of)| pieces(stretch, parallels.get(of)).map(move |piece| Over { piece, of }));
    Some(over.filter(|over| !over.piece.is_nothing()).collect())
}

/// The outline between the foundation before the part and that behind it.
fn above_foundation(whole: &[Corner], ends: &Ends) -> Option<Vec<OutlinePiece>> {
    let is_at = |corner: &Corner, at: Vector| at.minus(corner.at).length() < SAME;
    let start = whole.iter().position(|corner| is_at(corner, ends.left))?;
    let round: Vec<&Corner> = whole.iter().cycle().skip(start).take(whole.len()).collect();
    let end = round.iter().position(|corner| is_at(corner, ends.right))?;
    let stretches = round.iter().zip(round.iter().skip(1)).take(end);
    let stretch = |(one, next): (&&Corner, &&Corner)| OutlinePiece { from: one.at, to: next.at, sweep: one.sweep };
    let on_ground = |stretch: &OutlinePiece| {
        [stretch.from, stretch.to].iter().all(|at| (at.radius - ends.left.radius).abs() < SAME)
    };
    Some(stretches.map(stretch).filter(|stretch| !on_ground(stretch)).collect())
}

/// Removes what lies beyond the end of the part: everything before the outline first meets the ray from the corner of
/// the part through the end of its offset. If the strip of another piece covers that end, the ray is parallel to the
/// axis.
fn trim(stretches: &mut Vec<OutlinePiece>, end: End, outwards: f64) {
    let level = End { out: Vector::new(outwards, 0.0), reach: end.far, ..end };
    if let Some(rest) = after(stretches, end).or_else(|| after(stretches, level)) {
        *stretches = rest;
    }
}

/// The stretches after the ray; none if the outline does not meet it within its reach.
fn after(stretches: &[OutlinePiece], end: End) -> Option<Vec<OutlinePiece>> {
    let along = |at: Vector| end.out.dot(at.minus(end.corner));
    let aside = |at: Vector| end.out.cross(at.minus(end.corner));
    let reached = |at: Vector| (-SAME..end.reach + SAME).contains(&along(at));
    let met = |at: Vector| aside(at).abs() < SAME && reached(at);
    for (place, stretch) in stretches.iter().enumerate() {
        let rest = || stretches.iter().skip(place + 1).copied();
        if met(stretch.to) {
            // What lies on the ray is removed too.
            return Some(rest().skip_while(|next| met(next.to)).collect());
        }
        if aside(stretch.from) * aside(stretch.to) < 0.0 {
            let share = crossing(*stretch, aside);
            if reached(stretch.at(share)) {
                return Some(std::iter::once(stretch.rest(share)).chain(rest()).collect());
            }
        }
    }
    None
}

/// The share of a stretch at which a measure changes its sign, by bisection.
fn crossing(stretch: OutlinePiece, measure: impl Fn(Vector) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = (low + high) / 2.0;
        if measure(stretch.at(middle)) * measure(stretch.from) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}

/// The offset on which a stretch lies, the nearest if there are several. Their pieces are in the order of Z, so only
/// those within reach are compared.
fn parallel_of(stretch: OutlinePiece, parallels: &[Parallel], reach: f64) -> Option<usize> {
    let middle = stretch.at(0.5);
    let fits = |parallel: &Parallel| {
        let from = middle.minus(parallel.over_from);
        match parallel.piece.centre() {
            None => {
                stretch.sweep == 0.0
                    && parallel.ahead_from.cross(stretch.chord().unit()).abs() < PARALLEL
                    && parallel.ahead_from.cross(from).abs() < ON_IT
            }
            Some(centre) => {
                let radius = parallel.over_from.minus(centre).length();
                stretch.sweep * parallel.sweep > 0.0 && (middle.minus(centre).length() - radius).abs() < ON_IT
            }
        }
    };
    // How far the middle lies beyond the ends of the offset.
    let beyond = |parallel: &Parallel| {
        let chord = parallel.over_to.minus(parallel.over_from);
        let along = chord.unit().dot(middle.minus(parallel.over_from));
        (-along).max(along - chord.length()).max(0.0)
    };
    let first = parallels.partition_point(|parallel| parallel.to.z < middle.z - reach);
    let near = parallels.iter().enumerate().skip(first).take_while(|(_, one)| one.from.z <= middle.z + reach);
    let fitting = near.filter(|(_, parallel)| fits(parallel));
    fitting.min_by(|(_, one), (_, other)| beyond(one).total_cmp(&beyond(other))).map(|(of, _)| of)
}

/// A stretch as one piece, or as two: the rounded ends of nearly half a circle may not give its centre, but those of
/// its halves do.
fn pieces(stretch: OutlinePiece, parallel: Option<&Parallel>) -> impl Iterator<Item = Piece> {
    let whole = piece(stretch, parallel);
    let off = whole.centre().map_or(0.0, |centre| stretch.centre().minus(centre).length());
    let halves = (off > OFF_CENTRE && stretch.sweep.abs() > HALF_CIRCLE / 2.0).then(|| {
        let rest = stretch.rest(0.5);
        [OutlinePiece { to: rest.from, sweep: stretch.sweep / 2.0, ..stretch }, rest]
    });
    let parts = halves.map_or_else(|| vec![stretch], Vec::from);
    parts.into_iter().map(move |part| piece(part, parallel))
}

/// A stretch as a piece. On the offset of an arc its radius follows from that arc and the distance.
fn piece(stretch: OutlinePiece, parallel: Option<&Parallel>) -> Piece {
    let (from, to) = (Point::at(stretch.from), Point::at(stretch.to));
    let chord = stretch.chord().length();
    if stretch.sweep == 0.0 || chord < SHORT {
        return Piece::line(from, to);
    }
    let turn = if stretch.sweep > 0.0 { Turn::Left } else { Turn::Right };
    let computed = Half::from(chord / 2.0 / libm::sin(stretch.sweep.abs() / 2.0));
    let concentric = parallel.and_then(|parallel| match parallel.piece.curve {
        Curve::Arc { radius, turn: Turn::Left } if turn == Turn::Left => Some(radius - Half::from(parallel.distance)),
        Curve::Arc { radius, turn: Turn::Right } if turn == Turn::Right => Some(radius + Half::from(parallel.distance)),
        _ => None,
    });
    // A join carries the index of a neighbouring arc, but has another radius.
    let radius =
        concentric.filter(|radius| (radius.to_mm() - computed.to_mm()).abs() < ON_IT.max(0.01 * computed.to_mm()));
    Piece::arc(from, to, radius.unwrap_or(computed), turn)
}
