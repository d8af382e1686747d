//! Metric threads, outside and in a bore, turned pass by pass towards the chuck: right-hand threads with a right-hand
//! tool.
//!
//! Depth: the flanks are cut to the middle of the limits of the pitch diameter (ISO 965-1), for any nose of the insert.
//! From the pitch line to the sharp point of the flanks it is H/2, with H = √3/2 · P; a round tip of radius r ends r before
//! that point. Inserts of full profile have r = H/6 outside and H/12 in a bore. On the basic profile that makes makers'
//! depths: 17/24 H = 0.6134 P below the nominal diameter outside, 2/3 H = 0.5774 P from the minor diameter in a bore.

mod passes;
mod room;

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests;

use crate::error::{Refusal, Tried};
use crate::knowledge::Question;
use crate::note::{Because, Note};
use crate::tables::turning::jobs::{
    JobLimit, ThreadingFirstPassFor, ThreadingInfeedFor, ThreadingPasses, ThreadingSpeedFor,
};
use crate::turning::contour::{Side, Surface, SurfaceName};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::program::{Feeds, Speed};
use crate::turning::tooling::{Hand, Lathe, Place, ToolKind, TurningTool};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::workpiece::{Thread, ThreadLimits, ToleranceRow, longest_run_out, tolerance_rows};
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute};
use technolog_cutting::{rpm_at, speed_at};

use super::limits::Limits;
use super::refused::{NoJob, Operation, no_figure};
use super::site::{self, Site};
use super::{Job, JobTool, Pace, ThreadCut, Work};
use passes::Divided;
pub use passes::{Bounds, Passes};
use room::Room;

/// The height of the triangle of the profile over the pitch, H/P (ISO 68-1).
const TRIANGLE: f64 = 0.866_025_403_784;

