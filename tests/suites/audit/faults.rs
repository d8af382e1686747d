//! `technolog audit`: hand-written plans with one fault each; plans of the program, which have none; Appendix Г,
//! which has many.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use proptest::prelude::*;
use serde::Deserialize;
use technolog::audit::{Audit, AuditFinding, read_plan};
use technolog::note::Severity;
use technolog::plan::CuttingMethod;
use technolog::words::Lang;
use technolog_testing::{AUDITOR, KNOWLEDGE, planned, read};

/// A change of a plan without a slip.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Fault {
    name: String,
    from: String,
    to: String,
    /// Further changes of the same fault.
    #[serde(default)]
    and: Vec<Change>,
    /// `severity rule field` of every slip.
    finds: Vec<String>,
    /// Fields that are wrong because of it; absent: whatever they are.
    #[serde(default)]
    follows: Vec<String>,
    /// Whether figures after it stay as they were, so that they are fine or wrong as it may be.
    #[serde(default)]
    stay: bool,
    /// Whether other slips may be said beside.
    #[serde(default)]
    also: bool,
    /// Whether the slip is told at another line than the changed one.
    #[serde(default)]
    elsewhere: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Change {
    from: String,
    to: String,
}

/// A plan without a slip, the faults that are made in it, and what is said of it as it is.
struct Case {
    right: &'static str,
    faults: &'static str,
    known: &'static [&'static str],
}

const CASES: [Case; 3] = [
    Case { right: "right.yaml", faults: "faults.yaml", known: &METHOD },
    Case { right: "right-formula.yaml", faults: "faults-formula.yaml", known: &[] },
    Case { right: "right-zone.yaml", faults: "faults-zone.yaml", known: &[] },
];

