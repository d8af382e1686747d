//! The program of a plan: whether the control takes it, and whether it does what the plan says.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::error::KnowledgeError;
use crate::job;
use crate::knowledge::diagnostic::Place;
use crate::motion::{Axis, Position};
use crate::note::{Note, Severity};
use crate::plan::{Plan, ToolPlan};
use crate::program::proof::{Asked, Tolerated, prove};
use crate::program::{Language, Setting, path};
use crate::sequence;
use crate::units::{Micrometres, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute};

use super::super::context::Context;
use super::super::figures::nature;
use super::super::finding::{Finding, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::{Id, Quantity as Q, Scope};

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let Some(program) = &context.stated.program else { return Ok(()) };
    let language = Language::read(&program.control, context.shop.knowledge)?;
    let file: Arc<str> = Arc::from(program.file.value.as_str());
    let mut setting = match &program.setting {
        // It was read once already, when the plan was.
        Some((name, text)) => language.setting(name, text).unwrap_or_default(),
        None => Setting::default(),
    };
    let held = as_plan(context, graph);
    let job = held.as_ref().map(|plan| job::make(plan, &context.shop)).transpose()?;
    let mut own_correctors = false;
    if let Some(job) = &job {
        for (setup, zero) in job.setups.iter().zip(&mut setting.zeros) {
            for axis in Axis::ALL {
                zero[axis.index()].get_or_insert(setup.zero.get(axis));
            }
        }
        let correctors: BTreeMap<u32, Micrometres> = job.correctors.iter().copied().collect();
        own_correctors = !setting.correctors.is_empty() && setting.correctors != correctors;
        if setting.correctors.is_empty() {
            setting.correctors = correctors;
        }
    }
    let run = context.auditor.run(program, &language, &context.shop.machine, &setting);
    for fault in run.faults.iter() {
        let place =
            Place { file: file.clone(), line: fault.span.line, column: fault.span.column, width: fault.span.width };
        let field = fault.path().map_or_else(|| "program".to_owned(), |path| format!("program.{path}"));
        findings.push(Finding::new(fault.severity, Section::Program, field, fault.note.clone()).at(&place));
    }
    let (Some(plan), Some(job)) = (held, job) else {
        let note = Note::new("audit-program-not-held");
        findings
            .push(Finding::new(Severity::Note, Section::Program, "program".to_owned(), note).at(&program.file.place));
        return Ok(());
    };
    let zero = |zero: &[Option<Micrometres>; 3]| {
        Position::of(Axis::ALL.map(|axis| zero[axis.index()].unwrap_or_default() + setting.shift.get(axis)))
    };
    let zeros: Vec<Position> = setting.zeros.iter().take(job.setups.len()).map(zero).collect();
    let tolerated = Tolerated::read(&plan.part, context.shop.knowledge)?;
    let start = setting.start;
    let asked = Asked { plan: &plan, job: &job, zeros: &zeros, start, tolerated, own_correctors };
    for said in prove(&run.steps, &asked).findings {
        // Of coolant a plan as stated says nothing.
        if said.code.starts_with("coolant-") {
            continue;
        }
        let field = said.block.map_or_else(|| "program".to_owned(), |block| format!("program.{}", path(&[], block)));
        let finding = Finding::new(said.severity, Section::Program, field, said.note);
        findings.push(match said.block {
            Some(block) => finding.at(&Place { file: file.clone(), line: block.line, column: 1, width: 1 }),
            None => finding.at(&program.file.place),
        });
    }
    Ok(())
}

/// The stated plan as one of ours, so that a program can be held against it: our own plan of the part with the tools,
/// speeds, feeds and correctors that are stated. Nothing where the routes differ.
fn as_plan(context: &Context<'_>, graph: &Graph<'_>) -> Option<Plan> {
    let stated = context.stated;
    let mut plan = Plan::clone(context.plan);
    let mut tools: Vec<ToolPlan> = Vec::new();
    for hole in &mut plan.holes {
        let rows: Vec<usize> = stated.rows_of_hole(&hole.name).map(|(at, _)| at).collect();
        let same =
            rows.iter().map(|at| stated.rows[*at].operation.value).eq(hole.transitions.iter().map(|one| one.operation));
        if !same {
            return None;
        }
        for (at, transition) in rows.into_iter().zip(&mut hole.transitions) {
            let number = stated.rows[at].tool.as_ref()?.value;
            let base = context.plan.tools.iter().find(|tool| tool.number == transition.tool.number)?;
            if !tools.iter().any(|tool| tool.number == number) {
                tools.push(tool(context, base, number));
            }
            transition.tool.number = number;
            let Some(conditions) = stated.conditions_of(at) else { continue };
            let said = &stated.conditions[conditions];
            let own = &mut transition.conditions;
            if let Some(rpm) = said.figures.get(&Q::Rpm) {
                own.spindle_rpm = RevsPerMinute(rpm.value);
            }
            if let Some(feed) = meant(context, graph, Id::new(Scope::Conditions(conditions), said.feed())) {
                own.feed_mm_per_rev = MillimetresPerRev(feed);
            }
            let minute = said.figures.get(&Q::MinuteFeed).map(|figure| figure.value);
            own.feed_mm_per_min = MillimetresPerMinute(minute.unwrap_or(own.feed_mm_per_rev.0 * own.spindle_rpm.0));
        }
    }
    tools.sort_by_key(|tool| tool.number);
    plan.tools = tools;
    let (visits, time) = sequence::sequence(&plan.part, &plan.holes, &context.shop.machine, None);
    plan.sequence = visits;
    plan.time = time;
    Some(plan)
}

/// What the author meant by a figure: a slip of the comma is no other value.
fn meant(context: &Context<'_>, graph: &Graph<'_>, id: Id) -> Option<f64> {
    let slipped = graph.verdict(id).zip(context.stated.figure(id)).is_some_and(|(verdict, figure)| {
        let comma = nature(figure.value, verdict.right) == "audit-decimal-point";
        comma && matches!(verdict.status, Status::Root(_, None))
    });
    if slipped { graph.right(id) } else { graph.stated_or_right(id) }
}

fn tool(context: &Context<'_>, base: &ToolPlan, number: u32) -> ToolPlan {
    let mut tool = ToolPlan { number, load: 1, corrector: number, ..base.clone() };
    let Some(at) = context.stated.tool_at(number) else { return tool };
    let own = &context.stated.tools[at];
    if let Some(name) = &own.designation {
        tool.designation.clone_from(&name.value);
    }
    let length = |quantity| own.figures.get(&quantity).map(|figure| Micrometres::from_mm_rounded(figure.value));
    if let Some(corrector) = own.figures.get(&Q::Corrector) {
        tool.corrector = corrector.value as u32;
    }
    tool.length_mm = length(Q::Assembly).unwrap_or(tool.length_mm);
    tool.correction_mm = length(Q::Correction).unwrap_or(tool.correction_mm);
    tool
}
