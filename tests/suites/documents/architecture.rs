//! The table of crates in docs/architecture.md says which crate depends on which. These tests compare it with the
//! manifests.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The crates of each crate's row, the rows from the ground up.
fn documented_crates() -> Vec<(String, BTreeSet<String>)> {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/architecture.md")).unwrap();
    let table = page.lines().skip_while(|line| !line.starts_with("| crate | knows |")).skip(2);
    let rows = table.take_while(|line| line.starts_with('|')).map(|line| {
        let cells: Vec<&str> = line.split('|').collect();
        (quoted(cells[1]).next().unwrap(), quoted(cells[2]).collect())
    });
    rows.collect()
}

/// What stands in back quotes.
fn quoted(text: &str) -> impl Iterator<Item = String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned)
}

/// The crates of ours that a crate is built with; `shipped` serves the tests of some that do not know it.
fn built_with(folder: &Path) -> BTreeSet<String> {
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
    let (_, dependencies) = manifest.split_once("\n[dependencies]\n").unwrap();
    let dependencies = dependencies.split("\n[").next().unwrap();
    let ours = dependencies.lines().filter_map(|line| line.strip_prefix("technolog-")?.split_once('.'));
    ours.map(|(name, _)| name.to_owned()).collect()
}

#[test]
fn the_page_says_which_crate_knows_which() {
    let mut documented: BTreeMap<String, BTreeSet<String>> = documented_crates().into_iter().collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let front = documented.remove("technolog").unwrap();
    assert_eq!(front, BTreeSet::new(), "it knows all of them, which the page says in words");
    assert_eq!(built_with(root), documented.keys().cloned().collect());
    // What only tests are built with is no room of the program.
    let of_tests = |path: &PathBuf| path.ends_with("testing") || path.ends_with("laws");
    let crates = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path());
    let crates = crates.filter(|path| !of_tests(path));
    let built = crates.map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), built_with(&path)));
    assert_eq!(documented, built.collect());
}

#[test]
fn a_crate_knows_only_what_stands_above_its_row() {
    let mut below = BTreeSet::new();
    for (name, knows) in documented_crates() {
        assert!(knows.is_subset(&below), "{name} knows {:?}", knows.difference(&below));
        below.insert(name);
    }
}

/// A crate that is not built by default would not be tested by default either. What sets pages as PDF is the last step of
/// .ci/run.
#[test]
fn what_is_no_tool_of_tests_is_built_by_default() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = fs::read_to_string(root.join("Cargo.toml")).unwrap();
    let (_, members) = manifest.split_once("default-members = [").unwrap();
    let members = members.split(']').next().unwrap();
    let by_default: BTreeSet<String> = members
        .split('"')
        .skip(1)
        .step_by(2)
        .filter_map(|member| member.strip_prefix("crates/"))
        .map(str::to_owned)
        .collect();
    let rooms =
        documented_crates().into_iter().map(|(name, _)| name).filter(|name| name != "technolog" && name != "pdf");
    assert_eq!(by_default, rooms.collect());
}
