//! A query against a decision table: the row that won, and why every other one lost.

use serde::Serialize;
use technolog::knowledge::query::Answer;
use technolog::knowledge::table::{Cell, Uncovered};
use technolog::knowledge::{Column, Diagnostic, Input, RowRef, Table, Value};

use super::near::{self, Near};
use super::question::Question;
use crate::cli::words;
use crate::cli::{CliError, Context, Format, Outcome, grid, record, sheet};

/// More rejected rows than this are grouped by column, unless all are asked for.
const LISTED: usize = 12;

/// Asks the table and shows its answer.
///
/// # Errors
/// The rows of the table contradict each other, or the answer cannot be written.
pub fn answer(question: &Question<'_>, all: bool, format: Format, context: &Context) -> Result<Outcome, CliError> {
    let table = question.table;
    let inputs: Vec<(&str, Input<'_>)> = question
        .given
        .iter()
        .filter_map(|(index, value)| {
            Option::<Input<'_>>::from(value).map(|input| (table.columns[*index].name.as_str(), input))
        })
        .collect();
    let answer = table.decide(&inputs).map_err(|error| {
        let help = words::run_lint(context.lang);
        Diagnostic::error("contradiction", technolog::note::Note::from(&error), None).help(help)
    })?;
    let told = Told::of(question, &answer);
    match format {
        Format::Json => context.emit_json(&told.json())?,
        _ => context.emit(&told.text(all, context))?,
    }
    Ok(if told.winners.is_empty() { Outcome::Findings } else { Outcome::Done })
}

/// An input as the table understood it.
struct Asked<'a> {
    index: usize,
    column: &'a Column,
    value: &'a Value,
    rank: i64,
    by_default: bool,
}

/// Everything there is to tell about an answer.
struct Told<'a> {
    table: &'a Table,
    asked: Vec<Asked<'a>>,
    winners: Vec<RowRef<'a>>,
    passed_over: Vec<RowRef<'a>>,
    rejected: Vec<(RowRef<'a>, &'a Column, &'a str)>,
    gap: Option<&'a Uncovered>,
    near: Vec<Near<'a>>,
}

