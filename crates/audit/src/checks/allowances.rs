//! The stock of each finishing transition, on diameter, by section 1.2.1.
//!
//! The check goes backwards from the finished hole, as planning does. A wrong stock is reported at the row that left
//! it; the next row is then judged by the right diameter, so that one wrong diameter is reported once.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note, Severity};
use crate::part::Hole;
use crate::plan::{Operation, Route};
use crate::route::diameters::{Range, range};
use crate::tables::audit::Threshold;
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::figures::with_right_value;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots;
use super::super::rules::counts::FROM;
use super::super::stated::Row;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    for hole in context.stated.part.holes.iter().filter(|hole| hole.slot.is_none()) {
        let rows: Vec<(usize, &Row)> = context
            .stated
            .rows_of_hole(&hole.name)
            .filter(|(_, row)| row.opens_main_cylinder() && row.operation.value != Operation::Tap)
            .collect();
        backwards(context, graph, hole, &rows, findings)?;
    }
    Ok(())
}

fn backwards(
    context: &Context<'_>,
    graph: &Graph<'_>,
    hole: &Hole,
    rows: &[(usize, &Row)],
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let mut left = Vec::with_capacity(rows.len());
    for (at, _) in rows {
        let Some(diameter) = leaves(graph, *at) else { return Ok(()) };
        left.push(diameter);
    }
    // Rows out of order are reported by the route check; they have no stock here.
    if !left.is_sorted() {
        return Ok(());
    }
    let Some(mut after) = left.last().map(|last| finished(context, hole, *last)) else { return Ok(()) };
    let of_two = context.auditor.threshold(Threshold::StockOfTwo);
    // The diameters that the next row permits this one to leave.
    let mut window = (after, after);
    for index in (0..rows.len()).rev() {
        let (at, row) = rows[index];
        let previous = index.checked_sub(1).map(|before| (rows[before], left[before]));
        let Some(before) = previous.map(|(_, left)| left).or(hole.state.diameter()) else { return Ok(()) };
        let operation_before = previous.map(|((_, other), _)| other.operation.value);
        let Some(range) = range(row.operation.value, operation_before, hole.diameter.nominal, &context.shop)? else {
            (after, window) = (before, (before, before));
            continue;
        };
        let high = permitted(row, &range);
        let (smallest, largest) = (after - high, after - range.low);
        // Rough boring in the blank, or after a thinner bar, may have any small stock.
        let first = row.operation.value == Operation::RoughBore
            && previous.is_none_or(|((_, other), _)| other.operation.value == Operation::RoughBore);
        let too_little = before > largest && !first;
        // The stock by the figures as stated: errors that only a correction of the next row would cause are not
        // reported.
        let stock = left[index] - before;
        let fine = stock <= high && (stock >= range.low || first);
        if fine || !too_little && before >= smallest {
            (after, window) = (before, (smallest, largest));
            continue;
        }
        let of_row = (at, row);
        // The own diameter of the row may be the slip, if another value would suit both its stock and the next row.
        let own = (window.0.max(before + range.low), window.1.min(before + high));
        if own.0 <= own.1 {
            let right = after.max(own.0).min(own.1);
            findings.push(finding(context, of_row, Some(of_row), (stock, right), &range));
            (after, window) = (before, (right - high, right - range.low));
            continue;
        }
        let nearest = if too_little { largest } else { smallest };
        // Where the row states its own diameter before, and that value fits, the figure of the row before was
        // misprinted.
        let stated = row.figures.get(&Q::From).map(|from| Micrometres::from_mm_rounded(from.value));
        let stated = stated.filter(|value| (smallest..=largest).contains(value));
        if stated.is_none() && !too_little && row.operation.value == Operation::RoughBore {
            findings.push(passes(context, of_row, stock, &range));
            (after, window) = (before, (before, before));
            continue;
        }
        if let Some(missing) =
            missing(context, hole, rows, index).filter(|_| stated.is_none() && stock.to_mm() > of_two * high.to_mm())
        {
            findings.push(without(context, of_row, missing, (stock, high), &range));
            (after, window) = (before, (before, before));
            continue;
        }
        let right = stated.unwrap_or(nearest);
        let before_it = previous.map(|(row, _)| row);
        if stated == Some(right) {
            roots::retract(findings, &context.field(Id::new(Scope::Row(at), Q::From)), &FROM);
        }
        findings.push(finding(context, of_row, before_it, (stock, right), &range));
        (after, window) = (right, (smallest, largest));
    }
    Ok(())
}

/// The transition of our plan that stands between a row and the one before it, and that the rows lack.
fn missing(context: &Context<'_>, hole: &Hole, rows: &[(usize, &Row)], index: usize) -> Option<Operation> {
    let own = rows.get(index)?.1.operation.value;
    let before = rows.get(index.checked_sub(1)?)?.1.operation.value;
    let plan = context.plan.holes.iter().find(|plan| plan.name == hole.name)?;
    let ours: Vec<Operation> = plan.transitions.iter().map(|transition| transition.operation).collect();
    let end = ours.iter().position(|operation| *operation == own)?;
    let begin = ours.iter().position(|operation| *operation == before)? + 1;
    let mut between = ours.get(begin..end)?.iter().copied();
    let stated = |operation: Operation| rows.iter().any(|(_, row)| row.operation.value == operation);
    between.rfind(|operation| !operation.is_of_edge() && !stated(*operation))
}

