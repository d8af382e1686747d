//! The jobs of a set-up, in the order of work: faces, holes on the axis, rough zones, the finished contours, and the
//! grooves and threads in them.

use crate::error::{KnowledgeError, Refusal};
use crate::note::Finding;
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::{Piece, Side};
use crate::turning::jobs::hole::{self, Hole, HoleEnd};
use crate::turning::jobs::limits::Limits;
use crate::turning::jobs::{Job, JobTool, Pace, Work as JobWork};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::program::{Feeds, Speed};
use crate::turning::tooling::{Spindle, TurningTool};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::zones::{Feed, SetUp};
use crate::units::{Micrometres, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute, round_to};

use super::depth;
use super::finish::{finish, finish_hollow};
use super::tools::Bench;
use super::work::{Work, ZoneWork};
use super::{Axial, SideWork, features};
use crate::turning::cutting::{GripLimit, TurningConditions};

/// The jobs of a set-up.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn jobs(
    set_up: &SetUp,
    sides: &[SideWork],
    axial: Option<&Axial>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Job>, KnowledgeError> {
    let mut jobs = Vec::new();
    if let Some(axial) = axial {
        jobs.extend(axial.jobs(rough_face(sides), bench, findings)?);
    }
    let there = jobs.iter().filter_map(Job::drills).max().unwrap_or_default();
    for side in sides {
        for zone in &side.zones {
            for (index, work) in zone.works.iter().enumerate() {
                jobs.extend(rough(side.side, zone, Some((zone.zone.number, index)), work, bench)?);
            }
        }
        for zone in side.hollows.iter().flat_map(|hollow| &hollow.zones) {
            for work in &zone.works {
                jobs.extend(rough(side.side, zone, None, work, bench)?);
            }
        }
    }
    for side in sides {
        let drilled = drilled(set_up, side, sides, there, bench, findings)?;
        let own = side.layers.drilled_first.as_ref().is_some_and(|first| first.own);
        if own && !drilled.iter().any(|job| job.work == JobWork::Drill) {
            // No bar enters solid metal; the findings say why there is no hole, and which surfaces of the bore are
            // not made.
            jobs.retain(|job| job.side != side.side);
            continue;
        }
        jobs.extend(drilled);
        jobs.extend(finish(set_up, side, bench, findings)?);
        for hollow in &side.hollows {
            if hollow.zones.is_empty() {
                jobs.extend(features::hollow(set_up, side, hollow, bench, findings)?);
            } else {
                jobs.extend(finish_hollow(set_up, side, hollow, bench, findings)?);
            }
        }
        jobs.extend(features::features(set_up, side, bench, findings)?);
    }
    jobs.sort_by_key(|job| order(job.work));
    Ok(jobs)
}

/// The order of a kind of work in a set-up; for each kind the outside comes before the bore.
const fn order(work: JobWork) -> u8 {
    match work {
        JobWork::Face => 0,
        JobWork::Centre => 1,
        JobWork::Drill | JobWork::Flatten | JobWork::CoreDrill => 2,
        JobWork::Rough => 3,
        JobWork::Finish => 4,
        // A reamer follows the bar that makes its mouth true, and the countersink leaves its burr to the reamer.
        JobWork::Countersink => 5,
        JobWork::Ream => 6,
        JobWork::Groove => 7,
        JobWork::Thread | JobWork::Tap => 8,
        JobWork::PartOff => 9,
    }
}

/// Z of the rough face of the free end.
pub(super) fn rough_face(sides: &[SideWork]) -> Half {
    let outside = sides.iter().find(|other| other.side == Side::Outer);
    outside.and_then(|outer| outer.layers.rough.start()).map_or(Half::ZERO, |outer| outer.z)
}

