//! The planner: the only room where the refusal of a later stage makes an earlier stage try the next alternative.
//!
//! Holes are planned from the smallest up, because the drill of a smaller hole may be the first drill of a larger
//! one. For each hole, the candidates of the three sources ([`crate::route`]) are turned into steps with tools and
//! conditions, or refused with a reason (`options`). The routes of all holes are then chosen together, so that they
//! share tools (`choose`). At last the tools of the whole part are collected (`magazine`).
//!
//! - `options`: the routes of a group; `sources`: how routes are found, tried and filed;
//! - `finer`: holes that another machine finishes;
//! - `nearest`: what is possible beside a hole that is not;
//! - `whole`: the steps of a whole hole for one candidate; `step_drill`: hole and opening by one drill;
//! - `fit`: cutter, holder and conditions of each step, with `fit/centring` and `fit/reach`.

mod choose;
mod finer;
mod fit;
mod holding;
mod magazine;
mod names;
mod nearest;
mod options;
mod slots;
mod sources;
mod step_drill;
mod whole;

use crate::error::{KnowledgeError, Refusal};
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Figure, Finding, Note, Severity, doubtful_row};
use crate::part::{Face, Hole, Part};
use crate::plan::{Clamping, CuttingMethod, Feature, Plan, Preference, Route, Setup, Times};
use crate::route::Remark;
use crate::shop::Shop;
use crate::tables::cutting::Process;
use crate::tables::materials::ClampScrew;
use crate::units::round_to;
use crate::{sequence, setup, tooling, zone};

use choose::{Chooser, ComparedRoutes};
pub use fit::feed_travel;
use fit::{Fitted, Fitting};
use nearest::TappedBy;
use options::{Choice, Options};

/// Of so many groups without a route the nearest possible hole is looked for: each costs as much as ten other groups.
const MOST_NEAREST: usize = 20;

/// The draft of a group's plan: its route and fitted steps, if a route was accepted.
struct HoleDraft {
    route: Option<Route>,
    steps: Vec<Fitted>,
}

/// Plans a part.
///
/// # Errors
/// The knowledge base lacks a rule or row that planning needs. A hole that cannot be made is a finding of the plan,
/// not an error.
pub fn plan(part: &Part, method: CuttingMethod, knowledge: &Knowledge) -> Result<Plan, KnowledgeError> {
    plan_by(part, method, Preference::Best, knowledge)
}

/// Plans a part by the schemes of the tables, wherever they can be carried out, and reports what the best plan would
/// save.
///
/// # Errors
/// As for [`plan`].
pub fn plan_by_tables(part: &Part, method: CuttingMethod, knowledge: &Knowledge) -> Result<Plan, KnowledgeError> {
    let best = plan(part, method, knowledge)?;
    let mut plan = plan_by(part, method, Preference::Tables, knowledge)?;
    let saves = plan.time.total_min.0 - best.time.total_min.0;
    if saves > 0.0 && !best.has_errors() {
        let (own_time, best_time) = (plan.time.total_min, best.time.total_min);
        let note = Note::new("tables-preferred").with("own", own_time.0).with("best", best_time.0);
        plan.findings.push(Finding::of_part(Severity::Note, note.with("saves", round_to(saves, 2))));
        Finding::in_order(&mut plan.findings);
    }
    Ok(plan)
}

