//! Reports as Word files and workbooks: read back by other programs' readers, nothing of the text is lost.

use std::collections::BTreeSet;
use std::fs;
use std::io::{Cursor, Read};
use std::path::PathBuf;
use std::process::Command;

use calamine::{Data, Reader, Xlsx};
use quick_xml::events::Event;
use technolog::plan::CuttingMethod;
use technolog_testing::{planned, read};

/// Parts with holes.
const PARTS: [&str; 3] = ["examples/plate.yaml", "examples/variant-2.yaml", "examples/variant-4.yaml"];
/// What else has a report: turned parts, a stepped shaft, and a plan that somebody made.
const OTHERS: [&str; 4] = [
    "examples/turned-bushing.yaml",
    "examples/turned-stepped.yaml",
    "examples/shaft.yaml",
    "examples/appendix-g/plan.yaml",
];

/// The report of a file in the format of an ending.
fn report(source: &str, lang: &str, ending: &str) -> Vec<u8> {
    let name = format!("technolog-office-{}-{}", std::process::id(), source.replace('/', "-"));
    let file: PathBuf = std::env::temp_dir().join(format!("{name}-{lang}.{ending}"));
    let output = Command::new(env!("CARGO_BIN_EXE_technolog"))
        .args(["report", source, "--lang", lang, "-o"])
        .arg(&file)
        .env("COLUMNS", "400")
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(matches!(output.status.code(), Some(0 | 1)), "{source}: {}", String::from_utf8_lossy(&output.stderr));
    let bytes = fs::read(&file).unwrap();
    fs::remove_file(&file).unwrap();
    bytes
}

/// The words of a Word file, and how many rows and words each of its tables has.
fn words_of(docx: &[u8]) -> (String, Vec<(usize, usize)>) {
    let mut package = zip::ZipArchive::new(Cursor::new(docx)).unwrap();
    let mut xml = String::new();
    package.by_name("word/document.xml").unwrap().read_to_string(&mut xml).unwrap();
    let mut reader = quick_xml::Reader::from_str(&xml);
    let (mut text, mut tables) = (String::new(), Vec::new());
    let mut inside = false;
    loop {
        match reader.read_event().unwrap() {
            Event::Eof => return (text.replace('\u{a0}', " "), tables),
            Event::Start(element) if element.name().as_ref() == "w:tbl" => tables.push((0, 0)),
            Event::Start(element) if element.name().as_ref() == "w:tr" => tables.last_mut().unwrap().0 += 1,
            Event::Start(element) if element.name().as_ref() == "w:t" => {
                inside = true;
                if let Some((_, words)) = tables.last_mut() {
                    *words += 1;
                }
            }
            Event::End(element) => {
                inside &= element.name().as_ref() != "w:t";
                if ["w:p", "w:tc"].contains(&element.name().as_ref()) {
                    text.push('\n');
                }
            }
            Event::Text(own) if inside => text.push_str(own.as_ref()),
            _ => {}
        }
    }
}

/// The figures of a text: `29,3` or `1600`.
fn figures(text: &str) -> BTreeSet<&str> {
    let of_figure = |sign: char| sign.is_ascii_digit() || matches!(sign, ',' | '.');
    let figures = text.split(|sign| !of_figure(sign)).map(|figure| figure.trim_matches([',', '.']));
    figures.filter(|figure| !figure.is_empty()).collect()
}

#[test]
fn a_word_file_has_every_figure_of_the_text_and_no_empty_table() {
    for source in PARTS.into_iter().chain(OTHERS) {
        for lang in ["uk", "en"] {
            let text = String::from_utf8(report(source, lang, "txt")).unwrap();
            let (words, tables) = words_of(&report(source, lang, "docx"));
            let (stated, there) = (figures(&text), figures(&words));
            let lost: Vec<&&str> = stated.difference(&there).collect();
            assert!(stated.len() > 50 && lost.is_empty(), "{source} {lang}: {lost:?}");
            assert!(tables.len() > if source.contains("appendix") { 0 } else { 5 }, "{source} {lang}");
            assert!(tables.iter().all(|(rows, words)| *rows > 1 && *words > 2), "{source} {lang}: {tables:?}");
        }
    }
}

#[test]
fn a_workbook_has_the_figures_of_the_plan_as_numbers() {
    for source in PARTS {
        let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let plan = planned(&read(&fs::read_to_string(root.join(source)).unwrap()), CuttingMethod::default());
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(report(source, "uk", "xlsx"))).unwrap();
        let mut numbers = Vec::new();
        for (name, range) in book.worksheets() {
            assert!(range.height() > 0, "{source}: the sheet {name} is empty");
            numbers.extend(range.cells().filter_map(|(_, _, cell)| match cell {
                Data::Float(number) => Some(*number),
                _ => None,
            }));
        }
        let has = |what: f64, places: f64| {
            let near = |number: &f64| (number - what).abs() <= 0.5 * places + 1e-9;
            assert!(numbers.iter().any(near), "{source}: {what} is no number of the workbook");
        };
        plan.tools.iter().for_each(|tool| has(tool.length_mm.to_mm(), 0.0));
        for own in plan.holes.iter().flat_map(|hole| &hole.transitions).filter(|own| !own.elsewhere) {
            let conditions = &own.conditions;
            has(conditions.spindle_rpm.0, 1.0);
            has(conditions.feed_mm_per_min.0, 1.0);
            has(conditions.feed_mm_per_rev.0, 0.001);
            has(conditions.speed_m_per_min.0, 0.1);
        }
    }
}

/// A turned part comes with its sketches, its setting and its program; one that is not made whole comes without a program.
#[test]
fn the_report_of_a_turned_part_has_its_sketches_and_its_program() {
    let good = String::from_utf8(report("examples/turned-bushing.yaml", "uk", "html")).unwrap();
    assert!(good.matches("<img ").count() > 4 && good.contains("G71") | good.contains("G1 "), "a bushing");
    // The same program that is written by itself.
    let alone = Command::new(env!("CARGO_BIN_EXE_technolog"))
        .args(["turn", "examples/turned-bushing.yaml", "--show", "program", "--lang", "uk"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let alone = String::from_utf8(alone.stdout).unwrap();
    let text = String::from_utf8(report("examples/turned-bushing.yaml", "uk", "txt")).unwrap();
    assert!(alone.lines().count() > 20 && text.contains(alone.trim_end()), "{alone}");
    let bad = String::from_utf8(report("examples/shaft.yaml", "en", "txt")).unwrap();
    assert!(bad.contains("must not be run") && !bad.contains("M30"), "{bad}");
}

/// What numbers the parts of another report means nothing here, and is refused.
#[test]
fn parts_are_chosen_only_where_there_are_parts() {
    let title = std::env::temp_dir().join(format!("technolog-parts-{}.yaml", std::process::id()));
    fs::write(&title, "author: A\nparts: [1]\n").unwrap();
    for source in ["examples/turned-bushing.yaml", "examples/appendix-g/plan.yaml"] {
        let run = Command::new(env!("CARGO_BIN_EXE_technolog"))
            .args(["report", source, "--lang", "en", "--title"])
            .arg(&title)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .output()
            .unwrap();
        let told = String::from_utf8(run.stderr).unwrap();
        assert!(run.status.code() == Some(2) && told.contains("`parts`"), "{source}: {told}");
    }
    fs::remove_file(&title).unwrap();
}
