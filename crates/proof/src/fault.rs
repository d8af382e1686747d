//! The faults of a plan, with the inequality that fails.

use crate::note::{Figure, Note, Severity};
use crate::plan::Operation;
use crate::units::{ItGrade, MetresPerMinute, Micrometres, NewtonMetres, Newtons, Roughness, round_to};
use technolog_knowledge::units::Brinell;

pub use crate::tables::rules::Load;

/// What a transition reaches at best and ordinarily, and the requirement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shortfall {
    /// The grade of a diameter.
    Grade(ItGrade, ItGrade, ItGrade),
    /// The roughness of a surface.
    Surface(Roughness, Roughness, Roughness),
    /// The position of an axis.
    Position(Micrometres, Micrometres, Micrometres),
}

/// What a wall of a hole stands against.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Beside {
    /// The edge of the blank.
    Edge,
    /// Another hole of its own group.
    Twin,
    /// A hole of the group of that name.
    Other(String),
}

impl Beside {
    /// The sentence of those for the edge, for a hole of the group, and for one of another group.
    fn note(&self, [edge, twin, other]: [&'static str; 3]) -> Note {
        match self {
            Self::Edge => Note::new(edge),
            Self::Twin => Note::new(twin),
            Self::Other(name) => Note::new(other).with("other", Figure::called(name)),
        }
    }
}

/// A condition that does not hold.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum Fault {
    /// In the worst case the hole before is as wide as after the transition: on one side nothing is cut.
    NoStock { operation: Operation, before: Micrometres, may_be: Micrometres, shift: Micrometres, least: Micrometres },
    /// The stock on diameter is more than such a tool may remove at once.
    TooMuch { operation: Operation, stock: Micrometres, most: Micrometres },
    /// The last transition reaches the required value only at best, or not at all.
    Wanting { operation: Operation, shortfall: Shortfall },
    /// The hole may be wider than its upper limit.
    TooWide { operation: Operation, diameter: Micrometres, may_be: Micrometres, limit: Micrometres },
    /// Nothing leaves the cylinder within its limits.
    NotFinished { left: Micrometres, smallest: Micrometres, largest: Micrometres },
    /// A tool wider than the finished hole goes into it.
    Enters { operation: Operation, tool: Micrometres, limit: Micrometres },
    /// The point of a drill cuts a crater into a flat shoulder, wider than the hole below it.
    Gouges { operation: Operation, crater: Micrometres, shoulder: Micrometres, below: Micrometres },
    /// A mill goes straight down where its middle, which has no teeth, meets metal.
    MiddleInMetal { operation: Operation, tool: Micrometres, middle: Micrometres, open: Micrometres },
    /// A centring spot remains visible around the finished hole.
    SpotStays { spot: Micrometres, limit: Micrometres },
    /// The full diameter ends before the drawing's depth.
    TooShallow { operation: Operation, depth: Micrometres, required: Micrometres },
    /// The tip comes out of a blind hole's floor.
    BreaksThrough { operation: Operation, tip: Micrometres, thickness: Micrometres },
    /// The floor under the tip of a blind hole is so thin that it may burst.
    ThinFloor { operation: Operation, tip: Micrometres, floor: Micrometres, least: Micrometres, bursts: bool },
    /// A reamer or boring bar runs into a flat floor.
    MeetsFloor { operation: Operation, tip: Micrometres },
    /// A drill that opens a blind hole finds solid metal below the point of the drill before it. `short`: that drill's cylinder ends
    /// higher, too.
    SolidCore {
        operation: Operation,
        drill: Micrometres,
        tip: Micrometres,
        core: Micrometres,
        most: Micrometres,
        short: bool,
    },
    /// The tool goes below what was opened for it.
    Floor { operation: Operation, tip: Micrometres, opened: Micrometres },
    /// The drill under a thread is out of the limits of its minor diameter.
    TapHole { diameter: Micrometres, smallest: Micrometres, largest: Micrometres },
    /// A load takes more than its share of the machine's limit.
    Overload { operation: Operation, load: Load, value: f64, limit: f64, share: f64 },
    /// The speed is above shop practice by more than good tables differ among themselves.
    TooFast { operation: Operation, value: MetresPerMinute, usual: MetresPerMinute, share: f64 },
    /// The metal is too hard for a tool of high-speed steel.
    TooHard { operation: Operation, hardness: Brinell, limit: f64 },
    /// The metal is so hard that tools of ordinary high-speed steel live short.
    Hard { hardness: Brinell, usual: f64, limit: f64 },
    /// The torque exceeds the strength of a thin drill.
    Twists { operation: Operation, drill: Micrometres, value: NewtonMetres, limit: NewtonMetres },
    /// The thrust exceeds the buckling load of a long drill.
    Buckles { operation: Operation, drill: Micrometres, flutes: Micrometres, value: Newtons, limit: Newtons },
    /// The flutes of a drill are so deep in the hole that chips do not get out.
    FlutesClose { operation: Operation, drill: Micrometres, flutes: Micrometres, tip: Micrometres, least: Micrometres },
    /// The holder comes too near to the face.
    HolderLow { operation: Operation, overhang: Micrometres, tip: Micrometres, least: Micrometres },
    /// The overhang of a boring bar is more than so many of its diameters.
    BarSlender { operation: Operation, reach: Micrometres, bar: Micrometres, ratio: f64 },
    /// A pass sets the edge of a boring bar outside the range that the bar has.
    BarOutOfRange { operation: Operation, set: Micrometres, smallest: Micrometres, largest: Micrometres },
    /// A boring bar is set wider than the machine takes tools.
    BarBeyondMachine { operation: Operation, set: Micrometres, largest: Micrometres },
    /// A boring bar is as thick as the hole that it enters, or thicker.
    BarEnters { operation: Operation, bar: Micrometres, hole: Micrometres },
    /// The pilot of a counterbore has less room in a blind hole than it is wide, or none at all.
    PilotMeetsFloor { operation: Operation, pilot: Micrometres, room: Micrometres, least: Micrometres, none: bool },
    /// Nobody says how deep a blind cast hole is: at its floor tools may meet metal.
    CastDepth { cast: Micrometres, depth: Micrometres },
    /// A wall is thinner than such a wall may be.
    Wall { beside: Beside, wall: Micrometres, least: Micrometres },
    /// Nothing is left of a wall where the drawing permits its holes to lie.
    NoWall { beside: Beside, wall: Micrometres, shift: Micrometres },
    /// A cast hole leaves less stock a side than its skin and its place need.
    CastStock { cast: Micrometres, stock: Micrometres, least: Micrometres },
    /// The first cut in a cast hole is too shallow: where the stock is thinnest, it runs in the skin.
    UnderSkin { operation: Operation, depth: Micrometres, place: Micrometres, least: Micrometres },
    /// A thin plate springs between its supports by more than the feed.
    /// `gives`: so far between straps of the plan's own that they do not hold it.
    PlateSprings { operation: Operation, thrust: Newtons, spring: f64, span: Micrometres, most: f64, gives: bool },
    /// A boring bar deflects under uneven stock by more than the tolerance of the hole.
    BarSprings { operation: Operation, spring: Micrometres, tolerance: Micrometres },
}

