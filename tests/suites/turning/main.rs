//! Turned parts: contours, zones, tools, ways, operations, passes and their programs.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod agree;
mod allowances;
mod bores;
mod drawn;
mod elements;
mod equidistant;
mod everyday;
mod extremes;
mod fields;
mod gripped;
mod hand_written;
mod limit;
mod operation;
mod operation_rules;
mod pages;
mod passes;
mod programs;
mod read_back;
mod read_pace;
mod schemes;
mod setting;
mod shop;

mod tailstock;
mod tapping;
mod tapping_laws;
mod threads;
mod tools;
mod transitions;
mod volumes;
mod ways;
mod workpiece;
mod zones;
