//! The planner: the one place where a later stage's refusal makes an earlier one try the next alternative.
//!
//! Holes are planned from the smallest up, because a drill of a smaller hole may be the first drill of a
//! larger one. For each hole the candidates of [`crate::route::scheme`] are tried in order: diameters,
//! cutters, holders and conditions either accept a candidate or refuse it with a reason, and the first
//! one accepted is taken. Then the tools of the whole part are put together.

mod fit;
mod magazine;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity};
use crate::part::{Bottom, Hole, Part};
use crate::plan::{Clamping, CuttingMethod, Operation, Plan, Route, Times};
use crate::route::scheme::{self, Candidates};
use crate::route::{Candidate, diameters};
use crate::shop::Shop;
use crate::units::{Micrometres, round_to};
use crate::{sequence, setup, tooling};

use fit::{Fitted, Fitting};

/// A group of holes on the way: its candidate and fitted steps, when one was accepted.
struct Draft {
    route: Option<Route>,
    steps: Vec<Fitted>,
}

/// Plans a part.
///
/// # Errors
/// The knowledge base lacks something planning asks of it. A hole that cannot be made is a finding of
/// the plan, not an error.
pub fn plan(part: &Part, method: CuttingMethod, knowledge: &Knowledge) -> Result<Plan, KnowledgeError> {
    let shop = Shop::new(part, method, knowledge)?;
    let mut findings = Vec::new();
    let mut in_magazine: Vec<Micrometres> = Vec::new();
    let mut order: Vec<usize> = (0..part.holes.len()).collect();
    order.sort_by_key(|&index| (part.holes[index].diameter.nominal, index));
    let mut drafts: Vec<Option<Draft>> = part.holes.iter().map(|_| None).collect();
    for index in order {
        let draft = hole(&part.holes[index], part, &in_magazine, &shop, &mut findings)?;
        in_magazine.extend(
            draft
                .steps
                .iter()
                .filter(|fitted| fitted.step.operation == Operation::Drill)
                .map(|fitted| fitted.step.diameter),
        );
        drafts[index] = Some(draft);
    }
    let mut drafts: Vec<Draft> = drafts.into_iter().flatten().collect();
    magazine::choose_centre_drill(part, &mut drafts, &shop, &mut findings)?;
    let (holes, tools) = magazine::number_tools(part, drafts, &shop, &mut findings);

    let clamping = match setup::clamping(part, &holes, &shop)? {
        None => None,
        Some(Ok(clamping)) => {
            findings.extend(start_point(part, &clamping, &shop));
            Some(clamping)
        }
        Some(Err(note)) => {
            findings.push(Finding::of_part(Severity::Error, note));
            None
        }
    };
    let (visits, time) = match u32::try_from(tools.len()) {
        Ok(count) if count > 0 => sequence::sequence(part, &holes, count, &shop.machine),
        _ => (Vec::new(), Times::default()),
    };
    reach_of_table(part, &shop, &mut findings);
    let mut plan =
        Plan { part: part.clone(), cutting: method, holes, tools, clamping, sequence: visits, time, findings };
    unconfirmed(&mut plan);
    plan.findings.sort_by(|a, b| (a.severity, &a.hole, &a.note).cmp(&(b.severity, &b.hole, &b.note)));
    plan.findings.dedup();
    Ok(plan)
}

