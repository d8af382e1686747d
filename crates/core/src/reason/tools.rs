//! Why a cutter or a holder is not suitable.

use crate::knowledge::units::Decimal;
use crate::note::{Figure, IntoFigure, Note};
use crate::plan::Operation;
use crate::units::{Micrometres, round_to};

use super::{sides, size};

/// Why a cutter, by itself or in a holder, is not suitable.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum Unfit {
    /// No cutter of the catalogs has the size.
    NoSize(NoSize),
    /// A cutter of the size is not suitable.
    Cutter { tool: String, table: String, fault: CutterFault },
    /// A holder is not suitable for a cutter.
    Holder { tool: String, holder: String, fault: HolderFault },
    /// The cutter is made for something else.
    OfOther(OfOther),
}

/// The existing sizes, where none is the required one.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum NoSize {
    /// The next below and above.
    NoCutter {
        operation: Operation,
        diameter: Micrometres,
        below: Option<Micrometres>,
        above: Option<Micrometres>,
        tables: String,
    },
    /// No mill enters the hole with clearance around it.
    NoMillEnters { hole: Micrometres, clearance: Micrometres },
    /// No tap of the thread.
    NoTap { thread: String, tables: String },
    /// The countersinks of that angle (thousandths of a degree) that are wide enough have a front wider than the hole.
    NoConeSoPointed { angle: u32, diameter: Micrometres, tip: Micrometres, hole: Micrometres, tables: String },
    /// No cone of that angle (thousandths of a degree) is wide enough.
    NoConeSoWide { angle: u32, diameter: Micrometres, widest: Micrometres, hole: Micrometres, tables: String },
    /// No cone of that angle (thousandths of a degree); the existing angles.
    NoConeOfAngle { angle: u32, diameter: Micrometres, angles: Vec<u32>, tables: String },
    /// No step drill of both diameters.
    NoStepDrill { narrow: Micrometres, wide: Micrometres },
}

/// Why a cutter of the right size is not suitable.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum CutterFault {
    /// The machine cannot drive so large a drill.
    DrillTooLarge { diameter: Micrometres, limit: Micrometres },
    /// The machine cannot drive so large an end mill.
    MillTooLarge { diameter: Micrometres, limit: Micrometres },
    /// The machine does not take so wide a tool.
    TooWide { diameter: Micrometres, limit: Micrometres },
    /// It does not pass through the cylinder above.
    DoesNotPass { diameter: Micrometres, within: Micrometres },
    /// Its pilot does not enter.
    PilotWider { pilot: Micrometres, hole: Micrometres },
    /// The bar does not enter.
    BarDoesNotEnter { bar: Micrometres, hole: Micrometres },
    /// Its end teeth do not reach its middle, which would meet metal on the way down: only narrower mills of its kind go down there.
    NoTeethInMiddle { diameter: Micrometres, widest: Micrometres },
    /// It is too short.
    DoesNotReach { reach: Micrometres, needed: Micrometres },
    /// Its flutes reach, but leave too little open for chips to get out.
    FlutesClose { flutes: Micrometres, needed: Micrometres, room: Micrometres },
}

/// Why a holder is not suitable for a cutter.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum HolderFault {
    /// Its taper is not the spindle's.
    OtherTaper { own: i64, spindle: i64 },
    /// The tap's thread is not one that the chuck takes.
    ThreadOutsideChuck { thread: Micrometres, low: Micrometres, high: Micrometres },
    /// The shank is not one that it clamps.
    ShankOutsideClamp { shank: Micrometres, low: Micrometres, high: Micrometres },
    /// Another Morse taper.
    OtherMorse { own: i64, taken: i64 },
    /// An arbor for another bore.
    OtherBore { own: Micrometres, taken: Micrometres },
    /// The overhang does not reach the depth.
    StandsOutTooLittle { reach: Micrometres, needed: Micrometres, over_face: Micrometres },
    /// The arbor is too thick for the hole.
    ArborDoesNotEnter { arbor: Micrometres, hole: Micrometres },
    /// The assembly is longer than the machine takes.
    TooLong { length: Micrometres, limit: Micrometres },
    /// The assembly is heavier than the machine takes, kg.
    TooHeavy { mass: f64, limit: f64 },
    /// The holder has no seat for such a shank at all.
    OtherShank { shank: &'static str },
}

