//! `technolog audit A --against B`: where two plans differ.

use std::path::Path;
use std::process::Command;

use technolog::audit::stated::Stated;
use technolog::audit::{Auditor, Comparison, read_plan};
use technolog_testing::KNOWLEDGE;

fn root(path: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn right() -> String {
    std::fs::read_to_string(root("tests/audit/right.yaml")).unwrap()
}

fn stated(text: &str) -> Stated {
    let files = |name: &str| std::fs::read_to_string(root("tests/audit").join(name)).map_err(|error| error.to_string());
    read_plan("plan.yaml", text, &KNOWLEDGE, &files).unwrap()
}

fn compared(from: &str, to: &str) -> Comparison {
    let right = right();
    assert_eq!(right.matches(from).count(), 1, "`{from}`");
    let auditor = Auditor::new(&KNOWLEDGE).unwrap();
    auditor.compare(&stated(&right), &stated(&right.replacen(from, to, 1))).unwrap()
}

#[test]
fn a_plan_beside_itself_has_no_difference_and_costs_nothing_more() {
    let text = right();
    let same = Auditor::new(&KNOWLEDGE).unwrap().compare(&stated(&text), &stated(&text)).unwrap();
    assert_eq!(same.differences, []);
    assert!(!same.costs.is_empty() && same.costs.iter().all(|cost| cost.more == Some(0.0)), "{:?}", same.costs);
}

#[test]
fn every_changed_figure_and_name_is_told_with_both_values() {
    for (from, to, what, a, b) in
        [("distance: 283", "distance: 300", "distance", "283", "300"), ("screw: ", "screw: M", "screw", "", "")]
    {
        let found = compared(from, to);
        let [one] = &found.differences[..] else { panic!("{from}: {:?}", found.differences) };
        assert_eq!(one.key, what);
        if !a.is_empty() {
            assert_eq!((one.a.as_deref(), one.b.as_deref()), (Some(a), Some(b)));
        }
    }
    // The same number written otherwise is the same.
    assert_eq!(compared("distance: 283", "distance: 283.0").differences, []);
}

#[test]
fn rows_in_another_place_are_matched_by_what_they_do() {
    let text = right();
    let rows: Vec<&str> = text.lines().filter(|line| line.trim_start().starts_with("- {row:")).collect();
    // Two rows exchanged: their order differs and nothing else.
    let exchanged = text.replacen(rows[0], "\0", 1).replacen(rows[1], rows[0], 1).replacen('\0', rows[1], 1);
    let auditor = Auditor::new(&KNOWLEDGE).unwrap();
    let found = auditor.compare(&stated(&text), &stated(&exchanged)).unwrap();
    let what: Vec<&str> = found.differences.iter().map(|one| one.key.as_str()).collect();
    assert_eq!(what, ["order"]);
}

#[test]
fn the_worked_example_beside_the_right_plan() {
    for (lang, format) in [("uk", "text"), ("en", "text"), ("en", "markdown"), ("uk", "html"), ("en", "json")] {
        let arguments = ["audit", "examples/appendix-g/plan.yaml", "--against", "tests/audit/right.yaml"];
        let output = Command::new(env!("CARGO_BIN_EXE_technolog"))
            .args(arguments)
            .args(["--lang", lang, "--format", format])
            .current_dir(root(""))
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let text = String::from_utf8(output.stdout).unwrap();
        if format == "json" {
            let read: serde_json::Value = serde_json::from_str(&text).unwrap();
            assert!(read["differences"].as_array().unwrap().len() > 10 && read["costs"].is_array(), "{text}");
        } else {
            insta::assert_snapshot!(format!("audit-against-{format}-{lang}"), text);
        }
    }
}
