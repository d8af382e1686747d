//! The schemes of rough transitions (lecture 12.4, l. 271-520, table 12.1, fig. 12.4), each as a toolpath over a zone
//! of any shape: lines and arcs between a rough contour and a blank.
//!
//! [`work`] makes the toolpath of a scheme. Each scheme is a file: [`looped`], [`zigzag`], [`descent`], [`pick_up`],
//! [`semi_finishing`], [`equidistant`], [`contour`]. They share [`split`] (the levels), [`straight`] (straight
//! passes), [`builder`] (a toolpath under construction), [`monotone`] (the rough contour) and [`in_process_stock`].
//! [`zone`] prepares a zone for all schemes, [`check`] refuses zones that cannot be worked, [`narrow`] defines the
//! least width that counts, [`support_points`] names the support points, [`measures`] measures and compares.
//!
//! A toolpath is that of the theoretical point of the tool on the rough contour: the corner of the two tangents to
//! its nose, along the axis and across it. On cylinders and perpendicular faces ahead the true edge cuts the same. On
//! a piece that rises at an angle α to the axis the nose of radius r leaves r·(sin α + cos α − 1) more, normal to the
//! contour; on one that falls at α it cuts r·(1 + sin α − cos α) too deep. The program must compensate for that, not
//! this module. (The centre of the nose is r before the point and r above it; subtract r from its distance from the
//! contour.)
//!
//! Architecture invariant: every contour is treated as an outer one; a bore is turned inside out.

pub mod builder;
pub mod check;
pub mod contour;
pub mod descent;
pub mod equidistant;
pub mod in_process_stock;
pub mod looped;
pub mod measures;
pub mod monotone;
pub mod narrow;
pub mod pick_up;
pub mod semi_finishing;
pub mod split;
pub mod straight;
pub mod support_points;
pub mod zigzag;
pub mod zone;

use serde::Serialize;

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, Finding, Note, Severity};
use crate::tables::turning::passes::TurningSchemes;
use crate::units::{Degrees, MillimetresPerMinute, Roughness};

use super::contour::Contour;
use super::length::Half;
use super::toolpath::{Purpose, Toolpath};
use super::workpiece;
use check::Unsuited;
use equidistant::Offset;
use measures::ToolpathMeasures;
use support_points::SupportPoint;
pub use zone::PreparedZone;

/// The stock to remove between two contours over one range of Z.
///
/// Both contours run from the free end towards the chuck and never back. A wall at an end of the zone is a face of the
/// rough contour. Beyond the ends there is no metal for the tool, but it never goes beyond `to`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Stock {
    /// The contour after roughing; it is nowhere above the blank.
    pub rough: Contour,
    /// The blank.
    pub blank: Contour,
    /// Z of its beginning.
    pub from: Half,
    /// Z of its end.
    pub to: Half,
}

/// The figures of a tool that a toolpath depends on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Tool {
    /// Nose radius.
    pub nose_radius: Half,
    /// The main angle φ: the steepest rise of a contour.
    pub main: Degrees,
    /// The secondary angle φ1: the steepest fall of a contour.
    pub secondary: Degrees,
}

/// The rate of each kind of motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Feeds {
    /// Of straight passes, S0.
    pub main: MillimetresPerMinute,
    /// Of infeed, and of return moves along the contour of a closed zone.
    pub infeed: MillimetresPerMinute,
    /// Of picking up.
    pub pick_up: MillimetresPerMinute,
    /// Of the semi-finishing pass.
    pub semi_finish: MillimetresPerMinute,
    /// Of finishing.
    pub finish: MillimetresPerMinute,
    /// Rapids of an axis.
    pub rapid: MillimetresPerMinute,
}

impl Feeds {
    /// The rate of a motion.
    pub const fn rate(&self, purpose: Purpose) -> MillimetresPerMinute {
        match purpose {
            Purpose::Rapid => self.rapid,
            Purpose::Cut => self.main,
            // The passes of a zone have no threads; their infeed is a plunge.
            Purpose::Infeed | Purpose::Return | Purpose::Plunge | Purpose::Thread => self.infeed,
            Purpose::PickUp => self.pick_up,
            Purpose::SemiFinish => self.semi_finish,
            Purpose::Finish => self.finish,
        }
    }
}

/// The settings of the tool's motions. All lengths are positive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Settings {
    /// t_p, the greatest depth of a pass; for descent the width of a slice.
    pub depth: Half,
    /// δ: the distance before the metal where the feed begins.
    pub approach: Half,
    /// The retract; the lecture says about 0.5 mm.
    pub retract: Half,
    /// The rates.
    pub feeds: Feeds,
}

