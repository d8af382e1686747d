//! The depths of transitions for which the route has no formula: after the drill a tool goes as deep as the hole,
//! centring as deep as its spot requires, and nothing cuts through a blind hole.

use crate::error::KnowledgeError;
use crate::note::{self, Figure, Note, Severity};
use crate::part::{Bottom, Hole};
use crate::plan::Operation;
use crate::tables::holes::HoleDefault;
use crate::tooling::named;
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::figures::{shown, with_right_value};
use super::super::finding::{AuditFinding, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::{Row, StatedFigure};

/// The depth of a spot is half its width: centring drills have 90° (textbook 1.2.1, l. 272-273).
const CENTRING_ANGLE: f64 = 90.0;

/// The usual point of a drill (ГОСТ 10903).
const DRILL_ANGLE: f64 = 118.0;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    for (at, row) in context.stated.rows.iter().enumerate() {
        let (Some(hole), Some(figure)) = (context.hole(row), row.figures.get(&Q::Depth)) else { continue };
        if !row.of_main_cylinder() || row.operation.value.is_of_edge() {
            continue;
        }
        let verdict = graph.verdict(Id::new(Scope::Row(at), Q::Depth));
        let is_slip = verdict.is_some_and(|verdict| verdict.status != Status::Fine);
        let field = || format!("route.{}.depth", row.number);
        let say = |severity, note: Note| {
            AuditFinding::new(severity, Section::Route, field(), note).about(context.subject(Scope::Row(at)))
        };
        if let Some(end) = breaks_through(context, graph, at, row, hole, figure) {
            let thickness = context.stated.part.blank.thickness;
            let note = Note::new("audit-breaks-through")
                .with("end", note::Figure::number(shown(end)))
                .with("thickness", thickness);
            findings.retain(|finding| finding.field != field());
            // The tip of a drill would leave only a small hole, if its depth is that of the drawing.
            let is_through = figure.value >= thickness.to_mm() || is_slip;
            let finding = say(if is_through { Severity::Error } else { Severity::Doubtful }, note);
            findings.push(with_right_value(finding, figure, format!("< {thickness}"), Q::Depth));
            continue;
        }
        if is_slip || graph.formula(Id::new(Scope::Row(at), Q::Depth)).is_some() {
            continue;
        }
        if row.operation.value == Operation::CentreDrill {
            // How wide the spot of a program is meant to be nobody says.
            let is_said = row.figures.contains_key(&Q::Diameter);
            if let Some(right) = spot(context, graph, at, row).filter(|_| is_said || !context.stated.is_of_program())
                && (figure.value - right).abs() > figure.last_place / 2.0 + 1e-6
            {
                // Without its diameter, the author may have meant a wider spot than our plan makes.
                let severity = if is_said { Severity::Wrong } else { Severity::Doubtful };
                let finding = say(severity, Note::new("audit-spot-depth"));
                findings.push(with_right_value(finding, figure, shown(right), Q::Depth));
            }
            continue;
        }
        // The cylinders of stepped and conical holes end where the next begins, and threads have rules of their own.
        let plain = hole.steps.is_empty() && hole.thread.is_none() && hole.cone.is_none();
        // A later mill makes the flat bottom, and the point of the drill stays above it.
        let milled = context.stated.mill_follows(&hole.name, at) && !hole.through;
        let plain = plain && !milled;
        // Before a reamer a blind hole is drilled deeper, for its lead and for chips; over a flat floor the reamer ends above it, and a
        // boring bar, too.
        let stated = Micrometres::from_mm_rounded(figure.value);
        let room = hole.diameter.nominal.half() + context.shop.convention(HoleDefault::ReamerChipRoom)?;
        let deeper = context.stated.reamer_follows(&hole.name, at) && !hole.through;
        // A mill before it has made a free floor flat, too.
        let mut before = context.stated.rows_of_hole(&hole.name).filter(|(other, _)| *other < at);
        let levelled = before.any(|(_, own)| own.operation.value == Operation::Mill);
        let floor = (hole.bottom == Bottom::Flat || levelled) && !hole.through;
        let above = match row.operation.value {
            operation if floor && operation.is_reaming() => room,
            operation if floor && operation.is_boring() => context.shop.convention(HoleDefault::FlatFloorGap)?,
            _ => Micrometres::ZERO,
        };
        let most = if deeper { hole.depth + room } else { hole.depth };
        let most = most + Micrometres::from_mm_rounded(shorter_point(context, graph, at, hole));
        let least = hole.depth - above;
        let runs_out = context.runs_out(hole, at) && context.is_overrun(hole, figure.value);
        if plain && !runs_out && !(least..=most).contains(&stated) {
            let finding =
                say(Severity::Wrong, Note::new("audit-depth-of-hole").with("hole", Figure::called(&hole.name)));
            findings.push(with_right_value(finding, figure, hole.depth, Q::Depth));
        }
    }
    travels(context, graph, findings);
    Ok(())
}

