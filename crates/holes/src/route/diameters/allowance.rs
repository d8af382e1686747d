//! The range of the allowance a transition removes, on diameter, and where in it to aim.

use crate::error::KnowledgeError;
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, RowRef};
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::units::Micrometres;

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
    let Allowance { low, high, row, .. } = allowance(operation, nominal, nominal, None, shop)?;
    let least_is_ours = row.number_in("share", Unit::None).is_ok();
    Ok(Some(Range { low, high, row, least_is_ours }))
}

/// An allowance on diameter.
pub(super) struct Allowance<'k> {
    pub low: Micrometres,
    pub high: Micrometres,
    pub aim: Micrometres,
    pub row: RowRef<'k>,
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
    let rule = shop.knowledge.table("allowance-before")?;
    let answer = rule.decide(&[("operation", Input::Text(operation.name()))])?;
    let choice = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, operation.name()))?;
    let table = shop.knowledge.table("allowances")?;
    let name = choice.text("allowance")?;
    let row = table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
    if let Ok(share) = row.number_in("share", Unit::None) {
        // A share of the diameter is the most; inside it the handbook's stock, measured from the finished hole.
        let high = Micrometres::from_mm_rounded(nominal.to_mm() * share);
        let stocks = shop.knowledge.table("drill-before-core-drill")?;
        let answer = stocks.decide(&[("diameter", Input::Length(nominal))])?;
        let own = answer.winner().ok_or_else(|| KnowledgeError::no_row(stocks, "this diameter"))?;
        let stock = own.length("stock")?;
        // A slim core drill may have no more than the eighth that it is given.
        let low = shop.convention("least-stock-core-drill-mm")?.min(high);
        let aim = (after - (nominal - stock)).max(low).min(high);
        let note = Note::new("core-drill-stock").with("stock", stock).with("nominal", nominal);
        let stock = previous.is_some().then(|| Because::answer(&answer, note));
        return Ok(Allowance { low, high, aim, row, stock });
    }
    let (low, high) = (row.length("minimum")?, row.length("maximum")?);
    let share = choice.number_in("share", Unit::None)?;
    let aim = low.to_mm() + (high - low).to_mm() * share;
    Ok(Allowance { low, high, aim: Micrometres::from_mm_rounded(aim), row, stock: None })
}
