//! The answer of the tables for a hole, before centring is added and before any scheme is tried.

use crate::error::KnowledgeError;
use crate::knowledge::{RowRef, Source};
use crate::note::Because;
use crate::part::{Hole, Part};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::tables::holes::StagedHole;
use crate::tables::rules::TwoPassDrillingFor;
use crate::units::Micrometres;

use super::auxiliary::{self, AuxiliaryKind};
use super::scheme::{self, SchemeQuestion};
use super::{accuracy, bores};

/// The answer of the tables.
#[derive(Clone, Debug)]
pub struct TableAnswer<'k> {
    /// The row of A.8, A.9 or A.10; absent if their cell is empty.
    pub row: Option<RowRef<'k>>,
    /// Its schemes as printed.
    pub schemes: Vec<String>,
    /// Whether the hole is centred first, by the rule `centre-first`.
    pub centred: bool,
    /// The row of that rule.
    pub centring: Because,
}

/// Asks the tables for the schemes of a hole's main cylinder.
///
/// # Errors
/// The knowledge base has no answer. A tolerance of the drawing that cannot be read gives an answer without a row.
pub fn ask<'k>(hole: &Hole, part: &Part, shop: &Shop<'k>) -> Result<TableAnswer<'k>, KnowledgeError> {
    let task = bores::task(hole, part, shop)?;
    let main = &task.main;
    let (centred, centring) = scheme::centre_first(main, shop)?;
    let nothing = TableAnswer { row: None, schemes: Vec::new(), centred, centring };
    let Ok(written) = accuracy::centre_tolerance(hole, shop) else { return Ok(nothing) };
    // As in the planner: an unmachined face means a tighter tolerance, and A.6 asks for the position of the axis.
    let loss = accuracy::rough_face(main, part, shop)?.map_or(0.0, |(loss, _)| loss);
    let position = part.position_tolerance.unwrap_or(written);
    let mut question = SchemeQuestion {
        bore: main,
        centre_tolerance: Micrometres::from_mm_rounded(written.to_mm() / (1.0 + loss)),
        drawn_tolerance: written,
        position,
        outer_wall: hole.outer_wall,
        drills: &[],
    };
    let kind = AuxiliaryKind::of(hole, main, accuracy::drilled(shop)?);
    let diameter = if kind.is_some() { auxiliary::diameter(&question) } else { main.diameter.nominal };
    let (_, elsewhere) =
        scheme::stages(&question, kind.map_or(StagedHole::Plain, AuxiliaryKind::stage_name), diameter, shop)?;
    if elsewhere {
        question.centre_tolerance = question.centre_tolerance.min(position);
    }
    let found = match kind {
        Some(kind) => {
            let row = shop.knowledge.ask(&auxiliary::query(&question, kind))?.winner()?;
            row.map(|row| (row.row, row.schemes))
        }
        None => scheme::own_cell(&question, shop.knowledge)?.map(|row| (row.row, row.schemes)),
    };
    let Some((row, schemes)) = found else { return Ok(nothing) };
    Ok(TableAnswer { row: Some(row), schemes: schemes.into_iter().map(str::to_owned).collect(), ..nothing })
}

/// The transitions of a scheme of A.7, of `04 + centre` too; none if A.7 has no such scheme.
///
/// # Errors
/// The knowledge base has no answer.
pub fn transitions(scheme: &str, shop: &Shop<'_>) -> Result<Option<Vec<Operation>>, KnowledgeError> {
    let (name, centred) = match scheme.strip_suffix(" + centre") {
        Some(name) => (name, true),
        None => (scheme, false),
    };
    Ok(scheme::find_scheme(name, shop)?.map(|row| {
        let mut operations = row.transitions.clone();
        if centred && operations.first() != Some(&Operation::CentreDrill) {
            operations.insert(0, Operation::CentreDrill);
        }
        operations
    }))
}

/// A scheme with centring first: its twin in the table `centred-twin`, otherwise `04 + centre`.
///
/// # Errors
/// The knowledge base has no answer.
pub fn centred(scheme: &str, shop: &Shop<'_>) -> Result<String, KnowledgeError> {
    if transitions(scheme, shop)?.is_some_and(|own| own.first() == Some(&Operation::CentreDrill)) {
        return Ok(scheme.to_owned());
    }
    let twin = scheme::twin(scheme, shop)?;
    Ok(twin.map_or_else(|| format!("{scheme} + centre"), |twin| twin.centred.to_owned()))
}

/// The row of the text in the rule `two-pass-drilling` that requires two drills in place of one; none if one is enough,
/// or if a row of ours alone asks for two.
///
/// # Errors
/// The knowledge base has no answer.
pub fn two_drills<'k>(diameter: Micrometres, shop: &Shop<'k>) -> Result<Option<RowRef<'k>>, KnowledgeError> {
    let material_group = shop.material.group;
    let question = TwoPassDrillingFor { diameter, material_group, first_drill_in_magazine: false };
    let row = shop.knowledge.ask(&question)?.need("this drill")?;
    Ok((row.passes >= 2 && row.row.row().source == Source::Seed).then_some(row.row))
}
