//! What stops planning altogether: knowledge that does not hold what planning asks of it.
//!
//! A hole that cannot be made is not such an error; it is a finding of the plan.

use crate::knowledge::{QueryError, TableError};

/// The knowledge base cannot answer.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum KnowledgeError {
    /// A question does not fit its table.
    #[error(transparent)]
    Query(#[from] QueryError),
    /// A table lacks a column or row.
    #[error(transparent)]
    Table(#[from] TableError),
}

impl KnowledgeError {
    /// A table has no row where it must have one.
    pub fn no_row(table: &crate::knowledge::Table, wanted: &str) -> Self {
        Self::Table(TableError {
            table: table.id.clone(),
            file: table.file.clone(),
            row: String::new(),
            problem: format!("there is no row for {wanted}; add it or run `technolog lint`"),
        })
    }
}
