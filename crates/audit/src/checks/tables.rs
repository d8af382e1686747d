//! Values taken from tables that are doubtful beside them; wrong ones are judged with the formulas
//! (`rules/tabulated`).

use crate::error::KnowledgeError;

use super::super::context::Context;
use super::super::figures::{shown, with_right_value};
use super::super::finding::AuditFinding;
use super::super::graph::Graph;
use super::super::rules::tabulated::{is_of_speed, judged};

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
        if is_of_speed(context, id)? {
            continue;
        }
        let Some(figure) = context.stated.figure(id).filter(|_| graph.formula(id).is_none()) else { continue };
        let Some(own) = judged(context, id, figure.value, table)? else { continue };
        let finding = AuditFinding::new(own.severity, Context::section(id), context.field(id), own.note)
            .about(context.subject(id.scope))
            .resting_on(own.because);
        findings.push(with_right_value(finding, figure, shown(table), id.quantity));
    }
    Ok(())
}
