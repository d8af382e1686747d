//! Monotone contours: pieces that only rise or only fall, so that each crosses a horizontal once.

use crate::turning::contour::{Contour, Curve, Piece, touching};
use crate::turning::length::Half;
use crate::turning::point::Point;

use super::narrow::is_narrow;

/// An arc is not divided where it is horizontal if that is nearer than this to its end, mm: over 10 µm it rises by less
/// than half a micrometre for every radius above 0.1 mm.
const NEAR_END: f64 = 0.01;

/// A monotone outer contour. Each piece rises, falls or is a cylinder; arcs are at most a quarter of a circle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MonotoneContour {
    /// The pieces from the free end.
    pub pieces: Vec<Piece>,
}

impl MonotoneContour {
    /// From a contour. A rising face at its start or a falling face at its end bounds no stock and is left out.
    pub fn of(contour: &Contour) -> Self {
        let mut pieces: Vec<Piece> = contour.pieces.iter().flat_map(|piece| quarters(*piece)).collect();
        while pieces.first().is_some_and(|piece| piece.is_face() && piece.to.radius > piece.from.radius) {
            pieces.remove(0);
        }
        while pieces.last().is_some_and(|piece| piece.is_face() && piece.to.radius < piece.from.radius) {
            pieces.pop();
        }
        Self { pieces }
    }

    /// Extended along the axis to cover a range of Z; an end with a face stays as it is.
    #[must_use]
    pub fn stretched(mut self, from: Half, to: Half) -> Self {
        if let Some(first) = self.pieces.first().filter(|piece| !piece.is_face() && piece.from.z > from) {
            let line = Piece::line(Point { radius: first.from.radius, z: from }, first.from);
            self.pieces.insert(0, line);
        }
        if let Some(last) = self.pieces.last().filter(|piece| !piece.is_face() && piece.to.z < to) {
            self.pieces.push(Piece::line(last.to, Point { radius: last.to.radius, z: to }));
        }
        self
    }

    /// Z of its beginning.
    pub fn from(&self) -> Half {
        self.pieces.first().map_or(Half::ZERO, |piece| piece.from.z)
    }

    /// Z of its end.
    pub fn to(&self) -> Half {
        self.pieces.last().map_or(Half::ZERO, |piece| piece.to.z)
    }

    /// The least radius over a range, without faces; none over a range without length.
    pub fn lowest(&self, from: Half, to: Half) -> Option<Half> {
        let radii = self.over(from, to).flat_map(|piece| [piece.from.radius, piece.to.radius]);
        radii.min()
    }

    /// The ranges of Z where it is not above a radius. A slot narrower than rounding counts as wall
    /// ([`NARROW`](super::narrow)).
    pub fn spans(&self, radius: Half, from: Half, to: Half) -> Vec<(Half, Half)> {
        let mut spans: Vec<(Half, Half)> = Vec::new();
        for piece in self.over(from, to) {
            let (begins, ends) = (piece.from.radius <= radius, piece.to.radius <= radius);
            let (a, b) = match (begins, ends) {
                (true, true) => (piece.from.z, piece.to.z),
                (true, false) => (piece.from.z, z_on(&piece, radius)),
                (false, true) => (z_on(&piece, radius), piece.to.z),
                (false, false) => continue,
            };
            match spans.last_mut() {
                Some(last) if last.1 == a => last.1 = b,
                _ => spans.push((a, b)),
            }
        }
        spans.retain(|(a, b)| !is_narrow(*a, *b));
        spans
    }

