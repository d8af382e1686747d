//! The openings at the ends of a hole: counterbores, countersinks, chamfers. Checks whether the drawing requires what
//! the rows cut, with its diameter and depth, and whether the rows cut what the drawing requires.

use crate::error::KnowledgeError;
use crate::note::{Figure, Note, Severity};
use crate::part::Hole;
use crate::plan::{Feature, Operation, Transition};
use crate::route::bores;
use crate::tables::audit::PlanPart;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::figures::{shown, with_right_value};
use super::super::finding::{AuditFinding, FindingKind, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots;
use super::super::stated::Row;
use super::route::hole_subject;

/// An opening of the drawing.
#[derive(Clone, Copy, Debug)]
struct Opening {
    feature: Feature,
    diameter: Micrometres,
    /// Absent if the drawing does not fix it, as for a face.
    depth: Option<Micrometres>,
    /// Whether the drawing requires it; the lead-in of a thread is added by the program.
    required: bool,
}

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    for hole in context.stated.part.holes.iter().filter(|hole| hole.slot.is_none()) {
        let rows: Vec<(usize, &Row)> = context.stated.rows_of_hole(&hole.name).collect();
        if rows.is_empty() {
            continue;
        }
        let openings = openings(hole, context)?;
        let whole = context.stated.covers(PlanPart::Holes);
        let required = openings.iter().filter(|opening| whole && opening.required);
        for opening in required.filter(|opening| is_made_by_own_plan(context, hole, opening)) {
            check_made(context, graph, hole, opening, &rows, findings);
        }
        // Plans of the program report themselves what they cut beyond the drawing.
        for (at, row) in rows.iter().filter(|(_, row)| row.operation.value.is_of_edge() && row.step.is_none()) {
            asked_for(context, graph, *at, row, &openings, findings);
        }
    }
    Ok(())
}

/// The openings that the drawing has at the entry of a hole, and those that a thread needs there.
fn openings(hole: &Hole, context: &Context<'_>) -> Result<Vec<Opening>, KnowledgeError> {
    let task = bores::task(hole, &context.stated.part, &context.shop)?;
    let stock = context.shop.convention(HoleDefault::FaceStock)?;
    let edges = task.edges.iter().map(|edge| Opening {
        feature: edge.feature,
        diameter: edge.diameter,
        depth: Some(edge.depth(stock)).filter(|_| edge.feature != Feature::Face),
        required: edge.required,
    });
    let counterbore = hole.counterbore.map(|counterbore| Opening {
        feature: Feature::Counterbore,
        diameter: counterbore.diameter,
        depth: Some(counterbore.depth),
        required: true,
    });
    Ok(counterbore.into_iter().chain(edges).collect())
}

/// Whether the program's plan makes an opening: what that plan cannot make either is reported for the part.
fn is_made_by_own_plan(context: &Context<'_>, hole: &Hole, opening: &Opening) -> bool {
    let Some(plan) = context.plan.holes.iter().find(|plan| plan.name == hole.name) else { return false };
    let makes = |transition: &Transition| {
        transition.feature == opening.feature
            || transition.operation == Operation::CentreDrill && transition.diameter_mm >= opening.diameter
            || transition.also_diameter_mm == Some(opening.diameter)
    };
    plan.transitions.iter().any(makes)
}

/// Whether some row makes an opening that the drawing requires: a row of its own, a step drill, or a centring spot of
/// that width.
fn check_made(
    context: &Context<'_>,
    graph: &Graph<'_>,
    hole: &Hole,
    opening: &Opening,
    rows: &[(usize, &Row)],
    findings: &mut Vec<AuditFinding>,
) {
    let cuts = |row: &Row| match opening.feature {
        Feature::Counterbore | Feature::Face => matches!(row.operation.value, Operation::Counterbore | Operation::Mill),
        // Column 9 of A.7 covers countersinks and counterbores.
        _ => row.operation.value.is_of_edge(),
    };
    let own = |row: &Row| row.step.is_none() && row.feature.is_none_or(|feature| feature == opening.feature);
    let also = |row: &Row| row.figures.contains_key(&Q::Also);
    if rows.iter().any(|(_, row)| also(row) || own(row) && cuts(row)) {
        return;
    }
    let conical = !matches!(opening.feature, Feature::Counterbore | Feature::Face);
    let centring = rows.iter().find(|(_, row)| row.operation.value == Operation::CentreDrill && conical);
    let spot = centring.and_then(|(at, _)| graph.stated_or_right(Id::new(Scope::Row(*at), Q::Diameter)));
    if spot.is_some_and(|spot| Micrometres::from_mm_rounded(spot) >= opening.diameter) {
        return;
    }
    let note = |code: &'static str| {
        let note = Note::new(code).with("feature", Figure::word(opening.feature.name()));
        note.with("diameter", opening.diameter).with("hole", &hole.name)
    };
    // Either the spot is too narrow, or a row is missing.
    let finding = match centring.zip(spot) {
        Some(((at, row), spot)) => {
            let note = note("audit-opening-not-centred").with("spot", Figure::number(shown(spot)));
            let field = format!("route.{}.diameter", row.number);
            let finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.place);
            match row.figures.get(&Q::Diameter) {
                Some(figure) => with_right_value(finding, figure, opening.diameter, Q::Diameter),
                None => finding,
            }
            .about(context.subject(Scope::Row(*at)))
        }
        None => {
            let (field, note) = (format!("route.{}", hole.name), note("audit-opening-not-made"));
            let finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).about(hole_subject(hole));
            match rows.last() {
                Some((_, row)) => finding.at(&row.place),
                None => finding,
            }
        }
    };
    findings.push(finding.of_kind(FindingKind::Opening));
}

