//! Tools that meet what the file says stands over the face: a plan that sends a holder into a clamp is wrong before there is a program.

use crate::note::{Finding, Note, Severity};
use crate::part::{Point, Standing};
use crate::plan::Plan;
use crate::units::Micrometres;

use super::on_table::{swing, way};
use super::{Body, Envelope, SetUp, ToolWork};

/// Holders, collars and the nose of the spindle that come down into what the file gives, and tools that go through it from point to
/// point, each tool once for each thing.
///
/// A holder of unknown thickness is held as thick as its collar, than which it is no thicker as a rule: until it is measured the plan
/// is wrong, as its program is. What the plan proposes itself may be chosen lower, and is moved out of the way of known holders before;
/// beside unknown ones it is a doubt, told once.
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
    findings.extend(beside_straps(setup, plan, envelopes));
    findings
}

/// The tools whose holders of unknown thickness may meet straps of the plan's own, with the lowest of them.
fn beside_straps(setup: &SetUp, plan: &Plan, envelopes: &[Envelope]) -> Option<Finding> {
    let mut tools: Vec<String> = Vec::new();
    let mut lowest: Option<(Meeting, &Body, &Standing)> = None;
    for work in &setup.works {
        let bodies = envelopes.iter().filter(|one| one.tool == work.tool).flat_map(|one| &one.bodies);
        for body in bodies.filter(|body| !body.known) {
            for one in setup.standing.iter().filter(|one| one.proposed) {
                let Some(meeting) = deepest(work, body, one, plan) else { continue };
                let tool = format!("T{}", work.tool);
                if !tools.contains(&tool) {
                    tools.push(tool);
                }
                if lowest.as_ref().is_none_or(|(known, ..)| meeting.low < known.low) {
                    lowest = Some((meeting, body, one));
                }
            }
        }
    }
    let (meeting, body, one) = lowest?;
    let note = Note::new("holders-may-meet-straps").with("tools", tools.join(", "));
    Some(Finding::of_part(Severity::Doubtful, meeting.told(note, body, one)))
}

/// Where a body meets something, and how low it is there over the face.
struct Meeting {
    low: Micrometres,
    at: Point,
}

impl Meeting {
    fn told(&self, note: Note, body: &Body, one: &Standing) -> Note {
        let note = note.with("diameter", body.diameter).with("at", self.at.shown()).with("low", self.low);
        note.with("clamp", one.at.shown()).with("height", one.height)
    }
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
    let meeting = deepest(work, body, one, plan)?;
    let (severity, code) =
        if body.known { (Severity::Error, "holder-in-clamp") } else { (Severity::Wrong, "holder-may-meet-clamp") };
    Some(Finding::of_part(severity, meeting.told(Note::new(code).with("tool", work.tool), body, one)))
}

fn deepest(work: &ToolWork, body: &Body, one: &Standing, plan: &Plan) -> Option<Meeting> {
    let top = plan.part.datum.top;
    let meets = work.stops.iter().filter_map(|stop| {
        let low = work.cycles.get(stop.cycle)?.end + body.from - top;
        let (line, aside) = (way(work, stop), swing(work, stop.cycle));
        let meets = low < one.height && one.outline.is_hit(line.from, line.to, body.diameter.half() + aside);
        meets.then_some(Meeting { low, at: stop.at })
    });
    meets.min_by_key(|meeting| meeting.low)
}
