//! The units a table column may be written in.

use std::fmt;
use std::str::FromStr;
use technolog_note::note;

use serde::{Deserialize, Serialize};

use super::ParseError;

macro_rules! units {
    ($($(#[$doc:meta])* $name:ident = $text:literal),* $(,)?) => {
        /// A unit of a table column.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum Unit { $($(#[$doc])* $name),* }

        impl Unit {
            /// Every unit, in the order of the documentation.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// How it is written in a table.
            pub const fn text(self) -> &'static str {
                match self { $(Self::$name => $text),* }
            }
        }
    };
}

units! {
    /// A pure number.
    None = "1",
    /// Millimetres.
    Millimetre = "mm",
    /// Micrometres.
    Micrometre = "um",
    /// Degrees of angle.
    Degree = "deg",
    /// Newtons.
    Newton = "N",
    /// Newton metres.
    NewtonMetre = "N*m",
    /// Kilowatts.
    Kilowatt = "kW",
    /// Metres per minute.
    MetrePerMinute = "m/min",
    /// Millimetres per revolution.
    MillimetrePerRev = "mm/rev",
    /// Millimetres per tooth.
    MillimetrePerTooth = "mm/tooth",
    /// Millimetres per minute.
    MillimetrePerMinute = "mm/min",
    /// Millimetres per second, per second.
    MillimetrePerSecondSquared = "mm/s2",
    /// Revolutions per minute.
    RevPerMinute = "1/min",
    /// Minutes.
    Minute = "min",
    /// Seconds.
    Second = "s",
    /// Milliseconds.
    Millisecond = "ms",
    /// Kilograms.
    Kilogram = "kg",
    /// Megapascals.
    Megapascal = "MPa",
    /// Brinell hardness.
    Brinell = "HB",
    /// Percent.
    Percent = "%",
    /// Kilobytes.
    Kilobyte = "kB",
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

impl FromStr for Unit {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        Self::ALL.iter().copied().find(|unit| unit.text() == text).ok_or_else(|| {
            let known: Vec<_> = Self::ALL.iter().map(|unit| unit.text()).collect();
            ParseError(note!("unit-unit-known", text = text, known = known.join(", ")))
        })
    }
}
