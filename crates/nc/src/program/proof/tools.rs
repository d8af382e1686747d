//! Finds the plan's tool for each tool of the program, and checks its length correction.

use std::collections::{BTreeMap, BTreeSet};

use super::cuts::Descent;
use super::matching::{TaskIndex, fits};
use super::walk::Event;
use super::{Code, Name, ObservedCuts, ProgramFinding, ProofInput, StopTask};
use crate::job::Pause;
use crate::note::Severity;
use crate::units::Micrometres;

/// The tools of a program.
#[derive(Clone, Debug, Default)]
pub(super) struct Tools {
    /// The tool of the plan that is in the spindle after each tool change; 0 is before the first.
    sections: Vec<Option<u32>>,
    pub findings: Vec<ProgramFinding>,
}

impl Tools {
    /// The tool of the plan after that tool change.
    pub fn of_section(&self, section: usize) -> Option<u32> {
        self.sections.get(section).copied().flatten()
    }
}

/// Finds the tools.
///
/// T is the plan's place in the magazine. Where the tool of that place would make none of its cuts and another tool
/// would make most of them, the program has numbers of its own, which is reported. Where a place is loaded several
/// times, the tool is the one whose work is done, and the operator must have been asked before. Of two that would do
/// the same work (one bore in two passes) it is the one whose offset register acts, then the one that is loaded, or after
/// a stop the next one.
pub(super) fn tools(made: &ObservedCuts, tasks: &[StopTask<'_>], input: &ProofInput<'_>) -> Tools {
    let mut tools = Tools::default();
    let places = TaskIndex::of(tasks);
    // For every cut, the plan's tools that would make it: the tool of the place, or one whose correction is active.
    let corrected =
        |tool: u32| input.plan.tools.iter().find(|known| known.number == tool).map(|known| known.correction_mm);
    let makes = |cut: &Descent| -> BTreeSet<u32> {
        let fitting = places.at(cut, tasks).into_iter().filter(|&task| fits(cut, &tasks[task]));
        let fitting = fitting.map(|task| tasks[task].tool).filter(|tool| {
            input.own_correctors || tool.place == cut.tool || corrected(tool.tool) == Some(cut.corrector.1)
        });
        fitting.map(|tool| tool.tool).collect()
    };
    let mut in_place: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for tool in input.job.setups.iter().flat_map(|setup| &setup.works) {
        let known = in_place.entry(tool.place).or_default();
        if !known.contains(&tool.tool) {
            known.push(tool.tool);
        }
    }
    // Scores of every T, and of every section.
    let mut by_tool: BTreeMap<u32, (usize, BTreeMap<u32, usize>)> = BTreeMap::new();
    let mut by_section: BTreeMap<usize, BTreeMap<u32, (usize, usize)>> = BTreeMap::new();
    for cut in &made.cuts {
        let (count, scores) = by_tool.entry(cut.tool).or_default();
        *count += 1;
        for tool in makes(cut) {
            *scores.entry(tool).or_default() += 1;
            let own = input.plan.tools.iter().find(|known| known.number == tool);
            let own = own.is_some_and(|own| cut.corrector == (Some(own.corrector), own.correction_mm));
            let (made, with_own) = by_section.entry(cut.section).or_default().entry(tool).or_default();
            *made += 1;
            *with_own += usize::from(own);
        }
    }
    let named = |tool: u32| in_place.get(&tool).cloned().unwrap_or_default();
    let works = |tool: u32| {
        by_tool.get(&tool).is_some_and(|(_, scores)| named(tool).iter().any(|own| scores.contains_key(own)))
    };
    let taken: BTreeSet<u32> = by_tool.keys().filter(|tool| works(**tool)).flat_map(|tool| named(*tool)).collect();
    let mut other: BTreeMap<u32, u32> = BTreeMap::new();
    for (&tool, (count, scores)) in &by_tool {
        let best = scores.iter().filter(|(plan, _)| !taken.contains(plan)).max_by_key(|(plan, score)| {
            // Among equals the first.
            (**score, std::cmp::Reverse(**plan))
        });
        // A program for the plan's magazine uses its numbers; only with own offset registers it may have others.
        if let Some((&plan, &score)) = best.filter(|_| input.own_correctors)
            && !works(tool)
            && 2 * score > *count
            && !other.values().any(|known| *known == plan)
        {
            other.insert(tool, plan);
            tools.findings.push(
                ProgramFinding::new(Code::ToolByWork, Severity::Doubtful, first(made, tool))
                    .with(Name::Tool, tool)
                    .with(Name::Plan, plan),
            );
        }
    }
    let sections = made.walk.visits.iter().map(|stay| stay.section).max().unwrap_or_default();
    let mut loaded: BTreeMap<u32, u32> = BTreeMap::new();
    let mut changed_at = 0;
    for section in 0..=sections {
        let Some(stay) = made.walk.visits.iter().find(|stay| stay.section == section) else {
            tools.sections.push(None);
            continue;
        };
        let asked_for =
            made.walk.events.iter().any(|(order, _, event)| {
                *event == Event::Stop && *order >= changed_at && *order < begin_of(made, section)
            });
        let plan = other.get(&stay.tool).copied().or_else(|| {
            let known = named(stay.tool);
            let score = |tool: &u32| by_section.get(&section).and_then(|it| it.get(tool)).copied().unwrap_or_default();
            let most = known.iter().map(score).max()?;
            let mut best = known.iter().filter(|tool| score(tool) == most);
            let now = loaded.get(&stay.tool).and_then(|now| known.iter().position(|tool| tool == now));
            let wanted = now.map(|now| now + usize::from(asked_for)).and_then(|wanted| known.get(wanted));
            wanted.filter(|tool| score(tool) == most).or_else(|| best.next()).copied()
        });
        if let Some(plan) = plan.filter(|_| !other.contains_key(&stay.tool)) {
            let before = *loaded.entry(stay.tool).or_insert_with(|| first_in(stay.tool, plan, input));
            if before != plan {
                if !asked_for {
                    tools.findings.push(
                        ProgramFinding::new(Code::NotLoaded, Severity::Error, stay.block)
                            .with(Name::Tool, plan)
                            .with(Name::Place, stay.tool),
                    );
                }
                loaded.insert(stay.tool, plan);
            }
        }
        changed_at = begin_of(made, section);
        tools.sections.push(plan);
    }
    for (section, plan) in tools.sections.clone().into_iter().enumerate() {
        if section > 0 && plan.is_none() && made.cuts.iter().any(|cut| cut.section == section) {
            let stay = made.walk.visits.iter().find(|stay| stay.section == section);
            if let Some(stay) = stay {
                tools.findings.push(
                    ProgramFinding::new(Code::ToolUnknown, Severity::Error, stay.block).with(Name::Tool, stay.tool),
                );
            }
        }
    }
    correctors(made, &mut tools, input);
    tools
}

/// The tool in a place when the program begins: the first one with work there, unless a pause loads it.
fn first_in(place: u32, first: u32, input: &ProofInput<'_>) -> u32 {
    let works = || input.job.setups.iter().flat_map(|setup| &setup.works).filter(|work| work.place == place);
    let loads = |tool: u32| {
        works()
            .flat_map(|work| &work.pauses)
            .any(|pause| matches!(pause, Pause::LoadTool { tool: it, .. } if *it == tool))
    };
    let known = works().map(|work| work.tool).find(|tool| !loads(*tool));
    // A place that is empty in the plan holds the tool that the program takes from it.
    known.unwrap_or(if loads(first) { 0 } else { first })
}

fn first(made: &ObservedCuts, tool: u32) -> Option<crate::motion::BlockRef> {
    made.walk.visits.iter().find(|stay| stay.tool == tool).map(|stay| stay.block)
}

/// The step of the tool change that begins a section.
fn begin_of(made: &ObservedCuts, section: usize) -> usize {
    let changes = made.walk.events.iter().filter(|(_, _, event)| matches!(event, Event::Change { .. }));
    section.checked_sub(1).and_then(|at| changes.map(|(order, ..)| *order).nth(at)).unwrap_or_default()
}

/// The length correction of every cut.
///
/// With the plan's offset registers the value and the number must be those of the tool. With the operator's own, the
/// register of a tool is the one that most of its cuts use, two tools may not share one, and a value other than the
/// plan's is reported.
fn correctors(made: &ObservedCuts, tools: &mut Tools, input: &ProofInput<'_>) {
    let mut used: BTreeMap<u32, BTreeMap<(Option<u32>, Micrometres), usize>> = BTreeMap::new();
    for cut in &made.cuts {
        *used.entry(cut.tool).or_default().entry(cut.corrector).or_default() += 1;
    }
    let usual: BTreeMap<u32, (Option<u32>, Micrometres)> = used
        .iter()
        .filter_map(|(tool, counts)| Some((*tool, *counts.iter().max_by_key(|(_, count)| **count)?.0)))
        .collect();
    let mut findings = Vec::new();
    let mut reported = BTreeSet::new();
    for cut in &made.cuts {
        let Some(plan) = tools.of_section(cut.section) else { continue };
        let Some(own) = input.plan.tools.iter().find(|tool| tool.number == plan) else { continue };
        let (number, value) = cut.corrector;
        let say = |code, severity| {
            ProgramFinding::new(code, severity, cut.block)
                .with(Name::Tool, cut.tool)
                .with(Name::Corrector, number.unwrap_or_default())
                .with(Name::Value, value)
                .with(Name::Needed, own.correction_mm)
                .with(Name::Own, own.corrector)
        };
        let wrong = || {
            // The owner of a value shows which number was confused with which.
            let other = match input.own_correctors {
                false => input.plan.tools.iter().find(|tool| Some(tool.corrector) == number).map(|tool| tool.number),
                true => usual.iter().find(|(_, used)| used.0 == number).map(|(tool, _)| *tool),
            };
            let finding = say(Code::WrongCorrection, Severity::Error);
            match other.filter(|other| number != Some(0) && *other != plan) {
                Some(other) => finding.with(Name::Whose, "tool".to_owned()).with(Name::Other, other),
                None => finding.with(Name::Whose, "none".to_owned()),
            }
        };
        if !input.own_correctors {
            if value != own.correction_mm {
                let none = number == Some(0) || value == Micrometres::ZERO;
                findings.push(if none { say(Code::NoCorrection, Severity::Error) } else { wrong() });
            } else if number.is_none() {
                // Of a value there is no number to be another one.
            } else if number != Some(own.corrector) && number != Some(0) && value != Micrometres::ZERO {
                findings.push(say(Code::OtherCorrector, Severity::Doubtful));
            } else if number != Some(own.corrector) {
                findings.push(say(Code::NoCorrector, Severity::Wrong));
            }
            continue;
        }
        let first = usual.get(&cut.tool).copied().unwrap_or(cut.corrector);
        // A register that holds 0 is the same as none for these motions, but not when the tool has been measured anew.
        if cut.corrector != first && (value != Micrometres::ZERO || first.1 != Micrometres::ZERO) {
            findings.push(wrong().with(Name::Needed, first.1).with(Name::Own, first.0.unwrap_or_default()));
        } else if cut.corrector != first {
            findings.push(say(Code::NoCorrector, Severity::Wrong).with(Name::Own, first.0.unwrap_or_default()));
        } else if let Some((other, _)) = usual.iter().find(|(tool, used)| {
            **tool != cut.tool && used.0 == number && number.is_some_and(|it| it > 0) && value != Micrometres::ZERO
        }) {
            findings.push(say(Code::SharedCorrector, Severity::Error).with(Name::Other, *other));
        } else if value == Micrometres::ZERO && own.correction_mm != Micrometres::ZERO {
            findings.push(say(Code::NoCorrection, Severity::Error));
        } else if number == Some(0) {
            findings.push(say(Code::NoCorrector, Severity::Wrong));
        } else if value == -own.correction_mm && value != Micrometres::ZERO {
            findings.push(say(Code::WrongSign, Severity::Error));
        } else if value != own.correction_mm && reported.insert(cut.tool) {
            findings.push(say(Code::CorrectionOtherwise, Severity::Doubtful));
        }
    }
    tools.findings.append(&mut findings);
}
