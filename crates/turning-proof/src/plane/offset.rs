//! Regions grown and shrunk by a distance.

use super::{Convex, Region, Rule, Vector, chords};

impl Region {
    /// With all points that are no farther from it than so many mm.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        self.made(&Self::pieces(&self.seam(by, 1.0)), Rule::Either)
    }

    /// Without the points that are nearer to its edge than so many mm.
    #[must_use]
    pub fn shrunk(&self, by: f64) -> Self {
        self.made(&Self::pieces(&self.seam(by, -1.0)), Rule::Without)
    }

    /// What lies so near to its edge outside (1), or inside (−1): a strip along each edge, and a sector where two of them part.
    fn seam(&self, by: f64, outwards: f64) -> Vec<Convex> {
        let mut pieces = Vec::new();
        for chain in self.chains() {
            let next = |index: usize| chain[(index + 1) % chain.len()];
            let across = |index: usize| next(index).minus(chain[index]).unit().right().times(by * outwards);
            for (index, &from) in chain.iter().enumerate() {
                let (to, out, then) = (next(index), across(index), across((index + 1) % chain.len()));
                pieces.extend(Convex::hull([from, to, from.plus(out), to.plus(out)]));
                pieces.extend(sector(to, out, then, outwards));
            }
        }
        pieces
    }
}

/// The sector between the ends of two strips at a corner; none where they overlap.
fn sector(corner: Vector, out: Vector, then: Vector, outwards: f64) -> Option<Convex> {
    let angle = libm::atan2(out.cross(then), out.dot(then));
    // An edge that runs there and back has half a disc at its end.
    let angle =
        if out.dot(then) < 0.0 && angle.abs() > std::f64::consts::PI - 1e-9 { angle.abs() * outwards } else { angle };
    let (from, to) = (corner.plus(out), corner.plus(then));
    (angle * outwards > 0.0).then(|| Convex::hull([corner, from].into_iter().chain(chords(corner, from, to, angle))))?
}
