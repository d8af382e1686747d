//! The surfaces of a part along a contour: what the drawing says of each.

use serde::Serialize;

use crate::turning::length::Half;
use crate::units::{ItGrade, Roughness};

pub use crate::tables::turning::part::SurfaceKind;

use super::{Contour, Piece, Side};

/// A surface of the part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Surface {
    /// Its name: that of the file, or its place on the contour from the free end, `outer 1` or `inner 1`.
    pub name: String,
    /// What it is.
    pub kind: SurfaceKind,
    /// Its pieces; a groove has several.
    pub pieces: Vec<Piece>,
    /// The IT grade of its size, where the drawing gives one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grade: Option<ItGrade>,
    /// Its roughness, where the drawing gives one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<Roughness>,
    /// The finishing allowance that the file states, on one side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated_allowance: Option<Half>,
}

/// The surfaces along one contour of the part, from the free end; each begins where the one before it ends.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Profile {
    /// Where the metal lies.
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
}
