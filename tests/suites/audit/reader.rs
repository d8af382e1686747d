//! The reader of hand-written plans: impossible figures, letters that look alike, and short forms of writing.

use std::path::Path;

use technolog::audit::stated::Stated;
use technolog::audit::{Unreadable, audit, read_plan};
use technolog::note::Severity;
use technolog::plan::{CuttingMethod, Operation};
use technolog::report::Lang;
use technolog_testing::{KNOWLEDGE, planned, read as read_part};

fn right() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit/right.yaml");
    std::fs::read_to_string(path).unwrap()
}

fn read(text: &str) -> Result<Stated, Unreadable> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit");
    let files = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    read_plan("plan.yaml", text, &KNOWLEDGE, &files)
}

/// The sound plan with one change.
fn with(from: &str, to: &str) -> String {
    let text = right();
    assert!(text.contains(from), "`{from}`");
    text.replacen(from, to, 1)
}

fn findings(text: &str) -> Vec<String> {
    let stated = read(text).unwrap_or_else(|why| panic!("{why:?}"));
    let found = audit(&stated, &KNOWLEDGE).unwrap().findings;
    found.into_iter().map(|one| format!("{:?} {} {}", one.severity, one.rule, one.field)).collect()
}

/// A figure that there cannot be is a slip of the author, told at its line; the rest of the plan is read and judged.
#[test]
fn a_figure_that_cannot_be_is_a_slip() {
    for (from, to, message) in [
        ("depth: 40", "depth: -5", "-5 cannot be the depth: it must not be below zero"),
        ("count: 6", "count: -2", "-2 cannot be the number of holes: it must be above zero"),
        ("count: 6", "count: 0", "0 cannot be the number of holes: it must be above zero"),
        ("count: 6", "count: 2.5", "2.5 cannot be the number of holes: it must be a whole number"),
        ("    rpm: 800", "    rpm: 0", "0 cannot be the spindle speed taken: it must be above zero"),
        ("clamps: 2", "clamps: 0", "0 cannot be the number of clamps: it must be above zero"),
        ("corrector: 2", "corrector: 1.5", "1.5 cannot be the offset register: it must be a whole number"),
        ("feed: 0.325", "feed: -0.2", "-0.2 cannot be the feed: it must be above zero"),
        ("machine: ", "machine: -", "-2.606 cannot be the machine time: it must not be below zero"),
        ("distance: 283", "distance: 0", "0 cannot be the distance to the clamp: it must be above zero"),
    ] {
        let text = with(from, to);
        let line = right().lines().zip(text.lines()).position(|(a, b)| a != b).unwrap() + 1;
        let stated = read(&text).unwrap_or_else(|why| panic!("`{to}`: {why:?}"));
        let [remark] = stated.remarks.as_slice() else { panic!("{to}: {:?}", stated.remarks) };
        assert_eq!(Lang::EN.say(&remark.note), message);
        assert_eq!((remark.place.line as usize, remark.severity), (line, Severity::Wrong), "{to}");
    }
    let problems = read(&with("depth: 40", "depth: ７.9")).err().unwrap().problems;
    let [problem] = problems.as_slice() else { panic!("{problems:?}") };
    assert_eq!(Lang::EN.say(&problem.message), "`７.9` is not a number");
    assert!(problem.help.is_some());
}

/// What the reader of parts refuses is refused of the part in a stored plan, too.
#[test]
fn a_roughness_beyond_the_tables_is_a_mistake_of_a_stored_plan() {
    let part = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/plate.yaml")).unwrap();
    let plan = serde_json::to_string_pretty(&planned(&read_part(&part), CuttingMethod::Formula)).unwrap();
    let text = plan.replacen("\"roughness\": \"Ra 12.5\"", "\"roughness\": \"Ra 1205\"", 1);
    assert_ne!(plan, text);
    let none = |_: &str| Err("no files here".to_owned());
    let problems = read_plan("plan.json", &text, &KNOWLEDGE, &none).unwrap_err().problems;
    let [problem] = problems.as_slice() else { panic!("{problems:?}") };
    let message = Lang::EN.say(&problem.message);
    assert!(message.starts_with("`Ra 1205` is outside Ra 0.008 to Ra 100"), "{message}");
    assert!(problem.place.is_some() && problem.help.is_some());
}