/// Checks that the drawing requires what a row cuts, with that diameter and depth.
fn asked_for(
    context: &Context<'_>,
    graph: &Graph<'_>,
    at: usize,
    row: &Row,
    openings: &[Opening],
    findings: &mut Vec<AuditFinding>,
) {
    let id = |quantity| Id::new(Scope::Row(at), quantity);
    let about = |finding: AuditFinding| finding.of_kind(FindingKind::Opening).about(context.subject(Scope::Row(at)));
    let field = |key: &str| format!("route.{}.{key}", row.number);
    let flat = row.operation.value == Operation::Counterbore;
    let like = |opening: &&Opening| {
        row.feature.is_none_or(|feature| feature == opening.feature)
            // Column 9 of A.7 gives its name to countersinks too.
            && (flat || !matches!(opening.feature, Feature::Counterbore | Feature::Face))
    };
    let stated = row.figures.get(&Q::Diameter);
    let away = |opening: &&Opening| {
        stated.map_or(Micrometres::ZERO, |own| (opening.diameter - Micrometres::from_mm_rounded(own.value)).abs())
    };
    let Some(opening) = openings.iter().filter(like).min_by_key(away) else {
        let note = Note::new("audit-opening-unasked").with("operation", Figure::operation(row.operation.value.name()));
        let finding = AuditFinding::new(Severity::Doubtful, Section::Route, field("operation"), note);
        findings.push(about(finding.at(&row.operation.place)));
        return;
    };
    if let Some(figure) = stated.filter(|_| graph.formula(id(Q::Diameter)).is_none())
        && Micrometres::from_mm_rounded(figure.value) != opening.diameter
    {
        let note = Note::new("audit-opening-diameter").with("feature", Figure::word(opening.feature.name()));
        let finding = AuditFinding::new(Severity::Wrong, Section::Route, field("diameter"), note);
        findings.push(about(with_right_value(finding, figure, opening.diameter, Q::Diameter)));
        right_by_drawing(context, graph, at, opening.diameter, findings);
    }
    if let (Some(figure), Some(depth)) = (row.figures.get(&Q::Depth), opening.depth)
        && graph.formula(id(Q::Depth)).is_none()
        // The depth of a cone is computed: half of the last printed place is rounding.
        && (figure.value - depth.to_mm()).abs() > figure.last_place / 2.0 + 1e-6
    {
        let note = Note::new("audit-opening-depth").with("feature", Figure::word(opening.feature.name()));
        let finding = AuditFinding::new(Severity::Wrong, Section::Route, field("depth"), note);
        findings.push(about(with_right_value(finding, figure, depth, Q::Depth)));
    }
}

/// Conditions that state the diameter of the drawing are right although the row states another, and so is every figure
/// of them that was computed from it.
pub(super) fn right_by_drawing(
    context: &Context<'_>,
    graph: &Graph<'_>,
    row: usize,
    right: Micrometres,
    findings: &mut Vec<AuditFinding>,
) {
    let other = Some((Id::new(Scope::Row(row), Q::Diameter), right.to_mm()));
    for (at, conditions) in context.stated.conditions.iter().enumerate() {
        if conditions.rows.first() != Some(&row) {
            continue;
        }
        for quantity in conditions.figures.keys() {
            let id = Id::new(Scope::Conditions(at), *quantity);
            if graph.fits_if(id, other) == Some(true)
                && let Some(formula) = graph.formula(id)
            {
                roots::retract(findings, &context.field(id), formula.rule);
            }
        }
    }
}
