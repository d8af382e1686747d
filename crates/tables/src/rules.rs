//! Row types: rules.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_knowledge::units::{
    Decimal, Degrees, ItGrade, MetresPerMinute, Micrometres, MillimetresPerMinute, Minutes, Percent, Roughness,
};
use technolog_knowledge::vocabulary::{Operation, Shank, ToolMaterial};
use technolog_knowledge::{rows, vocabulary};

use crate::holes::DrillingWay;

vocabulary! {
    /// The state of the entry face.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Entry {
        /// Machined beforehand.
        #[default]
        Machined = "machined",
        /// As cast, forged or rolled.
        Rough = "rough",
    }

    /// What stands where a hole is to be.
    pub enum BlankState {
        Solid = "solid",
        WithHole = "cast-or-pre-machined",
    }

    /// Whether the position of the axis asks for boring.
    pub enum BoringAsked {
        Asked = "asked",
        NotAsked = "not-asked",
    }

    /// What the centring spot is as wide as.
    pub enum Spot {
        Chamfer = "chamfer",
        ShareOfDrill = "share-of-drill",
    }

    /// What stands for an empty cell of A.8 or A.9.
    pub enum CellTaken {
        Own = "own-cell",
        FinerRoughness = "finer-roughness",
        FinerGrade = "finer-grade",
        Nothing = "nothing",
    }

    /// What opens a large hole.
    pub enum MillInstead {
        Same = "same",
        Mill = "mill",
    }

    /// What stands in where no boring bar enters.
    pub enum BoringInstead {
        Same = "same",
        CoreDrill = "core-drill",
        Nothing = "nothing",
    }

    /// What was done to a hole last, or what the blank has there.
    pub enum HoleState {
        Solid = "solid",
        Centred = "centred",
        Drilled = "drilled",
        CoreDrilled = "core-drilled",
        RoughBored = "rough-bored",
        BoredOnce = "bored-once",
        BoredTwice = "bored-twice",
        Milled = "milled",
        Counterbored = "counterbored",
        ReamedAfterDrill = "reamed-after-drill",
        ReamedAfterCoreDrill = "reamed-after-core-drill",
        ReamedAfterBoring = "reamed-after-boring",
        ReamedAfterTwoBorings = "reamed-after-two-borings",
        CastHole = "cast-hole",
        PreMachinedHole = "pre-machined-hole",
        OwnCylinder = "own-cylinder",
        Finished = "finished",
    }

    /// Lead angle of a reamer.
    pub enum Lead {
        Deg5 = "5deg",
        Deg15 = "15deg",
    }

    /// The grade that a table of schemes is asked with.
    pub enum GradeAsked {
        Own = "own",
        It13 = "13",
    }

    /// The column of centre tolerances that a table of schemes is asked with.
    pub enum CentreColumn {
        Own = "own",
        UpTo03 = "0.05-0.3",
    }

    /// How the holes of a group are visited (textbook 1.3.1).
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum VisitingMethod {
        /// Each tool goes round all holes.
        Parallel = "parallel",
        /// Each hole is made with all tools before the next.
        Sequential = "sequential",
        /// The first transitions in parallel, the finishing ones one after the other at each hole.
        FirstParallelFinishSequential = "first-parallel-finish-sequential",
    }

    /// Which of two schemes.
    pub enum SchemeTaken {
        First = "first",
        Second = "second",
    }
}

