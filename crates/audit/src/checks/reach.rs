//! How far a tool goes below the face it enters, and whether its overhang is long enough.

use crate::error::KnowledgeError;
use crate::knowledge::vocabulary::Shank;
use crate::note::{Because, Note, Severity};
use crate::plan::Operation;
use crate::tooling::named;
use crate::units::Micrometres;
use crate::zone;

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots;

/// The depths of tips, with the addition of the rule `approach` to the depth of a hole.
pub(super) struct Tips {
    /// How far above the part the feed begins.
    pub approach: Micrometres,
    overrun: Micrometres,
}

impl Tips {
    /// By the rule `approach`.
    ///
    /// # Errors
    /// The rule has no row.
    pub fn read(context: &Context<'_>) -> Result<Self, KnowledgeError> {
        let row = zone::approach(&context.stated.part, true, context.shop.knowledge)?;
        Ok(Self { approach: row.approach, overrun: row.overrun })
    }

    /// How far below its face the tip of a row's tool goes: depth, point and overrun. Point and overrun are those of
    /// the same transition in the program's plan, if there is one; none if the depth is not known.
    pub fn tip_depth(&self, context: &Context<'_>, at: usize) -> Option<Micrometres> {
        let row = context.stated.rows.get(at).filter(|row| !row.elsewhere)?;
        let hole = context.hole(row)?;
        let figure = |quantity| {
            let figure = context.stated.figure(Id::new(Scope::Row(at), quantity))?;
            Some(Micrometres::from_mm_rounded(figure.value))
        };
        let depth = figure(Q::Depth);
        if let Some(transition) = context.reference(at) {
            return Some(depth.unwrap_or(transition.depth_mm) + transition.end() - transition.depth_mm);
        }
        if !row.opens_main_cylinder() {
            return depth;
        }
        let depth = depth.or(Some(hole.depth).filter(|_| hole.steps.is_empty()))?;
        let point = match row.operation.value {
            Operation::Drill | Operation::DrillOut => {
                let cutter = context.stated.tool_of(row).and_then(|tool| context.cutter(tool));
                let angle = cutter.and_then(|cutter| named::point_angle(cutter));
                let diameter = figure(Q::Diameter).unwrap_or(hole.diameter.nominal).to_mm();
                // The length of a point: the radius divided by the tangent of half its angle.
                angle.map(|angle| diameter / 2.0 / libm::tan(angle.to_radians() / 2.0)).unwrap_or_default()
            }
            _ => 0.0,
        };
        let overrun = if hole.through { self.overrun } else { Micrometres::ZERO };
        Some(depth + Micrometres::from_mm_rounded(point) + overrun)
    }
}

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let tips = Tips::read(context)?;
    for (tool, own) in context.stated.tools.iter().enumerate() {
        let rows = context.stated.rows_of_tool(own.number);
        // The deepest hole of the tool decides.
        let deepest = rows.filter_map(|(at, _)| Some((at, tips.tip_depth(context, at)?))).max_by_key(|(_, tip)| *tip);
        let Some((at, needed)) = deepest else { continue };
        holder(context, graph, (tool, at), needed, findings);
        flute(context, (tool, at), needed, findings);
    }
    Ok(())
}

/// A cutter whose overhang is less than its depth: its holder would hit the part. The arbor of a shell cutter follows
/// it into the hole.
fn holder(
    context: &Context<'_>,
    graph: &Graph<'_>,
    (tool, row): (usize, usize),
    needed: Micrometres,
    findings: &mut Vec<AuditFinding>,
) {
    let shank = context.cutter(tool).map(|cutter| cutter.head.shank);
    let arbor = if shank == Some(Shank::Shell) { Some(Q::HolderUsed) } else { None };
    let length = |of: &dyn Fn(Id) -> Option<f64>| -> Option<Micrometres> {
        let parts = [Some(Q::Overhang), arbor].into_iter().flatten();
        let lengths: Option<Vec<f64>> = parts.map(|quantity| of(Id::new(Scope::Tool(tool), quantity))).collect();
        Some(Micrometres::from_mm_rounded(lengths?.iter().sum()))
    };
    let Some(stands_out) = length(&|id| graph.written(id)).filter(|own| *own < needed) else { return };
    let id = Id::new(Scope::Tool(tool), Q::Overhang);
    let field = context.field(id);
    let note = Note::new("audit-holder-hits").with("reach", stands_out).with("needed", needed);
    let own = &context.stated.tools[tool];
    let place = own.figures.get(&Q::Overhang).map_or(&own.place, |figure| &figure.place);
    let mut finding = AuditFinding::new(Severity::Error, Section::Lengths, field.clone(), note).at(place);
    finding.subject = context.subject(Scope::Row(row));
    finding.subject.tool = Some(own.number);
    finding.stated = own.figures.get(&Q::Overhang).map(|figure| figure.text.clone());
    finding.quantity = Some(Q::Overhang);
    // Where the overhang is a slip and its right value is long enough, only the slip is reported.
    let slip = graph.verdict(id).is_some_and(|verdict| verdict.status != Status::Fine);
    if slip && length(&|id| graph.right(id)).is_some_and(|right| right >= needed) {
        finding.follows_from = vec![field];
    } else {
        finding.follows_from = roots::roots_of(findings, context.field(Id::new(Scope::Row(row), Q::Depth)));
    }
    findings.push(finding.resting_on(context.holder(tool).map(|holder| Because::row(holder.row, Note::new("named")))));
}

/// The stated flute length of a drill that no catalog has; for a known drill `cutters` reports it.
fn flute(context: &Context<'_>, (tool, row): (usize, usize), needed: Micrometres, findings: &mut Vec<AuditFinding>) {
    let operation = context.stated.rows[row].operation.value;
    let drills = matches!(operation, Operation::Drill | Operation::DrillOut);
    let own = &context.stated.tools[tool];
    let flute = own.figures.get(&Q::FluteLength).filter(|_| drills && context.cutter(tool).is_none());
    let Some(figure) = flute.filter(|flute| Micrometres::from_mm_rounded(flute.value) < needed) else { return };
    let field = context.field(Id::new(Scope::Tool(tool), Q::FluteLength));
    let note = Note::new("audit-flute-short").with("reach", &figure.text).with("needed", needed);
    let mut finding = AuditFinding::new(Severity::Error, Section::Tools, field, note).at(&figure.place);
    finding.subject = context.subject(Scope::Row(row));
    finding.subject.tool = Some(own.number);
    findings.push(finding.with_values(&figure.text, format!(">= {needed}")));
}
