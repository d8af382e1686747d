//! The programs of an operation: one for each set-up, with every job of it, as motions or with the cycles of the control.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Note;
use crate::turning::contour::{Contour, Side};
use crate::turning::jobs::{Job, Pace, Work as JobWork};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::program::{
    self, Allowance, Control, CycleOf, Direction, FreeEnd, NotCycled, NotWritten, ProgramFile, Roughing, Seat,
    SectionCycle, SectionLoad, Speed, ToolSection, WholeProgram,
};
use crate::turning::toolpath::Toolpath;
use crate::turning::zones::Feed;
use crate::units::RevsPerMinute;

use super::grip::thousands;
use super::jobs::per_rev;
use super::turret::{Load, Put, Station, loads, station, stations};
use super::unfinished::reaches_axis;
use super::work::ZoneWork;
use super::{Operation, Regrip, SetUpWork, proof};

/// The form of programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Every motion separately.
    Motions,
    /// The cycles of the control, where one can clear a zone or cut a thread.
    Cycles,
}

/// A program, or why there is none.
#[derive(Clone, Debug)]
pub struct OperationProgram {
    /// The set-up.
    pub set_up: u8,
    /// Its tools in the turret, in the order of work.
    pub seats: Vec<Seat>,
    /// Why threads of it are cut by single passes, although cycles are requested.
    pub remarks: Vec<Note>,
    /// Its files, or the reason.
    pub files: Result<Vec<ProgramFile>, NotWritten>,
}

/// The words of comments in programs.
#[derive(Clone, Copy)]
pub struct Remarks<'a> {
    /// A work.
    pub work: &'a dyn Fn(JobWork) -> String,
    /// A tool that is put into the turret, with the number of its offset.
    pub put: &'a dyn Fn(&Put<'_>, u32) -> String,
    /// What the jaws are set to at a stop.
    pub regrip: &'a dyn Fn(&Regrip) -> String,
    /// Why the passes of a thread are written one by one.
    pub single: &'a dyn Fn(NotCycled) -> String,
}

/// The program of each set-up; `spindle` is the spindle speed that the user states. Comments name works by their ids.
///
/// # Errors
/// There is no such control, or a table lacks something of it.
pub fn programs(
    operation: &Operation,
    control: &str,
    form: Form,
    spindle: Option<RevsPerMinute>,
    knowledge: &Knowledge,
) -> Result<Vec<OperationProgram>, KnowledgeError> {
    let put =
        |put: &Put<'_>, offset: u32| format!("T{}: {}, {offset}", put.station.seat.place, put.station.tool.designation);
    let single = |why: NotCycled| why.name().to_owned();
    let regrip = |regrip: &Regrip| format!("{} kN", thousands(regrip.force));
    let remarks = Remarks { work: &by_id, put: &put, regrip: &regrip, single: &single };
    programs_named(operation, control, form, spindle, remarks, knowledge)
}

/// The same with comments in a language.
///
/// # Errors
/// Those of [`programs`].
pub fn programs_named(
    operation: &Operation,
    control: &str,
    form: Form,
    spindle: Option<RevsPerMinute>,
    remarks: Remarks<'_>,
    knowledge: &Knowledge,
) -> Result<Vec<OperationProgram>, KnowledgeError> {
    let control = Control::read(control, knowledge)?;
    let stations = stations(operation);
    let loads = loads(operation, &stations);
    let written = operation.set_ups.iter().filter(|set_up| !set_up.jobs.is_empty()).map(|set_up| {
        let mut seats: Vec<Seat> =
            set_up.jobs.iter().filter_map(|job| station(&stations, job)).map(|one| one.seat).collect();
        seats.dedup();
        let number = set_up.set_up.number;
        let at_centre = set_up.set_up.centre;
        let end_of_part = if at_centre { FreeEnd::Tailstock } else { FreeEnd::Open };
        let files = if at_centre && set_up.jobs.iter().any(hits_centre) {
            Err(NotWritten::ThroughCentre)
        } else if let Some(why) = proof::rejects(operation, number) {
            Err(NotWritten::Unsafe { why })
        } else {
            let lathe_is_named = operation.workpiece.machine.is_some();
            sections(set_up, &stations, form, spindle, lathe_is_named, remarks.work).and_then(|mut sections| {
                let put = |put: &Put<'_>| (remarks.put)(put, control.offset(put.station.seat));
                stops(&mut sections, set_up, &stations, &loads, put);
                regrips(&mut sections, set_up, &stations, remarks);
                program::whole(&control, &operation.workpiece.name, number, &sections, end_of_part, remarks.single)
            })
        };
        let (files, remarks) = match files {
            Ok(WholeProgram { files, remarks }) => (Ok(files), remarks),
            Err(why) => (Err(why), Vec::new()),
        };
        OperationProgram { set_up: number, seats, remarks, files }
    });
    Ok(written.collect())
}

