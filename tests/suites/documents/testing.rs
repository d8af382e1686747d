//! docs/testing.md: the suites that it names exist, and every law is run as it says.

use std::fs;
use std::path::{Path, PathBuf};

use technolog_testing::root;

/// Every file of Rust below a folder, this one left out.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") && !path.ends_with("documents/testing.rs")
        {
            found.push(path);
        }
    }
}

#[test]
fn every_law_draws_by_the_seed_of_its_name() {
    let (mut paths, mut laws) = (Vec::new(), 0);
    for folder in ["src", "crates", "tests/suites"] {
        sources(&root().join(folder), &mut paths);
    }
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        for (at, _) in text.match_indices("proptest! {\n") {
            let mut inside = text[at..].lines().skip(1).map(str::trim);
            let next = inside.find(|line| !line.starts_with("//")).unwrap_or_default();
            let seeded = next.starts_with("#![proptest_config(") && next.contains("::cases!(");
            assert!(seeded, "{}: `{next}` where `technolog_laws::cases!` should stand", path.display());
            laws += 1;
        }
    }
    assert!(laws > 20, "only {laws} blocks of laws are found");
}

#[test]
fn the_page_names_every_suite() {
    let page = fs::read_to_string(root().join("docs/testing.md")).unwrap();
    for entry in fs::read_dir(root().join("tests/suites")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(page.contains(&format!("\n| `{name}` |")), "{name}");
    }
}
