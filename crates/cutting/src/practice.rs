//! A second opinion on speeds: what shops drive by public tables, beside the formulas of the handbook.
//!
//! The formula stays the method. Where it parts from the practice by more than a third, the rule `second-opinion` says
//! which of them is taken; both stand in the reasons of the plan.

use crate::error::KnowledgeError;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::knowledge::{QueryError, RowRef};
use crate::note::{Because, Note};
use crate::plan::{Conditions, Operation};
use crate::shop::Shop;
use crate::tables::practice::{
    CarbideSpeedFor, CarbideWork, Coating, DrillForceFactor, DrillForceFormula, ForceConstant, HssSpeedFor, HssWork,
    PracticeGroup, PracticeGroupFor, RoughOrFinish, SharedWork, SpeedShareFor, TapSpeedFor,
};
use crate::tables::rules::{SecondOpinionFor, Taken};
use crate::units::{Brinell, MetresPerMinute, round_to};

use super::{Cut, DraftConditions};

/// The speeds that shops drive.
#[derive(Clone, Copy, Debug)]
struct Practice<'k> {
    low: MetresPerMinute,
    typical: MetresPerMinute,
    high: MetresPerMinute,
    row: RowRef<'k>,
}

impl<'k> Practice<'k> {
    fn new(low: MetresPerMinute, high: MetresPerMinute, row: RowRef<'k>) -> Self {
        Self { low, typical: MetresPerMinute((low.0 + high.0) / 2.0), high, row }
    }

    fn times(self, low: f64, typical: f64, high: f64) -> Self {
        let times = |speed: MetresPerMinute, share: f64| MetresPerMinute(speed.0 * share);
        Self {
            low: times(self.low, low),
            typical: times(self.typical, typical),
            high: times(self.high, high),
            row: self.row,
        }
    }

    /// What shops drive for a cut; nothing where the tables have no figure for it.
    fn of(cut: &Cut, shop: &Shop<'k>) -> Result<Option<Self>, KnowledgeError> {
        let Some(group) = group(shop)?.map(|row| row.group) else { return Ok(None) };
        let steel = cut.tool_material == ToolMaterial::HighSpeedSteel;
        match cut.operation {
            Operation::Drill if steel => Self::hss(HssWork::Drill, group, shop),
            Operation::CentreDrill if steel => Self::of_drill(SharedWork::CentreDrill, group, shop),
            Operation::DrillOut if steel => Self::of_drill(SharedWork::DrillOut, group, shop),
            Operation::CoreDrill if steel => Self::of_drill(SharedWork::CoreDrill, group, shop),
            Operation::Counterbore if steel => Self::of_drill(SharedWork::Counterbore, group, shop),
            Operation::Countersink | Operation::Chamfer if steel => {
                Self::of_drill(SharedWork::Countersink, group, shop)
            }
            Operation::RoughReam | Operation::FinishReam if steel => Self::hss(HssWork::Ream, group, shop),
            Operation::RoughReam | Operation::FinishReam => {
                Self::carbide(CarbideWork::Ream, RoughOrFinish::Finish, group, shop)
            }
            Operation::RoughBore | Operation::SemiFinishBore | Operation::FinishBore => {
                let rough = cut.operation == Operation::RoughBore;
                let pass = if rough { RoughOrFinish::Rough } else { RoughOrFinish::Finish };
                let turned = match steel {
                    true => Self::hss(HssWork::Turn, group, shop)?,
                    false => Self::carbide(CarbideWork::Turn, pass, group, shop)?,
                };
                Self::share(SharedWork::Bore, turned, shop)
            }
            Operation::Mill if steel => Self::hss(HssWork::Mill, group, shop),
            Operation::Tap if steel => {
                let row = shop.knowledge.ask(&TapSpeedFor { group })?.winner()?;
                Ok(row.map(|row| Self::new(row.speed_low, row.speed_high, row.row)))
            }
            _ => Ok(None),
        }
    }

    fn hss(operation: HssWork, group: &str, shop: &Shop<'k>) -> Result<Option<Self>, KnowledgeError> {
        let row = shop.knowledge.ask(&HssSpeedFor { operation, group })?.winner()?;
        Ok(row.map(|row| Self { low: row.speed_low, typical: row.speed, high: row.speed_high, row: row.row }))
    }

    fn of_drill(operation: SharedWork, group: &str, shop: &Shop<'k>) -> Result<Option<Self>, KnowledgeError> {
        Self::share(operation, Self::hss(HssWork::Drill, group, shop)?, shop)
    }

    /// The bars and reamers of the catalogs are not coated.
    fn carbide(
        operation: CarbideWork,
        cut: RoughOrFinish,
        group: &str,
        shop: &Shop<'k>,
    ) -> Result<Option<Self>, KnowledgeError> {
        let question = CarbideSpeedFor { operation, coating: Coating::Uncoated, cut, group };
        let row = shop.knowledge.ask(&question)?.winner()?;
        Ok(row.map(|row| Self::new(row.speed_low, row.speed_high, row.row)))
    }

    /// Of operations that have no rows of their own: a share of drilling or turning.
    fn share(operation: SharedWork, of: Option<Self>, shop: &Shop<'k>) -> Result<Option<Self>, KnowledgeError> {
        let Some(row) = shop.knowledge.ask(&SpeedShareFor { operation })?.winner()? else { return Ok(None) };
        Ok(of.map(|of| of.times(row.share_low, row.share, row.share_high)))
    }
}

/// The rows of the pages for the material; nothing for a hardness or a grade of somebody's own tables, which they lack.
fn group<'k>(shop: &Shop<'k>) -> Result<Option<PracticeGroup<'k>>, KnowledgeError> {
    let question = PracticeGroupFor { material: shop.material.id, hardness: Brinell(shop.material.hardness) };
    match shop.knowledge.ask(&question) {
        Err(KnowledgeError::Query(QueryError::OutOfDomain { .. } | QueryError::IllTyped { .. })) => Ok(None),
        asked => Ok(asked?.winner()?),
    }
}

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
    let Some(practice) = Practice::of(cut, shop)? else { return Ok(Held::No) };
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
    let Some(id) = group(shop)?.and_then(|row| row.drill_force) else { return Ok(None) };
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
