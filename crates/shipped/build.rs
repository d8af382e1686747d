//! Reads, checks and compiles the knowledge base while the program is built, so that start-up needs no parsing. A
//! fault in a table stops the build with its file, line and column.

use std::path::{Path, PathBuf};
use std::{env, fs};

use technolog_knowledge::{Knowledge, SourceFile};

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=build.rs");
    let package = PathBuf::from(env::var("CARGO_MANIFEST_DIR").map_err(|error| error.to_string())?);
    let root = package.ancestors().nth(2).ok_or("crates/shipped does not stand in the root of the project")?;
    for folder in ["catalogs", "rules"] {
        println!("cargo::rerun-if-changed={}", root.join(folder).display());
    }
    let out = PathBuf::from(env::var("OUT_DIR").map_err(|error| error.to_string())?);
    let files = Knowledge::read_folder(root).map_err(|problems| listed(&problems))?;
    let sources: Vec<SourceFile<'_>> = files.iter().map(|(path, text)| SourceFile { path, text }).collect();
    let knowledge = technolog_tables::load(&sources).map_err(|problems| listed(&problems))?;
    write(&out.join("knowledge.bin"), &knowledge.to_bytes()?)?;

    // `lint` needs the place of every cell, so it reads the same files again from here.
    let mut list = String::from("&[\n");
    for (path, _) in &files {
        let full = root.join(path);
        list.push_str(&format!("    SourceFile {{ path: {path:?}, text: include_str!({full:?}) }},\n"));
    }
    list.push(']');
    write(&out.join("sources.rs"), list.as_bytes())
}

fn listed(problems: &[technolog_knowledge::Diagnostic]) -> String {
    let lines: Vec<String> = problems.iter().map(|problem| problem.text(english)).collect();
    format!("the knowledge base has {} faults:\n{}", lines.len(), lines.join("\n"))
}

/// A note in English without the message catalogue, which is not built yet: its line with the figures inserted.
#[expect(clippy::disallowed_methods, reason = "words are made of a note here")]
fn english(note: &technolog_note::Note) -> String {
    const LINES: [&str; 2] =
        [include_str!("../words/languages/en/fault-files.ftl"), include_str!("../words/languages/en/fault-tables.ftl")];
    let raw = note.to_string();
    let code = raw.split(' ').next().unwrap_or_default();
    let line = LINES.iter().flat_map(|text| text.lines()).find_map(|line| line.strip_prefix(code)?.strip_prefix(" = "));
    let Some(line) = line else { return raw };
    note.figures().fold(line.to_owned(), |line, (name, figure)| {
        let shown = match figure {
            technolog_note::Figure::Note(note) => english(note),
            figure => figure.text().into_owned(),
        };
        line.replace(&format!("{{ ${name} }}"), &shown)
    })
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
}
