//! The route: every hole, the order of its transitions, its scheme beside those the tables allow, the tool changes.

use crate::error::KnowledgeError;
use crate::knowledge::Input;
use crate::note::{Because, Note, Severity};
use crate::part::Hole;
use crate::plan::{HolePlan, Operation};
use crate::units::{Micrometres, round_to};

use super::super::context::Context;
use super::super::finding::{Finding, Section, Subject};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::Row;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    if stated.rows.is_empty() {
        return Ok(());
    }
    for hole in &stated.part.holes {
        let rows: Vec<(usize, &Row)> = stated.rows_of_hole(&hole.name).collect();
        let plan = context.plan.holes.iter().find(|plan| plan.name == hole.name);
        if rows.is_empty() {
            // A hole that nothing makes in our plan either is told there.
            if plan.is_some_and(|plan| !plan.transitions.is_empty()) {
                let field = format!("route.{}", hole.name);
                let note = Note::new("audit-hole-not-made").with("hole", &hole.name).with("count", hole.at.len());
                findings.push(Finding::new(Severity::Error, Section::Route, field, note).about(of_hole(hole)));
            }
            continue;
        }
        order(context, &rows, findings)?;
        finished(context, graph, hole, &rows, findings);
        if let Some(plan) = plan {
            scheme(hole, plan, &rows, findings);
        }
    }
    changes(context, findings);
    Ok(())
}

fn of_hole(hole: &Hole) -> Subject {
    Subject { holes: vec![hole.name.clone()], ..Subject::default() }
}

