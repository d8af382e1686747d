//! Checks what a mill leaves of a slot: nothing uncut in it at any level, and no cut beyond its outline.
//!
//! It does not follow the motions of the job one by one: it looks at the metal. What the mill sweeps at a level is drawn
//! together from the straight and round motions made there, and held against the outline of the slot, point by point.

use super::Name;
use super::compare::CutAtStop;
use super::cuts::{TOLERANCE, same_position};
use super::walk::{TipMotion, TipMove};
use super::{Code, ProgramFinding};
use crate::job::SlotCycle;
use crate::motion::Sense;
use crate::note::Severity;
use crate::units::Micrometres;

/// How far apart the points are that are looked at, mm; in a slot longer than this many steps, further.
const STEP: f64 = 0.5;
const STEPS: f64 = 2000.0;
/// How many machine steps a wall may lie aside: the point, the end of the slot and the step to its wall are rounded along both axes,
/// each by half a step at most: 3·√2/2 = 2.1. In a corner the step to the middle of its radius is, too: 2.9.
const ASIDE: f64 = 2.2;
const IN_CORNER: f64 = 3.0;
/// Points in a quarter of an arc.
const QUARTER: i32 = 16;

/// A slot or a pocket as its transition leaves it, mm.
struct Outline {
    /// The middles of its ends.
    ends: [[f64; 2]; 2],
    /// From one to the other.
    length: f64,
    /// The direction from the first to the second.
    along: [f64; 2],
    /// Half of its width.
    half: f64,
    /// The radius of its corners; half of its width where its ends are round.
    corner: f64,
}

impl Outline {
    /// How far a point lies from the middle line, measured as the outline lies about it: on the outline half of the width.
    fn aside(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.along;
        let (dx, dy) = (at[0] - self.ends[0][0], at[1] - self.ends[0][1]);
        let (along, aside) = (dx * x + dy * y - self.length / 2.0, dy * x - dx * y);
        // From the rectangle between the middles of the corner radii.
        let square = self.half - self.corner;
        let (beyond, beside) = (along.abs() - self.length / 2.0 - square, aside.abs() - square);
        libm::hypot(beyond.max(0.0), beside.max(0.0)) + beyond.max(beside).min(0.0) - self.corner + self.half
    }

    /// A point so far along the middle line, from the first end, and so far aside of it, to the left.
    fn at(&self, along: f64, aside: f64) -> [f64; 2] {
        let [x, y] = self.along;
        [self.ends[0][0] + x * along - y * aside, self.ends[0][1] + y * along + x * aside]
    }

    /// Points all over it, and close together on the line that is so far inside its outline.
    fn points(&self, inside: f64) -> Vec<[f64; 2]> {
        let (edge, square) = (self.half - inside, self.half - self.corner);
        let mut points = Vec::new();
        let step = ((self.length + 2.0 * square) / STEPS).max(STEP);
        let steps = |from: f64, to: f64, by: f64| {
            let count = libm::ceil((to - from).max(0.0) / by) as i32;
            (0..=count).map(move |one| if one == count { to } else { from + by * f64::from(one) })
        };
        for along in steps(-edge, self.length + edge, step) {
            points.extend(steps(-edge, edge, STEP).map(|aside| self.at(along, aside)));
        }
        points.retain(|at| self.aside(*at) <= edge);
        for along in steps(-square, self.length + square, step) {
            points.extend([edge, -edge].map(|aside| self.at(along, aside)));
        }
        for aside in steps(-square, square, STEP) {
            points.extend([-edge, self.length + edge].map(|along| self.at(along, aside)));
        }
        let rounded = self.corner - inside;
        for (end, turn) in [(-square, -1.0), (self.length + square, 1.0)] {
            for side in [-1.0, 1.0] {
                for part in 0..=QUARTER {
                    let angle = std::f64::consts::FRAC_PI_2 * f64::from(part) / f64::from(QUARTER);
                    let (along, aside) = (rounded * libm::cos(angle), square + rounded * libm::sin(angle));
                    points.push(self.at(end + turn * along, side * aside));
                }
            }
        }
        points
    }
}

