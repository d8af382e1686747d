//! Row types: holes.

use technolog_knowledge::units::{ItGrade, Micrometres, Microns, Percent, Roughness};
use technolog_knowledge::vocabulary::Operation;
use technolog_knowledge::{Knowledge, KnowledgeError, rows, vocabulary};

use crate::rules::BlankState;

vocabulary! {
    /// A kind of hole of A.4.
    pub enum ComplexGroup {
        Counterbored = "counterbored",
        Smooth = "smooth",
        Countersunk = "countersunk",
        Threaded = "threaded",
        Precise = "precise",
    }

    /// A kind of hole of A.6.
    pub enum StagedHole {
        Counterbored = "counterbored-cylindrical",
        Countersunk = "countersunk",
        Threaded = "threaded",
        Plain = "plain",
    }

    /// The permitted position of the axis compared with the accuracy of the machine.
    pub enum PositionAsked {
        Above = "above",
        NotAbove = "not-above",
    }

    /// A stage of A.6.
    pub enum Stage {
        FinishHere = "finish-nc",
        RoughHere = "rough-nc",
        FinalElsewhere = "final-other",
    }

    /// A kind of hole of A.10.
    pub enum AuxiliaryHole {
        ThreadCylindrical = "thread-cylindrical",
        ThreadConical = "thread-conical",
        Counterbore = "counterbore",
        Countersink90 = "countersink-90",
        CountersinkOther = "countersink-other",
    }

    /// A method of drilling, for the position of the axis.
    pub enum DrillingWay {
        WithoutCentring = "drilling-without-centring",
        WithCentring = "drilling-with-centring",
        IntoRoughFace = "drilling-from-unmachined-cast-face",
    }

    /// A convention on holes. A name says its unit where it has one.
    pub enum HoleDefault {
        FreeSizeGrade = "free-size-grade",
        SmallestDiameter = "smallest-diameter-mm",
        LargestDiameter = "largest-diameter-mm",
        LargestOpened = "largest-opened-diameter-mm",
        ThreadHoleGrade = "thread-hole-grade",
        SettingStep = "setting-step-mm",
        ClampInset = "clamp-inset-mm",
        ClampSideShare = "clamp-side-share",
        ThreadChamferPitches = "thread-chamfer-pitches",
        CounterboreRa = "counterbore-ra-um",
        FaceStock = "face-stock-mm",
        CutterGrindLimit = "cutter-grind-limit-mm",
        MillCoreShare = "mill-core-share",
        EdgeClearance = "edge-clearance-mm",
        ReamerLeastShare = "reamer-least-share",
        CoreDrillLeastShare = "core-drill-least-share",
        ClampSetsTried = "clamp-sets-tried",
        ClampPairsCombined = "clamp-pairs-combined",
        FinestBoughtGrade = "finest-bought-grade",
        CoarsestBoughtGrade = "coarsest-bought-grade",
        CutterGrindShare = "cutter-grind-share",
        MillClearance = "mill-clearance-mm",
        MilledRoundnessShare = "milled-roundness-share",
        ReamerLeadShare = "reamer-lead-share",
        TapClampDiameters = "tap-clamp-diameters",
        ThreadRunoutPitches = "thread-runout-pitches",
        TapLeadPitches = "tap-lead-pitches",
        BottomingTapLeadPitches = "bottoming-tap-lead-pitches",
        LeastStockDrillOut = "least-stock-drill-out-mm",
        LeastStockCoreDrill = "least-stock-core-drill-mm",
        LeastStockMill = "least-stock-mill-mm",
        LeastFeedPerTooth = "least-feed-per-tooth-mm",
        FloorClearance = "floor-clearance-mm",
        FloorMillShare = "floor-mill-share",
        FlatFloorGap = "flat-floor-gap-mm",
        ReamerChipRoom = "reamer-chip-room-mm",
        NearTieShare = "near-tie-share",
        FinestCentres = "finest-centres-mm",
    }
}

