//! The constants of table `turning-job-limits`, each with its reason.

use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, IntoFigure, Note};
use crate::tables::turning::jobs::{JobLimit, JobLimits};
use crate::units::Micrometres;

/// Queries the table and keeps its answers.
#[derive(Clone, Debug)]
pub struct Limits<'k> {
    knowledge: &'k Knowledge,
    /// The rows that were used.
    pub because: Vec<Because>,
}

impl<'k> Limits<'k> {
    /// Asks nothing yet.
    pub const fn of(knowledge: &'k Knowledge) -> Self {
        Self { knowledge, because: Vec::new() }
    }

    /// A constant that is a ratio.
    ///
    /// # Errors
    /// The table lacks the constant, or its figure is none of that kind.
    pub fn ratio(&mut self, name: JobLimit) -> Result<f64, KnowledgeError> {
        self.constant(name, |row| row.ratio)
    }

    /// A constant that is a length.
    ///
    /// # Errors
    /// The table lacks the constant, or its figure is none of that kind.
    pub fn length(&mut self, name: JobLimit) -> Result<Micrometres, KnowledgeError> {
        self.constant(name, |row| row.length)
    }

    fn constant<T: IntoFigure + Copy>(
        &mut self,
        name: JobLimit,
        of: impl Fn(&JobLimits<'_>) -> Option<T>,
    ) -> Result<T, KnowledgeError> {
        let row = self.knowledge.need(name.name(), |row: &JobLimits<'_>| row.name == name)?;
        let lacks =
            || KnowledgeError::missing(&row.row.table.id, note!("turned-has-no-figure-kind", value = name.name()));
        let value = of(&row).ok_or_else(lacks)?;
        let note = Note::new("job-limit").with("name", Figure::word(name.name())).with("value", value);
        self.because.push(Because::row(row.row, note));
        Ok(value)
    }
}
