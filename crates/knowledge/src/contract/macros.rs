//! The macros that declare row types and vocabularies.

/// Makes enums with their words in tables: the only place where a word is written.
///
/// ```text
/// vocabulary! {
///     /// How a face lies before the cut.
///     pub enum Entry {
///         /// Machined before.
///         Machined = "machined",
///         /// As cast or rolled.
///         Rough = "rough",
///     }
/// }
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

/// Makes row types: a struct with the columns that code reads, its contract, and the reader of a row.
///
/// ```text
/// rows! {
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
/// ```
///
/// `field as "column": Type` names a column that is no Rust identifier. `complete COLUMN` after the tables requires
/// that each word of that column's type has a row and that each row has such a word. `shown { … }` names the columns
/// that are only for people.
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
            /// The row itself, for citing it.
            pub row: $crate::RowRef<'t>,
            $(pub $field: $type,)*
        }

        impl<'t> $crate::contract::TableRow<'t> for $name<'t> {
            const CONTRACT: &'static $crate::contract::Contract = &$crate::contract::Contract {
                row: stringify!($name),
                which: $crate::contract::Which::$which $(($table))?,
                inputs: &[$($($crate::contract::RequiredColumn {
                    name: $crate::column!($input $($in_column)?),
                    shape: <$in_type as $crate::contract::AsInput>::SHAPE,
                },)*)?],
                fields: &[$($crate::contract::RequiredColumn {
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

        impl $(<$life>)? $question $(<$life>)? {
            $(
                /// The column of that input, for querying its permitted values.
                pub fn $input(table: &$crate::Table) -> Option<&$crate::Column> {
                    let name = $crate::column!($input $($column)?);
                    table.columns.iter().find(|column| column.name == name)
                }
            )*
        }

        impl $(<$life>)? $crate::contract::Question for $question $(<$life>)? {
            type Row<'k> = $name<'k>;
            const TABLE: &'static str = <$name<'static> as $crate::contract::TableRow<'static>>::CONTRACT.which.id();

            fn put<T>(&self, ask: impl FnOnce(&[(&'static str, Option<$crate::Input<'_>>)]) -> T) -> T {
                ask(&[$(($crate::column!($input $($column)?), $crate::contract::AsInput::as_input(&self.$input)),)*])
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
