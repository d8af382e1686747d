//! A part of the fuzzing of `fuzz/` that every `cargo test` runs: all programs of the corpus, of `tests/programs` and of
//! `examples`, and some thousands of seeded mutations of them. What is held of each stands in `fuzz/one_check.rs`.
//!
//! `TECHNOLOG_CASES=250 cargo test --release --test programs fuzz::` runs a million mutations. A mutation that fails is printed,
//! and belongs into `fuzz/corpus/check` under a name that tells what was wrong.

#[path = "../../../fuzz/one_check.rs"]
mod one_check;

use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

use one_check::one_check;
use technolog_laws::{count, seed_of};

/// Mutations of an ordinary run: counted, so that the same are tried on every machine.
const ROUNDS: usize = 4_000;

/// Programs as bytes, in the order of their paths.
fn programs() -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    let mut folders = ["fuzz/corpus/check", "tests/programs", "examples"].map(|folder| root.join(folder)).to_vec();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "nc") {
                paths.push(path);
            }
        }
    }
    paths.sort();
    paths.into_iter().map(|path| fs::read(path).unwrap()).collect()
}

/// Xorshift: the same numbers everywhere.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as usize % limit.max(1)
    }

    /// A stretch of so many bytes, some bytes long or some lines.
    fn stretch(&mut self, length: usize) -> std::ops::Range<usize> {
        let begin = self.below(length + 1);
        let most = if self.below(3) == 0 { length } else { 12 };
        begin..(begin + self.below(most + 1)).min(length)
    }
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

fn mutated(programs: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut bytes = programs[random.below(programs.len())].clone();
    for _ in 0..=random.below(6) {
        let stretch = random.stretch(bytes.len());
        match random.below(6) {
            0 if !bytes.is_empty() => {
                let at = random.below(bytes.len());
                bytes[at] ^= 1 << random.below(8);
            }
            1 => drop(bytes.drain(stretch)),
            2 => {
                let again = bytes[stretch.clone()].to_vec();
                bytes.splice(stretch.end..stretch.end, again);
            }
            3 => {
                let other = &programs[random.below(programs.len())];
                bytes.splice(stretch, other[random.stretch(other.len())].to_vec());
            }
            4 => {
                let panel: Vec<u8> = (0..20).map(|_| b'0' + random.below(75) as u8).collect();
                bytes.splice(0..0, [b"%", panel.as_slice(), b"\n"].concat());
            }
            _ => drop(bytes.splice(stretch, LITTER[random.below(LITTER.len())].bytes())),
        }
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
    let mut random = Random(seed_of("mutations of programs") | 1);
    for round in 0..count(ROUNDS) {
        let bytes = mutated(&programs, &mut random);
        let held = catch_unwind(|| one_check(&bytes));
        assert!(held.is_ok(), "round {round}: {:?}", String::from_utf8_lossy(&bytes));
    }
}
