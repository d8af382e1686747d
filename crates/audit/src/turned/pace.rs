//! Whether the tools of a lathe program cut as they are meant to: which way the spindle turns, how fast, at what feed, with what power.

use std::f64::consts::PI;

use crate::error::{KnowledgeError, Refusal};
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::{Operation as Cutting, ToolMaterial};
use crate::motion::Turning;
use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheAct, LatheMotion, LatheRun, LatheSpeed};
use crate::tables::audit::{AuditLathePaceFor, PaceFigure};
use crate::tables::cutting::BoringForceFor;
use crate::tables::practice::RoughOrFinish;
use crate::tables::turning::jobs::ThreadingSpeedFor;
use crate::turning::contour::Side;
use crate::turning::cutting::deepest_edge;
use crate::turning::jobs::{Body, Job, Work};
use crate::turning::length::Half;
use crate::turning::operation::{Operation, SetUpWork};
use crate::turning::tooling::{Hand, Lathe, ToolKind, TurningTool};
use crate::units::{Micrometres, round_to};
use technolog_core::material::Material;
use technolog_core::practice_speed::PracticeSpeed;
use technolog_cutting::figures::{self, Asking};
use technolog_turning_proof::{Block, Cuts};

use super::borne::{Borne, borne};
use super::calls::CalledTool;
use super::fault;
use super::lathe::{per_turn, turns};

