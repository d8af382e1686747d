//! Makes the job of a plan.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::KnowledgeError;
use crate::motion::Position;
use crate::note::{Finding, Severity};
use crate::part::{Face, Point};
use crate::plan::{Plan, ToolPlan, ToolVisit, Transition};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

use super::clearance::{beside, change_over_part, go_over, straps, ways_over_clamps};
use super::collisions;
use super::cycle::{Feeding, cycle};
use super::envelope::envelopes;
use super::on_table;
use super::part_position::{PartPosition, across, reach_of_quill, stand};
use super::{Job, Pause, SetUp, Stop, ToolWork, Unfinished, frame};

/// The job of a plan, in the shop it was planned for.
///
/// # Errors
/// The knowledge base has no answer.
pub fn make(plan: &Plan, shop: &Shop<'_>) -> Result<Job, KnowledgeError> {
    let part = &plan.part;
    let machine = &shop.machine;
    let (mut findings, mut asked, mut met) = (Vec::new(), Vec::new(), Vec::new());
    let envelopes = envelopes(plan, shop)?;
    let mut setups = Vec::new();
    let (mut frames, mut bars) = (0, Bars::of(plan, shop.convention(HoleDefault::SettingStep)?));
    // The tool in each place; the first loading is done before the program begins.
    let mut magazine: BTreeMap<u32, u32> = plan
        .tools
        .iter()
        .filter(|tool| tool.load == 1)
        .map(|tool| (place(tool, machine.magazine), tool.number))
        .collect();
    for (number, face) in [(1, Face::Entry), (2, Face::Back)] {
        let mut works = Vec::new();
        let first = frames;
        frames += plan.zeros_of(number).len().max(1);
        for (index, visit) in plan.sequence.iter().enumerate().filter(|(_, visit)| visit.setup == number) {
            let Some(tool) = plan.tools.iter().find(|tool| tool.number == visit.tool) else { continue };
            let mut pauses = Vec::new();
            if works.is_empty() && !setups.is_empty() {
                pauses.push(Pause::TurnOver);
            }
            let place = place(tool, machine.magazine);
            if magazine.insert(place, tool.number) != Some(tool.number) {
                pauses.push(Pause::LoadTool { tool: tool.number, place });
            }
            let stops = plan.by_zero(visit).into_iter().enumerate().filter(|(_, stops)| !stops.is_empty());
            for (zero, stops) in stops {
                let visit = ToolVisit { stops: stops.into_iter().cloned().collect(), ..visit.clone() };
                let pauses = std::mem::take(&mut pauses);
                let own = (index, &visit, frame(first + zero));
                works.extend(rounds(own, tool, place, (pauses, &mut bars), plan, shop)?);
            }
        }
        if works.is_empty() {
            frames = first;
            continue;
        }
        let mut standing = part.standing(number, shop.convention(HoleDefault::ClampInset)?);
        standing.extend(straps(plan, number));
        let zero = across(part, &works, machine);
        let home = Point { x: machine.tool_change_at.0 - zero.x, y: machine.tool_change_at.1 - zero.y };
        go_over(&mut works, &standing, home, plan, shop, &mut findings)?;
        let PartPosition { zero, supports, nose } = stand(part, plan, &works, &standing, shop, &mut findings)?;
        let frames: Vec<u8> = (first..frames).map(frame).collect();
        let setup = SetUp { number, face, frames, zero, supports, nose, works, standing };
        change_over_part(&setup, part, machine.tool_change_at, &mut findings);
        asked.extend(ways_over_clamps(&setup, plan, machine.tool_change_at, shop)?);
        beside(&setup, plan, shop, &mut findings)?;
        reach_of_quill(&setup, plan, shop, &mut findings);
        on_table::faults(&setup, plan, machine, &mut findings);
        met.extend(collisions::with_given(&setup, plan, &envelopes));
        setups.push(setup);
    }
    let (x, y) = machine.tool_change_at;
    let hinders = findings.iter().filter(|finding: &&Finding| finding.severity <= Severity::Doubtful).cloned();
    let doubted =
        asked.iter().map(|own: &Finding| Finding { severity: own.severity.max(Severity::Doubtful), ..own.clone() });
    // A program says these itself, with their blocks.
    let of_plan = hinders.chain(doubted).chain(met).collect();
    findings.extend(asked);
    Ok(Job {
        part: part.part.clone(),
        machine: part.machine.clone(),
        change_at: Position { x, y, z: machine.tool_change_z },
        setups,
        correctors: plan.tools.iter().map(|tool| (tool.corrector, tool.correction_mm)).collect(),
        unfinished: Unfinished::of(plan),
        envelopes,
        findings,
        of_plan,
    })
}

/// What the bars of boring tools are set to, by tool.
struct Bars {
    /// All settings of each over the whole job: a bar with one is set before the program begins.
    all: BTreeMap<u32, BTreeSet<Micrometres>>,
    /// What each is set to now.
    now: BTreeMap<u32, Micrometres>,
}

impl Bars {
    fn of(plan: &Plan, step: Micrometres) -> Self {
        let mut all: BTreeMap<u32, BTreeSet<Micrometres>> = BTreeMap::new();
        for visit in &plan.sequence {
            let transitions = visit.stops.iter().filter_map(|stop| transition_of(plan, &stop.hole, stop.transition));
            let settings =
                transitions.flat_map(|one| (1..=one.passes.max(1)).filter_map(|pass| setting(one, pass, step)));
            all.entry(visit.tool).or_default().extend(settings);
        }
        Self { all, now: BTreeMap::new() }
    }

