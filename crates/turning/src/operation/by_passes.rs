//! The operation of a stepped shaft, roughed by a sequence of passes (the paper) instead of schemes.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::turning::jobs::{Body, Work};
use crate::turning::length::Half;
use crate::turning::passes::Variant;
use crate::turning::passes::toolpath::toolpath;
use crate::turning::schemes::rates;
use crate::turning::shaft::Shaft;
use crate::turning::workpiece::Workpiece;
use crate::units::{Degrees, Micrometres};

use super::{Operation, plan};

/// How far the wall that a pass leaves extends before its foot, plus a clearance: an edge with φ above 90° leaves it
/// inclined over the depth of the pass.
fn lean(depth: Micrometres, lead: Degrees) -> Micrometres {
    /// The clearance, mm.
    const FREE: f64 = 0.2;
    let over = (lead.0 - 90.0).max(0.0).to_radians();
    Micrometres::from_mm_rounded(depth.to_mm() * libm::tan(over) + FREE)
}

/// The operation with the rough jobs of its first set-up replaced by one job with the passes of a variant. Tool,
/// conditions and everything else are those of the operation.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn by_passes(shaft: &Shaft, variant: &Variant, knowledge: &Knowledge) -> Result<Operation, KnowledgeError> {
    let mut operation = plan(&Workpiece::from(shaft), knowledge)?;
    let (mut distances, _) = rates::rates(shaft, knowledge)?;
    let Some(set_up) = operation.set_ups.first_mut() else { return Ok(operation) };
    let is_rough = |work: Work| matches!(work, Work::Face | Work::Rough);
    let Some(mut job) = set_up.jobs.iter().find(|job| job.work == Work::Rough).cloned() else { return Ok(operation) };
    let nose = Half::of(job.tool.nose_radius());
    if let Body::Insert { lead_angle_deg, .. } = job.tool.body {
        distances.retract = distances.retract.max(lean(shaft.roughing.longitudinal_depth, lead_angle_deg));
    }
    job.path = toolpath(&variant.drawn, Half::radius_of(shaft.blank.diameter), &distances, nose);
    job.time_min = job.pace.time(&job.path, distances.rapid);
    job.zone = None;
    let place = set_up.jobs.iter().position(|job| is_rough(job.work)).unwrap_or_default();
    set_up.jobs.retain(|job| !is_rough(job.work));
    set_up.jobs.insert(place, job);
    operation.prove_again();
    Ok(operation)
}
