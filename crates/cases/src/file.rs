//! The file of cases as its author writes it: the source of docs/cases.schema.json, which editors use for completion.
//! `read` reads the file itself, because it says where every mistake stands.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, schema_for};
use serde_json::Value;

use crate::plan::CuttingMethod;

/// The JSON Schema of a file of cases.
pub fn schema() -> Schema {
    schema_for!(CasesFile)
}

/// Cases for `technolog test` (docs/cases.md). What stands beside `tests` holds for each of them, as far as a case does not
/// say otherwise.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[allow(dead_code, reason = "only its shape is used")]
struct CasesFile {
    /// The cases.
    #[schemars(length(min = 1))]
    tests: Vec<CaseForm>,
    /// Where the expectations come from: a table, a page, a computation by hand.
    source: Option<String>,
    /// Why they follow from there.
    because: Option<String>,
    #[schemars(flatten)]
    question: QuestionForm,
}

/// A case: one question, and what is expected of the answer.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[allow(dead_code, reason = "only its shape is used")]
struct CaseForm {
    /// Its name; without one it is called by its question.
    name: Option<String>,
    /// Where the expectation comes from: a table, a page, a computation by hand.
    source: Option<String>,
    /// Why it follows from there.
    because: Option<String>,
    /// What is expected: keys of the answer's JSON with values or matchers; of a table `none` where no row must answer.
    /// `technolog test --write` fills in an empty one.
    expect: Option<Value>,
    #[schemars(flatten)]
    question: QuestionForm,
}

/// What is asked: one of `table`, `part` or `hole`, `turn`, `program`, `audit`.
#[derive(JsonSchema)]
#[allow(dead_code, reason = "only its shape is used")]
struct QuestionForm {
    /// The table that is asked: `A.8`.
    table: Option<String>,
    /// What is known, by the names of the table's columns.
    given: Option<BTreeMap<String, Scalar>>,
    /// The part that is planned, or that a program must make: a path, or the keys of a part file.
    part: Option<FileOrKeys>,
    /// The keys of the only group of holes of `part`; its place need not be said.
    hole: Option<BTreeMap<String, Value>>,
    /// How cutting conditions are found.
    cutting: Option<CuttingMethod>,
    /// The turned part: a path, or the keys of its file.
    turn: Option<FileOrKeys>,
    /// Of a stepped shaft: its passes, or the operation.
    show: Option<Show>,
    /// What the passes of a stepped shaft make small.
    objective: Option<Aim>,
    /// The program that is run: a path, or its lines behind `|`.
    program: Option<String>,
    /// The control whose language it is.
    control: Option<Control>,
    /// The machine that runs it; without it the part's.
    machine: Option<String>,
    /// What the operator sets: a path, or its lines behind `|`.
    setting: Option<String>,
    /// The plan that is audited: a path, or the keys of a plan file.
    audit: Option<FileOrKeys>,
}

/// A value of a column.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[allow(dead_code, reason = "only its shape is used")]
enum Scalar {
    Text(String),
    Number(f64),
    Truth(bool),
}

/// A file beside this one, or what would stand in it.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[allow(dead_code, reason = "only its shape is used")]
enum FileOrKeys {
    File(String),
    Keys(BTreeMap<String, Value>),
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
#[allow(dead_code, reason = "only its shape is used")]
enum Show {
    Passes,
    Operation,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
#[allow(dead_code, reason = "only its shape is used")]
enum Aim {
    Path,
    Passes,
    Time,
}

#[derive(JsonSchema)]
#[allow(dead_code, reason = "only its shape is used")]
enum Control {
    #[schemars(rename = "2c42-65")]
    TwoC42,
    #[schemars(rename = "linuxcnc")]
    LinuxCnc,
    #[schemars(rename = "fanuc")]
    Fanuc,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Language;
    use crate::read::{AUDIT, COMMON, PART, PROGRAM, TABLE, TURN};

    #[test]
    fn the_schema_in_docs_is_the_generated_one() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/cases.schema.json");
        let generated = serde_json::to_string_pretty(&schema()).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/cases.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }

    #[test]
    fn the_schema_has_the_keys_that_the_reader_knows() {
        let schema = serde_json::to_value(schema()).unwrap();
        let keys = |pointer: &str| {
            let mut keys: Vec<String> =
                schema.pointer(pointer).unwrap()["properties"].as_object().unwrap().keys().cloned().collect();
            keys.sort_unstable();
            keys
        };
        fn sorted(mut known: Vec<&str>) -> Vec<&str> {
            known.sort_unstable();
            known.dedup();
            known
        }
        let asking: Vec<&str> = [TABLE, PART, TURN, PROGRAM, AUDIT].concat();
        assert_eq!(keys("/$defs/CaseForm"), sorted([&asking[..], COMMON].concat()));
        assert_eq!(keys(""), sorted([&asking[..], &["source", "because", "tests"]].concat()));
        let controls = schema.pointer("/$defs/Control/enum").unwrap();
        assert_eq!(*controls, serde_json::to_value(Language::NAMES).unwrap());
    }
}
