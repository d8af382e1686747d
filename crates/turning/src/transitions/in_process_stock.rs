//! The in-process stock over a zone: for each Z the radius of the metal, as spans with one line or arc each. A
//! working move lowers it to its path. Exact along Z to half a micrometre.

use crate::turning::contour::{Contour, Curve, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;

use super::monotone::{MonotoneContour, clipped, radius_on};
use super::narrow::{NARROW, is_narrow};

/// A span under one line or arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StockSpan {
    /// Z of its beginning.
    pub from: Half,
    /// Z of its end.
    pub to: Half,
    /// Its surface: a piece that only rises or only falls, not a face; it may be longer than the span.
    pub top: Piece,
}

/// The metal over a zone; beyond its ends there is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InProcessStock {
    cells: Vec<StockSpan>,
}

impl InProcessStock {
    /// The whole blank, or everything that a contour bounds.
    pub fn of(blank: &MonotoneContour) -> Self {
        let pieces = blank.pieces.iter().filter(|piece| !piece.is_face());
        Self { cells: pieces.map(|piece| StockSpan { from: piece.from.z, to: piece.to.z, top: *piece }).collect() }
    }

    /// The spans.
    pub fn cells(&self) -> &[StockSpan] {
        &self.cells
    }

    /// The radius of the metal just before a Z and just after it; none beyond the ends.
    pub fn sides(&self, z: Half) -> (Option<Half>, Option<Half>) {
        let at = |cell: &StockSpan| radius_on(&cell.top, z);
        let next = self.cells.partition_point(|cell| cell.to < z);
        let before = self.cells.get(next).filter(|cell| cell.from < z && z <= cell.to).map(at);
        let next = self.cells.partition_point(|cell| cell.to <= z);
        let behind = self.cells.get(next).filter(|cell| cell.from <= z && z < cell.to).map(at);
        (before, behind)
    }

    /// The smaller radius of both sides of a Z; beyond the ends that of the neighbouring metal. A tool can move down
    /// a face to this radius. A slot narrower than the rounding does not count; the wall behind it does.
    pub fn least_at(&self, z: Half) -> Option<Half> {
        let (before, behind) = self.sides(z);
        match (before.max(self.walled(z - NARROW, z)), behind.max(self.walled(z, z + NARROW))) {
            (Some(before), Some(behind)) => Some(before.min(behind)),
            (one, other) => one.or(other),
        }
    }

    /// The greatest radius of the metal where a span begins or ends between two Z.
    fn walled(&self, from: Half, to: Half) -> Option<Half> {
        let within = |z: Half| from < z && z < to;
        let radii = self.over(from, to).iter().flat_map(|cell| {
            let begins = within(cell.from).then(|| radius_on(&cell.top, cell.from));
            begins.into_iter().chain(within(cell.to).then(|| radius_on(&cell.top, cell.to)))
        });
        radii.max()
    }

    /// The greatest radius between two Z; none if there is no metal. The metal beyond them does not count.
    pub fn highest(&self, from: Half, to: Half) -> Option<Half> {
        let (from, to) = (from.min(to), from.max(to));
        let parts = self.over(from, to).iter().filter_map(|cell| self.part(cell, from, to));
        parts.flat_map(|part| [part.from.radius, part.to.radius]).max()
    }

    /// The length before a Z, at most `most`, without metal above a radius.
    pub fn room_before(&self, z: Half, radius: Half, most: Half) -> Half {
        let stop = z - most;
        for cell in self.over(stop, z).iter().rev() {
            let Some(part) = self.part(cell, stop, z) else { continue };
            if part.to.radius > radius {
                return z - part.to.z;
            }
            if part.from.radius > radius {
                return z - super::monotone::z_on(&part, radius);
            }
        }
        most
    }

    /// The ranges of Z where a piece that is not a face goes through metal. Touching does not count.
    pub fn metal(&self, piece: &Piece) -> Vec<(Half, Half)> {
        let mut stretches: Vec<(Half, Half)> = Vec::new();
        self.compared(piece, |a, b, above| {
            if above {
                match stretches.last_mut() {
                    Some(last) if last.1 == a => last.1 = b,
                    _ => stretches.push((a, b)),
                }
            }
        });
        stretches
    }

    /// Removes the metal above a piece. A face removes nothing: it has no width.
    pub fn lower(&mut self, piece: &Piece) {
        let piece = &if piece.to.z < piece.from.z { piece.reversed() } else { *piece };
        let mut lowered: Vec<StockSpan> = Vec::new();
        self.compared(piece, |from, to, above| {
            if above {
                lowered.push(StockSpan { from, to, top: *piece });
            }
        });
        for cell in lowered {
            self.replace(cell);
        }
    }

