//! How thick a tool with its holder is along its axis: what is held against clamps and obstacles beside it.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::plan::{Plan, ToolPlan};
use crate::shop::Shop;
use crate::tables::holders::HolderRow;
use crate::tables::standards::SpindleNose;
use crate::units::Micrometres;

/// A part of a tool that does not cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum BodyKind {
    /// The holder in front of its collar.
    Holder,
    /// The collar of the holder.
    Collar,
    /// The nose of the spindle.
    Nose,
}

impl BodyKind {
    /// Its name in sentences.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Holder => "holder",
            Self::Collar => "collar",
            Self::Nose => "nose",
        }
    }
}

/// A cylinder of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Body {
    /// What it is.
    pub kind: BodyKind,
    /// Where it begins over the tip, mm.
    pub from: Micrometres,
    /// Its diameter, mm; of a holder of unknown thickness that of its collar, than which it is no thicker as a rule.
    pub diameter: Micrometres,
    /// Whether the diameter is known.
    pub known: bool,
}

/// A tool of the plan with the cylinders over its cutter, from the tip upwards.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Envelope {
    /// Its number in the plan.
    pub tool: u32,
    /// The holder, by its designation.
    pub holder: String,
    /// The cylinders.
    pub bodies: Vec<Body>,
}

/// The envelopes of the tools of a plan, by the tables of holders and `spindle-noses`.
///
/// # Errors
/// A table cannot be read.
pub(super) fn envelopes(plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Envelope>, KnowledgeError> {
    let noses: Vec<SpindleNose> = shop.knowledge.rows()?;
    let nose = noses.iter().find(|nose| nose.number == shop.machine.taper);
    plan.tools.iter().map(|tool| envelope(tool, nose, shop)).collect()
}

fn envelope(tool: &ToolPlan, nose: Option<&SpindleNose>, shop: &Shop<'_>) -> Result<Envelope, KnowledgeError> {
    let mut thick = None;
    if let Ok(table) = shop.knowledge.table(&tool.holder_table) {
        for row in table.rows::<HolderRow<'_>>() {
            let row = row?;
            thick = thick.or(row.max_diameter.filter(|_| row.designation == tool.holder));
        }
    }
    let mut bodies = Vec::new();
    let collar = nose.map(|nose| nose.collar_diameter);
    // A plan that somebody wrote may say nothing of its holders.
    if let Some(diameter) = thick.or(collar).filter(|_| tool.overhang_mm > Micrometres::ZERO) {
        bodies.push(Body { kind: BodyKind::Holder, from: tool.overhang_mm, diameter, known: thick.is_some() });
    }
    if let Some(nose) = nose.filter(|_| tool.length_mm > Micrometres::ZERO) {
        // A collar that the holder is too short for begins with it.
        let from = (tool.length_mm - nose.collar_length).max(tool.overhang_mm);
        bodies.push(Body { kind: BodyKind::Collar, from, diameter: nose.collar_diameter, known: true });
        bodies.push(Body { kind: BodyKind::Nose, from: tool.length_mm, diameter: nose.nose_diameter, known: true });
    }
    Ok(Envelope { tool: tool.number, holder: tool.holder.clone(), bodies })
}
