//! What the lathe cannot finish, and the intermediate allowance that is left for another machine (lecture 12.2, the
//! first statement). [`crate::turning::operation::layers`] makes the contour that includes this allowance, after
//! grooves are bridged.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, Finding, Note, Severity, doubtful_row};
use crate::tables::turning::part::{FinishedSurface, GrindingAllowanceFor, LaterOperation, TurningFinishElsewhereFor};
use crate::turning::contour::{Profile, Surface, SurfaceKind, SurfaceName};
use crate::turning::length::Half;
use crate::units::{ItGrade, Micrometres, Roughness};

use super::surfaces::{Place, diameter, on_side, place, query_size};

/// The accuracy that a lathe reaches, from its passport.
#[derive(Clone, Copy, Debug)]
pub struct LatheAccuracy {
    /// The finest grade of outer diameters.
    pub outer: ItGrade,
    /// The finest grade of bores.
    pub inner: ItGrade,
    /// The finest grade of lengths between faces.
    pub face: ItGrade,
    /// The finest roughness.
    pub finest: Roughness,
}

impl LatheAccuracy {
    const fn grade(&self, place: Place) -> ItGrade {
        match place {
            Place::Outer => self.outer,
            Place::Inner => self.inner,
            Place::Face => self.face,
        }
    }
}

/// A surface that is finished on another machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Elsewhere {
    /// Its name.
    pub surface: SurfaceName,
    /// The later operation.
    pub operation: LaterOperation,
    /// What is left for it, on one side, mm.
    pub allowance_mm: Half,
    /// Why this operation.
    pub because: Because,
    /// Why this allowance.
    pub because_allowance: Because,
}

/// The surfaces of a profile that are finished on another machine, with their intermediate allowances; `length` is that
/// of the whole part. A main surface without grade and roughness, and a part without a lathe, cannot be compared: a
/// finding says so.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn elsewhere(
    profile: &Profile,
    holds: Option<&LatheAccuracy>,
    material_group: &str,
    length: Micrometres,
    knowledge: &Knowledge,
) -> Result<(Vec<Elsewhere>, Vec<Finding>), KnowledgeError> {
    let (mut later, mut findings) = (Vec::new(), Vec::new());
    let Some(holds) = holds else {
        findings.push(Finding::of_part(Severity::Note, Note::new("no-lathe-to-compare")));
        return Ok((later, findings));
    };
    for surface in &profile.surfaces {
        let place = place(surface, profile.side);
        later.extend(compare(surface, place, (holds, material_group), length, knowledge, &mut findings)?);
    }
    Ok((later, findings))
}

/// Compares one surface with the lathe; none if the lathe can finish it.
fn compare(
    surface: &Surface,
    place: Place,
    (holds, material_group): (&LatheAccuracy, &str),
    length: Micrometres,
    knowledge: &Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Option<Elsewhere>, KnowledgeError> {
    let mut find = |severity: Severity, code: &'static str| {
        findings.push(Finding::of_part(severity, Note::new(code).with("surface", &surface.name)));
    };
    if surface.grade.is_none() && surface.roughness.is_none() {
        if !surface.kind.is_additional() {
            find(Severity::Note, "no-grade-to-compare");
        }
        return Ok(None);
    }
    // A thread is turned like a cylinder, but it is not ground like one.
    let kind = if surface.kind.is_additional() { FinishedSurface::Additional } else { place.into() };
    let rule = knowledge.ask(&TurningFinishElsewhereFor {
        surface: kind,
        material_group,
        grade_held: surface.grade.is_none_or(|grade| grade >= holds.grade(place)),
        roughness_held: surface.roughness.is_none_or(|roughness| roughness >= holds.finest),
    })?;
    let operation = rule.need(kind.name())?.operation;
    match operation {
        LaterOperation::None => return Ok(None),
        LaterOperation::Unknown => {
            find(Severity::Doubtful, "finished-elsewhere-unknown");
            return Ok(None);
        }
        LaterOperation::OuterGrinding | LaterOperation::InnerGrinding | LaterOperation::FaceGrinding => {}
    }
    let because = Because::answer(
        &rule.answer,
        Note::new("finished-elsewhere")
            .with("surface", &surface.name)
            .with("operation", Figure::word(operation.name())),
    );
    let (diameter, length) = (query_size(diameter(surface)), query_size(length));
    let lookup = knowledge.ask(&GrindingAllowanceFor { place_on: place, diameter, length })?;
    let Some(row) = lookup.winner()? else {
        find(Severity::Error, "no-allowance-for-elsewhere");
        return Ok(None);
    };
    let allowance_mm = on_side(place, row.allowance);
    let note = Note::new("elsewhere-allowance").with("surface", &surface.name).with("allowance", allowance_mm);
    let because_allowance = Because::answer(&lookup.answer, note);
    findings.extend(doubtful_row(row.row));
    Ok(Some(Elsewhere { surface: surface.name.clone(), operation, allowance_mm, because, because_allowance }))
}

/// Whether a surface is a groove. Grooves are cut after the main contour and have no finishing allowance of their own.
pub(super) const fn is_groove(kind: SurfaceKind) -> bool {
    kind.is_additional() && !matches!(kind, SurfaceKind::Thread)
}
