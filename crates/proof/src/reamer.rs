//! A reamer as it is bought is for a field H: it makes holes that begin at its own size.

use crate::error::KnowledgeError;
use crate::part::{Hole, tolerance_width};
use crate::plan::{HolePlan, Plan};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::ItGrade;

use super::fault::Fault;

/// The finished cylinders that a bought reamer makes too wide: of 10K7 (9.990 to 10.005) one for H7 leaves 10.000 to 10.015.
pub(super) fn bought_too_wide(
    hole: &Hole,
    planned: &HolePlan,
    plan: &Plan,
    shop: &Shop<'_>,
) -> Result<Vec<Fault>, KnowledgeError> {
    let Some(finest) = ItGrade::new(shop.share(HoleDefault::FinestBoughtGrade)? as u8) else { return Ok(Vec::new()) };
    let mut faults = Vec::new();
    for transition in planned.transitions.iter().filter(|one| one.operation.is_reaming() && !one.elsewhere) {
        let step = transition.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
        let required = step.map_or(&hole.diameter, |step| &step.diameter);
        let finishes = (required.smallest()..=required.largest()).contains(&transition.diameter_mm);
        let tool = plan.tools.iter().find(|tool| tool.number == transition.tool.number);
        if !finishes || tool.is_none_or(|tool| tool.ground_from_mm.is_some()) {
            continue;
        }
        let own = transition.tool.diameter_mm;
        let may_be = own + tolerance_width(finest, own, shop.knowledge).unwrap_or_default();
        if may_be > required.largest() {
            let (operation, limit) = (transition.operation, required.largest());
            faults.push(Fault::TooWide { operation, diameter: own, may_be, limit });
        }
    }
    Ok(faults)
}
