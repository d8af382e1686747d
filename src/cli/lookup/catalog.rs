//! A query of a catalog: the rows with the given values.

use std::collections::BTreeMap;

use serde::Serialize;
use technolog::document::{Column as Head, Document, Inlines};
use technolog::knowledge::alike::matches;
use technolog::knowledge::diagnostic::nearest;
use technolog::knowledge::table::Cell;
use technolog::knowledge::{Column, RowRef, Table, Value};
use technolog::words::say;

use super::near::{self, NearRow};
use super::question::LookupQuestion;
use crate::cli::{CliError, Context, Format, Lang, Outcome, record, sheet, shown};

/// If a text column has no more values than this, all of them are named when none is near.
const FEW: usize = 12;

/// Finds the rows and shows them.
///
/// # Errors
/// The answer cannot be written.
pub fn answer(question: &LookupQuestion<'_>, format: Format, context: &Context) -> Result<Outcome, CliError> {
    let table = question.table;
    let failed = |row: RowRef<'_>| -> Vec<usize> {
        let fails =
            |(index, value): &&(usize, Value)| !matches(&table.columns[*index], &row.row().cells[*index], value);
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
            rows: rows.iter().map(|&row| record::WholeRow::of(row)).collect(),
            nearest: near::json(&missed.near),
            nearest_values: missed.keys.iter().map(|key| (key.column.name.as_str(), key)).collect(),
        })?,
        _ if rows.is_empty() => context.emit_document(&missed_page(table, &missed, context.lang), format)?,
        _ => context.emit_document(&found_page(table, &rows, context.lang, context.room(format)), format)?,
    }
    Ok(if rows.is_empty() { Outcome::Findings } else { Outcome::Done })
}

/// Why no row was found.
#[derive(Default)]
struct Missed<'a> {
    near: Vec<NearRow<'a>>,
    keys: Vec<Key<'a>>,
}

/// A single key: the number of rows that it finds, and the nearest values if it finds none.
struct Key<'a> {
    column: &'a Column,
    wanted: &'a Value,
    rows: usize,
    near: Vec<&'a Value>,
}

impl<'a> Key<'a> {
    fn of(table: &'a Table, index: usize, wanted: &'a Value) -> Self {
        let column = &table.columns[index];
        let rows = table.rows.iter().filter(|row| matches(column, &row.cells[index], wanted)).count();
        let near = if rows == 0 { nearest_values(table, index, wanted) } else { Vec::new() };
        Self { column, wanted, rows, near }
    }
}

impl Serialize for Key<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.near.iter().map(|value| record::ValueJson(self.column, value)))
    }
}

/// The values of a column next to the wanted one: two below and two above, or similar texts.
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

fn found_page(table: &Table, rows: &[RowRef<'_>], lang: Lang, room: Option<usize>) -> Document {
    let mut page = sheet::titled(table, lang);
    let results: Vec<String> = rows.iter().map(|&row| shown::result(lang, row)).collect();
    super::result(&mut page, &results.join("; "), lang);
    let numbered = sheet::rows(&mut page, table, rows, lang, room);
    if numbered {
        sheet::columns(&mut page, table, numbered, lang);
    }
    sheet::row_remarks(&mut page, rows, lang);
    page
}

fn missed_page(table: &Table, missed: &Missed<'_>, lang: Lang) -> Document {
    let mut page = sheet::titled(table, lang);
    super::result(&mut page, lang.word("cli-no-row"), lang);
    page.heading(2, lang.word("cli-each-alone"));
    let heads = ["table-key", "table-asked", "table-found", "cli-nearest-values"];
    let row = |key: &Key<'_>| {
        let near: Vec<String> = key.near.iter().map(|value| shown::value(lang, key.column, value)).collect();
        vec![
            Inlines::default().code(&key.column.name),
            shown::full(lang, key.column, key.wanted).into(),
            say!(lang, "cli-rows-counted", count = key.rows).into(),
            near.join("; ").into(),
        ]
    };
    let heads = heads.map(|head| Head::text(lang.word(head))).to_vec();
    page.push(sheet::filled(heads, missed.keys.iter().map(row).collect()));
    near::section(&mut page, &missed.near, lang);
    page
}

#[derive(Serialize)]
struct Json<'a> {
    table: &'a str,
    result: record::Results<'a>,
    inputs: record::Inputs<'a>,
    rows: Vec<record::WholeRow<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    nearest: Vec<near::Json<'a>>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    nearest_values: BTreeMap<&'a str, &'a Key<'a>>,
}