    /// Whether a straight move between two points goes through no metal. If that is not certain, false.
    pub fn is_clear(&self, from: Point, to: Point) -> bool {
        let (from, to) = if from.z <= to.z { (from, to) } else { (to, from) };
        if from.z == to.z {
            return self.least_at(from.z).is_none_or(|least| from.radius.min(to.radius) >= least);
        }
        let line = Piece::line(from, to);
        let over = |cell: &StockSpan| {
            let Some(part) = self.part(cell, from.z, to.z) else { return true };
            let (a, b) = (radius_on(&line, part.from.z), radius_on(&line, part.to.z));
            part.from.radius <= a && part.to.radius <= b && {
                // An arc may be higher between its ends, so the move must be above both of them.
                matches!(part.curve, Curve::Line) || part.from.radius.max(part.to.radius) <= a.min(b)
            }
        };
        self.over(from.z, to.z).iter().all(over)
    }

    /// The greatest height of metal above a ground. Remains of rounding do not count, nor does metal that fills a
    /// slot narrower than rounding. Where an arc meets a slope it is an upper bound.
    pub fn ridge(&self, ground: &[Piece]) -> Half {
        let mut most = Half::ZERO;
        for piece in ground.iter().filter(|piece| !piece.is_face()) {
            for cell in self.over(piece.from.z, piece.to.z) {
                let top = self.part(cell, piece.from.z, piece.to.z);
                let under = off_foot(piece).and_then(|piece| clipped(&piece, cell.from, cell.to));
                let (Some(top), Some(under)) = (top, under) else { continue };
                if !is_sliver(&top, piece) && !touches(&top, piece) {
                    most = most.max(over(&top, &under));
                }
            }
        }
        most
    }

    /// The surface of the stock over a ground; the ground itself where only rounding is above it. It is the blank of
    /// the next, deeper work.
    pub fn surface(&self, ground: &MonotoneContour) -> Contour {
        let mut pieces: Vec<Piece> = Vec::new();
        // The index of the piece of the ground that the last piece is part of.
        let mut of = None;
        for (index, piece) in ground.pieces.iter().enumerate().filter(|(_, piece)| !piece.is_face()) {
            for cell in self.over(piece.from.z, piece.to.z) {
                let (Some(top), Some(under)) =
                    (self.part(cell, piece.from.z, piece.to.z), clipped(piece, cell.from, cell.to))
                else {
                    continue;
                };
                let is_ground = cell.top == *piece;
                let clean = is_ground || (top.to.z - top.from.z).halves() <= ROUNDED || touches(&top, piece);
                let (next, source) = if clean { (under, Some(index)) } else { (top, None) };
                match pieces.last_mut() {
                    Some(last) if source.is_some() && source == of => last.to = next.to,
                    Some(last) if last.is_cylinder() && next.is_cylinder() && last.to == next.from => last.to = next.to,
                    Some(last) => {
                        let face = Piece::line(last.to, next.from);
                        pieces.extend([face, next].into_iter().filter(|piece| !piece.is_nothing()));
                    }
                    None => pieces.push(next),
                }
                of = source;
            }
        }
        Contour { side: Side::Outer, pieces }
    }

    /// The spans with a length over a range.
    pub fn over(&self, from: Half, to: Half) -> &[StockSpan] {
        let (_, ahead) = self.cells.split_at(self.cells.partition_point(|cell| cell.to <= from));
        ahead.split_at(ahead.partition_point(|cell| cell.from < to)).0
    }

    /// The part of a span within a range, if it has a length.
    fn part(&self, cell: &StockSpan, from: Half, to: Half) -> Option<Piece> {
        clipped(&cell.top, from.max(cell.from), to.min(cell.to))
    }

    /// Calls `tell` for each range under a piece, from the free end, with whether there is metal above it.
    fn compared(&self, piece: &Piece, mut tell: impl FnMut(Half, Half, bool)) {
        let piece = &if piece.to.z < piece.from.z { piece.reversed() } else { *piece };
        for cell in self.over(piece.from.z, piece.to.z) {
            let (from, to) = (cell.from.max(piece.from.z), cell.to.min(piece.to.z));
            if from < to {
                compare(&cell.top, piece, from, to, &mut tell);
            }
        }
    }

