//! Drawings and encoding sheets: whole files against their snapshots, and what must hold of every one.
//!
//! `DRAWINGS=folder cargo test --test programs drawings::` also writes every drawing there, to be looked at.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use proptest::prelude::*;
use technolog::job::{self, CycleKind, Job};
use technolog::machine::Machine;
use technolog::motion::{BlockRef, Motion, MotionStep, Plane, Position};
use technolog::plan::{CuttingMethod, Plan};
use technolog::program::written::{Form, LineRole, ProgramLine, WorkRef, WrittenProgram};
use technolog::program::{Language, Setting};
use technolog::report::backplot::{Frame, backplot};
use technolog::report::encoding::{self, Dictionary, encoding_sheet};
use technolog::report::{Lang, cycles};
use technolog::shop::Shop;
use technolog::units::{Micrometres, MillimetresPerMinute};
use technolog_testing::pages::{in_markdown, shown};
use technolog_testing::{KNOWLEDGE, planned, read};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

/// A drawing, written where the one who runs the tests wants to see it.
fn seen(name: &str, svg: String) -> String {
    if let Ok(folder) = std::env::var("DRAWINGS") {
        fs::create_dir_all(&folder).unwrap();
        fs::write(Path::new(&folder).join(format!("{name}.svg")), &svg).unwrap();
    }
    svg
}

fn planned_job(text: &str) -> (Plan, Job) {
    let plan = planned(&read(text), CuttingMethod::Formula);
    let shop = Shop::new(&plan.part, CuttingMethod::Formula, &KNOWLEDGE).unwrap();
    let job = job::make(&plan, &shop).unwrap();
    (plan, job)
}

fn of_file(path: &str) -> (Plan, Job) {
    planned_job(&fs::read_to_string(root().join(path)).unwrap())
}

/// The steps of a job without a program: over each point down and up again, or round it.
fn steps(job: &Job) -> Vec<MotionStep> {
    let mut steps = Vec::new();
    let mut put = |motion: Motion, at: Position| steps.push(MotionStep { motion, at, block: BlockRef::default() });
    let feed = || Motion::Feed { feed_mm_per_min: MillimetresPerMinute(100.0) };
    for setup in &job.setups {
        for work in &setup.works {
            put(Motion::Rapid, job.change_at);
            put(Motion::ToolChange { tool: work.place }, job.change_at);
            for stop in &work.stops {
                let cycle = &work.cycles[stop.cycle];
                let at = |z: Micrometres, dx: Micrometres| Position {
                    x: setup.zero.x + stop.at.x + dx,
                    y: setup.zero.y + stop.at.y,
                    z: setup.zero.z + z,
                };
                let none = Micrometres::ZERO;
                put(Motion::Rapid, at(cycle.out, none));
                put(Motion::Rapid, at(cycle.begin, none));
                put(feed(), at(cycle.end, none));
                if let CycleKind::Circles { radii, sense, .. } = &cycle.kind {
                    for radius in radii {
                        put(feed(), at(cycle.end, *radius));
                        let centre = [setup.zero.x + stop.at.x, setup.zero.y + stop.at.y];
                        let feed_mm_per_min = MillimetresPerMinute(100.0);
                        let arc = Motion::Arc { plane: Plane::Xy, sense: *sense, centre, turns: 0, feed_mm_per_min };
                        put(arc, at(cycle.end, *radius));
                    }
                    put(feed(), at(cycle.end, none));
                }
                put(Motion::Rapid, at(cycle.out, none));
            }
        }
    }
    put(Motion::Rapid, job.change_at);
    steps
}

fn of_job(plan: &Plan, job: &Job, lang: Lang) -> String {
    backplot(&steps(job), Some(&Frame::of(job, &plan.part)), lang)
}

/// The steps of the worked example's program.
fn appendix_g() -> Vec<MotionStep> {
    let folder = root().join("examples/appendix-g");
    let control = Language::read("2c42-65", &KNOWLEDGE).unwrap();
    let machine = Machine::find(&KNOWLEDGE, "gf2171").unwrap();
    let setting = fs::read_to_string(folder.join("setting.yaml")).unwrap();
    let setting = Language::read("2c42-65", &KNOWLEDGE).unwrap().setting("setting.yaml", &setting).unwrap();
    let mut steps = Vec::new();
    control.check(&fs::read_to_string(folder.join("program.nc")).unwrap(), &machine, &setting, &mut steps);
    steps
}

