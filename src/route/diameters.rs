//! Intermediate diameters: backwards from the finished hole, by the allowances of section 1.2.1.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, RowRef};
use crate::note::{Because, Note};
use crate::part::Hole;
use crate::plan::Operation;
use crate::shop::Shop;
use crate::units::Micrometres;

use super::{Candidate, Step};

/// What a route is turned into steps with.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<'a> {
    /// Every drill that reaches, ascending.
    pub drills: &'a [Micrometres],
    /// Drills that are in the magazine anyway, for other holes.
    pub in_magazine: &'a [Micrometres],
    /// The smallest hole a boring bar of the catalogs enters.
    pub smallest_bore: Micrometres,
    /// Whether to drill in one pass although a first drill is at hand.
    pub single_drill: bool,
}

/// The steps of a scheme for a hole, first to last; centring takes its spot later, when the drill is known.
///
/// # Errors
/// The knowledge cannot answer. That no diameters work is not an error: the inner `Err` says why.
pub fn steps(candidate: &Candidate, hole: &Hole, sizes: &Sizes<'_>, shop: &Shop<'_>) -> Tried<Vec<Step>> {
    let transitions = &candidate.transitions;
    let mut steps: Vec<Step> = Vec::new();
    let (mut after, left) = finished(candidate, hole, shop)?;
    for index in (0..transitions.len()).rev() {
        let previous = index.checked_sub(1).map(|before| transitions[before]);
        let (operation, replaced) = stand_in(transitions[index], after, sizes, shop)?;
        let mut step = match operation {
            Operation::CentreDrill => step(operation, Micrometres::ZERO, Micrometres::ZERO),
            Operation::Drill => {
                let diameter = drill(after, steps.is_empty(), candidate.finish_elsewhere, hole, sizes)?;
                step(operation, diameter, Micrometres::ZERO)
            }
            Operation::RoughBore => {
                // All but the first of the chain stand behind it; the first is handled as any step.
                let mut chain = rough_bore(after, previous, sizes, shop)?;
                let first = chain.remove(0);
                steps.extend(chain.into_iter().rev());
                first
            }
            Operation::CoreDrill
            | Operation::RoughReam
            | Operation::FinishReam
            | Operation::SemiFinishBore
            | Operation::FinishBore => finishing(operation, after, previous, hole, sizes, shop)?,
            other => return Err(Refusal::Not(Note::new("not-planned").with("operation", other.name()))),
        };
        after = step.from;
        step.because.extend(replaced);
        if steps.is_empty() {
            step.because.extend(left.clone());
        }
        steps.push(step);
    }
    steps.reverse();
    two_passes(&mut steps, sizes, shop)?;
    Ok(steps)
}

