//! What is wrong with a file is said in Ukrainian and in English: every sentence of the rooms that read users' files is
//! in the table of `report::mistakes`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use technolog::audit::read_plan;
use technolog::part::read_part;
use technolog::report::{Lang, mistakes};
use technolog_testing::KNOWLEDGE;

/// The rooms that read what users write.
const ROOMS: [&str; 12] = [
    "crates/knowledge/src/yaml.rs",
    "crates/knowledge/src/units",
    "crates/core/src/part",
    "crates/audit/src/read",
    "crates/audit/src/marks/read.rs",
    "crates/audit/src/own.rs",
    "crates/nc/src/program/setting.rs",
    "crates/cases/src/asked.rs",
    "crates/cases/src/expected.rs",
    "crates/cases/src/planned.rs",
    "crates/cases/src/read.rs",
    "crates/cases/src/table.rs",
];

/// Texts in those rooms that are no sentences about a mistake: formats of files and values, schema descriptions, what
/// the reader of a file writes.
const NO_MISTAKES: &[&str] = &[
    "Millimetres, at most three decimal places (whole micrometres)",
    "Roughness limit in micrometres, `Ra 12.5` or `Rz 80`",
    "[Micrometres; 2]",
    " ",
    ", ",
    " *",
    "{0} {1}",
    "{0} {1}/{2}",
    "{0}: {1}",
    "  {0}: {{1}}",
    "correctors: {{0}}",
    " /.\"'″”“’u{0}",
];

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn files(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path.to_owned()];
    }
    let entries = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| files(&path)).filter(|path| path.extension().is_some_and(|it| it == "rs")).collect()
}

/// The texts in quotes of a file, but for comments and tests, as the table has them: places to fill in are numbered.
fn texts(source: &str) -> Vec<String> {
    let source = source.split("#[cfg(test)]").next().unwrap_or_default();
    let code: Vec<&str> = source.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n").replace("'\"'", "").replace("'\\\"'", "");
    let mut texts = Vec::new();
    let mut letters = code.chars().peekable();
    while letters.by_ref().any(|letter| letter == '"') {
        let mut text = String::new();
        while let Some(letter) = letters.next().filter(|letter| *letter != '"') {
            match (letter, letters.peek()) {
                ('\\', Some('\n')) => while letters.next_if(|letter| letter.is_whitespace()).is_some() {},
                ('\\', Some(_)) => text.extend(letters.next()),
                _ => text.push(letter),
            }
        }
        texts.push(numbered(&text));
    }
    texts.retain(|text| text.contains(' '));
    texts
}

/// A text with its places to fill in numbered: `{text}` and `{}` are places, `{{` is a brace, `{a: 1}` is meant so.
fn numbered(text: &str) -> String {
    let mut numbered = String::new();
    let mut rest = text;
    let mut places = 0;
    while let Some((before, after)) = rest.split_once('{') {
        numbered.push_str(before);
        let inside = after.split_once('}');
        let name = |name: &str| name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
        if let Some(after) = after.strip_prefix('{') {
            numbered.push('{');
            rest = after;
        } else if let Some((_, behind)) = inside.filter(|(inside, _)| name(inside)) {
            numbered.push_str(&format!("{{{places}}}"));
            places += 1;
            rest = behind;
        } else {
            numbered.push('{');
            rest = after;
        }
    }
    numbered.push_str(rest);
    numbered.replace("}}", "}")
}

#[test]
fn every_sentence_of_the_readers_is_in_both_languages() {
    let mut found = BTreeSet::new();
    for room in ROOMS {
        for path in files(&root(room)) {
            found.extend(texts(&std::fs::read_to_string(path).unwrap()));
        }
    }
    assert!(found.len() > 150, "the rooms were not read: {}", found.len());
    let superfluous: Vec<&&str> = NO_MISTAKES.iter().filter(|text| !found.contains(**text)).collect();
    assert!(superfluous.is_empty(), "{superfluous:?}");
    found.retain(|text| !text.starts_with('^') && !NO_MISTAKES.contains(&text.as_str()));
    let known = |text: &str| mistakes::is_known(text) || mistakes::said(text, Lang::UK) != text;
    let missing: Vec<String> = found.into_iter().filter(|text| !known(text)).collect();
    assert!(missing.is_empty(), "without a Ukrainian sentence in crates/pages/src/mistakes:\n{}", missing.join("\n"));
}

/// A text without what it quotes of the file.
fn own_words(text: &str) -> String {
    text.split('`').step_by(2).collect()
}

/// Of every bad file of the tests every mistake is told in Ukrainian, and in English as before.
#[test]
fn the_mistakes_of_the_bad_files_are_told_in_ukrainian() {
    let mut english = Vec::new();
    let mut told = 0;
    for entry in std::fs::read_dir(root("tests/bad")).unwrap() {
        let path = entry.unwrap().path();
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let problems = read_part("part.yaml", &text, &KNOWLEDGE).err().unwrap_or_default();
        let none = |_: &str| Err("No such file or directory (os error 2)".to_owned());
        let plan = read_plan("plan.yaml", &text, &KNOWLEDGE, &none).err().map(|why| why.problems).unwrap_or_default();
        for problem in problems.iter().chain(&plan) {
            told += 1;
            assert_eq!(mistakes::told(problem, Lang::EN), *problem);
            let uk = mistakes::told(problem, Lang::UK);
            let cyrillic = |text: &str| text.chars().any(|letter| ('а'..='ї').contains(&letter));
            for (said, text) in [(Some(&uk.message), Some(&problem.message)), (uk.help.as_ref(), problem.help.as_ref())]
            {
                if said.is_some_and(|said| !cyrillic(&own_words(said))) {
                    english.push(format!("{}: {}", path.display(), text.unwrap()));
                }
            }
        }
    }
    assert!(told > 50, "{told} mistakes");
    assert!(english.is_empty(), "{}", english.join("\n"));
}
