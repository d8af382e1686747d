//! The severity and the place of a deviation of a program from its plan.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::error::KnowledgeError;
use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Node, parse};
use crate::motion::{BlockRef, Motion, MotionStep};
use crate::note::{Note, Severity};
use crate::plan::{Operation, Plan, Transition};
use crate::program::Setting;
use crate::program::proof::{self, Code, Name};
use crate::tables::audit::{ProgramAloneCaps, ProgramTolerance, Threshold};
use crate::units::Micrometres;

use super::super::super::context::Context;
use super::super::super::finding::{AuditFinding, Section};
use super::super::super::graph::{Graph, Status};
use super::super::super::quantity::{Id, Quantity as Q, Scope};
use super::causes::{FindingFacts, SETTING, called};
use super::{field, holds};

/// Offset registers whose setting differs from the plan.
pub(super) fn setting(
    context: &Context<'_>,
    graph: &Graph<'_>,
    plan: &Plan,
    setting: &Setting,
    seen: &mut Vec<FindingFacts>,
) {
    let Some((file, text)) = context.stated.program.as_ref().and_then(|program| program.setting.as_ref()) else {
        return;
    };
    let tree = parse(file, text).0;
    for tool in &plan.tools {
        let Some(at) = context.stated.tool_at(tool.number) else { continue };
        let id = |quantity| Id::new(Scope::Tool(at), quantity);
        let says = |quantity| context.stated.figure(id(quantity)).is_some();
        let Some(set) = setting.correctors.get(&tool.corrector) else { continue };
        if !says(Q::Corrector) || !says(Q::Correction) || *set == holds(context, tool) {
            continue;
        }
        let note = Note::new(SETTING)
            .with("tool", tool.number)
            .with("corrector", tool.corrector)
            .with("value", set)
            .with("needed", holds(context, tool));
        let field = format!("program.setting.correctors.{}", tool.corrector);
        let mut finding = AuditFinding::new(Severity::Error, Section::Program, field, note);
        let node = tree.as_ref().and_then(|tree| tree.get("correctors")?.get(&tool.corrector.to_string()));
        if let Some(Node { place, .. }) = node {
            finding = finding.at(place);
        }
        finding = finding.with_values(set, holds(context, tool));
        // A correction that is wrong in the plan itself says nothing against the setting.
        let wrong = graph.verdict(id(Q::Correction)).filter(|verdict| !matches!(verdict.status, Status::Fine));
        finding.follows_from.extend(wrong.map(|verdict| context.field(verdict.id)));
        seen.push(FindingFacts::of_setting(finding, tool.number));
    }
}

/// How grave findings about a program may be: of one without a plan the table `audit-program-alone` says it.
pub(super) struct Caps<'k> {
    rows: Vec<ProgramAloneCaps<'k>>,
    /// The tool changes after the first, with the height at which they happen: where the program begins nobody knows.
    changes: Vec<(BlockRef, Micrometres)>,
    /// The first block of each cut of a tool, with the change before it.
    called: Vec<(BlockRef, u32, BlockRef)>,
    /// The one tool that works from another zero than all others.
    zero: Option<OddZero>,
}

/// A zero that one tool calls and no other.
struct OddZero {
    tool: u32,
    line: u32,
    own: String,
    usual: String,
}

