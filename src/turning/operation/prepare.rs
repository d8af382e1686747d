//! Before the first cut: the lathe, and what it cannot finish (lecture 12.2, l. 120-135).

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::turning::allowances::capability::{CapabilityError, Elsewhere, Holds, capability};
use crate::turning::contour::Profile;
use crate::turning::tooling::Lathe;
use crate::turning::workpiece::Workpiece;
use crate::units::Micrometres;

/// What the lathe leaves of a part.
#[derive(Clone, Debug)]
pub struct Left {
    /// Its outside, with new elements where surfaces are finished elsewhere.
    pub outer: Profile,
    /// Its bore.
    pub inner: Option<Profile>,
    /// What is finished elsewhere.
    pub elsewhere: Vec<Elsewhere>,
}

/// The lathe that the file names; none where it names none, or one that no catalog has, which is a finding.
///
/// # Errors
/// The record of the lathe is not whole.
pub fn lathe<'k>(
    workpiece: &Workpiece,
    knowledge: &'k Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Option<Lathe<'k>>, KnowledgeError> {
    let Some(id) = &workpiece.machine else {
        findings.extend(super::no_lathe(None));
        return Ok(None);
    };
    if !Lathe::ids(knowledge).contains(&id.as_str()) {
        let known = Lathe::ids(knowledge).join(", ");
        let note = Note::new("no-such-lathe").with("lathe", id).with("known", known);
        findings.push(Finding::of_part(Severity::Error, note));
        return Ok(None);
    }
    let lathe = Lathe::find(knowledge, id)?;
    let length = Micrometres::new(workpiece.blank.length().halves() / 2);
    if let Some(note) = lathe.refuses_part(workpiece.blank.largest_diameter(), length) {
        findings.push(Finding::of_part(Severity::Error, note));
    }
    Ok(Some(lathe))
}

/// The part as the lathe leaves it: what it cannot finish keeps an intermediate allowance.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn left_by_the_lathe(
    workpiece: &Workpiece,
    lathe: Option<&Lathe<'_>>,
    knowledge: &Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Left, KnowledgeError> {
    let holds = lathe.and_then(|lathe| {
        Some(Holds {
            outer: lathe.it_outer?,
            inner: lathe.it_inner?,
            face: lathe.it_face?,
            finest: lathe.best_roughness?,
        })
    });
    let length = Micrometres::new(workpiece.length().halves() / 2);
    let mut elsewhere = Vec::new();
    let mut of = |profile: &Profile, findings: &mut Vec<Finding>| -> Result<Profile, KnowledgeError> {
        match capability(profile, holds.as_ref(), length, knowledge) {
            Ok(found) => {
                elsewhere.extend(found.elsewhere);
                findings.extend(found.findings);
                Ok(found.replaced)
            }
            Err(CapabilityError::Knowledge(error)) => Err(error),
            Err(CapabilityError::Equidistant(error)) => {
                let note = Note::new("no-intermediate-contour").with("why", error);
                findings.push(Finding::of_part(Severity::Error, note));
                Ok(profile.clone())
            }
        }
    };
    let outer = of(&workpiece.outer, findings)?;
    let inner = workpiece.inner.as_ref().map(|inner| of(inner, findings)).transpose()?;
    Ok(Left { outer, inner, elsewhere })
}
