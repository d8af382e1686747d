//! ISO 286 tolerance grades.

use std::fmt;
use std::str::FromStr;
use technolog_note::note;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ParseError;

/// A standard tolerance grade, IT 1 to IT 18 (ISO 286-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct ItGrade(u8);

impl ItGrade {
    /// The grade of that number, if there is one (1 to 18).
    pub const fn new(grade: u8) -> Option<Self> {
        if grade >= 1 && grade <= 18 { Some(Self(grade)) } else { None }
    }

    /// Its number.
    pub const fn number(self) -> u8 {
        self.0
    }
}

impl fmt::Display for ItGrade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl FromStr for ItGrade {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        let digits = text.strip_prefix("IT").unwrap_or(text).trim();
        digits
            .parse::<u8>()
            .ok()
            .and_then(Self::new)
            .ok_or_else(|| ParseError(note!("unit-tolerance-grade-whole-number-from", text = text)))
    }
}