    /// Sets the bar of a tool; whether the program has to stop for it.
    fn set(&mut self, tool: u32, diameter: Micrometres) -> bool {
        let before = self.now.insert(tool, diameter);
        before != Some(diameter) && self.all.get(&tool).is_some_and(|all| all.len() > 1)
    }
}

/// The place of a tool in its loading of the magazine, from 1.
fn place(tool: &ToolPlan, places: usize) -> u32 {
    let places = u32::try_from(places).unwrap_or(u32::MAX);
    (tool.number.max(1) - 1) % places + 1
}

/// A visit from one zero as one work, or as several where the bar of a boring tool is set by hand between its passes.
fn rounds(
    (number, visit, frame): (usize, &ToolVisit, u8),
    tool: &ToolPlan,
    place: u32,
    (pauses, bars): (Vec<Pause>, &mut Bars),
    plan: &Plan,
    shop: &Shop<'_>,
) -> Result<Vec<ToolWork>, KnowledgeError> {
    // The work at one setting of the bar; every other tool has one setting.
    let mut settings: BTreeMap<Option<Micrometres>, Vec<(usize, u32)>> = BTreeMap::new();
    let step = shop.convention(HoleDefault::SettingStep)?;
    for (index, stop) in visit.stops.iter().enumerate() {
        let Some(transition) = transition_of(plan, &stop.hole, stop.transition) else { continue };
        for pass in 1..=transition.passes.max(1) {
            settings.entry(setting(transition, pass, step)).or_default().push((index, pass));
        }
    }
    let mut pauses = pauses;
    let mut works = Vec::new();
    for (setting, stops) in settings {
        if let Some(diameter_mm) = setting.filter(|diameter| bars.set(tool.number, *diameter)) {
            pauses.push(Pause::SetBar { diameter_mm });
        }
        let first = stops.first().and_then(|(index, _)| visit.stops.get(*index));
        let first = first.and_then(|stop| transition_of(plan, &stop.hole, stop.transition));
        let Some(operation) = first.map(|transition| transition.operation) else { continue };
        let also = first.and_then(|transition| transition.also_diameter_mm);
        let mut work = ToolWork {
            visit: number,
            frame,
            tool: tool.number,
            place,
            corrector: tool.corrector,
            designation: tool.designation.clone(),
            operation,
            diameter_mm: tool.diameter_mm,
            also_diameter_mm: also,
            ground_from_mm: tool.ground_from_mm,
            pauses: std::mem::take(&mut pauses),
            bar_mm: setting,
            coolant: false,
            because: Vec::new(),
            cycles: Vec::new(),
            over_straps: false,
            stops: Vec::new(),
        };
        // Cycles by group and transition, so that each is computed once.
        let mut known: BTreeMap<(&str, usize), usize> = BTreeMap::new();
        for (index, pass) in stops {
            let stop = &visit.stops[index];
            let Some(transition) = transition_of(plan, &stop.hole, stop.transition) else { continue };
            let cycle = match known.get(&(stop.hole.as_str(), stop.transition)) {
                Some(&known) => known,
                None => {
                    let hole = plan.part.holes.iter().find(|hole| hole.name == stop.hole);
                    let pitch = hole.and_then(|hole| hole.thread_at(transition.step)).map(|thread| thread.pitch);
                    let slot = hole.and_then(|hole| hole.slot_to(transition.diameter_mm));
                    let feeding = Feeding { slot, ..Feeding::of(transition, pitch) };
                    let made = cycle(&feeding, plan.part.datum.top, shop)?;
                    let cooled = match transition.conditions.coolant {
                        Some(needed) => needed,
                        None => {
                            let (cooled, reason) = shop.coolant(transition.operation)?;
                            if !work.because.contains(&reason) {
                                work.because.push(reason);
                            }
                            cooled
                        }
                    };
                    work.coolant |= cooled;
                    let at = work.cycles.iter().position(|known| known.same_motions(&made)).unwrap_or_else(|| {
                        work.cycles.push(made);
                        work.cycles.len() - 1
                    });
                    known.insert((&stop.hole, stop.transition), at);
                    at
                }
            };
            let at = if visit.setup == 2 { plan.part.turned_over(stop.at) } else { stop.at };
            work.stops.push(Stop { cycle, hole: stop.hole.clone(), transition: stop.transition, pass, at });
        }
        works.push(work);
    }
    Ok(works)
}

fn transition_of<'p>(plan: &'p Plan, hole: &str, transition: usize) -> Option<&'p Transition> {
    plan.holes.iter().find(|plan| plan.name == hole)?.transitions.get(transition)
}

/// The setting of a boring bar for a pass: the stock is removed in passes that are equal within the step of setting.
fn setting(transition: &Transition, pass: u32, step: Micrometres) -> Option<Micrometres> {
    let stock = transition.diameter_mm - transition.from_diameter_mm;
    let passes = transition.passes.max(1);
    let exact = transition.from_diameter_mm + stock.ratio(i64::from(pass), i64::from(passes));
    let diameter = if pass < passes { exact.on_grid(step) } else { transition.diameter_mm };
    transition.operation.is_boring().then_some(diameter)
}
