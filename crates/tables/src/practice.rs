//! Row types: shop practice, whatever a drawing requires.

use technolog_knowledge::contract::Named;
use technolog_knowledge::units::{
    Brinell, ItGrade, Kilograms, Megapascals, MetresPerMinute, Micrometres, Microns, MillimetresPerRev, Seconds,
};
use technolog_knowledge::{rows, vocabulary};

use crate::rules::ReamingCase;

vocabulary! {
    /// What practice has feeds for.
    pub enum PracticeWork {
        Drill = "drill",
        CoreDrill = "core-drill",
        Ream = "ream",
        FinishBore = "finish-bore",
        RoughBore = "rough-bore",
    }
}

vocabulary! {
    /// What a part is clamped by when it is loaded.
    pub enum LoadedBy {
        /// Straps on the table.
        Straps = "straps",
        /// A vice.
        Vice = "vice",
        /// A three-jaw chuck on the table, with its key.
        Chuck = "chuck",
    }

    /// A figure of `time-norms`.
    pub enum TimeNorm {
        /// Order, papers, program and tools are received, min a lot.
        ReceiveOrder = "receive-order",
        /// Papers are read, min a lot.
        StudyOrder = "study-order",
        /// The foreman instructs, min a lot.
        Instruction = "instruction",
        /// The machine is set with its first tools, min a lot.
        SetUp = "set-up",
        /// Soft jaws are put on and bored, min a lot.
        SoftJaws = "soft-jaws",
        /// How many tools are in that time.
        SetUpTools = "set-up-tools",
        /// A further tool, min a lot.
        Tool = "tool",
        /// The zero of a set-up, min a lot.
        Zeros = "zeros",
        /// A clamp beyond three, min a piece.
        MoreClamp = "more-clamp",
        /// A plug in a hole of grade 11 and coarser, min.
        PlugCoarse = "plug-coarse",
        /// A plug in a finer hole, min.
        PlugFine = "plug-fine",
        /// A plug in a thread, min.
        ThreadPlug = "thread-plug",
        /// Looking after the place of work, % of the time at work.
        Service = "service",
        /// Rest and needs, % of the time at work.
        Rest = "rest",
    }
}

impl TimeNorm {
    /// The plug that gauges a hole of a grade.
    pub fn plug(grade: ItGrade) -> Self {
        /// The finest grade of the coarse plugs of the table.
        const COARSE: u8 = 11;
        if grade.number() >= COARSE { Self::PlugCoarse } else { Self::PlugFine }
    }

    /// The unit of its value, as the table writes it.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::SetUpTools => "1",
            Self::Service | Self::Rest => "%",
            _ => "min",
        }
    }
}

rows! {
    /// Norms of time for an operation of an NC machine.
    pub struct TimeNorms of One("time-norms") complete name {
        name: TimeNorm,
        value: f64,
        unit: &'t str,
    }

    /// Time to load, clamp and unload a part.
    pub struct LoadingTime of One("loading-time") asked by LoadingTimeFor {
        held: LoadedBy,
        mass: Kilograms,
    } {
        time: Seconds,
    }

    /// The accuracy of a method on an ordinary machine tool.
    pub struct ReachOfTransition of One("reach-of-transition") asked by ReachOfTransitionFor<'t> {
        way: &'t str,
        diameter: Micrometres,
    } {
        it_best: Option<ItGrade>,
        it_ordinary: Option<ItGrade>,
        ra_best: Microns,
        ra_ordinary: Microns,
    } shown { thread_best, thread_ordinary, sources }

    /// Position error of the axis by method.
    pub struct HolePositionReach of One("hole-position-reach") asked by HolePositionReachFor<'t> {
        way: &'t str,
    } {
        follows: bool,
        error_best: Option<Micrometres>,
        error_ordinary: Option<Micrometres>,
    }

    /// Drift of the axis of a drilled hole.
    pub struct DrillDrift of One("drill-drift") asked by DrillDriftFor {
        diameter: Micrometres,
    } {
        drift: f64,
    } shown { offset }

    /// Stock before reaming, on diameter.
    pub struct StockBeforeReaming of One("stock-before-reaming") asked by StockBeforeReamingFor {
        case: ReamingCase,
        diameter: Micrometres,
    } {
        stock_min: Micrometres,
        stock_max: Micrometres,
    } shown { american_min, american_max, european_min, european_max, soviet_min, soviet_max, pages }

    /// Rows of the shop tables for a material grade.
    pub struct PracticeGroup of One("practice-group") asked by PracticeGroupFor<'t> {
        material: &'t str,
        hardness: Brinell,
    } {
        group: &'t str,
        vdi: i64,
        drill_force: Option<&'t str>,
    }

    /// Speeds of high-speed steel tools in practice.
    pub struct HssSpeed of One("practice-speed-hss") asked by HssSpeedFor<'t> {
        operation: HssWork,
        group: &'t str,
    } {
        speed_low: MetresPerMinute,
        speed: MetresPerMinute,
        speed_high: MetresPerMinute,
    } shown { pages }

    /// Speeds of carbide tools in practice.
    pub struct CarbideSpeed of One("practice-speed-carbide") asked by CarbideSpeedFor<'t> {
        operation: CarbideWork,
        coating: Coating,
        cut: RoughOrFinish,
        group: &'t str,
    } {
        speed_low: MetresPerMinute,
        speed_high: MetresPerMinute,
    } shown { pages }

    /// Speeds of taps in practice.
    pub struct TapSpeed of One("practice-speed-tap") asked by TapSpeedFor<'t> {
        group: &'t str,
    } {
        speed_low: MetresPerMinute,
        speed_high: MetresPerMinute,
    } shown { clarkson_low, clarkson_high, sutton_low, sutton_high, pages }

    /// Share of the speed of drilling or turning.
    pub struct SpeedShare of One("practice-speed-share") asked by SpeedShareFor {
        operation: SharedWork,
    } {
        share_low: f64,
        share: f64,
        share_high: f64,
    } shown { of, pages }

    /// Material constants for the forces of drilling.
    pub struct DrillForceFactor of One("drill-force-factor") {
        id: &'t str,
        factor: f64,
    } shown { strength, hardness, name_uk, name_en }

    /// Constants of the formulas of drilling forces.
    pub struct DrillForceFormula of One("drill-force-formula") complete name {
        name: Named<'t, ForceConstant>,
        value: f64,
    } shown { used }

    /// The oversize of a drilled hole.
    pub struct DrillOversize of One("drill-oversize") asked by DrillOversizeFor {
        diameter: Micrometres,
    } {
        oversize_mean: Micrometres,
    } shown {
        oversize_largest, mean_american, largest_american, mean_soviet, largest_standard,
    }

    /// Specific cutting forces.
    pub struct SpecificCuttingForce of One("specific-cutting-force") asked by SpecificCuttingForceFor {
        vdi: i64,
    } {
        kc1: Megapascals,
        mc: f64,
    } shown { strength, hardness, what_uk, what_en }

    /// Limits of the proof of plans.
    pub struct ProofLimits of One("proof-limits") complete name {
        name: Named<'t, ProofLimit>,
        value: f64,
    } shown { used }

    /// Feeds in practice.
    pub struct PracticeFeed of One("practice-feed") asked by PracticeFeedFor<'t> {
        operation: PracticeWork,
        material_group: &'t str,
        diameter: Micrometres,
    } {
        feed_low: MillimetresPerRev,
        feed: Option<MillimetresPerRev>,
        feed_high: MillimetresPerRev,
    } shown { pages }

    /// The pages of the tables of practice.
    pub struct PracticeSource of One("practice-sources") {
        id: &'t str,
        page: &'t str,
    } shown { read }

    /// The sources that facts name by letters.
    pub struct FactSource of One("fact-sources") {
        id: &'t str,
        page: &'t str,
    } shown { read }

    /// The accuracy of a method by each source.
    pub struct ReachBySource of One("reach-by-source") {} shown {
        way, of, it_coarsest, it_finest, ra_coarsest, ra_finest,
    }

    /// The sources of accuracies.
    pub struct ReachSource of One("reach-sources") {
        id: &'t str,
        page: &'t str,
    } shown { tradition, read }
}

