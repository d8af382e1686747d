//! Checks the tables: gaps, contradictions, dead and duplicate rows, dangling references, broken laws, and the
//! examples beside the decision tables.
//!
//! Each check is a file of its own and reports findings with a place and, where an input shows the fault, that input
//! as a witness.

pub mod cases;
pub mod contracts;
mod coverage;
mod laws;
mod names;
mod overlap;
mod references;
mod region;
mod rows;
mod vocabularies;

pub use rows::row_place;

use crate::diagnostic::Diagnostic;
use crate::knowledge::Knowledge;

/// All findings of all checks over the whole knowledge base, by file and line.
pub fn lint(knowledge: &Knowledge) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    let mut gaps = Vec::new();
    for table in knowledge.tables() {
        rows::check(table, &mut findings);
        overlap::check(table, &mut findings);
        gaps.push((table, coverage::check(table, &mut findings)));
        references::check(table, knowledge, &mut findings);
        laws::check(table, knowledge, &mut findings);
    }
    names::check(knowledge, &mut findings);
    vocabularies::check(knowledge, &gaps, &mut findings);
    cases::check(knowledge, &mut findings);
    findings.sort_by(|a, b| a.place.cmp(&b.place).then_with(|| a.message.cmp(&b.message)));
    findings
}

#[cfg(test)]
mod tests;
