//! A second opinion on speeds: what shops drive by public tables, beside the formulas of the handbook.
//!
//! The formula stays the method. Where it parts from the practice by more than a third, the rule `second-opinion` says
//! which of them is taken; both stand in the reasons of the plan.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::practice_speed::PracticeSpeed;
use crate::shop::Shop;
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
