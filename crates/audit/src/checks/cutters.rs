//! Whether a cutter suits its transition: its kind, diameter and reach, and the bottom of its hole.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note, Severity};
use crate::part::Hole;
use crate::plan::Operation;
use crate::reason::{OfOther, Unfit};
use crate::shop::widest_over_hole;
use crate::tables::holes::HoleDefault;
use crate::tooling::named;
use crate::tooling::{CutterNeed, Plunging};
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::finding::{AuditFinding, FindingKind, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots;
use super::super::stated::{Row, StatedFigure};
use super::reach::Tips;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    let tips = Tips::read(context)?;
    let mut unsuited_rows = Vec::new();
    for (at, row) in context.stated.rows.iter().enumerate().filter(|(_, row)| !row.elsewhere) {
        let Some(tool) = context.stated.tool_of(row) else { continue };
        let Some(cutter) = context.cutter(tool) else { continue };
        let Some(hole) = context.hole(row) else { continue };
        // The angle of an edge is in no row; in a plan of the program the check `ours` compares it.
        if row.operation.value.is_of_edge() && context.stated.is_own {
            continue;
        }
        let finding = |severity, why: Note| {
            let field = format!("route.{}.tool", row.number);
            let place = row.tool.as_ref().map_or(&row.place, |tool| &tool.place);
            let note = why.with("tool", cutter.designation);
            let mut finding = AuditFinding::new(severity, Section::Tools, field, note).at(place);
            finding.subject = context.subject(Scope::Row(at));
            finding.subject.tool = Some(context.stated.tools[tool].number);
            finding.resting_on([Because::row(cutter.row.row, Note::new("named"))])
        };
        let need = need(context, graph, &tips, at, row, hole);
        if let Some(why) = named::unsuited(cutter, &need, machine) {
            let mut unsuited = finding(Severity::Error, why.note());
            if why.is_of_reach() {
                unsuited.follows_from = roots::roots_of(findings, context.field(Id::new(Scope::Row(at), Q::Depth)));
            }
            if let Unfit::OfOther(other) = why
                && !matches!(other, OfOther::Thread { .. })
            {
                unsuited.follows_from = diameter(context, graph, at, findings);
            }
            if unsuited.follows_from.is_empty() {
                unsuited_rows.push(Unsuited { row: at, tool, finding: findings.len() });
            }
            findings.push(unsuited);
        } else if let Some(why) = named::other_design_note(cutter, hole.through).filter(|_| row.of_main_cylinder()) {
            findings.push(finding(Severity::Wrong, why));
        }
    }
    let suits = |at: usize, tool: usize| {
        let row = context.stated.rows.get(at)?;
        let need = need(context, graph, &tips, at, row, context.hole(row)?);
        Some(named::unsuited(context.cutter(tool)?, &need, machine).is_none())
    };
    exchanged(context, &unsuited_rows, |at, tool| suits(at, tool) == Some(true), findings);
    one_of_tool(context, &unsuited_rows, findings);
    two_sizes(context, &unsuited_rows, findings);
    Ok(())
}

/// A row whose tool does not suit it, with its finding.
struct Unsuited {
    row: usize,
    tool: usize,
    finding: usize,
}

