//! The values that a plan by hand takes from tables: feeds, points and factors of the cards, rapids. The rule
//! `audit-by-table` says how far they may differ.
//!
//! A value so far off that it is wrong is replaced by that of the table, so that what was computed from the right one
//! stays right, and what was computed from it follows from it.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note, Severity};
use crate::plan::{CuttingMethod, Operation};
use crate::tables::audit::{AuditByTableFor, Tabulated};
use crate::tables::cutting::CardPoints;
use crate::units::round_to;

use super::super::context::Context;
use super::super::figures::{Nature, nature, shown};
use super::super::graph::{Formula, Graph, Rule};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::fixed_figure;

const FAR: Rule = Rule { id: "audit-by-table", formula: "" };

/// The figures of a card taken from a row of another transition.
const CARD_ROW: Rule = Rule { id: "audit-card-row", formula: "" };

pub(super) const RULES: &[Rule] = &[FAR, CARD_ROW];

/// What the rule says of a figure beside its table.
pub(crate) struct Judged {
    /// How grave.
    pub severity: Severity,
    /// How far it is.
    pub note: Note,
    /// The rows behind it.
    pub because: Vec<Because>,
}

/// Judges a stated figure by its table; none if nothing is to be said.
pub(crate) fn judged(context: &Context<'_>, id: Id, value: f64, table: f64) -> Result<Option<Judged>, KnowledgeError> {
    let Some(quantity) = kind(context, id).filter(|_| table > 0.0) else { return Ok(None) };
    let question = |of_table| AuditByTableFor { quantity, of_table };
    let (share, asked) = context.by_share(value / table, question)?;
    let Some(rule) = asked.winner()? else { return Ok(None) };
    // A misplaced decimal point is reported as such.
    let slip = Some(nature(value, table)).filter(|own| rule.severity <= Severity::Wrong && *own != Nature::Figure);
    let note = Note::new(slip.map_or("audit-by-table", Nature::code));
    let note = note.with("share", round_to(share, 0)).with("value", Figure::number(shown(table)));
    let why = Because::answer(&asked.answer, Note::new("audit-limit"));
    let because = rows(context, id).into_iter().chain([why]).collect();
    Ok(Some(Judged { severity: rule.severity, note, because }))
}

/// The figures that are wrong by their tables, each with the value of its table. A figure that another formula
/// computes, or that what was computed from it shows to be misprinted, is judged there.
pub(in super::super) fn far_off<'a>(
    context: &'a Context<'a>,
    graph: &Graph<'a>,
) -> Result<Vec<Formula<'a>>, KnowledgeError> {
    let mut found = Vec::new();
    // In a plan of the program every figure is compared with the new plan.
    for (&id, &table) in graph.tables().iter().filter(|_| !context.stated.is_own) {
        if is_of_speed(context, id)? {
            continue;
        }
        let Some(figure) = context.stated.figure(id).filter(|_| graph.formula(id).is_none()) else { continue };
        if let Some(note) = card_row(context, graph, id)? {
            let mut formula = fixed_figure(&CARD_ROW, id, table, rows(context, id));
            formula.judge = Some(Box::new(move |_, _| Some((Severity::Wrong, note.clone()))));
            found.push(formula);
            continue;
        }
        let Some(own) = judged(context, id, figure.value, table)?.filter(|own| own.severity <= Severity::Wrong) else {
            continue;
        };
        let mut formula = fixed_figure(&FAR, id, table, own.because);
        let said = (own.severity, own.note);
        formula.judge = Some(Box::new(move |_, _| Some(said.clone())));
        found.push(formula);
    }
    Ok(found)
}

/// The figures of a card, with those of its points.
const CARD: [Q; 4] = [Q::CardFeed, Q::CardSpeed, Q::CardForce, Q::CardPower];

/// What is said of a figure of the card, where all that the plan takes from the card stand in the row of another transition, and the tables
/// have something against one of them. Of fewer than three figures nobody can tell.
fn card_row(context: &Context<'_>, graph: &Graph<'_>, id: Id) -> Result<Option<Note>, KnowledgeError> {
    let operation = operation(context, id).filter(|_| CARD.contains(&id.quantity));
    let Some(operation) = operation.filter(|_| context.stated.method == CuttingMethod::Card) else { return Ok(None) };
    let stated = |quantity| context.stated.figure(Id { quantity, ..id }).map(|figure| figure.value);
    let own = CARD.map(stated);
    if own.iter().flatten().count() < 3 {
        return Ok(None);
    }
    let points = context.shop.knowledge.rows::<CardPoints<'_>>()?;
    let printed = |row: &&CardPoints<'_>| {
        let figures = [row.feed.0, row.speed.0, row.thrust.0, row.power.0];
        own.iter().zip(figures).all(|(own, figure)| own.is_none_or(|own| (own - figure).abs() < 1e-9))
    };
    let Some(row) = points.iter().filter(|row| row.operation != operation).find(printed) else { return Ok(None) };
    for quantity in CARD {
        let id = Id { quantity, ..id };
        let both = stated(quantity).zip(graph.tables().get(&id));
        if let Some((value, table)) = both
            && judged(context, id, value, *table)?.is_some()
        {
            let note = Note::new("audit-card-row").with("operation", Figure::operation(row.operation.name()));
            return Ok(Some(note.with("diameter", row.diameter)));
        }
    }
    Ok(None)
}

