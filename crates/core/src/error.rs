//! What stops planning altogether: knowledge that does not hold what planning asks of it.
//!
//! A hole that cannot be made is not such an error; it is a finding of the plan.

use crate::note::Note;

pub use crate::knowledge::KnowledgeError;

/// Why a stage does not go on: the knowledge cannot answer, or it answers that this cannot be done.
///
/// The second is the typed refusal by which the planner tries the next alternative; it becomes a finding
/// when there is none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// Planning stops: a table lacks what is asked of it.
    Knowledge(KnowledgeError),
    /// This alternative cannot be carried out, for that reason.
    Not(Note),
}

/// What a stage yields when it may refuse.
pub type Tried<T> = Result<T, Refusal>;

impl<E: Into<KnowledgeError>> From<E> for Refusal {
    fn from(error: E) -> Self {
        Self::Knowledge(error.into())
    }
}

impl Refusal {
    /// The refusal with one more figure; a knowledge error stays as it is.
    #[must_use]
    pub fn with(self, name: &str, value: impl ToString) -> Self {
        match self {
            Self::Not(note) => Self::Not(note.with(name, value)),
            other => other,
        }
    }

    /// Tells a refusal from a knowledge error, where the caller goes on after the first.
    ///
    /// # Errors
    /// The knowledge error.
    pub fn split<T>(tried: Tried<T>) -> Result<Result<T, Note>, KnowledgeError> {
        match tried {
            Ok(value) => Ok(Ok(value)),
            Err(Self::Not(note)) => Ok(Err(note)),
            Err(Self::Knowledge(error)) => Err(error),
        }
    }
}
