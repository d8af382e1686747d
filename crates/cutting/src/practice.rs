//! A second source for speeds: shop practice by public tables, compared with the formulas of the handbook.
//!
//! The formula is the main method. If it differs from practice by more than a third, the rule `second-opinion`
//! chooses one of the two; the reasons of the plan name both.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::units::Megapascals;
use crate::material::Material;
use crate::note::{Because, Note};
use crate::practice_speed::PracticeSpeed;
use crate::shop::Shop;
use crate::tables::rules::{SecondOpinionFor, Taken};
use crate::units::{MetresPerMinute, round_to};

use super::{Cut, DraftConditions};

/// The result of the comparison of a speed with practice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PracticeComparison {
    /// The formula's speed is kept.
    FormulaKept,
    /// Practice is slower than the formula, and its speed is taken.
    Slower,
    /// Practice is faster, and its speed is taken: the formula's tool life does not apply.
    Faster,
}

/// Compares the speed of a draft with practice, by the rule `second-opinion`.
pub(super) fn compare_with_practice(
    draft: &mut DraftConditions,
    cut: &Cut,
    shop: &Shop<'_>,
) -> Result<PracticeComparison, KnowledgeError> {
    let opinion = second_opinion(draft.speed, cut, &shop.material, shop.knowledge)?;
    draft.speed = opinion.speed;
    draft.fastest = opinion.fastest;
    draft.because.extend(opinion.because);
    Ok(opinion.comparison)
}

/// A speed held against practice.
#[derive(Clone, Debug)]
pub struct SecondOpinion {
    /// The speed to use.
    pub speed: MetresPerMinute,
    /// Whose it is.
    pub comparison: PracticeComparison,
    /// The upper end of practice; absent where no table has it.
    pub fastest: Option<MetresPerMinute>,
    /// The rows.
    pub because: Vec<Because>,
}

/// The speed to use in place of that of the formula, by the rule `second-opinion`, and the reason.
///
/// # Errors
/// The tables cannot answer.
pub fn second_opinion(
    formula: MetresPerMinute,
    cut: &Cut,
    material: &Material<'_>,
    knowledge: &Knowledge,
) -> Result<SecondOpinion, KnowledgeError> {
    let Some(practice) = PracticeSpeed::of(cut.operation, cut.tool_material, material, knowledge)? else {
        let comparison = PracticeComparison::FormulaKept;
        return Ok(SecondOpinion { speed: formula, comparison, fastest: None, because: Vec::new() });
    };
    let share = formula.0 / practice.typical.0;
    let (material_group, spread) = (material.group, practice.high.0 / practice.typical.0);
    let strength = Megapascals(material.strength);
    let question = SecondOpinionFor { operation: cut.operation, material_group, strength, share, spread };
    let answer = knowledge.ask(&question)?;
    let taken = answer.need(cut.operation.name())?.take;
    let (speed, comparison) = match taken {
        Taken::PracticeHigh if practice.high.0 < formula.0 => (practice.high, PracticeComparison::Slower),
        Taken::PracticeUsual if practice.typical.0 < formula.0 => (practice.typical, PracticeComparison::Slower),
        Taken::PracticeUsual if practice.lowest().is_some() => (practice.typical, PracticeComparison::Faster),
        Taken::PracticeLow => match practice.lowest().filter(|low| low.0 > formula.0) {
            Some(low) => (low, PracticeComparison::Faster),
            None => (formula, PracticeComparison::FormulaKept),
        },
        _ => (formula, PracticeComparison::FormulaKept),
    };
    let mut because = vec![Because::row(practice.row, practice.beside(formula, share))];
    if comparison != PracticeComparison::FormulaKept {
        let note = Note::new("practice-speed").with("speed", round_to(speed.0, 1));
        because.push(Because::answer(&answer.answer, note));
    }
    Ok(SecondOpinion { speed, comparison, fastest: Some(practice.high), because })
}
