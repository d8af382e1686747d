//! The proof that a program makes its part: right programs, Appendix Г, and programs with one word changed.
//!
//! A folder of `tests/proof` holds `program.nc`, written by hand, and `plan.json`, the plan that it carries out: a program
//! is right for its plan, whatever is planned today.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use technolog::job::Pause;
use technolog::note::Severity;
use technolog::program::Language;
use technolog::units::Micrometres;
use technolog::words::Lang;
use technolog_testing::KNOWLEDGE;
use technolog_testing::mutants::{Score, score};
use technolog_testing::proof_bench::ProofBench;

static CONTROL: LazyLock<Language> = LazyLock::new(|| Language::read("2c42-65", &KNOWLEDGE).unwrap());

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

/// The right programs: folder, program, part.
fn right() -> Vec<(String, String, ProofBench)> {
    let mut folders: Vec<PathBuf> =
        fs::read_dir(root().join("tests/proof")).unwrap().map(|entry| entry.unwrap().path()).collect();
    folders.sort();
    let read = |path: PathBuf| fs::read_to_string(path).unwrap();
    folders
        .into_iter()
        .map(|folder| {
            let name = folder.file_name().unwrap().to_string_lossy().into_owned();
            let plan = serde_json::from_str(&read(folder.join("plan.json"))).unwrap();
            (name, read(folder.join("program.nc")), ProofBench::of_plan(plan))
        })
        .collect()
}

#[test]
fn of_a_right_program_nothing_is_said_and_every_stop_is_visited_in_the_order_of_the_job() {
    let programs = right();
    assert!(programs.len() > 2);
    for (name, text, bench) in programs {
        let (faults, proof, _) = bench.run(&CONTROL, &text);
        assert!(faults.is_empty(), "{name}: {faults:?}");
        assert!(proof.findings.is_empty(), "{name}: {:?}", proof.findings);
        let visited: Vec<_> =
            proof.visits.iter().map(|visit| (visit.hole.as_str(), visit.transition, visit.pass, visit.at)).collect();
        let planned: Vec<_> =
            bench.job.stops().map(|(.., stop)| (stop.hole.as_str(), stop.transition, stop.pass, stop.at)).collect();
        assert_eq!(visited, planned, "{name}");
    }
}

/// A share of every kind of the changes below.
#[test]
fn no_word_can_be_changed_unnoticed() {
    changes_are_noticed(13);
}

/// Delete, swap or alter any one word of a program, and something is said, or the program does the same.
#[test]
#[ignore = "takes long: every change there is"]
fn not_one_word_can_be_changed_unnoticed() {
    changes_are_noticed(1);
}

fn changes_are_noticed(usual: usize) {
    let mut kinds: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    let mut unnoticed = Vec::new();
    for (name, text, bench) in right() {
        let Score { kinds: own, unnoticed: mut more } = score(&name, &text, usual, |text| bench.run(&CONTROL, text).2);
        for (kind, counts) in own {
            let all = kinds.entry(kind).or_default();
            for (all, count) in all.iter_mut().zip(counts) {
                *all += count;
            }
        }
        unnoticed.append(&mut more);
    }
    let mut report = String::from("kind          noticed  same  unnoticed\n");
    for (kind, [noticed, same, missed]) in &kinds {
        report.push_str(&format!("{kind:<12} {noticed:>8} {same:>5} {missed:>10}\n"));
    }
    println!("{report}");
    assert!(unnoticed.is_empty(), "{report}{}", unnoticed.join("\n"));
}

