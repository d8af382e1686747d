//! Files with thousands of mistakes: all of them are found, of many the gravest are shown, and the rest is counted.
//!
//! Where the work of a mistake grows with their number, or with the length of its line, these tests take minutes.

use std::fmt::Write as _;
use std::fs;

use technolog::part::read_part;
use technolog_testing::{KNOWLEDGE, root};

use super::{command, folder};

/// A line of so many points with decimal commas, which makes four figures of two.
fn commas(points: usize) -> String {
    let points: Vec<String> = (0..points).map(|point| format!("[{point},5, 7,5]")).collect();
    format!(
        "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 400, width: 200, thickness: 40}}\n\
         holes:\n  - {{name: A, diameter: 10, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [{}]}}\n",
        points.join(", ")
    )
}

#[test]
fn keys_that_stand_again_are_found_however_many() {
    let text = "a: 1\n".repeat(20_000);
    let problems = read_part("part.yaml", &text, &KNOWLEDGE).unwrap_err();
    assert_eq!(problems.iter().filter(|one| one.code == "duplicate-key").count(), 19_999);
    let last = problems.iter().rfind(|one| one.code == "duplicate-key").unwrap();
    assert_eq!(last.place.as_ref().unwrap().line, 20_000);
}

#[test]
fn unknown_keys_are_found_however_many_and_however_long() {
    // Some of them are near to known ones, and each of those is no longer missing.
    let mut text: String = (0..20_000).map(|number| format!("nobody-knows-this-key-of-many-{number}: 1\n")).collect();
    let _ = write!(text, "materia: 1\nmachin: 1\nhole: 1\n? {}\n: 1\n", "x".repeat(1_000_000));
    let problems = read_part("part.yaml", &text, &KNOWLEDGE).unwrap_err();
    let of = |code: &str| problems.iter().filter(|one| one.code == code).count();
    assert_eq!((of("unknown-key"), of("missing-key")), (20_004, 2));
}

#[test]
fn groups_with_a_mistyped_key_each_are_found_however_many() {
    let mut text = String::from("part: P\nmaterial: steel-45\nmachine: gf2171\nholes:\n");
    for number in 0..500 {
        let _ = writeln!(text, "  - {{name: A{number}, diametr: 10, through: true, roughnes: Ra 5, at: [[0, 0]]}}");
    }
    let problems = read_part("part.yaml", &text, &KNOWLEDGE).unwrap_err();
    let of = |code: &str| problems.iter().filter(|one| one.code == code).count();
    // The blank, and the tolerance of each group.
    assert_eq!((of("unknown-key"), of("missing-key")), (1_000, 501));
}

#[test]
fn of_many_mistakes_in_one_line_fifty_are_shown_each_with_its_stretch_of_the_line() {
    let folder = folder("commas");
    fs::write(folder.join("part.yaml"), commas(4_000)).unwrap();
    let answer = command(&folder, &["plan", "part.yaml"], b"");
    assert_eq!(answer.code, Some(2));
    assert_eq!(answer.beside.matches("error[").count(), 50, "{}", answer.beside);
    assert!(answer.beside.ends_with("\nand 3950 more: `--all-problems` shows all\n"), "{}", answer.beside);
    assert!(answer.beside.lines().all(|line| line.chars().count() <= 120), "{}", answer.beside);
    let all = command(&folder, &["plan", "part.yaml", "--all-problems"], b"");
    assert_eq!(all.beside.matches("error[").count(), 4_000);
    assert!(!all.beside.contains("--all-problems"));
    // Above each mark stands what it means.
    for lines in all.beside.lines().collect::<Vec<_>>().windows(2) {
        let Some(column) = lines[1].strip_prefix("  | ").and_then(|line| line.find('^')) else { continue };
        assert_eq!(lines[0].chars().nth(column + 4), Some('['), "{lines:?}");
    }
}

#[test]
fn a_check_is_told_in_the_words_of_its_reader() {
    let folder = folder("words-of-check");
    let example = |name: &str| fs::read_to_string(root().join("examples/appendix-g").join(name)).unwrap();
    fs::write(folder.join("program.nc"), example("program.nc")).unwrap();
    fs::write(folder.join("setting.yaml"), example("setting.yaml")).unwrap();
    let run = |lang: &str| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_technolog"));
        command.args(["check", "program.nc", "--setting", "setting.yaml", "--lang", lang]).current_dir(&folder);
        String::from_utf8(command.env("COLUMNS", "80").output().unwrap().stdout).unwrap()
    };
    let (uk, en) = (run("uk"), run("en"));
    // A count of each severity, and the motions by their words.
    assert!(uk.contains("4 помилки, 3 попередження, 3 зауваження"), "{uk}");
    assert!(en.contains("4 errors, 3 warnings, 3 notes"), "{en}");
    assert!(uk.contains("   8 N30   шпиндель за год. стрілкою S2000\n"), "{uk}");
    assert!(en.contains("   8 N30   spindle clockwise S2000\n"), "{en}");
    let motions = uk.lines().skip_while(|line| !line.starts_with("Рухи")).skip(1).take_while(|line| !line.is_empty());
    for line in motions.filter(|line| line.starts_with(' ')) {
        assert!(!line.contains(|sign: char| sign.is_ascii_lowercase()), "{line}");
    }
    for page in [uk, en] {
        let wide: Vec<&str> = page.lines().filter(|line| line.chars().count() > 80).collect();
        assert!(wide.is_empty(), "{wide:?}");
    }
}

/// The same fault in every block is told once, with how many there are and where; the form for programs has them all.
#[test]
fn a_fault_of_every_block_is_told_once() {
    let folder = folder("faults");
    let program: String = (1..=2_000).map(|number| format!("N{number} X1 Q9 Ж3\n")).collect();
    fs::write(folder.join("program.nc"), format!("%\nO1\n{program}M30\n%\n")).unwrap();
    for control in ["linuxcnc", "fanuc"] {
        for format in ["text", "markdown", "html"] {
            let run = command(&folder, &["check", "program.nc", "--control", control, "--format", format], b"");
            assert_eq!(run.code, Some(1), "{}", run.beside);
            let shown = run.answer.matches("program.nc:").count();
            assert!((1..=3).contains(&shown), "{control} {format}: {}", run.answer);
            assert!(run.answer.contains("(and 1999 more, lines 4, 5, 6, "), "{control} {format}: {}", run.answer);
            let count = run.answer.lines().rfind(|line| line.contains("errors")).unwrap();
            let counts = count.split(|sign: char| !sign.is_ascii_digit()).filter_map(|one| one.parse::<usize>().ok());
            assert!(counts.sum::<usize>() >= 2_000, "{count}");
        }
        let run = command(&folder, &["check", "program.nc", "--control", control, "--format", "json"], b"");
        let answer: serde_json::Value = serde_json::from_str(&run.answer).unwrap();
        assert!(answer["findings"].as_array().unwrap().len() >= 2_000);
    }
}
