//! The surfaces of a part along a contour: what the drawing says of each.

use serde::Serialize;

use crate::turning::length::Half;
use crate::units::{ItGrade, Roughness};

use super::{Contour, Piece, Side};

/// What a surface is, by how the drawing names it (lecture, fig. 12.1). Whether it is a main or an additional element of the
/// contour is not said here: that follows from the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SurfaceKind {
    /// Across the axis.
    Face,
    /// Along it.
    Cylinder,
    /// Aslant.
    Cone,
    /// A cone that breaks an edge.
    Chamfer,
    /// An arc that bulges from the metal: a ball, a rounded edge.
    Ball,
    /// An arc that is hollow: a fillet, a radius face.
    Fillet,
    /// A thread, which is turned as a cylinder or cone first.
    Thread,
    /// A relief for the grinding wheel.
    GrindingRelief,
    /// A relief at the end of a thread.
    ThreadRelief,
    /// A groove with upright walls.
    RectangularGroove,
    /// A groove with slanting walls.
    TrapezoidGroove,
    /// A groove in a face.
    FaceGroove,
    /// A groove for a belt.
    PulleyGroove,
}

impl SurfaceKind {
    /// Its name for programs and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Face => "face",
            Self::Cylinder => "cylinder",
            Self::Cone => "cone",
            Self::Chamfer => "chamfer",
            Self::Ball => "ball",
            Self::Fillet => "fillet",
            Self::Thread => "thread",
            Self::GrindingRelief => "grinding-relief",
            Self::ThreadRelief => "thread-relief",
            Self::RectangularGroove => "rectangular-groove",
            Self::TrapezoidGroove => "trapezoid-groove",
            Self::FaceGroove => "face-groove",
            Self::PulleyGroove => "pulley-groove",
        }
    }

    /// Additional by its kind, whatever its angles: threads and grooves have tools of their own.
    pub const fn is_additional(self) -> bool {
        matches!(
            self,
            Self::Thread
                | Self::GrindingRelief
                | Self::ThreadRelief
                | Self::RectangularGroove
                | Self::TrapezoidGroove
                | Self::FaceGroove
                | Self::PulleyGroove
        )
    }
}

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