/// A right program with one passage altered: folder, what stands there, what instead, and what is said of it.
const FAULTS: &[(&str, &str, &str, &str)] = &[
    ("plate", "N45 X-175 Y50\n", "", "not-made"),
    ("plate", "N45 X-175 Y50\n", "N45 X-175 Y50\nN46 X-175 Y50\n", "cut-again"),
    ("plate", "P03\n", "P03\nN1 X-200 Y100\n", "cut-not-planned"),
    ("plate", "N45 X-175 Y50\n", "N45 X-170 Y50\n", "cut-elsewhere"),
    ("plate", "T2 M6", "T3 M6", "wrong-tool"),
    ("plate", "T3 M6", "T9 M6", "tool-unknown"),
    ("plate", " H2", " H0", "no-correction"),
    ("plate", " H2", " H1", "wrong-correction"),
    ("variant-4", " H4", " H5", "other-corrector"),
    ("plate", "U3 Z-46.01 I15", "U3 Z-46.01 I-10", "rapid-across"),
    ("plate", "G81 U3 Z-46.01 I15 F225", "G0 Z-46.01", "rapid-into-part"),
    ("plate", "U3 Z-46.01", "U-1 Z-46.01", "rapid-into-metal"),
    ("plate", "H2 Z15", "H2 Z-15", "rapid-into-part"),
    ("plate", "S1000 M3", "S1000 M4", "wrong-turn"),
    ("plate", "G81 U3 Z-46.01 I15 F225", "G1 Z-46.01 F225 G91\nN2 X5\nN3 X-5 G90\nN4 G0 Z15", "slot"),
    ("plate", "Z-46.01 I15", "Z-46.01 I5", "travel-low"),
    ("plate", "Z-46.01", "Z-40", "too-shallow"),
    ("plate", "Z-46.01", "Z-45", "less-overrun"),
    ("plate", "Z-46.01", "Z-48", "deeper"),
    ("large-bore", "Z-72.01", "Z-125", "into-table"),
    ("plate", "U3 Z-46.01", "U1 Z-46.01", "begins-lower"),
    ("plate", "U3 Z-46.01", "U5 Z-46.01", "begins-higher"),
    ("plate", "S1000", "S800", "other-speed"),
    ("plate", "F225", "F200", "other-feed"),
    ("plate", "I15 F225", "I15 E10 F225", "other-dwell"),
    ("two-sides", "E6", "E2", "other-dwell"),
    ("plate", "G81 U3 Z-46.01 I15 F225", "G1 Z-20 F225\nN2 G4 E5\nN3 G1 Z-46.01\nN4 G0 Z15", "dwell-elsewhere"),
    ("plate", "S1000 M3 M8", "S1000 M3", "coolant-missing"),
    ("large-bore", "S2500 M3", "S2500 M3 M8", "coolant-superfluous"),
    ("two-sides", "V9", "V10", "step-too-large"),
    ("two-sides", "V9", "V8", "step-smaller"),
    ("two-sides", "W1", "W2", "step-clearance"),
    ("two-sides", "G83", "G86", "step-return"),
    ("plate", "G81 U3 Z-46.01 I15", "G83 U3 Z-46.01 V10 W1 I15", "steps-not-planned"),
    ("two-sides", "G83 U3 Z-46.5 V2.5 W1", "G81 U3 Z-46.5", "step-too-large"),
    ("two-sides", "G82", "G81", "out-at-rapid"),
    ("large-bore", "G85", "G81", "out-turning"),
    ("plate", "G81 U3 Z-46.01", "G85 U3 Z-46.01", "out-standing"),
    ("variant-4", "I15 F320", "I15 F320 H100", "out-other-feed"),
    ("plate", "G81 U3 Z-46.01", "G82 U3 Z-46.01", "out-at-feed"),
    ("variant-4", "G82 U3 Z-13 I15 F320", "G82 U3 Z-13 F320", "out-too-high"),
    ("large-bore", "G1 X7.25\n", "G1 X7.25\nN8 G1 X-17\nN9 G0 Z15\nN10 G90\nN11 M99\n", "circle-missing"),
    ("two-sides", "G1 X-7\n", "G1 X-7\nN6 G1 X7\nN7 G3 I-7\nN8 G1 X-7\n", "circle-superfluous"),
    ("large-bore", "Z-40", "Z-41", "circle-level"),
    ("two-sides", "G91 X7\nN4 G3 I-7\nN5 G1 X-7", "G91 X6\nN4 G3 I-6\nN5 G1 X-6", "circle-radius"),
    ("two-sides", "G3 I-7", "G3 I-6", "circle-centre"),
    ("two-sides", "G3 I-7", "G2 I-7", "circle-sense"),
    ("two-sides", "G3 I-7\nN5 G1 X-7", "G3 X-14 I-7\nN5 G1 X7", "circle-open"),
    ("two-sides", "G3 I-7", "L2 G3 I-7", "circle-again"),
    ("two-sides", "G1 X-7", "G1 X-7 Z1", "oblique"),
    ("two-sides", "G91 X7\n", "G91 X4\nN4 X3\n", "ways-between-circles"),
    ("two-sides", "G1 Z-12 F41", "G1 Z-6 F41.8\nN3 Z-12", "ways-down"),
    ("two-sides", "N5 G1 X-7\n", "", "not-in-the-middle"),
    ("two-sides", "M00", "", "no-stop-to-turn-over"),
    ("two-sides", "M00", "", "not-turned-over"),
    ("plate", "N80 X175 Y50\n", "N80 X175 Y50\nN81 M00\n", "stop-for-nothing"),
    ("plate", "G40", "G41", "radius-correction"),
    ("plate", " M5", "", "turns-to-change"),
    ("plate", " M5", "", "turns-at-change"),
    ("plate", " M5", "", "turns-at-end"),
    ("plate", "M5 M9", "M5", "coolant-at-change"),
    ("plate", " M02", "", "no-end"),
    ("plate", "N45 X-175 Y50\nN50 X-200 Y0\n", "N45 X-200 Y0\nN50 X-175 Y50\n", "other-order"),
    ("plate", "N95 P08", "N90 G0 X0\nN95 P08", "idle-point"),
    ("plate", "N40 P01", "N40 G0 Z10\nN41 G0 Z15\nN42 P01", "idle-height"),
    ("plate", "N40 P01", "N39 G4 E5\nN40 P01", "dwell-in-air"),
    ("plate", "G0 G43 H2", "G1 G43 H2 F2000", "air-at-feed"),
    ("plate", "N45 X-175", "N45 G1 X-175", "travel-at-feed"),
    ("plate", "Z-46.01 I15", "Z-46.01 I20", "travel-high"),
    ("plate", "Z-46.01 I15", "Z-126.01 I15", "holder-into-part"),
    ("plate", "N95 P08\nN100 P09", "N95 P09\nN100 P08", "travel-not-up"),
    ("plate", "S1000 M3 M8\nN120 G0 G43 H2 Z15", "M8\nN120 G0 G43 H2 Z15 S1000\nN121 M3", "approach-standing"),
    (
        "plate",
        "T3 M6\nN195 G0 G54 X-175 Y50\nN200 S400 M3 M8\nN205 G0 G43 H3",
        "T9 M6\nN195 G0 G54 X-175 Y50\nN200 S400 M3 M8\nN205 G0 G43 H1",
        "tool-unknown",
    ),
    ("variant-4", "T4 M6", "T3 M6", "wrong-tool"),
    ("plate", "M9\nN2 M99\n:09\nN1 G53 G0", "M99\n:09\nN1 G53 G0 M8", "coolant-at-end"),
    ("plate", "N240 P09\n", "", "ends-elsewhere"),
    ("plate", "H3 Z15", "H0 Z15", "no-corrector"),
    ("plate", "S1000 M3 M8", "S50 M3 M8", "feed-per-turn"),
    ("plate", "P09\n", "\n", "changes-elsewhere"),
    ("plate", "G49 ", "", "correction-at-change"),
    ("large-bore", "N26 G0 Z15", "N26 G0 Z18", "out-elsewhere"),
    ("variant-4", "N1 G82 U3 Z-13 I15 F320", "N1 G82 U3 Z-13 I0 F320", "out-too-low"),
];

