//! The field of a fit, as the drawing writes it: `h6`, `f7`, `H7`.

use std::fmt;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Figure, IntoFigure};
use crate::tables::rules::TurningFieldFor;
use crate::tables::vocabularies::VocabularyWord;
use crate::units::{ItGrade, Micrometres};

/// A field by its letters and its grade.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its letters, capital for a hole.
    pub letters: String,
    /// Its grade.
    pub grade: ItGrade,
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.letters, self.grade.number())
    }
}

impl IntoFigure for &Field {
    fn into_figure(self) -> Figure {
        self.to_string().into_figure()
    }
}

impl Field {
    /// Whether the nominal size, which is what a program makes, lies in it, by the rule `turning-field`.
    ///
    /// # Errors
    /// The rule cannot answer.
    pub fn has_nominal(&self, size: Micrometres, knowledge: &Knowledge) -> Result<bool, KnowledgeError> {
        let question = TurningFieldFor { letters: &self.letters, grade: self.grade, diameter: size };
        Ok(knowledge.ask(&question)?.need(&self.to_string())?.holds)
    }

    /// Whether there is a field of its letters.
    ///
    /// # Errors
    /// The vocabulary `field-letters` is missing.
    pub fn is_known(&self, knowledge: &Knowledge) -> Result<bool, KnowledgeError> {
        let words = knowledge.table("field-letters")?.rows().collect::<Result<Vec<VocabularyWord<'_>>, _>>()?;
        Ok(words.iter().any(|known| known.word == self.letters))
    }
}
