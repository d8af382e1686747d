//! The offset curve of a contour. The rough contour of lecture 12.2 is one: it leaves over each piece the allowance of
//! that piece.
//!
//! The stock over a piece is the strip between the piece and its offset, and everything below the strip, because the
//! tool comes from outside. So the offset of a contour that does not run back towards the free end does not run back
//! either. Strips are joined at a convex corner and overlap at a concave one. The rough contour is the outer boundary
//! of all strips together (`union` finds it). Arcs keep their centres.

use crate::note::{Figure, IntoFigure, Note};
use crate::turning::contour::{Contour, Curve, Piece, Side, Turn};
use crate::turning::length::Half;
use crate::turning::point::Vector;

use super::read_back;
use super::union::{Corner, union};

/// The corner of two extended offsets may lie so far from the corner of the part, in multiples of the larger allowance
/// of the two. A sharper corner is rounded. The factor 2 is reached where the contour turns by 120°.
const FAR: f64 = 2.0;

/// Angles with a smaller sine count as straight: over an allowance of 1 mm that is 10 nm.
const STRAIGHT: f64 = 1e-5;

/// Points nearer than this are equal, mm: a fifth of half a micrometre.
pub(super) const SAME: f64 = 1e-4;

/// Ends of neighbouring offsets nearer than this are equal, mm: half a micrometre, the unit of rounding.
const TOUCH: f64 = 5e-4;

/// How far the rectangle under all strips reaches below the contour and beyond its ends, mm.
const FOUNDATION: f64 = 10.0;

/// Why there is no offset curve.
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
    /// A distance is below zero.
    #[error("the distance of piece {piece} is negative; an allowance is at least 0")]
    Negative {
        /// Its place on the contour, from 1.
        piece: usize,
    },
    /// The contour has only concave arcs, and all of them vanish at their distances.
    #[error("nothing is left of the contour at this distance; it is larger than the radii of its hollow arcs")]
    Vanished,
    /// The strips did not join into one outline.
    #[error("the strips over the contour did not join into one outline; report the contour, it is a defect of ours")]
    NotJoined,
}

impl IntoFigure for EquidistantError {
    fn into_figure(self) -> Figure {
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
        note.into_figure()
    }
}

/// A piece of an offset curve, with the piece of the contour below it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Over {
    /// The piece.
    pub piece: Piece,
    /// The index of the piece of the contour whose offset it is; for a join between two offsets, that of the earlier
    /// one.
    pub of: usize,
}

/// The offset curve of a contour with a distance for each piece: parallel lines and concentric arcs. Offsets are
/// extended to their corner where the part is convex (rounded where an arc ends there, or where they would meet far
/// away), and cut where it is concave. Points are rounded to half a micrometre.
///
/// It has a step between pieces that touch without a corner but have different distances. It begins and ends
/// perpendicular to the ends of the contour; on the axis it reaches the axis. It does not run back, except by half a
/// micrometre of rounding where an arc ends upright.
///
/// # Errors
/// The contour is empty, broken or runs back; a distance is missing or negative.
pub fn equidistant(contour: &Contour, distances: &[Half]) -> Result<Contour, EquidistantError> {
    let pieces = equidistant_over(contour, distances)?.into_iter().map(|over| over.piece).collect();
    Ok(Contour { side: contour.side, pieces })
}

/// The same, with the piece of the contour below each piece.
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

/// The offset with the bare faces at its ends. A face at an end without a distance has no strip, and no strip lies over
/// it, so it is added afterwards, from where the outline ends.
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
    let mut offset = outline(&Contour { side: contour.side, pieces: inside.to_vec() }, by, axis)?;
    for over in &mut offset {
        over.of += before;
    }
    // The part of a face that the neighbouring strip covers is left out.
    if let (Some(first), Some(start)) = (offset.first().map(|over| over.piece.from), contour.start())
        && (before > 0 && start.radius > first.radius && start.z == first.z)
    {
        offset.insert(0, Over { piece: Piece::line(start, first), of: before - 1 });
    }
    if let (Some(last), Some(end)) = (offset.last().map(|over| over.piece.to), contour.end())
        && (behind > 0 && end.radius > last.radius && end.z == last.z)
    {
        offset.push(Over { piece: Piece::line(last, end), of: rest.end });
    }
    Ok(offset)
}

