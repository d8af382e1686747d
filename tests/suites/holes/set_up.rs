//! The set-up of a part: on the table, within reach, held.

use technolog::note::{Finding, Severity};
use technolog::plan::{CuttingMethod, FixtureKind, HeldBy, JawsAlong, PartLocating, Plan, TableKeying};
use technolog::units::Micrometres;
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

const CORNERS: &str = "[[-15, -10], [15, 10], [-15, 10], [15, -10]]";
const NEAR_SIDES: &str = "[[-23.5, -18.5], [23.5, 18.5], [-23.5, 18.5], [23.5, -18.5], [0, 0]]";

/// A block of 60 by 50 by 30 mm with four holes of 10 mm leaves no strap a place. The drill comes out 3 mm and its point of 118°,
/// 10/2/tan 59° = 3.0 mm, below it, the ways shall stay 1 mm away: 7 mm, and the lowest parallels are 14 mm. Jaws of 44.07 mm
/// on 18 mm grip 26.07 mm, at most 30 − 2; on 16 mm it would be 28.07. Holes begin 25 − 10 − 5 = 10 mm from the jaws.
#[test]
fn a_part_without_a_place_for_straps_is_put_into_a_vice() {
    let small = plan([60, 50, 30], "", CORNERS);
    assert!(!small.has_errors() && small.clamping.is_none(), "{:?}", small.findings);
    assert!(found(&small, "no-place-for-clamps").is_none());
    let vice = small.setup.vice.as_ref().unwrap();
    assert_eq!(vice.designation, "Kurt DX6 (D688)");
    assert_eq!(vice.jaws_along, JawsAlong::X);
    let figures = [vice.opened_mm, vice.grip_mm, vice.below_face_mm].map(Micrometres::to_mm);
    assert_eq!(figures, [50.0, 26.07, 3.93]);
    assert_eq!(vice.parallels_mm, Some(Micrometres::from_mm(18)));
    assert_eq!(vice.thickest_parallels_mm, Some(Micrometres::from_mm(10)));
    // k·M/(f·b) with the torque of the drill, the largest of the plan.
    let torques = small.holes[0].transitions.iter().filter_map(|step| step.conditions.torque_n_m);
    let torque = torques.map(|torque| torque.0).fold(0.0, f64::max);
    assert!((vice.force_n.0 - 2.5 * torque / (0.15 * 0.05)).abs() < 1.0, "{} {torque}", vice.force_n.0);
    // The part lies on the parallels, and the knee follows.
    assert_eq!(small.setup.stands[0].height_mm, Micrometres::from_mm(73 + 18));
}

/// A hole 6.5 mm from the side begins 1.5 mm from the jaw, and the thinnest parallels are 4 mm; between the other sides it is
/// as near, so that nothing takes the part.
#[test]
fn no_vice_is_named_whose_parallels_would_be_cut() {
    let near = plan([60, 50, 30], "", NEAR_SIDES);
    assert!(near.setup.vice.is_none());
    assert_eq!(figures(&near, "no-vice", &["why"]).0, Severity::Doubtful);
    assert!(found(&near, "no-place-for-clamps").is_some());
    // What the file says of its fixture is for who made it.
    assert!(plan([60, 50, 30], "fixture: {height: 20}", CORNERS).setup.vice.is_none());
}

