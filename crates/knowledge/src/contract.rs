//! The contract between a table and the code that reads it.
//!
//! Code never names a column by a string: each table it reads has one row type, a struct made by [`crate::rows!`]. From
//! the struct come the reading of a row, the list of columns with their types and units, and the check that
//! holds a table against that list when it is loaded. A column that is missing, of another type or unit, that may be
//! left out where the code needs it, or that nobody reads, is an error before anything is planned.

use crate::query::Input;
use crate::table::{Cell, RowRef, Table, TableError};
use crate::units::{
    Brinell, Decimal, Degrees, ItGrade, Kilograms, Kilowatts, Megapascals, MetresPerMinute, Micrometres, Microns,
    MillimetresPerMinute, MillimetresPerRev, MillimetresPerSecondSquared, MillimetresPerTooth, Minutes, NewtonMetres,
    Newtons, Percent, RevsPerMinute, Roughness, Seconds, Unit,
};
use crate::value::Value;

/// What the cells of a column hold, for the code that reads them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// Any text, or any word of an enum.
    Text,
    /// One of these words and no other.
    Word(&'static [&'static str]),
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
pub struct Shape {
    /// What a cell, or each item of its list, holds.
    pub holds: Holds,
    /// Whether a cell is a list.
    pub list: bool,
    /// Whether a row may leave it out.
    pub optional: bool,
}

impl Shape {
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

/// What a cell is read as.
pub trait FromCell<'t>: Sized {
    /// What is asked of the column.
    const SHAPE: Shape;

    /// The value; nothing where the cell is not of that shape.
    fn from_cell(cell: &'t Cell) -> Option<Self>;
}

/// What one value of a cell, or one item of its list, is read as.
pub trait FromValue<'t>: Sized {
    /// What the value is.
    const HOLDS: Holds;

    /// The value; nothing where it is something else.
    fn from_value(value: &'t Value) -> Option<Self>;
}

/// A value that a question gives for an input column.
pub trait AsInput {
    /// What the column must take.
    const SHAPE: Shape;

    /// The input; nothing where the table's default is to stand.
    fn as_input(&self) -> Option<Input<'_>>;
}

impl<'t, T: FromValue<'t>> FromCell<'t> for T {
    const SHAPE: Shape = Shape::one(T::HOLDS);

    fn from_cell(cell: &'t Cell) -> Option<Self> {
        match cell {
            Cell::Value(value) => T::from_value(value),
            _ => None,
        }
    }
}

impl<'t, T: FromValue<'t>> FromCell<'t> for Vec<T> {
    const SHAPE: Shape = Shape { list: true, ..Shape::one(T::HOLDS) };

    fn from_cell(cell: &'t Cell) -> Option<Self> {
        match cell {
            Cell::Value(Value::List(items)) => items.iter().map(T::from_value).collect(),
            _ => None,
        }
    }
}

impl<'t, T: FromCell<'t>> FromCell<'t> for Option<T> {
    const SHAPE: Shape = Shape { optional: true, ..T::SHAPE };

    fn from_cell(cell: &'t Cell) -> Option<Self> {
        match cell {
            Cell::Empty => Some(None),
            cell => T::from_cell(cell).map(Some),
        }
    }
}

impl<T: AsInput> AsInput for Option<T> {
    const SHAPE: Shape = Shape { optional: true, ..T::SHAPE };

    fn as_input(&self) -> Option<Input<'_>> {
        self.as_ref().and_then(T::as_input)
    }
}

impl<W: Word> FromValue<'_> for W {
    const HOLDS: Holds = Holds::Word(W::WORDS);

    fn from_value(value: &Value) -> Option<Self> {
        value.as_text().and_then(W::from_word)
    }
}

impl<W: Word> AsInput for W {
    const SHAPE: Shape = Shape::one(Holds::Word(W::WORDS));

    fn as_input(&self) -> Option<Input<'_>> {
        Some(Input::Text(self.word()))
    }
}

