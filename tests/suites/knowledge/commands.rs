//! Whole-command tests of `table`, `lookup` and `lint`.
//!
//! What is shown as text is held by snapshots over `tests/small-knowledge`, so that work on the
//! shipped tables does not move them; the contract's questions go to the shipped tables, and planted
//! defects into copies of two of those.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};
use unicode_width::UnicodeWidthStr;

/// The shipped scheme tables, which the planted defects go into.
const SCHEMES: &str = "catalogs/holes/a07-schemes.yaml";
const DECISION: &str = "catalogs/holes/a08-scheme-main-holes-fine.yaml";
/// The row of A.8 that answers the contract's example.
const ROW: &str = r#"{it: "[7..8]", diameter: "(10..15]", centre_tolerance: "(0.05..0.3]", roughness: "Ra 2.5""#;
const EXAMPLE: [&str; 6] = ["lookup", "A.8", "it=7", "diameter=12", "centre_tolerance=0.2", "roughness=Ra 2.5"];

fn technolog(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.current_dir(folder).env_remove("LANG").env_remove("COLUMNS").args(args);
    command
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn run(args: &[&str]) -> Output {
    technolog(&root(), args).output().unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn json_of(args: &[&str], code: i32) -> Value {
    let output = run(&[args, &["--format", "json"]].concat());
    assert_eq!(output.status.code(), Some(code), "{args:?}: {}", stderr(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Exit code and both streams, as a snapshot holds them.
fn shown(output: &Output) -> String {
    let mut text = format!("exit {}\n", output.status.code().unwrap());
    for (name, stream) in [("stdout", stdout(output)), ("stderr", stderr(output))] {
        if !stream.is_empty() {
            text.push_str(&format!("--- {name}\n{stream}"));
        }
    }
    text
}

/// An empty folder for one test.
fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn what_people_see() {
    let cases: &[(&str, &[&str])] = &[
        ("list", &["table"]),
        ("list_in_english", &["table", "--lang", "en"]),
        ("list_csv", &["table", "--format", "csv"]),
        ("table_decision", &["table", "X.2"]),
        ("table_decision_in_english", &["table", "X.2", "--lang", "en"]),
        ("table_catalog", &["table", "X.3"]),
        ("table_csv", &["table", "X.2", "--format", "csv"]),
        ("table_with_numbered_columns", &["table", "X.4"]),
        ("table_unknown", &["table", "X.33"]),
        ("lookup_decision", &["lookup", "X.2", "it=7", "diameter=10"]),
        ("lookup_decision_in_english", &["lookup", "X.2", "it=7", "diameter=10", "--lang", "en"]),
        ("lookup_corrected_row", &["lookup", "X.2", "it=12", "diameter=10.001"]),
        ("lookup_passed_over", &["lookup", "coolant", "speed=150", "material=steel"]),
        ("lookup_in_a_gap", &["lookup", "X.2", "it=7", "diameter=10", "state=cast"]),
        ("lookup_catalog", &["lookup", "X.3", "clearance=8"]),
        ("lookup_catalog_by_list_item", &["lookup", "X.1", "transitions=ream"]),
        ("lookup_catalog_nearest_number", &["lookup", "X.3", "diameter=11"]),
        ("lookup_catalog_nearest_text", &["lookup", "X.3", "designation=К-15"]),
        ("lookup_catalog_nearest_rows", &["lookup", "X.3", "diameter=16", "clearance=5"]),
        (
            "lookup_every_slip_at_once",
            &["lookup", "X.2", "it=99", "diametr=1", "elsewhere=true", "it=7", "what", "state="],
        ),
        ("lookup_slips_in_english", &["--lang", "en", "lookup", "X.2", "it=5", "state=liquid metal"]),
        ("lookup_without_a_query", &["lookup", "X.2"]),
        ("lint_clean", &["lint"]),
        ("lint_clean_in_english", &["lint", "--lang", "en"]),
        ("format_unknown_to_the_command", &["lint", "--format", "csv"]),
        ("no_such_folder", &["table", "--knowledge", "nowhere"]),
    ];
    for (name, args) in cases {
        let args: Vec<&str> = if args.contains(&"--knowledge") {
            args.to_vec()
        } else {
            [*args, &["--knowledge", "tests/small-knowledge"]].concat()
        };
        insta::assert_snapshot!(*name, shown(&run(&args)));
    }
}

#[test]
fn help_is_in_the_language_of_the_answers() {
    for (args, word) in [
        (&["--help"][..], "Використання:"),
        (&["lookup", "--help"], "з поясненням відповіді"),
        (&["lookup", "--help", "--lang", "en"], "with the reason for its answer"),
        (&["--lang=en", "--help"], "Usage:"),
    ] {
        let output = run(args);
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        assert!(stdout(&output).contains(word), "{args:?}: {}", stdout(&output));
    }
    for args in [&["bogus"][..], &[], &["table", "--lang", "fr"], &["lookup"]] {
        assert_eq!(run(args).status.code(), Some(2), "{args:?}");
    }
}

#[test]
fn the_language_comes_from_lang_unless_it_is_named() {
    for (variable, option, word) in [
        ("en_US.UTF-8", None, "Result: 32"),
        ("en_US.UTF-8", Some("uk"), "Результат: 32"),
        ("uk_UA.UTF-8", None, "Результат: 32"),
        ("C", None, "Результат: 32"),
        ("C", Some("en"), "Result: 32"),
    ] {
        let mut command = technolog(&root(), &EXAMPLE);
        command.env("LANG", variable).args(option.map(|lang| format!("--lang={lang}")));
        let output = command.output().unwrap();
        assert!(stdout(&output).contains(word), "{variable} {option:?}: {}", stdout(&output));
    }
}

#[test]
fn the_shipped_tables_answer_the_contract() {
    let cases: &[(&[&str], i32, Value)] = &[
        (&EXAMPLE, 0, json!(["32"])),
        (&["lookup", "а.8", "it=IT7", "diameter=12", "centre_tolerance=0.2", "roughness=Ra2.5"], 0, json!(["32"])),
        (
            &["lookup", "A.9", "it=13", "diameter=20", "centre_tolerance=0.46", "roughness=Ra 12.5"],
            0,
            json!(["01", "04"]),
        ),
        (&["lookup", "A.8", "it=9", "diameter=5", "centre_tolerance=0.02", "roughness=Ra 2.5"], 1, json!([])),
        (&["lookup", "A.11", "diameter=10"], 0, json!(["035-2300-1273"])),
        (&["lookup", "A.11", "diameter=10.0", "length=135"], 0, json!(["035-2300-1273"])),
        (&["lookup", "A.11", "diameter=10.03"], 1, json!([])),
        (&["lookup", "A.7", "scheme=04"], 0, json!(["drill", "rough-bore"])),
        (&["lookup", "A.3", "method=tap"], 0, json!([{"thread_grade": "6H", "ra_coarsest": 6.3, "ra_finest": 3.2}])),
        // Micrometres stay micrometres.
        (&["lookup", "it-grades", "it=7", "diameter=12"], 0, json!([18])),
    ];
    for (args, code, result) in cases {
        assert_eq!(json_of(args, *code)["result"], *result, "{args:?}");
    }
}

/// The example of a question with missing keys answers when it is followed.
#[test]
fn an_example_of_missing_keys_is_answered() {
    for asked in [
        &["A.8"][..],
        &["A.8", "it=7"],
        &["A.9", "state=cast-or-pre-machined"],
        &["drilling-feed"],
        &["drilling-feed", "material_group=aluminium-alloy"],
        &["tool-life"],
        &["cutting-speed"],
        &["it-grades", "it=7"],
    ] {
        let asked = [&["lookup"], asked].concat();
        let output = run(&[&asked[..], &["--lang", "en"]].concat());
        let said = String::from_utf8(output.stderr).unwrap();
        let example =
            said.lines().find_map(|line| line.split_once("add, for example, ")).unwrap_or_else(|| panic!("{said}")).1;
        // The pairs as a shell would take them.
        let mut pairs: Vec<String> = vec![String::new()];
        let mut quoted = false;
        for letter in example.chars() {
            match letter {
                '"' => quoted = !quoted,
                ' ' if !quoted => pairs.push(String::new()),
                letter => pairs.last_mut().unwrap().push(letter),
            }
        }
        let whole: Vec<&str> = asked.iter().copied().chain(pairs.iter().map(String::as_str)).collect();
        assert_eq!(run(&whole).status.code(), Some(0), "{whole:?}");
    }
}

#[test]
fn fields_of_a_catalog_are_compared_as_what_they_are() {
    let cases: &[(&str, &[&str], Value)] = &[
        ("numbers as numbers", &["diameter=16.0"], json!(["К-16"])),
        ("micrometres", &["clearance=5"], json!(["К-10"])),
        ("a truth value left out is no", &["coated=false"], json!(["К-10", "К-16"])),
        ("letters that look alike", &["designation=K-12"], json!(["К-12"])),
        ("all keys together", &["angle=118", "clearance=8"], json!(["К-16"])),
        ("no key at all", &[], json!(["К-10", "К-12", "К-16"])),
    ];
    for (name, query, result) in cases {
        let args = [&["--knowledge", "tests/small-knowledge", "lookup", "X.3"], *query].concat();
        let answer = json_of(&args, 0);
        assert_eq!(answer["result"], *result, "{name}");
        assert_eq!(answer["rows"].as_array().unwrap().len(), result.as_array().unwrap().len(), "{name}");
    }
    let missed = json_of(&["--knowledge", "tests/small-knowledge", "lookup", "X.3", "diameter=11"], 1);
    assert_eq!(missed["nearest_values"], json!({"diameter": [10, 12.5, 16]}));
}

#[test]
fn many_rejected_rows_are_counted_unless_all_are_asked_for() {
    let few = stdout(&run(&EXAMPLE));
    let all = stdout(&run(&[&EXAMPLE[..], &["--all"]].concat()));
    // The last table: a line for each rejected row, or one for each key that rejects some.
    let listed = |text: &str| {
        text.lines().rev().take_while(|line| !line.starts_with("---")).filter(|line| line.contains(" | ")).count()
    };
    let rejected = json_of(&EXAMPLE, 0)["rejected"].as_array().unwrap().len();
    assert!(rejected > 12);
    assert!(listed(&few) < 12, "{few}");
    assert_eq!(listed(&all), rejected, "{all}");
}

#[test]
fn an_answer_as_json_gives_its_whole_reason() {
    let answer = json_of(&EXAMPLE, 0);
    assert_eq!(answer["table"], "A.8");
    assert_eq!(answer["source"], "seed");
    assert_eq!(answer["inputs"]["diameter"], 12);
    assert_eq!(answer["inputs"]["state"], "solid");
    assert_eq!(answer["outputs"], json!({"schemes": ["32"], "finish_elsewhere": false}));
    let row = &answer["rows"][0];
    assert_eq!(row["diameter"], "(10..15]");
    assert_eq!(row["schemes"], json!(["32"]));
    let total = json_of(&["table", "A.8"], 0)["rows"].as_array().unwrap().len();
    let rejected = answer["rejected"].as_array().unwrap();
    assert_eq!(rejected.len() + 1, total);
    assert!(rejected.iter().all(|it| it["row"].is_u64() && it["column"].is_string() && it["cell"].is_string()));

    let gap = json_of(&["lookup", "A.8", "it=9", "diameter=5", "centre_tolerance=0.02", "roughness=Ra 2.5"], 1);
    assert!(gap["uncovered"].as_str().is_some_and(|reason| !reason.is_empty()), "{gap}");
    assert!(!gap["nearest"].as_array().unwrap().is_empty());
    assert!(gap["row"].is_null());
}

#[test]
fn a_table_as_json_has_every_field_of_every_row() {
    let table = json_of(&["table", "a.8", "--lang", "en"], 0);
    assert_eq!(table["table"], "A.8");
    assert_eq!(table["title"], "Schemes for main holes, IT 6 to 10");
    let names: Vec<&str> =
        table["columns"].as_array().unwrap().iter().map(|column| column["name"].as_str().unwrap()).collect();
    for row in table["rows"].as_array().unwrap() {
        for name in names.iter().chain(&["source", "place"]) {
            assert!(row.get(name).is_some(), "{row} has no {name}");
        }
    }
    let corrected = table["rows"].as_array().unwrap().iter().find_map(|row| row.get("corrections")).unwrap();
    assert!(corrected["roughness"]["printed"].is_string(), "{corrected}");
    // A cell that is left out is null, not absent.
    let schemes = json_of(&["table", "A.7"], 0);
    assert!(schemes["rows"][0]["tapping"].is_null());
    assert_eq!(schemes["rows"][0]["transitions"], json!(["drill"]));
}

#[test]
fn an_interval_without_an_end_is_shown_by_its_beginning() {
    for (table, shown) in [("second-opinion", "≥ 0\n"), ("stock-for-elsewhere", "> 0\n")] {
        let text = stdout(&run(&["table", table]));
        assert!(text.contains(shown), "{table}: {text}");
    }
}

#[test]
fn no_table_is_wider_than_the_screen_and_all_are_listed() {
    let list = json_of(&["table"], 0);
    let list = list.as_array().unwrap();
    assert!(list.len() >= 30);
    for entry in list {
        let id = entry["table"].as_str().unwrap();
        for key in ["title", "kind", "file"] {
            assert!(entry[key].is_string(), "{entry}");
        }
        let output = run(&["table", id]);
        assert_eq!(output.status.code(), Some(0), "{id}");
        let text = stdout(&output);
        for line in text.lines() {
            assert!(line.width() <= 120, "{id}: {line}");
        }
    }
}

#[test]
fn an_answer_goes_whole_into_its_file() {
    let folder = scratch("output");
    let file = folder.join("answer.json");
    fs::write(&file, "old").unwrap();
    let args = [&EXAMPLE[..], &["--format", "json", "-o", "answer.json"]].concat();
    let output = technolog(&folder, &args).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(output.stdout.is_empty());
    let written: Value = serde_json::from_slice(&fs::read(&file).unwrap()).unwrap();
    assert_eq!(written["result"], json!(["32"]));
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "a temporary file is left");

    let output = technolog(&folder, &["table", "-o", "nowhere/answer.txt"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("nowhere/answer.txt"), "{}", stderr(&output));
    let output = technolog(&folder, &["table", "-o", "."]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let mut command = technolog(&root(), &["table", "A.11", "--format", "json"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), String::new()));
}

/// A knowledge folder with copies of A.7 and A.8, where texts are replaced in lines that hold others.
fn planted(name: &str, changes: &[Change]) -> PathBuf {
    let folder = scratch(name);
    for file in [SCHEMES, DECISION] {
        let mut text = fs::read_to_string(root().join(file)).unwrap();
        for change in changes.iter().filter(|change| change.file == file) {
            let line = text.lines().find(|line| line.contains(change.line)).unwrap().to_owned();
            let new = line.replacen(change.from, change.to, 1);
            assert_ne!(line, new, "{name}: nothing to change");
            let new = if new.trim().is_empty() { String::new() } else { new + "\n" };
            text = text.replacen(&(line + "\n"), &new, 1);
        }
        let copy = folder.join("base").join(file);
        fs::create_dir_all(copy.parent().unwrap()).unwrap();
        fs::write(copy, text).unwrap();
    }
    fs::create_dir_all(folder.join("base/rules")).unwrap();
    folder
}

struct Change {
    file: &'static str,
    /// Of the line to change.
    line: &'static str,
    from: &'static str,
    to: &'static str,
}

/// Where a text stands in a planted file: `file:line:column`, in characters.
fn place_of(folder: &Path, file: &str, line: &str, text: &str) -> (String, usize, usize) {
    let content = fs::read_to_string(folder.join("base").join(file)).unwrap();
    let (number, line) = content.lines().enumerate().find(|(_, it)| it.contains(line)).unwrap();
    let column = line[..line.find(text).unwrap()].chars().count();
    (format!("base/{file}"), number + 1, column + 1)
}

#[test]
fn a_sound_copy_is_clean() {
    let folder = planted("clean", &[]);
    let output = technolog(&folder, &["lint", "--knowledge", "base", "--lang", "en"]).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stdout(&output));
    assert!(stdout(&output).starts_with("2 tables, "), "{}", stdout(&output));
    assert!(stdout(&output).ends_with(" 0 findings\n"), "{}", stdout(&output));
}

#[test]
fn every_planted_defect_is_found_where_it_stands() {
    let first_row = r#"{it: "[9..10]", diameter: "<= 6""#;
    let row = |from, to| Change { file: DECISION, line: ROW, from, to };
    // name, change, exit code, code of the finding, the line and the text it points to, what it must say
    let cases = [
        ("widened", row(r#""(10..15]""#, r#""(6..15]""#), 1, "overlap", r#""(6..15]""#, "\"[7..8]\"", "diameter=6.001"),
        ("typo", row("(10..15]", "(0..1O]"), 2, "bad-test", "(0..1O]", "1O]", "zero may be meant"),
        (
            "dangling",
            row(r#"["32"]"#, r#"["99"]"#),
            1,
            "dangling-reference",
            r#"["99"]"#,
            r#"["99"]"#,
            "has no scheme `99`",
        ),
        (
            "twice",
            row("state: \"solid\"", "state: \"solid\", state: \"solid\""),
            2,
            "duplicate-key",
            "state: \"solid\", state",
            "state: \"solid\", sch",
            "`state` appears twice",
        ),
        (
            "unit",
            Change { file: DECISION, line: "{name: diameter", from: "unit: mm", to: "unit: kg" },
            2,
            "wrong-unit",
            "{name: diameter",
            "kg",
            "cannot be in `kg`",
        ),
    ];
    for (name, change, exit, code, line, text, says) in cases {
        let folder = planted(name, &[change]);
        finds(&folder, exit, code, place_of(&folder, DECISION, line, text), says);
    }

    let folder = planted("removed", &[]);
    let file = folder.join("base").join(DECISION);
    let kept: Vec<String> = fs::read_to_string(&file)
        .unwrap()
        .lines()
        .filter(|line| !line.contains(ROW))
        .map(|line| format!("{line}\n"))
        .collect();
    fs::write(&file, kept.concat()).unwrap();
    let (file, line, _) = place_of(&folder, DECISION, first_row, "{");
    finds(&folder, 1, "gap", (file, line, 1), "it=7 diameter=10.001");
}

/// Lint says it at the place, as text with the line and a caret, and as JSON.
fn finds(folder: &Path, exit: i32, code: &str, (file, line, column): (String, usize, usize), says: &str) {
    let output = technolog(folder, &["lint", "--knowledge", "base", "--lang", "en"]).output().unwrap();
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(exit), "{text}");
    assert!(text.contains(&format!("error[{code}]")), "{code}: {text}");
    assert!(text.contains(&format!("--> {file}:{line}:{column}\n")), "{code} at {file}:{line}:{column}: {text}");
    assert!(text.contains(says) && text.contains('^'), "{says}: {text}");

    let output =
        technolog(folder, &["lint", "--knowledge", "base", "--format", "json", "--lang", "en"]).output().unwrap();
    assert_eq!(output.status.code(), Some(exit));
    let findings: Value = serde_json::from_slice(&output.stdout).unwrap();
    let found = findings.as_array().unwrap().iter().find(|it| it["code"] == code && it["line"] == line).unwrap();
    assert_eq!((&found["file"], &found["column"]), (&json!(file), &json!(column)));
    assert_eq!(found["severity"], "error");
    assert!(found["message"].as_str().unwrap().contains(says), "{found}");
}

/// What refers to a table that could not be read is no fault of its own: the file is mended first.
#[test]
fn a_broken_file_is_one_finding_though_others_refer_to_it() {
    let unreadable = Change { file: SCHEMES, line: "scheme: \"09\"", from: "source: seed", to: "source: sed" };
    let folder = planted("referred-to", &[unreadable]);
    let output = technolog(&folder, &["lint", "--knowledge", "base", "--lang", "en"]).output().unwrap();
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("`sed`") && text.ends_with(" 1 finding\n"), "{text}");
}

#[test]
fn sound_tables_are_proven_beside_broken_ones_and_nothing_else_starts() {
    let folder = planted(
        "both",
        &[
            Change { file: DECISION, line: ROW, from: "(10..15]", to: "(0..1O]" },
            Change { file: SCHEMES, line: "scheme: \"09\"", from: "\"09\"", to: "\"08\"" },
        ],
    );
    let output = technolog(&folder, &["lint", "--knowledge", "base"]).output().unwrap();
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("[bad-test]") && text.contains("[duplicate-row]"), "{text}");
    // Another command shows the load problem, with the line and the caret, and does not go on.
    let output = technolog(&folder, &["table", "--knowledge", "base"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert!(stderr(&output).contains("[bad-test]") && stderr(&output).contains('^'), "{}", stderr(&output));
}

#[test]
fn rows_that_contradict_each_other_give_no_answer() {
    let change = Change { file: DECISION, line: ROW, from: r#""(10..15]""#, to: r#""(6..15]""# };
    let folder = planted("contradiction", &[change]);
    let args =
        ["lookup", "A.8", "it=7", "diameter=8", "centre_tolerance=0.2", "roughness=Ra 2.5", "--knowledge", "base"];
    let output = technolog(&folder, &args).output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{}", stdout(&output));
    assert!(stderr(&output).contains("technolog lint"), "{}", stderr(&output));
}

#[test]
fn strange_arguments_are_refused_without_a_panic() {
    for args in [
        &["table", ""][..],
        &["table", "  "],
        &["table", "日本"],
        &["lookup", "A.8", ""],
        &["lookup", "A.8", "="],
        &["lookup", "A.8", "it="],
        &["lookup", "A.8", "it=7\nx"],
        &["lookup", "A.8", "it=99999999999999999999"],
        &["lookup", "A.8", "diameter=-1", "it=7"],
        &["lookup", "A.11", "diameter=9999999999999"],
        &["lookup", "A.11", "ключ=1"],
        &["table", "--knowledge", "Cargo.toml"],
        &["table", "A.8", "A.9"],
    ] {
        let output = run(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}: {}", shown(&output));
        assert!(!stderr(&output).is_empty() && !stderr(&output).contains("panicked"), "{args:?}: {}", shown(&output));
    }
}
