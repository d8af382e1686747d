//! The values that a plan by hand takes from tables: feeds, points and factors of the cards, rapids. The rule
//! `audit-by-table` says how far they may differ.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note};
use crate::plan::Operation;
use crate::tables::audit::{AuditByTableFor, Tabulated};
use crate::units::round_to;

use super::super::context::Context;
use super::super::figures::{shown, with_right_value};
use super::super::finding::AuditFinding;
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    // In a plan of the program every figure is compared with the new plan.
    if context.stated.is_own {
        return Ok(());
    }
    for (&id, &table) in graph.tables() {
        let Some(quantity) = kind(context, id).filter(|_| table > 0.0 && graph.formula(id).is_none()) else { continue };
        let Some(figure) = context.stated.figure(id) else { continue };
        let question = |of_table| AuditByTableFor { quantity, of_table };
        let (share, answer) = context.by_share(figure.value / table, question)?;
        let Some(rule) = answer.winner()? else { continue };
        let note =
            Note::new("audit-by-table").with("share", round_to(share, 0)).with("value", Figure::number(shown(table)));
        let finding = AuditFinding::new(rule.severity, Context::section(id), context.field(id), note)
            .about(context.subject(id.scope));
        let why = Because::answer(&answer.answer, Note::new("audit-limit"));
        let finding = finding.resting_on(rows(context, id).into_iter().chain([why]));
        findings.push(with_right_value(finding, figure, shown(table), id.quantity));
    }
    Ok(())
}

/// The quantity as the rule names it; none if the rule does not judge it.
fn kind(context: &Context<'_>, id: Id) -> Option<Tabulated> {
    match id.quantity {
        Q::Feed if operation(context, id) == Some(Operation::CentreDrill) => Some(Tabulated::SpotFeed),
        Q::Feed => Some(Tabulated::Feed),
        Q::CardFeed | Q::CardSpeed | Q::CardForce | Q::CardPower => Some(Tabulated::Card),
        Q::FactorFeed | Q::FactorSpeed | Q::FactorForce | Q::FactorPower => Some(Tabulated::Factor),
        Q::RapidTime => Some(Tabulated::Rapid),
        _ => None,
    }
}

/// The transition of the conditions.
fn operation(context: &Context<'_>, id: Id) -> Option<Operation> {
    let Scope::Conditions(at) = id.scope else { return None };
    let row = *context.stated.conditions.get(at)?.rows.first()?;
    Some(context.stated.rows.get(row)?.operation.value)
}

/// The rows behind the feed of the table.
fn rows(context: &Context<'_>, id: Id) -> Vec<Because> {
    let Scope::Conditions(at) = id.scope else { return Vec::new() };
    let first = context.stated.conditions.get(at).and_then(|conditions| conditions.rows.first().copied());
    let reference = first.filter(|_| id.quantity == Q::Feed).and_then(|row| context.same_transition(row));
    reference.map(|transition| transition.conditions.because.iter().take(1).cloned().collect()).unwrap_or_default()
}
