//! Programs that are written: read back they make the part, whatever the control, and no word of them can be changed
//! unnoticed.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use proptest::prelude::*;
use technolog::job::Pause;
use technolog::note::Severity;
use technolog::part::Point;
use technolog::program::Language;
use technolog::program::proof::ProgramFinding;
use technolog_testing::holes::part_files;
use technolog_testing::mutants::{Score, score};
use technolog_testing::proof_bench::ProofBench;
use technolog_testing::{KNOWLEDGE, read};

static LANGUAGES: LazyLock<Vec<(&str, Language)>> = LazyLock::new(technolog_testing::languages);

fn language(name: &str) -> Language {
    Language::read(name, &KNOWLEDGE).unwrap()
}

/// What the tests of this file are done with: the examples, and parts that need every cycle there is.
const PARTS: [&str; 7] = [
    "examples/plate.yaml",
    "examples/variant-2.yaml",
    "examples/variant-4.yaml",
    "tests/parts/aluminium.yaml",
    "tests/parts/large-bore.yaml",
    "tests/parts/reamed-iron.yaml",
    "tests/written/every-cycle.yaml",
];

/// Whether the part fits on its machine.
fn fits(bench: &ProofBench) -> bool {
    bench.job.findings.iter().all(|finding| finding.severity > Severity::Wrong)
}

type Visits = Vec<(String, usize, u32, Point)>;

/// The visits of the program of a control, after it was found right.
fn visits(bench: &ProofBench, name: &str, language: &Language) -> Result<Visits, TestCaseError> {
    let text = bench.written(language);
    let (faults, proof, _) = bench.run(language, &text);
    // A part that does not fit on the machine has a finding of its job, and its program leaves the travels.
    let fits = fits(bench);
    let faults = faults.iter().filter(|fault| fits || fault.code != "beyond-travel-of");
    // Without the part nobody knows that the hole goes through, where a tap comes out farther than its drill.
    let faults: Vec<_> =
        faults.filter(|fault| !["tap-beyond-hole-maybe", "widens-beyond-hole-maybe"].contains(&fault.code)).collect();
    prop_assert!(faults.is_empty(), "{name}: {faults:?}\n{text}");
    // A control has peck clearances of its own; that is a note.
    // That a holder needs a lower strap than the catalog's is a doubt about what the plan proposes, not about its motions.
    let proposed = bench.job.setups.iter().any(|setup| setup.standing.iter().any(|one| one.proposed));
    let of_strap = |finding: &&ProgramFinding| {
        let of_holder = ["holder-unknown", "holder-through-obstacle"].contains(&finding.code.name());
        proposed && of_holder && finding.severity == Severity::Doubtful
    };
    let findings: Vec<_> = proof
        .findings
        .iter()
        .filter(|finding| finding.severity < Severity::Note)
        .filter(|finding| !of_strap(finding))
        .collect();
    prop_assert!(!fits || findings.is_empty(), "{name}: {findings:?}\n{text}");
    Ok(proof.visits.iter().map(|visit| (visit.hole.clone(), visit.transition, visit.pass, visit.at)).collect())
}

/// The programs of a part, for every control, make the stops of its job, in its order.
fn holds(bench: &ProofBench) -> Result<(), TestCaseError> {
    let planned: Visits =
        bench.job.stops().map(|(.., stop)| (stop.hole.clone(), stop.transition, stop.pass, stop.at)).collect();
    if !fits(bench) {
        return Ok(());
    }
    for (name, language) in &*LANGUAGES {
        // Of a control that does not tap all but the taps.
        let left = bench.job_for(language);
        let made = |visit: &(String, usize, u32, Point)| {
            left.stops().any(|(.., stop)| (&stop.hole, stop.transition) == (&visit.0, visit.1))
        };
        let planned: Visits = planned.iter().filter(|visit| made(visit)).cloned().collect();
        let visited = visits(bench, name, language)?;
        prop_assert_eq!(&visited, &planned, "{}", name);
    }
    Ok(())
}

#[test]
fn the_programs_of_a_part_make_the_same_stops() {
    for part in PARTS {
        let bench = ProofBench::new(part);
        assert!(!bench.job.setups.is_empty() && fits(&bench), "{part}: {:?}", bench.job.findings);
        holds(&bench).unwrap_or_else(|error| panic!("{part}: {error}"));
    }
}