/// A part inside a stored plan that nothing can be planned for is told where it stands, whatever makes it so; the tables are
/// not at fault.
#[test]
fn a_part_that_cannot_be_planned_is_a_mistake_of_the_stored_plan() {
    let part = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/plate.yaml")).unwrap();
    let plan = serde_json::to_value(planned(&read_part(&part), CuttingMethod::Formula)).unwrap();
    for (field, value) in [
        ("/part/material", "unobtainium".into()),
        ("/part/machine", "no-machine".into()),
        ("/part/holes/0/diameter/nominal", 0.into()),
        ("/part/holes/0/diameter/nominal", (-10).into()),
        ("/part/holes/0/diameter/nominal", 600.into()),
        ("/part/holes/0/diameter/it", 5.into()),
        ("/part/holes/0/depth", 0.into()),
        ("/part/holes/0/depth", (-1).into()),
        ("/part/holes/0/centre_tolerance", 0.into()),
        ("/part/holes/0/centre_tolerance", 1000.into()),
        // None stands there.
        ("/part/holes/0", serde_json::json!({"counterbore": {"diameter": 600, "depth": 5}})),
        // A way over points so far away overflowed.
        ("/part/holes/0/at/0/0", 9_007_199_254_740_993_i64.into()),
    ] as [(&str, serde_json::Value); 12]
    {
        let mut plan = plan.clone();
        match (plan.pointer_mut(field).unwrap(), value.clone()) {
            (serde_json::Value::Object(hole), serde_json::Value::Object(more)) => hole.extend(more),
            (old, new) => *old = new,
        }
        let text = serde_json::to_string_pretty(&plan).unwrap();
        let none = |_: &str| Err("no files here".to_owned());
        let problem = match read_plan("plan.json", &text, &KNOWLEDGE, &none) {
            Err(unreadable) => unreadable.problems.into_iter().next().unwrap(),
            Ok(stated) => match audit(&stated, &KNOWLEDGE) {
                // Planned as it stands: the audit says what of the plan does not belong to such a part.
                Ok(found) if found.findings.iter().any(|one| one.severity <= Severity::Wrong) => continue,
                Ok(_) => panic!("{field} {value}: nothing is said"),
                Err(error) => stated.at_fault(&error).unwrap(),
            },
        };
        let line = text.lines().position(|line| line.trim_start().starts_with("\"part\": {")).unwrap() + 1;
        assert!(
            problem.place.as_ref().is_some_and(|place| place.line as usize >= line),
            "{field} {value}: {problem:?}"
        );
        assert!(problem.help.is_some(), "{field} {value}");
    }
}

#[test]
fn corrections_may_have_any_sign() {
    for correction in ["correction: 60.4", "correction: 0", "correction: -60.4"] {
        assert!(read(&with("correction: -60.4", correction)).is_ok(), "{correction}");
    }
}

#[test]
fn digits_of_another_script_and_files_that_are_no_text_have_a_remedy_of_their_own() {
    let help = |text: &str, files: &dyn Fn(&str) -> Result<String, String>| {
        let problems = read_plan("plan.yaml", text, &KNOWLEDGE, files).err().unwrap().problems;
        problems
            .iter()
            .filter_map(|one| one.help.as_ref().map(|help| Lang::EN.say(help)))
            .collect::<Vec<_>>()
            .join("; ")
    };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit");
    let files = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    assert!(help(&with("depth: 40", "depth: ４0"), &files).contains("digits 0 to 9"));
    let binary = |_: &str| String::from_utf8(vec![0, 0xff]).map_err(|error| error.to_string());
    assert!(help("part: x.yaml\n", &binary).contains("not text"));
    let missing = |_: &str| Err("No such file or directory (os error 2)".to_owned());
    assert!(help("part: x.yaml\n", &missing).contains("relative"));
}

