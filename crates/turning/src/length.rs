//! Lengths as whole halves of a micrometre: diameters are exact to a micrometre, so radii are exact to half of one.

use std::fmt;
use std::iter::Sum;
use std::ops::{Add, Sub};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

use crate::units::{Decimal, Micrometres};

/// A length along or across the axis, in halves of a micrometre. Shown and serialised in mm, at most four places.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Deserialize)]
#[serde(from = "f64")]
pub struct Half(i64);

impl Half {
    /// No length.
    pub const ZERO: Self = Self(0);

    /// From whole halves of a micrometre.
    pub const fn new(halves: i64) -> Self {
        Self(halves)
    }

    /// Whole halves of a micrometre.
    pub const fn halves(self) -> i64 {
        self.0
    }

    /// The same length.
    pub const fn of(length: Micrometres) -> Self {
        Self(length.micrometres().saturating_mul(2))
    }

    /// The radius of a diameter.
    pub const fn radius_of(diameter: Micrometres) -> Self {
        Self(diameter.micrometres())
    }

    /// The diameter of this radius.
    pub const fn diameter(self) -> Micrometres {
        Micrometres::new(self.0)
    }

    /// The least number of equal parts that are not above `most` (at least half a micrometre): the quotient, rounded
    /// up. 0 for a length that is not above zero.
    pub fn parts(self, most: Self) -> i64 {
        let most = most.0.max(1);
        self.0.max(0).saturating_add(most - 1) / most
    }

    /// One of so many equal parts, rounded up to half a micrometre; at least 1 part is assumed.
    pub fn part(self, parts: i64) -> Self {
        Self(self.parts(Self(parts)))
    }

    /// In whole micrometres, rounded up; for a length that is not negative.
    pub fn rounded_up(self) -> Micrometres {
        Micrometres::new(self.parts(Self(2)))
    }

    /// Millimetres, for formulas and drawings.
    pub fn to_mm(self) -> f64 {
        self.0 as f64 / 2000.0
    }
}

impl Add for Half {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Half {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Sum for Half {
    fn sum<I: Iterator<Item = Self>>(lengths: I) -> Self {
        lengths.fold(Self::ZERO, Add::add)
    }
}

impl fmt::Display for Half {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Decimal::from_millionths(self.0.saturating_mul(500)).fmt(f)
    }
}

technolog_note::told_as_number!(Half);

impl From<f64> for Half {
    fn from(millimetres: f64) -> Self {
        Self((millimetres * 2000.0).round() as i64)
    }
}

impl Serialize for Half {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0 % 2000 == 0 {
            serializer.serialize_i64(self.0 / 2000)
        } else {
            serializer.serialize_f64(self.to_mm())
        }
    }
}

/// A Z as output shows it: negative towards the chuck.
///
/// # Errors
/// Those of the serializer.
pub fn negative_z<S: Serializer>(z: &Half, serializer: S) -> Result<S::Ok, S::Error> {
    (Half::ZERO - *z).serialize(serializer)
}

/// A radius as output shows it: its diameter.
///
/// # Errors
/// Those of the serializer.
pub fn as_diameter<S: Serializer>(radius: &Half, serializer: S) -> Result<S::Ok, S::Error> {
    radius.diameter().serialize(serializer)
}

impl JsonSchema for Half {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "HalfMicrometres".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "number",
            "description": "Millimetres, at most four decimal places (whole halves of a micrometre)",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_an_odd_diameter_is_exact() {
        let radius = Half::radius_of("39.985".parse().unwrap());
        assert_eq!(radius.to_string(), "19.9925");
        assert_eq!(radius.diameter().to_string(), "39.985");
        assert_eq!(serde_json::to_string(&(radius, Half::of(Micrometres::from_mm(7)))).unwrap(), "[19.9925,7]");
        assert_eq!(serde_json::from_str::<Half>("19.9925").unwrap(), radius);
    }

    #[test]
    fn parts_are_the_fewest_and_the_smallest_that_do() {
        for size in 0..40 {
            for most in 1..12 {
                let (size, most) = (Half::new(size), Half::new(most));
                let (parts, part) = (size.parts(most), size.part(size.parts(most)));
                assert!(part <= most && part.halves() * parts >= size.halves(), "{size} in {parts} of {part}");
                assert!(
                    parts == 0 || (parts - 1) * most.halves() < size.halves(),
                    "{size} does with fewer than {parts}"
                );
                assert!(parts == 0 || (part.halves() - 1) * parts < size.halves(), "{size} does with less than {part}");
            }
        }
        assert_eq!(Half::new(-7).parts(Half::new(2)), 0);
        assert_eq!([4, 5].map(|halves| Half::new(halves).rounded_up().micrometres()), [2, 3]);
    }
}
