//! What bounds the parts of the rough zone, and which scheme of passes the lecture gives each (rules `turning-zone` and
//! `turning-scheme`).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::{Answer, Input, Knowledge};
use crate::note::{Because, Note};
use crate::turning::length::Half;
use crate::turning::levels::Levels;

/// A zone, with the schemes that suit it.
#[derive(Clone, Debug, Serialize)]
pub struct Zone {
    /// Z of its beginning, mm.
    pub from_z_mm: Half,
    /// Z of its end, mm.
    pub to_z_mm: Half,
    /// `open`, `half-open`, `closed` or `combined`.
    pub zone: String,
    /// The schemes, in the order of work; more than one where the zone is worked in parts.
    pub schemes: Vec<String>,
    /// Why this kind.
    pub because_zone: Because,
    /// Why these schemes.
    pub because: Because,
}

/// The zone over each cylinder, and the whole one after them where there is more than one.
///
/// # Errors
/// The knowledge base lacks a rule or a row of it.
pub fn zones(levels: &Levels, knowledge: &Knowledge) -> Result<Vec<Zone>, KnowledgeError> {
    let cylinders: Vec<_> = levels.sections.iter().flat_map(|section| &section.cylinders).collect();
    let mut zones = Vec::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        // The stock of the next section of a stepped blank is a face ahead too, though not one of the contour.
        let stock_ahead = cylinders.get(index + 1).is_some_and(|next| next.from == cylinder.to);
        zones.push(zone(knowledge, cylinder.from, cylinder.to, cylinder.wall.is_some() || stock_ahead, "alone")?);
    }
    if let (Some(first), Some(last), true) = (cylinders.first(), cylinders.last(), cylinders.len() > 1) {
        let open = zones.iter().any(|zone| zone.zone == "open");
        let half_open = zones.iter().any(|zone| zone.zone == "half-open");
        let parts = if open && half_open { "open-and-half-open" } else { "alone" };
        zones.push(zone(knowledge, first.from, last.to, half_open, parts)?);
    }
    Ok(zones)
}

/// A stepped shaft has no face behind the tool: its cylinders grow towards the chuck.
fn zone(knowledge: &Knowledge, from: Half, to: Half, wall: bool, parts: &str) -> Result<Zone, KnowledgeError> {
    let rule = knowledge.table("turning-zone")?;
    let answer = rule.decide(&[
        ("parts", Input::Text(parts)),
        ("face_ahead", Input::Bool(wall)),
        ("face_behind", Input::Bool(false)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, parts))?;
    let kind = row.text("zone")?.to_owned();
    let because_zone = Because::answer(&answer, Note::new("zone-is").with("kind", &kind));
    let rule = knowledge.table("turning-scheme")?;
    let answer: Answer<'_> = rule.decide(&[
        ("zone", Input::Text(&kind)),
        ("parts", Input::Text(parts)),
        ("contour", Input::Text("stepped")),
        ("against_stop", Input::Bool(false)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, &kind))?;
    let schemes: Vec<String> = row.texts("schemes")?.into_iter().map(str::to_owned).collect();
    let because = Because::answer(&answer, Note::new("zone-scheme").with("kind", &kind));
    Ok(Zone { from_z_mm: Half::ZERO - from, to_z_mm: Half::ZERO - to, zone: kind, schemes, because_zone, because })
}