/// A scheme of rough transitions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scheme {
    /// Loop.
    Loop,
    /// Loop against a stop, for stepped rollers.
    LoopAgainstStop,
    /// Zigzag.
    Zigzag,
    /// Descent.
    Descent,
    /// With pick-up.
    PickUp,
    /// With a semi-finishing pass.
    SemiFinishing,
    /// Equidistant.
    Equidistant,
    /// Contour.
    Contour,
}

impl Scheme {
    /// Every scheme, in the order of the lecture.
    pub const ALL: [Self; 8] = [
        Self::Loop,
        Self::LoopAgainstStop,
        Self::Zigzag,
        Self::Descent,
        Self::PickUp,
        Self::SemiFinishing,
        Self::Equidistant,
        Self::Contour,
    ];

    /// Its name in answers.
    pub const fn name(self) -> &'static str {
        match self {
            Self::LoopAgainstStop => "loop-against-stop",
            other => other.row().name(),
        }
    }

    /// Its row in the table `turning-schemes`, which has one for both forms of the loop.
    pub const fn row(self) -> workpiece::Scheme {
        match self {
            Self::Loop | Self::LoopAgainstStop => workpiece::Scheme::Loop,
            Self::Zigzag => workpiece::Scheme::Zigzag,
            Self::Descent => workpiece::Scheme::Descent,
            Self::PickUp => workpiece::Scheme::PickUp,
            Self::SemiFinishing => workpiece::Scheme::SemiFinishing,
            Self::Equidistant => workpiece::Scheme::Equidistant,
            Self::Contour => workpiece::Scheme::Contour,
        }
    }

    /// That row.
    fn record(self, knowledge: &Knowledge) -> Result<TurningSchemes<'_>, KnowledgeError> {
        knowledge.need(self.row().name(), |row: &TurningSchemes<'_>| row.scheme == self.row())
    }
}

/// The scheme that a file requires. A file cannot require the one against a stop.
impl From<workpiece::Scheme> for Scheme {
    fn from(asked: workpiece::Scheme) -> Self {
        match asked {
            workpiece::Scheme::Loop => Self::Loop,
            workpiece::Scheme::Zigzag => Self::Zigzag,
            workpiece::Scheme::Descent => Self::Descent,
            workpiece::Scheme::PickUp => Self::PickUp,
            workpiece::Scheme::SemiFinishing => Self::SemiFinishing,
            workpiece::Scheme::Equidistant => Self::Equidistant,
            workpiece::Scheme::Contour => Self::Contour,
        }
    }
}

/// A rough transition: a zone cleared by a scheme.
#[derive(Clone, Debug, Serialize)]
pub struct Transition {
    /// The scheme.
    pub scheme: Scheme,
    /// The toolpath, from the home point and back.
    #[serde(rename = "way")]
    pub path: Toolpath,
    /// Its points with their names: first the home point, then the end of each move.
    pub points: Vec<SupportPoint>,
    /// For descent, the width of the tool's edge, which a motion across the axis clears towards the free end.
    #[serde(rename = "edge_mm", skip_serializing_if = "Option::is_none")]
    pub edge: Option<Half>,
    /// The greatest height above the rough contour, radial; 0 if only rounding remains. Where an arc of the blank
    /// remains over a slope it is an upper bound.
    pub ridges_mm: Half,
    /// Whether the allowance for finishing is even, without ridges.
    pub uniform: bool,
    /// Its lengths, its time and its passes.
    pub measures: ToolpathMeasures,
    /// The reason: its row in the table `turning-schemes`.
    pub because: Because,
}

/// Makes the toolpath of a scheme over a zone, outer or inner. Only the equidistant scheme calls `offset`, for its
/// offset curves. For several schemes over one zone, prepare a [`PreparedZone`] once.
///
/// # Errors
/// The zone, the tool or the settings do not suit ([`check`]), an offset curve cannot be made, or the
/// knowledge base lacks the scheme.
pub fn work(
    stock: &Stock,
    tool: &Tool,
    settings: &Settings,
    scheme: Scheme,
    offset: Offset<'_>,
    knowledge: &Knowledge,
) -> Tried<Transition, Unsuited> {
    PreparedZone::of(stock, tool, settings)?.transition(scheme, offset, knowledge)
}

/// A finding if a scheme cannot leave the required roughness and finishing must follow: if the table
/// `turning-schemes` gives the finest roughness of the scheme as the last one, and the required roughness is finer.
///
/// # Errors
/// The knowledge base lacks the scheme.
pub fn finishing_must_follow(
    scheme: Scheme,
    asked: Roughness,
    knowledge: &Knowledge,
) -> Result<Option<Finding>, KnowledgeError> {
    let Some(finest) = scheme.record(knowledge)?.finest else { return Ok(None) };
    let note = Note::new("finishing-must-follow")
        .with("scheme", Figure::scheme(scheme.name()))
        .with("finest", finest)
        .with("asked", asked);
    Ok((asked < finest).then(|| Finding::of_part(Severity::Note, note)))
}