vocabulary! {
    /// A constant of the formulas of drilling forces.
    pub enum ForceConstant {
        Thrust = "thrust-constant",
        ThrustFeedExponent = "thrust-feed-exponent",
        Torque = "torque-constant",
        TorqueFeedSlope = "torque-feed-slope",
    }

    /// A limit of the proof of plans.
    pub enum ProofLimit {
        BarOverhangRatio = "bar-overhang-ratio",
        BarElasticModulus = "bar-elastic-modulus",
        CarbideBarOverhangRatio = "carbide-bar-overhang-ratio",
        DampedBarOverhangRatio = "damped-bar-overhang-ratio",
        CarbideBarElasticModulus = "carbide-bar-elastic-modulus",
        BarRadialShare = "bar-radial-share",
        SpeedOverPractice = "speed-over-practice",
        DrillSection = "drill-section",
        DrillColumn = "drill-column",
        DrillBucklingShare = "drill-buckling-share",
        DrillFluteRoom = "drill-flute-room",
        DrillFluteRoomPecked = "drill-flute-room-pecked",
        HolderOverFace = "holder-over-face",
        SemiFinishBoreStock = "semi-finish-bore-stock",
        FinishBoreStock = "finish-bore-stock",
        LeastFloor = "least-floor",
        LeastFloorShare = "least-floor-share",
        CoreDrillLips = "core-drill-lips",
        ChiselCone = "chisel-cone",
        PilotLengthDiameters = "pilot-length-diameters",
        ShortestPilot = "shortest-pilot",
        HardestForSteel = "hardest-for-high-speed-steel",
        HardForSteel = "hard-for-high-speed-steel",
        LeastWall = "least-wall",
        LeastWallShare = "least-wall-share",
        CastHoleStock = "cast-hole-stock",
        CoreShift = "core-shift",
        CastHolePlace = "cast-hole-place",
        CastSkin = "cast-skin",
        PlateSpringFeeds = "plate-spring-feeds",
        PlateSpringMost = "plate-spring-most",
    }

    /// The kinds of work in tables of high-speed steel.
    pub enum HssWork {
        Turn = "turn",
        Mill = "mill",
        Drill = "drill",
        Ream = "ream",
    }

    /// Operations whose speed is a share of the speed of drilling or turning.
    pub enum SharedWork {
        CentreDrill = "centre-drill",
        DrillOut = "drill-out",
        CoreDrill = "core-drill",
        Counterbore = "counterbore",
        Countersink = "countersink",
        Ream = "ream",
        Bore = "bore",
    }

    /// The kinds of work in tables of carbide.
    pub enum CarbideWork {
        Turn = "turn",
        Drill = "drill",
        Ream = "ream",
    }

    /// Whether the carbide is coated.
    pub enum Coating {
        Coated = "coated",
        Uncoated = "uncoated",
    }

    /// The pass of a turning tool.
    pub enum RoughOrFinish {
        Rough = "rough",
        Finish = "finish",
    }
}
