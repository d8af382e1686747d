//! The tables as code reads them: one row type per table, with its contract.
//!
//! A crate below all planning crates, because the build script checks the shipped tables against the same contracts
//! ([`check`]) as `--knowledge` and `lint` do. There is a module for each folder of `catalogs/`, and one for
//! `rules/`.
//!
//! Architecture invariant: no other crate names a column.

#![allow(missing_docs, reason = "a field is the column of its name; what it means and its unit stand in the table")]

pub mod audit;
pub mod controls;
pub mod cutters;
pub mod cutting;
pub mod holders;
pub mod holes;
pub mod lathes;
pub mod machines;
pub mod materials;
pub mod practice;
pub mod quantity;
pub mod rules;
pub mod standards;
pub mod tools;
pub mod turning;
pub mod vocabularies;

use technolog_knowledge::contract::Contract;
use technolog_knowledge::lint::contracts;
use technolog_knowledge::{Diagnostic, Knowledge, SourceFile};

/// The contract of every table.
pub fn all() -> Vec<&'static Contract> {
    [
        audit::CONTRACTS,
        controls::CONTRACTS,
        controls::control_2c42_65::CONTRACTS,
        controls::iso::CONTRACTS,
        controls::lathe::CONTRACTS,
        controls::lathe_reading::CONTRACTS,
        cutting::CONTRACTS,
        holders::CONTRACTS,
        holes::CONTRACTS,
        lathes::CONTRACTS,
        machines::CONTRACTS,
        materials::CONTRACTS,
        practice::CONTRACTS,
        rules::CONTRACTS,
        standards::CONTRACTS,
        tools::CONTRACTS,
        turning::jobs::CONTRACTS,
        turning::part::CONTRACTS,
        turning::passes::CONTRACTS,
        turning::tools::CONTRACTS,
        vocabularies::CONTRACTS,
    ]
    .concat()
}

/// Checks every table against the code that reads it, and every cutter against the needs of planning.
pub fn check(knowledge: &Knowledge) -> Vec<Diagnostic> {
    let mut findings = contracts::check(knowledge, &all());
    findings.extend(cutters::check(knowledge));
    findings
}

/// Whether a folder is a knowledge base for planning, and not a few separate tables: it has at least half of the
/// tables that are required by name.
pub fn is_to_plan_with(knowledge: &Knowledge) -> bool {
    let (there, contracts) = contracts::present(knowledge, &all());
    2 * there >= contracts
}

/// Reads tables for planning and checks their contracts.
///
/// # Errors
/// Every problem of every file, then every broken contract.
pub fn load(files: &[SourceFile<'_>]) -> Result<Knowledge, Vec<Diagnostic>> {
    let knowledge = Knowledge::from_sources(files)?;
    let problems = check(&knowledge);
    if problems.is_empty() { Ok(knowledge) } else { Err(problems) }
}

/// The parts of a table that are only for people: no calculation uses them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ForPeople<'k> {
    /// The table's id.
    pub table: &'k str,
    /// Columns without use; for a table that no code reads, all of them.
    pub columns: Vec<&'k str>,
    /// Rows that are marked as documentation, by name.
    pub rows: Vec<String>,
}

/// The documentation parts of tables; a table that code reads completely is not listed.
pub fn documentation(knowledge: &Knowledge) -> Vec<ForPeople<'_>> {
    let contracts = all();
    let listed = knowledge.tables().map(|table| {
        let contract = contracts.iter().find(|contract| contract.is_of(table));
        let is_shown = |name: &&str| contract.is_none_or(|contract| contract.shown.contains(name));
        let columns = table.columns.iter().map(|column| column.name.as_str()).filter(is_shown).collect();
        let rows = contract.map(|contract| contracts::for_people(table, contract)).unwrap_or_default();
        ForPeople { table: &table.id, columns, rows }
    });
    listed.filter(|parts| !parts.columns.is_empty() || !parts.rows.is_empty()).collect()
}

#[cfg(test)]
mod tests;