impl Fault {
    /// What is reached only at best, a thin floor, a tool that just meets a flat one, a mill that may have no teeth where it needs them, and what the blank does not hold are doubtful; everything else damages the part or the tool.
    pub fn severity(&self) -> Severity {
        match self {
            Self::Wanting { shortfall, .. } if shortfall.at_best() => Severity::Doubtful,
            Self::ThinFloor { bursts: true, .. } => Severity::Error,
            Self::PlateSprings { gives: true, .. } => Severity::Wrong,
            // Closed flutes break the drill; with less room than usual a patient hand gets through.
            Self::FlutesClose { flutes, tip, .. } if flutes > tip => Severity::Doubtful,
            Self::HolderLow { overhang, tip, .. } if overhang > tip => Severity::Doubtful,
            Self::ThinFloor { .. }
            | Self::MeetsFloor { .. }
            | Self::MiddleInMetal { .. }
            | Self::Wall { .. }
            | Self::PilotMeetsFloor { none: false, .. }
            | Self::SolidCore { short: false, .. }
            | Self::CastDepth { .. }
            | Self::CastStock { .. }
            | Self::UnderSkin { .. }
            | Self::Hard { .. }
            | Self::PlateSprings { .. } => Severity::Doubtful,
            _ => Severity::Error,
        }
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        let of = |code: &'static str, operation: &Operation| {
            Note::new(code).with("operation", Figure::operation(operation.name()))
        };
        match self {
            Self::NoStock { operation, before, may_be, shift, least } => of("proof-no-stock", operation)
                .with("before", before)
                .with("may_be", may_be)
                .with("shift", shift)
                .with("least", least),
            Self::TooMuch { operation, stock, most } => {
                of("proof-too-much", operation).with("stock", stock).with("most", most)
            }
            Self::Wanting { operation, shortfall } => shortfall.with_figures(of(shortfall.code(), operation)),
            Self::TooWide { operation, diameter, may_be, limit } => {
                of("proof-too-wide", operation).with("diameter", diameter).with("may_be", may_be).with("limit", limit)
            }
            Self::NotFinished { left, smallest, largest } => {
                Note::new("proof-not-finished").with("left", left).with("smallest", smallest).with("largest", largest)
            }
            Self::Enters { operation, tool, limit } => {
                of("proof-enters", operation).with("tool", tool).with("limit", limit)
            }
            Self::Gouges { operation, crater, shoulder, below } => {
                of("proof-gouges", operation).with("crater", crater).with("shoulder", shoulder).with("below", below)
            }
            Self::MiddleInMetal { operation, tool, middle, open } => {
                let code = if *open > Micrometres::ZERO { "proof-middle-over-hole" } else { "proof-middle-in-metal" };
                of(code, operation).with("tool", tool).with("middle", middle).with("open", open)
            }
            Self::SolidCore { operation, drill, tip, core, most, .. } => of("proof-solid-core", operation)
                .with("drill", drill)
                .with("tip", tip)
                .with("core", core)
                .with("most", most),
            Self::SpotStays { spot, limit } => Note::new("proof-spot-stays").with("spot", spot).with("limit", limit),
            Self::TooShallow { operation, depth, required } => {
                of("proof-too-shallow", operation).with("depth", depth).with("asked", required)
            }
            Self::BreaksThrough { operation, tip, thickness } => {
                of("proof-breaks-through", operation).with("tip", tip).with("thickness", thickness)
            }
            Self::ThinFloor { operation, tip, floor, least, .. } => {
                of("proof-thin-floor", operation).with("tip", tip).with("floor", floor).with("least", least)
            }
            Self::MeetsFloor { operation, tip } => of("proof-meets-floor", operation).with("tip", tip),
            Self::Floor { operation, tip, opened } => {
                of("proof-floor", operation).with("tip", tip).with("opened", opened)
            }
            Self::TapHole { diameter, smallest, largest } => Note::new("proof-tap-hole")
                .with("diameter", diameter)
                .with("smallest", smallest)
                .with("largest", largest),
            Self::Overload { operation, load, value, limit, share } => of(overload(*load), operation)
                .with("value", round_to(*value, 1))
                .with("limit", round_to(*limit, 1))
                .with("percent", round_to(share * 100.0, 0)),
            Self::TooFast { operation, value, usual, share } => of("proof-too-fast", operation)
                .with("value", round_to(value.0, 1))
                .with("percent", round_to(share * 100.0, 0))
                .with("usual", round_to(usual.0, 1)),
            Self::TooHard { operation, hardness, limit } => {
                of("proof-too-hard", operation).with("hardness", hardness.0).with("limit", *limit)
            }
            Self::Hard { hardness, usual, limit } => {
                Note::new("proof-hard").with("hardness", hardness.0).with("usual", *usual).with("limit", *limit)
            }
            Self::Twists { operation, drill, value, limit } => of("proof-twists", operation)
                .with("drill", drill)
                .with("value", round_to(value.0, 2))
                .with("limit", round_to(limit.0, 2)),
            Self::Buckles { operation, drill, flutes, value, limit } => of("proof-buckles", operation)
                .with("drill", drill)
                .with("flutes", flutes)
                .with("value", round_to(value.0, 0))
                .with("limit", round_to(limit.0, 0)),
            Self::FlutesClose { operation, drill, flutes, tip, least } => of("proof-flutes-close", operation)
                .with("drill", drill)
                .with("flutes", flutes)
                .with("tip", tip)
                .with("open", *flutes - *tip)
                .with("least", least),
            Self::HolderLow { operation, overhang, tip, least } => of("proof-holder-low", operation)
                .with("overhang", overhang)
                .with("tip", tip)
                .with("over", *overhang - *tip)
                .with("least", least),
            Self::BarSlender { operation, reach, bar, ratio } => of("proof-bar-slender", operation)
                .with("reach", reach)
                .with("bar", bar)
                .with("ratio", round_to(*ratio, 1)),
            Self::BarOutOfRange { operation, set, smallest, largest } => of("proof-bar-out-of-range", operation)
                .with("set", set)
                .with("smallest", smallest)
                .with("largest", largest),
            Self::BarBeyondMachine { operation, set, largest } => {
                of("proof-bar-beyond-machine", operation).with("set", set).with("largest", largest)
            }
            Self::BarEnters { operation, bar, hole } => {
                of("proof-bar-enters", operation).with("bar", bar).with("hole", hole)
            }
            Self::PilotMeetsFloor { operation, pilot, room, least, none } => {
                let code = if *none { "proof-pilot-has-no-room" } else { "proof-pilot-room" };
                of(code, operation).with("pilot", pilot).with("room", room).with("least", least)
            }
            Self::CastDepth { cast, depth } => Note::new("proof-cast-depth").with("cast", cast).with("depth", depth),
            Self::Wall { beside, wall, least } => beside
                .note(["proof-wall-to-edge", "proof-wall-among", "proof-wall-between"])
                .with("wall", wall)
                .with("least", least),
            Self::NoWall { beside, wall, shift } => beside
                .note(["proof-no-wall-to-edge", "proof-no-wall-among", "proof-no-wall-between"])
                .with("wall", wall)
                .with("shift", shift),
            Self::CastStock { cast, stock, least } => {
                Note::new("proof-cast-stock").with("cast", cast).with("stock", stock).with("least", least)
            }
            Self::UnderSkin { operation, depth, place, least } => of("proof-under-skin", operation)
                .with("depth", depth)
                .with("place", place)
                .with("thinnest", (*depth - *place).max(Micrometres::ZERO))
                .with("least", least),
            Self::PlateSprings { operation, thrust, spring, span, most, gives } => {
                let code = if *gives { "proof-plate-gives" } else { "proof-plate-springs" };
                of(code, operation)
                    .with("thrust", round_to(thrust.0, 0))
                    .with("spring", round_to(*spring, 2))
                    .with("span", span)
                    .with("most", round_to(*most, 2))
            }
            Self::BarSprings { operation, spring, tolerance } => {
                of("proof-bar-springs", operation).with("spring", spring).with("tolerance", tolerance)
            }
        }
    }
}

