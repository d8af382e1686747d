//! The purpose of a job's cycle in a technologist's words: `Свердління 6 отв. Ø10H12 (A)`.

use crate::document::capital;
use crate::job::{Pause, ToolWork};
use crate::note::Figure;
use crate::part::{Hole, Part};
use crate::plan::{Operation, Plan, Transition};

use super::Lang;
use super::sheet::route::{finishes, size_text, slot_size};
use super::words::say;

/// The transitions that a work makes with some of its cycles: for each its group, its number and the number of its
/// holes, in the order of the work.
pub(super) fn stops_of_work<'w>(work: &'w ToolWork, cycles: &[usize]) -> Vec<(&'w str, usize, usize)> {
    let mut found: Vec<(&str, usize, usize)> = Vec::new();
    for stop in work.stops.iter().filter(|stop| cycles.contains(&stop.cycle)) {
        let same = found.iter_mut().find(|(hole, transition, _)| *hole == stop.hole && *transition == stop.transition);
        match same {
            Some((.., count)) => *count += 1,
            None => found.push((&stop.hole, stop.transition, 1)),
        }
    }
    found
}

/// The transition of a plan for a stop.
pub(super) fn find_in_plan<'p>(plan: &'p Plan, hole: &str, number: usize) -> Option<(&'p Hole, &'p Transition)> {
    let own = plan.holes.iter().find(|own| own.name == hole)?;
    Some((plan.part.holes.iter().find(|known| known.name == hole)?, own.transitions.get(number)?))
}

/// The purpose of some cycles of a work, in one sentence; a work done pass by pass counts a hole once.
pub(super) fn sentence(plan: &Plan, work: &ToolWork, cycles: &[usize], lang: Lang) -> String {
    let mut text = String::new();
    let mut before: Option<Operation> = None;
    for (hole, number, count) in stops_of_work(work, cycles) {
        let Some((hole, transition)) = find_in_plan(plan, hole, number) else { continue };
        let holes_text = holes(hole, transition, count.min(hole.at.len()), lang);
        let operation = Figure::operation(transition.operation.name());
        let with_holes = |operation| say!(lang, "cycles-operation", operation = operation, holes = holes_text.as_str());
        match before.replace(transition.operation) {
            None => text.push_str(&capital(&with_holes(operation))),
            Some(same) if same == transition.operation => {
                text.push_str(", ");
                text.push_str(&holes_text);
            }
            Some(_) => {
                text.push_str("; ");
                text.push_str(&with_holes(operation));
            }
        }
    }
    text
}

/// `6 отв. Ø10H12 (A)`, with the diameter reached if it is not yet that of the hole.
fn holes(hole: &Hole, transition: &Transition, count: usize, lang: Lang) -> String {
    if let Some(size) = slot_size(hole, lang) {
        let (size, width) = (size.as_str(), transition.diameter_mm);
        if hole.slot.is_some_and(|slot| slot.corner.is_some()) {
            return say!(lang, "cycles-pocket", size = size, hole = hole.name.as_str(), width = width);
        }
        return say!(lang, "cycles-slot", size = size, hole = hole.name.as_str(), width = width);
    }
    let (size, name) = (size_text(hole, transition, lang), hole.name.as_str());
    if transition.operation == Operation::CentreDrill || finishes(hole, transition) {
        return say!(lang, "cycles-holes", count = count, size = size, hole = name);
    }
    say!(lang, "cycles-holes-to", count = count, size = size, hole = name, diameter = transition.diameter_mm)
}

/// The operator's task.
pub(super) fn pause(pause: Pause, part: &Part, lang: Lang) -> String {
    match pause {
        Pause::LoadTool { tool, place } => say!(lang, "cycles-load-tool", tool = tool, place = place),
        Pause::TurnOver => say!(lang, "cycles-turn-over", part = part.part.as_str()),
        Pause::SetBar { diameter_mm } => say!(lang, "cycles-set-bar", diameter = diameter_mm),
    }
}
