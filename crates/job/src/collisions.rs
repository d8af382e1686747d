//! Tools that meet what the file says stands over the face: a plan that sends a holder into a clamp is wrong before there is a program.

use crate::note::{Finding, Note, Severity};
use crate::part::Standing;
use crate::plan::Plan;
use crate::units::Micrometres;

use super::on_table::{swing, way};
use super::{Body, Envelope, SetUp, ToolWork};

/// Holders, collars and the nose of the spindle that come down into what the file gives, and tools that go through it from point to
/// point, each tool once for each thing.
///
/// A holder of unknown thickness is a doubt: it is held as thick as its collar, than which it is no thicker as a rule. What the plan
/// proposes itself may be chosen lower, and is moved out of the way before.
pub(super) fn with_given(setup: &SetUp, plan: &Plan, envelopes: &[Envelope]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for work in &setup.works {
        let bodies: Vec<&Body> =
            envelopes.iter().filter(|one| one.tool == work.tool).flat_map(|one| &one.bodies).collect();
        for one in setup.standing.iter().filter(|one| !one.proposed) {
            let found = through(work, one, plan).or_else(|| {
                // Of a holder that is known and one that is not, the known one is sure.
                let met = |known| {
                    bodies.iter().filter(move |body| body.known == known).find_map(|body| down(work, body, one, plan))
                };
                met(true).or_else(|| met(false))
            });
            findings.extend(found);
        }
    }
    findings
}

/// A rapid from point to point that goes lower than what stands there: only a height of the file is lower.
fn through(work: &ToolWork, one: &Standing, plan: &Plan) -> Option<Finding> {
    let top = plan.part.datum.top;
    let tool = plan.tools.iter().find(|tool| tool.number == work.tool);
    let radius = tool.map(|tool| tool.diameter_mm.half()).unwrap_or_default();
    let low = work.cycles.iter().map(|cycle| cycle.out).min()? - top;
    let hit = work.stops.windows(2).find(|pair| one.outline.is_hit_by_rapid(pair[0].at, pair[1].at, radius))?;
    (low < one.height).then(|| {
        let note = Note::new("rapid-through-clamp").with("tool", work.tool).with("at", one.at.shown());
        let note = note.with("from", hit[0].at.shown()).with("to", hit[1].at.shown());
        Finding::of_part(Severity::Error, note.with("low", low).with("height", one.height))
    })
}

/// What is above a cutter in something, where it comes down deepest.
fn down(work: &ToolWork, body: &Body, one: &Standing, plan: &Plan) -> Option<Finding> {
    let top = plan.part.datum.top;
    let deep = work.stops.iter().filter_map(|stop| {
        let low = work.cycles.get(stop.cycle)?.end + body.from - top;
        let (line, aside) = (way(work, stop), swing(work, stop.cycle));
        let meets = low < one.height && one.outline.is_hit(line.from, line.to, body.diameter.half() + aside);
        meets.then_some((low, stop.at))
    });
    let (low, at): (Micrometres, _) = deep.min_by_key(|(low, _)| *low)?;
    let (severity, code) =
        if body.known { (Severity::Error, "holder-in-clamp") } else { (Severity::Doubtful, "holder-may-meet-clamp") };
    let note = Note::new(code).with("tool", work.tool).with("diameter", body.diameter).with("at", at.shown());
    let note = note.with("low", low).with("clamp", one.at.shown()).with("height", one.height);
    Some(Finding::of_part(severity, note))
}
