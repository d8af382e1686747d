//! How far a program goes at the end of the part: where it parts the part off, and how deep its drills go.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheMotion, LatheRun};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::jobs::limits::Limits;
use crate::turning::jobs::{Body, Job};
use crate::turning::operation::{Operation, SetUpWork};
use crate::units::round_to;
use technolog_turning_proof::{Mm, Proof};

use super::calls::CalledTool;
use super::fault;

/// A length of `turning-job-limits`, mm.
fn length(name: JobLimit, knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    Ok(Limits::of(knowledge).length(name)?.to_mm())
}

/// The lines of a program round to a thousandth, mm.
const ROUNDING: f64 = 0.01;

/// A part that a set-up parts off: whether it does, and how long the part stays. A neck that is broken by hand is doubtful.
///
/// # Errors
/// The knowledge base lacks a row.
pub(super) fn parted(
    operation: &Operation,
    work: &SetUpWork,
    run: &LatheRun,
    proof: &Proof,
    knowledge: &Knowledge,
) -> Result<Vec<Fault>, KnowledgeError> {
    let Some(face) = work.parted_mm else { return Ok(Vec::new()) };
    let length_of_part = operation.workpiece.length().to_mm();
    let behind = work.jaws.map_or_else(|| operation.workpiece.blank.end(), |jaws| jaws.front_mm).to_mm();
    let Some((z, radius)) = proof.left.thinnest(Mm(-length_of_part), Mm(-behind)) else { return Ok(Vec::new()) };
    let last = run.motions.iter().rev().find(|one| one.act.cuts());
    let line = last.map_or(1, |motion| motion.line);
    if radius.0 > 0.0 {
        let (neck, most) = (2.0 * radius.0, length(JobLimit::PartingNeck, knowledge)?);
        let severity = if neck > most { Severity::Wrong } else { Severity::Doubtful };
        let note = Note::new("turned-not-parted").with("neck", round_to(neck, 1)).with("z", round_to(z.0, 3));
        return Ok(vec![fault("turned-not-parted", severity, note.with("most", most), line)]);
    }
    let (left, planned) = (-z.0 - length_of_part, face.to_mm() - length_of_part);
    let excess = left - planned;
    if excess <= ROUNDING {
        return Ok(Vec::new());
    }
    // What is parted to length has no face that would take the rest off.
    let most = if planned > 0.0 { length(JobLimit::PartingExcess, knowledge)? } else { ROUNDING };
    let severity = if excess > most + ROUNDING { Severity::Wrong } else { Severity::Doubtful };
    let note = Note::new("turned-parted-long").with("left", round_to(left, 3)).with("planned", round_to(planned, 3));
    Ok(vec![fault("turned-parted-long", severity, note.with("excess", round_to(excess, 3)), line)])
}

/// Drills that go deeper than the holes of the set-up need: into the bar that the jaws hold, through the blank, or beyond the
/// run-out of the deepest drill of the plan. What a drill cuts of the part, the proof tells.
///
/// # Errors
/// The knowledge base lacks a row.
pub(super) fn drilled(
    operation: &Operation,
    work: &SetUpWork,
    run: &LatheRun,
    tools: &[CalledTool],
    knowledge: &Knowledge,
) -> Result<Vec<Fault>, KnowledgeError> {
    let bores = |job: &&Job| matches!(job.tool.body, Body::Drill { .. } | Body::Reamer { .. });
    let deepest = |job: &Job| job.path.moves.iter().map(|one| one.to.z).max();
    let Some(planned) = work.jobs.iter().filter(bores).filter_map(deepest).max().map(|z| z.to_mm()) else {
        return Ok(Vec::new());
    };
    let over = length(JobLimit::DrillBreakthrough, knowledge)?;
    let end = operation.workpiece.blank.end().to_mm();
    let jaws = work.jaws.map(|jaws| jaws.front_mm.to_mm());
    let mut faults = Vec::new();
    for tool in tools {
        let Some(job) = work.jobs.get(tool.job).filter(|job| bores(job)) else { continue };
        let is_of = |one: &&LatheMotion| one.act.cuts() && one.modes.tool == Some(tool.called);
        let depths = run.motions.iter().filter(is_of).filter_map(|one| Some((-one.to.z_mm?, one.line)));
        let Some((depth, line)) = depths.max_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        let beyond = |limit: f64| depth > limit.max(planned) + over;
        let note = |code| Note::new(code).with("tool", &*job.tool.designation).with("z", round_to(-depth, 3));
        let (code, severity, note) = match jaws.filter(|_| work.parted_mm.is_some()) {
            _ if beyond(end) => {
                let note = note("turned-drilled-through").with("limit", round_to(-end, 3));
                ("turned-drilled-through", Severity::Wrong, note)
            }
            Some(front) if beyond(front) => {
                let note = note("turned-drilled-into-jaws").with("limit", round_to(-front, 3));
                ("turned-drilled-into-jaws", Severity::Wrong, note)
            }
            _ if depth > planned + over => {
                let note = note("turned-drilled-deep").with("excess", round_to(depth - planned, 3));
                ("turned-drilled-deep", Severity::Doubtful, note)
            }
            _ => continue,
        };
        let least = if tool.is_named { Severity::Error } else { Severity::Doubtful };
        faults.push(fault(code, severity.max(least), note, line));
    }
    Ok(faults)
}
