//! A part of the fuzzing of `fuzz/` that every `cargo test` runs: each target on its corpus, on seeded mutations of it, and
//! on texts that are too large to keep. What is held of each stands in `fuzz/targets.rs`.
//!
//! `TECHNOLOG_CASES=100 TECHNOLOG_SEED=7 cargo test --release --test reading fuzz::` runs more, others. A mutation that fails
//! is printed, and belongs into the target's folder of `fuzz/corpus/` under a name that tells what was wrong.

#[path = "../../../fuzz/targets.rs"]
mod targets;

use std::fs;
use std::panic::catch_unwind;

use technolog_laws::{count, seed_of};
use technolog_testing::fuzzing::{Random, files, mutated};
use technolog_testing::root;

/// Mutations of each target: of the slow ones few. `check` has more of its own in the suite `programs`.
const fn rounds(target: &str) -> usize {
    match target.as_bytes() {
        b"plan" | b"whole" => 25,
        b"check" => 0,
        _ => 200,
    }
}

/// What gets into files, by hand and by fault.
const LITTER: &[&str] = &[
    "",
    "-",
    "- ",
    "0",
    "-1",
    "1e9",
    "99999999999",
    "9223372036854775807",
    ".5",
    ",",
    ": ",
    "\n",
    "\r\n",
    "\t",
    "[",
    "]",
    "{",
    "}",
    "null",
    "~",
    "true",
    "\"",
    "\\e",
    "\u{1b}[2J",
    "\u{202e}",
    "\0",
    "\u{feff}",
    "&a ",
    "*a",
    "? ",
    "| \n",
    "---\n",
    "М",
    "Ø",
    "🙂",
    "T1",
    "Т1",
    "steps: []\n",
    "part: ",
    "tests: ",
    "holes: ",
    "a: 1\na: 1\n",
    "N1 X1 ",
    " G81 X1 Z-5 R1 ",
    "M98 P1 ",
    "(",
    "%\n",
    "O1\n",
];

fn corpus(target: &str) -> Vec<Vec<u8>> {
    files(&[&format!("fuzz/corpus/{target}")], |_| true)
}

#[test]
fn every_target_has_a_corpus_and_stands_in_the_manifest() {
    let manifest = fs::read_to_string(root().join("fuzz/Cargo.toml")).unwrap();
    let names: Vec<&str> = targets::TARGETS.iter().map(|(name, _)| *name).collect();
    for name in &names {
        assert!(corpus(name).len() > 1, "{name}");
        assert!(manifest.contains(&format!("path = \"fuzz_targets/{name}.rs\"")), "{name}");
        let own = fs::read_to_string(root().join(format!("fuzz/fuzz_targets/{name}.rs"))).unwrap();
        assert!(own.contains(&format!("targets::run(\"{name}\", bytes)")), "{name}");
    }
    for folder in fs::read_dir(root().join("fuzz/corpus")).unwrap() {
        let folder = folder.unwrap().file_name().into_string().unwrap();
        assert!(names.contains(&folder.as_str()), "{folder}");
    }
}

#[test]
fn every_target_holds_for_its_corpus() {
    for (target, _) in targets::TARGETS {
        for (number, bytes) in corpus(target).iter().enumerate() {
            let outcome = catch_unwind(|| targets::run(target, bytes));
            assert!(outcome.is_ok(), "file {number} of {target}: {:?}", String::from_utf8_lossy(bytes));
        }
    }
}

#[test]
fn every_target_holds_for_mutations_of_its_corpus() {
    for (target, _) in targets::TARGETS.into_iter().filter(|(target, _)| rounds(target) > 0) {
        let (files, mut random) = (corpus(target), Random::new(seed_of(target)));
        for round in 0..count(rounds(target)) {
            let bytes = mutated(&files, LITTER, &mut random);
            let outcome = catch_unwind(|| targets::run(target, &bytes));
            assert!(outcome.is_ok(), "round {round} of {target}: {:?}", String::from_utf8_lossy(&bytes));
        }
    }
}

#[test]
fn every_target_holds_for_texts_too_large_to_keep() {
    let deep = ["- ", "[", "{a: ", "? ", "(", "N1 "].map(|open| open.repeat(5_000));
    let many = ["a: 1\n", "- {}\n", "1,5;2,5\n", "N1 X1 Ж3 Q9\n", "{},"].map(|one| one.repeat(500));
    let different: String = (0..500).map(|number| format!("nobody-knows-this-key-{number}: {number}\n")).collect();
    let long =
        ["x".repeat(20_000), format!("a: [{}]", "1,5, ".repeat(3_000)), format!("part: \"{}\"", "Ж".repeat(5_000))];
    for (target, _) in targets::TARGETS {
        for text in deep.iter().chain(&many).chain(&long).chain([&different]) {
            targets::run(target, text.as_bytes());
        }
    }
}