/// A plate with a grid of holes.
fn grid(columns: u32, rows: u32) -> String {
    format!(
        "part: Сітка\nmaterial: steel-45\nblank: {{kind: plate, length: 400, width: 260, thickness: 20}}\nmachine: \
         gf2171\nholes:\n  - name: A\n    diameter: 8H12\n    depth: 20\n    through: true\n    roughness: Ra 12.5\n    \
         centre_tolerance: 0.46\n    pattern: {{grid: {{start: [-180, -110], columns: {columns}, rows: {rows}, step: 15}}}}\n"
    )
}

/// The worked example's program as a writer of the plate's job might leave it: the first tool, a pause, the end.
fn written() -> WrittenProgram {
    let mut lines = Vec::new();
    let mut put = |text: &str, role: LineRole, work: Option<usize>, cycle: Option<usize>| {
        let work = work.map(|work| WorkRef { setup: 0, work });
        lines.push(ProgramLine { text: text.to_owned(), role, work, cycle });
    };
    put(":10", LineRole::Frame, None, None);
    put("N5 G17 G40 G80 G90", LineRole::Frame, None, None);
    put("N10 G49 G53 G0 Z0 M5", LineRole::Withdrawal, None, None);
    put("N15 G53 G0 X0 Y196", LineRole::Withdrawal, None, None);
    put("N20 T1 M6", LineRole::ToolChange, Some(0), None);
    put("N25 S2000 M3 M8", LineRole::Spindle, Some(0), None);
    put("N30 G0 G54 X-200 Y100", LineRole::Approach, Some(0), None);
    put("N35 G43 H1 Z15", LineRole::Approach, Some(0), None);
    put("N40 G81 U3 Z-3 I15 F300 E5", LineRole::Cycle, Some(0), Some(0));
    put("N45 G0 Y0", LineRole::Point, Some(0), None);
    put("N50 G91 L3 X25 G81 U-12 Z-6 I18", LineRole::Point, Some(0), None);
    put("N55 G90 G80", LineRole::Withdrawal, Some(0), None);
    put("N60 T2 M6", LineRole::ToolChange, Some(1), None);
    put("/N65 M1", LineRole::Frame, None, None);
    put("N70 M2", LineRole::End, None, None);
    WrittenProgram { lines, ..WrittenProgram::default() }
}

#[test]
fn the_encoding_sheet_says_every_transition_once_and_every_word() {
    let (plan, job) = of_file("examples/plate.yaml");
    for (name, lang) in [("uk", Lang::UK), ("en", Lang::EN)] {
        let sheet = encoding_sheet(&written(), &job, &plan, "2c42-65", &KNOWLEDGE, lang).unwrap();
        insta::assert_snapshot!(format!("encoding-plate-{name}"), shown(&sheet.page()));
        if name == "uk" {
            let csv = technolog::sheets::lines(sheet.rows_of_cells(), b',', "\r\n").unwrap();
            insta::assert_snapshot!("encoding-plate-csv", csv);
            insta::assert_snapshot!("encoding-plate-markdown", in_markdown(&sheet.page()));
            // The transitions of the worked example stand as its own sheet has them (l. 10435-10490), but that a numeral
            // in figures has no ending grown on it.
            let transitions: Vec<&str> = sheet.rows.iter().filter_map(|row| row.transition.as_deref()).collect();
            assert_eq!(transitions.len(), 2, "{transitions:?}");
            assert!(transitions[0].starts_with("Центрування 6 отв. Ø10H12 (A), 4 отв. Ø20H12 (B)"), "{transitions:?}");
            assert!(transitions[1].starts_with("Свердління 6 отв. Ø10H12 (A), 4 отв. Ø20H12"), "{transitions:?}");
        }
        assert_eq!(sheet.rows.len(), 15);
        let json = serde_json::to_value(&sheet).unwrap();
        assert_eq!(json["rows"][4]["tool"], "T1");
        assert!(json["rows"][4]["code"].as_str().unwrap().ends_with(" LF"));
    }
}

