//! Points of the half section, which are exact, and vectors between them, which are not.

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::length::Half;

/// A point of the half section: radius from the axis, Z from the face of the free end towards the chuck. Output has
/// `diameter_mm` and `z_mm` as on drawings, with Z negative towards the chuck.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Point {
    /// Radius.
    pub radius: Half,
    /// Z.
    pub z: Half,
}

/// A point at a radius and a Z, mm.
#[cfg(test)]
pub fn at(radius: f64, z: f64) -> Point {
    Point { radius: Half::from(radius), z: Half::from(z) }
}

impl Serialize for Point {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Point", 2)?;
        fields.serialize_field("diameter_mm", &self.radius.diameter())?;
        fields.serialize_field("z_mm", &(Half::ZERO - self.z))?;
        fields.end()
    }
}

impl Point {
    /// A point.
    pub const fn new(radius: Half, z: Half) -> Self {
        Self { radius, z }
    }

    /// From here to there, mm.
    pub fn to(self, other: Self) -> Vector {
        Vector { z: (other.z - self.z).to_mm(), radius: (other.radius - self.radius).to_mm() }
    }

    /// This point moved by a vector, rounded to half a micrometre.
    #[must_use]
    pub fn moved(self, by: Vector) -> Self {
        Self { radius: self.radius + Half::from(by.radius), z: self.z + Half::from(by.z) }
    }

    /// The point at a vector from zero, rounded to half a micrometre.
    pub fn at(place: Vector) -> Self {
        Self::default().moved(place)
    }

    /// Inside out: its radius counts inwards from `top`.
    #[must_use]
    pub fn inside_out(self, top: Half) -> Self {
        Self { radius: top - self.radius, z: self.z }
    }

    /// From zero to here, mm.
    pub fn vector(self) -> Vector {
        Self::default().to(self)
    }
}

/// A displacement in the half section, mm, for formulas. Z points towards the chuck, the radius away from the axis.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Vector {
    /// Along the axis, towards the chuck, mm.
    pub z: f64,
    /// Across it, outwards, mm.
    pub radius: f64,
}

impl Vector {
    /// A displacement, mm.
    pub const fn new(z: f64, radius: f64) -> Self {
        Self { z, radius }
    }

    /// Its length, mm.
    pub fn length(self) -> f64 {
        libm::hypot(self.z, self.radius)
    }

    /// The vector multiplied by a factor.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { z: self.z * factor, radius: self.radius * factor }
    }

    /// The sum of both displacements.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { z: self.z + other.z, radius: self.radius + other.radius }
    }

    /// The difference of two vectors.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self { z: self.z - other.z, radius: self.radius - other.radius }
    }

    /// Turned by 90° to the left, which is outwards for a displacement towards the chuck.
    #[must_use]
    pub fn left(self) -> Self {
        Self { z: -self.radius, radius: self.z }
    }

    /// Turned by an angle to the left, radians.
    #[must_use]
    pub fn turned(self, angle: f64) -> Self {
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        Self { z: self.z * cosine - self.radius * sine, radius: self.z * sine + self.radius * cosine }
    }

    /// The same direction, 1 mm long; unchanged if it has no length.
    #[must_use]
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > 0.0 { self.times(1.0 / length) } else { self }
    }

    /// The dot product with another displacement.
    pub fn dot(self, other: Self) -> f64 {
        self.z * other.z + self.radius * other.radius
    }

    /// The cross product: positive if the other displacement turns to the left of this one.
    pub fn cross(self, other: Self) -> f64 {
        self.z * other.radius - self.radius * other.z
    }

    /// Its direction, degrees in (−180, 180]: 0 towards the chuck, 90 outwards, ±180 towards the free end.
    pub fn degrees(self) -> f64 {
        libm::atan2(self.radius, self.z).to_degrees()
    }
}
