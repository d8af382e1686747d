//! What is judged of a list of tools or a program without a part: the table `audit-needs` says which rules need nothing but the list, which its material
//! or its machine. Nothing else is said, and one note tells what was left out.

use std::collections::BTreeSet;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Note, Severity};
use crate::tables::audit::{AuditNeeds, Need};

use super::finding::{AuditFinding, Section};
use super::sheet::Unsaid;
use super::stated::Stated;

/// Leaves out the findings that need what the list does not say.
///
/// # Errors
/// The table `audit-needs` cannot be read.
pub(super) fn leave_out(
    stated: &Stated,
    knowledge: &Knowledge,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(Unsaid { material, machine }) = stated.unsaid else { return Ok(()) };
    let rows = knowledge.rows::<AuditNeeds<'_>>()?;
    let of_program = stated.is_of_program();
    let known = |finding: &AuditFinding| {
        // What the control finds in a program needs no part.
        of_program && finding.section == Section::Program
            || rows.iter().any(|row| {
                let said = match row.needs {
                    Need::Nothing => true,
                    Need::Material => !material,
                    Need::Machine => !machine,
                    Need::Program => of_program,
                };
                row.rule == finding.rule && said
            })
    };
    // What follows from something that is not judged is not judged either.
    let mut left: BTreeSet<String> = BTreeSet::new();
    findings.retain(|finding| {
        let known = known(finding);
        if !known && finding.follows_from.is_empty() {
            left.insert(finding.field.clone());
        }
        known
    });
    for finding in findings.iter_mut().filter(|finding| !finding.follows_from.is_empty()) {
        finding.follows_from.retain(|root| !left.contains(root));
    }
    let kept: BTreeSet<String> = findings.iter().map(|finding| finding.field.clone()).collect();
    findings.retain(|finding| {
        !matches!(finding.kind, super::finding::FindingKind::Follows(_))
            || finding.follows_from.iter().any(|root| kept.contains(root))
    });
    let code = match (material, machine) {
        _ if of_program => "audit-program-without-part",
        (true, true) => "audit-list-without-part",
        (true, false) => "audit-list-without-material",
        (false, true) => "audit-list-without-machine",
        (false, false) => "audit-list-with-both",
    };
    findings.push(AuditFinding::new(Severity::Note, Section::Missing, "part".to_owned(), Note::new(code)));
    Ok(())
}
