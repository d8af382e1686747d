//! The jobs of a set-up, in the order of work: faces, holes on the axis, rough zones, the finished contours, what is cut
//! into them.

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::turning::contour::{Contour, Piece, Side, Surface, SurfaceName};
use crate::turning::elements::{Element, steepness};
use crate::turning::jobs::along::{Clearance, along};
use crate::turning::jobs::{Job, JobTool, Pace, Work as JobWork};
use crate::turning::length::Half;
use crate::turning::nose::tightest;
use crate::turning::program::{Feeds, Speed};
use crate::turning::tooling::TurningTool;
use crate::turning::zones::fit::reaches;
use crate::turning::zones::{Feed, Needs, SetUp, TurnedSide};
use crate::units::{Degrees, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute, Roughness, round_to};

use super::SideWork;
use super::depth::{self, Task};
use super::tools::{self, Bench};
use super::work::{Work, ZoneWork};
use crate::turning::cutting::Direction;

/// The jobs of a set-up.
///
/// # Errors The knowledge base lacks a table.
pub(super) fn jobs(
    set_up: &SetUp,
    sides: &[SideWork],
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Job>, KnowledgeError> {
    let mut jobs = Vec::new();
    for side in sides {
        for zone in &side.zones {
            for (index, work) in zone.works.iter().enumerate() {
                jobs.extend(rough(side, zone, index, work, bench)?);
            }
        }
    }
    for side in sides {
        jobs.extend(finish(set_up, side, bench, findings)?);
    }
    jobs.sort_by_key(|job| order(job.work));
    Ok(jobs)
}

/// The place of a kind of work in the order of a set-up. Within it the outside comes before the bore.
const fn order(work: JobWork) -> u8 {
    match work {
        JobWork::Face => 0,
        JobWork::Centre => 1,
        JobWork::Drill => 2,
        JobWork::Rough => 3,
        JobWork::Finish => 4,
        JobWork::Groove => 5,
        JobWork::Thread => 6,
        JobWork::PartOff => 7,
    }
}

/// A part of a zone as the taken scheme clears it; none if nothing clears it, which is a finding elsewhere.
fn rough(
    side: &SideWork,
    zone: &ZoneWork,
    index: usize,
    work: &Work,
    bench: &Bench<'_, '_>,
) -> Result<Option<Job>, KnowledgeError> {
    let chosen = zone.tool.as_ref().filter(|_| zone.is_cleared());
    let (Some(transition), Some(chosen)) = (work.transition(), chosen) else { return Ok(None) };
    let Some(tool) = TurningTool::find(bench.knowledge, &chosen.designation)? else { return Ok(None) };
    let pace = pace_of(&work.pace, bench);
    let path = transition.path.clone();
    Ok(Some(Job {
        work: if zone.zone.feed == Feed::Across { JobWork::Face } else { JobWork::Rough },
        side: side.side,
        tool: JobTool::of(&tool),
        surfaces: Vec::new(),
        time_min: pace.time(&path, work.pace.feeds.rapid),
        path,
        conditions: work.pace.conditions.clone(),
        pace,
        thread: None,
        zone: Some((zone.zone.number, index)),
        notes: Vec::new(),
        because: vec![chosen.because.clone(), transition.because.clone()],
    }))
}

/// The pace of a job by the pace of its passes: the spindle step of its conditions with feeds per revolution, or rates
/// where the file states them or nothing else is known.
fn pace_of(pace: &depth::Pace, bench: &Bench<'_, '_>) -> Pace {
    let rates = pace.feeds;
    let rpm = pace.conditions.as_ref().map(|conditions| conditions.spindle_rpm);
    match rpm.filter(|_| bench.workpiece.rates.is_none()) {
        Some(rpm) => Pace::PerRev { speed: Speed::Spindle(rpm), feeds: per_rev(&rates, rpm) },
        None => Pace::PerMinute { rates, spindle: rpm },
    }
}

/// Rates at a spindle speed, per revolution.
pub(super) fn per_rev(rates: &crate::turning::transitions::Feeds, rpm: RevsPerMinute) -> Feeds {
    let feed = |rate: MillimetresPerMinute| MillimetresPerRev(round_to(rate.0 / rpm.0, 4));
    Feeds {
        cut: feed(rates.main),
        infeed: feed(rates.infeed),
        pick_up: feed(rates.pick_up),
        semi_finish: feed(rates.semi_finish),
        finish: feed(rates.finish),
        back: feed(rates.infeed),
        plunge: feed(rates.infeed),
        thread: feed(rates.infeed),
    }
}

/// The finishing pass along the main contour of a side; none where nothing is to be finished, or where roughing left
/// stock in the way.
fn finish(
    set_up: &SetUp,
    side: &SideWork,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Job>, KnowledgeError> {
    let stretch = match side.side {
        Side::Outer => set_up.outer.as_ref(),
        Side::Inner => set_up.inner.as_ref(),
    };
    let (contour, standing) = (&side.layers.left, &side.layers.rough);
    if contour == standing || !side.zones.iter().all(ZoneWork::is_cleared) {
        return Ok(None);
    }
    let needs = needs(contour);
    let passage = (side.side == Side::Inner).then(|| contour.radii().map(|(least, _)| least.diameter())).flatten();
    let mut candidates = tools::candidates(side.side, bench)?;
    candidates.retain(|tool| reaches(needs, passage, &tools::angles(tool)));
    // A nose that fits into the hollows comes before one that leaves metal in them.
    let tight = tightest(contour);
    let fits = |tool: &&TurningTool<'_>| tight.is_none_or(|tight| tools::nose(tool).radius <= tight);
    let smallest = || candidates.iter().min_by_key(|tool| tools::nose(tool).radius);
    let Some(tool) = candidates.iter().find(fits).or_else(smallest) else {
        let note = Note::new("no-tool-to-finish").with("side", side.side.name());
        let note = note.with("main", needs.main.0).with("secondary", needs.secondary.0);
        findings.push(Finding::of_part(Severity::Wrong, note));
        return Ok(None);
    };
    let nose = tools::nose(tool);
    let seen = nose.seen(contour).and_then(|contour| Ok((contour, nose.seen(standing)?)));
    let (seen, standing) = match seen {
        Ok(seen) => seen,
        Err(error) => {
            let note = Note::new("no-contour-of-nose").with("tool", tool.designation).with("why", error);
            findings.push(Finding::of_part(Severity::Wrong, note));
            return Ok(None);
        }
    };
    let allowance = side.layers.allowances.iter().filter_map(|one| one.allowance_mm).max().unwrap_or_default();
    let main: Vec<&Surface> = stretch.map(main_surfaces).unwrap_or_default();
    let roughness = main.iter().filter_map(|surface| surface.roughness).min();
    let task = Task { tool, diameter: largest(contour), direction: Direction::Longitudinal, stock: allowance };
    let paced = depth::pace(task, allowance, Some(roughness.unwrap_or(UNSAID)), bench, findings)?;
    let mut notes = Vec::new();
    if let Some(tight) = tight.filter(|tight| nose.radius > *tight) {
        notes.push(Note::new("nose-fills-hollow").with("nose", nose.radius).with("hollow", tight));
    }
    if roughness.is_none() {
        notes.push(Note::new("roughness-taken").with("roughness", UNSAID));
    }
    let clearance = Clearance { approach: paced.approach_mm, retract: paced.retract_mm };
    let path = along(&seen, &standing, clearance);
    let mut pace = pace_of(&paced, bench);
    if let Pace::PerRev { feeds, .. } = &mut pace {
        feeds.finish = feeds.cut;
    }
    if let Pace::PerMinute { rates, .. } = &mut pace
        && bench.workpiece.rates.is_none_or(|rates| rates.finishing_feed.is_none())
    {
        rates.finish = rates.main;
    }
    let chosen = tools::chosen(tool, 1, bench)?;
    Ok(Some(Job {
        work: JobWork::Finish,
        side: side.side,
        tool: JobTool::of(tool),
        surfaces: main.iter().map(|surface| surface.name.clone()).collect::<Vec<SurfaceName>>(),
        time_min: pace.time(&path, paced.feeds.rapid),
        path,
        conditions: paced.conditions.clone(),
        pace,
        thread: None,
        zone: None,
        notes,
        because: vec![chosen.because, chosen.because_order],
    }))
}

/// The roughness that finishing is planned for where the drawing gives none: what turning to size leaves without care.
const UNSAID: Roughness = Roughness::from_ra_nanometres(6300);

/// The main elements of a stretch.
fn main_surfaces(stretch: &TurnedSide) -> Vec<&Surface> {
    let both = stretch.profile.surfaces.iter().zip(&stretch.classes);
    both.filter(|(_, class)| class.element == Element::Main).map(|(surface, _)| surface).collect()
}

/// The largest diameter of a contour.
fn largest(contour: &Contour) -> crate::units::Micrometres {
    contour.radii().map_or(Half::ZERO, |(_, most)| most).diameter()
}

/// The angles that a contour asks of a tool that follows it; the face at the free end asks for none.
fn needs(contour: &Contour) -> Needs {
    let outer = |piece: &Piece| match contour.side {
        Side::Outer => *piece,
        Side::Inner => piece.inside_out(Half::ZERO),
    };
    let pieces = contour.pieces.iter().map(outer);
    let rest = pieces.skip_while(|piece| piece.is_face() && piece.to.radius > piece.from.radius);
    let steepest = rest.map(steepness).fold((0.0_f64, 0.0_f64), |most, one| (most.0.max(one.0), most.1.max(one.1)));
    Needs { main: Degrees(steepest.0), secondary: Degrees(steepest.1) }
}