    /// Replaces the spans of a range with a new span.
    fn replace(&mut self, new: StockSpan) {
        let first = self.cells.partition_point(|cell| cell.to <= new.from);
        let last = self.cells.partition_point(|cell| cell.from < new.to);
        let mut put = Vec::with_capacity(3);
        let old = self.cells.get(first..last).unwrap_or_default();
        if let Some(cell) = old.first().filter(|cell| cell.from < new.from) {
            put.push(StockSpan { to: new.from, ..*cell });
        }
        put.push(new);
        if let Some(cell) = old.last().filter(|cell| cell.to > new.to) {
            put.push(StockSpan { from: new.to, ..*cell });
        }
        self.cells.splice(first..last, put);
    }
}

/// Metal no higher than this above a piece touches it, in halves of a micrometre.
const TOUCHING: i64 = 1;

/// A ridge must be higher than this, in halves of a micrometre: the ends of a cut, of the one beside it and of the
/// contour are rounded, together by one and a half micrometres.
const ROUNDED: i64 = 3;

/// Calls `tell` for the parts of a range where one piece is above another; they may cross more than once.
fn compare(top: &Piece, piece: &Piece, from: Half, to: Half, tell: &mut impl FnMut(Half, Half, bool)) {
    let middle = Half::new((from.halves() + to.halves()).div_euclid(2));
    let places = [from, middle, to];
    let over = |z: Half| (radius_on(top, z) - radius_on(piece, z)).halves();
    if places.iter().all(|z| over(*z) <= TOUCHING || is_near(top, piece, *z, TOUCHING)) {
        tell(from, to, false);
    } else if places.iter().all(|z| over(*z) >= 0) || middle == from {
        tell(from, to, true);
    } else {
        compare(top, piece, from, middle, tell);
        compare(top, piece, middle, to, tell);
    }
}

/// Whether one piece is above another at a Z by no more than rounding, which is half a micrometre along both axes: on a
/// steep piece that is more across the axis than along it.
fn is_near(top: &Piece, piece: &Piece, z: Half, slack: i64) -> bool {
    let reach = [z - Half::new(1), z, z + Half::new(1)];
    let reach = reach.into_iter().filter(|z| (piece.from.z..=piece.to.z).contains(z));
    let near = reach.map(|z| radius_on(piece, z)).max().unwrap_or_default();
    (radius_on(top, z) - near).halves() <= slack
}

/// Whether the stock between `top` and a piece is too narrow to count.
fn is_sliver(top: &Piece, piece: &Piece) -> bool {
    let (mut first, mut last) = (top.to.z, top.from.z);
    compare(top, piece, top.from.z, top.to.z, &mut |from, to, above| {
        if above {
            (first, last) = (first.min(from), last.max(to));
        }
    });
    is_narrow(first, last)
}

/// A piece without the lowest end of an arc. If the stock beside that end is as low, it is compared there; otherwise it
/// and the arc form a slot.
fn off_foot(piece: &Piece) -> Option<Piece> {
    match piece.curve {
        Curve::Line => Some(*piece),
        Curve::Arc { .. } if piece.from.radius < piece.to.radius => clipped(piece, piece.from.z + NARROW, piece.to.z),
        Curve::Arc { .. } => clipped(piece, piece.from.z, piece.to.z - NARROW),
    }
}

/// The number of parts of a range at whose ends two pieces are compared.
const PARTS: i64 = 16;

/// The places where two pieces over one range are compared.
fn places(piece: &Piece) -> impl Iterator<Item = Half> + use<> {
    let (from, length) = (piece.from.z.halves(), (piece.to.z - piece.from.z).halves());
    (0..=PARTS).map(move |part| Half::new(from + length * part / PARTS))
}

/// Whether a piece coincides with another, apart from rounding.
fn touches(top: &Piece, under: &Piece) -> bool {
    places(top).all(|z| is_near(top, under, z, ROUNDED))
}

/// The greatest height of a piece above another: exact if both are straight or one is horizontal, otherwise an upper
/// bound.
fn over(top: &Piece, under: &Piece) -> Half {
    let straight = |piece: &Piece| matches!(piece.curve, Curve::Line);
    if straight(top) && straight(under) || top.is_cylinder() || under.is_cylinder() {
        return (top.from.radius - under.from.radius).max(top.to.radius - under.to.radius);
    }
    let between =
        |(a, b): (Half, Half)| radius_on(top, a).max(radius_on(top, b)) - radius_on(under, a).min(radius_on(under, b));
    places(top).zip(places(top).skip(1)).map(between).max().unwrap_or_default()
}
