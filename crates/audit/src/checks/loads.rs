//! Forces and torques compared with the formulas of the handbook at the feed used, because the clamping depends on
//! them.

use crate::error::KnowledgeError;
use crate::knowledge::TableRow;
use crate::note::{Because, Figure, Note, Severity};
use crate::plan::Transition;
use crate::tables::audit::{AuditLoadFor, Judgement};
use crate::tables::cutting::TorqueAndThrust;
use crate::units::round_to;

use super::super::context::Context;
use super::super::figures::shown;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::roots::figure_roots;
use super::super::rules::handbook;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    // The figures of a plan of the program come from these formulas.
    if stated.is_own {
        return Ok(());
    }
    for (at, conditions) in stated.conditions.iter().enumerate() {
        let Some(row) = conditions.rows.first() else { continue };
        let id = |quantity| Id::new(Scope::Conditions(at), quantity);
        let Some(feed) = graph.right(id(conditions.feed())) else { continue };
        let Some(by) = context.reference(*row).and_then(|reference| at_feed(context, reference, feed)) else {
            continue;
        };
        let clamped = stated.clamping.as_ref().and_then(|own| own.row.as_ref()).is_some_and(|own| own.value == *row);
        let clamping = clamped.then_some((Id::new(Scope::Clamping, Q::Torque), by.torque, Section::Clamping));
        let figures = [(id(Q::Force), by.force, Section::Conditions), (id(Q::Torque), by.torque, Section::Conditions)];
        for (id, by_formula, section) in figures.into_iter().chain(clamping) {
            // In a plan by formula the rules of `handbook` judge it.
            if graph.formula(id).is_some_and(|formula| handbook::is_handbook_rule(formula.rule)) {
                continue;
            }
            let Some((figure, by_formula)) = stated.figure(id).zip(by_formula) else { continue };
            let question = |of_formula| AuditLoadFor { of_formula };
            let (share, answer) = context.by_share(figure.value / by_formula, question)?;
            let Some(rule) = answer.winner()? else { continue };
            let note = match rule.judgement {
                Judgement::Low => Note::new("audit-load-low"),
                Judgement::High => Note::new("audit-load-high"),
                Judgement::Fine => continue,
            };
            let note = note
                .with("share", round_to(share, 0))
                .with("load", Figure::number(shown(by_formula)))
                .with("feed", Figure::number(shown(feed)));
            let mut finding = AuditFinding::new(Severity::Doubtful, section, context.field(id), note).at(&figure.place);
            finding.quantity = Some(id.quantity);
            finding.stated = Some(figure.text.clone());
            // Who carried a wrong figure on computed right.
            finding.follows_from = figure_roots(graph, id).into_iter().map(|root| context.field(root)).collect();
            let finding = finding.about(context.subject(id.scope));
            findings.push(finding.resting_on([by.because.clone(), Because::row(rule.row, Note::new("audit-limit"))]));
        }
    }
    Ok(())
}

/// Loads by the formulas.
struct Loads {
    torque: Option<f64>,
    force: Option<f64>,
    because: Because,
}

/// The loads of the program's transition at another feed: powers of the feed, by the row of `torque-and-thrust`.
fn at_feed(context: &Context<'_>, reference: &Transition, feed: f64) -> Option<Loads> {
    let conditions = &reference.conditions;
    let table = context.shop.knowledge.table_of::<TorqueAndThrust<'_>>().ok()?;
    let because = conditions.because.iter().find(|why| why.table == table.id)?;
    let row = TorqueAndThrust::read(table.row(because.row?.checked_sub(1)?)?).ok()?;
    let scale = |exponent| libm::pow(feed / conditions.feed_mm_per_rev.0, exponent);
    Some(Loads {
        torque: conditions.torque_n_m.map(|torque| torque.0 * scale(row.ym)),
        force: conditions.axial_force_n.map(|force| force.0 * scale(row.yp)),
        because: because.clone(),
    })
}