impl<'a> Told<'a> {
    fn of(question: &'a Question<'a>, answer: &Answer<'a>) -> Self {
        let table = question.table;
        let asked: Vec<Asked<'_>> = table
            .inputs()
            .filter_map(|(index, column)| {
                let given = question.value(index);
                let value = given.or(column.default.as_ref())?;
                Some(Asked { index, column, value, rank: column.rank(value)?, by_default: given.is_none() })
            })
            .collect();
        let winners: Vec<RowRef<'_>> = answer.winners().collect();
        let lies_in = |gap: &&Uncovered| gap.sets.iter().zip(&asked).all(|(set, asked)| set.contains(asked.rank));
        let gap = if winners.is_empty() { table.uncovered.iter().find(lies_in) } else { None };
        let failed = |row: RowRef<'_>| -> Vec<usize> {
            let fails = |asked: &&Asked<'_>| match &row.row().cells[asked.index] {
                Cell::Test(set, _) => !set.contains(asked.rank),
                _ => false,
            };
            asked.iter().filter(fails).map(|asked| asked.index).collect()
        };
        let near = if winners.is_empty() { near::rows(table.all_rows(), asked.len(), failed) } else { Vec::new() };
        let rejected = answer
            .rejected()
            .map(|(row, column)| {
                let cell = table.column_index(&column.name).map(|index| &row.row().cells[index]);
                let test = match cell {
                    Some(Cell::Test(_, text)) => text.as_str(),
                    _ => "-",
                };
                (row, column, test)
            })
            .collect();
        Self { table, asked, winners, passed_over: answer.passed_over().collect(), rejected, gap, near }
    }

    fn text(&self, all: bool, context: &Context) -> String {
        let lang = context.lang;
        let mut text = sheet::title(self.table, context);
        let result = match &self.winners[..] {
            [] => context.word("cli-no-row").to_owned(),
            rows => rows.iter().map(|&row| record::results_text(lang, row)).collect::<Vec<_>>().join("; "),
        };
        text.push('\n');
        text.push_str(&grid::paragraph(&format!("{}: {result}", context.word("cli-result")), 0));
        if let Some(gap) = self.gap {
            text.push_str(&grid::paragraph(&format!("{}: {}", context.word("cli-gap"), gap.reason), 0));
        }
        for &row in &self.winners {
            text.push_str(&self.winner(row, context));
        }
        if self.winners.is_empty() {
            text.push_str(&format!(
                "\n{}\n{}",
                context.word("cli-question"),
                grid::columns(&self.question(context), 2)
            ));
            text.push_str(&near::text(&self.near, context));
        }
        text.push_str(&sheet::said(&self.winners, context));
        if !self.passed_over.is_empty() {
            let rows: Vec<Vec<String>> = self
                .passed_over
                .iter()
                .map(|&row| {
                    let result = record::results_text(lang, row);
                    vec![words::rows_named(lang, &[row.number()]), format!("→ {result}")]
                })
                .collect();
            text.push_str(&format!("\n{}\n{}", context.word("cli-passed-over"), grid::columns(&rows, 2)));
        }
        text.push_str(&self.rejected(all, context));
        text
    }

    /// The inputs with their units.
    fn question(&self, context: &Context) -> Vec<Vec<String>> {
        self.asked
            .iter()
            .map(|asked| {
                let default = if asked.by_default { context.word("cli-by-default") } else { "" };
                let value = record::with_unit(context.lang, asked.column, asked.value);
                vec![asked.column.name.clone(), value, default.to_owned()]
            })
            .collect()
    }

    /// A row that won: its source, its tests against the inputs, and what it says beside the result.
    fn winner(&self, row: RowRef<'_>, context: &Context) -> String {
        let lang = context.lang;
        let source = record::source(lang, row.row().source);
        let named = words::rows_named(lang, &[row.number()]);
        let mut text = String::from("\n");
        text.push_str(&grid::paragraph(&format!("{} ({source}): {}", capital(&named), row.place()), 0));
        let mut lines = self.question(context);
        for (line, asked) in lines.iter_mut().zip(&self.asked) {
            line.insert(2, record::cell(asked.column, &row.row().cells[asked.index]));
        }
        text.push_str(&grid::columns(&lines, 2));
        let results = record::results(self.table);
        let others: Vec<Vec<String>> = self
            .table
            .outputs()
            .filter(|(index, _)| !results.contains(index))
            .filter_map(|(index, column)| match &row.row().cells[index] {
                Cell::Value(value) => {
                    let label = record::label(lang, column).unwrap_or_default();
                    Some(vec![column.name.clone(), record::with_unit(lang, column, value), label.to_owned()])
                }
                _ => None,
            })
            .collect();
        if !others.is_empty() {
            text.push_str(&format!("\n{}\n{}", context.word("cli-also-says"), grid::columns(&others, 2)));
        }
        text
    }

    /// The rejected rows, each with its first failing column, or counted by column where they are many.
    fn rejected(&self, all: bool, context: &Context) -> String {
        let lang = context.lang;
        if self.rejected.is_empty() {
            return String::new();
        }
        let heading = context.word("cli-rejected");
        if all || self.rejected.len() <= LISTED {
            let rows: Vec<Vec<String>> = self
                .rejected
                .iter()
                .map(|(row, column, test)| {
                    vec![words::rows_named(lang, &[row.number()]), column.name.clone(), (*test).to_owned()]
                })
                .collect();
            return format!("\n{heading}\n{}", grid::columns(&rows, 2));
        }
        let rows: Vec<Vec<String>> = self
            .asked
            .iter()
            .filter_map(|asked| {
                let own = self.rejected.iter().filter(|(_, column, _)| column.name == asked.column.name);
                // In the order of the table, where neighbouring intervals follow each other.
                let mut counts: Vec<(&str, usize)> = Vec::new();
                for (_, _, test) in own {
                    match counts.iter_mut().find(|(known, _)| known == test) {
                        Some((_, count)) => *count += 1,
                        None => counts.push((test, 1)),
                    }
                }
                let total: usize = counts.iter().map(|(_, count)| count).sum();
                let tests: Vec<String> = counts.iter().map(|(test, count)| format!("{test} ×{count}")).collect();
                (total > 0).then(|| vec![asked.column.name.clone(), words::rows(lang, total), tests.join(", ")])
            })
            .collect();
        format!("\n{heading} ({})\n{}", context.word("cli-all-rejected"), grid::columns(&rows, 2))
    }

    fn json(&self) -> Json<'_> {
        let first = self.winners.first().copied();
        Json {
            table: &self.table.id,
            result: record::Results(self.winners.clone()),
            row: first.map(RowRef::number),
            outputs: first.map(record::Cells::outputs),
            inputs: record::Inputs(self.asked.iter().map(|asked| (asked.column, asked.value)).collect()),
            about: first.map(record::About::of),
            uncovered: self.gap.map(|gap| gap.reason.as_str()),
            nearest: near::json(&self.near),
            passed_over: self
                .passed_over
                .iter()
                .map(|&row| PassedOver { row: row.number(), outputs: record::Cells::outputs(row) })
                .collect(),
            rejected: self
                .rejected
                .iter()
                .map(|&(row, column, cell)| Rejected { row: row.number(), column: &column.name, cell })
                .collect(),
            rows: self.winners.iter().map(|&row| record::Whole::of(row)).collect(),
        }
    }
}

/// With its first letter large.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

#[derive(Serialize)]
struct Json<'t> {
    table: &'t str,
    result: record::Results<'t>,
    row: Option<usize>,
    outputs: Option<record::Cells<'t>>,
    inputs: record::Inputs<'t>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    about: Option<record::About<'t>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncovered: Option<&'t str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    nearest: Vec<near::Json<'t>>,
    passed_over: Vec<PassedOver<'t>>,
    rejected: Vec<Rejected<'t>>,
    rows: Vec<record::Whole<'t>>,
}

#[derive(Serialize)]
struct PassedOver<'t> {
    row: usize,
    outputs: record::Cells<'t>,
}

#[derive(Serialize)]
struct Rejected<'t> {
    row: usize,
    column: &'t str,
    cell: &'t str,
}
