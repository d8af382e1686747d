//! The kind of fixture, how it is keyed to the table, and how the part is located in it, by the decision tables of sections 1.6
//! to 1.9.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::part::Part;
use crate::plan::{Clamping, FixturePlan, HeldBy, Plan, Vice};
use crate::shop::Shop;
use crate::tables::rules::{FixtureKeyingFor, FixtureKindFor, PartLocatingFor};

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
    let answer = shop.knowledge.ask(&PartLocatingFor { fine_holes: 0.0, from_contour: true })?;
    because.push(Because::answer(&answer.answer, Note::new("part-locating")));
    let locating = answer.need("three-planes")?.locating;
    Ok(Some(FixturePlan { fixture_kind: kind, held, keying, locating, because }))
}
