//! Plans of other hands, worked out by the textbook's methods without a look at ours (tests/audit-honest): nothing in them is an error or
//! wrong. What an audit cannot prove it must not say.

use std::path::{Path, PathBuf};

use technolog::audit::{Audit, read_plan, read_table};
use technolog::sheets;
use technolog_testing::{AUDITOR, KNOWLEDGE};

pub(super) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit-honest")
}

/// The audit of a plan that stands in that folder.
pub(super) fn audited(name: &str, text: &str) -> Audit {
    let files = |name: &str| std::fs::read_to_string(folder().join(name)).map_err(|error| error.to_string());
    let stated = read_plan(name, text, &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{name}: {why:?}"));
    AUDITOR.audit(&stated).unwrap()
}

/// Every plan of the folder with its name.
pub(super) fn plans() -> Vec<(String, String)> {
    let mut plans: Vec<(String, String)> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "yaml"))
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(path).unwrap()))
        .collect();
    plans.sort();
    plans
}

#[test]
fn no_honest_plan_is_blamed() {
    let plans = plans();
    assert!(plans.len() >= 24, "{}", plans.len());
    let mut blamed = Vec::new();
    for (name, text) in &plans {
        let audit = audited(name, text);
        let grave = audit.findings.iter().filter(|finding| finding.is_wrong());
        blamed
            .extend(grave.map(|one| format!("{name}: {:?} {} {} {:?}", one.severity, one.rule, one.field, one.stated)));
    }
    assert_eq!(blamed, [""; 0]);
}

/// Lists of tools of other hands, each with what it says of its part: the same holds.
#[test]
fn no_honest_list_is_blamed() {
    let none = |_: &str| Err(String::new());
    let mut lists = 0;
    for entry in std::fs::read_dir(folder()).unwrap() {
        let path = entry.unwrap().path();
        let kind = match path.extension().and_then(|end| end.to_str()) {
            Some("csv") => sheets::Kind::Csv,
            Some("xlsx") => sheets::Kind::Xlsx,
            _ => continue,
        };
        lists += 1;
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let tables = sheets::read(kind, &std::fs::read(&path).unwrap()).unwrap();
        let stated =
            read_table(&name, &tables, None, &KNOWLEDGE, &none).unwrap_or_else(|why| panic!("{name}: {why:?}"));
        let audit = AUDITOR.audit(&stated).unwrap();
        let grave = audit.findings.iter().filter(|one| one.is_wrong()).map(|one| format!("{} {}", one.rule, one.field));
        assert_eq!(grave.collect::<Vec<_>>(), [""; 0], "{name}");
    }
    assert_eq!(lists, 6);
}

/// What a plan states is judged though it says that it covers something else; only what is not there may be missing.
#[test]
fn a_scope_excuses_what_is_missing_and_nothing_that_is_stated() {
    let name = "plate-conditions-only.yaml";
    let text = std::fs::read_to_string(folder().join(name)).unwrap();
    let row = "{row: 3, operation: drill, hole: A, count: 6, diameter: 10, depth: 40}";
    let found = |text: &str| {
        let audit = audited(name, text);
        audit.findings.iter().filter(|one| one.is_wrong()).map(|one| one.rule.clone()).collect::<Vec<_>>()
    };
    // A scheme that no cell of the hole has, and one of a table that is not its own.
    let with = |row: &str, more: &str| text.replacen(row, &row.replace('}', more), 1);
    assert_eq!(found(&with(row, ", scheme: \"32\", table: A.8}")), ["audit-scheme-unknown"]);
    // Without its first row the hole B is not centred, which is no matter of conditions.
    let centred = "  - {row: 2, operation: centre-drill, hole: B, count: 4, diameter: 6}\n";
    let without = text.replacen(centred, "", 1).replacen("for: [1, 2]", "for: [1]", 1);
    assert_ne!(without, text);
    assert_eq!(found(&without), [""; 0]);
    let whole = without.replacen("scope: [conditions]\n", "scope: [conditions, holes]\n", 1);
    assert!(!found(&whole).is_empty());
}
