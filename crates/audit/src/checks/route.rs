//! The route: every hole, the order of its transitions and their diameters, the tool changes.

use std::collections::BTreeSet;

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note, Severity};
use crate::part::Hole;
use crate::plan::{Operation, Route};
use crate::tables::audit::PlanPart;
use crate::tables::rules::TransitionOrderFor;
use crate::units::{Micrometres, round_to};

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section, Subject};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots;
use super::super::stated::Row;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    // A plan by hand may leave its route out; a plan of the program without rows has no route for any hole.
    if stated.rows.is_empty() && !stated.is_own {
        return Ok(());
    }
    let whole = stated.covers(PlanPart::Holes);
    for hole in &stated.part.holes {
        let rows: Vec<(usize, &Row)> = stated.rows_of_hole(&hole.name).collect();
        let plan = context.plan.holes.iter().find(|plan| plan.name == hole.name);
        if rows.is_empty() && !whole {
            continue;
        }
        if rows.is_empty() {
            // A hole for which the program has no route is unfinished too.
            let known = plan.is_some_and(|plan| !plan.transitions.is_empty());
            let code = if known { "audit-hole-not-made" } else { "audit-hole-not-made-either" };
            let note = Note::new(code).with("count", hole.at.len());
            let field = format!("route.{}", hole.name);
            findings.push(AuditFinding::new(Severity::Error, Section::Route, field, note).about(hole_subject(hole)));
            continue;
        }
        if hole.slot.is_some() && !stated.is_own {
            // No table speaks of slots, and the rules of figures know round holes.
            let note = Note::new("audit-slot-not-checked");
            let field = format!("route.{}", hole.name);
            findings.push(AuditFinding::new(Severity::Doubtful, Section::Route, field, note).about(hole_subject(hole)));
        }
        order(context, &rows, findings)?;
        finished(context, graph, hole, &rows, findings);
    }
    changes(context, findings);
    Ok(())
}

pub(super) fn hole_subject(hole: &Hole) -> Subject {
    Subject { holes: vec![hole.name.clone()], ..Subject::default() }
}

/// The order of section 1.1.2: the ranks within one cylinder never fall. Rows that make edges may come between.
fn order(
    context: &Context<'_>,
    rows: &[(usize, &Row)],
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let mut before: Option<(i64, &Row)> = None;
    let mut opened: Option<f64> = None;
    for (turn, (at, row)) in rows.iter().enumerate() {
        let operation = row.operation.value;
        // The pilot of a counterbore goes into the hole, which a later row drills.
        let drilled = |own: &(usize, &Row)| own.1.operation.value == Operation::Drill;
        let (done, left) = rows.split_at(turn);
        if operation == Operation::Counterbore
            && !done.iter().any(|own| own.1.opens_main_cylinder())
            && let Some((_, drill)) = left.iter().find(|own| drilled(own))
        {
            let Some(rule) = context.shop.knowledge.ask(&TransitionOrderFor { operation, face: true })?.winner()?
            else {
                continue;
            };
            let note = Note::new("audit-order-opening")
                .with("operation", Figure::operation(operation.name()))
                .with("instead", Figure::operation(drill.operation.value.name()))
                .with("row", drill.number);
            let field = format!("route.{}.operation", row.number);
            let finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.operation.place);
            let because = Because::row(rule.row, Note::new("audit-rank").with("rank", rule.rank));
            findings.push(finding.about(context.subject(Scope::Row(*at))).resting_on([because]));
        }
        if operation.is_of_edge() || !row.of_main_cylinder() {
            continue;
        }
        // A mill that only levels the floor comes after what opened the hole.
        let diameter = row.figures.get(&Q::Diameter).map(|figure| figure.value);
        if operation == Operation::Mill && diameter.is_some() && diameter == opened {
            continue;
        }
        opened = diameter.or(opened);
        let answer = context.shop.knowledge.ask(&TransitionOrderFor { operation, face: false })?;
        let Some(rule) = answer.winner()? else { continue };
        let rank = rule.rank;
        // A drill after what is wider comes too late, whatever their rank.
        let drills = |row: &Row| matches!(row.operation.value, Operation::Drill | Operation::DrillOut);
        let size = |row: &Row| row.figures.get(&Q::Diameter).map(|figure| figure.value);
        let late = |other: &Row| {
            let opens = !matches!(other.operation.value, Operation::CentreDrill | Operation::Mill);
            drills(row) && opens && size(row).zip(size(other)).is_some_and(|(own, before)| own < before)
        };
        if let Some((least, other)) = before
            && (rank < least || late(other))
        {
            let note = Note::new("audit-order")
                .with("operation", Figure::operation(operation.name()))
                .with("instead", Figure::operation(other.operation.value.name()))
                .with("row", other.number);
            let field = format!("route.{}.operation", row.number);
            let finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.operation.place);
            let because = Because::row(rule.row, Note::new("audit-rank").with("rank", rank));
            findings.push(finding.about(context.subject(Scope::Row(*at))).resting_on([because]));
        }
        if before.is_none_or(|(least, _)| rank >= least) {
            before = Some((rank, row));
        }
    }
    Ok(())
}