/// Checks the motions of a cut in a slot that a mill of this diameter makes.
pub(super) fn slot(say: &CutAtStop<'_, '_>, slot: &SlotCycle, mill: Micrometres, findings: &mut Vec<ProgramFinding>) {
    let radius = mill.to_mm() / 2.0;
    let outline = outline(say, slot, radius);
    let slack = TOLERANCE.to_mm() * if slot.corner.is_some() { IN_CORNER } else { ASIDE };
    let fed: Vec<&TipMove> = say.cut.moves.iter().filter(|made| made.feed().is_some()).collect();
    // Whatever the tip does at feed below the face, it cuts.
    let beyond = fed.iter().flat_map(|made| traced(made).into_iter().map(move |at| (made, at)));
    let beyond = beyond.map(|(made, at)| (made, at, outline.aside(at) + radius - outline.half));
    let worst = beyond.filter(|(.., over)| *over > slack).max_by(|one, two| one.2.total_cmp(&two.2));
    if let Some((made, at, over)) = worst {
        let mut finding = say.finding(Code::SlotGouged, Severity::Error);
        finding.block = Some(made.block);
        let at = at.map(Micrometres::from_mm_rounded);
        findings.push(
            finding.with(Name::To, at).with(Name::Z, made.to[2]).with(Name::Made, crate::units::round_to(over, 3)),
        );
    }
    // A first pass that leaves a slot as wide as the mill, or that of a slot which is there: only its walls are cut.
    let inside = if slot.along_middle { 0.0 } else { outline.half - radius };
    for level in &slot.levels {
        let here = fed.iter().filter(|made| same_position(made.from[2], *level) && same_position(made.to[2], *level));
        let here: Vec<Vec<[f64; 2]>> = here.map(|made| traced(made)).collect();
        let uncut = outline.points(slack).into_iter().filter(|at| slot.along_middle || outline.aside(*at) > inside);
        let mut uncut = uncut.filter(|at| !here.iter().any(|way| passes(way, *at, radius)));
        if let Some(at) = uncut.next() {
            let at = at.map(Micrometres::from_mm_rounded);
            findings.push(say.finding(Code::SlotUncut, Severity::Error).with(Name::To, at).with(Name::Z, *level));
        }
    }
    if let Some(oblique) = fed.iter().find(|made| made.across() && made.from[2] != made.to[2]) {
        findings.push(say.finding(Code::Oblique, Severity::Doubtful).with(Name::Z, oblique.to[2]));
    }
    let round = fed.iter().find(|made| matches!(made.motion, TipMotion::Round { sense, .. } if sense != slot.sense));
    if let Some(made) = round {
        let mut finding = say.finding(Code::CircleSense, Severity::Wrong).with(Name::Z, made.to[2]);
        finding.block = Some(made.block);
        findings.push(finding);
    }
    // It goes down on the middle line: elsewhere it drills into a wall that a pass along it should cut.
    let downs = fed.iter().filter(|made| !made.across() && made.to[2] < made.from[2]);
    let mut aside = downs.filter(|made| outline.aside(place(made.to)) > slack);
    if let Some(made) = aside.next() {
        let mut finding = say.finding(Code::SlotPlungeAside, Severity::Doubtful);
        finding.block = Some(made.block);
        findings.push(finding.with(Name::To, [made.to[0], made.to[1]]).with(Name::Z, made.to[2]));
    }
}

/// The slot or pocket that the transition of a cut with a mill of this radius leaves.
fn outline(say: &CutAtStop<'_, '_>, slot: &SlotCycle, radius: f64) -> Outline {
    let at = say.task.stop.at;
    let ends = [at, slot.run.far(at)].map(|end| [end.x.to_mm(), end.y.to_mm()]);
    let half = say.task.transition.diameter_mm.to_mm() / 2.0;
    let corner = slot.corner.map_or(half, |corner| corner.to_mm() + radius);
    Outline { ends, length: slot.run.length().to_mm(), along: slot.run.direction(), half, corner }
}

fn place(tip: [Micrometres; 3]) -> [f64; 2] {
    [tip[0].to_mm(), tip[1].to_mm()]
}

/// The distance of a point from a straight line between two others.
fn from_line(at: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let square = dx * dx + dy * dy;
    let share = ((at[0] - from[0]) * dx + (at[1] - from[1]) * dy) / square;
    let share = if square > 0.0 { share.clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(at[0] - from[0] - share * dx, at[1] - from[1] - share * dy)
}

/// Points of the way of the tip, from its beginning to its end.
fn traced(made: &TipMove) -> Vec<[f64; 2]> {
    let (from, to) = (place(made.from), place(made.to));
    let TipMotion::Round { centre, radius, sense, turned, .. } = made.motion else { return vec![from, to] };
    let centre = centre.map(Micrometres::to_mm);
    let first = libm::atan2(from[1] - centre[1], from[0] - centre[0]);
    let turned = if sense == Sense::Counterclockwise { turned } else { -turned };
    let count = 4 * QUARTER;
    let angle = |step: i32| first + turned * f64::from(step) / f64::from(count);
    let on = |angle: f64| [centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle)];
    (0..=count).map(|step| on(angle(step))).collect()
}

/// Whether a way of the tip passes a point no further away than the radius of the mill. Between the points of an arc the way is
/// taken as straight, by less than the slack of the outline.
fn passes(way: &[[f64; 2]], at: [f64; 2], radius: f64) -> bool {
    way.windows(2).any(|pair| from_line(at, pair[0], pair[1]) <= radius + 1e-6)
}