#[test]
fn what_deviates_is_called_by_its_name() {
    let programs = right();
    let mut wrong = Vec::new();
    for (name, before, after, code) in FAULTS {
        let (_, text, bench) = programs.iter().find(|(known, ..)| known == name).unwrap();
        assert!(text.contains(before), "{name} has no {before:?}");
        let codes = bench.codes(&CONTROL, &text.replacen(before, after, 1));
        if !codes.contains(code) {
            wrong.push(format!("{name}: {before:?} → {after:?}: {codes:?}, not {code}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A length of another tool is told with that tool: one of the two numbers was mistaken for the other.
#[test]
fn a_wrong_correction_names_the_tool_whose_it_is() {
    let programs = right();
    let (_, text, bench) = programs.iter().find(|(known, ..)| known == "plate").unwrap();
    let (_, proof, _) = bench.run(&CONTROL, &text.replacen(" H2", " H1", 1));
    let wrong = proof.findings.iter().find(|finding| finding.code.name() == "wrong-correction").unwrap();
    let message = Lang::EN.say(&wrong.note);
    assert!(
        message.starts_with("T2 cuts with H1 = ")
            && message.contains(", the offset of T1, and its correction is H2 = "),
        "{message}"
    );
    let message = Lang::UK.say(&wrong.note);
    assert!(
        message.starts_with("T2 ріже з H1 = ") && message.contains(", коректором T1, а його корекція H2 = "),
        "{message}"
    );
}

/// Every deviation of docs/proof.md is shown by some altered program, here or in the tests below.
#[test]
fn every_deviation_is_shown_by_some_program() {
    let below = [
        "wrong-order",
        "tool-by-work",
        "wrong-sign",
        "shared-corrector",
        "correction-otherwise",
        "not-loaded",
        "no-stop-to-load",
        "no-stop-to-set-bar",
        // `slots`, `unfinished`, `clamps` and `directed` have tests of their own.
        "slot-uncut",
        "slot-gouged",
        "slot-plunge-aside",
        "through-obstacle",
        "holder-through-obstacle",
        "holder-unknown",
        "tap-not-followed",
        // Of a standing spindle this control lets no feed out; `cuts` has a test of it.
        "spindle-stands",
    ];
    let page = fs::read_to_string(root().join("docs/proof.md")).unwrap();
    let rows = page.lines().filter(|line| line.starts_with("| `")).filter_map(|line| line.split('|').nth(1));
    let codes: Vec<&str> = rows.flat_map(|cell| cell.split('`').skip(1).step_by(2)).collect();
    assert!(codes.len() > 70, "the page names {}", codes.len());
    let keys = ["visits", "missing", "superfluous", "findings"];
    let shown =
        |code: &&str| FAULTS.iter().any(|(.., known)| known == code) || below.contains(code) || keys.contains(code);
    let unshown: Vec<&str> = codes.into_iter().filter(|code| !shown(code)).collect();
    assert!(unshown.is_empty(), "no program shows {unshown:?}");
}

/// Appendix Г: what its README tells of it, and what its plan does otherwise (`technolog plan examples/plate.yaml`).
///
/// Expected by hand. N105 names X alone, so the first hole of T2 is at Y196. N140 drills, before N145 calls the drilling
/// (the block of that cut is N1 of :02). N380 names X-50. N195 is missing, so the spindle stands over B and nothing is
/// centred there: N190 and N220 go there for nothing. The program ends without P05.
/// The example's figures beside the plan's: centring to 5 mm at S2000 F400 (3 mm, S1600 F240); A drilled to 45 mm at S700 F175
/// (46.004, S1000 F225) in five holes, B to 48 mm at S700 F60 in four; B drilled out to 48 mm at S500 F60 (49.009, S400
/// F304) in three; no coolant, which the plan has for all three; correctors -50 and -85 (-102.4, -60.4); approaches at
/// F2000 by T1, T2 and T3 (a further one goes to the hole at Y196).
const APPENDIX: &[(&str, &str, Option<u32>, &str)] = &[
    ("error", "cut-elsewhere", Some(105), "X-200 Y196"),
    ("error", "cut-elsewhere", Some(380), "X-50 Y50"),
    ("error", "cut-again", Some(1), "X200 Y-100"),
    ("error", "not-made", None, "[-200; 0]"),
    ("error", "not-made", None, "[-175; 50], [-175; -50], [175; -50], [175; 50]"),
    ("error", "not-made", None, "[175; -50]"),
    ("doubtful", "less-overrun", Some(125), "4"),
    ("doubtful", "other-speed", Some(125), "4"),
    ("doubtful", "other-feed", Some(125), "4"),
    ("doubtful", "coolant-missing", Some(125), "4"),
    ("doubtful", "correction-otherwise", Some(1), "12"),
    ("doubtful", "correction-otherwise", Some(1), "10"),
    ("doubtful", "deeper", Some(1), "5"),
    ("wrong", "other-speed", Some(1), "5"),
    ("doubtful", "other-feed", Some(1), "5"),
    ("doubtful", "coolant-missing", Some(1), "5"),
    ("doubtful", "deeper", Some(1), "3"),
    ("doubtful", "other-speed", Some(1), "3"),
    ("doubtful", "other-feed", Some(1), "3"),
    ("doubtful", "coolant-missing", Some(1), "3"),
    ("doubtful", "coolant-missing", Some(1), "2"),
    ("doubtful", "less-overrun", Some(1), "2"),
    ("doubtful", "other-speed", Some(1), "2"),
    ("doubtful", "other-feed", Some(1), "2"),
    // At Z15 it goes lower than the plan does over its own straps.
    ("note", "travel-low", Some(42), "X-200 Y0"),
    ("note", "travel-low", Some(45), "1"),
    ("note", "travel-low", Some(55), "2"),
    ("note", "travel-low", Some(65), "1"),
    ("note", "travel-low", Some(70), "1"),
    ("note", "travel-low", Some(125), "X-200 Y100"),
    ("note", "travel-low", Some(285), "1"),
    ("note", "travel-low", Some(295), "1"),
    ("note", "travel-low", Some(305), "X175 Y-50"),
    ("note", "travel-low", Some(380), "X-50 Y50"),
    ("note", "idle-height", Some(35), "19"),
    ("note", "air-at-feed", Some(35), "2"),
    ("note", "other-order", Some(130), ""),
    ("note", "idle-point", Some(190), "X-175 Y-50"),
    ("note", "idle-point", Some(220), "X175 Y50"),
    ("note", "ends-elsewhere", Some(395), "X-50 Y50 Z0"),
];

#[test]
fn appendix_g_is_held_against_its_part() {
    let text = fs::read_to_string(root().join("examples/appendix-g/program.nc")).unwrap();
    let mut bench = ProofBench::new("examples/plate.yaml").with_correctors(&[(8, 0), (10, -85_000), (12, -50_000)]);
    // As its setting says.
    bench.setting.zeros[0] = [0, 0, -120].map(|zero| Some(Micrometres::from_mm(zero)));
    bench.job.setups[0].zero.z = Micrometres::from_mm(-120);
    let mut findings: Vec<(String, &str, Option<u32>, String)> = Vec::new();
    for finding in bench.run(&CONTROL, &text).1.findings {
        let severity = format!("{:?}", finding.severity).to_lowercase();
        // What tells one from another: the points, how many more, the corrector, the place.
        let which = ["points", "more", "at", "corrector"]
            .map(|name| finding.note.figure(name).map(|it| it.text().into_owned()));
        let which = match (finding.code.name(), which) {
            ("other-order", _) => String::new(),
            ("correction-otherwise", [.., corrector]) => corrector.unwrap(),
            (_, [points, more, at, _]) => points.or(more).or(at).unwrap(),
        };
        findings.push((severity, finding.code.name(), finding.block.and_then(|block| block.number), which));
    }
    let mut expected: Vec<(String, &str, Option<u32>, String)> = APPENDIX
        .iter()
        .map(|(severity, code, block, which)| ((*severity).to_owned(), *code, *block, (*which).to_owned()))
        .collect();
    findings.sort();
    expected.sort();
    assert_eq!(findings, expected);
}

/// The order of the tools, and of the points, is the program's own affair.
#[test]
fn another_order_makes_the_part_as_well() {
    let (_, text, bench) = right().into_iter().find(|(name, ..)| name == "plate").unwrap();
    let other = text.replacen("N45 X-175 Y50\nN50 X-200 Y0\n", "N45 X-200 Y0\nN50 X-175 Y50\n", 1);
    let proof = bench.run(&CONTROL, &other).1;
    assert!(!proof.has_errors(), "{:?}", proof.findings);
    assert_eq!(proof.missing.len() + proof.superfluous.len(), 0);
    // Transitions of a hole the other way round are not.
    let codes = bench
        .codes(&CONTROL, &text.replacen("P01\n", "P02\n", 1).replacen("H2 Z15\nN125 P02\n", "H2 Z15\nN125 P01\n", 1));
    assert!(codes.contains(&"wrong-tool"), "{codes:?}");
    let reamers = right().into_iter().find(|(name, ..)| name == "variant-4").unwrap();
    let (four, five) = ("S400 M3 M8\nN180 G0 G43 H4 Z15\nN185 P04", "S500 M3 M8\nN225 G0 G43 H5 Z15\nN230 P05");
    let swapped = reamers
        .1
        .replace("T4 M6", "T0 M6")
        .replace("T5 M6", "T4 M6")
        .replace("T0 M6", "T5 M6")
        .replace(four, "#")
        .replace(five, "S400 M3 M8\nN225 G0 G43 H4 Z15\nN230 P04")
        .replace('#', "S500 M3 M8\nN180 G0 G43 H5 Z15\nN185 P05");
    assert_eq!(reamers.2.codes(&CONTROL, &swapped), ["wrong-order", "other-order"]);
}

/// Correctors of the operator have his numbers and values; one of them for two tools, or two for one, is an error.
#[test]
fn own_correctors_have_their_own_numbers() {
    let (_, text, bench) = right().into_iter().find(|(name, ..)| name == "plate").unwrap();
    let bench = bench.with_correctors(&[(11, -102_400), (12, -60_400), (13, -50_000)]);
    let numbered = text.replace(" H1 ", " H11 ").replace(" H2 ", " H12 ");
    assert_eq!(bench.codes(&CONTROL, &numbered), [""; 0]);
    assert_eq!(bench.codes(&CONTROL, &numbered.replace(" H12 ", " H11 ")), ["shared-corrector", "shared-corrector"]);
    assert_eq!(bench.codes(&CONTROL, &numbered.replace(" H12 ", " H13 ")), ["correction-otherwise"]);
    // Tools that he numbers in his own way are known by what they do.
    assert_eq!(bench.codes(&CONTROL, &numbered.replace("T2 M6", "T9 M6")), ["tool-by-work"]);
    let mut bench = bench.with_correctors(&[(11, 102_400), (12, -60_400), (13, 0)]);
    // Low enough that the quill can follow the wrong sign.
    bench.job.setups[0].zero.z = Micrometres::from_mm(-130);
    bench.setting.zeros[0][2] = Some(Micrometres::from_mm(-130));
    assert!(bench.codes(&CONTROL, &numbered).contains(&"wrong-sign"));
}

/// The plan has three turns at the bottom of the counterbore, 0.6 s at 315 1/min; 0.2 s is a whole turn, 0.1 s is half of one.
#[test]
fn a_dwell_of_less_than_a_turn_is_doubtful() {
    let (_, text, bench) = right().into_iter().find(|(name, ..)| name == "two-sides").unwrap();
    for (dwell, severity) in [("E2", Severity::Note), ("E1", Severity::Doubtful)] {
        let (_, proof, _) = bench.run(&CONTROL, &text.replace("E6", dwell));
        let found: Vec<_> = proof.findings.iter().map(|finding| (finding.code.name(), finding.severity)).collect();
        assert_eq!(found, [("other-dwell", severity)]);
    }
}

/// The second set-up has a zero of its own, and the part is turned over at the stop.
#[test]
fn the_second_set_up_counts_from_its_own_zero() {
    let (_, text, mut bench) = right().into_iter().find(|(name, ..)| name == "two-sides").unwrap();
    let shifted = bench.job.setups[1].zero.x + Micrometres::from_mm(30);
    bench.job.setups[1].zero.x = shifted;
    bench.setting.zeros[1][0] = Some(shifted);
    assert_eq!(bench.codes(&CONTROL, &text), [""; 0]);
    let codes = bench.codes(&CONTROL, &text.replace("G55", "G54"));
    assert!(codes.contains(&"not-made") && codes.contains(&"cut-elsewhere"), "{codes:?}");
}

/// What the operator has to do needs a stop before the work.
#[test]
fn pauses_need_stops() {
    let (_, text, mut bench) = right().into_iter().find(|(name, ..)| name == "plate").unwrap();
    let stopped = text.replacen("N190 T3", "N189 M00\nN190 T3", 1);
    assert_ne!(stopped, text);
    bench.job.setups[0].works[2].pauses = vec![Pause::SetBar { diameter_mm: Micrometres::from_mm(20) }];
    assert_eq!(bench.codes(&CONTROL, &text), ["no-stop-to-set-bar"]);
    assert_eq!(bench.codes(&CONTROL, &stopped), [""; 0]);
    // The third tool comes into the place of the first.
    bench.job.setups[0].works[2].pauses = vec![Pause::LoadTool { tool: 3, place: 1 }];
    bench.job.setups[0].works[2].place = 1;
    let loaded = text.replace("T3 M6", "T1 M6");
    assert_eq!(bench.codes(&CONTROL, &loaded), ["not-loaded", "no-stop-to-load"]);
    assert_eq!(bench.codes(&CONTROL, &stopped.replace("T3 M6", "T1 M6")), [""; 0]);
}

fn technolog(args: &[&str]) -> std::process::Output {
    std::process::Command::new(env!("CARGO_BIN_EXE_technolog")).current_dir(root()).args(args).output().unwrap()
}

/// The command takes zeros and correctors of the job, shows what is made, and fails what is not.
#[test]
fn the_command_shows_what_is_made_of_what_is_needed() {
    let part = ["--part", "examples/plate.yaml", "--control", "2c42-65", "--lang", "en"];
    let program = technolog(&["program", "examples/plate.yaml", "--control", "2c42-65"]).stdout;
    let file = std::env::temp_dir().join(format!("technolog-proof-{}.nc", std::process::id()));
    fs::write(&file, program).unwrap();
    let right = technolog(&[&["check", file.to_str().unwrap()], &part[..]].concat());
    fs::remove_file(&file).unwrap();
    let text = String::from_utf8(right.stdout).unwrap();
    assert_eq!(right.status.code(), Some(0), "{text}");
    assert!(text.starts_with("What the plan requires, and what the program makes of it\n"), "{text}");
    assert!(text.contains("\n B    | drilling out | T3 |  4/4\n"), "{text}");

    let printed = ["check", "examples/appendix-g/program.nc", "--setting", "examples/appendix-g/setting.yaml"];
    let printed = technolog(&[&printed, &part[..], &["--format", "json"]].concat());
    assert_eq!(printed.status.code(), Some(1));
    let answer: serde_json::Value = serde_json::from_slice(&printed.stdout).unwrap();
    let proof = &answer["proof"];
    let count = |key: &str| proof[key].as_array().unwrap().len();
    assert_eq!([count("visits"), count("missing"), count("superfluous")], [18, 6, 3]);
    assert_eq!(proof["findings"][0]["block"], 105);
    let keys: Vec<&String> = proof["visits"][0].as_object().unwrap().keys().collect();
    assert_eq!(keys, ["at", "block", "hole", "line", "pass", "tool", "transition"]);
    assert_eq!(proof["visits"][0]["at"], serde_json::json!([-200, 100]));
}