impl<'t> FromValue<'t> for &'t Value {
    const HOLDS: Holds = Holds::Anything;

    fn from_value(value: &'t Value) -> Option<Self> {
        Some(value)
    }
}

impl<'t> FromValue<'t> for &'t str {
    const HOLDS: Holds = Holds::Text;

    fn from_value(value: &'t Value) -> Option<Self> {
        value.as_text()
    }
}

impl AsInput for &str {
    const SHAPE: Shape = Shape::one(Holds::Text);

    fn as_input(&self) -> Option<Input<'_>> {
        Some(Input::Text(self))
    }
}

/// Both directions for types that a value of a table holds as they are.
macro_rules! plain {
    ($($type:ty: $holds:expr, $variant:ident;)*) => {$(
        impl FromValue<'_> for $type {
            const HOLDS: Holds = $holds;

            fn from_value(value: &Value) -> Option<Self> {
                match value {
                    Value::$variant(value) => Some(*value),
                    _ => None,
                }
            }
        }

        impl AsInput for $type {
            const SHAPE: Shape = Shape::one($holds);

            fn as_input(&self) -> Option<Input<'_>> {
                Some(Input::$variant(*self))
            }
        }
    )*};
}

plain! {
    bool: Holds::Bool, Bool;
    i64: Holds::Int, Int;
    Micrometres: Holds::Length, Length;
    ItGrade: Holds::Grade, Grade;
    Roughness: Holds::Roughness, Roughness;
}

/// Both directions for decimals: the type says the unit.
macro_rules! decimals {
    ($($type:ty: $unit:ident, $read:expr, $write:expr;)*) => {$(
        impl FromValue<'_> for $type {
            const HOLDS: Holds = Holds::Number(Unit::$unit);

            fn from_value(value: &Value) -> Option<Self> {
                match value {
                    Value::Number(number, Unit::$unit) => Some($read(*number)),
                    _ => None,
                }
            }
        }

        impl AsInput for $type {
            const SHAPE: Shape = Shape::one(Holds::Number(Unit::$unit));

            fn as_input(&self) -> Option<Input<'_>> {
                Some(Input::Number($write(*self), Unit::$unit))
            }
        }
    )*};
    // Results of formulas are floating-point; a question rounds them to the millionth, as tables have it.
    (floating $($type:ident: $unit:ident;)*) => {
        decimals! { $($type: $unit, |number: Decimal| $type(number.to_f64()), |value: $type| Decimal::from_f64_rounded(value.0);)* }
    };
}

decimals! {
    Decimal: None, |number| number, |number| number;
    f64: None, |number: Decimal| number.to_f64(), Decimal::from_f64_rounded;
    Brinell: Brinell, Brinell, |value: Brinell| value.0;
    Megapascals: Megapascal, Megapascals, |value: Megapascals| value.0;
}

decimals! {
    floating
    Newtons: Newton;
    NewtonMetres: NewtonMetre;
    Kilowatts: Kilowatt;
    MetresPerMinute: MetrePerMinute;
    MillimetresPerRev: MillimetrePerRev;
    MillimetresPerTooth: MillimetrePerTooth;
    MillimetresPerMinute: MillimetrePerMinute;
    RevsPerMinute: RevPerMinute;
    Minutes: Minute;
    Seconds: Second;
    Degrees: Degree;
    Kilograms: Kilogram;
    Percent: Percent;
    Microns: Micrometre;
    MillimetresPerSecondSquared: MillimetrePerSecondSquared;
}

/// One column that a row type asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asked {
    /// The name of the column, and of the field.
    pub name: &'static str,
    /// What its cells must be.
    pub shape: Shape,
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
    pub inputs: &'static [Asked],
    /// The columns that are read.
    pub fields: &'static [Asked],
    /// Columns for people: shown with the table and its answers, steering nothing.
    pub shown: &'static [&'static str],
    /// A column whose words must each have a row, and whose rows must each be such a word.
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

    /// The inputs by name; those left to the table's default are not among them.
    fn inputs(&self) -> Vec<(&'static str, Input<'_>)>;
}

