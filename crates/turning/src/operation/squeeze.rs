//! Whether a hollow part bears its jaws: its wall must not give way, and a bore that is finished between them must stay round.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::tables::lathes::WorkholdingFigure;
use crate::turning::contour::{Contour, SurfaceName};
use crate::turning::cutting::{PartSection, PressedRing};
use crate::turning::jobs::Job;
use crate::turning::length::Half;
use crate::turning::tooling::figure;
use crate::turning::zones::SetUp;
use crate::units::{ItGrade, Micrometres, Newtons};
use technolog_core::part::tolerance_width;

use super::grip::{Grip, finishes_bore, thousands};
use super::held::stretches;
use super::jaws::Jaws;
use super::tools::Bench;

/// A hollow part between its jaws.
#[derive(Clone, Debug)]
pub(super) struct Squeeze {
    ring: PressedRing,
    /// The thinnest wall under the jaws.
    wall: Half,
    /// The tightest surface of the bore that this set-up finishes there, with its tolerance.
    tightest: Option<(SurfaceName, Micrometres)>,
    /// Whether the jaws grip all around already.
    full: bool,
}

impl Squeeze {
    /// A part in its jaws as the set-up leaves it; none where it is solid under them.
    ///
    /// # Errors
    /// The knowledge base lacks a table or a row.
    pub fn of(set_up: &SetUp, jaws: Option<&Jaws>, bench: &Bench<'_, '_>) -> Result<Option<Self>, KnowledgeError> {
        let Some(jaws) = jaws.filter(|jaws| jaws.length_mm > Half::ZERO) else { return Ok(None) };
        let workpiece = bench.workpiece;
        let in_set_up = |contour: Contour| {
            if set_up.turned_over { contour.turned_over(workpiece.length()) } else { contour }
        };
        let raw = workpiece.blank.inner.clone().map(in_set_up);
        // In a second set-up all of the bore is made in the end; before, only what the first one makes.
        let made = match (&workpiece.inner, &set_up.inner) {
            (Some(inner), _) if set_up.turned_over => Some(in_set_up(inner.contour())),
            (_, Some(inner)) => Some(inner.main.contour.clone()),
            _ => None,
        };
        let (front, back) = (jaws.front_mm, jaws.front_mm + jaws.length_mm);
        let radius = Half::radius_of(jaws.grips_mm);
        let bore = |from: Half, to: Half| {
            let of = [&raw, &made].into_iter().flatten().flat_map(|inner| stretches(inner, from, to));
            of.map(|(.., radii)| radii.1).max().unwrap_or(Half::ZERO)
        };
        let hollow = bore(front, back);
        if hollow <= Half::ZERO || hollow >= radius {
            return Ok(None);
        }
        let spread = Half::from(PressedRing::spread_mm(radius.to_mm(), hollow.to_mm()));
        let (from, to) = (front - spread, back + spread);
        let outside = if set_up.turned_over { workpiece.outer.contour() } else { workpiece.blank.outer.clone() };
        let outside = in_set_up(outside);
        // Each step of the bore is a ring of its own.
        let mut cuts: Vec<Half> =
            [&raw, &made].into_iter().flatten().flat_map(|inner| &inner.pieces).map(|piece| piece.from.z).collect();
        cuts.extend([from, front, back, to]);
        cuts.sort();
        let ends = cuts.windows(2).filter(|ends| ends[0] < ends[1]);
        let within: Vec<_> = ends.flat_map(|ends| stretches(&outside, ends[0].max(from), ends[1].min(to))).collect();
        let wall = radius - hollow;
        let keeps = figure(WorkholdingFigure::WallKeepsShape, bench.knowledge)? * wall.to_mm();
        let mut sections = Vec::new();
        let mut stiffer = 1.0_f64;
        for (near, far, (radius_there, _)) in within {
            let inside = bore(near, far);
            if radius_there <= inside {
                continue;
            }
            let beside = far <= front || near >= back;
            // What is thick beside the jaws does not share their force, but keeps the shape of the wall.
            if beside && (radius_there - inside).to_mm() >= keeps {
                let distance = if far <= front { back - far } else { near - front };
                let [radius, hollow, distance] = [radius, hollow, distance].map(Half::to_mm);
                stiffer = stiffer.max(PressedRing::stiffened(radius, hollow, distance));
                continue;
            }
            let inside = if beside { inside.max(radius_there - wall) } else { inside };
            sections.push(PartSection { from: near, to: far, radius: radius_there, bore: inside });
        }
        let contact = contact(jaws, bench.knowledge)?;
        let ring = PressedRing::of(&sections, contact, stiffer, &bench.material, bench.knowledge)?;
        let Some(ring) = ring else { return Ok(None) };
        let tightest = tightest(set_up, (from, to), bench)?;
        Ok(Some(Self { ring, wall, tightest, full: jaws.full }))
    }

    /// The largest force of all jaws that its wall bears.
    pub fn bears(&self) -> Option<Newtons> {
        self.ring.bears()
    }

