//! The tools that a lathe program calls, and whether they can stand in the turret.

use std::collections::{BTreeMap, BTreeSet};

use technolog_core::ascii::ascii;

use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheAct, LatheRun, LatheTool};
use crate::turning::operation::turret::{Station, station, stations};
use crate::turning::operation::{Operation, SetUpWork};

use super::fault;

/// A tool that a program calls.
#[derive(Clone, Copy, Debug)]
pub(super) struct CalledTool {
    /// Its place and its offset in the program.
    pub called: LatheTool,
    /// The first line that calls it.
    pub line: u32,
    /// The job of the set-up whose tool it is.
    pub job: usize,
    /// Whether the text names it; otherwise it is identified by its place.
    pub is_named: bool,
}

impl CalledTool {
    pub fn taken(self, work: &SetUpWork) -> Fault {
        let tool = work.jobs.get(self.job).map_or("", |job| &job.tool.designation);
        let note = Note::new("turned-tool-taken").with("number", self.called.number).with("tool", tool.to_owned());
        fault("turned-tool-taken", Severity::Note, note, self.line)
    }
}

/// The tools that a program calls and that the set-up has.
pub(super) fn tools(operation: &Operation, work: &SetUpWork, text: &str, run: &LatheRun) -> Vec<CalledTool> {
    let lines: Vec<String> = text.lines().map(plain).collect();
    let stations = stations(operation);
    let mut tools: Vec<CalledTool> = Vec::new();
    for motion in &run.motions {
        let (Some(tool), line) = (motion.modes.tool, motion.line) else { continue };
        if tools.iter().any(|known| known.called == tool) {
            continue;
        }
        // A comment is in the block of the call or before it.
        let at = usize::try_from(line).unwrap_or(usize::MAX);
        let near = [at.checked_sub(2), at.checked_sub(1)].into_iter().flatten().filter_map(|index| lines.get(index));
        let remarks: Vec<&String> = near.collect();
        let names = |index: &usize| {
            let name = work.jobs.get(*index).map_or("", |job| &job.tool.designation);
            // Controls can show only Latin letters.
            let names = [plain(name), plain(&ascii(name))];
            names.iter().any(|name| !name.is_empty() && remarks.iter().any(|remark| remark.contains(name)))
        };
        let length = |index: &usize| work.jobs.get(*index).map_or(0, |job| job.tool.designation.len());
        let named = (0..work.jobs.len()).filter(names).max_by_key(length);
        let of = |fits: &dyn Fn(&Station) -> bool| {
            work.jobs.iter().position(|job| station(&stations, job).is_some_and(fits))
        };
        // Where tools share a place, their offsets may tell them apart.
        let mut seated = stations.iter().filter(|one| is_seated(one, tool));
        let only = seated.next().filter(|_| seated.next().is_none());
        let placed = || of(&|one| Some(one) == only).or_else(|| of(&|one| one.seat.place == tool.number));
        if let Some(job) = named.or_else(placed) {
            tools.push(CalledTool { called: tool, line, job, is_named: named.is_some() });
        }
    }
    tools
}

/// Whether a call means a station: by place and by offset, which controls number for each place or over all places.
fn is_seated(station: &Station, called: LatheTool) -> bool {
    let offsets = [station.seat.offset, station.seat.edge];
    station.seat.place == called.number && called.offset.is_some_and(|offset| offsets.contains(&offset))
}

/// A text for comparing designations: capitals, digits and all other characters but blanks.
fn plain(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_uppercase).collect()
}

/// Tools that nobody can have put in: another one at the same place, with no stop since. A place that the turret of the record
/// does not have is doubtful: turrets of one lathe differ.
pub(super) fn exchanges(operation: &Operation, work: &SetUpWork, run: &LatheRun, tools: &[CalledTool]) -> Vec<Fault> {
    let designation = |tool: &CalledTool| work.jobs.get(tool.job).map_or("", |job| &*job.tool.designation);
    let mut faults = Vec::new();
    let mut standing: BTreeMap<u32, &CalledTool> = BTreeMap::new();
    let mut beyond = BTreeSet::new();
    for motion in &run.motions {
        if motion.act == LatheAct::Stop {
            standing.clear();
        }
        let Some(called) = motion.modes.tool.filter(|_| motion.act.moves()) else { continue };
        let Some(tool) = tools.iter().find(|tool| tool.called == called) else { continue };
        let note = |code| Note::new(code).with("number", called.number);
        if let Some(places) = operation.turret_places.filter(|places| called.number as usize > *places)
            && beyond.insert(called.number)
        {
            let note = note("turned-beyond-turret").with("places", places);
            faults.push(fault("turned-beyond-turret", Severity::Doubtful, note, motion.line));
        }
        let before = standing.insert(called.number, tool);
        let Some(before) = before.filter(|before| designation(before) != designation(tool)) else { continue };
        let severity = if before.is_named && tool.is_named { Severity::Wrong } else { Severity::Doubtful };
        let note = note("turned-no-stop").with("before", designation(before)).with("tool", designation(tool));
        faults.push(fault("turned-no-stop", severity, note, motion.line));
    }
    faults
}
