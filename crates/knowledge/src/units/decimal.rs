//! Exact decimal numbers of up to six places, for table figures.

use std::fmt;
use std::str::FromStr;
use technolog_note::{Note, note};

use serde::{Deserialize, Serialize};

use super::ParseError;

/// An exact decimal in millionths of its unit; range about ±9.2 · 10¹².
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
pub struct Decimal(i64);

/// Millionths in one.
const SCALE: i64 = 1_000_000;

impl Decimal {
    /// From a number of millionths.
    pub const fn from_millionths(millionths: i64) -> Self {
        Self(millionths)
    }

    /// From a whole number; saturates far outside any figure of a table.
    pub const fn from_int(value: i64) -> Self {
        Self(value.saturating_mul(SCALE))
    }

    /// The number of millionths.
    pub const fn millionths(self) -> i64 {
        self.0
    }

    /// The nearest floating-point number, for formulas.
    pub fn to_f64(self) -> f64 {
        self.0 as f64 / SCALE as f64
    }

    /// The nearest decimal to a computed number; saturates far outside any figure of a table.
    pub fn from_f64_rounded(value: f64) -> Self {
        Self((value * SCALE as f64).round() as i64)
    }

    /// The whole number this is, if it is one.
    pub fn to_int(self) -> Option<i64> {
        (self.0 % SCALE == 0).then_some(self.0 / SCALE)
    }
}

/// Room for the longest of them: sign, 13 digits, point, 6 digits.
const ROOM: usize = 24;

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.written(&mut [0; ROOM]))
    }
}

impl Decimal {
    /// Appends the number to a text, as it is shown. Traces write thousands of positions with it.
    pub fn append_to(self, text: &mut String) {
        text.push_str(self.written(&mut [0; ROOM]));
    }

    /// Its digits, written backwards into a buffer.
    fn written(self, text: &mut [u8; ROOM]) -> &str {
        let mut at = text.len();
        let mut put = |digit: u8| {
            at -= 1;
            text[at] = digit;
        };
        let mut whole = self.0.unsigned_abs() / SCALE as u64;
        let mut part = (self.0.unsigned_abs() % SCALE as u64) as u32;
        if part > 0 {
            let mut places = 6;
            while part.is_multiple_of(10) {
                part /= 10;
                places -= 1;
            }
            for _ in 0..places {
                put(b'0' + (part % 10) as u8);
                part /= 10;
            }
            put(b'.');
        }
        loop {
            put(b'0' + (whole % 10) as u8);
            whole /= 10;
            if whole == 0 {
                break;
            }
        }
        if self.0 < 0 {
            put(b'-');
        }
        std::str::from_utf8(&text[at..]).unwrap_or_default()
    }
}

/// What stands behind the digits at the beginning of a text.
fn letters_of(text: &str) -> &str {
    text.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').trim()
}

/// Whether a number is followed by nothing but a word, such as a unit.
fn is_unit_behind(text: &str) -> bool {
    let unit = letters_of(text);
    text.starts_with(|c: char| c.is_ascii_digit())
        && unit.starts_with(char::is_alphabetic)
        && unit.chars().all(|c| c.is_alphanumeric() || "/²³°".contains(c))
}

impl FromStr for Decimal {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        let bad = |why: Note| ParseError(note!("unit-number", text = text, why = why));
        let (negative, digits) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        if whole.is_empty() || digits.ends_with('.') {
            return Err(bad(note!("unit-digits-expected-on-both-sides")));
        }
        if let Some(wrong) = whole.chars().chain(part.chars()).find(|c| !c.is_ascii_digit()) {
            return Err(bad(match wrong {
                ',' => note!("unit-write-decimal-point-comma"),
                '±' => note!("unit-one-number-without-plus-minus"),
                'o' | 'O' | 'О' | 'о' => note!("unit-letter-stands-where-zero-may", wrong = wrong),
                _ if is_unit_behind(digits) => note!("unit-behind-number", unit = letters_of(digits)),
                other => note!("unit-no-digit", other = other),
            }));
        }
        if part.len() > 6 {
            return Err(bad(note!("unit-more-than-six-decimal-places")));
        }
        let scaled = format!("{whole}{part:0<6}")
            .parse::<i64>()
            .map_err(|_| bad(note!("unit-too-large", most = i64::MAX / SCALE)))?;
        Ok(Self(if negative { -scaled } else { scaled }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_reads_back_as_it_was_written() {
        for text in ["0", "7", "-3", "0.0345", "26.5", "-0.9", "1000000.000001"] {
            assert_eq!(text.parse::<Decimal>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn a_misread_digit_is_named() {
        assert!(technolog_words::Lang::EN.say(&"1O".parse::<Decimal>().unwrap_err().0).contains("zero may be meant"));
        assert!(technolog_words::Lang::EN.say(&"1,5".parse::<Decimal>().unwrap_err().0).contains("comma"));
        for bad in ["", ".", "5.", ".5", "1.2.3", "1e3", "1.0000001", "99999999999999999999"] {
            assert!(bad.parse::<Decimal>().is_err(), "{bad}");
        }
    }
}