/// Two tools of which each suits the rows of the other are exchanged: one slip, told at the first of these rows.
fn exchanged(
    context: &Context<'_>,
    unsuited: &[Unsuited],
    suits: impl Fn(usize, usize) -> bool,
    findings: &mut [AuditFinding],
) {
    let mut tools: Vec<usize> = unsuited.iter().map(|one| one.tool).collect();
    tools.sort_unstable();
    tools.dedup();
    let of = |tool: usize| unsuited.iter().filter(move |one| one.tool == tool);
    for (place, &tool) in tools.iter().enumerate() {
        let mut others = tools.iter().skip(place + 1).copied();
        let each = |tool: usize, other: usize| of(tool).all(|one| suits(one.row, other));
        let Some(other) = others.find(|other| each(tool, *other) && each(*other, tool)) else { continue };
        let both = || unsuited.iter().filter(|one| [tool, other].contains(&one.tool));
        let rows: Vec<String> = both().map(|one| context.stated.rows[one.row].number.to_string()).collect();
        let Some(first) = both().next().and_then(|one| findings.get(one.finding)).cloned() else { continue };
        let called = |tool: usize| format!("T{}", context.stated.tools[tool].number);
        let note = Note::new("audit-tools-exchanged").with("tool", called(tool)).with("other", called(other));
        let note = note.with("rows", rows.join(", "));
        let mut root = AuditFinding::new(first.severity, first.section, first.field.clone(), note).about(first.subject);
        (root.file, root.line, root.column, root.because) = (first.file, first.line, first.column, first.because);
        for (turn, one) in both().enumerate() {
            let Some(own) = findings.get_mut(one.finding) else { continue };
            if turn == 0 {
                *own = root.clone();
            } else {
                own.follows_from.push(first.field.clone());
            }
        }
    }
}

/// A tool that suits none of its rows is one slip, told at the first of them: its designation is wrong.
fn one_of_tool(context: &Context<'_>, unsuited: &[Unsuited], findings: &mut [AuditFinding]) {
    for (tool, own) in context.stated.tools.iter().enumerate() {
        let rows = || unsuited.iter().filter(|one| one.tool == tool);
        let Some(first) = rows().next().and_then(|one| findings.get(one.finding)) else { continue };
        if !first.follows_from.is_empty() || rows().count() != context.stated.rows_of_tool(own.number).count() {
            continue;
        }
        let field = first.field.clone();
        for one in rows().skip(1) {
            if let Some(finding) = findings.get_mut(one.finding).filter(|one| one.follows_from.is_empty()) {
                finding.follows_from.push(field.clone());
            }
        }
    }
}

/// A reamer or a core drill leaves one size: ground down for one row, it cannot make another of another size.
fn two_sizes(context: &Context<'_>, unsuited: &[Unsuited], findings: &mut Vec<AuditFinding>) {
    // A list may count tools of one designation as one.
    let numbered = !context.stated.is_own && !context.stated.is_list;
    for (at, tool) in context.stated.tools.iter().enumerate().filter(|_| numbered) {
        let sizes: Vec<(usize, &Row, &StatedFigure)> =
            context.stated.rows_of_tool(tool.number).filter_map(|(row, own)| Some((row, own, size(own)?))).collect();
        let Some((_, first, first_size)) = sizes.first() else { continue };
        let other = sizes.iter().find(|(row, _, size)| {
            (size.value - first_size.value).abs() > 1e-6 && !unsuited.iter().any(|one| one.row == *row)
        });
        let Some((row, own, size)) = other else { continue };
        let note = Note::new("audit-two-sizes")
            .with("tool", format!("T{}", tool.number))
            .with("size", Figure::number(size.text.clone()))
            .with("row", first.number)
            .with("other", Figure::number(first_size.text.clone()));
        let place = own.tool.as_ref().map_or(&own.place, |tool| &tool.place);
        let finding = AuditFinding::new(Severity::Wrong, Section::Tools, format!("route.{}.tool", own.number), note);
        let mut finding = finding.at(place).about(context.subject(Scope::Row(*row)));
        finding.subject.tool = context.stated.tools.get(at).map(|tool| tool.number);
        findings.push(finding);
    }
}

/// The size that a row asks of a tool that leaves one size.
fn size(row: &Row) -> Option<&StatedFigure> {
    let fixed = row.operation.value.is_reaming() || row.operation.value == Operation::CoreDrill;
    row.figures.get(&Q::Diameter).filter(|_| fixed && !row.elsewhere)
}

