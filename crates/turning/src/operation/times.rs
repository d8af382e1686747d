//! The times of a set-up: those of its program, and those around it.
//!
//! Cutting and rapids are those of the written motions. The travels to the change position of the turret and back are
//! in none of the figures, because the setter chooses that position.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::tables::lathes::{LatheWorkholding, WorkholdingFigure};
use crate::turning::contour::Piece;
use crate::turning::jobs::Work;
use crate::turning::schemes::rates;
use crate::turning::tooling::{Lathe, Seconds};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{MillimetresPerMinute, Minutes};

use super::programs::{Form, by_id, sections};
use super::turret::{Station, station, stations};
use super::{Operation, SetUpWork};

/// The times of a set-up, min.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Times {
    /// The set-up.
    pub set_up: u8,
    /// At feed, through metal and beside it.
    pub cutting_min: Minutes,
    /// At rapid, along the path of the tool, at one rate.
    pub rapid_min: Minutes,
    /// The number of tool calls.
    pub tool_changes: usize,
    /// All tool changes.
    pub tool_change_min: Minutes,
    /// All starts of the spindle: it stops for each tool change, and twice for each tap, which it reverses.
    pub spindle_start_min: Minutes,
    /// Loading and unloading of the part.
    pub load_min: Minutes,
}

impl Times {
    /// All of it.
    pub fn total(&self) -> Minutes {
        let parts = [self.cutting_min, self.rapid_min, self.tool_change_min, self.spindle_start_min, self.load_min];
        Minutes(parts.iter().map(|part| part.0).sum())
    }
}

/// The times of the set-ups that have work.
///
/// # Errors
/// The knowledge base lacks the lathe of the part, `chuck-and-tailstock` or a row of it.
pub fn times(operation: &Operation, knowledge: &Knowledge) -> Result<Vec<Times>, KnowledgeError> {
    let part = &operation.workpiece;
    let lathe = part.machine.as_deref().map(|id| Lathe::find(knowledge, id)).transpose()?;
    let of = |name| Seconds::of_table(name, knowledge);
    let change = match &lathe {
        Some(lathe) => lathe.tool_change(knowledge)?,
        None => of(WorkholdingFigure::ToolChangeTime)?,
    };
    let (start, load) = (of(WorkholdingFigure::SpindleStartTime)?, of(WorkholdingFigure::LoadTime)?);
    let rapid = match (part.rates, &lathe) {
        (Some(given), _) => given.main.rapid,
        (None, Some(lathe)) => lathe.rapid_z,
        (None, None) => rates::of_table(knowledge)?.0.rapid,
    };
    let stations = stations(operation);
    let worked = operation.set_ups.iter().filter(|set_up| !set_up.jobs.is_empty());
    Ok(worked
        .map(|set_up| {
            let ways = ways(set_up, &stations);
            let tool_changes = 1 + ways.windows(2).filter(|two| two[0].0 != two[1].0).count();
            let each = |time: Seconds| Minutes(time.minutes().0 * tool_changes as f64);
            let taps = set_up.jobs.iter().filter(|job| job.work == Work::Tap).count();
            let reversals = Minutes(start.minutes().0 * 2.0 * taps as f64);
            Times {
                set_up: set_up.set_up.number,
                cutting_min: cutting(set_up),
                rapid_min: Minutes(rapids(&ways) / rapid.0),
                tool_changes,
                tool_change_min: each(change),
                spindle_start_min: Minutes(each(start).0 + reversals.0),
                load_min: load.minutes(),
            }
        })
        .collect())
}

/// The row that has the time of loading.
///
/// # Errors
/// The knowledge base lacks it.
pub fn loading(knowledge: &Knowledge) -> Result<Because, KnowledgeError> {
    let name = WorkholdingFigure::LoadTime;
    let row = knowledge.need(name.name(), |row: &LatheWorkholding<'_>| row.name.is(name))?;
    Ok(Because::row(row.row, Note::new("time-norm")))
}

/// The time at feed: that of the jobs if rapids took none.
fn cutting(set_up: &SetUpWork) -> Minutes {
    let instant = MillimetresPerMinute(f64::INFINITY);
    Minutes(set_up.jobs.iter().map(|job| job.pace.time(&job.path, instant).0).sum())
}

/// The toolpaths by the offsets of the tools, as in a program. If none can be written, those of the jobs.
fn ways(set_up: &SetUpWork, stations: &[Station]) -> Vec<(u32, Toolpath)> {
    match sections(set_up, stations, Form::Motions, None, false, &by_id) {
        Ok(sections) => sections.into_iter().map(|section| (section.tool.offset, section.path)).collect(),
        Err(_) => {
            let of = |job| station(stations, job).map_or(0, |one| one.seat.offset);
            set_up.jobs.iter().map(|job| (of(job), job.path.clone())).collect()
        }
    }
}

/// The length of all rapids, mm; between two paths of one tool it moves straight.
fn rapids(ways: &[(u32, Toolpath)]) -> f64 {
    let own = ways.iter().flat_map(|(_, way)| way.pieces());
    let own = own.filter(|(_, purpose)| *purpose == Purpose::Rapid).map(|(piece, _)| piece.length_mm());
    let same = ways.windows(2).filter(|two| two[0].0 == two[1].0);
    let between = same.map(|two| Piece::line(two[0].1.end(), two[1].1.from).length_mm());
    own.chain(between).sum()
}
