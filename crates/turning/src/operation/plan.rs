//! Plans an operation: every step once, then again without the tools that the proof rejects.

use super::axial::Axial;
use super::barred::Barred;
use super::grip::{Ahead, Grip};
use super::jaws::Jaws;
use super::parted::{NotParted, Parted};
use super::sizes::Sizes;
use super::tailstock::Tailstock;
use super::tools::Bench;
use super::{
    Operation, SetUpWork, SideWork, barred, centred, coolant, held, jobs, layers, opened, prepare, proof, squeeze,
    tapped, turned_before, work,
};
use crate::error::{KnowledgeError, Refusal};
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::material::Material;
use crate::note::{Finding, Note, Severity};
use crate::tables::cutting::Process;
use crate::turning::contour::Side;
use crate::turning::cutting::jaw_clearance;
use crate::turning::elements::Angles;
use crate::turning::jobs::{Job, Work as JobWork};
use crate::turning::length::Half;
use crate::turning::workpiece::{Workpiece, advice};
use crate::turning::zones::{self, Hold, JawLengths, SetUp};
use crate::units::Micrometres;

/// Plans the turning of a part.
///
/// What cannot be made is a finding, not an error of the program.
///
/// # Errors
/// The knowledge base lacks a table or a row that must be there.
pub fn plan(workpiece: &Workpiece, knowledge: &Knowledge) -> Result<Operation, KnowledgeError> {
    if let Some((centred, finding)) = centred::centred(workpiece, knowledge)? {
        let mut operation = tapped::planned(&centred, knowledge, |part| plan_best(part, knowledge))?;
        operation.findings.insert(0, finding);
        operation.blank_before = Some(workpiece.blank.clone());
        return Ok(operation);
    }
    tapped::planned(workpiece, knowledge, |part| plan_best(part, knowledge))
}

/// The best plan of several attempts.
fn plan_best(workpiece: &Workpiece, knowledge: &Knowledge) -> Result<Operation, KnowledgeError> {
    let mut barred = Vec::new();
    let mut last = plan_without(workpiece, &barred, true, knowledge)?;
    let mut best = last.clone();
    // How many were barred from the best: told once it is known, so that a plan is no worse for what is told of it.
    let mut best_without = 0;
    for _ in 0..ATTEMPTS {
        let known = barred.len();
        for one in barred::rejected(&last.operation) {
            if !barred.iter().any(|known: &Barred| known.is_same(&one)) {
                barred.push(one);
            }
        }
        if barred.len() == known {
            break;
        }
        last = plan_without(workpiece, &barred, true, knowledge)?;
        if last.operation.badness() < best.operation.badness() {
            best = last.clone();
            best_without = barred.len();
        }
    }
    let Attempt { mut operation, planned } = best;
    operation.leave_unsafe_out(planned, knowledge)?;
    operation.findings.extend(barred.iter().take(best_without).map(Barred::finding));
    Ok(operation)
}

/// A plan with what was found on the way to its jobs, before it was concluded.
#[derive(Clone, Debug)]
pub(super) struct Attempt {
    pub operation: Operation,
    pub planned: Vec<Finding>,
}

/// The most attempts with other tools after the proof rejected some.
const ATTEMPTS: usize = 6;

