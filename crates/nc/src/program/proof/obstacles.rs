//! Checks every motion against what stands over the face of the part: clamps and obstacles, by their outlines and heights;
//! with the cutter, its holder and the nose of the spindle.

use super::cuts::same_position;
use super::finding::DeviationFigure;
use super::tools::Tools;
use super::walk::{PointVisit, TipMotion, TipMove};
use super::{Code, Name, ObservedCuts, ProgramFinding, ProofInput};
use crate::job::{Body, BodyKind, Envelope};
use crate::note::Severity;
use crate::part::{Point, Standing};
use crate::units::Micrometres;

/// A motion of a tool through a clamp or an obstacle, or of its holder into one or into the part, each told once for a
/// block.
pub(super) fn all(made: &ObservedCuts, tools: &Tools, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let face = input.plan.part.datum.top;
    let (mut unknown, mut low_holders) = (Vec::new(), Vec::new());
    for stay in &made.walk.visits {
        let Some(setup) = input.job.setups.get(stay.setup) else { continue };
        let number = tools.of_section(stay.section);
        let tool = number.and_then(|number| input.plan.tools.iter().find(|tool| tool.number == number));
        let radius = tool.map(|tool| tool.diameter_mm.half()).unwrap_or_default();
        let envelope = number.and_then(|number| input.job.envelopes.iter().find(|one| one.tool == number));
        for motion in stay.travel.iter().chain(&stay.moves).filter(|motion| motion.moves()) {
            let low = motion.from[2].min(motion.to[2]);
            let hit = |one: &&Standing| low < face + one.height && hits(motion, one, radius);
            if let Some(one) = setup.standing.iter().find(hit) {
                // Whoever wrote the program may clamp otherwise than the plan proposes.
                let severity = if one.proposed { Severity::Doubtful } else { Severity::Error };
                findings.push(
                    ProgramFinding::new(Code::ThroughObstacle, severity, motion.block)
                        .with(Name::At, [one.at.x, one.at.y])
                        .with(Name::To, [motion.to[0], motion.to[1]])
                        .with(Name::Made, low)
                        .with(Name::Needed, face + one.height),
                );
                continue;
            }
            if let Some(envelope) = envelope {
                let found = holder(envelope, motion, stay, &setup.standing, input);
                let of_unknown = found.as_ref().is_some_and(|found| found.code == Code::HolderUnknown);
                if of_unknown { &mut unknown } else { &mut low_holders }.extend(found);
            }
        }
    }
    findings.extend(one_for_each_holder(unknown));
    findings.extend(deepest(low_holders));
}

/// Of the motions of one holder into the part, or into one clamp, the deepest, with how many others there are.
fn deepest(found: Vec<ProgramFinding>) -> impl Iterator<Item = ProgramFinding> {
    let mut groups: Vec<(ProgramFinding, usize)> = Vec::new();
    let made = |finding: &ProgramFinding| finding.length(Name::Made);
    for finding in found {
        let same = |(other, _): &&mut (ProgramFinding, usize)| {
            let alike = |name| other.figures.get(&name) == finding.figures.get(&name);
            let place = finding.code == Code::HolderIntoPart || alike(Name::At);
            other.code == finding.code && alike(Name::Tool) && alike(Name::Whose) && place
        };
        match groups.iter_mut().find(same) {
            Some((worst, others)) => {
                *others += 1;
                if made(&finding) < made(worst) {
                    *worst = finding;
                }
            }
            None => groups.push((finding, 0)),
        }
    }
    groups.into_iter().map(|(worst, others)| if others > 0 { worst.with(Name::More, others) } else { worst })
}

/// One finding for each holder of unknown thickness, which is one cause: the worst of its own, with all its tools and all that it
/// would meet.
fn one_for_each_holder(found: Vec<ProgramFinding>) -> impl Iterator<Item = ProgramFinding> {
    let mut of_holders: Vec<Vec<ProgramFinding>> = Vec::new();
    for finding in found {
        let same = |other: &ProgramFinding| {
            let alike = |name| other.figures.get(&name) == finding.figures.get(&name);
            other.severity == finding.severity && alike(Name::Own) && alike(Name::Diameter)
        };
        match of_holders.iter_mut().find(|known| known.first().is_some_and(same)) {
            Some(known) => known.push(finding),
            None => of_holders.push(vec![finding]),
        }
    }
    of_holders.into_iter().filter_map(|all| {
        let (mut tools, mut points) = (Vec::new(), Vec::new());
        for finding in &all {
            tools.extend(finding.tool().filter(|tool| !tools.contains(tool)));
            if let Some(DeviationFigure::Point(at)) = finding.figures.get(&Name::At)
                && !points.contains(at)
            {
                points.push(*at);
            }
        }
        let length = |finding: &ProgramFinding, name| match finding.figures.get(&name) {
            Some(DeviationFigure::Length(length)) => *length,
            _ => Micrometres::ZERO,
        };
        let most = |name| all.iter().map(|finding| length(finding, name)).max().unwrap_or_default();
        let (aside, lower) = (most(Name::Aside), most(Name::Lower));
        // The first of those that leave the least room.
        let worst = all.iter().min_by_key(|finding| length(finding, Name::Free))?.clone();
        let tools: Vec<String> = tools.iter().map(|tool| format!("T{tool}")).collect();
        let worst = worst.with(Name::Tools, tools.join(", ")).with(Name::Points, points);
        Some(worst.with(Name::Aside, aside).with(Name::Lower, lower))
    })
}

