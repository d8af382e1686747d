//! The line at a distance from a contour: the rough contour of lecture 12.2, each of whose points leaves the allowance of
//! the piece below it.
//!
//! What is left over a piece is the strip between the piece and its parallel, and everything under the strip, because the
//! tool comes from outside: a contour that does not lead back towards the free end keeps that property. Strips that meet
//! at a corner which bulges are joined there; at a hollow corner they overlap. The rough contour is the outer boundary of
//! all strips together (`union` finds it). Arcs keep their centres.

use crate::note::{Figure, Note, Told};
use crate::turning::contour::{Contour, Curve, Piece, Side, Turn};
use crate::turning::length::Half;
use crate::turning::point::Vector;

use super::read_back;
use super::union::{Corner, union};

/// How far the corner of two extended parallels may lie from the corner of the part, in larger allowances of the two; a
/// sharper corner is rounded. Twice is met where the contour turns by 120°.
const FAR: f64 = 2.0;

/// Angles below this are none: their sine, which over an allowance of 1 mm is 10 nm.
const STRAIGHT: f64 = 1e-5;

/// Points nearer than this are one, mm: the fifth part of half a micrometre.
pub(super) const SAME: f64 = 1e-4;

/// Ends of neighbouring parallels nearer than this are one, mm: half a micrometre, to which all is rounded.
const TOUCH: f64 = 5e-4;

/// How far the foundation on which the strips stand reaches below and beside the contour, mm.
const FOUNDATION: f64 = 10.0;

/// Why there is no equidistant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EquidistantError {
    /// The contour has no pieces.
    #[error("the contour has no pieces; give it at least one")]
    Empty,
    /// There must be one distance for each piece.
    #[error("the contour has {pieces} pieces and {distances} distances; give one distance for each piece")]
    Count {
        /// How many pieces.
        pieces: usize,
        /// How many distances.
        distances: usize,
    },
    /// A piece does not begin where the one before it ends.
    #[error("the contour is broken: each piece must begin where the one before it ends")]
    Broken,
    /// A piece leads back towards the free end.
    #[error("the contour leads back towards the free end; bridge what is undercut before allowances are laid on")]
    LeadsBack,
    /// A distance is less than nothing.
    #[error("the distance of piece {piece} is negative; an allowance is at least 0")]
    Negative {
        /// Its place on the contour, from 1.
        piece: usize,
    },
    /// The contour is hollow arcs alone, and all have come to nothing.
    #[error("nothing is left of the contour at this distance; it is larger than the radii of its hollow arcs")]
    Vanished,
    /// The strips did not come together.
    #[error("the strips over the contour did not join into one outline; report the contour, it is a defect of ours")]
    NotJoined,
}

impl Told for EquidistantError {
    fn told(self) -> Figure {
        let note = match self {
            Self::Empty => Note::new("equidistant-empty"),
            Self::Count { pieces, distances } => {
                Note::new("equidistant-count").with("pieces", pieces).with("distances", distances)
            }
            Self::Broken => Note::new("equidistant-broken"),
            Self::LeadsBack => Note::new("equidistant-leads-back"),
            Self::Negative { piece } => Note::new("equidistant-negative").with("piece", piece),
            Self::Vanished => Note::new("equidistant-vanished"),
            Self::NotJoined => Note::new("equidistant-not-joined"),
        };
        note.told()
    }
}

/// A piece of an equidistant, with the piece of the contour that it lies over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Over {
    /// The piece.
    pub piece: Piece,
    /// The place of the piece of the contour to which it is parallel, from 0; of what joins two of them the earlier one.
    pub of: usize,
}

/// The contour at a distance from each piece of this one: concentric arcs, parallel lines, extended to corners where the
/// part bulges (rounded where an arc ends there or where they would meet far off) and cut where it is hollow. Rounded to
/// halves of a micrometre.
///
/// Between pieces that touch without a corner but differ in their distance it steps. It begins and ends upright over the
/// ends of the contour; on the axis it reaches the axis. It does not lead back, but for half a micrometre of rounding where
/// an arc ends upright.
///
/// # Errors
/// The contour is empty, broken or leads back; a distance is lacking or negative.
pub fn equidistant(contour: &Contour, distances: &[Half]) -> Result<Contour, EquidistantError> {
    let pieces = equidistant_over(contour, distances)?.into_iter().map(|over| over.piece).collect();
    Ok(Contour { side: contour.side, pieces })
}

