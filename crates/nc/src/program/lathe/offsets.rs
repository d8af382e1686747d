//! Offsets that two tools share, in controls that number them over all tools.

use std::collections::BTreeMap;

use super::LatheReader;
use super::motion::{LatheAct, LatheMotion, LatheTool};
use super::rules::fault;
use crate::program::{Fault, TextSpan};

/// Calls with an offset that is called for another tool, too, each pair once: at the call whose numbers differ, where one of both
/// has the same number for tool and offset. Where none has, nobody knows whose the offset is: a doubt at every call behind the
/// first. Offset 0 is none, and Sinumerik numbers its edges for each tool anew.
pub(super) fn shared(kind: LatheReader, motions: &[LatheMotion]) -> Vec<Fault> {
    if kind == LatheReader::Sinumerik {
        return Vec::new();
    }
    let mut calls: BTreeMap<u32, Vec<(LatheTool, u32)>> = BTreeMap::new();
    for motion in motions.iter().filter(|motion| motion.act.cuts()) {
        let Some((tool, offset)) = motion.modes.tool.and_then(|tool| Some((tool, tool.offset?))) else { continue };
        if offset == 0 {
            continue;
        }
        let known = calls.entry(offset).or_default();
        if known.iter().all(|(one, _)| one.number != tool.number) {
            known.push((tool, motion.line));
        }
    }
    let mut faults = Vec::new();
    for (offset, tools) in calls {
        let owner = tools.iter().find(|(tool, _)| tool.number == offset);
        let code = if owner.is_some() { "lathe-offset-shared" } else { "lathe-offset-of-two" };
        let Some((other, _)) = owner.or(tools.first()) else { continue };
        for (tool, line) in tools.iter().filter(|(tool, _)| tool.number != other.number) {
            let span = TextSpan { line: called(motions, *tool).unwrap_or(*line), column: 1, width: 1 };
            let problem = fault(code, span, None).with("number", tool.number);
            faults.push(problem.with("offset", offset).with("other", other.number));
        }
    }
    faults
}

/// The line that calls a tool with its offset.
fn called(motions: &[LatheMotion], tool: LatheTool) -> Option<u32> {
    let call = |one: &&LatheMotion| one.act == LatheAct::ToolChange && one.modes.tool == Some(tool);
    motions.iter().find(call).map(|motion| motion.line)
}
