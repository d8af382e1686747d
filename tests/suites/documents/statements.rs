//! The table of docs/turning-lecture.md numbers the statements of lecture 12, with the code that keeps each and the
//! test that cites its number. These tests compare the table with the tests and code that it names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

/// A number and the names of the test files that cite it.
type Citations = BTreeMap<String, BTreeSet<String>>;

/// A row of the table, cell by cell.
struct Row {
    number: String,
    kept_by: String,
    tests: String,
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn page() -> String {
    fs::read_to_string(root().join("docs/turning-lecture.md")).unwrap()
}

fn rows(page: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    for line in page.lines().filter(|line| line.starts_with("| 12.")) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        assert_eq!(cells.len(), 5, "{line}");
        rows.push(Row { number: cells[0].to_owned(), kept_by: cells[3].to_owned(), tests: cells[4].to_owned() });
    }
    rows
}

/// What stands in back quotes.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// Every number of a statement in a text: 12, a full stop, the section, a hyphen, digits. A range of sections is none.
fn numbers(text: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (at, _) in text.match_indices("12.") {
        let inside = text[..at].ends_with(|before: char| before.is_ascii_digit() || before == '.');
        let Some((section, rest)) = text[at + 3..].split_once('-') else { continue };
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        let mut after = rest[digits.len()..].chars();
        let range = after.next() == Some('.') && after.next().is_some_and(|next| next.is_ascii_digit());
        if !inside && !range && matches!(section, "1" | "2" | "3" | "4") && !digits.is_empty() {
            found.insert(format!("12.{section}-{digits}"));
        }
    }
    found
}

/// What the tests of turning cite.
fn cited() -> Citations {
    let mut cited = Citations::new();
    for entry in fs::read_dir(root().join("tests/suites/turning")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        for number in numbers(&fs::read_to_string(&path).unwrap()) {
            cited.entry(number).or_default().insert(name.clone());
        }
    }
    cited
}

#[test]
fn every_number_stands_once_and_in_order() {
    let rows = rows(&page());
    assert!(rows.len() > 50, "{} rows: the table is not found", rows.len());
    let order = |row: &Row| -> Vec<u32> { row.number.split(['.', '-']).map(|part| part.parse().unwrap()).collect() };
    for pair in rows.windows(2) {
        let (one, next) = (order(&pair[0]), order(&pair[1]));
        let follows = if one[1] == next[1] { next[2] == one[2] + 1 } else { next[1] == one[1] + 1 && next[2] == 1 };
        assert!(follows, "{} after {}", pair[1].number, pair[0].number);
    }
}

#[test]
fn the_tests_cite_what_the_table_says_they_do() {
    let mut citations = Citations::new();
    for row in rows(&page()) {
        assert!(!quoted(&row.tests).is_empty(), "{} is cited by no test", row.number);
        citations.insert(row.number, quoted(&row.tests).into_iter().map(str::to_owned).collect());
    }
    assert_eq!(citations, cited());
}

#[test]
fn the_words_of_the_page_cite_numbers_of_the_table() {
    let page = page();
    let known: BTreeSet<String> = rows(&page).into_iter().map(|row| row.number).collect();
    assert!(numbers(&page).is_subset(&known), "{:?}", numbers(&page).difference(&known));
}

#[test]
fn what_keeps_a_statement_is_there() {
    let there = |path: String| root().join(path).exists();
    for row in rows(&page()) {
        assert!(!quoted(&row.kept_by).is_empty(), "{}: nothing keeps it", row.number);
        for name in quoted(&row.kept_by) {
            let found = if row.kept_by.contains(&format!("rule `{name}`")) {
                there(format!("rules/{name}.yaml"))
            } else if row.kept_by.contains(&format!("table `{name}`")) {
                there(format!("catalogs/cutting/{name}.yaml"))
            } else {
                there(format!("crates/turning/src/{name}.rs")) || there(format!("crates/turning/src/{name}/mod.rs"))
            };
            assert!(found, "{}: {name} is not there", row.number);
        }
    }
}

#[test]
fn numbers_are_told_from_ranges_and_other_figures() {
    let section = "12.4";
    let text =
        format!("{section}-7. {section}-12: {section}-{section}.1 l. 3{section}-5, fig. {section} a, {section}-x");
    let expected = [format!("{section}-12"), format!("{section}-7")];
    assert_eq!(numbers(&text), BTreeSet::from(expected));
}