/// Whatever a writer says of its lines, every transition of the job is on the sheet, each at one block; so is every
/// pause that has a block.
#[test]
fn no_transition_is_lost_or_said_twice() {
    let (plan, job) = of_file("tests/drawings/part.yaml");
    let works = &job.setups[0].works;
    for names_cycles in [true, false] {
        let mut lines = Vec::new();
        for (index, work) in works.iter().enumerate() {
            let mut put = |text: &str, role: LineRole, cycle: Option<usize>| {
                let work = Some(WorkRef { setup: 0, work: index });
                lines.push(ProgramLine { text: text.to_owned(), role, work, cycle });
            };
            for _ in &work.pauses {
                put("M0", LineRole::Pause, None);
            }
            put("T1 M6", LineRole::ToolChange, None);
            for stop in &work.stops {
                put("X0 Y0", LineRole::Cycle, Some(stop.cycle).filter(|_| names_cycles));
            }
        }
        let sheet = encoding_sheet(
            &WrittenProgram { lines, ..WrittenProgram::default() },
            &job,
            &plan,
            "2c42-65",
            &KNOWLEDGE,
            Lang::EN,
        )
        .unwrap();
        let transitions: Vec<&str> = sheet.rows.iter().filter_map(|row| row.transition.as_deref()).collect();
        let transitions = transitions.join("; ").to_lowercase();
        for hole in &plan.holes {
            for transition in &hole.transitions {
                // Both millings of D are one noun, so it is counted as often as the plan has it.
                let noun = technolog::report::operation_noun(transition.operation.name(), Lang::EN);
                let count = |text: &str| {
                    let of_hole = text.split("; ").filter(|part| part.starts_with(noun));
                    of_hole.map(|part| part.matches(&format!("({})", hole.name.to_lowercase())).count()).sum::<usize>()
                };
                let alike = hole.transitions.iter().filter(|other| other.operation == transition.operation).count();
                assert_eq!(count(&transitions), alike, "{noun} {} in {transitions}", hole.name);
            }
        }
    }
}

/// Every word of every program at hand has a meaning; of the words of the tests that break a rule those that exist.
#[test]
fn the_worked_example_has_no_word_without_a_meaning() {
    let text = fs::read_to_string(root().join("examples/appendix-g/program.nc")).unwrap();
    for lang in [Lang::UK, Lang::EN] {
        let sheet = encoding::sheet_of_text(&text, "gf2171", "2c42-65", &KNOWLEDGE, lang).unwrap();
        for row in &sheet.rows {
            assert!(!row.meaning.contains("не знають") && !row.meaning.contains("not know"), "{row:?}");
            assert!(row.transition.is_none());
        }
    }
}

