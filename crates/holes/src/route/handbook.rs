//! The handbook's step diameters (facts 4.2), as far as section 1.2.1 lets them stand.

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::plan::Operation;
use crate::shop::Shop;
use crate::units::Micrometres;

use super::bores::Bore;

/// The coarsest grade whose cylinders go through the handbook's diameters: H8 and H9 take them without the
/// rough reamer (facts 4.2).
const COARSEST: u8 = 9;

/// The handbook's row for a precise cylinder in solid metal; nothing for others and for sizes it lacks.
pub(super) fn row<'k>(bore: &Bore, shop: &Shop<'k>) -> Result<Option<RowRef<'k>>, KnowledgeError> {
    if !bore.before.is_solid() || bore.diameter.it.number() > COARSEST || bore.thread.is_some() {
        return Ok(None);
    }
    let table = shop.knowledge.table("step-diameters")?;
    Ok(table.all_rows().find(|row| row.length_if_any("diameter") == Some(bore.diameter.nominal)))
}

/// The diameter the handbook has before a transition: the rough reamer's before the finish reamer that
/// follows one, the core drill's or bore's before the first reamer, the last drill's before those.
pub(super) fn before(row: RowRef<'_>, operation: Operation, previous: Option<Operation>) -> Option<Micrometres> {
    let column = match (operation, previous?) {
        (Operation::FinishReam, Operation::RoughReam) => "rough_ream",
        (Operation::FinishReam | Operation::RoughReam, Operation::CoreDrill) => "core_drill",
        (Operation::FinishReam | Operation::RoughReam, previous) if previous.is_boring() => "bore",
        (
            Operation::FinishReam | Operation::RoughReam | Operation::CoreDrill | Operation::SemiFinishBore,
            Operation::Drill,
        ) => return last_drill(row),
        _ => return None,
    };
    row.length(column).ok().or_else(|| (column == "bore").then(|| row.length("core_drill").ok()).flatten())
}

/// The last drill of the row.
pub(super) fn last_drill(row: RowRef<'_>) -> Option<Micrometres> {
    row.length("drill_2").or_else(|_| row.length("drill_1")).ok()
}

/// The first of two drills, where the row has two.
pub(super) fn first_drill(row: RowRef<'_>) -> Option<Micrometres> {
    row.length("drill_2").is_ok().then(|| row.length("drill_1").ok()).flatten()
}
