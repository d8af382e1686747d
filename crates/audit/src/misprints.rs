//! Finds which figure was misprinted, where only the figures computed from it do not fit.
//!
//! An author who misprints a figure and continues with the right value leaves a plan in which everything computed
//! from that figure disagrees with it. The other figures show which one is at fault: a misprint explains every
//! disagreement and breaks nothing that fits. Where several figures are possible, the tables decide, then the
//! similarity to a typing error. Where nothing decides, the computed figure is reported and nothing is guessed.

use std::collections::BTreeSet;

use crate::tables::audit::Threshold;

use super::context::Context;
use super::figures::{Nature, nature};
use super::graph::{Formula, Graph, Rule, Status};
use super::mistakes;
use super::quantity::{Id, Quantity, Scope};

const MISPRINT: Rule = Rule { id: "misprinted", formula: "" };

pub(super) const RULES: &[Rule] = &[MISPRINT];

/// The most misprints of a plan; each changes one figure, and few plans have so many.
const MOST: usize = 32;

/// A figure that may have been misprinted.
struct Suspect {
    id: Id,
    /// What it should have been.
    right: f64,
    /// How many more figures fit with that value.
    mends: usize,
    /// Whether the tables give that value.
    known: bool,
    /// Whether it looks like a slip of the pen.
    slip: bool,
}

/// Finds misprinted figures one by one and corrects them.
pub(super) fn correct<'a>(context: &Context<'a>, graph: &mut Graph<'a>) {
    points(context, graph);
    for _ in 0..MOST {
        let own: Vec<Id> = graph
            .verdicts()
            .iter()
            .filter(|verdict| matches!(verdict.status, Status::Root(_, None)))
            .map(|verdict| verdict.id)
            .filter(|id| graph.computed_from_right(*id).is_none())
            .collect();
        let Some((found, computed)) = own.iter().find_map(|id| Some((explains(context, graph, *id)?, *id))) else {
            return;
        };
        graph.correct(right_value(found.id, found.right), computed);
    }
}

/// The formula of a misprinted figure: its right value.
fn right_value<'a>(id: Id, right: f64) -> Formula<'a> {
    Formula {
        rule: &MISPRINT,
        output: id,
        inputs: Vec::new(),
        numbers: String::new(),
        compute: Box::new(move |_| Some(right)),
        judge: None,
        others: None,
        because: Vec::new(),
    }
}

/// A figure taken from a table whose decimal point is misplaced, where the author went on with the right one: with the
/// point elsewhere the author's own figure fits what was computed from it, and that is surer than another one of a table.
fn points<'a>(context: &Context<'a>, graph: &mut Graph<'a>) {
    use Quantity::{CardFeed, CardForce, CardPower, CardSpeed, Feed, FeedTaken, Friction, Safety, SupportFriction};
    let of_conditions = [Feed, FeedTaken, CardFeed, CardSpeed, CardForce, CardPower];
    let conditions = (0..context.stated.conditions.len()).map(Scope::Conditions);
    let ids = conditions.flat_map(|scope| of_conditions.map(|quantity| Id::new(scope, quantity)));
    let of_clamping = [Friction, Safety, SupportFriction].map(|quantity| Id::new(Scope::Clamping, quantity));
    for id in ids.chain(of_clamping) {
        if let Some((right, computed)) = point(context, graph, id) {
            graph.correct(right_value(id, right), computed);
        }
    }
}

