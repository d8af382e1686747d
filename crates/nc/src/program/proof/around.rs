//! Checks everything but the cuts: travel over the part, pauses, the order of the points, the ends.

use std::collections::BTreeMap;

use super::cuts::{TOLERANCE, same_position};
use super::matching::Matched;
use super::walk::{Event, PointVisit, TipMotion};
use super::{Code, Name, ObservedCuts, ProgramFinding, ProofInput, StopTask};
use crate::job::{CycleKind, Pause};
use crate::motion::{BlockRef, Turning};
use crate::note::Severity;
use crate::units::Micrometres;

/// All these checks.
pub(super) fn all(
    made: &ObservedCuts,
    matched: &Matched,
    tasks: &[StopTask<'_>],
    input: &ProofInput<'_>,
    turned_over: usize,
    findings: &mut Vec<ProgramFinding>,
) {
    let around = Around { made, matched, tasks, input };
    around.check_stops(findings);
    around.above(findings);
    around.between(findings);
    around.pauses(findings);
    around.turned_over(turned_over, findings);
    around.order(findings);
    around.ends(findings);
}

struct Around<'a, 't> {
    made: &'a ObservedCuts,
    matched: &'a Matched,
    tasks: &'a [StopTask<'t>],
    input: &'a ProofInput<'t>,
}

