//! The position of the part on the machine: the zero of its drawing in machine coordinates.

use crate::error::KnowledgeError;
use crate::machine::Machine;
use crate::motion::{Axis, Position};
use crate::note::{Finding, Note, Severity};
use crate::part::{Part, Point, Standing};
use crate::plan::{Held, Plan};
use crate::shop::Shop;
use crate::tables::controls::Convention;
use crate::tables::practice::{ProofLimit, ProofLimits};
use crate::units::Micrometres;
use crate::zone::Stroke;

use super::on_table::{swing, way};
use super::{SetUp, ToolWork};
use crate::shop::convention;

/// The position of the part on the machine.
#[derive(Clone, Copy, Debug)]
pub(super) struct PartPosition {
    pub zero: Position,
    pub supports: Micrometres,
    pub nose: Micrometres,
}

/// The zero of a set-up, and findings about what does not fit.
///
/// - X and Y: the middle of the blank is over the middle of the table, which the spindle stands over in the middle of the
///   travels. If points would then be outside the travel, the blank is shifted so that they are in its middle.
/// - Z: the knee is as high as the longest tool allows: with the quill retracted this tool clears the part by the
///   retract height. It is the reference tool of the corrections, so its tip is used for measuring the zero.
/// - Under the part there is room for tools that go through, and `support-room` more: without a height of the fixture,
///   supports of whole millimetres are assumed, and reported. Where the nose comes no lower, they are so high that the shortest
///   tool reaches its depth.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn stand(
    part: &Part,
    plan: &Plan,
    works: &[ToolWork],
    standing: &[Standing],
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<PartPosition, KnowledgeError> {
    let machine = &shop.machine;
    let Point { x, y } = across(part, works, machine);

    // The longest tool: corrections refer to it, unless the plan has another reference tool.
    let reference = plan.tools.iter().map(|tool| tool.length_mm - tool.correction_mm).max().unwrap_or_default();
    let longest = plan.tools.iter().map(|tool| tool.correction_mm).max().unwrap_or_default();
    let heights = works.iter().flat_map(|work| work.cycles.iter().map(|cycle| cycle.out)).max().unwrap_or_default();
    // With the quill retracted the longest tool clears what stands over the face, too: from one point to another, and to the tool change.
    let room = Micrometres::from_mm_rounded(convention(Convention::ObstacleClearance, shop.knowledge)?.0);
    let over = standing.iter().filter(|_| part.fixture.retract.is_none()).map(|one| part.datum.top + one.height + room);
    let heights = over.chain([heights]).max().unwrap_or(heights);
    let supports = match plan.held(1) {
        Held::Vice(vice) => vice.height(),
        Held::Chuck(chuck) => chuck.part_height_mm,
        _ => supports(plan, works, shop, findings)?,
    };
    // From the table to the zero of the drawing.
    let zero_height = supports + part.blank.thickness - part.datum.top;
    let needed =
        Stroke { length: reference + longest, highest: zero_height + heights, lowest: zero_height }.passes_from();
    let step = Micrometres::from_mm_rounded(convention(Convention::KneeStep, shop.knowledge)?.0);
    let (least, most) = machine.nose_to_table.unwrap_or((Micrometres::ZERO, needed));
    let nose = up_to(needed, step).max(least);
    if needed > most {
        let note = Note::new("no-room-over-part").with("needed", needed).with("most", most);
        findings.push(Finding::of_part(Severity::Error, note.with("tool", reference + longest)));
    }
    Ok(PartPosition { zero: Position { x, y, z: zero_height + reference - nose }, supports, nose })
}

/// X and Y of the zero.
pub(super) fn across(part: &Part, works: &[ToolWork], machine: &Machine<'_>) -> Point {
    let stops = works.iter().flat_map(|work| work.stops.iter().map(move |stop| (work, stop)));
    let reaches = stops.flat_map(|(work, stop)| {
        let way = way(work, stop);
        [way.from, way.to].map(|at| (at, swing(work, stop.cycle)))
    });
    let ends: Vec<[Point; 2]> = reaches
        .map(|(at, swing)| [Point { x: at.x - swing, y: at.y - swing }, Point { x: at.x + swing, y: at.y + swing }])
        .collect();
    let points = || ends.iter().flatten();
    let middle = part.middle();
    Point {
        x: along(middle.x, points().map(|at| at.x), machine.range(Axis::X)),
        y: along(middle.y, points().map(|at| at.y), machine.range(Axis::Y)),
    }
}