/// Plans a part by one preference, without comparison with the other.
///
/// # Errors
/// As for [`plan`].
pub fn plan_by(
    part: &Part,
    method: CuttingMethod,
    preference: Preference,
    knowledge: &Knowledge,
) -> Result<Plan, KnowledgeError> {
    let shop = Shop::new(part, method, knowledge)?;
    let mut findings = Vec::new();
    let drills = tooling::drill_sizes(&shop)?;
    let mut order: Vec<usize> = (0..part.holes.len()).collect();
    // Sorted by the figures of a group, not by its name; names only break ties.
    order.sort_by_cached_key(|&index| {
        let hole = &part.holes[index];
        let (grade, roughness) = (hole.diameter.it, hole.roughness);
        let mut points = hole.at.clone();
        points.sort_unstable();
        (hole.diameter.nominal, grade, roughness, hole.depth, points, &hole.name)
    });
    let mut chooser = Chooser::new(part, preference, &shop)?;
    let mut told = 0;
    for &index in &order {
        let hole = &part.holes[index];
        match Refusal::split(options::options(hole, part, preference, (&chooser.drills(), &drills), &shop))? {
            Ok(mut options) => {
                if options.choices.is_empty() && options.impossible.is_empty() && told < MOST_NEAREST {
                    told += 1;
                    // Another depth helps only where depth is a reason.
                    let deep = options.refused.iter().any(|other| other.why.is_of_depth());
                    let drills = (&*chooser.drills(), &*drills);
                    options.nearest = nearest::nearest((hole, deep), part, preference, drills, &shop)?;
                    options.other_machine = nearest::machine(hole, part, preference, &shop)?;
                }
                chooser.add(index, options);
            }
            Err(why) => findings.push(Finding::of_hole(Severity::Error, &hole.name, why.note())),
        }
    }
    chooser.settle(&order);
    let mut drafts = Vec::with_capacity(part.holes.len());
    for (index, hole) in part.holes.iter().enumerate() {
        drafts.push(draft(index, hole, part, &mut chooser, &shop, &mut findings)?);
    }
    magazine::choose_centre_drill(part, &mut drafts, &shop, &mut findings)?;
    for (draft, hole) in drafts.iter().zip(&part.holes) {
        let doubts = draft.steps.iter().flat_map(|fitted| &fitted.doubts);
        findings.extend(doubts.map(|doubt| Finding::of_hole(Severity::Doubtful, &hole.name, doubt.note())));
    }
    let (holes, tools) = magazine::number_tools(part, drafts, &shop, &mut findings);

    let visits = sequence::sequence(part, &holes, &shop.machine, None);
    let bare = Plan {
        part: part.clone(),
        cutting: method,
        holes,
        tools,
        clamping: None,
        setup: Setup::default(),
        sequence: visits,
        visiting: Vec::new(),
        time: Times::default(),
        findings: Vec::new(),
    };
    let (mut plan, of_holding) = holding::held(bare, &shop)?;
    if let Some(clamping) = &plan.clamping {
        findings.extend(start_point(part, clamping, &shop)?);
    }
    findings.extend(of_holding);
    plan.setup.own = setup::own(part, &plan.holes, &shop)?;
    let held = setup::held_by(plan.held(1));
    let setup::Chains { zeros, chains, findings: of_chains } = setup::chains(part, &plan.holes, held, &shop)?;
    findings.extend(of_chains);
    plan.visiting = sequence::visiting::visiting(part, &plan.holes, &shop, &mut findings)?;
    let off_table = zone::off_table(part, &shop)?;
    findings.extend(off_table.iter().map(|fault| Finding::of_part(fault.severity(), fault.note())));
    findings.extend(names::lookalike_names(part));
    findings.extend(doubtful_row(shop.material.row));
    if let Some(state) = part.material_state {
        let by = (Process::Drilling, ToolMaterial::HighSpeedSteel);
        findings.extend(technolog_cutting::state::without_force(&shop.material, state, by, knowledge)?);
    }
    (plan.setup.zeros, plan.setup.chains) = (zeros, chains);
    plan.findings = findings;
    sequence::timed(&mut plan, &shop)?;
    // Every plan is checked by the proof, however it was chosen.
    plan.findings.extend(technolog_proof::prove(&plan, &shop)?);
    let (fixture, of_fixture) = setup::fixture(&plan, &shop)?;
    plan.setup.fixture = fixture;
    plan.findings.extend(of_fixture);
    unconfirmed(&mut plan);
    Finding::in_order(&mut plan.findings);
    Ok(plan)
}

