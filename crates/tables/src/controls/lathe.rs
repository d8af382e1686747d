//! Controls of lathes: their words and their roughing cycles.

pub use technolog_knowledge::vocabulary::LatheControl;
use technolog_knowledge::{rows, vocabulary};

use super::lathe_reading::LatheReader;
use crate::turning::part::Side;

vocabulary! {
    /// The direction of the passes.
    pub enum Direction {
        /// Along the axis, from the free end towards the chuck.
        Longitudinal = "longitudinal",
        /// Across it, from the surface of the blank towards the axis; of a bore, away from it.
        Facing = "facing",
    }

    /// The content of a field in the call of a cycle.
    pub enum FieldContent {
        Contour = "contour",
        StartX = "start-x",
        StartZ = "start-z",
        Allowance = "allowance",
        AllowanceX = "allowance-x",
        AllowanceZ = "allowance-z",
        Depth = "depth",
        Retract = "retract",
        RoughFeed = "rough-feed",
        PlungeFeed = "plunge-feed",
        FinishFeed = "finish-feed",
        Machining = "machining",
        Nothing = "nothing",
    }

    /// The order in which a control numbers the positions of a tool tip.
    pub enum TipNumbering {
        LinuxCnc = "linuxcnc",
        Common = "common",
    }

    /// Along what the lead of a thread is measured on a line along both axes.
    pub enum LeadAlong {
        Path = "path",
        Axis = "axis",
    }

    /// How a length across the axis is measured.
    pub enum Measure {
        Radius = "radius",
        Diameter = "diameter",
    }

    /// The purpose of a word of a control.
    pub enum Use {
        Plane = "plane",
        Millimetres = "millimetres",
        Diameters = "diameters",
        RadiusCorrectionOff = "radius-correction-off",
        Absolute = "absolute",
        FeedPerRevolution = "feed-per-revolution",
        System = "system",
        ExactPath = "exact-path",
        Tool = "tool",
        ToolOfOffset = "tool-of-offset",
        CuttingSpeed = "cutting-speed",
        SpindleSpeed = "spindle-speed",
        CoolantOn = "coolant-on",
        Rapid = "rapid",
        Line = "line",
        Clockwise = "clockwise",
        Counterclockwise = "counterclockwise",
        SpindleStop = "spindle-stop",
        CoolantOff = "coolant-off",
        Stop = "stop",
        End = "end",
        ContourBegins = "contour-begins",
        ContourEnds = "contour-ends",
        ChangePosition = "change-position",
        ChangePositionX = "change-position-x",
        ChangePositionZ = "change-position-z",
        SpeedLimit = "speed-limit",
        Thread = "thread",
        ThreadLead = "thread-lead",
        TapBegins = "tap-begins",
        Tap = "tap",
        TapEnds = "tap-ends",
        ProgramBegins = "program-begins",
        ThreadCycleFirst = "thread-cycle-first",
        ThreadCycle = "thread-cycle",
    }
}

impl Use {
    /// Whether every control must have it.
    pub const fn is_required(self) -> bool {
        use Use::{Absolute, ContourBegins, ContourEnds, Diameters, ExactPath, Plane, ProgramBegins, SpeedLimit};
        use Use::{Tap, TapBegins, TapEnds, ThreadCycle, ThreadCycleFirst};
        let often = matches!(self, SpeedLimit | ExactPath | Plane | Diameters | Absolute);
        let of_subprograms = matches!(self, ContourBegins | ContourEnds | ProgramBegins);
        let of_cycles = matches!(self, Tap | TapBegins | TapEnds | ThreadCycleFirst | ThreadCycle);
        !often && !of_subprograms && !of_cycles
    }
}

rows! {
    /// Controls of lathes.
    pub struct LatheControls of One("lathe-controls") complete control {
        control: LatheControl,
        plain: bool,
        cycles: bool,
        ending: Option<&'t str>,
        point: Option<bool>,
        comment: Option<&'t str>,
        tip_numbering: Option<TipNumbering>,
        lead_along: Option<LeadAlong>,
        read_as: Option<LatheReader>,
        known_words: Option<Vec<&'t str>>,
    } shown { version }

    /// Fields of roughing cycles.
    pub struct LatheCycleFields of One("lathe-cycle-fields") {
        control: LatheControl,
        place_in_call: i64,
        field: &'t str,
        holds: FieldContent,
        measure: Option<Measure>,
    } shown { unit_of_field, meaning_uk, meaning_en }

    /// Roughing cycles of lathes.
    pub struct LatheCycles of One("lathe-cycles") {
        control: LatheControl,
        direction: Direction,
        side: Side,
        cycle: &'t str,
        machining: Option<i64>,
    }

    /// Positions of the tip of a tool, from the centre of its nose.
    pub struct LatheTipPlaces of One("lathe-tip-places") {
        numbering: TipNumbering,
        radial: i64,
        axial: i64,
        number: i64,
    }

    /// Words of programs for lathes.
    pub struct LatheWords of One("lathe-words") {
        control: LatheControl,
        use_ as "use": Use,
        word: &'t str,
    } shown { meaning_uk, meaning_en }
}
