//! The tools that a lathe program calls, and whether they can stand in the turret.

use std::collections::{BTreeMap, BTreeSet};

use technolog_core::ascii::ascii;

use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheAct, LatheRun, LatheTool};
use crate::turning::jobs::Body;
use crate::turning::operation::turret::{Station, station, stations};
use crate::turning::operation::{Operation, SetUpWork};
use crate::turning::tooling::ToolKind;

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
        let named = named(work, &lines, line).map(|job| at_its_place(work, &stations, job, tool));
        let of = |fits: &dyn Fn(&Station) -> bool| {
            work.jobs.iter().position(|job| station(&stations, job).is_some_and(fits))
        };
        // Where tools share a place, their offsets may tell them apart.
        let mut seated = stations.iter().filter(|one| is_seated(one, tool));
        let only = seated.next().filter(|_| seated.next().is_none());
        let placed = || of(&|one| Some(one) == only).or_else(|| of(&|one| one.seat.place == tool.number));
        // A tool that is called by a name stands nobody knows where.
        if let Some(job) = named.or_else(|| if tool.by_name { None } else { placed() }) {
            tools.push(CalledTool { called: tool, line, job, is_named: named.is_some() });
        }
    }
    tools
}

/// Of the jobs with a tool of that name, the one whose place the program calls.
fn at_its_place(work: &SetUpWork, stations: &[Station], job: usize, called: LatheTool) -> usize {
    let name = |index: usize| work.jobs.get(index).map_or("", |job| &*job.tool.designation);
    let sits = |index: &usize| {
        let station = work.jobs.get(*index).and_then(|job| station(stations, job));
        name(*index) == name(job) && station.is_some_and(|one| one.seat.place == called.number)
    };
    (0..work.jobs.len()).find(sits).unwrap_or(job)
}

