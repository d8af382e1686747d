//! The contour that a program writes while G41 or G42 acts and the control, not this project, goes beside it: arcs that the tool does
//! not fit into, and ways on and off a closed contour that lead through what stands inside it.
//!
//! With G41 the metal is to the right of the way, with G42 to the left.

use crate::motion::{Motion, MotionStep, Plane, Position, Sense};
use crate::note::Note;
use crate::program::TextSpan;
use crate::units::round_to;

/// How near two points are one, mm.
const NEAR: f64 = 0.02;
/// How far a way must lie in the metal, mm.
const INSIDE: f64 = 0.1;
/// Two directions with this cosine between them or more go on smoothly: 20°.
const SMOOTH: f64 = 0.94;
/// The most pieces that are held against one another.
const MOST: usize = 2000;

type Point = [f64; 2];

/// A straight or round piece of the contour.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from: Point,
    to: Point,
    z: [f64; 2],
    /// Its centre and whether it goes counterclockwise.
    arc: Option<(Point, bool)>,
    span: TextSpan,
    block: Option<u32>,
}

impl Piece {
    /// The direction at its beginning or its end.
    fn direction(&self, at_end: bool) -> Point {
        let along = match self.arc {
            None => [self.to[0] - self.from[0], self.to[1] - self.from[1]],
            Some((centre, ccw)) => {
                let at = if at_end { self.to } else { self.from };
                let out = [at[0] - centre[0], at[1] - centre[1]];
                if ccw { [-out[1], out[0]] } else { [out[1], -out[0]] }
            }
        };
        let length = libm::hypot(along[0], along[1]);
        along.map(|part| part / length)
    }
}

/// A contour in progress.
#[derive(Clone, Debug)]
struct Active {
    /// Whether the tool is to the left of it.
    left: bool,
    /// The radius of the tool, mm, where it is known.
    radius: Option<f64>,
    pieces: Vec<Piece>,
    /// Whether something of it is not followed: an arc in another plane.
    unknown: bool,
}

/// What is told of a contour.
pub(super) type ToldOfContour = (&'static str, TextSpan, Option<u32>, Note);

/// The contour beside which the tool goes, if it does.
#[derive(Clone, Debug, Default)]
pub(super) struct Contour(Option<Active>);

impl Contour {
    /// Whether G41 or G42 acts.
    pub const fn is_active(&self) -> bool {
        self.0.is_some()
    }

    /// Whether nothing has moved along it yet.
    pub fn is_empty(&self) -> bool {
        self.0.as_ref().is_some_and(|active| active.pieces.is_empty())
    }

    /// G41 or G42; what is told is of a contour that ends by it.
    pub fn begins(&mut self, left: bool, radius: Option<f64>) -> Vec<ToldOfContour> {
        let told = match &self.0 {
            Some(active) if active.left == left => return Vec::new(),
            _ => self.ends(),
        };
        self.0 = Some(Active { left, radius, pieces: Vec::new(), unknown: false });
        told
    }

    /// One more motion.
    pub fn takes(&mut self, step: &MotionStep, from: Position, span: TextSpan) {
        let Some(active) = &mut self.0 else { return };
        let arc = match &step.motion {
            Motion::Arc { plane: Plane::Xy, centre, sense, .. } => {
                Some((centre.map(|along| along.to_mm()), *sense == Sense::Counterclockwise))
            }
            Motion::Arc { .. } => {
                active.unknown = true;
                None
            }
            _ => None,
        };
        let [from_xy, to] = [from, step.at].map(|at| [at.x.to_mm(), at.y.to_mm()]);
        if arc.is_none() && from_xy == to {
            return;
        }
        active.unknown |= active.pieces.len() == MOST;
        if !active.unknown {
            let z = [from.z.to_mm(), step.at.z.to_mm()];
            active.pieces.push(Piece { from: from_xy, to, z, arc, span, block: step.block.number });
        }
    }

    /// G40, or the end of all.
    pub fn ends(&mut self) -> Vec<ToldOfContour> {
        let Some(active) = self.0.take().filter(|active| !active.unknown) else { return Vec::new() };
        let mut told = Vec::new();
        let code = "arc-smaller-than-tool";
        for piece in &active.pieces {
            let (Some(tool), Some((centre, ccw))) = (active.radius, piece.arc) else { continue };
            let radius = libm::hypot(piece.to[0] - centre[0], piece.to[1] - centre[1]);
            if ccw == active.left && radius < tool - NEAR {
                let note = Note::new(code).with("radius", round_to(radius, 3)).with("tool", round_to(tool, 3));
                told.push((code, piece.span, piece.block, note));
            }
        }
        told.extend(active.leads());
        told
    }
}

impl Active {
    /// Ways on and off a closed contour that lie in the metal.
    fn leads(&self) -> Option<ToldOfContour> {
        let (at, back) = [1, 0].into_iter().find_map(|at| self.closes_behind(at).map(|back| (at, back)))?;
        let (lead, first, last) = (self.pieces.get(at)?, self.pieces.get(at + 1)?, self.pieces.get(back)?);
        let (out, inwards) = (first.direction(false), last.direction(true));
        let flat = |piece: &Piece| piece.z.iter().all(|z| (z - first.z[0]).abs() < NEAR);
        // At a corner the way may come past the metal, and what still goes down may begin above it.
        if out[0] * inwards[0] + out[1] * inwards[1] < SMOOTH || !flat(first) || !flat(last) {
            return None;
        }
        let told = |code: &'static str, piece: &Piece| Some((code, piece.span, piece.block, Note::new(code)));
        let arrives = lead.direction(true);
        let turns_back = arrives[0] * out[0] + arrives[1] * out[1] < -0.5;
        if flat(lead) && (self.in_metal(lead.from, lead.to, out) || turns_back) {
            return told("lead-in-through-part", lead);
        }
        // What goes over the beginning once more is no way off.
        let off = self.pieces.get(back + 1).filter(|_| back + 2 >= self.pieces.len())?;
        let again = match (off.arc, first.arc) {
            (Some((one, _)), Some((other, _))) => libm::hypot(one[0] - other[0], one[1] - other[1]) < NEAR,
            (None, None) => true,
            _ => false,
        };
        let in_metal = flat(off) && !again && self.in_metal(off.to, off.from, out);
        if in_metal { told("lead-out-through-part", off) } else { None }
    }

    /// The piece that comes back to the end of that one, where none comes back to its beginning first.
    fn closes_behind(&self, at: usize) -> Option<usize> {
        let lead = self.pieces.get(at)?;
        let near = |one: Point, other: Point| libm::hypot(one[0] - other[0], one[1] - other[1]) < NEAR;
        let behind = self.pieces.iter().enumerate().skip(at + 1);
        let back = behind.clone().find(|(_, piece)| near(piece.to, lead.to)).map(|(back, _)| back)?;
        let part = behind.take_while(|(index, _)| *index <= back).any(|(_, piece)| near(piece.to, lead.from));
        Some(back).filter(|_| !part)
    }

    /// Whether a point lies on the side of the metal of the way through another.
    fn in_metal(&self, point: Point, on: Point, along: Point) -> bool {
        let across = along[0] * (point[1] - on[1]) - along[1] * (point[0] - on[0]);
        if self.left { across < -INSIDE } else { across > INSIDE }
    }
}
