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

    /// What kinds of zones a zone consists of.
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

    /// What a contour is made of.
    pub enum ContourShape {
        /// Cylinders and faces.
        Stepped = "stepped",
        /// Cones or arcs too.
        Shaped = "shaped",
    }

    /// The seven schemes of roughing passes (lecture 12.4, l. 273-296); the table `turning-schemes` tells what each is for.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Scheme {
        /// Back through the air after each pass.
        Loop = "loop",
        /// Cutting there and back.
        Zigzag = "zigzag",
        /// Cutting across.
        Descent = "descent",
        /// Each pass cleans the contour up to the pass before.
        PickUp = "pick-up",
        /// A pass along the whole contour after the others.
        SemiFinishing = "semi-finishing",
        /// Passes at even distances from the contour.
        Equidistant = "equidistant",
        /// The contour again and again, shifted.
        Contour = "contour",
    }

    /// How the parts of a combined zone are worked.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum PartsWorked {
        /// All of it at once.
        Whole = "whole",
        /// Part after part.
        Each = "each",
        /// All but the closed parts as one, these by themselves.
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
        /// Cycles of horizontals: straight passes, which leave at most one depth over each cylinder, then one pass along
        /// the contour (fig. 12.9 a).
        HorizontalsA = "horizontals-a",
        /// The same, but what is left for the pass along the contour is less than the depth everywhere (fig. 12.9 b).
        HorizontalsB = "horizontals-b",
    }

    /// Which passes rough a stepped shaft.
    pub enum Passes {
        /// Along the axis.
        Lengthwise = "lengthwise",
        /// Along and across, whichever is shorter.
        Searched = "searched",
        /// Along the contour.
        Contour = "contour",
    }

    /// What the table `turning-motion` has figures of.
    pub enum Motion {
        /// The feed along the axis.
        LongitudinalFeed = "longitudinal-feed",
        /// The feed across it.
        TransverseFeed = "transverse-feed",
        /// The rapid.
        Rapid = "rapid",
        /// How far before the metal the feed begins.
        Approach = "approach",
        /// How far the tool draws back.
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

    /// Schemes that remove the rough stock of stepped shafts: which among equals, the first first.
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