/// Reads the cells of one row, field by field in the order of the contract.
#[derive(Debug)]
pub struct Reader<'t> {
    row: RowRef<'t>,
    contract: &'static Contract,
    next: usize,
}

impl<'t> Reader<'t> {
    /// At the first field of a row.
    pub fn new(row: RowRef<'t>, contract: &'static Contract) -> Self {
        Self { row, contract, next: 0 }
    }

    /// The next field.
    ///
    /// # Errors
    /// Its cell is not of the field's type.
    pub fn cell<T: FromCell<'t>>(&mut self) -> Result<T, TableError> {
        let position = self.next;
        self.next += 1;
        // A table of a family may lack a column that its rows may leave out.
        let cell = match self.row.table.position(self.contract, position) {
            Some(column) => &self.row.row().cells[column],
            None => &Cell::Empty,
        };
        T::from_cell(cell).ok_or_else(|| {
            let name = self.contract.fields.get(position).map_or("", |field| field.name);
            self.row.problem(format!("the column `{name}` does not hold what {} reads", self.contract.row))
        })
    }
}

impl Table {
    /// Where a field of its contract stands among its columns.
    fn position(&self, contract: &'static Contract, field: usize) -> Option<usize> {
        let find = |asked: &Asked| self.column_index(asked.name);
        let (row, positions) =
            self.layout.get_or_init(|| (contract.row, contract.fields.iter().map(find).collect::<Vec<_>>()));
        match *row == contract.row {
            true => positions.get(field).copied().flatten(),
            false => contract.fields.get(field).and_then(find),
        }
    }
}

/// Makes enums whose words stand in tables: the one place where a word is written.
///
/// ```
/// technolog_knowledge::vocabulary! {
///     /// How a face lies before the cut.
///     pub enum Entry {
///         /// Machined before.
///         Machined = "machined",
///         /// As cast or rolled.
///         Rough = "rough",
///     }
/// }
/// use technolog_knowledge::contract::Word;
/// assert_eq!(Entry::from_word("rough"), Some(Entry::Rough));
/// assert_eq!(Entry::Machined.word(), "machined");
/// ```
#[macro_export]
macro_rules! vocabulary {
    ($($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$doc:meta])* $variant:ident = $word:literal),* $(,)? })*) => {$(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        $vis enum $name { $($(#[$doc])* $variant),* }

        impl $name {
            /// Every word with its variant.
            pub const NAMES: &'static [(&'static str, Self)] = &[$(($word, Self::$variant)),*];

            /// The word, in tables, plans and files.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $word),* }
            }
        }

        impl $crate::contract::Word for $name {
            const WORDS: &'static [&'static str] = &[$($word),*];

            fn word(self) -> &'static str {
                self.name()
            }

            fn from_word(word: &str) -> Option<Self> {
                match word { $($word => Some(Self::$variant),)* _ => None }
            }
        }
    )*};
}

