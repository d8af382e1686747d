//! The tables and what is required of them: `table`, `lookup`, `lint`, and readings by somebody else.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod commands;
mod fields;
mod index;
mod readings;
mod remarks;
