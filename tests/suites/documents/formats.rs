//! Every page in every format: as text at two widths, as Markdown and as HTML, the same bytes on every run.

use std::path::Path;
use std::process::Command;

use unicode_width::UnicodeWidthStr;

/// Commands that print a page, in both languages.
const PAGES: &[&[&str]] = &[
    &["plan", "examples/plate.yaml"],
    &["plan", "examples/variant-4.yaml"],
    &["explain", "examples/plate.yaml", "--hole", "B"],
    &["order", "examples/plate.yaml"],
    &["turn", "examples/shaft.yaml"],
    &["turn", "examples/turned-bushing.yaml"],
    &["audit", "examples/appendix-g/plan.yaml"],
    &["audit", "examples/appendix-g/plan.yaml", "--against", "examples/appendix-g/plan.yaml"],
    &["program", "examples/plate.yaml", "--show", "encoding"],
    &["program", "examples/plate.yaml", "--show", "setting"],
    &["report", "examples/plate.yaml", "--title", "examples/report.yaml"],
    &["check", "examples/appendix-g/program.nc", "--control", "2c42-65"],
    &["table"],
    &["table", "A.11"],
    &["table", "A.7"],
    &["lookup", "A.8", "it=7", "diameter=12", "centre_tolerance=0.2", "roughness=Ra 2.5"],
    &["test", "examples/cases"],
];

fn printed(page: &[&str], lang: &str, columns: &str, format: &str) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_technolog"))
        .args(page)
        .args(["--lang", lang, "--format", format])
        .env("COLUMNS", columns)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")))
        .output()
        .unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(matches!(output.status.code(), Some(0 | 1)), "{page:?} --format {format}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn no_line_of_a_page_is_wider_than_the_terminal() {
    for page in PAGES {
        for (lang, columns) in [("uk", 80), ("en", 80), ("uk", 120), ("en", 120)] {
            let text = printed(page, lang, &columns.to_string(), "text");
            assert!(text.lines().count() > 2, "{page:?}");
            for line in text.lines().filter(|line| line.width() > columns) {
                // A single word that is longer than the line cannot be broken; the faults of a file are framed lines as
                // compilers print them, which wrap where the terminal does.
                let unbreakable = line.split_whitespace().any(|word| word.width() > columns / 2);
                assert!(unbreakable || page[0] == "check", "{page:?} at {columns}: {line}");
            }
        }
    }
}

#[test]
fn every_page_is_there_as_markdown_and_html_with_the_same_bytes_each_time() {
    for page in PAGES {
        for lang in ["uk", "en"] {
            let markdown = printed(page, lang, "80", "markdown");
            assert!(markdown.lines().any(|line| line.starts_with("# ")), "{page:?}: no title");
            let html = printed(page, lang, "80", "html");
            assert!(html.starts_with("<!doctype html>") && html.contains(&format!("lang=\"{lang}\"")), "{page:?}");
            assert!(html.contains("name=\"viewport\"") && html.trim_end().ends_with("</html>"), "{page:?}");
            // Width and run make no difference to either.
            assert_eq!(printed(page, lang, "120", "markdown"), markdown, "{page:?}");
            assert_eq!(printed(page, lang, "120", "html"), html, "{page:?}");
        }
    }
}
