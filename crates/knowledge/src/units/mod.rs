//! Quantities as types: no value with a unit is passed as a bare `f64`.
//!
//! Lengths are whole micrometres and table figures exact decimals, so that a comparison with the end of an interval
//! is exact. Results of formulas are floating-point numbers in a type that names their unit ([`quantity`]).

mod decimal;
mod grade;
mod length;
pub mod quantity;
mod roughness;
mod unit;

pub use decimal::Decimal;
pub use grade::ItGrade;
pub use length::{Deviation, Micrometres};
pub use quantity::{
    Brinell, Degrees, Kilograms, Kilowatts, Megapascals, MetresPerMinute, Microns, MillimetresPerMinute,
    MillimetresPerRev, MillimetresPerSecondSquared, MillimetresPerTooth, Minutes, NewtonMetres, Newtons, Percent,
    RevsPerMinute, Seconds, round_to,
};
pub use roughness::Roughness;
pub use unit::Unit;

use technolog_note::Note;

technolog_note::told_as_number!(Decimal, ItGrade, Micrometres);
technolog_note::told_as_text!(Unit);

/// Why a text is no valid quantity: what was read and what is expected.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ParseError(pub Note);

impl technolog_note::IntoFigure for ParseError {
    fn into_figure(self) -> technolog_note::Figure {
        self.0.into_figure()
    }
}

impl From<ParseError> for Note {
    fn from(error: ParseError) -> Self {
        error.0
    }
}