/// A row that finds far more stock than it may take, because the transition before it is left out.
fn without(
    context: &Context<'_>,
    (at, row): (usize, &Row),
    missing: Operation,
    (stock, high): (Micrometres, Micrometres),
    range: &Range<'_>,
) -> AuditFinding {
    let note = Note::new("audit-transition-missing")
        .with("operation", Figure::operation(row.operation.value.name()))
        .with("row", row.number)
        .with("missing", Figure::operation(missing.name()))
        .with("stock", stock)
        .with("high", high);
    let field = format!("route.{}.operation", row.number);
    let finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.operation.place);
    finding.about(context.subject(Scope::Row(at))).resting_on([Because::row(range.row, Note::new("named"))])
}

/// The diameter that a row leaves; a slip that a formula explains is replaced by the right value.
fn leaves(graph: &Graph<'_>, at: usize) -> Option<Micrometres> {
    let id = Id::new(Scope::Row(at), Q::Diameter);
    let slip = graph.verdict(id).is_some_and(|verdict| verdict.status != Status::Fine);
    let value = if slip { graph.right(id) } else { graph.stated_or_right(id) };
    value.map(Micrometres::from_mm_rounded)
}

/// The diameter that the last row must leave; the route check reports where that is not the drawing's.
fn finished(context: &Context<'_>, hole: &Hole, last: Micrometres) -> Micrometres {
    let reference = context.plan.holes.iter().find(|plan| plan.name == hole.name);
    let elsewhere = reference.and_then(|plan| plan.route.as_ref()).is_some_and(Route::may_finish_elsewhere);
    let right = (hole.diameter.smallest()..=hole.diameter.largest()).contains(&last);
    if right || elsewhere || hole.thread.is_some() { last } else { hole.diameter.nominal }
}

/// The most stock of a row: the limit of one pass times its passes.
fn permitted(row: &Row, range: &Range<'_>) -> Micrometres {
    let passes = row.figures.get(&Q::Passes).map_or(1, |passes| passes.value.max(1.0) as i64);
    Micrometres::new(range.high.micrometres() * passes)
}

/// Rough boring removes what it must, in as many passes as the range requires: too few are wrong, none stated is
/// doubtful.
fn passes(context: &Context<'_>, (at, row): (usize, &Row), stock: Micrometres, range: &Range<'_>) -> AuditFinding {
    let most = range.high.micrometres().max(1);
    let needed = (stock.micrometres() + most - 1) / most;
    let figure = row.figures.get(&Q::Passes);
    let note = Note::new("audit-passes").with("stock", stock).with("high", range.high).with("needed", needed);
    let severity = if figure.is_some() { Severity::Wrong } else { Severity::Doubtful };
    let field = context.field(Id::new(Scope::Row(at), Q::Passes));
    let finding = AuditFinding::new(severity, Section::Route, field, note).at(&row.place);
    let finding = finding.about(context.subject(Scope::Row(at)));
    let finding = finding.resting_on([Because::row(range.row, Note::new("named"))]);
    match figure {
        Some(figure) => with_right_value(finding, figure, needed, Q::Passes),
        None => finding,
    }
}

/// The finding at the diameter that is wrong: of `row` itself, or of the row before it. `stock` is the stock of the
/// row; `right` is the nearest diameter that would be right.
fn finding(
    context: &Context<'_>,
    (at, row): (usize, &Row),
    blamed: Option<(usize, &Row)>,
    (stock, right): (Micrometres, Micrometres),
    range: &Range<'_>,
) -> AuditFinding {
    let high = permitted(row, range);
    let note = Note::new("audit-allowance")
        .with("operation", Figure::operation(row.operation.value.name()))
        .with("row", row.number)
        .with("stock", stock)
        .with("low", range.low)
        .with("high", high);
    // The least stock of core drilling is a convention of the program; the text gives only the most.
    let ours = range.least_is_ours && stock < range.low;
    let severity = if ours { Severity::Doubtful } else { Severity::Wrong };
    let stated = |(_, row): &(usize, &Row)| row.figures.contains_key(&Q::Diameter);
    let (blamed, quantity) = match blamed.filter(stated) {
        Some(blamed) => (blamed, Q::Diameter),
        None => ((at, row), Q::From),
    };
    let id = Id::new(Scope::Row(blamed.0), quantity);
    let because = Because::row(range.row, Note::new("named"));
    let finding = AuditFinding::new(severity, Section::Route, context.field(id), note).at(&blamed.1.place);
    let finding = finding.about(context.subject(id.scope)).resting_on([because]);
    match blamed.1.figures.get(&quantity) {
        Some(figure) => with_right_value(finding, figure, right, quantity),
        None => finding,
    }
}
