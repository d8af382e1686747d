//! Whether a cutter suits its transition, and a holder its cutter.

use crate::error::KnowledgeError;
use crate::note::{Because, Note, Severity};
use crate::part::Hole;
use crate::plan::Operation;
use crate::tooling::CutterNeed;
use crate::tooling::named;
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::finding::{Finding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::Row;
use super::reach::Tips;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    let tips = Tips::read(context)?;
    for (at, row) in context.stated.rows.iter().enumerate().filter(|(_, row)| !row.elsewhere) {
        let Some(tool) = context.stated.tool_of(row) else { continue };
        let Some(cutter) = context.cutter(tool) else { continue };
        let Some(hole) = context.hole(row) else { continue };
        // The angle of an edge stands in no row; what we chose for it `ours` holds against our plan.
        if row.operation.value.is_of_edge() && context.stated.own {
            continue;
        }
        let Some(why) = named::unsuited(&cutter, &need(context, graph, &tips, at, row, hole), machine) else {
            continue;
        };
        let field = format!("route.{}.tool", row.number);
        let place = row.tool.as_ref().map_or(&row.place, |tool| &tool.place);
        let note = why.with("tool", cutter.designation);
        let mut finding = Finding::new(Severity::Error, Section::Tools, field, note).at(place);
        finding.subject = context.subject(Scope::Row(at));
        finding.subject.tool = Some(context.stated.tools[tool].number);
        findings.push(finding.resting_on([Because::row(cutter.row, Note::new("named"))]));
    }
    for (at, tool) in context.stated.tools.iter().enumerate() {
        let (Some(cutter), Some(holder)) = (context.cutter(at), context.holder(at)) else { continue };
        if let Some(why) = named::not_taken(holder, &cutter, machine) {
            let name = tool.holder.as_ref().map_or("", |holder| holder.value.as_str());
            let field = format!("tools.T{}.holder.designation", tool.number);
            let place = tool.holder.as_ref().map_or(&tool.place, |holder| &holder.place);
            let note = why.with("holder", name).with("tool", cutter.designation);
            let finding = Finding::new(Severity::Error, Section::Holders, field, note).at(place);
            let because = Because::row(holder, Note::new("named"));
            findings.push(finding.about(context.subject(Scope::Tool(at))).resting_on([because]));
        }
    }
    Ok(())
}

/// What the row asks of its cutter. Of a plan of ours only what stands in the row is asked, and of reach only that of
/// drills, for it was reckoned with all that lies above it. How far a tap reaches depends on what its shank passes through.
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
    let asked = if context.stated.own { drills } else { row.opens_main_cylinder() && operation != Operation::Tap };
    let plain = row.step.is_none() && hole.steps.is_empty();
    let reach = if asked && plain { tips.of(context, at) } else { None };
    let cone = hole.countersink.map(|sink| sink.angle_millideg).or(hole.cone.map(|cone| cone.angle_millideg));
    CutterNeed {
        enters: length(Q::From).unwrap_or_default(),
        reach: reach.unwrap_or_default(),
        through: hole.through,
        thread: hole.thread_at(row.step).map(|thread| thread.id.as_str()),
        angle_millideg: match operation {
            Operation::Countersink => cone.or(Some(90_000)),
            Operation::Chamfer => Some(90_000),
            _ => None,
        },
        clearance: Micrometres::ZERO,
        grind_limit: context.shop.convention("cutter-grind-limit-mm").unwrap_or_default(),
        ..CutterNeed::plain(operation, diameter)
    }
}
