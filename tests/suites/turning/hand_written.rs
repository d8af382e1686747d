//! Programs of lathes as people write them, in `tests/turned-programs`: for each nothing is wrong, and each of the slips beside it
//! is. A slip is a line of its name, what stands in the program, and what stands there in its place, parted by ` | `; `\n` is the end
//! of a line, and `@2:` in front means the second place with that text.

use std::fs;
use std::path::PathBuf;

use technolog::audit::turned::{against_lathe, compare_with_part};
use technolog::note::Severity;
use technolog::program::Fault;
use technolog::program::lathe::{LatheLanguage, Subprogram, is_serious, read};
use technolog::turning::operation::{Operation, plan};
use technolog::turning::tooling::Lathe;
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

/// The least number of slips for each program.
const SLIPS: usize = 8;

fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/turned-programs"))
}

fn operation(part: &str) -> Operation {
    let path = folder().join(format!("{part}.yaml"));
    let text = fs::read_to_string(&path).unwrap();
    plan(&read_turned(&path.to_string_lossy(), &text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap()
}

/// Beside a tailstock, and out of a relief before a wall, both axes may not go home at once: which of them is first nobody knows.
#[test]
fn a_way_home_that_may_meet_something_is_doubtful() {
    for (name, from, to) in [
        ("spindle.linuxcnc-lathe", "G91 G28 X0\nG28 Z0\nG90\nM5\nM9\n(T2", "G28\nM5\nM9\n(T2"),
        ("stud.fanuc-lathe", "Z-28.933\nG0 X39.\nG28 U0.\nG28 W0.", "Z-28.933\nG28 U0. W0."),
    ] {
        let (part, control) = name.split_once('.').unwrap();
        let operation = operation(part);
        let honest = fs::read_to_string(folder().join(format!("{name}.nc"))).unwrap();
        let homes = |text: &str| {
            let run = read(text, &LatheLanguage::read(control, &KNOWLEDGE).unwrap(), &[] as &[Subprogram<'_>]);
            let faults = compare_with_part(&operation, 1, text, &run, &KNOWLEDGE).unwrap();
            faults.into_iter().filter(|fault| fault.code == "turned-home-way").map(|fault| fault.severity).collect()
        };
        let found: Vec<Severity> = homes(&honest);
        assert_eq!(found, [], "{name}");
        let found: Vec<Severity> = homes(&honest.replacen(from, to, 1));
        assert_eq!(found, [Severity::Doubtful], "{name}");
    }
}

/// What must not be run in a program, with its line.
fn serious(operation: &Operation, control: &str, text: &str) -> Vec<(&'static str, u32)> {
    let language = LatheLanguage::read(control, &KNOWLEDGE).unwrap();
    let run = read(text, &language, &[] as &[Subprogram<'_>]);
    let mut faults: Vec<Fault> = run.faults.clone();
    faults.extend(compare_with_part(operation, 1, text, &run, &KNOWLEDGE).unwrap());
    let lathe = Lathe::find(&KNOWLEDGE, operation.workpiece.machine.as_deref().unwrap()).unwrap();
    faults.extend(against_lathe(&run, &lathe).unwrap());
    faults.iter().filter(|fault| is_serious(fault)).map(|fault| (fault.code, fault.span.line)).collect()
}

/// A program with one slip: its name and its text.
fn slipped(text: &str, slip: &str) -> (String, String) {
    let parts: Vec<String> = slip.split(" | ").map(|part| part.trim().replace("\\n", "\n")).collect();
    let [name, from, to] = &parts[..] else { panic!("{slip}") };
    let (nth, from) = match from.strip_prefix('@').and_then(|rest| rest.split_once(':')) {
        Some((nth, from)) => (nth.parse::<usize>().unwrap(), from),
        None => (1, from.as_str()),
    };
    let (at, _) = text.match_indices(from).nth(nth - 1).unwrap_or_else(|| panic!("{slip}"));
    (name.clone(), format!("{}{to}{}", &text[..at], &text[at + from.len()..]))
}

#[test]
fn honest_programs_are_right_and_their_slips_are_wrong() {
    let mut names: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().to_str()?.strip_suffix(".nc").map(str::to_owned))
        .collect();
    names.sort();
    assert!(names.len() >= 6, "{names:?}");
    for name in names {
        let (part, control) = name.split_once('.').unwrap();
        let operation = operation(part);
        let text = fs::read_to_string(folder().join(format!("{name}.nc"))).unwrap();
        assert_eq!(serious(&operation, control, &text), [], "{name}");
        let slips = fs::read_to_string(folder().join(format!("{name}.slips"))).unwrap();
        assert!(slips.lines().count() >= SLIPS, "{name}");
        for slip in slips.lines() {
            let (slip, text) = slipped(&text, slip);
            assert!(!serious(&operation, control, &text).is_empty(), "{name}: {slip}");
        }
    }
}
