//! What stops planning: missing knowledge; and what makes the planner try the next alternative.
//!
//! A hole that cannot be made is not such an error; it is a finding of the plan.

use crate::reason::Reason;

pub use crate::knowledge::KnowledgeError;

/// Why a stage stops: the knowledge has no answer, or the answer is that something cannot be done.
///
/// The second is the typed refusal after which the planner tries the next alternative; without one it becomes a
/// finding. The reason of a refusal is a type of the stage: [`Reason`] for routes and whole holes,
/// [`crate::reason::Uncut`] for cutting conditions.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal<W = Reason> {
    /// Planning stops: a table lacks something that is required.
    Knowledge(KnowledgeError),
    /// This alternative cannot be carried out, for the given reason.
    Not(W),
}

/// The result of a stage that may refuse.
pub type Tried<T, W = Reason> = Result<T, Refusal<W>>;

impl<W, E: Into<KnowledgeError>> From<E> for Refusal<W> {
    fn from(error: E) -> Self {
        Self::Knowledge(error.into())
    }
}

impl<W> Refusal<W> {
    /// Converts the reason of a refusal for a later stage; a knowledge error stays as it is.
    pub fn map<V>(self, other: impl FnOnce(W) -> V) -> Refusal<V> {
        match self {
            Self::Not(why) => Refusal::Not(other(why)),
            Self::Knowledge(error) => Refusal::Knowledge(error),
        }
    }

    /// Separates refusals from knowledge errors, for callers that continue after a refusal.
    ///
    /// # Errors
    /// The knowledge error.
    pub fn split<T>(tried: Tried<T, W>) -> Result<Result<T, W>, KnowledgeError> {
        match tried {
            Ok(value) => Ok(Ok(value)),
            Err(Self::Not(why)) => Ok(Err(why)),
            Err(Self::Knowledge(error)) => Err(error),
        }
    }
}