/// Plans one group of holes: the first candidate that every stage accepts.
fn hole(
    hole: &Hole,
    part: &Part,
    in_magazine: &[Micrometres],
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<Draft, KnowledgeError> {
    let nothing = Draft { route: None, steps: Vec::new() };
    let mut report = |severity, note| findings.push(Finding::of_hole(severity, &hole.name, note));
    if hole.bottom == Bottom::Flat {
        report(Severity::Error, Note::new("flat-bottom-not-planned"));
        return Ok(nothing);
    }
    let fitting = Fitting::new(hole, part, shop)?;
    let drills =
        tooling::drill_diameters(|drill| fitting.drill_reach(drill), hole.through, shop.knowledge, &shop.machine)?;
    let candidates = match Refusal::split(scheme::candidates(hole, part, &drills, shop))? {
        Ok(candidates) => candidates,
        Err(note) => {
            report(Severity::Error, note);
            return Ok(nothing);
        }
    };
    let sizes =
        diameters::Sizes { drills: &drills, in_magazine, smallest_bore: smallest_bore(shop)?, single_drill: false };
    let mut refused = Vec::new();
    for candidate in &candidates.schemes {
        match Refusal::split(try_candidate(candidate, hole, &sizes, &fitting, shop))? {
            Ok(steps) => {
                if candidate.finish_elsewhere || candidates.stages_end_elsewhere {
                    report(Severity::Note, Note::new("finish-elsewhere").with("scheme", &candidate.scheme));
                }
                if steps.iter().any(|fitted| fitted.step.operation.is_boring() && fitted.step.passes > 1) {
                    report(Severity::Note, Note::new("bar-set-by-hand"));
                }
                for note in fitting.beyond(&steps, part.blank.thickness) {
                    report(Severity::Error, note);
                }
                let chamfered =
                    steps.iter().flat_map(|fitted| &fitted.because).any(|why| why.note.code == "spot-by-chamfer");
                if let (Some(chamfer), false) = (hole.chamfer, chamfered) {
                    report(
                        Severity::Wrong,
                        Note::new("chamfer-not-planned").with("chamfer", chamfer).with("widest", fitting.widest_spot),
                    );
                }
                let route = route(candidate, &candidates, refused);
                return Ok(Draft { route: Some(route), steps });
            }
            Err(note) => refused.push(note.with("scheme", &candidate.scheme)),
        }
    }
    report(
        Severity::Error,
        Note::new("no-route").with("diameter", &hole.diameter.written).with("tried", refused.len()),
    );
    for note in refused {
        report(Severity::Error, note);
    }
    Ok(nothing)
}

/// Tries a candidate with two drills where the rule prefers them, then with one.
fn try_candidate(
    candidate: &Candidate,
    hole: &Hole,
    sizes: &diameters::Sizes<'_>,
    fitting: &Fitting<'_, '_>,
    shop: &Shop<'_>,
) -> Tried<Vec<Fitted>> {
    let steps = diameters::steps(candidate, hole, sizes, shop)?;
    if !steps.iter().any(|step| step.operation == Operation::DrillOut) {
        return fitting.fit(steps, candidate.finish_elsewhere);
    }
    match fitting.fit(steps, candidate.finish_elsewhere) {
        Ok(mut fitted) => {
            fitting.compare_with_one_drill(&mut fitted)?;
            Ok(fitted)
        }
        Err(Refusal::Not(why)) => {
            let single = diameters::Sizes { single_drill: true, ..*sizes };
            let steps = diameters::steps(candidate, hole, &single, shop)?;
            // The first reason is the one to tell: the second attempt is only a way around it.
            fitting.fit(steps, candidate.finish_elsewhere).map_err(|_| Refusal::Not(why))
        }
        Err(error) => Err(error),
    }
}

fn route(candidate: &Candidate, candidates: &Candidates, refused: Vec<Note>) -> Route {
    let mut because = vec![candidates.stages.clone()];
    because.extend(candidate.because.clone());
    if !refused.is_empty() {
        because.push(Because {
            table: candidate.table.clone(),
            row: None,
            source: None,
            place: "planner".to_owned(),
            reason: None,
            unconfirmed: None,
            note: Note::new("candidates-refused").with("count", refused.len()),
            rejected: refused,
        });
    }
    Route {
        table: candidate.table.clone(),
        scheme: candidate.scheme.clone(),
        finish_elsewhere: candidate.finish_elsewhere,
        centre_tolerance_mm: candidates.centre_tolerance,
        because,
    }
}

/// The smallest hole a boring bar of the catalogs enters.
fn smallest_bore(shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let bars = shop.knowledge.table("boring-bars")?;
    Ok(bars.all_rows().filter_map(|row| row.length("diameter_min").ok()).min().unwrap_or_default())
}

/// The tool-change position against the safe distance from a clamp's screw (textbook 1.11).
fn start_point(part: &Part, clamping: &Clamping, shop: &Shop<'_>) -> Option<Finding> {
    let start = sequence::tool_change_point(part, &shop.machine);
    let nearest = clamping.clamps.iter().map(|clamp| clamp.distance(start)).min()?;
    (nearest < clamping.safe_distance_mm).then(|| {
        let note = Note::new("start-near-clamp")
            .with("distance", round_to(nearest.to_mm(), 0))
            .with("needed", clamping.safe_distance_mm);
        Finding::of_part(Severity::Note, note)
    })
}

/// The blank must be light enough for the table, and the holes must lie within its travel.
fn reach_of_table(part: &Part, shop: &Shop<'_>, findings: &mut Vec<Finding>) {
    if let Some(mass) = part.mass_kg.filter(|mass| *mass > shop.machine.load_max_kg) {
        let note = Note::new("too-heavy").with("mass", mass).with("limit", shop.machine.load_max_kg);
        findings.push(Finding::of_part(Severity::Error, note));
    }
    let points = || part.holes.iter().flat_map(|hole| &hole.at);
    let axes = [
        ("X", points().map(|point| point.x).collect::<Vec<_>>(), shop.machine.travel_x),
        ("Y", points().map(|point| point.y).collect::<Vec<_>>(), shop.machine.travel_y),
    ];
    for (axis, values, travel) in axes {
        if let (Some(low), Some(high)) = (values.iter().min(), values.iter().max())
            && *high - *low > travel
        {
            let note = Note::new("beyond-travel").with("axis", axis).with("span", *high - *low).with("travel", travel);
            findings.push(Finding::of_part(Severity::Error, note));
        }
    }
}

/// Every row the plan rests on that is not fully trusted, once each, and what a card could not give.
fn unconfirmed(plan: &mut Plan) {
    let mut found: Vec<Finding> = Vec::new();
    let mut look = |because: &[Because], hole: Option<&str>| {
        for reason in because {
            if reason.note.code == "card-point-forces-differ" {
                let hole = hole.map(str::to_owned);
                found.push(Finding { severity: Severity::Doubtful, hole, note: reason.note.clone() });
            }
            let Some(why) = &reason.unconfirmed else { continue };
            let note = Note::new("unconfirmed")
                .with("table", &reason.table)
                .with("row", reason.row.map_or_else(|| "-".to_owned(), |row| row.to_string()))
                .with("why", why);
            match found.iter_mut().find(|finding| finding.note == note) {
                // Said of several groups, it is said of the part.
                Some(known) if known.hole.as_deref() != hole => known.hole = None,
                Some(_) => {}
                None => found.push(Finding { severity: Severity::Doubtful, hole: hole.map(str::to_owned), note }),
            }
        }
    };
    for hole in &plan.holes {
        if let Some(route) = &hole.route {
            look(&route.because, Some(&hole.name));
        }
        for transition in &hole.transitions {
            look(&transition.because, Some(&hole.name));
            look(&transition.conditions.because, Some(&hole.name));
        }
    }
    for tool in &plan.tools {
        look(&tool.because, None);
    }
    if let Some(clamping) = &plan.clamping {
        look(&clamping.because, None);
    }
    plan.findings.extend(found);
}
