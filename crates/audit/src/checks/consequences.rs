//! Several checks may see one slip of a plan. The table `audit-program-causes` says which finding is the cause and which its consequence.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Severity;
use crate::tables::audit::ProgramCauses;

use super::super::finding::{AuditFinding, Section};

/// In what two findings of a plan may agree. Rows of the table that ask for something else are of programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shared {
    Hole,
    Tool,
    Operation,
    /// The figure itself.
    Field,
    /// The conditions, the row or the tool that it belongs to.
    Part,
    /// What is stated.
    Stated,
}

impl Shared {
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "hole" => Self::Hole,
            "tool" => Self::Tool,
            "operation" => Self::Operation,
            "field" => Self::Field,
            "part" => Self::Part,
            "stated" => Self::Stated,
            _ => return None,
        })
    }

    fn agree(self, cause: &AuditFinding, consequence: &AuditFinding) -> bool {
        match self {
            Self::Hole => holes(cause).any(|hole| holes(consequence).any(|other| other == hole)),
            Self::Tool => cause.subject.tool.is_some() && cause.subject.tool == consequence.subject.tool,
            Self::Operation => {
                cause.subject.operation.is_some() && cause.subject.operation == consequence.subject.operation
            }
            Self::Field => cause.field == consequence.field,
            Self::Part => part(&cause.field) == part(&consequence.field),
            Self::Stated => cause.stated.is_some() && cause.stated == consequence.stated,
        }
    }
}

/// The holes of a finding; one of the proof or of a whole hole names it in its field.
fn holes(finding: &AuditFinding) -> impl Iterator<Item = &str> {
    let field = &finding.field;
    let named = field.strip_prefix("proof.").or_else(|| field.strip_prefix("route."));
    finding.subject.holes.iter().map(String::as_str).chain(named)
}

/// `conditions.2` of `conditions.2.feed`.
fn part(field: &str) -> &str {
    let mut dots = field.match_indices('.').map(|(at, _)| at);
    dots.nth(1).map_or(field, |end| &field[..end])
}

/// Whether a row of the table is of plans only.
pub(super) fn is_of_plans(row: &ProgramCauses<'_>) -> bool {
    row.alike.iter().flatten().any(|name| ["field", "part", "stated"].contains(name))
}

/// Gives every consequence its cause.
///
/// # Errors
/// The table cannot be read.
pub(super) fn together(findings: &mut [AuditFinding], knowledge: &Knowledge) -> Result<(), KnowledgeError> {
    let rows = knowledge.rows::<ProgramCauses<'_>>()?;
    let is_root = |one: &AuditFinding| one.severity < Severity::Note && one.follows_from.is_empty();
    for row in &rows {
        let alike: Option<Vec<Shared>> = row.alike.iter().flatten().map(|name| Shared::named(name)).collect();
        let Some(alike) = alike else { continue };
        for at in 0..findings.len() {
            let of_program = |one: &AuditFinding| one.section == Section::Program;
            let Some(own) = findings.get(at).filter(|own| own.rule == row.consequence && is_root(own)) else {
                continue;
            };
            let cause = findings.iter().enumerate().find(|(other, cause)| {
                // Of two of one id the first is the cause; two of a program its own facts tell apart.
                let may_be = *other != at && (row.cause != row.consequence || *other < at);
                may_be
                    && cause.rule == row.cause
                    && is_root(cause)
                    && !(of_program(cause) && of_program(own))
                    // Two findings of one figure are told by one path.
                    && cause.field != own.field
                    && alike.iter().all(|shared| shared.agree(cause, own))
            });
            let Some(field) = cause.map(|(_, cause)| cause.field.clone()) else { continue };
            if let Some(finding) = findings.get_mut(at) {
                finding.follows_from.push(field);
            }
        }
    }
    Ok(())
}
