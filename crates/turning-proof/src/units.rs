//! Quantities and places, in the coordinates of one set-up.

use std::fmt;

use crate::plane::Vector;

/// A length, mm.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default)]
pub struct Mm(pub f64);

/// An angle, degrees.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default)]
pub struct Degrees(pub f64);

/// A volume, mm³.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default)]
pub struct CubicMm(pub f64);

/// The number of a block of the program, or of its line, for findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Block(pub usize);

/// A place of the half-plane. Z grows away from the chuck; the radius is from the axis, negative beyond it.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct At {
    /// Along the axis, mm.
    pub z: Mm,
    /// From the axis, mm.
    pub radius: Mm,
}

impl At {
    /// A place.
    pub const fn new(z: Mm, radius: Mm) -> Self {
        Self { z, radius }
    }

    pub(crate) const fn spot(self) -> Vector {
        Vector { z: self.z.0, r: self.radius.0 }
    }

    pub(crate) const fn of(spot: Vector) -> Self {
        Self { z: Mm(spot.z), radius: Mm(spot.r) }
    }
}

/// Whole micrometres: a proof has no finer resolution.
impl fmt::Display for Mm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded = (self.0 * 1000.0).round() / 1000.0;
        write!(f, "{}", if rounded == 0.0 { 0.0 } else { rounded })
    }
}

technolog_note::told_as_number!(Mm);
technolog_note::told_as_text!(Block);

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