/// A tool is fed at least as far as its transition is deep; what comes before and behind it is a choice. In a hole that is wider at its
/// mouth it may begin lower.
fn travels(context: &Context<'_>, graph: &Graph<'_>, findings: &mut Vec<AuditFinding>) {
    let by_hand = context.stated.conditions.iter().enumerate().filter(|(_, own)| !own.rounds && !context.stated.is_own);
    for (at, conditions) in by_hand {
        let id = Id::new(Scope::Conditions(at), Q::Travel);
        let is_slip = graph.verdict(id).is_some_and(|verdict| verdict.status != Status::Fine);
        let Some(figure) = conditions.figures.get(&Q::Travel).filter(|_| !is_slip) else { continue };
        let depths = conditions.rows.iter().filter_map(|row| {
            let own = context.stated.rows.get(*row)?;
            let hole = context.hole(own)?;
            let plain = hole.steps.is_empty() && hole.cone.is_none() && hole.thread.is_none();
            let plain = plain && hole.counterbore.is_none() && hole.countersink.is_none();
            let bores = plain
                && own.of_main_cylinder()
                && !matches!(own.operation.value, Operation::CentreDrill | Operation::Mill | Operation::Tap);
            // A depth beyond the drawing is told by itself.
            let depth = graph.stated_or_right(Id::new(Scope::Row(*row), Q::Depth)).filter(|_| bores);
            depth.map(|depth| depth.min(hole.depth.to_mm()))
        });
        let Some(deepest) = depths.reduce(f64::max).filter(|depth| figure.value < *depth - 1e-6) else { continue };
        let note = Note::new("audit-travel-short").with("depth", note::Figure::number(shown(deepest)));
        let finding = AuditFinding::new(Severity::Wrong, Section::Conditions, context.field(id), note);
        let finding = finding.about(context.subject(Scope::Conditions(at)));
        findings.push(with_right_value(finding, figure, format!("> {}", shown(deepest)), Q::Travel));
    }
}

/// How far the tip of a cutter comes out below a part with a blind hole, mm; none if it stays inside.
fn breaks_through(
    context: &Context<'_>,
    graph: &Graph<'_>,
    at: usize,
    row: &Row,
    hole: &Hole,
    figure: &StatedFigure,
) -> Option<f64> {
    let thickness = context.stated.part.blank.thickness;
    // Where the drawing leaves no room, as for the run-out of a thread, the program's plan comes out too.
    let ours = context.plan.holes.iter().find(|plan| plan.name == hole.name);
    let no_room = ours.is_some_and(|plan| plan.transitions.iter().any(|transition| transition.end() >= thickness));
    if hole.through || row.operation.value == Operation::CentreDrill || no_room {
        return None;
    }
    let drills = matches!(row.operation.value, Operation::Drill | Operation::DrillOut);
    let angle = context.stated.tool_of(row).and_then(|tool| context.cutter(tool)).filter(|_| drills);
    let angle = angle.and_then(|cutter| named::point_angle(cutter));
    let diameter = graph.stated_or_right(Id::new(Scope::Row(at), Q::Diameter));
    let point = angle.zip(diameter).map_or(0.0, |(angle, diameter)| cone(diameter, angle));
    let end = figure.value + point;
    (end >= thickness.to_mm()).then_some(end)
}

/// How much deeper than the second the first drill of a blind hole may go, mm, in whole millimetres: both points then end together.
fn shorter_point(context: &Context<'_>, graph: &Graph<'_>, at: usize, hole: &Hole) -> f64 {
    let second = context.stated.drilled_out(&hole.name, at).filter(|_| !hole.through);
    let diameter = |row: usize| graph.stated_or_right(Id::new(Scope::Row(row), Q::Diameter));
    let pair = diameter(at).zip(second.and_then(diameter));
    pair.map_or(0.0, |(first, second)| libm::ceil(cone((second - first).max(0.0), DRILL_ANGLE)))
}

/// How deep a centring spot is, mm, by its diameter and the angle of the centring drill.
fn spot(context: &Context<'_>, graph: &Graph<'_>, at: usize, row: &Row) -> Option<f64> {
    let diameter = graph.stated_or_right(Id::new(Scope::Row(at), Q::Diameter))?;
    let cutter = context.stated.tool_of(row).and_then(|tool| context.cutter(tool));
    let angle = cutter.and_then(|cutter| named::point_angle(cutter)).unwrap_or(CENTRING_ANGLE);
    Some(cone(diameter, angle))
}

/// (D/2)/tan φ: the height of a cone, mm, of that diameter, mm, and full angle 2φ, degrees.
fn cone(diameter: f64, angle: f64) -> f64 {
    diameter / 2.0 / libm::tan((angle / 2.0).to_radians())
}
