//! A table: head, typed columns, rows with a source each.

use std::fmt;
use std::sync::OnceLock;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_note::{Note, note};

use crate::column::{Column, ColumnRole, Label};
use crate::contract::TableRow;
use crate::diagnostic::Place;
use crate::query::Index;
use crate::set::Set;
use crate::units::Decimal;
use crate::value::Value;
use crate::vocabulary::{Operation, Shank, ToolMaterial};

/// A catalog repeats its source; a decision table says which row applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum TableKind {
    /// Rows are looked up by their fields.
    Catalog,
    /// Rows match inputs by tests.
    Decision,
}

/// The result if several rows match.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum HitPolicy {
    /// At most one row may match.
    Unique,
    /// Several may match if they say the same.
    Any,
    /// The first of those that match.
    First,
    /// The one with the highest `priority`.
    Priority,
    /// All of them.
    Collect,
}

impl HitPolicy {
    /// Every policy with its name in a table file.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("unique", Self::Unique),
        ("any", Self::Any),
        ("first", Self::First),
        ("priority", Self::Priority),
        ("collect", Self::Collect),
    ];
}

/// The origin of a row's figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// Taken from the source text unchanged.
    Seed,
    /// Taken from a named standard or handbook.
    Standard,
    /// Inferred, with the reason.
    Reconstructed,
}

impl Source {
    /// Every source with its name in a table file.
    pub const NAMES: [(&'static str, Self); 3] =
        [("seed", Self::Seed), ("standard", Self::Standard), ("reconstructed", Self::Reconstructed)];
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(Self::NAMES.iter().find(|(_, source)| source == self).map_or("", |(name, _)| name))
    }
}

/// A cell of a row.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Cell {
    /// The row leaves it out.
    Empty,
    /// A value.
    Value(Value),
    /// A test of an input: the ranks it matches, and the test as written.
    Test(Set, String),
}

/// A figure the source prints wrongly, kept beside the right one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Correction {
    /// The column.
    pub column: String,
    /// What the source prints.
    pub printed: String,
    /// Why it is wrong.
    pub reason: String,
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Row {
    /// Its cells, in the order of the columns.
    pub cells: Vec<Cell>,
    /// The origin of its figures.
    pub source: Source,
    /// Its place in the source, if not the table's place.
    pub place: Option<String>,
    /// The data from which it was inferred.
    pub reason: Option<String>,
    /// Why it is not fully trusted: what of it nothing confirms or, where `is_choice`, what of it is chosen here.
    pub unconfirmed: Option<String>,
    /// It is doubted as a choice of ours, which no page could confirm, and not as a figure of the world.
    pub is_choice: bool,
    /// Figures printed wrongly.
    pub corrections: Vec<Correction>,
    /// A remark for readers.
    pub note: Option<String>,
    /// For the hit policy `priority`: the highest wins.
    pub priority: Option<i64>,
    /// The line of the table file, from 1.
    pub line: u32,
    /// The place of each cell; only when read from YAML, for `lint`.
    #[serde(skip)]
    pub places: Vec<Option<Place>>,
}

/// A gap that exists in the source.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Uncovered {
    /// A set per input column, in the order of [`Table::inputs`].
    pub sets: Vec<Set>,
    /// Why there is no row.
    pub reason: String,
    /// Where it is declared; only when read from YAML.
    #[serde(skip)]
    pub place: Option<Place>,
}

/// A law for the numbers of a table; `lint` checks the rows against it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Law {
    /// The name of the law.
    pub name: String,
    /// Its parameters by name.
    pub parameters: Vec<(String, String)>,
    /// Where it is declared; only when read from YAML.
    #[serde(skip)]
    pub place: Option<Place>,
}

impl Law {
    /// A parameter of the law.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }
}

/// The head of a table of cutters, valid for all its rows.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ToolHead {
    /// The transitions these cutters make.
    pub operations: Vec<Operation>,
    /// Their shank.
    pub shank: Shank,
    /// Tool material.
    pub material: ToolMaterial,
    /// Point angle 2φ, degrees.
    pub point_angle: Option<Decimal>,
    /// Number of teeth, where all have the same.
    pub teeth: Option<i64>,
    /// Whether the end teeth of a mill reach its middle, so that it cuts straight down into metal.
    pub centre_cutting: bool,
}

