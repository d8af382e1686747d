//! The speeds that shops use, by the public tables of `catalogs/practice`.

use crate::error::KnowledgeError;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::knowledge::{QueryError, RowRef};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::practice::{
    CarbideSpeedFor, CarbideWork, Coating, HssSpeedFor, HssWork, PracticeGroup, PracticeGroupFor, RoughOrFinish,
    SharedWork, SpeedShareFor, TapSpeedFor,
};
use crate::units::{Brinell, MetresPerMinute};

/// The speeds that shops drive, m/min.
#[derive(Clone, Copy, Debug)]
pub struct PracticeSpeed<'k> {
    /// The lower end.
    pub low: MetresPerMinute,
    /// What is usual.
    pub typical: MetresPerMinute,
    /// The upper end.
    pub high: MetresPerMinute,
    /// The row that says so.
    pub row: RowRef<'k>,
}

impl<'k> PracticeSpeed<'k> {
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

    /// What shops use for an operation with a tool of that material; `None` where the tables have no figure for it.
    ///
    /// # Errors
    /// The tables cannot answer.
    pub fn of(operation: Operation, tool: ToolMaterial, shop: &Shop<'k>) -> Result<Option<Self>, KnowledgeError> {
        let Some(group) = practice_group(shop)?.map(|row| row.group) else { return Ok(None) };
        let steel = tool == ToolMaterial::HighSpeedSteel;
        match operation {
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
                let rough = operation == Operation::RoughBore;
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
///
/// # Errors
/// The rule `practice-group` cannot answer.
pub fn practice_group<'k>(shop: &Shop<'k>) -> Result<Option<PracticeGroup<'k>>, KnowledgeError> {
    let question = PracticeGroupFor { material: shop.material.id, hardness: Brinell(shop.material.hardness) };
    match shop.knowledge.ask(&question) {
        Err(KnowledgeError::Query(QueryError::OutOfDomain { .. } | QueryError::IllTyped { .. })) => Ok(None),
        asked => Ok(asked?.winner()?),
    }
}
