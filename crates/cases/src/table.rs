//! A question to a table.

use serde_json::{Map, Value as Json};
use technolog_note::note;

use crate::knowledge::alike::{latin, matches};
use crate::knowledge::diagnostic::{Place, nearest};
use crate::knowledge::table::Cell;
use crate::knowledge::yaml::{Node, NodeKind, Problems};
use crate::knowledge::{Answer, Column, Input, Knowledge, QueryError, RowRef, Table, TableKind, Value};
use crate::note::{Because, Note};
use crate::units::Unit;

use super::expected::{Expected, ExpectedKind, Item};
use super::hold;
use super::reasons::Why;

/// A question: the table, and the given values.
#[derive(Clone, Debug)]
pub struct Question {
    /// The id of the table.
    pub table: String,
    /// The position of each column that is given, and its value.
    given: Vec<(usize, Value)>,
}

/// The fields of a row besides its columns.
const OF_ROWS: [&str; 5] = ["row", "source", "place", "reason", "unconfirmed"];

impl Question {
    /// Reads a question; faults are reported.
    pub fn read(table: &Node, given: Option<&Node>, knowledge: &Knowledge, problems: &mut Problems) -> Option<Self> {
        let id = latin(problems.text(table)?.trim());
        let Some(found) = knowledge.tables().find(|known| known.id.eq_ignore_ascii_case(&id)) else {
            let help = match nearest(&id, knowledge.tables().map(|table| table.id.as_str())) {
                Some(near) => note!("cli-did-you-mean", name = near),
                None => note!("case-technolog-table-lists-them"),
            };
            return problems.error_help("unknown-table", note!("cli-unknown-table", id = id), &table.place, help);
        };
        let mut columns = Vec::new();
        let mut whole = true;
        if let Some(given) = given {
            let NodeKind::Map(entries) = &given.kind else { return problems.open_map(given).and(None) };
            for (key, node) in entries {
                match value(found, &key.text, &key.place, node, problems) {
                    Some(column) => columns.push(column),
                    None => whole = false,
                }
            }
        }
        if !whole {
            return None;
        }
        let question = Self { table: found.id.clone(), given: columns };
        if found.kind == TableKind::Decision
            && let Err(error) = question.decide(found)
        {
            let place = given.map_or(&table.place, |given| &given.place);
            return problems.error_help(
                "bad-question",
                Note::from(&error),
                place,
                note!("case-technolog-table-shows-columns"),
            );
        }
        Some(question)
    }

    fn decide<'t>(&self, table: &'t Table) -> Result<Answer<'t>, QueryError> {
        let name = |index: usize| table.columns.get(index).map_or("", |column| column.name.as_str());
        let input = |(index, value)| Option::<Input<'_>>::from(value).map(|input| (name(index), input));
        let inputs: Vec<(&str, Input<'_>)> =
            self.given.iter().filter_map(|(index, value)| input((*index, value))).collect();
        table.decide(&inputs)
    }

    /// The rows that answer.
    pub fn rows<'t>(&self, table: &'t Table) -> Vec<RowRef<'t>> {
        match table.kind {
            TableKind::Decision => self.decide(table).map(|answer| answer.winners().collect()).unwrap_or_default(),
            TableKind::Catalog => {
                let fits = |row: &RowRef<'_>| {
                    self.given.iter().all(|(index, value)| {
                        let column = table.columns.get(*index).zip(row.row().cells.get(*index));
                        column.is_some_and(|(column, cell)| matches(column, cell, value))
                    })
                };
                table.all_rows().filter(fits).collect()
            }
        }
    }

    /// Why no other rows answer: the row that does, and rows that would give the expected value.
    pub fn why(&self, table: &Table, expected: &Expected) -> Vec<Why> {
        let Ok(answer) = self.decide(table) else { return Vec::new() };
        let won = answer.winners().map(|row| Why::Because(Box::new(Because::row(row, Note::new("")))));
        let gives = |row: &RowRef<'_>| {
            let value = row_json(*row);
            hold::hold(expected, hold::Answer { value: &value, vouched: true }).is_empty()
        };
        let others = answer.rejected().filter(|(row, _)| gives(row)).map(|(row, column)| Why::OtherRow {
            row: row.number(),
            column: column.name.clone(),
            cell: match table.column_index(&column.name).and_then(|index| row.row().cells.get(index)) {
                Some(Cell::Test(_, text)) => text.clone(),
                _ => "-".to_owned(),
            },
        });
        won.chain(others).collect()
    }
}