/// The holder, its collar or the nose of the spindle in a clamp, in an obstacle or in the part.
fn holder(
    envelope: &Envelope,
    motion: &TipMove,
    stay: &PointVisit,
    standing: &[Standing],
    input: &ProofInput<'_>,
) -> Option<ProgramFinding> {
    let face = input.plan.part.datum.top;
    let low = motion.from[2].min(motion.to[2]);
    let by_thickness = |body: &Body| if body.known { Severity::Error } else { Severity::Wrong };
    let say = |code, severity, body: &Body, at: [Micrometres; 2], needed: Micrometres| {
        ProgramFinding::new(code, severity, motion.block)
            .with(Name::Tool, envelope.tool)
            .with(Name::Whose, body.kind.name().to_owned())
            .with(Name::Own, envelope.holder.clone())
            .with(Name::Diameter, body.diameter)
            .with(Name::At, at)
            .with(Name::Made, low + body.from)
            .with(Name::Needed, needed)
    };
    for body in &envelope.bodies {
        let hit = |one: &&Standing| low + body.from < face + one.height && hits(motion, one, body.diameter.half());
        if let Some(one) = standing.iter().find(hit) {
            let code = if body.known { Code::HolderThroughObstacle } else { Code::HolderUnknown };
            // A strap that the plan proposes may be chosen lower than its catalog has it.
            let severity = if one.proposed { Severity::Doubtful } else { by_thickness(body) };
            let found = say(code, severity, body, [one.at.x, one.at.y], face + one.height);
            if body.known {
                return Some(found);
            }
            // What a setter can do: measure the holder, or move the clamp by as much as is missing.
            let free = free(motion, one, body.diameter.half());
            return Some(
                found
                    .with(Name::Free, free + free)
                    .with(Name::Aside, body.diameter.half() - free)
                    .with(Name::Lower, face + one.height - (low + body.from)),
            );
        }
    }
    // An opening wider than the holder lets it in.
    let body = envelope.bodies.iter().find(|body| body.kind == BodyKind::Holder && low + body.from < face)?;
    (widest(stay, input) <= body.diameter).then(|| say(Code::HolderIntoPart, by_thickness(body), body, stay.at, face))
}

/// The widest that the hole at a point is made by the plan.
fn widest(stay: &PointVisit, input: &ProofInput<'_>) -> Micrometres {
    let setup = input.job.setups.get(stay.setup);
    let stops = setup.into_iter().flat_map(|setup| &setup.works).flat_map(|work| &work.stops);
    let here = stops.filter(|stop| same_position(stop.at.x, stay.at[0]) && same_position(stop.at.y, stay.at[1]));
    let holes = here.filter_map(|stop| input.plan.holes.iter().find(|hole| hole.name == stop.hole));
    holes.flat_map(|hole| &hole.transitions).map(|made| made.diameter_mm).max().unwrap_or_default()
}

/// The largest radius, no larger than a given one that meets it, with which a motion passes beside what stands there, mm.
fn free(motion: &TipMove, one: &Standing, meets: Micrometres) -> Micrometres {
    let (mut passes, mut meets) = (0, meets.micrometres());
    while meets - passes > 1 {
        let middle = (passes + meets) / 2;
        let hit = hits(motion, one, Micrometres::new(middle));
        *(if hit { &mut meets } else { &mut passes }) = middle;
    }
    // Of a way over the clamp itself nothing passes.
    Micrometres::new(passes)
}

fn hits(motion: &TipMove, one: &Standing, radius: Micrometres) -> bool {
    let [from, to] = [motion.from, motion.to].map(|tip| Point { x: tip[0], y: tip[1] });
    match motion.motion {
        TipMotion::Rapid => one.outline.is_hit_by_rapid(from, to, radius),
        // The whole circle, whatever part of it the arc is.
        TipMotion::Round { centre, radius: own, .. } => {
            let centre = Point { x: centre[0], y: centre[1] };
            one.outline.is_hit(centre, centre, Micrometres::from_mm_rounded(own) + radius)
        }
        _ => one.outline.is_hit(from, to, radius),
    }
}