fn case_file(name: &str) -> String {
    std::fs::read_to_string(root("tests/audit").join(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// What is doubtful of the book's method itself, so of every plan by it: 2638 of 4485 N, 42.1 of 76.7 N·m, 1.88 of 2.84.
const METHOD: [&str; 4] = [
    "doubtful audit-load-low conditions.1.torque",
    "doubtful audit-load-low conditions.3.force",
    "doubtful audit-load-low conditions.3.torque",
    "doubtful audit-load-low clamping.torque",
];

fn root(path: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn audited(text: &str) -> Audit {
    let files = |name: &str| std::fs::read_to_string(root("tests/audit").join(name)).map_err(|error| error.to_string());
    let stated = read_plan("plan.yaml", text, &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{why:?}"));
    AUDITOR.audit(&stated).unwrap()
}

/// The slips themselves: neither notes nor what follows from others.
fn slips(audit: &Audit) -> impl Iterator<Item = &AuditFinding> {
    audit.findings.iter().filter(|one| one.severity < Severity::Note && one.follows_from.is_empty())
}

fn text_of(finding: &AuditFinding) -> String {
    let severity = format!("{:?}", finding.severity).to_lowercase();
    format!("{severity} {} {}", finding.rule, finding.field)
}

#[test]
fn a_plan_without_a_slip_has_no_finding() {
    for case in CASES {
        let found = audited(&case_file(case.right));
        let grave: Vec<String> =
            found.findings.iter().filter(|one| one.severity < Severity::Note).map(text_of).collect();
        // The book divides force and power by the factor by which it raises the feed (docs/worked-example.md).
        assert_eq!(grave, case.known, "{}", case.right);
    }
}

#[test]
fn every_fault_is_found_at_its_line() {
    let wrong: Vec<String> = CASES.iter().flat_map(faults_not_found).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn faults_not_found(case: &Case) -> Vec<String> {
    let right = case_file(case.right);
    let faults: Vec<Fault> = serde_yaml::from_str(&case_file(case.faults)).unwrap();
    let mut wrong = Vec::new();
    for fault in faults {
        let first = Change { from: fault.from.clone(), to: fault.to.clone() };
        let text = std::iter::once(&first).chain(&fault.and).fold(right.clone(), |text, change| {
            assert_eq!(text.matches(&change.from).count(), 1, "{}: `{}`", fault.name, change.from);
            text.replacen(&change.from, &change.to, 1)
        });
        let line = right.lines().zip(text.lines()).position(|(a, b)| a != b).unwrap() + 1;
        let audit = audited(&text);
        let found: Vec<&AuditFinding> = slips(&audit).collect();
        let method = |one: &String| !case.known.contains(&one.as_str()) && !one.contains(" audit-load-");
        let reported: BTreeSet<String> = found.iter().map(|one| text_of(one)).filter(method).collect();
        let expected: BTreeSet<String> = fault.finds.iter().cloned().collect();
        if !(reported == expected || fault.also && reported.is_superset(&expected)) {
            wrong.push(format!("{}: {reported:?}", fault.name));
        }
        let last = line + fault.to.trim_end().matches('\n').count();
        for one in found.iter().filter(|one| fault.finds.contains(&text_of(one))) {
            let at = one.line.map_or(0, |line| line as usize);
            if !fault.elsewhere && !(line..=last).contains(&at) {
                wrong.push(format!("{}: {} at line {at}, not {line}", fault.name, text_of(one)));
            }
        }
        let following: Vec<&str> =
            audit.findings.iter().filter(|one| !one.follows_from.is_empty()).map(|one| one.field.as_str()).collect();
        if !fault.stay && !fault.follows.iter().all(|field| following.contains(&field.as_str())) {
            wrong.push(format!("{}: follow {following:?}", fault.name));
        }
    }
    wrong
}

/// A sum of so many wrong figures that not every mixture of stated and right ones is tried: 3^8 of three values each are more than 4096.
#[test]
fn what_is_not_tried_is_said() {
    let untried = |rows: u32| {
        let of = |row: fn(u32) -> String| (1..=rows).map(row).collect::<String>();
        let hole = |at: u32| {
            let x = 40 * i64::from(at) - 200;
            format!(
                "    - {{name: H{at}, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.4, at: [[{x}, 0]]}}\n"
            )
        };
        let row =
            |at: u32| format!("  - {{row: {at}, operation: drill, hole: H{at}, count: 1, diameter: 10, depth: 40}}\n");
        let conditions = |at: u32| {
            format!("  - {{for: {at}, depth_of_cut: 5, rpm: 800, minute_feed: 160, travel: {}, time: 0.5}}\n", 48 + at)
        };
        let plate = "{kind: plate, length: 500, width: 100, thickness: 40}";
        let part =
            format!("  part: P\n  material: steel-45\n  machine: gf2171\n  blank: {plate}\n  holes:\n{}", of(hole));
        let (rows, conditions) = (of(row), of(conditions));
        let text = format!("part:\n{part}route:\n{rows}conditions:\n{conditions}times: {{machine: 99}}\n");
        audited(&text).findings.iter().filter(|one| one.rule == "audit-untried").count()
    };
    assert_eq!([untried(3), untried(8)], [0, 1]);
}

/// Whether the way out is named, and what is missing for a check is said once.
#[test]
fn the_zone_says_what_would_work_and_what_it_does_not_know() {
    let right = case_file("right-zone.yaml");
    let wide = right.replace("width: 300", "width: 640").replace("[200, 100]]", "[200, 310]]");
    let found = audited(&wide);
    let travel = found.findings.iter().find(|one| one.rule == "beyond-travel").unwrap();
    assert!(travel.reasons.iter().any(|why| why.code() == "audit-zone-turned"), "{:?}", travel.reasons);
    // Along both axes wider than the table travels: no turning helps.
    let wider =
        wide.replace("length: 500", "length: 1100").replace("[200, 0]", "[520, 0]").replace("[-200, 0]", "[-520, 0]");
    let found = audited(&wider);
    let travel: Vec<_> = found.findings.iter().filter(|one| one.rule == "beyond-travel").collect();
    assert_eq!(travel.len(), 2);
    assert!(travel.iter().all(|one| one.reasons.is_empty()));
    let unknown = |text: &str| audited(text).findings.iter().filter(|one| one.rule == "audit-zone-unknown").count();
    assert_eq!(unknown(&right), 0);
    assert_eq!(unknown(&right.replace("machine: gf2171", "machine: ir500pmf4")), 1);
}

/// The plan of a part by a method, as JSON and back through the audit.
fn own(part: &technolog::part::Part, method: CuttingMethod) -> Vec<String> {
    let ours = planned(part, method);
    let text = serde_json::to_string_pretty(&ours).unwrap();
    let none = |_: &str| Err("no files here".to_owned());
    let stated = read_plan("plan.json", &text, &KNOWLEDGE, &none).unwrap_or_else(|why| panic!("{why:?}"));
    let audit = AUDITOR.audit_beside(&stated, &ours).unwrap();
    let unmade = audit.findings.iter().filter(|one| one.rule == UNMADE).count();
    assert_eq!(unmade, ours.holes.iter().filter(|hole| hole.transitions.is_empty()).count());
    wrong(&audit)
}

/// An endless number is told as it is written, wherever in a plan of ours it stands.
#[test]
fn an_endless_number_of_a_plan_is_refused_as_it_is_written() {
    let part = technolog_testing::read(
        &std::fs::read_to_string(technolog_testing::root().join("examples/plate.yaml")).unwrap(),
    );
    let text = serde_json::to_string(&planned(&part, CuttingMethod::default())).unwrap();
    let (before, stops) = text.rsplit_once("\"stops\":").unwrap();
    let (to, behind) = stops.split_once("\"at\":[").unwrap();
    let (_, behind) = behind.split_once(',').unwrap();
    let text = format!("{before}\"stops\":{to}\"at\":[1e400,{behind}");
    let none = |_: &str| Err("no files here".to_owned());
    let problems = read_plan("plan.json", &text, &KNOWLEDGE, &none).err().unwrap().problems;
    let texts: Vec<String> = problems.iter().map(|one| one.text(|note| Lang::EN.say(note))).collect();
    assert!(texts.len() == 1 && texts[0].contains("`1e400` is beyond 1000000000"), "{texts:?}");
}

/// A group that we have no route for is unfinished, whoever wrote the plan.
const UNMADE: &str = "audit-hole-not-made-either";

/// What an audit finds wrong, except for groups that we have no route for either.
fn wrong(audit: &Audit) -> Vec<String> {
    let wrong = audit.findings.iter().filter(|one| one.is_wrong() && one.rule != UNMADE);
    wrong.map(|one| format!("{} {:?}", text_of(one), one.note)).collect()
}

#[test]
fn our_own_plans_of_the_examples_have_no_error() {
    let examples = ["plate", "variant-2", "variant-4"].map(|name| format!("examples/{name}.yaml"));
    let parts = ["aluminium", "impossible", "large-bore", "reamed-iron"].map(|name| format!("tests/parts/{name}.yaml"));
    for path in examples.iter().chain(&parts) {
        let part = read(&std::fs::read_to_string(root(path)).unwrap());
        for method in [CuttingMethod::Formula, CuttingMethod::Card] {
            let found = own(&part, method);
            assert!(found.is_empty(), "{path} {method:?}: {found:?}");
        }
    }
}

/// The plan of a part by a method, written by hand and read back.
fn by_hand(text: &str, method: CuttingMethod) -> Vec<String> {
    let ours = planned(&read(text), method);
    let part = |_: &str| Ok(text.to_owned());
    let written = technolog::audit::by_hand(&ours, "part.yaml");
    let stated = read_plan("plan.yaml", &written, &KNOWLEDGE, &part).unwrap_or_else(|why| panic!("{why:?}\n{written}"));
    let audit = AUDITOR.audit_beside(&stated, &ours).unwrap();
    wrong(&audit)
}

#[test]
fn our_plans_written_by_hand_have_no_error() {
    for path in ["examples/plate", "examples/variant-2", "examples/variant-4", "tests/drawings/part"] {
        let text = std::fs::read_to_string(root(&format!("{path}.yaml"))).unwrap();
        let found = by_hand(&text, CuttingMethod::Formula);
        assert!(found.is_empty(), "{path}: {found:?}");
    }
}

/// A hole stepped from both faces: the tool of the last row before the part is turned over is taken up again after it.
#[test]
fn a_tool_is_taken_up_anew_in_the_second_set_up() {
    let text = "part: P\nmaterial: steel-45\nmachine: gf2171\ndatum: {x: left, y: front}\n\
                blank: {kind: plate, length: 1000, width: 200, thickness: 40}\nholes:\n  \
                - {name: H0, centre_tolerance: 0.5, through: true, roughness: Ra 12.5, steps: [{diameter: 10, depth: 1}, \
                {diameter: 7, depth: 38}, {diameter: 10, depth: 39}, {diameter: 12, depth: 40}], \
                at: [[100, 100], [40, 100]]}\n  \
                - {name: H1, centre_tolerance: 0.5, diameter: 20H9, through: true, roughness: Rz 20, \
                groove: {diameter: 21, width: 3, depth: 10}, at: [[300, 100], [240, 100]]}\n";
    let found = by_hand(text, CuttingMethod::Formula);
    assert!(found.is_empty(), "{found:?}");
}

proptest! {
    #![proptest_config(technolog_laws::cases!(12))]

    /// Whatever the holes, what we plan is right by the audit, also as somebody would write it by hand.
    #[test]
    fn our_own_plans_have_no_error(text in technolog_testing::holes::part_files()) {
        let found = own(&read(&text), CuttingMethod::Formula);
        prop_assert!(found.is_empty(), "{found:?}\n{text}");
        let found = by_hand(&text, CuttingMethod::Formula);
        prop_assert!(found.is_empty(), "by hand {found:?}\n{text}");
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(48))]

    /// Whatever is typed into a plan, it is read or refused, and audited without a panic.
    #[test]
    fn a_spoilt_plan_is_told_or_audited(spoils in prop::collection::vec((any::<prop::sample::Index>(), "[-0-9.{}: A-Zа-я]{0,3}"), 1..4)) {
        let mut text = std::fs::read_to_string(root("tests/audit/right.yaml")).unwrap();
        for (at, with) in spoils {
            let places: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
            let at = *at.get(&places);
            let end = text[at..].char_indices().nth(1).map_or(text.len(), |(next, _)| at + next);
            text.replace_range(at..end, &with);
        }
        let files = |name: &str| std::fs::read_to_string(root("tests/audit").join(name)).map_err(|error| error.to_string());
        match read_plan("plan.yaml", &text, &KNOWLEDGE, &files) {
            Ok(stated) => { AUDITOR.audit(&stated).unwrap(); }
            Err(why) => prop_assert!(!why.problems.is_empty()),
        }
    }
}

/// The command's answer and its exit code.
fn command(arguments: &[&str]) -> (String, i32) {
    let output = Command::new(env!("CARGO_BIN_EXE_technolog")).args(arguments).current_dir(root("")).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap();
    (text, output.status.code().unwrap())
}

#[test]
fn the_worked_example_in_both_languages() {
    for lang in ["uk", "en"] {
        let (text, code) = command(&["audit", "examples/appendix-g/plan.yaml", "--lang", lang]);
        assert_eq!(code, 1);
        insta::assert_snapshot!(format!("audit-appendix-g-{lang}"), text);
    }
}

/// What is wrong with the worked example by other readings of it: docs/worked-example.md, examples/appendix-g/README.md.
#[test]
fn the_slips_of_the_worked_example_are_found() {
    let (text, _) = command(&["audit", "examples/appendix-g/plan.yaml", "--format", "json"]);
    let audit: serde_json::Value = serde_json::from_str(&text).unwrap();
    let find = |field: &str| {
        // A figure may be doubtful beside a formula too; it is the right value that is asked for here.
        let mut findings = audit["findings"].as_array().unwrap().iter().filter(|one| one["field"] == field);
        findings.find(|one| !one["right"].is_null()).unwrap_or_else(|| panic!("nothing of {field}"))
    };
    for (field, stated, right) in [
        ("tools.T1.designation", "2317-0103", "035-2317-0103"),
        ("tools.T1.standard", "ОСТ 2420-5-80", "ОСТ 2И20-5-80"),
        ("tools.T3.shank", "cylindrical", "morse"),
        ("conditions.1.feed_taken", "2", "0.195"),
        ("conditions.1.rpm", "2000", "1600"),
        ("conditions.2.feed", "0.25", "0.325"),
        ("conditions.2.speed", "2746", "27.456"),
        ("conditions.2.rpm", "700", "800"),
        ("conditions.3.feed", "0.1235", "1.235"),
        ("conditions.3.speed", "1979", "19.791"),
        ("conditions.3.rpm", "500", "315"),
        ("clamping.torque", "26.52", "42.143"),
        ("tools.T2.overhang", "50", "93"),
        ("tools.T3.holder_used", "45", "50"),
        ("tools.T1.correction", "50", "-102.4"),
        ("tools.T2.correction", "85", "-60.4"),
    ] {
        let one = find(field);
        assert_eq!((one["stated"].as_str(), one["right"].as_str()), (Some(stated), Some(right)), "{field}");
    }
    // 937 by the book's own figures, 1489 with the torque put right.
    assert_eq!(find("clamping.force")["by_stated"], "937.1");
    assert_eq!(find("clamping.torque")["follows_from"], serde_json::json!(["conditions.3.rpm"]));
}

#[test]
fn a_bad_plan_file_tells_all_its_mistakes() {
    let (text, code) = command(&["audit", "tests/audit/bad.yaml", "--lang", "en"]);
    assert_eq!(code, 2, "{text}");
    insta::assert_snapshot!("audit-bad-file", text);
}

/// docs/audit.md is the page of the rules and checks.
#[test]
fn the_page_names_every_rule() {
    let page = std::fs::read_to_string(root("docs/audit.md")).unwrap();
    let untold: Vec<&str> =
        technolog::audit::rules::all().map(|rule| rule.id).filter(|id| !page.contains(&format!("`{id}`"))).collect();
    assert!(untold.is_empty(), "docs/audit.md does not name {untold:?}");
}

/// A plan says what is missing and nothing more.
#[test]
fn a_plan_of_a_part_alone_lists_what_it_lacks() {
    let audit = audited("part: ../../examples/plate.yaml\n");
    let texts: Vec<String> = audit.findings.iter().map(text_of).collect();
    let sections = ["route", "tools", "conditions", "clamping", "program", "times"];
    for section in sections.into_iter().filter(|section| *section != "conditions") {
        assert!(texts.contains(&format!("note audit-missing {section}")), "{section}: {texts:?}");
    }
    assert!(!audit.has_errors());
}

#[test]
fn no_line_of_the_page_is_wider_than_the_page() {
    use unicode_width::UnicodeWidthStr;
    for lang in ["uk", "en"] {
        let (text, _) = command(&["audit", "examples/appendix-g/plan.yaml", "--lang", lang]);
        let wide: Vec<&str> = text.lines().filter(|line| line.width() > 120).collect();
        assert!(wide.is_empty(), "{lang}: {wide:?}");
    }
}

/// A core drill above a floor that a mill then levels, and a tool that stays in the spindle while the part is turned over: both were
/// blamed in our own plans.
#[test]
fn a_levelled_floor_and_a_tool_that_stays_are_not_blamed() {
    for keys in [
        "diameter: 15H7, depth: 36, roughness: Ra 6.3, countersink: {diameter: 19}",
        "diameter: 15H7, depth: 30, bottom: flat, roughness: Ra 6.3",
        "through: true, roughness: Ra 12.5, steps: [{diameter: 12, depth: 1}, {diameter: 11, depth: 2}, {diameter: 10, depth: 3}, \
         {diameter: 8, depth: 39}, {diameter: 12, depth: 40}]",
    ] {
        let keys = format!("centre_tolerance: 0.5, {keys}, at: [[100, 100], [40, 100]]");
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\ndatum: {{x: left, y: front}}\n\
             blank: {{kind: plate, length: 1000, width: 200, thickness: 40}}\nholes:\n  - {{name: H0, {keys}}}\n"
        );
        let found = own(&read(&text), CuttingMethod::Formula);
        assert!(found.is_empty(), "{keys}: {found:?}");
    }
}
