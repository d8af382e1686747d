//! The turning operation of a part, from the part file to the toolpaths.
//!
//! The steps, each run once (lecture 12.1-12.4):
//!
//! 1. [`prepare`]: the preparation of the blank, the surfaces that the lathe cannot finish, the contour that it
//!    leaves in their place;
//! 2. set-ups ([`crate::turning::zones::setup`]) with main and additional elements ([`crate::turning::elements`]);
//! 3. [`layers`]: finishing allowances, the rough contour, the three allowances as areas;
//! 4. zones ([`crate::turning::zones`]), [`tools`] for them;
//! 5. [`depth`]: the limiting depth, cutting conditions and feeds;
//! 6. [`work`]: the seven schemes over each zone, and the chosen one;
//! 7. `unfinished`: missing work, and toolpaths that would damage the part.
//!
//! Decisions by rules and tables are not made here: the rules are evaluated in this order and their reasons kept.

mod axial;
mod barred;
pub mod beside;
pub mod by_way;
mod centred;
mod clip;
mod coolant;
mod crests;
pub mod depth;
mod doubts;
pub mod drill;
mod features;
mod feeds;
mod finishing;
pub mod gauging;
pub mod grip;
pub mod ground;
mod held;
mod intermediate;
mod jaws;
mod jobs;
pub mod layers;
mod left_out;
mod opened;
mod parted;
mod pocket;
pub mod prepare;
pub mod programs;
pub mod proof;
pub mod setting;
pub mod sizes;
mod squeeze;
mod tailstock;
pub(crate) mod tapped;
mod thin;
pub mod times;
pub mod tool_table;
pub mod tools;
mod turned_before;
pub mod turret;
mod unfinished;
pub mod work;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::error::{KnowledgeError, Refusal};
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::material::Material;
use crate::note::{Figure, Finding, Note, Severity};
use crate::tables::cutting::Process;
use crate::turning::allowances::capability::Elsewhere;
use crate::turning::contour::Side;
use crate::turning::elements::Angles;
use crate::turning::jobs::{Job, Work as JobWork};
use crate::turning::length::Half;
use crate::turning::workpiece::{Advice, Blank, Workpiece, advice};
use crate::turning::zones::{self, Hold, SetUp};
use crate::units::Micrometres;
use layers::Layers;
use parted::{NotParted, Parted};
use tools::Bench;
use work::{Hollow, ZoneWork};

pub use axial::{Axial, AxialHole};
pub use barred::{Barred, Stage};
pub use grip::Grip;
pub use jaws::{ChuckBody, Jaws};
pub use sizes::{SizeOf, Sized, Sizes};
pub use tailstock::Tailstock;

/// A turning operation.
#[derive(Clone, Debug, Serialize)]
pub struct Operation {
    /// The part.
    #[serde(flatten)]
    pub workpiece: Workpiece,
    /// The blank of the file, where its ends are faced before it comes between the centres. That of the part is the faced one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blank_before: Option<Blank>,
    /// The advice of the rules about the blank.
    pub blank_advice: Vec<Advice>,
    /// The surfaces finished on another machine.
    pub elsewhere: Vec<Elsewhere>,
    /// The diameters that are turned between limits.
    #[serde(serialize_with = "sized", skip_serializing_if = "no_size")]
    pub sizes: Sizes,
    /// The set-ups.
    pub set_ups: Vec<SetUpWork>,
    /// How many tools the turret of its lathe holds.
    #[serde(skip)]
    pub turret_places: Option<usize>,
    /// The results of the proof of its jobs.
    #[serde(skip)]
    pub proven: Vec<proof::Proven>,
    /// Findings for the reader.
    pub findings: Vec<Finding>,
}

/// The sizes as a list.
fn sized<S: serde::Serializer>(sizes: &Sizes, serializer: S) -> Result<S::Ok, S::Error> {
    sizes.surfaces.serialize(serializer)
}

fn no_size(sizes: &Sizes) -> bool {
    sizes.surfaces.is_empty()
}

/// A set-up with its work.
#[derive(Clone, Debug, Serialize)]
pub struct SetUpWork {
    /// The set-up.
    #[serde(flatten)]
    pub set_up: SetUp,
    /// The jaws that hold the part; none between centres, and where no cylinder is long enough for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jaws: Option<Jaws>,
    /// How hard they must hold it; none where no force of a cut is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grip: Option<Grip>,
    /// The tailstock before the free end, between centres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tailstock: Option<Tailstock>,
    /// The narrow end of its bore, which tools on the axis make to size.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial: Option<Axial>,
    /// Its roughing outside and inside, in the order of work.
    pub sides: Vec<SideWork>,
    /// The work of its tools, in order.
    pub jobs: Vec<Job>,
    /// Z of the face at which the part is parted off in the end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parted_mm: Option<Half>,
}

impl SetUpWork {
    /// That nothing holds the part. Where no tool works, as long as it is held for nothing, it is doubtful only.
    pub(crate) fn not_held(&self) -> Option<Finding> {
        let severity = if self.jobs.is_empty() { Severity::Doubtful } else { Severity::Wrong };
        let note = || Note::new("set-up-not-held").with("number", self.set_up.number);
        self.set_up.holds_at.is_none().then(|| Finding::of_part(severity, note()))
    }

    /// Z of its free face before it is finished, where a spot and a drill begin.
    pub fn rough_face(&self) -> Half {
        jobs::rough_face(&self.sides)
    }
}

