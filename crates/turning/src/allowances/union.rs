//! The union of closed outlines of lines and arcs. No other file uses the crate `cavalier_contours`.
//!
//! Its union (0.9.0), tried on random contours: it handles edges that coincide. Where edges meet at a very flat angle,
//! so that corners come nearer than its tolerance of 1e-5, it silently loses a part about once in 10,000 times. So each
//! union is checked for what it covers, and repeated in other units, in which the same tolerance is another length. Its
//! debug assertions panic in such cases, so Cargo.toml turns them off.

use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{
    BooleanOp, PlineCreation, PlineOrientation, PlineSource, PlineSourceMut, Polyline, seg_midpoint, seg_tangent_vector,
};

use crate::turning::point::Vector;

use super::equidistant::SAME;

/// How many units of the crate are a millimetre, in the order in which they are tried.
const UNITS: [f64; 4] = [100.0, 1000.0, 10.0, 1.0];

/// Smaller areas are rounding, mm².
const NOTHING: f64 = 1e-5;

/// Coverage is checked so far inside each edge, mm.
const INSIDE: f64 = 1e-5;

/// The finished part ends at least so far before the next outline, mm.
const CLEAR: f64 = 0.01;

/// A corner of a closed outline, and how the outline goes on from it to the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    /// Where it is, mm.
    pub at: Vector,
    /// The angle of the arc to the next corner, radians: 0 for a straight line, positive to the left, at most half a
    /// circle.
    pub sweep: f64,
}

impl Corner {
    /// A corner from which the outline goes on straight.
    pub const fn sharp(at: Vector) -> Self {
        Self { at, sweep: 0.0 }
    }
}

/// The outer boundary of a foundation and all outlines that stand on it, clockwise; none if they are not connected or
/// leave a hole. The foundation begins with its lower corner at the free end.
///
/// The outlines come in the order of the contour. What lies before all remaining outlines is finished; only the rest, a
/// few neighbours, is joined with the next outline. So the time grows with the length of the contour, not with its
/// square.
pub(super) fn union(foundation: &[Corner], outlines: &[Vec<Corner>]) -> Option<Vec<Corner>> {
    let (mut done, mut rest) = (Vec::new(), foundation.to_vec());
    for (outline, reach) in outlines.iter().zip(reaches(outlines)) {
        settle(&mut done, &mut rest, reach - CLEAR);
        let joined = UNITS.iter().find_map(|unit| together(&rest, outline, *unit))?;
        rest = from_corner(joined, rest.first()?.at)?;
    }
    Some(foundation.first().copied().into_iter().chain(done).chain(rest.into_iter().skip(1)).collect())
}

/// The least Z of each outline and all after it.
fn reaches(outlines: &[Vec<Corner>]) -> Vec<f64> {
    let mut reach = f64::INFINITY;
    let mut reaches: Vec<f64> = Vec::with_capacity(outlines.len());
    for outline in outlines.iter().rev() {
        reach = outline.iter().map(|corner| corner.at.z).fold(reach, f64::min);
        reaches.push(reach);
    }
    reaches.reverse();
    reaches
}

/// Moves the corners before a Z from the rest to the finished part. The last of them stays; below it the rest is cut
/// off vertically.
fn settle(done: &mut Vec<Corner>, rest: &mut Vec<Corner>, before: f64) {
    let upper = rest.iter().skip(1).take_while(|corner| corner.at.z < before).count();
    done.extend(rest.drain(1..upper.max(1)));
    if let [lower, first, ..] = rest.as_mut_slice() {
        lower.at.z = first.at.z;
    }
}

/// A closed outline, rotated to begin at that corner.
fn from_corner(mut outline: Vec<Corner>, at: Vector) -> Option<Vec<Corner>> {
    let start = outline.iter().position(|corner| corner.at.minus(at).length() < SAME)?;
    outline.rotate_left(start);
    Some(outline)
}

/// The union of two outlines; none if the crate fails, that is if the result does not cover some point of them.
fn together(one: &[Corner], other: &[Corner], unit: f64) -> Option<Vec<Corner>> {
    let (one, other) = (polyline(one, unit), polyline(other, unit));
    let area = |line: &Polyline<f64>| line.area().abs() / (unit * unit);
    let result = one.boolean(&other, BooleanOp::Or);
    let parts = result.pos_plines.into_iter().chain(result.neg_plines).map(|part| part.pline);
    let mut parts = parts.filter(|part| area(part) > NOTHING);
    let (mut joined, more) = (parts.next()?, parts.next());
    let covered = [&one, &other].into_iter().all(|line| covers(&joined, line, INSIDE * unit));
    if more.is_some() || !covered || area(&joined) > area(&one) + area(&other) + NOTHING {
        return None;
    }
    if joined.orientation() == PlineOrientation::CounterClockwise {
        joined.invert_direction_mut();
    }
    let back = |x: f64, y: f64| Vector::new(x / unit, y / unit);
    let corner = |at: Vector, bulge: f64| Corner { at, sweep: 4.0 * libm::atan(bulge) };
    Some(joined.iter_vertexes().map(|vertex| corner(back(vertex.x, vertex.y), vertex.bulge)).collect())
}

/// Whether the result covers a clockwise outline: the middle of each edge, moved inside by a small distance.
fn covers(whole: &Polyline<f64>, outline: &Polyline<f64>, inside: f64) -> bool {
    outline.iter_segments().all(|(from, to)| {
        let middle = seg_midpoint(from, to);
        let ahead = seg_tangent_vector(from, to, middle).normalize();
        whole.winding_number(Vector2::new(middle.x + inside * ahead.y, middle.y - inside * ahead.x)) != 0
    })
}

/// An outline as the crate has it: each vertex has a bulge, the tangent of a quarter of the angle of its arc.
fn polyline(outline: &[Corner], unit: f64) -> Polyline<f64> {
    let mut line = Polyline::with_capacity(outline.len(), true);
    for corner in outline {
        line.add(corner.at.z * unit, corner.at.radius * unit, libm::tan(corner.sweep / 4.0));
    }
    line
}