/// A spindle speed of a program that is the slip where its feed per turn looks like one: the feed per minute is that of our plan, and the
/// speed is farther from it. How grave the feed per turn makes it, and our speed, 1/min.
pub(crate) fn slip_of_speed(context: &Context<'_>, at: usize) -> Result<Option<(Severity, f64)>, KnowledgeError> {
    let id = |quantity| Id::new(Scope::Conditions(at), quantity);
    let figure = |quantity| context.stated.figure(id(quantity)).map(|figure| figure.value);
    let conditions = context.stated.conditions.get(at).filter(|own| context.stated.is_of_program() && !own.rounds);
    let ours = conditions.and_then(|own| context.reference(*own.rows.first()?));
    let figures = figure(Q::Rpm).zip(figure(Q::MinuteFeed));
    let Some((ours, (rpm, minute))) = ours.filter(|ours| ours.operation != Operation::Tap).zip(figures) else {
        return Ok(None);
    };
    let (own, table) = (&ours.conditions, ours.conditions.feed_mm_per_rev.0);
    let Some(off) = judged(context, id(Q::Feed), minute / rpm, table)? else { return Ok(None) };
    let as_meant = judged(context, id(Q::Feed), minute / own.spindle_rpm.0, table)?;
    let away = |value: f64, ours: f64| libm::log(value / ours).abs();
    let farther = away(rpm, own.spindle_rpm.0) > away(minute, own.feed_mm_per_min.0);
    let better = as_meant.is_none_or(|meant| meant.severity > off.severity);
    Ok((better && farther).then_some((off.severity, own.spindle_rpm.0)))
}

/// The feed of conditions as it was meant: as stated, or that of the table where the stated one is wrong by it.
pub(super) fn feed(context: &Context<'_>, at: usize) -> Result<Option<f64>, KnowledgeError> {
    let conditions = &context.stated.conditions[at];
    let id = Id::new(Scope::Conditions(at), Q::Feed);
    let Some(figure) = context.stated.figure(Id { quantity: conditions.feed(), ..id }) else { return Ok(None) };
    let reference = conditions.rows.first().and_then(|row| context.reference(*row));
    let Some(table) = reference.map(|own| own.conditions.feed_mm_per_rev.0) else { return Ok(Some(figure.value)) };
    let wrong = judged(context, id, figure.value, table)?.is_some_and(|own| own.severity <= Severity::Wrong);
    Ok(Some(if wrong { table } else { figure.value }))
}

/// Whether a feed per turn is off because the spindle speed is.
pub(crate) fn is_of_speed(context: &Context<'_>, id: Id) -> Result<bool, KnowledgeError> {
    match id {
        Id { scope: Scope::Conditions(at), quantity: Q::Feed, .. } => Ok(slip_of_speed(context, at)?.is_some()),
        _ => Ok(false),
    }
}

/// The quantity as the rule names it; none if the rule does not judge it.
fn kind(context: &Context<'_>, id: Id) -> Option<Tabulated> {
    match id.quantity {
        Q::Feed if operation(context, id) == Some(Operation::CentreDrill) => Some(Tabulated::SpotFeed),
        Q::Feed if operation(context, id).is_some_and(Operation::is_reaming) => Some(Tabulated::ReamerFeed),
        Q::Feed => Some(Tabulated::Feed),
        Q::CardFeed | Q::CardSpeed | Q::CardForce | Q::CardPower => Some(Tabulated::Card),
        Q::FactorFeed | Q::FactorSpeed | Q::FactorForce | Q::FactorPower => Some(Tabulated::Factor),
        Q::RapidTime => Some(Tabulated::Rapid),
        _ => None,
    }
}

/// The transition of the conditions.
fn operation(context: &Context<'_>, id: Id) -> Option<Operation> {
    let Scope::Conditions(at) = id.scope else { return None };
    let row = *context.stated.conditions.get(at)?.rows.first()?;
    Some(context.stated.rows.get(row)?.operation.value)
}

/// The rows behind the feed of the table.
fn rows(context: &Context<'_>, id: Id) -> Vec<Because> {
    let Scope::Conditions(at) = id.scope else { return Vec::new() };
    let first = context.stated.conditions.get(at).and_then(|own| own.rows.first().copied());
    let reference = first.filter(|_| id.quantity == Q::Feed).and_then(|row| context.same_transition(row));
    reference.map(|own| own.conditions.because.iter().take(1).cloned().collect()).unwrap_or_default()
}
