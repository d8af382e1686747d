//! Two figures that stand in each other's place are one slip: of one kind in two places, or of two kinds in one; with
//! their diameters whole conditions are exchanged.

use crate::error::KnowledgeError;
use crate::note::{Figure, Note, Severity, Word};

use super::super::context::Context;
use super::super::figures::follows;
use super::super::finding::{AuditFinding, FindingKind};
use super::super::graph::{Graph, Status, Verdict};
use super::super::quantity::{Id, Quantity as Q, Scope};

#[expect(clippy::ptr_arg, reason = "checks are called alike")]
pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let is_root = |one: &&Verdict| matches!(one.status, Status::Root(severity, _) if severity < Severity::Note);
    let roots: Vec<&Verdict> = graph.verdicts().iter().filter(is_root).filter(|_| !context.stated.is_own).collect();
    for (at, one) in roots.iter().enumerate() {
        let other = roots.iter().skip(at + 1).find(|other| stand_for_each_other(graph, one, other));
        if let Some(other) = other {
            tell(context, one.id, other.id, findings);
        }
    }
    Ok(())
}

/// Whether each of two figures is what the other should be.
fn stand_for_each_other(graph: &Graph<'_>, one: &Verdict, other: &Verdict) -> bool {
    if one.id.scope == other.id.scope {
        return one.id.quantity != other.id.quantity && each_fits(graph, one.id, other.id);
    }
    let alike =
        one.id.quantity == other.id.quantity && one.id.index == other.id.index && one.id.scope != other.id.scope;
    let same_kind = matches!(
        (one.id.scope, other.id.scope),
        (Scope::Tool(_), Scope::Tool(_))
            | (Scope::Conditions(_), Scope::Conditions(_))
            | (Scope::Row(_), Scope::Row(_))
    );
    let is = |one: &Verdict, other: &Verdict| {
        let stated = graph.printed(one.id).map(|figure| figure.value);
        stated.is_some_and(|stated| graph.within_tolerance(one.id, stated, other.right))
    };
    alike && same_kind && is(one, other) && is(other, one) && !graph.within_tolerance(one.id, one.right, other.right)
}

/// Whether each of two figures of one part is right with what the other states, as M and P that are exchanged are.
fn each_fits(graph: &Graph<'_>, one: Id, other: Id) -> bool {
    let stated = |id| graph.printed(id).map(|figure| figure.value);
    let Some((own, others)) = stated(one).zip(stated(other)) else { return false };
    graph.fits_if(one, Some((one, others))) == Some(true) && graph.fits_if(other, Some((other, own))) == Some(true)
}

/// The first of two exchanged figures becomes the root, the other follows from it. Conditions that have each other's
/// diameter are exchanged as a whole: everything in them follows, and the clamping that is computed with them.
fn tell(context: &Context<'_>, one: Id, other: Id, findings: &mut [AuditFinding]) {
    let (field, second) = (context.field(one), context.field(other));
    let own = |finding: &AuditFinding| finding.field == field && matches!(finding.kind, FindingKind::Formula(_));
    let Some(root) = findings.iter_mut().find(|finding| own(finding)) else { return };
    let beside = match other.scope {
        scope if scope == one.scope => {
            let other = Word { vocabulary: "quantity", id: other.quantity.key().replace('.', "-").into() };
            Note::new("audit-exchanged-figures").with("other", Figure::Word(other))
        }
        Scope::Tool(at) => {
            Note::new("audit-exchanged-tool").with("other", context.stated.tools.get(at).map_or(0, |tool| tool.number))
        }
        _ => {
            let row = match other.scope {
                Scope::Row(at) => Some(at),
                Scope::Conditions(at) => context.stated.conditions.get(at).and_then(|own| own.rows.first().copied()),
                _ => None,
            };
            let row = row.and_then(|at| context.stated.rows.get(at)).map_or(0, |row| row.number);
            Note::new("audit-exchanged").with("other", row)
        }
    };
    root.note = beside;
    root.is_slip = false;
    let whole = one.quantity == Q::Diameter && matches!(one.scope, Scope::Conditions(_));
    let part = |field: &str| field.rsplit_once('.').map_or(String::new(), |(part, _)| format!("{part}."));
    let parts = [part(&field), part(&second)];
    let clamped = context.stated.clamping.as_ref().and_then(|own| own.row.as_ref()).is_some_and(|row| {
        [one.scope, other.scope]
            .iter()
            .any(|scope| matches!(scope, Scope::Conditions(at) if context.stated.conditions_of(row.value) == Some(*at)))
    });
    let of_both = |name: &str| {
        whole && (parts.iter().any(|part| name.starts_with(part.as_str())) || clamped && name.starts_with("clamping."))
    };
    for finding in findings.iter_mut().filter(|own| own.severity < Severity::Note && own.field != field) {
        if finding.field == second || of_both(&finding.field) {
            finding.follows_from = vec![field.clone()];
            if let FindingKind::Formula(rule) = finding.kind {
                finding.kind = FindingKind::Follows(rule);
                finding.note = follows(&finding.follows_from);
            }
        }
    }
}
