//! The program of a plan: whether the control accepts it, and whether it does what the plan says.
//!
//! - `stated_plan` turns the stated plan into a plan of the program, row by row;
//! - `judged` gives the severity and place of a deviation of the program from its plan;
//! - `causes` merges findings of several checks that have one cause.

mod causes;
mod judged;
mod stated_plan;

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::error::KnowledgeError;
use crate::job;
use crate::knowledge::diagnostic::Place;
use crate::motion::{Axis, Motion, MotionStep};
use crate::note::{Note, Severity};
use crate::plan::{HolePlan, Operation, Plan};
use crate::program::proof::{self, Code, ProofInput, Tolerated, prove};
use crate::program::setting::Before;
use crate::program::{Fault, Setting, is_run, path};
use crate::tables::audit::{AuditNeeds, Need};
use crate::units::Micrometres;

use super::super::auditor::SimulatedProgram;
use super::super::context::Context;
use super::super::finding::{AuditFinding, FindingKind, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::Quantity as Q;
use super::super::stated::Alone;
use causes::FindingFacts;
use stated_plan::{NotComparable, Reading, comparable_plan, unordered};

/// The travel of a quill of which nobody knows where it stands: no program goes beyond it.
const UNKNOWN_REACH: Micrometres = Micrometres::from_mm(20_000);

/// The transitions of every hole as a plan states them; none if it does not say enough.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn stated_holes(context: &Context<'_>, graph: &Graph<'_>) -> Result<Option<Vec<HolePlan>>, KnowledgeError> {
    let plan = unordered(context, graph, &Setting::default(), Reading::Stated)?;
    Ok(plan.ok().map(|plan| plan.holes))
}

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(program) = &context.stated.program else { return Ok(()) };
    let language = context.auditor.language(&program.control)?;
    let file: Arc<str> = Arc::from(program.file.value.as_str());
    let setting = match &program.setting {
        // It was read once already, together with the plan.
        Some((name, text)) => language.setting(name, text).unwrap_or_default(),
        None => Setting::default(),
    };
    let as_stated = match program.alone {
        Some(Alone { is_proven: false, .. }) => {
            Err(NotComparable { note: Note::new("audit-program-not-compared"), place: None })
        }
        _ => comparable_plan(context, graph, &setting, Reading::Stated)?,
    };
    let job = as_stated.as_ref().ok().map(|plan| job::make(plan, &context.shop)).transpose()?;
    let set = set(context, setting.clone(), as_stated.as_ref().ok().zip(job.as_ref()));
    let mut machine = context.shop.machine.clone();
    if program.alone.is_some_and(|alone| !alone.is_set) {
        machine.travel_z = UNKNOWN_REACH;
    }
    // Without a part no machine is named, and a stand-in runs the program.
    let unknown = context.stated.unsaid.is_some_and(|unsaid| unsaid.machine);
    if unknown {
        machine.can_tap = true;
    }
    let run = context.auditor.run(program, &language, &machine, &set);

    // What a program tells of offsets and dwells by itself the proof says better, by the plan.
    let compared = as_stated.is_ok();
    let faults = run.faults.iter().filter(|fault| !(compared && fault.of_program_alone));
    let caps = judged::Caps::read(context, &run.steps)?;
    // What the control remarks besides, `technolog check` says.
    let alone = context.stated.is_of_program();
    let needs = context.shop.knowledge.rows::<AuditNeeds<'_>>()?;
    let of_machine = |code: &str| needs.iter().any(|row| row.rule == code && row.needs == Need::Machine);
    let faults = faults.filter(|fault| !(unknown && of_machine(fault.code)));
    let faults = faults.filter(|fault| !alone || caps.of(fault.code, fault.severity) < Severity::Note);
    let mut seen: Vec<FindingFacts> = faults.map(|fault| of_fault(fault, &caps, &run.steps, &file)).collect();
    let missing = |NotComparable { note, place }: NotComparable| {
        let finding = AuditFinding::new(Severity::Note, Section::Program, "program".to_owned(), note);
        finding.at(place.as_ref().unwrap_or(&program.file.place))
    };
    match (as_stated, job) {
        (Ok(plan), Some(job)) if is_run(&run.faults, &run.steps) => {
            findings.retain(|finding| finding.kind != FindingKind::UnlessProven);
            judged::setting(context, graph, &plan, &setting, &mut seen);
            let deviations = proven(context, &plan, &job, &set, &run)?;
            // Where the program agrees with the corrected plan, a deviation follows from the slips of the plan.
            let slips = graph.verdicts().iter().any(|verdict| !matches!(verdict.status, Status::Fine));
            let by_right =
                if slips && !deviations.is_empty() { right(context, graph, &plan, &setting, &run)? } else { None };
            for deviation in deviations {
                let own = by_right.as_ref().is_none_or(|known| known.contains(&key(&deviation)));
                judged::deviation(context, graph, &plan, (deviation, &caps), own, &file, &mut seen)?;
            }
        }
        // Of a program without a part nobody expects it.
        (Err(_), _) if context.stated.unsaid.is_some() => {}
        (Err(why), _) => findings.push(missing(why)),
        // Nothing is known of a program that is not run: that it makes no hole follows from its mistakes.
        (Ok(plan), Some(_)) => {
            judged::setting(context, graph, &plan, &setting, &mut seen);
            let note = Note::new("audit-program-not-run");
            let finding = AuditFinding::new(Severity::Note, Section::Program, "program".to_owned(), note);
            findings.push(finding.at(&program.file.place));
        }
        (Ok(_), None) => {}
    }
    // What a control does not carry out makes no transition.
    if let Some(broken) = seen.iter().find(|facts| facts.broken).filter(|_| alone) {
        let field = broken.finding.field.clone();
        let of_route = |one: &&mut AuditFinding| one.section == Section::Route && one.severity < Severity::Note;
        for finding in findings.iter_mut().filter(of_route).filter(|one| one.follows_from.is_empty()) {
            finding.follows_from.push(field.clone());
        }
    }
    findings.extend(causes::together(seen, context.shop.knowledge)?);
    Ok(())
}

