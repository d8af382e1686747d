//! The contract between a table and the code that reads it.
//!
//! Code never names a column by a string: each table it reads has one row type, a struct made by [`crate::rows!`]. From
//! the struct come the reading of a row, the list of columns with their types and units, and the check that
//! holds a table against that list when it is loaded. A column that is missing, of another type or unit, that may be
//! left out where the code needs it, or that nobody reads, is an error before anything is planned.

mod cells;
mod macros;
#[cfg(test)]
mod tests;

use crate::query::Input;
use crate::table::{Cell, RowRef, Table, TableError};
use crate::units::Unit;
use crate::value::Value;

/// What the cells of a column hold, for the code that reads them.
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
    /// Whatever the table says: shown, and no more.
    Anything,
}

/// What the code asks of the cells of a column.
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
    pub const fn one(holds: Holds) -> Self {
        Self { holds, list: false, optional: false }
    }
}

/// A word of a vocabulary that the code knows: an enum whose words stand in tables.
pub trait Word: Copy + Eq + 'static {
    /// Every word, in the order of the variants.
    const WORDS: &'static [&'static str];

    /// The word as tables write it.
    fn word(self) -> &'static str;

    /// The variant of that word.
    fn from_word(word: &str) -> Option<Self>;
}

/// A name that stands in a column of names, some of which code reads.
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
    /// What a named row is for.
    pub enum Use {
        /// Code reads it.
        Planning = "planning",
        /// It is for people; nothing calculates with it.
        Documentation = "documentation",
    }
}

/// What a cell is read as.
pub trait FromCell<'t>: Sized {
    /// What is required of the column.
    const SHAPE: CellShape;

    /// The value; none if the cell is not of that shape.
    fn from_cell(cell: &'t Cell) -> Option<Self>;
}

/// What one value of a cell, or one item of its list, is read as.
pub trait FromValue<'t>: Sized {
    /// What the value is.
    const HOLDS: Holds;

    /// The value; none if it is something else.
    fn from_value(value: &'t Value) -> Option<Self>;
}

/// A value that a question gives for an input column.
pub trait AsInput {
    /// What the column must take.
    const SHAPE: CellShape;

    /// The input; none if the table's default is to stand.
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

/// Which tables a row type is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// One table; it must be there.
    One(&'static str),
    /// Tables of one shape; all of them must be there. A column that a row may leave out may be left out of a table.
    Each(&'static [&'static str]),
    /// Every table that obeys the law `record` of that schema; at least one must be there. Columns as of `Each`.
    Record(&'static str),
    /// Every table of cutters, which has a `tool` head. Columns as of `Each`.
    Tools,
}

impl Which {
    /// The id of the one table; empty of several.
    pub const fn id(self) -> &'static str {
        match self {
            Self::One(id) => id,
            Self::Each(_) | Self::Record(_) | Self::Tools => "",
        }
    }
}

/// What code asks of a table: made by [`crate::rows!`].
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
    /// Columns for people: shown with the table and its answers, steering nothing.
    pub shown: &'static [&'static str],
    /// A column whose words must each have a row, and whose rows must each be such a word. Where it holds names
    /// ([`Named`]), the column of [`Use`] says which rows are no such word.
    pub complete: Option<&'static str>,
}

/// A row of a table as a value.
pub trait TableRow<'t>: Sized {
    /// What it asks of its table.
    const CONTRACT: &'static Contract;

    /// Reads a row.
    ///
    /// # Errors
    /// A cell is not what the contract says; never of a table that was checked.
    fn read(row: RowRef<'t>) -> Result<Self, TableError>;
}

/// A question to a decision table: its inputs as a struct.
pub trait Question {
    /// The row of the table that answers.
    type Row<'k>: TableRow<'k>;
    /// The table.
    const TABLE: &'static str;

    /// Asks with the inputs by name; `None` takes the table's default. A plan does it thousands of times, so there is
    /// no list on the heap.
    fn put<T>(&self, ask: impl FnOnce(&[(&'static str, Option<Input<'_>>)]) -> T) -> T;
}

/// Reads the cells of one row, field by field in the order of the contract.
#[derive(Debug)]
pub struct Reader<'t> {
    row: RowRef<'t>,
    cells: &'t [Cell],
    contract: &'static Contract,
    /// Where the fields stand among the columns, if the table was first read by this contract.
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
        // A table of a family may lack a column that its rows may leave out.
        let column = match self.layout {
            Some(layout) => layout.get(position).copied().flatten(),
            None => self.contract.fields.get(position).and_then(|asked| self.row.table.column_index(asked.name)),
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
    /// Where the fields of a contract stand among its columns; none where another contract was asked first.
    fn layout_of(&self, contract: &'static Contract) -> Option<&[Option<usize>]> {
        let find = |asked: &RequiredColumn| self.column_index(asked.name);
        let (row, positions) =
            self.layout.get_or_init(|| (contract.row, contract.fields.iter().map(find).collect::<Vec<_>>()));
        (*row == contract.row).then_some(positions)
    }
}
