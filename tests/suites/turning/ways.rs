//! The ways of roughing a shaft: one table, one answer, and a program of each for every control.

use std::fs;
use std::path::Path;
use std::process::Command;

use proptest::prelude::*;
use serde_json::Value;
use technolog::audit::turned::read_back;
use technolog::note::Severity;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::passes::cost::Objective;
use technolog::turning::ways::{Way, Ways, find};
use technolog::turning::workpiece::read_turned;
use technolog::units::RevsPerMinute;
use technolog_testing::KNOWLEDGE;
use technolog_testing::shafts::{shafts, workpiece};

const EXAMPLES: [&str; 4] = ["shaft", "shaft-three-cylinders", "shaft-forging", "shaft-six-steps"];
const CONTROLS: [&str; 3] = ["linuxcnc", "fanuc", "sinumerik"];
const NAMES: [&str; 8] =
    ["longitudinal", "transverse", "per-step", "optimal", "verticals", "levels", "horizontals-a", "horizontals-b"];

fn text(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.yaml"))).unwrap()
}

fn ways(text: &str) -> Ways {
    find(&read_turned("shaft", text, &KNOWLEDGE).unwrap(), Objective::Path, &KNOWLEDGE).unwrap().unwrap()
}

fn turn(args: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    let output = command.current_dir(env!("CARGO_MANIFEST_DIR")).arg("turn").args(args).output().unwrap();
    // 1: nothing holds the shaft of the paper.
    assert!(matches!(output.status.code(), Some(0 | 1)), "{args:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// A file of steps has no allowance: the pass that finishes them takes off what roughing left, and has its speed and feed like any, or
/// no program could be written of a part that is told to be made.
#[test]
fn steps_without_an_allowance_have_programs() {
    let part = "shaft: Steps\nmaterial: steel-45\nmachine: 16k20f3\nblank: {kind: bar, diameter: 80, length: 220}\nholding: \
                chuck-and-centre\nsteps:\n  - {diameter: 35.5, length: 40}\n  - {diameter: 45.5, length: 50}\n  - {diameter: 60.5, length: \
                45}\n  - {diameter: 74.5, length: 20}\nroughing: {longitudinal_depth: 3, transverse_depth: 3}\n";
    let ways = ways(part);
    for operation in [Some(ways.operation.clone()), ways.operation_by("horizontals-a")] {
        for program in programs(&operation.unwrap(), "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap() {
            assert!(program.files.is_ok(), "{:?}", program.files);
        }
    }
}

fn refused(ways: &Ways, code: &str) -> Vec<&'static str> {
    let all = ways.ways.iter().filter(|way| way.refused.as_ref().is_some_and(|why| why.code() == code));
    all.map(|way| way.name).collect()
}

/// 12.4-11: on the examples the third scheme is the quickest, with the second within 2 % of it (lecture, l. 788-792), and
/// no sequence of the paper is quicker.
#[test]
fn the_answer_is_the_quickest_way_that_holds() {
    for name in EXAMPLES {
        let found = ways(&text(name));
        assert_eq!(found.ways.iter().map(|way| way.name).collect::<Vec<_>>(), NAMES, "{name}");
        let time = |name: &str| found.ways.iter().find(|way| way.name == name).unwrap().time_min.0;
        let answer = found.recommended.as_ref().unwrap();
        let (best, next) = (answer.variant.unwrap(), answer.next.unwrap());
        let clean = |way: &&Way| way.refused.is_none() && way.leaves.is_none() && way.name != best;
        for way in found.ways.iter().filter(clean) {
            assert!(time(best) <= time(next) && time(next) <= way.time_min.0, "{name} {}", way.name);
        }
        assert!((time(next) - time(best) - answer.margin_min.0).abs() < 1e-9, "{name}");
        assert_eq!(best, "horizontals-a", "{name}");
        assert!(time("levels") / time("horizontals-a") < 1.02, "{name}");
    }
}

/// The paper, p. 1-2: between centres along the axis only; a forging or casting is no full cylinder, whatever its way.
#[test]
fn ways_that_do_not_apply_are_told_with_the_reason() {
    let centres = ways(&text("shaft").replacen("steps:", "holding: centres\nsteps:", 1));
    assert_eq!(refused(&centres, "way-across"), ["transverse", "per-step", "optimal"]);
    let forging = ways(&text("shaft-forging"));
    assert_eq!(refused(&forging, "way-full-cylinder"), NAMES[..4]);
    assert!(forging.ways.iter().skip(4).all(|way| way.refused.is_none()));
    assert_eq!(forging.pass_direction.table, "pass-direction");
    assert!(forging.sequences.findings.iter().any(|one| one.note.code() == "contour-passes-elsewhere"));
}

/// An edge of 95° leaves a face inclined: over a pass of 4 mm by 4 · tan 5° = 0.35 mm. Passes along or across alone do not
/// go up the face again, so a shaft that nothing finishes is left so; where a finishing pass follows, nothing is told.
#[test]
fn a_way_that_leaves_metal_standing_is_told_and_not_recommended() {
    let paper = ways(&text("shaft"));
    assert_eq!(refused(&paper, "way-by-proof"), [""; 0]);
    let leaves = paper.ways.iter().filter(|way| way.leaves.is_some()).map(|way| way.name);
    assert_eq!(leaves.collect::<Vec<_>>(), NAMES[..4]);
    let longitudinal = paper.ways[0].leaves.as_ref().unwrap();
    let note = paper.operation_by("longitudinal").unwrap().findings;
    let stands = note.iter().find(|one| one.note.code() == "swept-stands").unwrap();
    let thickness: f64 = stands.note.figure_text("thickness").unwrap().parse().unwrap();
    assert!(thickness > 0.1 && thickness < 0.35, "{thickness} {longitudinal:?}");
    let finished = ways(&text("shaft-three-cylinders"));
    assert!(finished.ways[0].refused.is_none() && finished.ways[0].leaves.is_none());
}

#[test]
fn a_shaft_without_stock_has_no_ways() {
    let none =
        ways(&text("shaft").replacen("diameter: 65", "diameter: 50", 1).replacen("diameter: 40", "diameter: 50", 1));
    assert!(none.ways.is_empty() && none.recommended.is_none());
    assert!(none.sequences.findings.iter().any(|one| one.note.code() == "nothing-to-turn"));
}

/// Text, JSON and YAML give one answer.
#[test]
fn every_output_has_the_same_answer() {
    for name in EXAMPLES {
        let file = format!("examples/{name}.yaml");
        let json: Value = serde_json::from_str(&turn(&[&file, "--format", "json"])).unwrap();
        let taken = json["recommended"]["variant"].as_str().unwrap();
        let yaml = turn(&[&file, "--format", "yaml"]);
        assert!(yaml.contains(&format!("\nrecommended:\n  variant: {taken}\n")), "{name}");
        let page = turn(&[&file, "--lang", "en"]);
        let row: Vec<&str> = page.lines().filter(|line| line.starts_with(" + ")).collect();
        assert!(row.len() == 1 && row[0].contains(taken), "{name}: {row:?}");
        assert!(page.contains(&format!("--variant {taken}`")), "{name}");
    }
}

/// Every way is written for every control, read back, and carried through the proof: nothing is cut below the part or
/// hit; and where the way holds, nothing stands that the operation itself does not leave.
#[test]
fn every_way_is_a_program_of_every_control() {
    let spindle = Some(RevsPerMinute(600.0));
    for name in EXAMPLES {
        let found = ways(&text(name));
        for (index, way) in found.ways.iter().enumerate() {
            let operation = found.operation_by(way.name).unwrap();
            let wrong: Vec<_> = operation.findings.iter().filter(|one| one.severity <= Severity::Wrong).collect();
            let usual: Vec<_> = found.operation.findings.iter().filter(|one| one.severity <= Severity::Wrong).collect();
            let only_usual = wrong.iter().all(|one| usual.contains(one));
            assert!(only_usual || way.refused.is_some() || way.leaves.is_some(), "{name} {}: {wrong:?}", way.name);
            // Of the larger shafts each way is read by one control only: reading takes long.
            let controls = if name == "shaft" { &CONTROLS } else { &CONTROLS[index % 3..=index % 3] };
            for &control in controls {
                let written = programs(&operation, control, Form::Motions, spindle, &KNOWLEDGE).unwrap();
                let files =
                    written[0].files.as_ref().unwrap_or_else(|why| panic!("{name} {} {control}: {why:?}", way.name));
                let why = read_back(&operation, written[0].set_up, control, files, &KNOWLEDGE).unwrap();
                assert_eq!(why, None, "{name} {} {control}", way.name);
            }
        }
    }
}

/// A way that does not hold is written if it is safe, with the reason on the error stream.
#[test]
fn a_refused_way_is_written_with_its_reason() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args([
        "turn",
        "examples/shaft-three-cylinders.yaml",
        "--lang",
        "en",
    ]);
    command.args(["--show", "program", "--spindle", "600", "--variant", "transverse"]);
    let output = command.output().unwrap();
    let (program, told) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert!(
        program.contains("G1 X51.2") && told.contains("transverse: it has passes across the axis"),
        "{told}\n{program}"
    );
}

proptest! {
    #![proptest_config(technolog_laws::cases!(10))]

    /// Whatever the shaft: a way that holds is written for every control and read back, and one of them is the answer.
    #[test]
    fn every_way_that_holds_is_written(shaft in shafts(60)) {
        let found = find(&workpiece(&shaft), Objective::Path, &KNOWLEDGE).unwrap().unwrap();
        let hold: Vec<&Way> = found.ways.iter().filter(|way| way.refused.is_none()).collect();
        prop_assert_eq!(found.recommended.as_ref().is_some_and(|answer| answer.variant.is_some()), !hold.is_empty());
        for way in hold {
            let Some(operation) = found.operation_by(way.name) else { continue };
            for control in CONTROLS {
                let written = programs(&operation, control, Form::Motions, Some(RevsPerMinute(600.0)), &KNOWLEDGE).unwrap();
                let files = written[0].files.as_ref().unwrap_or_else(|why| panic!("{} {control}: {why:?}", way.name));
                let why = read_back(&operation, written[0].set_up, control, files, &KNOWLEDGE).unwrap();
                prop_assert!(why.is_none(), "{} {control}: {why:?}", way.name);
            }
        }
    }
}
