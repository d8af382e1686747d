//! What several tests share: reading, planning, and looking at the routes of a plan.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
pub mod cuts;
pub mod extremes;
pub mod fuzzing;
pub mod grid;
pub mod holes;
pub mod kinds;
pub mod lawful;
pub mod mutants;
pub mod oracle_json;
pub mod pages;
pub mod patterns;
pub mod proof_bench;
pub mod refusals;
pub mod section;
pub mod shafts;
pub mod spoilt;
pub mod turned;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use technolog::audit::Auditor;
use technolog::knowledge::{Knowledge, RowRef, SourceFile, Value};
use technolog::part::{Part, read_part};
use technolog::plan::{CuttingMethod, Operation, Plan, RouteSource};
use technolog::program::Language;
use technolog::units::Micrometres;
use technolog::{planner, shipped};

pub static KNOWLEDGE: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().unwrap());

/// Every control of mills, by its name.
pub fn languages() -> Vec<(&'static str, Language)> {
    Language::names(&KNOWLEDGE).into_iter().map(|name| (name, Language::read(name, &KNOWLEDGE).unwrap())).collect()
}

/// Audits of many plans: our own plan of a part is made once for all of them.
pub static AUDITOR: LazyLock<Auditor<'static>> = LazyLock::new(|| Auditor::new(&KNOWLEDGE).unwrap());

/// The shipped knowledge with one text of a file, which stands there once, put instead of another.
pub fn changed_knowledge(path: &str, old: &str, new: &str) -> Knowledge {
    let text = shipped::SOURCES.iter().find(|file| file.path == path).unwrap().text;
    assert_eq!(text.matches(old).count(), 1, "{path}: {old}");
    let changed = text.replace(old, new);
    let file = |file: &SourceFile<'static>| {
        let text = if file.path == path { changed.as_str() } else { file.text };
        SourceFile { path: file.path, text }
    };
    let files: Vec<SourceFile<'_>> = shipped::SOURCES.iter().map(file).collect();
    Knowledge::read_sources(&files).0
}

pub fn read(text: &str) -> Part {
    read_part("part.yaml", text, &KNOWLEDGE).unwrap_or_else(|problems| panic!("{problems:?}\n{text}"))
}

pub fn planned(part: &Part, method: CuttingMethod) -> Plan {
    planner::plan(part, method, &KNOWLEDGE).unwrap_or_else(|error| panic!("{error}\n{part:?}"))
}

/// A plan of one group of holes, `keys` as they stand in its braces.
pub fn plan_of_hole(material: &str, machine: &str, thickness: &str, keys: &str) -> Plan {
    let text = format!(
        "part: P\nmaterial: {material}\nmachine: {machine}\n\
         blank: {{kind: plate, length: 400, width: 200, thickness: {thickness}}}\nholes:\n  - {{name: A, {keys}}}\n"
    );
    planned(&read(&text), CuttingMethod::Formula)
}

/// The same with the schemes of the tables preferred.
pub fn plan_of_hole_by_tables(material: &str, machine: &str, thickness: &str, keys: &str) -> Plan {
    let part = plan_of_hole(material, machine, thickness, keys).part;
    planner::plan_by_tables(&part, CuttingMethod::Formula, &KNOWLEDGE).unwrap_or_else(|error| panic!("{error}"))
}

/// A route of a group: the one taken, one that lost, or one that cannot be carried out.
#[derive(Clone, Debug)]
pub struct RouteSummary {
    /// Absent if the group has no route at all: findings name only the scheme.
    pub source: Option<RouteSource>,
    pub scheme: String,
    /// Operations with the diameters they leave; empty where it cannot be carried out.
    pub operations: Vec<(Operation, Micrometres)>,
    pub carried_out: bool,
    pub taken: bool,
    /// Why it lost or cannot be carried out; empty of the one taken.
    pub why: String,
}

/// Every route of the first group that the plan tells of, the one taken first.
pub fn routes(plan: &Plan) -> Vec<RouteSummary> {
    let hole = &plan.holes[0];
    let Some(route) = &hole.route else {
        let named = |finding: &technolog::note::Finding| {
            let scheme = finding.note.figure("scheme")?.text().into_owned();
            let why = finding.note.code().to_owned();
            Some(RouteSummary { source: None, scheme, operations: Vec::new(), carried_out: false, taken: false, why })
        };
        return plan.findings.iter().filter_map(named).collect();
    };
    // What finishes a hole on another machine is no operation of the scheme.
    let here = |step: &&technolog::plan::Transition| step.operation.is_of_scheme(step.elsewhere);
    let taken = RouteSummary {
        source: Some(route.source),
        scheme: route.scheme.clone(),
        operations: hole.transitions.iter().filter(here).map(|step| (step.operation, step.diameter_mm)).collect(),
        carried_out: true,
        taken: true,
        why: String::new(),
    };
    let others = route.alternatives.iter().map(|other| RouteSummary {
        source: Some(other.source),
        scheme: other.scheme.clone(),
        operations: (other.operations.iter())
            .filter(|made| made.operation.is_of_scheme(made.elsewhere))
            .map(|made| (made.operation, made.diameter_mm))
            .collect(),
        carried_out: other.time_min.is_some(),
        taken: false,
        why: other.why.code().to_owned(),
    });
    std::iter::once(taken).chain(others).collect()
}

/// The root of the project.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The parts of `tests/found`: what laws once found, each with its name. A case of a law that fails becomes a file here.
pub fn found() -> Vec<(String, String)> {
    let entries = std::fs::read_dir(root().join("tests/found")).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let named = |path: std::path::PathBuf| {
        (path.file_stem().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(&path).unwrap())
    };
    paths.into_iter().map(named).collect()
}

/// A second reading of a table: its rows, each cell by its column.
pub fn reading(table: &str) -> Vec<BTreeMap<String, String>> {
    csv_rows(&format!("tests/readings/{table}.csv"))
}

/// The rows of a CSV file of this repository, each cell by its column.
pub fn csv_rows(path: &str) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_path(root().join(path)).unwrap();
    let columns: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let row = |record: csv::StringRecord| columns.iter().cloned().zip(record.iter().map(str::to_owned)).collect();
    reader.records().map(|record| row(record.unwrap())).collect()
}

/// Transitions as a table lists them, separated by spaces.
pub fn operations(written: &str) -> Vec<Operation> {
    written.split(' ').map(|name| Operation::from_name(name).unwrap_or_else(|| panic!("no operation {name}"))).collect()
}

/// The text of a cell.
pub fn text<'t>(row: RowRef<'t>, column: &str) -> &'t str {
    row.value(column).and_then(Value::as_text).unwrap_or_else(|| panic!("{column} holds no text"))
}

/// The number of a cell, in the unit of its column.
pub fn number(row: RowRef<'_>, column: &str) -> f64 {
    match row.value(column) {
        Some(Value::Number(number, _)) => number.to_f64(),
        other => panic!("{column}: {other:?}"),
    }
}
