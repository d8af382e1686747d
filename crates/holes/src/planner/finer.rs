//! Holes that are finer than this machine makes: planned here as far as the stock for the finish, which another machine takes
//! (rules `finer-elsewhere` and `honing-allowance`).

use std::rc::Rc;

use crate::error::KnowledgeError;
use crate::job::Duration;
use crate::knowledge::query::TypedAnswer;
use crate::note::{Because, Figure, Note};
use crate::part::{Hole, LimitsOf, ToleratedDiameter, tolerance_width};
use crate::plan::{Conditions, Feature, Operation};
use crate::route::RouteStep;
use crate::shop::Shop;
use crate::tables::rules::{FinerElsewhere, FinerElsewhereFor, HoningAllowance, HoningAllowanceFor};
use crate::units::{Micrometres, Roughness};

use super::fit::Fitted;
use super::options::Choice;

/// What is left of a hole for another machine.
pub(super) struct Finer<'k> {
    /// The hole that is made here: narrower and coarser than drawn.
    pub here: Hole,
    /// The finish of the drawing.
    diameter: ToleratedDiameter,
    roughness: Roughness,
    operation: Operation,
    asked: TypedAnswer<'k, FinerElsewhere<'k>>,
    stock: TypedAnswer<'k, HoningAllowance<'k>>,
}

impl<'k> Finer<'k> {
    /// The hole to be left; none for threads, and where no machine that the rules name finishes it.
    ///
    /// # Errors
    /// The knowledge base is broken.
    pub fn of(hole: &Hole, shop: &Shop<'k>) -> Result<Option<Self>, KnowledgeError> {
        if hole.thread.is_some() {
            return Ok(None);
        }
        let (drawn, roughness, knowledge) = (&hole.diameter, hole.roughness, shop.knowledge);
        let Some(asked) = knowledge.ask_within(&FinerElsewhereFor { it: drawn.it, roughness })? else {
            return Ok(None);
        };
        let Some(rule) = asked.winner()? else { return Ok(None) };
        let Ok(tolerance) = tolerance_width(rule.before, drawn.nominal, knowledge) else { return Ok(None) };
        let Some(stock) = knowledge.ask_within(&HoningAllowanceFor { tolerance, roughness })? else { return Ok(None) };
        let Some(allowance) = stock.winner()? else { return Ok(None) };
        // Even the widest hole made here leaves the least stock to the narrowest one drawn.
        let upper = drawn.lower - allowance.least;
        let lower = upper - tolerance;
        let nominal = drawn.nominal;
        let written = format!("{nominal} {upper}/{lower}");
        let diameter = ToleratedDiameter { nominal, upper, lower, it: rule.before, written, limits: LimitsOf::Drawing };
        let here = Hole { diameter, roughness: roughness.max(allowance.before), ..hole.clone() };
        let operation = rule.operation;
        Ok(Some(Self { here, diameter: drawn.clone(), roughness, operation, asked, stock }))
    }

    /// A route of the hole that is made here, with the finish on the other machine as its last row.
    pub fn finished(&self, mut choice: Choice) -> Choice {
        let here = |fitted: &&Fitted| fitted.step.place.feature == Feature::Bore && fitted.step.place.step.is_none();
        let Some(last) = choice.steps.iter().rev().find(here) else { return choice };
        let (target, from) = (self.diameter.target(), last.step.diameter);
        let mut step = RouteStep::plain(self.operation, last.step.place, target, from);
        step.place.start = Micrometres::ZERO;
        step.place.depth = self.here.depth;
        step.elsewhere = true;
        step.required_finish = Some((self.diameter.it, self.roughness));
        let operation = Figure::operation(self.operation.name());
        let asked = Note::new("finer-elsewhere")
            .with("operation", operation.clone())
            .with("it", self.diameter.it)
            .with("roughness", self.roughness);
        let stock = Note::new("stock-left")
            .with("operation", operation)
            .with("least", self.diameter.lower - self.here.diameter.upper)
            .with("most", self.diameter.upper - self.here.diameter.lower);
        step.because = vec![Because::answer(&self.asked.answer, asked), Because::answer(&self.stock.answer, stock)];
        choice.steps.push(Fitted::elsewhere(step));
        choice.candidate.finish_elsewhere = true;
        choice
    }
}

impl Fitted {
    /// Work that only another machine does: without cutter and conditions, which are not known here.
    fn elsewhere(mut step: RouteStep) -> Self {
        let because = std::mem::take(&mut step.because);
        Self {
            conditions: Rc::new(Conditions::of_another_machine(step.diameter - step.from)),
            step,
            tool: None,
            travel: Micrometres::ZERO,
            approach: Micrometres::ZERO,
            pass_time: Duration::default(),
            doubts: Vec::new(),
            makes_edge: false,
            because,
        }
    }
}

/// What a plan says of a hole that another machine finishes so.
pub(super) fn remark(hole: &Hole, left: &Fitted) -> Note {
    Note::new("finer-than-this-machine")
        .with("operation", Figure::operation(left.step.operation.name()))
        .with("it", hole.diameter.it)
        .with("roughness", hole.roughness)
        .with("from", left.step.from)
        .with("stock", left.step.diameter - left.step.from)
}
