//! Audits: plans of other authors compared with the tables.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod against;
mod alone;
mod by_hand;
mod edited;
mod faults;
mod folder;
mod honest;
mod marks;
mod measured;
mod mistakes;
mod mutations;
mod program;
mod reader;
mod routes;
mod tables;
mod words;
