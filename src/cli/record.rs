//! Rows and cells in JSON: in the form of queries and tables.

use serde::ser::{SerializeMap, SerializeSeq};
use serde::{Serialize, Serializer};
use technolog::knowledge::table::Cell;
use technolog::knowledge::{Column, ColumnRole, RowRef, Table, Value};
use technolog::units::Unit;

/// The columns of a lookup's answer: those that the table names, otherwise all that are no inputs.
pub fn results(table: &Table) -> Vec<usize> {
    let named: Vec<usize> = table.result.iter().filter_map(|name| table.column_index(name)).collect();
    if named.is_empty() { table.outputs().map(|(index, _)| index).collect() } else { named }
}

/// A cell without its unit: a test as written, a value, or nothing.
pub fn cell(column: &Column, cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Test(_, text) => text.clone(),
        Cell::Value(value) => bare(column, value),
    }
}

/// A value as written in a query, without its unit.
pub fn bare(column: &Column, value: &Value) -> String {
    match value {
        Value::List(items) => items.iter().map(|item| bare(column, item)).collect::<Vec<_>>().join(", "),
        Value::Length(_) => column.rank(value).map_or_else(|| value.to_string(), |rank| column.show_rank(rank)),
        other => other.to_string(),
    }
}

/// A value in JSON, in the unit of its column.
#[derive(Debug)]
pub struct ValueJson<'a>(pub &'a Column, pub &'a Value);

impl Serialize for ValueJson<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match (self.0.unit, self.1) {
            (Unit::Micrometre, Value::Length(length)) => serializer.serialize_i64(length.micrometres()),
            (_, Value::List(items)) => {
                let mut list = serializer.serialize_seq(Some(items.len()))?;
                for item in items {
                    list.serialize_element(&ValueJson(self.0, item))?;
                }
                list.end()
            }
            (_, value) => value.serialize(serializer),
        }
    }
}

/// A cell in JSON: a test as written, a value, or null.
struct CellJson<'a>(&'a Column, &'a Cell);

impl Serialize for CellJson<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.1 {
            Cell::Empty => serializer.serialize_none(),
            Cell::Test(_, text) => serializer.serialize_str(text),
            Cell::Value(value) => ValueJson(self.0, value).serialize(serializer),
        }
    }
}

/// Some cells of a row, as an object in the order of the columns.
#[derive(Debug)]
pub struct Cells<'t> {
    row: RowRef<'t>,
    columns: Vec<usize>,
}

impl<'t> Cells<'t> {
    /// These columns.
    pub fn of(row: RowRef<'t>, columns: Vec<usize>) -> Self {
        Self { row, columns }
    }

    /// All columns that are no inputs.
    pub fn outputs(row: RowRef<'t>) -> Self {
        Self::of(row, row.table.outputs().map(|(index, _)| index).collect())
    }
}

impl Serialize for Cells<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_map(Some(self.columns.len()))?;
        for &index in &self.columns {
            let column = &self.row.table.columns[index];
            object.serialize_entry(&column.name, &CellJson(column, &self.row.row().cells[index]))?;
        }
        object.end()
    }
}

/// Typed inputs by name, as an object in the order of the columns.
#[derive(Debug)]
pub struct Inputs<'a>(pub Vec<(&'a Column, &'a Value)>);

impl Serialize for Inputs<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|&(column, value)| (column.name.as_str(), ValueJson(column, value))))
    }
}

/// The data of a row besides its cells.
#[derive(Debug, Serialize)]
pub struct RowData<'t> {
    source: String,
    place: &'t str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'t str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    unconfirmed: Option<&'t str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    choice: Option<&'t str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    corrections: Option<Corrections<'t>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'t str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    priority: Option<i64>,
}

impl<'t> RowData<'t> {
    /// Of that row.
    pub fn of(row: RowRef<'t>) -> Self {
        let content = row.row();
        Self {
            source: content.source.to_string(),
            place: row.place(),
            reason: content.reason.as_deref(),
            unconfirmed: content.unconfirmed.as_deref().filter(|_| !content.is_choice),
            choice: content.unconfirmed.as_deref().filter(|_| content.is_choice),
            corrections: (!content.corrections.is_empty()).then_some(Corrections(row)),
            note: content.note.as_deref(),
            priority: content.priority,
        }
    }
}

/// The corrections of a row, as in its file: `{column: {printed, reason}}`.
#[derive(Debug)]
struct Corrections<'t>(RowRef<'t>);

impl Serialize for Corrections<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Correction<'t> {
            printed: &'t str,
            reason: &'t str,
        }
        serializer.collect_map(self.0.row().corrections.iter().map(|correction| {
            (&correction.column, Correction { printed: &correction.printed, reason: &correction.reason })
        }))
    }
}

/// A whole row: every cell, and the data besides them.
#[derive(Debug, Serialize)]
pub struct WholeRow<'t> {
    #[serde(flatten)]
    cells: Cells<'t>,
    #[serde(flatten)]
    about: RowData<'t>,
}

impl<'t> WholeRow<'t> {
    /// Of that row.
    pub fn of(row: RowRef<'t>) -> Self {
        Self { cells: Cells::of(row, (0..row.table.columns.len()).collect()), about: RowData::of(row) }
    }
}

/// The values of the result columns: a list for one column, an object per row for several.
#[derive(Debug)]
pub struct Results<'t>(pub Vec<RowRef<'t>>);

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let columns = self.0.first().map(|row| results(row.table)).unwrap_or_default();
        let mut list = serializer.serialize_seq(None)?;
        for &row in &self.0 {
            match columns[..] {
                [only] => {
                    let column = &row.table.columns[only];
                    if let Cell::Value(value) = &row.row().cells[only] {
                        for item in value.items() {
                            list.serialize_element(&ValueJson(column, item))?;
                        }
                    }
                }
                _ => list.serialize_element(&Cells::of(row, columns.clone()))?,
            }
        }
        list.end()
    }
}

/// The role of a column, as JSON names it.
pub const fn role(role: ColumnRole) -> &'static str {
    match role {
        ColumnRole::Field => "field",
        ColumnRole::Input => "input",
        ColumnRole::Output => "output",
    }
}
