//! `technolog audit --marks FILE`: a score by a lecturer's scheme.

use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;

use proptest::prelude::*;
use technolog::audit::marks::{DeductedBy, MarkingScheme, Marks, read_scheme};
use technolog::audit::{Audit, PlanPart, audit, read_plan, rules};
use technolog::words::Lang;
use technolog_testing::KNOWLEDGE;

fn root(path: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn known() -> Vec<String> {
    rules::all().map(|rule| rule.id.to_owned()).chain(Lang::codes()).collect()
}

fn scheme(text: &str) -> MarkingScheme {
    read_scheme("marks.yaml", text, &known().iter().map(String::as_str).collect::<Vec<_>>()).unwrap()
}

fn audited_text(text: &str) -> Audit {
    let files = |name: &str| std::fs::read_to_string(root("tests/audit").join(name)).map_err(|error| error.to_string());
    audit(&read_plan("plan.yaml", text, &KNOWLEDGE, &files).unwrap(), &KNOWLEDGE).unwrap()
}

/// The plan without a slip except for one: the clamping force twice too large, and with it the force per clamp.
fn audited() -> Audit {
    let text = std::fs::read_to_string(root("tests/audit/right.yaml")).unwrap();
    let text =
        text.replacen("force: 1488", "force: 2976", 1).replacen("force_per_clamp: 744", "force_per_clamp: 1488", 1);
    audited_text(&text)
}

fn mark_of(marks: &Marks, field: &str) -> (f64, DeductedBy, bool) {
    let one = marks.deductions.iter().find(|one| one.field == field).unwrap();
    (one.points, one.by, one.capped)
}

#[test]
fn the_most_particular_word_of_the_scheme_holds() {
    let audit = audited();
    // (scheme, of the slip, of its consequence, points of the whole; the plan has three doubtful conditions and one
    // doubtful clamping beside)
    for (text, force, per_clamp, points) in [
        (
            "{points: 10, missing: {}, deduct: {wrong: 3}}",
            (3.0, DeductedBy::Severity, false),
            (0.0, DeductedBy::Consequence, false),
            7.0,
        ),
        (
            "{points: 10, missing: {}, deduct: {wrong: 3}, consequences: 0.5}",
            (3.0, DeductedBy::Severity, false),
            (0.5, DeductedBy::Consequence, false),
            6.5,
        ),
        (
            "{points: 10, missing: {}, deduct: {wrong: 3}, consequences: 0.5, slip_at_most: 3.2}",
            (3.0, DeductedBy::Severity, false),
            (0.2, DeductedBy::Consequence, true),
            6.8,
        ),
        (
            "{points: 10, missing: {}, deduct: {wrong: 3}, sections: {clamping: {wrong: 2}}}",
            (2.0, DeductedBy::Section, false),
            (0.0, DeductedBy::Consequence, false),
            8.0,
        ),
        (
            "{points: 10, missing: {}, deduct: {wrong: 3}, sections: {clamping: {wrong: 2}}, rules: {clamping-force: 1}}",
            (1.0, DeductedBy::Rule, false),
            (0.0, DeductedBy::Consequence, false),
            9.0,
        ),
        (
            "{points: 10, missing: {}, deduct: {wrong: 3}, sections: {clamping: {at_most: 2}}}",
            (2.0, DeductedBy::Severity, true),
            (0.0, DeductedBy::Consequence, false),
            8.0,
        ),
        (
            "{points: 2, missing: {}, deduct: {wrong: 3}}",
            (2.0, DeductedBy::Severity, true),
            (0.0, DeductedBy::Consequence, false),
            0.0,
        ),
        (
            "{points: 10, missing: {}, deduct: {wrong: 1, doubtful: 0.25}}",
            (1.0, DeductedBy::Severity, false),
            (0.0, DeductedBy::Consequence, false),
            8.0,
        ),
    ] {
        let marks = scheme(text).mark(&audit);
        assert_eq!(mark_of(&marks, "clamping.force"), force, "{text}");
        assert_eq!(mark_of(&marks, "clamping.force_per_clamp"), per_clamp, "{text}");
        assert!((marks.points - points).abs() < 1e-9, "{text}: {}", marks.points);
    }
}

/// A root that is only doubtful costs what it does: the wrong figure that follows from it is paid once, beyond what the root costs.
#[test]
fn a_consequence_graver_than_its_root_is_paid() {
    let mut audit = audited();
    for finding in &mut audit.findings {
        if finding.field == "clamping.force" {
            finding.severity = technolog::note::Severity::Doubtful;
        }
    }
    for (text, root, consequence) in [
        ("{points: 10, missing: {}, deduct: {wrong: 3}}", 0.0, 3.0),
        ("{points: 10, missing: {}, deduct: {wrong: 3, doubtful: 1}}", 1.0, 2.0),
        ("{points: 10, missing: {}, deduct: {doubtful: 1}}", 1.0, 0.0),
    ] {
        let marks = scheme(text).mark(&audit);
        let points = [mark_of(&marks, "clamping.force").0, mark_of(&marks, "clamping.force_per_clamp").0];
        assert_eq!(points, [root, consequence], "{text}");
    }
}

#[test]
fn a_plan_passes_from_the_threshold_on() {
    let audit = audited();
    for (pass, passed) in [("6.9", Some(true)), ("7", Some(true)), ("7.1", Some(false)), ("", None)] {
        let marks = scheme(&format!("{{points: 10, missing: {{}}, pass: {pass}, deduct: {{wrong: 3}}}}")).mark(&audit);
        assert_eq!(marks.passed, passed, "{pass}");
    }
}

static AUDITED: LazyLock<Audit> = LazyLock::new(audited);

proptest! {
    #![proptest_config(technolog_laws::cases!(256))]

    /// What is left and what was taken off are the whole, and no section costs more than its cap.
    #[test]
    fn points_add_up(points in 0_u32..200, error in 0_u32..20, wrong in 0_u32..20, doubtful in 0_u32..5, cap in 0_u32..30) {
        let text = format!("{{points: {points}, deduct: {{error: {error}, wrong: {wrong}, doubtful: {doubtful}}}, sections: {{conditions: {{at_most: {cap}}}}}}}");
        let marks = scheme(&text).mark(&AUDITED);
        let taken: f64 = marks.deductions.iter().map(|one| one.points).sum();
        let missing: f64 = marks.missing.iter().map(|one| one.points).sum();
        prop_assert!((marks.points + missing + taken - f64::from(points)).abs() < 1e-9, "{marks:?}");
        let conditions = marks.deductions.iter().filter(|one| one.section == technolog::audit::Section::Conditions);
        prop_assert!(conditions.map(|one| one.points).sum::<f64>() <= f64::from(cap));
    }
}

fn command(arguments: &[&str]) -> (String, i32) {
    let output = Command::new(env!("CARGO_BIN_EXE_technolog")).args(arguments).current_dir(root("")).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap();
    (text, output.status.code().unwrap())
}

const PLAN: &str = "examples/appendix-g/plan.yaml";

#[test]
fn the_marks_of_the_worked_example() {
    for lang in ["uk", "en"] {
        let (text, code) = command(&["audit", PLAN, "--marks", "examples/marks.yaml", "--lang", lang]);
        assert_eq!(code, 1);
        // The audit itself has its snapshot in tests/suites/audit/faults.rs.
        let (_, marks) = text.split_once("\nКурсовий проєкт: ").unwrap();
        insta::assert_snapshot!(format!("audit-marks-{lang}"), marks);
    }
}

/// A scheme can name the rule of any finding.
#[test]
fn the_rule_of_every_finding_can_be_named() {
    let (text, _) = command(&["audit", PLAN, "--format", "json"]);
    let audit: serde_json::Value = serde_json::from_str(&text).unwrap();
    let known = known();
    for finding in audit["findings"].as_array().unwrap() {
        let rule = finding["rule"].as_str().unwrap();
        assert!(known.iter().any(|one| one == rule), "{rule}");
    }
}

#[test]
fn a_bad_scheme_tells_all_its_mistakes() {
    let (text, code) = command(&["audit", PLAN, "--marks", "tests/audit/bad-marks.yaml", "--lang", "en"]);
    assert_eq!(code, 2);
    insta::assert_snapshot!("audit-bad-marks", text);
}

#[test]
fn a_folder_has_a_column_of_marks() {
    let (text, code) = command(&["audit", "examples/appendix-g", "--marks", "examples/marks.yaml", "--lang", "en"]);
    assert_eq!(code, 1);
    assert!(text.lines().nth(2).unwrap().trim_end().ends_with(" Marks"), "{text}");
}

/// docs/audit.md shows the example as it is.
#[test]
fn the_page_shows_the_example() {
    let example = std::fs::read_to_string(root("examples/marks.yaml")).unwrap();
    let body: String =
        example.lines().skip_while(|line| line.starts_with('#')).map(|line| line.to_owned() + "\n").collect();
    assert!(std::fs::read_to_string(root("docs/audit.md")).unwrap().contains(&body));
}

fn example() -> MarkingScheme {
    scheme(&std::fs::read_to_string(root("examples/marks.yaml")).unwrap())
}

/// By the shipped example an empty plan has no point, an honest whole one all, and a part of one those of its part.
#[test]
fn an_empty_plan_has_no_point_and_an_honest_one_all() {
    let empty = audited_text("part: ../../examples/plate.yaml\n");
    assert_eq!(example().mark(&empty).points, 0.0);
    let whole = std::fs::read_to_string(root("tests/audit/right-formula.yaml")).unwrap();
    assert_eq!(example().mark(&audited_text(&whole)).points, 100.0);
    let (without_program, _) = whole.split_once("program:").unwrap();
    assert_eq!(example().mark(&audited_text(without_program)).points, 80.0);
    let (without_clamping, _) = whole.split_once("clamping:").unwrap();
    assert_eq!(example().mark(&audited_text(without_clamping)).points, 70.0);
}

/// A plan is held to what it says it covers, unless the scheme says what the work is to cover.
#[test]
fn a_plan_of_a_part_has_all_points_within_its_scope() {
    for (name, text) in super::honest::plans().into_iter().filter(|(_, text)| text.contains("\nscope: ")) {
        let audit = super::honest::audited(&name, &text);
        let marks = example().mark(&audit);
        assert_eq!(marks.points, 100.0, "{name}: {marks:?}");
        assert!(!marks.uncovered.is_empty(), "{name}");
        let whole = MarkingScheme { scope: Some(vec![PlanPart::Holes, PlanPart::Clamping]), ..example() }.mark(&audit);
        assert!(whole.points < 100.0 && whole.uncovered.is_empty(), "{name}: {whole:?}");
    }
}

/// What is worth knowing costs nothing, and a doubtful choice only what the scheme asks for it.
#[test]
fn a_doubtful_choice_costs_what_is_asked_for_it() {
    let audit = audited();
    for (text, points) in [
        ("{points: 10, missing: {}, deduct: {wrong: 0}}", 10.0),
        ("{points: 10, missing: {}, rules: {audit-load-low: {wrong: 2}}}", 10.0),
        ("{points: 10, missing: {}, rules: {audit-load-low: {doubtful: 1}}}", 6.0),
        ("{points: 10, missing: {}, rules: {audit-missing: 1}}", 10.0),
        ("{points: 10, missing: {program: 3}}", 7.0),
        ("{points: 10}", 8.0),
        ("{points: 10, scope: [holes, tools]}", 10.0),
    ] {
        assert_eq!(scheme(text).mark(&audit).points, points, "{text}");
    }
}
