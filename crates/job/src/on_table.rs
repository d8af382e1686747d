//! Whether the part lies on the table, clear of the column, and whether the axes reach all the work where it lies.

use crate::machine::Machine;
use crate::motion::Axis;
use crate::note::{Figure, Finding, Note, Severity};
use crate::part::{Part, Point, Slot, Way};
use crate::plan::Plan;
use crate::units::Micrometres;
use crate::zone;

use super::{CycleKind, SetUp, Stop, ToolWork};

/// How far from its point, or from the middle line of its slot, the axis of a tool goes: a mill goes round in the hole.
pub(super) fn swing(work: &ToolWork, cycle: usize) -> Micrometres {
    match work.cycles.get(cycle).map(|cycle| &cycle.kind) {
        Some(CycleKind::Circles { radii, .. }) => radii.iter().copied().max().unwrap_or_default(),
        Some(CycleKind::Slot(slot)) => slot.reach(),
        _ => Micrometres::ZERO,
    }
}

/// The line of a stop: its point, or the middle line of its slot.
pub(super) fn way(work: &ToolWork, stop: &Stop) -> Way {
    match work.cycles.get(stop.cycle).map(|cycle| &cycle.kind) {
        Some(CycleKind::Slot(slot)) => slot.run.middle(stop.at),
        _ => Slot::default().middle(stop.at),
    }
}

/// The points of a set-up, each with how far the axis of a tool goes from it, and its hole.
fn reaches(setup: &SetUp) -> impl Iterator<Item = (Point, Micrometres, &str)> {
    let stops = setup.works.iter().flat_map(|work| work.stops.iter().map(move |stop| (work, stop)));
    stops.flat_map(|(work, stop)| {
        let way = way(work, stop);
        [way.from, way.to].map(|at| (at, swing(work, stop.cycle), stop.hole.as_str()))
    })
}

fn along(at: Point, axis: Axis) -> Micrometres {
    if axis == Axis::X { at.x } else { at.y }
}

/// What does not fit, each with its inequality. Nothing is said of a machine whose spindle does not stand over its table, or
/// whose record does not say how high.
pub(super) fn faults(setup: &SetUp, plan: &Plan, machine: &Machine<'_>, findings: &mut Vec<Finding>) {
    travels(setup, &plan.part, machine, findings);
    if machine.nose_to_table.is_some() {
        beyond_edge(setup, plan, machine, findings);
        column(setup, &plan.part, machine, findings);
    }
}

/// Work beyond the travel, with the part where it lies: |zero + point − middle| + swing ≤ travel/2, mm.
fn travels(setup: &SetUp, part: &Part, machine: &Machine<'_>, findings: &mut Vec<Finding>) {
    // Holes further apart than the travel are told of the part.
    let spans: Vec<Axis> =
        zone::spans(part).filter(|(axis, low, high)| *high - *low > machine.travel(*axis)).map(|one| one.0).collect();
    for axis in [Axis::X, Axis::Y].into_iter().filter(|axis| !spans.contains(axis)) {
        let zero = setup.zero.get(axis) - machine.middle[axis.index()];
        let reached = reaches(setup).map(|(at, swing, hole)| ((zero + along(at, axis)).abs() + swing, hole));
        let most = machine.travel(axis).half();
        if let Some((reached, hole)) = reached.max().filter(|(reached, _)| *reached > most) {
            let note = Note::new("work-beyond-travel").with("hole", Figure::called(hole)).with("axis", axis.letter());
            findings.push(Finding::of_part(Severity::Error, note.with("reached", reached).with("most", most)));
        }
    }
}

/// A part that reaches beyond the edge of the table; and holes and clamps with no table under them, where the fixture of the
/// file is not what bears them.
fn beyond_edge(setup: &SetUp, plan: &Plan, machine: &Machine<'_>, findings: &mut Vec<Finding>) {
    let (part, clamping) = (&plan.part, plan.clamping_of(setup.number));
    let sides = [
        (Axis::X, part.datum.left, part.blank.length, machine.table_length),
        (Axis::Y, part.datum.front, part.blank.width, machine.table_width),
    ];
    for (axis, begin, size, table) in sides {
        let Some(table) = table else { continue };
        // From the middle of the table.
        let zero = setup.zero.get(axis) - machine.middle[axis.index()];
        let edge = table.half();
        let over = (-edge - zero - begin).max(zero + begin + size - edge);
        if over <= Micrometres::ZERO {
            continue;
        }
        let note = Note::new("part-over-edge").with("axis", axis.letter()).with("size", size);
        findings.push(Finding::of_part(Severity::Doubtful, note.with("table", table).with("over", over)));
        let away = |at: Point| (zero + along(at, axis)).abs();
        let holes = reaches(setup)
            .map(|(at, _, hole)| (away(at), Note::new("hole-off-table").with("hole", Figure::called(hole))));
        let clamps = clamping.into_iter().flat_map(|clamping| &clamping.clamps);
        let clamps = clamps.map(|at| (away(*at), Note::new("clamp-off-table").with("at", at.shown())));
        let severity = if part.fixture.height.is_some() { Severity::Doubtful } else { Severity::Wrong };
        for worst in [holes.max_by_key(|one| one.0), clamps.max_by_key(|one| one.0)].into_iter().flatten() {
            let (away, note) = worst;
            if away > edge {
                let note = note.with("axis", axis.letter()).with("away", away).with("edge", edge);
                findings.push(Finding::of_part(severity, note));
            }
        }
    }
}

/// The back side of the part in the column: back side − least Y of the work ≤ spindle to column, mm.
fn column(setup: &SetUp, part: &Part, machine: &Machine<'_>, findings: &mut Vec<Finding>) {
    let Some(most) = machine.spindle_to_column else { return };
    let Some(front) = reaches(setup).map(|(at, swing, _)| at.y - swing).min() else { return };
    let needed = part.datum.front + part.blank.width - front;
    if needed > most {
        let note = Note::new("into-column").with("needed", needed).with("most", most);
        findings.push(Finding::of_part(Severity::Error, note));
    }
}
