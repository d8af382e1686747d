//! Metal remaining on the finished part: stock, and the roundings of noses in inner corners.

use std::collections::BTreeMap;

use crate::carry::{Carried, TOLERANCE, samples};
use crate::fault::Fault;
use crate::plane::{Convex, Region, Rule, Vector, Window};
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
        let unreached = unreached(carried, piece.window(), nose);
        let (mut corner, mut stands) = (Vec::new(), Vec::new());
        for mut left in left {
            left.thickness = unreached.as_ref().map_or(f64::INFINITY, |region| over_region(region, left.spot));
            left.thickness = left.thickness.min(left.near.distance);
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
fn unreached(carried: &Carried<'_>, window: Window, nose: f64) -> Option<Region> {
    let disc = Convex::disc(nose).filter(|_| nose > 0.0)?;
    let metal = carried.target.may_stay.within(window.grown(2.0 * nose + 1.0));
    let along =
        |edges: &Region| -> Vec<Convex> { edges.edges().filter_map(|(from, to)| disc.swept(from, to)).collect() };
    let grown = metal.made(&Region::pieces(&along(&metal)), Rule::Either);
    Some(grown.made(&Region::pieces(&along(&grown)), Rule::Without))
}

/// The distance of a point from a region, mm; 0 inside.
fn over_region(region: &Region, spot: Vector) -> f64 {
    if region.holds(spot) {
        return 0.0;
    }
    region.edges().map(|(from, to)| spot.distance(from, to)).fold(f64::INFINITY, f64::min)
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
