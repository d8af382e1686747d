//! The proof of turned parts: cases worked by hand, a law, and the texts of findings.

#![allow(clippy::unwrap_used, clippy::panic, reason = "clippy allows it in tests, but not in the functions they share")]

mod clean;
mod faults;
mod laws;
mod made;
mod speed;
mod taps;
mod tools;
mod words;
