//! The formulas of the handbook for a plan by hand: from feed, depth of cut, diameter and tool life to speed, force,
//! torque and power, and the tool life for which they are given. The rule `audit-formula` says how far a stated
//! figure may differ and how severe a larger difference is.

use crate::cutting::factors;
use crate::cutting::handbook::{self, Handbook};
use crate::cutting::laws::{LoadLaw, SpeedLaw};
use crate::cutting::{self, Cut};
use crate::error::{KnowledgeError, Refusal};
use crate::note::{Because, Figure, Note, Severity};
use crate::plan::{CuttingMethod, Operation};
use crate::tables::audit::{AuditFormula, AuditFormulaFor, AuditThresholds, MistakenLaw, Threshold};
use crate::tables::cutting::{CuttingSpeed, TorqueAndThrust};
use crate::units::{Micrometres, MillimetresPerRev, RevsPerMinute, round_to};

use super::super::context::Context;
use super::super::figures::{Nature, nature, shown};
use super::super::graph::{Compute, Formula, Graph, Judge, Judged, Rule};
use super::super::mistakes::OtherLaw;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::{fixed_figure, formula, tabulated};

/// Whether a rule is one of the handbook's formulas of speed and loads.
pub(crate) fn is_handbook_rule(rule: &Rule) -> bool {
    [SPEED, FORCE, TORQUE, POWER].contains(rule)
}

const LIFE: Rule = Rule { id: "tool-life", formula: "T" };
const SPEED: Rule = Rule { id: "handbook-speed", formula: "V = Cv·D^q·Kv/(T^m·t^x·S^y)" };
const FORCE: Rule = Rule { id: "handbook-force", formula: "P = 10·Cp·D^q·t^x·S^y·Kp" };
const TORQUE: Rule = Rule { id: "handbook-torque", formula: "M = 10·Cm·D^q·t^x·S^y·Kp" };
const POWER: Rule = Rule { id: "handbook-power", formula: "N = M·n/9750" };

pub(super) const RULES: &[Rule] = &[LIFE, SPEED, FORCE, TORQUE, POWER];

pub(super) fn add_all<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    // In a plan of the program the figures come from these formulas, and `by-tables` checks them all.
    if context.stated.is_own {
        return Ok(());
    }
    for at in 0..context.stated.conditions.len() {
        add_formulas(context, graph, at)?;
    }
    Ok(())
}

fn add_formulas<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>, at: usize) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    let id = move |quantity| Id::new(Scope::Conditions(at), quantity);
    // With cards, only the tool life is checked against the handbook.
    if stated.method != CuttingMethod::Formula && stated.figure(id(Q::ToolLife)).is_none() {
        return Ok(());
    }
    if stated.unsaid.is_some_and(|unsaid| unsaid.material) {
        return Ok(());
    }
    let Some(cut) = cut(context, at)? else { return Ok(()) };
    // The row that applies depends on the feed, on the right one where the stated one is misprinted.
    let feed = tabulated::feed(context, at)?.map(MillimetresPerRev);
    let formulas = match feed.filter(|feed| feed.0 > 0.0) {
        Some(feed) => Refusal::split(handbook::formulas(&cut, feed, &context.shop))?.ok().flatten(),
        None => None,
    };
    let mut by_table = None;
    if let Ok(Some((life, because))) = Refusal::split(handbook::tool_life(&cut, &context.shop))? {
        let life = life.0;
        let at_step = formulas.as_ref().is_some_and(|handbook| is_at_step(context, at, handbook, cut.diameter, life));
        let by_life = formulas.as_ref().is_some_and(|own| is_by_life(context, at, own, cut.diameter, life));
        by_table = Some(life).filter(|_| at_step || by_life);
        let table = Because::table(context.shop.knowledge.table_of::<AuditFormula<'_>>()?, Note::new("audit-limit"));
        let mut formula = fixed_figure(&LIFE, id(Q::ToolLife), life, because.into_iter().chain([table]));
        formula.judge = Some(Box::new(move |value, _| match at_step {
            true => None,
            false => judged(context, Q::ToolLife, value, life),
        }));
        graph.add(formula);
    }
    if let Some(formulas) = formulas.filter(|_| stated.method == CuttingMethod::Formula) {
        // The formula of drills says nothing of the speed of a spot: centring goes as practice has it.
        if cut.operation != Operation::CentreDrill {
            speed(context, graph, at, &formulas, by_table)?;
        }
        loads(context, graph, at, &formulas)?;
    }
    Ok(())
}

