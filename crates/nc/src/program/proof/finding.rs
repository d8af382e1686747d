//! Findings of the proof: the kind of deviation and its figures, as types.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::motion::{BlockRef, Position};
use crate::note::{self, IntoFigure, Note, Severity};
use crate::plan::Operation;
use crate::units::Micrometres;

use super::shown;

/// An enum whose values have names.
macro_rules! named {
    ($(#[$about:meta])* $kind:ident { $($value:ident = $name:literal,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[allow(missing_docs)] // the sentences of the proof say what each is
        pub enum $kind { $($value,)* }

        impl $kind {
            /// Every one.
            pub const ALL: &'static [Self] = &[$(Self::$value,)*];

            /// Its name in sentences, JSON and tables.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$value => $name,)* }
            }

            /// The one of that name.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|one| one.name() == name)
            }
        }
    };
}

named! {
    /// The kind of deviation of a program from the job.
    Code {
        IdlePoint = "idle-point",
        TravelAtFeed = "travel-at-feed",
        TurnsToChange = "turns-to-change",
        TravelNotUp = "travel-not-up",
        TravelLow = "travel-low",
        TravelHigh = "travel-high",
        DwellInAir = "dwell-in-air",
        IdleHeight = "idle-height",
        ApproachStanding = "approach-standing",
        AirAtFeed = "air-at-feed",
        StopForNothing = "stop-for-nothing",
        NotTurnedOver = "not-turned-over",
        OtherOrder = "other-order",
        RadiusCorrection = "radius-correction",
        ChangesElsewhere = "changes-elsewhere",
        CorrectionAtChange = "correction-at-change",
        TurnsAtChange = "turns-at-change",
        CoolantAtChange = "coolant-at-change",
        EndsElsewhere = "ends-elsewhere",
        TurnsAtEnd = "turns-at-end",
        CoolantAtEnd = "coolant-at-end",
        NoEnd = "no-end",
        NoStopToLoad = "no-stop-to-load",
        NoStopToTurnOver = "no-stop-to-turn-over",
        NoStopToSetBar = "no-stop-to-set-bar",
        WrongTool = "wrong-tool",
        WrongOrder = "wrong-order",
        RapidAcross = "rapid-across",
        ThroughObstacle = "through-obstacle",
        HolderThroughObstacle = "holder-through-obstacle",
        HolderUnknown = "holder-unknown",
        HolderIntoPart = "holder-into-part",
        RapidIntoPart = "rapid-into-part",
        NotMade = "not-made",
        RapidIntoMetal = "rapid-into-metal",
        BeginsLower = "begins-lower",
        BeginsHigher = "begins-higher",
        IntoTable = "into-table",
        Deeper = "deeper",
        OtherSpeed = "other-speed",
        OtherFeed = "other-feed",
        FeedPerTurn = "feed-per-turn",
        OtherDwell = "other-dwell",
        DwellElsewhere = "dwell-elsewhere",
        CoolantMissing = "coolant-missing",
        CoolantSuperfluous = "coolant-superfluous",
        StepsNotPlanned = "steps-not-planned",
        StepTooLarge = "step-too-large",
        StepSmaller = "step-smaller",
        StepClearance = "step-clearance",
        StepReturn = "step-return",
        OutAtRapid = "out-at-rapid",
        OutOtherFeed = "out-other-feed",
        OutAtFeed = "out-at-feed",
        OutElsewhere = "out-elsewhere",
        OutTooLow = "out-too-low",
        OutTooHigh = "out-too-high",
        OutTurning = "out-turning",
        OutStanding = "out-standing",
        SpindleStands = "spindle-stands",
        TapNotFollowed = "tap-not-followed",
        WrongTurn = "wrong-turn",
        LessOverrun = "less-overrun",
        TooShallow = "too-shallow",
        CutAgain = "cut-again",
        CutNotPlanned = "cut-not-planned",
        CutElsewhere = "cut-elsewhere",
        Slot = "slot",
        SlotGouged = "slot-gouged",
        SlotUncut = "slot-uncut",
        SlotPlungeAside = "slot-plunge-aside",
        CircleMissing = "circle-missing",
        CircleSuperfluous = "circle-superfluous",
        WaysBetweenCircles = "ways-between-circles",
        Oblique = "oblique",
        NotInTheMiddle = "not-in-the-middle",
        WaysDown = "ways-down",
        CircleLevel = "circle-level",
        CircleRadius = "circle-radius",
        CircleCentre = "circle-centre",
        CircleSense = "circle-sense",
        CircleOpen = "circle-open",
        CircleAgain = "circle-again",
        ToolByWork = "tool-by-work",
        NotLoaded = "not-loaded",
        ToolUnknown = "tool-unknown",
        OtherCorrector = "other-corrector",
        NoCorrector = "no-corrector",
        WrongCorrection = "wrong-correction",
        SharedCorrector = "shared-corrector",
        NoCorrection = "no-correction",
        WrongSign = "wrong-sign",
        CorrectionOtherwise = "correction-otherwise",
    }
}

