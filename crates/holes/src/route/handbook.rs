//! The handbook's step diameters (facts 4.2), as far as section 1.2.1 lets them stand.

use crate::error::KnowledgeError;
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::holes::StepDiameters;
use crate::units::Micrometres;

use super::bores::Bore;

/// The coarsest grade whose cylinders go through the handbook's diameters: H8 and H9 take them without the
/// rough reamer (facts 4.2).
const COARSEST: u8 = 9;

/// The handbook's row for a precise cylinder in solid metal; none for others and for sizes it lacks.
pub(super) fn row<'k>(bore: &Bore, shop: &Shop<'k>) -> Result<Option<StepDiameters<'k>>, KnowledgeError> {
    if !bore.before.is_solid() || bore.diameter.it.number() > COARSEST || bore.thread.is_some() {
        return Ok(None);
    }
    Ok(shop.knowledge.find(|row: &StepDiameters<'_>| row.diameter == bore.diameter.nominal)?)
}

/// The diameter the handbook has before a transition: the rough reamer's before the finish reamer that
/// follows one, the core drill's or bore's before the first reamer, the last drill's before those.
pub(super) fn before(
    row: &StepDiameters<'_>,
    operation: Operation,
    previous: Option<Operation>,
) -> Option<Micrometres> {
    match (operation, previous?) {
        (Operation::FinishReam, Operation::RoughReam) => row.rough_ream,
        (Operation::FinishReam | Operation::RoughReam, Operation::CoreDrill) => row.core_drill,
        (Operation::FinishReam | Operation::RoughReam, previous) if previous.is_boring() => row.bore.or(row.core_drill),
        (
            Operation::FinishReam | Operation::RoughReam | Operation::CoreDrill | Operation::SemiFinishBore,
            Operation::Drill,
        ) => Some(last_drill(row)),
        _ => None,
    }
}

/// The last drill of the row.
pub(super) fn last_drill(row: &StepDiameters<'_>) -> Micrometres {
    row.drill_2.unwrap_or(row.drill_1)
}

/// The first of two drills, where the row has two.
pub(super) fn first_drill(row: &StepDiameters<'_>) -> Option<Micrometres> {
    row.drill_2.map(|_| row.drill_1)
}
