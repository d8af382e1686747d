//! Whether the turret may turn where a program changes tools.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::tables::audit::AuditTurretClearFor;
use crate::turning::jobs::{Body, Job};
use crate::turning::operation::{Operation, SetUpWork};
use crate::units::{Micrometres, round_to};
use technolog_turning_proof::IndexedNear;

use super::calls::CalledTool;
use super::fault;

/// Changes of tools beside the stock: as the turret turns, what stands in its other places sweeps through there. Of a lathe whose
/// turret is not known it is doubtful at most.
///
/// No record says how far tools stand out of a turret, but a tool that works within the part stands out by as much as it goes in,
/// at least, and a turning tool across the axis by little more than the width of its shank.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn turned_near(
    operation: &Operation,
    work: &SetUpWork,
    tools: &[CalledTool],
    indexed: &[IndexedNear],
    knowledge: &Knowledge,
) -> Result<Vec<Fault>, KnowledgeError> {
    let least = if operation.turret_places.is_some() { Severity::Error } else { Severity::Doubtful };
    let called = || tools.iter().filter(|tool| tool.is_named).filter_map(|tool| work.jobs.get(tool.job));
    let longest = called().filter_map(|job| Some((goes_in(job)?, job))).max_by(|one, other| one.0.total_cmp(&other.0));
    let mut faults = Vec::new();
    for IndexedNear { block, tool, distance } in indexed {
        let beside = work.jobs.get(*tool).and_then(across);
        let beyond = |(reach, job)| beside.map(|beside: f64| (reach - beside - distance.0, job));
        let reaching: Option<(f64, &Job)> = longest.and_then(beyond).filter(|(into, _)| *into > 0.0);
        let question =
            AuditTurretClearFor { distance: Micrometres::from_mm_rounded(distance.0), reaches_in: reaching.is_some() };
        let severity = knowledge.ask(&question)?.need("distance")?.severity;
        if severity == Severity::Note {
            continue;
        }
        let code = if reaching.is_some() { "turned-index-into" } else { "turned-index-near" };
        let note = Note::new(code).with("distance", round_to(distance.0, 1));
        let note = match reaching {
            Some((into, job)) => note.with("tool", &*job.tool.designation).with("into", round_to(into, 0)),
            None => note,
        };
        let line = u32::try_from(block.0).unwrap_or(u32::MAX);
        faults.push(fault(code, severity.max(least), note, line));
    }
    Ok(faults)
}

/// How far a tool that stands along the axis goes into the part, mm: so far it stands out of the turret at least. None of a tool that
/// stands across.
fn goes_in(job: &Job) -> Option<f64> {
    let along = !matches!(job.tool.body, Body::Insert { bar_mm: None, .. });
    let deepest = job.path.moves.iter().map(|one| one.to.z).max()?;
    along.then(|| deepest.to_mm())
}

/// How far a tool across the axis stands out of the turret along it at most, mm: its tip is about a quarter of the shank beside the
/// shank (25 and 32 mm, 20 and 25 mm of ISO 5610). None of other tools.
fn across(job: &Job) -> Option<f64> {
    match job.tool.body {
        Body::Insert { shank_mm: Some((_, width)), .. } => Some(1.3 * width.to_mm()),
        _ => None,
    }
}