/// Makes row types: a struct whose fields are the columns that code reads, with its contract and its reading.
///
/// ```
/// use technolog_knowledge::units::Micrometres;
///
/// technolog_knowledge::rows! {
///     /// Approach and overrun of a tool.
///     pub struct Approach of One("approach") asked by ApproachFor { rough: bool, through: bool } {
///         approach: Micrometres,
///         overrun: Micrometres,
///     }
///     /// A screw of a clamp.
///     pub struct ClampScrew of One("clamp-screws") {
///         thread: &'t str,
///         safe_distance: Option<Micrometres>,
///     } shown { force_80, force_100 }
/// }
/// use technolog_knowledge::contract::TableRow;
/// assert_eq!(Approach::CONTRACT.inputs.len(), 2);
/// assert!(ClampScrew::CONTRACT.fields[1].shape.optional);
/// ```
///
/// `field as "column": Type` names a column that is no identifier of Rust. `complete COLUMN` after the tables asks that
/// each word of that column's type has a row and each row such a word. `shown { … }` names the columns that are for
/// people only.
#[macro_export]
macro_rules! rows {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident of $which:ident $(($table:expr))? $(complete $complete:ident)?
        $(asked by $question:ident $(<$life:lifetime>)? { $($input:ident $(as $in_column:literal)? : $in_type:ty),* $(,)? })?
        { $($field:ident $(as $column:literal)? : $type:ty),* $(,)? }
        $(shown { $($shown:tt),* $(,)? })?
    )*) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug)]
        pub struct $name<'t> {
            /// The row itself, for those who cite it.
            pub row: $crate::RowRef<'t>,
            $(pub $field: $type,)*
        }

        impl<'t> $crate::contract::TableRow<'t> for $name<'t> {
            const CONTRACT: &'static $crate::contract::Contract = &$crate::contract::Contract {
                row: stringify!($name),
                which: $crate::contract::Which::$which $(($table))?,
                inputs: &[$($($crate::contract::Asked {
                    name: $crate::column!($input $($in_column)?),
                    shape: <$in_type as $crate::contract::AsInput>::SHAPE,
                },)*)?],
                fields: &[$($crate::contract::Asked {
                    name: $crate::column!($field $($column)?),
                    shape: <$type as $crate::contract::FromCell>::SHAPE,
                },)*],
                shown: &[$($($crate::shown!($shown),)*)?],
                complete: $crate::complete!($($complete)?),
            };

            #[allow(unused_mut, unused_variables, reason = "a table may be asked only whether it has a row")]
            fn read(row: $crate::RowRef<'t>) -> Result<Self, $crate::TableError> {
                let mut cells = $crate::contract::Reader::new(row, Self::CONTRACT);
                Ok(Self { row, $($field: cells.cell()?,)* })
            }
        }

        $($crate::question! { $name $question $(<$life>)? { $($input $(as $in_column)? : $in_type),* } })?
    )*
        /// The contract of every row type of this room.
        pub const CONTRACTS: &[&$crate::contract::Contract] =
            &[$(<$name<'static> as $crate::contract::TableRow<'static>>::CONTRACT),*];
    };
}

/// The question of a decision table; a part of [`crate::rows!`].
#[doc(hidden)]
#[macro_export]
macro_rules! question {
    ($name:ident $question:ident $(<$life:lifetime>)? {
        $($input:ident $(as $column:literal)? : $type:ty),*
    }) => {
        /// A question to the table of
        #[doc = concat!("[`", stringify!($name), "`].")]
        #[derive(Clone, Copy, Debug)]
        pub struct $question $(<$life>)? { $(pub $input: $type,)* }

        impl $(<$life>)? $crate::contract::Question for $question $(<$life>)? {
            type Row<'k> = $name<'k>;
            const TABLE: &'static str = <$name<'static> as $crate::contract::TableRow<'static>>::CONTRACT.which.id();

            fn inputs(&self) -> Vec<(&'static str, $crate::Input<'_>)> {
                let given = [$(($crate::column!($input $($column)?), $crate::contract::AsInput::as_input(&self.$input)),)*];
                given.into_iter().filter_map(|(name, input)| input.map(|input| (name, input))).collect()
            }
        }
    };
}

/// The name of a column: the field's, or the one that is given; a part of [`crate::rows!`].
#[doc(hidden)]
#[macro_export]
macro_rules! column {
    ($field:ident) => {
        stringify!($field)
    };
    ($field:ident $column:literal) => {
        $column
    };
}

/// The name of a column that is only shown: an identifier, or a text where it is none; a part of [`crate::rows!`].
#[doc(hidden)]
#[macro_export]
macro_rules! shown {
    ($column:ident) => {
        stringify!($column)
    };
    ($column:literal) => {
        $column
    };
}

/// The column whose words must each have a row, if there is one; a part of [`crate::rows!`].
#[doc(hidden)]
#[macro_export]
macro_rules! complete {
    () => {
        None
    };
    ($column:ident) => {
        Some(stringify!($column))
    };
}
