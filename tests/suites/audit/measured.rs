//! Typical mistakes in honest plans, lists and programs (tests/audit-mistakes), each written down with its place and its explanation before
//! the audit had seen it: what share is found, and what share of that is named first, at its root, as what it is.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::Deserialize;
use technolog::audit::{Audit, AuditFinding, ProgramAlone, read_table};
use technolog::note::Severity;
use technolog::sheets;
use technolog_testing::{AUDITOR, KNOWLEDGE, read, root};

use super::edited;

/// A mistake with what must be said of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planted {
    base: String,
    kind: String,
    name: String,
    /// Figures and words of a plan as they are then, by their paths.
    #[serde(default)]
    set: BTreeMap<String, String>,
    #[serde(default)]
    drop: Vec<String>,
    #[serde(default)]
    swap: Vec<String>,
    /// What of a list or a program is put instead.
    #[serde(default)]
    from: String,
    #[serde(default)]
    to: String,
    #[serde(default)]
    all: bool,
    /// Whether a list has the part of the plate beside it.
    #[serde(default)]
    part: bool,
    /// Of a program: its control, and the file of its part.
    #[serde(default)]
    control: String,
    #[serde(default)]
    of: String,
    #[serde(default)]
    at: Vec<String>,
    rule: Vec<String>,
    /// How many findings that follow from nothing a program may have.
    #[serde(default)]
    roots: Option<usize>,
}

/// What became of a mistake.
struct Outcome {
    kind: String,
    found: bool,
    /// Told first, at its place and as what it is.
    root: bool,
    said: String,
}

fn text(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|why| panic!("{path}: {why}"))
}

/// What stands in the files of a form: `plans.yaml`, the second set, `blind-plans.yaml`, and the third.
fn planted(file: &str) -> Vec<Planted> {
    let of =
        |file: &str| -> Vec<Planted> { serde_yaml::from_str(&text(&format!("tests/audit-mistakes/{file}"))).unwrap() };
    ["", "blind-", "third-"].iter().flat_map(|set| of(&format!("{set}{file}"))).collect()
}

impl Planted {
    fn replaced(&self, text: &str) -> String {
        let count = text.matches(&self.from).count();
        assert!(count == 1 || self.all && count > 1, "{}: {count} of `{}`", self.name, self.from);
        text.replace(&self.from, &self.to)
    }

    /// What an audit says beyond what it says of the honest work.
    fn outcome(&self, audit: &Audit, honest: &Audit, is_here: impl Fn(&AuditFinding) -> bool) -> Outcome {
        let known = |one: &AuditFinding| {
            honest
                .findings
                .iter()
                .any(|own| (&own.rule, &own.field, own.severity) == (&one.rule, &one.field, one.severity))
        };
        let slips = || audit.findings.iter().filter(|one| one.severity < Severity::Note && !known(one));
        let is_named = |one: &AuditFinding| self.rule.contains(&one.rule);
        let found = slips().any(|one| is_here(one) || is_named(one));
        let first = slips().filter(|one| one.follows_from.is_empty()).min_by_key(|one| one.severity);
        let roots = slips().filter(|one| one.follows_from.is_empty()).count();
        let root =
            first.is_some_and(|one| is_here(one) && is_named(one)) && self.roots.is_none_or(|most| roots <= most);
        let told: Vec<String> = slips()
            .filter(|one| one.follows_from.is_empty())
            .map(|one| format!("{:?} {} {} {:?}:{:?}", one.severity, one.rule, one.field, one.line, one.column))
            .collect();
        let said = format!("{} {}: {} | {roots} roots: {told:?}", self.base, self.kind, self.name);
        Outcome { kind: self.kind.clone(), found, root, said }
    }
}

fn plans() -> Vec<Outcome> {
    let outcome = |one: &Planted| {
        let file = format!("{}.yaml", one.base);
        let honest = text(&format!("tests/audit-honest/{file}"));
        let mut plan = edited::Lines::of(&honest);
        plan.drop(&one.drop);
        if let [first, second] = one.swap.as_slice() {
            plan.swap(first, second);
        }
        for (path, value) in &one.set {
            plan.set(path, value);
        }
        let audit = super::honest::audited(&file, &plan.text());
        let honest = super::honest::audited(&file, &honest);
        one.outcome(&audit, &honest, |finding| one.at.contains(&finding.field))
    };
    planted("plans.yaml").iter().map(outcome).collect()
}