/// Whether the stated tool life is that at the stated spindle speed, and not the life for which the speed was
/// computed.
///
/// Either speed or life may be misprinted: both the stated speed and that of the formula are tried.
fn is_at_step(context: &Context<'_>, at: usize, formulas: &Handbook, diameter: Micrometres, life: f64) -> bool {
    let figure = |quantity| context.stated.figure(Id::new(Scope::Conditions(at), quantity));
    let (Some(own), Some(rpm), Some(speed)) = (figure(Q::ToolLife), figure(Q::Rpm), figure(Q::Speed)) else {
        return false;
    };
    let tolerances = context.auditor.tolerances();
    let law = formulas.speed;
    let fits = |speed: f64| {
        let at_step = law.life_at(life, speed, cutting::speed_at(RevsPerMinute(rpm.value), diameter).0);
        (own.value - at_step).abs() <= tolerances.allowed_difference(Q::ToolLife, own, at_step)
    };
    fits(speed.value) || by_law(context, at, formulas, diameter, life).is_some_and(fits)
}

/// Whether the stated speed is that for the life of the table, whatever life is stated.
fn is_by_life(context: &Context<'_>, at: usize, formulas: &Handbook, diameter: Micrometres, life: f64) -> bool {
    let Some(speed) = context.stated.figure(Id::new(Scope::Conditions(at), Q::Speed)) else { return false };
    let by_law = by_law(context, at, formulas, diameter, life);
    by_law.is_some_and(|law| judged(context, Q::Speed, speed.value, law).is_none())
}

/// The speed by the formula for a life, at the stated feed and depth of cut.
fn by_law(context: &Context<'_>, at: usize, formulas: &Handbook, diameter: Micrometres, life: f64) -> Option<f64> {
    let figure = |quantity| context.stated.figure(Id::new(Scope::Conditions(at), quantity));
    let (feed, depth) = (tabulated::feed(context, at).ok()??, figure(Q::DepthOfCut)?);
    Some(formulas.speed.at(diameter.to_mm(), depth.value, feed, life) * formulas.speed_factor())
}

/// The cut of the conditions, as far as the formulas need it; none if the cutter is not known.
pub(super) fn cut(context: &Context<'_>, at: usize) -> Result<Option<Cut>, KnowledgeError> {
    let stated = context.stated;
    let conditions = &stated.conditions[at];
    let Some(first) =
        conditions.rows.first().copied().filter(|first| !conditions.rounds && !context.goes_round(*first))
    else {
        return Ok(None);
    };
    let row = &stated.rows[first];
    let cutter = stated.tool_of(row).and_then(|tool| context.cutter(tool));
    let (Some(cutter), Some(hole)) = (cutter.filter(|_| !row.elsewhere), context.hole(row)) else { return Ok(None) };
    let figure = |id: Id| stated.figure(id).map(|figure| Micrometres::from_mm_rounded(figure.value));
    let reference = context.reference(first);
    let diameter = figure(Id::new(Scope::Conditions(at), Q::Diameter))
        .or_else(|| figure(Id::new(Scope::Row(first), Q::Diameter)))
        .or_else(|| reference.map(|transition| transition.diameter_mm));
    // The drawing gives the depth of the hole; a misprinted depth changes no speed.
    let depth = reference
        .map(|own| own.depth_mm - own.start_mm)
        .or_else(|| figure(Id::new(Scope::Row(first), Q::Depth)))
        // The depth of a hole that is made of a list is ours.
        .or_else(|| stated.unsaid.is_none().then_some(hole.depth))
        .unwrap_or_default();
    // Typed values may be anything; the tables end far below one metre.
    let sensible = |own: &Micrometres| (Micrometres::new(1)..=Micrometres::from_mm(1000)).contains(own);
    let Some(diameter) = diameter.filter(sensible).filter(|_| sensible(&depth)) else { return Ok(None) };
    Ok(Some(Cut {
        operation: row.operation.value,
        diameter,
        feed_diameter: None,
        tool_diameter: None,
        flutes: None,
        from: Micrometres::ZERO,
        passes: 1,
        depth,
        travel: depth,
        tool_material: cutter.head.material,
        nose_radius: None,
        roughness: None,
        reamer_follows: false,
        blind: !hole.through,
        surface: factors::surface_of(hole.skin, &context.shop)?,
        it: None,
        pitch: None,
        cutter: None,
        around: None,
        plunges: false,
        slot: None,
    }))
}

