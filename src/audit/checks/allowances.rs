//! The stock that each finishing transition finds: by section 1.2.1, on diameter.
//!
//! Backwards from the finished hole, as it is planned: what a row finds is blamed on the row that left it, and that row is
//! then judged by the diameter that would have done, so that one wrong diameter is told once.

use crate::error::KnowledgeError;
use crate::note::{Because, Note, Severity};
use crate::part::Hole;
use crate::plan::Operation;
use crate::route::diameters::{Range, range};
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::figures::beside;
use super::super::finding::{Finding, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::Row;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    for hole in &context.stated.part.holes {
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
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let left = |at: usize| {
        let id = Id::new(Scope::Row(at), Q::Diameter);
        // A slip that a formula explains is judged as it should be.
        let slip = graph.verdict(id).is_some_and(|verdict| verdict.status != Status::Fine);
        let value = if slip { graph.right(id) } else { graph.stated_or_right(id) };
        value.map(Micrometres::from_mm_rounded)
    };
    let Some(mut after) = rows.last().and_then(|(at, _)| left(*at)) else { return Ok(()) };
    for index in (0..rows.len()).rev() {
        let (at, row) = rows[index];
        let previous = index.checked_sub(1).and_then(|before| rows.get(before)).copied();
        let start = || hole.state.diameter();
        let Some(before) = previous.map_or_else(start, |(at, _)| left(at)) else { return Ok(()) };
        let operation = row.operation.value;
        let Some(range) = range(operation, hole.diameter.nominal, &context.shop)? else {
            after = before;
            continue;
        };
        let (smallest, largest) = (after - permitted(row, &range), after - range.low);
        // What rough boring finds in the blank, or after a slimmer bar, may be as little as it is.
        let first = operation == Operation::RoughBore
            && previous.is_none_or(|(_, other)| other.operation.value == Operation::RoughBore);
        let too_little = before > largest && !first;
        // That the hole is not opened at all the route says.
        if before >= after || !(too_little || before < smallest) {
            after = before;
            continue;
        }
        let right = if too_little { largest } else { smallest };
        findings.push(finding(context, (at, row), previous, (before, after, right), &range));
        after = right;
    }
    Ok(())
}

/// The most that a row may find: so much in each of its passes.
fn permitted(row: &Row, range: &Range<'_>) -> Micrometres {
    let passes = row.figures.get(&Q::Passes).map_or(1, |passes| passes.value.max(1.0) as i64);
    Micrometres::new(range.high.micrometres() * passes)
}

/// What is said at the diameter that leaves the wrong stock: `before`, of which `right` is the nearest that would do.
fn finding(
    context: &Context<'_>,
    (at, row): (usize, &Row),
    previous: Option<(usize, &Row)>,
    (before, after, right): (Micrometres, Micrometres, Micrometres),
    range: &Range<'_>,
) -> Finding {
    let high = permitted(row, range);
    let note = Note::new("audit-allowance")
        .with("operation", row.operation.value.name())
        .with("row", row.number)
        .with("stock", after - before)
        .with("low", range.low)
        .with("high", high)
        .with("least", after - high)
        .with("most", after - range.low);
    // The least stock of core drilling is ours, the text gives only the most.
    let ours = range.least_is_ours && before > after - range.low;
    let severity = if ours { Severity::Doubtful } else { Severity::Wrong };
    let (blamed, quantity) = match previous {
        Some(previous) if previous.1.figures.contains_key(&Q::Diameter) => (previous, Q::Diameter),
        _ if row.figures.contains_key(&Q::From) => ((at, row), Q::From),
        _ => ((at, row), Q::Diameter),
    };
    let id = Id::new(Scope::Row(blamed.0), quantity);
    let because = Because::row(range.row, Note::new("named"));
    let finding = Finding::new(severity, Section::Route, context.field(id), note).at(&blamed.1.place);
    let finding = finding.about(context.subject(id.scope)).resting_on([because]);
    match blamed.1.figures.get(&quantity) {
        // Its own diameter is not what should be another.
        Some(figure) if quantity == Q::From || blamed.0 != at => beside(finding, figure, right, quantity),
        _ => finding,
    }
}
