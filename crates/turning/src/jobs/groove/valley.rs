//! The shape of a groove seen from its mouth: `z` along the mouth, `radius` out of the metal, so that grooves
//! outside, inside and in a face are handled alike; and the path of the centre of a round corner that touches it.

use crate::error::{Refusal, Tried};
use crate::turning::contour::{Curve, Piece, Profile, Side, Surface, SurfaceKind, Turn};
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

use super::super::refused::NoJob;

/// The place of a groove in the set-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lie {
    /// In a cylinder, cut from outside.
    Outside,
    /// In a bore.
    Inside,
    /// In a face towards the free end.
    Face,
}

impl Lie {
    /// A point of the set-up as seen from the mouth, and back: the mapping is its own inverse. The leading corner of
    /// the blade, towards the chuck or towards the axis, has the greater `z`.
    pub fn seen(self, point: Point) -> Point {
        match self {
            Self::Outside => point,
            Self::Inside => point.inside_out(Half::ZERO),
            Self::Face => Point { radius: Half::ZERO - point.z, z: Half::ZERO - point.radius },
        }
    }

    /// The same for a piece.
    pub fn piece(self, piece: Piece) -> Piece {
        piece.mapped(self != Self::Outside, |point| self.seen(point))
    }
}

/// A groove: a wall down, a floor, a wall up, with concave corners. Seen from its mouth.
#[derive(Clone, Debug)]
pub(super) struct Valley {
    pub lie: Lie,
    /// Its pieces in the order of `z`.
    pub pieces: Vec<Piece>,
    /// The height of its mouth.
    pub mouth: Half,
    /// The height of its floor.
    pub floor: Half,
    /// The foot of what rises beside its mouth more steeply than its own walls, such as a shoulder.
    shoulders: [Option<Piece>; 2],
}

/// Ends of pieces nearer than this differ only by rounding, mm.
const APART: f64 = 0.002;

/// As high a round nose leaves its rounding at the foot of a shoulder, mm: the roundest of the catalogs has 1.6.
const FOOT: f64 = 1.6;

/// The foot of a wall that begins at the mouth. A rounding that bends away from the groove keeps its curve; the line along the beginning
/// of another is clear of it.
fn foot(wall: Piece, away: Turn) -> Piece {
    let far = FOOT.min(wall.length_mm());
    match wall.curve {
        Curve::Arc { turn, .. } if turn == away => wall.between(wall.from, wall.at_length(far)),
        _ => Piece::line(wall.from, wall.from.moved(wall.direction_at_start().times(far))),
    }
}

/// As far may a shoulder be moved from the mouth by the middle of its limits, mm.
const BESIDE: f64 = 0.05;

impl Valley {
    /// The groove of a surface.
    ///
    /// # Errors
    /// It faces the chuck, goes under its own mouth, or is no valley.
    pub fn of(surface: &Surface, side: Side) -> Tried<Self, NoJob> {
        let name = || surface.name.clone();
        let lie = match (surface.kind, side) {
            (SurfaceKind::FaceGroove, Side::Outer) => Lie::Face,
            // The bottom of a bore would be faced from inside, where no holder of the catalogs can go.
            (SurfaceKind::FaceGroove, Side::Inner) => return Err(Refusal::Not(NoJob::NoTool { surface: name() })),
            (_, Side::Outer) => Lie::Outside,
            (_, Side::Inner) => Lie::Inside,
        };
        let mut pieces: Vec<Piece> = surface.pieces.iter().map(|piece| lie.piece(*piece)).collect();
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else {
            return Err(Refusal::Not(NoJob::NotAValley { surface: name() }));
        };
        if lie == Lie::Face {
            // Outwards the face is towards the free end; seen from the mouth that is from the greater `z` to the
            // smaller.
            if last.to.z >= first.from.z {
                return Err(Refusal::Not(NoJob::FacesChuck { surface: name() }));
            }
            pieces = pieces.into_iter().rev().map(Piece::reversed).collect();
        }
        let back: Vec<&Piece> = pieces.iter().filter(|piece| piece.to.z < piece.from.z).collect();
        if !back.is_empty() {
            // Both mouths lead under the metal: the main edge must be inclined as much as the piece that runs back.
            let falls = pieces.iter().map(|piece| -piece.chord().degrees()).fold(0.0, f64::max);
            let rises = back.iter().map(|piece| piece.chord().degrees()).fold(90.0, f64::max);
            return Err(Refusal::Not(NoJob::Undercut { surface: name(), main: rises, secondary: falls }));
        }
        let ends = pieces.first().zip(pieces.last()).map(|(first, last)| (first.from.radius, last.to.radius));
        let floor = pieces.iter().map(|piece| piece.radii().0).min();
        let (Some((from, to)), Some(floor)) = (ends, floor) else {
            return Err(Refusal::Not(NoJob::NotAValley { surface: name() }));
        };
        let bends_out = |piece: &Piece| matches!(piece.curve, Curve::Arc { turn: Turn::Right, .. });
        let corners = pieces.iter().zip(pieces.iter().skip(1));
        let ridge = |(one, next): (&Piece, &Piece)| one.direction_at_end().cross(next.direction_at_start()) < -0.01;
        if floor >= from.min(to) || pieces.iter().any(bends_out) || corners.into_iter().any(ridge) {
            return Err(Refusal::Not(NoJob::NotAValley { surface: name() }));
        }
        Ok(Self { lie, pieces, mouth: from.max(to), floor, shoulders: [None, None] })
    }

