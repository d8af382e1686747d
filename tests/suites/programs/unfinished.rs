//! Parts that a program of their machine does not finish: the program says so, and is not written unless forced to.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use technolog::motion::time::Clock;
use technolog::plan::{HolePlan, Operation};
use technolog::program::proof::PlannedJob;
use technolog::program::written::Form;
use technolog::program::{Language, Setting};
use technolog::shop::Shop;
use technolog::units::Micrometres;
use technolog_testing::KNOWLEDGE;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn folder(name: &str) -> PathBuf {
    let folder = root().join("target/tmp/unfinished").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn technolog(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_technolog")).current_dir(folder).args(args).output().unwrap()
}

const THREAD: &str = "
  - {name: T, thread: M10-6H, depth: 18, centre_tolerance: 0.3, at: [[0, 35]]}
";
const GROOVE: &str = "
  - {name: G, diameter: 14H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, groove: {diameter: 18, width: 3, depth: 10}, at: [[0, 0]]}
";
const NO_ROUTE: &str = "
  - {name: A, diameter: 14H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[30, 0]]}
  - {name: R, diameter: 20H6, through: true, roughness: Ra 0.1, centre_tolerance: 0.05, at: [[0, -40]]}
";
const HONED: &str = "
  - {name: R, diameter: 20H6, through: true, roughness: Ra 0.8, centre_tolerance: 0.2, at: [[0, -40]]}
";

/// What is left undone, with the remark at the head of a program.
const PARTS: [(&str, &str, &str); 4] = [
    ("honed", HONED, "(UNFINISHED: R: HONE LEFT TO ANOTHER MACHINE)"),
    ("thread", THREAD, "(UNFINISHED: T: TAP LEFT TO ANOTHER MACHINE)"),
    ("groove", GROOVE, "(UNFINISHED: G: NOT MADE AS DRAWN)"),
    ("no-route", NO_ROUTE, "(UNFINISHED: R: NOT MADE AT ALL)"),
];

/// A machine that taps, with a control that does not: the thread is left to another one, and that is said.
#[test]
fn a_control_without_a_tapping_cycle_leaves_threads_undone() {
    let folder = folder("taps");
    let part = "part: Body\nmaterial: steel-45\nblank: {kind: plate, length: 240, width: 160, thickness: 30}\n\
                machine: ir500pmf4\nfixture: {height: 60}\nholes:\n  \
                - {name: T, thread: M10-6H, depth: 18, centre_tolerance: 0.3, at: [[0, 35], [40, 35]]}\n";
    fs::write(folder.join("part.yaml"), part).unwrap();
    for control in Language::names(&technolog_testing::KNOWLEDGE) {
        let write = ["program", "part.yaml", "--control", control, "--lang", "en", "--force", "-o", "p.nc"];
        let written = technolog(&folder, &write);
        let told = String::from_utf8(written.stderr).unwrap();
        let text = fs::read_to_string(folder.join("p.nc")).unwrap();
        let taps = !["grbl", "mach3"].contains(&control);
        assert_eq!(written.status.code(), Some(i32::from(!taps)), "{control}: {told}");
        assert_eq!(text.contains("(UNFINISHED: T: TAP LEFT TO ANOTHER MACHINE)"), !taps, "{control}: {text}");
        assert_eq!(text.contains("G84"), taps, "{control}: {text}");
        assert_eq!(told.contains("T: tapping: left to another machine"), !taps, "{control}: {told}");
        let check = ["check", "p.nc", "--control", control, "--part", "part.yaml", "--lang", "en"];
        let read = technolog(&folder, &check);
        let page = String::from_utf8([read.stdout, read.stderr].concat()).unwrap();
        assert_eq!(read.status.code(), Some(0), "{control}: {page}");
    }
}

