//! What must stay open over the metal when a tool is deepest: flutes that chips leave by, and room under its holder.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::plan::Operation;
use crate::tables::practice::{ProofLimit, ProofLimits};
use crate::tables::rules::{HoleCycle, MachiningCycleFor};
use crate::units::Micrometres;

/// How a drill goes into its hole.
#[derive(Clone, Copy, Debug)]
pub struct Drilling<'a> {
    /// What is done.
    pub operation: Operation,
    /// Its diameter.
    pub diameter: Micrometres,
    /// The depth of its full diameter, from where it meets metal.
    pub depth: Micrometres,
    /// The height of its point.
    pub point: Micrometres,
    /// The group of the material.
    pub material_group: &'a str,
}

/// The length of flutes that must stay open over the metal when the tip is deepest; zero for tools that are no drills.
///
/// In one go l ≥ depth + k·d, with the point counted in k·d (row `drill-flute-room`). A drill that is brought out after every
/// step carries the chips of that step with it, and one that opens a hole has room in that: l ≥ depth + point + k·d with a
/// smaller k (row `drill-flute-room-pecked`).
///
/// # Errors
/// The knowledge base has no answer.
pub fn chip_room(drilling: &Drilling<'_>, knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    let Drilling { operation, diameter, depth, point, material_group } = *drilling;
    if !matches!(operation, Operation::Drill | Operation::DrillOut) || diameter <= Micrometres::ZERO {
        return Ok(Micrometres::ZERO);
    }
    let depth_ratio = depth.max(Micrometres::ZERO).to_mm() / diameter.to_mm();
    let question = MachiningCycleFor { operation, depth_ratio, material_group };
    // The hole that a drill opens takes its chips, too.
    let pecked =
        operation == Operation::DrillOut || knowledge.ask(&question)?.need(operation.name())?.cycle == HoleCycle::Peck;
    let of = if pecked { ProofLimit::DrillFluteRoomPecked } else { ProofLimit::DrillFluteRoom };
    let room = Micrometres::from_mm_rounded(limit(of, knowledge)? * diameter.to_mm());
    Ok(if pecked { room } else { (room - point).max(Micrometres::ZERO) })
}

/// How far the holder must stay over the face.
///
/// # Errors
/// The knowledge base has no answer.
pub fn holder_over_face(knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    Ok(Micrometres::from_mm_rounded(limit(ProofLimit::HolderOverFace, knowledge)?))
}

fn limit(name: ProofLimit, knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    Ok(knowledge.need(name.name(), |row: &ProofLimits<'_>| row.name.is(name))?.value)
}