/// The same, each piece with what it lies over.
///
/// # Errors
/// As [`equidistant`].
pub fn equidistant_over(contour: &Contour, distances: &[Half]) -> Result<Vec<Over>, EquidistantError> {
    check(contour, distances)?;
    if contour.side == Side::Inner {
        let top = contour.radii().map_or(Half::ZERO, |(_, most)| most);
        let outer = contour.inside_out(top);
        let back = |over: Over| Over { piece: over.piece.inside_out(top), of: over.of };
        // Radii of the image count from the largest radius of the bore, so its zero is not the axis.
        return Ok(between_bare_faces(&outer, distances, false)?.into_iter().map(back).collect());
    }
    between_bare_faces(contour, distances, true)
}

/// The outline with the bare faces at its ends: one that leads away from the axis there has no strip where it has no
/// distance, and nothing under which it would stand, so it is laid on afterwards, from where the outline ends.
fn between_bare_faces(contour: &Contour, distances: &[Half], axis: bool) -> Result<Vec<Over>, EquidistantError> {
    let pieces = || contour.pieces.iter().zip(distances);
    let bare = |piece: &Piece, distance: Half| piece.is_face() && distance == Half::ZERO;
    let before = pieces().take_while(|(piece, by)| bare(piece, **by) && piece.to.radius < piece.from.radius).count();
    let behind =
        pieces().rev().take_while(|(piece, by)| bare(piece, **by) && piece.to.radius > piece.from.radius).count();
    let rest = before..contour.pieces.len().saturating_sub(behind);
    let (Some(inside), Some(by)) = (contour.pieces.get(rest.clone()), distances.get(rest.clone())) else {
        return outline(contour, distances, axis);
    };
    if inside.is_empty() {
        return outline(contour, distances, axis);
    }
    let mut found = outline(&Contour { side: contour.side, pieces: inside.to_vec() }, by, axis)?;
    for over in &mut found {
        over.of += before;
    }
    // What of a face the strip beside it covers is no face any more.
    if let (Some(first), Some(start)) = (found.first().map(|over| over.piece.from), contour.start())
        && (before > 0 && start.radius > first.radius && start.z == first.z)
    {
        found.insert(0, Over { piece: Piece::line(start, first), of: before - 1 });
    }
    if let (Some(last), Some(end)) = (found.last().map(|over| over.piece.to), contour.end())
        && (behind > 0 && end.radius > last.radius && end.z == last.z)
    {
        found.push(Over { piece: Piece::line(last, end), of: rest.end });
    }
    Ok(found)
}

/// Everything that must be true before.
fn check(contour: &Contour, distances: &[Half]) -> Result<(), EquidistantError> {
    if contour.pieces.is_empty() {
        return Err(EquidistantError::Empty);
    }
    if contour.pieces.len() != distances.len() {
        return Err(EquidistantError::Count { pieces: contour.pieces.len(), distances: distances.len() });
    }
    if !contour.hangs_together() {
        return Err(EquidistantError::Broken);
    }
    if !contour.is_monotone() {
        return Err(EquidistantError::LeadsBack);
    }
    match distances.iter().position(|distance| *distance < Half::ZERO) {
        Some(at) => Err(EquidistantError::Negative { piece: at + 1 }),
        None => Ok(()),
    }
}

/// The strips over an outer contour, joined, and their outer boundary.
fn outline(contour: &Contour, distances: &[Half], axis: bool) -> Result<Vec<Over>, EquidistantError> {
    let parallels: Vec<Parallel> =
        contour.pieces.iter().zip(distances).map(|(piece, distance)| Parallel::new(*piece, *distance)).collect();
    let (Some(first), Some(last)) = (parallels.first(), parallels.last()) else { return Err(EquidistantError::Empty) };
    let most = parallels.iter().map(|parallel| parallel.distance).fold(0.0, f64::max);
    let least = contour.radii().map_or(0.0, |(least, _)| least.to_mm());
    let (left, right) = (first.from.z - FAR * most - FOUNDATION, last.to.z + FAR * most + FOUNDATION);
    let ground = least - FOUNDATION;
    let foundation = [
        Vector::new(left, ground - FOUNDATION),
        Vector::new(left, ground),
        Vector::new(right, ground),
        Vector::new(right, ground - FOUNDATION),
    ];
    let tops = tops(&parallels, axis);
    let wide = |top: &&Vec<Corner>| match (top.first(), top.last()) {
        (Some(first), Some(last)) => last.at.z - first.at.z > SAME,
        _ => false,
    };
    let shadows: Vec<_> = tops.iter().filter(wide).map(|top| shadow(top, ground - FOUNDATION / 2.0)).collect();
    let whole = union(&foundation.map(Corner::sharp), &shadows).ok_or(EquidistantError::NotJoined)?;
    let end = |corner: Vector, out: Vector, reach: f64, outwards: f64| {
        let on_axis = axis && corner.radius == 0.0;
        let out = if on_axis { Vector::new(outwards, 0.0) } else { out };
        read_back::End { corner, out, reach: if on_axis { FAR * reach } else { reach }, far: FAR * most }
    };
    let ends = read_back::Ends {
        from: end(first.from, first.ahead_from.left(), first.distance, -1.0),
        to: end(last.to, last.ahead_to.left(), last.distance, 1.0),
        left: Vector::new(left, ground),
        right: Vector::new(right, ground),
        reach: FAR * most + FOUNDATION,
    };
    let found = read_back::read_back(&whole, &ends, &parallels).ok_or(EquidistantError::NotJoined)?;
    if found.is_empty() { Err(EquidistantError::Vanished) } else { Ok(found) }
}

