//! The language of ISO 6983 as each control reads it: a record for each, and the tables of its words.

use technolog_knowledge::contract::{Named, Use};
use technolog_knowledge::{Knowledge, KnowledgeError, Table, rows, vocabulary};

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
        /// What X counts.
        Diameter = "diameter",
    }

    /// The effect of a G function.
    pub enum Effect {
        Mode = "mode",
        Cycle = "cycle",
        CycleOff = "cycle-off",
        Dwell = "dwell",
        Return = "return",
        MachinePosition = "machine-position",
        /// A length offset by the value of Z, which moves nothing.
        OffsetValue = "offset-value",
        /// A length offset that is added to the one in force.
        OffsetAdded = "offset-added",
        /// Zeros and lengths of tools are set.
        Data = "data",
        /// A zero beside that of the system.
        LocalZero = "local-zero",
        /// A zero by the present place.
        Shift = "shift",
        ShiftOff = "shift-off",
        ShiftWaits = "shift-waits",
        ShiftAgain = "shift-again",
        Noted = "noted",
    }

    /// The action of the control for an M function.
    pub enum Action {
        Stop = "stop",
        OptionalStop = "optional-stop",
        End = "end",
        Return = "return",
        Call = "call",
        /// Of the blocks from a number on.
        CallLocal = "call-local",
        SpindleClockwise = "spindle-clockwise",
        SpindleCounterclockwise = "spindle-counterclockwise",
        SpindleStop = "spindle-stop",
        ToolChange = "tool-change",
        /// The tool in the spindle is named.
        ToolNamed = "tool-named",
        /// Modes are kept, forgotten, brought back, kept for the end of the subprogram.
        KeepModes = "keep-modes",
        ForgetModes = "forget-modes",
        BringModes = "bring-modes",
        KeepForReturn = "keep-for-return",
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
        /// It stops at an angle, and the bar is drawn off the wall before it goes out.
        Oriented = "oriented",
    }

    /// The motion of a cycle out of the hole.
    pub enum Outwards {
        Rapid = "rapid",
        /// At feed to R, at rapid from there.
        Feed = "feed",
        FeedToTheEnd = "feed-to-the-end",
    }

    /// The characteristics of a control in its record, whose meanings `iso-control-quantities` has. Of those that are yes
    /// or no, yes is 1 and no is 0; where the record does not name one, it is 0.
    pub enum Characteristic {
        SubprogramDepthMax = "subprogram-depth-max",
        Correctors = "correctors",
        FeedOverride = "feed-override",
        SpindleOverride = "spindle-override",
        MFunctionsPerBlockMax = "m-functions-per-block-max",
        DwellUnit = "dwell-unit",
        ArcTolerance = "arc-tolerance",
        ArcToleranceRelative = "arc-tolerance-relative",
        G83Clearance = "g83-clearance",
        G73Retract = "g73-retract",
        WordsOf = "words-of",
        BlockEnd = "block-end",
        WordsInSmallLetters = "words-in-small-letters",
        OWords = "o-words",
        ReadsFromSign = "reads-from-sign",
        SkipNumbers = "skip-numbers",
        DecimalOfSetting = "decimal-of-setting",
        CyclesAreMotions = "cycles-are-motions",
        OneOfGroup = "one-of-group",
        PathTolerance = "path-tolerance",
        DwellInX = "dwell-in-x",
        DwellPointInSeconds = "dwell-point-in-seconds",
        LengthOfToolInSpindle = "length-of-tool-in-spindle",
        MachinePositionAtRapid = "machine-position-at-rapid",
        ReturnAlone = "return-alone",
        ReturnOfAllAxes = "return-of-all-axes",
        ReturnNumber = "return-number",
        ArcTurns = "arc-turns",
        ArcCentresAsSet = "arc-centres-as-set",
        ArcNamesEnd = "arc-names-end",
        PecksOfSetting = "pecks-of-setting",
        CycleBeginsAnew = "cycle-begins-anew",
        CycleNeedsAxes = "cycle-needs-axes",
        CycleRises = "cycle-rises",
        CyclesInEveryPlane = "cycles-in-every-plane",
        RepeatsInL = "repeats-in-l",
        RepeatsNone = "repeats-none",
        RepeatsInP = "repeats-in-p",
        TapTurnsBeforeDwell = "tap-turns-before-dwell",
        Signs = "signs",
        ProgramNumberDigits = "program-number-digits",
        PointsWritten = "points-written",
        MFunctionsWritten = "m-functions-written",
        LengthOffOnWayUp = "length-off-on-way-up",
        TapPreparation = "tap-preparation",
        TapStartsSpindle = "tap-starts-spindle",
        MacroWords = "macro-words",
        ChangeStopsSpindle = "change-stops-spindle",
        ChangeByBuilder = "change-by-builder",
        RadiusOnALine = "radius-on-a-line",
        RadiusByRegister = "radius-by-register",
        RoundsUnlike = "rounds-unlike",
        EndCancelsRadius = "end-cancels-radius",
        ChangeWithdraws = "change-withdraws",
        StopStopsSpindle = "stop-stops-spindle",
        StopLeavesSpindle = "stop-leaves-spindle",
        LengthsInOffsets = "lengths-in-offsets",
        ArcCentreInPlane = "arc-centre-in-plane",
        ToolTakenOut = "tool-taken-out",
        ArcToleranceInches = "arc-tolerance-inches",
        ArcReach = "arc-reach",
        LocalParameters = "local-parameters",
        FreeParameters = "free-parameters",
    }
}