fn value(table: &Table, key: &str, at: &Place, node: &Node, problems: &mut Problems) -> Option<(usize, Value)> {
    let keys: Vec<(usize, &Column)> = match table.kind {
        TableKind::Decision => table.inputs().collect(),
        TableKind::Catalog => table.columns.iter().enumerate().collect(),
    };
    let text = problems.text(node)?;
    let Some((index, column)) = keys.iter().find(|(_, column)| column.name == key) else {
        let names = || keys.iter().map(|(_, column)| column.name.as_str());
        let help = match nearest(key, names()) {
            Some(near) => note!("cli-did-you-mean", name = near),
            None => note!("case-known-here", names = names().collect::<Vec<_>>().join(", ")),
        };
        return problems.error_help(
            "unknown-key",
            note!("case-table-has-no-input", table = table.id, key = key),
            at,
            help,
        );
    };
    match column.parse_value(text) {
        Ok(value) => Some((*index, value)),
        Err(why) => problems.error("bad-value", why, &node.place),
    }
}

/// The rows as a list of objects.
pub fn json(rows: &[RowRef<'_>]) -> Json {
    rows.iter().map(|row| row_json(*row)).collect()
}

/// The rows that an expectation concerns: a list concerns all of them, a mapping the row that answers (in a table
/// that collects rows, the first). `none` means that no row answers.
pub fn about<'v>(expected: &mut Expected, rows: &'v Json, table: &Table) -> &'v Json {
    let all = rows.as_array().map(Vec::as_slice).unwrap_or_default();
    match (&expected.kind, all) {
        (ExpectedKind::Is(word), _) if word == "none" => {
            expected.kind = ExpectedKind::List(Vec::new());
            rows
        }
        (ExpectedKind::Map(_), [row]) => row,
        (ExpectedKind::Map(_), [first, ..]) if table.kind == TableKind::Decision => first,
        (ExpectedKind::Map(_), _) => {
            // Not one row: the whole list is the actual value.
            let item = Item { expected: expected.clone(), optional: false };
            expected.kind = ExpectedKind::List(vec![item]);
            rows
        }
        _ => rows,
    }
}

/// A row as an object: its outputs by column name, with its number and its source.
fn row_json(row: RowRef<'_>) -> Json {
    let mut object = Map::new();
    for (index, column) in answer_columns(row.table) {
        if let Some(cell) = row.row().cells.get(index) {
            object.insert(column.name.clone(), cell_json(column, cell));
        }
    }
    let own = row.row();
    let texts = [
        Json::from(row.number()),
        Json::from(own.source.to_string()),
        Json::from(row.place()),
        own.reason.as_deref().into(),
        own.unconfirmed.as_deref().into(),
    ];
    for (key, value) in OF_ROWS.iter().zip(texts) {
        object.entry(*key).or_insert(value);
    }
    Json::Object(object)
}

/// The columns of a row's answer.
fn answer_columns(table: &Table) -> Vec<(usize, &Column)> {
    match table.kind {
        TableKind::Decision => table.outputs().collect(),
        TableKind::Catalog => table.columns.iter().enumerate().collect(),
    }
}

fn cell_json(column: &Column, cell: &Cell) -> Json {
    match cell {
        Cell::Empty => Json::Null,
        Cell::Test(_, text) => Json::from(text.as_str()),
        Cell::Value(value) => value_json(column, value),
    }
}

fn value_json(column: &Column, value: &Value) -> Json {
    match (column.unit, value) {
        (Unit::Micrometre, Value::Length(length)) => Json::from(length.micrometres()),
        (_, Value::List(items)) => items.iter().map(|item| value_json(column, item)).collect(),
        (_, value) => serde_json::to_value(value).unwrap_or_default(),
    }
}

/// Compares the keys of an expectation with the columns of the table; a single value of a list column is a list of one.
pub fn fit(expected: &mut Expected, table: &Table, problems: &mut Problems) {
    match &mut expected.kind {
        ExpectedKind::List(items) => items.iter_mut().for_each(|item| fit(&mut item.expected, table, problems)),
        ExpectedKind::Map(keys) => {
            for (key, inner) in keys {
                let column =
                    answer_columns(table).into_iter().map(|(_, column)| column).find(|column| column.name == key.text);
                if let (Some(Column { list: true, .. }), ExpectedKind::Is(_)) = (column, &inner.kind) {
                    let item = Item { expected: inner.clone(), optional: false };
                    inner.kind = ExpectedKind::List(vec![item]);
                }
                if column.is_none() && !OF_ROWS.contains(&key.text.as_str()) {
                    let names =
                        || answer_columns(table).into_iter().map(|(_, column)| column.name.as_str()).chain(OF_ROWS);
                    let help = match nearest(&key.text, names()) {
                        Some(near) => note!("cli-did-you-mean", name = near),
                        None => note!("case-known-here", names = names().collect::<Vec<_>>().join(", ")),
                    };
                    let message = note!("case-table-gives-no", table = table.id, key = key.text);
                    problems.error_help::<()>("unknown-key", message, &key.place, help);
                }
            }
        }
        _ => {}
    }
}
