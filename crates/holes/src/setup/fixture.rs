//! The kind of fixture, how it is keyed to the table, and how the part is located in it, by the decision tables of sections 1.6
//! to 1.9.

use crate::error::KnowledgeError;
use crate::note::{Because, Finding, Note};
use crate::part::{Base, Deviations, Part};
use crate::plan::{FixturePlan, Held, HeldBy, LocatingPin, PartLocating, Plan, TableKeying};
use crate::shop::Shop;
use crate::tables::materials::{KeyingFit, SettingError, SettingErrorOf};
use crate::tables::rules::{FixtureKeyingFor, FixtureKindFor, PartLocatingFor};
use crate::units::Micrometres;

use super::pins::{Pins, pins};

/// What holds a part in its first set-up, in the words of the rules.
pub const fn held_by(held: Held<'_>) -> HeldBy {
    match held {
        Held::Straps(_) => HeldBy::Straps,
        Held::Vice(_) => HeldBy::Vice,
        Held::Chuck(_) => HeldBy::Chuck,
        Held::Own(_) => HeldBy::Own,
        Held::Nothing => HeldBy::Nothing,
    }
}

/// How the part is located in its fixture, with its reason.
///
/// # Errors
/// The knowledge base has no answer.
pub fn locating(part: &Part, shop: &Shop<'_>) -> Result<(PartLocating, Because), KnowledgeError> {
    // Where the drawing does not say from where it gives its sizes, it is the contour, unless the file locates the part by holes.
    let (dimensions, pins) = (&part.dimensions, &part.fixture.pins);
    let from_side = dimensions.iter().any(|one| matches!((&one.from, &one.to), (Base::Side(_), Base::Hole(_))));
    let from_contour = from_side || dimensions.is_empty() && pins.is_empty();
    let round = part.blank.is_round();
    let answer = shop.knowledge.ask(&PartLocatingFor { fine_holes: pins.len() as f64, from_contour, round })?;
    let why = Because::answer(&answer.answer, Note::new("part-locating"));
    Ok((answer.need("three-planes")?.locating, why))
}

/// The fixture of a plan with its findings; none where nothing is set up. A plate that springs under a drill is not stiff.
///
/// # Errors
/// The knowledge base has no answer.
pub fn fixture(plan: &Plan, shop: &Shop<'_>) -> Result<(Option<FixturePlan>, Vec<Finding>), KnowledgeError> {
    if plan.setup.stands.is_empty() {
        return Ok((None, Vec::new()));
    }
    let held = held_by(plan.held(1));
    let stiff = !technolog_proof::plate_springs(plan, shop)?;
    let ask = FixtureKindFor { held, stiff, family: false, pins: !plan.part.fixture.pins.is_empty() };
    let answer = shop.knowledge.ask(&ask)?;
    let kind = answer.need(held.name())?.kind;
    let mut because = vec![Because::answer(&answer.answer, Note::new("fixture-kind"))];
    // A table with T-slots of which nothing else is said has neither cross slot nor central hole. A chuck has no keys: its axis is
    // found where it lies.
    let keying = if shop.machine.slots && held != HeldBy::Chuck {
        let answer = shop.knowledge.ask(&FixtureKeyingFor { cross_element: false, plate: false })?;
        because.push(Because::answer(&answer.answer, Note::new("fixture-keying")));
        Some(answer.need("two-keys")?.keying)
    } else {
        None
    };
    let play = keying.map(|keying| play(keying, shop)).transpose()?.flatten();
    because.extend(play.iter().map(|(_, why)| why.clone()));
    let (locating, why) = locating(&plan.part, shop)?;
    because.push(why);
    let Pins { pins, pair, because: of_pins, findings } = pins(&plan.part, locating, shop)?;
    because.extend(of_pins);
    // On a plane and two holes no side of the part touches anything, and a disc has none but for jaws.
    let on_sides = matches!(locating, PartLocating::ThreePlanes | PartLocating::TwoPlanesAndHole);
    let error = if on_sides || held == HeldBy::Chuck { locating_error(held, shop)? } else { None };
    because.extend(error.iter().map(|row| Because::row(row.row, Note::new("locating-error").with("most", row.most))));
    let of_sides = error.map(|row| [row.least, row.most]);
    // Along X and Y it may be a side or a pin that errs more.
    let of_pin = pins.first().map(|pin: &LocatingPin| pin.clearance_mm);
    let wider = |[a, b]: [Micrometres; 2], [c, d]: [Micrometres; 2]| [a.max(c), b.max(d)];
    let error = match (of_sides, of_pin) {
        (Some(sides), Some(pin)) => Some(wider(sides, pin)),
        (sides, pin) => sides.or(pin),
    };
    let fixture = FixturePlan {
        fixture_kind: kind,
        held,
        keying,
        keying_play_mm: play.map(|(play, _)| play),
        locating,
        locating_error_mm: error,
        pins,
        pair,
        because,
    };
    Ok((Some(fixture), findings))
}

/// How far a part is off its place from part to part, by what holds it; none for what nobody knows.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn locating_error<'k>(held: HeldBy, shop: &Shop<'k>) -> Result<Option<SettingError<'k>>, KnowledgeError> {
    let wanted = match held {
        HeldBy::Straps => SettingErrorOf::Straps,
        HeldBy::Vice => SettingErrorOf::Vice,
        HeldBy::Chuck => SettingErrorOf::Chuck,
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
