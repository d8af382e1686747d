//! Grooves, threads, holes on the axis and parting: passes and cutting conditions.

use technolog_knowledge::units::{Degrees, MetresPerMinute, Micrometres, MillimetresPerRev};
use technolog_knowledge::{rows, vocabulary};

use super::part::Side;

vocabulary! {
    /// A constant of `turning-job-limits`.
    pub enum JobLimit {
        /// The distance between two plunges, divided by the width of the blade.
        PlungeStep = "plunge-step",
        /// The finishing allowance of a groove, divided by the corner radius of the blade.
        GrooveAllowance = "groove-allowance",
        /// The largest depth that a blade finishes sideways.
        GrooveFinishDepth = "groove-finish-depth",
        /// The depth from which a blade is retracted during a plunge, divided by its width.
        PeckFrom = "peck-from",
        /// A step of such a plunge, divided by the width of the blade.
        PeckStep = "peck-step",
        /// The distance of the retract.
        PeckRetract = "peck-retract",
        /// Feed along a side, divided by the width of the blade.
        SideFeed = "side-feed",
        /// Depth times feed along a side, divided by the square of the width of the blade.
        SideLoad = "side-load",
        /// The factor on the speed of grooving in a bore and in a face.
        InnerGroovingSpeed = "inner-grooving-speed",
        /// The least depth of a pass of a thread.
        ThreadLastPass = "thread-last-pass",
        /// The largest worked diameter over the smallest from which on the cutting speed is held.
        ConstantSpeedRatio = "constant-speed-ratio",
        /// The time, in minutes, that may be lost to save a blade.
        BladeSaved = "blade-saved",
        /// φ of the first pass of a thread in the makers' formula.
        ThreadFirstShare = "thread-first-share",
        /// The number of passes at full depth after the last pass of a thread.
        ThreadSpringPasses = "thread-spring-passes",
        /// The least run-in of a thread, in pitches.
        ThreadEntry = "thread-entry",
        /// Run-out of a thread: spindle speed times pitch, divided by this.
        ThreadRunOut = "thread-run-out",
        /// The finest IT grade of a surface on which a thread may run out.
        ThreadRunOutGrade = "thread-run-out-grade",
        /// The run-in of a thread, in run-outs.
        ThreadRunIn = "thread-run-in",
        /// From the tip of a threading insert to its side.
        ThreadInsertSide = "thread-insert-side",
        /// The distance from the crests at which the tool returns.
        ThreadLift = "thread-lift",
        /// The greatest depth of parting, divided by the width of the blade.
        PartingDepth = "parting-depth",
        /// The radius at which the feed of parting is reduced.
        PartingSlowFrom = "parting-slow-from",
        /// The reduced feed, divided by the feed before.
        PartingSlowFeed = "parting-slow-feed",
        /// From the jaws to the parting tool.
        PartingJawGap = "parting-jaw-gap",
        /// The stock left on a parted face that is faced afterwards.
        PartingFaceStock = "parting-face-stock",
        PartingExcess = "parting-excess",
        HollowSeam = "hollow-seam",
        HollowOverLip = "hollow-over-lip",
        HollowSteepest = "hollow-steepest",
        PartingNeck = "parting-neck",
        /// The distance by which the full diameter of a drill comes out of a through hole.
        DrillBreakthrough = "drill-breakthrough",
        /// The diameter of a centring spot, divided by that of the next drill.
        SpotShare = "spot-share",
        /// The diameter by which a countersink is fed and run, as a share of the way from the hole to its widest.
        CountersinkShare = "countersink-share",
        /// The length of a core drill's lead, divided by its height: the cotangent of its angle.
        CoreDrillLead = "core-drill-lead",
        /// The fastest spindle at which a tap is reversed, 1/min.
        TapSpindle = "tap-spindle",
        /// The turns that a spindle still makes at the end of a tap's way, before it stands.
        TapStopTurns = "tap-stop-turns",
        /// The way of a tap before the hole, in pitches, on which feed and spindle come into step.
        TapEntry = "tap-entry",
        /// The share of the rise of a bar's secondary edge that the stock on a bottom may take.
        BottomEdgeShare = "bottom-edge-share",
        /// The length of the slope with which the allowance of a seat ends beside a plain cylinder, divided by its height.
        AllowanceEndFall = "allowance-end-fall",
        /// The length of a slope up to a fit of another radius, divided by its height: the cotangent of its angle.
        FitRise = "fit-rise",
        /// The same down from one.
        FitFall = "fit-fall",
        /// The longest way along a slope of the drawing to the radius of a fit.
        FitSlopeFar = "fit-slope-far",
    }
}

rows! {
    /// Constants of grooves, threads, holes and parting; each has one of the two values.
    pub struct JobLimits of One("turning-job-limits") complete name {
        name: JobLimit,
        ratio: Option<f64>,
        length: Option<Micrometres>,
    }

    /// Feed and speed of grooving by a tool maker, by the width of the blade.
    pub struct GroovingPractice of One("grooving-practice") asked by GroovingPracticeFor<'t> {
        material_group: &'t str,
        width: Micrometres,
    } {
        feed_min: MillimetresPerRev,
        feed_max: MillimetresPerRev,
        speed_min: MetresPerMinute,
        speed_max: MetresPerMinute,
    }

    /// Passes of a metric thread by its pitch.
    pub struct ThreadingPasses of One("threading-passes") {
        side: Side,
        pitch: Micrometres,
        passes: i64,
    } shown { depth, first }

    /// The longest run-out of a metric thread by its pitch.
    pub struct ThreadRunOut of One("thread-run-out") {
        side: Side,
        pitch: Micrometres,
        length: Micrometres,
    }

    /// The infeed of a metric thread.
    pub struct ThreadingInfeed of One("threading-infeed") asked by ThreadingInfeedFor<'t> {
        pitch: Micrometres,
        material_group: &'t str,
    } {
        angle: Degrees,
    }

    /// The deepest first pass of a thread, and the number of passes added to those of the table.
    pub struct ThreadingFirstPass of One("threading-first-pass") asked by ThreadingFirstPassFor<'t> {
        material_group: &'t str,
    } {
        depth: Micrometres,
        more: i64,
    }

    /// Cutting speed of threading with carbide.
    pub struct ThreadingSpeed of One("threading-speed") asked by ThreadingSpeedFor<'t> {
        material_group: &'t str,
    } {
        speed: MetresPerMinute,
        speed_max: MetresPerMinute,
    }

    /// The least width of a parting blade by the diameter of the bar.
    pub struct PartingBlade of One("parting-blade") asked by PartingBladeFor {
        diameter: Micrometres,
    } {
        width: Micrometres,
    }

    /// Centre holes of ГОСТ 14034 and the centre drills for them.
    pub struct CentreHole of One("centre-holes") {
        pilot: Micrometres,
        cone: Micrometres,
        protected: Micrometres,
        pilot_length: Micrometres,
        cone_depth: Micrometres,
        protected_depth: Micrometres,
        part_diameter: Micrometres,
        drill: &'t str,
        protecting_drill: &'t str,
        body: Micrometres,
        protected_body: Micrometres,
    }
}
