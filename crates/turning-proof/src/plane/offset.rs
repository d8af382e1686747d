//! Regions grown by a distance.

use std::f64::consts::PI;

use super::{Convex, Region, Rule, Vector, chords};

impl Region {
    /// With all points that are no farther from it than so many mm: a strip along each edge, and a sector where two of them part.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        let mut pieces = Vec::new();
        for chain in self.chains() {
            let next = |index: usize| chain[(index + 1) % chain.len()];
            // The metal is to the left.
            let out = |index: usize| next(index).minus(chain[index]).unit().right().times(by);
            for (index, &from) in chain.iter().enumerate() {
                let (to, across, then) = (next(index), out(index), out((index + 1) % chain.len()));
                pieces.extend(Convex::hull([from, to, from.plus(across), to.plus(across)]));
                pieces.extend(sector(to, across, then));
            }
        }
        self.made(&Self::pieces(&pieces), Rule::Either)
    }
}

/// The sector between the ends of two strips at a corner; none where they overlap.
fn sector(corner: Vector, across: Vector, then: Vector) -> Option<Convex> {
    let angle = libm::atan2(across.cross(then), across.dot(then));
    // An edge that runs there and back has half a disc at its end.
    let angle = if angle.abs() > PI - 1e-9 { PI } else { angle };
    let (from, to) = (corner.plus(across), corner.plus(then));
    (angle > 0.0).then(|| Convex::hull([corner, from].into_iter().chain(chords(corner, from, to, angle)))).flatten()
}