/// The examples, the parts of tests and everyday parts: written, read back and proven for every control.
#[test]
fn every_part_of_the_repository_goes_through_every_control() {
    let mut made = 0;
    for folder in ["examples", "tests/parts", "tests/everyday"] {
        let files = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
        let mut files: Vec<_> = files.map(|entry| entry.unwrap().path()).collect();
        files.sort();
        for file in files.iter().filter(|file| file.extension().is_some_and(|end| end == "yaml")) {
            let text = fs::read_to_string(file).unwrap();
            let Ok(part) = technolog::part::read_part("part.yaml", &text, &KNOWLEDGE) else { continue };
            holds(&ProofBench::of(&part)).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            made += 1;
        }
    }
    assert!(made > 7, "only {made} parts");
}

/// Where one place holds several tools of one bore, the proof tells them apart.
#[test]
fn programs_for_a_small_magazine_make_their_stops() {
    for places in 1..=3 {
        let bench = ProofBench::with_magazine("tests/written/every-cycle.yaml", places);
        let loads = |pause: &Pause| matches!(pause, Pause::LoadTool { .. });
        let works = || bench.job.setups.iter().flat_map(|setup| &setup.works);
        assert!(works().flat_map(|work| &work.pauses).filter(|pause| loads(pause)).count() > 10);
        holds(&bench).unwrap_or_else(|error| panic!("{places} places: {error}"));
    }
}

/// Whatever its number, and with no subprograms at all, a program does the same.
#[test]
fn numbers_and_subprograms_change_nothing_that_is_made() {
    for part in PARTS {
        let bench = ProofBench::new(part);
        for (name, language) in &*LANGUAGES {
            let (_, proof, usual) = bench.run(language, &bench.written(language));
            let last = if *name == "2c42-65" { 99 } else { 9999 };
            for (number, subprograms) in [(Some(7), true), (Some(last), true), (Some(7), false)] {
                let text = bench.written_as(language, number, subprograms);
                let (faults, made, run) = bench.run(language, &text);
                assert!(!faults.iter().any(|fault| fault.is_grave()), "{part} {name} {number:?}: {faults:?}");
                assert_eq!((made.visits.len(), made.has_errors()), (proof.visits.len(), false), "{part} {name}");
                assert!(run.does_as(&usual), "{part} {name} {number:?} {subprograms}");
                let call = match *name {
                    "2c42-65" => " P0",
                    "linuxcnc" => " call",
                    _ => "M98",
                };
                assert_eq!(subprograms && *name != "grbl", text.contains(call) || number == Some(99), "{text}");
                let head = text.contains(":07\n") || text.contains("O0007") || text.contains("O00007");
                assert_eq!(head, number == Some(7) && !["linuxcnc", "mach3", "grbl"].contains(name), "{name}");
            }
        }
    }
}

/// As the owner of a Fanuc runs it: one M function in a block, G49 on the way up, taps in step with the spindle.
#[test]
fn a_fanuc_takes_its_program_as_it_is_written() {
    let part = "part: P\nmaterial: steel-45\nblank: {kind: plate, length: 240, width: 160, thickness: 30}\n\
                machine: ir500pmf4\nfixture: {height: 60}\nholes:\n  \
                - {name: T, thread: M10-6H, depth: 18, centre_tolerance: 0.3, at: [[0, 35], [40, 35]]}\n";
    let bench = ProofBench::of(&read(part));
    let text = bench.written(&language("fanuc"));
    for line in text.lines().filter(|line| line.starts_with('N')) {
        let words = line.split('(').next().unwrap_or_default();
        let functions = words.split(' ').filter(|word| word.starts_with('M')).count();
        assert!(functions <= 1, "{line}");
    }
    assert!(text.contains("G49 G53 Z0.0\n") && text.contains("G53 X0.0 Y250.0\n"), "{text}");
    let lines: Vec<&str> = text.lines().collect();
    let tapping = lines.iter().position(|line| line.contains("G84")).unwrap();
    assert!(lines[tapping - 1].ends_with("M29") && lines[tapping - 1].contains(" S"), "{}", lines[tapping - 1]);
}