/// The job of a thread.
///
/// # Errors
/// No insert has the pitch, nothing is free before or behind the thread, with the inequality that fails; or the
/// knowledge base lacks a table.
pub fn thread(
    site: Site<'_>,
    surface: &Surface,
    thread: &Thread,
    passes: Passes,
    bench: &Bench<'_, '_>,
) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let name = || surface.name.clone();
    let [piece] = surface.pieces.as_slice() else {
        return Err(Refusal::Not(NoJob::ThreadOnNoCylinder { surface: name() }));
    };
    if !piece.is_cylinder() {
        return Err(Refusal::Not(NoJob::ThreadOnNoCylinder { surface: name() }));
    }
    let mut limits = Limits::of(bench.knowledge);
    let side = site.side();
    let tool = insert(site, surface, thread.pitch, piece.to.z, bench)?;
    let crest = thread.crests.as_ref().map_or(piece.from.radius, ThreadLimits::middle_radius);
    let root = root_radius(side, thread, &tool);
    let (slows, run_in) = (limits.ratio(JobLimit::ThreadRunOut)?, limits.ratio(JobLimit::ThreadRunIn)?);
    let least_entry = limits.ratio(JobLimit::ThreadEntry)? * thread.pitch.to_mm();
    let lift = Half::of(limits.length(JobLimit::ThreadLift)?);
    let usual_side = limits.length(JobLimit::ThreadInsertSide)?;
    let finest = limits.ratio(JobLimit::ThreadRunOutGrade)?;
    let away = (outwards(side, crest, lift).to_mm() - root.to_mm()).abs();
    let mut bound = RevsPerMinute(f64::INFINITY);
    let (rpm, mut because, found) = loop {
        let (rpm, because) = spindle(thread.pitch, root.max(crest).diameter(), bound, lathe, bench)?;
        let lost = thread.pitch.to_mm() * rpm.0 / slows;
        let asked = Room {
            thread: *piece,
            root,
            lift,
            entry: Half::from((run_in * lost).max(least_entry)),
            run_out: Half::from(lost),
            side_of_insert: Half::of(tool.insert_side.unwrap_or(usual_side)),
            longest: thread.longest_run_out.unwrap_or_default(),
            finest,
        };
        let found = asked.find(site, surface)?;
        // Where it is pulled out of the thread, X goes as far as it must while Z goes on by the pitch.
        let along = (found.to - piece.to.z).to_mm();
        let rate = if found.pull_out { rpm.0 * thread.pitch.to_mm() * away / along.max(0.001) } else { 0.0 };
        let (_, most) = lathe.feed_x;
        if rate <= most.0 {
            break (rpm, because, found);
        }
        if rpm.0 > bound.0 {
            let rate = MillimetresPerMinute(rate);
            return Err(Refusal::Not(NoJob::PitchTooQuick { pitch: thread.pitch, spindle: rpm, rate, most }));
        }
        // At a lower speed less is lost, too, and the way out may get shorter: asked again.
        bound = RevsPerMinute(rpm.0 * (most.0 / rate).min(0.99));
    };
    if bound.0.is_finite() {
        let note = Note::new("thread-feed-follows").with("most", lathe.feed_x.1.0).with("spindle", rpm.0);
        let row = lathe.row(crate::tables::lathes::LatheQuantity::FeedMaxX)?;
        because.push(Because::row(row, note.with("pitch", thread.pitch)));
    }
    because.insert(0, Because::row(tool.row, Note::new("job-tool-taken").with("tool", tool.designation)));
    if let Some(row) = longest_run_out(side, thread.pitch, bench.knowledge).filter(|_| found.pull_out) {
        let note = Note::new("thread-longest-run-out").with("pitch", row.pitch).with("length", row.length);
        because.push(Because::row(row.row, note));
    }
    let Divided { depths, of_cycles, springs, because: of_passes } =
        divided(thread, side, root.max(crest) - root.min(crest), passes, &mut limits, bench)?;
    because.extend(of_passes);
    let group = bench.material.group;
    let infeed = bench.knowledge.ask(&ThreadingInfeedFor { pitch: thread.pitch, material_group: group })?;
    let angle = infeed.need(&thread.pitch.to_string())?.angle;
    because.push(Because::answer(&infeed.answer, Note::new("thread-infeed").with("angle", angle.0)));
    let cut = ThreadCut {
        pitch_mm: thread.pitch,
        from_z_mm: found.from,
        to_z_mm: found.to,
        begins_z_mm: piece.from.z,
        ends_z_mm: piece.to.z,
        pulled_out: found.pull_out,
        return_radius_mm: outwards(side, crest, lift),
        crest_radius_mm: crest,
        root_radius_mm: root,
        depths_mm: with_springs(&depths, springs),
        cycle_depths_mm: with_springs(&of_cycles, springs),
        infeed_angle_deg: angle,
    };
    let path = toolpath(&cut, side, site);
    let (speed, feeds) = (Speed::Spindle(rpm), Feeds::all(MillimetresPerRev(thread.pitch.to_mm())));
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    let mut notes = vec![
        Note::new("thread-passes")
            .with("surface", &surface.name)
            .with("thread", thread.written.as_str())
            .with("tool", tool.designation)
            .with("passes", depths.len())
            .with("springs", springs)
            .with("depth", root.max(crest) - root.min(crest))
            .with("angle", angle.0),
        Note::new("thread-ways")
            .with("surface", &surface.name)
            .with("entry", piece.from.z - found.from)
            .with("run-out", found.to - piece.to.z),
    ];
    if found.pull_out {
        notes.push(Note::new("thread-pulled-out").with("surface", &surface.name).with("length", found.to - piece.to.z));
    }
    notes.extend(crests(side, thread, &surface.name));
    notes.push(flanks(thread, &surface.name));
    because.extend(of_flanks(thread, bench));
    because.extend(limits.because);
    let (surfaces, tool, pace) = (vec![surface.name.clone()], JobTool::of(&tool), Pace::PerRev { speed, feeds });
    let job = Job::of(Work::Thread, side, tool, path, pace, rapid);
    Ok(Job { surfaces, thread: Some(cut), notes, because, ..job })
}

/// An insert for a pitch that works there: of full profile first, because its tip is as round as the root
/// of the profile.
fn insert<'k>(
    site: Site<'_>,
    surface: &Surface,
    pitch: Micrometres,
    end: Half,
    bench: &Bench<'_, 'k>,
) -> Tried<TurningTool<'k>, NoJob> {
    let place = if site.side() == Side::Outer { Place::Outer } else { Place::Inner };
    // The depth for an insert without a nose radius is not known.
    let mut tools = bench.tools(ToolKind::Threading, place)?;
    tools.retain(|tool| tool.hand == Hand::R);
    let ranges = || tools.iter().filter_map(|tool| tool.pitch);
    let bounds = ranges().map(|(least, _)| least).min().zip(ranges().map(|(_, most)| most).max());
    let Some((least, most)) = bounds else {
        return Err(Refusal::Not(NoJob::NoTool { surface: surface.name.clone() }));
    };
    tools.retain(|tool| tool.pitch.is_some_and(|(least, most)| (least..=most).contains(&pitch)));
    tools.sort_by_key(|tool| !is_full(tool));
    let mut why = NoJob::NoPitch { pitch, least, most };
    for tool in tools {
        if site.side() == Side::Inner {
            let bore = site.narrowest(end);
            if let Some(least) = tool.min_bore.filter(|least| bore < *least) {
                why = NoJob::BoreTooSmall { surface: surface.name.clone(), bore, least };
                continue;
            }
            if let Some((reach, _)) = site::bar_reach(&tool, bench)?
                && end > reach
            {
                why = NoJob::BarTooShort { surface: surface.name.clone(), depth: end, reach };
                continue;
            }
        }
        return Ok(tool);
    }
    Err(Refusal::Not(why))
}

