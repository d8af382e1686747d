//! A part of the fuzzing of `fuzz/` that every `cargo test` runs: all programs of the corpus, of `tests/programs` and of
//! `examples`, and some thousands of seeded mutations of them. What is held of each stands in `fuzz/one_check.rs`.
//!
//! `TECHNOLOG_CASES=250 cargo test --release --test programs fuzz::` runs a million mutations. A mutation that fails is printed,
//! and belongs into `fuzz/corpus/check` under a name that tells what was wrong.

#[path = "../../../fuzz/one_check.rs"]
mod one_check;

use std::panic::catch_unwind;

use one_check::one_check;
use technolog_laws::{count, seed_of};
use technolog_testing::fuzzing::{self, Random, files};

/// Mutations of an ordinary run: counted, so that the same are tried on every machine.
const ROUNDS: usize = 4_000;

/// Programs as bytes, in the order of their paths.
fn programs() -> Vec<Vec<u8>> {
    let wanted = |path: &std::path::Path| path.extension().is_some_and(|extension| extension == "nc");
    files(&["fuzz/corpus/check", "tests/programs", "examples"], wanted)
}

/// What gets into programs, by hand and by fault.
const LITTER: &[&str] = &[
    "0",
    "-",
    "+",
    ".",
    "/",
    "%",
    ":01 ",
    "\n",
    "\r",
    "\0",
    "\u{feff}",
    "Х",
    "У",
    "🙂",
    " L65535 ",
    " L0 ",
    "9999.999",
    "-9999.999",
    "0.001",
    "65535",
    "9223372036854775807",
    "\n:02\n",
    " P02 ",
    " M99 ",
    " M02 ",
    " G41 D1 ",
    " G42 D2 ",
    " G40 ",
    " G91 ",
    " G90 ",
    " G81 U1 Z-5 ",
    " G83 U1 Z-5 V1 W1 ",
    " G86 V0.001 W9 ",
    " G80 ",
    " G02 I5 ",
    " G03 J-5 ",
    " G10 K-1 ",
    " G18 ",
    " G19 ",
    " G28 X0 ",
    " G30 Z0 ",
    " G92 X0 Y0 Z0 ",
    " G45 D3 ",
    " G48 ",
    " G43 H1 ",
    " G44 H2 ",
    " G04 E5 ",
    " M3 S500 F100 ",
    " M06 T1 ",
    "\nN5 X10 Y10\n",
];

/// A mutated program, some with a line that says how the operator's panel is set.
fn mutated(programs: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut bytes = fuzzing::mutated(programs, LITTER, random);
    if random.below(2) == 0 {
        let panel: Vec<u8> = (0..20).map(|_| b'0' + random.below(75) as u8).collect();
        bytes.splice(0..0, [b"%", panel.as_slice(), b"\n"].concat());
    }
    bytes
}

#[test]
fn every_program_at_hand_is_checked_without_panic() {
    let programs = programs();
    assert!(programs.len() > 100, "only {} programs", programs.len());
    programs.iter().for_each(|program| one_check(program));
}

#[test]
fn no_mutation_of_a_program_makes_the_check_panic() {
    let programs = programs();
    let mut random = Random::new(seed_of("mutations of programs"));
    for round in 0..count(ROUNDS) {
        let bytes = mutated(&programs, &mut random);
        let outcome = catch_unwind(|| one_check(&bytes));
        assert!(outcome.is_ok(), "round {round}: {:?}", String::from_utf8_lossy(&bytes));
    }
}