/// The last diameter of the main cylinder is the hole's; no transition makes a hole narrower or leaves it as it is.
fn finished(
    context: &Context<'_>,
    graph: &Graph<'_>,
    hole: &Hole,
    rows: &[(usize, &Row)],
    findings: &mut Vec<AuditFinding>,
) {
    let bores = |row: &Row| row.opens_main_cylinder() && row.operation.value != Operation::Tap;
    let mut before = Micrometres::ZERO;
    let mut last: Option<(usize, &Row, Micrometres)> = None;
    for (at, row) in rows.iter().filter(|(_, row)| bores(row)) {
        let id = row_id(*at);
        let Some(diameter) = graph.stated_or_right(id) else { return };
        let diameter = Micrometres::from_mm_rounded(diameter);
        let floor = row.operation.value == Operation::Mill && diameter == before;
        if diameter <= before && !floor {
            let note = Note::new("audit-not-opened").with("diameter", diameter).with("before", before);
            let field = format!("route.{}.diameter", row.number);
            let mut finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.place);
            finding.follows_from = follows(context, graph, &[Some(id), last.map(|(at, ..)| row_id(at))]);
            findings.push(finding.about(context.subject(Scope::Row(*at))));
        }
        before = diameter;
        last = Some((*at, *row, diameter));
    }
    // The hole of a thread is that of its tap; a hole finished elsewhere keeps its stock.
    let reference = context.plan.holes.iter().find(|plan| plan.name == hole.name);
    let elsewhere = reference.and_then(|plan| plan.route.as_ref()).is_some_and(Route::may_finish_elsewhere);
    // Nor is the last row the last transition where the plan does not cover the route.
    if hole.thread.is_some() || elsewhere || !context.stated.covers(PlanPart::Holes) {
        return;
    }
    if let Some((at, row, diameter)) = last
        && !(hole.diameter.smallest()..=hole.diameter.largest()).contains(&diameter)
        && diameter != hole.diameter.nominal
    {
        let note = Note::new("audit-last-diameter").with("diameter", diameter).with("hole", &hole.diameter);
        let field = format!("route.{}.diameter", row.number);
        let mut finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.place);
        finding.follows_from = follows(context, graph, &[Some(row_id(at))]);
        findings.push(finding.with_values(diameter, &hole.diameter).about(context.subject(Scope::Row(at))));
    }
}

const fn row_id(at: usize) -> Id {
    Id::new(Scope::Row(at), Q::Diameter)
}

/// The fields of the slips among stated figures, or of the slips that these follow from.
fn follows(context: &Context<'_>, graph: &Graph<'_>, figures: &[Option<Id>]) -> Vec<String> {
    let roots = figures.iter().flatten().flat_map(|id| roots::figure_roots(graph, *id));
    roots.map(|id| context.field(id)).collect::<BTreeSet<_>>().into_iter().collect()
}

/// More tool changes than tools, where each tool could visit all its holes at once.
fn changes(context: &Context<'_>, findings: &mut Vec<AuditFinding>) {
    let changes = context.changes();
    let mut tools = changes.clone();
    tools.sort_unstable();
    tools.dedup();
    // A list of tools goes hole by hole and says nothing of the order of work.
    if context.stated.is_own || context.stated.is_list || changes.len() <= tools.len() {
        return;
    }
    // The least number, by the order of the program's plan: each tool comes once where the transitions permit it.
    let least = context.plan.sequence.len();
    if changes.len() <= least || least == 0 {
        return;
    }
    let extra = (changes.len() - least) as f64 * context.shop.machine.tool_change.0;
    let note = Note::new("audit-tool-changes")
        .with("changes", changes.len())
        .with("needed", least)
        .with("order", changes.iter().map(|tool| format!("T{tool}")).collect::<Vec<_>>().join(", "))
        .with("time", round_to(extra, 2));
    let finding = AuditFinding::new(Severity::Doubtful, Section::Route, "route".to_owned(), note);
    let finding = match context.stated.rows.first() {
        Some(row) => finding.at(&row.place),
        None => finding,
    };
    findings.push(finding.with_values(changes.len(), least));
}