/// The diameter the route ends at: the hole's, or smaller by the stock for a finish on another machine
/// (rule `stock-for-elsewhere`).
fn finished(
    candidate: &Candidate,
    hole: &Hole,
    shop: &Shop<'_>,
) -> Result<(Micrometres, Option<Because>), KnowledgeError> {
    let target = hole.diameter.target();
    if !candidate.finish_elsewhere {
        return Ok((target, None));
    }
    let rule = shop.knowledge.table("stock-for-elsewhere")?;
    let answer = rule.decide(&[("diameter", Input::Length(target))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this diameter"))?;
    let allowances = shop.knowledge.table("allowances")?;
    let mut stock = Micrometres::ZERO;
    for name in row.texts("allowances")? {
        let allowance = allowances.find("name", name).ok_or_else(|| KnowledgeError::no_row(allowances, name))?;
        stock = stock + allowance.length("maximum")?;
    }
    Ok((target - stock, Some(Because::row(row, Note::new("stock-for-elsewhere").with("stock", stock)))))
}

fn step(operation: Operation, diameter: Micrometres, from: Micrometres) -> Step {
    Step { operation, diameter, nominal: diameter, from, passes: 1, because: Vec::new() }
}

/// What stands in where no boring bar enters, by the rule `too-small-to-bore`.
fn stand_in(
    operation: Operation,
    after: Micrometres,
    sizes: &Sizes<'_>,
    shop: &Shop<'_>,
) -> Tried<(Operation, Option<Because>)> {
    if !operation.is_boring() {
        return Ok((operation, None));
    }
    let enters = after >= sizes.smallest_bore;
    let rule = shop.knowledge.table("too-small-to-bore")?;
    let answer = rule.decide(&[("operation", Input::Text(operation.name())), ("bar_enters", Input::Bool(enters))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, operation.name()))?;
    let note = |code: &str| {
        Note::new(code)
            .with("operation", operation.name())
            .with("diameter", after)
            .with("smallest", sizes.smallest_bore)
    };
    let instead = row.text("operation_instead")?;
    match (instead, Operation::from_name(instead)) {
        ("same", _) => Ok((operation, None)),
        (_, Some(other)) => {
            Ok((other, Some(Because::row(row, note("bored-by-stand-in").with("instead", other.name())))))
        }
        _ => Err(Refusal::Not(note("too-small-to-bore"))),
    }
}

/// The drill that can make the hole itself: of its nominal diameter, or within its tolerance.
pub fn final_drill(hole: &Hole, drills: &[Micrometres]) -> Option<Micrometres> {
    let target = hole.diameter.target();
    let permitted = |drill: &Micrometres| (hole.diameter.smallest()..=hole.diameter.largest()).contains(drill);
    drills.iter().copied().find(|drill| *drill == target).or_else(|| drills.iter().copied().find(permitted))
}

/// The drill before the next transition, or the one that ends the route: of the hole's size, or the
/// largest that still leaves the stock for a finish elsewhere.
fn drill(after: Micrometres, last: bool, finish_elsewhere: bool, hole: &Hole, sizes: &Sizes<'_>) -> Tried<Micrometres> {
    let drills = sizes.drills;
    let found = match (last, finish_elsewhere) {
        (true, true) => drills.iter().rev().copied().find(|drill| *drill <= after),
        (true, false) => final_drill(hole, drills),
        (false, _) => drills.iter().copied().find(|drill| *drill == after),
    };
    found.ok_or_else(|| {
        let below = drills.iter().rev().find(|drill| **drill < after);
        let above = drills.iter().find(|drill| **drill > after);
        let show = |size: Option<&Micrometres>| size.map_or_else(|| "-".to_owned(), |size| format!("Ø{size}"));
        let note = Note::new("no-drill").with("diameter", after);
        Refusal::Not(note.with("below", show(below)).with("above", show(above)))
    })
}

/// The range of the allowance a transition removes, on diameter, and its aim.
struct Allowance<'k> {
    low: Micrometres,
    high: Micrometres,
    aim: Micrometres,
    row: RowRef<'k>,
}

fn allowance<'k>(operation: Operation, nominal: Micrometres, shop: &Shop<'k>) -> Result<Allowance<'k>, KnowledgeError> {
    let rule = shop.knowledge.table("allowance-before")?;
    let answer = rule.decide(&[("operation", Input::Text(operation.name()))])?;
    let choice = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, operation.name()))?;
    let table = shop.knowledge.table("allowances")?;
    let name = choice.text("allowance")?;
    let row = table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
    if let Ok(share) = row.number_in("share", Unit::None) {
        // A share of the diameter: no range, so the nearest size of the catalog is right.
        let aim = Micrometres::from_mm_rounded(nominal.to_mm() * share);
        return Ok(Allowance { low: Micrometres::ZERO, high: aim + aim, aim, row });
    }
    let (low, high) = (row.length("minimum")?, row.length("maximum")?);
    let share = choice.number_in("share", Unit::None)?;
    let aim = low.to_mm() + (high - low).to_mm() * share;
    Ok(Allowance { low, high, aim: Micrometres::from_mm_rounded(aim), row })
}

/// A transition that removes an allowance: the diameter before it is the aim of the range, or the drill
/// nearest to the aim where a drill makes it.
fn finishing(
    operation: Operation,
    after: Micrometres,
    previous: Option<Operation>,
    hole: &Hole,
    sizes: &Sizes<'_>,
    shop: &Shop<'_>,
) -> Tried<Step> {
    let allowance = allowance(operation, hole.diameter.nominal, shop)?;
    let (smallest, largest) = (after - allowance.high, after - allowance.low);
    let before = if previous == Some(Operation::Drill) {
        let aim = after - allowance.aim;
        let nearest = sizes
            .drills
            .iter()
            .copied()
            .filter(|drill| *drill >= smallest && *drill <= largest && *drill < after)
            .min_by_key(|drill| ((*drill - aim).abs(), *drill));
        match nearest {
            Some(drill) => drill,
            None => {
                return Err(Refusal::Not(
                    Note::new("no-drill-in-allowance")
                        .with("operation", operation.name())
                        .with("low", smallest)
                        .with("high", largest)
                        .with("diameter", after),
                ));
            }
        }
    } else {
        let aim = (after - allowance.aim).micrometres();
        // To the setting step, but never out of the range.
        let step = shop.convention("setting-step-mm")?.micrometres().max(1);
        let set = Micrometres::new((aim + step / 2).div_euclid(step) * step);
        set.max(smallest).min(largest)
    };
    let note = Note::new("allowance")
        .with("operation", operation.name())
        .with("low", allowance.low)
        .with("high", allowance.high)
        .with("taken", after - before);
    // Reamers and core drills of the catalog are ground to the size before the last one.
    let fixed = operation.is_reaming() || operation == Operation::CoreDrill;
    let nominal = if fixed { hole.diameter.nominal } else { after };
    let mut because = vec![Because::row(allowance.row, note)];
    if fixed && after != nominal {
        let note = Note::new("ground-to-size").with("nominal", nominal).with("size", after);
        because.push(Because::row(allowance.row, note));
    }
    Ok(Step { operation, diameter: after, nominal, from: before, passes: 1, because })
}

