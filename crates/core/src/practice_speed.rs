//! The speeds used in shops, by the public tables of `catalogs/practice`.

use crate::error::KnowledgeError;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::knowledge::{Knowledge, QueryError, RowRef};
use crate::material::Material;
use crate::note::Note;
use crate::plan::Operation;
use crate::tables::practice::{
    CarbideSpeedFor, CarbideWork, Coating, HssSpeedFor, HssWork, PracticeGroup, PracticeGroupFor, RoughOrFinish,
    SharedWork, SpeedShareFor, TapSpeedFor,
};
use crate::tables::turning::jobs::GroovingPracticeFor;
use crate::units::{Brinell, Decimal, MetresPerMinute, Micrometres, round_to};

/// By how much hardness is lessened until a table has a figure, HB: the groups of practice are 25 to 50 wide.
const SOFTER: Decimal = Decimal::from_int(20);

/// A whole HB, in millionths.
const HB: i64 = 1_000_000;

/// The speeds used in shops, m/min.
#[derive(Clone, Copy, Debug)]
pub struct PracticeSpeed<'k> {
    /// The lower end.
    pub low: MetresPerMinute,
    /// The usual speed.
    pub typical: MetresPerMinute,
    /// The upper end.
    pub high: MetresPerMinute,
    /// The row that gives them.
    pub row: RowRef<'k>,
    /// The hardness that they are of, HB, where the tables end below that of the material.
    pub softer: Option<Decimal>,
}

impl<'k> PracticeSpeed<'k> {
    fn new(low: MetresPerMinute, high: MetresPerMinute, row: RowRef<'k>) -> Self {
        Self { low, typical: MetresPerMinute((low.0 + high.0) / 2.0), high, row, softer: None }
    }

    fn times(self, low: f64, typical: f64, high: f64) -> Self {
        let times = |speed: MetresPerMinute, share: f64| MetresPerMinute(speed.0 * share);
        Self { low: times(self.low, low), typical: times(self.typical, typical), high: times(self.high, high), ..self }
    }

    /// What shops use for an operation with a tool of that material; `None` where the tables have no figure for it.
    ///
    /// # Errors
    /// The tables cannot answer.
    pub fn of(
        operation: Operation,
        tool: ToolMaterial,
        material: &Material<'k>,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        Self::or_of_softer(material, |material| Self::as_hard(operation, tool, material, knowledge))
    }

