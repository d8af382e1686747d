//! Metal remaining on the finished part: stock, and the roundings of noses in inner corners.

use std::collections::BTreeMap;

use crate::carry::{Carried, TOLERANCE, samples};
use crate::fault::{Fault, What};
use crate::plane::{AlongAxis, Rule, Vector, Window};
use crate::target::Nearest;
use crate::units::{At, Mm};

/// A sample of the remaining metal.
#[derive(Clone, Copy)]
struct Left {
    spot: Vector,
    near: Nearest,
    /// Its thickness, mm: from the contour, or from the rounding that the nose leaves in a corner.
    thickness: f64,
}

impl Left {
    /// Whether it measures the thickness over a surface, and not over the rounding of an inner or outer corner.
    fn is_square(&self) -> bool {
        self.near.square && self.near.distance <= self.thickness + TOLERANCE
    }
}

/// The number of points examined on a side: enough for a shaft of half a metre.
const MOST: usize = 1000;

/// Compares the stock after the motions with the part.
pub fn hold(carried: &mut Carried<'_>) {
    let over = carried.stock.0.made(&carried.target.may_stay, Rule::Without);
    for piece in over.outer_pieces() {
        let spots = samples(&piece, MOST);
        let left = left(carried, &spots);
        if left.is_empty() {
            continue;
        }
        let nose = carried.nose_at(&spots);
        let reached = Reached::by(nose, carried, piece.window());
        let (mut corner, mut stands) = (Vec::new(), Vec::new());
        for mut left in left {
            left.thickness = reached.thickness(left.spot, left.near.distance);
            if left.thickness > TOLERANCE { stands.push(left) } else { corner.push(left) }
        }
        tell_corner(carried, &corner, nose);
        tell_stands(carried, &stands);
    }
}

/// The points that belong to this set-up and are farther from the contour than the tolerance of findings.
fn left(carried: &Carried<'_>, spots: &[Vector]) -> Vec<Left> {
    let target = &carried.target;
    let nearest = target.nearest_left(spots);
    let all = spots.iter().zip(nearest).map(|(&spot, near)| Left { spot, near, thickness: near.distance });
    all.filter(|left| left.thickness > TOLERANCE && !target.is_elsewhere(left.spot, left.near.drawn)).collect()
}

/// Where the centre of a nose may stand: outside of the part grown by the nose. Its edges are found by their places along the axis.
struct Reached {
    nose: f64,
    edges: Vec<(Vector, Vector)>,
    along: AlongAxis,
}

impl Reached {
    /// Around what lies in a window.
    fn by(nose: f64, carried: &Carried<'_>, window: Window) -> Self {
        let part = || carried.target.may_stay.within(window.grown(2.0 * nose + 1.0));
        let edges: Vec<_> = if nose > 0.0 { part().grown(nose).edges().collect() } else { Vec::new() };
        let along = AlongAxis::of(edges.iter().map(|(from, to)| [from.z.min(to.z), from.z.max(to.z)]));
        Self { nose, edges, along }
    }

    /// The thickness of metal at a point over what no nose reaches, mm: by so much the nose must come nearer to touch it, having
    /// come as near as the part lets it. At most the distance of the point from the part.
    fn thickness(&self, spot: Vector, from_part: f64) -> f64 {
        let reach = from_part.max(self.nose);
        let near = |reach: f64| self.along.between(spot.z - reach, spot.z + reach).into_iter().map(|at| self.edges[at]);
        let distance = |reach: f64| near(reach).map(|(from, to)| spot.distance(from, to)).fold(f64::INFINITY, f64::min);
        let close = [0.1, 1.0].into_iter().map(|reach| (reach, distance(reach)));
        let close = close.into_iter().find(|(reach, found)| found <= reach);
        let off = close.map_or_else(|| distance(reach), |found| found.1);
        // Seen along the radius: the region is to the left of its edges.
        let crossing = |(from, to): (Vector, Vector)| {
            let left = to.minus(from).cross(spot.minus(from));
            let (on, back) = (from.z <= spot.z && to.z > spot.z, from.z > spot.z && to.z <= spot.z);
            i32::from(on && left > 0.0) - i32::from(back && left < 0.0)
        };
        let inside = near(0.0).map(crossing).sum::<i32>() != 0;
        (if inside { self.nose - off } else { self.nose + off }).max(0.0).min(from_part)
    }
}

fn tell_corner(carried: &mut Carried<'_>, corner: &[Left], nose: f64) {
    if let Some(most) = corner.iter().max_by(|a, b| a.near.distance.total_cmp(&b.near.distance)) {
        let (surface, at) = (carried.target.surface(most.near.piece), At::of(most.spot));
        let (radius, left) = (Mm(nose), Mm(most.near.distance));
        carried.faults.add(Fault::of_surface(What::Corner { radius, left }, surface, Some(at), None));
    }
}

fn tell_stands(carried: &mut Carried<'_>, stands: &[Left]) {
    let square: Vec<Left> = stands.iter().filter(|left| left.is_square()).copied().collect();
    let mut by_piece: BTreeMap<usize, Vec<Left>> = BTreeMap::new();
    for left in if square.is_empty() { stands } else { &square } {
        by_piece.entry(left.near.piece).or_default().push(*left);
    }
    for (piece, left) in by_piece {
        let Some(most) = left.iter().max_by(|a, b| a.thickness.total_cmp(&b.thickness)) else { continue };
        let window = Window::around(left.iter().map(|left| left.spot));
        let (thickness, from_z, to_z) = (Mm(most.thickness), Mm(window.most.z), Mm(window.least.z));
        let (what, surface) = (What::Stands { thickness, from_z, to_z }, carried.target.surface(piece));
        carried.faults.add(Fault::of_surface(what, surface, Some(At::of(most.spot)), None));
    }
}
