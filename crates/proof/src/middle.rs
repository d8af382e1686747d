//! Mills that go straight down: the middle of one whose end teeth do not reach it must find no metal there.

use crate::error::KnowledgeError;
use crate::part::Hole;
use crate::plan::{Feature, Operation, Transition};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

use super::Fault;

/// A mill whose middle, where it has no teeth, meets metal; none for a mill that is in no catalog. `opened` is how deep the main
/// cylinder is open at its full diameter.
///
/// The middle is reckoned with a share of the mill's diameter (`mill-core-share` of `hole-defaults`).
///
/// # Errors
/// The knowledge base has no answer.
pub(crate) fn in_metal(
    transition: &Transition,
    hole: &Hole,
    opened: Micrometres,
    shop: &Shop<'_>,
) -> Result<Option<Fault>, KnowledgeError> {
    let operation = transition.operation;
    if !matches!(operation, Operation::Mill | Operation::Counterbore) || transition.elsewhere {
        return Ok(None);
    }
    let table = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table);
    let mill =
        table.is_some_and(|table| table.head.operations.contains(&Operation::Mill) && !table.head.centre_cutting);
    let main = transition.feature == Feature::Bore && transition.step.is_none();
    if !mill || (main && (hole.through || transition.depth_mm <= opened)) {
        return Ok(None);
    }
    let tool = transition.tool.diameter_mm;
    let middle = Micrometres::from_mm_rounded(tool.to_mm() * shop.share(HoleDefault::MillCoreShare)?);
    let open = if main { Micrometres::ZERO } else { transition.from_diameter_mm };
    Ok((middle > open).then_some(Fault::MiddleInMetal { operation, tool, middle, open }))
}
