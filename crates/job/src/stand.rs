//! Where the part stands in each set-up, and its zeros, as the job has them.

use crate::error::KnowledgeError;
use crate::machine::Machine;
use crate::motion::Axis;
use crate::part::{Along, Face, Outline, Part, Point, Side};
use crate::plan::{BarSetting, Loading, OtherZero, PartZero, Plan, Stand, Touched};
use crate::shop::Shop;
use crate::tables::materials::ClampScrew;
use crate::units::Micrometres;

use super::{Job, Pause, SetUp};

/// How the part stands in each set-up of the job of a plan.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn stands(plan: &Plan, job: &Job, shop: &Shop<'_>) -> Result<Vec<Stand>, KnowledgeError> {
    let screws: Vec<ClampScrew<'_>> = shop.knowledge.rows()?;
    let mut set = Vec::new();
    let mut stands = Vec::new();
    for setup in &job.setups {
        let bars = bars(setup, &mut set);
        let stand = stand(plan, job, setup, &shop.machine);
        let loading = loading(plan, setup, stand.start, &shop.machine, &screws);
        stands.push(Stand { bars, loading, ..stand });
    }
    Ok(stands)
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
        holes: holes(setup),
        bars: Vec::new(),
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
        loading: None,
    }
}

/// The groups of holes that are worked on in a set-up, in the order of the work.
fn holes(setup: &SetUp) -> Vec<String> {
    let mut holes: Vec<String> = Vec::new();
    for stop in setup.works.iter().flat_map(|work| &work.stops) {
        if !holes.contains(&stop.hole) {
            holes.push(stop.hole.clone());
        }
    }
    holes
}

/// What the bars are set to in a set-up; `set` are those with one setting that stand in an earlier one.
fn bars(setup: &SetUp, set: &mut Vec<(u32, Micrometres)>) -> Vec<BarSetting> {
    let mut bars: Vec<BarSetting> = Vec::new();
    for work in &setup.works {
        let Some(diameter_mm) = work.bar_mm else { continue };
        let at_stop = work.pauses.iter().any(|pause| matches!(pause, Pause::SetBar { .. }));
        let own = work.stops.iter().map(|stop| &stop.hole);
        let unlike = |last: &&mut BarSetting| last.tool == work.tool && last.diameter_mm == diameter_mm;
        match bars.last_mut().filter(unlike).filter(|_| !at_stop) {
            Some(last) => own.for_each(|hole| {
                if !last.holes.contains(hole) {
                    last.holes.push(hole.clone());
                }
            }),
            None if !at_stop && set.contains(&(work.tool, diameter_mm)) => {}
            None => {
                let mut holes: Vec<String> = Vec::new();
                own.for_each(|hole| {
                    if !holes.contains(hole) {
                        holes.push(hole.clone());
                    }
                });
                set.push((work.tool, diameter_mm));
                bars.push(BarSetting { tool: work.tool, diameter_mm, holes, at_stop });
            }
        }
    }
    bars
}

/// The point at the far left from the worker, who stands before the table: left of everything that stands there and behind it, as
/// far as Y reaches, and so far to the left that every clamp is as far away as a wrench on its nut and a hand need (textbook 1.11).
fn loading(
    plan: &Plan,
    setup: &SetUp,
    start: Point,
    machine: &Machine<'_>,
    screws: &[ClampScrew<'_>],
) -> Option<Loading> {
    let (part, clamping) = (&plan.part, plan.clamping_of(setup.number)?);
    // Each clamp of the file may have a screw of its own.
    let needed = |index: usize| {
        let given = part.fixture.clamps.get(index).filter(|_| !clamping.proposed)?.screw.as_deref()?;
        screws.iter().find(|screw| screw.thread == given).map(|screw| screw.safe_distance)
    };
    let clamps = clamping.clamps.iter().enumerate();
    let clamps = clamps.map(|(index, at)| (*at, needed(index).unwrap_or(clamping.safe_distance_mm)));
    let low = Point { x: part.datum.left, y: part.datum.front };
    let high = Point { x: low.x + part.blank.length, y: low.y + part.blank.width };
    let standing = setup.standing.iter().map(|one| match one.outline {
        Outline::Round(at, radius) => (at.x - radius, at.y + radius),
        Outline::Box(low, high) => (low.x, high.y),
    });
    let (left, back) = standing.fold((low.x, high.y), |(left, back), (x, y)| (left.min(x), back.max(y)));
    let [(least, _), (_, most)] = [machine.range(Axis::X), machine.range(Axis::Y)];
    let y = back.min(most - setup.zero.y);
    let aside = |(at, needed): (Point, Micrometres)| {
        let (needed, off) = (needed.to_mm(), (y - at.y).to_mm());
        let away = (needed * needed - off * off).max(0.0).sqrt();
        at.x - Micrometres::from_mm_rounded(away.ceil())
    };
    let x = clamps.clone().map(aside).fold(left, Micrometres::min);
    let at = Point { x, y };
    let start_is_safe = clamps.clone().all(|(clamp, needed)| start.distance(clamp) >= needed);
    let (_, safe_mm) = clamps.min_by_key(|(clamp, needed)| at.distance(*clamp) - *needed)?;
    let beyond = least - (setup.zero.x + x);
    let beyond_mm = Some(beyond).filter(|beyond| *beyond > Micrometres::ZERO);
    Some(Loading { at, safe_mm, beyond_mm, start_is_safe })
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