/// The spot and the hole that is drilled before a bore, with its bottom; `there` is the diameter of the hole behind it that is made
/// to size.
fn drilled(
    set_up: &SetUp,
    side: &SideWork,
    sides: &[SideWork],
    there: Micrometres,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Job>, KnowledgeError> {
    let Some(drilled) = side.layers.drilled_first.as_ref().filter(|drilled| drilled.own) else {
        return Ok(Vec::new());
    };
    let face = rough_face(sides);
    let end = match narrower(set_up, drilled.depth_mm, Half::radius_of(drilled.diameter_mm), bench) {
        Some(Half::ZERO) => HoleEnd::Blind(drilled.depth_mm),
        Some(radius) => HoleEnd::Blind(drilled.depth_mm + hole::point_length(radius)),
        None => HoleEnd::Through(bench.through(drilled.depth_mm)),
    };
    let (diameter, from) = (drilled.diameter_mm, there.max(bench.raw_bore()));
    let mut jobs = Vec::new();
    let task = Hole { diameter, from, face, end, surfaces: Vec::new(), exact: false, tapped: false };
    // A bore that widens again towards the far face is drilled through in one go, where a drill reaches.
    let whole = bench.workpiece.inner.as_ref().and_then(|inner| inner.contour().end()).map(|end| end.z);
    let whole = whole.filter(|end| *end == bench.workpiece.length() && !set_up.turned_over && *end > drilled.depth_mm);
    let at_once = match (end, whole) {
        (HoleEnd::Through(_), Some(whole)) => {
            let task = Hole { end: HoleEnd::Through(bench.through(whole)), ..task.clone() };
            Refusal::split(hole::drilling(&task, bench))?.ok()
        }
        _ => None,
    };
    let mut drills = match at_once {
        Some(drills) => drills,
        None => features::made(hole::drilling(&task, bench), findings)?.unwrap_or_default(),
    };
    let first = drills.first().and_then(|drill| drill.tool.diameter()).unwrap_or(diameter);
    if from == Micrometres::ZERO {
        jobs.extend(features::made(hole::spot(first, face, drilled.depth_mm, bench), findings)?);
    }
    let Some(made) = drills.pop() else { return Ok(jobs) };
    jobs.extend(drills);
    let bottom = set_up.side(side.side).and_then(|stretch| stretch.profile.surfaces.last());
    let surfaces = bottom.map(|surface| surface.name.clone()).into_iter().collect();
    let flattened = drilled.flat.then(|| hole::flatten(&made, drilled.depth_mm, face, surfaces, bench));
    jobs.push(made);
    if let Some(flattened) = flattened {
        jobs.extend(features::made(flattened, findings)?);
    }
    Ok(jobs)
}

/// The radius to which a bore narrows within the reach of the point of a drill that ends at a depth; zero at a
/// bottom, none where the drill may come out.
fn narrower(set_up: &SetUp, depth: Half, drill: Half, bench: &Bench<'_, '_>) -> Option<Half> {
    let whole = set_up.sees(&bench.workpiece.inner.as_ref()?.contour(), bench.workpiece.length());
    let end = whole.end()?;
    if end.radius == Half::ZERO && end.z <= depth + drill {
        return Some(Half::ZERO);
    }
    let ahead = whole.pieces.iter().filter(|piece| piece.to.z > depth && piece.from.z < depth + drill);
    let radii =
        ahead.flat_map(|piece| [piece.from, piece.to]).filter(|point| point.z >= depth).map(|point| point.radius);
    radii.min().filter(|least| *least < drill)
}

/// A part of a zone as cleared by the chosen scheme, with its index among the zones of the side; none if no scheme
/// clears it, which is a finding elsewhere.
fn rough(
    side: Side,
    zone: &ZoneWork,
    place: Option<(usize, usize)>,
    work: &Work,
    bench: &Bench<'_, '_>,
) -> Result<Option<Job>, KnowledgeError> {
    let chosen = zone.tool.as_ref().filter(|_| zone.is_cleared());
    let (Some(transition), Some(chosen)) = (work.transition(), chosen) else { return Ok(None) };
    let Some(tool) = TurningTool::find(bench.knowledge, &chosen.designation)? else { return Ok(None) };
    let is_face = zone.zone.feed == Feed::Across;
    let mut pace = pace_of(&work.pace, bench);
    let path = eased(&transition.path, work.levels.depth + work.pace.retract_mm);
    let path = if is_face { off_the_face(&path, work.pace.retract_mm) } else { path };
    // A sliver beside a raw surface that no level takes is left to finishing.
    if path.moves.is_empty() {
        return Ok(None);
    }
    let spread = Limits::of(bench.knowledge).ratio(JobLimit::ConstantSpeedRatio)?;
    if is_face || widest_to_narrowest(&path) >= spread {
        pace = constant_speed(pace, work.pace.conditions.as_ref(), bench);
    }
    let kind = if is_face { JobWork::Face } else { JobWork::Rough };
    Ok(Some(Job {
        conditions: work.pace.conditions.clone(),
        zone: place,
        because: vec![chosen.because.clone(), transition.because.clone()],
        ..Job::of(kind, side, JobTool::of(&tool), path, pace, work.pace.feeds.rapid)
    }))
}

/// A path that leaves a wall at feed by the depth of a pass, and only then at rapid: an inclined edge has left metal
/// in front of its tip.
fn eased(path: &Toolpath, height: Half) -> Toolpath {
    let mut eased = Toolpath::at(path.from);
    let mut along = false;
    for (piece, purpose) in path.pieces() {
        let upright = piece.from.z == piece.to.z && piece.from.radius != piece.to.radius;
        if purpose == Purpose::Rapid && upright && along {
            let out = piece.to.radius > piece.from.radius;
            let far = if out { piece.from.radius + height } else { piece.from.radius - height };
            let radius = if out { far.min(piece.to.radius) } else { far.max(piece.to.radius) };
            eased.go(Point { radius, z: piece.to.z }, Purpose::Return);
        }
        along = purpose != Purpose::Rapid && piece.to.z > piece.from.z;
        eased.follow(Piece { from: eased.end(), ..piece }, purpose);
    }
    eased
}

/// A path over a face that leaves it along the axis before it goes outwards at rapid: back along the face the tip would rub.
fn off_the_face(path: &Toolpath, back: Half) -> Toolpath {
    let mut off = Toolpath::at(path.from);
    let mut cut = false;
    for (piece, purpose) in path.pieces() {
        let upright = piece.from.z == piece.to.z;
        let mut to = piece.to;
        if cut && purpose == Purpose::Rapid && upright && piece.to.radius > piece.from.radius {
            to.z = to.z - back;
            off.go(Point { radius: piece.from.radius, z: to.z }, Purpose::Rapid);
            off.go(to, Purpose::Rapid);
        } else {
            off.follow(Piece { from: off.end(), ..piece }, purpose);
        }
        cut = purpose != Purpose::Rapid && upright;
    }
    off
}

/// The largest diameter that a path works on over the smallest.
fn widest_to_narrowest(path: &Toolpath) -> f64 {
    let worked = path.pieces().filter(|(_, purpose)| *purpose != Purpose::Rapid).map(|(piece, _)| piece.radii());
    let both = worked.reduce(|(least, most), (low, high)| (least.min(low), most.max(high)));
    both.map_or(1.0, |(least, most)| most.to_mm() / least.to_mm().max(0.001))
}

/// The conditions of a job from those of its passes: the spindle step with feeds per revolution, or rates if the file
/// gives them or nothing else is known.
pub(super) fn pace_of(pace: &depth::Pace, bench: &Bench<'_, '_>) -> Pace {
    let rates = pace.feeds;
    let rpm = pace.conditions.as_ref().map(|conditions| conditions.spindle_rpm);
    match rpm.filter(|_| bench.workpiece.rates.is_none()) {
        Some(rpm) => Pace::PerRev { speed: Speed::Spindle(rpm), feeds: per_rev(&rates, rpm) },
        None => Pace::PerMinute { rates, spindle: rpm },
    }
}

/// Conditions with a constant cutting speed, if the diameter changes along the path and the spindle is stepless: a
/// face and a contour are then cut at the same speed everywhere, up to the highest speed of the spindle, and no faster than
/// the drives follow with the feed.
pub(super) fn constant_speed(pace: Pace, conditions: Option<&TurningConditions>, bench: &Bench<'_, '_>) -> Pace {
    let stepless = bench.lathe.and_then(|lathe| match lathe.spindle {
        Spindle::Range { max, .. } => {
            let drive = lathe.feed_x.1.0.min(lathe.feed_z.1.0);
            let fed = pace.feeds().map_or(max.0, |feeds| libm::floor(drive / feeds.fastest().0));
            let held = bench.grip.as_ref().zip(conditions).and_then(|(grip, cut)| held_up_to(grip, cut));
            Some(RevsPerMinute(max.0.min(fed).min(held.map_or(max.0, |rpm| libm::floor(rpm.0)))))
        }
        Spindle::Steps(_) => None,
    });
    match (pace, stepless, conditions) {
        (Pace::PerRev { feeds, .. }, Some(limit), Some(conditions)) => {
            Pace::PerRev { speed: Speed::whole(conditions.speed_m_per_min, limit), feeds }
        }
        (pace, ..) => pace,
    }
}

/// The speed up to which the jaws hold a cut with all of its pull, but not below that at its largest diameter; none where they lose
/// nothing.
fn held_up_to(grip: &GripLimit, cut: &TurningConditions) -> Option<RevsPerMinute> {
    let along = [cut.axial_force_n?, cut.radial_force_n?].into_iter().max_by(|one, other| one.0.total_cmp(&other.0))?;
    grip.held_up_to(cut.torque_n_m?, along, cut.spindle_rpm)
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
