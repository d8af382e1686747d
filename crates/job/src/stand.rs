//! Where the part stands in each set-up, and its zeros, as the job has them.

use crate::machine::Machine;
use crate::part::{Along, Face, Part, Point, Side};
use crate::plan::{OtherZero, PartZero, Plan, Stand, Touched};
use crate::units::Micrometres;

use super::{Job, SetUp};

/// How the part stands in each set-up of the job of a plan.
pub(super) fn stands(plan: &Plan, job: &Job, machine: &Machine<'_>) -> Vec<Stand> {
    job.setups.iter().map(|setup| stand(plan, job, setup, machine)).collect()
}

fn stand(plan: &Plan, job: &Job, setup: &SetUp, machine: &Machine<'_>) -> Stand {
    let datum = &plan.part.datum;
    let zero = setup.zero;
    let start = Point { x: job.change_at.x - zero.x, y: job.change_at.y - zero.y };
    let outs = setup.works.iter().flat_map(|work| work.cycles.iter().map(|cycle| cycle.out));
    let clamps = plan.clamping_of(setup.number).map(|clamping| &clamping.clamps);
    let zeros = &plan.setup.zeros;
    let (touched, sides) = touches(&plan.part, zeros.first(), setup.face);
    // Further zeros are of the first set-up.
    let others = setup.frames.iter().skip(1).zip(zeros.iter().skip(1)).map(|(frame, zero)| {
        let (touched, sides_mm) = touches(&plan.part, Some(zero), setup.face);
        OtherZero { frame: *frame, sides_mm, touched, holes: zero.holes.clone() }
    });
    Stand {
        set_up: setup.number,
        face: setup.face,
        height_mm: setup.supports,
        corner_mm: Point { x: zero.x + datum.left - machine.middle[0], y: zero.y + datum.front - machine.middle[1] },
        // A machine without a knee has one height.
        nose_to_table_mm: machine.nose_to_table.filter(|(least, most)| least < most).map(|_| setup.nose),
        frame: setup.frames.first().copied().unwrap_or_default(),
        zero_mm: [zero.x, zero.y, zero.z],
        sides_mm: sides,
        touched,
        other_zeros: others.collect(),
        face_mm: datum.top,
        reference_tool: plan.tools.iter().find(|tool| tool.correction_mm.micrometres() == 0).map(|tool| tool.number),
        first_level_mm: outs.max().unwrap_or_default() - datum.top,
        start,
        start_to_clamp_mm: clamps.and_then(|clamps| start.to_nearest(clamps)),
    }
}

/// The sides that an arbor touches for a zero, and how far they are from the zero of the drawing, as the part lies.
fn touches(part: &Part, zero: Option<&PartZero>, face: Face) -> (Touched, [Micrometres; 2]) {
    let (datum, blank) = (&part.datum, &part.blank);
    let side = |axis| zero.map_or_else(|| part.side_of_zero(axis), |zero| zero.side(axis));
    let front = side(Along::Y) == Side::Front;
    // Turned over about the line through its middle along Y, the part has its left side on the right.
    let left = (side(Along::X) == Side::Left) != (face == Face::Back);
    let sides = [
        if left { datum.left } else { datum.left + blank.length },
        if front { datum.front } else { datum.front + blank.width },
    ];
    (Touched { left, front }, sides)
}