/// x0 = xM − B − d/2 (textbook 1.12.2): with the zero at the left front corner, B and H are the length and the width.
#[test]
fn zeros_are_told_by_the_sides_that_an_arbor_touches() {
    let corner = plan([300, 200, 40], "datum: {x: left, y: front}", "[[50, 50], [250, 150]]");
    let [stand] = &corner.setup.stands[..] else { panic!("{:?}", corner.setup) };
    assert_eq!(stand.sides_mm, [300, 200].map(Micrometres::from_mm));
    assert_eq!((stand.zero_mm[0], stand.zero_mm[1]), (Micrometres::from_mm(-150), Micrometres::from_mm(-100)));
    assert_eq!(stand.first_level_mm, Micrometres::from_mm(15));
    // The place of the tool change, X0 Y196 of the machine, in the drawing.
    assert_eq!((stand.start.x, stand.start.y), (Micrometres::from_mm(150), Micrometres::from_mm(296)));
    // With the reference tool on the face: its length is what is left of the nose over face and supports.
    let (nose, reference) = (stand.nose_to_table_mm.unwrap(), stand.reference_tool.unwrap());
    let tool = corner.tools.iter().find(|tool| tool.number == reference).unwrap();
    assert_eq!(stand.zero_mm[2], Micrometres::from_mm(40) + stand.height_mm + tool.length_mm - nose);
    assert_eq!(serde_json::from_str::<Plan>(&serde_json::to_string(&corner).unwrap()).unwrap(), corner);
}

/// Appendix Г, item 8: 2.5 · 26.52 / (0.25 · 0.283) = 937 N (the example prints 977) with both clamps 283 mm from the hole, which
/// is √(200² + 200²). Each hole has its own arm, and the largest force governs: a drill of 10 mm 40 mm from its clamp needs more
/// than one of 20 mm that far away.
#[test]
fn every_hole_has_its_own_arm_and_the_largest_force_governs() {
    let of = |near: &str| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 500, width: 300, thickness: 40}}\n\
             fixture: {{clamps: [{{at: [-200, -100]}}, {{at: [200, -100]}}]}}\nholes:\n{near}  \
             - {{name: B, diameter: 20H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 100]]}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    let torque = |plan: &Plan, hole: usize| {
        let torques = plan.holes[hole].transitions.iter().filter_map(|step| step.conditions.torque_n_m);
        torques.map(|torque| torque.0).fold(0.0, f64::max)
    };
    let far = of("");
    let clamping = far.clamping.as_ref().unwrap();
    assert_eq!(clamping.distance_mm, Micrometres::from_mm_rounded(282.843));
    assert!((clamping.force_n.0 - 2.5 * torque(&far, 0) / (0.25 * 0.282_843)).abs() < 1.0, "{clamping:?}");
    assert!((2.5 * 26.52 / (0.25 * 0.283) - 937.1_f64).abs() < 0.1);

    let near = "  - {name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[-160, -100]]}\n";
    let both = of(near);
    let clamping = both.clamping.as_ref().unwrap();
    assert!(torque(&both, 0) < torque(&both, 1));
    assert_eq!((clamping.hole.as_str(), clamping.distance_mm), ("A", Micrometres::from_mm(40)));
    assert!((clamping.force_n.0 - 2.5 * torque(&both, 0) / (0.25 * 0.040)).abs() < 1.0, "{clamping:?}");
}

/// Sections 1.6 to 1.9: universal fixtures first, and item 11 of Appendix Г: two keys on the ГФ2171.
#[test]
fn the_fixture_is_chosen_by_what_holds_the_part() {
    for (blank, at, held, kind) in [
        ([300, 200, 40], "[[0, 0]]", HeldBy::Straps, FixtureKind::Universal),
        ([60, 50, 30], CORNERS, HeldBy::Vice, FixtureKind::Universal),
        // A thin plate springs between its clamps.
        ([900, 300, 8], "[[0, 0]]", HeldBy::Straps, FixtureKind::Special),
        // Neither straps nor jaws: the parallels would be cut.
        ([60, 50, 30], NEAR_SIDES, HeldBy::Nothing, FixtureKind::Special),
    ] {
        let plan = plan(blank, "", at);
        let fixture = plan.setup.fixture.as_ref().unwrap();
        assert_eq!((fixture.held, fixture.fixture_kind), (held, kind), "{blank:?}: {:?}", plan.findings);
        assert_eq!(fixture.keying, Some(TableKeying::TwoKeys));
        assert_eq!(fixture.locating, PartLocating::ThreePlanes);
    }
}
