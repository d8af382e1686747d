//! Questions that the knowledge base cannot answer: the question or a table is wrong, which is no fault of a part.

use technolog_note::{Note, note};

use crate::query::QueryError;
use crate::table::{Table, TableError};

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

impl From<&KnowledgeError> for Note {
    fn from(error: &KnowledgeError) -> Self {
        match error {
            KnowledgeError::Query(error) => error.into(),
            KnowledgeError::Table(error) => error.into(),
        }
    }
}

impl technolog_note::IntoFigure for KnowledgeError {
    fn into_figure(self) -> technolog_note::Figure {
        Note::from(&self).into_figure()
    }
}

impl KnowledgeError {
    /// A table lacks something that is required, for the given reason.
    pub fn missing(table: &str, why: impl Into<Note>) -> Self {
        let table = table.to_owned();
        Self::Table(TableError { table, file: String::new(), row: String::new(), problem: Box::new(why.into()) })
    }

    /// A table has no row where it must have one.
    pub fn no_row(table: &Table, wanted: &str) -> Self {
        Self::Table(TableError {
            table: table.id.clone(),
            file: table.file.clone(),
            row: String::new(),
            problem: note!("table-no-row-for", wanted = wanted).into(),
        })
    }
}