/// Plans the turning of a part without the tools that the proof rejected, parted off its bar or not.
pub(super) fn plan_without(
    workpiece: &Workpiece,
    barred: &[Barred],
    parts_off: bool,
    knowledge: &Knowledge,
) -> Result<Attempt, KnowledgeError> {
    let mut findings = workpiece.findings.clone();
    let lathe = prepare::lathe(workpiece, knowledge, &mut findings)?;
    let blank_advice = advice(workpiece, knowledge)?;
    findings.extend(
        blank_advice.iter().filter(|one| one.finding.severity <= Severity::Doubtful).map(|one| one.finding.clone()),
    );
    let material = stated(workpiece, knowledge)?;
    if let Some(state) = workpiece.material_state {
        let by = (Process::Turning, ToolMaterial::Carbide);
        findings.extend(technolog_cutting::state::without_force(&material, state, by, knowledge)?);
    }
    let none = Sizes::default();
    let bench = Bench::of(workpiece, lathe.as_ref(), material, &none, knowledge);
    let tried = if parts_off { Refusal::split(Parted::of(workpiece, &bench))? } else { Err(NotParted::Hole) };
    let mut parted = tried.ok();
    let jaws_from = parted.map(Parted::jaws_from);
    let mut set_ups = zones::set_ups(workpiece, jaws_from, Angles::CONTOURING, knowledge)?;
    // A far face that nothing but a thread holds the part for, or less than jaws must close on, is parted to length.
    let [near, _] = jaw_clearance(knowledge)?.map(Half::of);
    let held = |one: &SetUp| match &one.holds_at {
        None | Some(Hold::Surface { threaded: true, .. }) => false,
        Some(Hold::Surface { diameter_mm, length_mm, .. }) => {
            JawLengths::of(*diameter_mm, knowledge).is_ok_and(|lengths| *length_mm - near >= lengths.least_grip)
        }
        Some(Hold::Blank { .. } | Hold::Centres) => true,
    };
    let only_faced = |one: &SetUp| one.outer.is_none() && one.inner.is_none() && !held(one);
    if parted.is_some() && set_ups.get(1).is_some_and(only_faced) {
        parted = parted.map(Parted::to_length);
        set_ups.truncate(1);
        findings.push(Finding::of_part(Severity::Doubtful, Note::new("far-face-as-parted")));
    }
    let axials = Axial::of_set_ups(&set_ups, &bench)?;
    let mut elsewhere = prepare::finished_elsewhere(workpiece, lathe.as_ref(), knowledge, &mut findings)?;
    // What tools on the axis make to size does not hang on what the lathe holds with a bar.
    elsewhere.retain(|one| axials.iter().flatten().flat_map(Axial::surfaces).all(|name| *name != one.surface));
    let (sizes, off_size) = Sizes::of(workpiece, &elsewhere, &axials, knowledge)?;
    findings.extend(off_size);
    let bench = Bench { elsewhere: &elsewhere, sizes: &sizes, ..bench };
    let cut_off = parted.map(|parted| parted.workpiece(workpiece));
    let mut done = Vec::new();
    for (mut set_up, axial) in set_ups.into_iter().zip(axials) {
        let workpiece = cut_off.as_ref().filter(|_| set_up.turned_over).unwrap_or(workpiece);
        if let Err(why) = tried
            && set_up.faces
            && set_up.outer.is_none()
        {
            let length = workpiece.blank.end() - workpiece.length();
            let note = Note::new("far-face-cut-away").with("number", set_up.number).with("length", length);
            let note = note.with("why", why.name());
            findings.push(Finding::of_part(Severity::Note, note));
        }
        let jaws = Jaws::of(&set_up, workpiece, lathe.as_ref(), &elsewhere, knowledge)?;
        findings.extend(jaws.and_then(|jaws| jaws.short(set_up.number)));
        let tailstock = Tailstock::of(&set_up, workpiece, lathe.as_ref(), knowledge)?;
        let held = held::Held::of(&set_up, jaws.as_ref(), workpiece, &bench.material, knowledge)?;
        let own = barred.iter().filter(|one| one.set_up == set_up.number).cloned().collect();
        // Nothing but the jaws holds it.
        let alone = !set_up.centre && set_up.rest.is_none();
        let squeeze = squeeze::Squeeze::of(&set_up, jaws.as_ref(), &Bench { workpiece, ..bench.clone() })?;
        let bears = squeeze.as_ref().and_then(squeeze::Squeeze::bears);
        let grip = Grip::limit(jaws.as_ref(), bears, alone, knowledge)?;
        let fastest = Grip::fastest(jaws.as_ref(), bears, knowledge)?;
        let slowed = lathe.as_ref().zip(fastest).filter(|(lathe, most)| lathe.spindle.ends().1.0 > most.0);
        let slowed = slowed.map(|(lathe, most)| {
            let chuck = jaws.and_then(|jaws| jaws.body).map(|body| body.chuck_mm).unwrap_or_default();
            set_up.notes.push(Note::new("chuck-turns-at-most").with("most", most.0).with("chuck", chuck));
            lathe.no_faster_than(most)
        });
        let bench = Bench { lathe: slowed.as_ref().or(lathe.as_ref()), ..bench.clone() };
        let parts = parted.filter(|_| !set_up.turned_over);
        let through = parts.and_then(Parted::drilled_to);
        let opened = if set_up.turned_over { opened::opened(&done, workpiece.length()) } else { Micrometres::ZERO };
        let turned = turned_before::turned(&done, workpiece.length()).filter(|_| set_up.turned_over);
        let parted_at = parts.map(Parted::face);
        let bench =
            Bench { workpiece, held, grip, through, parted: parted_at, opened, turned, barred: own, ..bench.clone() };
        // The set-up as turning tools see it: its bore ends where the hole that is made to size begins.
        let turned = match &axial {
            Some(axial) => &SetUp { inner: axial.bored.clone(), ..set_up.clone() },
            None => &set_up,
        };
        let sides = sides(turned, axial.as_ref(), &bench, &mut findings)?;
        let mut jobs = jobs::jobs(turned, &sides, axial.as_ref(), &bench, &mut findings)?;
        if set_up.centre && jobs.iter().any(|job| job.side == Side::Inner) {
            jobs.retain(|job| job.side != Side::Inner);
            let note = Note::new("bore-behind-centre").with("number", set_up.number);
            findings.push(Finding::of_part(Severity::Wrong, note));
        }
        if let Some(parted) = parts {
            set_up.notes.push(Note::new("setup-parts-off").with("z", Half::ZERO - parted.face()));
            match parted.job(jaws.as_ref(), &jobs, &bench, &mut findings)? {
                Some(job) => jobs.push(job),
                // The hole came out narrower than was expected: the blade does not reach it.
                None if parted.counts_on_hole() => return plan_without(workpiece, barred, false, knowledge),
                None => {}
            }
        }
        coolant::mark_dry(&mut jobs, bench.material.group, knowledge)?;
        let mut grip = Grip::of(jaws.as_ref(), alone, &jobs, Ahead::of(&sides), knowledge)?;
        if let (Some(squeeze), Some(grip)) = (&squeeze, &mut grip) {
            grip.loosened = squeeze.loosened(grip, &jobs);
            findings.extend(squeeze.findings(grip, &jobs, set_up.number));
        }
        findings.extend(grip.as_ref().and_then(|grip| grip.finding(set_up.number)));
        findings.extend(slug(&set_up, &done, &jobs, workpiece));
        let parted_mm = parts.map(Parted::face);
        let work = SetUpWork { set_up, jaws, grip, tailstock, axial, sides, jobs, parted_mm };
        findings.extend(work.not_held());
        done.push(work);
    }
    let mut operation = Operation {
        workpiece: workpiece.clone(),
        blank_before: None,
        blank_advice,
        elsewhere: elsewhere.clone(),
        sizes: sizes.clone(),
        set_ups: done,
        turret_places: lathe.as_ref().and_then(|lathe| lathe.turret_places),
        proven: Vec::new(),
        findings: Vec::new(),
    };
    operation.proven = proof::prove(&operation);
    if operation.turns_centres_down() {
        operation.proven = proof::prove(&operation);
    }
    operation.conclude(&findings, knowledge)?;
    Ok(Attempt { operation, planned: findings })
}

