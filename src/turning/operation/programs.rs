//! The programs of an operation: one for each tool of a set-up that follows without another between, as ways or as the
//! roughing cycles of a control.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::turning::contour::{Contour, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::program::{
    self, Allowance, Control, Direction, Feeds, NotWritten, ProgramFile, Roughing, Setting, Speed,
};
use crate::turning::way::{Purpose, Way};
use crate::turning::zones::Feed;
use crate::units::{MillimetresPerMinute, MillimetresPerRev, RevsPerMinute, round_to};

use super::work::{Work, ZoneWork};
use super::{Operation, SideWork};

/// What is written of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Every motion by itself.
    Motions,
    /// The roughing cycle of the control, where one can clear the zone.
    Cycles,
}

/// A program, or why there is none.
#[derive(Clone, Debug)]
pub struct Written {
    /// The set-up.
    pub set_up: u8,
    /// Outside or inside.
    pub side: Side,
    /// The numbers of its zones on that side.
    pub zones: Vec<usize>,
    /// Its tool.
    pub tool: String,
    /// Its files, or the reason.
    pub files: Result<Vec<ProgramFile>, NotWritten>,
}

/// Neighbouring zones of a side with one tool.
struct Run<'a> {
    set_up: u8,
    side: &'a SideWork,
    tool: &'a str,
    place: u32,
    zones: Vec<&'a ZoneWork>,
}

/// The programs of an operation in the order of work; `spindle` is the spindle speed that the user states. Tools have the places of the turret in the order of their first use.
///
/// # Errors
/// There is no such control, or a table lacks something of it.
pub fn programs(
    operation: &Operation,
    control: &str,
    form: Form,
    spindle: Option<RevsPerMinute>,
    knowledge: &Knowledge,
) -> Result<Vec<Written>, KnowledgeError> {
    let control = Control::read(control, knowledge)?;
    let mut written = Vec::new();
    for run in runs(operation) {
        let zones = |zones: &[&ZoneWork]| zones.iter().map(|zone| zone.zone.number).collect::<Vec<_>>();
        let put = |zones: Vec<usize>, files| Written {
            set_up: run.set_up,
            side: run.side.side,
            zones,
            tool: run.tool.to_owned(),
            files,
        };
        match form {
            Form::Motions => written.push(put(zones(&run.zones), motions(&run, operation, &control, spindle))),
            Form::Cycles => {
                for (zone, work) in run.zones.iter().flat_map(|zone| zone.works.iter().map(move |work| (zone, work))) {
                    written.push(put(vec![zone.zone.number], cycle(zone, work, &run, operation, &control, spindle)));
                }
            }
        }
    }
    Ok(written)
}

fn runs(operation: &Operation) -> Vec<Run<'_>> {
    let mut runs: Vec<Run<'_>> = Vec::new();
    let mut places: Vec<&str> = Vec::new();
    for (set_up, side, zone) in operation.zones() {
        let Some(tool) = zone.tool.as_ref().map(|tool| tool.designation.as_str()) else { continue };
        if !zone.is_cleared() {
            continue;
        }
        let place = places.iter().position(|known| *known == tool).unwrap_or_else(|| {
            places.push(tool);
            places.len() - 1
        });
        let number = set_up.set_up.number;
        match runs.last_mut().filter(|run| run.set_up == number && run.tool == tool && run.side.side == side.side) {
            Some(run) => run.zones.push(zone),
            None => {
                let place = u32::try_from(place + 1).unwrap_or(u32::MAX);
                runs.push(Run { set_up: number, side, tool, place, zones: vec![zone] });
            }
        }
    }
    runs
}

/// Every way of a run, from home to home. Between two ways the tool goes from one home to the next, both off the corner of
/// the blank before its free face.
fn motions(
    run: &Run<'_>,
    operation: &Operation,
    control: &Control,
    spindle: Option<RevsPerMinute>,
) -> Result<Vec<ProgramFile>, NotWritten> {
    let works: Vec<&Work> = run.zones.iter().flat_map(|zone| &zone.works).collect();
    let mut whole: Option<Way> = None;
    for way in works.iter().filter_map(|work| work.transition()).map(|transition| &transition.way) {
        match &mut whole {
            None => whole = Some(way.clone()),
            Some(whole) => {
                for corner in over(whole.end(), way.from, run.side.side) {
                    whole.go(corner, Purpose::Rapid);
                }
                whole.moves.extend(way.moves.iter().copied());
            }
        }
    }
    let way = whole.unwrap_or_default();
    let setting = setting(run, operation, works.first().copied(), spindle)?;
    let text = program::plain(control, &way, &setting)?;
    Ok(vec![ProgramFile { name: format!("{}.ngc", run.place), text }])
}

/// The way from a home to the next: first away from the axis and from the metal, of a bore first out of it.
fn over(from: Point, to: Point, side: Side) -> [Point; 2] {
    let z = from.z.min(to.z);
    let radius = match side {
        Side::Outer => from.radius.max(to.radius),
        Side::Inner => from.radius.min(to.radius),
    };
    [Point { radius, z: if side == Side::Inner { z } else { from.z } }, Point { radius, z: to.z }]
}

/// What is cleared by one scheme, as the cycle of the control over its rough contour.
fn cycle(
    zone: &ZoneWork,
    work: &Work,
    run: &Run<'_>,
    operation: &Operation,
    control: &Control,
    spindle: Option<RevsPerMinute>,
) -> Result<Vec<ProgramFile>, NotWritten> {
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
    let setting = setting(run, operation, Some(work), spindle)?;
    let written = program::cycle(control, &work.stock.rough, corner(&work.stock.blank), roughing, &setting)?;
    Ok(written.files)
}

/// The corner of a blank before its free face: its greatest radius, of a bore its least.
fn corner(blank: &Contour) -> Point {
    let (least, most) = blank.radii().unwrap_or_default();
    let z = blank.start().map_or(Half::ZERO, |start| start.z);
    Point { radius: if blank.side == Side::Outer { most } else { least }, z }
}

/// Speeds and feeds of a run: the spindle step of the conditions, or the speed that the user states; without either there
/// is no program, because feeds are written for a revolution.
fn setting(
    run: &Run<'_>,
    operation: &Operation,
    work: Option<&Work>,
    spindle: Option<RevsPerMinute>,
) -> Result<Setting, NotWritten> {
    let pace = work.map(|work| &work.pace).ok_or(NotWritten::NoSpeed)?;
    let found = pace.conditions.as_ref().map(|found| found.spindle_rpm);
    let rpm = spindle.or(found).ok_or(NotWritten::NoSpeed)?;
    let per_rev = |rate: MillimetresPerMinute| MillimetresPerRev(round_to(rate.0 / rpm.0, 4));
    let feeds = Feeds {
        cut: per_rev(pace.feeds.main),
        infeed: per_rev(pace.feeds.infeed),
        pick_up: per_rev(pace.feeds.pick_up),
        semi_finish: per_rev(pace.feeds.semi_finish),
        finish: per_rev(pace.feeds.finish),
        back: per_rev(pace.feeds.infeed),
    };
    let name = operation.workpiece.name.clone();
    Ok(Setting { name, tool: run.place, speed: Speed::Spindle(rpm), feeds, coolant: true })
}