/// The operator's setting; what it leaves out is as the plan states it.
fn set(context: &Context<'_>, mut setting: Setting, plan: Option<(&Plan, &job::Job)>) -> Setting {
    // As in the proof: other programs ran before.
    setting.before = Before::OtherPrograms;
    let Some((plan, job)) = plan else { return setting };
    // A program with a zero of its own makes the part at the same place of the table.
    let shift = context.stated.program.as_ref().map(|program| program.shift).unwrap_or_default();
    let unset = context.stated.program.as_ref().and_then(|program| program.alone).is_some_and(|alone| !alone.is_set);
    for (setup, zero) in job.setups.iter().zip(&mut setting.zeros) {
        for axis in Axis::ALL {
            // Where the zeros of a program by itself lie nobody says: it is held to no travel.
            setting.assumed.zeros[axis.index()] |= unset;
            zero[axis.index()].get_or_insert(setup.zero.get(axis) + shift.get(axis));
        }
    }
    // What stands in the registers of a program by itself nobody says: what its tools need.
    if setting.correctors.is_empty() || unset {
        setting.correctors.extend(plan.tools.iter().map(|tool| (tool.corrector, holds(context, tool))));
    }
    setting
}

/// The value in the offset register of a tool: the correction, with the other sign where it is subtracted.
fn holds(context: &Context<'_>, tool: &crate::plan::ToolPlan) -> Micrometres {
    let subtracts = context.stated.tool_at(tool.number).is_some_and(|at| context.subtracts(at));
    if subtracts { -tool.correction_mm } else { tool.correction_mm }
}

