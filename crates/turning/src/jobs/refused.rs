//! Why a job cannot be made: the failed inequality.

use crate::error::Refusal;
use crate::note::{Figure, Note};
use crate::reason::Uncut;
use crate::turning::contour::SurfaceName;
use crate::turning::cutting::{Bound, CuttingRefusal};
use crate::turning::length::Half;
use crate::units::{ItGrade, Micrometres, MillimetresPerMinute, NewtonMetres, Newtons, RevsPerMinute, round_to};
use technolog_cutting::figures::{self, Asking};

/// What the tables of cutting conditions are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Operation {
    Drilling,
    Grooving,
    Threading,
    Tapping,
}

impl Operation {
    /// Its name among the operations.
    const fn name(self) -> &'static str {
        match self {
            Self::Drilling => "drill",
            Self::Grooving => "grooving",
            Self::Threading => "threading",
            Self::Tapping => "tap",
        }
    }
}

/// Why a job cannot be made.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum NoJob {
    /// Speed and feed need a lathe.
    NoLathe,
    /// No tool of that kind works there.
    NoTool { surface: SurfaceName },
    /// Speed or feed is not known.
    Cutting(CuttingRefusal),
    /// The tables of cutting conditions have no figures for it.
    NoFigures { operation: Operation, why: Uncut },
    /// It is not a groove with walls and a floor.
    NotAValley { surface: SurfaceName },
    /// Even the narrowest blade is wider than the floor permits.
    TooNarrow { surface: SurfaceName, room: Half, width: Micrometres },
    /// The corners of the edge are so round that it makes no wall of so shallow a groove.
    TooRound { surface: SurfaceName, corner: Half, depth: Half },
    /// The blade is too short.
    TooDeep { surface: SurfaceName, depth: Half, reach: Micrometres },
    /// The tool is too thick for the bore.
    BoreTooSmall { surface: SurfaceName, bore: Micrometres, least: Micrometres },
    /// The bar is too short.
    BarTooShort { surface: SurfaceName, depth: Half, reach: Half },
    /// The blade of a face groove is curved for larger diameters.
    FaceTooSmall { surface: SurfaceName, diameter: Micrometres, least: Micrometres },
    /// Its mouth does not face the free end.
    FacesChuck { surface: SurfaceName },
    /// Both sides of its mouth are undercut: no insert has both angles.
    Undercut { surface: SurfaceName, main: f64, secondary: f64 },
    /// It exceeds a limit of tool or lathe.
    Overloaded { tool: String, bound: Bound },
    /// No insert cuts that pitch.
    NoPitch { pitch: Micrometres, least: Micrometres, most: Micrometres },
    /// The table of passes has no such pitch.
    NoPasses { pitch: Micrometres },
    /// The feed of the lathe is too slow for the pitch even at its slowest spindle.
    PitchTooQuick { pitch: Micrometres, spindle: RevsPerMinute, rate: MillimetresPerMinute, most: MillimetresPerMinute },
    /// There is no room before the thread.
    NoEntry { surface: SurfaceName, needs: Half, room: Half },
    /// There is no room behind the thread.
    NoRunOut { surface: SurfaceName, needs: Half, room: Half },
    /// Without a relief the thread would run out over a greater length than the standard allows.
    RunOutTooLong { surface: SurfaceName, needs: Half, most: Micrometres },
    /// Without a relief the thread would run out on a surface with a fine tolerance.
    RunOutOnSeat { surface: SurfaceName, seat: SurfaceName, grade: ItGrade },
    /// The relief is not as deep as the thread.
    ReliefTooShallow { surface: SurfaceName, relief: Micrometres, root: Micrometres },
    /// The thread is not on a cylinder.
    ThreadOnNoCylinder { surface: SurfaceName },
    /// No drill of the catalogs is so small, or reaches so deep.
    NoDrill { diameter: Micrometres, depth: Half },
    /// No other cutter for the axis is of that size and reaches so deep.
    NoCutter { operation: crate::knowledge::vocabulary::Operation, diameter: Micrometres, depth: Half },
    /// The hole that is there is as wide as the cutter, or wider.
    NoStock { operation: crate::knowledge::vocabulary::Operation, diameter: Micrometres, from: Micrometres },
    /// No catalog has a tap of the thread.
    NoTap { thread: String },
    /// No tap of the thread goes so deep.
    TapTooShort { thread: String, depth: Half, reach: Half },
    /// There is no room behind the thread for the lead of its tap.
    NoTapRunOut { surface: SurfaceName, needs: Half, room: Half, thread: String },
    /// The hole begins with a plain cylinder of the same diameter, which the tap would cut too.
    PlainBeforeTap { surface: SurfaceName, plain: SurfaceName },
    /// The torque of the tap is more than that of the spindle.
    TapTooStrong { diameter: Micrometres, torque: NewtonMetres, most: NewtonMetres },
    /// The drill exceeds the spindle or the drive of Z even at the least feed.
    DrillTooStrong { diameter: Micrometres, force: Newtons, most: Newtons },
    /// No centre hole is so small.
    NoCentreHole { diameter: Micrometres, least: Micrometres },
    /// The blade is too near to the jaws.
    JawsTooNear { gap: Half, least: Micrometres },
    /// The blade is not long enough for the bar.
    PartingTooDeep { depth: Half, reach: Micrometres },
}

