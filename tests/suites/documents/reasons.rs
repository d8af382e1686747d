//! Nothing is decided by a sentence: planning, checks and audits use types, and notes are made of them at the end.
//!
//! Code and figures of a note are private, and clippy forbids the methods that read them (`clippy.toml`) except where
//! words are made of them. Clippy ignores a wrong path, so the paths are checked here.

use std::any::type_name;
use std::path::{Path, PathBuf};

use technolog::note::Note;

fn read(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn clippy_forbids_to_read_a_note_where_the_note_is() {
    let forbidden = read("clippy.toml");
    for method in ["code", "figure", "figures"] {
        let path = format!("path = \"{}::{method}\"", type_name::<Note>());
        assert!(forbidden.contains(&path), "clippy.toml lacks {path}");
    }
    let cargo = read("Cargo.toml");
    assert!(cargo.contains("disallowed_methods = \"warn\""), "the lint is not asked for");
}

/// Where a note may be read: what tests share, its words, a finding's rule that is told by its code, and what is read back from JSON.
const READERS: [&str; 7] = [
    "shipped/build.rs",
    "crates/testing/",
    "crates/note/",
    "crates/words/",
    "crates/pages/",
    "audit/src/finding.rs",
    "turning/src/cutting/refusal.rs",
];

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("target") {
            files(&path, found);
        } else if path.extension().is_some_and(|kind| kind == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn nobody_else_asks_clippy_to_look_away() {
    let mut found = Vec::new();
    for folder in ["src", "crates"] {
        files(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut found);
    }
    assert!(found.len() > 100, "the search for sources finds too few: {}", found.len());
    // What is compiled for tests alone may look at what notes are told.
    found.retain(|path| !path.ends_with("tests.rs") && !path.components().any(|part| part.as_os_str() == "tests"));
    for path in found {
        let (name, text) = (path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let program = text.split("#[cfg(test)]").next().unwrap_or_default();
        let reads = program.contains("clippy::disallowed_methods");
        assert!(!reads || READERS.iter().any(|reader| name.contains(reader)), "{name} reads notes");
    }
}
