//! The operation of a stepped shaft, roughed by one of its ways ([`crate::turning::ways`]) instead of the schemes of its
//! zones.

use crate::note::{Finding, Note, Severity};
use crate::turning::jobs::{Body, Work};
use crate::turning::length::Half;
use crate::turning::ways::Ways;
use crate::units::{Degrees, Micrometres};

use super::{Operation, proof};

/// How far the wall that a pass leaves extends before its foot, plus a clearance: an edge with φ above 90° leaves it
/// inclined over the depth of the pass.
fn lean(depth: Micrometres, lead: Degrees) -> Micrometres {
    /// The clearance, mm.
    const FREE: f64 = 0.2;
    let over = (lead.0 - 90.0).max(0.0).to_radians();
    Micrometres::from_mm_rounded(depth.to_mm() * libm::tan(over) + FREE)
}

/// The operation with the rough jobs of its first set-up replaced by one job with the toolpath of a way. Tool,
/// conditions and everything else are those of the operation. None if nothing is roughed there.
pub fn by_way(ways: &Ways, name: &str) -> Option<Operation> {
    let mut operation = ways.operation.clone();
    let mut distances = ways.schemes.splitting.rates;
    let set_up = operation.set_ups.first_mut()?;
    let is_rough = |work: Work| matches!(work, Work::Face | Work::Rough);
    let mut job = set_up.jobs.iter().find(|job| job.work == Work::Rough)?.clone();
    if let Body::Insert { lead_angle_deg, .. } = job.tool.body {
        let depth = ways.sequences.shaft.roughing.longitudinal_depth;
        distances.retract = distances.retract.max(lean(depth, lead_angle_deg));
    }
    job.path = ways.toolpath(name, &distances, Half::of(job.tool.nose_radius()))?;
    job.time_min = job.pace.time(&job.path, distances.rapid);
    job.zone = None;
    let place = set_up.jobs.iter().position(|job| is_rough(job.work)).unwrap_or_default();
    set_up.jobs.retain(|job| !is_rough(job.work));
    set_up.jobs.insert(place, job);
    operation.prove_again();
    Some(operation)
}

/// What is wrong with the operation by a way and not with the usual one.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    /// The first place where it damages something.
    pub damage: Option<Note>,
    /// The first place where it leaves metal standing.
    pub leaves: Option<Note>,
}

/// The faults that an operation has by a way and not as usual.
pub fn faults(usual: &Operation, by_way: &Operation) -> Faults {
    let wrong = by_way.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    let own = wrong.filter(|finding| !usual.findings.contains(finding));
    let all_standing = proof::standing(by_way);
    let (standing, damage): (Vec<&Finding>, Vec<&Finding>) = own.partition(|own| all_standing.contains(own));
    let first = |findings: &[&Finding]| findings.first().map(|finding| finding.note.clone());
    Faults { damage: first(&damage), leaves: first(&standing) }
}
