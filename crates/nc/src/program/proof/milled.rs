//! Checks the circles of a mill, and motions across inside the part.

use super::compare::CutAtStop;
use super::cuts::{Circle, TOLERANCE, same_position};
use super::walk::{TipMotion, TipMove};
use super::{Code, Name, ProgramFinding};
use crate::motion::{Sense, geometry};
use crate::note::Severity;
use crate::units::Micrometres;

/// A transition without circles: a motion across at feed makes a slot.
pub(super) fn check_no_circles(say: &CutAtStop<'_, '_>, findings: &mut Vec<ProgramFinding>) {
    let across = say.cut.moves.iter().find(|made| made.feed().is_some() && made.across());
    if let Some(made) = across {
        findings.push(
            say.finding(Code::Slot, Severity::Error).with(Name::To, [made.to[0], made.to[1]]).with(Name::Z, made.to[2]),
        );
    }
}

/// Checks the circles of a cycle in their order, and the paths between them.
pub(super) fn circles(
    say: &CutAtStop<'_, '_>,
    levels: &[Micrometres],
    radii: &[Micrometres],
    sense: Sense,
    findings: &mut Vec<ProgramFinding>,
) {
    let made = say.cut.circles();
    let planned: Vec<(Micrometres, Micrometres)> =
        levels.iter().flat_map(|level| radii.iter().map(|radius| (*level, *radius))).collect();
    let widest = radii.iter().max().copied().unwrap_or_default();
    for (index, (level, radius)) in planned.iter().enumerate() {
        let Some(circle) = made.get(index) else {
            let count = planned.len() - index;
            findings
                .push(say.finding(Code::CircleMissing, Severity::Error).with(Name::Count, count).with(Name::Z, *level));
            break;
        };
        check_circle(say, circle, *level, *radius, sense, findings);
    }
    if let Some(circle) = made.get(planned.len()) {
        findings.push(say.finding(Code::CircleSuperfluous, Severity::Error).with(Name::Z, circle.z));
    }
    let centre = say.cut.at.map(Micrometres::to_mm);
    let outside = |to: [Micrometres; 3]| {
        geometry::distance([to[0].to_mm(), to[1].to_mm()], centre) > (widest + TOLERANCE).to_mm()
    };
    let straight = say.cut.moves.iter().filter(|made| matches!(made.motion, TipMotion::Feed(_)));
    for made in straight.clone().filter(|made| made.across() && outside(made.to)) {
        findings.push(
            say.finding(Code::Slot, Severity::Error).with(Name::To, [made.to[0], made.to[1]]).with(Name::Z, made.to[2]),
        );
    }
    // Straight paths: out to every circle of a level, and back to the middle.
    let ways = straight.clone().filter(|made| made.across()).count();
    let needed = levels.len() * (radii.len() + 1);
    if ways != needed {
        findings.push(say.figure(Code::WaysBetweenCircles, Severity::Note, ways, needed));
    }
    if let Some(oblique) = straight.clone().find(|made| made.across() && made.from[2] != made.to[2]) {
        findings.push(say.finding(Code::Oblique, Severity::Doubtful).with(Name::Z, oblique.to[2]));
    }
    // It enters and leaves in the middle, where there is room.
    let aside = |made: &&TipMove| {
        !made.across()
            && made.moves()
            && !(same_position(made.to[0], say.cut.at[0]) && same_position(made.to[1], say.cut.at[1]))
    };
    // Down at feed it may go into the metal that the hole is milled out of: few mills drill.
    let plunges = |made: &&TipMove| matches!(made.motion, TipMotion::Feed(_)) && made.to[2] < made.from[2];
    let plunge = say.cut.moves.iter().find(|made| aside(made) && plunges(made));
    if let Some(made) = plunge.or_else(|| say.cut.moves.iter().find(aside)) {
        let severity = if plunge.is_some() { Severity::Wrong } else { Severity::Doubtful };
        findings.push(
            say.finding(Code::NotInTheMiddle, severity)
                .with(Name::To, [made.to[0], made.to[1]])
                .with(Name::Z, made.to[2]),
        );
    }
    let downs = straight.filter(|made| !made.across() && made.to[2] < made.from[2]).count();
    if downs != levels.len() {
        findings.push(say.figure(Code::WaysDown, Severity::Note, downs, levels.len()));
    }
}

fn check_circle(
    say: &CutAtStop<'_, '_>,
    circle: &Circle,
    level: Micrometres,
    radius: Micrometres,
    sense: Sense,
    findings: &mut Vec<ProgramFinding>,
) {
    let at = |code, severity| {
        let mut finding = say.finding(code, severity).with(Name::Z, circle.z);
        finding.block = Some(circle.block);
        finding
    };
    let step = TOLERANCE.to_mm();
    if !same_position(circle.z, level) {
        findings.push(at(Code::CircleLevel, Severity::Error).with(Name::Needed, level));
    }
    if circle.from_z != circle.z {
        findings.push(at(Code::Oblique, Severity::Doubtful));
    }
    if (circle.radius - radius.to_mm()).abs() > step {
        let made = crate::units::round_to(circle.radius, 3);
        findings.push(at(Code::CircleRadius, Severity::Error).with(Name::Made, made).with(Name::Needed, radius));
    }
    if !(same_position(circle.centre[0], say.cut.at[0]) && same_position(circle.centre[1], say.cut.at[1])) {
        findings.push(at(Code::CircleCentre, Severity::Error).with(Name::Made, circle.centre));
    }
    if circle.sense != sense {
        findings.push(at(Code::CircleSense, Severity::Wrong));
    }
    // A full turn, within one machine step along the arc.
    let turns = circle.turned / std::f64::consts::TAU;
    let slack = 2.0 * step / circle.radius.max(step);
    if turns < 1.0 - slack {
        findings.push(at(Code::CircleOpen, Severity::Error).with(Name::Made, crate::units::round_to(turns, 3)));
    } else if turns > 1.0 + slack {
        findings.push(at(Code::CircleAgain, Severity::Note).with(Name::Made, crate::units::round_to(turns, 3)));
    }
}
