//! Row types: audit, with the rules by which it judges.

use technolog_knowledge::units::{Micrometres, Percent};
use technolog_knowledge::vocabulary::Severity;
use technolog_knowledge::{rows, vocabulary};

use crate::quantity::Quantity;

vocabulary! {
    /// A constant used in calculations by hand.
    pub enum Constant {
        /// π, with the precision that the author used.
        Pi = "pi",
        /// The divisor of N = M·n/9750: kW of N·m and 1/min.
        Power = "power",
    }

    /// The possible range of a quantity.
    pub enum Range {
        /// Above zero.
        Positive = "positive",
        /// Zero or above.
        NotNegative = "not-negative",
        /// Any.
        Any = "any",
    }

    /// Values that a plan by hand takes from tables.
    pub enum Tabulated {
        /// A feed.
        Feed = "feed",
        /// A feed of centring.
        SpotFeed = "spot-feed",
        /// The feed of the last reamer.
        ReamerFeed = "reamer-feed",
        /// A point of the cards.
        Card = "card",
        /// A factor of the cards.
        Factor = "factor",
        /// The time of rapids, which comes from the program's own order and not from a table.
        Rapid = "rapid",
    }

    /// What a plan may cover.
    pub enum PlanPart {
        /// The route of every group of holes.
        Holes = "holes",
        /// Tools and holders.
        Tools = "tools",
        /// Cutting conditions.
        Conditions = "conditions",
        /// The clamping.
        Clamping = "clamping",
        /// The program.
        Program = "program",
        /// Times.
        Times = "times",
    }

    /// A figure of the pace of a lathe program.
    pub enum PaceFigure {
        /// The cutting speed.
        Speed = "speed",
        Slow = "slow",
        /// The feed per revolution.
        Feed = "feed",
        /// The feed of an insert, against the radius of its nose.
        NoseFeed = "nose-feed",
        /// The feed of a drill, against tables.
        DrillFeed = "drill-feed",
        /// The depth of cut.
        Depth = "depth",
        /// The depth of a pass of a thread.
        ThreadPass = "thread-pass",
        /// That of a pass that takes the whole depth of the thread.
        WholeThread = "whole-thread",
    }

    /// Another law in place of a formula's, which the program makes.
    pub enum MistakenLaw {
        /// The tool life is left out.
        WithoutLife = "without-life",
        /// All corrections are left out.
        WithoutFactors = "without-factors",
        /// One correction is left out.
        WithoutFactor = "without-factor",
        /// A correction is divided by.
        FactorInverted = "factor-inverted",
        /// The coefficients are those of another row.
        OtherRow = "other-row",
        /// One exponent is that of another row.
        OtherExponent = "other-exponent",
    }

    /// Where the figure stands that a mistake takes instead.
    pub enum MistakenPlace {
        /// In the row of the route.
        Row = "row",
        /// In its tool.
        Tool = "tool",
    }

    /// A limit by which an audit tells one thing from another.
    pub enum Threshold {
        /// The largest misprint.
        MisprintLargest = "misprint-largest",
        /// How near a figure is to a usual mistake, as a share.
        MistakeNear = "mistake-near",
        /// The coarsest figure that is compared with usual mistakes, as a share.
        MistakeCoarse = "mistake-coarse",
        /// From which share of its depth a pass cuts the whole thread.
        ThreadWhole = "thread-whole",
        /// How many equal wrong figures make two works alike.
        AlikeFigures = "alike-figures",
        /// In how many works an unusual figure may stand.
        AlikeWorks = "alike-works",
        /// In which share of the works an unusual figure may stand.
        AlikeShare = "alike-share",
        /// How much deeper than the radius of its hole a spot may be, mm.
        SpotOverRadius = "spot-over-radius",
        /// How far a tool may go beyond a narrow hole, mm.
        OverrunLeast = "overrun-least",
        /// The widest hole of a program of which nothing is told, mm.
        UntoldWidth = "untold-width",
        /// The least share of the formula's speed that a list may have chosen.
        ListSpeedLeast = "list-speed-least",
        /// The same where the speed is that at the step of the spindle.
        ListStepSpeedLeast = "list-step-speed-least",
        /// The least share of the table's feed that may be an author's own, where one with another decimal point is not.
        PointLeast = "point-least",
        /// The largest such share.
        PointMost = "point-most",
        /// By which share of its diameter a blind hole is deeper than room for chips explains.
        FarDeeper = "far-deeper",
        /// From how many times its largest stock on a row lacks a transition before it.
        StockOfTwo = "stock-of-two",
    }

    /// What must be known of the part of a list of tools for a rule to judge it.
    pub enum Need {
        /// Nothing: the list is enough.
        Nothing = "nothing",
        /// The material.
        Material = "material",
        /// The machine.
        Machine = "machine",
        /// The motions of a program, which tell the order of work.
        Program = "program",
    }

    /// What kind of tool a word of a program names.
    pub enum ToolKind {
        /// A centring or spot drill.
        Centring = "centring",
        /// A drill.
        Drill = "drill",
        /// A core drill.
        CoreDrill = "core-drill",
        /// A reamer.
        Ream = "ream",
        /// A boring bar.
        Bore = "bore",
        /// A mill.
        Mill = "mill",
        /// A tap.
        Tap = "tap",
        /// A countersink.
        Countersink = "countersink",
        /// A tool for chamfers.
        Chamfer = "chamfer",
        /// A counterbore.
        Counterbore = "counterbore",
    }

    /// Which of several transitions with tools of one kind a word of a program names.
    pub enum ToolStage {
        /// The first.
        Rough = "rough",
        /// One between.
        SemiFinish = "semi-finish",
        /// The last.
        Finish = "finish",
    }

    /// How a load compares with the formula.
    pub enum Judgement {
        /// Too low.
        Low = "low",
        /// Right.
        Fine = "fine",
        /// Too high.
        High = "high",
    }
}

