//! A query of a decision table: the row that applies, and why every other row does not.

use serde::Serialize;
use technolog::document::{Block, Column as Head, Document, Field, Inlines, Keep, Table as Grid};
use technolog::knowledge::query::Answer;
use technolog::knowledge::table::{Cell, Uncovered};
use technolog::knowledge::{Column, Diagnostic, Input, RowRef, Table, Value};
use technolog::words::say;

use super::near::{self, NearRow};
use super::question::LookupQuestion;
use crate::cli::{CliError, Context, Format, Lang, Outcome, record, sheet, shown};

/// If there are more rejected rows, they are grouped by column, unless all are requested.
const LISTED: usize = 12;

/// Asks the table and shows its answer.
///
/// # Errors
/// The rows of the table contradict each other, or the answer cannot be written.
pub fn answer(
    question: &LookupQuestion<'_>,
    all: bool,
    format: Format,
    context: &Context,
) -> Result<Outcome, CliError> {
    let table = question.table;
    let inputs: Vec<(&str, Input<'_>)> = question
        .given
        .iter()
        .filter_map(|(index, value)| {
            Option::<Input<'_>>::from(value).map(|input| (table.columns[*index].name.as_str(), input))
        })
        .collect();
    let answer = table.decide(&inputs).map_err(|error| {
        let help = context.word("cli-run-lint");
        Diagnostic::error("contradiction", technolog::note::Note::from(&error), None).help(help)
    })?;
    let report = DecisionReport::of(question, &answer);
    match format {
        Format::Json => context.emit_json(&report.json())?,
        _ => context.emit_document(&report.page(all, context.lang), format)?,
    }
    Ok(if report.winners.is_empty() { Outcome::Findings } else { Outcome::Done })
}

/// An input as the table understood it.
struct UnderstoodInput<'a> {
    index: usize,
    column: &'a Column,
    value: &'a Value,
    rank: i64,
    by_default: bool,
}

/// All data about an answer.
struct DecisionReport<'a> {
    table: &'a Table,
    inputs: Vec<UnderstoodInput<'a>>,
    winners: Vec<RowRef<'a>>,
    passed_over: Vec<RowRef<'a>>,
    rejected: Vec<(RowRef<'a>, &'a Column, &'a str)>,
    gap: Option<&'a Uncovered>,
    near: Vec<NearRow<'a>>,
}