impl<'t> Around<'_, 't> {
    fn task(&self, cut: usize) -> Option<&StopTask<'t>> {
        self.matched.task_of.get(cut).copied().flatten().and_then(|task| self.tasks.get(task))
    }

    /// The first and last task of every stay.
    fn tasks_at(&self) -> BTreeMap<usize, (usize, usize)> {
        let mut at: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
        for (number, cut) in self.made.cuts.iter().enumerate() {
            at.entry(cut.visit).and_modify(|(_, last)| *last = number).or_insert((number, number));
        }
        at
    }

    fn at_change(&self, stay: &PointVisit) -> bool {
        let change = self.input.job.change_at;
        stay.machine == [change.x, change.y]
    }

    /// Travels from point to point: at rapid, at the height of the cycles or with the quill retracted, to a point
    /// with work, otherwise to the tool-change position.
    fn check_stops(&self, findings: &mut Vec<ProgramFinding>) {
        let cuts = self.tasks_at();
        let top = self.input.plan.part.datum.top;
        for (number, stay) in self.made.walk.visits.iter().enumerate() {
            let Some(travel) = stay.travel else { continue };
            if !cuts.contains_key(&number) && !self.at_change(stay) {
                findings.push(ProgramFinding::new(Code::IdlePoint, Severity::Note, stay.block).with(Name::At, stay.at));
            }
            if let Some(feed) = travel.feed() {
                findings.push(
                    ProgramFinding::new(Code::TravelAtFeed, Severity::Note, stay.block)
                        .with(Name::At, stay.at)
                        .with(Name::Made, feed),
                );
            }
            let low = travel.from[2].min(travel.to[2]);
            let high = travel.from[2].max(travel.to[2]);
            let up = travel.machine.z == self.input.job.change_at.z && low == high;
            if up && self.at_change(stay) && travel.turning != Turning::Stopped {
                findings.push(ProgramFinding::new(Code::TurnsToChange, Severity::Note, stay.block));
            }
            let from_change = number.checked_sub(1).and_then(|before| self.made.walk.visits.get(before));
            if self.at_change(stay) || from_change.is_some_and(|stay| self.at_change(stay)) {
                if up {
                    continue;
                }
                findings.push(
                    ProgramFinding::new(Code::TravelNotUp, Severity::Wrong, stay.block)
                        .with(Name::At, stay.at)
                        .with(Name::Z, high),
                );
            }
            let before = number.checked_sub(1).and_then(|before| cuts.get(&before)).map(|(_, last)| *last);
            let after = cuts.get(&number).map(|(first, _)| *first);
            let out = |cut: Option<usize>| self.task(cut?).map(|task| (task.cycle.out, task.tool.over_straps));
            // After and before a cut without a stop, every height above the part is accepted. Of two works that ask for one
            // height the one that goes over what the shop has decides.
            let Some((needed, of_straps)) = [out(before), out(after)].into_iter().flatten().min() else { continue };
            let say = |code, severity, made: Micrometres| {
                ProgramFinding::new(code, severity, stay.block)
                    .with(Name::At, stay.at)
                    .with(Name::Made, made)
                    .with(Name::Needed, needed)
            };
            if low < needed - TOLERANCE {
                // The plan goes high over straps that it proposes itself; a motion through one is told as that.
                let severity = if low <= top {
                    Severity::Error
                } else if of_straps {
                    Severity::Note
                } else {
                    Severity::Doubtful
                };
                findings.push(say(Code::TravelLow, severity, low));
            } else if high > needed + TOLERANCE {
                findings.push(say(Code::TravelHigh, Severity::Note, high));
            }
        }
    }

    /// Motions above a point: only to the heights of its cycle, at rapid.
    fn above(&self, findings: &mut Vec<ProgramFinding>) {
        let cuts = self.tasks_at();
        let up = self.input.job.change_at.z;
        for (stay, leads, made) in &self.made.above {
            let say = |code| ProgramFinding::new(code, Severity::Note, made.block);
            if let TipMotion::Dwell(seconds) = made.motion {
                findings.push(say(Code::DwellInAir).with(Name::Made, seconds));
                continue;
            }
            if !made.moves() {
                continue;
            }
            let cut = leads.or_else(|| cuts.get(stay).map(|(_, last)| *last));
            let work = cut.and_then(|cut| self.task(cut));
            // Motion to an unplanned cut is reported with that cut.
            let Some(task) = work else {
                if !cuts.contains_key(stay) && made.machine.z != up {
                    findings.push(say(Code::IdleHeight).with(Name::Z, made.to[2]));
                }
                continue;
            };
            if leads.is_some() && made.turning == Turning::Stopped {
                findings.push(say(Code::ApproachStanding).with(Name::Z, made.to[2]));
            }
            let cycle = task.cycle;
            let metal = self.input.plan.part.datum.top - task.transition.start_mm;
            // Between its steps a pecking tool comes back to just over what it has drilled, which may be the face itself; before the
            // first it has no business there.
            let first = cut.and_then(|cut| self.made.cuts.get(cut)?.cutting().next());
            let begun = first.is_some_and(|first| first.order < made.order);
            let pecks = begun && matches!(cycle.kind, CycleKind::Peck { .. } | CycleKind::ChipBreak { .. });
            let lowest = if pecks { metal } else { task.reached_in_air(metal) };
            if made.to[2] < cycle.begin && made.to[2] >= lowest && made.turning != Turning::Stopped {
                continue;
            }
            let known = [cycle.begin, cycle.out].iter().any(|level| same_position(*level, made.to[2]));
            let up_again = leads.is_none() && made.machine.z == up;
            if !known && !up_again {
                let mut finding = say(Code::IdleHeight).with(Name::Z, made.to[2]);
                if made.motion == TipMotion::Rapid && made.to[2] <= self.input.plan.part.datum.top + TOLERANCE {
                    finding.severity = Severity::Wrong;
                }
                findings.push(finding);
            }
            if let Some(feed) = made.feed() {
                findings.push(say(Code::AirAtFeed).with(Name::Z, made.to[2]).with(Name::Made, feed));
            }
        }
    }

    /// Between two cuts at one point the tool rises as high as between points.
    fn between(&self, findings: &mut Vec<ProgramFinding>) {
        for (next, pair) in self.made.cuts.windows(2).enumerate().map(|(at, pair)| (at + 1, pair)) {
            let Some(task) = self.task(next - 1).filter(|_| pair[0].visit == pair[1].visit) else { continue };
            let above = self.made.above.iter().filter(|(_, leads, made)| *leads == Some(next) && made.moves());
            let high = above.map(|(.., made)| made.to[2]).fold(pair[0].retracted_to, Micrometres::max);
            if high < task.cycle.out - TOLERANCE {
                findings.push(
                    ProgramFinding::new(Code::TravelLow, Severity::Note, pair[1].block)
                        .with(Name::At, pair[1].at)
                        .with(Name::Made, high)
                        .with(Name::Needed, task.cycle.out),
                );
            }
        }
    }

    /// What the operator must do before a work, and stops without a task.
    fn pauses(&self, findings: &mut Vec<ProgramFinding>) {
        let stops: Vec<(usize, BlockRef)> = self
            .made
            .walk
            .events
            .iter()
            .filter(|(.., event)| *event == Event::Stop)
            .map(|(order, block, _)| (*order, *block))
            .collect();
        let mut used = vec![false; stops.len()];
        let mut seen: BTreeMap<usize, ()> = BTreeMap::new();
        let mut last = 0;
        for (number, cut) in self.made.cuts.iter().enumerate() {
            let Some(task) = self.task(number) else { continue };
            if seen.insert(task.work, ()).is_none() && !task.tool.pauses.is_empty() {
                let between: Vec<usize> = (0..stops.len())
                    .filter(|&at| !used[at] && (last..cut.order).contains(&stops[at].0))
                    .take(task.tool.pauses.len())
                    .collect();
                for at in &between {
                    used[*at] = true;
                }
                for pause in task.tool.pauses.iter().skip(between.len()) {
                    findings.push(no_stop(pause, cut.place, between.is_empty()));
                }
            }
            last = cut.order;
        }
        for (stop, _) in stops.iter().zip(&used).filter(|(_, used)| !**used) {
            findings.push(ProgramFinding::new(Code::StopForNothing, Severity::Note, stop.1));
        }
    }

    /// The zero of the other side must change at the stop, not elsewhere.
    fn turned_over(&self, turned_over: usize, findings: &mut Vec<ProgramFinding>) {
        let first = self.made.cuts.iter().find(|cut| cut.setup > 0);
        if let Some(cut) = first
            && !self.made.walk.events.iter().any(|(order, _, event)| *order == turned_over && *event == Event::Stop)
        {
            findings.push(ProgramFinding::new(Code::NotTurnedOver, Severity::Error, cut.place));
        }
    }

    /// Reports points in another order than the plan's: allowed, but the path is another one.
    fn order(&self, findings: &mut Vec<ProgramFinding>) {
        let visited: Vec<(usize, usize)> =
            (0..self.made.cuts.len()).filter_map(|cut| Some((cut, self.matched.task_of[cut]?))).collect();
        let made: Vec<usize> = visited.iter().map(|(_, task)| *task).collect();
        let planned: Vec<usize> = (0..self.tasks.len()).filter(|task| self.matched.cut_of[*task].is_some()).collect();
        let Some(at) = (0..made.len()).find(|&at| made.get(at) != planned.get(at)) else { return };
        let Some(cut) = visited.get(at).and_then(|(cut, _)| self.made.cuts.get(*cut)) else { return };
        let Some(task) = planned.get(at).and_then(|task| self.tasks.get(*task)) else { return };
        let others = made.iter().zip(&planned).filter(|(made, planned)| made != planned).count();
        // The path length by its coordinates distinguishes two orders.
        let length: f64 = self
            .made
            .cuts
            .windows(2)
            .map(|pair| {
                let [a, b] = [pair[0].at, pair[1].at].map(|at| at.map(Micrometres::to_mm));
                libm::hypot(b[0] - a[0], b[1] - a[1])
            })
            .sum();
        findings.push(
            ProgramFinding::new(Code::OtherOrder, Severity::Note, cut.place)
                .with(Name::At, cut.at)
                .with(Name::Needed, [task.stop.at.x, task.stop.at.y])
                .with(Name::Count, others)
                .with(Name::Way, crate::units::round_to(length, 1)),
        );
    }

    /// Tool changes and the end: spindle and coolant off, the axes at the place of the change.
    fn ends(&self, findings: &mut Vec<ProgramFinding>) {
        let change = self.input.job.change_at;
        let mut ended = false;
        for (_, block, event) in &self.made.walk.events {
            match event {
                Event::Stop => {}
                Event::Radius => findings.push(ProgramFinding::new(Code::RadiusCorrection, Severity::Doubtful, *block)),
                Event::Change { at, turned, coolant, corrected } => {
                    if *at != change {
                        findings.push(
                            ProgramFinding::new(Code::ChangesElsewhere, Severity::Wrong, *block).with(Name::At, *at),
                        );
                    }
                    if *corrected {
                        findings.push(ProgramFinding::new(Code::CorrectionAtChange, Severity::Note, *block));
                    }
                    if *turned {
                        let severity = self.input.turning_at_change;
                        findings.push(ProgramFinding::new(Code::TurnsAtChange, severity, *block));
                    }
                    if *coolant {
                        findings.push(ProgramFinding::new(Code::CoolantAtChange, Severity::Note, *block));
                    }
                }
                Event::End { at, turns, coolant } => {
                    ended = true;
                    if *at != change {
                        // The next program begins with a rapid.
                        let severity = if at.z == change.z { Severity::Note } else { Severity::Wrong };
                        findings.push(ProgramFinding::new(Code::EndsElsewhere, severity, *block).with(Name::At, *at));
                    }
                    if *turns {
                        findings.push(ProgramFinding::new(Code::TurnsAtEnd, Severity::Doubtful, *block));
                    }
                    if *coolant {
                        findings.push(ProgramFinding::new(Code::CoolantAtEnd, Severity::Note, *block));
                    }
                }
            }
        }
        if !ended {
            findings.push(ProgramFinding::new(Code::NoEnd, Severity::Doubtful, None));
        }
    }
}

fn no_stop(pause: &Pause, block: BlockRef, none: bool) -> ProgramFinding {
    // One stop may serve two tasks; only its existence matters.
    let severity = if none { Severity::Error } else { Severity::Note };
    match pause {
        Pause::LoadTool { tool, place } => {
            ProgramFinding::new(Code::NoStopToLoad, severity, block).with(Name::Tool, *tool).with(Name::Place, *place)
        }
        Pause::TurnOver => ProgramFinding::new(Code::NoStopToTurnOver, severity, block),
        Pause::SetBar { diameter_mm } => {
            ProgramFinding::new(Code::NoStopToSetBar, severity, block).with(Name::Diameter, *diameter_mm)
        }
    }
}
