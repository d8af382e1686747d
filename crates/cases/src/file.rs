//! The file of cases as its author writes it: the source of docs/cases.schema.json, which editors use for completion.
//! `read` takes the keys from here, and reads the file itself, because it says where every mistake stands.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;
use serde_json::Value;
use technolog_knowledge::forms;

use crate::plan::CuttingMethod;

/// The JSON Schema of a file of cases, with the names of the controls that there are.
pub fn schema(controls: &[&str]) -> Schema {
    let mut schema = schema_for!(CasesFile);
    if let Some(control) = schema.pointer_mut("/$defs/Control").and_then(Value::as_object_mut) {
        control.insert("enum".to_owned(), controls.into());
    }
    schema
}

/// Declares a mapping that may ask a question: one of `table`, `part` or `hole`, `turn`, `program`, `audit`.
macro_rules! question_forms {
    ($(#[$meta:meta])* $name:ident { $($(#[$remark:meta])* $field:ident: $kind:ty),* $(,)? }) => {
        forms! {
            $(#[$meta])*
            pub struct $name {
                $($(#[$remark])* pub $field: $kind,)*
                /// The table that is queried: `A.8`.
                pub table: Option<String>,
                /// What is known, by the names of the table's columns.
                pub given: Option<BTreeMap<String, Scalar>>,
                /// The part that is planned, or that a program must make: a path, or the keys of a part file.
                pub part: Option<FileOrKeys>,
                /// The keys of the only group of holes of `part`; its place need not be said.
                pub hole: Option<BTreeMap<String, Value>>,
                /// How cutting conditions are found.
                pub cutting: Option<CuttingMethod>,
                /// The turned part: a path, or the keys of its file.
                pub turn: Option<FileOrKeys>,
                /// Of a stepped shaft: its passes, or the operation.
                pub show: Option<Show>,
                /// What the passes of a stepped shaft make small.
                pub objective: Option<Aim>,
                /// The program that is run: a path, or its lines behind `|`.
                pub program: Option<String>,
                /// The control whose language it is.
                pub control: Option<Control>,
                /// The machine that runs it; without it the part's.
                pub machine: Option<String>,
                /// What the operator sets: a path, or its lines behind `|`.
                pub setting: Option<String>,
                /// The plan that is audited: a path, or the keys of a plan file.
                pub audit: Option<FileOrKeys>,
            }
        }
    };
}

question_forms! {
    /// Cases for `technolog test` (docs/cases.md). What stands beside `tests` holds for each of them, as far as a case does not
    /// say otherwise.
    CasesFile {
        /// The cases.
        #[schemars(length(min = 1))]
        tests: Vec<CaseForm>,
        /// Where the expectations come from: a table, a page, a computation by hand.
        source: Option<String>,
        /// Why they follow from there.
        because: Option<String>,
    }
}

question_forms! {
    /// A case: one question, and what is expected of the answer.
    CaseForm {
        /// Its name; without one it is called by its question.
        name: Option<String>,
        /// Where the expectation comes from: a table, a page, a computation by hand.
        source: Option<String>,
        /// Why it follows from there.
        because: Option<String>,
        /// What is expected: keys of the answer's JSON with values or matchers; of a table `none` where no row must answer.
        /// `technolog test --write` fills in an empty one.
        expect: Option<Value>,
    }
}

/// A value of a column.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
#[allow(missing_docs)] // the words of the format
pub enum Scalar {
    Text(String),
    Number(f64),
    Truth(bool),
}

/// A file beside this one, or what would stand in it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
#[allow(missing_docs)] // the words of the format
pub enum FileOrKeys {
    File(String),
    Keys(BTreeMap<String, Value>),
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the words of the format
pub enum Show {
    Passes,
    Operation,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the words of the format
pub enum Aim {
    Path,
    Passes,
    Time,
}

/// The name of a control, as the command line has it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Control(pub String);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Language;

    #[test]
    fn the_schema_in_docs_is_the_generated_one() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/cases.schema.json");
        let knowledge = technolog_shipped::knowledge().unwrap();
        let generated = serde_json::to_string_pretty(&schema(&Language::names(&knowledge))).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/cases.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }
}
