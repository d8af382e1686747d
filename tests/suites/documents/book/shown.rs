//! Pages show what the program prints.
//!
//! - A `console` block has commands after `$ `, and under each its output, errors included.
//! - A block with a file name after the language is written to that file first.
//! - The lines of a `sh` block that begin with `technolog` are run, and none may be refused.
//! - A file that a command writes into docs/shown/ is in the repository with the same content.

use std::collections::BTreeMap;
use std::fs;
use std::thread;

use technolog_testing::root;

use super::page::{Block, Page, carried_out};
use super::shell::{SHOWN, Shell, is_run};

/// A page as it should be, the files that it shows, and what is wrong with its commands.
struct Refreshed {
    page: Page,
    text: String,
    shown: BTreeMap<String, Vec<u8>>,
    faults: Vec<String>,
}

fn refreshed(page: Page) -> Refreshed {
    let mut shell = Shell::new(&page.path);
    let blocks = page.blocks();
    for block in &blocks {
        if let Some(file) = block.file() {
            fs::write(shell.folder.join(file), block.text()).unwrap();
        }
    }
    let mut lines: Vec<String> = page.text.lines().map(str::to_owned).collect();
    let (mut replaced, mut faults) = (Vec::new(), Vec::new());
    for block in &blocks {
        let outcome = match block.language() {
            "console" => printed(block, &mut shell).map(|printed| replaced.push((block, printed))),
            "sh" => carry_out(block, &mut shell),
            _ => Ok(()),
        };
        faults.extend(outcome.err().map(|fault| format!("{}:{}: {fault}", page.path, block.line + 1)));
    }
    for (block, printed) in replaced.into_iter().rev() {
        lines.splice(block.line..block.line + block.lines.len(), printed);
    }
    let written = fs::read_dir(shell.folder.join(SHOWN)).unwrap().map(|entry| entry.unwrap());
    let shown =
        written.map(|entry| (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap())).collect();
    Refreshed { page, text: lines.join("\n") + "\n", shown, faults }
}

/// The lines of a `console` block as they should be. A command that is refused must be followed by one that shows its code;
/// one that writes no file must show something.
fn printed(block: &Block, shell: &mut Shell) -> Result<Vec<String>, String> {
    let commands: Vec<&str> = block.lines.iter().filter_map(|line| line.strip_prefix("$ ")).collect();
    if !block.lines.first().is_some_and(|line| line.starts_with("$ ")) {
        return Err("no command".to_owned());
    }
    let mut lines = Vec::new();
    for (number, command) in commands.iter().enumerate() {
        lines.push(format!("$ {command}"));
        if !is_run(command) {
            return Err(format!("`{command}` is not run"));
        }
        let output = shell.run(command);
        let code_is_shown = commands.get(number + 1) == Some(&"echo $?");
        if shell.code > 1 && !code_is_shown {
            return Err(format!("`{command}` ends with {}:\n{output}", shell.code));
        }
        let writes = command.contains(" -o ") || command.contains(" > ");
        if output.trim().is_empty() && !writes {
            return Err(format!("`{command}` shows nothing: has a word changed that it looks for?"));
        }
        lines.extend(output.trim_end().lines().map(str::to_owned));
    }
    Ok(lines)
}

/// Runs the commands of a `sh` block.
fn carry_out(block: &Block, shell: &mut Shell) -> Result<(), String> {
    let text = block.text().replace("\\\n", " ");
    for command in text.lines().filter(|line| is_run(line)) {
        let output = shell.run(command);
        if shell.code > 1 {
            return Err(format!("`{command}` ends with {}:\n{output}", shell.code));
        }
    }
    Ok(())
}

