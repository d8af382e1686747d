//! What the lathe cannot finish, and the contour that it leaves instead (lecture 12.2, the first statement).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::{Input, Knowledge};
use crate::note::{Because, Finding, Note, Severity};
use crate::turning::contour::{Profile, Surface, SurfaceKind};
use crate::turning::length::Half;
use crate::units::{ItGrade, Micrometres, Roughness};

use super::equidistant::{EquidistantError, Over, equidistant_over};
use super::surfaces::{Place, ask, diameter};

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
    pub surface: String,
    /// The later operation: `outer-grinding`, `inner-grinding`, `face-grinding`.
    pub operation: String,
    /// What is left for it, on one side, mm.
    pub allowance_mm: Half,
    /// Why this operation.
    pub because: Because,
    /// Why this allowance.
    pub because_allowance: Because,
}

/// The comparison of a profile with a lathe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Capability {
    /// The profile with new elements in place of those that are finished elsewhere; their grade and roughness are what the
    /// lathe leaves.
    pub replaced: Profile,
    /// The surfaces that are finished elsewhere.
    pub elsewhere: Vec<Elsewhere>,
    /// What could not be compared, and which figures are doubtful.
    pub findings: Vec<Finding>,
}

/// Why the profile cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CapabilityError {
    /// The knowledge base cannot answer.
    #[error(transparent)]
    Knowledge(#[from] KnowledgeError),
    /// The new elements cannot be laid.
    #[error(transparent)]
    Equidistant(#[from] EquidistantError),
}

/// Compares each surface with what the lathe holds, and lays intermediate allowances where it does not; `length` is that
/// of the whole part. A surface without grade and roughness, or a part without a lathe, is left as it is, with a finding.
///
/// # Errors
/// The knowledge base lacks a table, or the contour is none on which an allowance can be laid.
pub fn capability(
    profile: &Profile,
    holds: Option<&Holds>,
    length: Micrometres,
    knowledge: &Knowledge,
) -> Result<Capability, CapabilityError> {
    let (elsewhere, findings) = elsewhere(profile, holds, length, knowledge)?;
    let mut found = Capability { replaced: profile.clone(), elsewhere, findings };
    let Some(holds) = holds else { return Ok(found) };
    if !found.elsewhere.is_empty() {
        let distance = |surface: &Surface| {
            let own = found.elsewhere.iter().find(|elsewhere| elsewhere.surface == surface.name);
            own.map_or(Half::ZERO, |elsewhere| elsewhere.allowance_mm)
        };
        let pieces = profile.surfaces.iter().flat_map(|surface| surface.pieces.iter().map(move |_| surface));
        let distances: Vec<Half> = pieces.map(distance).collect();
        found.replaced = replaced(profile, &equidistant_over(&profile.contour(), &distances)?);
        for surface in &mut found.replaced.surfaces {
            if found.elsewhere.iter().any(|elsewhere| elsewhere.surface == surface.name) {
                let place = Place::of(surface, profile.side);
                surface.grade = surface.grade.map(|grade| grade.max(holds.grade(place)));
                surface.roughness = surface.roughness.map(|roughness| roughness.max(holds.finest));
            }
        }
    }
    Ok(found)
}

/// What of a profile is finished on another machine, and what could not be compared: what [`capability`] begins with, for
/// contours that cannot be shifted before their grooves are bridged.
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
        let place = Place::of(surface, profile.side);
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
    let mut find = |severity: Severity, code: &str| {
        findings.push(Finding::of_part(severity, Note::new(code).with("surface", &surface.name)));
    };
    if surface.grade.is_none() && surface.roughness.is_none() {
        if !surface.kind.is_additional() {
            find(Severity::Note, "no-grade-to-compare");
        }
        return Ok(None);
    }
    let rule = knowledge.table("turning-finish-elsewhere")?;
    // A thread is turned as a cylinder, but nobody grinds it as one.
    let kind = if surface.kind.is_additional() { "additional" } else { place.name() };
    let answer = rule.decide(&[
        ("surface", Input::Text(kind)),
        ("grade_held", Input::Bool(surface.grade.is_none_or(|grade| grade >= holds.grade(place)))),
        ("roughness_held", Input::Bool(surface.roughness.is_none_or(|roughness| roughness >= holds.finest))),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, kind))?;
    let operation = row.text("operation")?.to_owned();
    match operation.as_str() {
        "none" => return Ok(None),
        "unknown" => {
            find(Severity::Doubtful, "finished-elsewhere-unknown");
            return Ok(None);
        }
        _ => {}
    }
    let because = Because::answer(
        &answer,
        Note::new("finished-elsewhere").with("surface", &surface.name).with("operation", &operation),
    );
    let answer = ask(knowledge, "grinding-allowance", place, diameter(surface), length)?;
    let Some(row) = answer.winner() else {
        find(Severity::Error, "no-allowance-for-elsewhere");
        return Ok(None);
    };
    let allowance_mm = place.on_side(row.length("allowance")?);
    let note = Note::new("elsewhere-allowance").with("surface", &surface.name).with("allowance", allowance_mm);
    let because_allowance = Because::answer(&answer, note);
    if let Some(why) = &because_allowance.unconfirmed {
        let note = Note::new("unconfirmed").with("table", &row.table.id).with("row", row.number()).with("why", why);
        findings.push(Finding::of_part(Severity::Doubtful, note));
    }
    Ok(Some(Elsewhere { surface: surface.name.clone(), operation, allowance_mm, because, because_allowance }))
}

/// The surfaces with the pieces that lie over theirs. What joins two surfaces belongs to the earlier one; a surface that
/// its neighbours swallow is left out.
fn replaced(profile: &Profile, over: &[Over]) -> Profile {
    let of: Vec<usize> = profile
        .surfaces
        .iter()
        .enumerate()
        .flat_map(|(place, surface)| surface.pieces.iter().map(move |_| place))
        .collect();
    let mut surfaces: Vec<Surface> =
        profile.surfaces.iter().map(|surface| Surface { pieces: Vec::new(), ..surface.clone() }).collect();
    let mut last = 0;
    for over in over {
        // In the order of the contour, whatever a piece resembles.
        last = of.get(over.of).copied().unwrap_or(last).max(last);
        if let Some(surface) = surfaces.get_mut(last) {
            surface.pieces.push(over.piece);
        }
    }
    surfaces.retain(|surface| !surface.pieces.is_empty());
    Profile { side: profile.side, surfaces }
}

/// Whether a kind of surface is a groove, which is cut after the main contour and has no finishing allowance of its own.
pub(super) const fn is_groove(kind: SurfaceKind) -> bool {
    kind.is_additional() && !matches!(kind, SurfaceKind::Thread)
}