    /// The speeds for a material, or those of its hardest state that the tables know: what is harder is cut no faster.
    fn or_of_softer(
        material: &Material<'k>,
        of: impl Fn(&Material<'k>) -> Result<Option<Self>, KnowledgeError>,
    ) -> Result<Option<Self>, KnowledgeError> {
        let at = |hardness: i64| {
            let mut softer = material.clone();
            softer.hardness = Decimal::from_millionths(hardness);
            of(&softer)
        };
        let own = material.hardness.millionths();
        let (mut known, mut found) = (own, at(own)?);
        while found.is_none() && known > 0 {
            known -= SOFTER.millionths();
            found = at(known)?;
        }
        // Back to the end of the tables, in whole HB.
        let mut next = known;
        while found.is_some() && next < own {
            next = (next - next.rem_euclid(HB) + HB).min(own);
            match at(next)? {
                Some(harder) => (known, found) = (next, Some(harder)),
                None => break,
            }
        }
        let softer = (known < own).then(|| Decimal::from_millionths(known));
        Ok(found.map(|found| Self { softer, ..found }))
    }

    /// The lower end, as far as it says something of the material: how slow a harder one may be cut nobody tells.
    pub fn lowest(&self) -> Option<MetresPerMinute> {
        self.softer.is_none().then_some(self.low)
    }

    /// The range beside the speed of a formula, which is `share` of the usual one.
    pub fn beside(&self, formula: MetresPerMinute, share: f64) -> Note {
        let note = match self.softer {
            Some(hardness) => Note::new("second-opinion-softer").with("hardness", hardness.to_f64()),
            None => Note::new("second-opinion").with("low", round_to(self.low.0, 1)),
        };
        note.with("high", round_to(self.high.0, 1))
            .with("formula", round_to(formula.0, 1))
            .with("percent", round_to(share * 100.0, 0))
    }

    fn as_hard(
        operation: Operation,
        tool: ToolMaterial,
        material: &Material<'k>,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let Some(group) = practice_group(material, knowledge)?.map(|row| row.group) else { return Ok(None) };
        let steel = tool == ToolMaterial::HighSpeedSteel;
        match operation {
            Operation::Drill if steel => Self::hss(HssWork::Drill, group, knowledge),
            Operation::CentreDrill if steel => Self::of_drill(SharedWork::CentreDrill, group, knowledge),
            Operation::DrillOut if steel => Self::of_drill(SharedWork::DrillOut, group, knowledge),
            Operation::CoreDrill if steel => Self::of_drill(SharedWork::CoreDrill, group, knowledge),
            Operation::Counterbore if steel => Self::of_drill(SharedWork::Counterbore, group, knowledge),
            Operation::Countersink | Operation::Chamfer if steel => {
                Self::of_drill(SharedWork::Countersink, group, knowledge)
            }
            Operation::RoughReam | Operation::FinishReam if steel => Self::hss(HssWork::Ream, group, knowledge),
            Operation::RoughReam | Operation::FinishReam => {
                Self::carbide(CarbideWork::Ream, Coating::Uncoated, RoughOrFinish::Finish, group, knowledge)
            }
            Operation::RoughBore | Operation::SemiFinishBore | Operation::FinishBore => {
                let rough = operation == Operation::RoughBore;
                let pass = if rough { RoughOrFinish::Rough } else { RoughOrFinish::Finish };
                let turned = match steel {
                    true => Self::hss(HssWork::Turn, group, knowledge)?,
                    false => Self::carbide(CarbideWork::Turn, Coating::Uncoated, pass, group, knowledge)?,
                };
                Self::share(SharedWork::Bore, turned, knowledge)
            }
            Operation::Mill if steel => Self::hss(HssWork::Mill, group, knowledge),
            Operation::Tap if steel => {
                let row = knowledge.ask(&TapSpeedFor { group })?.winner()?;
                Ok(row.map(|row| Self::new(row.speed_low, row.speed_high, row.row)))
            }
            _ => Ok(None),
        }
    }

    /// The speeds used in shops for a carbide insert on a lathe; for a bar in a bore a share of them. None where the
    /// tables have no figure.
    ///
    /// The usual speed and the lower end are those of uncoated carbide, as the catalogs' tools are. The upper end is
    /// that of coated carbide where that is faster, because the pages on uncoated grades are of an older generation.
    ///
    /// # Errors
    /// The tables cannot answer.
    pub fn of_turning(
        pass: RoughOrFinish,
        inner: bool,
        material: &Material<'k>,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        Self::or_of_softer(material, |material| Self::turned(pass, inner, material, knowledge))
    }

    fn turned(
        pass: RoughOrFinish,
        inner: bool,
        material: &Material<'k>,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let Some(group) = practice_group(material, knowledge)?.map(|row| row.group) else { return Ok(None) };
        let of = |coating| Self::carbide(CarbideWork::Turn, coating, pass, group, knowledge);
        let (uncoated, coated) = (of(Coating::Uncoated)?, of(Coating::Coated)?);
        let turned = match (uncoated, coated) {
            (Some(speed), Some(other)) if other.high.0 > speed.high.0 => Some(Self { high: other.high, ..speed }),
            (uncoated, coated) => uncoated.or(coated),
        };
        if inner { Self::share(SharedWork::Bore, turned, knowledge) } else { Ok(turned) }
    }

    /// The speeds used in shops for the blade of a grooving insert of that width; none if the table has no figure.
    ///
    /// # Errors
    /// The table cannot answer.
    pub fn of_grooving(
        width: Micrometres,
        material: &Material<'k>,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let row = knowledge.ask(&GroovingPracticeFor { material_group: material.group, width })?.winner()?;
        Ok(row.map(|row| Self::new(row.speed_min, row.speed_max, row.row)))
    }

    fn hss(operation: HssWork, group: &str, knowledge: &'k Knowledge) -> Result<Option<Self>, KnowledgeError> {
        let row = knowledge.ask(&HssSpeedFor { operation, group })?.winner()?;
        Ok(row.map(|row| Self { typical: row.speed, ..Self::new(row.speed_low, row.speed_high, row.row) }))
    }

    fn of_drill(operation: SharedWork, group: &str, knowledge: &'k Knowledge) -> Result<Option<Self>, KnowledgeError> {
        Self::share(operation, Self::hss(HssWork::Drill, group, knowledge)?, knowledge)
    }

    fn carbide(
        operation: CarbideWork,
        coating: Coating,
        cut: RoughOrFinish,
        group: &str,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let question = CarbideSpeedFor { operation, coating, cut, group };
        let row = knowledge.ask(&question)?.winner()?;
        Ok(row.map(|row| Self::new(row.speed_low, row.speed_high, row.row)))
    }

    /// For operations without rows of their own: a share of drilling or turning.
    fn share(
        operation: SharedWork,
        speed: Option<Self>,
        knowledge: &'k Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let Some(row) = knowledge.ask(&SpeedShareFor { operation })?.winner()? else { return Ok(None) };
        Ok(speed.map(|of| of.times(row.share_low, row.share, row.share_high)))
    }
}

/// The rows for the material; none for a hardness or a grade from tables of the user, which they lack.
///
/// # Errors
/// The rule `practice-group` cannot answer.
pub fn practice_group<'k>(
    material: &Material<'k>,
    knowledge: &'k Knowledge,
) -> Result<Option<PracticeGroup<'k>>, KnowledgeError> {
    let question = PracticeGroupFor { material: material.id, hardness: Brinell(material.hardness) };
    match knowledge.ask(&question) {
        Err(KnowledgeError::Query(QueryError::OutOfDomain { .. } | QueryError::IllTyped { .. })) => Ok(None),
        answer => Ok(answer?.winner()?),
    }
}
