//! Clearance over obstacles: the clamps of the part file, and the part at the tool change.

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::part::{Outline, Part, Point, Standing};
use crate::plan::Plan;
use crate::shop::Shop;
use crate::tables::controls::Convention;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

use super::on_table::{swing, way};
use super::{SetUp, ToolWork};
use crate::shop::convention;

/// A tool change above the part: the tools are not higher above it than during their motions.
pub(super) fn change_over_part(
    setup: &SetUp,
    part: &Part,
    change: (Micrometres, Micrometres),
    findings: &mut Vec<Finding>,
) {
    let over = |zero: Micrometres, begin: Micrometres, length: Micrometres, at: Micrometres| {
        (zero + begin..=zero + begin + length).contains(&at)
    };
    let (datum, blank) = (part.datum, part.blank);
    let x = over(setup.zero.x, datum.left, blank.length, change.0);
    let y = over(setup.zero.y, datum.front, blank.width, change.1);
    if x && y {
        let note = Note::new("change-over-part").with("x", change.0).with("y", change.1);
        findings.push(Finding::of_part(Severity::Doubtful, note));
    }
}

/// The straps that the plan proposes. Where the file says how high tools go from hole to hole, the straps must be chosen lower
/// than that instead.
pub(super) fn straps(plan: &Plan, set_up: u32) -> Vec<Standing> {
    let clamping = plan.clamping_of(set_up).filter(|clamping| clamping.proposed && plan.part.fixture.retract.is_none());
    let Some((clamping, strap)) = clamping.and_then(|clamping| Some((clamping, clamping.strap?))) else {
        return Vec::new();
    };
    clamping.clamps.iter().map(|at| strap.standing(*at, &plan.part)).collect()
}

/// Tools that work nearer to what stands over the face than the margin of the convention: a clamp by hand does not stand
/// where the file says to the tenth. The foot about a clamp without an outline has its margin in it.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn beside(
    setup: &SetUp,
    plan: &Plan,
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let side = Micrometres::from_mm_rounded(convention(Convention::ObstacleSide, shop.knowledge)?.0);
    // The foot about a clamp without an outline has its margin in it.
    for one in setup.standing.iter().filter(|one| matches!(one.outline, Outline::Box(..))) {
        let near = setup.works.iter().find(|work| {
            let radius = radius_of(work, plan);
            work.stops.iter().any(|stop| {
                let way = way(work, stop);
                one.outline.is_hit(way.from, way.to, radius + swing(work, stop.cycle) + side)
                    && work.cycles.get(stop.cycle).is_some_and(|cycle| cycle.end < plan.part.datum.top + one.height)
            })
        });
        if let Some(work) = near {
            let note = Note::new("tool-beside-clamp").with("tool", work.tool).with("least", side);
            let note = note.with("at", one.at.shown());
            findings.push(Finding::of_part(Severity::Wrong, note));
        }
    }
    Ok(())
}

/// Half of the diameter of its tool.
fn radius_of(work: &ToolWork, plan: &Plan) -> Micrometres {
    let tool = plan.tools.iter().find(|tool| tool.number == work.tool);
    tool.map(|tool| tool.diameter_mm.half()).unwrap_or_default()
}