/// What the words of three controls mean, word by word; the expectations are the manuals', not the tables'.
#[test]
fn words_mean_what_the_manuals_say() {
    for (control, line, expected) in [
        (
            "2c42-65",
            "N2 G81 U0.5 Z-15 I0.5 F100",
            vec!["G81: drilling cycle", "U0.5: position of point 1 = 0.5 mm", "F100: feed on 1-2 = 100 mm/min"],
        ),
        ("2c42-65", "N3 G91 G81 U-9.5", vec!["U-9.5: motion to point 1 = -9.5 mm"]),
        ("2c42-65", "N4 G4 E15", vec!["E15: dwell = 1.5 s"]),
        ("2c42-65", "N5 G82 U1 Z-5 F60 H120", vec!["F60: feed on 1-2 = 60 mm/min", "H120: feed on 2-3 = 120 mm/min"]),
        ("2c42-65", "N5 G82 U1 Z-5 F60", vec!["F60: feed on 1-2 and feed on 2-3 = 60 mm/min"]),
        ("2c42-65", "N6 G85 U1 Z-5 M5", vec!["M5: spindle state at point 4: spindle stop"]),
        ("2c42-65", "N7 H12 X10", vec!["H12: length offset register", "X10: motion along X to 10 mm"]),
        ("2c42-65", "N8 M8", vec!["M8: coolant on"]),
        // Of an arc I is the centre alone; beside G10, in a helix, one of I, J, K is the pitch.
        ("2c42-65", "N8 G2 I-27.4 J0 F100", vec!["I-27.4: from the start of an arc to its centre along X = -27.4 mm"]),
        ("2c42-65", "N8 G10 G2 X1 Y1 I5 J0 Z-1 F100 K2", vec!["pitch of a helix = 2 mm"]),
        ("2c42-65", "N9 G99", vec!["G99: the control's tables do not know this word"]),
        (
            "linuxcnc",
            "G99 G83 X1 Y2 Z-40. R3 Q5 F100 (hole A)",
            vec![
                "G83: deep drilling cycle",
                "Z-40.: level of the bottom = -40 mm",
                "Q5: drilling step = 5 mm",
                "comment: hole A",
            ],
        ),
        (
            "linuxcnc",
            "G59.3 G82 Z-5 R1 P0.5",
            vec!["G59.3: workpiece coordinate system 9", "P0.5: dwell at the bottom = 0.5 s"],
        ),
        ("fanuc", "N1 G82 Z-5. R1. P500", vec!["P500: dwell at the bottom = 500 ms"]),
        ("fanuc", "M98 P1001", vec!["M98: subprogram call"]),
    ] {
        let sheet = encoding::sheet_of_text(line, "gf2171", control, &KNOWLEDGE, Lang::EN).unwrap();
        for part in expected {
            let meanings: Vec<&str> = sheet.rows[0].meaning.split("; ").collect();
            assert!(meanings.contains(&part), "{control} {line}: {part} is not in {meanings:?}");
        }
    }
    let error = Dictionary::read("other", &KNOWLEDGE).unwrap_err().to_string();
    assert!(error.contains("other-words"), "{error}");
}

/// A text of a drawing: its box, estimated by letters half as wide as they are high, and what it says.
#[derive(Clone, Debug)]
struct Label {
    left: f64,
    right: f64,
    top: f64,
    foot: f64,
    text: String,
}

impl Label {
    fn over(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.foot && other.top < self.foot
    }
}

/// The texts of a drawing without their rims.
fn labels(svg: &str) -> Vec<Label> {
    let lines = svg.lines().filter(|line| line.starts_with("<text") && !line.contains("stroke="));
    lines
        .map(|line| {
            let value = |name: &str| line.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap();
            let number = |name: &str| value(name).parse::<f64>().unwrap();
            let text = line.split('>').nth(1).unwrap().split('<').next().unwrap().to_owned();
            let (x, y, size) = (number("x"), number("y"), number("font-size"));
            let width = text.chars().count() as f64 * size * 0.5;
            let left = if value("text-anchor") == "middle" { x - width / 2.0 } else { x };
            Label { left, right: left + width, top: y - size * 0.7, foot: y, text }
        })
        .collect()
}

/// Nothing is cut off and no text stands on another, whatever is drawn.
fn readable(name: &str, svg: &str) {
    let size = svg.split("viewBox=\"0 0 ").nth(1).unwrap().split('"').next().unwrap();
    let (width, height) = size.split_once(' ').unwrap();
    let (width, height): (f64, f64) = (width.parse().unwrap(), height.parse().unwrap());
    let labels = labels(svg);
    assert!(!labels.is_empty(), "{name}");
    for (index, label) in labels.iter().enumerate() {
        let inside = label.left >= 0.0 && label.right <= width && label.top >= 0.0 && label.foot <= height;
        assert!(inside, "{name}: cut off: {label:?}");
        for other in &labels[index + 1..] {
            assert!(!label.over(other), "{name}: {label:?} stands on {other:?}");
        }
    }
    assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count(), "{name}");
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
}

const PARTS: [(&str, &str); 4] = [
    ("plate", "examples/plate.yaml"),
    ("variant-2", "examples/variant-2.yaml"),
    ("variant-4", "examples/variant-4.yaml"),
    ("mixed", "tests/drawings/part.yaml"),
];

#[test]
fn every_drawing_of_every_part_is_readable() {
    for (name, path) in PARTS {
        let (plan, job) = of_file(path);
        for lang in [Lang::EN, Lang::UK] {
            readable(name, &seen(&format!("{name}-backplot"), of_job(&plan, &job, lang)));
            readable(name, &seen(&format!("{name}-cycles"), cycles::page(&job, &plan, lang)));
            let diagrams = cycles::diagrams(&job, &plan, lang);
            assert_eq!(diagrams.len(), job.setups.iter().map(|setup| setup.works.len()).sum::<usize>());
            diagrams.iter().for_each(|diagram| readable(name, &diagram.svg));
        }
    }
}

