//! Every part of `tests/bad` is refused as its `.expected` file says.
//!
//! `<fault>.expected` begins with the exit code, `exit 2`, and then names every mistake on a line of its own:
//! `line:column code`, followed where it matters by words that the message or the remedy must contain. To add a
//! fault, add two files.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use technolog::knowledge::input::text_of;
use technolog::part::read_part;
use technolog_testing::KNOWLEDGE;

/// One file of the folder with what is expected of it.
struct Case {
    name: String,
    path: PathBuf,
    exit: i32,
    mistakes: Vec<Mistake>,
}

/// A mistake as it is expected.
struct Mistake {
    place: String,
    code: String,
    words: String,
}

fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    let mut paths: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let stray = paths.iter().find(|path| !path.with_extension("yaml").exists());
    assert!(stray.is_none(), "{stray:?} expects something of no part");
    paths
        .iter()
        .filter(|path| path.extension().is_some_and(|extension| extension == "yaml"))
        .map(|path| case(path))
        .collect()
}

fn case(path: &Path) -> Case {
    let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
    let beside = path.with_extension("expected");
    let expected = fs::read_to_string(&beside).unwrap_or_else(|error| panic!("{}: {error}", beside.display()));
    let mut lines = expected.lines();
    let exit = lines.next().and_then(|line| line.strip_prefix("exit ")).and_then(|code| code.parse().ok());
    let mistakes = lines.map(|line| {
        let mut words = line.splitn(3, ' ').map(str::to_owned);
        let mut next = || words.next().unwrap_or_default();
        Mistake { place: next(), code: next(), words: next() }
    });
    let exit = exit.unwrap_or_else(|| panic!("{name}: the first line must be `exit 2`"));
    Case { exit, mistakes: mistakes.collect(), path: path.to_path_buf(), name }
}

/// The mistakes of a file: place, code, and all that is said.
fn found(path: &Path) -> Vec<(String, String, String)> {
    let problems = match text_of("part", fs::read(path).unwrap()) {
        Ok(text) => read_part("part", &text, &KNOWLEDGE).err().unwrap_or_default(),
        Err(problem) => vec![problem],
    };
    let place = |line, column| format!("{line}:{column}");
    problems
        .iter()
        .map(|one| {
            let place = one.place.as_ref().map_or_else(|| "-".to_owned(), |it| place(it.line, it.column));
            (place, one.code.to_owned(), one.text(|note| technolog::words::Lang::EN.say(note)))
        })
        .collect()
}

fn technolog(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.env_remove("LANG").args(args).output().unwrap()
}

#[test]
fn every_mistake_is_found_where_it_stands_and_none_is_reported_twice() {
    let cases = cases();
    assert!(cases.len() >= 16);
    for case in cases {
        let found = found(&case.path);
        let short = |place: &str, code: &str| format!("{place} {code}");
        let got: Vec<String> = found.iter().map(|(place, code, _)| short(place, code)).collect();
        let expected: Vec<String> = case.mistakes.iter().map(|one| short(&one.place, &one.code)).collect();
        assert_eq!(got, expected, "{}: {found:#?}", case.name);
        for (mistake, (.., text)) in case.mistakes.iter().zip(&found) {
            assert!(text.contains(&mistake.words), "{}: `{}` is not in `{text}`", case.name, mistake.words);
        }
    }
}

#[test]
fn the_command_names_every_place_and_writes_nothing() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bad_parts");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let answer = folder.join("plan.json");
    for case in cases() {
        let file = case.path.to_str().unwrap();
        let output = technolog(&["plan", file, "--format", "json", "-o", answer.to_str().unwrap()]);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(case.exit), "{}: {stderr}", case.name);
        assert!(stderr.contains(file), "{}: {stderr}", case.name);
        for mistake in &case.mistakes {
            assert!(stderr.contains(&format!("[{}]", mistake.code)), "{}: {stderr}", case.name);
            // Bytes that are no text have no line to show.
            if mistake.code != "not-utf8" {
                assert!(stderr.contains(&format!("{file}:{}", mistake.place)), "{}: {stderr}", case.name);
            }
        }
        assert!(output.stdout.is_empty(), "{}", case.name);
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "{} wrote something", case.name);
    }
}

#[test]
fn a_bad_part_leaves_an_old_answer_as_it_was() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let answer = folder.join("old-plan.json");
    fs::write(&answer, "old").unwrap();
    let cases = cases();
    let file = cases[0].path.to_str().unwrap();
    technolog(&["plan", file, "-o", answer.to_str().unwrap()]);
    assert_eq!(fs::read_to_string(&answer).unwrap(), "old");
}

#[test]
fn a_part_that_is_not_there_is_named_with_a_remedy() {
    for missing in ["nowhere/part.yaml", "tests"] {
        let output = technolog(&["plan", missing, "--lang", "en"]);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(missing) && stderr.contains("help"), "{stderr}");
    }
}
