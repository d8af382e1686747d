//! What holds the part: clamps of the plan's own must not be the reason why a tool does not reach its depth.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::job::{self, Body, Cycle, CycleKind};
use crate::note::{Finding, Note, Severity};
use crate::part::{Face, Holding, Point, Standing};
use crate::plan::{Clamping, HolePlan, Plan};
use crate::sequence;
use crate::setup;
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

/// The plan with clamps, a vice or a chuck, and what is to be said of them.
///
/// Straps of the plan's own stand over the face, and tools go over them: the quill may then lack the travel for the depth of a hole.
/// Other places are tried, with them more and lower straps, and a vice, until the job runs as it would with nothing on the face. Where
/// nothing helps, the plan has no clamps, and the finding says how low a fixture must be.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn held(mut plan: Plan, shop: &Shop<'_>) -> Result<(Plan, Vec<Finding>), KnowledgeError> {
    let mut findings = Vec::new();
    if plan.part.fixture.holding == Some(Holding::Chuck) && !plan.tools.is_empty() {
        match setup::jaws(&plan.part, &plan.holes, shop)? {
            Ok(jaws) => jaws.hold(&mut plan),
            Err(why) => findings.push(Finding::of_part(Severity::Wrong, why)),
        }
    } else {
        findings = strapped(&mut plan, shop)?;
    }
    // Where stops and supports stand nobody says.
    let open = plan.part.holes.iter().filter_map(|hole| Some((hole, hole.slot?.open?)));
    findings.extend(open.map(|(hole, _)| {
        let note = Note::new("slot-runs-out").with("beyond", hole.diameter.nominal).with("depth", hole.depth);
        Finding::of_hole(Severity::Doubtful, &hole.name, note)
    }));
    for face in [Face::Entry, Face::Back] {
        let (cleared, finding) = out_of_the_way(plan, face, shop)?;
        plan = cleared;
        findings.extend(finding);
    }
    // How far a ring gives way between three jaws, and its holes with it when they let go, is not reckoned.
    if let (Some(chuck), Some(bore)) = (&plan.setup.chuck, plan.part.blank.bore) {
        let note = Note::new("chuck-squeezes-ring").with("wall", (plan.part.blank.length - bore).half());
        findings.push(Finding::of_part(Severity::Doubtful, note.with("force", chuck.force_n.0)));
    }
    Ok((plan, findings))
}

/// Straps in both set-ups, or where these do not hold the part jaws, which hold it in both; what is to be said of them.
fn strapped(plan: &mut Plan, shop: &Shop<'_>) -> Result<Vec<Finding>, KnowledgeError> {
    let entry: Vec<HolePlan> = plan.holes.iter().map(|one| setup::of_face(one, Face::Entry)).collect();
    let (clamping, mut findings) = setup::clamping(&plan.part, &entry, shop)?;
    plan.clamping = clamping;
    if let Some(jaws) = setup::jaws_instead(&plan.part, &plan.holes, &mut findings, shop)? {
        jaws.hold(plan);
        return Ok(findings);
    }
    if !findings.is_empty()
        && let Some(uneven) = setup::uneven_clamping(&plan.part, &plan.holes, Face::Entry, shop)?
    {
        plan.clamping = Some(uneven);
        findings.clear();
    }
    let (clamping, mut unheld) = setup::second_clamping(&plan.part, &plan.holes, shop)?;
    plan.setup.second_clamping = clamping;
    // What straps do not hold turned over, jaws hold in both set-ups.
    if findings.is_empty()
        && let Some(jaws) = setup::jaws_instead(&plan.part, &plan.holes, &mut unheld, shop)?
    {
        jaws.hold(plan);
    } else if !unheld.is_empty()
        && let Some(uneven) = setup::uneven_clamping(&plan.part, &plan.holes, Face::Back, shop)?
    {
        plan.setup.second_clamping = Some(uneven);
        unheld.clear();
    }
    findings.extend(unheld);
    Ok(findings)
}

/// The plan with clamps of its own on a face that keep no tool from its work.
fn out_of_the_way(plan: Plan, face: Face, shop: &Shop<'_>) -> Result<(Plan, Option<Finding>), KnowledgeError> {
    let Some(own) = clamping_of(&plan, face).filter(|own| own.proposed) else { return Ok((plan, None)) };
    let (with, in_strap) = (faults(&plan, shop)?, near_straps(&plan, shop)?.sure);
    if with.is_empty() && in_strap.is_none() {
        return Ok((plan, None));
    }
    let bare = clamped(&plan, face, None);
    let without = faults(&bare, shop)?;
    let own_fault = with.iter().find(|fault| !without.contains(fault)).filter(|_| with.len() > without.len());
    let Some(why) = own_fault.cloned().or(in_strap) else { return Ok((plan, None)) };
    let (mut tried, mut best): (BTreeMap<usize, usize>, Option<(usize, Plan)>) = (BTreeMap::new(), None);
    let most = shop.share(HoleDefault::ClampSetsTried)? as usize;
    for set in setup::clampings(&plan.part, &plan.holes, face, shop)? {
        let count = tried.entry(set.clamps.len()).or_default();
        *count += 1;
        if *count > most {
            continue;
        }
        let other = clamped(&plan, face, Some(set));
        if !is_as_good(&other, &without, shop)? {
            continue;
        }
        // Of sets that leave the quill its travel, and no holder in a strap, the one that fewest unknown holders come near to.
        let near = near_straps(&other, shop)?;
        if near.sure.is_some() {
            continue;
        }
        if best.as_ref().is_none_or(|(least, _)| near.maybe < *least) {
            best = Some((near.maybe, other));
        }
        if near.maybe == 0 {
            break;
        }
    }
    if let Some((0, best)) = best {
        return Ok((best, None));
    }
    let obstacles = !plan.part.fixture.obstacles.is_empty();
    if face == Face::Entry
        && !obstacles
        && let Ok(jaws) = setup::jaws(&plan.part, &plan.holes, shop)?
    {
        let mut other = bare.clone();
        jaws.hold(&mut other);
        if is_as_good(&other, &without, shop)? {
            return Ok((other, None));
        }
    }
    if let Some((_, best)) = best {
        return Ok((best, None));
    }
    let height = own.strap.map(|strap| strap.height_mm).unwrap_or_default();
    let most = lowest(&plan, face, &without, shop)?;
    let note = Note::new("straps-in-the-way").with("why", why).with("height", height).with("most", most);
    let note = if face == Face::Back { Note::new("in-second-set-up").with("why", note) } else { note };
    // Nothing then holds the part.
    Ok((bare, Some(Finding::of_part(Severity::Wrong, note))))
}

