//! The dimensions of the drawing: from which side or hole each coordinate is dimensioned, and with which tolerance.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Micrometres;

use super::{Hole, Part, Point};

/// A dimension of the drawing along X or Y.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Dimension {
    /// Where it begins: a datum side, or a group of holes with one coordinate along the axis.
    pub from: Base,
    /// Where it ends; of a group of holes every hole has the dimension.
    pub to: Base,
    /// The axis along which it is measured.
    pub axis: Along,
    /// The full width of its tolerance, mm.
    pub tolerance_mm: Micrometres,
}

/// What a dimension begins or ends at.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Base {
    /// A side of the blank.
    Side(Side),
    /// A group of holes.
    Hole(String),
}

/// A side of the blank, seen from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Of least X.
    Left,
    /// Of greatest X.
    Right,
    /// Of least Y.
    Front,
    /// Of greatest Y.
    Back,
}

/// An axis of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Along {
    /// Along the table.
    #[serde(alias = "X")]
    X,
    /// Across the table.
    #[serde(alias = "Y")]
    Y,
}

impl Side {
    /// The sides with their words.
    pub const NAMES: [(&'static str, Self); 4] =
        [("left", Self::Left), ("right", Self::Right), ("front", Self::Front), ("back", Self::Back)];

    /// Its word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Front => "front",
            Self::Back => "back",
        }
    }

    /// The axis along which dimensions from it are measured.
    pub const fn axis(self) -> Along {
        match self {
            Self::Left | Self::Right => Along::X,
            Self::Front | Self::Back => Along::Y,
        }
    }
}

impl Along {
    /// Its letter.
    pub const fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Y => 'Y',
        }
    }

    /// The coordinate of a point along it.
    pub const fn of(self, point: Point) -> Micrometres {
        match self {
            Self::X => point.x,
            Self::Y => point.y,
        }
    }
}

impl Hole {
    /// The coordinate that all its holes have along an axis; none where they differ.
    pub fn coordinate(&self, axis: Along) -> Option<Micrometres> {
        let mut all = self.at.iter().map(|at| axis.of(*at));
        let first = all.next()?;
        all.all(|other| other == first).then_some(first)
    }
}

impl Part {
    /// The dimension that ends at a group of holes along an axis.
    pub fn dimension_of(&self, hole: &str, axis: Along) -> Option<&Dimension> {
        self.dimensions.iter().find(|one| one.axis == axis && matches!(&one.to, Base::Hole(name) if name == hole))
    }

    /// The side along an axis at which the zero is found where no dimension says it: the one where the zero of the drawing lies;
    /// from the middle, the right and the back one.
    pub fn side_of_zero(&self, axis: Along) -> Side {
        match axis {
            Along::X if self.datum.left == Micrometres::ZERO => Side::Left,
            Along::X => Side::Right,
            Along::Y if self.datum.front == Micrometres::ZERO => Side::Front,
            Along::Y => Side::Back,
        }
    }

    /// The tolerance of the blank's size along an axis, where a dimension between its two sides gives it.
    pub fn size_tolerance(&self, axis: Along) -> Option<Micrometres> {
        let between = |one: &&Dimension| matches!((&one.from, &one.to), (Base::Side(_), Base::Side(_)));
        self.dimensions.iter().filter(between).find(|one| one.axis == axis).map(|one| one.tolerance_mm)
    }

    /// The side from which a group of holes is dimensioned along an axis, straight or over other holes; none where the drawing
    /// does not say.
    pub fn datum_side(&self, hole: &str, axis: Along) -> Option<Side> {
        let mut at = hole;
        // Reading refuses circles; a part made otherwise may have one.
        for _ in 0..=self.holes.len() {
            match &self.dimension_of(at, axis)?.from {
                Base::Side(side) => return Some(*side),
                Base::Hole(next) => at = next,
            }
        }
        None
    }
}
