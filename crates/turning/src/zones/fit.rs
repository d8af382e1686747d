//! Compares tools with a zone: which fit, and for every other the inequality that fails.

use serde::Serialize;

use crate::note::{Figure, Note};
use crate::turning::contour::Side;
use crate::turning::elements::{Angles, Hand};
use crate::turning::length::Half;
use crate::units::{Degrees, Micrometres, round_to};

use super::parts::Needs;
use super::{Zone, ZoneKind};

/// How far an angle of a contour of rounded points may be above that of the tool, degrees: half a micrometre over half
/// a millimetre.
const TRIFLE: f64 = 0.06;

/// The figures of a tool for the check of its fit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToolAngles {
    /// Its designation.
    pub name: String,
    /// Its angles and its hand.
    #[serde(flatten)]
    pub angles: Angles,
    /// For a boring bar, the smallest bore that it enters.
    #[serde(rename = "least_bore_mm", skip_serializing_if = "Option::is_none")]
    pub least_bore: Option<Micrometres>,
    /// For a boring bar, the deepest bore that it reaches the end of.
    #[serde(rename = "reach_mm", skip_serializing_if = "Option::is_none")]
    pub reach: Option<Half>,
    /// For a grooving tool, its width. It plunges, so its angles do not count.
    #[serde(rename = "width_mm", skip_serializing_if = "Option::is_none")]
    pub width: Option<Half>,
}

impl ToolAngles {
    /// The contouring tool of the lecture.
    pub fn contouring() -> Self {
        Self { name: "φ95 φ1 30".to_owned(), angles: Angles::CONTOURING, least_bore: None, reach: None, width: None }
    }
}

/// A tool that does not fit, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RefusedTool {
    /// Its designation.
    pub tool: String,
    /// Every inequality that fails.
    pub why: Vec<Note>,
}

/// The result of comparing tools with a zone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fit {
    /// Those that fit, in the given order.
    pub fitting: Vec<String>,
    /// The others.
    pub refused: Vec<RefusedTool>,
}

/// Compares tools with a zone. The face of the free end requires an edge that is not ahead of its tip.
pub fn fit(zone: &Zone, tools: &[ToolAngles]) -> Fit {
    let mut compared = Fit { fitting: Vec::new(), refused: Vec::new() };
    let closed = |part: &&super::ZonePart| part.kind == ZoneKind::Closed;
    let floor = zone.parts.iter().filter(closed).map(|part| part.floor_length).min();
    // Where no bar reaches the end of the bore, those that come nearest fit, and their cut is refused.
    let bars = tools.iter().filter(|tool| zone.side == Side::Inner && reaches(zone.needs, zone.passage, tool));
    let farthest = bars.filter_map(|tool| tool.reach).max();
    for tool in tools {
        let mut why = refusals(zone.needs, zone.passage, floor, tool);
        let short = |reach: &Half| farthest.is_some_and(|farthest| *reach < zone.to_z.min(farthest));
        if let Some(reach) = tool.reach.filter(short) {
            why.push(Note::new("tool-bar-too-short").with("depth", zone.to_z).with("reach", reach));
        }
        if tool.width.is_some() && zone.kind != ZoneKind::Closed {
            why.push(Note::new("tool-only-for-grooves").with("kind", Figure::word(zone.kind.name())));
        }
        if why.is_empty() {
            compared.fitting.push(tool.name.clone());
        } else {
            compared.refused.push(RefusedTool { tool: tool.name.clone(), why });
        }
    }
    compared
}

/// Whether a tool satisfies the angles of a contour and enters its bore.
pub fn reaches(needs: Needs, passage: Option<Micrometres>, tool: &ToolAngles) -> bool {
    refusals(needs, passage, None, tool).is_empty()
}

/// Every inequality that a tool does not satisfy.
pub(super) fn refusals(
    needs: Needs,
    passage: Option<Micrometres>,
    floor: Option<Half>,
    tool: &ToolAngles,
) -> Vec<Note> {
    let mut why = Vec::new();
    let bar = tool.least_bore.zip(passage).filter(|(least, passage)| least > passage);
    if let Some((least, passage)) = bar {
        why.push(Note::new("tool-bore-too-small").with("least", least).with("bore", passage));
    }
    if let Some(width) = tool.width {
        if let Some(floor) = floor.filter(|floor| width > *floor) {
            why.push(Note::new("tool-wider-than-groove").with("width", width).with("floor", floor));
        }
        return why;
    }
    // A tool of the other hand meets the fall first.
    let (main, secondary) = match tool.angles.hand {
        Hand::Right => (needs.main, needs.secondary),
        Hand::Left => (needs.secondary, needs.main),
    };
    let angle = |degrees: Degrees| round_to(degrees.0, 2);
    if main.0 > tool.angles.main.0 + TRIFLE {
        why.push(Note::new("tool-main-angle").with("has", angle(tool.angles.main)).with("needs", angle(main)));
    }
    if secondary.0 > tool.angles.secondary.0 + TRIFLE {
        let has = angle(tool.angles.secondary);
        why.push(Note::new("tool-secondary-angle").with("has", has).with("needs", angle(secondary)));
    }
    why
}
