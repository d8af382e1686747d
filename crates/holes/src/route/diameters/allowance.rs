//! The range of the allowance a transition removes, on diameter, and where in it to aim.

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::holes::{Allowance as Row, HoleDefault};
use crate::tables::rules::{AllowanceBeforeFor, DrillBeforeCoreDrillFor};
use crate::units::Micrometres;
use technolog_note::note;

/// The stock on diameter that a transition may find.
#[derive(Clone, Copy, Debug)]
pub struct Range<'k> {
    /// The least.
    pub low: Micrometres,
    /// The most, of one pass.
    pub high: Micrometres,
    /// The row of the table `allowances`.
    pub row: RowRef<'k>,
    /// Whether the least is a convention of ours: of core drilling the text gives only the most.
    pub least_is_ours: bool,
}

/// The range of a transition in a hole of that nominal diameter; nothing for those that section 1.2.1 gives no stock.
///
/// # Errors
/// The knowledge cannot answer.
pub fn range<'k>(
    operation: Operation,
    nominal: Micrometres,
    shop: &Shop<'k>,
) -> Result<Option<Range<'k>>, KnowledgeError> {
    let named = operation.is_boring() || operation.is_reaming() || operation == Operation::CoreDrill;
    if !named {
        return Ok(None);
    }
    let Allowance { low, high, row, least_is_ours, .. } = allowance(operation, nominal, nominal, None, shop)?;
    Ok(Some(Range { low, high, row, least_is_ours }))
}

/// An allowance on diameter.
pub(super) struct Allowance<'k> {
    pub low: Micrometres,
    pub high: Micrometres,
    pub aim: Micrometres,
    pub row: RowRef<'k>,
    /// Whether the least is a convention of ours.
    pub least_is_ours: bool,
    /// Where the aim is from another row than the range.
    pub stock: Option<Because>,
}

/// The allowance of a transition that leaves `after`, by the rule `allowance-before` and section 1.2.1.
pub(super) fn allowance<'k>(
    operation: Operation,
    after: Micrometres,
    nominal: Micrometres,
    previous: Option<Operation>,
    shop: &Shop<'k>,
) -> Result<Allowance<'k>, KnowledgeError> {
    let choice = shop.knowledge.ask(&AllowanceBeforeFor { operation })?.need(operation.name())?;
    let found = shop.knowledge.need(choice.allowance, |row: &Row<'_>| row.name == choice.allowance)?;
    let row = found.row;
    if let Some(share) = found.share {
        // A share of the diameter is the most; inside it the handbook's stock, measured from the finished hole.
        let high = Micrometres::from_mm_rounded(nominal.to_mm() * share);
        let answer = shop.knowledge.ask(&DrillBeforeCoreDrillFor { diameter: nominal })?;
        let stock = answer.need("this diameter")?.stock;
        // A slim core drill may have no more than the eighth that it is given.
        let low = shop.convention(HoleDefault::LeastStockCoreDrill)?.min(high);
        let aim = (after - (nominal - stock)).max(low).min(high);
        let note = Note::new("core-drill-stock").with("stock", stock).with("nominal", nominal);
        let stock = previous.is_some().then(|| Because::answer(&answer.answer, note));
        return Ok(Allowance { low, high, aim, row, least_is_ours: true, stock });
    }
    let low = found.minimum.ok_or_else(|| lacks(&found, "minimum"))?;
    let high = found.maximum.ok_or_else(|| lacks(&found, "maximum"))?;
    let aim = Micrometres::from_mm_rounded(low.to_mm() + (high - low).to_mm() * choice.share);
    Ok(Allowance { low, high, aim, row, least_is_ours: false, stock: None })
}

/// An allowance is either a share of the diameter or a range; this one is neither.
pub(super) fn lacks(row: &Row<'_>, what: &str) -> KnowledgeError {
    KnowledgeError::lacks(&row.row.table.id, note!("order-has-neither-share-nor", row = row.name, what = what))
}
