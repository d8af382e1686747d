//! Lengths in micrometres, exact to the half.

use std::fmt;

use std::iter::Sum;
use std::ops::{Add, Neg, Sub};
use std::str::FromStr;
use technolog_note::note;

use schemars::JsonSchema;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Decimal, ParseError};

/// A length or coordinate in micrometres. Sizes, coordinates and table cells are whole ones, written and read in
/// millimetres with a decimal point and at most three places. A limit of a tolerance field may end at a half: IT7 of 30 is
/// 21, and 30JS7 is ±10.5 (ISO 286-1). So halves are what is kept. Serialises as a number of millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Micrometres {
    halves: i64,
}

/// The largest length that is read, mm: a path over all points of a part still fits.
const MOST_MM: i64 = 1_000_000_000;

/// Half micrometres in a millimetre.
const OF_MM: i64 = 2000;

impl Micrometres {
    /// No length.
    pub const ZERO: Self = Self { halves: 0 };

    /// From whole micrometres.
    pub const fn new(micrometres: i64) -> Self {
        Self { halves: micrometres.saturating_mul(2) }
    }

    /// From whole millimetres.
    pub const fn from_mm(millimetres: i64) -> Self {
        Self { halves: millimetres.saturating_mul(OF_MM) }
    }

    /// From a computed number of millimetres, rounded to the nearest whole micrometre.
    pub fn from_mm_rounded(millimetres: f64) -> Self {
        Self::new((millimetres * 1000.0).round() as i64)
    }

    /// Whole micrometres, a half rounded towards zero, as ISO 286-2 prints js.
    pub const fn micrometres(self) -> i64 {
        self.halves / 2
    }

    /// Millimetres, for formulas.
    pub fn to_mm(self) -> f64 {
        self.halves as f64 / OF_MM as f64
    }

    /// The absolute value.
    pub const fn abs(self) -> Self {
        Self { halves: self.halves.abs() }
    }

    /// Half of the length, rounded down to a whole micrometre.
    pub const fn half(self) -> Self {
        Self::new(self.halves.div_euclid(4))
    }

    /// Half of the length, exact where the length is in whole micrometres.
    pub const fn exact_half(self) -> Self {
        Self { halves: self.halves.div_euclid(2) }
    }

    /// The nearest multiple of a step, half away from zero.
    #[must_use]
    pub fn on_grid(self, step: Self) -> Self {
        let step = step.halves.max(2);
        Self { halves: (self.halves.abs() + step / 2).div_euclid(step) * step * self.halves.signum() }
    }

    /// `self · numerator / denominator`, rounded to the nearest micrometre; zero for a zero denominator.
    pub fn ratio(self, numerator: i64, denominator: i64) -> Self {
        if denominator == 0 {
            return Self::ZERO;
        }
        Self::new((self.halves as f64 * numerator as f64 / denominator as f64 / 2.0).round() as i64)
    }

    /// Reads millimetres that are a whole number of some half micrometres.
    fn read(text: &str, finest: i64) -> Result<Self, ParseError> {
        if let Some(digits) = text.strip_suffix("mm").or_else(|| text.strip_suffix("мм")) {
            return Err(ParseError(note!("unit-write-bare-number-millimetres", text = text, number = digits.trim())));
        }
        let exact: Decimal = text.parse()?;
        if exact.millionths() % (finest * MILLIONTHS) != 0 {
            return Err(ParseError(note!("unit-finer-than-micrometre-at-most", text = text)));
        }
        let length = Self { halves: exact.millionths() / MILLIONTHS };
        if length.abs() > Self::from_mm(MOST_MM) {
            return Err(ParseError(note!("unit-length-beyond", text = text, most = MOST_MM)));
        }
        Ok(length)
    }
}

/// Millionths of a millimetre in half a micrometre.
const MILLIONTHS: i64 = 500;

/// A deviation as a drawing states it, which may end at a half micrometre: `0.0105`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Deviation(pub Micrometres);

impl FromStr for Deviation {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        Micrometres::read(text, 1).map(Self)
    }
}

impl Add for Micrometres {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { halves: self.halves.saturating_add(other.halves) }
    }
}

impl Sub for Micrometres {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { halves: self.halves.saturating_sub(other.halves) }
    }
}

impl Neg for Micrometres {
    type Output = Self;
    fn neg(self) -> Self {
        Self { halves: -self.halves }
    }
}

impl Sum for Micrometres {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::ZERO, Add::add)
    }
}

impl fmt::Display for Micrometres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.exact().fmt(f)
    }
}

impl Micrometres {
    /// Appends the number of millimetres to a text, as it is shown.
    pub fn append_to(self, text: &mut String) {
        self.exact().append_to(text);
    }

    /// The number of millimetres.
    fn exact(self) -> Decimal {
        Decimal::from_millionths(self.halves.saturating_mul(MILLIONTHS))
    }
}

impl FromStr for Micrometres {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        Self::read(text, 2)
    }
}

impl Serialize for Micrometres {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if !serializer.is_human_readable() {
            serializer.serialize_i64(self.halves)
        } else if self.halves % OF_MM == 0 {
            serializer.serialize_i64(self.halves / OF_MM)
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
            Ok(Self { halves: (millimetres * OF_MM as f64).round() as i64 })
        } else {
            i64::deserialize(deserializer).map(|halves| Self { halves })
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

    /// IT7 of 30 is 21 micrometres: JS7 has 10.5 on either side.
    #[test]
    fn a_limit_may_end_at_half_a_micrometre() {
        let limit = Micrometres::new(21).exact_half();
        assert_eq!((limit.to_string().as_str(), (-limit).to_string().as_str()), ("0.0105", "-0.0105"));
        assert_eq!("-0.0105".parse::<Deviation>().unwrap().0, -limit);
        assert_eq!(limit + limit, Micrometres::new(21));
        assert!("0.0105".parse::<Micrometres>().is_err() && "0.0104".parse::<Deviation>().is_err());
        assert_eq!((limit.half(), limit.micrometres(), (-limit).micrometres()), (Micrometres::new(5), 10, -10));
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
