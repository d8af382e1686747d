//! Routes, designations, cutters, holders, depths and allowances of hand-written plans: tests/audit/routes.yaml
//! changes them and lists the expected findings.

use std::collections::BTreeSet;
use std::path::Path;

use proptest::prelude::*;
use serde::Deserialize;
use technolog::audit::{Audit, AuditFinding, by_hand, read_plan};
use technolog::note::Severity;
use technolog::plan::CuttingMethod;
use technolog_testing::{AUDITOR, KNOWLEDGE, planned, read};

/// Changes of a plan, and what must be said.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    plan: String,
    name: String,
    /// What stands there once, and what stands there instead.
    changes: Vec<(String, String)>,
    /// `severity rule field`, or `severity rule field stated -> right`.
    #[serde(default)]
    finds: Vec<String>,
    /// Fields of which something is said that follows from these.
    #[serde(default)]
    follows: Vec<String>,
    /// Rules that say nothing.
    #[serde(default)]
    never: Vec<String>,
    /// Whether nothing may be error or wrong.
    #[serde(default)]
    accepted: bool,
    /// Whether other slips may be said beside: figures that were left as they are.
    #[serde(default)]
    also: bool,
}

fn text_of(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit").join(name)).unwrap()
}

fn audited(text: &str) -> Audit {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit");
    let files = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    let stated = read_plan("plan.yaml", text, &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{why:?}"));
    AUDITOR.audit(&stated).unwrap()
}

fn finding_line(finding: &AuditFinding) -> String {
    let severity = format!("{:?}", finding.severity).to_lowercase();
    format!("{severity} {} {}", finding.rule, finding.field)
}

fn with_figures(finding: &AuditFinding) -> String {
    let figures = finding.stated.as_ref().zip(finding.right.as_ref());
    finding_line(finding) + &figures.map_or_else(String::new, |(stated, right)| format!(" {stated} -> {right}"))
}

/// What is doubtful of the book's method itself is said of every plan by its cards.
fn of_method(finding: &AuditFinding) -> bool {
    // The book's 0.1 mm for finish reaming right after a drill leaves nothing at worst.
    finding.rule == "audit-load-low" || finding.rule == "proof-no-stock"
}

#[test]
fn sound_plans_have_no_slip() {
    for plan in ["iron", "steel", "aluminium"] {
        let found = audited(&text_of(&format!("{plan}.yaml")));
        let grave = found.findings.iter().filter(|one| one.severity < Severity::Note && !of_method(one));
        let grave: Vec<String> = grave.map(finding_line).collect();
        assert!(grave.is_empty(), "{plan}: {grave:?}");
    }
}

#[test]
fn every_choice_is_judged_as_the_source_has_it() {
    let cases: Vec<Case> = serde_yaml::from_str(&text_of("routes.yaml")).unwrap();
    let mut wrong = Vec::new();
    for case in cases {
        let mut text = text_of(&format!("{}.yaml", case.plan));
        for (from, to) in &case.changes {
            assert_eq!(text.matches(from).count(), 1, "{}: `{from}`", case.name);
            text = text.replacen(from, to, 1);
        }
        let audit = audited(&text);
        let roots = || audit.findings.iter().filter(|one| one.follows_from.is_empty() && !of_method(one));
        let grave: BTreeSet<String> = roots().filter(|one| one.severity < Severity::Note).map(with_figures).collect();
        let is_root =
            |expected: &String| roots().any(|one| finding_line(one) == *expected || with_figures(one) == *expected);
        let missed: Vec<&String> = case.finds.iter().filter(|expected| !is_root(expected)).collect();
        if !missed.is_empty() {
            wrong.push(format!("{}: not said {missed:?}, but {grave:?}", case.name));
        }
        let expected = |one: &&String| case.finds.iter().any(|find| one.starts_with(find.as_str()));
        if !case.also && !grave.iter().all(|one| expected(&one)) {
            wrong.push(format!("{}: {grave:?}", case.name));
        }
        if case.accepted && audit.has_errors() {
            wrong.push(format!("{}: not accepted", case.name));
        }
        let follows = |field: &String| {
            audit.findings.iter().any(|one| one.field == *field && !one.follows_from.is_empty())
                && !roots().any(|one| one.field == *field)
        };
        if !case.follows.iter().all(follows) {
            wrong.push(format!("{}: of {:?} it is not said that they follow", case.name, case.follows));
        }
        for rule in case.never.iter().filter(|rule| audit.findings.iter().any(|one| one.rule == **rule)) {
            wrong.push(format!("{}: {rule}", case.name));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The rules of these checks, that judge a choice and not a figure.
const CHOICES: [&str; 9] = [
    "audit-scheme-",
    "audit-route-",
    "audit-opening-",
    "audit-thread-",
    "audit-tap-",
    "audit-allowance",
    "audit-passes",
    "audit-depth-",
    "audit-spot-",
];

/// The choices of our plan are right by the audit when it is written as by hand.
fn choices_are_right(part: &str) -> Result<(), TestCaseError> {
    let plan = planned(&read(part), CuttingMethod::Formula);
    let files = |name: &str| if name == "part.yaml" { Ok(part.to_owned()) } else { Err("no such file".to_owned()) };
    let stated = read_plan("plan.yaml", &by_hand(&plan, "part.yaml"), &KNOWLEDGE, &files).unwrap();
    let audit = AUDITOR.audit(&stated).unwrap();
    let choice =
        |one: &&AuditFinding| one.severity < Severity::Note && CHOICES.iter().any(|rule| one.rule.starts_with(rule));
    let found: Vec<String> = audit.findings.iter().filter(choice).map(with_figures).collect();
    prop_assert!(found.is_empty(), "{found:?}\n{part}");
    Ok(())
}

#[test]
fn choices_for_what_laws_found_are_right() {
    for (name, part) in technolog_testing::found() {
        choices_are_right(&part).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(12))]

    /// Whatever the holes.
    #[test]
    fn choices_of_our_plans_by_hand_are_right(part in technolog_testing::holes::part_files()) {
        choices_are_right(&part)?;
    }
}