    /// What the jaws are loosened to before the bore is finished, and tightened to after that; none where it comes out round without, or
    /// not even so.
    pub fn loosened(&self, grip: &Grip, jobs: &[Job]) -> Option<(Newtons, Option<Newtons>)> {
        let allowed = self.ring.allowed_mm(self.tightest.as_ref()?.1);
        let bore = finishes_bore(jobs)?;
        let after = jobs.get(bore.end..).and_then(|jobs| hardest(grip, jobs));
        let bored = jobs.get(bore)?;
        let force = hardest(grip, bored)?;
        let lobes = |set: Newtons| self.ring.lobes_mm(grip.turning(set, bored));
        // What follows is cut as the bore is, where that leaves it round: nothing is tightened on a finished bore without need.
        let both = after.filter(|after| after.0 > force.0 && lobes(*after) <= allowed);
        let force = both.unwrap_or(force);
        let loosens = lobes(force) <= allowed && lobes(grip.required_n) > allowed;
        loosens.then_some((force, after.filter(|after| after.0 > force.0)))
    }

    /// What is told of it: a wall that gives way, and a bore that comes out of round.
    pub fn findings(&self, grip: &Grip, jobs: &[Job], set_up: u8) -> Vec<Finding> {
        let mut findings = Vec::new();
        let note = |code: &'static str| {
            let note = Note::new(code).with("number", set_up).with("grips", grip.grips_mm);
            note.with("wall", self.wall)
        };
        if let Some(bears) = self.bears().filter(|bears| grip.required_n.0 > bears.0) {
            let code = if self.full { "jaws-crush-full" } else { "jaws-crush" };
            let note = note(code).with("force", thousands(grip.required_n)).with("bears", thousands(bears));
            findings.push(Finding::of_part(Severity::Wrong, note));
        }
        let Some((surface, tolerance)) = &self.tightest else { return findings };
        let allowed = self.ring.allowed_mm(*tolerance);
        let bored = finishes_bore(jobs).and_then(|bore| jobs.get(bore)).unwrap_or_default();
        // Jaws that nothing is known of for finishing stay as they are.
        let own = || hardest(grip, bored).unwrap_or(grip.required_n);
        let force = grip.loosened.map_or_else(own, |(force, _)| force);
        let [tight, loosened] = [grip.required_n, force].map(|set| self.ring.lobes_mm(grip.turning(set, bored)));
        let told = |code: &'static str, lobes: f64, force: Newtons| {
            note(code)
                .with("surface", surface)
                .with("lobes", Micrometres::from_mm_rounded(lobes))
                .with("tolerance", *tolerance)
                .with("allowed", Micrometres::from_mm_rounded(allowed))
                .with("force", thousands(force))
        };
        if loosened > allowed {
            // A bore whose lobes alone fill the tolerance of its diameter is not made.
            let severity = if 2.0 * loosened > tolerance.to_mm() { Severity::Wrong } else { Severity::Doubtful };
            findings.push(Finding::of_part(severity, told("jaws-make-lobes", loosened, force)));
        } else if tight > allowed {
            findings.push(Finding::of_part(
                Severity::Doubtful,
                told("jaws-loosen", tight, grip.required_n).with("loosened", thousands(force)),
            ));
        }
        findings
    }
}

/// What the jaws must press with for the heaviest of some jobs.
fn hardest(grip: &Grip, jobs: &[Job]) -> Option<Newtons> {
    jobs.iter().filter_map(|job| grip.required_by(job)).max_by(|one, other| one.0.total_cmp(&other.0))
}

/// Half of the angle over which a jaw touches, degrees: hard jaws with their edges only, soft ones over their width, full-grip ones
/// nearly all around.
fn contact(jaws: &Jaws, knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    let full = figure(WorkholdingFigure::FullGripArc, knowledge)? / 2.0;
    Ok(match jaws.body {
        _ if jaws.full => full,
        Some(body) if jaws.soft => {
            let width = figure(WorkholdingFigure::JawWidthShare, knowledge)? * body.chuck_mm.to_mm();
            libm::asin((width / jaws.grips_mm.to_mm()).min(1.0)).to_degrees().min(full)
        }
        _ => 0.0,
    })
}

/// The tightest cylinder of the bore that a set-up finishes between two places, with the tolerance of its diameter; where the
/// drawing gives none, a general one.
fn tightest(
    set_up: &SetUp,
    (from, to): (Half, Half),
    bench: &Bench<'_, '_>,
) -> Result<Option<(SurfaceName, Micrometres)>, KnowledgeError> {
    let Some(inner) = &set_up.inner else { return Ok(None) };
    let unsaid = ItGrade::new(figure(WorkholdingFigure::UnsaidGrade, bench.knowledge)? as u8);
    let mut tightest: Option<(SurfaceName, Micrometres)> = None;
    for surface in &inner.profile.surfaces {
        let ground = bench.elsewhere.iter().any(|one| one.surface == surface.name);
        let there = |z: Half| z > from && z < to;
        let cylinders = || surface.pieces.iter().filter(|piece| piece.is_cylinder());
        let pressed = cylinders().any(|piece| {
            let (near, far) = (piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z));
            there(near) || there(far) || (near <= from && far >= to)
        });
        let Some(radius) = cylinders().map(|piece| piece.from.radius).max().filter(|_| pressed && !ground) else {
            continue;
        };
        let by_grade = || tolerance_width(surface.grade.or(unsaid)?, radius.diameter(), bench.knowledge).ok();
        let tolerance = bench.sizes.of_surface(&surface.name).map(super::Sized::tolerance).or_else(by_grade);
        if let Some(tolerance) = tolerance.filter(|own| tightest.as_ref().is_none_or(|(_, least)| own < least)) {
            tightest = Some((surface.name.clone(), tolerance));
        }
    }
    Ok(tightest)
}