/// With 6, 50 and 300 holes every plunge has its number, once on each panel.
#[test]
fn the_order_can_be_read_with_few_holes_and_with_many() {
    for (columns, rows) in [(3, 2), (10, 5), (20, 15)] {
        let (plan, job) = planned_job(&grid(columns, rows));
        let count = columns * rows;
        let svg = seen(&format!("grid-{count}"), of_job(&plan, &job, Lang::EN));
        readable(&format!("{count} holes"), &svg);
        let numbers: Vec<u32> = labels(&svg).iter().filter_map(|label| label.text.parse().ok()).collect();
        for number in 1..=count {
            let shown = numbers.iter().filter(|shown| **shown == number).count();
            assert_eq!(shown, plan.tools.len(), "number {number} of {count}");
        }
    }
}

/// Any program can be drawn, without a part: the worked example's, and those that show the rules of the control.
#[test]
fn programs_without_a_part_are_drawn() {
    let svg = seen("appendix-g", backplot(&appendix_g(), None, Lang::UK));
    readable("appendix-g", &svg);
    insta::assert_snapshot!("backplot-appendix-g", svg);
    // The tool that is changed for the second time gets a second panel; what the check does not carry out has none.
    assert_eq!(labels(&svg).iter().filter(|label| label.text.starts_with("T2,")).count(), 2);
    let mut drawn = 0;
    for entry in fs::read_dir(root().join("tests/programs")).unwrap().map(|entry| entry.unwrap().path()) {
        let Ok(text) = fs::read_to_string(entry.join("program.nc")) else { continue };
        let svg = backplot(&steps_of(&text), None, Lang::EN);
        readable(&entry.display().to_string(), &svg);
        drawn += 1;
    }
    assert!(drawn > 50, "{drawn}");
}

fn steps_of(text: &str) -> Vec<MotionStep> {
    let machine = Machine::find(&KNOWLEDGE, "gf2171").unwrap();
    let control = Language::read("2c42-65", &KNOWLEDGE).unwrap();
    let mut steps = Vec::new();
    control.check(text, &machine, &Setting::default(), &mut steps);
    steps
}

/// Arcs go round as the program says, seen from above.
#[test]
fn an_arc_is_drawn_as_an_arc_of_its_sense() {
    let flags = |sense: &str| -> Vec<String> {
        let text = format!(":01\nN1 S500 M3 F100 G0 X10 Y0\nN2 {sense} X0 Y10 I-10 J0\nN3 M02\n");
        let svg = backplot(&steps_of(&text), None, Lang::EN);
        let arc = svg.lines().find(|line| line.contains(" A")).unwrap().to_owned();
        // Behind the two radii: rotation, the larger arc, the sense in which angles grow on the page.
        arc.split(" A").nth(1).unwrap().split(' ').skip(3).take(2).map(str::to_owned).collect()
    };
    // Y points down on the page, so that its angles grow with the clock: a quarter against it, three quarters with it.
    assert_eq!(flags("G3"), ["0", "0"]);
    assert_eq!(flags("G2"), ["1", "1"]);
}

/// One tool of each kind of cycle, and the plate with its holes under the path, as they are today.
#[test]
fn drawings_stay_as_they_are() {
    let (plan, job) = of_file("examples/plate.yaml");
    insta::assert_snapshot!("backplot-plate", of_job(&plan, &job, Lang::UK));
    insta::assert_snapshot!("cycles-plate", cycles::page(&job, &plan, Lang::EN));
    let (plan, job) = of_file("tests/drawings/part.yaml");
    let diagrams = cycles::diagrams(&job, &plan, Lang::UK);
    for tool in [2, 4, 6, 9, 11] {
        let diagram = diagrams.iter().find(|diagram| diagram.tool == tool).unwrap();
        insta::assert_snapshot!(format!("cycles-mixed-t{tool}"), diagram.svg);
    }
}

