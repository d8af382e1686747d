//! Programs of machining centres: their interpreters, writers, proof and drawings.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod browser;
mod cases;
mod clamps;
mod directed;
mod drawings;
mod fuzz;
mod iso;
mod office;
mod proof;
mod report;
mod slots;
mod through_nothing;
mod times;
mod unfinished;
mod written;