    /// With the shoulders of a profile beside it, into which no corner of a blade may go.
    pub fn between_shoulders(mut self, profile: &Profile) -> Self {
        if self.lie == Lie::Face {
            return self;
        }
        let near = |one: Point, other: Point| one.to(other).length() < BESIDE;
        let seen = |piece: &Piece| self.lie.piece(*piece);
        let all: Vec<Piece> = profile.surfaces.iter().flat_map(|surface| &surface.pieces).map(seen).collect();
        let steeper = |falls: Vector, rises: Vector| falls.cross(rises) > 0.01;
        // From the mouth on; beside its beginning from right to left.
        let rises = |wall: Piece, own: Vector, turn: Turn| {
            let along = wall.direction_at_start();
            let up = wall.to.radius > wall.from.radius && along.radius > 0.0;
            let steep = if turn == Turn::Right { steeper(own, along) } else { steeper(along.times(-1.0), own) };
            let outwards = if turn == Turn::Right { along.z } else { -along.z };
            (up && steep && outwards > -1e-9).then(|| foot(wall, turn))
        };
        let before = self.pieces.first().and_then(|first| {
            let wall = all.iter().find(|piece| near(piece.to, first.from))?.reversed();
            Some(rises(wall, first.direction_at_start(), Turn::Left)?.reversed())
        });
        let behind = self.pieces.last().and_then(|last| {
            let wall = *all.iter().find(|piece| near(piece.from, last.to))?;
            rises(wall, last.direction_at_end(), Turn::Right)
        });
        self.shoulders = [before, behind];
        self
    }

    /// Where its mouth ends.
    pub fn end(&self) -> Half {
        self.pieces.last().map_or(Half::ZERO, |piece| piece.to.z)
    }

    /// From the mouth to the floor.
    pub fn depth(&self) -> Half {
        self.mouth - self.floor
    }

    /// The steepest fall and the steepest rise of its walls, degrees.
    pub fn steepest(&self) -> (f64, f64) {
        let directions = self.pieces.iter().flat_map(|piece| [piece.direction_at_start(), piece.direction_at_end()]);
        let degrees: Vec<f64> = directions.map(Vector::degrees).collect();
        (
            degrees.iter().fold(0.0, |most: f64, one| most.max(-one)),
            degrees.iter().fold(0.0, |most: f64, one| most.max(*one)),
        )
    }

    /// The height above the floor up to which a corner of the edge rounds the steeper wall off, where the groove has none as round:
    /// a circle that touches the floor and a wall under the angle θ touches the wall r·(1 − cos θ) above the floor.
    pub fn rounded_off(&self, corner: f64) -> Half {
        if self.corner().to_mm() >= corner {
            return Half::ZERO;
        }
        let (fall, rise) = self.steepest();
        Half::from(corner * (1.0 - libm::cos(fall.max(rise).to_radians())))
    }

    /// Whether one of its walls stands square to the seat.
    pub fn is_upright(&self) -> bool {
        let (fall, rise) = self.steepest();
        fall.max(rise) > 89.9
    }

