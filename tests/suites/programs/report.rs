//! The laboratory report: all its parts, every figure of the plan, and what is undone.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use technolog::note::IntoFigure;
use technolog::plan::CuttingMethod;
use technolog::report::Lang;
use technolog_testing::{planned, read};

fn run(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    Command::new(env!("CARGO_BIN_EXE_technolog"))
        .args(arguments)
        .env("COLUMNS", "160")
        .current_dir(root)
        .output()
        .unwrap()
}

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn parts() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    ["plate", "variant-2", "variant-4"].iter().map(|name| root.join(format!("examples/{name}.yaml"))).collect()
}

/// The textbook lists sixteen parts (5.3); each has its heading once, in their order, and no message without words is left.
#[test]
fn every_report_has_the_sixteen_parts_in_order() {
    for part in parts() {
        for lang in ["uk", "en"] {
            let text = printed(&["report", part.to_str().unwrap(), "--lang", lang, "--format", "markdown"]);
            let headings: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("## ")).collect();
            let number = |heading: &str| heading.replace('\\', "").split('.').next().unwrap().parse::<u32>().ok();
            let numbers: Vec<Option<u32>> = headings.iter().map(|heading| number(heading)).collect();
            // Behind them stand the cards.
            let expected: Vec<Option<u32>> = (1..=16).map(Some).chain([None, None]).collect();
            assert_eq!(numbers, expected, "{part:?} {lang}");
            assert!(text.contains("ГОСТ 3.1118-82") && text.contains("ГОСТ 3.1404-86"), "{part:?} {lang}: no cards");
            assert!(!text.contains("lab-"), "{part:?} {lang}: a message without words");
        }
    }
}

/// Nothing of the plan is lost on the way into the report: every tool, diameter, speed, feed and length is in it.
#[test]
fn every_figure_of_the_plan_is_in_its_report() {
    for path in parts() {
        let part = read(&std::fs::read_to_string(&path).unwrap());
        let plan = planned(&part, CuttingMethod::default());
        let text = printed(&["report", path.to_str().unwrap(), "--lang", "en", "--format", "text"]);
        let has = |what: &str| assert!(text.contains(what), "{path:?}: {what} is not in the report");
        for tool in &plan.tools {
            has(&tool.designation);
            has(&tool.holder);
            has(&Lang::EN.figure(&tool.length_mm.into_figure()));
        }
        for own in plan.holes.iter().flat_map(|hole| &hole.transitions) {
            has(&Lang::EN.figure(&own.diameter_mm.into_figure()));
            if !own.elsewhere {
                has(&format!("{:.0}", own.conditions.spindle_rpm.0));
                has(&format!("{:.0}", own.conditions.feed_mm_per_min.0));
            }
        }
        has(&format!("{:.2}", plan.time.total_min.0));
    }
}

