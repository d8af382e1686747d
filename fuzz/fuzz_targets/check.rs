//! Bytes as a program of the control 2С42-65: whatever they are, the check ends and tells places inside the text.

#![no_main]

#[path = "../one_check.rs"]
mod one_check;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| one_check::one_check(bytes));
