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
mod beyond;
pub mod by_way;
mod centred;
mod clear;
mod clip;
mod coolant;
mod crests;
pub mod depth;
mod doubts;
pub mod drill;
mod features;
mod feeds;
mod finish;
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
mod plan;
mod pocket;
pub mod prepare;
pub mod programs;
pub mod proof;
pub mod setting;
mod side_stock;
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

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Figure, Finding, Note, Severity};
use crate::turning::allowances::capability::Elsewhere;
use crate::turning::contour::Side;
use crate::turning::jobs::Job;
use crate::turning::length::Half;
use crate::turning::workpiece::{Advice, Blank, Workpiece};
use crate::turning::zones::SetUp;
use layers::Layers;
use work::{Hollow, ZoneWork};

pub use axial::{Axial, AxialHole};
pub use barred::{Barred, Stage};
pub use grip::{Grip, Regrip};
pub use jaws::{ChuckBody, Jaws};
pub use plan::plan;
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
