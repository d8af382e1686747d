//! The range of the allowance that a transition removes, on diameter, and the value to aim at.

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::holes::{Allowance as Row, HoleDefault};
use crate::tables::practice::StockBeforeReamingFor;
use crate::tables::rules::{AllowanceBefore, AllowanceBeforeFor, DrillBeforeCoreDrillFor, MadeBy};
use crate::units::Micrometres;
use technolog_note::note;

/// The stock on diameter that a transition may find.
#[derive(Clone, Copy, Debug)]
pub struct Range<'k> {
    /// The least.
    pub low: Micrometres,
    /// The most, in one pass.
    pub high: Micrometres,
    /// The row of the table `allowances`.
    pub row: RowRef<'k>,
    /// Whether the least is a convention of the program: for core drilling the text gives only the most.
    pub least_is_ours: bool,
}

/// The range of a transition after another one in a hole of that nominal diameter; none where neither section 1.2.1
/// nor practice gives a stock.
///
/// # Errors
/// The knowledge base has no answer.
pub fn range<'k>(
    operation: Operation,
    previous: Option<Operation>,
    nominal: Micrometres,
    shop: &Shop<'k>,
) -> Result<Option<Range<'k>>, KnowledgeError> {
    let named = operation.is_boring() || operation.is_reaming() || operation == Operation::CoreDrill;
    if !named {
        return Ok(None);
    }
    let Allowance { mut low, mut high, row, least_is_ours, .. } =
        allowance(operation, nominal, nominal, previous, shop)?;
    // For finish reaming, section 1.2.1 gives a stock after any transition: a route that follows the book is not
    // wrong.
    if operation == Operation::FinishReam {
        let book = allowance(operation, nominal, nominal, Some(Operation::RoughReam), shop)?;
        (low, high) = (low.min(book.low), high.max(book.high));
    }
    Ok(Some(Range { low, high, row, least_is_ours }))
}

/// An allowance on diameter.
pub(super) struct Allowance<'k> {
    pub low: Micrometres,
    pub high: Micrometres,
    pub aim: Micrometres,
    pub row: RowRef<'k>,
    /// Whether the least is a convention of the program.
    pub least_is_ours: bool,
    /// The row of the aim, where it is not the row of the range.
    pub stock: Option<Because>,
}

/// The allowance of a transition that leaves `after`, by the rule `allowance-before`, section 1.2.1 and the usual
/// stock of reamers.
pub(super) fn allowance<'k>(
    operation: Operation,
    after: Micrometres,
    nominal: Micrometres,
    previous: Option<Operation>,
    shop: &Shop<'k>,
) -> Result<Allowance<'k>, KnowledgeError> {
    let made_by = previous.and_then(MadeBy::of).unwrap_or(MadeBy::BlankHole);
    let choice = shop.knowledge.ask(&AllowanceBeforeFor { operation, after: made_by })?.need(operation.name())?;
    let practice = match choice.case {
        None => None,
        Some(case) => {
            let question = StockBeforeReamingFor { case, diameter: nominal };
            Some(shop.knowledge.ask(&question)?.need(case.name())?)
        }
    };
    let within =
        |low: Micrometres, high: Micrometres| low + Micrometres::from_mm_rounded((high - low).to_mm() * choice.share);
    let Some(name) = choice.allowance else {
        let Some(found) = practice else {
            let table = shop.knowledge.table_of::<AllowanceBefore<'_>>()?;
            return Err(KnowledgeError::no_row(table, operation.name()));
        };
        let (low, high) = (found.stock_min, found.stock_max);
        let aim = within(low, high);
        return Ok(Allowance { low, high, aim, row: found.row, least_is_ours: false, stock: None });
    };
    let found = shop.knowledge.need(name, |row: &Row<'_>| row.name == name)?;
    let row = found.row;
    if let Some(share) = found.share {
        // The most is a share of the diameter; within it the handbook's stock, measured from the finished hole.
        let high = Micrometres::from_mm_rounded(nominal.to_mm() * share);
        let answer = shop.knowledge.ask(&DrillBeforeCoreDrillFor { diameter: nominal })?;
        let stock = answer.need("this diameter")?.stock;
        // The least must not exceed the most: a core drill of small diameter may take no more than its eighth.
        let low = shop.convention(HoleDefault::LeastStockCoreDrill)?.min(high);
        let aim = (after - (nominal - stock)).max(low).min(high);
        let note = Note::new("core-drill-stock").with("stock", stock).with("nominal", nominal);
        let stock = previous.is_some().then(|| Because::answer(&answer.answer, note));
        return Ok(Allowance { low, high, aim, row, least_is_ours: true, stock });
    }
    let low = found.minimum.ok_or_else(|| no_allowance(&found, "minimum"))?;
    let high = found.maximum.ok_or_else(|| no_allowance(&found, "maximum"))?;
    let aim = within(low, high);
    let Some(practice) = practice else {
        return Ok(Allowance { low, high, aim, row, least_is_ours: false, stock: None });
    };
    let (least, most) = (low.min(practice.stock_min), high.max(practice.stock_max));
    let note = Note::new("stock-of-practice").with("low", practice.stock_min).with("high", practice.stock_max);
    let stock = Some(Because::row(practice.row, note));
    Ok(Allowance { low: least, high: most, aim, row, least_is_ours: false, stock })
}

/// The row has neither a share nor a range, and an allowance must be one of them.
pub(super) fn no_allowance(row: &Row<'_>, what: &str) -> KnowledgeError {
    KnowledgeError::missing(&row.row.table.id, note!("order-has-neither-share-nor", row = row.name, what = what))
}
