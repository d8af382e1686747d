//! Cases: questions, parts, programs and audits with their expected answers, written in YAML (docs/cases.md).
//!
//! ```text
//! case.test.yaml → read → Case { question, expected } → answer (a JSON value, that of the command) → hold → failures
//! ```
//!
//! The kind of a file, a case or something else, is recognised by its contents ([`other_kind`]).
//!
//! One matcher compares all answers ([`hold`]): there is no special form for each kind of question, only the keys of
//! the commands' own JSON. Named things may be written by a short name ([`called`]).
//!
//! Architecture invariant: nothing passes by mistake. A key or a word that no answer can have is a fault of the file
//! or a failure, also where something is expected to be absent. A case that expects nothing fails. Where a case does
//! not mention findings, none of severity `error` or `wrong` is accepted.

mod answer;
mod called;
mod digest;
pub mod expected;
pub mod file;
pub mod hold;
mod kind;
pub mod limits;
mod merge;
mod planned;
mod question;
mod read;
mod read_question;
pub mod reasons;
mod table;
pub mod write;
mod written;

// The types of other crates, under the names of the whole program.
use technolog_audit as audit;
use technolog_core::{error, machine, motion, note, part, plan};
use technolog_holes::planner;
use technolog_knowledge::{self as knowledge, units};
use technolog_nc::program;
use technolog_turning as turning;

use std::sync::OnceLock;

use serde_json::Value;

use crate::audit::{Auditor, NamedText};
use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::Place;
use crate::turning::shaft::Mistake;

pub use called::{brief, name as called};
pub use expected::Expected;
pub use file::schema;
pub use hold::{ActualValue, Failure};
pub use kind::{FileKind, other_kind};
pub use read::{ReadContext, read_cases};
pub use reasons::Why;

use question::Question;

/// A file of cases, as far as it could be read.
#[derive(Debug)]
pub struct CaseFile {
    /// The file as the user named it.
    pub file: String,
    /// The cases that can be asked, in the order of the file.
    pub cases: Vec<Case>,
    /// Every mistake of the file and of the files it names.
    pub mistakes: Vec<Mistake>,
    /// The texts of the files it names, for the places of mistakes.
    pub texts: Vec<NamedText>,
}

/// A case.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its number among the cases of its file, from 1.
    pub number: usize,
    /// Its name, or its question on one line.
    pub name: String,
    /// Its place.
    pub place: Place,
    /// The origin of its expectation: a table, a page, a computation.
    pub source: Option<String>,
    /// The derivation of the expectation.
    pub because: Option<String>,
    question: Question,
    /// The expectation; absent: none yet.
    pub expected: Option<Expected>,
}

/// Answers questions: the tables, and the shared data of audits, made when the first plan is audited.
#[derive(Debug)]
pub struct Asker<'k> {
    /// The tables.
    pub knowledge: &'k Knowledge,
    auditor: OnceLock<Auditor<'k>>,
}

impl<'k> Asker<'k> {
    /// An asker with these tables.
    pub fn new(knowledge: &'k Knowledge) -> Self {
        Self { knowledge, auditor: OnceLock::new() }
    }

    /// What audits of many plans share.
    fn auditor(&self) -> Result<&Auditor<'k>, KnowledgeError> {
        match self.auditor.get() {
            Some(auditor) => Ok(auditor),
            None => {
                let auditor = Auditor::new(self.knowledge)?;
                Ok(self.auditor.get_or_init(|| auditor))
            }
        }
    }
}

impl Case {
    /// The answer to the question, as the JSON of its command.
    ///
    /// # Errors
    /// The knowledge base lacks something for the answer.
    pub fn answer(&self, asker: &Asker<'_>) -> Result<Value, KnowledgeError> {
        answer::answer(&self.question, asker)
    }

    /// Asks the question and compares the answer with the expectation: all differences.
    ///
    /// # Errors
    /// As for [`Self::answer`].
    pub fn run(&self, asker: &Asker<'_>) -> Result<Vec<Failure>, KnowledgeError> {
        Ok(self.against(&self.answer(asker)?, asker.knowledge))
    }

    /// Compares an answer to the question with what is expected.
    pub fn against(&self, answer: &Value, knowledge: &Knowledge) -> Vec<Failure> {
        match &self.expected {
            Some(expected) => self.question.hold(expected, answer, &self.place, knowledge),
            None => vec![Failure {
                place: self.place.clone(),
                path: String::new(),
                expected: String::new(),
                actual: ActualValue::Open(Some(digest::digest(&self.question, answer))),
                reasons: Vec::new(),
            }],
        }
    }
}