/// The roughing of a set-up on one side.
#[derive(Clone, Debug, Serialize)]
pub struct SideWork {
    /// Outside or inside.
    pub side: Side,
    /// Contours and allowances.
    pub layers: Layers,
    /// The zones, and the clearing of each.
    pub zones: Vec<ZoneWork>,
    /// The hollows under the main contour that are no grooves.
    pub hollows: Vec<Hollow>,
}

impl Operation {
    /// Proves the jobs again, after some of them were replaced.
    pub(super) fn prove_again(&mut self) {
        let before = proof::findings(self);
        self.findings.retain(|finding| !before.contains(finding));
        self.proven = proof::prove(self);
        let findings = proof::findings(self);
        self.findings.extend(findings);
    }

    /// Tells what follows from its jobs and their proof, after what was found as they were planned: each time anew, so that nothing
    /// stays of jobs that it no longer has.
    fn conclude(&mut self, planned: &[Finding], knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        let mut findings = planned.to_vec();
        findings.extend(unfinished::unfinished(self));
        findings.extend(self.set_ups.iter().filter_map(|one| one.tailstock.as_ref()?.finding(one.set_up.number)));
        findings.extend(proof::findings(self));
        findings.extend(doubts::doubts(self));
        findings.extend(turret(self));
        findings.extend(tapped::bored_beside_limits(&self.workpiece, knowledge)?);
        self.findings = merged(findings);
        Ok(())
    }

    /// Whether something was found wrong.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|finding| finding.severity <= Severity::Wrong)
    }

    /// Replaces each centre that a tool strikes with one that is turned down for it; whether there was one.
    fn turns_centres_down(&mut self) -> bool {
        let slimmer = |work: &SetUpWork| {
            let outside = work.jobs.iter().filter(|job| job.side == Side::Outer);
            let nearest = outside.flat_map(|job| &job.path.moves).map(|one| one.to.radius).min()?;
            work.tailstock?.turned_down(nearest).filter(|_| proof::meets_centre(self, work.set_up.number))
        };
        let slimmer: Vec<_> = self.set_ups.iter().map(slimmer).collect();
        let any = slimmer.iter().any(Option::is_some);
        for (work, slimmer) in self.set_ups.iter_mut().zip(slimmer) {
            work.tailstock = slimmer.or(work.tailstock);
        }
        any
    }

    /// Its badness: first the set-ups that the proof rejects, then the number of wrong findings.
    fn badness(&self) -> (usize, usize) {
        let rejected = self.proven.iter().filter(|proven| proof::rejected(self, proven).is_some());
        (rejected.count(), self.findings.iter().filter(|finding| finding.severity <= Severity::Wrong).count())
    }

    /// Every zone with its work, in the order of work.
    pub fn zones(&self) -> impl Iterator<Item = (&SetUpWork, &SideWork, &ZoneWork)> {
        let sides = self.set_ups.iter().flat_map(|set_up| set_up.sides.iter().map(move |side| (set_up, side)));
        sides.flat_map(|(set_up, side)| side.zones.iter().map(move |zone| (set_up, side, zone)))
    }
}

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
struct Attempt {
    operation: Operation,
    planned: Vec<Finding>,
}

/// The most attempts with other tools after the proof rejected some.
const ATTEMPTS: usize = 6;

/// Plans the turning of a part without the tools that the proof rejected, parted off its bar or not.
fn plan_without(
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
    // A far face that nothing but a thread holds the part for is parted to length.
    let held = |one: &SetUp| !matches!(one.holds_at, None | Some(Hold::Surface { threaded: true, .. }));
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
        let grip = Grip::of(jaws.as_ref(), alone, &jobs, knowledge)?;
        if let (Some(squeeze), Some(grip)) = (&squeeze, &grip) {
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

/// That the turret has fewer places than the operation has tools, and at how many stops tools are put in.
fn turret(operation: &Operation) -> Option<Finding> {
    let stations = turret::stations(operation);
    let (places, tools) = (operation.turret_places?, stations.len());
    let stops = turret::loads(operation, &stations).iter().filter(|load| load.before > 0).count();
    // With fewer places than tools one shares the place of another.
    let seat = stations.iter().map(|one| one.seat).find(|seat| seat.place != seat.offset)?;
    let note = Note::new("turret-too-small")
        .with("tools", tools)
        .with("places", places)
        .with("stops", stops)
        .with("place", seat.place)
        .with("offset", seat.offset)
        .with("lathe", Figure::word_of("machine", operation.workpiece.machine.clone()?));
    (tools > places).then(|| Finding::of_part(Severity::Doubtful, note))
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

/// The figures in which merged findings may differ.
const LISTED: [&str; 3] = ["surface", "row", "z"];

/// Each finding once, in the order of the first. Findings that differ only in a surface or a row are merged.
fn merged(findings: Vec<Finding>) -> Vec<Finding> {
    let mut kept: Vec<(Finding, Vec<Note>)> = Vec::new();
    let mut places = BTreeMap::new();
    for finding in findings {
        let alike = LISTED.iter().fold(finding.note.clone(), |note, name| note.without(name));
        let place = *places.entry((finding.severity, alike)).or_insert(kept.len());
        match kept.get_mut(place) {
            Some((_, others)) => others.push(finding.note),
            None => kept.push((finding, Vec::new())),
        }
    }
    let joined = |(mut finding, others): (Finding, Vec<Note>)| {
        finding.note.join(&others, &LISTED);
        finding
    };
    kept.into_iter().map(joined).collect()
}
