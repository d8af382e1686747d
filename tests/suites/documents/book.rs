//! docs/ as a book: its pages show what the program prints today, their examples are read, their links lead somewhere, and
//! the pages in Ukrainian say what their English twins say.
//!
//! `UPDATE_DOCS=1 cargo test --test documents book::` writes again what the pages show. Read what changed.

mod examples;
mod links;
mod page;
mod shell;
mod shown;
mod twins;