impl OddZero {
    /// The one of a program, where two other tools at least call one zero: parts side by side have all their tools at each zero.
    fn of(text: &str, steps: &[MotionStep]) -> Option<Self> {
        let changes: Vec<(u32, u32)> = steps
            .iter()
            .filter_map(|step| match step.motion {
                Motion::ToolChange { tool } => Some((step.block.line, tool)),
                _ => None,
            })
            .collect();
        let mut calls: Vec<(u32, u32, String)> = Vec::new();
        for (line, text) in (1..).zip(text.lines()) {
            let Some((_, tool)) = changes.iter().rev().find(|(change, _)| *change <= line) else { continue };
            calls.extend(zeros(text).map(|zero| (*tool, line, zero)));
        }
        let names: BTreeSet<&String> = calls.iter().map(|(.., zero)| zero).collect();
        let tools = |name: &str| -> BTreeSet<u32> {
            calls.iter().filter(|(.., zero)| zero == name).map(|(tool, ..)| *tool).collect()
        };
        let [first, second] = names.into_iter().collect::<Vec<_>>().try_into().ok()?;
        let (own, usual) = if tools(first).len() == 1 { (first, second) } else { (second, first) };
        let (one, others) = (tools(own), tools(usual));
        let (tool, line, _) = calls.iter().find(|(.., zero)| zero == own)?;
        let is_odd = one.len() == 1 && others.len() > 1 && one.is_disjoint(&others);
        is_odd.then(|| Self { tool: *tool, line: *line, own: own.clone(), usual: usual.clone() })
    }
}

/// The zeros that a line calls, outside its comments.
fn zeros(line: &str) -> impl Iterator<Item = String> {
    let line = line.split(['(', ';']).next().unwrap_or_default().to_ascii_uppercase();
    let own = |word: &&str| ["54", "55", "56", "57", "58", "59"].contains(word);
    let digits = |rest: &str| rest.split(|sign: char| !sign.is_ascii_digit() && sign != '.').next().map(str::to_owned);
    let words: Vec<String> = line.split('G').skip(1).filter_map(digits).collect();
    words.into_iter().filter(move |word| own(&word.as_str())).map(|word| format!("G{word}"))
}

impl<'k> Caps<'k> {
    /// Those of a plan.
    ///
    /// # Errors
    /// The table cannot be read.
    pub fn read(context: &Context<'k>, steps: &[MotionStep]) -> Result<Self, KnowledgeError> {
        let rows = context.stated.is_of_program().then(|| context.shop.knowledge.rows());
        let (mut called, mut known, mut spindle) = (Vec::new(), BTreeSet::new(), None);
        for step in steps {
            match step.motion {
                Motion::ToolChange { tool } => spindle = Some((tool, step.block)),
                _ => called.extend(
                    spindle
                        .filter(|(tool, _)| known.insert((step.block, *tool)))
                        .map(|(tool, at)| (step.block, tool, at)),
                ),
            }
        }
        let changes = steps.iter().filter(|step| matches!(step.motion, Motion::ToolChange { .. })).skip(1);
        let changes = changes.map(|step| (step.block, step.at.z)).collect();
        let program =
            context.stated.program.as_ref().filter(|program| program.alone.is_some_and(|alone| !alone.is_set));
        let zero = program.and_then(|program| OddZero::of(&program.text, steps));
        Ok(Self { rows: rows.transpose()?.unwrap_or_default(), changes, called, zero })
    }

    /// The change that brought a tool to a block.
    fn changed(&self, block: Option<BlockRef>, tool: Option<u32>) -> Option<BlockRef> {
        let own = self.called.iter().find(|(own, with, _)| Some(*own) == block && Some(*with) == tool);
        own.map(|(_, _, change)| *change)
    }

    /// Whether a tool is changed lower than another of the same program: then the way to the place of the change is left out.
    fn is_low(&self, block: Option<BlockRef>) -> bool {
        let own = self.changes.iter().find(|(own, _)| Some(*own) == block).map(|(_, height)| *height);
        own.is_some_and(|own| self.changes.iter().any(|(_, other)| *other > own))
    }

    /// Whether all others are at one place, two of them at least: then the program has its way to the place of the change and lacks it
    /// once.
    fn is_left_out(&self, block: Option<BlockRef>) -> bool {
        let others: Vec<_> =
            self.changes.iter().filter(|(own, _)| Some(*own) != block).map(|(_, height)| *height).collect();
        self.is_low(block) && others.len() > 1 && others.windows(2).all(|two| two.first() == two.last())
    }

    /// The severity of a finding: the gravest stand first in their order.
    pub fn of(&self, code: &str, severity: Severity) -> Severity {
        self.of_share(code, severity, None)
    }