rows! {
    /// The allowance that a transition removes.
    pub struct AllowanceBefore of One("allowance-before") asked by AllowanceBeforeFor {
        operation: Operation,
    } {
        allowance: &'t str,
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

    /// A figure taken from a table beside the table.
    pub struct AuditByTable of One("audit-by-table") asked by AuditByTableFor<'t> {
        quantity: &'t str,
        of_table: Percent,
    } {
        severity: &'t str,
    }

    /// A stated figure beside the handbook's formula.
    pub struct AuditFormula of One("audit-formula") asked by AuditFormulaFor<'t> {
        quantity: &'t str,
        of_formula: Percent,
    } {
        severity: &'t str,
    }

    /// A force or torque beside the handbook's formula.
    pub struct AuditLoad of One("audit-load") asked by AuditLoadFor {
        of_formula: Percent,
    } {
        judgement: &'t str,
    }

    /// A spindle speed that is not the rule's.
    pub struct AuditSpindle of One("audit-spindle") asked by AuditSpindleFor {
        excess: Percent,
    } {
        severity: &'t str,
    }

    /// The drill before a solid blank is bored.
    pub struct BoreDrill of One("bore-drill") asked by BoreDrillFor {
        diameter: Micrometres,
    } {
        drilled: bool,
        least_stock: Option<Micrometres>,
        step: Option<Micrometres>,
    }

    /// Whether the position of the axis asks for boring.
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

    /// The scheme with centring that stands for one without.
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

    /// What an empty cell of А.8 or А.9 is replaced by.
    pub struct EmptyCell of One("empty-cell") asked by EmptyCellFor {
        own_cell: bool,
        finer_roughness: bool,
        finer_grade: bool,
    } {
        take: CellTaken,
    }

    /// Where the feed comes from.
    pub struct FeedChoice of One("feed-choice") asked by FeedChoiceFor<'t> {
        operation: Operation,
        method: &'t str,
    } {
        feed_table: &'t str,
        multiple: &'t str,
    }

    /// Which holder takes a shank.
    pub struct HolderForShank of One("holder-for-shank") asked by HolderForShankFor {
        shank: Shank,
        drawbar: bool,
        tap: bool,
    } {
        holders: Option<&'t str>,
    }

    /// The machining cycle of a transition.
    pub struct MachiningCycle of One("machining-cycle") asked by MachiningCycleFor<'t> {
        operation: Operation,
        depth_ratio: f64,
        material_group: &'t str,
    } {
        cycle: &'t str,
        step: Option<f64>,
        clearance: Option<Micrometres>,
        dwell: Option<f64>,
        cut: Option<&'t str>,
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
    } {
        operation: Operation,
        leaves: HoleState,
        a1: Option<i64>,
        a2: Option<&'t str>,
        own: Option<&'t str>,
    }

    /// Direction of the roughing passes in turning.
    pub struct PassDirection of One("pass-direction") asked by PassDirectionFor<'t> {
        blank_shape: &'t str,
        holding: &'t str,
    } {
        direction: &'t str,
    }

    /// The highest speed that shop practice allows.
    pub struct PracticeSpeed of One("practice-speed") asked by PracticeSpeedFor<'t> {
        operation: Operation,
        tool_material: ToolMaterial,
        material_group: &'t str,
    } {
        limit: MetresPerMinute,
    }

    /// Lead angle of a reamer.
    pub struct ReamerLead of One("reamer-lead") asked by ReamerLeadFor<'t> {
        material_group: &'t str,
    } {
        lead: Lead,
    }

    /// Which factors on the reaming feed apply.
    pub struct ReamingFeedCondition of One("reaming-feed-condition") asked by ReamingFeedConditionFor {
        tool_material: ToolMaterial,
        final_ as "final": Option<bool>,
        it: Option<ItGrade>,
        roughness: Option<Roughness>,
    } {
        conditions: Vec<&'t str>,
    }

    /// Schemes that remove the rough stock of stepped shafts.
    pub struct RemovalScheme of One("removal-scheme") asked by RemovalSchemeFor<'t> {
        scheme: &'t str,
    } {
        preference: i64,
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
    } {
        take: &'t str,
    }

    /// Whose figures stand in where a material has none.
    pub struct StandInMaterial of One("stand-in-material") asked by StandInMaterialFor<'t> {
        of_table: &'t str,
        material_group: &'t str,
    } {
        group: &'t str,
    }

    /// Whose figures stand in where a transition has none.
    pub struct StandInOperation of One("stand-in-operation") asked by StandInOperationFor {
        operation: Operation,
    } {
        instead: Operation,
    }

    /// Whose figures stand in where a tool material has none.
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
        allowances: Vec<&'t str>,
    }

    /// Surface of the blank, for the speed factor.
    pub struct Surface of One("surface") asked by SurfaceFor<'t> {
        skin: bool,
        material_group: &'t str,
    } {
        surface: &'t str,
    }

    /// Which table of schemes a hole is looked up in.
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
        operation: &'t str,
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

    /// Preparing a blank for an NC lathe.
    pub struct TurningBlankPreparation of One("turning-blank-preparation") asked by TurningBlankPreparationFor<'t> {
        stock: &'t str,
        holding: &'t str,
        heat_treatment: &'t str,
    } {
        action: &'t str,
        contradicts: bool,
    }

    /// The blank of a turned part: for how many parts, and how exact its length.
    pub struct TurningBlank of One("turning-blank") asked by TurningBlankFor<'t> {
        stock: &'t str,
        diameter: Micrometres,
    } {
        parts: &'t str,
        length_deviation: Micrometres,
    }

    /// Main or additional element of a contour, and by what tool.
    pub struct TurningElement of One("turning-element") asked by TurningElementFor<'t> {
        kind: &'t str,
        ground: &'t str,
        valley_fall: Degrees,
        floor_reached: bool,
    } {
        element: &'t str,
        tool: &'t str,
    }

    /// What is finished elsewhere than on the lathe.
    pub struct TurningFinishElsewhere of One("turning-finish-elsewhere") asked by TurningFinishElsewhereFor<'t> {
        surface: &'t str,
        grade_held: bool,
        roughness_held: bool,
    } {
        operation: &'t str,
    }

    /// Least length of a cylinder for the jaws of a chuck.
    pub struct TurningHold of One("turning-hold") asked by TurningHoldFor {
        diameter: Micrometres,
    } {
        least_length: Micrometres,
    }

    /// Rates and distances of turning motions where the shaft file says nothing.
    pub struct TurningMotion of One("turning-motion") asked by TurningMotionFor<'t> {
        quantity: &'t str,
    } {
        rate: Option<MillimetresPerMinute>,
        distance: Option<Micrometres>,
    }

    /// Scheme of the roughing passes for a zone.
    pub struct TurningScheme of One("turning-scheme") asked by TurningSchemeFor<'t> {
        zone: &'t str,
        parts: &'t str,
        contour: &'t str,
        against_stop: bool,
        blank_shape: &'t str,
    } {
        schemes: Vec<&'t str>,
        also: Option<Vec<&'t str>>,
        parts_worked: &'t str,
        return_way: &'t str,
    }

    /// Surface of a turned blank, for the speed factor.
    pub struct TurningSkin of One("turning-skin") asked by TurningSkinFor<'t> {
        stock: &'t str,
        group: &'t str,
    } {
        surface: &'t str,
    }

    /// Which of the turning tools that fit.
    pub struct TurningToolOrder of One("turning-tool-order") asked by TurningToolOrderFor<'t> {
        kind: &'t str,
    } {
        prefer: Vec<&'t str>,
    }

    /// Zones of turning: what bounds them.
    pub struct TurningZone of One("turning-zone") asked by TurningZoneFor<'t> {
        parts: &'t str,
        face_ahead: bool,
        face_behind: bool,
    } {
        zone: &'t str,
        limits_main_angle: bool,
        limits_auxiliary_angle: bool,
    }

    /// Whether to drill in two passes.
    pub struct TwoPassDrilling of One("two-pass-drilling") asked by TwoPassDrillingFor {
        diameter: Micrometres,
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
}
