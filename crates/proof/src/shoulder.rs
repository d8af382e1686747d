//! Points of drills over flat shoulders: what reaches below one must fit into the hole there.

use crate::error::KnowledgeError;
use crate::part::{Bottom, Face, Hole};
use crate::plan::{Feature, Operation, Transition};
use crate::shop::Shop;
use crate::units::Micrometres;

use super::Fault;

/// A point that cuts a crater into a flat shoulder; none for a drill that is in no catalog.
///
/// On the level of the shoulder the cone is 2·(tip − shoulder)·tan(φ/2) wide, mm.
///
/// # Errors
/// The knowledge base has no answer.
pub(crate) fn gouged(transition: &Transition, hole: &Hole, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let operation = transition.operation;
    if !matches!(operation, Operation::Drill | Operation::DrillOut) || transition.elsewhere {
        return Ok(None);
    }
    let Some((face, shoulder)) = shoulder(transition, hole) else { return Ok(None) };
    let table = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table);
    let Some(angle) = table.and_then(|table| table.head.point_angle) else { return Ok(None) };
    let below = below(face, shoulder, hole);
    let slope = libm::tan((angle.to_f64() / 2.0).to_radians());
    let deeper = transition.end() - shoulder;
    let crater = Micrometres::from_mm_rounded(2.0 * deeper.to_mm() * slope).min(transition.diameter_mm);
    Ok((crater > below).then_some(Fault::Gouges { operation, crater, shoulder, below }))
}

/// The face and the depth of the flat shoulder that a transition works above.
fn shoulder(transition: &Transition, hole: &Hole) -> Option<(Face, Micrometres)> {
    match (transition.feature, transition.step) {
        (Feature::Counterbore, _) => hole.counterbore.map(|counterbore| (Face::Entry, counterbore.depth)),
        (Feature::Step, Some(number)) => {
            let step = hole.steps.get(number.checked_sub(1)?)?;
            (step.bottom == Bottom::Flat).then_some((step.face, step.depth))
        }
        _ => None,
    }
}

/// The widest finished cylinder below a shoulder: the hole itself, or a step from the same face that goes deeper.
fn below(face: Face, shoulder: Micrometres, hole: &Hole) -> Micrometres {
    let deeper = hole.steps.iter().filter(|step| step.face == face && step.depth > shoulder);
    deeper.map(|step| step.diameter.largest()).max().unwrap_or_default().max(hole.diameter.largest())
}
