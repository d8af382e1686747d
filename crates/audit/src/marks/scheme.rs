//! The scheme file as a lecturer writes it: the source of docs/marks.schema.json. `read` reads the file itself, because
//! it says where every mistake stands, and a test holds the keys of the two together.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;

/// The JSON Schema of a scheme file.
pub fn schema() -> Schema {
    schema_for!(SchemeFile)
}

/// A marking scheme for `technolog audit --marks`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "only its shape is used")]
pub struct SchemeFile {
    /// Name of the scheme.
    scheme: Option<String>,
    /// Points of a plan without a slip.
    #[schemars(range(min = 0))]
    points: f64,
    /// From how many points on a plan passes.
    #[schemars(range(min = 0))]
    pass: Option<f64>,
    /// Points off for a slip, by its severity; what is not named costs nothing.
    deduct: Option<Deduct>,
    /// Points off for what is only wrong because something else is: 0 unless said.
    #[schemars(range(min = 0))]
    consequences: Option<f64>,
    /// What is special about a section: `route`, `tools`, `holders`, `conditions`, `clamping`, `lengths`, `program`,
    /// `times`, `missing`.
    sections: Option<BTreeMap<String, Section>>,
    /// Points off by the id of the rule or check, as findings name it in JSON.
    rules: Option<BTreeMap<String, f64>>,
}

/// Points off by severity.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "only its shape is used")]
struct Deduct {
    /// Unsafe or impossible.
    #[schemars(range(min = 0))]
    error: Option<f64>,
    /// Contradicts the source or the arithmetic.
    #[schemars(range(min = 0))]
    wrong: Option<f64>,
    /// Allowed but dominated, or out of line with a formula.
    #[schemars(range(min = 0))]
    doubtful: Option<f64>,
    /// Worth knowing, or not stated.
    #[schemars(range(min = 0))]
    note: Option<f64>,
}

/// A section.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "only its shape is used")]
struct Section {
    /// Unsafe or impossible.
    #[schemars(range(min = 0))]
    error: Option<f64>,
    /// Contradicts the source or the arithmetic.
    #[schemars(range(min = 0))]
    wrong: Option<f64>,
    /// Allowed but dominated, or out of line with a formula.
    #[schemars(range(min = 0))]
    doubtful: Option<f64>,
    /// Worth knowing, or not stated.
    #[schemars(range(min = 0))]
    note: Option<f64>,
    /// The most that the section can cost.
    #[schemars(range(min = 0))]
    at_most: Option<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::marks::read::{SCHEME, SECTION, SEVERITIES};

    #[test]
    fn the_schema_in_docs_is_the_generated_one() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/marks.schema.json");
        let generated = serde_json::to_string_pretty(&schema()).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/marks.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }

    #[test]
    fn the_schema_has_the_keys_that_the_reader_knows() {
        let schema = serde_json::to_value(schema()).unwrap();
        for (pointer, known) in [("", SCHEME), ("/$defs/Deduct", SEVERITIES), ("/$defs/Section", SECTION)] {
            let properties = schema.pointer(pointer).unwrap()["properties"].as_object().unwrap();
            let mut keys: Vec<&str> = properties.keys().map(String::as_str).collect();
            let mut known = known.to_vec();
            keys.sort_unstable();
            known.sort_unstable();
            assert_eq!(keys, known, "{pointer}");
        }
    }

    #[test]
    fn the_example_is_of_the_schema() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/marks.yaml");
        let read: Result<SchemeFile, _> = serde_yaml::from_str(&std::fs::read_to_string(path).unwrap());
        assert!(read.is_ok(), "{:?}", read.err());
    }
}
