//! Why a lathe does not cut so, or why that is not known.

use serde::{Deserialize, Serialize};

use crate::note::{Figure, Note};
use crate::reason::Uncut;
use crate::units::{Decimal, Micrometres, MillimetresPerRev, Roughness};

use super::bounds::Missing;

pub use crate::tables::cutting::LatheProcess as Process;

/// Why a lathe does not cut so, or why that is not known.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum Lack {
    /// A figure is missing.
    Figure(Lacking),
    /// There is no feed at that depth and diameter.
    NoFeed { lacking: Lacking, depth: Micrometres, diameter: Micrometres },
    /// Nothing is cut.
    NothingToCut(Nothing),
    /// The tables have no feed for so fine a surface.
    TooFineToTurn { roughness: Roughness, process: Process },
    /// The lathe leaves no surface so fine.
    TooFineForLathe { lathe: String, roughness: Roughness, best: Roughness },
    /// Threads are not reckoned.
    Threads { tool: String, process: Process },
    /// A grooving or threading tool has no depth of cut to choose.
    NoDepth { tool: String },
    /// No load can be reckoned; the first bound that lacks something.
    LimitNotKnown(Option<Missing>),
    /// Nothing tells the limiting depth.
    NoLimitingDepth,
}

/// What of a cut is not above zero, or beyond reason.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // the quantities themselves
pub enum Nothing {
    Depth(Micrometres),
    Diameter(Micrometres),
    Feed(MillimetresPerRev),
}

/// A figure that is missing; in JSON it is its sentence.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "Note", try_from = "Note")]
pub struct Lacking {
    /// Which, and of what.
    pub of: Of,
    /// For what it was asked, where that matters.
    pub process: Option<Process>,
}

/// What lacks a figure.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum Of {
    /// The row of a tool.
    Tool { tool: String, quantity: String },
    /// The record of a lathe.
    Lathe { lathe: String, quantity: String },
    /// A table of cutting conditions.
    Cutting(Uncut),
    /// A table of factors by the angle of the edge.
    Angle { table: String, angle: Decimal },
}

impl From<Of> for Lacking {
    fn from(of: Of) -> Self {
        Self { of, process: None }
    }
}

impl Lacking {
    /// The same, asked for a process.
    #[must_use]
    pub fn during(self, process: Process) -> Self {
        Self { process: Some(process), ..self }
    }

    /// Who lacks it, and what it is, as sentences name them.
    pub(super) fn names(&self) -> (&str, &str) {
        match &self.of {
            Of::Tool { tool, quantity } => (tool, quantity),
            Of::Lathe { lathe, quantity } => (lathe, quantity),
            Of::Cutting(Uncut::NoFigure { table, material }) => (material, table),
            Of::Cutting(Uncut::TooDeep { table, .. }) | Of::Angle { table, .. } => ("", table),
            Of::Cutting(_) => ("", ""),
        }
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        let note = match &self.of {
            Of::Tool { tool, quantity } => {
                Note::new("turning-tool-lacks").with("tool", tool).with("quantity", quantity)
            }
            Of::Lathe { lathe, quantity } => Note::new("lathe-lacks").with("lathe", lathe).with("quantity", quantity),
            Of::Cutting(why) => why.note(),
            Of::Angle { table, angle } => Note::new("angle-beyond-table").with("table", table).with("angle", angle),
        };
        match self.process {
            Some(process) => note.with("operation", Figure::operation(process.name())),
            None => note,
        }
    }
}

impl From<Lacking> for Note {
    fn from(lacking: Lacking) -> Self {
        lacking.note()
    }
}

/// Read back from JSON.
impl TryFrom<Note> for Lacking {
    type Error = String;

    #[expect(clippy::disallowed_methods, reason = "it is read back into a type here")]
    fn try_from(note: Note) -> Result<Self, String> {
        let figure = |name: &str| note.figure(name).map(|figure| figure.text().into_owned()).unwrap_or_default();
        let of = match note.code() {
            "turning-tool-lacks" => Of::Tool { tool: figure("tool"), quantity: figure("quantity") },
            "lathe-lacks" => Of::Lathe { lathe: figure("lathe"), quantity: figure("quantity") },
            "no-figure" => Of::Cutting(Uncut::NoFigure { table: figure("table"), material: figure("material") }),
            "angle-beyond-table" => {
                let angle = figure("angle").parse().map_err(|_| "the angle is no number".to_owned())?;
                Of::Angle { table: figure("table"), angle }
            }
            other => return Err(format!("`{other}` is nothing that a bound lacks")),
        };
        let mut process = [Process::Turning, Process::Grooving].into_iter();
        let process = process.find(|one| one.name() == figure("operation"));
        Ok(Self { of, process })
    }
}

impl Lack {
    /// The sentence.
    pub fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::Figure(lacking) => lacking.note(),
            Self::NoFeed { lacking, depth, diameter } => lacking.note().with("depth", depth).with("diameter", diameter),
            Self::NothingToCut(nothing) => {
                let (quantity, is) = match nothing {
                    Nothing::Depth(depth) => ("depth", depth.to_string()),
                    Nothing::Diameter(diameter) => ("diameter", diameter.to_string()),
                    Nothing::Feed(feed) => ("feed", feed.0.to_string()),
                };
                new("nothing-to-cut").with("quantity", quantity).with("is", is)
            }
            Self::TooFineToTurn { roughness, process } => new("too-fine-to-turn")
                .with("roughness", roughness)
                .with("operation", Figure::operation(process.name())),
            Self::TooFineForLathe { lathe, roughness, best } => {
                new("too-fine-for-lathe").with("lathe", lathe).with("roughness", roughness).with("best", best)
            }
            Self::Threads { tool, process } => {
                new("threads-not-reckoned").with("tool", tool).with("operation", Figure::operation(process.name()))
            }
            Self::NoDepth { tool } => new("tool-has-no-depth").with("tool", tool),
            Self::LimitNotKnown(missing) => {
                let note = new("limit-not-known");
                missing.as_ref().map_or_else(|| note.clone(), |missing| missing.told(note.clone()))
            }
            Self::NoLimitingDepth => new("no-limiting-depth"),
        }
    }
}