/// The order of section 1.1.2: ranks of one cylinder never fall. What opens edges may stand between.
fn order(context: &Context<'_>, rows: &[(usize, &Row)], findings: &mut Vec<Finding>) -> Result<(), KnowledgeError> {
    let rule = context.shop.knowledge.table("transition-order")?;
    let mut before: Option<(i64, &Row)> = None;
    for (at, row) in rows {
        let operation = row.operation.value;
        if operation.is_of_edge() || !row.of_main_cylinder() {
            continue;
        }
        let inputs = [("operation", Input::Text(operation.name())), ("face", Input::Bool(false))];
        let answer = rule.decide(&inputs)?;
        let Some(winner) = answer.winner() else { continue };
        let rank = winner.int("rank")?;
        if let Some((least, other)) = before
            && rank < least
        {
            let note = Note::new("audit-order")
                .with("operation", operation.name())
                .with("instead", other.operation.value.name())
                .with("row", other.number);
            let field = format!("route.{}.operation", row.number);
            let finding = Finding::new(Severity::Wrong, Section::Route, field, note).at(&row.operation.place);
            let because = Because::row(winner, Note::new("audit-rank").with("rank", rank));
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
    findings: &mut Vec<Finding>,
) {
    let bores = |row: &Row| row.opens_main_cylinder() && row.operation.value != Operation::Tap;
    let mut before = Micrometres::ZERO;
    let mut last = None;
    for (at, row) in rows.iter().filter(|(_, row)| bores(row)) {
        let id = Id::new(Scope::Row(*at), Q::Diameter);
        let Some(diameter) = graph.stated_or_right(id) else { return };
        let diameter = Micrometres::from_mm_rounded(diameter);
        let floor = row.operation.value == Operation::Mill && diameter == before;
        if diameter <= before && !floor {
            let note = Note::new("audit-not-opened").with("diameter", diameter).with("before", before);
            let field = format!("route.{}.diameter", row.number);
            let finding = Finding::new(Severity::Wrong, Section::Route, field, note).at(&row.place);
            findings.push(finding.about(context.subject(Scope::Row(*at))));
        }
        before = diameter;
        last = Some((*at, *row, diameter));
    }
    // A thread's hole is that of its tap; a hole finished elsewhere keeps its stock.
    let reference = context.plan.holes.iter().find(|plan| plan.name == hole.name);
    let elsewhere = reference.and_then(|plan| plan.route.as_ref()).is_some_and(|route| route.finish_elsewhere);
    if hole.thread.is_some() || elsewhere {
        return;
    }
    if let Some((at, row, diameter)) = last
        && !(hole.diameter.smallest()..=hole.diameter.largest()).contains(&diameter)
        && diameter != hole.diameter.nominal
    {
        let note = Note::new("audit-last-diameter").with("diameter", diameter).with("hole", &hole.diameter);
        let field = format!("route.{}.diameter", row.number);
        let finding = Finding::new(Severity::Wrong, Section::Route, field, note).at(&row.place);
        findings.push(finding.beside(diameter, &hole.diameter).about(context.subject(Scope::Row(at))));
    }
}

/// The transitions of a hole beside the routes that the tables allow, and how they rank.
fn scheme(hole: &Hole, plan: &HolePlan, rows: &[(usize, &Row)], findings: &mut Vec<Finding>) {
    let Some(route) = &plan.route else { return };
    let stated: Vec<Operation> = rows.iter().map(|(_, row)| row.operation.value).collect();
    let ours: Vec<Operation> = plan.transitions.iter().map(|transition| transition.operation).collect();
    let named = rows.iter().find(|(_, row)| row.scheme.is_some()).or(rows.first());
    let Some((_, first)) = named else { return };
    let place = first.scheme.as_ref().map_or(&first.place, |scheme| &scheme.place);
    let field = format!("route.{}.scheme", first.number);
    let say = |severity, note: Note| {
        let finding = Finding::new(severity, Section::Route, field.clone(), note).at(place);
        finding.about(of_hole(hole)).resting_on(route.because.iter().take(3).cloned())
    };
    let best = |note: Note| note.with("scheme", &route.scheme).with("table", &route.table);
    if let Some(named) = &first.scheme {
        let known = (named.value == route.scheme) || route.alternatives.iter().any(|other| other.scheme == named.value);
        if !known {
            let note = best(Note::new("audit-scheme-unknown").with("stated", &named.value).with("hole", &hole.name));
            findings.push(say(Severity::Wrong, note).beside(&named.value, &route.scheme));
            return;
        }
        // The scheme and the table it is said to stand in.
        if let Some(table) = &first.table {
            let fits = (named.value == route.scheme && table.value == route.table)
                || route.alternatives.iter().any(|other| other.scheme == named.value && other.table == table.value);
            if !fits {
                let note = best(Note::new("audit-scheme-table").with("stated", &table.value).with("hole", &hole.name));
                let mut finding = say(Severity::Wrong, note).beside(&table.value, &route.table).at(&table.place);
                finding.field = format!("route.{}.table", first.number);
                findings.push(finding);
            }
        }
    }
    if stated == ours {
        return;
    }
    let main =
        |list: &[Operation]| -> Vec<Operation> { list.iter().copied().filter(|one| !one.is_of_edge()).collect() };
    let alike = |other: &crate::plan::Alternative| {
        let made: Vec<Operation> = other.operations.iter().map(|made| made.operation).collect();
        main(&made) == main(&stated)
    };
    let names = stated.iter().map(|operation| operation.name()).collect::<Vec<_>>().join(", ");
    let found = route.alternatives.iter().enumerate().find(|(_, other)| alike(other));
    let mut reasons = Vec::new();
    let note = match found {
        Some((rank, other)) if other.meets && other.time_min.is_some() => {
            let slower = other.time_min.map_or(0.0, |time| time.0 - route.time_min.0);
            let note = Note::new("audit-route-dominated").with("rank", rank + 2);
            (Severity::Doubtful, note.with("slower", round_to(slower, 2)))
        }
        Some((_, other)) => {
            reasons.push(other.why.clone());
            (Severity::Wrong, Note::new("audit-route-refused"))
        }
        None => (Severity::Wrong, Note::new("audit-route-unknown")),
    };
    let ours = ours.iter().map(|operation| operation.name()).collect::<Vec<_>>().join(", ");
    let text = best(note.1).with("hole", &hole.name).with("transitions", &names);
    let mut finding = say(note.0, text).beside(names, ours);
    finding.reasons = reasons;
    findings.push(finding);
}

/// More tool changes than tools where each could go round all its holes.
fn changes(context: &Context<'_>, findings: &mut Vec<Finding>) {
    let changes = context.changes();
    let mut tools = changes.clone();
    tools.sort_unstable();
    tools.dedup();
    if context.stated.own || changes.len() <= tools.len() {
        return;
    }
    // By our own plan's order, which puts every tool into the spindle once where the transitions let it.
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
    let finding = Finding::new(Severity::Doubtful, Section::Route, "route".to_owned(), note);
    let finding = match context.stated.rows.first() {
        Some(row) => finding.at(&row.place),
        None => finding,
    };
    findings.push(finding.beside(changes.len(), least));
}
