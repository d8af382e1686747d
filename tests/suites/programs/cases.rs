//! Every program of `tests/programs` (2С42-65), `tests/programs-linuxcnc` and `tests/programs-fanuc` is read and run as
//! the file beside it says.
//!
//! A folder holds `program.nc` (or `.ngc`), `expected` and, where they matter, `setting.yaml` and `machine` (an id of the
//! catalog).
//! `expected` names every finding as `line:column code` and then the trace. A case is added by adding a folder;
//! `PROGRAMS=write cargo test --test programs cases::` writes what the program says today, to be read before it is kept.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use proptest::prelude::*;
use technolog::machine::Machine;
use technolog::motion::MotionStep;
use technolog::motion::trace::Trace;
use technolog::note::Severity;
use technolog::program::setting::Before;
use technolog::program::{Fault, Language, MOST_OPERATIONS, Setting};
use technolog_testing::KNOWLEDGE;

static CONTROL: LazyLock<Language> = LazyLock::new(|| Language::read("2c42-65", &KNOWLEDGE).unwrap());

/// A folder of programs: its control, the name of a program in it, the machine where none is named, and how many programs
/// there are at least.
const FOLDERS: [(&str, &str, &str, &str, usize); 6] = [
    ("tests/programs", "2c42-65", "program.nc", "gf2171", 60),
    ("tests/programs-linuxcnc", "linuxcnc", "program.ngc", "ir500pmf4", 100),
    ("tests/programs-fanuc", "fanuc", "program.nc", "ir500pmf4", 40),
    ("tests/programs-haas", "haas-ngc", "program.nc", "ir500pmf4", 8),
    ("tests/programs-mach3", "mach3", "program.nc", "ir500pmf4", 5),
    ("tests/programs-grbl", "grbl", "program.nc", "ir500pmf4", 8),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

/// What is said of a folder today.
fn checked_text(folder: &Path, language: &Language, program: &str, machine: &str) -> String {
    let read = |name: &str| fs::read_to_string(folder.join(name)).ok();
    let machine = read("machine").map_or(machine.to_owned(), |id| id.trim().to_owned());
    // A program for nobody knows which machine.
    let machine = (machine != "none").then(|| Machine::find(&KNOWLEDGE, &machine).unwrap());
    let mut setting =
        read("setting.yaml").map_or_else(Setting::default, |text| language.setting("setting.yaml", &text).unwrap());
    // Most of them show one word, with what acts after power-on.
    if setting.before == Before::Unsaid {
        setting.before = Before::PoweredOn;
    }
    let mut trace = Trace::default();
    let faults = language.check(&read(program).unwrap(), machine.as_ref(), &setting, &mut trace);
    let mut text = String::new();
    for fault in &faults {
        let figures: String = fault.note.figures().map(|(name, value)| format!(" {name}={}", value.text())).collect();
        let calls = if fault.calls.is_empty() { String::new() } else { format!(" {}", fault.path().unwrap()) };
        writeln!(text, "{}:{} {}{figures}{calls}", fault.span.line, fault.span.column, fault.code).unwrap();
    }
    text.push_str("trace\n");
    text.push_str(trace.text());
    text
}

#[test]
fn every_program_does_what_the_file_beside_it_says() {
    let write = std::env::var("PROGRAMS").is_ok_and(|value| value == "write");
    let mut wrong = Vec::new();
    for (root_of, control, program, machine, least) in FOLDERS {
        let language = Language::read(control, &KNOWLEDGE).unwrap();
        let mut folders: Vec<PathBuf> =
            fs::read_dir(root().join(root_of)).unwrap().map(|entry| entry.unwrap().path()).collect();
        folders.retain(|path| path.is_dir());
        if control == "2c42-65" {
            folders.push(root().join("examples/appendix-g"));
        }
        folders.sort();
        for folder in &folders {
            let text = checked_text(folder, &language, program, machine);
            let expected = fs::read_to_string(folder.join("expected")).unwrap_or_default();
            if write {
                fs::write(folder.join("expected"), &text).unwrap();
            } else if text != expected {
                wrong.push(format!("{}\n--- expected\n{expected}\n--- said\n{text}", folder.display()));
            }
        }
        assert!(folders.len() >= least, "only {} programs in {root_of}", folders.len());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// Every rule of the control is broken by some program of the folder, but those that need a program too long to keep.
#[test]
fn every_rule_is_broken_by_some_program() {
    let page = fs::read_to_string(root().join("docs/control-2c42-65.md")).unwrap();
    let mut seen = String::new();
    for entry in fs::read_dir(root().join("tests/programs")).unwrap() {
        seen.push_str(&fs::read_to_string(entry.unwrap().path().join("expected")).unwrap_or_default());
    }
    // The last one only where nothing is said of what ran before: `a_program_alone_sets_the_modes_that_it_relies_on`.
    seen.push_str("memory-full too-many-programs habit-left-over machine-needed limit-not-checked");
    // The rows of the page's table of rules begin with the code.
    let rules: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next()).collect();
    assert!(rules.len() > 50, "the page names {} rules", rules.len());
    let unbroken: Vec<&&str> = rules.iter().filter(|code| !seen.contains(**code)).collect();
    assert!(unbroken.is_empty(), "no program breaks {unbroken:?}");
}

#[test]
fn the_memory_and_the_number_of_programs_are_limited() {
    let codes = |text: &str| -> Vec<&str> { run(text).0.iter().map(|fault| fault.code).collect() };
    assert!(codes(&"N1 M02\n".repeat(5000)).contains(&"memory-full"));
    let many: String = (0..=100).map(|number| format!(":{:02}\nN1 M99\n", number % 100)).collect();
    assert!(codes(&many).contains(&"too-many-programs"));
}

/// Nobody says what ran before: a mode that the program relies on and never sets is wrong, what habit may hold is doubtful, and
/// a mode that nothing relies on is not asked for.
#[test]
fn a_program_alone_sets_the_modes_that_it_relies_on() {
    let machine = Machine::find(&KNOWLEDGE, "ir500pmf4").unwrap();
    let told = |control: &str, text: &str, before: Before| -> Vec<(String, Severity)> {
        let language = Language::read(control, &KNOWLEDGE).unwrap();
        let setting = Setting { before, ..Setting::default() };
        let faults = language.check(text, &machine, &setting, &mut Trace::default());
        let left = faults
            .into_iter()
            .filter(|fault| ["mode-left-over", "habit-left-over", "height-unknown"].contains(&fault.code));
        let words = |fault: &Fault| {
            fault.note.figures().find(|(name, _)| *name == "words").map(|(_, it)| it.text().into_owned())
        };
        left.map(|fault| (words(&fault).unwrap_or_else(|| fault.code.to_owned()), fault.severity)).collect()
    };
    let wrong = |words: &str| (words.to_owned(), Severity::Wrong);
    let doubtful = |words: &str| (words.to_owned(), Severity::Doubtful);
    let bare = "S500 M3\nG0 Z5\nX1\nG1 Z-1 F50\nG2 X3 R1\nM30\n";
    for control in ["linuxcnc", "mach3", "grbl"] {
        let text = bare.replace("M30", "M2");
        let all = told(control, &text, Before::Unsaid);
        // One finding for the head, with all that it lacks. GRBL refuses G41 and G42, so no program can have left one.
        let by_habit = if control == "grbl" { "G49, G54" } else { "G49, G54, G40" };
        let lacks =
            |(words, severity): &(String, Severity)| words.starts_with("G21, G90, G17") && *severity == Severity::Wrong;
        assert!(all.len() == 2 && all.iter().any(lacks) && all.contains(&doubtful(by_habit)), "{control}: {all:?}");
        assert_eq!(told(control, &text, Before::PoweredOn), [], "{control}");
        let others = told(control, &text, Before::OtherPrograms);
        assert!(others.iter().any(|(words, _)| words.starts_with("G21, G90, G49, G54")), "{control}: {others:?}");
        // Without an arc nothing relies on the plane; with a tool of the magazine its length and radius are no habit.
        let head = "G21 G90\n";
        let changed = format!("{head}T1 M6\nS500 M3\nG0 Z5\nX1\nM2\n");
        if control != "grbl" {
            assert_eq!(told(control, &changed, Before::Unsaid), [wrong("G49, G40"), doubtful("G54")], "{control}");
        }
        let flat = format!("{head}G40 G49 G54\nS500 M3\nG0 X1\nM2\n");
        assert_eq!(told(control, &flat, Before::Unsaid), [doubtful("height-unknown")], "{control}");
    }
    let old = told("2c42-65", ":01\nN1 S500 M3 F100\nN2 G0 Z5\nN3 X1\nN4 M02\n", Before::Unsaid);
    assert_eq!(old, [wrong("G80, G90"), doubtful("G49, G54, G40")]);
}

/// A sum of many terms is as deep as it is long: one that no control would read ended the program itself once.
#[test]
fn a_number_of_many_operations_is_not_carried_out() {
    let machine = Machine::find(&KNOWLEDGE, "ir500pmf4").unwrap();
    for control in ["fanuc", "linuxcnc"] {
        let language = Language::read(control, &KNOWLEDGE).unwrap();
        let codes = |terms: usize| {
            let text = format!("%\nO1000\nG21 G17 G40 G49 G80 G90\nG0 X[{}]\nM30\n%\n", vec!["1."; terms].join("+"));
            let faults = language.check(&text, &machine, &Setting::default(), &mut Trace::default());
            faults.iter().map(|fault| fault.code).filter(|code| *code == "not-carried-out").count()
        };
        assert_eq!([MOST_OPERATIONS, MOST_OPERATIONS + 2, 200_000].map(codes), [0, 1, 1], "{control}");
    }
}

/// Programs that would repeat for ever end by the budget, whatever they repeat.
#[test]
fn no_repetition_lasts() {
    let nothing = ":01\nN1 L65535 P02\nN2 M02\n:02\nN1 L65535 P03\nN2 M99\n:03\nN1 L65535 G80\nN2 M99\n";
    let waiting = ":01\nN1 S500 M3 F100 G41 D1 X10\nN2 L65535 P02\nN3 M02\n:02\nN1 L65535 G04 E1 G91 Z-0.01\nN2 M99\n";
    let cycle =
        ":01\nN1 S500 M3 F100 G41 D1 X10\nN2 L65535 P02\nN3 M02\n:02\nN1 L65535 G83 U-1 Z-9999 V0.001 W0.001\nN2 M99\n";
    // A finding of every repeat.
    let finding = ":01\nN1 S500 M3 F100\nN2 L65535 P02\nN3 M02\n:02\nN1 L65535 X0 G81 U-1 Z-2\nN2 M99\n";
    for text in [nothing, waiting, cycle, finding] {
        let begin = std::time::Instant::now();
        let setting =
            Setting { correctors: [(1, technolog::units::Micrometres::from_mm(5))].into(), ..Setting::default() };
        let machine = Machine::find(&KNOWLEDGE, "gf2171").unwrap();
        let faults = CONTROL.check(text, &machine, &setting, &mut Vec::<MotionStep>::new());
        assert!(faults.iter().any(Fault::is_error), "{text}");
        // Not a measurement: what is not held by the budget takes hours.
        assert!(begin.elapsed().as_secs() < 60, "{text}");
    }
}

fn run(text: &str) -> (Vec<Fault>, Vec<MotionStep>) {
    let machine = Machine::find(&KNOWLEDGE, "gf2171").unwrap();
    let mut steps = Vec::new();
    let faults = CONTROL.check(text, &machine, &Setting::default(), &mut steps);
    (faults, steps)
}

fn technolog(arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_technolog")).args(arguments).current_dir(root()).output().unwrap();
    let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    (output.status.code(), text)
}

#[test]
fn the_command_tells_line_caret_and_rule_and_its_exit_code() {
    let of = |name: &str| format!("tests/programs/{name}/program.nc");
    let (code, text) = technolog(&["check", &of("bad-feed-zero"), "--control", "2c42-65", "--lang", "en"]);
    assert_eq!(code, Some(1), "{text}");
    for part in ["error[feed-zero]: N2: the feed is 0", "program.nc:3:7", "^^^", "(rule: textbook 3.9.2)"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    // Nobody has said that the control was just switched on.
    let arcs = of("arcs-absolute");
    let (code, text) = technolog(&["check", &arcs, "--control", "2c42-65", "--lang", "en"]);
    assert_eq!(code, Some(1), "{text}");
    assert!(text.contains("say as_powered_on: true in the file of --setting"), "{text}");
    let setting = "tests/programs/arcs-absolute/setting.yaml";
    let (code, text) = technolog(&["check", &arcs, "--control", "2c42-65", "--setting", setting, "--format", "json"]);
    assert_eq!(code, Some(0), "{text}");
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["trace"][1]["motion"], "arc", "{text}");
    assert!(json["time"]["total_min"].as_f64().unwrap() > 0.0);
    for arguments in [
        ["check", "no-such-file.nc", "--control", "2c42-65"].as_slice(),
        &["check", &of("arcs-absolute"), "--control", "other"],
        &["check", &of("arcs-absolute"), "--control", "2c42-65", "--machine", "other"],
        &["check", &of("arcs-absolute"), "--control", "2c42-65", "--setting", "tests/programs/setting-bad.yaml"],
    ] {
        let (code, text) = technolog(arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {text}");
    }
}

/// Nobody is blamed by the limits of a machine that nobody has named; which one is taken, or that none is, is said.
#[test]
fn a_machine_that_nobody_names_is_none() {
    let honest = "tests/programs-haas/honest-without-a-machine/program.nc";
    let (code, text) = technolog(&["check", honest, "--control", "haas-ngc", "--format", "json"]);
    assert_eq!(code, Some(0), "{text}");
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(json["machine"].is_null() && json["time"]["rapid_min"].is_null(), "{text}");
    assert!(json["time"]["feed_min"].as_f64().unwrap() > 0.0, "{text}");
    assert!(text.contains("machine-not-named"), "{text}");
    let (code, text) = technolog(&["check", honest, "--control", "haas-ngc", "--machine", "gf2171", "--lang", "en"]);
    assert_eq!(code, Some(1), "{text}");
    for code in ["speed-beyond-machine", "cannot-tap", "tool-beyond-magazine"] {
        assert!(text.contains(code), "{code}: {text}");
    }
    let old = "examples/appendix-g/program.nc";
    let setting = "examples/appendix-g/setting.yaml";
    let (_, text) = technolog(&["check", old, "--setting", setting, "--lang", "en"]);
    assert!(text.contains("note[machine-assumed]: no machine is named: gf2171 is taken"), "{text}");
    // Without any machine 2С42-65 is not run: its limits are those of one.
    let faults = CONTROL.check("N1 M02", None, &Setting::default(), &mut Trace::default());
    assert_eq!(faults.iter().map(|fault| fault.code).collect::<Vec<_>>(), ["machine-needed"]);
}

/// Zeros and lengths that only the plan assumes, and a machine that nobody has named, cost no block: what is not checked is said
/// once.
#[test]
fn a_limit_that_nobody_has_stated_is_not_checked() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("not-checked");
    fs::create_dir_all(&folder).unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let (_, written) = technolog(&["program", "examples/plate.yaml", "--control", "fanuc"]);
    // 60 mm higher: the longest tool would stand over the zero of the machine.
    let higher = file("higher.nc", &written.replace("Z40.0 H", "Z100.0 H"));
    let part = ["check", &higher, "--control", "fanuc", "--part", "examples/plate.yaml", "--lang", "en"];
    let (code, text) = technolog(&part);
    assert_eq!(code, Some(0), "{text}");
    assert_eq!(text.matches("limit-not-checked").count(), 1, "{text}");
    assert!(text.contains("6/6") && !text.contains("beyond-travel-of"), "{text}");
    let stated = "zeros:\n  G54: {x: 0, y: 0, z: -150}\ncorrectors: {1: 130, 2: 130, 3: 130}\n";
    let setting = file("setting.yaml", stated);
    let (code, text) = technolog(&[&part[..], &["--setting", &setting]].concat());
    assert_eq!(code, Some(1), "{text}");
    assert!(text.contains("error[beyond-travel-of]: N35: axis Z moves to 80 mm"), "{text}");

    let high = ":01\nN1 G17 G40 G49 G80 G90 G54 T1 M06\nN2 G00 X0 Y0 S9000 M03\nN3 G43 H1 Z280\nN4 G01 Z-20 F100\nN5 G00 Z280\nN6 M05\nN7 M02\n";
    let high = file("high.nc", high);
    let old = ["check", &high, "--control", "2c42-65", "--lang", "en"];
    let (code, text) = technolog(&old);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("travels: not checked") && text.contains("spindle speeds: not checked"), "{text}");
    let (code, text) = technolog(&[&old[..], &["--machine", "gf2171"]].concat());
    assert_eq!(code, Some(1), "{text}");
    assert!(text.contains("span-beyond-travel") && text.contains("speed-beyond-machine"), "{text}");
}

/// Behind the last number stands the first, and that may be the program of another part.
#[test]
fn a_number_that_leaves_no_room_for_the_subprograms_is_refused() {
    for (control, number, room) in [
        ("fanuc", "9999", false),
        ("fanuc", "9998", false),
        ("fanuc", "9997", true),
        ("haas-ngc", "9999", false),
        ("mach3", "9999", false),
        ("grbl", "9999", true),
        ("2c42-65", "99", true),
        ("2c42-65", "100", false),
    ] {
        let arguments = ["program", "examples/plate.yaml", "--control", control, "--number", number];
        let (code, text) = technolog(&arguments);
        assert_eq!(code, Some(if room { 0 } else { 2 }), "{control} {number}: {text}");
        let whole = [arguments.as_slice(), &["--no-subprograms"]].concat();
        assert_eq!(technolog(&whole).0, Some(if number == "100" { 2 } else { 0 }), "{control} {number}");
    }
}

/// Without its comma the number would be ten times as large: no control is told to leave it out. And what a program that
/// is not run does not make is no mistake of it.
#[test]
fn a_decimal_comma_is_told_as_a_point_and_nothing_follows_from_it() {
    let folder = root().join("target/tmp/comma-for-point");
    fs::create_dir_all(&folder).unwrap();
    let program = folder.join("program.nc").display().to_string();
    for (control, text) in [
        ("2c42-65", ":01\nN5 G0 X80,5 Y1\nN10 М02\n"),
        ("linuxcnc", "G21 G90\ng0 x80,5 y1\nМ2\n"),
        ("fanuc", "O1001\nG21 G90\nG0 X80,5 Y1.\nМ30\n"),
    ] {
        fs::write(&program, text).unwrap();
        let part = ["check", &program, "--control", control, "--part", "examples/plate.yaml"];
        let (code, output) = technolog(&[part.as_slice(), &["--lang", "en"]].concat());
        assert_eq!(code, Some(1), "{output}");
        for expected in ["`X80,5` has a comma", "help: write X80.5 (", "2 errors", "not-compared"] {
            assert!(output.contains(expected), "{control}: {expected}: {output}");
        }
        assert!(!output.contains("remove") && !output.contains("missing"), "{control}: {output}");
        let (_, output) = technolog(&[part.as_slice(), &["--lang", "uk"]].concat());
        assert!(output.contains("підказка: напишіть X80.5 ("), "{control}: {output}");
        let (_, output) = technolog(&[part.as_slice(), &["--format", "json"]].concat());
        assert!(!output.contains("\"proof\""), "{control}: {output}");
    }
}

#[test]
fn a_bad_setting_tells_all_its_mistakes() {
    let text = fs::read_to_string(root().join("tests/programs/setting-bad.yaml")).unwrap();
    let problems = CONTROL.setting("setting-bad.yaml", &text).unwrap_err();
    let codes: Vec<&str> = problems.iter().map(|problem| problem.code).collect();
    assert_eq!(
        codes,
        ["unknown-key", "bad-override", "bad-axis", "unknown-key", "bad-value", "bad-corrector", "offset-beyond"]
    );
}

/// Words as programs have them, in any order: they reach far more of the interpreter than any bytes do.
fn program() -> impl Strategy<Value = String> {
    let word = prop_oneof![
        (0_u32..100).prop_map(|code| format!("G{code:02}")),
        prop::sample::select(vec![
            "G00", "G01", "G02", "G03", "G10", "G41", "G42", "G40", "G81", "G83", "G86", "G82", "G85", "G80", "G91",
            "G90", "G18", "G19", "G54", "G92", "G45", "G48", "G28", "G30", "M03", "M05", "M06", "M99", "P01", "P02",
            "/", "\n:01 ", "\n:02 ", "L3", "L65535", "S500", "F100", "T1", "D01", "H02", "G43", "G44", "G49",
        ])
        .prop_map(str::to_owned),
        ("[XYZIJKUVWE]", -60_i32..60).prop_map(|(address, value)| format!("{address}{value}")),
        "[A-Z]-?[0-9]{0,6}[.]?[0-9]{0,4}",
        Just("\nN1 ".to_owned()),
    ];
    prop::collection::vec(word, 0..60).prop_map(|words| format!("N1 S500 M03 F100 {}\nN2 M02\n", words.join(" ")))
}

proptest! {
    #![proptest_config(technolog_laws::cases!(400))]

    #[test]
    fn no_words_make_it_panic_and_every_place_is_in_the_text(text in program()) {
        let (faults, _) = run(&text);
        for fault in faults {
            let line = text.lines().nth(fault.span.line as usize - 1);
            prop_assert!(line.is_some_and(|line| fault.span.column as usize <= line.chars().count().max(1)));
        }
    }

    #[test]
    fn no_text_makes_it_panic(text in "\\PC{0,80}(\n\\PC{0,40}){0,4}") {
        run(&text);
    }

    /// A contour in increments is the same contour in positions.
    #[test]
    fn increments_and_positions_agree(points in prop::collection::vec((-150_000_i64..150_000, -90_000_i64..90_000), 1..20)) {
        let mm = technolog::units::Micrometres::new;
        let (mut absolute, mut incremental) = (String::from("N0 S500 M3 F100 G90\n"), String::from("N0 S500 M3 F100 G91\n"));
        let mut last = (0, 0);
        for (index, (x, y)) in points.iter().map(|(x, y)| (x / 10 * 10, y / 10 * 10)).enumerate() {
            writeln!(absolute, "N{index} X{} Y{}", mm(x), mm(y)).unwrap();
            writeln!(incremental, "N{index} X{} Y{}", mm(x - last.0), mm(y - last.1)).unwrap();
            last = (x, y);
        }
        let at = |text: String| -> Vec<_> { run(&(text + "N99 M02\n")).1.iter().map(|step| step.at).collect() };
        prop_assert_eq!(at(absolute), at(incremental));
    }
}