/// A cutter of another size than its row. The diameter of the row may be the slip, and the cutter is right for it;
/// where the drawing or the neighbouring rows confirm the diameter, no formula finds it wrong, and the cutter is the slip.
fn diameter(context: &Context<'_>, graph: &Graph<'_>, at: usize, findings: &[AuditFinding]) -> Vec<String> {
    let id = Id::new(Scope::Row(at), Q::Diameter);
    let field = context.field(id);
    // Another check has already found the diameter wrong, such as that of an opening.
    let already_reported = findings.iter().any(|finding| {
        finding.field == field
            && finding.follows_from.is_empty()
            && finding.severity <= Severity::Wrong
            && finding.kind == FindingKind::Opening
    });
    if already_reported {
        return vec![field];
    }
    roots::figure_roots(graph, id).into_iter().map(|root| context.field(root)).collect()
}

/// What the row requires of its cutter. In a plan of the program only the values in the row count, and reach only for
/// drills, because it was computed with everything above the cut. The reach of a tap depends on the hole through
/// which its shank passes.
fn need<'a>(
    context: &Context<'_>,
    graph: &Graph<'_>,
    tips: &Tips,
    at: usize,
    row: &Row,
    hole: &'a Hole,
) -> CutterNeed<'a> {
    let length = |quantity| graph.stated_or_right(Id::new(Scope::Row(at), quantity)).map(Micrometres::from_mm_rounded);
    let operation = row.operation.value;
    let planned = context.reference(at).map(|transition| transition.diameter_mm);
    let diameter = length(Q::Diameter).or(planned).unwrap_or(hole.diameter.nominal);
    let drills = matches!(operation, Operation::Drill | Operation::DrillOut);
    let required =
        if context.stated.is_own { drills } else { row.opens_main_cylinder() && operation != Operation::Tap };
    let plain = row.step.is_none() && hole.steps.is_empty();
    let reach = if required && plain { tips.tip_depth(context, at) } else { None };
    // What is not stated follows from the rows before: an edge is cut at the hole as they leave it.
    let before = || context.stated.rows_of_hole(&hole.name).take_while(|(other, _)| *other < at);
    let left = || {
        let (last, _) = before().filter(|(_, other)| other.opens_main_cylinder()).last()?;
        graph.stated_or_right(Id::new(Scope::Row(last), Q::Diameter)).map(Micrometres::from_mm_rounded)
    };
    let bored = || left().unwrap_or(hole.diameter.nominal);
    let enters = length(Q::From).or_else(|| operation.is_of_edge().then(bored)).unwrap_or_default();
    let cone = hole.countersink.map(|sink| sink.angle_millideg).or(hole.cone.map(|cone| cone.angle_millideg));
    let nominal = context.bought_size(row, diameter).unwrap_or(diameter);
    CutterNeed {
        nominal,
        enters,
        reach: reach.unwrap_or_default(),
        through: hole.through,
        thread: hole.thread_at(row.step).map(|thread| thread.id.as_str()),
        angle_millideg: match operation {
            Operation::Countersink => cone.or(Some(90_000)),
            Operation::Chamfer => Some(90_000),
            _ => None,
        },
        clearance: Micrometres::ZERO,
        // One that goes round is wider than its front by the cone at least.
        round: context.goes_round(at).then(|| diameter - enters),
        plunges: (operation == Operation::Mill).then(|| plunging(context, row, hole, diameter, enters)).flatten(),
        grind_limit: context.shop.grind_limit(diameter).unwrap_or_default(),
        ..CutterNeed::plain(operation, diameter)
    }
}

/// How wide a mill may be that cuts its way down. Over a hole the middle of one without teeth there must lie over it; whether one
/// may go down to a flat floor is judged by the proof of plans. Elsewhere in the main cylinder a mill goes into the hole.
fn plunging(
    context: &Context<'_>,
    row: &Row,
    hole: &Hole,
    diameter: Micrometres,
    enters: Micrometres,
) -> Option<Plunging> {
    if row.opens_main_cylinder() {
        // A mill goes down into the metal of a slot, whether that goes through or not.
        let floor = hole.slot.is_some() || !hole.through && hole.thread.is_none();
        return floor.then_some(Plunging { widest: diameter, without_middle: diameter });
    }
    let core = context.shop.share(HoleDefault::MillCoreShare).unwrap_or(1.0);
    Some(Plunging { widest: diameter, without_middle: widest_over_hole(enters, core) })
}
