//! Cutting conditions: from card and factors to feed, speed, spindle step, force, power, torque and time.

use std::collections::BTreeMap;

use crate::cutting;
use crate::error::{KnowledgeError, Refusal};
use crate::knowledge::units::Percent;
use crate::note::{Because, Note, Severity};
use crate::plan::{CuttingMethod, Operation, Transition};
use crate::tables::audit::{AuditSpindleFor, Constant as Known, Constants};
use crate::tables::cutting::CardCorrections;
use crate::tables::machines::MachineQuantity;
use crate::tables::practice::{PracticeFeedFor, PracticeWork};
use crate::tables::rules::SpindleStep;
use crate::units::{RevsPerMinute, round_to};

use super::super::context::Context;
use super::super::graph::{Constant, Formula, Graph, Judged, Rule};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::{by_its_text, equal_figures, fixed_figure, formula, handbook, written};

const DEPTH: Rule = Rule { id: "depth-of-cut", formula: "t = (D − D0)/2" };
const FEED: Rule = Rule { id: "feed", formula: "S = Sт·Ks" };
const TAKEN: Rule = Rule { id: "feed-taken", formula: "S" };
const SPEED: Rule = Rule { id: "speed", formula: "V = Vт·ΠKv" };
const COMPUTED: Rule = Rule { id: "rpm-computed", formula: "n = 1000·V/(π·D)" };
const STEP: Rule = Rule { id: "spindle-step", formula: "nпр" };
const AT_STEP: Rule = Rule { id: "speed-taken", formula: "Vд = π·D·n/1000" };
const MINUTE: Rule = Rule { id: "minute-feed", formula: "Sхв = S·n" };
const FORCE: Rule = Rule { id: "force", formula: "P = Pт/Kp" };
const POWER: Rule = Rule { id: "power", formula: "N = Nт/KN" };
const POWER_OF: Rule = Rule { id: "power-of-torque", formula: "N = M·n/9750" };
const TORQUE: Rule = Rule { id: "torque-of-power", formula: "M = 9750·N/n" };
const TIME: Rule = Rule { id: "machine-time", formula: "Tм = L·i/Sхв" };
const BY_TABLES: Rule = Rule { id: "by-tables", formula: "" };

pub(super) const RULES: &[Rule] =
    &[DEPTH, FEED, TAKEN, SPEED, COMPUTED, STEP, AT_STEP, MINUTE, FORCE, POWER, POWER_OF, TORQUE, TIME, BY_TABLES];

const PI: Id = Id::new(Scope::Constant, Q::Pi);
/// The 9750 of N = M·n/9750, the second constant.
const OF_POWER: Id = Id { index: 1, ..PI };

pub(super) fn add<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    let rows = context.shop.knowledge.rows::<Constants<'_>>()?;
    let values = rows.iter().filter(|row| row.name == Known::Pi).map(|row| row.value).collect();
    graph.constant(PI, Constant { values, because: Vec::new() });
    let values = rows.iter().filter(|row| row.name == Known::Power).map(|row| row.value).collect();
    graph.constant(OF_POWER, Constant { values, because: Vec::new() });
    for at in 0..context.stated.conditions.len() {
        add_formulas(context, graph, at)?;
    }
    Ok(())
}