/// GRBL takes lines of 79 characters without blanks and comments, one M in a block, and neither cycles nor calls; each hole is
/// made by motions, and a change is a stop with the spindle at rest.
#[test]
fn grbl_takes_its_program_as_it_is_written() {
    for part in PARTS {
        let text = ProofBench::new(part).written(&language("grbl"));
        let mut turning = false;
        for line in text.lines() {
            let words: Vec<&str> = line.split('(').next().unwrap_or_default().split_whitespace().collect();
            assert!(words.concat().len() < 80 && !line.contains('%'), "{part}: {line}");
            assert!(words.iter().filter(|word| word.starts_with('M')).count() <= 1, "{part}: {line}");
            for word in &words {
                let code = |letter: char| word.strip_prefix(letter).and_then(|code| code.parse::<f64>().ok());
                let known =
                    [0.0, 1.0, 2.0, 3.0, 4.0, 17.0, 21.0, 40.0, 43.1, 49.0, 53.0, 54.0, 55.0, 80.0, 90.0, 91.0, 94.0];
                assert!(code('G').is_none_or(|code| known.contains(&code)), "{part}: {line}");
                assert!(code('M').is_none_or(|code| [0.0, 3.0, 5.0, 8.0, 9.0, 30.0].contains(&code)), "{part}: {line}");
            }
            turning = match words.last() {
                Some(&"M3") => true,
                Some(&"M5") => false,
                _ => turning,
            };
            assert!(!turning || words.last() != Some(&"M0"), "{part}: {line}");
        }
    }
}

