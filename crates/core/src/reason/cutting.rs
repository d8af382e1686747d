//! Why there are no cutting conditions.

use crate::note::Note;
use crate::units::{Micrometres, NewtonMetres, RevsPerMinute, Roughness, round_to};

/// Why there are no cutting conditions for a cut.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum Uncut {
    /// A table has no figure for the material, nor for its replacement.
    NoFigure { table: String, material: String },
    /// A table ends before that depth, in diameters.
    TooDeep { table: String, ratio: f64 },
    /// No feed leaves so fine a surface.
    TooFineToBore { roughness: Roughness },
    /// A tap needs more torque than the spindle has.
    TorqueBeyondSpindle { torque: NewtonMetres, limit: NewtonMetres },
    /// The spindle has no step slow enough for a tap.
    NoStepBelow { computed: RevsPerMinute },
    /// A tap without a pitch.
    NoPitch,
    /// A mill without teeth or edges.
    NoCutterShape,
    /// The mill is as wide as the hole.
    MillDoesNotEnter { diameter: Micrometres, hole: Micrometres },
}

impl Uncut {
    /// The sentence, without a transition.
    pub fn note(&self) -> Note {
        match self {
            Self::NoFigure { table, material } => {
                Note::new("no-figure").with("table", table).with("material", material)
            }
            Self::TooDeep { table, ratio } => {
                Note::new("too-deep").with("table", table).with("ratio", round_to(*ratio, 2))
            }
            Self::TooFineToBore { roughness } => Note::new("too-fine-to-bore").with("roughness", roughness),
            Self::TorqueBeyondSpindle { torque, limit } => {
                Note::new("torque-beyond-spindle").with("torque", round_to(torque.0, 1)).with("limit", limit.0)
            }
            Self::NoStepBelow { computed } => Note::new("no-step-below").with("computed", round_to(computed.0, 1)),
            Self::NoPitch => Note::new("no-pitch"),
            Self::NoCutterShape => Note::new("no-cutter-shape"),
            Self::MillDoesNotEnter { diameter, hole } => {
                Note::new("mill-does-not-enter").with("diameter", diameter).with("hole", hole)
            }
        }
    }
}