    /// The same of a figure that is so many times ours.
    fn of_share(&self, code: &str, severity: Severity, times: Option<f64>) -> Severity {
        let cap = self.rows.iter().find(|row| row.finding == code);
        let holds = |row: &&ProgramAloneCaps<'_>| row.up_to.zip(times).is_none_or(|(most, times)| times <= most);
        cap.filter(holds).map_or(severity, |row| severity.max(row.severity))
    }
}

/// How far a blind hole is cut deeper than the drawing asks.
enum Deeper {
    /// It is not, or by no more than room for chips and the lead of a reamer.
    No,
    /// By more than room for chips.
    Far,
    /// Out of the part.
    Out,
}

fn deeper(context: &Context<'_>, deviation: &proof::ProgramFinding) -> Deeper {
    let (part, far) = (&context.stated.part, context.auditor.threshold(Threshold::FarDeeper));
    let hole = deviation.hole().and_then(|name| part.holes.iter().find(|hole| hole.name == name));
    let Some((hole, made)) = hole.filter(|hole| !hole.through).zip(deviation.length(Name::Made)) else {
        return Deeper::No;
    };
    match deviation.length(Name::Needed) {
        Some(needed) if deviation.code == Code::Deeper => {
            if made <= part.datum.top - part.blank.thickness {
                Deeper::Out
            } else if (needed - made).to_mm() > far * hole.diameter.nominal.to_mm() {
                Deeper::Far
            } else {
                Deeper::No
            }
        }
        _ => Deeper::No,
    }
}