rows! {
    /// Accuracy and roughness of cylindrical holes by method (A.1).
    pub struct HoleAccuracy of One("A.1") {
        no: i64,
        it_finest: Option<ItGrade>,
        it_coarsest: Option<ItGrade>,
        ra_coarsest: Microns,
        ra_finest: Microns,
    } shown { blank, method, method_uk }

    /// Accuracy and roughness of milled planes (A.2).
    pub struct PlaneAccuracy of One("A.2") {
        method: &'t str,
        it_coarsest: ItGrade,
        it_finest: ItGrade,
        ra_coarsest: Microns,
        ra_finest: Microns,
    } shown { no }

    /// Accuracy and roughness of threads (A.3).
    pub struct ThreadAccuracy of One("A.3") {
        method: Operation,
        ra_coarsest: Microns,
        ra_finest: Microns,
    } shown { thread_grade }

    /// Complexes of transitions for a hole (A.4).
    pub struct ComplexesOfHole of One("A.4") asked by ComplexesOfHoleFor {
        hole: ComplexGroup,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
    } {
        complex: Vec<&'t str>,
    } shown { group }

    /// The transitions of a complex (A.5).
    pub struct Complex of One("A.5") {
        complex: i64,
        transitions: Vec<Operation>,
    } shown {
        tools,
        centre_drilling,
        drilling,
        core_drilling,
        counterboring,
        chamfering,
        rough_reaming,
        finish_reaming,
        tapping,
    }

    /// Route of a hole by stages (A.6).
    pub struct RouteStages of One("A.6") asked by RouteStagesFor {
        hole: StagedHole,
        it: ItGrade,
        diameter: Micrometres,
        position: PositionAsked,
    } {
        stages: Vec<Stage>,
    }

    /// A scheme of hole machining (A.7).
    pub struct Scheme of One("A.7") {
        scheme: &'t str,
        transitions: Vec<Operation>,
    } shown {
        centre_drilling,
        drilling,
        milling,
        boring_4,
        core_drilling,
        boring_6,
        chamfering,
        boring_8,
        counterboring,
        boring_10,
        rough_reaming,
        finish_reaming,
        tapping,
    }

    /// Schemes for main holes: A.8 for IT 6 to 10, A.9 for 11, 13 and coarser.
    pub struct SchemesOfMainHole of Each(&["A.8", "A.9"]) asked by SchemesOfMainHoleFor {
        it: ItGrade,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
        roughness: Roughness,
        state: BlankState,
        outer_wall: bool,
    } {
        schemes: Vec<&'t str>,
        finish_elsewhere: Option<bool>,
        if_drill_differs: Option<Vec<&'t str>>,
    }

    /// Schemes for auxiliary holes (A.10).
    pub struct SchemesOfAuxiliaryHole of One("A.10") asked by SchemesOfAuxiliaryHoleFor {
        hole: AuxiliaryHole,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
    } {
        schemes: Vec<&'t str>,
        if_drill_differs: Option<Vec<&'t str>>,
    }

    /// An allowance of hole machining, on diameter.
    pub struct Allowance of One("allowances") {
        name: &'t str,
        minimum: Option<Micrometres>,
        maximum: Option<Micrometres>,
        share: Option<f64>,
    }

    /// Core drills No.1 before reaming.
    pub struct CoreDrillBeforeReaming of One("core-drill-before-reaming") {} shown { hole_diameter, diameter }

    /// Undersize of core drill No.1.
    pub struct CoreDrillUndersize of One("core-drill-undersize") {} shown { diameter, undersize }

    /// The first drill of two-pass drilling: its diameter as a share of the second one's.
    pub struct FirstDrill of One("first-drill") {
        share_min: f64,
        share_max: f64,
    } shown { name, above_diameter }

    /// A convention on holes.
    pub struct HoleConvention of One("hole-defaults") complete name {
        name: HoleDefault,
        value: f64,
    }

    /// Position accuracy of drilled holes: an error, or a loss of accuracy.
    pub struct PositionAccuracy of One("position-accuracy") complete name {
        name: DrillingWay,
        maximum: Option<Micrometres>,
        loss_max: Option<Percent>,
    } shown { minimum, loss_min }

    /// Step diameters of H7 holes in solid metal.
    pub struct StepDiameters of One("step-diameters") {
        diameter: Micrometres,
        drill_1: Micrometres,
        drill_2: Option<Micrometres>,
        bore: Option<Micrometres>,
        core_drill: Option<Micrometres>,
        rough_ream: Option<Micrometres>,
    }

    /// Accuracy and roughness of a single transition.
    pub struct TransitionAccuracy of One("transition-accuracy") {
        operation: &'t str,
        it_coarsest: ItGrade,
        it_finest: ItGrade,
        ra_coarsest: Microns,
        ra_finest: Microns,
        prepares: Option<Vec<Operation>>,
    }
}

impl<'k> HoleConvention<'k> {
    /// The row of a convention.
    ///
    /// # Errors
    /// The knowledge base lacks it.
    pub fn of(name: HoleDefault, knowledge: &'k Knowledge) -> Result<Self, KnowledgeError> {
        knowledge.need(name.name(), |row: &Self| row.name == name)
    }
}
