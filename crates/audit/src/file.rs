//! The plan file as its author writes it: the source of docs/plan-audit.schema.json, which editors use for completion.
//!
//! These types say which keys there are and what they hold; `read` takes the keys from them, and reads the file itself,
//! because it says where every mistake stands.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;
use technolog_knowledge::forms;

use crate::part::Point;
use crate::part::file::PartFile;
use crate::plan::{CuttingMethod, Feature, Operation};

/// The JSON Schema of a plan file.
pub fn schema() -> Schema {
    schema_for!(PlanFile)
}

/// A number with a decimal point, as it is printed: the places behind the point say how it was rounded.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Number(pub f64);

/// A text; a bare number is one too.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Name {
    /// As text.
    Text(#[schemars(length(min = 1))] String),
    /// As number.
    Number(f64),
}

forms! {
    /// A plan to be audited by `technolog audit`. Everything but the part may be left out.
    pub struct PlanFile {
        /// Name of the plan.
        pub plan: Option<Name>,
        /// Whose work it is; else as the name of the file says: `Коваль_ТМ-31_7.yaml`.
        pub student: Option<Name>,
        /// The group of the student.
        pub group: Option<Name>,
        /// The variant of the task.
        pub variant: Option<Name>,
        /// The part: a path relative to this file, or the part itself.
        pub part: PartOrPath,
        /// By which method the conditions were found: by formula unless said.
        pub cutting: Option<CuttingMethod>,
        /// What the plan covers: `holes` (the route), `tools`, `conditions`, `clamping`, `program`, `times`; everything unless said.
        pub scope: Option<ScopeOf>,
        /// The route, in the order of work.
        pub route: Option<Vec<Row>>,
        /// The tools by their places: `T1: {…}`.
        pub tools: Option<BTreeMap<String, Tool>>,
        /// Cutting conditions, each for one or more rows of the route.
        pub conditions: Option<Vec<Conditions>>,
        /// The clamping.
        pub clamping: Option<Clamping>,
        /// The program.
        pub program: Option<Program>,
        /// Times of the whole part, min.
        pub times: Option<Times>,
    }

    /// A row of the route: one transition of one group of holes.
    pub struct Row {
        /// Its number; else its place in the list.
        pub row: Option<u32>,
        /// What is done.
        pub operation: OperationName,
        /// The group of holes.
        pub hole: Option<Name>,
        /// What of the hole it makes, where that is not its bore.
        pub feature: Option<Feature>,
        /// The step of a stepped hole it works on, from 1 at the entry face.
        pub step: Option<u32>,
        /// The set-up it is done in, from 1; the first unless said.
        pub setup: Option<u32>,
        /// How many holes.
        pub count: Option<Number>,
        /// The diameter it leaves, mm; for centring that of the spot.
        pub diameter: Option<Number>,
        /// What the same stroke also opens, mm: the wide part of a step drill.
        pub also: Option<Number>,
        /// The diameter before it, mm.
        pub from: Option<Number>,
        /// How deep, mm.
        pub depth: Option<Number>,
        /// Passes of the same tool.
        pub passes: Option<Number>,
        /// Its tool: T1, T2, ….
        pub tool: Option<Name>,
        /// Whether it is done on another machine.
        pub elsewhere: Option<bool>,
        /// The scheme of А.7 it belongs to.
        pub scheme: Option<Name>,
        /// The table of the scheme: `A.9`.
        pub table: Option<Name>,
    }

    /// A tool in its holder.
    pub struct Tool {
        /// The cutter.
        pub designation: Option<Name>,
        /// Its standard.
        pub standard: Option<Name>,
        /// The table it is in: `A.11`.
        pub table: Option<Name>,
        /// Diameter, mm.
        pub diameter: Option<Number>,
        /// Whole length L, mm.
        pub length: Option<Number>,
        /// Flute length l0, mm.
        pub flute_length: Option<Number>,
        /// Length outside the taper, mm.
        pub projection: Option<Number>,
        /// Point angle 2φ, degrees.
        pub point_angle: Option<Number>,
        /// How it is held: `cylindrical`, `morse`, `shell`, `taper`.
        pub shank: Option<String>,
        /// Diameter of its shank, mm.
        pub shank_diameter: Option<Number>,
        /// Number of its Morse taper.
        pub morse: Option<Number>,
        /// Its holder; `T1` when it is the same as the holder of T1.
        pub holder: Option<HolderOrTool>,
        /// How far it stands out of the holder, mm.
        pub overhang: Option<Number>,
        /// The length of the holder that the assembly was computed with, mm.
        pub holder_used: Option<Number>,
        /// From the spindle's face to the tip, mm.
        pub assembly: Option<Number>,
        /// The number of its length corrector, H.
        pub corrector: Option<Number>,
        /// What the corrector holds, mm.
        pub correction: Option<Number>,
        /// The length of the reference tool, mm; else the longest.
        pub reference_length: Option<Number>,
        /// How the corrector is called: `G43` or `G44`; else as the program calls it.
        pub with: Option<String>,
    }

    /// A holder.
    pub struct Holder {
        /// Its designation.
        pub designation: Option<Name>,
        /// Its standard.
        pub standard: Option<Name>,
        /// The smallest shank it clamps, mm.
        pub clamp_min: Option<Number>,
        /// The largest shank it clamps, mm.
        pub clamp_max: Option<Number>,
        /// Number of its Morse taper.
        pub morse: Option<Number>,
        /// Its length, mm.
        pub length: Option<Number>,
    }

    /// Cutting conditions.
    pub struct Conditions {
        /// The rows of the route they are for.
        pub r#for: RowsOf,
        /// How many holes.
        pub count: Option<Number>,
        /// The diameter D of the formula for the spindle speed, mm.
        pub diameter: Option<Number>,
        /// Depth of cut t, mm.
        pub depth_of_cut: Option<Number>,
        /// Passes.
        pub passes: Option<Number>,
        /// What the card or table gives before any factor.
        pub card: Option<Card>,
        /// The factors by name; one without a value is only named.
        pub factors: Option<Factors>,
        /// Feed S, mm/rev.
        pub feed: Option<Number>,
        /// The feed as it was rounded and taken, mm/rev.
        pub feed_taken: Option<Number>,
        /// Cutting speed V, m/min.
        pub speed: Option<Number>,
        /// Computed spindle speed n, 1/min.
        pub rpm_computed: Option<Number>,
        /// Spindle speed taken, 1/min.
        pub rpm: Option<Number>,
        /// What held the spindle speed back where the cutting speed did not: `spindle-power`, `feed-force`, ….
        pub limited_by: Option<String>,
        /// Cutting speed at the spindle speed taken, m/min.
        pub speed_taken: Option<Number>,
        /// Feed per minute, mm/min.
        pub minute_feed: Option<Number>,
        /// Axial force P, N.
        pub force: Option<Number>,
        /// Cutting power N, kW.
        pub power: Option<Number>,
        /// Torque M, N·m.
        pub torque: Option<Number>,
        /// Working travel of one pass, mm.
        pub travel: Option<Number>,
        /// Machine time of one hole, min.
        pub time: Option<Number>,
        /// Tool life T, min.
        pub tool_life: Option<Number>,
    }

    /// Figures of a card.
    pub struct Card {
        /// Feed, mm/rev.
        pub feed: Option<Number>,
        /// Speed, m/min.
        pub speed: Option<Number>,
        /// Axial force, N.
        pub force: Option<Number>,
        /// Power, kW.
        pub power: Option<Number>,
    }

    /// Factors by their names: feed and speed are multiplied by theirs, force and power divided.
    pub struct Factors {
        /// Of the feed.
        pub feed: Option<BTreeMap<String, Option<Number>>>,
        /// Of the speed.
        pub speed: Option<BTreeMap<String, Option<Number>>>,
        /// Of the force.
        pub force: Option<BTreeMap<String, Option<Number>>>,
        /// Of the power.
        pub power: Option<BTreeMap<String, Option<Number>>>,
    }

    /// The clamping.
    pub struct Clamping {
        /// The row of the route whose torque it must hold.
        pub r#for: Option<RowOf>,
        /// The group of holes whose largest torque it must hold, where no row is named.
        pub hole: Option<Name>,
        /// The power the torque was computed from, kW.
        pub power: Option<Number>,
        /// The spindle speed the torque was computed from, 1/min.
        pub rpm: Option<Number>,
        /// The torque, N·m.
        pub torque: Option<Number>,
        /// Safety factor k.
        pub safety: Option<Number>,
        /// Coefficient of friction f.
        pub friction: Option<Number>,
        /// Coefficient of friction on the support f2.
        pub support_friction: Option<Number>,
        /// The side force P of a milled or bored hole, N: with it the clamping force holds the part against sliding.
        pub side_force: Option<Number>,
        /// From clamp to cut, mm.
        pub distance: Option<Number>,
        /// Clamping force W, N.
        pub force: Option<Number>,
        /// Number of clamps.
        pub clamps: Option<Number>,
        /// Where the clamps press, mm: the distance to the hole follows.
        pub at: Option<Vec<Point>>,
        /// Force per clamp Q, N.
        pub force_per_clamp: Option<Number>,
        /// The screw: `M10`.
        pub screw: Option<String>,
        /// The clamp's designation.
        pub designation: Option<Name>,
        /// Its standard.
        pub standard: Option<Name>,
    }

    /// The program.
    pub struct Program {
        /// Its file, relative to this one.
        pub file: String,
        /// The control: `2c42-65`, `linuxcnc`, `fanuc`.
        pub control: String,
        /// What the operator sets, a file.
        pub setting: Option<String>,
    }

    /// Times of the whole part, min.
    pub struct Times {
        /// Machine time.
        pub machine: Option<Number>,
        /// At feed out of the holes.
        pub feed_out: Option<Number>,
        /// Dwells.
        pub dwell: Option<Number>,
        /// Rapids.
        pub rapid: Option<Number>,
        /// Tool changes.
        pub tool_change: Option<Number>,
        /// The operator's hands while the program waits.
        pub hand: Option<Number>,
        /// Sum.
        pub total: Option<Number>,
    }
}