/// A work by its id.
pub(super) fn by_id(work: JobWork) -> String {
    work.name().to_owned()
}

/// Whether a job goes to the axis, where a tailstock centre would be.
fn hits_centre(job: &Job) -> bool {
    job.side == Side::Outer && reaches_axis(&job.path)
}

/// The jobs of a set-up as sections of its program. Successive jobs with one tool and the same conditions are one.
pub(super) fn sections(
    set_up: &SetUpWork,
    stations: &[Station],
    form: Form,
    spindle: Option<RevsPerMinute>,
    lathe_is_named: bool,
    named: &dyn Fn(JobWork) -> String,
) -> Result<Vec<ToolSection>, NotWritten> {
    let mut sections: Vec<ToolSection> = Vec::new();
    for job in &set_up.jobs {
        let tool = station(stations, job).ok_or(NotWritten::NoTool)?.seat;
        let (speed, feeds) = match job.pace {
            // A tap is not reversed faster than it was planned.
            Pace::PerRev { speed: Speed::Spindle(own), feeds } if job.work == JobWork::Tap => {
                (Speed::Spindle(spindle.map_or(own, |stated| RevsPerMinute(stated.0.min(own.0)))), feeds)
            }
            Pace::PerRev { speed, feeds } => (spindle.map_or(speed, Speed::Spindle), feeds),
            Pace::PerMinute { rates, spindle: known } => {
                // A spindle speed that the user gives does not stand for figures that the named lathe or tool lacks.
                if known.is_none() && lathe_is_named {
                    return Err(NotWritten::NoConditions { tool: tool.place });
                }
                let rpm = spindle.or(known).ok_or(NotWritten::NoSpeed)?;
                (Speed::Spindle(rpm), per_rev(&rates, rpm))
            }
        };
        let thread = || job.thread.clone().map(|cut| SectionCycle::Thread(cut, job.side));
        let cycle = match form {
            Form::Cycles => cycle(set_up, job).map(SectionCycle::Rough).or_else(thread),
            Form::Motions => None,
        };
        let title = title(tool, job, named);
        let one = |last: &&mut ToolSection| {
            last.tool == tool
                && last.speed == speed
                && last.feeds == feeds
                && last.coolant != job.dry
                && last.cycle.is_none()
                && cycle.is_none()
                && last.title == title
        };
        match sections.last_mut().filter(one) {
            Some(last) => join(&mut last.path, &job.path, job.side),
            None => {
                let (path, taps) = (job.path.clone(), job.work == JobWork::Tap);
                sections.push(ToolSection {
                    tool,
                    load: None,
                    title,
                    speed,
                    feeds,
                    coolant: !job.dry,
                    path,
                    cycle,
                    taps,
                });
            }
        }
    }
    Ok(sections)
}

