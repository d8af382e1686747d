//! What of a surface decides its allowance: where it lies, and how large it and the part are.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::{Answer, Input, Knowledge};
use crate::turning::contour::{Profile, Side, Surface, SurfaceKind};
use crate::turning::length::Half;
use crate::units::Micrometres;

/// Where a surface lies, for the tables of allowances.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// Turned from outside.
    Outer,
    /// Bored.
    Inner,
    /// Faced.
    Face,
}

impl Place {
    /// Of a surface on that side of the part. Cones and arcs count as cylinders.
    pub fn of(surface: &Surface, side: Side) -> Self {
        let face = surface.kind == SurfaceKind::Face || surface.pieces.iter().all(|piece| piece.is_face());
        match side {
            _ if face => Self::Face,
            Side::Outer => Self::Outer,
            Side::Inner => Self::Inner,
        }
    }

    /// Its name in the tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Outer => "outer",
            Self::Inner => "inner",
            Self::Face => "face",
        }
    }

    /// An allowance of a table on one side: the tables give it on the diameter, but on faces.
    pub const fn on_side(self, allowance: Micrometres) -> Half {
        match self {
            Self::Face => Half::of(allowance),
            Self::Outer | Self::Inner => Half::radius_of(allowance),
        }
    }
}

/// The largest diameter of a surface.
pub fn diameter(surface: &Surface) -> Micrometres {
    surface.pieces.iter().map(|piece| piece.radii().1).max().unwrap_or_default().diameter()
}

/// The length of the part, from the ends of its contour, in whole micrometres.
pub fn length(profile: &Profile) -> Micrometres {
    let contour = profile.contour();
    match (contour.start(), contour.end()) {
        (Some(start), Some(end)) => Micrometres::new((end.z - start.z).halves() / 2),
        _ => Micrometres::new(0),
    }
}

/// What a table of allowances says of a place, a diameter and a length of the part; sizes of nothing ask for the least.
///
/// # Errors
/// The knowledge base lacks the table.
pub(super) fn ask<'k>(
    knowledge: &'k Knowledge,
    table: &str,
    place: Place,
    diameter: Micrometres,
    length: Micrometres,
) -> Result<Answer<'k>, KnowledgeError> {
    let least = |size: Micrometres| Input::Length(size.max(Micrometres::new(1)));
    let given = [("place_on", Input::Text(place.name())), ("diameter", least(diameter)), ("length", least(length))];
    Ok(knowledge.table(table)?.decide(&given)?)
}