    /// The least radius of the corners of its floor; zero for a sharp one.
    pub fn corner(&self) -> Half {
        let is_line = |piece: &Piece| piece.curve == Curve::Line;
        let sharp = self.pieces.iter().zip(self.pieces.iter().skip(1)).any(|(one, next)| {
            is_line(one) && is_line(next) && one.direction_at_end().cross(next.direction_at_start()) > 0.01
        });
        let radii = self.pieces.iter().filter_map(|piece| match piece.curve {
            Curve::Arc { radius, .. } => Some(radius),
            Curve::Line => None,
        });
        if sharp { Half::ZERO } else { radii.min().unwrap_or(Half::ZERO) }
    }

    /// The path of the centre of a round corner that touches the groove everywhere; none if the corner is too large.
    /// Walls are extended beyond the mouth by that radius, because a shoulder may be above them, and because the edge
    /// of a groove shallower than the corner must not be rounded.
    pub fn centres(&self, corner: f64) -> Option<CentrePath> {
        let mut way: Vec<PathSpan> = Vec::new();
        let [before, behind] = self.shoulders;
        let pieces: Vec<Piece> = before.into_iter().chain(self.pieces.iter().copied()).chain(behind).collect();
        let last = pieces.len().saturating_sub(1);
        for (index, piece) in pieces.iter().enumerate() {
            let Some(mut next) = PathSpan::beside(*piece, corner) else { continue };
            let line = next.arc.is_none();
            if index == 0 && line {
                next.from = next.from.minus(piece.direction_at_start().times(corner));
            }
            if index == last && line {
                next.to = next.to.plus(piece.direction_at_end().times(corner));
            }
            loop {
                let Some(last) = way.last_mut() else {
                    way.push(next);
                    break;
                };
                if last.to.minus(next.from).length() < APART {
                    next.from = last.to;
                    way.push(next);
                    break;
                }
                if let Some(cross) = last.meets(&next) {
                    (last.to, next.from) = (cross, cross);
                    way.push(next);
                    break;
                }
                let (Some(mine), Some(own)) = (last.line(), next.line()) else { return None };
                // Where both lines cross, in lengths of each.
                let turn = mine.cross(own);
                if turn <= 0.0 {
                    return None;
                }
                let between = next.from.minus(last.from);
                let (along_last, along_next) = (between.cross(own) / turn, between.cross(mine) / turn);
                if along_next > 1.0 {
                    // The corner never touches this piece.
                    break;
                }
                if along_last < 0.0 {
                    way.pop();
                    continue;
                }
                let cross = last.from.plus(mine.times(along_last));
                (last.to, next.from) = (cross, cross);
                way.push(next);
                break;
            }
        }
        let low = way.iter().flat_map(|span| [span.from.radius, span.to.radius]).fold(f64::INFINITY, f64::min);
        Some(CentrePath { spans: way, low }).filter(|way| !way.spans.is_empty())
    }
}

/// A section of a toolpath: a line, or an arc that is concave like the corner below it.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathSpan {
    pub from: Vector,
    pub to: Vector,
    /// Radius of an arc, mm, and its sense.
    pub arc: Option<(f64, Turn)>,
}

impl PathSpan {
    /// The offset of a piece, out of the metal; none for a concave arc not larger than the corner.
    fn beside(piece: Piece, corner: f64) -> Option<Self> {
        let (from, to) = (piece.from.vector(), piece.to.vector());
        let off = |at: Vector, along: Vector| at.plus(along.left().times(corner));
        let (start, end) = (off(from, piece.direction_at_start()), off(to, piece.direction_at_end()));
        let arc = match piece.curve {
            Curve::Line => None,
            Curve::Arc { radius, turn: Turn::Right } => Some((radius.to_mm() + corner, Turn::Right)),
            Curve::Arc { radius, .. } if radius.to_mm() - corner < APART / 2.0 => return None,
            Curve::Arc { radius, .. } => Some((radius.to_mm() - corner, Turn::Left)),
        };
        Some(Self { from: start, to: end, arc })
    }

