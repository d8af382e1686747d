//! Passes of threads: whether the drive has reached the pitch where the thread begins, whether the spindle keeps its speed,
//! and how deep they cut at once.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheAct, LatheMotion, LathePoint, LatheRun};
use crate::tables::audit::{AuditLathePaceFor, AuditThresholds, PaceFigure, Threshold};
use crate::tables::turning::jobs::{JobLimit, ThreadingFirstPassFor};
use crate::turning::contour::Side;
use crate::turning::jobs::limits::Limits;
use crate::turning::jobs::{Body, Job, ThreadCut};
use crate::turning::operation::{Operation, SetUpWork};
use crate::units::{RevsPerMinute, round_to};
use technolog_core::material::Material;

use super::calls::CalledTool;
use super::fault;
use super::lathe::turns;

/// How far a depth may be off by the decimals of a program, mm: a thousandth of a diameter, at both ends.
const ROUNDING_MM: f64 = 0.001;

/// What is doubtful about the passes of each thread, each once, at the worst of them.
///
/// The run-in that a pass needs is a·L·R/k: the lead L, mm, and the spindle speed R, 1/min, with `thread-run-in` and
/// `thread-run-out` of `turning-job-limits`. How deep a pass may be at once is by `audit-lathe-pace`.
///
/// # Errors
/// The knowledge base lacks a row.
pub(super) fn passes(
    operation: &Operation,
    work: &SetUpWork,
    run: &LatheRun,
    tools: &[CalledTool],
    knowledge: &Knowledge,
) -> Result<Vec<Fault>, KnowledgeError> {
    let material_group = Material::find(knowledge, &operation.workpiece.material)?.group;
    let mut limits = Limits::of(knowledge);
    let whole = Threshold::ThreadWhole;
    let whole_share = knowledge.need(whole.name(), |row: &AuditThresholds<'_>| row.name == whole)?.value;
    let mut faults = Vec::new();
    for (side, cut) in work.jobs.iter().filter_map(|job| Some((job.side, job.thread.as_ref()?))) {
        let share = limits.ratio(JobLimit::ThreadRunIn)? / limits.ratio(JobLimit::ThreadRunOut)?;
        let may_cut = |motion: &LatheMotion| {
            let tool = tools.iter().find(|tool| motion.modes.tool == Some(tool.called));
            tool.and_then(|tool| work.jobs.get(tool.job)).is_some_and(|job| turns_on(job, side))
        };
        let own: Vec<&LatheMotion> =
            run.motions.iter().filter(|one| one.act.moves() && (!is_pass(one) || may_cut(one))).collect();
        let mut short: Option<(f64, f64, u32)> = None;
        let mut speeds: Option<(RevsPerMinute, RevsPerMinute, u32)> = None;
        for (begin, speed, line) in starts(&own, cut) {
            let (needs, has) = (share * cut.pitch_mm.to_mm() * speed.0, begin + cut.begins_z_mm.to_mm());
            if has < needs && short.is_none_or(|(worst, ..)| has < worst) {
                short = Some((has, needs, line));
            }
            let (least, most, _) = speeds.unwrap_or((speed, speed, line));
            let others = speed.0 < least.0 || speed.0 > most.0;
            let (least, most) = (least.0.min(speed.0), most.0.max(speed.0));
            let line = if others { line } else { speeds.map_or(line, |known| known.2) };
            speeds = Some((RevsPerMinute(least), RevsPerMinute(most), line));
        }
        if let Some((has, needs, line)) = short {
            let note =
                Note::new("turned-thread-run-in").with("has", round_to(has, 1)).with("needs", round_to(needs, 1));
            let note = note.with("pitch", cut.pitch_mm);
            faults.push(fault("turned-thread-run-in", Severity::Doubtful, note, line));
        }
        if let Some((least, most, line)) = speeds.filter(|(least, most, _)| most.0 - least.0 >= 1.0) {
            let note = Note::new("turned-thread-speeds").with("least", round_to(least.0, 0));
            let note = note.with("most", round_to(most.0, 0));
            faults.push(fault("turned-thread-speeds", Severity::Wrong, note, line));
        }
        let asked = knowledge.ask(&ThreadingFirstPassFor { material_group })?;
        let most = asked.need(material_group)?.depth.to_mm();
        if let Some((depth, line)) = deepest_step(&own, cut) {
            let whole = (cut.root_radius_mm.to_mm() - cut.crest_radius_mm.to_mm()).abs();
            let figure = if depth < whole_share * whole { PaceFigure::ThreadPass } else { PaceFigure::WholeThread };
            let share = ((depth - ROUNDING_MM) / most).max(0.0);
            let severity = knowledge.ask(&AuditLathePaceFor { figure, share })?.need("share")?.severity;
            if severity != Severity::Note {
                let note = Note::new("turned-thread-pass").with("depth", round_to(depth, 2));
                let note = note.with("whole", round_to(whole, 2)).with("most", round_to(most, 2));
                faults.push(fault("turned-thread-pass", severity, note, line));
            }
        }
    }
    Ok(faults)
}

/// Whether the tool of a job may cut a thread on a side: an insert that works there. A bar for the bore passes under the thread outside,
/// and a tap has passes of its own.
fn turns_on(job: &Job, side: Side) -> bool {
    matches!(job.tool.body, Body::Insert { .. }) && job.side == side
}

const fn is_pass(motion: &LatheMotion) -> bool {
    matches!(motion.act, LatheAct::Thread { .. })
}

/// How much deeper than all passes before it, from the crests on, the worst pass of a thread goes, radial, mm, and its line.
fn deepest_step(motions: &[&LatheMotion], cut: &ThreadCut) -> Option<(f64, u32)> {
    let (mut known, mut worst) = (0.0_f64, None::<(f64, u32)>);
    for motion in motions.iter().filter(|motion| is_pass(motion)) {
        let Some((from, to)) = motion.from.point().zip(motion.to.point()).filter(|ends| crosses(cut, *ends)) else {
            continue;
        };
        let depth = depth_of(cut, from.radius_mm).max(depth_of(cut, to.radius_mm));
        let step = depth - known;
        known = known.max(depth);
        if step > 0.0 && worst.is_none_or(|(most, _)| step > most) {
            worst = Some((step, motion.line));
        }
    }
    worst
}

/// Whether a motion towards the chuck goes through some of a thread.
fn crosses(cut: &ThreadCut, (from, to): (LathePoint, LathePoint)) -> bool {
    from.z_mm > -cut.ends_z_mm.to_mm() && to.z_mm < -cut.begins_z_mm.to_mm()
}

/// How far a radius is from the crests of a thread towards its roots, mm.
fn depth_of(cut: &ThreadCut, radius: f64) -> f64 {
    let (crest, root) = (cut.crest_radius_mm.to_mm(), cut.root_radius_mm.to_mm());
    (radius - crest) * (root - crest).signum()
}

/// Z at which each pass of a thread starts before it, the speed of the spindle, and its line. What goes on from another pass is
/// no start; nor is a pass whose speed follows its diameter, which a rule of its own tells.
fn starts(motions: &[&LatheMotion], cut: &ThreadCut) -> Vec<(f64, RevsPerMinute, u32)> {
    let mut before: Option<&LatheMotion> = None;
    let mut starts = Vec::new();
    for motion in motions.iter().copied() {
        let goes_on = before.is_some_and(|one| is_pass(one) && one.to == motion.from);
        before = Some(motion);
        let (Some(from), Some(to)) = (motion.from.point(), motion.to.point()) else { continue };
        let near = [from.radius_mm, to.radius_mm].into_iter().any(|radius| depth_of(cut, radius) > 0.0);
        if goes_on || !crosses(cut, (from, to)) || !near || !is_pass(motion) {
            continue;
        }
        if let Some((slow, _)) = turns(motion).filter(|(slow, fast)| slow == fast) {
            starts.push((from.z_mm, slow, motion.line));
        }
    }
    starts
}
