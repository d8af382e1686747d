//! The parts of a contour that the edges of a tool cannot reach.
//!
//! The tip of the tool is above a point of the contour. From there its main edge goes up at φ to the feed, its
//! auxiliary edge at φ1 to the return direction. Metal above an edge keeps the tip away:
//!
//! - metal behind and above the line back and up at φ1: the point is in the shadow of what fell before it;
//! - metal ahead and above the line up at φ: the point is in the corner before what rises too steeply.
//!
//! Both lines are straight, so only the points of each piece that are farthest across them are compared: its ends, and
//! the point of an arc where it is parallel to the edge. Edges count as infinitely long.

use crate::turning::contour::{Curve, Piece};
use crate::turning::point::{Point, Vector};

use super::Angles;
use super::metal::{Bound, Metal};
use super::view::Bit;

/// A smaller overlap is rounding of points to half a micrometre, mm.
const TRIFLE: f64 = 0.001;

/// Why the tip does not reach a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Shade {
    /// Metal behind is above the auxiliary edge.
    Behind,
    /// Metal ahead rises above the main edge.
    Ahead,
    /// Metal overhangs: the contour runs back above.
    Over,
}

/// The edges of a tool, each as the direction across it.
pub(super) struct Edges {
    behind: Vector,
    ahead: Vector,
}

impl Edges {
    pub fn of(tool: Angles) -> Self {
        let (main, secondary) = (tool.main.0.to_radians(), tool.secondary.0.to_radians());
        Self {
            behind: Vector::new(libm::sin(secondary), libm::cos(secondary)),
            ahead: Vector::new(libm::sin(main), -libm::cos(main)),
        }
    }

    /// For each bit, what keeps the tip from one of its points, and whether the tip reaches another of its points.
    pub fn shades(&self, bits: &[Bit], solid: impl Fn(&Bit) -> bool) -> Vec<(Option<Shade>, bool)> {
        let keys: Vec<Vec<Point>> =
            bits.iter().map(|bit| if solid(bit) { self.keys(bit.piece) } else { Vec::new() }).collect();
        let metal = Metal::new(keys, |at| Bound {
            behind: self.behind.dot(at.vector()),
            ahead: -self.ahead.dot(at.vector()),
            least_z: at.z,
        });
        let judge = |(index, bit): (usize, &Bit)| {
            let own = self.keys(bit.piece);
            let shade = own.iter().filter_map(|at| self.over(*at, index, bit.piece, &metal)).min();
            let reached =
                shade.is_none() || inside(bit.piece).any(|at| self.over(at, index, bit.piece, &metal).is_none());
            (shade, reached)
        };
        bits.iter().enumerate().map(judge).collect()
    }

    /// The metal that keeps the tip from a point of a bit.
    fn over(&self, tip: Point, index: usize, piece: Piece, metal: &Metal) -> Option<Shade> {
        let along = |at: Point| piece.from.to(at).length();
        let behind = |at: Point| at.z <= tip.z && self.behind.dot(tip.to(at)) > TRIFLE;
        let ahead = |at: Point| at.radius >= tip.radius && self.ahead.dot(at.to(tip)) > TRIFLE;
        // Limits are rounded differently from the exact comparison; half the tolerance is far more than
        // that.
        let far_behind = self.behind.dot(tip.vector()) + TRIFLE / 2.0;
        let far_ahead = -self.ahead.dot(tip.vector()) + TRIFLE / 2.0;
        let own = || metal.of(index).iter().copied();
        if own().any(|at| along(at) < along(tip) && behind(at))
            || metal.before(index, |bound| bound.behind > far_behind, behind)
        {
            return Some(Shade::Behind);
        }
        let rises = |over: bool| {
            let counts = |at: Point| ahead(at) && (!over || at.z < tip.z);
            own().any(|at| along(at) > along(tip) && counts(at))
                || metal.after(index, |bound| bound.ahead > far_ahead && (!over || bound.least_z < tip.z), counts)
        };
        rises(false).then(|| if rises(true) { Shade::Over } else { Shade::Ahead })
    }

    /// The points of a piece that are farthest across either edge.
    fn keys(&self, piece: Piece) -> Vec<Point> {
        let mut points = vec![piece.from, piece.to];
        if let (Curve::Arc { radius, .. }, Some(centre)) = (piece.curve, piece.centre()) {
            let radius = radius.to_mm();
            for across in [self.behind, self.ahead] {
                for spoke in [radius, -radius] {
                    let at = Point::at(centre.plus(across.times(spoke)));
                    if piece.holds(at) {
                        points.push(at);
                    }
                }
            }
        }
        points
    }
}

/// Fifteen points inside a piece, evenly spaced along the chord.
fn inside(piece: Piece) -> impl Iterator<Item = Point> {
    let chord = piece.chord();
    (1..16).filter_map(move |part| {
        let on_chord = piece.from.vector().plus(chord.times(f64::from(part) / 16.0));
        let Some(centre) = piece.centre() else { return Some(Point::at(on_chord)) };
        let Curve::Arc { radius, .. } = piece.curve else { return None };
        let spoke = on_chord.minus(centre);
        // The centre of half a circle is on the chord, where it gives no direction.
        (spoke.length() > 1e-6).then(|| Point::at(centre.plus(spoke.unit().times(radius.to_mm()))))
    })
}
