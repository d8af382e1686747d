//! All words are in the message catalogue: no sentence in the program, and no name of a missing message.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use technolog::note::{Figure, Note};
use technolog::units::Roughness;
use technolog::words::check::entries;
use technolog::words::{LANGUAGES, Lang};
use technolog_note::note;

/// What looks like a sentence and is none that a user reads.
const NO_SENTENCES: &[&str] = &[
    // Descriptions in JSON schemas, which are English as their keys are.
    "Millimetres, at most three decimal places (whole micrometres)",
    "Millimetres, at most four decimal places (whole halves of a micrometre)",
    "Roughness limit in micrometres, `Ra 12.5` or `Rz 80`",
    // What a table must have a row for: named in a fault of the table.
    "the cards are known for the worked example's steel only",
    "the tool life",
    "the internal factor",
    "what is not bored",
    "this roughness and nose",
    // Looked for in reasons, and the reason that planning gives itself; both are in remarks.tsv.
    "nothing at hand confirms",
    "the catalogs have no cutter of this size; it must be ground to order",
    // Endings of files, commands as they are typed, and what the parser of YAML says: looked for, not told.
    ".pdf .ps .eps .doc .docx .odt .rtf .tex .epub .xls .xlsx .xlsm .ods .tsv .ppt .pptx .odp .png \
     .jpg .jpeg .gif .bmp .tif .tiff .webp .ico .dxf .dwg .step .stp .iges .igs .stl .cdw .frw .spw \
     .zip .gz .7z .rar .tar .toml .ini .js .py .sqlite .db .exe",
    "technolog check … --setting {file}",
    "cargo build --release --features pdf",
    "technolog audit … --marks {file}",
    "technolog lint --knowledge …",
    "mapping values are not allowed",
    "illegal placement of ':'",
    // A defect of ours, for its developers.
    "the tables are not embedded",
    "a table value is read from a table file, not from text",
    "the angle is no number",
    "`{other}` is nothing that a bound lacks",
    "a piece begins where the toolpath ends",
    // A form of the standard, by its own name.
    "ГОСТ 3.1404-86, форма 5а",
    "ГОСТ 3.1404-86 форма 3",
    "ГОСТ 3.1404-86 форма 2а",
    "ГОСТ 3.1118-82 форма 1",
    "ГОСТ 3.1118-82 форма 1б",
    "МК",
    "ОК",
    "ГОСТ",
    "ОСТ",
    "ДСТУ",
    "ТУ",
    // A unit as users write it.
    "мм",
];

/// Rooms whose texts are no words of the program: tests, the catalogue, markup of Typst, words that are read and never
/// printed, symbols of
/// formulas, sources of audit rules.
const OTHERS: [&str; 11] = [
    "crates/testing",
    "crates/laws",
    "crates/words",
    "crates/pdf",
    "crates/office/src/emf/letters.rs",
    "crates/tables/src/quantity.rs",
    "crates/audit/src/rules",
    // The text of a part file.
    "crates/audit/src/from_program/part.rs",
    "crates/knowledge/src/key_words.rs",
    "crates/knowledge/src/yaml/faults.rs",
    "tests.rs",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|kind| kind == "rs") {
            found.push(path);
        }
    }
}

fn program() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    sources(&root.join("src"), &mut found);
    for room in fs::read_dir(root.join("crates")).unwrap() {
        sources(&room.unwrap().path().join("src"), &mut found);
    }
    let named = |path: &PathBuf| path.strip_prefix(root).unwrap().display().to_string();
    let read = found.iter().map(|path| (named(path), fs::read_to_string(path).unwrap()));
    let own = |text: String| text.split("#[cfg(test)]").next().unwrap_or_default().to_owned();
    read.map(|(name, text)| (name, own(text))).collect()
}

/// The string literals of a source, without its comments and attributes; each with what stands before it.
fn literals(source: &str) -> Vec<(String, String)> {
    let letters: Vec<char> = source.chars().collect();
    let (mut found, mut code, mut at) = (Vec::new(), String::new(), 0);
    let is = |at: usize, text: &str| text.chars().enumerate().all(|(step, one)| letters.get(at + step) == Some(&one));
    while at < letters.len() {
        if is(at, "//") {
            while letters.get(at).is_some_and(|letter| *letter != '\n') {
                at += 1;
            }
        } else if is(at, "#[") || is(at, "#![") {
            let mut depth = 0;
            while let Some(letter) = letters.get(at) {
                depth += i32::from(*letter == '[') - i32::from(*letter == ']');
                at += 1;
                if depth == 0 && *letter == ']' {
                    break;
                }
            }
        } else if letters[at] == '\'' && letters.get(at + 1) == Some(&'\\') {
            at += 2;
            while letters.get(at).is_some_and(|letter| *letter != '\'') {
                at += 1;
            }
            at += 1 + usize::from(letters.get(at + 1) == Some(&'\''));
        } else if letters[at] == '\'' && letters.get(at + 2) == Some(&'\'') {
            at += 3;
        } else if letters[at] == '"' {
            let mut text = String::new();
            at += 1;
            while letters.get(at).is_some_and(|letter| *letter != '"') {
                if letters[at] == '\\' {
                    at += 1;
                }
                text.extend(letters.get(at));
                at += 1;
            }
            at += 1;
            found.push((code.clone(), text));
            code.clear();
        } else {
            code.push(letters[at]);
            at += 1;
        }
    }
    found
}