impl Range {
    /// Whether a figure is within the range.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Any => true,
        }
    }
}

rows! {
    /// Constants used in calculations by hand, one row for each value in use.
    pub struct Constants of One("audit-constants") complete name {
        name: Constant,
        value: f64,
    }

    /// Findings about a program with a common cause: the codes of two findings, and the figures in which they must
    /// agree.
    pub struct ProgramCauses of One("audit-program-causes") {
        cause: &'t str,
        consequence: &'t str,
        alike: Option<Vec<&'t str>>,
        told: Option<&'t str>,
    }

    /// How a program may differ from its plan.
    pub struct ProgramTolerance of One("audit-program-tolerance") {
        quantity: Quantity,
        whole: f64,
        relative: Percent,
        severity: Severity,
    }

    /// The rounding tolerance of each quantity.
    pub struct Tolerance of One("audit-tolerance") complete quantity {
        quantity: Quantity,
        half_places: f64,
        relative: Percent,
        own_places: i64,
        rounded: bool,
        severity: Severity,
        range: Range,
        whole: bool,
    }

    /// A figure from a table, compared with the table.
    pub struct AuditByTable of One("audit-by-table") asked by AuditByTableFor {
        quantity: Tabulated,
        of_table: Percent,
    } {
        severity: Severity,
    }

    /// A stated figure, compared with the handbook's formula.
    pub struct AuditFormula of One("audit-formula") asked by AuditFormulaFor {
        quantity: Quantity,
        of_formula: Percent,
    } {
        severity: Severity,
    }

    /// A constant of clamping other than the textbook's.
    pub struct AuditClamping of One("audit-clamping") asked by AuditClampingFor {
        quantity: Quantity,
        of_table: Percent,
    } {
        severity: Severity,
    }

    /// An overhang other than the textbook's.
    pub struct AuditOverhang of One("audit-overhang") asked by AuditOverhangFor {
        excess: Micrometres,
    } {
        severity: Severity,
    }

    /// What a part of a plan is worth where it is missing.
    pub struct AuditShares of One("audit-shares") complete part {
        part: PlanPart,
        of_points: Percent,
    }

    /// The limits of an audit.
    pub struct AuditThresholds of One("audit-thresholds") complete name {
        name: Threshold,
        value: f64,
    }

    /// State standards whose tools a table has under another standard's designations.
    pub struct StandardsAlike of One("audit-standards-alike") {
        standard: &'t str,
        tools: &'t str,
    }

    /// What words in the comments of programs say of tools, the narrower before the wider.
    pub struct ProgramWords of One("audit-program-words") {
        word: &'t str,
        kind: Option<ToolKind>,
        stage: Option<ToolStage>,
    }

    /// How grave what the proof finds may be at most where the plan was read out of the program.
    pub struct ProgramAloneCaps of One("audit-program-alone") {
        finding: &'t str,
        severity: Severity,
        up_to: Option<f64>,
    }

    /// A cutting speed of a tool of which only the size is known, beside that of ours.
    pub struct AuditProgramPace of One("audit-program-pace") asked by AuditProgramPaceFor {
        of_ours: Percent,
    } {
        severity: Severity,
    }

    /// The rules that judge a list of tools without a part.
    pub struct AuditNeeds of One("audit-needs") {
        rule: &'t str,
        needs: Need,
    }

    /// The usual ways to get a formula wrong.
    pub struct Mistakes of One("audit-mistakes") {
        rule: &'t str,
        id: &'t str,
        of: Option<Quantity>,
        instead: Option<Quantity>,
        at: Option<MistakenPlace>,
        value: Option<f64>,
        times: Option<f64>,
        power: Option<f64>,
        law: Option<MistakenLaw>,
        severity: Option<Severity>,
        what: &'t str,
    }

    /// Names that the textbook prints otherwise than the catalogs have them.
    pub struct PrintedNames of One("audit-printed") {
        printed: &'t str,
        known: &'t str,
    }

    /// A force or torque, compared with the handbook's formula.
    pub struct AuditLoad of One("audit-load") asked by AuditLoadFor {
        of_formula: Percent,
    } {
        judgement: Judgement,
    }

    /// Speed and feed of a lathe program.
    pub struct AuditLathePace of One("audit-lathe-pace") asked by AuditLathePaceFor {
        figure: PaceFigure,
        share: f64,
    } {
        severity: Severity,
    }

    /// How near the part a turret may turn.
    pub struct AuditTurretClear of One("audit-turret-clear") asked by AuditTurretClearFor {
        distance: Micrometres,
        reaches_in: bool,
    } {
        severity: Severity,
    }

    /// A spindle speed that differs from the rule's.
    pub struct AuditSpindle of One("audit-spindle") asked by AuditSpindleFor {
        excess: Percent,
    } {
        severity: Severity,
    }
}
