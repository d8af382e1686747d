//! Row types: machines.

use technolog_knowledge::contract::{Named, Use};
use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// The quantities of a machine's record that planning, programs and audits use.
    pub enum MachineQuantity {
        SpindleSpeeds = "spindle-speeds",
        SpindlePower = "spindle-power",
        SpindleTorqueMax = "spindle-torque-max",
        SpindleTaper = "spindle-taper",
        FeedMin = "feed-min",
        FeedMax = "feed-max",
        RapidRate = "rapid-rate",
        RapidAcceleration = "rapid-acceleration",
        TravelX = "travel-x",
        TravelY = "travel-y",
        TravelZ = "travel-z",
        TravelMiddleX = "travel-middle-x",
        TravelMiddleY = "travel-middle-y",
        TableLength = "table-length",
        TableWidth = "table-width",
        TSlots = "t-slots",
        /// The width of its T-slots, mm.
        TSlotWidth = "t-slot-width",
        NoseToTableMin = "nose-to-table-min",
        NoseToTableMax = "nose-to-table-max",
        SpindleToColumn = "spindle-to-column",
        ThrustZMax = "thrust-z-max",
        LoadMassMax = "load-mass-max",
        MagazinePlaces = "magazine-places",
        ToolChangeTime = "tool-change-time",
        ToolChangeX = "tool-change-x",
        ToolChangeY = "tool-change-y",
        ToolChangeZ = "tool-change-z",
        ToolMassMax = "tool-mass-max",
        FaceMillDiameterMax = "face-mill-diameter-max",
        EndMillDiameterMax = "end-mill-diameter-max",
        DrillDiameterMax = "drill-diameter-max",
        ToolOverhangMax = "tool-overhang-max",
        PositionAccuracy = "position-accuracy",
        RoundnessAccuracy = "roundness-accuracy",
        Resolution = "resolution",
        CanTap = "can-tap",
        Control = "control",
        Contouring = "contouring",
        /// Whether its tools are changed wherever its table stands.
        ChangeAnywhere = "tool-change-anywhere",
        /// Whether its spindle has no steps.
        SpindleStepless = "spindle-stepless",
        MinuteRate = "minute-rate",
    }
}

rows! {
    /// The quantities a machine's catalog must name.
    pub struct MachineQuantities of One("machine-quantities") complete name {
        name: Named<'t, MachineQuantity>,
        use_ as "use": Use,
    } shown { unit, required }

    /// A characteristic of a machine. The law `record` has checked its unit.
    pub struct MachineRecord of Record("machine-quantities") {
        name: Named<'t, MachineQuantity>,
        value: Option<Vec<f64>>,
        unit: Option<&'t str>,
        text: Option<&'t str>,
    }
}
