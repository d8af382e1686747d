//! The language of LinuxCNC and Fanuc.

pub use technolog_knowledge::vocabulary::IsoControl;
use technolog_knowledge::{rows, vocabulary};

use super::{Acts, Letter};

vocabulary! {
    /// How an address is written.
    pub enum Written {
        Whole = "whole",
        Number = "number",
        /// In millimetres or inches.
        Length = "length",
    }

    /// Groups of G functions.
    pub enum Group {
        OneShot = "one-shot",
        Motion = "motion",
        Cycle = "cycle",
        Plane = "plane",
        Units = "units",
        Radius = "radius",
        Length = "length",
        System = "system",
        Path = "path",
        Distance = "distance",
        ArcDistance = "arc-distance",
        FeedMode = "feed-mode",
        Retract = "retract",
    }

    /// The effect of a G function.
    pub enum Effect {
        Mode = "mode",
        Cycle = "cycle",
        CycleOff = "cycle-off",
        Dwell = "dwell",
        Return = "return",
        MachinePosition = "machine-position",
        Noted = "noted",
    }

    /// The action of the control for an M function.
    pub enum Action {
        Stop = "stop",
        OptionalStop = "optional-stop",
        End = "end",
        Return = "return",
        Call = "call",
        SpindleClockwise = "spindle-clockwise",
        SpindleCounterclockwise = "spindle-counterclockwise",
        SpindleStop = "spindle-stop",
        ToolChange = "tool-change",
        CoolantOn = "coolant-on",
        CoolantOff = "coolant-off",
        Auxiliary = "auxiliary",
    }

    /// The action of the control for an active comment.
    pub enum CommentAct {
        Shows = "shows",
        /// To a file.
        Writes = "writes",
        /// A program of another language.
        Runs = "runs",
        /// The program.
        Stops = "stops",
    }

    /// Groups of M functions.
    pub enum MGroup {
        Stop = "stop",
        Spindle = "spindle",
        Tool = "tool",
        Coolant = "coolant",
        Call = "call",
        Other = "other",
    }

    /// The motion of a cycle to its bottom.
    pub enum Inwards {
        Feed = "feed",
        /// After every step out of the hole.
        StepsLeaving = "in-steps-leaving",
        /// After every step a small retract.
        StepsStaying = "in-steps-staying",
    }

    /// The spindle at the bottom of a cycle.
    pub enum Bottom {
        Turning = "turning",
        Stopped = "stopped",
        Reversed = "reversed",
    }

    /// The motion of a cycle out of the hole.
    pub enum Outwards {
        Rapid = "rapid",
        /// At feed to R, at rapid from there.
        Feed = "feed",
        FeedToTheEnd = "feed-to-the-end",
    }

    /// The characteristics of a control in its record. Yes is 1, no is 0.
    pub enum Characteristic {
        /// The deepest nesting of subprogram calls.
        SubprogramDepthMax = "subprogram-depth-max",
        /// The number of offset registers.
        Correctors = "correctors",
        /// Steps of the switch, %; two figures are the ends of a range of whole numbers.
        FeedOverride = "feed-override",
        /// Steps of the switch, %; two figures are the ends of a range of whole numbers.
        SpindleOverride = "spindle-override",
        MFunctionsPerBlockMax = "m-functions-per-block-max",
        /// The unit of P in a dwell, s.
        DwellUnit = "dwell-unit",
        /// The permitted difference of the radii at start and end of an arc, mm.
        ArcTolerance = "arc-tolerance",
        /// The same as a part of the radius.
        ArcToleranceRelative = "arc-tolerance-relative",
        /// The distance above the metal where the rapid of G83 ends, mm.
        G83Clearance = "g83-clearance",
        /// The retract of G73, mm.
        G73Retract = "g73-retract",
        /// Whether cycles and motions are one group, of which a block may have one.
        CyclesAreMotions = "cycles-are-motions",
        WordsInSmallLetters = "words-in-small-letters",
        /// Whether subprograms are written with o-words.
        OWords = "o-words",
        /// Whether G43 without H takes the offset register of the tool in the spindle.
        LengthOfToolInSpindle = "length-of-tool-in-spindle",
        /// Whether the operator sets clearance and retract of steps.
        PecksOfSetting = "pecks-of-setting",
    }
}

impl Characteristic {
    /// The unit of its value, as the record writes it.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::DwellUnit => "s",
            Self::ArcTolerance | Self::G83Clearance | Self::G73Retract => "mm",
            Self::FeedOverride | Self::SpindleOverride => "%",
            _ => "1",
        }
    }
}

rows! {
    /// Addresses of LinuxCNC and Fanuc.
    pub struct Addresses of One("iso-addresses") {
        address: Letter,
        controls: Vec<IsoControl>,
        kind: Written,
    } shown { meaning_uk, meaning_en }

    /// Fixed cycles of LinuxCNC and Fanuc.
    pub struct Cycles of One("iso-cycles") {
        code: &'t str,
        controls: Vec<IsoControl>,
        required: Vec<Letter>,
        optional_words: Option<Vec<Letter>>,
        inwards: Inwards,
        bottom: Bottom,
        outwards: Outwards,
    }

    /// G functions of LinuxCNC and Fanuc.
    pub struct GFunctions of One("iso-g-functions") {
        code: &'t str,
        controls: Vec<IsoControl>,
        group: Group,
        power_on: Option<Vec<IsoControl>>,
        effect: Effect,
    } shown { meaning_uk, meaning_en }

    /// M functions of LinuxCNC and Fanuc.
    pub struct MFunctions of One("iso-m-functions") {
        code: &'t str,
        controls: Vec<IsoControl>,
        action: Action,
        group: MGroup,
        acts: Acts,
    } shown { meaning_uk, meaning_en }

    /// Comments that the control executes.
    pub struct ActiveComments of One("iso-active-comments") {
        begins: &'t str,
        controls: Vec<IsoControl>,
        acts: CommentAct,
        after_semicolon: Option<bool>,
        whole: Option<bool>,
    } shown { meaning_uk, meaning_en }

    /// Words of LinuxCNC and Fanuc that the check does not carry out, and what it passes over with them.
    pub struct NotCarriedOut of One("iso-not-carried-out") {
        word: &'t str,
        last: Option<&'t str>,
        controls: Vec<IsoControl>,
        takes: Option<Vec<Letter>>,
        named_by: Option<Letter>,
        whole: Option<bool>,
        goes_on: Option<bool>,
        harmless: Option<bool>,
    } shown { meaning_uk, meaning_en }

    /// The meanings of the words of a control, where one table has all of them.
    pub struct Words of Each(&["fanuc-words", "linuxcnc-words"]) {
        word: &'t str,
        cycles: Option<Vec<&'t str>>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        incremental_uk: Option<&'t str>,
        incremental_en: Option<&'t str>,
        unit: Option<&'t str>,
    }

    /// A characteristic of a control.
    pub struct Record of Each(&["control-fanuc", "control-linuxcnc"]) complete name {
        name: Characteristic,
        value: Option<Vec<f64>>,
        unit: Option<&'t str>,
    } shown { text }
}
