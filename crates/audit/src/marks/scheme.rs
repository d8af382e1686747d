//! The scheme file as a lecturer writes it: the source of docs/marks.schema.json. `read` takes the keys from here, and
//! reads the file itself, because it says where every mistake stands.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;
use technolog_knowledge::forms;

use super::super::file::ScopeOf;

/// The JSON Schema of a scheme file.
pub fn schema() -> Schema {
    schema_for!(SchemeFile)
}

forms! {
    /// A marking scheme for `technolog audit --marks`.
    pub struct SchemeFile {
        /// Name of the scheme.
        pub scheme: Option<String>,
        /// Points of a plan without a slip.
        #[schemars(range(min = 0))]
        pub points: f64,
        /// From how many points on a plan passes.
        #[schemars(range(min = 0))]
        pub pass: Option<f64>,
        /// Points off for a slip, by its severity; what is not named costs nothing.
        pub deduct: Option<Deduct>,
        /// Points off for what is only wrong because something else is: 0 unless said.
        #[schemars(range(min = 0))]
        pub consequences: Option<f64>,
        /// The most that one slip costs, with all that follows from it.
        #[schemars(range(min = 0))]
        pub slip_at_most: Option<f64>,
        /// What is special about a section of the audit.
        pub sections: Option<Sections>,
        /// Points off by the id of the rule or check, as findings name it in JSON: a number is for whatever is more than a note.
        pub rules: Option<BTreeMap<String, OfRule>>,
        /// Points off for a part of the plan that is missing; else shares of the points that leave an empty plan with none.
        pub missing: Option<Missing>,
        /// What the work is to cover: `holes`, `tools`, `conditions`, `clamping`, `program`, `times`; else what each plan says of itself.
        pub scope: Option<ScopeOf>,
    }

    /// Parts of a plan.
    pub struct Missing {
        /// The route of every group of holes.
        #[schemars(range(min = 0))]
        pub holes: Option<f64>,
        /// Tools and holders.
        #[schemars(range(min = 0))]
        pub tools: Option<f64>,
        /// Cutting conditions.
        #[schemars(range(min = 0))]
        pub conditions: Option<f64>,
        /// The clamping.
        #[schemars(range(min = 0))]
        pub clamping: Option<f64>,
        /// The program.
        #[schemars(range(min = 0))]
        pub program: Option<f64>,
        /// Times.
        #[schemars(range(min = 0))]
        pub times: Option<f64>,
    }

    /// Points off by severity.
    pub struct Deduct {
        /// Unsafe or impossible.
        #[schemars(range(min = 0))]
        pub error: Option<f64>,
        /// Contradicts the source or the arithmetic.
        #[schemars(range(min = 0))]
        pub wrong: Option<f64>,
        /// Allowed but dominated, or out of line with a formula.
        #[schemars(range(min = 0))]
        pub doubtful: Option<f64>,
        /// Worth knowing, or not stated.
        #[schemars(range(min = 0))]
        pub note: Option<f64>,
    }

    /// Sections of the audit.
    pub struct Sections {
        /// Rows of the route.
        pub route: Option<Section>,
        /// Tools.
        pub tools: Option<Section>,
        /// Holders.
        pub holders: Option<Section>,
        /// Cutting conditions.
        pub conditions: Option<Section>,
        /// Clamping.
        pub clamping: Option<Section>,
        /// Lengths and correctors.
        pub lengths: Option<Section>,
        /// The program.
        pub program: Option<Section>,
        /// Times.
        pub times: Option<Section>,
        /// What the plan does not say.
        pub missing: Option<Section>,
    }

    /// A section.
    pub struct Section {
        /// Unsafe or impossible.
        #[schemars(range(min = 0))]
        pub error: Option<f64>,
        /// Contradicts the source or the arithmetic.
        #[schemars(range(min = 0))]
        pub wrong: Option<f64>,
        /// Allowed but dominated, or out of line with a formula.
        #[schemars(range(min = 0))]
        pub doubtful: Option<f64>,
        /// Worth knowing, or not stated.
        #[schemars(range(min = 0))]
        pub note: Option<f64>,
        /// The most that the section can cost.
        #[schemars(range(min = 0))]
        pub at_most: Option<f64>,
    }
}

/// Points off for a rule.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OfRule {
    /// For errors, wrong and doubtful findings alike.
    Points(f64),
    /// By severity.
    BySeverity(Deduct),
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn the_example_is_of_the_schema() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/marks.yaml");
        let read: Result<SchemeFile, _> = serde_yaml::from_str(&std::fs::read_to_string(path).unwrap());
        assert!(read.is_ok(), "{:?}", read.err());
    }
}