/// What of the pace of a program spoils its tools, for each tool and kind once, at the worst place. A tool that the text does not
/// name is not known well enough to be wrong.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn paced(
    operation: &Operation,
    work: &SetUpWork,
    run: &LatheRun,
    tools: &[CalledTool],
    chips: &Cuts,
    knowledge: &Knowledge,
) -> Result<Vec<Fault>, KnowledgeError> {
    let part = &operation.workpiece;
    let material = Material::find(knowledge, &part.material)?;
    let material = match part.material_state {
        Some(state) => material.in_state(state, knowledge)?,
        None => material,
    };
    let lathe = part.machine.as_deref().map(|id| Lathe::find(knowledge, id)).transpose()?;
    let by_feed = force_by_feed(&material, knowledge)?;
    let largest = part.blank.largest_diameter().to_mm() / 2.0;
    let mut faults = Vec::new();
    for tool in tools {
        let Some(job) = work.jobs.get(tool.job) else { continue };
        let same: Vec<&Job> = work.jobs.iter().filter(|one| one.tool.designation == job.tool.designation).collect();
        let cuts: Vec<&LatheMotion> =
            run.motions.iter().filter(|one| one.act.cuts() && one.modes.tool == Some(tool.called)).collect();
        let least = if tool.is_named { Severity::Error } else { Severity::Doubtful };
        let mut tell = |code, severity: Severity, line, note: Note| {
            let note = note.with("tool", &*job.tool.designation);
            faults.push(fault(code, severity.max(least), note, line));
        };
        // A tap is turned out of its hole backwards.
        let comes_in = |one: &LatheMotion| one.from.z_mm.zip(one.to.z_mm).is_none_or(|(from, to)| to < from);
        let is_tap = job.work == Work::Tap;
        let backwards =
            |one: &&&LatheMotion| one.modes.turning == Turning::Counterclockwise && (!is_tap || comes_in(one));
        if let Some(motion) = cuts.iter().find(backwards).filter(|_| is_right_hand(&job.tool.body)) {
            tell("turned-rotation", Severity::Wrong, motion.line, Note::new("turned-rotation"));
        }
        if let Some(line) = torn_out(&cuts).filter(|_| is_tap) {
            tell("turned-tap-torn-out", Severity::Wrong, line, Note::new("turned-tap-torn-out"));
        }
        let worst = |share: &dyn Fn(&LatheMotion) -> Option<f64>| {
            let each = cuts.iter().filter_map(|motion| Some((share(motion)?, motion.line)));
            each.max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let judged = |figure, share| -> Result<Option<Severity>, KnowledgeError> {
            let severity = knowledge.ask(&AuditLathePaceFor { figure, share })?.need("share")?.severity;
            Ok(Some(severity).filter(|one| *one != Severity::Note))
        };
        let face = work.rough_face();
        let axial = diameter_on_axis(job, face);
        let speed =
            |motion: &LatheMotion| speed_of(motion, axial.map_or(largest, |diameter| diameter / 2.0), axial.is_some());
        let practice: Vec<Option<f64>> =
            same.iter().map(|one| highest(one, &material, knowledge)).collect::<Result<_, _>>()?;
        let practice = practice.into_iter().flatten().max_by(f64::total_cmp);
        if let (Some(high), Some((used, line))) = (practice, worst(&speed))
            && let Some(severity) = judged(PaceFigure::Speed, used / high)?
        {
            let note = Note::new("turned-speed").with("speed", round_to(used, 0)).with("high", round_to(high, 0));
            tell("turned-speed", severity, line, note);
        }
        // The limit of the spindle hides a cutting speed that is a slip, and no finding of the cut itself tells it.
        let stated = |motion: &LatheMotion| match motion.modes.speed {
            Some(LatheSpeed::Cutting { speed, .. }) => Some(speed.0),
            _ => None,
        };
        if let (Some(high), Some((used, line))) = (practice, worst(&stated))
            && judged(PaceFigure::Speed, used / high)?.is_some()
            && worst(&speed).map_or(Ok(None), |(cut, _)| judged(PaceFigure::Speed, cut / high))?.is_none()
        {
            let note = Note::new("turned-speed-stated").with("speed", round_to(used, 0));
            tell("turned-speed-stated", Severity::Doubtful, line, note.with("high", round_to(high, 0)));
        }
        let fastest = lathe.as_ref().map_or(f64::INFINITY, |lathe| lathe.spindle.ends().1.0);
        let quickest = cuts.iter().filter_map(|motion| Some((speed(motion)?, turns(motion)?.0, motion.line)));
        let quickest = quickest.max_by(|one, other| one.0.total_cmp(&other.0));
        if let (Some(high), Some((used, rpm, line))) = (practice, quickest)
            && rpm.0 < 0.9 * fastest
            && let Some(severity) = judged(PaceFigure::Slow, used / high)?
        {
            let note = Note::new("turned-speed-slow").with("speed", round_to(used, 0)).with("high", round_to(high, 0));
            tell("turned-speed-slow", severity, line, note);
        }
        let planned = same.iter().filter_map(|job| largest_feed(job)).max_by(f64::total_cmp);
        let feed = |motion: &LatheMotion| match motion.act {
            LatheAct::Thread { .. } => None,
            _ => per_turn(motion, turns(motion)?.0).filter(|feed| feed.is_finite()),
        };
        // The feed of a tap is its pitch, which the proof holds.
        let planned = planned.filter(|_| !is_tap);
        let in_metal = |motion: &LatheMotion| {
            usize::try_from(motion.line).is_ok_and(|line| chips.blocks.contains(&Block(line))).then(|| feed(motion))?
        };
        if let (Some(planned), Some((used, line))) = (planned, worst(&in_metal)) {
            let smaller = |other: &CalledTool| {
                let other = work.jobs.get(other.job).filter(|other| matches!(other.tool.body, Body::Drill { .. }));
                other.is_some_and(|other| other.tool.diameter() < job.tool.diameter())
            };
            let by_tool = borne(job, tools.iter().any(smaller), used, &material, knowledge)?;
            let by_plan = Borne::of(PaceFigure::Feed, "turned-feed", used, planned);
            let by_plan = by_plan.with("planned", round_to(planned, 3));
            let mut worst: Option<(Severity, Borne)> = None;
            for borne in by_tool.into_iter().chain([by_plan]) {
                let severity = judged(borne.figure, borne.share)?;
                if let Some(severity) = severity.filter(|one| worst.as_ref().is_none_or(|(known, _)| one < known)) {
                    worst = Some((severity, borne));
                }
            }
            if let Some((severity, borne)) = worst {
                tell(borne.code, severity, line, borne.note);
            }
        }
        // The tool of the plan, by name: one that a remark does not name may be another.
        let edge = TurningTool::find(knowledge, &job.tool.designation)?;
        let edge = edge.map(|tool| deepest_edge(&tool, knowledge)).transpose()?.flatten();
        if let (Some(most), Some((depth, block))) = (edge, chips.depths.get(&tool.job))
            && let Some(severity) = judged(PaceFigure::Depth, depth.0 / most.to_mm())?
        {
            let note =
                Note::new("turned-depth").with("depth", round_to(depth.0, 1)).with("most", round_to(most.to_mm(), 1));
            tell("turned-depth", severity, u32::try_from(block.0).unwrap_or(u32::MAX), note);
        }
        // N ~ V·f^y at the depth of the plan.
        let load = |motion: &LatheMotion| {
            let conditions = same.iter().filter_map(|job| job.conditions.as_ref());
            let (speed, feed, by_feed) = (speed(motion)?, feed(motion)?, by_feed?);
            let power = |one: &crate::turning::cutting::TurningConditions| {
                let share = speed / one.speed_m_per_min.0;
                Some(one.power_kw?.0 * share * libm::pow(feed / one.feed_mm_per_rev.0, by_feed))
            };
            conditions.filter_map(power).min_by(f64::total_cmp)
        };
        if let (Some(lathe), Some((used, line))) = (&lathe, worst(&load))
            && used > lathe.power.0
        {
            let note = Note::new("turned-power").with("power", round_to(used, 1)).with("limit", lathe.power.0);
            tell("turned-power", Severity::Doubtful, line, note.with("lathe", lathe.id()));
        }
    }
    Ok(faults)
}

/// The exponent of the feed in the cutting force, with the stand-ins of the plan; none where no table has the material.
fn force_by_feed<'k>(material: &Material<'k>, knowledge: &'k Knowledge) -> Result<Option<f64>, KnowledgeError> {
    struct Turned<'m, 'k>(&'m Material<'k>, &'k Knowledge);
    impl<'k> Asking<'k> for Turned<'_, 'k> {
        fn knowledge(&self) -> &'k Knowledge {
            self.1
        }
        fn material(&self) -> &Material<'k> {
            self.0
        }
    }
    let question = |material_group| BoringForceFor { material_group, tool_material: ToolMaterial::Carbide };
    let found = Refusal::split(figures::ask(question, &Turned(material, knowledge)))?;
    Ok(found.ok().map(|figures| figures.row.y))
}