/// The height of the part above the table: that of the fixture, or what through tools need.
fn supports(
    plan: &Plan,
    works: &[ToolWork],
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<Micrometres, KnowledgeError> {
    let part = &plan.part;
    let mut lows = Vec::new();
    for work in works {
        let pilot = pilot(work, plan, shop)?;
        lows.extend(work.cycles.iter().map(|cycle| cycle.end - pilot));
    }
    let lowest = lows.into_iter().min().unwrap_or_default();
    let below = (part.datum.top - part.blank.thickness - lowest).max(Micrometres::ZERO);
    let room = Micrometres::from_mm_rounded(convention(Convention::SupportRoom, shop.knowledge)?.0);
    match part.fixture.height {
        Some(height) => {
            if below > height {
                let note = Note::new("no-room-under-part").with("below", below).with("height", height);
                findings.push(Finding::of_part(Severity::Error, note));
            } else if below > Micrometres::ZERO && below + room > height {
                let note = Note::new("scant-room-under-part").with("below", below).with("height", height);
                findings.push(Finding::of_part(Severity::Doubtful, note.with("room", room)));
            }
            if part.fixture.own.is_some() {
                below_in_own(plan, works, shop, findings)?;
            }
            Ok(height)
        }
        None => {
            let step = Micrometres::from_mm_rounded(convention(Convention::KneeStep, shop.knowledge)?.0);
            let needed = if below > Micrometres::ZERO { below + room } else { below };
            let height = up_to(needed, step);
            if below > Micrometres::ZERO {
                let note = Note::new("supports-assumed").with("below", below).with("height", height);
                findings.push(Finding::of_part(Severity::Note, note));
            }
            let short = shortfall(plan, works, height, &shop.machine);
            if let Some((short, tool)) = short.filter(|(short, _)| *short > Micrometres::ZERO) {
                let raised = height + up_to(short, step);
                findings.push(Finding::of_part(
                    Severity::Note,
                    Note::new("supports-for-reach")
                        .with("tool", tool)
                        .with("way", shop.machine.travel_z + short)
                        .with("height", raised),
                ));
                return Ok(raised);
            }
            Ok(height)
        }
    }
}

/// How much the quill lacks to bring a tool to its depth with its nose as low as the machine has it, and which tool: higher supports
/// mend that, for a nose that must be higher for the longest tool goes up with them.
fn shortfall(
    plan: &Plan,
    works: &[ToolWork],
    supports: Micrometres,
    machine: &Machine<'_>,
) -> Option<(Micrometres, u32)> {
    let (least, _) = machine.nose_to_table?;
    let part = &plan.part;
    let zero = supports + part.blank.thickness - part.datum.top;
    let short = works.iter().filter_map(|work| {
        let tool = plan.tools.iter().find(|tool| tool.number == work.tool)?;
        let lowest = zero + work.cycles.iter().map(|cycle| cycle.end).min()?;
        let stroke = Stroke { length: tool.length_mm, highest: lowest, lowest };
        Some((stroke.travel(least) - machine.travel_z, work.tool))
    });
    short.max()
}

/// Holes under which the tool comes out: what a fixture of the shop's own has there is not known. Each is told once, at its deepest.
fn below_in_own(
    plan: &Plan,
    works: &[ToolWork],
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let part = &plan.part;
    for hole in &part.holes {
        let mut lows = Vec::new();
        for work in works {
            let pilot = pilot(work, plan, shop)?;
            let own = work.stops.iter().filter(|stop| stop.hole == hole.name);
            lows.extend(own.filter_map(|stop| work.cycles.get(stop.cycle)).map(|cycle| cycle.end - pilot));
        }
        let Some(lowest) = lows.into_iter().min() else { continue };
        let below = part.datum.top - part.blank.thickness - lowest;
        let note = Note::new("out-below-in-own-fixture").with("below", below);
        let finding = Finding::of_hole(Severity::Doubtful, &hole.name, note);
        if below > Micrometres::ZERO && !findings.contains(&finding) {
            findings.push(finding);
        }
    }
    Ok(())
}

/// How far the pilot of a counterbore stands before its teeth: as long as is usual for its diameter (table `proof-limits`).
fn pilot(work: &ToolWork, plan: &Plan, shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let tool = plan.tools.iter().find(|tool| tool.number == work.tool);
    let Some(diameter) = tool.and_then(|tool| tool.pilot_mm) else { return Ok(Micrometres::ZERO) };
    let name = ProofLimit::PilotLengthDiameters;
    let share = shop.knowledge.need(name.name(), |row: &ProofLimits<'_>| row.name.is(name))?.value;
    Ok(Micrometres::from_mm_rounded(diameter.to_mm() * share))
}

/// The zero of one axis: with the blank in the middle, or shifted so far that all points are reached.
fn along(
    middle: Micrometres,
    points: impl Iterator<Item = Micrometres> + Clone,
    (least, most): (Micrometres, Micrometres),
) -> Micrometres {
    let over = (least + most).half();
    let zero = over - middle;
    let (Some(low), Some(high)) = (points.clone().min(), points.max()) else { return zero };
    if zero + low < least || zero + high > most { over - (low + high).half() } else { zero }
}

fn up_to(value: Micrometres, step: Micrometres) -> Micrometres {
    let (value, step) = (value.micrometres(), step.micrometres().max(1));
    Micrometres::new((value + step - 1).div_euclid(step) * step)
}

/// A tool that the quill cannot bring to its depth.
pub(super) fn reach_of_quill(setup: &SetUp, plan: &Plan, shop: &Shop<'_>, findings: &mut Vec<Finding>) {
    for work in &setup.works {
        let Some(tool) = plan.tools.iter().find(|tool| tool.number == work.tool) else { continue };
        let Some(end) = work.cycles.iter().map(|cycle| cycle.end).min() else { continue };
        let Some(out) = work.cycles.iter().map(|cycle| cycle.out).max() else { continue };
        let part = &plan.part;
        let zero_height = setup.supports + part.blank.thickness - part.datum.top;
        let stroke = Stroke { length: tool.length_mm, highest: zero_height + out, lowest: zero_height + end };
        let travel = stroke.travel(setup.nose);
        if travel > shop.machine.travel_z {
            let note = Note::new("quill-too-short")
                .with("tool", work.tool)
                .with("way", travel)
                .with("travel", shop.machine.travel_z);
            findings.push(Finding::of_part(Severity::Error, note));
        }
    }
}
