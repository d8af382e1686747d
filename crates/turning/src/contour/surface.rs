//! The surfaces of a part along a contour, with their data from the drawing.

use std::fmt;

use serde::{Serialize, Serializer};
use technolog_core::part::Deviations;

use crate::note::{Figure, IntoFigure, Word};
use crate::turning::length::Half;
use crate::units::{ItGrade, Roughness};

pub use crate::tables::turning::part::SurfaceKind;

use super::{Contour, Field, Piece, Side};

/// The name of a surface.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SurfaceName {
    /// The name in the file, the same in every language.
    Given(String),
    /// The position on the contour from the free end, from 1: `outer 1` or `inner 1`.
    Place(Side, usize),
}

impl fmt::Display for SurfaceName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Given(name) => name.fmt(f),
            Self::Place(side, number) => write!(f, "{} {number}", side.name()),
        }
    }
}

impl Serialize for SurfaceName {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl From<&str> for SurfaceName {
    fn from(name: &str) -> Self {
        Self::Given(name.to_owned())
    }
}

impl IntoFigure for SurfaceName {
    fn into_figure(self) -> Figure {
        match self {
            Self::Given(name) => name.into_figure(),
            Self::Place(side, number) => {
                let side = Figure::Word(Word { vocabulary: "surface", id: side.name().into() });
                Figure::List(vec![side, number.into_figure()], " ")
            }
        }
    }
}

/// A surface of the part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Surface {
    /// Its name.
    pub name: SurfaceName,
    /// Its kind.
    pub kind: SurfaceKind,
    /// Its pieces; a groove has several.
    pub pieces: Vec<Piece>,
    /// The IT grade of its size, if the drawing gives one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grade: Option<ItGrade>,
    /// The field of a fit that the drawing gives with the grade.
    #[serde(skip)]
    pub field: Option<Field>,
    /// The deviations of its size that the drawing gives.
    #[serde(skip)]
    pub limits: Option<Deviations>,
    /// Its roughness, if the drawing gives one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<Roughness>,
    /// The finishing allowance that the file states, on one side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated_allowance: Option<Half>,
}

impl Surface {
    /// A surface of which the drawing gives nothing but its shape.
    pub const fn plain(name: SurfaceName, kind: SurfaceKind, pieces: Vec<Piece>) -> Self {
        Self { name, kind, pieces, grade: None, field: None, limits: None, roughness: None, stated_allowance: None }
    }

    /// Whether it stands upright on the axis everywhere.
    pub fn is_face(&self) -> bool {
        self.pieces.iter().all(|piece| piece.is_face())
    }

    /// Whether it is cut into another surface: a groove or a relief. A thread counts as its cylinder.
    pub fn is_groove(&self) -> bool {
        self.kind.is_additional() && self.kind != SurfaceKind::Thread
    }

    /// Its piece, if it is a plain cylinder or one with a thread.
    pub fn cylinder(&self) -> Option<Piece> {
        let [piece] = self.pieces.as_slice() else { return None };
        let plain = matches!(self.kind, SurfaceKind::Cylinder | SurfaceKind::Thread);
        (plain && piece.is_cylinder()).then_some(*piece)
    }
}

/// The surfaces along one contour of the part, from the free end; each begins where the one before it ends.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Profile {
    /// The side of the metal.
    pub side: Side,
    /// The surfaces.
    pub surfaces: Vec<Surface>,
}

impl Profile {
    /// Its lines and arcs.
    pub fn contour(&self) -> Contour {
        Contour {
            side: self.side,
            pieces: self.surfaces.iter().flat_map(|surface| surface.pieces.iter().copied()).collect(),
        }
    }

    /// The same of the part turned over.
    #[must_use]
    pub fn turned_over(&self, length: Half) -> Self {
        let over = |surface: &Surface| {
            let contour = Contour { side: self.side, pieces: surface.pieces.clone() }.turned_over(length);
            Surface { pieces: contour.pieces, ..surface.clone() }
        };
        Self { side: self.side, surfaces: self.surfaces.iter().rev().map(over).collect() }
    }
}