/// The job whose tool a remark names in a block or before it.
fn named(work: &SetUpWork, lines: &[String], line: u32) -> Option<usize> {
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
    (0..work.jobs.len()).filter(names).max_by_key(length)
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

/// Tools that nobody can have put in: another one at the same place, with no stop since. Which tool a place holds is what the
/// first call says; a later remark of another tool does not make it that. A thread is cut by a tool for threads alone. A place
/// that the turret of the record does not have is doubtful: turrets of one lathe differ.
pub(super) fn exchanges(
    operation: &Operation,
    work: &SetUpWork,
    text: &str,
    run: &LatheRun,
    tools: &[CalledTool],
) -> Vec<Fault> {
    let lines: Vec<String> = text.lines().map(plain).collect();
    let designation = |tool: &CalledTool| work.jobs.get(tool.job).map_or("", |job| &*job.tool.designation);
    let mut faults = wrong_offsets(operation, work, &lines, tools);
    let mut standing: BTreeMap<u32, CalledTool> = BTreeMap::new();
    let mut current: Option<CalledTool> = None;
    let (mut beyond, mut no_threading) = (BTreeSet::new(), BTreeSet::new());
    for motion in &run.motions {
        if motion.act == LatheAct::Stop {
            standing.clear();
        }
        let Some(called) = motion.modes.tool else { continue };
        if motion.act == LatheAct::ToolChange || current.is_none_or(|tool| tool.called != called) {
            let known = tools.iter().find(|tool| tool.called == called).copied();
            let remarked = named(work, &lines, motion.line).filter(|_| motion.act == LatheAct::ToolChange);
            if let (Some(known), Some(job)) = (known, remarked) {
                faults.extend(of_one_before(operation, work, known, job, motion.line));
            }
            current = known.map(|tool| match remarked {
                Some(job) => CalledTool { job, is_named: true, ..tool },
                None => tool,
            });
        }
        let Some(tool) = current.filter(|_| motion.act.moves()) else { continue };
        let note = |code| Note::new(code).with("number", called.number);
        if let Some(places) = operation.turret_places.filter(|places| called.number as usize > *places)
            && !called.by_name
            && beyond.insert(called.number)
        {
            let note = note("turned-beyond-turret").with("places", places);
            faults.push(fault("turned-beyond-turret", Severity::Doubtful, note, motion.line));
        }
        if matches!(motion.act, LatheAct::Thread { .. })
            && work.jobs.get(tool.job).is_some_and(|job| !cuts_threads(&job.tool.body))
            && no_threading.insert(called.number)
        {
            let severity = if tool.is_named { Severity::Wrong } else { Severity::Doubtful };
            let note = note("turned-no-threading-tool").with("tool", designation(&tool));
            faults.push(fault("turned-no-threading-tool", severity, note, motion.line));
        }
        let before = standing.insert(called.number, tool);
        let Some(before) = before.filter(|before| designation(before) != designation(&tool)) else { continue };
        let severity = if before.is_named && tool.is_named { Severity::Wrong } else { Severity::Doubtful };
        let note = note("turned-no-stop").with("before", designation(&before)).with("tool", designation(&tool));
        faults.push(fault("turned-no-stop", severity, note, motion.line));
    }
    faults
}

/// A later call of a place with the offset of the tool that stood there before, though the remark names another one.
fn of_one_before(operation: &Operation, work: &SetUpWork, known: CalledTool, job: usize, line: u32) -> Option<Fault> {
    let stations = stations(operation);
    let called = known.called;
    let own = |job: usize| work.jobs.get(job).and_then(|job| station(&stations, job));
    let (before, now) = (own(known.job)?, own(job)?);
    let name = work.jobs.get(job).map_or("", |job| &*job.tool.designation);
    let same = before == now || before.tool.designation == now.tool.designation;
    if same || !is_seated(before, called) || is_seated(now, called) || now.seat.place != called.number {
        return None;
    }
    let note = Note::new("turned-offset-of-other").with("number", called.number).with("tool", name);
    let note = note.with("offset", called.offset.unwrap_or_default());
    Some(fault("turned-offset-of-other", Severity::Wrong, note, line))
}

/// Whether a tool is made for threads.
const fn cuts_threads(body: &Body) -> bool {
    matches!(body, Body::Tap { .. } | Body::Insert { kind: ToolKind::Threading, .. })
}

/// Whether a block has a D with that number: D1 is not in D12.
fn has_edge(block: &str, number: u32) -> bool {
    block.split('D').skip(1).any(|behind| {
        let digits = behind.find(|sign: char| !sign.is_ascii_digit()).unwrap_or(behind.len());
        behind[..digits].parse() == Ok(number)
    })
}

/// Calls with the offset of another tool: the tool stands at its place in our turret, and its offset is that of another one; wrong
/// where the program itself calls that one. An offset that no tool of the plan has is wrong, as is a D, which controls number for each
/// place, that no tool there has: nothing says where the tool then is along Z.
fn wrong_offsets(operation: &Operation, work: &SetUpWork, lines: &[String], tools: &[CalledTool]) -> Vec<Fault> {
    let stations = stations(operation);
    let wrong = |tool: &CalledTool| {
        let CalledTool { called, line, job, .. } = *tool;
        let own = work.jobs.get(job).and_then(|job| station(&stations, job))?;
        let offset = called.offset.filter(|_| own.seat.place == called.number)?;
        let at = usize::try_from(line).unwrap_or(usize::MAX);
        let block = at.checked_sub(1).and_then(|at| lines.get(at)).map_or("", String::as_str);
        let of_place = block.split(['(', ';']).next().is_some_and(|words| has_edge(words, offset));
        let is_of = |one: &Station| if of_place { is_seated(one, called) } else { one.seat.offset == offset };
        if is_seated(own, called) {
            return None;
        }
        let Some(other) = stations.iter().find(|one| is_of(one)) else {
            return Some(("turned-offset-unknown", Severity::Wrong));
        };
        let is_called = |tool: &CalledTool| {
            is_seated(other, tool.called) && work.jobs.get(tool.job).is_some_and(|job| other.is_of(job))
        };
        let severity = if tools.iter().any(is_called) { Severity::Wrong } else { Severity::Doubtful };
        Some(("turned-offset-of-other", severity))
    };
    let told = tools.iter().filter_map(|tool| {
        let (code, severity) = wrong(tool)?;
        let name = work.jobs.get(tool.job).map_or("", |job| &*job.tool.designation);
        let note = Note::new(code).with("number", tool.called.number).with("tool", name);
        let note = note.with("offset", tool.called.offset.unwrap_or_default());
        Some(fault(code, severity, note, tool.line))
    });
    told.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_is_told_from_one_that_begins_with_its_digits() {
        for (block, has) in [("T0303 D1", true), ("T3 D12", false), ("D12 D1", true), ("T3 D01", true), ("T1", false)] {
            assert_eq!(has_edge(block, 1), has, "{block}");
        }
    }
}
