//! The target `check` of `targets.rs`: bytes as a program of the control 2С42-65.

#![no_main]

#[path = "../targets.rs"]
mod targets;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| targets::run("check", bytes));