    /// The path over a range along the contour, but not below the radius `low` nor above the radius `high`. A falling
    /// face at its beginning and a rising face at its end are included.
    pub fn clamped(&self, low: Half, high: Half, from: Half, to: Half) -> Vec<Piece> {
        let mut path: Vec<Piece> = Vec::new();
        for piece in self.touching(from, to) {
            let part = if piece.is_face() {
                let rises = piece.to.radius > piece.from.radius;
                let z = piece.from.z;
                let in_it = if rises { from < z && z <= to } else { from <= z && z < to };
                in_it.then_some(*piece)
            } else {
                clipped(piece, from, to)
            };
            for part in part.into_iter().flat_map(|part| parted(part, low, high)) {
                match path.last_mut() {
                    Some(last) if last.is_cylinder() && part.is_cylinder() && last.to == part.from => last.to = part.to,
                    _ => path.push(part),
                }
            }
        }
        path
    }

    /// The contour itself over a range.
    pub fn along(&self, from: Half, to: Half) -> Vec<Piece> {
        self.clamped(Half::new(i64::MIN), Half::new(i64::MAX), from, to)
    }

    /// The falling flank down to a point of the contour, from its top; empty if the contour does not fall to it.
    pub fn flank(&self, foot: Point) -> Vec<Piece> {
        let falls = |piece: &&Piece| piece.from.radius > piece.to.radius;
        // A piece that ends at the point takes precedence over one that only passes it within rounding.
        let beside = self.touching(foot.z, foot.z);
        let ends = beside.iter().rposition(|piece| falls(&piece) && piece.to == foot);
        let passes = || beside.iter().rposition(|piece| falls(&piece) && lies_on(piece, foot));
        let Some(last) = ends.or_else(passes).map(|last| last + self.before(foot.z)) else { return Vec::new() };
        let above = self.pieces.iter().take(last).rev().take_while(falls);
        let mut flank: Vec<Piece> = above.copied().collect();
        flank.reverse();
        flank.extend(
            self.pieces.get(last).map(|piece| within(piece, piece.from, foot)).filter(|part| !part.is_nothing()),
        );
        flank
    }

    /// The contour after one of its points; after a point of a face first the rest of the face.
    pub fn beyond(&self, point: Point) -> impl Iterator<Item = Piece> + '_ {
        let rest = move |piece: &Piece| {
            if piece.is_face() {
                let rises = piece.to.radius > piece.from.radius;
                let passed = |end: Point| if rises { end.radius <= point.radius } else { end.radius >= point.radius };
                return match piece.from.z.cmp(&point.z) {
                    std::cmp::Ordering::Greater => Some(*piece),
                    // A face may be of several pieces.
                    std::cmp::Ordering::Equal if !passed(piece.from) => Some(*piece),
                    std::cmp::Ordering::Equal if !passed(piece.to) => Some(piece.between(point, piece.to)),
                    _ => None,
                };
            }
            clipped(piece, point.z, self.to())
        };
        let mut rest = self.pieces.iter().skip(self.before(point.z)).filter_map(rest);
        let mut begins: Vec<Piece> = rest.next().into_iter().collect();
        // On a steep piece the rounded radius at the Z of the point differs from that of the point. So the piece
        // begins at the point, or a perpendicular line leads to the piece if the point is before its beginning.
        if let Some(first) = begins.first().copied().filter(|first| !first.is_face() && first.from.z == point.z) {
            let own_start =
                self.touching(point.z, point.z).iter().any(|piece| piece.from == first.from && piece.to == first.to);
            let rises = first.to.radius >= first.from.radius;
            let before = if rises { point.radius < first.from.radius } else { point.radius > first.from.radius };
            if own_start && before {
                begins.insert(0, Piece::line(point, first.from));
            } else if let Some(first) = begins.first_mut() {
                first.from = point;
            }
        }
        begins.into_iter().chain(rest)
    }

    /// The contour from a point over a length, mm, as long as it does not fall.
    pub fn onwards(&self, point: Point, length: f64) -> Vec<Piece> {
        let (mut left, mut path) = (length, Vec::new());
        for piece in self.beyond(point) {
            if left <= 0.0 || piece.to.radius < piece.from.radius {
                break;
            }
            let whole = piece.length_mm();
            let part = if whole <= left { piece } else { piece.between(piece.from, piece.at_length(left)) };
            left -= whole;
            if !part.is_nothing() {
                path.push(part);
            }
        }
        path
    }

    /// The greatest radius over a range, without faces; none over a range without length.
    pub fn highest(&self, from: Half, to: Half) -> Option<Half> {
        self.over(from, to).flat_map(|piece| [piece.from.radius, piece.to.radius]).max()
    }

    /// The ranges of the pieces that are below a radius somewhere. Between two of them no stock of a blank of that
    /// radius is over the contour.
    pub fn below(&self, radius: Half, from: Half, to: Half) -> Vec<(Half, Half)> {
        let mut stretches: Vec<(Half, Half)> = Vec::new();
        for piece in self.over(from, to).filter(|piece| piece.from.radius.min(piece.to.radius) < radius) {
            match stretches.last_mut() {
                Some(last) if last.1 == piece.from.z => last.1 = piece.to.z,
                _ => stretches.push((piece.from.z, piece.to.z)),
            }
        }
        stretches
    }

    /// Whether a point lies on the contour, within rounding.
    pub fn holds(&self, point: Point) -> bool {
        self.touching(point.z, point.z).iter().any(|piece| lies_on(piece, point))
    }

    /// The parts of its pieces over a range, without faces.
    fn over(&self, from: Half, to: Half) -> impl Iterator<Item = Piece> + '_ {
        let beside = self.touching(from, to).iter();
        beside.filter(|piece| !piece.is_face()).filter_map(move |piece| clipped(piece, from, to))
    }

    /// The number of pieces that end before a Z. The contour does not run back, so the pieces are in the order of Z.
    fn before(&self, z: Half) -> usize {
        self.pieces.partition_point(|piece| piece.to.z < z)
    }

    /// The pieces with a point in a range, its ends included.
    pub fn touching(&self, from: Half, to: Half) -> &[Piece] {
        touching(&self.pieces, from, to)
    }
}