fn add_formulas<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>, at: usize) -> Result<(), KnowledgeError> {
    let conditions = &context.stated.conditions[at];
    let Some(first) = conditions.rows.first().copied() else { return Ok(()) };
    let row = &context.stated.rows[first];
    let operation = row.operation.value;
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let of_row = |quantity| Id::new(Scope::Row(first), quantity);
    let has = |id: Id| context.stated.figure(id).is_some();

    let rounds = conditions.rounds || context.goes_round(first);
    let axial = !rounds && !matches!(operation, Operation::Mill | Operation::Tap);
    if axial {
        depth_of_cut(context, graph, at, first, operation);
    }
    by_factors(context, graph, at, (Q::CardFeed, Q::FactorFeed, Q::Feed), &FEED, false);
    by_factors(context, graph, at, (Q::CardSpeed, Q::FactorSpeed, Q::Speed), &SPEED, false);
    by_factors(context, graph, at, (Q::CardForce, Q::FactorForce, Q::Force), &FORCE, true);
    by_factors(context, graph, at, (Q::CardPower, Q::FactorPower, Q::Power), &POWER, true);
    graph.add(equal_figures(&TAKEN, id(Q::FeedTaken), id(Q::Feed)));
    if !rounds && operation != Operation::Mill {
        let mut computed = by_its_text(&COMPUTED, id(Q::RpmComputed), vec![id(Q::Speed), PI, id(Q::Diameter)]);
        // Of a speed that the plan leaves out, and that the handbook gives, the author's may be as far from it as a stated one.
        let by_handbook = context.stated.method == CuttingMethod::Formula && !context.stated.is_own;
        if by_handbook && !has(id(Q::Speed)) && !has(id(Q::CardSpeed)) {
            computed.judge = Some(handbook::by_unstated_speed(context, at)?);
        }
        graph.add(computed);
        graph.add(by_its_text(&AT_STEP, id(Q::SpeedTaken), vec![PI, id(Q::Diameter), id(Q::Rpm)]));
    }
    spindle(context, graph, at)?;
    graph.add(by_its_text(&MINUTE, id(Q::MinuteFeed), vec![id(conditions.feed()), id(Q::Rpm)]));
    if has(id(Q::Torque)) {
        graph.add(written(&POWER_OF, id(Q::Power), vec![id(Q::Torque), id(Q::Rpm), OF_POWER], "{0}·{1}/{2}"));
    }
    if !has(id(Q::Torque)) || has(id(Q::CardPower)) {
        graph.add(torque_of_power(Scope::Conditions(at)));
    }
    // A tap returns at its feed.
    if axial {
        let passes = has(of_row(Q::Passes));
        let mut inputs = vec![id(Q::Travel), id(Q::MinuteFeed)];
        inputs.extend(passes.then_some(of_row(Q::Passes)));
        let numbers = if passes { "{0}·{2}/{1}" } else { "{0}/{1}" };
        graph.add(written(&TIME, id(Q::Time), inputs, numbers));
    }
    reference(context, graph, at, first);
    Ok(())
}

/// M = 9750·N/n, for conditions and for the clamping; N in kW, n in 1/min, M in N·m.
pub(super) fn torque_of_power<'a>(scope: Scope) -> Formula<'a> {
    let id = |quantity| Id::new(scope, quantity);
    written(&TORQUE, id(Q::Torque), vec![id(Q::Power), id(Q::Rpm), OF_POWER], "{2}·{0}/{1}")
}

/// t = (D − D0)/2, of one pass; for centring D/2.
fn depth_of_cut<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>, at: usize, first: usize, operation: Operation) {
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let of_row = |quantity| Id::new(Scope::Row(first), quantity);
    let mut inputs = vec![id(Q::Diameter)];
    let mut numbers = "{0}/2".to_owned();
    if operation != Operation::CentreDrill {
        inputs.push(of_row(Q::From));
        numbers = "({0}−{1})/2".to_owned();
    }
    if context.stated.figure(of_row(Q::Passes)).is_some() {
        numbers.push_str(&format!("/{{{}}}", inputs.len()));
        inputs.push(of_row(Q::Passes));
    }
    graph.add(written(&DEPTH, id(Q::DepthOfCut), inputs, &numbers));
}