impl<'a> DecisionReport<'a> {
    fn of(question: &'a LookupQuestion<'a>, answer: &Answer<'a>) -> Self {
        let table = question.table;
        let inputs: Vec<UnderstoodInput<'_>> = table
            .inputs()
            .filter_map(|(index, column)| {
                let given = question.value(index);
                let value = given.or(column.default.as_ref())?;
                Some(UnderstoodInput { index, column, value, rank: column.rank(value)?, by_default: given.is_none() })
            })
            .collect();
        let winners: Vec<RowRef<'_>> = answer.winners().collect();
        let lies_in = |gap: &&Uncovered| gap.sets.iter().zip(&inputs).all(|(set, input)| set.contains(input.rank));
        let gap = if winners.is_empty() { table.uncovered.iter().find(lies_in) } else { None };
        let failed = |row: RowRef<'_>| -> Vec<usize> {
            let fails = |input: &&UnderstoodInput<'_>| match &row.row().cells[input.index] {
                Cell::Test(set, _) => !set.contains(input.rank),
                _ => false,
            };
            inputs.iter().filter(fails).map(|input| input.index).collect()
        };
        let near = if winners.is_empty() { near::rows(table.all_rows(), inputs.len(), failed) } else { Vec::new() };
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
        Self { table, inputs, winners, passed_over: answer.passed_over().collect(), rejected, gap, near }
    }

    fn page(&self, all: bool, lang: Lang) -> Document {
        let mut page = sheet::titled(self.table, lang);
        let results: Vec<String> = self.winners.iter().map(|&row| shown::result(lang, row)).collect();
        let result = if results.is_empty() { lang.word("cli-no-row") } else { &results.join("; ") };
        super::result(&mut page, result, lang);
        if let Some(gap) = self.gap {
            page.push(Block::Fields(vec![Field::new(lang.word("cli-gap"), lang.remark(&gap.reason).into_owned())]));
        }
        for &row in &self.winners {
            self.winner(&mut page, row, lang);
        }
        if self.winners.is_empty() {
            page.heading(2, lang.word("cli-question"));
            page.push(self.question(None, lang));
            near::section(&mut page, &self.near, lang);
        }
        sheet::row_remarks(&mut page, &self.winners, lang);
        if !self.passed_over.is_empty() {
            page.heading(2, lang.word("cli-passed-over"));
            let mut rows = grid(&["cli-row", "table-answer"], lang);
            for &row in &self.passed_over {
                rows.row([Inlines::number(row.number().to_string()), shown::result(lang, row).into()]);
            }
            page.push(rows);
        }
        self.rejected(&mut page, all, lang);
        page
    }

    /// The inputs with their units, beside the tests of a row.
    fn question(&self, row: Option<RowRef<'_>>, lang: Lang) -> Grid {
        let mut heads =
            vec![Head::text(lang.word("table-key")), Head::text(lang.word("table-what")).keep(Keep::Optional)];
        heads.push(Head::text(lang.word("table-asked")));
        heads.extend(row.map(|_| Head::text(lang.word("cli-row"))));
        let one = |input: &UnderstoodInput<'_>| {
            let value = shown::full(lang, input.column, input.value);
            let value = if input.by_default { say!(lang, "table-by-default", value = value) } else { value };
            let mut cells = vec![key(input.column), shown::label(lang, input.column).unwrap_or_default().into()];
            cells.push(value.into());
            cells.extend(row.map(|row| shown::cell(lang, input.column, &row.row().cells[input.index]).into()));
            cells
        };
        sheet::filled(heads, self.inputs.iter().map(one).collect())
    }

    /// A row that applies: its source, its tests with the inputs, and its remarks besides the result.
    fn winner(&self, page: &mut Document, row: RowRef<'_>, lang: Lang) {
        let source = shown::source(lang, row.row().source);
        page.heading(
            2,
            say!(lang, "table-winner", row = row.number(), source = source, place = lang.place(row.place())),
        );
        page.push(self.question(Some(row), lang));
        let results = record::results(self.table);
        let mut others = grid(&["table-key", "table-what", "table-answer"], lang);
        for (index, column) in self.table.outputs().filter(|(index, _)| !results.contains(index)) {
            if let Cell::Value(value) = &row.row().cells[index] {
                let label = shown::label(lang, column).unwrap_or_default();
                others.row([key(column), label.into(), shown::full(lang, column, value).into()]);
            }
        }
        if !others.is_empty() {
            page.heading(2, lang.word("cli-also-says"));
            page.push(others);
        }
    }

    /// The rejected rows, each with its first failing column, or counted by column where they are many.
    fn rejected(&self, page: &mut Document, all: bool, lang: Lang) {
        if self.rejected.is_empty() {
            return;
        }
        page.heading(2, lang.word("cli-rejected"));
        if all || self.rejected.len() <= LISTED {
            let mut rows = grid(&["cli-row", "table-key", "table-failed"], lang);
            for (row, column, test) in &self.rejected {
                let number = Inlines::number(row.number().to_string());
                rows.row([number, key(column), shown::test(lang, column, test).into()]);
            }
            return page.push(rows);
        }
        let mut rows = grid(&["table-key", "cli-row-count", "table-failed"], lang);
        for input in &self.inputs {
            let own = self.rejected.iter().filter(|(_, column, _)| column.name == input.column.name);
            // In the order of the table, where neighbouring intervals follow each other.
            let mut counts: Vec<(&str, usize)> = Vec::new();
            for (_, _, test) in own {
                match counts.iter_mut().find(|(known, _)| known == test) {
                    Some((_, count)) => *count += 1,
                    None => counts.push((test, 1)),
                }
            }
            let total: usize = counts.iter().map(|(_, count)| count).sum();
            let test = |(test, count): &(&str, usize)| format!("{} ×{count}", shown::test(lang, input.column, test));
            let tests: Vec<String> = counts.iter().map(test).collect();
            if total > 0 {
                rows.row([key(input.column), Inlines::number(total.to_string()), tests.join("; ").into()]);
            }
        }
        rows.notes.push(Inlines::sentence(lang.word("cli-all-rejected")));
        page.push(rows);
    }

    fn json(&self) -> Json<'_> {
        let first = self.winners.first().copied();
        Json {
            table: &self.table.id,
            result: record::Results(self.winners.clone()),
            row: first.map(RowRef::number),
            outputs: first.map(record::Cells::outputs),
            inputs: record::Inputs(self.inputs.iter().map(|input| (input.column, input.value)).collect()),
            about: first.map(record::RowData::of),
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
            rows: self.winners.iter().map(|&row| record::WholeRow::of(row)).collect(),
        }
    }
}

/// The key of a column in a query.
fn key(column: &Column) -> Inlines {
    Inlines::default().code(&column.name)
}

fn grid(heads: &[&str], lang: Lang) -> Grid {
    Grid::new(heads.iter().map(|head| Head::text(lang.word(head))))
}

#[derive(Serialize)]
struct Json<'t> {
    table: &'t str,
    result: record::Results<'t>,
    row: Option<usize>,
    outputs: Option<record::Cells<'t>>,
    inputs: record::Inputs<'t>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    about: Option<record::RowData<'t>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncovered: Option<&'t str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    nearest: Vec<near::Json<'t>>,
    passed_over: Vec<PassedOver<'t>>,
    rejected: Vec<Rejected<'t>>,
    rows: Vec<record::WholeRow<'t>>,
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