/// Puts what the operator loads before the section of the first tool of each load.
fn stops(
    sections: &mut [ToolSection],
    set_up: &SetUpWork,
    stations: &[Station],
    loads: &[Load<'_>],
    said: impl Fn(&Put<'_>) -> String,
) {
    let mut from = 0;
    for load in loads.iter().filter(|load| load.set_up == set_up.set_up.number) {
        let Some(tool) = set_up.jobs.get(load.before).and_then(|job| station(stations, job)) else { continue };
        let Some(at) = sections.iter().skip(from).position(|section| section.tool == tool.seat) else { continue };
        if let Some(section) = sections.get_mut(from + at) {
            let remarks = load.tools.iter().map(&said).collect();
            section.load = Some(SectionLoad { remarks, stops: load.before > 0 });
        }
        from += at + 1;
    }
}

/// The comment for a job with its tool.
fn title(tool: Seat, job: &Job, named: &dyn Fn(JobWork) -> String) -> String {
    format!("T{} {}, {}", tool.place, job.tool.designation, named(job.work))
}

/// Stops before the sections for which the jaws are loosened or tightened. Each begins a kind of work with another tool.
fn regrips(sections: &mut [ToolSection], set_up: &SetUpWork, stations: &[Station], remarks: Remarks<'_>) {
    for regrip in set_up.grip.iter().flat_map(|grip| grip.regrips(&set_up.jobs)) {
        let Some(job) = set_up.jobs.get(regrip.before) else { continue };
        let Some(tool) = station(stations, job).map(|one| one.seat) else { continue };
        let title = title(tool, job, remarks.work);
        if let Some(section) = sections.iter_mut().find(|one| one.tool == tool && one.title == title) {
            let load = section.load.get_or_insert_with(|| SectionLoad { remarks: Vec::new(), stops: true });
            load.remarks.push((remarks.regrip)(&regrip));
            load.stops = true;
        }
    }
}

/// Appends a path to another, from home point to home point.
fn join(whole: &mut Toolpath, path: &Toolpath, side: Side) {
    for corner in over(whole.end(), path.from, side) {
        whole.go(corner, crate::turning::toolpath::Purpose::Rapid);
    }
    whole.moves.extend(path.moves.iter().copied());
}

/// From one home point to the next: first away from the axis and the metal; from a bore first out of it.
fn over(from: Point, to: Point, side: Side) -> [Point; 2] {
    let z = from.z.min(to.z);
    let radius = match side {
        Side::Outer => from.radius.max(to.radius),
        Side::Inner => from.radius.min(to.radius),
    };
    [Point { radius, z: if side == Side::Inner { z } else { from.z } }, Point { radius, z: to.z }]
}

/// A rough job as the cycle of a control over its rough contour.
fn cycle(set_up: &SetUpWork, job: &Job) -> Option<CycleOf> {
    let (number, index) = job.zone?;
    let side = set_up.sides.iter().find(|side| side.side == job.side)?;
    let is_it = |zone: &&ZoneWork| zone.zone.number == number && zone.tool.as_ref().is_some();
    let zone = side.zones.iter().find(is_it)?;
    let work = zone.works.get(index)?;
    let roughing = Roughing {
        direction: match zone.zone.feed {
            Feed::Along => Direction::Longitudinal,
            Feed::Across => Direction::Facing,
        },
        depth: work.levels.depth,
        clearance: work.pace.approach_mm,
        retract: work.pace.retract_mm.min(work.pace.approach_mm),
        allowance: Allowance { radius: Half::ZERO, z: Half::ZERO },
    };
    Some(CycleOf { rough: work.stock.rough.clone(), corner: corner(&work.stock.blank), roughing })
}

/// The corner of a blank before its free face: at its greatest radius, for a bore at its least.
fn corner(blank: &Contour) -> Point {
    let (least, most) = blank.radii().unwrap_or_default();
    let z = blank.start().map_or(Half::ZERO, |start| start.z);
    Point { radius: if blank.side == Side::Outer { most } else { least }, z }
}
