//! Before the first cut: the lathe, and the surfaces that it cannot finish (lecture 12.2, l. 120-135).

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::{Finding, Note, Severity, doubtful_row};
use crate::tables::lathes::LatheQuantity as Q;
use crate::turning::allowances::capability::{Elsewhere, LatheAccuracy, elsewhere};
use crate::turning::tooling::Lathe;
use crate::turning::workpiece::Workpiece;
use crate::units::Micrometres;

use super::thin;

/// The lathe in the file; none, with a finding, if it names none.
///
/// # Errors
/// No catalog has it (the reader of files prevents that), or its record is incomplete.
pub fn lathe<'k>(
    workpiece: &Workpiece,
    knowledge: &'k Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Option<Lathe<'k>>, KnowledgeError> {
    let Some(id) = &workpiece.machine else {
        findings.push(Finding::of_part(Severity::Note, Note::new("no-lathe")));
        return Ok(None);
    };
    let lathe = Lathe::find(knowledge, id)?;
    let length = Micrometres::new(workpiece.blank.length().halves() / 2);
    if let Some(note) = lathe.refuses_part(workpiece.blank.largest_diameter(), length) {
        findings.push(Finding::of_part(Severity::Error, note));
    }
    Ok(Some(lathe))
}

/// The surfaces that the lathe cannot finish, with the intermediate allowances for later operations.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn finished_elsewhere(
    workpiece: &Workpiece,
    lathe: Option<&Lathe<'_>>,
    knowledge: &Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Elsewhere>, KnowledgeError> {
    let holds = lathe.and_then(|lathe| {
        Some(LatheAccuracy {
            outer: lathe.it_outer?,
            inner: lathe.it_inner?,
            face: lathe.it_face?,
            finest: lathe.best_roughness?,
        })
    });
    if let (Some(lathe), Some(_)) = (lathe, &holds) {
        let rows = [Q::ItOuter, Q::ItInner, Q::ItFace, Q::RaBest].into_iter().filter_map(|name| lathe.row(name).ok());
        findings.extend(rows.filter_map(doubtful_row));
    }
    let length = Micrometres::new(workpiece.length().halves() / 2);
    let group = Material::find(knowledge, &workpiece.material)?.group;
    let mut all = Vec::new();
    let outer = (&workpiece.outer, Some(&workpiece.blank.outer));
    let inner = workpiece.inner.as_ref().map(|inner| (inner, workpiece.blank.inner.as_ref()));
    for (profile, blank) in std::iter::once(outer).chain(inner) {
        let (later, doubts) = elsewhere(profile, holds.as_ref(), group, length, knowledge)?;
        findings.extend(doubts);
        for one in later {
            let surface = profile.surfaces.iter().find(|surface| surface.name == one.surface);
            let (Some(surface), Some(blank)) = (surface, blank) else {
                all.push(one);
                continue;
            };
            // The blank has nothing to leave there, which is told where the surface stays as it is.
            if thin::is_of_blank(surface, blank) {
                continue;
            }
            if thin::keeps_skin(surface, one.allowance_mm, blank) {
                let note = Note::new("blank-thin-for-elsewhere").with("surface", &one.surface);
                findings.push(Finding::of_part(Severity::Wrong, note.with("allowance", one.allowance_mm)));
            }
            all.push(one);
        }
    }
    Ok(all)
}
