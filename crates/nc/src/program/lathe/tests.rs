//! Programs whose motions are worked out by hand, in `tests/programs-lathe`: a folder per control, of each program
//! `NAME.nc` and `NAME.expected`, lines of its trace and codes of what is wrong. `CONTOUR.SPF` is a contour beside them.
//!
//! A line `...` of what is expected stands for lines that are not looked at.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::rules::RULES;
use super::{LatheLanguage, LatheRun, Subprogram, read, trace};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/programs-lathe")
}

fn language(control: &str) -> LatheLanguage {
    LatheLanguage::read(control, &crate::shipped::knowledge().unwrap()).unwrap()
}

fn lines(run: &LatheRun) -> Vec<String> {
    let motions = run.motions.iter().map(|motion| trace::line_in(motion, &|word| word));
    let faults = run.faults.iter().map(|fault| format!("{} {}:{}", fault.code, fault.span.line, fault.span.column));
    let squeezed = |line: String| line.split_whitespace().collect::<Vec<_>>().join(" ");
    motions.chain(faults).map(squeezed).collect()
}

/// Whether lines are those that are expected, with stretches left out.
fn agree(lines: &[String], expected: &[&str]) -> bool {
    match expected.split_first() {
        None => lines.is_empty(),
        Some((&"...", rest)) => (0..=lines.len()).any(|skipped| agree(&lines[skipped..], rest)),
        Some((line, rest)) => lines.first().is_some_and(|first| first == line) && agree(&lines[1..], rest),
    }
}

#[test]
fn programs_do_what_was_worked_out_by_hand() {
    let (mut count, mut wrong, mut codes) = (0, Vec::new(), BTreeSet::new());
    for control in LatheLanguage::NAMES {
        let language = language(control);
        let mut files: Vec<PathBuf> =
            fs::read_dir(root().join(control)).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        for file in files.iter().filter(|file| file.extension().is_some_and(|it| it == "nc")) {
            let text = fs::read_to_string(file).unwrap();
            let contour = fs::read_to_string(file.with_file_name("CONTOUR.SPF")).unwrap_or_default();
            let run = read(&text, &language, &[Subprogram { name: "CONTOUR", text: &contour }]);
            codes.extend(run.faults.iter().map(|fault| fault.code));
            let expected = fs::read_to_string(file.with_extension("expected")).unwrap_or_default();
            let expected: Vec<String> = expected
                .lines()
                .filter(|line| !line.trim().is_empty() && !line.starts_with('#'))
                .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "))
                .collect();
            let expected: Vec<&str> = expected.iter().map(String::as_str).collect();
            count += 1;
            if !agree(&lines(&run), &expected) {
                wrong.push(format!("{}\n{}", file.display(), lines(&run).join("\n")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    assert!(count > 20, "{count}");
    let never: Vec<&str> = RULES.iter().map(|rule| rule.0).filter(|code| !codes.contains(code)).collect();
    // Limits of size.
    assert_eq!(never, ["too-many-blocks", "run-too-long"]);
}

#[test]
fn no_text_makes_the_reader_panic() {
    let parts = [
        "G0",
        "G1",
        "G2",
        "X",
        "Z",
        "-5",
        "1e9",
        "I",
        "K",
        "R1",
        "G71",
        "G76",
        "P",
        "Q100",
        "U",
        "(",
        ")",
        "[",
        "]",
        "#1",
        "=",
        "G33.1",
        "G84",
        "G80",
        "K1.5",
        "CYCLE84",
        "CYCLE95",
        "CYCLE97",
        "\"A\"",
        ",",
        "\n",
        "\n",
        "N10",
        "o100 sub",
        "o100 endsub",
        "o100 call",
        "%",
        "M3",
        "S100",
        "T0101",
        "G96",
        "D",
        "F0.1",
        "LIMS=",
        "CR=",
        "é",
        "Ж",
        " ",
        "/",
        ";",
        ":",
        "M98",
        "M99",
        "M2",
        "G18 G21 G7 G90",
    ];
    let mut seed = 1_u64;
    let mut next = |end: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % end
    };
    for control in LatheLanguage::NAMES {
        let language = language(control);
        for _ in 0..3000 {
            let text: String = (0..next(40)).map(|_| parts[next(parts.len())]).collect();
            read(&text, &language, &[Subprogram { name: "A", text: &text }]);
        }
    }
}
