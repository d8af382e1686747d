//! What stops planning altogether: knowledge that lacks what planning needs; and what makes it try the next
//! alternative.
//!
//! A hole that cannot be made is not such an error; it is a finding of the plan.

use crate::reason::Reason;

pub use crate::knowledge::KnowledgeError;

/// Why a stage stops: the knowledge cannot answer, or it answers that this cannot be done.
///
/// The second is the typed refusal by which the planner tries the next alternative; it becomes a finding
/// when there is none. What a stage refuses for is a type of its own: [`Reason`] of routes and whole holes,
/// [`crate::reason::Uncut`] of cutting conditions.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal<W = Reason> {
    /// Planning stops: a table lacks what is required of it.
    Knowledge(KnowledgeError),
    /// This alternative cannot be carried out, for that reason.
    Not(W),
}

/// What a stage yields when it may refuse.
pub type Tried<T, W = Reason> = Result<T, Refusal<W>>;

impl<W, E: Into<KnowledgeError>> From<E> for Refusal<W> {
    fn from(error: E) -> Self {
        Self::Knowledge(error.into())
    }
}

impl<W> Refusal<W> {
    /// The refusal for the reason that a later stage makes of this one; a knowledge error stays as it is.
    pub fn map<V>(self, other: impl FnOnce(W) -> V) -> Refusal<V> {
        match self {
            Self::Not(why) => Refusal::Not(other(why)),
            Self::Knowledge(error) => Refusal::Knowledge(error),
        }
    }

    /// Tells a refusal from a knowledge error, where the caller goes on after the first.
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