/// Paths from hole to hole that cross a clamp whose height is not known: of the part file nobody can prove them, and clamps
/// that the plan proposes must be chosen low enough.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn ways_over_clamps(
    setup: &SetUp,
    plan: &Plan,
    change: (Micrometres, Micrometres),
    shop: &Shop<'_>,
) -> Result<Vec<Finding>, KnowledgeError> {
    let mut findings = Vec::new();
    let foot = shop.convention(HoleDefault::ClampInset)?;
    let home = Point { x: change.0 - setup.zero.x, y: change.1 - setup.zero.y };
    // The clamps of the file are those of the first set-up.
    let clamps = plan.part.fixture.clamps.iter().filter(|_| setup.number == 1);
    let unmeasured = clamps.filter(|clamp| clamp.height.is_none());
    let unmeasured = unmeasured.map(|clamp| (clamp.at, clamp.outline(foot))).collect();
    // Tools go over straps, unless the file says how high they go.
    let retract = plan.part.fixture.retract;
    let proposed = plan.clamping_of(setup.number).into_iter();
    let proposed = proposed.filter(|clamping| clamping.proposed && retract.is_some());
    let proposed = proposed.flat_map(|clamping| &clamping.clamps);
    let proposed = proposed.map(|at| (*at, Outline::Round(*at, foot))).collect();
    let both: [(Vec<(Point, Outline)>, _, _); 2] =
        [(unmeasured, Severity::Wrong, "ways-over-clamps"), (proposed, Severity::Note, "ways-over-proposed-clamps")];
    for (clamps, severity, code) in both {
        let mut under: Vec<String> = Vec::new();
        let mut height = None;
        for work in &setup.works {
            let ends = std::iter::once(home).chain(work.stops.iter().map(|stop| stop.at)).chain([home]);
            let points: Vec<Point> = ends.collect();
            for ((at, outline), pair) in clamps.iter().flat_map(|one| points.windows(2).map(move |pair| (one, pair))) {
                if outline.is_hit_by_rapid(pair[0], pair[1], Micrometres::ZERO) {
                    let shown = at.shown();
                    under.extend(Some(shown.clone()).filter(|_| !under.contains(&shown)));
                    let out = work.cycles.iter().map(|cycle| cycle.out).min();
                    height = height.into_iter().chain(out).min();
                }
            }
        }
        if let Some(height) = height {
            let over = height - plan.part.datum.top;
            let note = Note::new(code).with("clamps", under.join(", ")).with("height", over);
            findings.push(Finding::of_part(severity, note));
        }
    }
    Ok(findings)
}

/// Sets the heights at which tools go from hole to hole: as the part file says; else a tool whose ways lead over
/// something that stands on the part goes over that. `home` is the place of the tool change in the drawing.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn go_over(
    works: &mut [ToolWork],
    standing: &[Standing],
    home: Point,
    plan: &Plan,
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let part = &plan.part;
    let room = Micrometres::from_mm_rounded(convention(Convention::ObstacleClearance, shop.knowledge)?.0);
    let side = Micrometres::from_mm_rounded(convention(Convention::ObstacleSide, shop.knowledge)?.0);
    for work in works {
        let radius = radius_of(work, plan);
        let ends = std::iter::once(home).chain(work.stops.iter().map(|stop| stop.at)).chain([home]);
        let points: Vec<Point> = ends.collect();
        let in_the_way = standing.iter().filter(|one| {
            // The foot about a clamp without an outline has its margin in it.
            let margin = if matches!(one.outline, Outline::Box(..)) { side } else { Micrometres::ZERO };
            let hit = |pair: &[Point]| one.outline.is_hit_by_rapid(pair[0], pair[1], radius + margin);
            points.windows(2).any(hit)
        });
        // Of two of one height what the shop has is no proposal.
        let highest = in_the_way.max_by_key(|one| (one.height, !one.proposed));
        let over = match (part.fixture.retract, highest) {
            (Some(retract), _) => retract,
            (None, Some(one)) => one.height + room,
            (None, None) => continue,
        };
        let level = (part.datum.top + over).on_grid(shop.machine.resolution);
        let mut raised = false;
        for cycle in &mut work.cycles {
            let out = if part.fixture.retract.is_some() { level.max(cycle.begin) } else { level.max(cycle.out) };
            raised |= out > cycle.out;
            cycle.out = out;
        }
        let raises = highest.filter(|_| raised && part.fixture.retract.is_none());
        work.over_straps = raises.is_some_and(|one| one.proposed);
        // How high straps of the plan's own are stands in its set-up.
        if let Some(one) = raises.filter(|one| !one.proposed) {
            let note = Note::new("goes-over").with("tool", work.tool).with("height", over);
            findings.push(Finding::of_part(Severity::Note, note.with("at", one.at.shown())));
        }
    }
    Ok(())
}
