//! Chains of dimensions: what errs between a base of the drawing and a hole, against the tolerance of the dimension.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::note::Because;
use crate::part::{Along, Base, Side};
use crate::tables::rules::ChainClosing;
use crate::units::Micrometres;

/// The chain of a dimension that this plan makes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Chain {
    /// The group of holes it ends at.
    pub hole: String,
    /// Where it begins.
    pub from: Base,
    /// The axis along which it is measured.
    pub axis: Along,
    /// The full width of the tolerance of the drawing, mm.
    pub tolerance_mm: Micrometres,
    /// What errs, the largest first.
    pub terms: Vec<ChainTerm>,
    /// The sum of all terms, mm; absent where the size of the blank between two sides belongs to the chain, and the file does not
    /// say its tolerance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worst_mm: Option<Micrometres>,
    /// The root of the sum of their squares, mm: the field of 99.7 % of parts where the errors are normal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub likely_mm: Option<Micrometres>,
    /// Whether it closes; absent as `worst_mm` is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub closing: Option<ChainClosing>,
    /// Why.
    pub because: Vec<Because>,
}

/// A field of error in a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ChainTerm {
    /// What errs.
    pub what: ChainError,
    /// The width of its field, mm.
    pub field_mm: Micrometres,
    /// Whether the figure rests on a row that nothing confirms.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unconfirmed: bool,
}

/// What errs in a chain of dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ChainError {
    /// The tool, at the axis of the hole: with the machine, where it makes its own axis.
    Axis,
    /// The tool at the axis of the other hole; with one zero for both a reading of section 1.2.1 that nothing confirms.
    OtherAxis,
    /// The part in its fixture.
    Locating,
    /// The zero, found at a side.
    Touch,
    /// The side that is not along the axis.
    Truing,
    /// The size of the blank between the side of the dimension and that of the zero.
    Size,
}

impl ChainError {
    /// Its name in plans and sentences.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Axis => "axis",
            Self::OtherAxis => "other-axis",
            Self::Locating => "locating",
            Self::Touch => "touch",
            Self::Truing => "truing",
            Self::Size => "size",
        }
    }
}

/// A zero of the part in its first set-up: the sides where it is found, and the holes that are counted from it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct PartZero {
    /// The side along X.
    pub x: Side,
    /// The side along Y.
    pub y: Side,
    /// The groups of holes.
    pub holes: Vec<String>,
}

impl PartZero {
    /// Its side along an axis.
    pub const fn side(&self, axis: Along) -> Side {
        match axis {
            Along::X => self.x,
            Along::Y => self.y,
        }
    }
}
