//! Checks every motion against what stands over the face of the part: clamps and obstacles, by their outlines and heights.

use super::tools::Tools;
use super::walk::{TipMotion, TipMove};
use super::{Code, Name, ObservedCuts, ProgramFinding, ProofInput};
use crate::note::Severity;
use crate::part::{Point, Standing};
use crate::units::Micrometres;

/// A motion of a tool through a clamp or an obstacle, each told once for a block.
pub(super) fn all(made: &ObservedCuts, tools: &Tools, input: &ProofInput<'_>, findings: &mut Vec<ProgramFinding>) {
    let face = input.plan.part.datum.top;
    for stay in &made.walk.visits {
        let Some(setup) = input.job.setups.get(stay.setup).filter(|setup| !setup.standing.is_empty()) else { continue };
        let tool = tools.of_section(stay.section);
        let tool = tool.and_then(|number| input.plan.tools.iter().find(|tool| tool.number == number));
        let radius = tool.map(|tool| tool.diameter_mm.half()).unwrap_or_default();
        for motion in stay.travel.iter().chain(&stay.moves).filter(|motion| motion.moves()) {
            let low = motion.from[2].min(motion.to[2]);
            let hit = |one: &&Standing| low < face + one.height && hits(motion, one, radius);
            let Some(one) = setup.standing.iter().find(hit) else { continue };
            findings.push(
                ProgramFinding::new(Code::ThroughObstacle, Severity::Error, motion.block)
                    .with(Name::At, [one.at.x, one.at.y])
                    .with(Name::To, [motion.to[0], motion.to[1]])
                    .with(Name::Made, low)
                    .with(Name::Needed, face + one.height),
            );
        }
    }
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