/// A deviation of the program as a finding; `None` within the tolerance of rounding.
///
/// # Errors
/// The table `audit-program-tolerance` cannot be read.
pub(super) fn deviation(
    context: &Context<'_>,
    graph: &Graph<'_>,
    plan: &Plan,
    (deviation, caps): (proof::ProgramFinding, &Caps<'_>),
    own: bool,
    file: &Arc<str>,
    seen: &mut Vec<FindingFacts>,
) -> Result<(), KnowledgeError> {
    let row = row(context, deviation.hole(), deviation.operation());
    let of_row = row.and_then(|row| Some(context.stated.rows.get(row)?.tool.as_ref()?.value));
    let tool = deviation.tool().or(of_row);
    let mut severity = deviation.severity;
    let quantity = match deviation.code {
        Code::OtherSpeed => Some(Q::Rpm),
        Code::OtherFeed | Code::OutOtherFeed => Some(Q::MinuteFeed),
        _ => None,
    };
    if let Some((quantity, made)) = quantity.zip(deviation.number(Name::Made)) {
        let planned = transition(plan, deviation.hole(), deviation.operation()).map(|transition| match quantity {
            Q::Rpm => transition.conditions.spindle_rpm.0,
            _ => transition.conditions.feed_mm_per_min.0,
        });
        let of_quantity = |row: &ProgramTolerance<'_>| row.quantity == quantity;
        let may = context.shop.knowledge.need(quantity.key(), of_quantity)?;
        let planned = planned.or(deviation.number(Name::Needed)).unwrap_or(made);
        if (made - planned).abs() < may.whole + may.relative.0 / 100.0 * planned {
            return Ok(());
        }
        severity = severity.min(may.severity);
    }
    if context.stated.is_of_program() {
        severity = match deeper(context, &deviation) {
            Deeper::Out => Severity::Error,
            Deeper::Far => severity,
            Deeper::No => {
                let made = deviation.length(Name::Made).zip(deviation.length(Name::Needed));
                let times = made.map(|(made, needed)| made.to_mm() / needed.to_mm());
                match deviation.code {
                    Code::ChangesElsewhere if caps.is_left_out(deviation.block) => Severity::Wrong,
                    Code::ChangesElsewhere if caps.is_low(deviation.block) => Severity::Doubtful,
                    code => caps.of_share(code.name(), severity, times),
                }
            }
        };
        // Notes compare heights and ways with ours, and others are as good.
        if severity == Severity::Note {
            return Ok(());
        }
    }
    // A wrong tool is called where it is changed.
    let changed = || caps.changed(deviation.block, deviation.tool());
    let block = if deviation.code == Code::WrongTool { changed().or(deviation.block) } else { deviation.block };
    let mut place = block.map(|block| Place { file: file.clone(), line: block.line, column: 1, width: 1 });
    let mut name = field(block);
    let mut beside = None;
    if deviation.code == Code::OtherCorrector {
        let at = tool.and_then(|tool| context.stated.tool_at(tool));
        let figure = at.and_then(|at| context.stated.tools.get(at)?.figures.get(&Q::Corrector));
        // A plan that gives no number leaves it to the operator.
        let Some((figure, tool)) = figure.zip(tool) else { return Ok(()) };
        severity = Severity::Error;
        name = format!("tools.T{tool}.corrector");
        place = Some(figure.place.clone());
        beside = deviation.count(Name::Corrector).map(|right| (figure.text.clone(), right.to_string()));
    }
    let follows_from = if own { Vec::new() } else { slips(context, graph, row, tool) };
    let mut finding = AuditFinding::new(severity, Section::Program, name, deviation.note.clone());
    if block != deviation.block {
        finding.note = called(&deviation.figures, "program-tool-called");
    }
    // What is not made is told where another zero is called.
    let zero = caps.zero.as_ref().filter(|zero| deviation.code == Code::NotMade && Some(zero.tool) == tool);
    if let Some(OddZero { tool, line, own, usual }) = zero {
        place = Some(Place { file: file.clone(), line: *line, column: 1, width: 1 });
        finding.note = Note::new("audit-program-other-zero")
            .with("tool", *tool)
            .with("own", own.clone())
            .with("usual", usual.clone());
    }
    // Where the zero lies nobody said, so that no position of the machine is known.
    let unset = context.stated.program.as_ref().and_then(|program| program.alone).is_some_and(|alone| !alone.is_set);
    if deviation.code == Code::ChangesElsewhere && unset {
        finding.note = Note::new("audit-program-change-low");
    }
    if let Some((stated, right)) = beside {
        finding = finding.with_values(stated, right);
    }
    let place = place.or_else(|| context.stated.program.as_ref().map(|program| program.file.place.clone()));
    if let Some(place) = &place {
        finding = finding.at(place);
    }
    finding.follows_from = follows_from;
    seen.push(FindingFacts::of_deviation(finding, tool, deviation));
    Ok(())
}

/// The row of the plan that a deviation concerns.
fn row(context: &Context<'_>, hole: Option<&str>, operation: Option<Operation>) -> Option<usize> {
    let (hole, operation) = hole.zip(operation)?;
    let mut rows = context.stated.rows_of_hole(hole);
    rows.find(|(_, row)| row.operation.value == operation).map(|(at, _)| at)
}

fn transition<'p>(plan: &'p Plan, hole: Option<&str>, operation: Option<Operation>) -> Option<&'p Transition> {
    let (hole, operation) = hole.zip(operation)?;
    let hole = plan.holes.iter().find(|plan| plan.name == hole)?;
    hole.transitions.iter().find(|one| one.operation == operation)
}

/// The slips of the plan that a row or a tool has.
fn slips(context: &Context<'_>, graph: &Graph<'_>, row: Option<usize>, tool: Option<u32>) -> Vec<String> {
    let conditions = row.and_then(|row| context.stated.conditions_of(row));
    let tool = tool.and_then(|tool| context.stated.tool_at(tool));
    let about = |scope: Scope| match scope {
        Scope::Row(at) => row == Some(at),
        Scope::Conditions(at) => conditions == Some(at),
        Scope::Tool(at) => tool == Some(at),
        _ => false,
    };
    let mut fields: Vec<String> = Vec::new();
    for verdict in graph.verdicts().iter().filter(|verdict| about(verdict.id.scope)) {
        match &verdict.status {
            Status::Fine => {}
            Status::Root(..) => fields.push(context.field(verdict.id)),
            Status::Follows(roots) => fields.extend(roots.iter().map(|root| context.field(*root))),
        }
    }
    fields.sort();
    fields.dedup();
    fields
}