/// Of what laws once found, too.
#[test]
fn programs_of_what_laws_found_make_their_stops() {
    for (name, text) in technolog_testing::found() {
        holds(&ProofBench::of(&read(&text))).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// A countersink that goes round a wide edge: its circle by hand (`holes::floors`), and no figure of it altered unnoticed. Tools that
/// are ground say so where the operator changes them.
#[test]
fn a_countersink_goes_round_a_wide_edge() {
    let bench = ProofBench::new("tests/written/floors-and-wide-edge.yaml");
    holds(&bench).unwrap();
    for (name, language) in &*LANGUAGES {
        let text = bench.written(language);
        let round = text.lines().find(|line| line.contains("I-27.4")).unwrap_or_else(|| panic!("{name}: {text}"));
        for (from, to) in [("I-27.4", "I-27.3"), ("G3", "G2")] {
            let altered = text.replace(round, &round.replace(from, to));
            assert!(altered == text || !bench.codes(language, &altered).is_empty(), "{name}: {from} {to}");
        }
    }
    let reamed = ProofBench::of(&read(
        "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {kind: plate, length: 200, width: 150, thickness: 20}\nholes:\n  - \
         {name: A, diameter: 20H7, roughness: Ra 0.8, through: true, centre_tolerance: 0.2, at: [[0, 0]]}\n",
    ));
    let text = reamed.written(&language("fanuc"));
    let ground = |line: &&str| line.contains("ROUGH REAM") && line.contains("GROUND FROM D20");
    assert!(text.lines().find(ground).is_some(), "{text}");
    assert!(!text.lines().any(|line| line.contains("FINISH REAM") && line.contains("GROUND")), "{text}");
}

/// The part that is to have every cycle has it, and both set-ups.
#[test]
fn the_part_of_every_cycle_has_them_all() {
    let bench = ProofBench::new("tests/written/every-cycle.yaml");
    let kinds: Vec<String> = bench
        .job
        .setups
        .iter()
        .flat_map(|setup| &setup.works)
        .flat_map(|work| &work.cycles)
        .map(|cycle| serde_json::to_value(&cycle.kind).unwrap()["cycle"].as_str().unwrap().to_owned())
        .collect();
    for kind in ["drill", "feed-out", "bore-stop", "peck", "chip-break", "circles"] {
        assert!(kinds.iter().any(|known| known == kind), "no {kind} in {kinds:?}");
    }
    assert_eq!(bench.job.setups.len(), 2);
}

#[test]
fn programs_look_as_they_should() {
    for part in ["examples/plate.yaml", "tests/written/every-cycle.yaml"] {
        let bench = ProofBench::new(part);
        let stem = Path::new(part).file_stem().unwrap().to_string_lossy().into_owned();
        for (name, language) in &*LANGUAGES {
            insta::assert_snapshot!(format!("{stem}-{name}"), bench.written(language));
        }
    }
}

/// What section 3 asks of the form of a block: its length, its number, the cycle last (3.4, 3.7, 3.12.1).
#[test]
fn blocks_of_2c42_65_have_the_form_that_the_text_asks() {
    let language = &language("2c42-65");
    for part in PARTS {
        let text = ProofBench::new(part).written(language);
        assert!(text.len() <= 32 * 1024, "{part}");
        for line in text.lines() {
            // With the end of the block.
            assert!(line.chars().count() < 128, "{part}: {line}");
            if line.starts_with(['%', ':']) {
                continue;
            }
            let words: Vec<&str> = line.split(' ').collect();
            assert!(words[0].starts_with('N') && words.len() > 1, "{part}: {line}");
            let cycle = words.iter().position(|word| matches!(*word, "G81" | "G82" | "G83" | "G84" | "G85" | "G86"));
            if let Some(at) = cycle {
                let behind = &words[at + 1..];
                assert!(behind.iter().all(|word| "UZIVWFEHM".contains(&word[..1])), "{part}: {line}");
            }
            // ГОСТ 20999: G, then ways, then feed, speed, tool, then M.
            let order = ["N", "G", "XYZ", "IJK", "F", "S", "T", "DH", "M", "LP"];
            let ranks: Vec<usize> = words[..cycle.unwrap_or(words.len())]
                .iter()
                .map(|word| order.iter().position(|letters| letters.contains(&word[..1])).unwrap())
                .collect();
            assert!(ranks.is_sorted(), "{part}: {line}");
            // On the machine's grid of 0.01.
            for word in &words {
                assert!(word.split_once('.').is_none_or(|(_, fraction)| fraction.len() <= 2), "{part}: {line}");
            }
        }
    }
}

/// Rows of a grid are repeated, so that a program stays short.
#[test]
fn rows_of_equal_steps_are_repeated() {
    let part = "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {kind: plate, length: 600, width: 100, thickness: 20}\n\
                holes:\n  - {name: A, diameter: 8H12, through: true, roughness: Rz 80, centre_tolerance: 0.46, \
                pattern: {line: {start: [-250, 0], count: 26, step: 20}}}\n";
    let text = ProofBench::of(&read(part)).written(&language("2c42-65"));
    assert!(text.contains(" L25") || text.contains(" L24"), "{text}");
    assert!(text.lines().count() < 45, "{text}");
}

/// A share of every kind of the changes below.
#[test]
fn no_word_of_a_written_program_can_be_changed_unnoticed() {
    changes_are_noticed(61);
}

/// Delete, swap or alter any one word of a written program, and something is said, or the program does the same.
#[test]
#[ignore = "takes minutes: every change there is"]
fn not_one_word_of_a_written_program_can_be_changed_unnoticed() {
    changes_are_noticed(1);
}

fn changes_are_noticed(usual: usize) {
    let mut kinds: BTreeMap<(&str, &str), [usize; 3]> = BTreeMap::new();
    let mut unnoticed = Vec::new();
    for part in ["examples/plate.yaml", "tests/written/every-cycle.yaml"] {
        let bench = ProofBench::new(part);
        for (name, language) in &*LANGUAGES {
            let label = format!("{part} {name}");
            let text = bench.written(language);
            let Score { kinds: own, unnoticed: mut more } =
                score(&label, &text, usual, |text| bench.run(language, text).2);
            for (kind, counts) in own {
                let all = kinds.entry((name, kind)).or_default();
                for (all, count) in all.iter_mut().zip(counts) {
                    *all += count;
                }
            }
            unnoticed.append(&mut more);
        }
    }
    let mut report = String::from("control   kind          noticed  same  unnoticed\n");
    for ((name, kind), [noticed, same, missed]) in &kinds {
        report.push_str(&format!("{name:<9} {kind:<12} {noticed:>8} {same:>5} {missed:>10}\n"));
    }
    println!("{report}");
    assert!(unnoticed.is_empty(), "{report}{}", unnoticed.join("\n"));
}

proptest! {
    #![proptest_config(technolog_laws::cases!(12))]

    /// Random parts: the program of every control, read back, makes the stops of the plan.
    #[test]
    fn programs_of_random_parts_make_their_stops(text in part_files()) {
        let Ok(part) = technolog::part::read_part("part.yaml", &text, &KNOWLEDGE) else { return Ok(()) };
        holds(&ProofBench::of(&part))?;
    }
}

/// The examples of the documentation stay what the program writes.
#[test]
fn parts_of_these_tests_are_there() {
    for part in PARTS {
        assert!(fs::exists(Path::new(env!("CARGO_MANIFEST_DIR")).join(part)).unwrap(), "{part}");
    }
}
