//! Documents: docs/ and README compared with the program.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod adding;
mod architecture;
mod book;
mod cases;
mod formats;
mod hand_plans;
mod provenance;
mod reasons;
mod statements;
mod testing;
mod words;
mod worked_example;