/// The other work for which a named cutter is made.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum OfOther {
    /// For other transitions.
    Operation { operation: Operation, transitions: Vec<Operation> },
    /// A bar of the other stage of boring: this one is for roughing, or for finishing.
    Stage { rough: bool },
    /// A bar of another range of diameters.
    Range { low: Micrometres, high: Micrometres, needed: Micrometres },
    /// A tap of another thread.
    Thread { own: String, needed: String },
    /// A cone of another angle, degrees.
    Angle { own: f64, needed: f64 },
    /// Another diameter.
    Size { own: Option<Micrometres>, needed: Micrometres },
}

impl Unfit {
    /// Whether the only reason is that a holder takes other shanks, which says nothing about the cutter.
    pub const fn is_of_other_holder(&self) -> bool {
        let Self::Holder { fault, .. } = self else { return false };
        matches!(
            fault,
            HolderFault::ShankOutsideClamp { .. }
                | HolderFault::OtherMorse { .. }
                | HolderFault::OtherBore { .. }
                | HolderFault::OtherTaper { .. }
                | HolderFault::ThreadOutsideChuck { .. }
        )
    }

    /// Whether the cutter itself is too short.
    pub const fn is_of_reach(&self) -> bool {
        let Self::Cutter { fault, .. } = self else { return false };
        matches!(fault, CutterFault::DoesNotReach { .. } | CutterFault::FlutesClose { .. })
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        match self {
            Self::NoSize(why) => why.note(),
            Self::Cutter { tool, table, fault } => fault.note().with("tool", tool).with("table", table),
            Self::Holder { tool, holder, fault } => fault.note().with("tool", tool).with("holder", holder),
            Self::OfOther(why) => why.note(),
        }
    }
}

impl NoSize {
    fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::NoCutter { operation, diameter, below, above, tables } => new("no-cutter-of-size")
                .with("operation", Figure::operation(operation.name()))
                .with("diameter", diameter)
                .with("below", size(*below))
                .with("above", size(*above))
                .with("sides", sides(*below, *above))
                .with("tables", tables),
            Self::NoMillEnters { hole, clearance } => {
                new("no-mill-enters").with("hole", hole).with("clearance", clearance)
            }
            Self::NoTap { thread, tables } => new("no-tap").with("thread", thread).with("tables", tables),
            Self::NoConeSoPointed { angle, diameter, tip, hole, tables } => new("no-cone-so-pointed")
                .with("angle", degrees(*angle))
                .with("diameter", diameter)
                .with("tip", tip)
                .with("hole", hole)
                .with("tables", tables),
            Self::NoConeSoWide { angle, diameter, widest, hole, tables } => new("no-cone-so-wide")
                .with("angle", degrees(*angle))
                .with("diameter", diameter)
                .with("widest", widest)
                .with("hole", hole)
                .with("tables", tables),
            // No countersink is so slender; such holes are for taper pins and shanks.
            Self::NoConeOfAngle { angle, diameter, .. } if *angle <= MOST_OF_TAPER_REAMERS => {
                let half = f64::from(*angle) / 2000.0 * core::f64::consts::PI / 180.0;
                let ratio = Decimal::from_f64_rounded(libm::round(5.0 / libm::tan(half)) / 10.0);
                new("no-taper-reamer").with("ratio", Figure::number(ratio.to_string())).with("diameter", diameter)
            }
            Self::NoConeOfAngle { angle, diameter, angles, tables } => {
                let angles = Figure::list(angles.iter().map(|angle| degrees(*angle)));
                new("no-cone-of-angle")
                    .with("angle", degrees(*angle))
                    .with("diameter", diameter)
                    .with("angles", angles)
                    .with("tables", tables)
            }
            Self::NoStepDrill { narrow, wide } => new("no-step-drill").with("narrow", narrow).with("wide", wide),
        }
    }
}

