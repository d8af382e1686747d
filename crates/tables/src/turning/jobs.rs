//! Grooves, threads, holes on the axis and parting: how they are divided, how fast they are cut.

use technolog_knowledge::units::{Degrees, MetresPerMinute, Micrometres, MillimetresPerRev};
use technolog_knowledge::{rows, vocabulary};

use super::part::Side;

vocabulary! {
    /// A constant of `turning-job-limits`.
    pub enum JobLimit {
        /// Between two plunges, over the width of the blade.
        PlungeStep = "plunge-step",
        /// What is left for finishing a groove, over the corner radius of the blade.
        GrooveAllowance = "groove-allowance",
        /// The most that a blade takes sideways when it finishes.
        GrooveFinishDepth = "groove-finish-depth",
        /// From which depth a blade is drawn back on its way, over its width.
        PeckFrom = "peck-from",
        /// A step of such a way, over the width of the blade.
        PeckStep = "peck-step",
        /// How far it is drawn back.
        PeckRetract = "peck-retract",
        /// Feed along a side, over the width of the blade.
        SideFeed = "side-feed",
        /// Depth times feed along a side, over the square of the width of the blade.
        SideLoad = "side-load",
        /// What the speed of grooving is multiplied by in a bore and in a face.
        InnerGroovingSpeed = "inner-grooving-speed",
        /// The least depth of a pass of a thread.
        ThreadLastPass = "thread-last-pass",
        /// Passes at the whole depth of a thread after the last.
        ThreadSpringPasses = "thread-spring-passes",
        /// The least way before a thread, in pitches.
        ThreadEntry = "thread-entry",
        /// Run-out of a thread: spindle speed times pitch, divided by this.
        ThreadRunOut = "thread-run-out",
        /// The way before a thread, in run-outs.
        ThreadRunIn = "thread-run-in",
        /// From the tip of a threading insert to its side.
        ThreadInsertSide = "thread-insert-side",
        /// From the crests to where the tool goes back.
        ThreadLift = "thread-lift",
        /// The deepest parting, over the width of the blade.
        PartingDepth = "parting-depth",
        /// The radius at which the feed of parting is reduced.
        PartingSlowFrom = "parting-slow-from",
        /// The feed from there, over that before.
        PartingSlowFeed = "parting-slow-feed",
        /// From the jaws to the parting tool.
        PartingJawGap = "parting-jaw-gap",
        /// How far the full diameter of a drill comes out of a hole that goes through.
        DrillBreakthrough = "drill-breakthrough",
        /// How wide a centre drill spots, over the drill that follows.
        SpotShare = "spot-share",
    }
}

rows! {
    /// Constants of grooves, threads, holes and parting; each has one of the two.
    pub struct JobLimits of One("turning-job-limits") complete name {
        name: JobLimit,
        ratio: Option<f64>,
        length: Option<Micrometres>,
    }

    /// Feed and speed of grooving by a maker, by the width of the blade.
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

    /// From where a metric thread is fed into the metal.
    pub struct ThreadingInfeed of One("threading-infeed") asked by ThreadingInfeedFor<'t> {
        pitch: Micrometres,
        material_group: &'t str,
    } {
        angle: Degrees,
    }

    /// The deepest first pass of a thread, and how many passes are added to those of the table.
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
    } shown { speed_max }

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
