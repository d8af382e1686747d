//! The step diameters of the handbook (facts 4.2), where section 1.2.1 permits them.

use crate::error::KnowledgeError;
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::holes::StepDiameters;
use crate::units::Micrometres;

use super::bores::Bore;

/// The coarsest grade that goes through the handbook's diameters: H8 and H9 use them without the rough reamer (facts
/// 4.2).
const COARSEST: u8 = 9;

/// The row of the handbook for a precise cylinder in solid metal; none for other cylinders and for sizes that it
/// lacks.
pub(super) fn row<'k>(bore: &Bore, shop: &Shop<'k>) -> Result<Option<StepDiameters<'k>>, KnowledgeError> {
    if !bore.before.is_solid() || bore.diameter.it.number() > COARSEST || bore.thread.is_some() {
        return Ok(None);
    }
    Ok(shop.knowledge.find(|row: &StepDiameters<'_>| row.diameter == bore.diameter.nominal)?)
}

/// The handbook's diameter before a transition: before a finish reamer after a rough one, that of the rough reamer;
/// before the first reamer, that of the core drill or boring; before those, that of the last drill.
pub(super) fn diameter_before(
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