#[test]
fn pages_show_what_the_program_prints() {
    let update = std::env::var("UPDATE_DOCS").is_ok_and(|value| value == "1");
    let pages: Vec<Refreshed> = thread::scope(|scope| {
        let running: Vec<_> = carried_out().map(|page| scope.spawn(|| refreshed(page))).collect();
        running.into_iter().map(|page| page.join().unwrap()).collect()
    });
    let faults: Vec<String> = pages.iter().flat_map(|page| page.faults.clone()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let mut old = Vec::new();
    let mut files = BTreeMap::new();
    for Refreshed { page, text, shown, .. } in pages {
        if text != page.text {
            let now = page.text.lines().zip(text.lines()).position(|(before, after)| before != after).unwrap_or(0);
            let line = |text: &str| text.lines().nth(now).unwrap_or_default().to_owned();
            old.push(format!("{}:{}\n- {}\n+ {}", page.path, now + 1, line(&page.text), line(&text)));
            if update {
                fs::write(root().join(&page.path), text).unwrap();
            }
        }
        for (name, bytes) in shown {
            let path = format!("{SHOWN}/{name}");
            if fs::read(root().join(&path)).ok().as_ref() != Some(&bytes) {
                old.push(path.clone());
                if update {
                    fs::create_dir_all(root().join(SHOWN)).unwrap();
                    fs::write(root().join(&path), &bytes).unwrap();
                }
            }
            assert!(files.insert(name, page.path.clone()).is_none(), "{path} is written by two pages");
        }
    }
    let kept = fs::read_dir(root().join(SHOWN)).into_iter().flatten().map(|entry| entry.unwrap().file_name());
    let unshown: Vec<_> = kept.filter(|name| !files.contains_key(&*name.to_string_lossy())).collect();
    assert!(unshown.is_empty(), "no page writes {SHOWN}/{unshown:?}");
    assert!(update || old.is_empty(), "old, UPDATE_DOCS=1 writes them anew:\n{}", old.join("\n"));
}

#[test]
fn the_readmes_show_a_whole_plan_a_reason_and_a_question() {
    for (path, lang) in [("README.md", " --lang en"), ("README.uk.md", "")] {
        let page = Page::read(path);
        for command in ["cargo run --release -- plan examples/plate.yaml", "cargo test"] {
            assert!(page.text.lines().any(|line| line == command), "{path} does not give `{command}`");
        }
        let consoles = page.blocks().into_iter().filter(|block| block.language() == "console");
        let commands: Vec<String> = consoles.map(|block| block.lines[0].clone()).collect();
        let whole = format!("$ cargo run --release -- plan examples/plate.yaml{lang}");
        assert!(commands.contains(&whole), "{path} does not show `{whole}`");
        for verb in ["$ technolog explain ", "$ technolog lookup "] {
            assert!(commands.iter().any(|command| command.starts_with(verb)), "{path} shows no `{verb}`");
        }
    }
}

/// Heads of tables and of sections that a plan prints, a head over several lines put together.
fn heads(plan: &str) -> Vec<String> {
    let lines: Vec<&str> = plan.lines().collect();
    let mut heads: Vec<String> = Vec::new();
    for (number, line) in lines.iter().enumerate() {
        if line.starts_with(|first: char| first.is_ascii_digit()) && line.contains(". ") {
            heads.push((*line).to_owned());
        }
        if !line.contains("-+-") {
            continue;
        }
        let above = lines[..number].iter().rev().take_while(|line| line.contains(" | ")).count();
        let mut cells: Vec<String> = Vec::new();
        for line in &lines[number - above..number] {
            for (column, cell) in line.split('|').map(str::trim).enumerate() {
                match cells.get_mut(column) {
                    Some(head) if !cell.is_empty() => *head = format!("{head} {cell}").trim().to_owned(),
                    Some(_) => {}
                    None => cells.push(cell.to_owned()),
                }
            }
        }
        heads.extend(cells.into_iter().map(|head| format!("**{head}**")));
    }
    heads
}

#[test]
fn the_page_on_plans_names_every_section_and_column() {
    for (path, lang) in [("docs/reading-a-plan.md", "en"), ("docs/uk/reading-a-plan.md", "uk")] {
        let page = Page::read(path);
        let plan =
            Shell::new(&format!("{path}-heads")).run(&format!("technolog plan examples/plate.yaml --lang {lang}"));
        let heads = heads(&plan);
        assert!(heads.len() > 35, "{heads:?}");
        let missing: Vec<&String> = heads.iter().filter(|head| !page.text.contains(*head)).collect();
        assert!(missing.is_empty(), "{path} does not name {missing:?}");
    }
}

/// The table on the page of outputs has the formats of every command; a command that is asked for another names its own.
#[test]
fn the_page_of_outputs_names_every_format() {
    for path in ["docs/outputs.md", "docs/uk/outputs.md"] {
        let page = Page::read(path);
        let rows: Vec<Vec<&str>> =
            page.prose().into_iter().filter(|line| line.contains("| `technolog ")).map(cells).collect();
        assert!(rows.len() > 12, "{path}: {rows:?}");
        let mut shell = Shell::new(&format!("{path}-formats"));
        for block in page.blocks() {
            if let Some(file) = block.file() {
                fs::write(shell.folder.join(file), block.text()).unwrap();
            }
        }
        for row in rows {
            let command = row[1].trim_matches('`');
            let refused = ["junit", "hand"].into_iter().find_map(|format| {
                let output = shell.run(&format!("{command} --format {format} --lang en"));
                (shell.code == 2).then_some(output)
            });
            let output = refused.unwrap_or_else(|| panic!("{path}: `{command}` has both formats"));
            let formats = format!("its formats are {}\n", row[2]);
            assert!(output.ends_with(&formats), "{path}: `{command}`: {output}");
        }
    }
}

/// The cells of a row of a table in Markdown.
fn cells(line: &str) -> Vec<&str> {
    line.trim_matches('|').split('|').map(str::trim).collect()
}
