//! Metal remaining on the finished part: stock, and the roundings of noses in inner corners.

use std::collections::BTreeMap;

use crate::carry::{Carried, TOLERANCE, samples};
use crate::fault::Fault;
use crate::plane::{AlongAxis, Region, Rule, Vector, Window};
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
        let unreached = Outlined::of(unreached(carried, piece.window(), nose));
        let (mut corner, mut stands) = (Vec::new(), Vec::new());
        for mut left in left {
            left.thickness = unreached.distance(left.spot, left.near.distance);
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

/// The part and the area that no nose circle could reach beside it: grown by the nose and shrunk by it.
fn unreached(carried: &Carried<'_>, window: Window, nose: f64) -> Region {
    if nose > 0.0 {
        carried.target.may_stay.within(window.grown(2.0 * nose + 1.0)).grown(nose).shrunk(nose)
    } else {
        Region::default()
    }
}

/// The edges of a region by their places along the axis.
struct Outlined {
    edges: Vec<(Vector, Vector)>,
    along: AlongAxis,
}

impl Outlined {
    fn of(region: Region) -> Self {
        let edges: Vec<(Vector, Vector)> = region.edges().collect();
        let along = AlongAxis::of(edges.iter().map(|(from, to)| [from.z.min(to.z), from.z.max(to.z)]));
        Self { edges, along }
    }

    /// The distance of a point from it, mm, or `most` if it is farther; 0 inside.
    fn distance(&self, spot: Vector, most: f64) -> f64 {
        let near = |reach: f64| self.along.between(spot.z - reach, spot.z + reach).into_iter().map(|at| self.edges[at]);
        // Seen along the radius: the metal is to the left of an edge.
        let crossing = |(from, to): (Vector, Vector)| {
            let left = to.minus(from).cross(spot.minus(from));
            let (on, back) = (from.z <= spot.z && to.z > spot.z, from.z > spot.z && to.z <= spot.z);
            i32::from(on && left > 0.0) - i32::from(back && left < 0.0)
        };
        if near(0.0).map(crossing).sum::<i32>() != 0 {
            return 0.0;
        }
        let distance = |reach: f64| near(reach).map(|(from, to)| spot.distance(from, to)).fold(most, f64::min);
        let close = [0.1, 1.0].into_iter().filter(|reach| *reach < most);
        close
            .map(|reach| (reach, distance(reach)))
            .find(|(reach, found)| found <= reach)
            .map_or_else(|| distance(most), |found| found.1)
    }
}

fn tell_corner(carried: &mut Carried<'_>, corner: &[Left], nose: f64) {
    if let Some(most) = corner.iter().max_by(|a, b| a.near.distance.total_cmp(&b.near.distance)) {
        let (surface, at) = (carried.target.surface(most.near.piece), At::of(most.spot));
        let (radius, left) = (Mm(nose), Mm(most.near.distance));
        carried.faults.add(Fault::Corner { surface, radius, left, at, count: 1 });
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
        carried.faults.add(Fault::Stands {
            surface: carried.target.surface(piece),
            thickness: Mm(most.thickness),
            at: At::of(most.spot),
            from_z: Mm(window.most.z),
            to_z: Mm(window.least.z),
        });
    }
}
