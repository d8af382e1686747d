//! One drill or two, by the rule `two-pass-drilling` and the handbook.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::holes::FirstDrill;
use crate::tables::rules::TwoPassDrillingFor;
use crate::units::Micrometres;

use super::super::bores::Bore;
use super::super::{RouteStep, handbook};
use super::Sizes;

/// Splits the drilling in two where the rule `two-pass-drilling` or the handbook says so.
pub(super) fn two_passes(
    steps: &mut Vec<RouteStep>,
    bore: &Bore,
    sizes: &Sizes<'_>,
    shop: &Shop<'_>,
) -> Result<(), KnowledgeError> {
    let Some(index) = steps.iter().position(|step| step.operation == Operation::Drill) else { return Ok(()) };
    let diameter = steps[index].diameter;
    if let Some(row) = handbook::row(bore, shop)?
        && let Some(first) = handbook::first_drill(&row)
        && handbook::last_drill(&row) == diameter
        && !sizes.single_drill
        && sizes.drills.contains(&first)
    {
        let note = Note::new("handbook-first-drill").with("first", first).with("diameter", diameter);
        split(steps, index, first, Because::row(row.row, note.clone()), Because::row(row.row, note));
        return Ok(());
    }
    let share = shop.knowledge.need("two-pass drilling", |_: &FirstDrill<'_>| true)?;
    let (share_min, share_max) = (share.share_min, share.share_max);
    let [low, high] = [share_min, share_max].map(|share| Micrometres::from_mm_rounded(diameter.to_mm() * share));
    let inside = |drills: &[Micrometres]| drills.iter().copied().filter(|drill| (low..=high).contains(drill)).max();
    let at_hand = inside(sizes.in_magazine);
    let in_magazine = at_hand.is_some() && !sizes.single_drill;
    let material_group = shop.material.group;
    let question = TwoPassDrillingFor { diameter, material_group, first_drill_in_magazine: in_magazine };
    let answer = shop.knowledge.ask(&question)?;
    let note = |code: &'static str| Note::new(code).with("diameter", diameter).with("low", low).with("high", high);
    if answer.need("this drill")?.passes < 2 {
        steps[index].because.push(Because::answer(&answer.answer, note("one-pass")));
        return Ok(());
    }
    // Without a drill at hand: the smallest drill of the range gives the least thrust.
    let first = at_hand.or_else(|| sizes.drills.iter().copied().find(|drill| (low..=high).contains(drill)));
    let Some(first) = first else { return Ok(()) };
    let why = Because::answer(&answer.answer, note("two-passes").with("first", first));
    let note = note("first-drill").with("first", first).with("share-min", share_min).with("share-max", share_max);
    split(steps, index, first, Because::row(share.row, note), why);
    // Where one drill is enough by itself, the first one is in the magazine only for another hole.
    let alone = shop.knowledge.ask(&TwoPassDrillingFor { first_drill_in_magazine: false, ..question })?;
    steps[index].borrowed = at_hand.is_some() && alone.need("this drill")?.passes < 2;
    Ok(())
}

/// Inserts a first drill before the drill at `index`, which then widens the hole of the first.
fn split(steps: &mut Vec<RouteStep>, index: usize, first: Micrometres, of_first: Because, of_second: Because) {
    let second = &mut steps[index];
    second.operation = Operation::DrillOut;
    second.from = first;
    second.because.push(of_second);
    let mut drill = RouteStep::plain(Operation::Drill, second.place, first, Micrometres::ZERO);
    drill.because.push(of_first);
    steps.insert(index, drill);
}
