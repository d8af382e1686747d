//! Row types: lathes.

use technolog_knowledge::contract::{Named, Use};
use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// The quantities of a lathe's record that planning of turning uses.
    pub enum LatheQuantity {
        SpindleSpeeds = "spindle-speeds",
        SpindleSpeedMin = "spindle-speed-min",
        SpindleSpeedMax = "spindle-speed-max",
        SpindlePower = "spindle-power",
        SpindleEfficiency = "spindle-efficiency",
        SpindleTorqueMax = "spindle-torque-max",
        DiameterOverBed = "diameter-over-bed",
        DiameterOverCarriage = "diameter-over-carriage",
        LengthBetweenCentres = "length-between-centres",
        BarHole = "bar-hole",
        FeedMinZ = "feed-min-z",
        FeedMaxZ = "feed-max-z",
        FeedMinX = "feed-min-x",
        FeedMaxX = "feed-max-x",
        RapidZ = "rapid-z",
        FeedForceZ = "feed-force-z",
        FeedForceX = "feed-force-x",
        CuttingForceMax = "cutting-force-max",
        TurretPlaces = "turret-places",
        ShankHeight = "shank-height",
        ToolChangeTime = "tool-change-time",
        ItOuter = "it-outer",
        ItInner = "it-inner",
        ItFace = "it-face",
        RaBest = "ra-best",
    }

    /// A figure of chuck and tailstock.
    pub enum WorkholdingFigure {
        ChuckDiameterShare = "chuck-diameter-share",
        JawShare = "jaw-share",
        JawGripShare = "jaw-grip-share",
        CentreAngle = "centre-angle",
        CentreBody = "centre-body",
        CentreClearance = "centre-clearance",
        CentreOut = "centre-out",
        QuillShare = "quill-share",
        JawFriction = "jaw-friction",
        JawFrictionSoft = "jaw-friction-soft",
        GripSafety = "grip-safety",
        ChuckForce = "chuck-force",
        ChuckSpeed = "chuck-speed",
        ChuckLoss = "chuck-loss",
        ToolChangeTime = "tool-change-time",
        SpindleStartTime = "spindle-start-time",
        LoadTime = "load-time",
        JawWidthShare = "jaw-width-share",
        FullGripArc = "full-grip-arc",
        UnsaidGrade = "unsaid-grade",
        WallKeepsShape = "wall-keeps-shape",
    }
}

rows! {
    /// The quantities a lathe's catalog must name.
    pub struct LatheQuantities of One("lathe-quantities") complete name {
        name: Named<'t, LatheQuantity>,
        use_ as "use": Use,
    } shown { unit, required }

    /// Chuck and tailstock where the record of a lathe has none.
    pub struct LatheWorkholding of One("chuck-and-tailstock") complete name {
        name: Named<'t, WorkholdingFigure>,
        value: f64,
    } shown { used }

    /// A characteristic of a lathe. The law `record` has checked its unit.
    pub struct LatheRecord of Record("lathe-quantities") {
        name: Named<'t, LatheQuantity>,
        value: Option<Vec<f64>>,
    } shown { unit, text }
}