/// The figure with its point in the right place, and one that was computed from it; none where the point is right,
/// or where nothing tells whether the figure or what was computed from it is the slip.
fn point(context: &Context<'_>, graph: &Graph<'_>, id: Id) -> Option<(f64, Id)> {
    // A feed of a card is computed and judged by its formula.
    if graph.formula(id).is_some_and(|formula| formula.judge.is_none()) || context.stated.is_own {
        return None;
    }
    let figure = graph.printed(id)?;
    let users = graph.stated_users(id);
    let fit = |other| -> Vec<Option<bool>> { users.iter().map(|user| graph.fits_if(*user, other)).collect() };
    let before = fit(None);
    let of_table = if id.quantity == Quantity::FeedTaken { Id { quantity: Quantity::Feed, ..id } } else { id };
    let chosen = || graph.formula(id).filter(|own| own.inputs.is_empty()).and_then(|own| (own.compute)(&[]));
    let table = graph.tables().get(&of_table).copied().or_else(chosen);
    let limit = |name| context.auditor.threshold(name);
    let own = limit(Threshold::PointLeast)..=limit(Threshold::PointMost);
    let like_table = |value: f64| table.map(|table| own.contains(&(value / table)));
    [0.1, 10.0, 0.01, 100.0].into_iter().find_map(|shift| {
        let right = figure.value * shift;
        let after = fit(Some((id, right)));
        let turned = |from: bool| {
            let pairs = before.iter().zip(&after).zip(&users);
            pairs.filter(move |((one, other), _)| (**one, **other) == (Some(from), Some(!from))).map(|(_, user)| *user)
        };
        let computed = turned(false).next()?;
        // What was computed from a figure that itself fits only the other feed speaks for that figure.
        let goes_on = || {
            turned(false).any(|user| {
                let own = graph.computed_if(user, None).map(|own| (user, own));
                let mut next = graph.stated_users(user).into_iter();
                next.any(|one| graph.fits_if(one, None) == Some(true) && graph.fits_if(one, own) == Some(false))
            })
        };
        let proven = match (like_table(figure.value), like_table(right)) {
            (Some(false), Some(true)) => true,
            (Some(true), Some(false)) => false,
            _ => turned(false).count() > 1 || goes_on(),
        };
        (turned(true).next().is_none() && proven).then_some((right, computed))
    })
}

/// The misprint that explains a computed figure. A formula that was got wrong in a usual way needs none, unless the misprint explains
/// more than that one figure or is a slip of the decimal point.
fn explains(context: &Context<'_>, graph: &Graph<'_>, computed: Id) -> Option<Suspect> {
    let found = misprinted(graph, computed)?;
    let stated = graph.printed(found.id)?.value;
    let point = nature(stated, found.right) == Nature::DecimalPoint
        && found.right < context.auditor.threshold(Threshold::MisprintLargest);
    (found.mends > 1 || point || !is_usual_mistake(context, graph, computed)).then_some(found)
}

/// Whether a figure is what comes out of its formula by a usual mistake.
fn is_usual_mistake(context: &Context<'_>, graph: &Graph<'_>, id: Id) -> bool {
    let known = graph.formula(id).zip(graph.printed(id));
    !context.stated.is_own
        && known.is_some_and(|(formula, figure)| mistakes::recognised(context, graph, formula, figure).is_some())
}

/// The figure whose misprint explains why a computed figure does not fit; none if the computed figure itself is
/// wrong, or several are possible.
fn misprinted(graph: &Graph<'_>, computed: Id) -> Option<Suspect> {
    let suspects: Vec<Suspect> =
        graph.stated_inputs(computed).into_iter().filter_map(|id| suspect(graph, id, computed)).collect();
    let most = suspects.iter().map(|suspect| suspect.mends).max()?;
    let own = graph.computed_if(computed, None)?;
    // How many figures would fit if the slip were its own, and whether its consequences contradict that.
    let users = graph.stated_users(computed).into_iter();
    let users: Vec<(Option<bool>, Option<bool>)> =
        users.map(|user| (graph.fits_if(user, None), graph.fits_if(user, Some((computed, own))))).collect();
    let alone = !users.contains(&(Some(true), Some(false)));
    let mended = 1 + users.iter().filter(|pair| **pair == (Some(false), Some(true))).count();
    if alone && mended > most {
        return None;
    }
    let slip = graph.printed(computed).is_some_and(|figure| is_slip(&figure.text, figure.value, own));
    let mut best: Vec<Suspect> = suspects.into_iter().filter(|one| one.mends == most).collect();
    if most == 1 || mended == most && alone {
        // Only the computed figure itself is in its favour, or it was computed wrong and used further.
        let known = best.iter().any(|one| one.known);
        if !known && slip && alone {
            return None;
        }
        best.retain(|one| one.known || (!known && one.slip));
    }
    for mark in [|one: &Suspect| one.known, |one: &Suspect| one.slip] {
        if best.len() > 1 && best.iter().any(mark) {
            best.retain(mark);
        }
    }
    if best.len() == 1 { best.pop() } else { None }
}

