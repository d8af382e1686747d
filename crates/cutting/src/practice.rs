//! A second opinion on speeds: what shops drive by public tables, beside the formulas of the handbook.
//!
//! The formula stays the method. Where it parts from the practice by more than a third, the rule `second-opinion` says
//! which of them is taken; both stand in the reasons of the plan.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::plan::{Conditions, Operation};
use crate::practice_speed::{PracticeSpeed, practice_group};
use crate::shop::Shop;
use crate::tables::practice::{DrillForceFactor, DrillForceFormula, ForceConstant};
use crate::tables::rules::{SecondOpinionFor, Taken};
use crate::units::round_to;

use super::{Cut, DraftConditions};

/// What practice makes of a speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    /// The formula's stands.
    No,
    /// It is driven slower than the formula has it.
    Slower,
    /// It is driven faster: the formula's tool life is not that of practice.
    Faster,
}

/// Holds the speed of a draft against practice, by the rule `second-opinion`.
pub(super) fn hold(draft: &mut DraftConditions, cut: &Cut, shop: &Shop<'_>) -> Result<Held, KnowledgeError> {
    let Some(practice) = PracticeSpeed::of(cut.operation, cut.tool_material, shop)? else { return Ok(Held::No) };
    let formula = draft.speed;
    let share = formula.0 / practice.typical.0;
    let asked = shop.knowledge.ask(&SecondOpinionFor { operation: cut.operation, share })?;
    let taken = asked.need(cut.operation.name())?.take;
    let (speed, held) = match taken {
        Taken::PracticeHigh if practice.high.0 < formula.0 => (practice.high, Held::Slower),
        Taken::PracticeUsual if practice.typical.0 < formula.0 => (practice.typical, Held::Slower),
        Taken::PracticeLow if practice.low.0 > formula.0 => (practice.low, Held::Faster),
        _ => (formula, Held::No),
    };
    let note = Note::new("second-opinion")
        .with("formula", round_to(formula.0, 1))
        .with("low", round_to(practice.low.0, 1))
        .with("high", round_to(practice.high.0, 1))
        .with("percent", round_to(share * 100.0, 0));
    draft.because.push(Because::row(practice.row, note));
    if held != Held::No {
        draft
            .because
            .push(Because::answer(&asked.answer, Note::new("practice-speed").with("speed", round_to(speed.0, 1))));
    }
    draft.speed = speed;
    Ok(held)
}

/// Thrust and torque of a drill by a maker's formulas beside ours: P = 570·K·D·s^0.85 N, M = K·D²·(0.0063 + 0.1684·s) N·m,
/// D in mm, s in mm/rev (tables `drill-force-formula`, `drill-force-factor`); nothing where the pages have no K.
pub(super) fn forces(cut: &Cut, found: &Conditions, shop: &Shop<'_>) -> Result<Option<Because>, KnowledgeError> {
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