/// V = Cv·D^q·Kv/(T^m·t^x·S^y), with the factors that the plan states, else with those of the tables; T as stated, or
/// `by_table` where the plan states the life of another speed.
fn speed<'a>(
    context: &'a Context<'a>,
    graph: &mut Graph<'a>,
    at: usize,
    formulas: &Handbook,
    by_table: Option<f64>,
) -> Result<(), KnowledgeError> {
    let conditions = &context.stated.conditions[at];
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let law = formulas.speed;
    let mut inputs = vec![id(conditions.feed()), id(Q::DepthOfCut), id(Q::Diameter)];
    let life = by_table.map_or_else(|| "{3}".to_owned(), shown);
    inputs.extend(by_table.is_none().then_some(id(Q::ToolLife)));
    let first = inputs.len();
    let named = conditions.factors.get(&Q::FactorSpeed).map(Vec::as_slice).unwrap_or_default();
    // A factor without a figure may be anything.
    if named.iter().any(|factor| factor.value.is_none()) {
        return Ok(());
    }
    inputs.extend((0..named.len()).map(|index| Id { index, ..id(Q::FactorSpeed) }));
    let kv = if named.is_empty() { formulas.speed_factor() } else { 1.0 };
    let mut numbers = format!("{}·{}", shown(law.cv), power("{2}", law.q));
    if named.is_empty() {
        numbers.push_str(&format!("·{}", shown(kv)));
    }
    (0..named.len()).for_each(|index| numbers.push_str(&format!("·{{{}}}", first + index)));
    let below = [power(&life, law.m), power("{1}", law.x), power("{0}", law.y)];
    let below: Vec<String> = below.into_iter().filter(|one| !one.is_empty()).collect();
    numbers.push_str(&format!("/({})", below.join("·")));
    let with = move |law: SpeedLaw, kv: f64, without_life: bool| {
        move |values: &[f64]| {
            let [feed, depth_of_cut, diameter, more @ ..] = values else { return None };
            let (life, factors) = match by_table {
                Some(life) => (life, more),
                None => more.split_first().map(|(life, factors)| (*life, factors))?,
            };
            let life = if without_life { 1.0 } else { life };
            Some(law.at(*diameter, *depth_of_cut, *feed, life) * kv * factors.iter().product::<f64>())
        }
    };
    let compute = with(law, kv, false);
    let mut formula = formula(&SPEED, id(Q::Speed), inputs, &numbers, compute);
    let single = if named.is_empty() { formulas.speed_factors.clone() } else { Vec::new() };
    formula.others = Some(Box::new(move || {
        let other = |law, row, compute| OtherLaw { law, row, compute };
        let mut others = vec![other(MistakenLaw::WithoutLife, None, Box::new(with(law, kv, true)) as Compute<'_>)];
        others.push(other(MistakenLaw::WithoutFactors, None, Box::new(with(law, 1.0, false))));
        for factor in single.iter().filter(|factor| **factor != 1.0) {
            others.push(other(MistakenLaw::WithoutFactor, None, Box::new(with(law, kv / factor, false))));
            others.push(other(MistakenLaw::FactorInverted, None, Box::new(with(law, kv / factor / factor, false))));
        }
        for row in context.shop.knowledge.rows::<CuttingSpeed<'_>>().unwrap_or_default() {
            let SpeedLaw { q, y, m, .. } = SpeedLaw::of(&row);
            let number = Some(row.row.number());
            others.push(other(MistakenLaw::OtherRow, number, Box::new(with(SpeedLaw::of(&row), kv, false))));
            others.push(other(MistakenLaw::OtherExponent, number, Box::new(with(SpeedLaw { y, ..law }, kv, false))));
            others.push(other(MistakenLaw::OtherExponent, number, Box::new(with(SpeedLaw { q, ..law }, kv, false))));
            others.push(other(MistakenLaw::OtherExponent, number, Box::new(with(SpeedLaw { m, ..law }, kv, false))));
        }
        others
    }));
    let because = if named.is_empty() { formulas.speed_because.len() } else { 1 };
    // Where the formula is far from public tables, the program takes the speed of those tables; that speed is no
    // slip.
    let reference = conditions.rows.first().and_then(|row| context.reference(*row));
    let practice =
        reference.filter(|_| named.is_empty()).map(|transition| transition.conditions.computed_speed_m_per_min.0);
    add(context, graph, formula, (compute, practice), formulas.speed_because.iter().take(because))
}

/// P, M and N by table 32, at the feed that is taken.
fn loads<'a>(
    context: &'a Context<'a>,
    graph: &mut Graph<'a>,
    at: usize,
    formulas: &Handbook,
) -> Result<(), KnowledgeError> {
    let conditions = &context.stated.conditions[at];
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let Some((torque, thrust)) = formulas.loads else { return Ok(()) };
    // The author may mean a load factor as a divisor, as the cards do: then nothing can be said.
    let factors = [Q::FactorForce, Q::FactorPower];
    if factors.iter().any(|own| conditions.factors.get(own).is_some_and(|named| !named.is_empty())) {
        return Ok(());
    }
    let kp = formulas.load_factor;
    let inputs = vec![id(conditions.feed()), id(Q::DepthOfCut), id(Q::Diameter)];
    let load =
        move |law: LoadLaw| move |values: &[f64]| Some(law.at(*values.get(2)?, *values.get(1)?, *values.first()?) * kp);
    let because = || formulas.loads_because.iter();
    // Where the formula is far too low, the program takes the torque by the specific cutting force; that torque is no
    // slip.
    let reference = conditions.rows.first().and_then(|row| context.reference(*row));
    let specific = reference.and_then(|transition| transition.conditions.torque_n_m).map(|torque| torque.0);
    for (rule, quantity, law, also) in [(&FORCE, Q::Force, thrust, None), (&TORQUE, Q::Torque, torque, specific)] {
        let mut formula = formula(rule, id(quantity), inputs.clone(), &numbers(&law, kp), load(law));
        formula.others = Some(Box::new(move || {
            let with = |law: LoadLaw, kp: f64| -> Compute<'_> {
                Box::new(move |values| Some(law.at(*values.get(2)?, *values.get(1)?, *values.first()?) * kp))
            };
            let other = |law, row, compute| OtherLaw { law, row, compute };
            let mut others = vec![other(MistakenLaw::WithoutFactors, None, with(law, 1.0))];
            others.push(other(MistakenLaw::FactorInverted, None, with(law, 1.0 / kp)));
            for row in context.shop.knowledge.rows::<TorqueAndThrust<'_>>().unwrap_or_default() {
                let of_row = match quantity {
                    Q::Torque => LoadLaw::torque(&row),
                    _ => LoadLaw::thrust(&row),
                };
                let number = Some(row.row.number());
                others.push(other(MistakenLaw::OtherRow, number, with(of_row, kp)));
                others.push(other(MistakenLaw::OtherExponent, number, with(LoadLaw { y: of_row.y, ..law }, kp)));
            }
            others
        }));
        add(context, graph, formula, (load(law), also), because())?;
    }
    // Where the torque is stated the power follows from it.
    if context.stated.figure(id(Q::Torque)).is_none() {
        let numbers = format!("{}·{{3}}/9750", numbers(&torque, kp));
        let power = move |values: &[f64]| Some(load(torque)(values)? * values.get(3)? / 9750.0);
        let inputs = inputs.into_iter().chain([id(Q::Rpm)]).collect();
        add(context, graph, formula(&POWER, id(Q::Power), inputs, &numbers, power), (power, None), because())?;
    }
    Ok(())
}