/// How high what stands at the places of the straps may be, in whole mm.
fn lowest(plan: &Plan, face: Face, without: &[Note], shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let Some(own) = clamping_of(plan, face) else { return Ok(Micrometres::ZERO) };
    let mut lower = own.clone();
    let step = Micrometres::from_mm_rounded(1.0);
    while let Some(strap) = &mut lower.strap
        && strap.height_mm > step
    {
        strap.height_mm = strap.height_mm - step;
        let lowered = clamped(plan, face, Some(lower.clone()));
        if is_as_good(&lowered, without, shop)? && near_straps(&lowered, shop)?.sure.is_none() {
            break;
        }
    }
    Ok(lower.strap.map(|strap| strap.height_mm).unwrap_or_default())
}

fn clamping_of(plan: &Plan, face: Face) -> Option<&Clamping> {
    plan.clamping_of(if face == Face::Back { 2 } else { 1 })
}

/// The plan with other clamps on a face.
fn clamped(plan: &Plan, face: Face, clamping: Option<Clamping>) -> Plan {
    let mut plan = plan.clone();
    match face {
        Face::Entry => plan.clamping = clamping,
        Face::Back => plan.setup.second_clamping = clamping,
    }
    plan
}

/// What keeps the job of a plan from running on the machine.
fn faults(plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Note>, KnowledgeError> {
    let mut timed = plan.clone();
    timed.findings.clear();
    sequence::timed(&mut timed, shop)?;
    let wrong = timed.findings.into_iter().filter(|finding| finding.severity <= Severity::Wrong);
    Ok(wrong.map(|finding| finding.note).collect())
}

/// What is above the cutters and meets straps of the plan's own.
#[derive(Default)]
struct Near {
    /// A holder of known thickness that meets one.
    sure: Option<Note>,
    /// How many tools have a holder that meets one if it is as thick as it can be.
    maybe: usize,
}

fn near_straps(plan: &Plan, shop: &Shop<'_>) -> Result<Near, KnowledgeError> {
    let job = job::make(plan, shop)?;
    let top = plan.part.datum.top;
    let mut near = Near::default();
    for setup in &job.setups {
        let straps: Vec<&Standing> = setup.standing.iter().filter(|one| one.proposed).collect();
        for work in &setup.works {
            // The point, how low the body comes there, and how high the strap stands.
            let meets = |body: &Body| {
                work.stops.iter().find_map(|stop| {
                    let cycle = work.cycles.get(stop.cycle)?;
                    let low = cycle.end + body.from;
                    let (to, aside) = reach(cycle, stop.at);
                    let hit = |one: &&&Standing| one.outline.is_hit(stop.at, to, body.diameter.half() + aside);
                    let strap = straps.iter().filter(|one| low < top + one.height).find(hit)?;
                    Some((stop.at.shown(), low - top, strap.height))
                })
            };
            let bodies = || job.envelopes.iter().filter(|one| one.tool == work.tool).flat_map(|one| &one.bodies);
            let sure = bodies().filter(|body| body.known).find_map(|body| Some((body.diameter, meets(body)?)));
            if let Some((diameter, (at, low, height))) = sure.filter(|_| near.sure.is_none()) {
                let note =
                    Note::new("holder-in-strap").with("tool", work.tool).with("at", at).with("diameter", diameter);
                near.sure = Some(note.with("low", low).with("height", height));
            }
            near.maybe += usize::from(bodies().any(|body| !body.known && meets(body).is_some()));
        }
    }
    Ok(near)
}

/// Where the tool's axis goes in a cycle at a point: to the other end of a slot, and how far beside that line.
fn reach(cycle: &Cycle, at: Point) -> (Point, Micrometres) {
    match &cycle.kind {
        CycleKind::Slot(slot) => (slot.run.far(at), slot.reach()),
        CycleKind::Circles { radii, .. } => (at, radii.iter().copied().max().unwrap_or_default()),
        _ => (at, Micrometres::ZERO),
    }
}

/// Whether a plan has no more faults than with nothing on the face.
fn is_as_good(plan: &Plan, without: &[Note], shop: &Shop<'_>) -> Result<bool, KnowledgeError> {
    Ok(faults(plan, shop)?.len() <= without.len())
}
