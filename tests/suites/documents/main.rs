//! What docs/ and README say, held against the program.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod architecture;
mod provenance;
mod statements;
mod testing;
mod worked_example;
