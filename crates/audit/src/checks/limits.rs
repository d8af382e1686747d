//! The limits of the machine, and the offset registers.

use crate::error::KnowledgeError;
use crate::note::{self, Because, Note, Severity};
use crate::plan::Operation;
use crate::tables::machines::MachineQuantity as Bound;

use super::super::context::Context;
use super::super::figures::{shown, with_right_value};
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots;
use super::super::stated::StatedFigure;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    conditions(context, graph, findings)?;
    series(context, graph, findings)?;
    lengths(context, graph, findings)?;
    correctors(context, findings);
    magazine(context, findings)?;
    drills(context, findings)
}

/// The slips that bring a figure beyond a limit which its right value keeps.
fn slips(context: &Context<'_>, graph: &Graph<'_>, id: Id, most: f64) -> Vec<String> {
    let keeps = graph.verdict(id).is_some_and(|verdict| verdict.right <= most);
    let slips = if keeps { roots::figure_roots(graph, id) } else { Vec::new() };
    slips.into_iter().map(|slip| context.field(slip)).collect()
}

/// Checks every figure that the machine limits.
fn conditions(
    context: &Context<'_>,
    graph: &Graph<'_>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    for (at, conditions) in context.stated.conditions.iter().enumerate() {
        let elsewhere =
            conditions.rows.iter().all(|row| context.stated.rows.get(*row).is_some_and(|row| row.elsewhere));
        if elsewhere {
            continue;
        }
        let bounds = [
            (Q::MinuteFeed, machine.feed_max.0, Bound::FeedMax),
            (Q::Force, machine.thrust.0, Bound::ThrustZMax),
            (Q::Torque, machine.spindle_torque.0, Bound::SpindleTorqueMax),
            (Q::Power, machine.spindle_power.0, Bound::SpindlePower),
        ];
        for (quantity, most, bound) in bounds {
            let Some(figure) = conditions.figures.get(&quantity).filter(|figure| figure.value > most * 1.001) else {
                continue;
            };
            let note = Note::new("audit-beyond-machine")
                .with("limit", note::Figure::number(shown(most)))
                .with("quantity", note::Figure::word(bound.name()));
            let field = context.field(Id::new(Scope::Conditions(at), quantity));
            let finding = AuditFinding::new(Severity::Error, Section::Conditions, field, note);
            let mut finding = with_right_value(finding, figure, format!("<= {}", shown(most)), quantity);
            finding.follows_from = slips(context, graph, Id::new(Scope::Conditions(at), quantity), most);
            let because = Because::row(machine.row(bound)?, Note::new("audit-limit"));
            findings.push(finding.about(context.subject(Scope::Conditions(at))).resting_on([because]));
        }
    }
    Ok(())
}

/// A spindle speed that no rule computed must still be a step of the machine.
fn series(context: &Context<'_>, graph: &Graph<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    for (at, conditions) in context.stated.conditions.iter().enumerate() {
        let id = Id::new(Scope::Conditions(at), Q::Rpm);
        let Some(figure) = conditions.figures.get(&Q::Rpm).filter(|_| graph.formula(id).is_none()) else { continue };
        let Some((below, above)) = context.steps_around(figure.value) else { continue };
        let (severity, note) = match context.beyond_series(figure.value) {
            Some(beyond) => (context.of_series(Severity::Error), beyond),
            // Of a program its control says it.
            None if context.stated.is_of_program() => continue,
            None => (
                context.of_series(Severity::Wrong),
                Note::new("audit-not-in-series").with("below", below).with("above", above),
            ),
        };
        let finding = AuditFinding::new(severity, Section::Conditions, context.field(id), note).at(&figure.place);
        let because = Because::row(machine.row(Bound::SpindleSpeeds)?, Note::new("audit-series"));
        let mut finding = finding.about(context.subject(Scope::Conditions(at))).resting_on([because]);
        finding.stated = Some(figure.text.clone());
        finding.quantity = Some(Q::Rpm);
        findings.push(finding);
    }
    Ok(())
}

/// An assembly within the largest overhang of the machine.
fn lengths(context: &Context<'_>, graph: &Graph<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    let most = machine.overhang_max.to_mm();
    for (at, tool) in context.stated.tools.iter().enumerate() {
        let Some(figure) = tool.figures.get(&Q::Assembly).filter(|figure| figure.value > most) else { continue };
        let note = Note::new("audit-beyond-machine")
            .with("limit", note::Figure::number(shown(most)))
            .with("quantity", note::Figure::word(Bound::ToolOverhangMax.name()));
        let field = context.field(Id::new(Scope::Tool(at), Q::Assembly));
        let mut finding = with_right_value(
            AuditFinding::new(Severity::Error, Section::Lengths, field, note),
            figure,
            format!("<= {}", shown(most)),
            Q::Assembly,
        );
        finding.follows_from = slips(context, graph, Id::new(Scope::Tool(at), Q::Assembly), most);
        let because = Because::row(machine.row(Bound::ToolOverhangMax)?, Note::new("audit-limit"));
        findings.push(finding.about(context.subject(Scope::Tool(at))).resting_on([because]));
    }
    Ok(())
}

