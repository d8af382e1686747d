//! The formulas for the figures of a plan: one file per family, each rule with its source.
//!
//! A rule is a constant beside the function that applies it: id, formula, source. It computes one figure from others
//! of the plan as a part of the graph; it never looks at the stated result.

mod clamping;
mod conditions;
pub(super) mod counts;
pub(super) mod handbook;
mod law;
pub(super) mod tabulated;
mod times;
pub(super) mod tools;

use crate::error::KnowledgeError;
use crate::note::Because;

use super::context::Context;
use super::graph::{Formula, Graph, Rule};
use super::quantity::Id;
use law::{Law, with_places};

/// Adds the formulas of a family to the graph.
type Family = for<'a> fn(&'a Context<'a>, &mut Graph<'a>) -> Result<(), KnowledgeError>;

/// Every family, in the order of a report.
const FAMILIES: &[Family] = &[counts::add, tools::add, conditions::add, handbook::add_all, clamping::add, times::add];

/// Every rule.
pub fn all() -> impl Iterator<Item = &'static Rule> {
    [
        counts::RULES,
        tools::RULES,
        conditions::RULES,
        handbook::RULES,
        tabulated::RULES,
        clamping::RULES,
        times::RULES,
        super::misprints::RULES,
    ]
    .into_iter()
    .flatten()
}

/// Adds every formula to the graph, and what the tables give for figures without one.
///
/// # Errors
/// The knowledge base has no answer.
pub fn add<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    FAMILIES.iter().try_for_each(|family| family(context, graph))?;
    graph.add_table_values(conditions::by_tables(context)?);
    Ok(())
}

/// The formula of a rule as it stands there: its symbols, in the order in which they first stand in it, are the inputs.
fn by_its_text<'a>(rule: &'static Rule, output: Id, inputs: Vec<Id>) -> Formula<'a> {
    written(rule, output, inputs, &with_places(rule.formula))
}

/// A formula with as many terms as a plan has; `numbers` has `{0}` … for the inputs, and is what computes.
fn written<'a>(rule: &'static Rule, output: Id, inputs: Vec<Id>, numbers: &str) -> Formula<'a> {
    let law = Law::read(numbers);
    debug_assert!(law.is_some(), "{}: {numbers}", rule.id);
    formula(rule, output, inputs, numbers, move |values| law.as_ref()?.compute(values))
}

/// A formula that another room computes; `numbers` has `{0}` … for the inputs.
fn formula<'a>(
    rule: &'static Rule,
    output: Id,
    inputs: Vec<Id>,
    numbers: &str,
    compute: impl Fn(&[f64]) -> Option<f64> + 'a,
) -> Formula<'a> {
    Formula {
        rule,
        output,
        inputs,
        numbers: numbers.to_owned(),
        compute: Box::new(compute),
        judge: None,
        others: None,
        because: Vec::new(),
    }
}

/// Two figures that must be the same.
fn equal_figures<'a>(rule: &'static Rule, output: Id, input: Id) -> Formula<'a> {
    written(rule, output, vec![input], "{0}")
}

/// A figure given by a row of a table or by the drawing.
fn fixed_figure<'a>(
    rule: &'static Rule,
    output: Id,
    value: f64,
    because: impl IntoIterator<Item = Because>,
) -> Formula<'a> {
    let mut formula = formula(rule, output, Vec::new(), "", move |_| Some(value));
    formula.because.extend(because);
    formula
}

/// The largest of several figures.
fn largest<'a>(rule: &'static Rule, output: Id, inputs: Vec<Id>) -> Formula<'a> {
    let numbers = format!("max({})", marks(inputs.len(), "; "));
    formula(rule, output, inputs, &numbers, |values| values.iter().copied().reduce(f64::max))
}

/// `{0}`, `{1}` … for `count` inputs, with a sign between.
fn marks(count: usize, between: &str) -> String {
    (0..count).map(|at| format!("{{{at}}}")).collect::<Vec<_>>().join(between)
}
