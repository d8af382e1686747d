//! Arcs as chords.

use std::f64::consts::TAU;

use super::{CHORD, Vector};

/// The angle from one direction to another around a centre, radians: positive to the left, a whole turn if both are
/// the same place.
pub fn turned(centre: Vector, from: Vector, to: Vector, left: bool) -> f64 {
    let (a, b) = (from.minus(centre), to.minus(centre));
    let angle = libm::atan2(a.cross(b), a.dot(b));
    let same = from.minus(to).length() < 1e-9;
    match (left, same) {
        (true, true) => TAU,
        (false, true) => -TAU,
        (true, false) if angle < 0.0 => angle + TAU,
        (false, false) if angle > 0.0 => angle - TAU,
        _ => angle,
    }
}

/// The ends of the chords of an arc after its beginning; the last is exactly its end. Chords lie inside the circle.
pub fn chords(centre: Vector, from: Vector, to: Vector, angle: f64) -> Vec<Vector> {
    let radius = from.minus(centre).length();
    let step = if radius > CHORD { 2.0 * libm::acos(1.0 - CHORD / radius) } else { TAU };
    let count = (angle.abs() / step).ceil().max(1.0);
    let begin = from.minus(centre);
    // If the radii at both ends differ within the tolerance of the control, the radius changes gradually.
    let grown = to.minus(centre).length() - radius;
    let mut ends: Vec<Vector> = (1..count as usize)
        .map(|index| {
            let part = index as f64 / count;
            let (sine, cosine) = (libm::sin(angle * part), libm::cos(angle * part));
            let turned = Vector::new(begin.z * cosine - begin.r * sine, begin.z * sine + begin.r * cosine);
            centre.plus(turned.unit().times(radius + grown * part))
        })
        .collect();
    ends.push(to);
    ends
}
