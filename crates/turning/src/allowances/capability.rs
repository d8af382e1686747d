//! What the lathe cannot finish, and what is left there for another machine (lecture 12.2, the first statement). The contour
//! that the lathe leaves instead is laid in [`crate::turning::operation::layers`], once grooves are bridged.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, Finding, Note, Severity, doubtful_row};
use crate::tables::turning::part::{FinishedSurface, GrindingAllowanceFor, LaterOperation, TurningFinishElsewhereFor};
use crate::turning::contour::{Profile, Surface, SurfaceKind, SurfaceName};
use crate::turning::length::Half;
use crate::units::{ItGrade, Micrometres, Roughness};

use super::surfaces::{Place, asked, diameter, on_side, place};

/// What a lathe holds: its passport's data.
#[derive(Clone, Copy, Debug)]
pub struct Holds {
    /// The finest grade of outer diameters.
    pub outer: ItGrade,
    /// The finest grade of bores.
    pub inner: ItGrade,
    /// The finest grade of lengths between faces.
    pub face: ItGrade,
    /// The finest roughness.
    pub finest: Roughness,
}

impl Holds {
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

/// What of a profile is finished on another machine, with the intermediate allowance that stays for it, and what could not be
/// compared; `length` is that of the whole part. A surface without grade and roughness, or a part without a lathe, is left
/// as it is, with a finding.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn elsewhere(
    profile: &Profile,
    holds: Option<&Holds>,
    length: Micrometres,
    knowledge: &Knowledge,
) -> Result<(Vec<Elsewhere>, Vec<Finding>), KnowledgeError> {
    let (mut found, mut findings) = (Vec::new(), Vec::new());
    let Some(holds) = holds else {
        findings.push(Finding::of_part(Severity::Note, Note::new("no-lathe-to-compare")));
        return Ok((found, findings));
    };
    for surface in &profile.surfaces {
        let place = place(surface, profile.side);
        found.extend(compare(surface, place, holds, length, knowledge, &mut findings)?);
    }
    Ok((found, findings))
}

/// One surface: what follows for it elsewhere, if anything does.
fn compare(
    surface: &Surface,
    place: Place,
    holds: &Holds,
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
    // A thread is turned as a cylinder, but nobody grinds it as one.
    let kind = if surface.kind.is_additional() { FinishedSurface::Additional } else { place.into() };
    let rule = knowledge.ask(&TurningFinishElsewhereFor {
        surface: kind,
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
            .with("operation", Figure::operation(operation.name())),
    );
    let (diameter, length) = (asked(diameter(surface)), asked(length));
    let told = knowledge.ask(&GrindingAllowanceFor { place_on: place, diameter, length })?;
    let Some(row) = told.winner()? else {
        find(Severity::Error, "no-allowance-for-elsewhere");
        return Ok(None);
    };
    let allowance_mm = on_side(place, row.allowance);
    let note = Note::new("elsewhere-allowance").with("surface", &surface.name).with("allowance", allowance_mm);
    let because_allowance = Because::answer(&told.answer, note);
    findings.extend(doubtful_row(row.row));
    Ok(Some(Elsewhere { surface: surface.name.clone(), operation, allowance_mm, because, because_allowance }))
}

/// Whether a kind of surface is a groove, which is cut after the main contour and has no finishing allowance of its own.
pub(super) const fn is_groove(kind: SurfaceKind) -> bool {
    kind.is_additional() && !matches!(kind, SurfaceKind::Thread)
}