/// A piece and its parallel, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parallel {
    /// The piece.
    pub piece: Piece,
    /// Its distance, at most the radius of a hollow arc, from whose points nothing goes beyond the centre.
    pub distance: f64,
    /// The distance that was asked for.
    pub wanted: f64,
    /// Its beginning.
    pub from: Vector,
    /// Its end.
    pub to: Vector,
    /// Its direction at its beginning, 1 long.
    pub ahead_from: Vector,
    /// Its direction at its end, 1 long.
    pub ahead_to: Vector,
    /// Where the parallel begins.
    pub over_from: Vector,
    /// Where it ends.
    pub over_to: Vector,
    /// The angle of both, radians, as in [`Corner`]; 0 for a line and for the parallel of an arc that vanished.
    pub sweep: f64,
}

impl Parallel {
    fn new(piece: Piece, distance: Half) -> Self {
        let wanted = distance.to_mm();
        let (mut distance, mut sweep, mut vanished) = (wanted, 0.0, None);
        if let (Curve::Arc { radius, turn }, Some(centre)) = (piece.curve, piece.centre()) {
            let half = (piece.chord().length() / 2.0 / radius.to_mm()).min(1.0);
            sweep = 2.0 * libm::asin(half) * if turn == Turn::Left { 1.0 } else { -1.0 };
            if turn == Turn::Left && distance > radius.to_mm() - SAME {
                (distance, sweep, vanished) = (radius.to_mm(), 0.0, Some(centre));
            }
        }
        let (from, to) = (piece.from.vector(), piece.to.vector());
        let (ahead_from, ahead_to) = (piece.direction_at_start(), piece.direction_at_end());
        let over = |at: Vector, ahead: Vector| vanished.unwrap_or(at.plus(ahead.left().times(distance)));
        let (over_from, over_to) = (over(from, ahead_from), over(to, ahead_to));
        Self { piece, distance, wanted, from, to, ahead_from, ahead_to, over_from, over_to, sweep }
    }

    fn is_line(&self) -> bool {
        self.piece.curve == Curve::Line
    }
}

/// The upper edges of all strips: one line as long as strips follow each other without a hollow corner between them and
/// without leading back.
fn tops(parallels: &[Parallel], axis: bool) -> Vec<Vec<Corner>> {
    let mut tops = Tops::default();
    if let Some(first) = parallels.first().filter(|first| axis && first.from.radius == 0.0) {
        tops.follow(tip(&mirrored(first), first, true), first.from);
    }
    let nexts = parallels.iter().skip(1).map(Some).chain([None]);
    for (one, next) in parallels.iter().zip(nexts) {
        tops.follow(vec![Corner { at: one.over_from, sweep: one.sweep }, Corner::sharp(one.over_to)], one.from);
        match next {
            Some(next) => match join(one, next) {
                Some(corners) => tops.follow(corners, one.to),
                None => tops.end(one.to),
            },
            None if axis && one.to.radius == 0.0 => tops.follow(tip(one, &mirrored(one), false), one.to),
            None => {}
        }
        tops.last_corner = one.to;
    }
    let last = tops.last_corner;
    tops.end(last);
    tops.done
}

/// The upper edges so far.
#[derive(Default)]
struct Tops {
    done: Vec<Vec<Corner>>,
    /// The one that grows.
    top: Vec<Corner>,
    /// The corner of the part under its end.
    last_corner: Vector,
}

impl Tops {
    /// Goes on to some corners, over that corner of the part. Where the way would lead back, another edge begins.
    fn follow(&mut self, corners: Vec<Corner>, part: Vector) {
        for corner in corners {
            if self.top.last().is_some_and(|last| corner.at.z < last.at.z - TOUCH) {
                self.end(part);
            }
            if self.top.is_empty() && corner.at.z > part.z {
                // A strip that leans towards the chuck has its first edge over the ground.
                self.top.push(Corner::sharp(part));
            }
            self.top.push(corner);
        }
    }

