//! docs/ as a book: its pages show what the program prints today, their examples can be read, their links work, and
//! the pages in Ukrainian agree with the English ones.
//!
//! `UPDATE_DOCS=1 cargo test --test documents book::` rewrites what the pages show. Read the changes.

mod examples;
mod links;
mod page;
mod shell;
mod shown;
mod twins;
