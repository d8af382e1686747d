//! The contract between a table and the code that reads it.
//!
//! Code never names a column by a string: each table that it reads has one row type, a struct made by
//! [`crate::rows!`]. The struct gives the reader of a row, the list of columns with types and units, and the check of
//! a table against that list when it is loaded. A column that is missing, of another type or unit, optional where
//! code needs it, or read by nobody, is an error before anything is planned.

mod cells;
mod macros;
#[cfg(test)]
mod tests;

use crate::query::Input;
use crate::table::{Cell, RowRef, Table, TableError};
use crate::units::Unit;
use crate::value::Value;

/// The content of a column's cells, as code needs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// Any text, or any word of an enum.
    Text,
    /// One of these words and no other.
    Word(&'static [&'static str]),
    /// One of these words, or a name that is for people; see [`Named`].
    Name(&'static [&'static str]),
    /// Yes or no.
    Bool,
    /// A whole number.
    Int,
    /// A decimal in that unit.
    Number(Unit),
    /// A length; micrometres and millimetres are both read exactly.
    Length,
    /// A tolerance grade.
    Grade,
    /// A roughness limit.
    Roughness,
    /// Anything: only shown.
    Anything,
}

/// The requirements of code for the cells of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellShape {
    /// What a cell, or each item of its list, holds.
    pub holds: Holds,
    /// Whether a cell is a list.
    pub list: bool,
    /// Whether a row may leave it out.
    pub optional: bool,
}

impl CellShape {
    /// One value in every row.
    pub const fn single(holds: Holds) -> Self {
        Self { holds, list: false, optional: false }
    }
}

/// A word of a vocabulary that the code knows: an enum whose words stand in tables.
pub trait Word: Copy + Eq + 'static {
    /// Every word, in the order of the variants.
    const WORDS: &'static [&'static str];

    /// The word as written in tables.
    fn word(self) -> &'static str;

    /// The variant of that word.
    fn from_word(word: &str) -> Option<Self>;
}

/// A value in a column of names, some of which code reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Named<'t, W> {
    /// A name that code reads.
    Read(W),
    /// A name for people.
    Other(&'t str),
}

impl<W: Word> Named<'_, W> {
    /// Whether it is that word.
    pub fn is(self, word: W) -> bool {
        self == Self::Read(word)
    }
}

crate::vocabulary! {
    /// The purpose of a named row.
    pub enum Use {
        /// Code reads it.
        Planning = "planning",
        /// It is for people; no calculation uses it.
        Documentation = "documentation",
    }
}

/// A Rust type for a cell.
pub trait FromCell<'t>: Sized {
    /// The required shape of the column.
    const SHAPE: CellShape;

    /// The value; none if the cell has another shape.
    fn from_cell(cell: &'t Cell) -> Option<Self>;
}

/// A Rust type for one value of a cell, or one item of its list.
pub trait FromValue<'t>: Sized {
    /// What the value is.
    const HOLDS: Holds;

    /// The value; none if it is something else.
    fn from_value(value: &'t Value) -> Option<Self>;
}

/// A Rust type that a question gives for an input column.
pub trait AsInput {
    /// The shape that the column must accept.
    const SHAPE: CellShape;

    /// The input; none if the table's default applies.
    fn as_input(&self) -> Option<Input<'_>>;
}

/// One column that a row type requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RequiredColumn {
    /// The name of the column, and of the field.
    pub name: &'static str,
    /// What its cells must be.
    pub shape: CellShape,
}

/// The tables of a row type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// One table; it must be there.
    One(&'static str),
    /// Tables of one shape; all of them must exist. An optional column may be missing in a table.
    Each(&'static [&'static str]),
    /// Every table that obeys the law `record` of that schema; at least one must exist. Columns as for `Each`.
    Record(&'static str),
    /// Every table of cutters, which has a `tool` head. Columns as of `Each`.
    Tools,
}

impl Which {
    /// The id of the single table; empty for several.
    pub const fn id(self) -> &'static str {
        match self {
            Self::One(id) => id,
            Self::Each(_) | Self::Record(_) | Self::Tools => "",
        }
    }
}

/// The requirements of code for a table, made by [`crate::rows!`].
#[derive(Debug)]
pub struct Contract {
    /// The row type, for messages.
    pub row: &'static str,
    /// Its tables.
    pub which: Which,
    /// The inputs that a question gives.
    pub inputs: &'static [RequiredColumn],
    /// The columns that are read.
    pub fields: &'static [RequiredColumn],
    /// Columns for people: shown with the table and its answers, used by no decision.
    pub shown: &'static [&'static str],
    /// A column whose words must each have a row, and whose rows must each have such a word. Where it holds names
    /// ([`Named`]), the column of [`Use`] says which rows are exempt.
    pub complete: Option<&'static str>,
}

/// A row of a table as a value.
pub trait TableRow<'t>: Sized {
    /// The requirements for its table.
    const CONTRACT: &'static Contract;

    /// Reads a row.
    ///
    /// # Errors
    /// A cell breaks the contract; this does not happen in a checked table.
    fn read(row: RowRef<'t>) -> Result<Self, TableError>;
}

/// A question to a decision table: its inputs as a struct.
pub trait Question {
    /// The row of the table that answers.
    type Row<'k>: TableRow<'k>;
    /// The table.
    const TABLE: &'static str;

    /// Calls `ask` with the inputs by name; `None` means the table's default. A plan does this thousands of times, so
    /// there is no list on the heap.
    fn put<T>(&self, ask: impl FnOnce(&[(&'static str, Option<Input<'_>>)]) -> T) -> T;
}

/// Reads the cells of one row, field by field in the order of the contract.
#[derive(Debug)]
pub struct Reader<'t> {
    row: RowRef<'t>,
    cells: &'t [Cell],
    contract: &'static Contract,
    /// The positions of the fields among the columns, if the table was first read by this contract.
    layout: Option<&'t [Option<usize>]>,
    next: usize,
}

impl<'t> Reader<'t> {
    /// At the first field of a row.
    pub fn new(row: RowRef<'t>, contract: &'static Contract) -> Self {
        Self { row, cells: &row.row().cells, contract, layout: row.table.layout_of(contract), next: 0 }
    }

    /// The next field.
    ///
    /// # Errors
    /// Its cell is not of the field's type.
    #[inline]
    pub fn cell<T: FromCell<'t>>(&mut self) -> Result<T, TableError> {
        let position = self.next;
        self.next += 1;
        // A table of a family may lack an optional column.
        let column = match self.layout {
            Some(layout) => layout.get(position).copied().flatten(),
            None => self.contract.fields.get(position).and_then(|required| self.row.table.column_index(required.name)),
        };
        let cell = column.map_or(&Cell::Empty, |column| &self.cells[column]);
        T::from_cell(cell).ok_or_else(|| self.other_type(position))
    }

    #[cold]
    fn other_type(&self, position: usize) -> TableError {
        let name = self.contract.fields.get(position).map_or("", |field| field.name);
        self.row.problem(technolog_note::note!("table-column-other-type", name = name, row = self.contract.row))
    }
}

impl Table {
    /// The positions of a contract's fields among its columns; none if another contract was used first.
    fn layout_of(&self, contract: &'static Contract) -> Option<&[Option<usize>]> {
        let find = |required: &RequiredColumn| self.column_index(required.name);
        let (row, positions) =
            self.layout.get_or_init(|| (contract.row, contract.fields.iter().map(find).collect::<Vec<_>>()));
        (*row == contract.row).then_some(positions)
    }
}