/// Whether an insert has a full profile: it is for one pitch only.
fn is_full(tool: &TurningTool<'_>) -> bool {
    tool.pitch.is_some_and(|(least, most)| least == most)
}

/// The radius of the roots: by the pitch diameter in the middle of its limits, or that of the basic profile where these are
/// not known.
fn root_radius(side: Side, thread: &Thread, tool: &TurningTool<'_>) -> Half {
    let triangle = TRIANGLE * thread.pitch.to_mm();
    let pitch_line = pitch_diameter(thread).to_mm() / 2.0;
    let tip = match (is_full(tool), side) {
        (true, Side::Outer) => triangle / 6.0,
        (true, Side::Inner) => triangle / 12.0,
        (false, _) => tool.nose_radius.unwrap_or_default().to_mm(),
    };
    let beyond = triangle / 2.0 - tip;
    Half::from(if side == Side::Outer { pitch_line - beyond } else { pitch_line + beyond })
}

/// The pitch diameter that the passes make.
fn pitch_diameter(thread: &Thread) -> Micrometres {
    thread.flanks.as_ref().map_or_else(|| thread.basic_pitch_diameter(), ThreadLimits::middle)
}

/// The spindle speed of a thread, with the rows behind it: the speed of threading on its largest diameter, as fast as the
/// feed of the lathe follows, and no faster than a bound.
fn spindle(
    pitch: Micrometres,
    diameter: Micrometres,
    bound: RevsPerMinute,
    lathe: &Lathe<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<(RevsPerMinute, Vec<Because>), NoJob> {
    let asked = bench.knowledge.ask(&ThreadingSpeedFor { material_group: bench.material.group })?;
    let Some(speed) = asked.winner()?.map(|row| row.speed) else {
        return Err(no_figure(Operation::Threading, ThreadingSpeedFor::TABLE, bench));
    };
    let (_, most) = lathe.feed_z;
    let follows = RevsPerMinute(most.0 / pitch.to_mm());
    let wanted = rpm_at(speed, diameter);
    let rpm = lathe.spindle.at_most(RevsPerMinute(wanted.0.min(follows.0).min(bound.0)));
    let rate = MillimetresPerMinute(rpm.0 * pitch.to_mm());
    if rate.0 > most.0 {
        return Err(Refusal::Not(NoJob::PitchTooQuick { pitch, spindle: rpm, rate, most }));
    }
    let MetresPerMinute(used) = speed_at(rpm, diameter).rounded(1);
    let note = Note::new("thread-speed").with("wanted", speed.0).with("speed", used).with("spindle", rpm.0);
    let mut because = vec![Because::answer(&asked.answer, note)];
    if follows.0 < wanted.0 {
        let note = Note::new("thread-feed-follows").with("most", most.0).with("spindle", rpm.0).with("pitch", pitch);
        because.push(Because::row(lathe.row(crate::tables::lathes::LatheQuantity::FeedMaxZ)?, note));
    }
    Ok((rpm, because))
}

/// The depths of the passes.
fn divided(
    thread: &Thread,
    side: Side,
    depth: Half,
    passes: Passes,
    limits: &mut Limits<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<Divided, NoJob> {
    let pitch = thread.pitch;
    let rows = bench.knowledge.rows::<ThreadingPasses<'_>>()?;
    // For a pitch between two of the table, the passes of the coarser one.
    let coarser = rows.into_iter().filter(|row| row.side == side && row.pitch >= pitch).min_by_key(|row| row.pitch);
    let Some(row) = coarser else { return Err(Refusal::Not(NoJob::NoPasses { pitch })) };
    let asked = bench.knowledge.ask(&ThreadingFirstPassFor { material_group: bench.material.group })?;
    let first = asked.need(bench.material.group)?;
    let least = Half::of(limits.length(JobLimit::ThreadLastPass)?);
    let springs = limits.ratio(JobLimit::ThreadSpringPasses)?;
    let wanted = usize::try_from(row.passes + first.more).unwrap_or(1).max(1);
    let bounds = Bounds { first: Half::of(first.depth), least, first_share: limits.ratio(JobLimit::ThreadFirstShare)? };
    let depths = passes.depths(depth, wanted, bounds);
    let of_cycles = Passes::Area.depths(depth, wanted, bounds);
    let note = Note::new("threading-passes").with("pitch", row.pitch).with("passes", row.passes);
    let mut because = vec![Because::row(row.row, note)];
    let note = Note::new("threading-first-pass").with("depth", first.depth).with("more", first.more);
    because.push(Because::answer(&asked.answer, note));
    Ok(Divided { depths, of_cycles, springs: springs.round().max(0.0) as usize, because })
}

/// Passes, and then so many more at the last depth.
fn with_springs(depths: &[Half], springs: usize) -> Vec<Half> {
    depths.iter().chain(std::iter::repeat_n(depths.last(), springs).flatten()).copied().collect()
}

/// The toolpath: from before the thread, pass by pass, and back. With an inclined infeed, a shallower pass begins
/// earlier by the remaining travel along the flank.
fn toolpath(cut: &ThreadCut, side: Side, site: Site<'_>) -> Toolpath {
    let above = cut.return_radius_mm;
    let deepest = cut.depths_mm.last().copied().unwrap_or_default();
    let slope = libm::tan(cut.infeed_angle_deg.0.to_radians());
    let start = match side {
        Side::Outer => Point { radius: site.clear.radius, z: cut.from_z_mm },
        Side::Inner => site.clear_before(cut.to_z_mm),
    };
    let mut path = Toolpath::at(start);
    path.go(Point { radius: start.radius, z: cut.from_z_mm }, Purpose::Rapid);
    for depth in &cut.depths_mm {
        let at = outwards(side, cut.crest_radius_mm, Half::ZERO - *depth);
        let before = cut.from_z_mm - Half::from((deepest - *depth).to_mm() * slope);
        path.go(Point { radius: above, z: before }, Purpose::Rapid);
        path.go(Point { radius: at, z: before }, Purpose::Rapid);
        if cut.pulled_out {
            path.go(Point { radius: at, z: cut.ends_z_mm }, Purpose::Thread);
        }
        let at = if cut.pulled_out { above } else { at };
        path.go(Point { radius: at, z: cut.to_z_mm }, Purpose::Thread);
        path.go(Point { radius: above, z: cut.to_z_mm }, Purpose::Rapid);
    }
    path.go(Point { radius: above, z: cut.from_z_mm }, Purpose::Rapid);
    path.go(Point { radius: start.radius, z: cut.from_z_mm }, Purpose::Rapid);
    path.go(start, Purpose::Rapid);
    path
}

/// A radius moved away from the metal.
fn outwards(side: Side, radius: Half, by: Half) -> Half {
    if side == Side::Outer { radius + by } else { radius - by }
}

/// To which pitch diameter the passes go, and between which limits it is measured.
fn flanks(thread: &Thread, surface: &SurfaceName) -> Note {
    let named = |code| {
        let written = thread.written.as_str();
        Note::new(code).with("surface", surface).with("thread", written).with("made", pitch_diameter(thread))
    };
    match &thread.flanks {
        Some(limits) => named("thread-flanks")
            .with("class", limits.class.as_str())
            .with("least", limits.least)
            .with("most", limits.most),
        None => named("thread-flanks-basic"),
    }
}

/// The rows behind the limits of the pitch diameter.
fn of_flanks(thread: &Thread, bench: &Bench<'_, '_>) -> Vec<Because> {
    let Some(limits) = &thread.flanks else { return Vec::new() };
    let told = |row| {
        let (row, code, value) = match row {
            ToleranceRow::Deviation(row) => (row, "thread-deviation", limits.deviation),
            ToleranceRow::Pitch(row) => (row, "thread-tolerance", limits.tolerance()),
        };
        Because::row(row, Note::new(code).with("class", limits.class.as_str()).with("value", value))
    };
    tolerance_rows(thread, bench.knowledge).into_iter().map(told).collect()
}

/// The notes about the crests of an outer thread.
fn crests(side: Side, thread: &Thread, surface: &SurfaceName) -> Option<Note> {
    let named = |code| Note::new(code).with("surface", surface);
    match (side, &thread.crests) {
        (Side::Inner, _) => None,
        (Side::Outer, Some(crests)) => Some(
            named("thread-crests")
                .with("class", crests.class.as_str())
                .with("turned", crests.middle())
                .with("least", crests.least)
                .with("most", crests.most),
        ),
        (Side::Outer, None) => Some(named("thread-crests-nominal").with("thread", thread.written.as_str())),
    }
}
