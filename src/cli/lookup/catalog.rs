//! A query against a catalog: the rows whose fields have the values asked for.

use std::collections::BTreeMap;

use serde::Serialize;
use technolog::knowledge::alike::has;
use technolog::knowledge::diagnostic::nearest;
use technolog::knowledge::table::Cell;
use technolog::knowledge::{Column, RowRef, Table, Value};

use super::near::{self, Near};
use super::question::Question;
use crate::cli::words;
use crate::cli::{CliError, Context, Format, Outcome, grid, record, sheet};

/// So many values of a text column are all named where none is near.
const FEW: usize = 12;

/// Finds the rows and shows them.
///
/// # Errors
/// The answer cannot be written.
pub fn answer(question: &Question<'_>, format: Format, context: &Context) -> Result<Outcome, CliError> {
    let table = question.table;
    let failed = |row: RowRef<'_>| -> Vec<usize> {
        let fails = |(index, value): &&(usize, Value)| !has(&table.columns[*index], &row.row().cells[*index], value);
        question.given.iter().filter(fails).map(|(index, _)| *index).collect()
    };
    let rows: Vec<RowRef<'_>> = table.all_rows().filter(|&row| failed(row).is_empty()).collect();
    let mut missed = Missed::default();
    if rows.is_empty() {
        missed.near = near::rows(table.all_rows(), question.given.len(), failed);
        missed.keys = question.given.iter().map(|(index, value)| Key::of(table, *index, value)).collect();
    }
    match format {
        Format::Json => context.emit_json(&Json {
            table: &table.id,
            result: record::Results(rows.clone()),
            inputs: record::Inputs(
                question.given.iter().map(|(index, value)| (&table.columns[*index], value)).collect(),
            ),
            rows: rows.iter().map(|&row| record::Whole::of(row)).collect(),
            nearest: near::json(&missed.near),
            nearest_values: missed.keys.iter().map(|key| (key.column.name.as_str(), key)).collect(),
        })?,
        _ if rows.is_empty() => context.emit(&missed_text(table, &missed, context))?,
        _ => context.emit(&found_text(table, &rows, context))?,
    }
    Ok(if rows.is_empty() { Outcome::Findings } else { Outcome::Done })
}

/// Why no row was found.
#[derive(Default)]
struct Missed<'a> {
    near: Vec<Near<'a>>,
    keys: Vec<Key<'a>>,
}

/// One key on its own: how many rows it finds, and the nearest values where it finds none.
struct Key<'a> {
    column: &'a Column,
    wanted: &'a Value,
    rows: usize,
    near: Vec<&'a Value>,
}

impl<'a> Key<'a> {
    fn of(table: &'a Table, index: usize, wanted: &'a Value) -> Self {
        let column = &table.columns[index];
        let rows = table.rows.iter().filter(|row| has(column, &row.cells[index], wanted)).count();
        let near = if rows == 0 { nearest_values(table, index, wanted) } else { Vec::new() };
        Self { column, wanted, rows, near }
    }
}

impl Serialize for Key<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.near.iter().map(|value| record::ValueJson(self.column, value)))
    }
}

/// The values of a column next to the wanted one: two below and two above, or texts that may be meant.
fn nearest_values<'a>(table: &'a Table, index: usize, wanted: &Value) -> Vec<&'a Value> {
    let column = &table.columns[index];
    let values = table.rows.iter().filter_map(|row| match &row.cells[index] {
        Cell::Value(value) => Some(value.items()),
        _ => None,
    });
    let values: Vec<&Value> = values.flatten().collect();
    if column.ty.is_ordered()
        && let Some(wanted) = column.rank(wanted)
    {
        let by_rank: BTreeMap<i64, &Value> =
            values.iter().filter_map(|&value| column.rank(value).map(|rank| (rank, value))).collect();
        let mut near: Vec<&Value> = by_rank.range(..wanted).rev().take(2).map(|(_, &value)| value).collect();
        near.reverse();
        near.extend(by_rank.range(wanted..).take(2).map(|(_, &value)| value));
        return near;
    }
    let by_text: BTreeMap<&str, &Value> =
        values.iter().filter_map(|&value| value.as_text().map(|text| (text, value))).collect();
    let wanted = wanted.to_string();
    let mut near: Vec<&str> = Vec::new();
    while near.len() < 4
        && let Some(next) = nearest(&wanted, by_text.keys().copied().filter(|text| !near.contains(text)))
    {
        near.push(next);
    }
    if near.is_empty() && by_text.len() <= FEW {
        return by_text.into_values().collect();
    }
    near.iter().filter_map(|text| by_text.get(text).copied()).collect()
}

fn found_text(table: &Table, rows: &[RowRef<'_>], context: &Context) -> String {
    let lang = context.lang;
    let mut text = sheet::title(table, context);
    let results: Vec<String> = rows.iter().map(|&row| record::results_text(lang, row)).collect();
    text.push('\n');
    text.push_str(&grid::paragraph(&format!("{}: {}", context.word("cli-result"), results.join("; ")), 0));
    text.push('\n');
    let (drawn, numbered) = sheet::rows(table, rows, context);
    text.push_str(&drawn);
    if numbered {
        text.push_str(&sheet::columns(table, numbered, context));
    }
    text.push_str(&sheet::said(rows, context));
    text
}

fn missed_text(table: &Table, missed: &Missed<'_>, context: &Context) -> String {
    let lang = context.lang;
    let mut text = sheet::title(table, context);
    text.push_str(&format!("\n{}: {}\n", context.word("cli-result"), context.word("cli-no-row")));
    let keys: Vec<Vec<String>> = missed
        .keys
        .iter()
        .map(|key| {
            let near: Vec<String> = key.near.iter().map(|value| record::bare(key.column, value)).collect();
            let near = match near.len() {
                0 => String::new(),
                _ => format!("{}: {}", context.word("cli-nearest-values"), near.join(", ")),
            };
            vec![
                key.column.name.clone(),
                record::with_unit(lang, key.column, key.wanted),
                words::rows(lang, key.rows),
                near,
            ]
        })
        .collect();
    text.push_str(&format!("\n{}\n{}", context.word("cli-each-alone"), grid::columns(&keys, 2)));
    text.push_str(&near::text(&missed.near, context));
    text
}

#[derive(Serialize)]
struct Json<'a> {
    table: &'a str,
    result: record::Results<'a>,
    inputs: record::Inputs<'a>,
    rows: Vec<record::Whole<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    nearest: Vec<near::Json<'a>>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    nearest_values: BTreeMap<&'a str, &'a Key<'a>>,
}