/// The right value of a figure, if its misprint explains why a computed one does not fit.
fn suspect(graph: &Graph<'_>, id: Id, computed: Id) -> Option<Suspect> {
    // A figure that its formula gives is no misprint, and one that differs from its formula is reported already.
    if graph.formula(id).is_some_and(|formula| formula.judge.is_none()) {
        return None;
    }
    let figure = graph.printed(id)?;
    let users: BTreeSet<Id> = graph.stated_users(id);
    let before: Vec<Option<bool>> = users.iter().map(|user| graph.fits_if(*user, None)).collect();
    let mends = |right: f64| -> Option<usize> {
        let other = Some((id, right));
        if graph.fits_if(computed, other) != Some(true) || graph.fits_if(id, other) == Some(false) {
            return None;
        }
        let after: Vec<Option<bool>> = users.iter().map(|user| graph.fits_if(*user, other)).collect();
        let breaks = before.iter().zip(&after).any(|pair| matches!(pair, (Some(true), Some(false))));
        let mended = before.iter().zip(&after).filter(|pair| matches!(pair, (Some(false), Some(true))));
        (!breaks).then(|| mended.count())
    };
    // The rapids of our order of the holes are an estimate; a plan with others is right too.
    let known = graph.tables().get(&id).copied().filter(|_| id.quantity != Quantity::RapidTime);
    let same = |one: f64, other: f64| graph.within_tolerance(id, one, other);
    // The figure agrees with the tables, so it is right.
    if known.is_some_and(|known| same(figure.value, known)) {
        return None;
    }
    let solved = solutions(graph, id, figure.value, computed).into_iter();
    let rounded = solved.flat_map(|value| (0..4).map(move |more| rounded(value, figure.last_place, more)));
    let (right, mends) = known.into_iter().chain(rounded).find_map(|right| Some((right, mends(right)?)))?;
    let known = known.is_some_and(|known| same(right, known));
    Some(Suspect { id, right, mends, known, slip: is_slip(&figure.text, figure.value, right) })
}

/// The values of a figure that give the computed one as stated, where the result is proportional to the figure or to
/// its reciprocal, or is the figure itself.
fn solutions(graph: &Graph<'_>, id: Id, value: f64, computed: Id) -> Vec<f64> {
    let Some(target) = graph.printed(computed).map(|figure| figure.value) else { return Vec::new() };
    let other = value * 1.25 + 0.125;
    let at = |value: f64| graph.computed_if(computed, Some((id, value)));
    let (Some(one), Some(two)) = (at(value), at(other)) else { return Vec::new() };
    let share = (target - one) / (two - one);
    let line = value + share * (other - value);
    let reciprocal = 1.0 / (1.0 / value + share * (1.0 / other - 1.0 / value));
    [line, reciprocal, target].into_iter().filter(|value| value.is_finite()).collect()
}

/// A value rounded to the printed places and `more` further ones.
fn rounded(value: f64, last_place: f64, more: i32) -> f64 {
    let place = last_place * libm::pow(10.0, f64::from(-more));
    libm::round(value / place) * place
}

/// Whether a misprinted value looks like a typing error: decimal point, sign, one digit, or two digits exchanged.
fn is_slip(text: &str, stated: f64, right: f64) -> bool {
    if nature(stated, right) != Nature::Figure {
        return true;
    }
    let places = text.split_once('.').map_or(0, |(_, part)| part.len());
    let printed = format!("{right:.places$}");
    let whole = printed.parse().is_ok_and(|value: f64| (value - right).abs() <= 1e-9 * right.abs().max(1.0));
    if !whole || text.len() != printed.len() {
        return false;
    }
    let off: Vec<(u8, u8)> = text.bytes().zip(printed.bytes()).filter(|(a, b)| a != b).collect();
    match off.as_slice() {
        // With a single digit, any other value differs in one digit.
        [_] => text.bytes().filter(u8::is_ascii_digit).skip_while(|digit| *digit == b'0').count() > 2,
        [(a, b), (c, d)] => a == d && b == c,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::is_slip;

    #[test]
    fn slips_of_the_pen_are_told_from_other_values() {
        for (text, right) in
            [("2830", 283.0), ("0.283", 283.0), ("54.58", 44.58), ("13.39", 13.93), ("13.93", 19.33), ("-50", 50.0)]
        {
            assert!(is_slip(text, text.parse().unwrap(), right), "{text} for {right}");
        }
        for (text, right) in [("977", 1489.1), ("26.52", 42.14)] {
            assert!(!is_slip(text, text.parse().unwrap(), right), "{text} for {right}");
        }
    }
}