named! {
    /// Which figure of a deviation it is.
    Name {
        At = "at",
        To = "to",
        Z = "z",
        Hole = "hole",
        Operation = "operation",
        Instead = "instead",
        Tool = "tool",
        Tools = "tools",
        Place = "place",
        Plan = "plan",
        Other = "other",
        Corrector = "corrector",
        Own = "own",
        Value = "value",
        Made = "made",
        Needed = "needed",
        Count = "count",
        Points = "points",
        More = "more",
        Way = "way",
        Whose = "whose",
        Diameter = "diameter",
        Free = "free",
        Aside = "aside",
        Lower = "lower",
        Word = "word",
    }
}

/// A figure of a deviation.
#[derive(Clone, Debug, PartialEq)]
pub enum DeviationFigure {
    /// A length or a coordinate.
    Length(Micrometres),
    /// A point of the drawing.
    Point([Micrometres; 2]),
    /// A place of the tool in the frame of the machine.
    Place(Position),
    /// Points of the drawing.
    Points(Vec<[Micrometres; 2]>),
    /// A number with its own unit: a feed, a speed, a time.
    Number(f64),
    /// How many, or which by its number.
    Count(usize),
    /// A transition.
    Operation(Operation),
    /// A name.
    Text(String),
}

impl IntoFigure for DeviationFigure {
    fn into_figure(self) -> note::Figure {
        match self {
            Self::Length(length) => length.into_figure(),
            Self::Point(at) => shown(at),
            Self::Place(at) => {
                let z = note::Figure::List(vec![" Z".into_figure(), at.z.into_figure()], "");
                note::Figure::List(vec![shown([at.x, at.y]), z], "")
            }
            Self::Points(points) => note::Figure::list(points.into_iter().map(in_brackets)),
            Self::Number(number) => number.into_figure(),
            Self::Count(count) => count.into_figure(),
            Self::Operation(operation) => note::Figure::operation(operation.name()),
            Self::Text(text) => text.into_figure(),
        }
    }
}

/// A point as drawings have it: `[-175; 50]`.
fn in_brackets([x, y]: [Micrometres; 2]) -> note::Figure {
    note::Figure::List(
        vec!["[".into_figure(), x.into_figure(), "; ".into_figure(), y.into_figure(), "]".into_figure()],
        "",
    )
}

macro_rules! figures {
    ($($from:ty, $value:ident => $figure:expr;)*) => {
        $(impl From<$from> for DeviationFigure {
            fn from($value: $from) -> Self {
                $figure
            }
        })*
    };
}

figures! {
    Micrometres, length => Self::Length(length);
    [Micrometres; 2], at => Self::Point(at);
    Position, at => Self::Place(at);
    Vec<[Micrometres; 2]>, points => Self::Points(points);
    f64, number => Self::Number(number);
    usize, count => Self::Count(count);
    u32, number => Self::Count(number as usize);
    Operation, operation => Self::Operation(operation);
    String, text => Self::Text(text);
    &String, text => Self::Text(text.clone());
}

/// A deviation from the job.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProgramFinding {
    /// The kind of deviation; the note has it too.
    #[serde(skip)]
    pub code: Code,
    /// How grave.
    pub severity: Severity,
    /// The block of the program; absent if there is none.
    #[serde(flatten)]
    pub block: Option<BlockRef>,
    /// Its figures; the note has them too.
    #[serde(skip)]
    pub figures: BTreeMap<Name, DeviationFigure>,
    /// What it says.
    #[serde(flatten)]
    pub note: Note,
}

impl ProgramFinding {
    /// A deviation that needs figures.
    pub(super) fn new(code: Code, severity: Severity, block: impl Into<Option<BlockRef>>) -> Self {
        let (block, figures) = (block.into(), BTreeMap::new());
        Self { code, severity, block, figures, note: Note::new(code.name()) }
    }

    /// With one more figure.
    pub(super) fn with(mut self, name: Name, figure: impl Into<DeviationFigure>) -> Self {
        let figure = figure.into();
        self.note = self.note.with(name.name(), &figure);
        self.figures.insert(name, figure);
        self
    }

    /// The group of holes it is about.
    pub fn hole(&self) -> Option<&str> {
        match self.figures.get(&Name::Hole)? {
            DeviationFigure::Text(hole) => Some(hole),
            _ => None,
        }
    }

    /// The transition it is about.
    pub fn operation(&self) -> Option<Operation> {
        match self.figures.get(&Name::Operation)? {
            DeviationFigure::Operation(operation) => Some(*operation),
            _ => None,
        }
    }

    /// The tool it is about.
    pub fn tool(&self) -> Option<u32> {
        self.count(Name::Tool)
    }

    /// A figure that is a count or a number of something.
    pub fn count(&self, name: Name) -> Option<u32> {
        match self.figures.get(&name)? {
            DeviationFigure::Count(count) => u32::try_from(*count).ok(),
            _ => None,
        }
    }

    /// A figure that is a length or a coordinate.
    pub fn length(&self, name: Name) -> Option<Micrometres> {
        match self.figures.get(&name)? {
            DeviationFigure::Length(length) => Some(*length),
            _ => None,
        }
    }

    /// A figure that is a rate or a time.
    pub fn number(&self, name: Name) -> Option<f64> {
        match self.figures.get(&name)? {
            DeviationFigure::Number(number) => Some(*number),
            _ => None,
        }
    }
}