rows! {
    /// Addresses of the ISO controls.
    pub struct Addresses of One("iso-addresses") {
        address: Letter,
        controls: Vec<&'t str>,
        kind: Written,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Fixed cycles of the ISO controls.
    pub struct Cycles of One("iso-cycles") {
        code: &'t str,
        controls: Vec<&'t str>,
        required: Vec<Letter>,
        optional_words: Option<Vec<Letter>>,
        inwards: Inwards,
        bottom: Bottom,
        outwards: Outwards,
    }

    /// G functions of the ISO controls.
    pub struct GFunctions of One("iso-g-functions") {
        code: &'t str,
        controls: Vec<&'t str>,
        group: Group,
        power_on: Option<Vec<&'t str>>,
        effect: Effect,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// M functions of the ISO controls.
    pub struct MFunctions of One("iso-m-functions") {
        code: &'t str,
        controls: Vec<&'t str>,
        action: Action,
        group: MGroup,
        acts: Acts,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Comments that the control executes.
    pub struct ActiveComments of One("iso-active-comments") {
        begins: &'t str,
        controls: Vec<&'t str>,
        acts: CommentAct,
        after_semicolon: Option<bool>,
        whole: Option<bool>,
    } shown { meaning_uk, meaning_en }

    /// Words of the ISO controls that the check does not carry out, and what it passes over with them.
    pub struct NotCarriedOut of One("iso-not-carried-out") {
        word: &'t str,
        last: Option<&'t str>,
        controls: Vec<&'t str>,
        takes: Option<Vec<Letter>>,
        named_by: Option<Letter>,
        whole: Option<bool>,
        goes_on: Option<bool>,
        harmless: Option<bool>,
        as_written: Option<bool>,
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

    /// The characteristics that the record of a control may name.
    pub struct Quantities of One("iso-control-quantities") complete name {
        name: Named<'t, Characteristic>,
        use_ as "use": Use,
    } shown { unit, required, meaning_uk, meaning_en }

    /// A characteristic of a control. The law `record` has checked its unit.
    pub struct Record of Record("iso-control-quantities") {
        name: Named<'t, Characteristic>,
        value: Option<Vec<f64>>,
        text: Option<&'t str>,
    } shown { unit }
}

/// The first word of the ids of records.
const ID: &str = "control-";

impl<'k> Record<'k> {
    /// The controls that have a record.
    pub fn names(knowledge: &'k Knowledge) -> impl Iterator<Item = &'k str> {
        knowledge.tables_of::<Self>().filter_map(|table| table.id.strip_prefix(ID))
    }

    /// The table of a control.
    ///
    /// # Errors
    /// It has none.
    pub fn table(control: &str, knowledge: &'k Knowledge) -> Result<&'k Table, KnowledgeError> {
        Ok(knowledge.table(&format!("{ID}{control}"))?)
    }

    /// The text of a characteristic of a control, where its record has one.
    ///
    /// # Errors
    /// It has no record.
    pub fn text(
        control: &str,
        name: Characteristic,
        knowledge: &'k Knowledge,
    ) -> Result<Option<&'k str>, KnowledgeError> {
        let record: Vec<Self> = Self::table(control, knowledge)?.rows().collect::<Result<_, _>>()?;
        Ok(record.iter().find(|row| row.name.is(name)).and_then(|row| row.text))
    }
}