#[test]
fn the_title_block_names_who_hands_it_in_and_chooses_the_parts() {
    let text = printed(&["report", "examples/plate.yaml", "--title", "examples/report.yaml", "--format", "text"]);
    for said in ["О. Ковальчук", "МТ-31", "Лабораторна робота 3"] {
        assert!(text.contains(said), "{said}");
    }
    assert!(!text.contains("Вписати: назву"), "the aim is in the file");
    let folder = std::env::temp_dir().join(format!("technolog-report-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let title = folder.join("title.yaml");
    std::fs::write(&title, "parts: [7, 15]\n").unwrap();
    let few = printed(&["report", "examples/plate.yaml", "--title", title.to_str().unwrap(), "--format", "markdown"]);
    assert_eq!(few.lines().filter(|line| line.starts_with("## ")).count(), 2);
    std::fs::write(&title, "parts: [0]\nautor: x\n").unwrap();
    let bad = run(&["report", "examples/plate.yaml", "--title", title.to_str().unwrap(), "--lang", "en"]);
    let told = String::from_utf8(bad.stderr).unwrap();
    assert_eq!(bad.status.code(), Some(2), "{told}");
    assert!(told.contains("title.yaml:1:") && told.contains("title.yaml:2:"), "{told}");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Several files come out of one run, each by its ending; if one of them cannot be written, none is.
#[test]
fn several_files_are_written_at_once_or_not_at_all() {
    let folder = std::env::temp_dir().join(format!("technolog-files-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = |name: &str| folder.join(name).display().to_string();
    let (html, md) = (path("a.html"), path("a.md"));
    let report = |files: &[&str]| {
        let files: Vec<&str> = files.iter().flat_map(|file| ["-o", file]).collect();
        let output = run(&[&["report", "examples/plate.yaml", "--lang", "en"], &files[..]].concat());
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    assert_eq!(report(&[&html, &md]), (Some(0), String::new()));
    assert!(std::fs::read_to_string(&html).unwrap().starts_with("<!doctype html>"));
    assert!(std::fs::read_to_string(&md).unwrap().starts_with("# "));
    std::fs::write(&html, "old").unwrap();
    let (code, told) = report(&[&html, &path("no/such/folder.md")]);
    assert!(code == Some(2) && told.contains("no/such"), "{told}");
    for (file, said) in [("a.xyz", ".html"), ("a", ".html"), ("a.rtf", ".html"), ("a.html", "twice")] {
        let (code, told) = report(&[&html, &path(file)]);
        assert!(code == Some(2) && told.contains(said), "{file}: {told}");
    }
    assert_eq!(std::fs::read_to_string(&html).unwrap(), "old");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 2, "no temporary file is left");
    let plan = run(&["plan", "examples/plate.yaml", "--lang", "en", "-o", &html, "-o", &md]);
    let told = String::from_utf8(plan.stderr).unwrap();
    assert!(plan.status.code() == Some(2) && told.contains("more than once"), "{told}");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A shop has one form by itself, in every format.
#[test]
fn every_form_can_be_had_by_itself() {
    for (form, _) in technolog::report::laboratory::Form::NAMES {
        for lang in ["uk", "en"] {
            for format in ["html", "markdown", "text"] {
                let text =
                    printed(&["report", "examples/plate.yaml", "--only", form, "--lang", lang, "--format", format]);
                assert!(text.lines().count() > 5 && !text.contains("form-"), "{form} {lang} {format}: {text}");
            }
        }
    }
}

/// A part that cannot be made whole is never reported as made.
#[test]
fn what_cannot_be_made_is_said_in_parts_4_15_and_16() {
    let folder = std::env::temp_dir().join(format!("technolog-undone-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let part = folder.join("part.yaml");
    let text = "part: Undone\nmaterial: steel-45\nblank: {kind: plate, length: 200, width: 120, thickness: 20}\n\
                machine: gf2171\nholes:\n  - {name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.4, at: [[0, 0]]}\n  \
                - {name: B, diameter: 30H7, through: true, roughness: Ra 0.1, centre_tolerance: 0.4, at: [[60, 0]]}\n";
    std::fs::write(&part, text).unwrap();
    let output = run(&["report", part.to_str().unwrap(), "--lang", "en", "--format", "text"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("Not all of the task can be done") && text.contains("must not be run"), "{text}");
    assert!(!text.contains("found no error"), "{text}");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A thread on a machine that cannot tap is planned, and no program makes it: the report says what the program says, whatever the
/// control.
#[test]
fn conclusions_are_those_of_plan_and_program() {
    let folder = std::env::temp_dir().join(format!("technolog-thread-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("part.yaml");
    let mut refused = 0;
    for machine in ["gf2171", "ir500pmf4", "haas-vf5-50"] {
        let text = format!(
            "part: Thread\nmaterial: steel-45\nblank: {{kind: plate, length: 200, width: 120, thickness: 20}}\nmachine: {machine}\n\
             holes:\n  - {{name: A, thread: M10, depth: 20, through: true, roughness: Ra 6.3, centre_tolerance: 0.4, at: [[0, 0]]}}\n"
        );
        std::fs::write(&path, text).unwrap();
        let part = path.to_str().unwrap();
        for control in ["2c42-65", "linuxcnc", "fanuc", "grbl"] {
            let program = run(&["program", part, "--control", control, "--lang", "en"]);
            let report = run(&["report", part, "--control", control, "--lang", "en", "--format", "text"]);
            assert_eq!(program.status.code(), report.status.code(), "{machine} {control}");
            let text = String::from_utf8(report.stdout).unwrap();
            let clean = report.status.code() == Some(0);
            let words =
                ["found no error in plan and program", "Every surface of the task can be machined", "Tpiece = "];
            for word in words {
                assert_eq!(text.contains(word), clean, "{machine} {control}: {word}\n{text}");
            }
            refused += usize::from(!clean);
        }
    }
    assert!(refused >= 4, "no machine refuses a thread");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Each kind of tool has the limit of its kind, and a blank whose metal is known has a mass: 0.5·0.3·0.04 m³ of 7850 kg/m³. The
/// drill is Ø20, and ГФ2171 drives drills up to Ø30 and end mills up to Ø40 (catalogs/machines/gf2171.yaml).
#[test]
fn the_blank_is_weighed_and_a_drill_is_held_against_drills() {
    let row = |text: &str, name: &str| -> Vec<String> {
        let line = text.lines().find(|line| line.contains(name)).unwrap_or_else(|| panic!("{name}: {text}"));
        line.split('|').map(|cell| cell.trim().to_owned()).skip(1).collect()
    };
    let plate = printed(&["report", "examples/plate.yaml", "--lang", "en", "--format", "text"]);
    assert_eq!(row(&plate, "largest drill"), ["20 mm", "30 mm", "yes"]);
    assert_eq!(row(&plate, "mass of the blank"), ["47.1 kg", "400 kg", "yes"]);
    assert!(!plate.contains("diameter of the largest end mill"), "the plate is not milled");
    let bracket = printed(&["report", "examples/bracket.yaml", "--lang", "en", "--format", "text"]);
    assert_eq!(row(&bracket, "largest end mill"), ["12 mm", "40 mm", "yes"]);
    let card =
        printed(&["report", "examples/plate.yaml", "--only", "operation-card", "--lang", "uk", "--format", "text"]);
    assert!(card.split_whitespace().collect::<Vec<_>>().join(" ").contains("МЗ: 47,1;"), "{card}");
}

/// A designation stands on one line with its prefix and its standard, a sheet begins with the letter of its line, and the step, its
/// tool and its figures stand on one sheet.
#[test]
fn cards_keep_together_what_belongs_together() {
    for part in ["bracket", "variant-4", "plate"] {
        for form in ["route-card", "operation-card"] {
            let path = format!("examples/{part}.yaml");
            let text = printed(&["report", &path, "--only", form, "--lang", "uk", "--format", "text"]);
            let coded = |line: &str| -> Option<(String, u32)> {
                let code = line.trim().split(';').next()?;
                let letters: String = code.chars().take_while(|sign| sign.is_alphabetic()).collect();
                let number = code[letters.len()..].parse().ok()?;
                (line.contains(';') && letters.chars().count() <= 1).then_some((letters, number))
            };
            let lines: Vec<(&str, String, u32)> =
                text.lines().filter_map(|line| coded(line).map(|(letter, number)| (line, letter, number))).collect();
            assert!(lines.len() > 5, "{part} {form}: {text}");
            for (line, letter, number) in &lines {
                assert!(*number != 1 || !letter.is_empty(), "{part} {form}: a sheet begins without its letter: {line}");
                let end = line.trim_end_matches(';').split(' ').next_back().unwrap();
                assert!(!["ДІ", "РІ", "ОСТ", "ТУ", "ГОСТ"].contains(&end), "{part} {form}: cut: {line}");
            }
            for pair in lines.windows(2) {
                let [(_, letter, _), (_, next, number)] = pair else { continue };
                let parted = form == "operation-card" && letter == "Т" && next == "Р" && *number == 1;
                assert!(!parted, "{part} {form}: figures on another sheet than their tool");
            }
        }
    }
}

/// A mill in a slot goes round: it has no travel of a drill. Ø12 in a slot 14 wide and 16 deep goes down in 3 levels, and at each once
/// along the middle and once around.
#[test]
fn the_card_of_a_slot_has_the_passes_of_its_mill() {
    let text =
        printed(&["report", "examples/bracket.yaml", "--only", "operation-card", "--lang", "uk", "--format", "text"]);
    let of_mill: Vec<&str> = text.lines().filter(|line| line.contains("D або B: 13,09;")).collect();
    assert!(of_mill.len() == 1 && of_mill[0].contains("L: –; ") && of_mill[0].contains("i: 6;"), "{text}");
    let of_drill: Vec<&str> = text.lines().filter(|line| line.contains("D або B: 11;")).collect();
    assert!(of_drill.len() == 1 && of_drill[0].contains("i: 1;") && !of_drill[0].contains('–'), "{text}");
    assert!(!text.contains("отв. 14H12") && text.contains("паз 14H12"), "{text}");
}

/// Ukrainian pages name a table as people do: with the letter of the textbook, or by its title. Answers about tables, and English
/// pages, have its id.
#[test]
fn ukrainian_pages_name_tables_for_people() {
    let report = printed(&["report", "examples/plate.yaml", "--lang", "uk", "--format", "text"]);
    assert!(report.contains("А.9 07") && !report.contains("A.9"), "{report}");
    for id in ["time-norms", "loading-time", "practice-sources"] {
        assert!(!report.contains(id), "{id}");
    }
    assert!(report.contains("«Нормативи часу"), "{report}");
    let english = printed(&["report", "examples/plate.yaml", "--lang", "en", "--format", "text"]);
    assert!(english.contains("A.9 07") && english.contains("time-norms"), "{english}");
    let why = printed(&["explain", "examples/plate.yaml", "--hole", "A", "--lang", "uk"]);
    assert!(why.contains("centre-spot") && why.contains("[А.6, рядок"), "{why}");
    assert!(printed(&["table", "--lang", "uk"]).contains("A.9"), "a list for `technolog table`");
    let turned = printed(&["report", "examples/turned-bushing.yaml", "--lang", "uk", "--format", "text"]);
    assert!(!turned.contains("turning-blank") && turned.contains("лекція 12.1"), "{turned}");
}
