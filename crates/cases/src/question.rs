//! The question of a case.

use serde_json::Value;

use crate::audit::stated::Stated;
use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::Place;
use crate::note::Severity;
use crate::part::Part;
use crate::plan::CuttingMethod;
use crate::program::{Language, Setting};
use crate::turning::passes::cost::Objective;
use crate::turning::workpiece::Workpiece;

use super::expected::Expected;
use super::hold::{ActualValue, Answer, Failure, hold, is_from};
use super::reasons::Why;
use super::table;

/// A question that was read without faults.
#[derive(Clone, Debug)]
pub enum Question {
    /// To a table: `technolog lookup`.
    Table(table::Question),
    /// The plan of a part: `technolog plan`.
    Part {
        /// The part.
        part: Box<Part>,
        /// How cutting conditions are found.
        method: CuttingMethod,
    },
    /// The turning of a part: `technolog turn`.
    Turned {
        /// The part.
        part: Box<Workpiece>,
        /// Whether the operation is asked for, where the file is a stepped shaft.
        operation: bool,
        /// The objective of the passes of a stepped shaft.
        objective: Objective,
    },
    /// The run of a program: `technolog check`.
    Program(Box<Program>),
    /// The audit of a plan: `technolog audit`.
    Audit(Box<Stated>),
}

/// A program and its input.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its text.
    pub text: String,
    /// The language of its control.
    pub language: Language,
    /// The name of the control.
    pub control: String,
    /// The machine, where one is named.
    pub machine: Option<String>,
    /// The operator's setting.
    pub setting: Setting,
    /// The part that it must make.
    pub part: Option<Part>,
}

impl Question {
    /// The lists of findings of its answers.
    fn findings(&self) -> &'static [&'static [&'static str]] {
        match self {
            Self::Table(_) => &[],
            Self::Part { .. } | Self::Turned { .. } | Self::Audit(_) => &[&["findings"]],
            Self::Program(_) => &[&["findings"], &["part"], &["proof", "findings"]],
        }
    }

    /// All differences between an answer and its expectation. A list of findings that the case does not mention must
    /// have none that is wrong.
    pub fn hold(&self, expected: &Expected, answer: &Value, case: &Place, knowledge: &Knowledge) -> Vec<Failure> {
        if let (Self::Table(question), Ok(found)) = (self, knowledge.table(self.table())) {
            let mut expected_rows = expected.clone();
            let about = table::about(&mut expected_rows, answer, found);
            let mut failures = hold(&expected_rows, Answer { value: about, vouched: true });
            let why = if failures.is_empty() { Vec::new() } else { question.why(found, expected) };
            failures.iter_mut().for_each(|failure| failure.reasons.clone_from(&why));
            return failures;
        }
        let vouched = matches!(self, Self::Part { .. });
        let mut failures = hold(expected, Answer { value: answer, vouched });
        for keys in self.findings() {
            let is_stated = keys.iter().try_fold(expected, |expected, key| expected.get(key)).is_some();
            let list = keys.iter().try_fold(answer, |answer, key| answer.get(key)).and_then(Value::as_array);
            if is_stated {
                continue;
            }
            let wrong = list.into_iter().flatten().filter(|finding| is_from(finding, Severity::Wrong));
            failures.extend(wrong.map(|finding| Failure {
                place: case.clone(),
                path: keys.join("."),
                expected: "none_from: wrong".to_owned(),
                actual: ActualValue::Unwanted(finding.clone()),
                reasons: Vec::<Why>::new(),
            }));
        }
        failures
    }

    fn table(&self) -> &str {
        match self {
            Self::Table(question) => &question.table,
            _ => "",
        }
    }
}
