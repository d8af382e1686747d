//! Words and cycles of programs for lathes, as they are read back.

use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// Controls of lathes whose programs are read.
    pub enum LatheReader {
        /// LinuxCNC 2.9.
        LinuxCnc = "linuxcnc-lathe",
        /// Fanuc 0i-TF, G codes of system A.
        Fanuc = "fanuc-lathe",
        /// Sinumerik 840D, 810D, 802D.
        Sinumerik = "sinumerik",
    }

    /// Groups of modal functions; one function of each is in force.
    pub enum LatheGroup {
        OneShot = "one-shot",
        Motion = "motion",
        Plane = "plane",
        Units = "units",
        Measure = "measure",
        Distance = "distance",
        Compensation = "compensation",
        FeedMode = "feed-mode",
        SpeedMode = "speed-mode",
        System = "system",
        Length = "length",
        Machine = "machine",
        Free = "free",
    }

    /// The block of a cycle, where it has several.
    pub enum Form {
        One = "one",
        First = "first",
        Second = "second",
    }

    /// The effect of a word.
    pub enum WordEffect {
        Rapid = "rapid",
        Line = "line",
        Clockwise = "clockwise",
        Counterclockwise = "counterclockwise",
        Thread = "thread",
        Dwell = "dwell",
        PlaneZx = "plane-zx",
        OtherPlane = "other-plane",
        Millimetres = "millimetres",
        Inches = "inches",
        Diameters = "diameters",
        DiametersAbsolute = "diameters-absolute",
        Radii = "radii",
        Absolute = "absolute",
        Incremental = "incremental",
        CompensationOff = "compensation-off",
        CompensationLeft = "compensation-left",
        CompensationRight = "compensation-right",
        PerMinute = "per-minute",
        PerRevolution = "per-revolution",
        CuttingSpeed = "cutting-speed",
        SpindleSpeed = "spindle-speed",
        SpeedLimit = "speed-limit",
        System = "system",
        Offset = "offset",
        OffsetOff = "offset-off",
        MachinePosition = "machine-position",
        Away = "away",
        RoughAlong = "rough-along",
        RoughAcross = "rough-across",
        Finish = "finish",
        ThreadCycle = "thread-cycle",
        ThreadBox = "thread-box",
        TurnBox = "turn-box",
        FaceBox = "face-box",
        PeckAlong = "peck-along",
        PeckAcross = "peck-across",
        Tap = "tap",
        CycleOff = "cycle-off",
        SpindleClockwise = "spindle-clockwise",
        SpindleCounterclockwise = "spindle-counterclockwise",
        SpindleStop = "spindle-stop",
        ToolChange = "tool-change",
        CoolantOn = "coolant-on",
        CoolantOff = "coolant-off",
        Stop = "stop",
        Call = "call",
        Return = "return",
        End = "end",
        Nothing = "nothing",
        NotCarriedOut = "not-carried-out",
    }
}

rows! {
    /// Functions of controls of lathes.
    pub struct LatheFunctions of One("lathe-functions") {
        code: &'t str,
        controls: Vec<LatheReader>,
        group: LatheGroup,
        does: WordEffect,
        power_on: Option<Vec<LatheReader>>,
        must_be_said: Option<Vec<LatheReader>>,
    } shown { meaning_uk, meaning_en }

    /// The words of the cycles of lathes.
    pub struct LatheReadCycles of One("lathe-read-cycles") {
        control: LatheReader,
        cycle: &'t str,
        form: Form,
        fields: Vec<&'t str>,
        required: Vec<&'t str>,
    }
}
