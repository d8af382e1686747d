//! Why there are no cutting conditions.

use serde::{Deserialize, Serialize};

use crate::note::{Figure, Note};
use crate::reason::Uncut;
use crate::units::{Decimal, Micrometres, MillimetresPerRev, Roughness};

use super::bounds::UnknownBound;

pub use crate::tables::cutting::LatheProcess as Process;

/// Why there are no cutting conditions.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum CuttingRefusal {
    /// A figure is missing.
    Figure(MissingFigure),
    /// There is no feed at that depth and diameter.
    NoFeed { lacking: MissingFigure, depth: Micrometres, diameter: Micrometres },
    /// There is no cut.
    NothingToCut(NonPositive),
    /// The tables have no feed for such a fine surface.
    TooFineToTurn { roughness: Roughness, process: Process },
    /// The lathe cannot make so fine a surface.
    TooFineForLathe { lathe: String, roughness: Roughness, best: Roughness },
    /// Threads are not computed.
    Threads { tool: String, process: Process },
    /// The depth of cut of a grooving or threading tool cannot be chosen.
    NoDepth { tool: String },
    /// No load can be calculated; the first limit with a missing figure.
    LimitNotKnown(Option<UnknownBound>),
    /// The overhang of a boring bar would be too large.
    BarTooLong(BarTooLong),
    /// No source gives the limiting depth.
    NoLimitingDepth,
}

/// A boring bar with too large an overhang: overhang > most.
#[derive(Clone, Debug, PartialEq)]
pub struct BarTooLong {
    /// Its designation.
    pub tool: String,
    /// Its overhang.
    pub overhang: Micrometres,
    /// The largest permitted overhang.
    pub most: Micrometres,
}

impl BarTooLong {
    /// The sentence.
    pub fn note(&self) -> Note {
        let Self { tool, overhang, most } = self;
        Note::new("bar-too-long").with("tool", tool).with("overhang", overhang).with("most", most)
    }
}

/// A quantity of a cut that is not above zero, or unreasonably large.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // the quantities themselves
pub enum NonPositive {
    Depth(Micrometres),
    Diameter(Micrometres),
    Feed(MillimetresPerRev),
}

/// A missing figure. In JSON it is its sentence.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "Note", try_from = "Note")]
pub struct MissingFigure {
    /// The owner of the figure.
    pub of: FigureOwner,
    /// The process that needs it, if that matters.
    pub process: Option<Process>,
}

/// The owner of a missing figure.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum FigureOwner {
    /// The row of a tool.
    Tool { tool: String, quantity: String },
    /// The record of a lathe.
    Lathe { lathe: String, quantity: String },
    /// A table of cutting conditions.
    Cutting(Uncut),
    /// A table of factors by the angle of the edge.
    Angle { table: String, angle: Decimal },
}

impl From<FigureOwner> for MissingFigure {
    fn from(of: FigureOwner) -> Self {
        Self { of, process: None }
    }
}

impl MissingFigure {
    /// The same, during a process.
    #[must_use]
    pub fn during(self, process: Process) -> Self {
        Self { process: Some(process), ..self }
    }

    /// The owner and the name of the figure, as they appear in sentences.
    pub(super) fn names(&self) -> (&str, &str) {
        match &self.of {
            FigureOwner::Tool { tool, quantity } => (tool, quantity),
            FigureOwner::Lathe { lathe, quantity } => (lathe, quantity),
            FigureOwner::Cutting(Uncut::NoFigure { table, material }) => (material, table),
            FigureOwner::Cutting(Uncut::TooDeep { table, .. }) | FigureOwner::Angle { table, .. } => ("", table),
            FigureOwner::Cutting(_) => ("", ""),
        }
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        let note = match &self.of {
            FigureOwner::Tool { tool, quantity } => {
                Note::new("turning-tool-lacks").with("tool", tool).with("quantity", quantity)
            }
            FigureOwner::Lathe { lathe, quantity } => {
                Note::new("lathe-lacks").with("lathe", lathe).with("quantity", quantity)
            }
            FigureOwner::Cutting(why) => why.note(),
            FigureOwner::Angle { table, angle } => {
                Note::new("angle-beyond-table").with("table", table).with("angle", angle)
            }
        };
        match self.process {
            Some(process) => note.with("operation", Figure::operation(process.name())),
            None => note,
        }
    }
}

impl From<MissingFigure> for Note {
    fn from(lacking: MissingFigure) -> Self {
        lacking.note()
    }
}

/// Read back from JSON.
impl TryFrom<Note> for MissingFigure {
    type Error = String;

    #[expect(clippy::disallowed_methods, reason = "it is read back into a type here")]
    fn try_from(note: Note) -> Result<Self, String> {
        let figure = |name: &str| note.figure(name).map(|figure| figure.text().into_owned()).unwrap_or_default();
        let of = match note.code() {
            "turning-tool-lacks" => FigureOwner::Tool { tool: figure("tool"), quantity: figure("quantity") },
            "lathe-lacks" => FigureOwner::Lathe { lathe: figure("lathe"), quantity: figure("quantity") },
            "no-figure" => {
                FigureOwner::Cutting(Uncut::NoFigure { table: figure("table"), material: figure("material") })
            }
            "angle-beyond-table" => {
                let angle = figure("angle").parse().map_err(|_| "the angle is no number".to_owned())?;
                FigureOwner::Angle { table: figure("table"), angle }
            }
            other => return Err(format!("`{other}` is nothing that a bound lacks")),
        };
        let mut process = [Process::Turning, Process::Grooving].into_iter();
        let process = process.find(|one| one.name() == figure("operation"));
        Ok(Self { of, process })
    }
}

impl CuttingRefusal {
    /// The sentence.
    pub fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::Figure(lacking) => lacking.note(),
            Self::NoFeed { lacking, depth, diameter } => lacking.note().with("depth", depth).with("diameter", diameter),
            Self::NothingToCut(nothing) => {
                let (quantity, is) = match nothing {
                    NonPositive::Depth(depth) => ("depth", depth.to_string()),
                    NonPositive::Diameter(diameter) => ("diameter", diameter.to_string()),
                    NonPositive::Feed(feed) => ("feed", feed.0.to_string()),
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
                missing.as_ref().map_or_else(|| note.clone(), |missing| missing.noted(note.clone()))
            }
            Self::BarTooLong(bar) => bar.note(),
            Self::NoLimitingDepth => new("no-limiting-depth"),
        }
    }
}
