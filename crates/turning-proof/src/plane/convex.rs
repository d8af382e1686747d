//! Convex pieces, the elements of tools, and their sweeps.

use super::{Vector, Window};

/// A convex piece: its corners counter-clockwise, with Z to the right and the radius up.
#[derive(Clone, Debug, PartialEq)]
pub struct Convex {
    corners: Vec<Vector>,
    window: Window,
}

impl Convex {
    /// The hull of some points; `None` if they have no area.
    pub fn hull(spots: impl IntoIterator<Item = Vector>) -> Option<Self> {
        let mut spots: Vec<Vector> = spots.into_iter().collect();
        spots.sort_by(|a, b| a.z.total_cmp(&b.z).then(a.r.total_cmp(&b.r)));
        spots.dedup();
        let mut corners: Vec<Vector> = Vec::with_capacity(spots.len() + 1);
        for upper in [false, true] {
            let begun = corners.len();
            let mut take = |spot: Vector| {
                while corners.len() >= begun + 2 {
                    let (a, b) = (corners[corners.len() - 2], corners[corners.len() - 1]);
                    if b.minus(a).cross(spot.minus(b)) > 0.0 {
                        break;
                    }
                    corners.pop();
                }
                corners.push(spot);
            };
            if upper {
                spots.iter().rev().copied().for_each(&mut take)
            } else {
                spots.iter().copied().for_each(&mut take)
            }
            corners.pop();
        }
        (corners.len() > 2).then(|| Self::of(corners))
    }

    /// The corners of a rectangle.
    pub fn rectangle(a: Vector, b: Vector) -> [Vector; 4] {
        [a, Vector::new(b.z, a.r), b, Vector::new(a.z, b.r)]
    }

    pub fn corners(&self) -> &[Vector] {
        &self.corners
    }

    pub const fn window(&self) -> Window {
        self.window
    }

    /// Its sweep along a straight line: its edges that face ahead are moved to the end of the line, the others stay.
    pub fn swept(&self, from: Vector, to: Vector) -> Self {
        let path = to.minus(from);
        let ahead = |from: Vector, to: Vector| to.minus(from).right().dot(path) > 0.0;
        let mut corners = Vec::with_capacity(self.corners.len() + 2);
        let mut turns = 0;
        let before = self.corners.iter().skip(self.corners.len() - 1).chain(&self.corners);
        let after = self.corners.iter().skip(1).chain(self.corners.first());
        for ((&before, &here), &after) in before.zip(&self.corners).zip(after) {
            let (was, is) = (ahead(before, here), ahead(here, after));
            corners.push(here.plus(if was { to } else { from }));
            if was != is {
                turns += 1;
                corners.push(here.plus(if is { to } else { from }));
            }
        }
        // Edges along the line, or shorter than a rounding, may turn back and forth.
        let hull =
            || Self::hull([from, to].into_iter().flat_map(|end| self.corners.iter().map(move |one| one.plus(end))));
        if turns > 2 { hull().unwrap_or_else(|| Self::of(corners)) } else { Self::of(corners) }
    }

    /// Of corners that are those of a convex piece already.
    fn of(corners: Vec<Vector>) -> Self {
        let window = Window::around(corners.iter().copied());
        Self { corners, window }
    }

    /// The piece in the half-plane after a turn of the part: the part of it beyond the axis cuts on this side.
    pub fn folded(self) -> Vec<Self> {
        if self.window.least.r >= 0.0 {
            return vec![self];
        }
        let mirrored = Self::hull(self.corners.iter().map(|corner| Vector::new(corner.z, -corner.r)));
        [Some(self), mirrored].into_iter().flatten().filter_map(|piece| piece.above_axis()).collect()
    }

    fn above_axis(&self) -> Option<Self> {
        self.beyond(|spot| spot.r)
    }

    /// The part of it inside a window.
    pub fn within(&self, window: Window) -> Option<Self> {
        let (least, most) = (window.least, window.most);
        let across = self.beyond(|spot| spot.z - least.z)?.beyond(|spot| most.z - spot.z)?;
        across.beyond(|spot| spot.r - least.r)?.beyond(|spot| most.r - spot.r)
    }

    /// The part of it where a linear measure is not negative.
    fn beyond(&self, measure: impl Fn(Vector) -> f64) -> Option<Self> {
        let mut kept = Vec::with_capacity(self.corners.len() + 2);
        for (index, &here) in self.corners.iter().enumerate() {
            let next = self.corners[(index + 1) % self.corners.len()];
            let (is, then) = (measure(here), measure(next));
            if is >= 0.0 {
                kept.push(here);
            }
            if (is < 0.0) != (then < 0.0) {
                kept.push(here.plus(next.minus(here).times(is / (is - then))));
            }
        }
        kept.dedup();
        (kept.len() > 2).then(|| Self::of(kept))
    }

    /// The distance of a point from it, mm; 0 inside.
    pub fn distance(&self, spot: Vector) -> f64 {
        let mut inside = true;
        let mut least = f64::INFINITY;
        for (index, &here) in self.corners.iter().enumerate() {
            let next = self.corners[(index + 1) % self.corners.len()];
            inside &= next.minus(here).cross(spot.minus(here)) >= 0.0;
            least = least.min(spot.distance(here, next));
        }
        if inside { 0.0 } else { least }
    }

    /// Its width where it is narrowest, mm.
    pub fn width(&self) -> f64 {
        let edges = self.corners.iter().enumerate().map(|(index, &here)| {
            let along = self.corners[(index + 1) % self.corners.len()].minus(here).unit();
            self.corners.iter().map(|corner| along.cross(corner.minus(here))).fold(0.0, f64::max)
        });
        edges.fold(f64::INFINITY, f64::min)
    }
}
