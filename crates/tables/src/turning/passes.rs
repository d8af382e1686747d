//! Zones of stock and the schemes of passes that clear them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_knowledge::units::{Micrometres, MillimetresPerMinute, Roughness};
use technolog_knowledge::{rows, vocabulary};

use super::part::{BlankShape, Holding};

vocabulary! {
    /// Kinds of zones (lecture 12.3, l. 221-269), in the order of fig. 12.3.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum ZoneKind {
        /// Free on both sides.
        Open = "open",
        /// Bounded on one side.
        HalfOpen = "half-open",
        /// Bounded on both.
        Closed = "closed",
        /// Of two or three kinds.
        Combined = "combined",
    }

    /// The kinds of zones in a combined zone.
    pub enum ZoneParts {
        /// Of one kind.
        Alone = "alone",
        /// Of two.
        OpenAndHalfOpen = "open-and-half-open",
        /// Of two.
        OpenAndClosed = "open-and-closed",
        /// Of two.
        HalfOpenAndClosed = "half-open-and-closed",
        /// Of all three.
        AllThree = "all-three",
    }

    /// The elements of a contour.
    pub enum ContourShape {
        /// Cylinders and faces.
        Stepped = "stepped",
        /// Cones or arcs too.
        Shaped = "shaped",
    }

    /// The seven schemes of roughing passes (lecture 12.4, l. 273-296); the table `turning-schemes` gives the use of
    /// each.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Scheme {
        /// Return through the air after each pass.
        Loop = "loop",
        /// Cutting in both directions.
        Zigzag = "zigzag",
        /// Cutting perpendicular to the axis.
        Descent = "descent",
        /// Each pass cleans the contour up to the previous pass.
        PickUp = "pick-up",
        /// A pass along the whole contour after the others.
        SemiFinishing = "semi-finishing",
        /// Passes at equal distances from the contour.
        Equidistant = "equidistant",
        /// The contour repeatedly, shifted.
        Contour = "contour",
    }

    /// The order of work in a combined zone.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum PartsWorked {
        /// The whole zone at once.
        Whole = "whole",
        /// Part after part.
        Each = "each",
        /// All parts but the closed ones together, the closed ones separately.
        Joined = "joined",
    }

    /// A scheme of removal.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Removal {
        /// Cycles of verticals: cylinder after cylinder (fig. 12.7).
        Verticals = "verticals",
        /// Cycles of levels: level after level over all cylinders (fig. 12.8).
        Levels = "levels",
        /// Cycles of horizontals: straight passes that leave at most one depth over each cylinder, then one pass
        /// along the contour (fig. 12.9 a).
        HorizontalsA = "horizontals-a",
        /// As above, but the stock for the pass along the contour is less than the depth everywhere (fig. 12.9 b).
        HorizontalsB = "horizontals-b",
    }

    /// The roughing passes of a stepped shaft.
    pub enum Passes {
        /// Along the axis.
        Lengthwise = "lengthwise",
        /// Along or across, whichever is shorter.
        Searched = "searched",
        /// Along the contour.
        Contour = "contour",
    }

    /// The quantities of the table `turning-motion`.
    pub enum Motion {
        /// The feed along the axis.
        LongitudinalFeed = "longitudinal-feed",
        /// The feed perpendicular to the axis.
        TransverseFeed = "transverse-feed",
        /// The rapid.
        Rapid = "rapid",
        /// The distance before the metal where the feed begins.
        Approach = "approach",
        /// The retract of the tool.
        Retract = "retract",
    }
}

rows! {
    /// Direction of the roughing passes in turning.
    pub struct PassDirection of One("pass-direction") asked by PassDirectionFor {
        blank_shape: BlankShape,
        holding: Holding,
    } {
        direction: Passes,
    }

    /// Schemes that remove the rough stock of stepped shafts: their order among equals.
    pub struct RemovalScheme of One("removal-scheme") asked by RemovalSchemeFor {
        scheme: Removal,
    } {
        preference: i64,
    }

    /// Rates and distances of turning motions where the shaft file says nothing.
    pub struct TurningMotion of One("turning-motion") asked by TurningMotionFor {
        quantity: Motion,
    } {
        rate: Option<MillimetresPerMinute>,
        distance: Option<Micrometres>,
    }

    /// Scheme of the roughing passes for a zone.
    pub struct TurningScheme of One("turning-scheme") asked by TurningSchemeFor {
        zone: ZoneKind,
        parts: ZoneParts,
        contour: ContourShape,
        against_stop: bool,
        blank_shape: BlankShape,
    } {
        schemes: Vec<Scheme>,
        also: Option<Vec<Scheme>>,
        parts_worked: PartsWorked,
        return_way: &'t str,
    }

    /// Schemes of roughing passes in turning.
    pub struct TurningSchemes of One("turning-schemes") complete scheme {
        scheme: Scheme,
        finest: Option<Roughness>,
    } shown { zones, working_feeds, even_allowance, what_uk, what_en }

    /// Zones of turning: what bounds them.
    pub struct TurningZone of One("turning-zone") asked by TurningZoneFor {
        parts: ZoneParts,
        face_ahead: bool,
        face_behind: bool,
    } {
        zone: ZoneKind,
    } shown { limits_main_angle, limits_auxiliary_angle }
}
