//! The cutting speed of a program's tool of which only the size is known: beside that of our plan for the same transition. What tools of
//! the catalogs are for, the formulas judge. Of any tool, a speed that makes the feed per turn wrong.

use crate::cutting;
use crate::error::KnowledgeError;
use crate::note::{Note, Severity};
use crate::plan::Operation;
use crate::tables::audit::{AuditProgramPace, AuditProgramPaceFor};
use crate::units::{RevsPerMinute, round_to};

use super::super::context::Context;
use super::super::figures::with_right_value;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::rules::tabulated::slip_of_speed;

pub(super) fn check<'a>(
    context: &Context<'a>,
    _: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    if !stated.is_of_program() {
        return Ok(());
    }
    for (at, conditions) in stated.conditions.iter().enumerate().filter(|(_, own)| !own.rounds) {
        let Some((first, row)) = conditions.rows.first().and_then(|first| Some((*first, stated.rows.get(*first)?)))
        else {
            continue;
        };
        let slip = slip_of_speed(context, at)?;
        let is_known = slip.is_none() && stated.tool_of(row).is_some_and(|tool| context.cutter(tool).is_some());
        let rpm = conditions.figures.get(&Q::Rpm).filter(|_| !is_known && row.operation.value != Operation::Tap);
        // A speed that the machine does not have says enough, and its control says it.
        let rpm = rpm.filter(|rpm| context.beyond_series(rpm.value).is_none());
        let Some((rpm, ours)) = rpm.zip(context.reference(first)) else { continue };
        let own = cutting::speed_at(RevsPerMinute(rpm.value), ours.diameter_mm).0;
        let known = ours.conditions.computed_speed_m_per_min.0.max(ours.conditions.speed_m_per_min.0);
        if known <= 0.0 {
            continue;
        }
        let (share, answer) = context.by_share(own / known, |of_ours| AuditProgramPaceFor { of_ours })?;
        let by_speed: Option<Severity> = answer.winner()?.map(|rule| rule.severity);
        let Some(severity) = by_speed.into_iter().chain(slip.map(|(severity, _)| severity)).min() else { continue };
        let id = Id::new(Scope::Conditions(at), Q::Rpm);
        let field = context.field(id);
        // One slip is told once: a speed that the machine does not have says enough.
        if findings.iter().any(|one| one.field == field && one.severity < Severity::Note) {
            continue;
        }
        let note = Note::new("audit-program-pace")
            .with("speed", round_to(own, 1))
            .with("share", round_to(share, 0))
            .with("rpm", ours.conditions.spindle_rpm.0);
        let finding = AuditFinding::new(severity, Section::Conditions, field, note);
        let finding = with_right_value(finding, rpm, ours.conditions.spindle_rpm.0, Q::Rpm);
        let why = crate::note::Because::table(
            context.shop.knowledge.table_of::<AuditProgramPace<'_>>()?,
            Note::new("audit-limit"),
        );
        let why = ours.conditions.because.iter().take(1).cloned().chain([why]);
        findings.push(finding.about(context.subject(Scope::Conditions(at))).resting_on(why));
    }
    Ok(())
}