/// The preconditions.
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

/// The outer boundary of the strips over an outer contour.
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
    let pieces = read_back::read_back(&whole, &ends, &parallels).ok_or(EquidistantError::NotJoined)?;
    if pieces.is_empty() { Err(EquidistantError::Vanished) } else { Ok(pieces) }
}

/// A piece and its offset, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parallel {
    /// The piece.
    pub piece: Piece,
    /// Its distance; over a concave arc at most the radius, because no offset goes beyond the centre.
    pub distance: f64,
    /// The required distance.
    pub wanted: f64,
    /// Its beginning.
    pub from: Vector,
    /// Its end.
    pub to: Vector,
    /// Its direction at its beginning, 1 long.
    pub ahead_from: Vector,
    /// Its direction at its end, 1 long.
    pub ahead_to: Vector,
    /// Where the offset begins.
    pub over_from: Vector,
    /// Where it ends.
    pub over_to: Vector,
    /// The angle of both, radians, as in [`Corner`]; 0 for a line and for an arc whose offset vanished.
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

/// The upper edges of all strips. Strips share an edge until a concave corner, or until the edge would run back.
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

/// The upper edges under construction.
#[derive(Default)]
struct Tops {
    done: Vec<Vec<Corner>>,
    /// The unfinished edge.
    top: Vec<Corner>,
    /// The corner of the part below its end.
    last_corner: Vector,
}

impl Tops {
    /// Continues to some corners above that corner of the part. Where the edge would run back, a new one begins.
    fn follow(&mut self, corners: Vec<Corner>, part: Vector) {
        for corner in corners {
            if self.top.last().is_some_and(|last| corner.at.z < last.at.z - TOUCH) {
                self.end(part);
            }
            if self.top.is_empty() && corner.at.z > part.z {
                // The strip leans towards the chuck: its edge begins at the part.
                self.top.push(Corner::sharp(part));
            }
            self.top.push(corner);
        }
    }

    /// Ends the edge above that corner of the part.
    fn end(&mut self, part: Vector) {
        if let Some(last) = self.top.last_mut() {
            last.sweep = 0.0;
            if last.at.z < part.z {
                // The strip leans towards the free end: its edge ends at the part.
                self.top.push(Corner::sharp(part));
            }
            self.done.push(std::mem::take(&mut self.top));
        }
    }
}

/// The corners between the axis and the strip that begins (or ends) on it: half of the join between the strip and its
/// mirror image.
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

/// The mirror image of a piece beyond the axis, in the direction in which the contour would go on there.
fn mirrored(parallel: &Parallel) -> Parallel {
    let piece = parallel.piece.inside_out(Half::ZERO).reversed();
    Parallel::new(piece, Half::from(parallel.wanted))
}

/// The corners between the end of one offset and the beginning of the next; none at a concave corner.
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
        // How far each offset must be extended to meet the other.
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
    // An arc about the corner, with the smaller distance of the two.
    let distance = one.wanted.min(next.wanted);
    let (from, to) = (corner.plus(out_one.times(distance)), corner.plus(out_next.times(distance)));
    Some(vec![Corner { at: from, sweep: -libm::atan2(sine, cosine) }, Corner::sharp(to)])
}

/// The outline of an upper edge and everything below it, down to the ground.
fn shadow(top: &[Corner], ground: f64) -> Vec<Corner> {
    let mut outline: Vec<Corner> = Vec::new();
    for corner in top {
        match outline.last_mut() {
            Some(last) if corner.at.minus(last.at).length() < TOUCH => last.sweep = corner.sweep,
            _ => outline.push(*corner),
        }
    }
    // An upright end, of a face without a distance, has no strip below it.
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