impl NoJob {
    /// The sentence.
    pub fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::NoLathe => new("job-needs-lathe"),
            Self::NoTool { surface } => new("job-no-tool").with("surface", surface),
            Self::Cutting(why) => why.note(),
            Self::NoFigures { operation, why } => why.note().with("operation", Figure::operation(operation.name())),
            Self::NotAValley { surface } => new("groove-no-valley").with("surface", surface),
            Self::TooNarrow { surface, room, width } => {
                new("groove-too-narrow").with("surface", surface).with("room", room).with("width", width)
            }
            Self::TooRound { surface, corner, depth } => {
                new("groove-shallower-than-corner").with("surface", surface).with("corner", corner).with("depth", depth)
            }
            Self::TooDeep { surface, depth, reach } => {
                new("groove-beyond-blade").with("surface", surface).with("depth", depth).with("reach", reach)
            }
            Self::BoreTooSmall { surface, bore, least } => {
                new("job-bore-too-small").with("surface", surface).with("bore", bore).with("least", least)
            }
            Self::BarTooShort { surface, depth, reach } => {
                new("job-bar-too-short").with("surface", surface).with("depth", depth).with("reach", reach)
            }
            Self::FaceTooSmall { surface, diameter, least } => {
                new("groove-face-too-small").with("surface", surface).with("diameter", diameter).with("least", least)
            }
            Self::FacesChuck { surface } => new("groove-faces-chuck").with("surface", surface),
            Self::Undercut { surface, main, secondary } => new("groove-undercut")
                .with("surface", surface)
                .with("main", round_to(*main, 2))
                .with("secondary", round_to(*secondary, 2)),
            Self::Overloaded { tool, bound } => {
                new("job-overloaded").with("tool", tool).with("bound", Figure::word(bound.name()))
            }
            Self::NoPitch { pitch, least, most } => {
                new("thread-no-insert").with("pitch", pitch).with("least", least).with("most", most)
            }
            Self::NoPasses { pitch } => new("thread-no-passes").with("pitch", pitch),
            Self::PitchTooQuick { pitch, spindle, rate, most } => new("thread-too-quick")
                .with("pitch", pitch)
                .with("spindle", spindle.0)
                .with("rate", round_to(rate.0, 1))
                .with("most", most.0),
            Self::NoEntry { surface, needs, room } => {
                new("thread-no-entry").with("surface", surface).with("needs", needs).with("room", room)
            }
            Self::NoRunOut { surface, needs, room } => {
                new("thread-no-run-out").with("surface", surface).with("needs", needs).with("room", room)
            }
            Self::RunOutTooLong { surface, needs, most } => {
                new("thread-run-out-too-long").with("surface", surface).with("needs", needs).with("most", most)
            }
            Self::RunOutOnSeat { surface, seat, grade } => {
                new("thread-run-out-on-seat").with("surface", surface).with("seat", seat).with("grade", grade.number())
            }
            Self::ReliefTooShallow { surface, relief, root } => {
                new("thread-relief-shallow").with("surface", surface).with("relief", relief).with("root", root)
            }
            Self::ThreadOnNoCylinder { surface } => new("thread-on-no-cylinder").with("surface", surface),
            Self::NoDrill { diameter, depth } => new("job-no-drill").with("diameter", diameter).with("depth", depth),
            Self::NoCutter { operation, diameter, depth } => new("job-no-cutter")
                .with("operation", Figure::operation(operation.name()))
                .with("diameter", diameter)
                .with("depth", depth),
            Self::NoStock { operation, diameter, from } => new("job-no-stock")
                .with("operation", Figure::operation(operation.name()))
                .with("diameter", diameter)
                .with("from", from),
            Self::NoTap { thread } => new("job-no-tap").with("thread", thread),
            Self::TapTooShort { thread, depth, reach } => {
                new("job-tap-too-short").with("thread", thread).with("depth", depth).with("reach", reach)
            }
            Self::NoTapRunOut { surface, needs, room, thread } => new("job-tap-no-run-out")
                .with("surface", surface)
                .with("thread", thread)
                .with("needs", needs)
                .with("room", room),
            Self::PlainBeforeTap { surface, plain } => {
                new("job-plain-before-tap").with("surface", surface).with("plain", plain)
            }
            Self::TapTooStrong { diameter, torque, most } => new("job-tap-too-strong")
                .with("diameter", diameter)
                .with("torque", round_to(torque.0, 1))
                .with("most", most.0),
            Self::DrillTooStrong { diameter, force, most } => new("job-drill-too-strong")
                .with("diameter", diameter)
                .with("force", round_to(force.0, 0))
                .with("most", most.0),
            Self::NoCentreHole { diameter, least } => {
                new("job-no-centre-hole").with("diameter", diameter).with("least", least)
            }
            Self::JawsTooNear { gap, least } => new("part-off-near-jaws").with("gap", gap).with("least", least),
            Self::PartingTooDeep { depth, reach } => new("part-off-too-deep").with("depth", depth).with("reach", reach),
        }
    }
}

/// A refusal of the tables of cutting conditions.
pub(super) fn of_tables(operation: Operation, refusal: Refusal<Uncut>) -> Refusal<NoJob> {
    refusal.map(|why| NoJob::NoFigures { operation, why })
}

/// A missing figure of a table for the material.
pub(super) fn no_figure<'k>(operation: Operation, table: &str, who: &impl Asking<'k>) -> Refusal<NoJob> {
    of_tables(operation, figures::missing(table, who))
}
