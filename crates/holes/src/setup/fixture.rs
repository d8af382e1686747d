//! The kind of fixture, how it is keyed to the table, and how the part is located in it, by the decision tables of sections 1.6
//! to 1.9.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::part::{Base, Deviations, Part};
use crate::plan::{Clamping, FixturePlan, HeldBy, Plan, TableKeying, Vice};
use crate::shop::Shop;
use crate::tables::materials::{KeyingFit, SettingError, SettingErrorOf};
use crate::tables::rules::{FixtureKeyingFor, FixtureKindFor, PartLocatingFor};
use crate::units::Micrometres;

/// What holds a part.
pub const fn held_by(part: &Part, vice: Option<&Vice>, clamping: Option<&Clamping>) -> HeldBy {
    if part.fixture.own.is_some() {
        return HeldBy::Own;
    }
    match (vice, clamping) {
        (Some(_), _) => HeldBy::Vice,
        (None, Some(_)) => HeldBy::Straps,
        (None, None) => HeldBy::Nothing,
    }
}

/// The fixture of a plan with its findings; none where nothing is set up. A plate that springs under a drill is not stiff.
///
/// # Errors
/// The knowledge base has no answer.
pub fn fixture(plan: &Plan, shop: &Shop<'_>) -> Result<Option<FixturePlan>, KnowledgeError> {
    if plan.setup.stands.is_empty() {
        return Ok(None);
    }
    let held = held_by(&plan.part, plan.setup.vice.as_ref(), plan.clamping.as_ref());
    let stiff = !technolog_proof::plate_springs(plan, shop)?;
    let ask = FixtureKindFor { held, stiff, family: false };
    let answer = shop.knowledge.ask(&ask)?;
    let kind = answer.need(held.name())?.kind;
    let mut because = vec![Because::answer(&answer.answer, Note::new("fixture-kind"))];
    // A table with T-slots of which nothing else is said has neither cross slot nor central hole.
    let keying = if shop.machine.slots {
        let answer = shop.knowledge.ask(&FixtureKeyingFor { cross_element: false, plate: false })?;
        because.push(Because::answer(&answer.answer, Note::new("fixture-keying")));
        Some(answer.need("two-keys")?.keying)
    } else {
        None
    };
    let play = keying.map(|keying| play(keying, shop)).transpose()?.flatten();
    because.extend(play.iter().map(|(_, why)| why.clone()));
    // Holes of the blank that take a pin no key of a file names. Where the drawing does not say from where it gives its sizes, it is the
    // contour.
    let dimensions = &plan.part.dimensions;
    let from_side = dimensions.iter().any(|one| matches!((&one.from, &one.to), (Base::Side(_), Base::Hole(_))));
    let ask = PartLocatingFor { fine_holes: 0.0, from_contour: dimensions.is_empty() || from_side };
    let answer = shop.knowledge.ask(&ask)?;
    because.push(Because::answer(&answer.answer, Note::new("part-locating")));
    let locating = answer.need("three-planes")?.locating;
    let error = locating_error(held, shop)?;
    because.extend(error.iter().map(|row| Because::row(row.row, Note::new("locating-error").with("most", row.most))));
    Ok(Some(FixturePlan {
        fixture_kind: kind,
        held,
        keying,
        keying_play_mm: play.map(|(play, _)| play),
        locating,
        locating_error_mm: error.map(|row| [row.least, row.most]),
        because,
    }))
}

/// How far a part is off its place from part to part, by what holds it; none for what nobody knows.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn locating_error<'k>(held: HeldBy, shop: &Shop<'k>) -> Result<Option<SettingError<'k>>, KnowledgeError> {
    let wanted = match held {
        HeldBy::Straps => SettingErrorOf::Straps,
        HeldBy::Vice => SettingErrorOf::Vice,
        HeldBy::Own | HeldBy::Nothing => return Ok(None),
    };
    shop.knowledge.need(wanted.name(), |row: &SettingError<'_>| row.name.is(wanted)).map(Some)
}

/// The greatest play of what keys a fixture: the largest hole less the smallest shaft, mm; none where the size of the slots is not
/// known.
fn play(keying: TableKeying, shop: &Shop<'_>) -> Result<Option<(Micrometres, Because)>, KnowledgeError> {
    let row = shop.knowledge.need(keying.name(), |row: &KeyingFit<'_>| row.keying == keying)?;
    let Some(size) = row.size.or(shop.machine.slot_width) else { return Ok(None) };
    let hole = Deviations::of_field(row.hole, row.hole_grade, size, shop.knowledge)?;
    let shaft = Deviations::of_field(row.shaft, row.shaft_grade, size, shop.knowledge)?;
    let Some((hole, shaft)) = hole.zip(shaft) else { return Ok(None) };
    let play = hole.upper - shaft.lower;
    let why = Note::new("keying-play").with("size", size).with("play", play);
    Ok(Some((play, Because::row(row.row, why))))
}