fn lists() -> Vec<Outcome> {
    let plate = read(&text("examples/plate.yaml"));
    let none = |_: &str| Err(String::new());
    let audited = |list: &str, part: bool| {
        let tables = sheets::read(sheets::Kind::Csv, list.as_bytes()).unwrap();
        let stated = read_table("list.csv", &tables, part.then_some(&plate), &KNOWLEDGE, &none);
        stated.map(|stated| AUDITOR.audit(&stated).unwrap())
    };
    let outcome = |one: &Planted| {
        let honest = text(&format!("tests/audit-mistakes/{}", one.base));
        let blank = audited(&honest, one.part).unwrap();
        let blamed: Vec<&str> =
            blank.findings.iter().filter(|one| one.is_wrong()).map(|one| one.rule.as_str()).collect();
        assert_eq!(blamed, [""; 0], "{}", one.base);
        // What cannot be read at all says nothing of the rest of it.
        let audit = match audited(&one.replaced(&honest), one.part) {
            Ok(audit) => audit,
            Err(why) => {
                let said = format!("{} {}: {} | {why:?}", one.base, one.kind, one.name);
                return Outcome { kind: one.kind.clone(), found: false, root: false, said };
            }
        };
        let place = |one: &AuditFinding| Some(format!("{}:{}", one.line?, one.column?));
        one.outcome(&audit, &blank, |finding| place(finding).is_some_and(|place| one.at.contains(&place)))
    };
    planted("lists.yaml").iter().map(outcome).collect()
}

fn programs() -> Vec<Outcome> {
    let outcome = |one: &Planted| {
        let honest = text(&format!("tests/audit-alone/{}", one.base));
        let program = one.replaced(&honest);
        let (control, part) = match one.base.split('-').next().unwrap() {
            _ if !one.of.is_empty() => (one.control.as_str(), one.of.as_str()),
            "plate" => ("fanuc", "plate"),
            "bearing" => ("linuxcnc", "bearing"),
            "bracket" => ("fanuc", "bracket"),
            _ if one.base.ends_with(".ngc") => ("linuxcnc", "cover"),
            _ => ("haas-ngc", "cover"),
        };
        let part = read(&text(&format!("tests/audit-alone/{part}.yaml")));
        let audited = |text: &str| {
            let alone =
                ProgramAlone { file: "program.nc", text, control, setting: None, part: Some(&part), tools: None };
            AUDITOR.audit(&alone.read(&KNOWLEDGE).unwrap().unwrap()).unwrap()
        };
        let audit = audited(&program);
        // The section of the tool in which the slip is, with the comment or the end of the one before it.
        let lines: Vec<&str> = program.lines().collect();
        let slip = honest.lines().zip(&lines).position(|(own, made)| own != *made).unwrap() + 1;
        let changes: Vec<usize> = (1..)
            .zip(&lines)
            .filter(|(_, line)| line.to_uppercase().contains("M6") || line.contains("M06"))
            .map(|(at, _)| at)
            .collect();
        let begin = changes.iter().rev().find(|at| **at <= slip + 4).copied().unwrap_or(1).min(slip);
        let end = changes.iter().find(|at| **at > slip + 4).copied().unwrap_or(lines.len() + 1);
        // A hole that is missing has no line.
        let named = one.kind == "tool" || one.all;
        one.outcome(&audit, &audited(&honest), |finding| {
            let is_near = |line: u32| named || (begin..end).contains(&(line as usize));
            ["not-made", "audit-program-left-out"].contains(&finding.rule.as_str()) || finding.line.is_some_and(is_near)
        })
    };
    let mut programs = planted("programs.yaml");
    for one in &mut programs {
        one.roots.get_or_insert(1);
    }
    programs.iter().map(outcome).collect()
}

/// The table of docs/audit.md.
fn table(outcomes: &[(&str, Vec<Outcome>)]) -> String {
    let mut page = "| in | kind | planted | found | first, as what it is |\n|---|---|---|---|---|\n".to_owned();
    for (of, outcomes) in outcomes {
        let mut kinds: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
        for one in outcomes {
            let counts = kinds.entry(&one.kind).or_default();
            for (count, is) in counts.iter_mut().zip([true, one.found, one.root]) {
                *count += usize::from(is);
            }
        }
        for (kind, [all, found, root]) in kinds {
            writeln!(page, "| {of} | {kind} | {all} | {found} | {root} |").unwrap();
        }
    }
    page
}

#[test]
fn typical_mistakes_are_found_and_named_first() {
    let outcomes = [("plans", plans()), ("lists", lists()), ("programs", programs())];
    let all: Vec<&Outcome> = outcomes.iter().flat_map(|(_, of)| of).collect();
    let found = all.iter().filter(|one| one.found).count();
    let root = all.iter().filter(|one| one.root).count();
    let missed: Vec<String> = all
        .iter()
        .filter(|one| !one.root)
        .map(|one| format!("{}{}", if one.found { "" } else { "NOT FOUND " }, one.said))
        .collect();
    println!("{} planted: {found} found, {root} first\n{}\n{}", all.len(), missed.join("\n"), table(&outcomes));
    assert!(all.len() >= 150, "{}", all.len());
    assert!(found * 100 >= all.len() * 98 && root * 100 >= found * 95, "{}", missed.join("\n"));
    assert!(text("docs/audit.md").contains(&table(&outcomes)), "docs/audit.md\n{}", table(&outcomes));
}
