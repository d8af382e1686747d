//! One drill or two, by the rule `two-pass-drilling` and the handbook.

use crate::error::KnowledgeError;
use crate::knowledge::Input;
use crate::knowledge::units::Unit;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::units::Micrometres;

use super::super::bores::Bore;
use super::super::{Step, handbook};
use super::Sizes;

/// Splits the drilling in two where the rule `two-pass-drilling` or the handbook says so.
pub(super) fn two_passes(
    steps: &mut Vec<Step>,
    bore: &Bore,
    sizes: &Sizes<'_>,
    shop: &Shop<'_>,
) -> Result<(), KnowledgeError> {
    let Some(index) = steps.iter().position(|step| step.operation == Operation::Drill) else { return Ok(()) };
    let diameter = steps[index].diameter;
    if let Some(row) = handbook::row(bore, shop)?
        && let (Some(first), Some(last)) = (handbook::first_drill(row), handbook::last_drill(row))
        && last == diameter
        && !sizes.single_drill
        && sizes.drills.contains(&first)
    {
        let note = Note::new("handbook-first-drill").with("first", first).with("diameter", diameter);
        split(steps, index, first, Because::row(row, note.clone()), Because::row(row, note));
        return Ok(());
    }
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
    let why = Because::answer(&answer, note("two-passes").with("first", first));
    let note = note("first-drill").with("first", first).with("share-min", share_min).with("share-max", share_max);
    split(steps, index, first, Because::row(share, note), why);
    // Below the limit above which two drills are the rule, the first is there for another hole only.
    steps[index].borrowed = at_hand.is_some() && diameter <= share.length("above_diameter")?;
    Ok(())
}

/// Puts a first drill before the drill at `index`, which then opens what the first left.
fn split(steps: &mut Vec<Step>, index: usize, first: Micrometres, of_first: Because, of_second: Because) {
    let second = &mut steps[index];
    second.operation = Operation::DrillOut;
    second.from = first;
    second.because.push(of_second);
    let mut drill = Step::plain(Operation::Drill, second.place, first, Micrometres::ZERO);
    drill.because.push(of_first);
    steps.insert(index, drill);
}
