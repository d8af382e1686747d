//! Surfaces whose field leaves out the size that the program makes.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::turning::allowances::Elsewhere;
use crate::turning::contour::{Surface, SurfaceKind};
use crate::turning::workpiece::Workpiece;
use crate::units::Micrometres;

/// A finding for each surface whose field leaves out the nominal size. Programs make the nominal size, so a part of that size is
/// scrap. What another machine finishes gets its size there: the lathe only leaves an allowance.
///
/// # Errors
/// The knowledge base lacks the rule.
pub(super) fn off_size(
    workpiece: &Workpiece,
    elsewhere: &[Elsewhere],
    knowledge: &Knowledge,
) -> Result<Vec<Finding>, KnowledgeError> {
    let mut findings = Vec::new();
    let profiles = std::iter::once(&workpiece.outer).chain(&workpiece.inner);
    for surface in profiles.flat_map(|profile| &profile.surfaces) {
        let (Some(field), Some(diameter)) = (&surface.field, size(surface)) else { continue };
        if elsewhere.iter().any(|one| one.surface == surface.name) || field.has_nominal(diameter, knowledge)? {
            continue;
        }
        let note = Note::new("field-off-size").with("surface", &surface.name).with("field", field);
        findings.push(Finding::of_part(Severity::Wrong, note.with("diameter", diameter)));
    }
    Ok(findings)
}

/// The diameter that a field is of: that of a cylinder, also of the floor of a groove, else the largest. A face has a length, whose
/// size the contour does not tell, and a thread has classes of its own.
fn size(surface: &Surface) -> Option<Micrometres> {
    if matches!(surface.kind, SurfaceKind::Face | SurfaceKind::FaceGroove | SurfaceKind::Thread) {
        return None;
    }
    let straight = surface.pieces.iter().find(|piece| piece.from.radius == piece.to.radius);
    let largest = || surface.pieces.iter().map(|piece| piece.from.radius.max(piece.to.radius)).max();
    straight.map(|piece| piece.from.radius).or_else(largest).map(|radius| radius.diameter())
}
