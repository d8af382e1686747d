//! The knowledge base: exact units, typed tables with a source on every row, queries with reasons, and a lint that
//! checks the tables.
//!
//! It is a separate crate because the build script of `technolog` uses it too: the shipped tables are read, checked
//! and compiled while the program is built, so that start-up needs no parsing.
//!
//! Architecture invariant: this crate does no I/O except reading a given folder ([`Knowledge::read_folder`]), and it
//! makes no decisions: decisions are rows.

pub mod alike;
mod by_id;
pub mod cell;
pub mod column;
pub mod contract;
pub mod diagnostic;
pub mod error;
mod examples;
mod few;
pub mod form;
mod hint;
pub mod input;
mod key_words;
pub mod knowledge;
pub mod lint;
pub mod load;
pub mod query;
pub mod set;
pub mod table;
pub mod units;
pub mod value;
pub mod vocabulary;
pub mod yaml;

pub use column::{Column, ColumnRole, ColumnType};
pub use contract::{Question, TableRow, Word};
pub use diagnostic::{Diagnostic, Place, Severity};
pub use error::KnowledgeError;
pub use knowledge::{Knowledge, SourceFile};
pub use query::{Answer, Input, QueryError, TypedAnswer};
pub use table::{HitPolicy, Row, RowRef, Source, Table, TableError, TableKind};
pub use value::Value;
