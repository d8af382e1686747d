//! Every mistake in a user's file is reported in both languages.

use std::path::{Path, PathBuf};

use technolog::audit::read_plan;
use technolog::part::read_part;
use technolog::report::Lang;
use technolog_testing::KNOWLEDGE;

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// A text without what it quotes of the file.
fn own_words(text: &str) -> String {
    text.split('`').step_by(2).collect()
}

/// Of every bad file of the tests every mistake is told in Ukrainian.
#[test]
fn the_mistakes_of_the_bad_files_are_told_in_ukrainian() {
    let mut english = Vec::new();
    let mut reported = 0;
    for entry in std::fs::read_dir(root("tests/bad")).unwrap() {
        let path = entry.unwrap().path();
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let problems = read_part("part.yaml", &text, &KNOWLEDGE).err().unwrap_or_default();
        let none = |_: &str| Err("No such file or directory (os error 2)".to_owned());
        let plan = read_plan("plan.yaml", &text, &KNOWLEDGE, &none).err().map(|why| why.problems).unwrap_or_default();
        for problem in problems.iter().chain(&plan) {
            reported += 1;
            let cyrillic = |text: &str| text.chars().any(|letter| ('а'..='ї').contains(&letter));
            for note in std::iter::once(&problem.message).chain(&problem.help) {
                if !cyrillic(&own_words(&Lang::UK.say(note))) {
                    english.push(format!("{}: {}", path.display(), Lang::EN.say(note)));
                }
            }
        }
    }
    assert!(reported > 50, "{reported} mistakes");
    assert!(english.is_empty(), "{}", english.join("\n"));
}