/// That facing the far end sets free a disc: an earlier set-up has bored or drilled the solid blank as far as the face, and the
/// last passes open the hole from behind.
fn slug(set_up: &SetUp, before: &[SetUpWork], jobs: &[Job], workpiece: &Workpiece) -> Option<Finding> {
    let faced = set_up.turned_over && jobs.iter().any(|job| job.work == JobWork::Face);
    if !faced || workpiece.blank.inner.is_some() {
        return None;
    }
    let earlier = before.iter().flat_map(|one| &one.jobs).filter(|job| job.work == JobWork::Drill);
    // Parted behind a hole that goes on: nothing is left in it.
    if workpiece.blank.end() > workpiece.length() && earlier.clone().any(|job| job.comes_to(workpiece.blank.end())) {
        return None;
    }
    let diameters = earlier.filter(|job| job.comes_to(workpiece.length())).filter_map(Job::drills);
    let note = Note::new("face-frees-slug").with("number", set_up.number).with("diameter", diameters.max()?);
    Some(Finding::of_part(Severity::Doubtful, note))
}

/// The material in the state that the file says.
fn stated<'k>(workpiece: &Workpiece, knowledge: &'k Knowledge) -> Result<Material<'k>, KnowledgeError> {
    let material = Material::find(knowledge, &workpiece.material)?;
    match workpiece.material_state {
        Some(state) => material.in_state(state, knowledge),
        None => Ok(material),
    }
}

/// The outside of a set-up, then its bore: the part is faced before it is bored.
fn sides(
    set_up: &SetUp,
    axial: Option<&Axial>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<SideWork>, KnowledgeError> {
    let mut sides = Vec::new();
    let axial = axial.map(|axial| axial.drill(bench)).transpose()?;
    if set_up.faces
        && set_up.outer.is_none()
        && let Some(layers) = layers::before_face(set_up, bench, findings)?
    {
        let zones = work::zones(&layers, bench, findings)?;
        sides.push(SideWork { side: Side::Outer, layers, zones, hollows: Vec::new() });
    }
    for (side, stretch) in [(Side::Outer, &set_up.outer), (Side::Inner, &set_up.inner)] {
        let Some(stretch) = stretch else { continue };
        let face = sides.first().and_then(|outer: &SideWork| outer.layers.rough.start()).map(|start| start.z);
        let before = layers::Before { face, axial: axial.filter(|_| side == Side::Inner) };
        let Some(layers) = layers::layers(stretch, set_up, before, bench, findings)? else { continue };
        let zones = work::zones(&layers, bench, findings)?;
        work::finishing_after(&zones, &stretch.profile, bench, findings)?;
        let hollows = work::hollows(stretch, set_up, &layers, bench, findings)?;
        sides.push(SideWork { side, layers, zones, hollows });
    }
    Ok(sides)
}
