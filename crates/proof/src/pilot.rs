//! The pilot of a counterbore in a blind hole.

use crate::error::KnowledgeError;
use crate::part::Hole;
use crate::plan::{HolePlan, Plan};
use crate::shop::Shop;
use crate::tables::practice::ProofLimit;
use crate::units::Micrometres;

use super::{Fault, tool};

/// Counterbores whose pilot has no room: it goes before the teeth into the cylinder that earlier tools left under the floor of the
/// counterbore. Through a through hole it comes out.
pub(super) fn meets_floor(
    hole: &Hole,
    planned: &HolePlan,
    plan: &Plan,
    shop: &Shop<'_>,
) -> Result<Vec<Fault>, KnowledgeError> {
    let mut faults = Vec::new();
    for (at, transition) in planned.transitions.iter().enumerate().filter(|(_, one)| !hole.through && !one.elsewhere) {
        let tool = plan.tools.iter().find(|tool| tool.number == transition.tool.number);
        let Some(pilot) = tool.and_then(|tool| tool.pilot_mm) else { continue };
        let wide = planned.transitions[..at].iter().filter(|before| before.diameter_mm >= pilot);
        // How deep a hole of the blank is nobody says.
        let Some(open) = wide.map(|before| before.depth_mm).max() else { continue };
        let room = open - transition.depth_mm;
        let share = tool::limit(ProofLimit::PilotLengthDiameters, shop)?;
        let least = Micrometres::from_mm_rounded(pilot.to_mm() * share);
        let none = room < Micrometres::from_mm_rounded(tool::limit(ProofLimit::ShortestPilot, shop)?);
        if room < least || none {
            faults.push(Fault::PilotMeetsFloor { operation: transition.operation, pilot, room, least, none });
        }
    }
    Ok(faults)
}
