//! The half-plane through the axis: points, convex pieces and their sweeps, paths of chords, regions.

mod along;
mod clip;
mod convex;
mod course;
mod offset;
mod region;
mod window;

pub use along::AlongAxis;
pub use convex::Convex;
pub use course::{chords, turned};
pub use region::{Region, Rule};
pub use window::Window;

/// The largest distance of a chord from its arc, mm: a tenth of the tolerance of findings.
pub const CHORD: f64 = 0.0005;

/// A place or a displacement, mm: z away from the chuck, r from the axis.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Vector {
    pub z: f64,
    pub r: f64,
}

impl Vector {
    pub const fn new(z: f64, r: f64) -> Self {
        Self { z, r }
    }

    pub fn plus(self, other: Self) -> Self {
        Self::new(self.z + other.z, self.r + other.r)
    }

    pub fn minus(self, other: Self) -> Self {
        Self::new(self.z - other.z, self.r - other.r)
    }

    pub fn times(self, factor: f64) -> Self {
        Self::new(self.z * factor, self.r * factor)
    }

    pub fn dot(self, other: Self) -> f64 {
        self.z * other.z + self.r * other.r
    }

    pub fn cross(self, other: Self) -> f64 {
        self.z * other.r - self.r * other.z
    }

    pub fn length(self) -> f64 {
        libm::hypot(self.z, self.r)
    }

    /// The same direction, 1 mm long; none for no direction.
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > 0.0 { self.times(1.0 / length) } else { self }
    }

    /// Turned by a right angle to the right, with Z to the right and the radius up.
    pub fn right(self) -> Self {
        Self::new(self.r, -self.z)
    }

    /// The point at a distance in the direction of an angle, radians from +Z towards +r.
    pub fn towards(self, angle: f64, far: f64) -> Self {
        self.plus(Self::new(libm::cos(angle), libm::sin(angle)).times(far))
    }

    /// The point between two others that is nearest to this one.
    pub fn nearest_between(self, from: Self, to: Self) -> Self {
        let path = to.minus(from);
        let square = path.dot(path);
        let part = if square > 0.0 { (self.minus(from).dot(path) / square).clamp(0.0, 1.0) } else { 0.0 };
        from.plus(path.times(part))
    }

    /// Its distance from the line segment between two others, mm.
    pub fn distance(self, from: Self, to: Self) -> f64 {
        self.minus(self.nearest_between(from, to)).length()
    }
}
