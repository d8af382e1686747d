//! The program of a plan: its differences from the plan, and that one fault is one slip.

use std::path::Path;

use serde::Deserialize;
use technolog::audit::marks::read_scheme;
use technolog::audit::{Audit, AuditFinding, Section, read_plan};
use technolog::note::Severity;
use technolog_testing::{AUDITOR, KNOWLEDGE};

/// A change of one of the files of a plan.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Fault {
    base: String,
    name: String,
    #[serde(default)]
    r#in: String,
    #[serde(default)]
    from: String,
    #[serde(default)]
    to: String,
    /// Further changes of the same file.
    #[serde(default)]
    and: Vec<(String, String)>,
    /// `severity rule field` of the slip; none if the program is right.
    finds: Vec<String>,
    /// Whether the slip is the plan's: whatever is told of the program must follow from it.
    #[serde(default)]
    plan: bool,
}

fn text(name: &str) -> Result<String, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit-programs").join(name);
    std::fs::read_to_string(path).map_err(|error| error.to_string())
}

fn audited(fault: &Fault) -> Audit {
    let files = |name: &str| {
        let text = text(name)?;
        if name != fault.r#in {
            return Ok(text);
        }
        let first = (fault.from.clone(), fault.to.clone());
        Ok(std::iter::once(&first).chain(&fault.and).fold(text, |text, (from, to)| {
            assert_eq!(text.matches(from).count(), 1, "{}: `{from}`", fault.name);
            text.replacen(from, to, 1)
        }))
    };
    let plan = format!("{}.yaml", fault.base);
    let stated = read_plan(&plan, &files(&plan).unwrap(), &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{why:?}"));
    AUDITOR.audit(&stated).unwrap()
}

fn text_of(finding: &AuditFinding) -> String {
    format!("{} {} {}", format!("{:?}", finding.severity).to_lowercase(), finding.rule, finding.field)
}

fn faults() -> Vec<Fault> {
    serde_yaml::from_str(&text("faults.yaml").unwrap()).unwrap()
}

#[test]
fn every_fault_of_a_program_is_one_slip() {
    let mut wrong = Vec::new();
    for fault in faults() {
        let audit = audited(&fault);
        let of_program = audit.findings.iter().filter(|one| one.section == Section::Program);
        let reported: Vec<String> = of_program
            .filter(|one| one.follows_from.is_empty())
            .filter(|one| one.severity <= Severity::Wrong || one.rule.starts_with("audit-program-"))
            .map(text_of)
            .collect();
        if reported != fault.finds {
            wrong.push(format!("{} {}: {reported:?}", fault.base, fault.name));
        }
        let follows = audit.findings.iter().filter(|one| one.section == Section::Program);
        if fault.plan && !follows.clone().any(|one| !one.follows_from.is_empty()) {
            wrong.push(format!("{} {}: nothing follows from the plan", fault.base, fault.name));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// One fault of a program costs what one slip costs.
#[test]
fn one_fault_of_a_program_is_charged_once() {
    let scheme = "{points: 100, sections: {program: {error: 7, wrong: 7}}}";
    let scheme = read_scheme("marks.yaml", scheme, &[]).unwrap();
    for fault in faults().iter().filter(|fault| !fault.plan) {
        let slips = fault.finds.iter().filter(|one| !one.starts_with("note")).count();
        let marks = scheme.mark(&audited(fault));
        let lost: f64 = marks.deductions.iter().map(|one| one.points).sum();
        assert!((lost - 7.0 * slips as f64).abs() < 1e-9, "{} {}: {lost}", fault.base, fault.name);
    }
}

/// A transition that our route does not have is compared with what its own row says.
#[test]
fn a_route_that_is_not_ours_is_compared_too() {
    let plan = text("steel-g44.yaml").unwrap();
    let other = plan
        .replace("operation: semi-finish-bore", "operation: core-drill")
        .replace("designation: BB-F-15-20\n    shank: taper\n    holder: {designation: BB-F-15-20}", "shank: morse");
    assert_ne!(plan, other);
    let audited = |program: &dyn Fn(String) -> String| {
        let files = |name: &str| text(name).map(|text| if name.ends_with(".nc") { program(text) } else { text });
        let stated = read_plan("plan.yaml", &other, &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{why:?}"));
        let audit = AUDITOR.audit(&stated).unwrap();
        let grave = audit.findings.into_iter().filter(|one| one.section == Section::Program && one.is_wrong());
        grave.map(|one| text_of(&one)).collect::<Vec<_>>()
    };
    let none: [&str; 0] = [];
    assert_eq!(audited(&|text| text), none);
    let shallow = |text: String| text.replacen("G85 U3 Z-39 I15 F500", "G85 U3 Z-25 I15 F500", 1);
    assert_eq!(audited(&shallow), ["error too-shallow program.N1"]);
}
