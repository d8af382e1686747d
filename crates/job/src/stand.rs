//! Where the part stands in each set-up, and its zeros, as the job has them.

use crate::machine::Machine;
use crate::part::{Face, Point};
use crate::plan::{Plan, Stand, Touched};
use crate::units::Micrometres;

use super::{Job, SetUp, frame};

/// How the part stands in each set-up of the job of a plan.
pub(super) fn stands(plan: &Plan, job: &Job, machine: &Machine<'_>) -> Vec<Stand> {
    job.setups.iter().enumerate().map(|(index, setup)| stand(plan, job, setup, (frame(index), machine))).collect()
}

fn stand(plan: &Plan, job: &Job, setup: &SetUp, (frame, machine): (u8, &Machine<'_>)) -> Stand {
    let (datum, blank) = (&plan.part.datum, &plan.part.blank);
    let zero = setup.zero;
    let start = Point { x: job.change_at.x - zero.x, y: job.change_at.y - zero.y };
    let outs = setup.works.iter().flat_map(|work| work.cycles.iter().map(|cycle| cycle.out));
    // The clamps are those of the first set-up.
    let clamps = plan.clamping.as_ref().filter(|_| setup.face == Face::Entry).map(|clamping| &clamping.clamps);
    // The drawing gives dimensions from the side where its zero lies; from the middle, the right and the back one are touched.
    let (left, front) = (datum.left == Micrometres::ZERO, datum.front == Micrometres::ZERO);
    // Turned over about the line through its middle along Y, the part has its left side on the right.
    let left = left != (setup.face == Face::Back);
    let sides = [
        if left { datum.left } else { datum.left + blank.length },
        if front { datum.front } else { datum.front + blank.width },
    ];
    Stand {
        set_up: setup.number,
        face: setup.face,
        height_mm: setup.supports,
        corner_mm: Point { x: zero.x + datum.left - machine.middle[0], y: zero.y + datum.front - machine.middle[1] },
        // A machine without a knee has one height.
        nose_to_table_mm: machine.nose_to_table.filter(|(least, most)| least < most).map(|_| setup.nose),
        frame,
        zero_mm: [zero.x, zero.y, zero.z],
        sides_mm: sides,
        touched: Touched { left, front },
        face_mm: datum.top,
        reference_tool: plan.tools.iter().find(|tool| tool.correction_mm.micrometres() == 0).map(|tool| tool.number),
        first_level_mm: outs.max().unwrap_or_default() - datum.top,
        start,
        start_to_clamp_mm: clamps.and_then(|clamps| start.to_nearest(clamps)),
    }
}
