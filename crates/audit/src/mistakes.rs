//! The usual ways to get a formula wrong: the table `audit-mistakes`, to which a lecturer may add.
//!
//! A figure that its formula does not explain is compared with what comes out of each of these ways, with the figures as they are stated
//! and as they should be. Whatever matches within rounding is told beside the finding: who reads it sees what happened, and not only that
//! another figure was expected.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Figure, Note, Severity};
use crate::tables::audit::{MistakenLaw, MistakenPlace, Mistakes, Threshold};

use super::context::Context;
use super::graph::{Compute, Formula, Graph};
use super::quantity::{Id, Scope};
use super::stated::StatedFigure;

/// Another law in place of a formula's: coefficients of another row, a correction left out.
pub(super) struct OtherLaw<'a> {
    /// Its name in the table.
    pub law: MistakenLaw,
    /// The row of the handbook's table it was taken from.
    pub row: Option<usize>,
    pub compute: Compute<'a>,
}

/// What a mistake that was recognised says.
pub(super) struct Recognised {
    pub note: Note,
    /// How grave it makes the finding, where it proves more than the deviation alone.
    pub severity: Option<Severity>,
}

/// The mistakes of the table.
pub(super) fn read(knowledge: &Knowledge) -> Result<Vec<Mistakes<'_>>, KnowledgeError> {
    Ok(knowledge.rows::<Mistakes<'_>>()?)
}

/// The first mistake of the table that gives the stated figure.
pub(super) fn recognised(
    context: &Context<'_>,
    graph: &Graph<'_>,
    formula: &Formula<'_>,
    figure: &StatedFigure,
) -> Option<Recognised> {
    let coarse = context.auditor.threshold(Threshold::MistakeCoarse);
    if figure.value == 0.0 || figure.last_place / 2.0 > coarse * figure.value.abs() {
        return None;
    }
    let bases = bases(graph, formula);
    let near = context.auditor.threshold(Threshold::MistakeNear);
    let fits = |value: f64| (figure.value - value).abs() <= figure.last_place / 2.0 + near * value.abs();
    let of_rule = || context.auditor.mistakes.iter().filter(|mistake| mistake.rule == formula.rule.id);
    let others = match (of_rule().any(|mistake| mistake.law.is_some()), &formula.others) {
        (true, Some(others)) => others(),
        _ => Vec::new(),
    };
    for mistake in of_rule() {
        for base in &bases {
            let mut results = Vec::new();
            match mistake.law {
                Some(law) => {
                    let of_law = others.iter().filter(|other| other.law == law);
                    results.extend(of_law.filter_map(|other| Some(((other.compute)(base)?, other.row))));
                }
                None => results.extend(changed(graph, formula, mistake, base).into_iter().map(|value| (value, None))),
            }
            if let Some((_, row)) = results.into_iter().find(|(value, _)| value.is_finite() && fits(*value)) {
                return Some(Recognised { note: note(mistake, row), severity: mistake.severity });
            }
        }
    }
    None
}

/// The inputs as they are stated and as they should be, with every constant in use.
fn bases(graph: &Graph<'_>, formula: &Formula<'_>) -> Vec<Vec<f64>> {
    let mut bases: Vec<Vec<f64>> = Vec::new();
    for by in [Graph::stated_or_right, Graph::right] {
        let inputs: Option<Vec<f64>> = formula.inputs.iter().map(|input| by(graph, *input)).collect();
        bases.extend(inputs.filter(|own| !bases.contains(own)));
    }
    bases
}

/// What comes out of a mistake: of every input that it may be made with, and of all of them together.
fn changed(graph: &Graph<'_>, formula: &Formula<'_>, mistake: &Mistakes<'_>, base: &[f64]) -> Vec<f64> {
    let instead = |scope: Scope| {
        let other = Id::new(place(graph, scope, mistake.at), mistake.instead?);
        graph.stated_or_right(other)
    };
    let change = |value: f64, scope: Scope| -> Option<f64> {
        let value = match mistake.instead {
            Some(_) => instead(scope)?,
            None => mistake.value.unwrap_or(value),
        };
        Some(libm::pow(value, mistake.power.unwrap_or(1.0)) * mistake.times.unwrap_or(1.0))
    };
    let scope = formula.output.scope;
    let Some(of) = mistake.of else {
        return (formula.compute)(base).and_then(|value| change(value, scope)).into_iter().collect();
    };
    let inputs = formula.inputs.iter().enumerate().filter(|(_, input)| input.quantity == of);
    let at: Vec<usize> = inputs.map(|(at, _)| at).collect();
    let with = |which: &[usize]| {
        let mut values = base.to_vec();
        for at in which {
            values[*at] = change(values[*at], scope)?;
        }
        (formula.compute)(&values)
    };
    let single = at.iter().filter_map(|one| with(&[*one]));
    single.chain((at.len() > 1).then(|| with(&at)).flatten()).collect()
}

/// Where the other figure of a mistake stands.
fn place(graph: &Graph<'_>, scope: Scope, at: Option<MistakenPlace>) -> Scope {
    match at {
        Some(MistakenPlace::Row) => graph.row_of(scope).map_or(scope, Scope::Row),
        Some(MistakenPlace::Tool) => graph.tool_of(scope).map_or(scope, Scope::Tool),
        None => scope,
    }
}

/// The sentence: `this is what comes out if T^m is left out`.
fn note(mistake: &Mistakes<'_>, row: Option<usize>) -> Note {
    let said = |code| {
        let note = Note::new(code).with("mistake", Figure::Remark(mistake.what.to_owned()));
        note.with("id", mistake.id)
    };
    match row {
        Some(row) => said("audit-mistake-row").with("row", row),
        None => said("audit-mistake"),
    }
}
