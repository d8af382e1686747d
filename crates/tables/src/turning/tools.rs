//! Turning tools: their tables, their order, how fast they feed and what bounds them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_knowledge::units::{Degrees, ItGrade, Megapascals, Micrometres, MillimetresPerRev, Roughness};
pub use technolog_knowledge::vocabulary::Place;
use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// What a tool is for.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum ToolKind {
        /// Cylinders, faces and contours outside.
        Turning = "turning",
        /// The same inside.
        Boring = "boring",
        /// Grooves and parting, across the axis.
        Grooving = "grooving",
        /// Grooves in a face, along the axis.
        FaceGrooving = "face-grooving",
        /// Threads.
        Threading = "threading",
    }

    /// Which way a tool cuts.
    #[derive(Serialize, Deserialize, JsonSchema)]
    pub enum Hand {
        /// Right: towards the chuck.
        R = "R",
        /// Left: away from the chuck.
        L = "L",
        /// Neutral: both ways.
        N = "N",
    }

    /// What tools that fit are put in order by.
    pub enum Preference {
        /// The smallest φ1 first.
        LeastTrailAngle = "least-trail-angle",
        /// The thickest shank or bar first.
        LargestShank = "largest-shank",
        /// The widest blade first.
        WidestBlade = "widest-blade",
    }

    /// A constant of `turning-limits`.
    pub enum Limit {
        /// What the shank bears in bending.
        ShankStress = "shank-stress",
        /// Its modulus of elasticity.
        ShankModulus = "shank-modulus",
        /// How far its tip may give way.
        ShankDeflection = "shank-deflection",
        /// Overhang of a tool over the height of its shank.
        OverhangRatio = "overhang-ratio",
        /// Overhang of a bar over its diameter.
        BarOverhangRatio = "bar-overhang-ratio",
        /// Share of the motor's power that reaches the spindle.
        DriveEfficiency = "drive-efficiency",
        /// What of a boring bar stands out beyond the depth of the bore.
        BarClearance = "bar-clearance",
        /// How far the axis of a part may give way in roughing.
        PartDeflection = "part-deflection",
        /// How far it may in finishing, over the tolerance of the diameter.
        PartDeflectionShare = "part-deflection-share",
        /// Bending stress of a part over its strength.
        PartStressShare = "part-stress-share",
        /// The shallowest pass worth roughing with.
        LeastSensibleDepth = "least-sensible-depth",
        /// Real roughness over the one that follows from feed and nose.
        RoughnessPracticeFactor = "roughness-practice-factor",
        /// The least depth of finishing over the radius of the nose.
        FinishDepthShare = "finish-depth-share",
        /// The least feed of finishing, for each turn.
        FinishFeedLeast = "finish-feed-least",
        /// Between the jaws and the end of the tool's way.
        JawClearance = "jaw-clearance",
        /// The least of it, where little is left to grip.
        JawClearanceLeast = "jaw-clearance-least",
        /// How much of its edge a tool brings into a wall on its way up.
        WallShare = "wall-share",
        /// To what depths are told.
        DepthStep = "depth-step",
        /// Where feeds and formulas end.
        DepthMax = "depth-max",
    }
}

rows! {
    /// Rake of the seat by the clearance of the insert, its second letter by ISO 1832.
    pub struct InsertRake of One("insert-rake") {
        clearance: &'t str,
        rake: Degrees,
    }

    /// Insert shapes and their included angle: φ1 of a row follows from it, and a test holds the rows to that.
    pub struct InsertShapes of One("insert-shapes") {} shown { shape, included_angle }

    /// The share of an insert's edge that may cut, by its shape, the first letter by ISO 1832.
    pub struct InsertEdgeShare of One("insert-edge-share") {
        shape: &'t str,
        share: f64,
    }

    /// A turning tool.
    pub struct TurningToolRow of Each(&TOOL_TABLES) {
        designation: &'t str,
        kind: ToolKind,
        place_of_work: Place,
        hand: Hand,
        lead_angle: Degrees,
        trail_angle: Degrees,
        nose_radius: Option<Micrometres>,
        insert: Option<&'t str>,
        edge: Option<Micrometres>,
        bar_diameter: Option<Micrometres>,
        min_bore: Option<Micrometres>,
        reach: Option<Micrometres>,
        grades: Option<Vec<&'t str>>,
        width: Option<Micrometres>,
        groove_depth: Option<Micrometres>,
        face_diameter_min: Option<Micrometres>,
        shank_height: Option<Micrometres>,
        shank_width: Option<Micrometres>,
        pitch_min: Option<Micrometres>,
        pitch_max: Option<Micrometres>,
    } shown { length }

    /// Which of the turning tools that fit.
    pub struct TurningToolOrder of One("turning-tool-order") asked by TurningToolOrderFor {
        kind: ToolKind,
    } {
        prefer: Vec<Preference>,
    }

    /// Whether a tool can cut back.
    pub struct TurningCutBack of One("turning-cut-back") asked by TurningCutBackFor {
        trail_angle: Degrees,
    } {
        cuts_back: bool,
    }

    /// Roughness that the drawing does not say.
    pub struct TurningRoughnessUnsaid of One("turning-roughness-unsaid") asked by TurningRoughnessUnsaidFor {
        it: Option<ItGrade>,
    } {
        roughness: Roughness,
    }

    /// Strength factor of the finish turning feed.
    pub struct TurningFinishFeedStrength of One("turning-finish-feed-strength") asked by TurningFinishFeedStrengthFor {
        strength: Megapascals,
    } {
        factor: f64,
    }

    /// Finish turning feed by roughness, the other cells.
    pub struct TurningFinishFeed of One("turning-finish-feed") asked by TurningFinishFeedFor<'t> {
        roughness: Roughness,
        nose_radius: &'t str,
    } {
        feed: MillimetresPerRev,
    }

    /// Angle factor of the forces Kφp.
    pub struct TurningForceAngle of One("turning-force-angle") asked by TurningForceAngleFor {
        lead_angle: Degrees,
    } {
        pz: f64,
        py: f64,
        px: f64,
    }

    /// Rake factor of the forces Kγp.
    pub struct TurningForceRake of One("turning-force-rake") asked by TurningForceRakeFor {
        rake: Degrees,
    } {
        pz: f64,
        py: f64,
        px: f64,
    }

    /// Angle factor of the speed Kφv.
    pub struct TurningSpeedAngle of One("turning-speed-angle") asked by TurningSpeedAngleFor {
        lead_angle: Degrees,
    } {
        factor: f64,
    }

    /// Constants of the limiting depth of cut; each has one of the three.
    pub struct TurningLimits of One("turning-limits") complete name {
        name: Limit,
        stress: Option<Megapascals>,
        ratio: Option<f64>,
        length: Option<Micrometres>,
    }
}

/// The tables of tools, in the order in which they are asked.
pub const TOOL_TABLES: [&str; 4] =
    ["turning-outer-tools", "turning-boring-bars", "turning-grooving-tools", "turning-threading-tools"];
