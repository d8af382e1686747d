//! Why a job cannot be made: the failed inequality.

use crate::error::Refusal;
use crate::note::{Figure, Note};
use crate::reason::Uncut;
use crate::turning::contour::SurfaceName;
use crate::turning::cutting::{Bound, CuttingRefusal};
use crate::turning::length::Half;
use crate::turning::reasons::reasons;
use crate::units::{ItGrade, Micrometres, MillimetresPerMinute, NewtonMetres, Newtons, RevsPerMinute, round_to};
use technolog_cutting::figures::{self, Asking};

technolog_knowledge::vocabulary! {
    /// What the tables of cutting conditions are asked for.
    #[allow(missing_docs)]
    pub enum Operation {
        Drilling = "drill",
        Grooving = "grooving",
        Threading = "threading",
        Tapping = "tap",
    }
}

/// The tables of cutting conditions have no figures.
#[derive(Clone, Debug, PartialEq)]
pub struct NoFigures {
    /// For what.
    operation: Operation,
    /// Why.
    why: Uncut,
}

impl NoFigures {
    fn note(&self) -> Note {
        self.why.note().with("operation", Figure::operation(self.operation.name()))
    }
}

reasons! {
    /// Why a job cannot be made.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(missing_docs)] // the figures have the names of those of the sentences
    pub enum NoJob {
        /// Speed and feed need a lathe.
        NoLathe = note!("job-needs-lathe"),
        /// No tool of that kind works there.
        NoTool { surface: SurfaceName } = note!("job-no-tool"),
        /// It is not a groove with walls and a floor.
        NotAValley { surface: SurfaceName } = note!("groove-no-valley"),
        /// Even the narrowest blade is wider than the floor permits.
        TooNarrow { surface: SurfaceName, room: Half, width: Micrometres } = note!("groove-too-narrow"),
        /// The corners of the edge are so round that it makes no wall of so shallow a groove.
        TooRound { surface: SurfaceName, corner: Half, depth: Half } = note!("groove-shallower-than-corner"),
        /// The blade is too short.
        TooDeep { surface: SurfaceName, depth: Half, reach: Micrometres } = note!("groove-beyond-blade"),
        /// The tool is too thick for the bore.
        BoreTooSmall { surface: SurfaceName, bore: Micrometres, least: Micrometres } = note!("job-bore-too-small"),
        /// The bar is too short.
        BarTooShort { surface: SurfaceName, depth: Half, reach: Half } = note!("job-bar-too-short"),
        /// The blade of a face groove is curved for larger diameters.
        FaceTooSmall { surface: SurfaceName, diameter: Micrometres, least: Micrometres } = note!("groove-face-too-small"),
        /// Its mouth does not face the free end.
        FacesChuck { surface: SurfaceName } = note!("groove-faces-chuck"),
        /// Both sides of its mouth are undercut: no insert has both angles.
        Undercut {
            surface: SurfaceName,
            main: f64 as round_to(*main, 2),
            secondary: f64 as round_to(*secondary, 2),
        } = note!("groove-undercut"),
        /// It exceeds a limit of tool or lathe.
        Overloaded { tool: String, bound: Bound as Figure::word(bound.name()) } = note!("job-overloaded"),
        /// No insert cuts that pitch.
        NoPitch { pitch: Micrometres, least: Micrometres, most: Micrometres } = note!("thread-no-insert"),
        /// The table of passes has no such pitch.
        NoPasses { pitch: Micrometres } = note!("thread-no-passes"),
        /// The feed of the lathe is too slow for the pitch even at its slowest spindle.
        PitchTooQuick {
            pitch: Micrometres,
            spindle: RevsPerMinute as spindle.0,
            rate: MillimetresPerMinute as round_to(rate.0, 1),
            most: MillimetresPerMinute as most.0,
        } = note!("thread-too-quick"),
        /// There is no room before the thread.
        NoEntry { surface: SurfaceName, needs: Half, room: Half } = note!("thread-no-entry"),
        /// There is no room behind the thread.
        NoRunOut { surface: SurfaceName, needs: Half, room: Half } = note!("thread-no-run-out"),
        /// Without a relief the thread would run out over a greater length than the standard allows.
        RunOutTooLong { surface: SurfaceName, needs: Half, most: Micrometres } = note!("thread-run-out-too-long"),
        /// Without a relief the thread would run out on a surface with a fine tolerance.
        RunOutOnSeat {
            surface: SurfaceName,
            seat: SurfaceName,
            grade: ItGrade as grade.number(),
        } = note!("thread-run-out-on-seat"),
        /// The relief is not as deep as the thread.
        ReliefTooShallow { surface: SurfaceName, relief: Micrometres, root: Micrometres } = note!("thread-relief-shallow"),
        /// The thread is not on a cylinder.
        ThreadOnNoCylinder { surface: SurfaceName } = note!("thread-on-no-cylinder"),
        /// No drill of the catalogs is so small, or reaches so deep.
        NoDrill { diameter: Micrometres, depth: Half } = note!("job-no-drill"),
        /// No other cutter for the axis is of that size and reaches so deep.
        NoCutter {
            operation: crate::knowledge::vocabulary::Operation as Figure::operation(operation.name()),
            diameter: Micrometres,
            depth: Half,
        } = note!("job-no-cutter"),
        /// The hole that is there is as wide as the cutter, or wider.
        NoStock {
            operation: crate::knowledge::vocabulary::Operation as Figure::operation(operation.name()),
            diameter: Micrometres,
            from: Micrometres,
        } = note!("job-no-stock"),
        /// No catalog has a tap of the thread.
        NoTap { thread: String } = note!("job-no-tap"),
        /// No tap of the thread goes so deep.
        TapTooShort { thread: String, depth: Half, reach: Half } = note!("job-tap-too-short"),
        /// There is no room behind the thread for the lead of its tap.
        NoTapRunOut { surface: SurfaceName, needs: Half, room: Half, thread: String } = note!("job-tap-no-run-out"),
        /// The hole begins with a plain cylinder of the same diameter, which the tap would cut too.
        PlainBeforeTap { surface: SurfaceName, plain: SurfaceName } = note!("job-plain-before-tap"),
        /// The torque of the tap is more than that of the spindle.
        TapTooStrong {
            diameter: Micrometres,
            torque: NewtonMetres as round_to(torque.0, 1),
            most: NewtonMetres as most.0,
        } = note!("job-tap-too-strong"),
        /// The drill exceeds the spindle or the drive of Z even at the least feed.
        DrillTooStrong {
            diameter: Micrometres,
            force: Newtons as round_to(force.0, 0),
            most: Newtons as most.0,
        } = note!("job-drill-too-strong"),
        /// No centre hole is so small.
        NoCentreHole { diameter: Micrometres, least: Micrometres } = note!("job-no-centre-hole"),
        /// The blade is too near to the jaws.
        JawsTooNear { gap: Half, least: Micrometres } = note!("part-off-near-jaws"),
        /// The blade is not long enough for the bar.
        PartingTooDeep { depth: Half, reach: Micrometres } = note!("part-off-too-deep"),
    }
    of others {
        /// Speed or feed is not known.
        Cutting(CuttingRefusal),
        /// The tables of cutting conditions have no figures for it.
        NoFigures(NoFigures),
    }
}

/// A refusal of the tables of cutting conditions.
pub(super) fn of_tables(operation: Operation, refusal: Refusal<Uncut>) -> Refusal<NoJob> {
    refusal.map(|why| NoJob::NoFigures(NoFigures { operation, why }))
}

/// A missing figure of a table for the material.
pub(super) fn no_figure<'k>(operation: Operation, table: &str, who: &impl Asking<'k>) -> Refusal<NoJob> {
    of_tables(operation, figures::missing(table, who))
}
