//! Threaded holes: the drill under the thread, the depth of hole and thread, and the machine that cuts the thread.

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::note::{Because, Figure, Note, Severity};
use crate::part::{Hole, Thread};
use crate::plan::Operation;
use crate::tables::holes::HoleDefault;
use crate::tables::machines::MachineQuantity;
use crate::tables::standards::{CoarseThread, FineThread};
use crate::units::Micrometres;
use technolog_core::tapping::minor_diameter;

use super::super::context::Context;
use super::super::figures::with_right_value;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::{Row, StatedFigure};
use super::openings::right_by_drawing;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    taps(context, findings)?;
    for hole in &context.stated.part.holes {
        let Some(thread) = &hole.thread else { continue };
        let rows: Vec<(usize, &Row)> = context.stated.rows_of_hole(&hole.name).collect();
        let opens = |row: &Row| row.opens_main_cylinder() && row.operation.value != Operation::Tap;
        let Some((at, row)) = rows.iter().rev().find(|(_, row)| opens(row)) else { continue };
        drill(context, graph, (hole, thread), (*at, row), findings);
        if hole.steps.is_empty() {
            for (at, row) in rows.iter().filter(|(_, row)| opens(row) || row.operation.value == Operation::Tap) {
                depth(context, graph, (hole, thread), (*at, row), findings)?;
            }
        }
        let tapped = rows.iter().any(|(_, row)| row.operation.value == Operation::Tap);
        if !tapped && !context.shop.machine.can_tap {
            let note = Note::new("audit-thread-elsewhere").with("thread", &thread.written).with("hole", &hole.name);
            let finding = AuditFinding::new(Severity::Note, Section::Route, format!("route.{}", hole.name), note);
            findings.push(finding.at(&row.place).about(context.subject(Scope::Row(*at))));
        }
    }
    Ok(())
}

/// A tap in the magazine of a machine that cannot tap.
fn taps(context: &Context<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    if machine.can_tap {
        return Ok(());
    }
    for (at, row) in context.stated.rows.iter().enumerate() {
        // Without a tool it is made on another machine.
        let Some(tool) = row.tool.as_ref().filter(|_| row.operation.value == Operation::Tap && !row.elsewhere) else {
            continue;
        };
        let note = Note::new("audit-cannot-tap")
            .with("machine", Figure::word_of("machine", context.stated.part.machine.clone()));
        let field = format!("route.{}.tool", row.number);
        let finding = AuditFinding::new(Severity::Error, Section::Route, field, note).at(&tool.place);
        let because = Because::row(machine.row(MachineQuantity::CanTap)?, Note::new("audit-limit"));
        findings.push(finding.about(context.subject(Scope::Row(at))).resting_on([because]));
    }
    Ok(())
}

/// The drill of a metric thread by its table.
fn tap_drill<'a>(thread: &Thread, context: &Context<'a>) -> Option<(Micrometres, RowRef<'a>)> {
    let knowledge = context.shop.knowledge;
    let coarse = knowledge.find(|row: &CoarseThread<'_>| row.thread == thread.id).ok()?;
    let fine = || knowledge.find(|row: &FineThread<'_>| row.thread == thread.id).ok()?;
    coarse.map(|row| (row.diameter, row.row)).or_else(|| fine().map(|row| (row.diameter, row.row)))
}

/// Checks the hole under the tap: by the drill of the table, or within the limits of the thread.
fn drill(
    context: &Context<'_>,
    graph: &Graph<'_>,
    (hole, thread): (&Hole, &Thread),
    (at, row): (usize, &Row),
    findings: &mut Vec<AuditFinding>,
) {
    let Some(figure) = row.figures.get(&Q::Diameter) else { return };
    // The formulas report it where it is not the diameter of its own tool.
    let own = Micrometres::from_mm_rounded(figure.value);
    let found = tap_drill(thread, context);
    let limits = hole.diameter.smallest()..=hole.diameter.largest();
    if found.is_some_and(|(right, _)| right == own) || limits.contains(&own) {
        return;
    }
    // What the standard allows under the thread is no slip, though the table has another drill: Ø8.6 under M10.
    let allowed = minor_diameter(thread.size, thread.pitch, context.shop.knowledge);
    if allowed.is_ok_and(|(least, most)| (least..=most).contains(&own)) {
        return;
    }
    let right = found.map_or_else(|| hole.diameter.target(), |(right, _)| right);
    let note = Note::new("audit-tap-drill")
        .with("thread", &thread.written)
        .with("low", hole.diameter.smallest())
        .with("high", hole.diameter.largest());
    let field = format!("route.{}.diameter", row.number);
    let finding =
        AuditFinding::new(Severity::Wrong, Section::Route, field, note).about(context.subject(Scope::Row(at)));
    let finding = finding.resting_on(found.map(|(_, row)| Because::row(row, Note::new("named"))));
    let id = Id::new(Scope::Row(at), Q::Diameter);
    // Reported once: where the tool has the right diameter, the misprint has its finding already.
    if graph.verdict(id).is_none_or(|verdict| verdict.status == super::super::graph::Status::Fine) {
        findings.push(with_right_value(finding, figure, right, Q::Diameter));
        right_by_drawing(context, graph, at, right, findings);
    }
}

/// How deep a hole and its thread go.
fn depth(
    context: &Context<'_>,
    graph: &Graph<'_>,
    (hole, thread): (&Hole, &Thread),
    (at, row): (usize, &Row),
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(figure) = row.figures.get(&Q::Depth) else { return Ok(()) };
    if graph.formula(Id::new(Scope::Row(at), Q::Depth)).is_some() {
        return Ok(());
    }
    let stated = Micrometres::from_mm_rounded(figure.value);
    let pitches = |name: HoleDefault| -> Result<Micrometres, KnowledgeError> {
        Ok(Micrometres::from_mm_rounded(thread.pitch.to_mm() * context.shop.share(name)?))
    };
    let tap = row.operation.value == Operation::Tap;
    let blind = !hole.through && !tap;
    // The first teeth of a tap cut no full thread: a blind hole goes deeper by its run-out.
    let right = if blind { hole.depth + pitches(HoleDefault::ThreadRunoutPitches)? } else { hole.depth };
    let mut say = |severity, code: &'static str, figure: &StatedFigure| {
        let note = Note::new(code).with("thread", &thread.written).with("depth", hole.depth);
        let finding = AuditFinding::new(severity, Section::Route, format!("route.{}.depth", row.number), note);
        findings.push(with_right_value(finding.about(context.subject(Scope::Row(at))), figure, right, Q::Depth));
    };
    if stated < hole.depth {
        say(Severity::Wrong, "audit-thread-short", figure);
    } else if blind && stated < hole.depth + pitches(HoleDefault::BottomingTapLeadPitches)? {
        say(Severity::Doubtful, "audit-thread-runout", figure);
    } else if !blind && stated != right && !hole.through {
        say(Severity::Wrong, "audit-thread-deep", figure);
    }
    Ok(())
}