/// The widest cone of taper reamers, thousandths of a degree: 1:7 is 8.17° (github sad-engineer/tools, geometry_deployment_cutter).
const MOST_OF_TAPER_REAMERS: u32 = 8_200;

/// Thousandths of a degree as degrees.
fn degrees(angle: u32) -> Figure {
    Figure::number(Decimal::from_f64_rounded(f64::from(angle) / 1000.0).to_string())
}

impl CutterFault {
    fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::DrillTooLarge { diameter, limit } => {
                new("drill-too-large").with("diameter", diameter).with("limit", limit)
            }
            Self::MillTooLarge { diameter, limit } => {
                new("mill-too-large").with("diameter", diameter).with("limit", limit)
            }
            Self::TooWide { diameter, limit } => new("tool-too-wide").with("diameter", diameter).with("limit", limit),
            Self::DoesNotPass { diameter, within } => {
                new("does-not-pass").with("diameter", diameter).with("within", within)
            }
            Self::PilotWider { pilot, hole } => new("pilot-wider-than-hole").with("pilot", pilot).with("hole", hole),
            Self::BarDoesNotEnter { bar, hole } => new("bar-does-not-enter").with("bar", bar).with("hole", hole),
            Self::NoTeethInMiddle { diameter, widest } if *widest > Micrometres::ZERO => {
                new("no-teeth-over-hole").with("diameter", diameter).with("widest", widest)
            }
            Self::NoTeethInMiddle { diameter, .. } => new("no-teeth-in-middle").with("diameter", diameter),
            Self::DoesNotReach { reach, needed } => new("does-not-reach").with("reach", reach).with("needed", needed),
            Self::FlutesClose { flutes, needed, room } => {
                new("flutes-close").with("flutes", flutes).with("needed", needed).with("room", room)
            }
        }
    }
}

impl HolderFault {
    /// The sentence, without a holder.
    pub fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::OtherTaper { own, spindle } => new("other-taper").with("own", own).with("spindle", spindle),
            Self::ThreadOutsideChuck { thread, low, high } => {
                new("thread-outside-chuck").with("thread", thread).with("low", low).with("high", high)
            }
            Self::ShankOutsideClamp { shank, low, high } => {
                new("shank-outside-clamp").with("shank", shank).with("low", low).with("high", high)
            }
            Self::OtherMorse { own, taken } => new("other-morse").with("own", own).with("taken", taken),
            Self::OtherBore { own, taken } => new("other-bore").with("own", own).with("taken", taken),
            Self::StandsOutTooLittle { reach, needed, over_face } => {
                new("stands-out-too-little").with("reach", reach).with("needed", needed).with("over_face", over_face)
            }
            Self::ArborDoesNotEnter { arbor, hole } => {
                new("arbor-does-not-enter").with("arbor", arbor).with("hole", hole)
            }
            Self::TooLong { length, limit } => new("assembly-too-long").with("length", length).with("limit", limit),
            Self::TooHeavy { mass, limit } => {
                new("assembly-too-heavy").with("mass", round_to(*mass, 1)).with("limit", limit)
            }
            Self::OtherShank { shank } => new("holder-of-other-shank").with("shank", Figure::word(*shank)),
        }
    }
}

impl OfOther {
    fn note(&self) -> Note {
        let new = Note::new;
        match self {
            Self::Operation { operation, transitions } => new("tool-of-other-operation")
                .with("operation", Figure::operation(operation.name()))
                .with("transitions", Figure::operations(transitions.iter().map(|made| made.name()))),
            Self::Stage { rough: true } => new("bar-of-other-stage-rough"),
            Self::Stage { rough: false } => new("bar-of-other-stage-finish"),
            Self::Range { low, high, needed } => {
                new("bar-of-other-range").with("low", low).with("high", high).with("needed", needed)
            }
            Self::Thread { own, needed } => new("tap-of-other-thread").with("own", own).with("needed", needed),
            Self::Angle { own, needed } => new("tool-of-other-angle").with("own", own).with("needed", needed),
            Self::Size { own, needed } => {
                let own = own.map_or_else(|| "-".into_figure(), IntoFigure::into_figure);
                new("tool-of-other-size").with("own", own).with("needed", needed)
            }
        }
    }
}