/// Rough boring opens from the largest drill that leaves at least the smallest allowance. Where the bar
/// for the final size does not enter that hole, slimmer bars open the way, one step each; each step is as
/// many equal passes as the largest allowance asks.
fn rough_bore(after: Micrometres, previous: Option<Operation>, sizes: &Sizes<'_>, shop: &Shop<'_>) -> Tried<Vec<Step>> {
    let allowance = allowance(Operation::RoughBore, after, shop)?;
    if previous != Some(Operation::Drill) {
        return Err(Refusal::Not(Note::new("not-planned").with("operation", "rough-bore")));
    }
    let largest = after - allowance.low;
    let drill = sizes.drills.iter().rev().copied().find(|drill| *drill <= largest);
    let Some(mut from) = drill else {
        return Err(Refusal::Not(
            Note::new("no-drill-before-boring")
                .with("diameter", after)
                .with("largest", largest)
                .with("smallest", sizes.smallest_bore),
        ));
    };
    let bars = shop.knowledge.table("boring-bars")?;
    let mut chain = Vec::new();
    while from < after {
        let widest = bars
            .all_rows()
            .filter(|bar| bar.text("stage") == Ok("rough") && bar.length("bar_diameter").is_ok_and(|bar| bar < from))
            .filter_map(|bar| bar.length("diameter_max").ok())
            .max()
            .unwrap_or_default();
        if widest <= from {
            return Err(Refusal::Not(Note::new("no-bar-enters").with("hole", from).with("diameter", after)));
        }
        let to = widest.min(after);
        let stock = (to - from).micrometres();
        let most = allowance.high.micrometres().max(1);
        let passes = u32::try_from((stock + most - 1) / most).unwrap_or(u32::MAX);
        let note = Note::new("rough-boring")
            .with("low", allowance.low)
            .with("high", allowance.high)
            .with("stock", to - from)
            .with("passes", passes);
        let because = vec![Because::row(allowance.row, note)];
        chain.push(Step { operation: Operation::RoughBore, diameter: to, nominal: to, from, passes, because });
        from = to;
    }
    Ok(chain)
}

/// Splits the drilling in two where the rule `two-pass-drilling` says so.
fn two_passes(steps: &mut Vec<Step>, sizes: &Sizes<'_>, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let Some(index) = steps.iter().position(|step| step.operation == Operation::Drill) else { return Ok(()) };
    let diameter = steps[index].diameter;
    let shares = shop.knowledge.table("first-drill")?;
    let share = shares.row(0).ok_or_else(|| KnowledgeError::no_row(shares, "two-pass drilling"))?;
    let (share_min, share_max) = (share.number_in("share_min", Unit::None)?, share.number_in("share_max", Unit::None)?);
    let [low, high] = [share_min, share_max].map(|share| Micrometres::from_mm_rounded(diameter.to_mm() * share));
    let inside = |drills: &[Micrometres]| drills.iter().copied().filter(|drill| (low..=high).contains(drill)).max();
    let at_hand = inside(sizes.in_magazine);
    let rule = shop.knowledge.table("two-pass-drilling")?;
    let in_magazine = at_hand.is_some() && !sizes.single_drill;
    let answer =
        rule.decide(&[("diameter", Input::Length(diameter)), ("first_drill_in_magazine", Input::Bool(in_magazine))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this drill"))?;
    let note = |code: &str| Note::new(code).with("diameter", diameter).with("low", low).with("high", high);
    if row.int("passes")? < 2 {
        steps[index].because.push(Because::answer(&answer, note("one-pass")));
        return Ok(());
    }
    // Above 30 mm with nothing at hand: the smallest drill of the range cuts with the least thrust.
    let first = at_hand.or_else(|| sizes.drills.iter().copied().find(|drill| (low..=high).contains(drill)));
    let Some(first) = first else { return Ok(()) };
    let second = &mut steps[index];
    second.operation = Operation::DrillOut;
    second.from = first;
    second.because.push(Because::answer(&answer, note("two-passes").with("first", first)));
    let mut drill = step(Operation::Drill, first, Micrometres::ZERO);
    let note = note("first-drill").with("first", first).with("share-min", share_min).with("share-max", share_max);
    drill.because.push(Because::row(share, note));
    steps.insert(index, drill);
    Ok(())
}