/// Whether a reader would take it for words: Cyrillic letters, or three English words.
fn is_sentence(text: &str) -> bool {
    let mut bare = String::new();
    let mut depth = 0;
    for letter in text.chars() {
        depth += i32::from(letter == '{');
        if depth == 0 {
            bare.push(letter);
        }
        depth -= i32::from(letter == '}');
    }
    let markup = text.trim_start().starts_with('<') || text.contains("=\"") || text.contains("</");
    let runs = |of: fn(char) -> bool| -> usize {
        bare.split(|letter: char| !letter.is_alphabetic())
            .filter(|run| run.chars().count() > 1 && run.chars().all(of))
            .count()
    };
    let spaces = bare.trim().matches(' ').count();
    let ukrainian = runs(|letter| ('\u{400}'..='\u{4ff}').contains(&letter)) > 0;
    !markup && (ukrainian || (spaces > 1 && runs(|letter| letter.is_ascii_lowercase()) > 2))
}

#[test]
fn no_sentence_stands_outside_the_catalogue() {
    let mut found = Vec::new();
    let mut seen = 0;
    for (file, text) in program() {
        if OTHERS.iter().any(|other| file.contains(other)) {
            continue;
        }
        for (_, literal) in literals(&text) {
            seen += 1;
            let text = literal.split_whitespace().collect::<Vec<_>>().join(" ");
            if is_sentence(&text) && !NO_SENTENCES.contains(&text.as_str()) {
                found.push(format!("{file}: {text}"));
            }
        }
    }
    assert!(seen > 3000, "only {seen} texts were seen");
    assert!(found.is_empty(), "put these into crates/words/languages:\n{}", found.join("\n"));
}

#[test]
fn every_message_that_is_said_is_in_the_catalogue() {
    let english = LANGUAGES.iter().find(|language| language.tag() == "en").unwrap();
    let known: BTreeSet<String> = entries(english).0.into_keys().collect();
    let mut seen = BTreeSet::new();
    let mut missing = Vec::new();
    for (file, text) in program().into_iter().filter(|(file, _)| !file.contains("crates/testing")) {
        for (before, name) in literals(&text) {
            let before = before.trim_end();
            let is_shown = before.ends_with("note!(")
                || before.ends_with("Note::new(")
                || before.ends_with(".word(")
                || before.rsplit_once("say!(").is_some_and(|(_, rest)| {
                    rest.trim_end().ends_with(',') && !rest.contains('"') && rest.matches(',').count() == 1
                });
            if is_shown && !name.is_empty() {
                seen.insert(name.clone());
                if !known.contains(&name) {
                    missing.push(format!("{file}: {name}"));
                }
            }
        }
    }
    assert!(seen.len() > 800, "only {} messages were seen", seen.len());
    assert!(missing.is_empty(), "said and in no language:\n{}", missing.join("\n"));
}

#[test]
fn a_size_without_neighbours_has_none_in_its_sentence() {
    for (sides, uk, en) in [
        ("both", "; найближчі Ø9 і Ø11", "; the nearest are Ø9 and Ø11"),
        ("below", "; найбільше з менших – Ø9", "; the largest below it is Ø9"),
        ("above", "; найменше з більших – Ø11", "; the smallest above it is Ø11"),
        ("none", "", ""),
    ] {
        let note = Note::new("no-drill").with("diameter", 10).with("sides", sides);
        let note = note.with("below", "Ø9").with("above", "Ø11");
        assert_eq!(Lang::UK.say(&note), format!("немає свердла Ø10, що сягає дна{uk}"));
        assert_eq!(Lang::EN.say(&note), format!("no drill Ø10 that reaches{en}"));
    }
}

/// Who reads Ukrainian is sent to the Ukrainian page where there is one.
#[test]
fn ukrainian_words_name_ukrainian_pages() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let pages = fs::read_dir(root.join("docs/uk")).unwrap().map(|entry| entry.unwrap().file_name());
    let pages: Vec<String> = pages.map(|name| format!("docs/{}", name.to_string_lossy())).collect();
    for file in fs::read_dir(root.join("crates/words/languages/uk")).unwrap() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let english = pages.iter().find(|page| text.contains(page.as_str()));
        assert!(english.is_none(), "{} names {english:?}, and there is one in docs/uk", path.display());
    }
}

/// An answer for machines has lost what its figures are; in words it is told as before.
#[test]
fn a_stored_sentence_is_told_as_it_was_made() {
    let roughness: Roughness = "Ra 12.5".parse().unwrap();
    for note in [
        note!("not-proven", why = note!("same-as", table = "A.9", same = Figure::scheme("07 + centre-drill"))),
        note!("scheme", scheme = Figure::scheme("01"), it = 14, roughness = roughness),
    ] {
        let stored: Note = serde_json::from_value(serde_json::to_value(&note).unwrap()).unwrap();
        for lang in Lang::all() {
            assert_eq!(lang.say(&stored), lang.say(&note));
        }
        assert_eq!(serde_json::to_value(&stored).unwrap(), serde_json::to_value(&note).unwrap());
    }
}

/// A key that stands twice in a language would hide one of its sentences.
#[test]
fn no_language_has_a_message_twice() {
    for language in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/words/languages")).unwrap() {
        let mut known = std::collections::BTreeMap::new();
        for file in fs::read_dir(language.unwrap().path()).unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_none_or(|ending| ending != "ftl") {
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let is_key = |letter: char| letter.is_alphanumeric() || letter == '-';
            let keys = text.lines().filter_map(|line| line.split_once(" =")).map(|(key, _)| key);
            for key in keys.filter(|key| !key.is_empty() && key.chars().all(is_key)) {
                let before = known.insert(key.to_owned(), path.clone());
                assert!(before.is_none(), "{key} stands in {before:?} and {}", path.display());
            }
        }
    }
}
