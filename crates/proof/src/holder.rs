//! The holder over the face when its tool is deepest.

use crate::chip_room::holder_over_face;
use crate::error::KnowledgeError;
use crate::part::{Face, Hole};
use crate::plan::{HolePlan, Operation, Plan};
use crate::shop::Shop;

use super::{Fault, tool};

/// Holders that come too near to the face. An arbor follows its shell cutter in, and a wider opening may let a holder in, too:
/// those the proof of programs holds against the width of the opening.
pub(super) fn low(hole: &Hole, planned: &HolePlan, plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Fault>, KnowledgeError> {
    let least = holder_over_face(shop.knowledge)?;
    let opened = hole.counterbore.is_some() || hole.steps.iter().any(|step| step.face == Face::Entry);
    let mut faults = Vec::new();
    for transition in planned.transitions.iter().filter(|one| !one.elsewhere && !opened) {
        let tool = plan.tools.iter().find(|tool| tool.number == transition.tool.number);
        let row = tool::row(transition, shop)?;
        let Some(tool) = tool.filter(|_| row.is_some_and(|row| row.bore.is_none())) else { continue };
        let (operation, overhang, tip) = (transition.operation, tool.overhang_mm, transition.end());
        if operation != Operation::CentreDrill && overhang - tip < least {
            faults.push(Fault::HolderLow { operation, overhang, tip, least });
        }
    }
    Ok(faults)
}
