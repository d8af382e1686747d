//! Axis-parallel boxes.

use super::Vector;

/// A box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    pub least: Vector,
    pub most: Vector,
}

impl Window {
    /// The empty box, which every point widens.
    pub const NONE: Self = Self {
        least: Vector::new(f64::INFINITY, f64::INFINITY),
        most: Vector::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    pub fn around(spots: impl IntoIterator<Item = Vector>) -> Self {
        spots.into_iter().fold(Self::NONE, |all, spot| all.with(Self { least: spot, most: spot }))
    }

    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            least: Vector::new(self.least.z.min(other.least.z), self.least.r.min(other.least.r)),
            most: Vector::new(self.most.z.max(other.most.z), self.most.r.max(other.most.r)),
        }
    }

    #[must_use]
    pub fn grown(self, by: f64) -> Self {
        let by = Vector::new(by, by);
        Self { least: self.least.minus(by), most: self.most.plus(by) }
    }

    pub fn meets(self, other: Self) -> bool {
        self.least.z <= other.most.z
            && other.least.z <= self.most.z
            && self.least.r <= other.most.r
            && other.least.r <= self.most.r
    }
}
