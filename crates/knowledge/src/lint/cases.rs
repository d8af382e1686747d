//! The examples beside the decision tables: `rules/x.test.yaml` next to `rules/x.yaml`.
//!
//! ```yaml
//! table: centre-first
//! tests:
//!   - {given: {it: 12, diameter: 10}, expect: {centre: true}, because: textbook 1.2.1}
//! ```
//! `expect: none` states that no row applies. `source` gives the origin of the expectation, `because` the derivation;
//! one of the two is required. Such a file is also a file of cases for `technolog test`, which can do more
//! (docs/cases.md).

use crate::column::Column;
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::knowledge::Knowledge;
use crate::query::Input;
use crate::table::{Table, TableKind};
use crate::value::Value;
use crate::yaml::{Node, NodeKind, Problems, parse};
use technolog_note::{Note, note};

/// One file of examples.
#[derive(Debug)]
pub struct CaseFile {
    /// The table of the examples.
    pub table: String,
    /// The file.
    pub file: String,
    /// The examples.
    pub cases: Vec<Case>,
}

/// One example. Values are text until the table's columns are known.
#[derive(Debug)]
pub struct Case {
    /// Inputs by name.
    pub given: Vec<(String, String)>,
    /// Expected outputs by name, each a list of texts; none when no row may apply.
    pub expect: Option<Vec<(String, Vec<String>)>>,
    /// The origin of the expectation.
    pub because: String,
    place: Place,
}

impl CaseFile {
    /// Reads a file of examples.
    ///
    /// # Errors
    /// Every problem of the file.
    pub fn from_text(file: &str, text: &str) -> Result<Self, Vec<Diagnostic>> {
        let (root, diagnostics) = parse(file, text);
        let mut problems = Problems(diagnostics);
        let cases = root.and_then(|root| read(file, &root, &mut problems));
        match cases {
            Some(cases) if !problems.0.iter().any(|problem| problem.severity == Severity::Error) => Ok(cases),
            _ => Err(problems.0),
        }
    }
}

fn read(file: &str, root: &Node, problems: &mut Problems) -> Option<CaseFile> {
    let mut head = problems.open_map(root)?;
    let table = head.need("table", problems).and_then(|node| problems.text(node)).map(str::to_owned);
    let tests = head.need("tests", problems).and_then(|node| problems.list(node));
    head.finish(&["table", "tests"], problems);
    let cases = tests?.iter().filter_map(|node| case(node, problems)).collect();
    Some(CaseFile { table: table?, file: file.to_owned(), cases })
}

fn case(node: &Node, problems: &mut Problems) -> Option<Case> {
    let mut fields = problems.open_map(node)?;
    let given = fields.need("given", problems).and_then(|node| problems.open_map(node)).map(|mut given| {
        let mut pairs = Vec::new();
        for (key, node) in given.remaining() {
            pairs.extend(problems.text(node).map(|text| (key.text.clone(), text.to_owned())));
        }
        pairs
    });
    let expect = fields.need("expect", problems).and_then(|node| expectation(node, problems));
    let _ = fields.take("name");
    let source = fields.take("source").and_then(|node| problems.lines(node)).map(str::to_owned);
    let because = match source.is_some() {
        true => fields.take("because"),
        false => fields.need("because", problems),
    };
    let because = because.and_then(|node| problems.lines(node)).map(str::to_owned);
    let because = source.into_iter().chain(because).reduce(|source, because| format!("{source}: {because}"));
    fields.finish(&["given", "expect", "because", "source", "name"], problems);
    Some(Case { given: given?, expect: expect?, because: because?, place: node.place.clone() })
}

type Expectation = Option<Vec<(String, Vec<String>)>>;

fn expectation(node: &Node, problems: &mut Problems) -> Option<Expectation> {
    if node.text() == Some("none") {
        return Some(None);
    }
    let mut fields = problems.open_map(node)?;
    let mut outputs = Vec::new();
    for (key, node) in fields.remaining() {
        let values = match &node.kind {
            NodeKind::Seq(items) => items.iter().filter_map(|item| problems.text(item).map(str::to_owned)).collect(),
            _ => problems.text(node).map(str::to_owned).into_iter().collect(),
        };
        outputs.push((key.text.clone(), values));
    }
    Some(Some(outputs))
}

/// Runs every example; a decision table of `rules/` without examples is a finding.
pub(super) fn check(knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    for file in &knowledge.cases {
        let Ok(table) = knowledge.table(&file.table) else {
            let message = note!("lint-examples-which-no-table", file = file.file, table = file.table);
            findings.push(Diagnostic::error("dangling-reference", message, None));
            continue;
        };
        for case in &file.cases {
            if let Err(message) = run(table, case) {
                findings.push(
                    Diagnostic::error(
                        "failed-example",
                        note!("lint-table-example-fails", table = table.id, message = message),
                        case.place.clone(),
                    )
                    .help(note!("lint-expectation-comes-from", because = case.because)),
                );
            }
        }
    }
    for table in
        knowledge.tables().filter(|table| table.kind == TableKind::Decision && table.file.starts_with("rules/"))
    {
        // The compiled knowledge has no examples; only sources can be checked for them.
        if !knowledge.cases.iter().any(|file| file.table == table.id && !file.cases.is_empty()) {
            let message = note!("lint-rule-has-no-examples", file = table.file, table = table.id);
            let help = note!("lint-put-them-beside", file = table.file.replace(".yaml", ".test.yaml"));
            findings.push(Diagnostic::error("no-examples", message, None).help(help));
        }
    }
}

/// Compares one example with its table.
fn run(table: &Table, case: &Case) -> Result<(), Note> {
    let mut values: Vec<(&str, Value)> = Vec::new();
    for (name, text) in &case.given {
        let column = input_column(table, name)?;
        values.push((name, column.parse_value(text)?));
    }
    let inputs: Vec<(&str, Input<'_>)> = values
        .iter()
        .filter_map(|(name, value)| Option::<Input<'_>>::from(value).map(|input| (*name, input)))
        .collect();
    let answer = table.decide(&inputs).map_err(|error| Note::from(&error))?;
    let given = case.given.iter().map(|(name, text)| format!("{name}={text}")).collect::<Vec<_>>().join(" ");
    match (answer.winner(), &case.expect) {
        (None, None) => Ok(()),
        (None, Some(_)) => Err(note!("lint-no-row-for", given = given)),
        (Some(row), None) => Err(note!("lint-row-answers-where-none-should", row = row.number(), given = given)),
        (Some(row), Some(expected)) => {
            for (name, values) in expected {
                let found: Vec<String> = row
                    .value(name)
                    .map(|value| value.items().iter().map(ToString::to_string).collect())
                    .unwrap_or_default();
                if table.column_index(name).is_none() || found != *values {
                    return Err(note!(
                        "lint-gives",
                        given = given,
                        name = name,
                        found = found.join(", "),
                        values = values.join(", ")
                    ));
                }
            }
            Ok(())
        }
    }
}

fn input_column<'t>(table: &'t Table, name: &str) -> Result<&'t Column, Note> {
    table.inputs().map(|(_, column)| column).find(|column| column.name == name).ok_or_else(|| {
        let known: Vec<&str> = table.inputs().map(|(_, column)| column.name.as_str()).collect();
        note!("lint-no-input-inputs", name = name, known = known.join(", "))
    })
}
