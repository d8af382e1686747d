//! The core of solid metal that a drill finds below the point of the drill before it.

use crate::error::KnowledgeError;
use crate::plan::{Feature, Operation, Transition};
use crate::shop::Shop;
use crate::tables::practice::ProofLimit;
use crate::units::Micrometres;

use super::{Fault, tool};

/// A drill that opens a blind hole with its point further below that of the drill before it than its chisel edge permits: there
/// it drills solid metal with the feed of drilling out. A hole of the blank says nothing of its floor, nor does a step's.
///
/// # Errors
/// The knowledge base has no answer.
pub(crate) fn left_solid(
    transition: &Transition,
    before: &[Transition],
    shop: &Shop<'_>,
) -> Result<Option<Fault>, KnowledgeError> {
    let main = |one: &Transition| one.feature == Feature::Bore && one.step.is_none() && !one.elsewhere;
    if transition.operation != Operation::DrillOut || !main(transition) {
        return Ok(None);
    }
    let drills = |one: &&Transition| matches!(one.operation, Operation::Drill | Operation::DrillOut) && main(one);
    let Some(pilot) = before.iter().filter(drills).max_by_key(|one| one.end()) else { return Ok(None) };
    let share = tool::limit(ProofLimit::ChiselCone, shop)?;
    let most = Micrometres::from_mm_rounded(transition.diameter_mm.to_mm() * share);
    let core = transition.end() - pilot.end();
    // Where both cylinders end, only the points differ.
    let short = transition.depth_mm - pilot.depth_mm > most;
    let (operation, drill) = (transition.operation, pilot.diameter_mm);
    Ok((core > most).then_some(Fault::SolidCore { operation, drill, tip: transition.end(), core, most, short }))
}