/// A stated figure within this share of another is that figure rounded.
const AS_ROUNDED: f64 = 0.01;

/// Adds a formula judged by `audit-formula`, with the rows behind it; `compute` gives its value, and another given
/// value is as good.
fn add<'a, 'b>(
    context: &'a Context<'a>,
    graph: &mut Graph<'a>,
    mut formula: Formula<'a>,
    (compute, also): (impl Fn(&[f64]) -> Option<f64> + 'a, Option<f64>),
    because: impl Iterator<Item = &'b Because>,
) -> Result<(), KnowledgeError> {
    let table = context.shop.knowledge.table_of::<AuditFormula<'_>>()?;
    formula.because.extend(because.cloned());
    formula.because.push(Because::table(table, Note::new("audit-limit")));
    let quantity = formula.output.quantity;
    // A list gives speeds and does not say by what they were found: a slower one is the author's own.
    let chosen = context.stated.is_list && quantity == Q::Speed;
    let least = |name| threshold(context, name);
    let (least, at_step_least) = (least(Threshold::ListSpeedLeast)?, least(Threshold::ListStepSpeedLeast)?);
    // Many give the speed at the step that was taken.
    let rpm = context.stated.figure(Id::new(formula.output.scope, Q::Rpm)).map(|rpm| rpm.value);
    let slowest = move |value: f64, inputs: &[f64]| {
        let at_step = rpm.zip(inputs.get(2)).map(|(rpm, diameter)| core::f64::consts::PI * diameter * rpm / 1000.0);
        if at_step.is_some_and(|at_step| (value / at_step - 1.0).abs() < AS_ROUNDED) { at_step_least } else { least }
    };
    formula.judge = Some(Box::new(move |value, inputs| match also {
        _ if chosen && compute(inputs).is_some_and(|most| (most * slowest(value, inputs)..=most).contains(&value)) => {
            None
        }
        Some(also) if (value / also - 1.0).abs() < AS_ROUNDED => None,
        _ => judged(context, quantity, value, compute(inputs)?),
    }));
    graph.add(formula);
    Ok(())
}

fn threshold(context: &Context<'_>, name: Threshold) -> Result<f64, KnowledgeError> {
    Ok(context.shop.knowledge.need("audit-thresholds", |row: &AuditThresholds| row.name == name)?.value)
}

/// Judges n = 1000·V/(π·D), from V, π and D, where the plan leaves out its V: n is then judged as that V would be.
pub(super) fn by_unstated_speed<'a>(context: &'a Context<'a>, at: usize) -> Result<Judge<'a>, KnowledgeError> {
    let conditions = &context.stated.conditions[at];
    let named = conditions.factors.get(&Q::FactorSpeed).is_some_and(|named| !named.is_empty());
    let reference = conditions.rows.first().and_then(|row| context.reference(*row)).filter(|_| !named);
    let practice = reference.map(|transition| transition.conditions.computed_speed_m_per_min.0);
    let slowest = threshold(context, Threshold::ListSpeedLeast)?;
    Ok(Box::new(move |value, inputs| {
        let [speed, pi, diameter] = inputs else { return None };
        let rpm = |speed: f64| 1000.0 * speed / (pi * diameter);
        let most = rpm(*speed);
        let chosen = context.stated.is_list && (most * slowest..=most).contains(&value);
        if chosen || practice.is_some_and(|also| (value / rpm(also) - 1.0).abs() < AS_ROUNDED) {
            return None;
        }
        judged(context, Q::Speed, value, most)
    }))
}

/// Judges a stated figure against the value of the handbook, by the rule `audit-formula`.
fn judged(context: &Context<'_>, quantity: Q, value: f64, by_formula: f64) -> Judged {
    let question = |of_formula| AuditFormulaFor { quantity, of_formula };
    let (share, answer) = context.by_share(value / by_formula, question).ok()?;
    let severity = answer.winner().ok()??.severity;
    let nature = nature(value, by_formula);
    let code = match quantity {
        // A misplaced decimal point or a wrong sign is reported as such.
        _ if severity == Severity::Wrong && nature != Nature::Figure => nature.code(),
        Q::ToolLife => "audit-tool-life",
        _ => "audit-by-formula",
    };
    Some((severity, Note::new(code).with("share", round_to(share, 0)).with("value", Figure::number(shown(by_formula)))))
}

/// The formula of a load with `{0}` for the feed, `{1}` for the depth of cut and `{2}` for the diameter.
fn numbers(law: &LoadLaw, kp: f64) -> String {
    let powers = [power("{2}", law.q), power("{1}", law.x), power("{0}", law.y)];
    let powers: Vec<String> = powers.into_iter().filter(|one| !one.is_empty()).collect();
    format!("{}·{}·{}", shown(law.factor), powers.join("·"), shown(kp))
}

/// A power as it is printed; none if the exponent is 0.
fn power(base: &str, exponent: f64) -> String {
    if exponent == 0.0 {
        String::new()
    } else if exponent == 1.0 {
        base.to_owned()
    } else {
        format!("{base}^{}", shown(exponent))
    }
}