const fn overload(load: Load) -> &'static str {
    match load {
        Load::Thrust => "proof-thrust",
        Load::Torque => "proof-torque",
        Load::Power => "proof-power",
    }
}

impl Shortfall {
    /// Whether the required value is reached at best.
    fn at_best(self) -> bool {
        match self {
            Self::Grade(best, _, required) => best <= required,
            Self::Surface(best, _, required) => best <= required,
            Self::Position(best, _, required) => best <= required,
        }
    }

    /// Whether the ordinary value is enough.
    pub(crate) fn holds(self) -> bool {
        match self {
            Self::Grade(_, ordinary, required) => ordinary <= required,
            Self::Surface(_, ordinary, required) => ordinary <= required,
            Self::Position(_, ordinary, required) => ordinary <= required,
        }
    }

    fn code(self) -> &'static str {
        match (self, self.at_best()) {
            (Self::Grade(..), true) => "proof-grade-at-best",
            (Self::Grade(..), false) => "proof-grade",
            (Self::Surface(..), true) => "proof-surface-at-best",
            (Self::Surface(..), false) => "proof-surface",
            (Self::Position(..), true) => "proof-position-at-best",
            (Self::Position(..), false) => "proof-position",
        }
    }

    fn with_figures(self, note: Note) -> Note {
        match self {
            Self::Grade(best, ordinary, required) => {
                note.with("best", best).with("ordinary", ordinary).with("asked", required)
            }
            Self::Surface(best, ordinary, required) => {
                note.with("best", best).with("ordinary", ordinary).with("asked", required)
            }
            Self::Position(best, ordinary, required) => {
                note.with("best", best).with("ordinary", ordinary).with("asked", required)
            }
        }
    }
}
