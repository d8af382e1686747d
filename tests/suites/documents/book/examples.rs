//! Examples of files on the pages are read by the program: whole files, and parts of files put into place.

use std::fs;

use super::page::{Block, Page, pages};
use super::shell::Shell;

/// Pages whose `yaml` blocks are tables, cases and settings. Other tests hold those.
const OTHER: [&str; 6] = ["adding", "cases", "catalog-format", "control-2c42-65", "tables", "turning-lecture"];

/// A part that is whole except for its holes.
const PART: &str =
    "part: P\nmaterial: steel-45\nblank: {kind: plate, length: 500, width: 300, thickness: 40}\nmachine: gf2171\n";
const HOLE: &str = "name: A\ndiameter: 10H12\nthrough: true\nroughness: Ra 12.5\ncentre_tolerance: 0.46\n";
const HOLES: &str =
    "holes: [{name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 0]]}]\n";

/// An item of a list, its lines pushed to the right.
fn item(text: &str) -> String {
    let lines: String = text.lines().map(|line| format!("    {line}\n")).collect();
    format!("  -{}", &lines[3..])
}

/// What a block may be: the command that reads it, and the file.
fn readings(block: &Block) -> Vec<Vec<(&'static str, String)>> {
    let text = block.text();
    let has = |key: &str| block.lines.iter().any(|line| line.starts_with(key));
    if has("part: ") && (has("holes:") || has("slots:")) {
        return vec![vec![("plan", text)]];
    }
    for (key, command) in [("shaft: ", "turn"), ("route:", "audit"), ("deduct:", "marks"), ("author:", "title")] {
        if has(key) {
            return vec![vec![(command, text)]];
        }
    }
    let hole = |keys: &str| format!("{PART}holes:\n{}", item(&format!("{HOLE}{keys}")));
    let line_by_line = |rest: &str| block.lines.iter().map(|line| ("plan", hole(&format!("{line}\n{rest}")))).collect();
    vec![
        vec![("plan", format!("{PART}holes:\n{text}"))],
        vec![("plan", format!("{PART}{text}{HOLES}"))],
        line_by_line(""),
        line_by_line("at: [[0, 0]]\n"),
    ]
}

/// What the program says where it cannot use a file.
fn refusal(shell: &mut Shell, command: &str, text: &str) -> Option<String> {
    fs::write(shell.folder.join("example.yaml"), text).unwrap();
    let faults = match command {
        "marks" => shell.run("technolog audit examples/appendix-g/plan.yaml --marks example.yaml --lang en"),
        "title" => shell.run("technolog report examples/plate.yaml --title example.yaml --lang en"),
        command => shell.run(&format!("technolog {command} example.yaml --lang en")),
    };
    (shell.code == 2).then_some(faults)
}

fn unread(page: &Page) -> Vec<String> {
    let mut shell = Shell::new(&format!("{}-examples", page.path));
    let mut unread = Vec::new();
    for block in page.blocks().iter().filter(|block| block.language() == "yaml") {
        let refused: Vec<Option<String>> = readings(block)
            .iter()
            .map(|files| files.iter().find_map(|(command, text)| refusal(&mut shell, command, text)))
            .collect();
        if refused.iter().all(Option::is_some) {
            let texts: Vec<String> = refused.into_iter().flatten().collect();
            unread.push(format!("{}:{}:\n{}", page.path, block.line + 1, texts.join("\nor\n")));
        }
    }
    unread
}

#[test]
fn examples_are_read() {
    let other = |page: &Page| OTHER.iter().any(|name| page.path == format!("docs/{name}.md"));
    let pages = pages().into_iter().filter(|page| !other(page));
    let unread: Vec<String> = pages.flat_map(|page| unread(&page)).collect();
    assert!(unread.is_empty(), "{}", unread.join("\n\n"));
}
