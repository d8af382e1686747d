//! What confirms the diameter of a row beside its tool.

use crate::error::KnowledgeError;
use crate::part::Hole;
use crate::plan::Operation;
use crate::route::diameters::range;
use crate::units::Micrometres;

use super::context::Context;
use super::quantity::Quantity as Q;
use super::stated::Row;

/// Whether something other than the tool confirms the diameter of a row: the drawing, the program's plan of the same
/// transition, or the stock of the next row.
pub(super) fn backed(context: &Context<'_>, at: usize, row: &Row, hole: &Hole) -> Result<bool, KnowledgeError> {
    let Some(value) = diameter(context, at, row) else { return Ok(false) };
    if context.reference(at).is_some_and(|own| own.diameter_mm == value) {
        return Ok(true);
    }
    let opens = |row: &Row| row.opens_main_cylinder() && row.operation.value != Operation::Tap;
    let mut after = context.stated.rows_of_hole(&hole.name).filter(|(other, row)| *other > at && opens(row));
    let Some((_, next)) = after.next() else {
        return Ok((hole.diameter.smallest()..=hole.diameter.largest()).contains(&value));
    };
    let stated = |quantity| next.figures.get(&quantity).map(|figure| Micrometres::from_mm_rounded(figure.value));
    let stock = stated(Q::Diameter).map(|after| after - value);
    let range = range(next.operation.value, Some(row.operation.value), hole.diameter.nominal, &context.shop)?;
    let found = range.zip(stock).is_some_and(|(range, stock)| (range.low..=range.high).contains(&stock));
    Ok(found || stated(Q::From) == Some(value))
}

/// The diameter that a row is stated with: its own, or else that of its conditions.
pub(super) fn diameter(context: &Context<'_>, at: usize, row: &Row) -> Option<Micrometres> {
    let of_conditions = || context.stated.conditions.get(context.stated.conditions_of(at)?)?.figures.get(&Q::Diameter);
    let own = row.figures.get(&Q::Diameter).or_else(of_conditions)?;
    Some(Micrometres::from_mm_rounded(own.value))
}
