//! Results of cases in JSON.

use serde::Serialize;
use serde_json::Value;
use technolog::cases::{ActualValue, Failure};

use super::super::diagnostics::Json as Mistake;
use super::super::{CliError, Context, output};
use super::{CaseFileRun, CaseRun, page};

#[derive(Serialize)]
struct Answer<'a> {
    files: Vec<FileJson<'a>>,
    passed: usize,
    failed: usize,
    unusable: usize,
}

#[derive(Serialize)]
struct FileJson<'a> {
    file: &'a str,
    passed: usize,
    failed: usize,
    mistakes: Vec<Mistake<'a>>,
    cases: Vec<CaseJson<'a>>,
}

#[derive(Serialize)]
struct CaseJson<'a> {
    number: usize,
    name: &'a str,
    line: u32,
    column: u32,
    passed: bool,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    written: bool,
    source: Option<&'a str>,
    because: Option<&'a str>,
    failures: Vec<FailureJson<'a>>,
}

#[derive(Serialize)]
struct FailureJson<'a> {
    line: u32,
    column: u32,
    path: &'a str,
    /// As written in the file.
    expected: &'a str,
    /// The actual value; null where there is none.
    came: Option<&'a Value>,
    message: String,
    why: Vec<String>,
}

/// The answer as JSON.
///
/// # Errors
/// It cannot be printed.
pub fn json(runs: &[CaseFileRun], context: &Context) -> Result<String, CliError> {
    let answer = Answer {
        files: runs.iter().map(|run| file(run, context)).collect(),
        passed: runs.iter().map(CaseFileRun::passed).sum(),
        failed: runs.iter().map(CaseFileRun::failed).sum(),
        unusable: runs.iter().filter(|run| !run.mistakes.is_empty()).count(),
    };
    output::json(&answer, context.lang)
}

fn file<'a>(run: &'a CaseFileRun, context: &Context) -> FileJson<'a> {
    FileJson {
        file: &run.file,
        passed: run.passed(),
        failed: run.failed(),
        mistakes: run.mistakes.iter().map(|mistake| Mistake::of(mistake, &run.texts, context.lang)).collect(),
        cases: run.cases.iter().map(|ran| case(ran, context)).collect(),
    }
}

fn case<'a>(ran: &'a CaseRun, context: &Context) -> CaseJson<'a> {
    CaseJson {
        number: ran.case.number,
        name: &ran.case.name,
        line: ran.case.place.line,
        column: ran.case.place.column,
        passed: ran.passed(),
        written: ran.written,
        source: ran.case.source.as_deref(),
        because: ran.case.because.as_deref(),
        failures: ran.failures.iter().map(|failed| failure(failed, context)).collect(),
    }
}

fn failure<'a>(failure: &'a Failure, context: &Context) -> FailureJson<'a> {
    FailureJson {
        line: failure.place.line,
        column: failure.place.column,
        path: &failure.path,
        expected: &failure.expected,
        came: match &failure.actual {
            ActualValue::Value(value) | ActualValue::Without(value) | ActualValue::Unwanted(value) => Some(value),
            ActualValue::Open(value) => value.as_ref(),
            ActualValue::Nothing | ActualValue::NoSuch { .. } | ActualValue::NoSuchWord { .. } => None,
        },
        message: page::short(failure, context.lang),
        why: failure.reasons.iter().map(|reason| page::why(reason, context.lang)).collect(),
    }
}
