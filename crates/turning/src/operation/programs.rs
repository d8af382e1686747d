//! The programs of an operation: one toolpath program for consecutive works with the same tool, speed and feeds, or
//! one roughing cycle of the control per work.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::turning::contour::{Contour, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::program::{
    self, Allowance, Control, Direction, Feeds, NotWritten, ProgramFile, Roughing, Setting, Speed,
};
use crate::turning::shaft::Holding;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::zones::Feed;
use crate::units::{MillimetresPerMinute, MillimetresPerRev, RevsPerMinute, round_to};

use super::Operation;
use super::unfinished::reaches_axis;
use super::work::{Work, ZoneWork};

/// What is written of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Every motion by itself.
    Motions,
    /// The roughing cycle of the control, if one can clear the zone.
    Cycles,
}

/// A program, or why there is none.
#[derive(Clone, Debug)]
pub struct OperationProgram {
    /// The set-up.
    pub set_up: u8,
    /// Outside or inside.
    pub side: Side,
    /// The numbers of its zones on that side.
    pub zones: Vec<usize>,
    /// Its works in order: the number of the zone, and the index of the work in it.
    pub works: Vec<(usize, usize)>,
    /// Its tool.
    pub tool: String,
    /// Its files, or the reason.
    pub files: Result<Vec<ProgramFile>, NotWritten>,
}

/// Consecutive works with one tool, speed and feeds.
struct ToolRun<'a> {
    set_up: u8,
    side: Side,
    tool: &'a str,
    place: u32,
    setting: Result<Setting, NotWritten>,
    works: Vec<(&'a ZoneWork, &'a Work)>,
}

/// The programs of an operation in the order of work; `spindle` is the spindle speed that the user states. Tools are
/// numbered on the turret in the order of their first use.
///
/// # Errors There is no such control, or a table lacks something of it.
pub fn programs(
    operation: &Operation,
    control: &str,
    form: Form,
    spindle: Option<RevsPerMinute>,
    knowledge: &Knowledge,
) -> Result<Vec<OperationProgram>, KnowledgeError> {
    let control = Control::read(control, knowledge)?;
    let runs = runs(operation, spindle, form);
    let between_centres = operation.workpiece.holding == Holding::Centres;
    Ok(runs.into_iter().map(|run| written(run, form, &control, between_centres)).collect())
}

fn written(run: ToolRun<'_>, form: Form, control: &Control, between_centres: bool) -> OperationProgram {
    let mut zones: Vec<usize> = run.works.iter().map(|(zone, _)| zone.zone.number).collect();
    zones.dedup();
    let place = |(zone, work): &(&ZoneWork, &Work)| {
        let place = zone.works.iter().position(|one| std::ptr::eq(one, *work));
        (zone.zone.number, place.unwrap_or_default())
    };
    let works = run.works.iter().map(place).collect();
    let (set_up, side, tool) = (run.set_up, run.side, run.tool.to_owned());
    let paths = run.works.iter().filter_map(|(_, work)| work.transition()).map(|transition| &transition.path);
    let hits_centre = between_centres && run.side == Side::Outer && paths.into_iter().any(reaches_axis);
    let setting = if hits_centre { Err(NotWritten::ThroughCentre) } else { run.setting.clone() };
    let files = setting.and_then(|setting| match form {
        Form::Motions => motions(&run, &setting, control),
        Form::Cycles => cycles(&run, &setting, control),
    });
    OperationProgram { set_up, side, zones, works, tool, files }
}

