//! The set-up of a part: on the table, within reach, held.

use technolog::note::{Finding, Severity};
use technolog::plan::{CuttingMethod, Plan};
use technolog_testing::{planned, read};

/// A part of steel 45 on the ГФ2171: its blank, more lines of the file, and the places of its holes.
fn plan(blank: [u32; 3], more: &str, at: &str) -> Plan {
    let [length, width, thickness] = blank;
    let text = format!(
        "part: P\nmaterial: steel-45\nmachine: gf2171\n\
         blank: {{kind: plate, length: {length}, width: {width}, thickness: {thickness}}}\n{more}\nholes:\n  \
         - {{name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: {at}}}\n"
    );
    planned(&read(&text), CuttingMethod::Formula)
}

fn found<'p>(plan: &'p Plan, code: &str) -> Option<&'p Finding> {
    plan.findings.iter().find(|finding| finding.note.code() == code)
}

/// The figures of the finding with that code, as they are said.
#[track_caller]
fn figures(plan: &Plan, code: &str, names: &[&str]) -> (Severity, Vec<String>) {
    let finding = found(plan, code).unwrap_or_else(|| panic!("no {code}: {:?}", plan.findings));
    let figure = |name: &&str| finding.note.figure(name).unwrap_or_else(|| panic!("{name}")).text().into_owned();
    (finding.severity, names.iter().map(figure).collect())
}

/// 0.9 · 0.38 · 0.25 m³ of steel, 7850 kg/m³, are 671 kg; of 0.149 m it is 400.02 kg, of 0.148 m 397.3 kg.
#[test]
fn a_plate_heavier_than_the_table_bears_is_told_without_its_mass_in_the_file() {
    let heavy = plan([900, 380, 250], "", "[[-50, 0], [50, 0]]");
    assert_eq!(
        figures(&heavy, "plate-too-heavy", &["mass", "limit"]),
        (Severity::Error, vec!["671".into(), "400".into()])
    );
    assert!(heavy.has_errors());
    assert!(found(&plan([900, 380, 149], "", "[[0, 0]]"), "plate-too-heavy").is_some());
    assert!(found(&plan([900, 380, 148], "", "[[0, 0]]"), "plate-too-heavy").is_none());
    // The file knows better: a casting with hollows.
    assert!(found(&plan([900, 380, 250], "mass: 390", "[[0, 0]]"), "plate-too-heavy").is_none());
    let stated = plan([500, 300, 40], "mass: 500", "[[0, 0]]");
    assert_eq!(figures(&stated, "too-heavy", &["mass", "limit"]), (Severity::Error, vec!["500".into(), "400".into()]));
}

/// The table is 1600 by 400 mm, and the middle of the part lies over its middle.
#[test]
fn what_lies_beyond_the_edge_of_the_table_is_told() {
    let names = ["axis", "over"];
    let long = plan([1700, 200, 20], "", "[[-50, 0], [50, 0]]");
    assert_eq!(figures(&long, "part-over-edge", &names), (Severity::Doubtful, vec!["X".into(), "50".into()]));
    assert!(found(&long, "clamp-off-table").is_none(), "its own clamps stand over the table: {:?}", long.clamping);
    let clamps = "fixture: {clamps: [{at: [-830, 0]}, {at: [830, 0]}]}";
    let names = ["at", "away", "edge"];
    let off = plan([1700, 200, 20], clamps, "[[-50, 0], [50, 0]]");
    assert_eq!(
        figures(&off, "clamp-off-table", &names),
        (Severity::Wrong, vec!["[830; 0]".into(), "830".into(), "800".into()])
    );
    // What the fixture of the file bears is for who made it.
    let borne = plan([1700, 200, 20], &clamps.replace("{clamps", "{height: 40, clamps"), "[[-50, 0], [50, 0]]");
    assert_eq!(figures(&borne, "clamp-off-table", &names).0, Severity::Doubtful);
    assert!(!plan([1600, 400, 20], "", "[[-50, 0]]").has_errors());
}

/// Travels of 500 mm to both sides along X and 200 along Y; the column stands 500 mm behind the spindle.
#[test]
fn work_that_the_axes_do_not_reach_where_the_part_lies_is_told() {
    let far = plan([1200, 300, 20], "", "[[-550, 0], [550, 0]]");
    assert_eq!(
        figures(&far, "beyond-travel", &["span", "travel"]),
        (Severity::Error, vec!["1100".into(), "1000".into()])
    );
    // 1000 mm apart, and off the middle: the part is shifted, and all is reached.
    assert!(found(&plan([1200, 300, 20], "", "[[-480, 0], [520, 0]]"), "work-beyond-travel").is_none());
    // The back side is 300 + 190 mm behind a hole 190 mm before the middle, and 320 + 190 are too much.
    assert!(found(&plan([500, 600, 20], "", "[[0, -190]]"), "into-column").is_none());
    let deep = plan([500, 640, 20], "", "[[0, -190]]");
    assert_eq!(figures(&deep, "into-column", &["needed", "most"]), (Severity::Error, vec!["510".into(), "500".into()]));
}

/// Between table and spindle there are 500 mm at most: 350 of fixture, 40 of part, 15 over it, and the tool.
#[test]
fn a_part_under_which_a_tool_does_not_pass_is_told() {
    let tall = plan([300, 200, 40], "fixture: {height: 350}", "[[0, 0]]");
    let length = tall.tools.iter().map(|tool| tool.length_mm.to_mm()).fold(0.0, f64::max);
    let (severity, said) = figures(&tall, "no-room-over-part", &["needed", "most"]);
    assert_eq!((severity, said[1].as_str()), (Severity::Error, "500"));
    assert!((said[0].parse::<f64>().unwrap() - (350.0 + 40.0 + 15.0 + length)).abs() < 0.01, "{said:?} {length}");
}