/// Two tools of different lengths with one offset register; a single tool whose register is not its own number; two
/// tools of which each has the register of the other's number.
fn correctors(context: &Context<'_>, findings: &mut Vec<AuditFinding>) {
    let stated = context.stated.tools.iter().enumerate();
    let own: Vec<(usize, u32, &StatedFigure)> =
        stated.filter_map(|(at, tool)| Some((at, tool.number, tool.figures.get(&Q::Corrector)?))).collect();
    let is_own = |number: u32, figure: &StatedFigure| figure.value == f64::from(number);
    for (place, (at, number, figure)) in own.iter().enumerate() {
        let others = || own.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, one)| one);
        let twin = others().find(|(_, _, other)| other.value == figure.value);
        // Of two tools the one whose number it is not has the slip, otherwise the later one.
        let theirs = |other: &&(usize, u32, &StatedFigure)| is_own(other.1, other.2) || other.0 < *at;
        let field = context.field(Id::new(Scope::Tool(*at), Q::Corrector));
        let finding = if let Some(other) = twin.filter(theirs).filter(|_| !is_own(*number, figure)) {
            let note = Note::new("audit-same-corrector").with("corrector", &figure.text);
            AuditFinding::new(Severity::Error, Section::Lengths, field, note.with("other", format!("T{}", other.1)))
        } else if let Some(other) = others().find(|(other, theirs, register)| {
            is_own(*theirs, figure) && is_own(*number, register) && other > at && theirs != number
        }) {
            let note = Note::new("audit-correctors-exchanged").with("tool", format!("T{number}"));
            let note = note.with("other", format!("T{}", other.1));
            AuditFinding::new(Severity::Doubtful, Section::Lengths, field, note)
        } else if !is_own(*number, figure) && own.len() > 2 && others().all(|(_, number, other)| is_own(*number, other))
        {
            let note =
                Note::new("audit-other-corrector").with("corrector", &figure.text).with("tool", format!("T{number}"));
            AuditFinding::new(Severity::Doubtful, Section::Lengths, field, note)
        } else {
            continue;
        };
        findings.push(finding.at(&figure.place).about(context.subject(Scope::Tool(*at))));
    }
}

/// More tools than places, or a tool at a place that the magazine lacks. A plan of the program continues the numbers
/// for tools that are loaded by hand.
fn magazine(context: &Context<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let (tools, machine) = (&context.stated.tools, &context.shop.machine);
    let places = machine.magazine;
    if places == 0 {
        return Ok(());
    }
    if tools.len() > places {
        let note = Note::new("audit-magazine").with("tools", tools.len()).with("places", places);
        let finding = AuditFinding::new(Severity::Doubtful, Section::Tools, "tools".to_owned(), note);
        findings.push(match tools.get(places) {
            Some(tool) => finding.at(&tool.place),
            None => finding,
        });
        return Ok(());
    }
    for (at, tool) in tools.iter().enumerate().filter(|(_, tool)| tool.number as usize > places) {
        let note = Note::new("audit-no-place").with("number", tool.number).with("places", places);
        let finding = AuditFinding::new(Severity::Error, Section::Tools, format!("tools.T{}", tool.number), note);
        let because = Because::row(machine.row(Bound::MagazinePlaces)?, Note::new("audit-limit"));
        findings.push(finding.at(&tool.place).about(context.subject(Scope::Tool(at))).resting_on([because]));
    }
    Ok(())
}

/// A drill larger than the machine permits, where no catalog has the drill of the row and so no other check reports
/// it.
fn drills(context: &Context<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let machine = &context.shop.machine;
    for (at, row) in context.stated.rows.iter().enumerate().filter(|(_, row)| !row.elsewhere) {
        let drills = matches!(row.operation.value, Operation::Drill | Operation::DrillOut);
        let known = context.stated.tool_of(row).is_some_and(|tool| context.cutter(tool).is_some());
        let most = machine.drill_max.to_mm();
        let Some(figure) = row.figures.get(&Q::Diameter).filter(|figure| drills && !known && figure.value > most)
        else {
            continue;
        };
        let note = Note::new("audit-beyond-machine")
            .with("limit", note::Figure::number(shown(most)))
            .with("quantity", note::Figure::word(Bound::DrillDiameterMax.name()));
        let field = context.field(Id::new(Scope::Row(at), Q::Diameter));
        let finding = AuditFinding::new(Severity::Error, Section::Route, field, note);
        let finding = with_right_value(finding, figure, format!("<= {}", shown(most)), Q::Diameter);
        let because = Because::row(machine.row(Bound::DrillDiameterMax)?, Note::new("audit-limit"));
        findings.push(finding.about(context.subject(Scope::Row(at))).resting_on([because]));
    }
    Ok(())
}
