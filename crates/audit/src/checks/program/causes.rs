//! One fault of a program is seen by several checks: which finding is the cause and which are its consequences stands in
//! the table `audit-program-causes`.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::tables::audit::ProgramCauses;

use super::super::super::finding::Finding;

/// A finding about a program with what its cause is found by.
#[derive(Debug)]
pub(super) struct Seen {
    pub finding: Finding,
    /// The tool in the spindle, where it is known.
    tool: Option<u32>,
    /// Whether the control does not carry the program out as it is written.
    fault: bool,
}

/// Any error of the control that carries the program out.
const FAULT: &str = "fault";

impl Seen {
    pub fn new(finding: Finding, tool: Option<u32>, fault: bool) -> Self {
        Self { finding, tool, fault }
    }

    fn is(&self, id: &str) -> bool {
        self.finding.note.code == id || self.fault && id == FAULT
    }

    /// What it says of something: a figure of its sentence, its code, its tool, its line.
    fn says(&self, name: &str) -> Option<String> {
        if let Some(value) = self.finding.note.params.get(name) {
            return Some(value.clone());
        }
        match name {
            "code" => Some(self.finding.note.code.clone()),
            "tool" => self.tool.map(|tool| tool.to_string()),
            "line" => self.finding.line.map(|line| line.to_string()),
            _ => None,
        }
    }
}

/// The findings, each consequence with the place of its cause. What follows from the plan already stays so.
///
/// # Errors
/// The table cannot be read.
pub(super) fn together(seen: Vec<Seen>, knowledge: &Knowledge) -> Result<Vec<Finding>, KnowledgeError> {
    let rows = knowledge.rows::<ProgramCauses<'_>>()?;
    let causes: Vec<Option<usize>> = (0..seen.len()).map(|at| cause(at, &seen, &rows)).collect();
    // What a cause follows from, or else the cause itself.
    let fields: Vec<Vec<String>> = seen
        .iter()
        .map(|Seen { finding, .. }| match finding.follows_from.is_empty() {
            true => vec![finding.field.clone()],
            false => finding.follows_from.clone(),
        })
        .collect();
    let mut found: Vec<Finding> = seen.into_iter().map(|one| one.finding).collect();
    for (at, finding) in found.iter_mut().enumerate() {
        if let Some(fields) = root(at, &causes).and_then(|root| fields.get(root))
            && finding.follows_from.is_empty()
        {
            finding.follows_from.clone_from(fields);
        }
    }
    Ok(found)
}

/// What a finding follows from: the first that a row of the table names.
fn cause(at: usize, seen: &[Seen], rows: &[ProgramCauses<'_>]) -> Option<usize> {
    let own = seen.get(at)?;
    for row in rows.iter().filter(|row| own.is(row.consequence)) {
        for (number, other) in seen.iter().enumerate() {
            // Of two of one id the first is the cause.
            let later = number >= at && (number == at || other.finding.note.code == own.finding.note.code);
            if !later && other.is(row.cause) && agree(other, own, row) {
                return Some(number);
            }
        }
    }
    None
}

fn agree(cause: &Seen, consequence: &Seen, row: &ProgramCauses<'_>) -> bool {
    let alike = |name: &str| {
        let (of_cause, of_consequence) = name.split_once('=').unwrap_or((name, name));
        let two = cause.says(of_cause).zip(consequence.says(of_consequence));
        two.is_none_or(|(cause, consequence)| cause == consequence)
    };
    row.alike.iter().flatten().all(|name| alike(name))
}

/// The first cause of a consequence.
fn root(at: usize, causes: &[Option<usize>]) -> Option<usize> {
    let mut root = causes.get(at).copied().flatten()?;
    // Two that were each the other's cause would go round for ever.
    for _ in 0..causes.len() {
        match causes.get(root).copied().flatten().filter(|next| *next != at) {
            Some(next) => root = next,
            None => return Some(root),
        }
    }
    None
}
