//! The figures of a plan, if one of them had another value. This distinguishes a misprinted figure from the figures
//! computed from its right value.

use std::cell::OnceCell;
use std::collections::BTreeSet;

use super::super::quantity::Id;
use super::super::stated::StatedFigure;
use super::{Formula, Graph};

impl<'a> Graph<'a> {
    /// As `written`, if one figure of the plan had another value.
    pub(super) fn written_if(&self, id: Id, other: Option<(Id, f64)>) -> Option<f64> {
        if let Some((_, value)) = other.filter(|(one, _)| *one == id) {
            return Some(value);
        }
        if let Some(figure) = self.stated.figure(id) {
            return Some(figure.value);
        }
        let right = self.right(id);
        if self.constants.contains_key(&id) || !self.open.borrow_mut().insert(id) {
            return right;
        }
        let value = self.formula(id).and_then(|formula| {
            let inputs: Option<Vec<f64>> = formula.inputs.iter().map(|input| self.written_if(*input, other)).collect();
            (formula.compute)(&inputs?).filter(|value| value.is_finite())
        });
        self.open.borrow_mut().remove(&id);
        value.or(right)
    }

    /// The result of the formula of a stated figure from the plan as written, if one of its figures had another
    /// value.
    pub(crate) fn computed_if(&self, id: Id, other: Option<(Id, f64)>) -> Option<f64> {
        let formula = self.formula(id)?;
        let inputs: Option<Vec<f64>> = formula.inputs.iter().map(|input| self.written_if(*input, other)).collect();
        (formula.compute)(&inputs?).filter(|value| value.is_finite())
    }

    /// Whether a stated figure would fit its formula if one figure of the plan (perhaps itself) had another value;
    /// none if it has no formula.
    pub(crate) fn fits_if(&self, id: Id, other: Option<(Id, f64)>) -> Option<bool> {
        let formula = self.formula(id)?;
        let mut figure = self.stated.figure(id)?.clone();
        if let Some((_, value)) = other.filter(|(one, _)| *one == id) {
            figure.value = value;
        }
        let inputs: Option<Vec<f64>> = formula.inputs.iter().map(|input| self.written_if(*input, other)).collect();
        let inputs = inputs?;
        if let Some(judge) = &formula.judge {
            return Some(judge(figure.value, &inputs).is_none());
        }
        // Each value in use of each constant.
        let mut mixtures = vec![inputs];
        for (at, input) in formula.inputs.iter().enumerate() {
            let Some(constant) = self.constants.get(input) else { continue };
            let with = |one: &Vec<f64>, value: f64| {
                let mut other = one.clone();
                other[at] = value;
                other
            };
            mixtures = mixtures.iter().flat_map(|one| constant.values.iter().map(|value| with(one, *value))).collect();
        }
        Some(mixtures.iter().any(|inputs| {
            (formula.compute)(inputs).is_some_and(|value| self.fits(id, &figure, value, self.slack(formula, inputs)))
        }))
    }

    /// The stated figures whose formulas use a figure, directly or through figures that are not stated.
    pub(crate) fn stated_users(&self, id: Id) -> BTreeSet<Id> {
        let mut found = BTreeSet::new();
        let (mut open, mut seen) = (vec![id], BTreeSet::new());
        while let Some(next) = open.pop() {
            for user in self.users().get(&next).into_iter().flatten() {
                if self.stated.figure(*user).is_some() {
                    found.insert(*user);
                } else if seen.insert(*user) {
                    open.push(*user);
                }
            }
        }
        found.remove(&id);
        found
    }

    /// The stated figures that the formula of a figure uses, directly or through figures that are not stated.
    pub(crate) fn stated_inputs(&self, id: Id) -> BTreeSet<Id> {
        let mut found = BTreeSet::new();
        let (mut open, mut seen) = (vec![id], BTreeSet::new());
        while let Some(next) = open.pop() {
            for input in self.formula(next).map(|formula| formula.inputs.as_slice()).unwrap_or_default() {
                if self.stated.figure(*input).is_some() {
                    found.insert(*input);
                } else if seen.insert(*input) {
                    open.push(*input);
                }
            }
        }
        found.remove(&id);
        found
    }

    /// Whether two values of a stated figure differ by less than its tolerance.
    pub(crate) fn within_tolerance(&self, id: Id, one: f64, other: f64) -> bool {
        let Some(figure) = self.stated.figure(id) else { return false };
        (one - other).abs() <= self.tolerances.allowed_difference(id.quantity, figure, other)
    }

    /// A figure as it is printed.
    pub(crate) fn printed(&self, id: Id) -> Option<&StatedFigure> {
        self.stated.figure(id)
    }

    /// What was computed from the right value of a misprinted figure.
    pub(crate) fn computed_from_right(&self, misprinted: Id) -> Option<Id> {
        self.misprinted.get(&misprinted).copied()
    }

    /// Adds the right value of a misprinted figure, and what was computed from it; everything is then judged again.
    pub(crate) fn correct(&mut self, formula: Formula<'a>, computed: Id) {
        self.misprinted.insert(formula.output, computed);
        self.replace(formula);
    }

    /// Replaces the formulas of a figure; everything is then judged again.
    pub(crate) fn replace(&mut self, formula: Formula<'a>) {
        self.formulas.insert(formula.output, vec![formula]);
        self.right.borrow_mut().clear();
        self.taken.borrow_mut().clear();
        self.off.borrow_mut().clear();
        self.users = OnceCell::new();
        self.verdicts = OnceCell::new();
    }
}
