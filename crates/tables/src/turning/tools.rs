//! Turning tools: their tables, their order, feeds and limits.

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

    /// The cutting direction of a tool.
    #[derive(Serialize, Deserialize, JsonSchema)]
    pub enum Hand {
        /// Right: towards the chuck.
        R = "R",
        /// Left: away from the chuck.
        L = "L",
        /// Neutral: both ways.
        N = "N",
    }

    /// The order of tools that fit.
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
        /// The permitted bending stress of the shank.
        ShankStress = "shank-stress",
        /// Its modulus of elasticity.
        ShankModulus = "shank-modulus",
        /// The permitted deflection of the tip.
        ShankDeflection = "shank-deflection",
        /// Overhang of a tool, divided by the height of its shank.
        OverhangRatio = "overhang-ratio",
        /// Overhang of a bar, divided by its diameter.
        BarOverhangRatio = "bar-overhang-ratio",
        /// The same of a bar of carbide.
        CarbideBarOverhangRatio = "carbide-bar-overhang-ratio",
        /// The modulus of elasticity of a bar of carbide.
        CarbideShankModulus = "carbide-shank-modulus",
        /// Share of the motor's power that reaches the spindle.
        DriveEfficiency = "drive-efficiency",
        /// The overhang of a boring bar beyond the depth of the bore.
        BarClearance = "bar-clearance",
        /// The permitted deflection of a part in roughing.
        PartDeflection = "part-deflection",
        /// The permitted deflection in finishing, divided by the tolerance of the diameter.
        PartDeflectionShare = "part-deflection-share",
        /// The same, as far as a second pass at the same setting still mends it.
        PartDeflectionMost = "part-deflection-most",
        /// Bending stress of a part, divided by its strength.
        PartStressShare = "part-stress-share",
        /// The least depth of a useful roughing pass.
        LeastSensibleDepth = "least-sensible-depth",
        /// Real roughness, divided by the theoretical one from feed and nose radius.
        RoughnessPracticeFactor = "roughness-practice-factor",
        /// The least depth of finishing, divided by the nose radius.
        FinishDepthShare = "finish-depth-share",
        /// The least feed of finishing, per revolution.
        FinishFeedLeast = "finish-feed-least",
        /// Clearance between the jaws and the end of the toolpath.
        JawClearance = "jaw-clearance",
        /// The least clearance, where little is left for gripping.
        JawClearanceLeast = "jaw-clearance-least",
        /// The step bored into soft jaws, divided by the length of the part.
        SoftJawShare = "soft-jaw-share",
        /// The share of its edge that a tool brings into a wall while it rises.
        WallShare = "wall-share",
        /// The step to which depths are rounded.
        DepthStep = "depth-step",
        /// The limit of feeds and formulas.
        DepthMax = "depth-max",
    }
}

rows! {
    /// Rake of the seat by the clearance of the insert, its second letter by ISO 1832.
    pub struct InsertRake of One("insert-rake") {
        clearance: &'t str,
        rake: Degrees,
    }

    /// Insert shapes and their included angle: φ1 of a row follows from it, and a test checks the rows.
    pub struct InsertShapes of One("insert-shapes") {} shown { shape, included_angle }

    /// The largest roughing feed as a share of the nose radius, by the shape of the insert.
    pub struct InsertNoseFeed of One("insert-nose-feed") {
        shape: &'t str,
        share: f64,
    }

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
        carbide_bar: Option<bool>,
        min_bore: Option<Micrometres>,
        reach: Option<Micrometres>,
        grades: Option<Vec<&'t str>>,
        width: Option<Micrometres>,
        groove_depth: Option<Micrometres>,
        own_width: Option<bool>,
        face_diameter_min: Option<Micrometres>,
        shank_height: Option<Micrometres>,
        shank_width: Option<Micrometres>,
        pitch_min: Option<Micrometres>,
        pitch_max: Option<Micrometres>,
        insert_side: Option<Micrometres>,
    } shown { length }

    /// The choice among turning tools that fit.
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

    /// Roughness where the drawing gives none.
    pub struct TurningRoughnessUnsaid of One("turning-roughness-unsaid") asked by TurningRoughnessUnsaidFor {
        it: Option<ItGrade>,
    } {
        roughness: Roughness,
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

/// The tables of tools, in the order of queries.
pub const TOOL_TABLES: [&str; 4] =
    ["turning-outer-tools", "turning-boring-bars", "turning-grooving-tools", "turning-threading-tools"];