/// A group's draft: the chosen route, the routes it was compared with, and the notes.
fn draft(
    index: usize,
    hole: &Hole,
    part: &Part,
    chooser: &mut Chooser<'_, '_>,
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<HoleDraft, KnowledgeError> {
    let mut report = |severity, note| findings.push(Finding::of_hole(severity, &hole.name, note));
    let compared = chooser.comparison(index)?;
    let chosen = chooser.chosen[index];
    let Some(options) = &chooser.options[index] else { return Ok(HoleDraft { route: None, steps: Vec::new() }) };
    for note in &options.impossible {
        report(Severity::Error, note.clone());
    }
    for note in &options.doubtful {
        report(Severity::Doubtful, note.clone());
    }
    for note in &options.remarks {
        report(Severity::Note, note.clone());
    }
    let (Some(compared), Some(choice)) = (compared, chosen.and_then(|chosen| options.choices.get(chosen))) else {
        report(
            Severity::Error,
            Note::new("no-route").with("diameter", &hole.diameter).with("tried", options.refused.len()),
        );
        for (note, schemes) in by_reason(options) {
            let note = if schemes.is_empty() {
                note
            } else {
                note.with("scheme", Figure::list(schemes.iter().map(|scheme| Figure::scheme(scheme))))
            };
            report(Severity::Error, note);
        }
        for nearest in options.nearest.iter().chain(&options.other_machine) {
            report(Severity::Note, nearest.clone());
        }
        return Ok(HoleDraft { route: None, steps: Vec::new() });
    };
    let steps = choice.steps.clone();
    if let Some(left) = steps.last().filter(|fitted| fitted.step.operation.is_only_elsewhere()) {
        report(Severity::Note, finer::remark(hole, left));
    } else if choice.candidate.finish_elsewhere {
        let here = steps.iter().map(|fitted| &fitted.step).filter(|step| !step.elsewhere);
        let opened = here.filter(|step| step.place.feature == Feature::Bore).map(|step| step.diameter).max();
        let note = Note::new("finish-elsewhere").with("scheme", Figure::scheme(&choice.candidate.scheme));
        report(
            Severity::Note,
            note.with("stock", hole.diameter.target() - opened.or(hole.state.diameter()).unwrap_or_default()),
        );
    }
    if options.not_bored {
        report(Severity::Doubtful, Note::new("not-bored"));
    }
    for missed in &choice.untold {
        report(Severity::Wrong, missed.clone().with("scheme", Figure::scheme(&choice.candidate.scheme)));
    }
    if steps.iter().any(|fitted| fitted.step.operation.is_set_by_hand(fitted.step.passes)) {
        report(Severity::Note, Note::new("bar-set-by-hand"));
    }
    let remarks = steps.iter().flat_map(|Fitted { step, .. }| step.remarks.iter().map(move |remark| (step, remark)));
    for (step, remark) in remarks {
        match remark {
            Remark::FinishedElsewhere(finished) => {
                report(Severity::Note, Note::new("step-finished-elsewhere").with("diameter", finished));
            }
            Remark::EndsAboveFloor(left) => {
                let depth = step.place.depth + *left - step.place.start;
                let own = step.place.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
                let it = own.map_or(hole.diameter.it, |own| own.diameter.it);
                let much = step.leaves_unfinished(it, shop)?.is_some();
                let severity = if much { Severity::Wrong } else { Severity::Doubtful };
                let main = (step.place.feature == Feature::Bore).then_some(&hole.diameter);
                let cylinder = own.map(|own| &own.diameter).or(main).map_or(step.diameter, |own| own.nominal);
                let note = Note::new("ends-above-floor").with("left", left).with("diameter", cylinder);
                report(severity, note.with("depth", depth));
            }
            Remark::LeadUnknown { lead, room } => {
                let note = Note::new("reamer-lead-unknown").with("depth", step.place.depth).with("lead", lead);
                report(Severity::Doubtful, note.with("room", room));
            }
            Remark::BoughtFor { nominal, it } => {
                let note = Note::new("bought-for").with("operation", Figure::operation(step.operation.name()));
                let note = note.with("nominal", nominal).with("it", it).with("size", step.diameter);
                report(Severity::Doubtful, note);
            }
            Remark::Promised { it: grade, own } => {
                let note = Note::new("promised-finer").with("it", grade).with("own", own);
                report(Severity::Doubtful, note.with("table", &choice.candidate.table));
            }
        }
    }
    if let Some(tap) = steps.iter().find(|fitted| nearest::taps_elsewhere(&fitted.step)) {
        let thread = hole.thread_at(tap.step.place.step).map_or("", |thread| thread.written.as_str());
        let told = |code: &str| Note::new(code.to_owned()).with("thread", thread);
        let word = |id: String| Figure::word_of("machine", id);
        let here = word(part.machine.clone());
        match nearest::tapped_by(hole, &tap.step, part, shop)? {
            TappedBy::Machine(id) => {
                report(Severity::Note, told("tap-elsewhere").with("machine", here).with("other", word(id)));
            }
            TappedBy::None(Some((id, why))) => {
                let note = told("tap-nowhere").with("machine", here).with("other", word(id));
                report(Severity::Doubtful, note.with("why", why.note()));
            }
            TappedBy::None(None) => report(Severity::Doubtful, told("no-machine-taps").with("machine", here)),
        }
    }
    if steps.iter().any(|fitted| fitted.step.place.face == Face::Back) {
        report(Severity::Note, Note::new("second-setup"));
    }
    let fitting = Fitting::new(hole, &[], part, shop)?;
    for note in fitting.cut_beyond_hole(&steps, part.blank.thickness) {
        report(Severity::Error, note);
    }
    Ok(HoleDraft { route: Some(route(choice, options, compared)), steps })
}

/// Why the routes of a group were refused: each reason once, with the schemes it kept out.
fn by_reason(options: &Options) -> Vec<(Note, Vec<String>)> {
    let mut reasons: Vec<(Note, Vec<String>)> = Vec::new();
    for other in &options.refused {
        let scheme = (!other.scheme.is_empty()).then(|| other.scheme.clone());
        let why = other.why.note();
        match reasons.iter_mut().find(|(note, _)| *note == why) {
            Some((_, schemes)) => schemes.extend(scheme.filter(|scheme| !schemes.contains(scheme))),
            None => reasons.push((why, scheme.into_iter().collect())),
        }
    }
    reasons
}

fn route(choice: &Choice, options: &Options, compared: ComparedRoutes) -> Route {
    let candidate = &choice.candidate;
    let mut because: Vec<Because> = options.stages.iter().cloned().collect();
    because.extend(candidate.because.clone());
    Route {
        source: candidate.source,
        table: candidate.table.clone(),
        scheme: candidate.scheme.clone(),
        finish_elsewhere: candidate.finish_elsewhere,
        meets: choice.meets_requirements(),
        centre_tolerance_mm: options.centre_tolerance,
        time_min: compared.time,
        cost: compared.cost,
        margin_min: compared.margin,
        alternatives: compared.alternatives,
        because,
    }
}

/// Checks the tool-change position against the safe distance from the screw of a clamp (textbook 1.11).
fn start_point(part: &Part, clamping: &Clamping, shop: &Shop<'_>) -> Result<Option<Finding>, KnowledgeError> {
    let start = sequence::tool_change_point(part, &shop.machine);
    let screws: Vec<ClampScrew<'_>> = shop.knowledge.rows()?;
    // Each clamp of the file may have a screw of its own.
    let needed = |index: usize| {
        let own = part.fixture.clamps.get(index).and_then(|clamp| clamp.screw.as_deref());
        let own = screws.iter().find(|screw| Some(screw.thread) == own);
        own.map_or(clamping.safe_distance_mm, |screw| screw.safe_distance)
    };
    let near = clamping.clamps.iter().enumerate().map(|(index, at)| (start.distance(*at), needed(index)));
    let near = near.filter(|(distance, needed)| distance < needed).min_by_key(|(distance, needed)| *distance - *needed);
    Ok(near.map(|(distance, needed)| {
        let note = Note::new("start-near-clamp").with("distance", round_to(distance.to_mm(), 2)).with("needed", needed);
        Finding::of_part(Severity::Note, note)
    }))
}

/// Adds a note for every row under the plan that is not fully trusted, once each.
fn unconfirmed(plan: &mut Plan) {
    let mut found: Vec<Finding> = Vec::new();
    let mut look = |because: &[Because], hole: Option<&str>| {
        for reason in because {
            let Some(note) = reason.doubt() else { continue };
            match found.iter_mut().find(|finding| finding.note == note) {
                // If it concerns several groups, it is a finding of the part.
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
    for visiting in &plan.visiting {
        look(&visiting.because, Some(&visiting.hole));
    }
    for clamping in plan.clamping.iter().chain(&plan.setup.second_clamping) {
        look(&clamping.because, None);
    }
    if let Some(vice) = &plan.setup.vice {
        look(&vice.because, None);
    }
    if let Some(chuck) = &plan.setup.chuck {
        look(&chuck.because, None);
    }
    if let Some(fixture) = &plan.setup.fixture {
        look(&fixture.because, None);
    }
    for chain in &plan.setup.chains {
        look(&chain.because, Some(&chain.hole));
    }
    plan.findings.extend(found);
}
