//! Surface roughness, Ra or Rz.

use std::cmp::Ordering;
use std::fmt;

use std::str::FromStr;
use technolog_note::note;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Decimal, Microns, ParseError};

/// A roughness limit. Ordered by Ra; an Rz is placed by the preferred pairs of drawings
/// (table `ra-rz`), because the source's tables mix both parameters in one row.
#[derive(Clone, Copy, Debug)]
pub struct Roughness {
    ra_nanometres: u32,
    rz_nanometres: Option<u32>,
}

/// Rz with the equivalent Ra on drawings, nanometres (facts 5.5; a test compares this with the table `ra-rz`).
pub const PREFERRED_PAIRS: [(u32, u32); 6] =
    [(80_000, 12_500), (40_000, 6_300), (20_000, 3_200), (10_000, 2_500), (6_300, 1_250), (3_200, 630)];

impl Roughness {
    /// From Ra in nanometres.
    pub const fn from_ra_nanometres(ra_nanometres: u32) -> Self {
        Self { ra_nanometres, rz_nanometres: None }
    }

    /// From Ra as a table prints it, to the nearest nanometre.
    pub fn from_ra(ra: Microns) -> Self {
        Self::from_ra_nanometres((ra.0 * 1000.0).round() as u32)
    }

    /// Ra in nanometres: the value by which roughness is ordered.
    pub const fn ra_nanometres(self) -> u32 {
        self.ra_nanometres
    }

    /// Ra in micrometres.
    pub fn ra_um(self) -> f64 {
        f64::from(self.ra_nanometres) / 1000.0
    }

    /// The parameter, Ra or Rz, and its value in micrometres.
    fn spelled(self) -> (&'static str, Decimal) {
        let (name, nanometres) = match self.rz_nanometres {
            Some(rz) => ("Rz", rz),
            None => ("Ra", self.ra_nanometres),
        };
        (name, Decimal::from_millionths(i64::from(nanometres) * 1000))
    }

    /// The same limit spelled as Ra.
    pub const fn as_ra(self) -> Self {
        Self::from_ra_nanometres(self.ra_nanometres)
    }
}

impl PartialEq for Roughness {
    fn eq(&self, other: &Self) -> bool {
        self.ra_nanometres == other.ra_nanometres
    }
}

impl Eq for Roughness {}

impl PartialOrd for Roughness {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Roughness {
    fn cmp(&self, other: &Self) -> Ordering {
        self.ra_nanometres.cmp(&other.ra_nanometres)
    }
}

impl fmt::Display for Roughness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, value) = self.spelled();
        write!(f, "{name} {value}")
    }
}

impl technolog_note::IntoFigure for Roughness {
    /// `Ra 2.5`, its number with the separator of the language.
    fn into_figure(self) -> technolog_note::Figure {
        let (name, value) = self.spelled();
        technolog_note::Figure::List(vec![name.into_figure(), value.into_figure()], " ")
    }
}

impl FromStr for Roughness {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        let bad = || ParseError(note!("unit-roughness-write-ra-rz-micrometres", text = text));
        // Users type the letters in Cyrillic as often as in Latin.
        let rest = text.trim().strip_prefix(['R', 'r']).ok_or_else(bad)?;
        let (is_rz, digits) = match rest.chars().next() {
            Some('a' | 'A' | 'а' | 'А') => (false, &rest[rest.chars().next().map_or(0, char::len_utf8)..]),
            Some('z' | 'Z') => (true, &rest[1..]),
            _ => return Err(bad()),
        };
        let digits = digits.trim_start_matches(['=', ' ']).trim();
        let value: Decimal = digits.parse().map_err(|_| {
            let meant = digits.replace(',', ".");
            match meant.parse::<Decimal>() {
                Ok(_) if meant != digits => {
                    let example = format!("{} {meant}", if is_rz { "Rz" } else { "Ra" });
                    ParseError(note!("unit-roughness-decimal-point", text = text, example = example))
                }
                _ => bad(),
            }
        })?;
        let nanometres = value.millionths() / 1000;
        if value.millionths() % 1000 != 0 || nanometres <= 0 {
            return Err(bad());
        }
        let nanometres = u32::try_from(nanometres).map_err(|_| bad())?;
        if !is_rz {
            return Ok(Self::from_ra_nanometres(nanometres));
        }
        PREFERRED_PAIRS
            .iter()
            .find(|(rz, _)| *rz == nanometres)
            .map(|&(rz, ra)| Self { ra_nanometres: ra, rz_nanometres: Some(rz) })
            .ok_or_else(|| ParseError(note!("unit-rz-known-at-only-give", text = text)))
    }
}

impl Serialize for Roughness {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Roughness {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

impl schemars::JsonSchema for Roughness {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Roughness".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "string",
            "pattern": "^R[az] ?[0-9.]+$",
            "description": "Roughness limit in micrometres, `Ra 12.5` or `Rz 80`",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rz_stands_beside_its_preferred_ra() {
        let rz20: Roughness = "Rz 20".parse().unwrap();
        assert_eq!(rz20, "Ra 3.2".parse().unwrap());
        assert!(rz20 > "Ra 2.5".parse().unwrap());
        assert_eq!(rz20.to_string(), "Rz 20");
        assert_eq!(rz20.as_ra().to_string(), "Ra 3.2");
    }

    #[test]
    fn what_is_not_a_roughness_is_refused_with_the_remedy() {
        for bad in ["2.5", "Rb 2", "Ra", "Ra -1", "Rz 33", "Ra 0"] {
            assert!(bad.parse::<Roughness>().is_err(), "{bad}");
        }
        assert!(
            technolog_words::Lang::EN
                .say(&"Rz 33".parse::<Roughness>().unwrap_err().0)
                .contains("give the limit as Ra")
        );
    }
}
