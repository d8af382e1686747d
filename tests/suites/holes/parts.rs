//! Whole plans of parts, as a reader sees them: every file of tests/parts has its snapshot.

use std::path::Path;
use std::process::Command;

#[test]
fn every_part_has_the_page_that_was_looked_at() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/parts");
    let mut parts: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    parts.sort();
    assert!(parts.len() >= 4);
    for part in parts {
        let output =
            Command::new(env!("CARGO_BIN_EXE_technolog")).args(["plan", "--lang", "en"]).arg(&part).output().unwrap();
        let text = format!("exit {:?}\n{}", output.status.code(), String::from_utf8(output.stdout).unwrap());
        let name = part.file_stem().unwrap().to_str().unwrap().to_owned();
        insta::with_settings!({ snapshot_path => "snapshots/parts", prepend_module_to_snapshot => false }, {
            insta::assert_snapshot!(name, text);
        });
    }
}
