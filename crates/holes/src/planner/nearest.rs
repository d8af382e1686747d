//! Where a hole is not possible: the nearest one that is, by its depth or, if no depth helps, by grade and roughness.

use crate::error::{KnowledgeError, Refusal};
use crate::note::Note;
use crate::part::{Hole, Part, ToleratedDiameter, tolerance_width};
use crate::plan::Preference;
use crate::shop::Shop;
use crate::tooling::DrillSize;
use crate::units::{ItGrade, Micrometres, Microns, Roughness};

use super::options::{self, Choice};

/// The step of depths that are tried.
const STEP: Micrometres = Micrometres::from_mm(1);
/// The roughness that a grade is asked for with, Ra, from the finest grade on: a step or two coarser than each reaches, so that
/// the grade decides.
const WITH: [(u8, f64); 4] = [(7, 1.25), (8, 2.5), (11, 6.3), (14, 12.5)];

/// The nearest possible hole beside one that is not; none for stepped and threaded holes, whose parts depend on each other, and
/// where nothing near is possible.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn nearest(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Result<Option<Note>, KnowledgeError> {
    if hole.thread.is_some() || !hole.steps.is_empty() || hole.counterbore.is_some() {
        return Ok(None);
    }
    let possible = |hole: &Hole, part: &Part| -> Result<bool, KnowledgeError> {
        let found = Refusal::split(options::options(hole, part, preference, drills, shop))?;
        Ok(found.is_ok_and(|options| options.choices.iter().any(Choice::meets_requirements)))
    };
    let to_depth = |depth: Micrometres| -> Result<bool, KnowledgeError> {
        let shallow = Hole { depth, ..hole.clone() };
        let mut part = part.clone();
        if hole.through {
            part.blank.thickness = depth;
        }
        possible(&shallow, &part)
    };
    let whole = |depth: Micrometres| Micrometres::new(depth.micrometres() / STEP.micrometres() * STEP.micrometres());
    let (mut deep, mut least) = (whole(hole.depth + STEP - Micrometres::new(1)), whole(hole.diameter.nominal.half()));
    if least >= STEP && least < hole.depth && to_depth(least)? {
        while deep - least > STEP {
            let middle = whole((deep + least).half());
            if to_depth(middle)? { least = middle } else { deep = middle }
        }
        return Ok(Some(Note::new("nearest-depth").with("depth", least)));
    }
    for (finest, ra) in WITH {
        let Some(it) = ItGrade::new(hole.diameter.it.number().max(finest)) else { continue };
        let roughness = hole.roughness.max(Roughness::from_ra(Microns(ra)));
        if it == hole.diameter.it && roughness == hole.roughness {
            continue;
        }
        let Ok(width) = tolerance_width(it, hole.diameter.nominal, shop.knowledge) else { continue };
        let diameter = ToleratedDiameter { upper: hole.diameter.lower + width, it, ..hole.diameter.clone() };
        if possible(&Hole { diameter, roughness, ..hole.clone() }, part)? {
            return Ok(Some(Note::new("nearest-grade").with("it", it).with("roughness", roughness)));
        }
    }
    Ok(None)
}