#[test]
fn a_cyrillic_letter_that_looks_like_the_latin_one_is_meant_as_that() {
    let before = findings(&right());
    let text = right().replace("hole: A,", "hole: А,");
    assert_ne!(text, right());
    assert_eq!(findings(&text), before);
}

/// Every way of writing the same plan has the same findings.
#[test]
fn a_plan_may_be_written_in_several_ways() {
    let sound = findings(&right());
    for (from, to) in [
        ("operation: drill,", "operation: свердління,"),
        ("operation: drill,", "operation: Свердлити,"),
        ("for: [3, 4]", "for: T2"),
        ("for: [3, 4]", "for: [T2]"),
        ("for: [3, 4]", "for: Т2"),
    ] {
        let text = with(from, to);
        assert_eq!(findings(&text), sound, "{to}");
    }
    for (name, operation) in Operation::NAMES {
        use technolog::report::{Lang, operation_named, operation_noun, operation_verb};
        for called in [operation_noun(name, Lang::UK), operation_verb(name, Lang::UK)] {
            assert_eq!(operation_named(called, Lang::UK), Some(*operation), "{called}");
        }
    }
    for (called, name) in [
        ("розвертання чорнове", Some("rough-ream")),
        ("чистове розгортання", Some("finish-ream")),
        ("Остаточно розвернути", Some("finish-ream")),
        ("фаска", Some("chamfer")),
        ("нарізання різьби", Some("tap")),
        ("розточити начорно", Some("rough-bore")),
        ("розточити", None),
        ("розвертання", None),
    ] {
        let operation = technolog::report::operation_named(called, Lang::UK);
        assert_eq!(operation, name.and_then(Operation::from_name), "{called}");
    }
    let text = with("operation: drill,", "operation: розточити,");
    let why = read(&text).unwrap_err().problems;
    let said: Vec<String> = why.iter().map(|one| one.text(|note| Lang::UK.say(note))).collect();
    let three = "чорнове розточування, напівчистове розточування, чистове розточування";
    assert!(said.iter().any(|one| one.contains("розточити") && one.contains(three)), "{said:?}");
}

#[test]
fn one_holder_is_written_once() {
    let part = "part: {part: x, material: Сталь 45, blank: {kind: plate, length: 100, width: 100, thickness: 20}, \
                machine: gf2171, holes: [{name: A, diameter: 10H12, through: true, roughness: Ra 12.5, \
                centre_tolerance: 0.5, at: [[0, 0]]}]}\n";
    let holder = "holder: {designation: \"191113040\", clamp_min: 5, clamp_max: 25, length: 61.6}";
    let text =
        |second: &str| format!("{part}tools:\n  T1: {{overhang: 10, {holder}}}\n  T2: {{overhang: 12, {second}}}\n");
    let figures = |text: &str| {
        let stated = read(text).unwrap_or_else(|why| panic!("{why:?}"));
        let tool = &stated.tools[1];
        let figures: Vec<_> = tool.figures.iter().map(|(quantity, figure)| (*quantity, figure.text.clone())).collect();
        (tool.holder.as_ref().map(|holder| holder.value.clone()), figures)
    };
    assert_eq!(figures(&text("holder: T1")), figures(&text(holder)));
    for wrong in ["holder: T2", "holder: T9", "holder: x"] {
        assert_eq!(read(&text(wrong)).err().unwrap().problems.len(), 1, "{wrong}");
    }
}

#[test]
fn a_tool_without_rows_and_several_rows_for_a_clamping_are_told() {
    for (from, to, code) in [("for: [3, 4]", "for: T9", "unknown-row"), ("  for: 5\n", "  for: [4, 5]\n", "bad-value")]
    {
        let text = with(from, to);
        let problems = read(&text).err().unwrap_or_else(|| panic!("{to}")).problems;
        assert_eq!(problems.iter().map(|one| one.code).collect::<Vec<_>>(), [code], "{to}");
    }
}
