//! Compares each cut with the cycle of its stop; reports cuts and stops without a partner.

use std::collections::BTreeMap;

use super::cuts::{Descent, TOLERANCE, same_position};
use super::matching::{Matched, TaskIndex};
use super::tools::Tools;
use super::walk::{Event, TipMotion, TipMove};
use super::{Code, DeviationFigure, Name, ObservedCuts, ProgramFinding, ProofInput, StopTask, milled, slotted};
use crate::job::{Cycle, CycleKind};
use crate::motion::Turning;
use crate::note::Severity;
use crate::part::Bottom;
use crate::plan::Operation;
use crate::units::Micrometres;

/// Speeds, feeds and times that differ by less are the same printed figure.
const FIGURE: f64 = 0.05;

/// Every cut beside its stop.
pub(super) fn all(
    made: &ObservedCuts,
    matched: &Matched,
    tools: &Tools,
    tasks: &[StopTask<'_>],
    input: &ProofInput<'_>,
    findings: &mut Vec<ProgramFinding>,
) {
    let places = TaskIndex::of(tasks);
    // The last task made at every point so far, to check the order.
    let mut furthest: BTreeMap<(usize, Micrometres, Micrometres), usize> = BTreeMap::new();
    for (number, cut) in made.cuts.iter().enumerate() {
        collisions(cut, input, findings);
        let Some(number) = matched.task_of.get(number).copied().flatten() else {
            superfluous(cut, matched, &places, tools, tasks, findings);
            continue;
        };
        let task = &tasks[number];
        let say = CutAtStop { cut, task };
        if tools.of_section(cut.section) != Some(task.tool.tool) {
            let needed = task.tool.tool;
            findings.push(
                say.finding(Code::WrongTool, Severity::Error).with(Name::Tool, cut.tool).with(Name::Needed, needed),
            );
        }
        let point = (task.setup, task.stop.at.x, task.stop.at.y);
        match furthest.get(&point) {
            Some(&before) if before > number => {
                let earlier = tasks[before].cycle.operation;
                findings.push(say.finding(Code::WrongOrder, Severity::Error).with(Name::Instead, earlier));
            }
            _ => {
                furthest.insert(point, number);
            }
        }
        levels(&say, input, findings);
        conditions(&say, input, findings);
        tap(&say, made, input, findings);
        match &task.cycle.kind {
            CycleKind::Circles { levels, radii, sense, .. } => milled::circles(&say, levels, radii, *sense, findings),
            CycleKind::Slot(slot) => slotted::slot(&say, slot, mill(&say, input), findings),
            _ => {
                milled::check_no_circles(&say, findings);
                steps(&say, input, findings);
            }
        }
        way_out(&say, input, findings);
    }
    missing(matched, tasks, findings);
}

/// Before a tap the function acts by which the spindle follows the feed, given since the tool came.
fn tap(say: &CutAtStop<'_, '_>, made: &ObservedCuts, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let Some(word) = input.tap_word.filter(|_| matches!(say.task.cycle.kind, CycleKind::Tap { .. })) else { return };
    let changes = made.walk.events.iter().filter(|(_, _, event)| matches!(event, Event::Change { .. }));
    let changed = changes.map(|(order, ..)| *order).filter(|order| *order < say.cut.order).max().unwrap_or_default();
    let acts = |(order, given): &(usize, String)| (changed..say.cut.order).contains(order) && given == word;
    if !made.walk.functions.iter().any(acts) {
        findings.push(say.finding(Code::TapNotFollowed, Severity::Wrong).with(Name::Word, word.to_owned()));
    }
}

/// A cut and its stop, for the findings about them.
pub(super) struct CutAtStop<'a, 't> {
    pub cut: &'a Descent,
    pub task: &'a StopTask<'t>,
}

impl CutAtStop<'_, '_> {
    /// A finding about the cut.
    pub fn finding(&self, code: Code, severity: Severity) -> ProgramFinding {
        ProgramFinding::new(code, severity, self.cut.block)
            .with(Name::Hole, &self.task.stop.hole)
            .with(Name::Operation, self.task.cycle.operation)
            .with(Name::At, self.cut.at)
    }

    /// A finding about a figure of it.
    pub fn figure(
        &self,
        code: Code,
        severity: Severity,
        made: impl Into<DeviationFigure>,
        needed: impl Into<DeviationFigure>,
    ) -> ProgramFinding {
        self.finding(code, severity).with(Name::Made, made).with(Name::Needed, needed)
    }
}

/// The diameter of the mill that makes a stop.
fn mill(say: &CutAtStop<'_, '_>, input: &ProofInput<'_>) -> Micrometres {
    let tool = input.plan.tools.iter().find(|tool| tool.number == say.task.tool.tool);
    tool.map_or(say.task.transition.tool.diameter_mm, |tool| tool.diameter_mm)
}

/// Motions that no tool may make inside the part: across at rapid, or down at rapid.
fn collisions(cut: &Descent, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let top = input.plan.part.datum.top;
    let across = cut.moves.iter().find(|made| made.motion == TipMotion::Rapid && made.across() && made.below(top));
    if let Some(made) = across {
        findings.push(
            ProgramFinding::new(Code::RapidAcross, Severity::Error, made.block)
                .with(Name::At, [made.to[0], made.to[1]])
                .with(Name::Z, made.from[2].min(made.to[2])),
        );
    }
    if cut.begin().is_none() {
        findings.push(
            ProgramFinding::new(Code::RapidIntoPart, Severity::Error, cut.block)
                .with(Name::At, cut.at)
                .with(Name::Z, cut.deepest()),
        );
        return;
    }
    // No rapid may go deeper than the feed has been.
    let mut deepest: Option<Micrometres> = None;
    for made in cut.moves.iter().filter(|made| made.moves()) {
        if made.motion == TipMotion::Rapid
            && !made.across()
            && deepest.is_some_and(|deepest| made.to[2] < deepest - TOLERANCE)
        {
            findings.push(
                ProgramFinding::new(Code::RapidIntoPart, Severity::Error, made.block)
                    .with(Name::At, cut.at)
                    .with(Name::Z, made.to[2]),
            );
        }
        if made.feed().is_some() {
            deepest = Some(deepest.map_or(made.to[2], |deepest| deepest.min(made.to[2])));
        }
    }
    let turning = cut.turning();
    if turning != Turning::Clockwise {
        let code = if turning == Turning::Stopped { Code::SpindleStands } else { Code::WrongTurn };
        findings.push(
            ProgramFinding::new(code, Severity::Error, cut.block).with(Name::At, cut.at).with(Name::Tool, cut.tool),
        );
    }
}

fn superfluous(
    cut: &Descent,
    matched: &Matched,
    places: &TaskIndex,
    tools: &Tools,
    tasks: &[StopTask<'_>],
    findings: &mut Vec<ProgramFinding>,
) {
    // A cut without any feed is reported as a rapid into the part.
    if cut.begin().is_none() {
        return;
    }
    let here = places.at(cut, tasks);
    let own = tools.of_section(cut.section);
    let again = here.iter().find(|&&task| own == Some(tasks[task].tool.tool) && matched.cut_of[task].is_some());
    let code = match (again, here.is_empty()) {
        (Some(_), _) => Code::CutAgain,
        (None, false) => Code::CutNotPlanned,
        (None, true) => Code::CutElsewhere,
    };
    findings.push(
        ProgramFinding::new(code, Severity::Error, cut.place)
            .with(Name::At, cut.at)
            .with(Name::Z, cut.deepest())
            .with(Name::Tool, cut.tool),
    );
}

/// One finding for the points of a transition.
fn missing(matched: &Matched, tasks: &[StopTask<'_>], findings: &mut Vec<ProgramFinding>) {
    let mut without: BTreeMap<(usize, &str, usize), Vec<&StopTask<'_>>> = BTreeMap::new();
    for (task, cut) in tasks.iter().zip(&matched.cut_of) {
        if cut.is_none() {
            without.entry((task.setup, &task.stop.hole, task.stop.transition)).or_default().push(task);
        }
    }
    for tasks in without.values() {
        let Some(task) = tasks.first() else { continue };
        let points: Vec<[Micrometres; 2]> = tasks.iter().map(|task| [task.stop.at.x, task.stop.at.y]).collect();
        findings.push(
            ProgramFinding::new(Code::NotMade, Severity::Error, None)
                .with(Name::Hole, &task.stop.hole)
                .with(Name::Operation, task.cycle.operation)
                .with(Name::Tool, task.tool.tool)
                .with(Name::Count, points.len())
                .with(Name::Points, points),
        );
    }
}

/// Where the feed begins and how deep it goes.
fn levels(say: &CutAtStop<'_, '_>, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let (cycle, transition) = (say.task.cycle, say.task.transition);
    let part = &input.plan.part;
    if let Some(begin) = say.cut.begin() {
        let metal = part.datum.top - transition.start_mm;
        // A rapid may have been lower before it.
        let rapids = say.cut.moves.iter().take_while(|made| made.feed().is_none()).filter(|made| made.moves());
        let begin = rapids.map(|made| made.to[2]).fold(begin, Micrometres::min);
        // At feed from the approach on, it met the face at feed, whatever the blocks in which it came.
        let at_feed = say.cut.fed_from.filter(|_| begin >= metal).map_or(begin, |from| from.min(cycle.begin));
        let begin = begin.max(at_feed);
        // Steps that end above the metal are in the air; the cut begins after them.
        let in_air = say.task.reached_in_air(metal) < cycle.begin && begin >= metal;
        if begin < cycle.begin - TOLERANCE && !in_air {
            let finding = if begin < metal {
                say.figure(Code::RapidIntoMetal, Severity::Error, begin, metal)
            } else {
                // A rapid that ends on the metal itself leaves nothing for an error of the zero or of the tool's length.
                let severity = if begin <= metal + TOLERANCE { Severity::Wrong } else { Severity::Doubtful };
                say.figure(Code::BeginsLower, severity, begin, cycle.begin)
            };
            findings.push(finding);
        } else if begin > cycle.begin + TOLERANCE {
            findings.push(say.figure(Code::BeginsHigher, Severity::Note, begin, cycle.begin));
        }
    }
    let deepest = say.cut.deepest();
    if same_position(deepest, cycle.end) {
        return;
    }
    // From the lower face on a hole is through, and anything deeper is overrun.
    let through = transition.depth_mm >= part.blank.thickness;
    let below = part.datum.top - part.blank.thickness;
    // A 90° spot not deeper than the radius of the hole is not wider than the hole.
    let hole = part.holes.iter().find(|hole| hole.name == say.task.stop.hole);
    let radius = hole.map(|hole| hole.diameter.nominal.half()).unwrap_or_default();
    let spot = part.datum.top - transition.start_mm - radius;
    let preparing = transition.operation == Operation::CentreDrill && deepest >= spot;
    if within_depth(say, input, deepest) {
        return;
    }
    let table = part.fixture.height.map(|height| below - height);
    let finding = if deepest > cycle.end {
        let enough = through && deepest <= cycle.end + input.tolerated.overrun + TOLERANCE;
        let (code, severity) =
            if enough { (Code::LessOverrun, Severity::Doubtful) } else { (Code::TooShallow, Severity::Error) };
        say.figure(code, severity, deepest, cycle.end)
    } else if let Some(table) = table.filter(|table| deepest < *table - TOLERANCE) {
        say.figure(Code::IntoTable, Severity::Error, deepest, table)
    } else {
        // The table is under a through hole.
        let within = through && deepest >= cycle.end - input.tolerated.overrun - TOLERANCE;
        // A reamer is let out farther, if the room under the part is known to be free.
        let reams = through && table.is_some() && transition.operation.is_reaming();
        let within = within || reams && deepest >= below - input.tolerated.reamer_overrun - TOLERANCE;
        let severity = if within || preparing { Severity::Doubtful } else { Severity::Wrong };
        say.figure(Code::Deeper, severity, deepest, cycle.end)
    };
    findings.push(finding);
}

/// Whether a blind hole is drilled right within the general tolerance of its depth, its first drill with its cylinder, or under a thread as much deeper as
/// harms nothing. A flat floor is made as it is planned.
fn within_depth(say: &CutAtStop<'_, '_>, input: &ProofInput<'_>, deepest: Micrometres) -> bool {
    let (part, transition) = (&input.plan.part, say.task.transition);
    let Some(hole) = part.holes.iter().find(|hole| hole.name == say.task.stop.hole) else { return false };
    let drills = matches!(transition.operation, Operation::Drill | Operation::DrillOut);
    if !drills || hole.through || hole.bottom == Bottom::Flat || deepest <= part.datum.top - part.blank.thickness {
        return false;
    }
    let tolerance = input.tolerated.depth_of(transition.depth_mm);
    let deeper = hole.thread.as_ref().map(|thread| thread.pitch.half()).unwrap_or_default().max(tolerance);
    // The first of two drills may end with the cylinder of the second, though its point is then short of the other's.
    let planned = input.plan.holes.iter().find(|planned| planned.name == hole.name);
    let rest = planned.and_then(|planned| planned.transitions.get(say.task.stop.transition + 1..));
    let second = rest.and_then(|rest| rest.iter().find(|next| next.operation == Operation::DrillOut));
    let first = transition.operation == Operation::Drill;
    let point = second.filter(|_| first).map(|second| transition.depth_mm - second.depth_mm).unwrap_or_default();
    (-deeper..=tolerance + point.max(Micrometres::ZERO)).contains(&(deepest - say.task.cycle.end))
}

/// Speed, feed, dwell, coolant.
fn conditions(say: &CutAtStop<'_, '_>, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let (cut, cycle) = (say.cut, say.task.cycle);
    let other = |made: f64, needed: f64| (made - needed).abs() > FIGURE;
    // Another choice is acceptable, but not far beyond the load that the tool bears.
    let load = |made: f64, needed: f64| {
        if made > needed * input.tolerated.overload { Severity::Wrong } else { Severity::Doubtful }
    };
    if let Some(made) = cut.cutting().find(|made| other(made.speed, cycle.speed_rpm.0)) {
        let severity = load(made.speed, cycle.speed_rpm.0);
        findings.push(say.figure(Code::OtherSpeed, severity, made.speed, cycle.speed_rpm.0));
    }
    // A mill that cuts on its way down has a feed of its own there.
    let plunge = match &cycle.kind {
        CycleKind::Circles { plunge_mm_per_min, .. } => *plunge_mm_per_min,
        CycleKind::Slot(slot) => slot.plunge_mm_per_min,
        _ => None,
    };
    // So has one on the arcs of a slot, where its teeth are faster at the wall than its middle.
    let along = cycle.feed_mm_per_min.0;
    let needed = |made: &TipMove| match (&cycle.kind, made.motion) {
        (CycleKind::Slot(slot), TipMotion::Round { radius, .. }) => slot.arc_feed(radius, cycle.feed_mm_per_min).0,
        _ => along,
    };
    // The feed per tooth grows when the spindle is slower, even if each figure alone is acceptable; and where the
    // spindle is proportionally faster, a faster feed does not load the tooth more.
    let per_turn = |feed: f64, speed: f64| feed / speed.max(f64::MIN_POSITIVE);
    let most_planned = plunge.map_or(cycle.feed_mm_per_min.0, |plunge| plunge.0.max(cycle.feed_mm_per_min.0));
    let planned = per_turn(most_planned, cycle.speed_rpm.0);
    let turned = cut.cutting().filter(|made| made.speed > 0.0);
    let made = turned.filter_map(|made| Some(per_turn(made.feed()?, made.speed))).fold(0.0, f64::max);
    let spots = cycle.operation == Operation::CentreDrill;
    let most = if spots { input.tolerated.spot_overload } else { input.tolerated.overload };
    let plunges = |made: &TipMove| plunge.is_some() && !made.across() && made.to[2] < made.from[2];
    if let Some(plunge) = plunge {
        let mut downs = cut.cutting().filter(|made| plunges(made)).filter_map(TipMove::feed);
        if let Some(feed) = downs.find(|feed| other(*feed, plunge.0)) {
            findings.push(say.figure(Code::OtherFeed, Severity::Doubtful, feed, plunge.0));
        }
    }
    let mut feeds = cut.cutting().filter(|made| !plunges(made)).filter_map(|made| Some((made.feed()?, needed(made))));
    if let Some((feed, needed)) = feeds.find(|(feed, needed)| other(*feed, *needed)) {
        // On an arc the load of a tooth follows the wall, whatever the feed along the slot.
        let loaded = needed < along || made > planned * most || made == 0.0;
        let beyond = feed > needed * most && loaded;
        // So slow a feed is another unit, feed per turn for one, and no choice: the tool rubs.
        let rubs = feed * input.tolerated.overlong < needed;
        let severity = if beyond || rubs { Severity::Wrong } else { Severity::Doubtful };
        findings.push(say.figure(Code::OtherFeed, severity, feed, needed));
    }
    // A tap cannot choose: the feed of a turn is the pitch of its thread.
    let off_pitch = match cycle.kind {
        CycleKind::Tap { pitch } => {
            let turned = cut.cutting().filter(|made| made.speed > 0.0);
            let mut fed = turned.filter_map(|made| Some(per_turn(made.feed()?, made.speed)));
            let near = input.tolerated.tap_near;
            fed.find(|made| (made / pitch.to_mm() - 1.0).abs() > near).map(|made| (made, pitch.to_mm()))
        }
        _ => (made > planned * most).then_some((made, planned)),
    };
    if let Some((made, planned)) = off_pitch {
        let figure = |value: f64| crate::units::round_to(value, 3);
        findings.push(say.figure(Code::FeedPerTurn, Severity::Wrong, figure(made), figure(planned)));
    }
    let needed = cycle.dwell_s.map_or(0.0, |dwell| dwell.0);
    // Dwells are written in tenths or thousandths, so there is no rounding.
    if (cut.dwell() - needed).abs() > 0.0005 {
        // One turn cuts the floor all round; a factor as large as `overlong` means another unit of time.
        let one_turn = 60.0 / cycle.speed_rpm.0;
        let severity = match cut.dwell() {
            made if made < needed && made < one_turn => Severity::Doubtful,
            made if made > (input.tolerated.overlong * needed).max(1.0) => Severity::Wrong,
            _ => Severity::Note,
        };
        findings.push(say.figure(Code::OtherDwell, severity, crate::units::round_to(cut.dwell(), 3), needed));
    }
    if cut.other_dwells() > 0.0 {
        findings.push(say.finding(Code::DwellElsewhere, Severity::Note).with(Name::Made, cut.other_dwells()));
    }
    let flows = cut.cutting().all(|made| made.coolant);
    if say.task.tool.coolant && !flows {
        findings.push(say.finding(Code::CoolantMissing, Severity::Doubtful));
    } else if !say.task.tool.coolant && cut.cutting().any(|made| made.coolant) {
        findings.push(say.finding(Code::CoolantSuperfluous, Severity::Note));
    }
}

/// The infeed, at once or in steps.
fn steps(say: &CutAtStop<'_, '_>, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let (cut, cycle) = (say.cut, say.task.cycle);
    let downs = cut.downs();
    let (step, back, leaves) = match cycle.kind {
        CycleKind::Peck { step, clearance } => (step, clearance, true),
        CycleKind::ChipBreak { step, retreat } => (step, retreat, false),
        _ => {
            if downs.len() > 1 {
                findings.push(say.finding(Code::StepsNotPlanned, Severity::Note).with(Name::Made, downs.len()));
            }
            return;
        }
    };
    let metal = input.plan.part.datum.top - say.task.transition.start_mm;
    let mut reached = cut.begin().unwrap_or(cycle.begin).min(say.task.reached_in_air(metal));
    for (index, (from, to)) in downs.iter().enumerate() {
        let taken = reached - *to;
        let last = index + 1 == downs.len();
        if taken > step + TOLERANCE {
            findings.push(say.figure(Code::StepTooLarge, Severity::Wrong, taken, step));
        } else if !last && taken < step - TOLERANCE {
            findings.push(say.figure(Code::StepSmaller, Severity::Note, taken, step));
        }
        // With a step smaller than the retract the tool returns to the beginning.
        let needed = (reached + back).min(cycle.begin);
        if index > 0 && !same_position(*from, needed) {
            findings.push(say.figure(Code::StepClearance, Severity::Note, *from - reached, needed - reached));
        }
        reached = reached.min(*to);
    }
    let returns = cut.returns(input.plan.part.datum.top);
    for (returned, (from, _)) in returns.iter().zip(downs.iter().skip(1)) {
        let needed = if leaves { cycle.begin } else { *from };
        if same_position(*returned, needed) {
            continue;
        }
        let severity = if leaves && *returned < needed { Severity::Doubtful } else { Severity::Note };
        findings.push(say.figure(Code::StepReturn, severity, *returned, needed));
    }
}

/// The retract.
fn way_out(say: &CutAtStop<'_, '_>, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let (cut, cycle) = (say.cut, say.task.cycle);
    let moves: Vec<&TipMove> = cut.way_out().iter().filter(|made| made.moves()).collect();
    let inside: Vec<&&TipMove> = moves.iter().filter(|made| made.from[2] < cycle.begin - TOLERANCE).collect();
    let at_feed = |made: &TipMove| made.feed().is_some();
    match &cycle.kind {
        CycleKind::FeedOut | CycleKind::Tap { .. } => {
            // The text has two cycles of boring: a bar whose spindle stands may leave at rapid, and only scratches (`turning_out`).
            let stands = |made: &TipMove| cycle.operation.is_boring() && made.turning == Turning::Stopped;
            if inside.iter().any(|made| !at_feed(made) && !stands(made)) {
                findings.push(say.finding(Code::OutAtRapid, Severity::Wrong));
            }
            let other = inside.iter().filter_map(|made| made.feed());
            let mut other = other.filter(|feed| (feed - cycle.feed_mm_per_min.0).abs() > FIGURE);
            if let Some(feed) = other.next() {
                findings.push(say.figure(Code::OutOtherFeed, Severity::Doubtful, feed, cycle.feed_mm_per_min.0));
            }
        }
        _ => {
            // A drill that clears its chips is drawn back at rapid, too; a mill goes on to its next depth.
            let mills = matches!(cycle.kind, CycleKind::Circles { .. } | CycleKind::Slot(_));
            let back = cut.moves.iter().filter(|made| !mills && made.moves() && made.to[2] > made.from[2]);
            if let Some(feed) = moves.iter().copied().chain(back).find_map(|made| made.feed()) {
                findings.push(say.finding(Code::OutAtFeed, Severity::Note).with(Name::Made, feed));
            }
        }
    }
    let turns = |made: &&TipMove| made.turning != Turning::Stopped;
    turning_out(say, cycle, inside.iter().any(|made| turns(made)), inside.iter().any(|made| !turns(made)), findings);
    let known = |made: &&TipMove| {
        same_position(made.to[2], cycle.begin)
            || same_position(made.to[2], cycle.out)
            || made.machine.z == input.job.change_at.z
    };
    if let Some(made) = moves.last().filter(|made| !at_feed(made) && !known(made)) {
        findings.push(say.figure(Code::OutElsewhere, Severity::Note, made.to[2], cycle.out));
    }
    if let Some(made) = moves.iter().rfind(|made| at_feed(made))
        && made.to[2] < cycle.begin - TOLERANCE
    {
        findings.push(say.figure(Code::OutTooLow, Severity::Note, made.to[2], cycle.begin));
    }
    // Above the beginning of its feed a reamer moves at rapid.
    if let Some(made) = moves.iter().find(|made| at_feed(made) && made.to[2] > cycle.begin + TOLERANCE)
        && !matches!(cycle.kind, CycleKind::Tap { .. })
    {
        findings.push(say.figure(Code::OutTooHigh, Severity::Note, made.to[2], cycle.begin));
    }
}

fn turning_out(say: &CutAtStop<'_, '_>, cycle: &Cycle, turned: bool, stood: bool, findings: &mut Vec<ProgramFinding>) {
    if cycle.kind == CycleKind::BoreStop {
        if turned {
            findings.push(say.finding(Code::OutTurning, Severity::Wrong));
        }
    } else if stood {
        findings.push(say.finding(Code::OutStanding, Severity::Doubtful));
    }
}