/// The runs of an operation; a cycle is a run of its own.
fn runs(operation: &Operation, spindle: Option<RevsPerMinute>, form: Form) -> Vec<ToolRun<'_>> {
    let mut runs: Vec<ToolRun<'_>> = Vec::new();
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
        let place = u32::try_from(place + 1).unwrap_or(u32::MAX);
        let number = set_up.set_up.number;
        for work in &zone.works {
            let setting = setting(place, operation, work, spindle);
            let same = |run: &&mut ToolRun<'_>| {
                let here = run.set_up == number && run.tool == tool && run.side == side.side;
                here && run.setting == setting && form == Form::Motions
            };
            match runs.last_mut().filter(same) {
                Some(run) => run.works.push((zone, work)),
                None => {
                    let works = vec![(zone, work)];
                    runs.push(ToolRun { set_up: number, side: side.side, tool, place, setting, works });
                }
            }
        }
    }
    runs
}

/// All toolpaths of a run as one, from home to home. Each home is off the corner of the blank before its free face, and
/// the tool goes from one to the next.
fn motions(run: &ToolRun<'_>, setting: &Setting, control: &Control) -> Result<Vec<ProgramFile>, NotWritten> {
    let mut whole: Option<Toolpath> = None;
    for path in run.works.iter().filter_map(|(_, work)| work.transition()).map(|transition| &transition.path) {
        match &mut whole {
            None => whole = Some(path.clone()),
            Some(whole) => {
                for corner in over(whole.end(), path.from, run.side) {
                    whole.go(corner, Purpose::Rapid);
                }
                whole.moves.extend(path.moves.iter().copied());
            }
        }
    }
    let text = program::plain(control, &whole.unwrap_or_default(), setting)?;
    Ok(vec![ProgramFile { name: format!("{}.ngc", run.place), text }])
}

/// From one home to the next: first away from the axis and the metal; from a bore first out of it.
fn over(from: Point, to: Point, side: Side) -> [Point; 2] {
    let z = from.z.min(to.z);
    let radius = match side {
        Side::Outer => from.radius.max(to.radius),
        Side::Inner => from.radius.min(to.radius),
    };
    [Point { radius, z: if side == Side::Inner { z } else { from.z } }, Point { radius, z: to.z }]
}

/// Each work as the cycle of the control over its rough contour.
fn cycles(run: &ToolRun<'_>, setting: &Setting, control: &Control) -> Result<Vec<ProgramFile>, NotWritten> {
    let mut files = Vec::new();
    for (zone, work) in &run.works {
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
        let corner = corner(&work.stock.blank);
        files.extend(program::cycle(control, &work.stock.rough, corner, roughing, setting)?.files);
    }
    Ok(files)
}

/// The corner of a blank before its free face: at its greatest radius, for a bore at its least.
fn corner(blank: &Contour) -> Point {
    let (least, most) = blank.radii().unwrap_or_default();
    let z = blank.start().map_or(Half::ZERO, |start| start.z);
    Point { radius: if blank.side == Side::Outer { most } else { least }, z }
}

/// Speed and feeds of a work: the spindle step of its conditions, or the speed that the user states. Without either
/// there is no program, because feeds are written per revolution.
fn setting(
    tool: u32,
    operation: &Operation,
    work: &Work,
    spindle: Option<RevsPerMinute>,
) -> Result<Setting, NotWritten> {
    let pace = &work.pace;
    let conditioned = pace.conditions.as_ref().map(|conditioned| conditioned.spindle_rpm);
    let rpm = spindle.or(conditioned).ok_or(NotWritten::NoSpeed)?;
    let per_rev = |rate: MillimetresPerMinute| MillimetresPerRev(round_to(rate.0 / rpm.0, 4));
    let feeds = Feeds {
        cut: per_rev(pace.feeds.main),
        infeed: per_rev(pace.feeds.infeed),
        pick_up: per_rev(pace.feeds.pick_up),
        semi_finish: per_rev(pace.feeds.semi_finish),
        finish: per_rev(pace.feeds.finish),
        back: per_rev(pace.feeds.infeed),
        plunge: per_rev(pace.feeds.infeed),
        thread: per_rev(pace.feeds.infeed),
    };
    let name = operation.workpiece.name.clone();
    Ok(Setting { name, tool, speed: Speed::Spindle(rpm), feeds, coolant: true })
}