/// A part that is turned over: each panel shows the holes as they lie in its set-up, and its points on them.
#[test]
fn the_second_set_up_lies_the_other_way() {
    let text = "part: P\nmaterial: steel-45\nblank: {kind: plate, length: 200, width: 120, thickness: 40}\nmachine: \
                gf2171\nholes:\n  - {name: A, diameter: 12H12, depth: 40, through: true, roughness: Ra 12.5, \
                centre_tolerance: 0.46, at: [[60, 20]], steps: [{diameter: 12H12, length: 30}, {diameter: 20H12, \
                length: 10, bottom: flat}]}\n";
    let (plan, job) = planned_job(text);
    assert_eq!(job.setups.len(), 2);
    let svg = seen("turned-over", of_job(&plan, &job, Lang::EN));
    readable("turned over", &svg);
    let (one, two) = svg.split_at(svg.find("set-up 2").unwrap());
    // Holes are the circles with the pen of a hole; points those without a pen.
    let x = |text: &str, hole: bool| -> f64 {
        let line = text.lines().find(|line| {
            line.starts_with("<circle") && line.contains("#999") == hole && (hole || line.contains("r=\"2.20\""))
        });
        line.unwrap().split("cx=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
    };
    assert_eq!(x(one, true), x(one, false));
    assert_eq!(x(two, true), x(two, false));
    assert!(labels(one).iter().any(|label| label.text.contains("set-up 1")));
}

/// What the writers write: every word has a meaning, every part is drawn from the steps of its own program, and the
/// program goes down at every stop of the job.
#[test]
fn written_programs_are_drawn_and_told_in_words() {
    for (name, path) in PARTS {
        let (plan, job) = of_file(path);
        let shop = Shop::new(&plan.part, CuttingMethod::Formula, &KNOWLEDGE).unwrap();
        let form = Form::read(&shop).unwrap();
        for (control, language) in technolog_testing::languages() {
            let written = language.write(&job, form);
            let mut steps: Vec<MotionStep> = Vec::new();
            language.check(&written.text(), &shop.machine, &Setting::of_job(&job), &mut steps);
            let svg = backplot(&steps, Some(&Frame::of(&job, &plan.part)), Lang::UK);
            readable(name, &seen(&format!("{name}-{control}"), svg));
            let sheet = encoding_sheet(&written, &job, &plan, control, &KNOWLEDGE, Lang::UK).unwrap();
            seen(&format!("{name}-{control}-sheet"), shown(&sheet.page()));
            for row in &sheet.rows {
                assert!(!row.meaning.contains("не знають"), "{control} {name}: {row:?}");
            }
            assert!(sheet.rows.iter().filter(|row| row.transition.is_some()).count() >= job.setups[0].works.len());
        }
    }
}

#[test]
fn check_draws_a_program_as_svg() {
    let program = "tests/programs/four-holes/program.nc";
    let output = Command::new(env!("CARGO_BIN_EXE_technolog"))
        .args(["check", program, "--control", "2c42-65", "--format", "svg", "--lang", "en"])
        .current_dir(root())
        .output()
        .unwrap();
    let svg = String::from_utf8(output.stdout).unwrap();
    readable(program, &svg);
    assert!(labels(&svg).iter().any(|label| label.text == "points: 4"), "{svg}");
}

proptest! {
    #![proptest_config(technolog_laws::cases!(200))]

    /// A sheet shows whatever stands in a file, line by line.
    #[test]
    fn no_text_makes_a_sheet_panic(text in "([A-Za-z#%;/(\\[\\]<>).0-9 -]{0,30}|\\PC{0,40})(\n[GMXZTHODNP/(#.0-9 -]{0,40}){0,4}") {
        for control in Language::names(&KNOWLEDGE) {
            let sheet = encoding::sheet_of_text(&text, "gf2171", control, &KNOWLEDGE, Lang::UK).unwrap();
            let lines = text.lines().filter(|line| !line.trim().is_empty()).count();
            prop_assert_eq!(sheet.rows.len(), lines);
            prop_assert_eq!(sheet.rows_of_cells().is_empty(), false);
            prop_assert!(shown(&sheet.page()).lines().count() >= lines);
        }
    }
}
