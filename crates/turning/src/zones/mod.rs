//! Zones of turning (lecture 12.3, l. 205-269; 12.4, l. 488-546): the stock between the rough contour and the blank,
//! divided at its bounds, with the angles that each zone requires of a tool and the schemes that suit it.
//!
//! - [`setup`] decides which surfaces are turned from which end;
//! - [`parts`] divides the stock at every face and slope;
//! - [`join`] joins neighbours that one tool reaches, and counts the returns that this saves;
//! - [`kind`] takes the kind of a zone and its schemes from the rules;
//! - [`mod@fit`] compares tools with a zone.
//!
//! Zones of a bore are found inside out, and given in the radii of the bore.

mod far_threads;
pub mod fit;
mod hold;
pub mod join;
pub mod kind;
pub mod parts;
pub mod setup;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Because;
use crate::units::{Degrees, Micrometres};

use super::contour::{Contour, Side};
use super::length::{Half, negative_z};
pub use fit::{Fit, ToolAngles, fit};
pub use hold::{Hold, JawLengths};
pub use join::{Returns, idle_returns};
pub use kind::{SchemeChoice, ZoneKind};
pub use parts::{Needs, ZonePart};
pub use setup::{SetUp, TurnedSide, set_ups};

/// The stock of one set-up on one side, in the coordinates of that set-up.
#[derive(Clone, Copy, Debug)]
pub struct Stock<'a> {
    /// The rough contour, monotone.
    pub rough: &'a Contour,
    /// The blank on the same side; for a bore into solid metal, the drilled hole.
    pub blank: &'a Contour,
    /// Whether the blank has nearly the shape of the part: a forging or casting.
    pub near_part: bool,
    /// Whether stepped rollers are turned against a stop.
    pub against_stop: bool,
}

/// The direction of the passes of a zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Feed {
    /// Along the axis.
    Along,
    /// Across it: the free end is faced.
    Across,
}

/// A zone: the stock that one transition clears.
#[derive(Clone, Debug, Serialize)]
pub struct Zone {
    /// Its number, from 1.
    pub number: usize,
    /// Outer or inner.
    pub side: Side,
    /// The direction of its passes.
    pub feed: Feed,
    /// Z of its beginning, towards the chuck.
    #[serde(rename = "from_z_mm", serialize_with = "negative_z")]
    pub from_z: Half,
    /// Z of its end, towards the chuck.
    #[serde(rename = "to_z_mm", serialize_with = "negative_z")]
    pub to_z: Half,
    /// The least radius of its stock.
    #[serde(rename = "least_radius_mm")]
    pub least_radius: Half,
    /// The greatest radius of its stock.
    #[serde(rename = "greatest_radius_mm")]
    pub greatest_radius: Half,
    /// Its kind.
    pub kind: ZoneKind,
    /// Its parts: one or, for a combined zone, in the order of fig. 12.3 г, the open ones before the half-open and the
    /// closed.
    pub parts: Vec<ZonePart>,
    /// The angles that a tool needs.
    pub needs: Needs,
    /// The narrowest place that a boring bar passes, a diameter; none outside.
    #[serde(rename = "passage_mm", skip_serializing_if = "Option::is_none")]
    pub passage: Option<Micrometres>,
    /// Its schemes.
    pub scheme: SchemeChoice,
    /// The reason for its kind.
    pub because: Because,
}

/// The zones of a stock from the free end: the face before the rough contour, then its parts, joined as far as one of
/// the tools reaches. Without tools the contouring tool of the lecture is used.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or `turning-scheme`, or a row of one.
pub fn find(stock: Stock<'_>, tools: &[ToolAngles], knowledge: &Knowledge) -> Result<Vec<Zone>, KnowledgeError> {
    let apart = parts::of(stock, knowledge)?;
    let reference = [ToolAngles::contouring()];
    let tools = if tools.is_empty() { &reference } else { tools };
    let mut zones = Vec::new();
    if let Some(face) = apart.face {
        zones.push(join::zone(vec![face], Feed::Across, stock, knowledge)?);
    }
    for group in join::groups(apart.along, tools) {
        zones.push(join::zone(group, Feed::Along, stock, knowledge)?);
    }
    for (index, zone) in zones.iter_mut().enumerate() {
        zone.number = index + 1;
    }
    Ok(zones)
}

/// No angle.
const NOTHING: Degrees = Degrees(0.0);
