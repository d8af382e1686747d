//! Whatever shows a turned part tells the same of it: its page, its programs with their check, and its setting sheet end with
//! one exit code.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A control as programs are written for it, and as they are read.
const CONTROLS: [(&str, &str); 3] =
    [("linuxcnc", "linuxcnc-lathe"), ("fanuc", "fanuc-lathe"), ("sinumerik", "sinumerik")];

/// Runs a command; its exit code, its answer and what it says beside it.
fn run(arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    let output =
        command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments).args(["--lang", "en"]).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

/// The exit codes of a part that differ from the one of its operation, each with the command.
fn disagreements(part: &str, controls: &[(&str, &str)]) -> Vec<String> {
    let (wanted, operation, _) = run(&["turn", part, "--show", "operation", "--format", "json"]);
    let operation: serde_json::Value = serde_json::from_str(&operation).unwrap();
    let worked = operation["set_ups"].as_array().unwrap().iter();
    let worked: Vec<String> =
        worked.filter(|one| one["jobs"] != serde_json::json!([])).map(|one| one["number"].to_string()).collect();
    // Without a lathe there is no speed.
    let speed: &[&str] = if operation["machine"].is_null() { &["--spindle", "600"] } else { &[] };
    let mut found = Vec::new();
    let mut hold = |command: String, code: i32| {
        if code != wanted {
            found.push(format!("{part}: {command} ends with {code}, its operation with {wanted}"));
        }
    };
    hold("turn".to_owned(), run(&["turn", part]).0);
    for (control, reader) in controls {
        hold(format!("setting of {control}"), run(&["turn", part, "--show", "setting", "--control", control]).0);
        for (number, set_up) in (1..).zip(&worked) {
            let number = number.to_string();
            let asked = ["turn", part, "--control", control, "--number", &number];
            let (code, _, _) = run(&[&asked[..], &["--show", "cycle"], speed].concat());
            hold(format!("cycles {number} of {control}"), code);
            let (code, program, _) = run(&[&asked[..], &["--show", "program"], speed].concat());
            hold(format!("program {number} of {control}"), code);
            if program.is_empty() {
                continue;
            }
            let name = part.replace(['/', '.'], "-");
            let file = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("agree-{name}-{control}-{number}.nc"));
            fs::write(&file, &program).unwrap();
            let file = file.to_str().unwrap();
            let (code, ..) = run(&["check", file, "--control", reader, "--part", part, "--set-up", set_up]);
            hold(format!("check {number} of {control}"), code);
        }
    }
    found
}

/// Parts that nothing holds, with a thread or a bore that is not made, whose first set-up is not proven, and two that are made whole.
#[test]
fn what_is_wrong_with_a_part_is_wrong_in_every_answer() {
    let parts = [
        "examples/turned-pin.yaml",
        "examples/turned-sleeve.yaml",
        "tests/everyday/cup.yaml",
        "tests/everyday/plug.yaml",
        "tests/everyday/tapped-no-tap.yaml",
        "tests/everyday/tapped-too-deep.yaml",
        "tests/everyday/tube-without-stock.yaml",
        "tests/everyday/run-out-on-seat.yaml",
        "tests/everyday/stud.yaml",
    ];
    let of_part = |(index, part): (usize, &&str)| disagreements(part, &CONTROLS[index % 3..=index % 3]);
    let found: Vec<String> = parts.iter().enumerate().flat_map(of_part).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Every turned part of examples/ and tests/everyday/, for every control: `cargo test --test turning agree:: -- --ignored`.
#[test]
#[ignore = "a minute: every part for every control"]
fn every_answer_of_every_part_agrees() {
    let mut parts = Vec::new();
    for folder in ["examples", "tests/everyday"] {
        let all = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
        let names = all.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        // A shaft without a lathe asks about its ways alone.
        let text =
            |name: &String| fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder).join(name)).unwrap();
        let shaft = |name: &String| name.starts_with("shaft") && text(name).contains("machine:");
        let turned = |name: &String| folder != "examples" || name.starts_with("turned-") || shaft(name);
        parts
            .extend(names.filter(|name| name.ends_with(".yaml")).filter(turned).map(|name| format!("{folder}/{name}")));
    }
    parts.sort();
    assert!(parts.len() > 40, "{parts:?}");
    let found: Vec<String> = parts.iter().flat_map(|part| disagreements(part, &CONTROLS)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}
