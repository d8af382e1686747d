//! Limits of the machine, whatever its control: axis travels and spindle steps.

use std::collections::{BTreeMap, BTreeSet};

use crate::machine::Machine;
use crate::motion::{Axis, Position};
use crate::note::Note;
use crate::program::setting::Assumed;
use crate::units::Micrometres;

/// The function of the coordinate system of an axis, if its zero is not set. Positions in it are consistent, but
/// unknown on the machine; or the zero is assumed, and so is the position.
pub(super) type Floating = Option<u8>;

/// The range of the axes in each system without a zero, least and greatest.
pub(super) type Spans = BTreeMap<(u8, usize), (Micrometres, Micrometres)>;

/// The range of each axis in a motion, least and greatest.
pub(super) type AxisRanges = [(Micrometres, Micrometres); 3];

/// What is told in place of a limit that nobody has stated.
pub(super) const NOT_CHECKED: &str = "limit-not-checked";

/// What is told once, without costing a block, in place of a limit of a machine that nobody has named.
pub(super) fn not_checked(what: &'static str) -> Note {
    Note::new(NOT_CHECKED).with("what", what.to_owned()).with("why", "machine".to_owned())
}

/// Which limit of the machine costs a block that breaks this rule, if any.
pub(super) fn of_machine(code: &str) -> Option<&'static str> {
    Some(match code {
        "feed-beyond-machine" => "feed",
        "speed-beyond-machine" => "speed",
        "cannot-tap" => "tap",
        "beyond-travel-of" | "span-beyond-travel" => "travel",
        _ => return None,
    })
}

/// The part of a motion outside the travels. If the zero of an axis is set, its machine position is known; otherwise the required
/// length of travel is. Without a machine nothing is beyond, and only what each system needs is noted.
pub(super) fn beyond_travel(
    machine: Option<&Machine<'_>>,
    reached: AxisRanges,
    from: Position,
    floating: [Floating; 3],
    (spans, assumed): (&mut Spans, Assumed),
) -> Vec<(&'static str, Note)> {
    let mut notes = Vec::new();
    for axis in Axis::ALL {
        let (low, high) = reached[axis.index()];
        let here = from.get(axis);
        if low == here && high == here {
            continue;
        }
        let range = machine.map(|machine| machine.range(axis));
        match floating[axis.index()] {
            None => {
                let Some((least, most)) = range else { continue };
                let beyond = if low < least { Some(low) } else { Some(high).filter(|high| *high > most) };
                if let Some(value) = beyond {
                    let code = "beyond-travel-of";
                    let note = Note::new(code).with("axis", axis.letter()).with("value", value);
                    notes.push((code, note.with("low", least).with("high", most)));
                }
            }
            Some(system) => {
                let entry = spans.entry((system, axis.index())).or_insert((low, high));
                *entry = (entry.0.min(low), entry.1.max(high));
                let Some((least, most)) = range else { continue };
                let (needed, travel) = (entry.1 - entry.0, most - least);
                if assumed.zeros[axis.index()] && needed <= travel && (low < least || high > most) {
                    let note = Note::new(NOT_CHECKED).with("what", axis.letter().to_string());
                    notes.push((NOT_CHECKED, note.with("why", "zeros".to_owned())));
                }
                if needed > travel {
                    let code = "span-beyond-travel";
                    let note = Note::new(code).with("axis", axis.letter()).with("system", system_name(system));
                    notes.push((code, note.with("needed", needed).with("travel", travel)));
                }
            }
        }
    }
    notes
}

/// The systems without a zero that a run has used, each with its axes, for the note `zero-not-set`.
pub(super) fn without_zero(spans: &Spans, assumed: Assumed) -> Vec<(String, String)> {
    let unknown = |axis: usize| !assumed.zeros.get(axis).is_some_and(|assumed| *assumed);
    let systems: BTreeSet<u8> = spans.keys().filter(|(_, axis)| unknown(*axis)).map(|(system, _)| *system).collect();
    let axes = |system: u8| -> Vec<String> {
        let used = Axis::ALL.into_iter();
        let used = used.filter(|axis| unknown(axis.index()) && spans.contains_key(&(system, axis.index())));
        used.map(|axis| axis.letter().to_string()).collect()
    };
    systems.into_iter().map(|system| (system_name(system), axes(system).join(", "))).collect()
}

/// The function of a system by its number: 54 to 59, and 60 to 62 for G59.1 to G59.3.
fn system_name(system: u8) -> String {
    match system.checked_sub(59) {
        Some(more @ 1..) => format!("G59.{more}"),
        _ => format!("G{system}"),
    }
}

/// What is wrong with a spindle speed on the machine, if anything is; 1/min.
pub(super) fn speed_off_steps(machine: &Machine<'_>, speed: f64) -> Option<(&'static str, Note)> {
    let steps = &machine.spindle_steps;
    let lowest = steps.first().map_or(0.0, |step| step.0);
    let highest = steps.last().map_or(f64::INFINITY, |step| step.0);
    if speed > highest {
        let code = "speed-beyond-machine";
        return Some((code, Note::new(code).with("limit", highest)));
    }
    // A step between whole numbers may be written as the whole number below it.
    if speed == 0.0
        || (machine.stepless && speed >= lowest)
        || steps.iter().any(|step| step.0 == speed || libm::floor(step.0) == speed)
    {
        return None;
    }
    let below = steps.iter().rev().find(|step| step.0 < speed);
    let above = steps.iter().find(|step| step.0 > speed);
    let near: Vec<String> = below.into_iter().chain(above).map(|step| step.0.to_string()).collect();
    let code = "no-spindle-step";
    Some((code, Note::new(code).with("speed", speed).with("near", near.join(", "))))
}