/// A table of the knowledge base.
#[derive(Debug, Serialize, Deserialize)]
pub struct Table {
    /// Its id, `A.11` or `cutting-speed`.
    pub id: String,
    /// Its title.
    pub title: Label,
    /// Catalog or decision table.
    pub kind: TableKind,
    /// The result if several rows match.
    pub hit: HitPolicy,
    /// The place of its rows in the source.
    pub place: String,
    /// The standard it is taken from.
    pub standard: Option<String>,
    /// Remarks for readers of the whole table.
    pub notes: Vec<String>,
    /// The columns of a lookup's answer.
    pub result: Vec<String>,
    /// The columns that identify a row of a catalog.
    pub key: Vec<String>,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows.
    pub rows: Vec<Row>,
    /// Declared gaps.
    pub uncovered: Vec<Uncovered>,
    /// Laws its numbers obey.
    pub laws: Vec<Law>,
    /// The head of a tool table.
    pub tool: Option<ToolHead>,
    /// The file it was read from.
    pub file: String,
    /// The line where its columns begin, from 1.
    pub columns_line: u32,
    /// The compiled form of its tests.
    #[serde(skip)]
    pub(crate) index: OnceLock<Index>,
    /// The positions of the row type's fields among its columns, with the name of that type.
    #[serde(skip)]
    pub(crate) layout: OnceLock<(&'static str, Vec<Option<usize>>)>,
}

impl Table {
    /// The schema of which the table is a record, if any: by its law `record`.
    pub fn record_of(&self) -> Option<&str> {
        self.laws.iter().find(|law| law.name == "record")?.get("schema")
    }

    /// The position of a column.
    pub fn column_index(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }

    /// The input columns with their positions.
    pub fn inputs(&self) -> impl Iterator<Item = (usize, &Column)> {
        self.columns.iter().enumerate().filter(|(_, column)| column.role == ColumnRole::Input)
    }

    /// The columns that are not inputs, with their positions.
    pub fn outputs(&self) -> impl Iterator<Item = (usize, &Column)> {
        self.columns.iter().enumerate().filter(|(_, column)| column.role != ColumnRole::Input)
    }

    /// Every row, read as its row type.
    pub fn rows<'t, R: TableRow<'t>>(&'t self) -> impl Iterator<Item = Result<R, TableError>> {
        self.all_rows().map(R::read)
    }

    /// All rows, read as their row type.
    ///
    /// # Errors
    /// A row breaks its contract; this does not happen in a checked table.
    pub fn read<'t, R: TableRow<'t>>(&'t self) -> Result<Vec<R>, TableError> {
        // Not `collect`: that would not know the number of rows and copy them as the list grows.
        let mut rows = Vec::with_capacity(self.rows.len());
        for row in self.rows() {
            rows.push(row?);
        }
        Ok(rows)
    }

    /// A row by its position.
    pub fn row(&self, index: usize) -> Option<RowRef<'_>> {
        (index < self.rows.len()).then_some(RowRef { table: self, index })
    }

    /// Every row.
    pub fn all_rows(&self) -> impl Iterator<Item = RowRef<'_>> {
        (0..self.rows.len()).map(|index| RowRef { table: self, index })
    }

    /// The first row whose text column has that value.
    pub(crate) fn find(&self, column: &str, value: &str) -> Option<RowRef<'_>> {
        self.all_rows().find(|row| row.value(column).and_then(Value::as_text) == Some(value))
    }
}

/// A row in its table.
#[derive(Clone, Copy, Debug)]
pub struct RowRef<'t> {
    /// The table.
    pub table: &'t Table,
    /// The position of the row.
    pub index: usize,
}

/// A table lacks something that the program requires.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableError {
    /// The table's id.
    pub table: String,
    /// Its file.
    pub file: String,
    /// The row, for messages.
    pub row: String,
    /// The fault and the remedy.
    pub problem: Box<Note>,
}

impl From<&TableError> for Note {
    fn from(error: &TableError) -> Self {
        let TableError { table, file, row, problem } = error;
        let file = if file.is_empty() { String::new() } else { format!("{file}: ") };
        note!("table-does-not-hold", file = file, table = table, row = row, problem = **problem)
    }
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Note::from(self).fmt(f)
    }
}

impl std::error::Error for TableError {}

impl<'t> RowRef<'t> {
    /// The row itself.
    pub fn row(self) -> &'t Row {
        &self.table.rows[self.index]
    }

    /// Its number, from 1, as shown to people.
    pub fn number(self) -> usize {
        self.index + 1
    }

    /// The value of a column, if the row has one.
    pub fn value(self, column: &str) -> Option<&'t Value> {
        let index = self.table.column_index(column)?;
        match &self.row().cells[index] {
            Cell::Value(value) => Some(value),
            _ => None,
        }
    }

    /// The place of the row in the source.
    pub fn place(self) -> &'t str {
        self.row().place.as_deref().unwrap_or(&self.table.place)
    }

    pub(crate) fn problem(self, problem: Note) -> TableError {
        TableError {
            table: self.table.id.clone(),
            file: format!("{}:{}", self.table.file, self.row().line),
            row: format!(", row {}", self.number()),
            problem: Box::new(problem),
        }
    }

    /// A text.
    ///
    /// # Errors
    /// The row has no text there.
    pub(crate) fn text(self, column: &str) -> Result<&'t str, TableError> {
        let text = self.value(column).and_then(Value::as_text);
        text.ok_or_else(|| self.problem(note!("table-column-must-hold-text-here", column = column)))
    }
}