/// All differences between a program and a plan.
fn proven(
    context: &Context<'_>,
    plan: &Plan,
    job: &job::Job,
    setting: &Setting,
    run: &SimulatedProgram,
) -> Result<Vec<proof::ProgramFinding>, KnowledgeError> {
    let mut zeros = setting.zeros_of(job);
    let Some(program) = &context.stated.program else { return Ok(Vec::new()) };
    for zero in &mut zeros {
        for axis in Axis::ALL {
            *zero = zero.with(axis, zero.get(axis) - program.shift.get(axis));
        }
    }
    let language = context.auditor.language(&program.control)?;
    let tap_word = language.tap_word();
    let tolerated = Tolerated::read(&plan.part, context.shop.knowledge)?;
    // Offset registers are those of the plan where it states any, otherwise those of the operator.
    let says = |quantity| context.stated.tools.iter().any(|tool| tool.figures.contains_key(&quantity));
    let own_correctors = !says(Q::Corrector) && !says(Q::Correction);
    let start = setting.start;
    let input = ProofInput {
        plan,
        job,
        zeros: &zeros,
        start,
        tolerated: &tolerated,
        tap_word: tap_word.as_deref(),
        turning_at_change: language.turning_at_change(),
        own_correctors,
    };
    let mut findings = prove(&run.steps, &input).findings;
    // A plan as stated says nothing of coolant, and holds the part by clamps of its own, not by those that we would propose. Of a program
    // alone its coolant is asked for as our own plan has it.
    let alone = program.alone.is_some();
    findings.retain(|finding| match finding.code {
        Code::CoolantMissing if alone => true,
        // A program that calls no register has its lengths set otherwise, as where tools are changed by hand.
        Code::NoCorrector | Code::NoCorrection if alone => !own_correctors,
        Code::CoolantMissing | Code::CoolantSuperfluous | Code::CoolantAtChange | Code::CoolantAtEnd => false,
        Code::ThroughObstacle | Code::HolderThroughObstacle | Code::HolderUnknown => {
            finding.severity < Severity::Doubtful
        }
        _ => true,
    });
    Ok(findings)
}

/// The key by which two deviations are distinguished, whatever the plan says.
type Key = (Code, Option<crate::motion::BlockRef>, Option<String>, Option<Operation>);

fn key(finding: &proof::ProgramFinding) -> Key {
    (finding.code, finding.block, finding.hole().map(str::to_owned), finding.operation())
}

/// The differences between the program and the corrected plan.
fn right(
    context: &Context<'_>,
    graph: &Graph<'_>,
    as_stated: &Plan,
    setting: &Setting,
    run: &SimulatedProgram,
) -> Result<Option<BTreeSet<Key>>, KnowledgeError> {
    let Ok(mut plan) = unordered(context, graph, setting, Reading::Right)? else { return Ok(None) };
    // Only figures differ, not rows and tools, so the path over the points need not be searched again.
    plan.sequence.clone_from(&as_stated.sequence);
    let job = job::make(&plan, &context.shop)?;
    let set = set(context, setting.clone(), Some((&plan, &job)));
    Ok(Some(proven(context, &plan, &job, &set, run)?.iter().map(key).collect()))
}

/// A fault that the control found, with the tool in the spindle.
fn of_fault(fault: &Fault, caps: &judged::Caps<'_>, steps: &[MotionStep], file: &Arc<str>) -> FindingFacts {
    let place = Place { file: file.clone(), line: fault.span.line, column: fault.span.column, width: fault.span.width };
    let field = fault.path().map_or_else(|| "program".to_owned(), |path| format!("program.{path}"));
    let finding =
        AuditFinding::new(caps.of(fault.code, fault.severity), Section::Program, field, fault.note.clone()).at(&place);
    let main = fault.calls.first().map_or(fault.span.line, |call| call.from.line);
    let ends = steps.iter().filter(|step| step.motion == Motion::End).map(|step| step.block.line).max();
    let mut changes = steps.iter().rev().filter_map(|step| match step.motion {
        Motion::ToolChange { tool } => Some((step.block.line, tool)),
        _ => None,
    });
    // What is written after the end of the main program belongs to no tool.
    let own = ends.is_none_or(|end| main <= end);
    let tool = changes.find(|(line, _)| own && *line <= main).map(|(_, tool)| tool);
    FindingFacts::of_fault(finding, tool, fault)
}

/// The path to a block of a program in the plan: `program.N1`.
fn field(block: Option<crate::motion::BlockRef>) -> String {
    block.map_or_else(|| "program".to_owned(), |block| format!("program.{}", path(&[], block)))
}