/// A figure of the card times its factors, or divided by them. A factor without a value takes its value from other
/// conditions of the same plan.
fn by_factors<'a>(
    context: &'a Context<'a>,
    graph: &mut Graph<'a>,
    at: usize,
    (card, factor, output): (Q, Q, Q),
    rule: &'static Rule,
    divides: bool,
) {
    let stated = context.stated;
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let none = Vec::new();
    let factors = stated.conditions[at].factors.get(&factor).unwrap_or(&none);
    let mut inputs = vec![id(card)];
    let mut numbers = "{0}".to_owned();
    for (index, own) in factors.iter().enumerate() {
        let mut input = Id { index, ..id(factor) };
        if own.value.is_none() {
            let Some(elsewhere) = context.same_factor(at, factor, &own.name.value) else { return };
            input = elsewhere;
        }
        numbers.push_str(&format!("{}{{{}}}", if divides { "/" } else { "·" }, inputs.len()));
        inputs.push(input);
    }
    graph.add(written(rule, id(output), inputs, &numbers));
}

/// The spindle step: a step of the machine's series, by the rule `spindle-step`; another step is judged by the rule
/// `audit-spindle`. How far practice lets a step go is not asked here: a speed beyond it has a finding of its own.
fn spindle<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>, at: usize) -> Result<(), KnowledgeError> {
    let conditions = &context.stated.conditions[at];
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let shop = &context.shop;
    let is_limited = conditions.is_limited;
    // In a plan of the program, a speed limited by something else than the cutting speed has no step of its own here.
    let rounds = conditions.rounds || conditions.rows.first().is_some_and(|first| context.goes_round(*first));
    let unknown = context.stated.unsaid.is_some_and(|unsaid| unsaid.machine);
    if is_limited && context.stated.is_own || rounds || unknown {
        return Ok(());
    }
    if context.stated.rows[conditions.rows[0]].operation.value == Operation::Tap {
        return Ok(());
    }
    let step = move |values: &[f64]| {
        let computed = RevsPerMinute(*values.first()?);
        cutting::spindle_step(computed, None, shop).ok().map(|(step, ..)| step.0)
    };
    let series = shop.machine.row(MachineQuantity::SpindleSpeeds)?;
    let mut formula = formula(&STEP, id(Q::Rpm), vec![id(Q::RpmComputed)], "", step);
    formula.because.push(Because::row(series, Note::new("audit-series")));
    formula.because.push(Because::table(shop.knowledge.table_of::<SpindleStep<'_>>()?, Note::new("audit-step-rule")));
    // What holds our own plan to that step, as practice does, holds the author's, too, who need not name it.
    let ours = context.reference(conditions.rows[0]).map(|own| own.conditions.spindle_rpm);
    formula.judge = Some(Box::new(move |value, values| {
        let computed = *values.first()?;
        // No slower than ours and no faster than computed, at a step, is right whichever way practice is seen.
        let between =
            |ours: RevsPerMinute| ours.0 < value && value <= computed && context.steps_around(value).is_none();
        if ours.is_some_and(|ours| (ours.0 - value).abs() < 1e-6 || between(ours)) {
            return None;
        }
        // A program says nothing of how its speed was found: one of practice is as good as one of the formula.
        let of_program = ours.filter(|_| context.stated.is_of_program());
        let computed = of_program.map_or(computed, |ours| computed.max(ours.0));
        // A limit only lowers the spindle speed, and leaves it at a step of the machine.
        let slower = is_limited && value < computed && context.steps_around(value).is_none();
        if slower { None } else { judge_step(context, value, computed) }
    }));
    graph.add(formula);
    Ok(())
}

fn judge_step(context: &Context<'_>, value: f64, computed: f64) -> Judged {
    let shop = &context.shop;
    let (right, ..) = cutting::spindle_step(RevsPerMinute(computed), None, shop).ok()?;
    if (right.0 - value).abs() < 1e-6 {
        return None;
    }
    let note = |code: &'static str| {
        let excess = round_to((value / computed - 1.0) * 100.0, 1);
        Note::new(code).with("excess", excess).with("computed", round_to(computed, 1)).with("step", right.0)
    };
    if let Some(beyond) = context.beyond_series(value) {
        return Some((context.of_series(Severity::Error), beyond));
    }
    // Of a program its control says it.
    let steps = context.steps_around(value).filter(|_| !context.stated.is_of_program());
    if let Some((below, above)) = steps {
        let note = note("audit-no-step").with("below", below).with("above", above);
        return Some((context.of_series(Severity::Wrong), note));
    }
    let fastest = shop.machine.spindle_steps.last().map_or(computed, |last| last.0.min(computed));
    let excess = Percent((value / fastest - 1.0) * 100.0);
    let rule = shop.knowledge.ask(&AuditSpindleFor { excess }).ok()?.winner().ok()??;
    // Whose hand and tool nobody knows may have had a reason to go slowly.
    let slow_program = value < computed && context.stated.is_of_program();
    let severity = if slow_program { rule.severity.max(Severity::Doubtful) } else { rule.severity };
    let code = match severity {
        _ if value > computed => "audit-step-fast",
        Severity::Wrong => "audit-step-lost",
        _ => "audit-step-slow",
    };
    Some((severity, note(code)))
}

/// Table values for the figures of conditions without a formula: card points, factors, feeds, travels, spots.
pub(super) fn by_tables(context: &Context<'_>) -> Result<BTreeMap<Id, f64>, KnowledgeError> {
    let corrections = context.shop.knowledge.rows::<CardCorrections<'_>>()?;
    let group = context.shop.material.group;
    let mut known = BTreeMap::new();
    for (at, conditions) in context.stated.conditions.iter().enumerate() {
        let scope = Scope::Conditions(at);
        // In a plan by formula the author may choose the names of factors.
        let factors = conditions.factors.iter().filter(|_| context.stated.method == CuttingMethod::Card);
        for (quantity, factors) in factors {
            for (index, factor) in factors.iter().enumerate() {
                let name = factor.name.value.as_str();
                let elsewhere = context.same_factor(at, *quantity, name);
                let elsewhere = elsewhere.and_then(|id| Some(context.stated.figure(id)?.value));
                let of_card = |row: &&CardCorrections<'_>| row.name.name() == name && row.material_group == group;
                let table = corrections.iter().find(of_card).map(|row| row.factor);
                known.extend(table.or(elsewhere).map(|value| (Id { scope, quantity: *quantity, index }, value)));
            }
        }
        let Some(first) = conditions.rows.first() else { continue };
        if let Some(spot) = context.same_transition(*first) {
            known.insert(Id::new(Scope::Row(*first), Q::Diameter), spot.diameter_mm.to_mm());
        }
        let is_known = context.stated.unsaid.is_none_or(|unsaid| !unsaid.material);
        if !context.stated.is_own && is_known && context.reference(*first).is_none() {
            known.extend(feed_of_size(context, at)?.map(|feed| (Id::new(scope, Q::Feed), feed)));
        }
        let Some(reference) = context.reference(*first) else { continue };
        let own = &reference.conditions;
        let figures = [
            (Q::Feed, Some(most_fed(context, reference)?)),
            (Q::Speed, Some(own.computed_speed_m_per_min.0)),
            (Q::Travel, Some(reference.travel_mm.to_mm())),
            (Q::Force, own.axial_force_n.map(|force| force.0)),
            (Q::Torque, own.torque_n_m.map(|torque| torque.0)),
            (Q::CardFeed, own.card.as_ref().map(|card| card.feed_mm_per_rev.0)),
            (Q::CardSpeed, own.card.as_ref().map(|card| card.speed_m_per_min.0)),
            (Q::CardForce, own.card.as_ref().and_then(|card| card.axial_force_n).map(|force| force.0)),
            (Q::CardPower, own.card.as_ref().and_then(|card| card.power_kw).map(|power| power.0)),
        ];
        known.extend(figures.into_iter().filter_map(|(quantity, value)| Some((Id::new(scope, quantity), value?))));
    }
    known.insert(Id::new(Scope::Times, Q::RapidTime), context.plan.time.rapid_min.0);
    Ok(known)
}

/// The feed by which that of a transition is judged, mm/rev: our own, or for a reamer of another's plan the most of practice, because
/// where ours takes less for the surface, that is no mistake of theirs.
fn most_fed(context: &Context<'_>, reference: &Transition) -> Result<f64, KnowledgeError> {
    let own = reference.conditions.feed_mm_per_rev.0;
    if context.stated.is_own || !reference.operation.is_reaming() {
        return Ok(own);
    }
    let (material_group, diameter) = (context.shop.material.group, reference.diameter_mm);
    let question = PracticeFeedFor { operation: PracticeWork::Ream, material_group, diameter };
    let row = context.shop.knowledge.winner_within(&question)?;
    Ok(row.map_or(own, |row| own.max(row.feed_high.0)))
}

/// The feed of the table, mm/rev, of a drill that our own plan does not have. How well its hole is to be nobody says then: where a reamer
/// follows, and for other tools, the feed depends on that.
fn feed_of_size(context: &Context<'_>, at: usize) -> Result<Option<f64>, KnowledgeError> {
    let stated = context.stated;
    let first = stated.conditions.get(at).and_then(|own| own.rows.first().copied());
    let Some((first, row)) = first.and_then(|first| Some((first, stated.rows.get(first)?))) else { return Ok(None) };
    let reamed = row.hole.as_ref().is_some_and(|hole| stated.reamer_follows(&hole.value, first));
    if reamed || !matches!(row.operation.value, Operation::CentreDrill | Operation::Drill | Operation::DrillOut) {
        return Ok(None);
    }
    let Some(cut) = handbook::cut(context, at)? else { return Ok(None) };
    let feed = Refusal::split(cutting::handbook::feed(&cut, &context.shop))?;
    Ok(feed.ok().map(|(feed, _)| feed.0))
}

/// The values that `technolog plan` takes from the tables for the same transition, used as a last resort. A plan of
/// the program must have them; in another plan only missing values are taken.
fn reference<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>, at: usize, first: usize) {
    let Some(reference) = context.reference(first) else { return };
    let conditions = &reference.conditions;
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let because = || conditions.because.iter().take(2).cloned();
    let spot = reference.operation == Operation::CentreDrill;
    if spot {
        let why = reference.because.iter().filter(|why| why.table == "centre-spot").cloned();
        graph.add(fixed_figure(
            &BY_TABLES,
            Id::new(Scope::Row(first), Q::Diameter),
            reference.diameter_mm.to_mm(),
            why,
        ));
    }
    if !context.stated.is_own {
        return;
    }
    // The quantities without a formula in the route.
    for (quantity, value) in [
        (Q::Diameter, reference.diameter_mm.to_mm()),
        (Q::Depth, reference.depth_mm.to_mm()),
        (Q::Passes, f64::from(reference.passes)),
    ] {
        graph.add(fixed_figure(&BY_TABLES, Id::new(Scope::Row(first), quantity), value, because()));
    }
    let figures = [
        (Q::DepthOfCut, Some(conditions.depth_of_cut_mm)),
        (Q::Feed, Some(conditions.feed_mm_per_rev.0)),
        (Q::Speed, Some(conditions.computed_speed_m_per_min.0)),
        (Q::Rpm, Some(conditions.spindle_rpm.0)),
        (Q::SpeedTaken, Some(conditions.speed_m_per_min.0)),
        (Q::Force, conditions.axial_force_n.map(|force| force.0)),
        (Q::Torque, conditions.torque_n_m.map(|torque| torque.0)),
        (Q::Travel, Some(reference.travel_mm.to_mm())),
        (Q::Time, Some(conditions.machine_time_min.0)),
    ];
    for (quantity, value) in figures {
        if let Some(value) = value {
            graph.add(fixed_figure(&BY_TABLES, id(quantity), value, because()));
        }
    }
}
