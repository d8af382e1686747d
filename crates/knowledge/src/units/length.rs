//! Lengths as whole micrometres.

use std::fmt;

use std::iter::Sum;
use std::ops::{Add, Neg, Sub};
use std::str::FromStr;
use technolog_note::note;

use schemars::JsonSchema;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Decimal, ParseError};

/// A length or coordinate in whole micrometres. Written and read in millimetres with a decimal
/// point and at most three places; serialises as a number of millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Micrometres(i64);

/// The largest length that is read, mm: a path over all points of a part still fits.
const MOST_MM: i64 = 1_000_000_000;

impl Micrometres {
    /// No length.
    pub const ZERO: Self = Self(0);

    /// From whole micrometres.
    pub const fn new(micrometres: i64) -> Self {
        Self(micrometres)
    }

    /// From whole millimetres.
    pub const fn from_mm(millimetres: i64) -> Self {
        Self(millimetres.saturating_mul(1000))
    }

    /// From a computed number of millimetres, rounded to the nearest micrometre.
    pub fn from_mm_rounded(millimetres: f64) -> Self {
        Self((millimetres * 1000.0).round() as i64)
    }

    /// Whole micrometres.
    pub const fn micrometres(self) -> i64 {
        self.0
    }

    /// Millimetres, for formulas.
    pub fn to_mm(self) -> f64 {
        self.0 as f64 / 1000.0
    }

    /// The absolute value.
    pub const fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// Half of the length, rounded down to a whole micrometre.
    pub const fn half(self) -> Self {
        Self(self.0.div_euclid(2))
    }

    /// The nearest multiple of a step, half away from zero.
    #[must_use]
    pub fn on_grid(self, step: Self) -> Self {
        let step = step.0.max(1);
        Self((self.0.abs() + step / 2).div_euclid(step) * step * self.0.signum())
    }

    /// `self · numerator / denominator`, rounded to the nearest micrometre; zero for a zero denominator.
    pub fn ratio(self, numerator: i64, denominator: i64) -> Self {
        if denominator == 0 {
            return Self::ZERO;
        }
        Self((self.0 as f64 * numerator as f64 / denominator as f64).round() as i64)
    }
}

impl Add for Micrometres {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Micrometres {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Neg for Micrometres {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Sum for Micrometres {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::ZERO, Add::add)
    }
}

impl fmt::Display for Micrometres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Decimal::from_millionths(self.0.saturating_mul(1000)).fmt(f)
    }
}

impl Micrometres {
    /// Appends the number of millimetres to a text, as it is shown.
    pub fn append_to(self, text: &mut String) {
        Decimal::from_millionths(self.0.saturating_mul(1000)).append_to(text);
    }
}

impl FromStr for Micrometres {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        if let Some(digits) = text.strip_suffix("mm").or_else(|| text.strip_suffix("мм")) {
            return Err(ParseError(note!("unit-write-bare-number-millimetres", text = text, number = digits.trim())));
        }
        let exact: Decimal = text.parse()?;
        if exact.millionths() % 1000 != 0 {
            return Err(ParseError(note!("unit-finer-than-micrometre-at-most", text = text)));
        }
        let length = Self(exact.millionths() / 1000);
        if length.abs() > Self::from_mm(MOST_MM) {
            return Err(ParseError(note!("unit-length-beyond", text = text, most = MOST_MM)));
        }
        Ok(length)
    }
}

impl Serialize for Micrometres {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if !serializer.is_human_readable() {
            serializer.serialize_i64(self.0)
        } else if self.0 % 1000 == 0 {
            serializer.serialize_i64(self.0 / 1000)
        } else {
            serializer.serialize_f64(self.to_mm())
        }
    }
}

impl<'de> Deserialize<'de> for Micrometres {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        if deserializer.is_human_readable() {
            let millimetres = f64::deserialize(deserializer)?;
            if millimetres.abs() > MOST_MM as f64 {
                let text = millimetres.to_string();
                return Err(D::Error::custom(ParseError(note!("unit-length-beyond", text = text, most = MOST_MM))));
            }
            Ok(Self::from_mm_rounded(millimetres))
        } else {
            i64::deserialize(deserializer).map(Self)
        }
    }
}

impl JsonSchema for Micrometres {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Millimetres".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "number",
            "description": "Millimetres, at most three decimal places (whole micrometres)",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_length_is_exact_to_the_micrometre() {
        assert_eq!("61.6".parse::<Micrometres>().unwrap(), Micrometres::new(61_600));
        assert_eq!("-0.005".parse::<Micrometres>().unwrap().to_string(), "-0.005");
        assert!("0.0001".parse::<Micrometres>().is_err());
        assert!(technolog_words::Lang::EN.say(&"10mm".parse::<Micrometres>().unwrap_err().0).contains("bare number"));
    }

    proptest! {
        #![proptest_config(technolog_laws::cases!(256))]

        #[test]
        fn every_length_survives_text(um in -10_000_000_i64..10_000_000) {
            let length = Micrometres::new(um);
            prop_assert_eq!(length.to_string().parse::<Micrometres>().unwrap(), length);
            prop_assert_eq!(Micrometres::from_mm_rounded(length.to_mm()), length);
        }
    }
}