/// What is left to another machine has no tool, no offset and no time in the program's set-up: the tap T3 that only the
/// thread needs, and not the drill of both holes. The time is that of the program's own clock but for what hands do.
#[test]
fn tools_and_time_are_those_of_a_program_that_leaves_taps() {
    let text = "part: Body\nmaterial: steel-45\nblank: {kind: plate, length: 240, width: 160, thickness: 30}\n\
                machine: ir500pmf4\nfixture: {height: 60}\nholes:\n  \
                - {name: T, thread: M10-6H, depth: 18, centre_tolerance: 0.3, at: [[0, 35], [40, 35]]}\n  \
                - {name: A, diameter: 12H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[0, -40]]}\n";
    let plan = technolog_testing::planned(&technolog_testing::read(text), Default::default());
    let whole: Vec<u32> = plan.tools.iter().map(|tool| tool.number).collect();
    for (control, language) in technolog_testing::languages() {
        let taps = !["grbl", "mach3"].contains(&control);
        let planned = PlannedJob::of(plan.clone(), &language, &KNOWLEDGE).unwrap();
        let tools = &planned.plan.tools;
        let tapping =
            |hole: &HolePlan| hole.transitions.iter().any(|it| it.operation == Operation::Tap && !it.elsewhere);
        assert_eq!(planned.plan.holes.iter().any(tapping), taps);
        assert_eq!(tools.len(), whole.len() - usize::from(!taps), "{control}");
        let works = planned.job.setups.iter().flat_map(|setup| &setup.works);
        let works: BTreeSet<u32> = works.map(|work| work.tool).collect();
        assert_eq!(works, tools.iter().map(|tool| tool.number).collect(), "{control}");
        assert_eq!(planned.job.correctors.len(), tools.len(), "{control}");
        assert_eq!(tools.iter().map(|tool| tool.correction_mm).max(), Some(Micrometres::ZERO), "{control}");

        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        let text = language.write(&planned.job, Form::read(&shop).unwrap()).text();
        let setting = Setting::of_job(&planned.job);
        let mut clock = Clock::new(&shop.machine, setting.start);
        language.check(&text, &shop.machine, &setting, &mut clock);
        let time = planned.plan.time;
        let ratio = (time.total_min.0 - time.hand_min.0) / clock.times().total_min.0;
        // Programs round feeds down to whole millimetres a minute.
        assert!((ratio - 1.0).abs() < 0.05, "{control}: {ratio}, {time:?}, {:?}", clock.times());
    }
}

#[test]
fn a_program_that_leaves_work_undone_is_not_written_unless_forced_and_says_so() {
    let head = "part: Body\nmaterial: steel-45\nblank: {kind: plate, length: 240, width: 160, thickness: 30}\nmachine: gf2171\nholes:";
    for (name, holes, remark) in PARTS {
        let left = ["thread", "honed"].contains(&name);
        let folder = folder(name);
        fs::write(folder.join("part.yaml"), format!("{head}{holes}")).unwrap();
        for control in Language::names(&technolog_testing::KNOWLEDGE) {
            let write = ["program", "part.yaml", "--control", control, "--lang", "en"];
            let refused = technolog(&folder, &[&write[..], &["-o", "p.nc"]].concat());
            let told = String::from_utf8(refused.stderr).unwrap();
            assert_eq!(refused.status.code(), Some(1), "{told}");
            assert!(!folder.join("p.nc").exists() && told.contains("not-written"), "{name} {control}: {told}");
            assert!(technolog(&folder, &write).stdout.is_empty(), "nothing for a file of the shell either");

            let forced = technolog(&folder, &[&write[..], &["--force", "-o", "p.nc"]].concat());
            assert_eq!(forced.status.code(), Some(1));
            let text = fs::read_to_string(folder.join("p.nc")).unwrap();
            fs::remove_file(folder.join("p.nc")).unwrap();
            assert!(text.lines().next().unwrap().contains("DO NOT RUN: "), "{text}");
            assert_eq!(text.contains(remark), control != "2c42-65", "{text}");
            // The first line is no word for the control.
            fs::write(folder.join("forced.nc"), &text).unwrap();
            let check = ["check", "forced.nc", "--control", control, "--part", "part.yaml", "--lang", "en"];
            let read = technolog(&folder, &check);
            let page = String::from_utf8([read.stdout, read.stderr].concat()).unwrap();
            assert_eq!(read.status.code(), Some(i32::from(!left)), "{page}");
            assert!(name != "thread" || page.contains("T: tapping: left to another machine"), "{page}");
        }
        let setting = technolog(&folder, &["program", "part.yaml", "--show", "setting", "--lang", "en"]);
        let setting = String::from_utf8(setting.stdout).unwrap();
        assert!(setting.starts_with("# Unfinished: "), "{setting}");
        // The plan and the report say so, too.
        for command in [&["plan", "part.yaml"][..], &["explain", "part.yaml", "--hole", &remark[13..14]]] {
            let told = technolog(&folder, &[command, &["--lang", "en"]].concat());
            let page = String::from_utf8(told.stdout).unwrap();
            assert_eq!(told.status.code(), Some(1), "{name}: {page}");
            assert!(!left || command[0] == "explain" || page.contains("left to another machine"), "{name}: {page}");
        }
        let report = technolog(&folder, &["report", "part.yaml", "-o", "part.md", "--lang", "en"]);
        assert_eq!(report.status.code(), Some(1), "{name}");
    }
}