    /// Where a line runs into the arc of a shoulder behind it, or an arc before it ends on a line; none of two others.
    fn meets(&self, next: &Self) -> Option<Vector> {
        let (line, arc, enters) = match (self.arc, next.arc) {
            (None, Some((_, Turn::Right))) => (self, next, true),
            (Some((_, Turn::Right)), None) => (next, self, false),
            _ => return None,
        };
        let centre = arc.piece(Vector::default()).centre()?;
        let (along, (radius, _)) = (line.line()?.unit(), arc.arc?);
        let to_centre = centre.minus(line.from);
        let (foot, off) = (to_centre.dot(along), to_centre.cross(along));
        let half = libm::sqrt(radius * radius - off * off);
        let at = if enters { foot - half } else { foot + half };
        // Not a number where the line passes the arc.
        (at.is_finite() && at > 0.0).then(|| line.from.plus(along.times(at)))
    }

    fn line(&self) -> Option<Vector> {
        self.arc.is_none().then(|| self.to.minus(self.from))
    }

    /// As a piece, moved by a vector.
    fn piece(&self, by: Vector) -> Piece {
        let (from, to) = (Point::at(self.from.plus(by)), Point::at(self.to.plus(by)));
        let curve = match self.arc {
            None => Curve::Line,
            Some((radius, turn)) => Curve::Arc { radius: Half::from(radius), turn },
        };
        Piece { from, to, curve }
    }

    /// Its height at a place along the mouth.
    fn height(&self, z: f64) -> Option<f64> {
        if z < self.from.z || z > self.to.z {
            return None;
        }
        match self.arc {
            None if self.to.z - self.from.z < 1e-9 => Some(self.from.radius.min(self.to.radius)),
            None => {
                let share = (z - self.from.z) / (self.to.z - self.from.z);
                Some(self.from.radius + (self.to.radius - self.from.radius) * share)
            }
            Some((radius, turn)) => {
                let piece = self.piece(Vector::default());
                let centre = piece.centre()?;
                let off = z - centre.z;
                let over = libm::sqrt((radius * radius - off * off).max(0.0));
                Some(if turn == Turn::Left { centre.radius - over } else { centre.radius + over })
            }
        }
    }
}

/// The path of a centre over a groove, from one end of the mouth to the other.
#[derive(Clone, Debug)]
pub(super) struct CentrePath {
    spans: Vec<PathSpan>,
    /// Its lowest height, mm.
    low: f64,
}

impl CentrePath {
    /// Its range along the floor, mm.
    pub fn floor(&self) -> (f64, f64) {
        let low = |at: &Vector| at.radius < self.low + APART / 2.0;
        let ends = self.spans.iter().flat_map(|span| [span.from, span.to]).filter(low);
        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), at| (from.min(at.z), to.max(at.z)))
    }

    /// Its ends along the mouth, mm.
    pub fn ends(&self) -> (f64, f64) {
        let (first, last) = (self.spans.first(), self.spans.last());
        (first.map_or(0.0, |span| span.from.z), last.map_or(0.0, |span| span.to.z))
    }

    /// The least height of the centre at a place along the mouth, mm; none beyond its ends.
    pub fn height(&self, z: f64) -> Option<f64> {
        self.spans.iter().filter_map(|span| span.height(z)).reduce(f64::min)
    }

    /// The part down to the floor, in its order, moved; and the part from the other mouth down to the floor.
    pub fn halves(&self, left: Vector, right: Vector) -> (Vec<Piece>, Vec<Piece>) {
        let on_floor = |span: &&PathSpan| {
            span.arc.is_none()
                && (span.from.radius - self.low).abs() < APART
                && (span.to.radius - self.low).abs() < APART
        };
        let down = self.spans.iter().take_while(|span| span.to.radius < span.from.radius && !on_floor(span));
        let up = self.spans.iter().rev().take_while(|span| span.to.radius > span.from.radius && !on_floor(span));
        let pieces = |piece: Piece| (!piece.is_nothing()).then_some(piece);
        (
            down.filter_map(|span| pieces(span.piece(left))).collect(),
            up.filter_map(|span| pieces(span.piece(right).reversed())).collect(),
        )
    }

    /// The whole of it, moved.
    pub fn whole(&self, by: Vector) -> Vec<Piece> {
        self.spans.iter().map(|span| span.piece(by)).filter(|piece| !piece.is_nothing()).collect()
    }
}