    /// Ends the edge over that corner of the part.
    fn end(&mut self, part: Vector) {
        if let Some(last) = self.top.last_mut() {
            last.sweep = 0.0;
            if last.at.z < part.z {
                // A strip that leans towards the free end has its last edge over the ground.
                self.top.push(Corner::sharp(part));
            }
            self.done.push(std::mem::take(&mut self.top));
        }
    }
}

/// The corners between the axis and the strip that begins (or ends) on it: half of what joins it to its own image.
fn tip(one: &Parallel, next: &Parallel, begins: bool) -> Vec<Corner> {
    let corners = join(one, next).unwrap_or_default();
    let [arc, end] = corners.as_slice() else { return corners };
    let out = if begins { -1.0 } else { 1.0 };
    let on_axis = one.to.plus(Vector::new(out * end.at.minus(one.to).length(), 0.0));
    let half = arc.sweep / 2.0;
    if begins {
        vec![Corner { at: on_axis, sweep: half }, *end]
    } else {
        vec![Corner { at: arc.at, sweep: half }, Corner::sharp(on_axis)]
    }
}

/// The image of a piece on the other side of the axis, walked the way that the contour goes on there.
fn mirrored(parallel: &Parallel) -> Parallel {
    let piece = parallel.piece.inside_out(Half::ZERO).reversed();
    Parallel::new(piece, Half::from(parallel.wanted))
}

/// The corners between the end of one parallel and the beginning of the next; none at a hollow corner.
fn join(one: &Parallel, next: &Parallel) -> Option<Vec<Corner>> {
    let (sine, cosine) = (one.ahead_to.cross(next.ahead_from), one.ahead_to.dot(next.ahead_from));
    if one.over_to.minus(next.over_from).length() < TOUCH || sine.abs() < STRAIGHT && cosine > 0.0 {
        return Some(Vec::new());
    }
    if sine > 0.0 {
        return None;
    }
    let (corner, sine) = (one.to, sine.abs());
    let (out_one, out_next) = (one.ahead_to.left(), next.ahead_from.left());
    if one.is_line() && next.is_line() {
        // How far each parallel must be extended to meet the other.
        let beyond_one = (next.distance - one.distance * cosine) / sine.max(STRAIGHT);
        let before_next = (one.distance - next.distance * cosine) / sine.max(STRAIGHT);
        if beyond_one < 0.0 {
            return Some(vec![Corner::sharp(corner.plus(out_one.times(next.distance / cosine)))]);
        }
        if before_next < 0.0 {
            return Some(vec![Corner::sharp(corner.plus(out_next.times(one.distance / cosine)))]);
        }
        let meeting = out_one.times(one.distance).plus(one.ahead_to.times(beyond_one));
        if meeting.length() <= FAR * one.distance.max(next.distance) {
            return Some(vec![Corner::sharp(corner.plus(meeting))]);
        }
    }
    // About the corner, at the smaller distance of the two.
    let distance = one.wanted.min(next.wanted);
    let (from, to) = (corner.plus(out_one.times(distance)), corner.plus(out_next.times(distance)));
    Some(vec![Corner { at: from, sweep: -libm::atan2(sine, cosine) }, Corner::sharp(to)])
}

/// An upper edge and everything under it, down to the ground.
fn shadow(top: &[Corner], ground: f64) -> Vec<Corner> {
    let mut outline: Vec<Corner> = Vec::new();
    for corner in top {
        match outline.last_mut() {
            Some(last) if corner.at.minus(last.at).length() < TOUCH => last.sweep = corner.sweep,
            _ => outline.push(*corner),
        }
    }
    // A face without a distance at an end stands over nothing.
    let upright = |one: &Corner, next: &Corner| one.sweep == 0.0 && (one.at.z - next.at.z).abs() < SAME;
    while let [.., one, next] = outline.as_slice() {
        if !upright(one, next) || next.at.radius < one.at.radius {
            break;
        }
        outline.pop();
    }
    while let [one, next, ..] = outline.as_slice() {
        if !upright(one, next) || one.at.radius < next.at.radius {
            break;
        }
        outline.remove(0);
    }
    let ends = [outline.last(), outline.first()].map(|end| end.map_or(0.0, |corner| corner.at.z));
    outline.extend(ends.map(|z| Corner::sharp(Vector::new(z, ground))));
    outline
}
