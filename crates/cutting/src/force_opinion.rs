//! A second source for forces: the specific cutting force and a maker's formulas, compared with those of the
//! handbook.
//!
//! The formula is the main method. If its torque is less than two thirds of the other, the rule `force-opinion` takes
//! the other, because machine and clamps must bear the larger one.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::plan::{Conditions, Operation};
use crate::practice_speed::practice_group;
use crate::shop::Shop;
use crate::tables::practice::{DrillForceFactor, DrillForceFormula, ForceConstant, SpecificCuttingForceFor};
use crate::tables::rules::ForceOpinionFor;
use crate::units::{MillimetresPerRev, round_to};

use super::{Cut, DraftConditions, PowerLaw};

/// Compares the torque of a draft with that of the specific cutting force, by the rule `force-opinion`.
///
/// M = kc1·h^-mc·(D² − d²)·s / 8000 N·m, h = s / lips; D, d and h in mm, s in mm/rev, kc1 in MPa (tables
/// `specific-cutting-force`, `force-opinion`). Nothing for a grade without a group of VDI 3323.
///
/// They are compared at the feed of the tables, `tabulated`, so that a feed reduced later does not change the decision.
pub(super) fn compare_torque(
    draft: &mut DraftConditions,
    tabulated: Option<MillimetresPerRev>,
    cut: &Cut,
    shop: &Shop<'_>,
) -> Result<(), KnowledgeError> {
    let Some(own) = draft.loads.torque else { return Ok(()) };
    let answer = shop.knowledge.ask(&ForceOpinionFor { operation: cut.operation })?;
    let Some(rule) = answer.winner()? else { return Ok(()) };
    let Some(group) = practice_group(&shop.material, shop.knowledge)? else { return Ok(()) };
    let Some(force) = shop.knowledge.ask(&SpecificCuttingForceFor { vdi: group.vdi })?.winner()? else {
        return Ok(());
    };
    let feed = tabulated.unwrap_or(draft.feed);
    let squares = cut.diameter.to_mm() * cut.diameter.to_mm() - cut.from.to_mm() * cut.from.to_mm();
    let factor = force.kc1.0.to_f64() * libm::pow(rule.lips, force.mc) * squares / 8000.0;
    let theirs = PowerLaw::of_feed(factor, 1.0 - force.mc);
    let share = own.at(feed, draft.speed) / theirs.at(feed, draft.speed);
    let note = Note::new("torque-opinion")
        .with("torque", round_to(theirs.at(feed, draft.speed), 1))
        .with("feed", round_to(feed.0, 3))
        .with("percent", round_to(share * 100.0, 0));
    draft.because.push(Because::row(force.row, note));
    if share < rule.least {
        draft.loads.torque = Some(theirs);
        draft.because.push(Because::row(rule.row, Note::new("torque-by-specific-force")));
    }
    Ok(())
}

/// Thrust and torque of a drill by a maker's formulas, for comparison: P = 570·K·D·s^0.85 N, M = K·D²·(0.0063 +
/// 0.1684·s) N·m, D in mm, s in mm/rev (tables `drill-force-formula`, `drill-force-factor`); none if the pages have
/// no K.
pub(super) fn makers(cut: &Cut, found: &Conditions, shop: &Shop<'_>) -> Result<Option<Because>, KnowledgeError> {
    let (Some(thrust), Some(torque)) = (found.axial_force_n, found.torque_n_m) else { return Ok(None) };
    if cut.operation != Operation::Drill || thrust.0 <= 0.0 || torque.0 <= 0.0 {
        return Ok(None);
    }
    let Some(id) = practice_group(&shop.material, shop.knowledge)?.and_then(|row| row.drill_force) else {
        return Ok(None);
    };
    let material = shop.knowledge.need(id, |row: &DrillForceFactor<'_>| row.id == id)?;
    let constant = |name: ForceConstant| -> Result<f64, KnowledgeError> {
        Ok(shop.knowledge.need(name.name(), |row: &DrillForceFormula<'_>| row.name.is(name))?.value)
    };
    let (diameter, feed) = (cut.diameter.to_mm(), found.feed_mm_per_rev.0);
    let exponent = constant(ForceConstant::ThrustFeedExponent)?;
    let their_thrust = constant(ForceConstant::Thrust)? * material.factor * diameter * libm::pow(feed, exponent);
    let slope = constant(ForceConstant::TorqueFeedSlope)?;
    let their_torque = material.factor * diameter * diameter * (constant(ForceConstant::Torque)? + slope * feed);
    let percent = |own: f64, theirs: f64| round_to(own / theirs * 100.0, 0);
    let note = Note::new("force-opinion")
        .with("thrust", round_to(their_thrust, 0))
        .with("thrust_percent", percent(thrust.0, their_thrust))
        .with("torque", round_to(their_torque, 1))
        .with("torque_percent", percent(torque.0, their_torque));
    Ok(Some(Because::row(material.row, note)))
}