/// Whether a point lies on a monotone piece, within rounding.
pub fn lies_on(piece: &Piece, point: Point) -> bool {
    let near = |a: Half, b: Half| (a - b).halves().abs() <= 1;
    let (low, high) = (piece.from.radius.min(piece.to.radius), piece.from.radius.max(piece.to.radius));
    let (over, beside) =
        (piece.from.z <= point.z && point.z <= piece.to.z, low <= point.radius && point.radius <= high);
    over && if piece.is_face() {
        beside
    } else {
        let aslant = beside && !piece.is_cylinder();
        near(radius_on(piece, point.z), point.radius) || aslant && near(z_on(piece, point.radius), point.z)
    }
}

/// The radius at a Z of a piece that is not a face, rounded to half a micrometre.
pub fn radius_on(piece: &Piece, z: Half) -> Half {
    let (along, whole) = (z - piece.from.z, piece.to.z - piece.from.z);
    if along == Half::ZERO || piece.is_cylinder() {
        return piece.from.radius;
    }
    if z == piece.to.z {
        return piece.to.radius;
    }
    match (piece.curve, piece.centre()) {
        (Curve::Arc { radius, .. }, Some(centre)) => {
            let rounded = across(radius, z.to_mm() - centre.z, centre.radius, piece.from.radius, piece.to.radius);
            rounded.clamp(piece.from.radius.min(piece.to.radius), piece.from.radius.max(piece.to.radius))
        }
        _ => piece.from.radius + share(piece.to.radius - piece.from.radius, along, whole),
    }
}

/// The Z at a radius of a rising or falling piece, rounded to half a micrometre.
pub fn z_on(piece: &Piece, at: Half) -> Half {
    let (up, whole) = (at - piece.from.radius, piece.to.radius - piece.from.radius);
    if up == Half::ZERO || whole == Half::ZERO {
        return piece.from.z;
    }
    if at == piece.to.radius {
        return piece.to.z;
    }
    match (piece.curve, piece.centre()) {
        (Curve::Arc { radius, .. }, Some(centre)) => {
            let rounded = across(radius, at.to_mm() - centre.radius, centre.z, piece.from.z, piece.to.z);
            rounded.clamp(piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z))
        }
        _ => piece.from.z + share(piece.to.z - piece.from.z, up, whole),
    }
}

