//! Row types: rules.

use technolog_knowledge::rows;
use technolog_knowledge::units::{Brinell, Decimal, ItGrade, Megapascals, Micrometres, Minutes, Percent, Roughness};
use technolog_knowledge::vocabulary::{CuttingMethod, Operation, Shank, ToolMaterial};

use crate::cutting::{Coefficients, FeedMultiple, ReamingCondition, Surface};
use crate::holes::DrillingWay;

mod words;
pub use words::*;

rows! {
    /// The allowance that a transition removes.
    pub struct AllowanceBefore of One("allowance-before") asked by AllowanceBeforeFor {
        operation: Operation,
        after: MadeBy,
    } {
        allowance: Option<&'t str>,
        case: Option<ReamingCase>,
        share: f64,
    }

    /// Approach and overrun.
    pub struct Approach of One("approach") asked by ApproachFor {
        entry: Entry,
        through: bool,
    } {
        approach: Micrometres,
        overrun: Micrometres,
    }

    /// Whether the position of the axis requires boring.
    pub struct BoringForPosition of One("boring-for-position") asked by BoringForPositionFor {
        position: Micrometres,
        bar_enters: bool,
    } {
        boring: BoringAsked,
    }

    /// Whether to centre before drilling.
    pub struct CentreFirst of One("centre-first") asked by CentreFirstFor {
        state: BlankState,
        it: ItGrade,
        diameter: Micrometres,
        depth_ratio: Decimal,
    } {
        centre: bool,
    }

    /// Diameter of the centring spot.
    pub struct CentreSpot of One("centre-spot") asked by CentreSpotFor {
        chamfer: bool,
        diameter: Micrometres,
    } {
        spot: Spot,
        share: Option<f64>,
    }

    /// The scheme with centring that replaces one without.
    pub struct CentredTwin of One("centred-twin") {
        scheme: &'t str,
        centred: &'t str,
    }

    /// Coolant, where the figures do not say.
    pub struct Coolant of One("coolant") asked by CoolantFor<'t> {
        operation: Operation,
        material_group: &'t str,
    } {
        coolant: bool,
    }

    /// The feed of a mill that plunges into metal.
    pub struct PlungeFeed of One("plunge-feed") asked by PlungeFeedFor<'t> {
        material_group: &'t str,
    } {
        share: f64,
    }

    /// The stock of the round with which an end mill finishes a cylinder.
    pub struct MillingFinishRound of One("milling-finish-round") asked by MillingFinishRoundFor {
        it: ItGrade,
        roughness: Roughness,
    } {
        stock: Micrometres,
    }

    /// What of a cylinder over a flat floor or shoulder may stay unfinished.
    pub struct UnfinishedOverFloor of One("unfinished-over-floor") asked by UnfinishedOverFloorFor {
        it: ItGrade,
        diameter: Micrometres,
        shoulder: bool,
    } {
        share: f64,
        most: Option<Micrometres>,
    }

    /// Coolant for inserts on a lathe.
    pub struct TurningCoolant of One("turning-coolant") asked by TurningCoolantFor<'t> {
        material_group: &'t str,
    } {
        coolant: bool,
    }

    /// How much deeper than its feed a pass may be, so that its chips break.
    pub struct TurningChipWidth of One("turning-chip-width") asked by TurningChipWidthFor<'t> {
        material_group: &'t str,
    } {
        ratio: f64,
    }

    /// Depth corrections beyond the handbook's table.
    pub struct DepthBeyond of One("depth-beyond") asked by DepthBeyondFor<'t> {
        of_table: &'t str,
        depth_ratio: f64,
    } {
        factor: f64,
    }

    /// The drill before a core drill.
    pub struct DrillBeforeCoreDrill of One("drill-before-core-drill") asked by DrillBeforeCoreDrillFor {
        diameter: Micrometres,
    } {
        stock: Micrometres,
    }

    /// The replacement for an empty cell of А.8 or А.9.
    pub struct EmptyCell of One("empty-cell") asked by EmptyCellFor {
        own_cell: bool,
        finer_roughness: bool,
        finer_grade: bool,
        tighter_centres: bool,
    } {
        take: CellTaken,
    }

    /// Where the feed comes from.
    pub struct FeedChoice of One("feed-choice") asked by FeedChoiceFor<'t> {
        operation: Operation,
        method: CuttingMethod,
        material_group: &'t str,
    } {
        feed_table: FeedTable,
        multiple: FeedMultiple,
        eased: bool,
        within_practice: bool,
    }

    /// Which holder takes a shank.
    pub struct HolderForShank of One("holder-for-shank") asked by HolderForShankFor {
        shank: Shank,
        drawbar: bool,
        tap: bool,
    } {
        holders: Option<&'t str>,
    }

    /// With what a transition moves the part under its clamps.
    pub struct ClampingLoad of One("clamping-load") asked by ClampingLoadFor {
        operation: Operation,
    } {
        load: PartLoad,
    }

    /// The kind of fixture.
    pub struct FixtureKindOf of One("fixture-kind") asked by FixtureKindFor {
        held: HeldBy,
        stiff: bool,
        family: bool,
        pins: bool,
    } {
        kind: FixtureKind,
    }

    /// How a fixture is keyed to the table.
    pub struct FixtureKeying of One("fixture-keying") asked by FixtureKeyingFor {
        cross_element: bool,
        plate: bool,
    } {
        keying: TableKeying,
    } shown { trued }

    /// How the part is located in its fixture.
    pub struct PartLocatingBy of One("part-locating") asked by PartLocatingFor {
        fine_holes: f64,
        from_contour: bool,
        round: bool,
    } {
        locating: PartLocating,
    }

    /// Whether a chain of dimensions closes.
    pub struct ChainClosingBy of One("chain-closing") asked by ChainClosingFor {
        worst: bool,
        likely: bool,
        sure: bool,
    } {
        closing: ChainClosing,
        severity: ChainSeverity,
    }

    /// One zero of the part, or one for each chain of dimensions.
    pub struct ChainZerosBy of One("chain-zeros") asked by ChainZerosFor {
        several: bool,
        more_close: bool,
    } {
        zeros: ChainZeros,
    }

    /// The share of the machine's limit that a load may take.
    pub struct LoadMargin of One("load-margin") asked by LoadMarginFor {
        load: Load,
    } {
        share: f64,
    }

    /// The machining cycle of a transition.
    pub struct MachiningCycle of One("machining-cycle") asked by MachiningCycleFor<'t> {
        operation: Operation,
        depth_ratio: f64,
        material_group: &'t str,
    } {
        cycle: HoleCycle,
        step: Option<f64>,
        clearance: Option<Micrometres>,
        dwell: Option<f64>,
        cut: Option<MillingDirection>,
    }

    /// Whether a large hole is milled or bored.
    pub struct MillOrBore of One("mill-or-bore") asked by MillOrBoreFor {
        operation: Operation,
        contouring: bool,
        diameter: Micrometres,
    } {
        instead: MillInstead,
    }

    /// Which transitions may follow a state of the hole.
    pub struct NextTransition of One("next-transition") asked by NextTransitionFor {
        after: HoleState,
        diameter: Micrometres,
        beyond_core_drills: bool,
    } {
        operation: Operation,
        leaves: HoleState,
        a1: Option<i64>,
        a2: Option<&'t str>,
        own: Option<&'t str>,
    }

    /// When the speed is that of practice.
    pub struct SecondOpinion of One("second-opinion") asked by SecondOpinionFor<'t> {
        operation: Operation,
        material_group: &'t str,
        strength: Megapascals,
        share: f64,
        spread: f64,
    } {
        take: Taken,
    }

    /// When the speed of turning is that of practice.
    pub struct TurningSecondOpinion of One("turning-second-opinion") asked by TurningSecondOpinionFor<'t> {
        cut: LatheCut,
        material_group: &'t str,
        formula: Formula,
        share: f64,
    } {
        take: Taken,
    }

    /// Whether a field holds the nominal size.
    pub struct TurningField of One("turning-field") asked by TurningFieldFor<'t> {
        letters: &'t str,
        grade: ItGrade,
        diameter: Micrometres,
    } {
        holds: bool,
    }

    /// Class of an alloy by its stated hardness or strength; 0 where not stated.
    pub struct AlloyClassState of One("alloy-class-state") asked by AlloyClassStateFor<'t> {
        alloy_class: &'t str,
        hardness: Brinell,
        strength: Megapascals,
    } {
        class: &'t str,
    }

    /// Where a tolerance field lies.
    pub struct FieldPosition of One("field-position") asked by FieldPositionFor<'t> {
        letters: &'t str,
        grade: ItGrade,
        diameter: Micrometres,
    } {
        begins: FieldBegins,
        of: &'t str,
        delta: bool,
    }

    /// When the torque is that of the specific cutting force.
    pub struct ForceOpinion of One("force-opinion") asked by ForceOpinionFor {
        operation: Operation,
    } {
        lips: f64,
        least: f64,
    }

    /// Lead angle of a reamer.
    pub struct ReamerLead of One("reamer-lead") asked by ReamerLeadFor<'t> {
        material_group: &'t str,
    } {
        lead: Lead,
    }

    /// Which factors on the reaming feed apply.
    pub struct ReamingFeedCondition of One("reaming-feed-condition") asked by ReamingFeedConditionFor<'t> {
        tool_material: ToolMaterial,
        material_group: &'t str,
        hardness: Brinell,
        diameter: Micrometres,
        final_ as "final": Option<bool>,
        roughness: Option<Roughness>,
    } {
        conditions: Vec<ReamingCondition>,
        practice: HeldTo,
    }

    /// Drilling into an unmachined face.
    pub struct RoughFace of One("rough-face") asked by RoughFaceFor {
        entry: Entry,
        state: BlankState,
    } {
        loses: Option<DrillingWay>,
    }

    /// The step of the spindle series for a computed speed.
    pub struct SpindleStep of One("spindle-step") asked by SpindleStepFor {
        excess: Percent,
        beyond_practice: bool,
    } {
        take: Neighbour,
    }

    /// The replacement material, where a material has no figures.
    pub struct StandInMaterial of One("stand-in-material") asked by StandInMaterialFor<'t> {
        of_table: &'t str,
        material_group: &'t str,
    } {
        group: &'t str,
    }

    /// The replacement transition, where a transition has no figures.
    pub struct StandInOperation of One("stand-in-operation") asked by StandInOperationFor {
        operation: Operation,
    } {
        instead: Operation,
    }

    /// The replacement tool material, where a tool material has no figures.
    pub struct StandInToolMaterial of One("stand-in-tool-material") asked by StandInToolMaterialFor<'t> {
        of_table: &'t str,
        tool_material: ToolMaterial,
    } {
        instead: ToolMaterial,
    }

    /// Stock left for a finish on another machine.
    pub struct StockForElsewhere of One("stock-for-elsewhere") asked by StockForElsewhereFor {
        diameter: Micrometres,
    } {
        transitions: Option<Vec<Operation>>,
    }

    /// What finishes a hole that is finer than this machine makes, and what it finds.
    pub struct FinerElsewhere of One("finer-elsewhere") asked by FinerElsewhereFor {
        it: ItGrade,
        roughness: Roughness,
    } {
        operation: Operation,
        before: ItGrade,
    }

    /// Stock for honing.
    pub struct HoningAllowance of One("honing-allowance") asked by HoningAllowanceFor {
        tolerance: Micrometres,
        roughness: Roughness,
    } {
        least: Micrometres,
        before: Roughness,
    }

    /// Surface of the blank, for the speed factor.
    pub struct BlankSurface of One("surface") asked by SurfaceFor<'t> {
        skin: bool,
        material_group: &'t str,
    } {
        surface: Surface,
    }

    /// The table of schemes for a hole.
    pub struct TableForHole of One("table-for-hole") asked by TableForHoleFor {
        it: ItGrade,
        centre_tolerance: Micrometres,
    } {
        scheme_table: &'t str,
        grade: GradeAsked,
        centre_column: CentreColumn,
        finish_elsewhere: bool,
    }

    /// A hole too small for a boring bar.
    pub struct TooSmallToBore of One("too-small-to-bore") asked by TooSmallToBoreFor {
        operation: Operation,
        bar_enters: bool,
    } {
        operation_instead: BoringInstead,
    }

    /// Tool life where the handbook's table is empty.
    pub struct ToolLifeBeyond of One("tool-life-beyond") asked by ToolLifeBeyondFor<'t> {
        operation: Coefficients,
        material_group: &'t str,
        tool_material: ToolMaterial,
        diameter: Micrometres,
    } {
        life: Minutes,
    }

    /// Which tables a cutter is taken from, in order.
    pub struct ToolTables of One("tool-tables") asked by ToolTablesFor {
        operation: Operation,
        diameter: Micrometres,
    } {
        tables: Vec<&'t str>,
    }

    /// Order of the transitions of one step.
    pub struct TransitionOrder of One("transition-order") asked by TransitionOrderFor {
        operation: Operation,
        face: bool,
    } {
        rank: i64,
    }

    /// Whether to drill in two passes.
    pub struct TwoPassDrilling of One("two-pass-drilling") asked by TwoPassDrillingFor<'t> {
        diameter: Micrometres,
        material_group: &'t str,
        first_drill_in_magazine: bool,
    } {
        passes: i64,
    }

    /// The method of visiting the holes of a group.
    pub struct MethodOfVisiting of One("visiting-method") asked by MethodOfVisitingFor {
        it: ItGrade,
        centre_tolerance: Micrometres,
        k_t: f64,
    } {
        method: VisitingMethod,
    }

    /// Which of the two schemes of a cell.
    pub struct WhichOfTwoSchemes of One("which-of-two-schemes") asked by WhichOfTwoSchemesFor {
        for_other_drill: bool,
        drill_of_that_diameter: bool,
        position: Micrometres,
    } {
        take: SchemeTaken,
    }

    /// The method of a transition.
    pub struct WayOfTransition of One("way-of-transition") asked by WayOfTransitionFor {
        operation: Operation,
        centred: bool,
        after: MadeBy,
        last: bool,
    } {
        way: &'t str,
        worst: Worst,
    }
}

impl MadeBy {
    /// How a hole was made if an operation was the last; none for operations that do not change its cylinder.
    pub const fn of(operation: Operation) -> Option<Self> {
        match operation {
            Operation::Drill | Operation::DrillOut => Some(Self::Drill),
            Operation::CoreDrill => Some(Self::CoreDrill),
            Operation::RoughBore | Operation::SemiFinishBore | Operation::FinishBore => Some(Self::Bore),
            Operation::Mill => Some(Self::Mill),
            Operation::Counterbore => Some(Self::Counterbore),
            Operation::RoughReam | Operation::FinishReam => Some(Self::Ream),
            Operation::CentreDrill | Operation::Countersink | Operation::Chamfer | Operation::Tap | Operation::Hone => {
                None
            }
        }
    }
}
