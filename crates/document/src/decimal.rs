//! Figures that are typed: a spreadsheet calculates with them.

use std::str::FromStr;

/// A decimal figure as it is printed, with its number of places: `0.250` is not `0.25`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decimal {
    /// The figure without its point.
    digits: i64,
    /// How many of its digits stand behind the point.
    places: u8,
}

/// The most digits that a spreadsheet keeps of a figure.
const DIGITS: usize = 15;

impl Decimal {
    /// How many digits stand behind the point.
    pub const fn places(self) -> u8 {
        self.places
    }

    /// The figure as spreadsheets hold it.
    #[expect(clippy::cast_precision_loss, reason = "at most 15 digits, which are exact")]
    pub fn value(self) -> f64 {
        // Division of two exact figures: the nearest one to the decimal, as if it were read.
        self.digits as f64 / (0..self.places).fold(1.0, |power, _| power * 10.0)
    }
}

/// Read from digits with a point, `-0.25`; the sign may be a minus, `−`, the point a comma.
///
/// # Errors
/// It is no decimal figure, or has more than 15 digits.
impl FromStr for Decimal {
    type Err = NotDecimal;

    fn from_str(written: &str) -> Result<Self, NotDecimal> {
        let unsigned = written.strip_prefix(['-', '−']);
        let sign = if unsigned.is_some() { -1 } else { 1 };
        let unsigned = unsigned.unwrap_or(written);
        let (whole, places) = unsigned.split_once(['.', ',']).unwrap_or((unsigned, ""));
        let digits = format!("{whole}{places}");
        let plain = digits.bytes().all(|byte| byte.is_ascii_digit()) && !whole.is_empty();
        if !plain || digits.len() > DIGITS || (places.is_empty() && unsigned != whole) {
            return Err(NotDecimal);
        }
        let figure: i64 = digits.parse().map_err(|_| NotDecimal)?;
        Ok(Self { digits: sign * figure, places: u8::try_from(places.len()).map_err(|_| NotDecimal)? })
    }
}

/// A text is no decimal figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotDecimal;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_keeps_its_places() {
        for (written, value, places) in
            [("0.25", 0.25, 2), ("0,250", 0.25, 3), ("−102,4", -102.4, 1), ("-0.1", -0.1, 1), ("1600", 1600.0, 0)]
        {
            let figure: Decimal = written.parse().unwrap();
            assert_eq!((figure.value(), figure.places()), (value, places), "{written}");
        }
    }

    #[test]
    fn what_is_no_figure_is_none() {
        for text in ["", "-", ".5", "5.", "1 000", "1.2.3", "1/2", "2…3", "5*", "Ø5", "1e3", "1234567890123456"] {
            assert_eq!(text.parse::<Decimal>(), Err(NotDecimal), "{text}");
        }
    }
}