/// The line where a tap goes out of the part while the spindle turns as it did on the way in, or stands.
fn torn_out(cuts: &[&LatheMotion]) -> Option<u32> {
    let mut inwards = None;
    for motion in cuts {
        let (Some(from), Some(to)) = (motion.from.z_mm, motion.to.z_mm) else { continue };
        if to < from {
            inwards = Some(motion.modes.turning);
        } else if to > from && from < 0.0 && inwards.is_some_and(|inwards| motion.modes.turning != inwards.reversed()) {
            return Some(motion.line);
        }
    }
    None
}

/// Whether a tool cuts only while the spindle turns with M3: what works on the axis, and a right-hand insert, which leads
/// towards the chuck whether it stands before the axis or, upside down, behind it.
const fn is_right_hand(body: &Body) -> bool {
    match body {
        Body::Insert { hand, .. } => matches!(hand, Hand::R),
        _ => true,
    }
}

/// The largest diameter that a tool on the axis cuts in our plan, mm; none of an insert.
fn diameter_on_axis(job: &Job, face: Half) -> Option<f64> {
    match job.tool.body {
        Body::Insert { .. } => None,
        Body::CentreDrill { pilot_mm, .. } => Some(job.spot_diameter(face).unwrap_or(pilot_mm).to_mm()),
        // A countersink is wider than the mouth that it makes.
        Body::Reamer { diameter_mm, front_mm, lead_mm, .. } => {
            let deepest = job.path.moves.iter().map(|one| one.to.z).max()?;
            let share = (deepest - face).to_mm() / lead_mm.to_mm();
            Some(front_mm.to_mm() + (diameter_mm - front_mm).to_mm() * share.clamp(0.0, 1.0))
        }
        Body::Drill { diameter_mm, .. } | Body::Tap { diameter_mm, .. } => Some(diameter_mm.to_mm()),
    }
}

/// The highest cutting speed of a motion, m/min, no farther from the axis than `farthest`, mm: there a tool on the axis cuts, and
/// there the blank ends.
fn speed_of(motion: &LatheMotion, farthest: f64, is_on_axis: bool) -> Option<f64> {
    let reached = motion.from.radius_mm?.abs().max(motion.to.radius_mm?.abs());
    let radius = if is_on_axis { farthest } else { reached.min(farthest) };
    let (slow, _) = turns(motion)?;
    Some(2.0 * PI * radius * slow.0 / 1000.0)
}

/// The upper end of the speeds of practice for a job, m/min; none where the tables have no figure.
fn highest(job: &Job, material: &Material<'_>, knowledge: &Knowledge) -> Result<Option<f64>, KnowledgeError> {
    let on_axis = |operation| PracticeSpeed::of(operation, ToolMaterial::HighSpeedSteel, material, knowledge);
    let practice = match job.tool.body {
        Body::Drill { .. } => on_axis(Cutting::Drill)?,
        Body::CentreDrill { .. } => on_axis(Cutting::CentreDrill)?,
        Body::Tap { .. } => on_axis(Cutting::Tap)?,
        Body::Reamer { .. } => on_axis(match job.work {
            Work::CoreDrill => Cutting::CoreDrill,
            Work::Countersink => Cutting::Countersink,
            _ => Cutting::FinishReam,
        })?,
        Body::Insert { kind: ToolKind::Threading, .. } => {
            let asked = knowledge.ask(&ThreadingSpeedFor { material_group: material.group })?.winner()?;
            return Ok(asked.map(|row| row.speed_max.0));
        }
        Body::Insert { kind: ToolKind::Grooving | ToolKind::FaceGrooving, width_mm, .. } => {
            let of = |width: Micrometres| PracticeSpeed::of_grooving(width, material, knowledge);
            width_mm.map(of).transpose()?.flatten()
        }
        Body::Insert { .. } => {
            let pass = if job.work == Work::Finish { RoughOrFinish::Finish } else { RoughOrFinish::Rough };
            PracticeSpeed::of_turning(pass, job.side == Side::Inner, material, knowledge)?
        }
    };
    Ok(practice.map(|practice| practice.high.0))
}

/// The largest feed of a job, mm/rev; none where it is not planned per revolution.
fn largest_feed(job: &Job) -> Option<f64> {
    let feeds = job.pace.feeds()?;
    let cutting = job.path.paced().filter_map(|(_, purpose, own)| own.or_else(|| feeds.of(purpose)));
    cutting.map(|feed| feed.0).max_by(f64::total_cmp)
}