/// The part.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum PartOrPath {
    /// Its file.
    Path(String),
    /// Itself.
    Part(Box<PartFile>),
}

/// One part of a plan or several.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ScopeOf {
    /// One.
    One(String),
    /// Several.
    Many(Vec<String>),
}

/// An operation.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OperationName {
    /// By its name in tables.
    Named(Operation),
    /// As the report calls it in Ukrainian: `свердління`, `свердлити`.
    Called(String),
}

/// A holder, or the tool that has the same.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum HolderOrTool {
    /// The tool.
    Tool(String),
    /// The holder.
    Holder(Box<Holder>),
}

/// One row or several.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum RowsOf {
    /// One.
    One(RowOf),
    /// Several.
    Many(Vec<RowOf>),
}

/// A row, or all rows of a tool.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum RowOf {
    /// The row of that number.
    Row(u32),
    /// The rows of that tool: `T2`.
    Tool(String),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_schema_in_docs_is_the_generated_one() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/plan-audit.schema.json");
        let generated = serde_json::to_string_pretty(&schema()).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/plan-audit.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }

    #[test]
    fn the_shipped_plans_are_of_the_schema() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let hand = ["right", "right-formula", "right-zone"].map(|name| format!("tests/audit/{name}.yaml"));
        for file in hand.iter().map(String::as_str).chain(["examples/appendix-g/plan.yaml"]) {
            let text = std::fs::read_to_string(root.join(file)).unwrap();
            let read: Result<PlanFile, _> = serde_yaml::from_str(&text);
            assert!(read.is_ok(), "{file}: {:?}", read.err());
        }
    }
}