/// The other coordinate of a circle at `off` from its centre along one: of the two solutions the one between the ends.
fn across(radius: Half, off: f64, centre: f64, one: Half, other: Half) -> Half {
    let half = libm::sqrt((radius.to_mm() * radius.to_mm() - off * off).max(0.0));
    let middle = (one.to_mm() + other.to_mm()) / 2.0;
    Half::from(if middle >= centre { centre + half } else { centre - half })
}

/// A share of a size, rounded to the nearest.
fn share(size: Half, part: Half, whole: Half) -> Half {
    let (size, part, whole) = (i128::from(size.halves()), i128::from(part.halves()), i128::from(whole.halves()));
    let doubled = (2 * size * part).checked_div(whole).unwrap_or(0);
    Half::new(i64::try_from((doubled + doubled.signum()) / 2).unwrap_or(0))
}

/// A piece divided where it is horizontal or vertical, so that each part only rises or only falls along both axes. A
/// part that is perpendicular only by rounding is a face, as everywhere along the contour.
fn quarters(piece: Piece) -> Vec<Piece> {
    let far = |point: &Point| piece.from.to(*point).length() > NEAR_END && point.to(piece.to).length() > NEAR_END;
    let mut cuts: Vec<Point> = match piece.curve {
        Curve::Line => Vec::new(),
        Curve::Arc { .. } => piece.extremes().into_iter().filter(far).collect(),
    };
    cuts.sort_by(|a, b| piece.from.to(*a).length().total_cmp(&piece.from.to(*b).length()));
    cuts.dedup();
    cuts.push(piece.to);
    let mut here = piece.from;
    let mut quarters = Vec::new();
    for cut in cuts {
        quarters.push(within(&piece, here, cut));
        here = cut;
    }
    quarters
}

/// The part of a piece within a range of Z, if it has a length; the piece must not be a face.
pub fn clipped(piece: &Piece, from: Half, to: Half) -> Option<Piece> {
    let (a, b) = (piece.from.z.max(from), piece.to.z.min(to));
    let at = |z: Half| Point { radius: radius_on(piece, z), z };
    (a < b).then(|| piece.between(at(a), at(b)))
}

/// The part of a piece between two of its points. If the rest of a steep arc is so short that it is perpendicular, it
/// becomes a face.
pub fn within(piece: &Piece, from: Point, to: Point) -> Piece {
    if from.z == to.z { Piece::line(from, to) } else { piece.between(from, to) }
}

/// A monotone piece cut at two radii; the parts beyond them become horizontal at them.
fn parted(piece: Piece, low: Half, high: Half) -> Vec<Piece> {
    let mut cuts = vec![piece.from];
    let between = |radius: &Half| {
        piece.from.radius.min(piece.to.radius) < *radius && *radius < piece.from.radius.max(piece.to.radius)
    };
    let mut radii: Vec<Half> = [low, high].into_iter().filter(between).collect();
    if piece.to.radius < piece.from.radius {
        radii.reverse();
    }
    cuts.extend(radii.into_iter().map(|radius| Point { radius, z: z_on(&piece, radius) }));
    cuts.push(piece.to);
    let part = |(from, to): (&Point, &Point)| {
        let flat = |radius: Half| Piece::line(Point { radius, z: from.z }, Point { radius, z: to.z });
        if from.radius.max(to.radius) <= low {
            flat(low)
        } else if from.radius.min(to.radius) >= high {
            flat(high)
        } else {
            within(&piece, *from, *to)
        }
    };
    cuts.iter().zip(cuts.iter().skip(1)).map(part).filter(|part| !part.is_nothing()).collect()
}
