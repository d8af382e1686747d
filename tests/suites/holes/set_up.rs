//! The set-up of a part: on the table, within reach, held.

use technolog::note::{Finding, Severity};
use technolog::part::Along;
use technolog::plan::{CuttingMethod, FixtureKind, HeldBy, PartLocating, Plan, TableKeying, Touched};
use technolog::report::{Doubts, Lang, sheet};
use technolog::units::Micrometres;
use technolog_testing::{KNOWLEDGE, planned, read};

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
    assert!(!plan([1600, 400, 40], "", "[[-50, 0]]").has_errors());
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

/// Between table and spindle there are 500 mm at most: 350 of fixture, 40 of part, 35 of straps of M10 and 5 over them, and the tool.
#[test]
fn a_part_under_which_a_tool_does_not_pass_is_told() {
    let tall = plan([300, 200, 40], "fixture: {height: 350}", "[[0, 0]]");
    let length = tall.tools.iter().map(|tool| tool.length_mm.to_mm()).fold(0.0, f64::max);
    let (severity, said) = figures(&tall, "no-room-over-part", &["needed", "most"]);
    assert_eq!((severity, said[1].as_str()), (Severity::Error, "500"));
    assert!((said[0].parse::<f64>().unwrap() - (350.0 + 40.0 + 35.0 + 5.0 + length)).abs() < 0.01, "{said:?} {length}");
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
    assert_eq!(vice.jaws_along, Along::X);
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
    assert_eq!(figures(&near, "no-vice", &["why"]).0, Severity::Wrong);
    assert!(found(&near, "no-place-for-clamps").is_some());
    // Clamps of the file are for who made it.
    let own = "fixture: {clamps: [{at: [0, -20]}, {at: [0, 20]}]}";
    assert!(found(&plan([60, 50, 30], own, NEAR_SIDES), "no-vice").is_none());
}

/// A height of the file does not make the part hold itself: ways of 73 mm and parallels of 18 give 91; 20 mm are less than any ways.
#[test]
fn a_height_of_the_file_does_not_switch_the_vice_off() {
    let suits = plan([60, 50, 30], "fixture: {height: 91}", CORNERS);
    let vice = suits.setup.vice.as_ref().unwrap();
    assert_eq!((vice.parallels_mm, vice.height()), (Some(Micrometres::from_mm(18)), Micrometres::from_mm(91)));
    assert!(!suits.has_errors(), "{:?}", suits.findings);
    let none = plan([60, 50, 30], "fixture: {height: 20}", CORNERS);
    assert!(none.setup.vice.is_none() && none.clamping.is_none());
    assert_eq!(figures(&none, "no-vice", &["why"]).0, Severity::Wrong);
}

/// x0 = xM − B − d/2 (textbook 1.12.2): with the zero at the left front corner, B and H are the length and the width.
#[test]
fn zeros_are_told_by_the_sides_that_an_arbor_touches() {
    let corner = plan([300, 200, 40], "datum: {x: left, y: front}", "[[50, 50], [250, 150]]");
    let [stand] = &corner.setup.stands[..] else { panic!("{:?}", corner.setup) };
    // A drawing that gives all dimensions from the left and the front is touched there: X = xM + d/2.
    assert_eq!(stand.sides_mm, [0, 0].map(Micrometres::from_mm));
    assert_eq!(stand.touched, Touched { left: true, front: true });
    assert_eq!((stand.zero_mm[0], stand.zero_mm[1]), (Micrometres::from_mm(-150), Micrometres::from_mm(-100)));
    // The place of the tool change, X0 Y196 of the machine, in the drawing.
    assert_eq!((stand.start.x, stand.start.y), (Micrometres::from_mm(150), Micrometres::from_mm(296)));
    // With the reference tool on the face: its length is what is left of the nose over face and supports.
    let (nose, reference) = (stand.nose_to_table_mm.unwrap(), stand.reference_tool.unwrap());
    let tool = corner.tools.iter().find(|tool| tool.number == reference).unwrap();
    assert_eq!(stand.zero_mm[2], Micrometres::from_mm(40) + stand.height_mm + tool.length_mm - nose);
    assert_eq!(serde_json::from_str::<Plan>(&serde_json::to_string(&corner).unwrap()).unwrap(), corner);
}

/// The hole and its counterbore from behind must be coaxial on a blank of 241 mm instead of 240, so that both set-ups count from one
/// face: the left one, which lies on the right when the part is turned over; of a part dimensioned from its middle the right one.
#[test]
fn both_set_ups_touch_the_same_face_of_the_part() {
    let of = |datum: &str, x: u32| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 240, width: 160, thickness: 30}}\n{datum}\nholes:\n  - name: B\n    through: true\n    roughness: Ra 12.5\n    centre_tolerance: 0.3\n    \
             steps: [{{diameter: 11, length: 20}}, {{diameter: 18}}]\n    at: [[{x}, 30]]\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    for (datum, x, touched, sides) in
        [("datum: {x: left, y: front}", 50, [true, false], [0, 240]), ("", 20, [false, true], [120, -120])]
    {
        let plan = of(datum, x);
        let [first, second] = &plan.setup.stands[..] else { panic!("{:?}", plan.setup.stands) };
        assert_eq!([first.touched.left, second.touched.left], touched, "{datum}");
        assert_eq!([first.sides_mm[0], second.sides_mm[0]], sides.map(Micrometres::from_mm), "{datum}");
        assert_eq!(first.touched.front, second.touched.front);
        // On a blank 1 mm longer a hole 50 mm from the face is 50 mm from it in both: the zero is set so that the touched side has
        // its coordinate of the drawing.
        let hole = Micrometres::from_mm(i64::from(x));
        let middle = plan.part.middle().x;
        let turned = middle + middle - hole;
        assert_eq!((first.sides_mm[0] - hole).abs(), (second.sides_mm[0] - turned).abs());
    }
}

/// The clamps of the second set-up hold against what is cut there, W = k·M/(f·d) with d as the part lies turned over: a hole drawn
/// 70 mm left of the middle is 70 mm right of it then. What the file places there is not ours to place anew.
#[test]
fn the_second_set_up_has_clamps_of_its_own() {
    let of = |fixture: &str| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 240, width: 160, thickness: 30}}\n{fixture}\nholes:\n  - name: B\n    through: true\n    roughness: Ra 12.5\n    centre_tolerance: 0.3\n    \
             steps: [{{diameter: 11, length: 20}}, {{diameter: 18}}]\n    at: [[-70, 30]]\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    let both = of("");
    let second = both.setup.second_clamping.as_ref().unwrap();
    assert!(second.proposed && second.clamps.len() >= 2 && second.strap.is_some());
    let back = both.holes[0].transitions.iter().filter(|one| one.face == technolog::part::Face::Back && !one.elsewhere);
    let torques = back.filter_map(|step| step.conditions.torque_n_m).map(|torque| torque.0);
    let torque = torques.fold(0.0, f64::max);
    let turned = [70.0, 30.0];
    let arm = |at: &technolog::part::Point| (at.x.to_mm() - turned[0]).hypot(at.y.to_mm() - turned[1]);
    let arm = second.clamps.iter().map(arm).fold(f64::INFINITY, f64::min);
    assert!((second.force_n.0 - 2.5 * torque / (0.25 * arm / 1000.0)).abs() < 1.0, "{second:?} {torque} {arm}");
    assert!(both.setup.stands[1].start_to_clamp_mm.is_some());
    let given = of("fixture: {obstacles: [{outline: [[-120, -80], [-80, -60]], height: 30, set_up: 2}]}");
    assert!(given.setup.second_clamping.is_none() && given.clamping.is_some());
    // A screw of its own has a safe distance of its own: 285 mm of M24 (textbook 1.11) are more than the way to the tool change.
    let thick = of("fixture: {height: 40, clamps: [{at: [0, 60], screw: M24}, {at: [0, -60], screw: M10}]}");
    assert_eq!(figures(&thick, "start-near-clamp", &["distance", "needed"]).1, ["136", "285"]);
    let thin = of("fixture: {height: 40, clamps: [{at: [0, 20], screw: M10}, {at: [0, -60], screw: M24}]}");
    assert_eq!(figures(&thin, "start-near-clamp", &["distance", "needed"]).1, ["256", "285"]);
}

/// A strap of M10 is 15 mm high (DIN 6314), a nut of 1.5 d and what is over and under it 20 more: 35 mm, and 5 over it.
#[test]
fn tools_go_over_the_straps_that_the_plan_proposes() {
    // Holes in the corners, and the clamps in the middles of the long sides: ways along them cross a clamp.
    let over = plan([300, 200, 40], "", "[[-130, -80], [130, -80], [130, 80], [-130, 80]]");
    let clamping = over.clamping.as_ref().unwrap();
    assert!(clamping.proposed && !over.has_errors(), "{:?}", over.findings);
    let strap = clamping.strap.unwrap();
    assert_eq!((clamping.screw.as_str(), strap.height_mm), ("M10", Micrometres::from_mm(35)));
    assert_eq!(over.setup.stands[0].first_level_mm, Micrometres::from_mm(40));
    // Where the file says how high tools go, the setter is told the bound.
    let bound = plan([300, 200, 40], "fixture: {retract: 25}", "[[-130, -80], [130, -80], [130, 80], [-130, 80]]");
    assert_eq!(bound.setup.stands[0].first_level_mm, Micrometres::from_mm(25));
    let page = sheet::page(&bound, &KNOWLEDGE, Doubts::Counted, Lang::EN);
    assert!(technolog_testing::pages::shown(&page).contains("must be lower than 25 mm over the face"));
}

/// Slots of 18 mm take bolts of M16, which bear 10449 N: what two cannot, four or six must.
#[test]
fn screws_fit_the_slots_of_the_table() {
    for diameter in [30, 40, 48, 60, 80] {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 300, width: 250, thickness: 40}}\nholes:\n  \
             - {{name: A, diameter: {diameter}H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[0, 0]]}}\n"
        );
        let plan = planned(&read(&text), CuttingMethod::Formula);
        let Some(clamping) = &plan.clamping else { panic!("{diameter}: {:?}", plan.findings) };
        assert!(["M10", "M12", "M16"].contains(&clamping.screw.as_str()), "{diameter}: {clamping:?}");
        assert!(clamping.screw_bears_n.0 >= clamping.force_per_clamp_n.0);
        // Straps stand side by side, not on one another.
        let strap = clamping.strap.unwrap();
        for (at, one) in clamping.clamps.iter().enumerate() {
            let outline = strap.standing(*one, &plan.part).outline;
            let rest = &clamping.clamps[at + 1..];
            assert!(
                !rest.iter().any(|two| outline.overlaps(&strap.standing(*two, &plan.part).outline)),
                "{clamping:?}"
            );
        }
    }
}

/// Tools come out a point of 118° and 1 to 3 mm below the part; supports leave 3 mm more.
#[test]
fn supports_leave_room_below_the_tools() {
    let part = plan([300, 200, 40], "", "[[0, 0]]");
    let lowest = part.holes[0].transitions.iter().map(|one| one.end()).max().unwrap() - Micrometres::from_mm(40);
    let left = part.setup.stands[0].height_mm - lowest;
    // Motions are on the grid of the machine, 0.01 mm.
    assert!(left.to_mm() > 2.99 && left < Micrometres::from_mm(4), "{left:?}");
    let scant = plan([300, 200, 40], "fixture: {height: 7}", "[[0, 0]]");
    assert_eq!(figures(&scant, "scant-room-under-part", &["height"]).0, Severity::Doubtful);
}

/// A measured clamp beside the widest tool, 6 and 4 mm from its edge.
#[test]
fn tools_keep_clear_of_a_clamp_with_an_outline() {
    let of = |begin: f64| {
        let clamps = format!(
            "fixture: {{clamps: [{{at: [40, 0], height: 40, outline: [[{begin}, -20], [60, 20]]}}, {{at: [-120, 0], height: 40}}]}}"
        );
        plan([300, 200, 40], &clamps, "[[0, 0], [0, 60]]")
    };
    let free = of(35.0);
    assert!(found(&free, "tool-beside-clamp").is_none(), "{:?}", free.findings);
    let widest = free.tools.iter().map(|tool| tool.diameter_mm.to_mm()).fold(0.0, f64::max);
    assert!(found(&of(widest / 2.0 + 6.0), "tool-beside-clamp").is_none());
    let near = of(widest / 2.0 + 4.0);
    assert_eq!(figures(&near, "tool-beside-clamp", &["least"]), (Severity::Wrong, vec!["5".into()]));
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
        // A key h6 in a slot 18H8 has 27 + 11 µm of play (ISO 286); the errors of setting are those of the table.
        assert_eq!(fixture.keying_play_mm, Some(Micrometres::new(38)));
        let error = match held {
            HeldBy::Straps => Some([25, 70].map(Micrometres::new)),
            HeldBy::Vice => Some([50, 100].map(Micrometres::new)),
            HeldBy::Own | HeldBy::Nothing | HeldBy::Chuck => None,
        };
        assert_eq!(fixture.locating_error_mm, error);
    }
}

/// What neither straps nor a vice hold the user may answer with a fixture of the shop's own; the set-up says what it must hold, and
/// what stands over the face is still in the way of tools.
#[test]
fn a_fixture_of_the_shop_takes_the_place_of_clamps() {
    let own = plan([60, 50, 30], "fixture: {own: UPS-12, height: 45}", NEAR_SIDES);
    assert!(own.clamping.is_none() && own.setup.vice.is_none());
    assert!(found(&own, "no-vice").is_none() && found(&own, "no-place-for-clamps").is_none());
    let fixture = own.setup.fixture.as_ref().unwrap();
    assert_eq!((fixture.held, fixture.fixture_kind), (HeldBy::Own, FixtureKind::Special));
    let torques = own.holes[0].transitions.iter().filter_map(|step| step.conditions.torque_n_m);
    let torque = torques.map(|torque| torque.0).fold(0.0, f64::max);
    let must = own.setup.own.as_ref().unwrap();
    assert_eq!((must.name.as_str(), must.torque_n_m.0, must.safety), ("UPS-12", torque, 2.5));
    assert_eq!(own.setup.stands[0].height_mm, Micrometres::from_mm(45));
}

/// A drill of 9 mm with a point of 118° comes out 9/2/tan 59° = 2.7 mm and its overrun below the part, where nobody knows what a fixture
/// of the shop's own has; each hole is told once, and a blind one is not.
#[test]
fn what_comes_out_below_a_part_in_a_fixture_of_its_own_is_doubtful() {
    let ring = |fixture: &str| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: disc, diameter: 130, thickness: 20, bore: 80}}\n\
             fixture: {fixture}\nholes:\n  \
             - {{name: A, diameter: 9H13, through: true, roughness: Ra 12.5, centre_tolerance: 0.4, at: [[52.5, 0], [-52.5, 0]]}}\n  \
             - {{name: B, diameter: 9H13, depth: 10, roughness: Ra 12.5, centre_tolerance: 0.4, at: [[0, 52.5]]}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    let plan = ring("{own: chuck 250, height: 120}");
    let told: Vec<_> = plan.findings.iter().filter(|one| one.note.code() == "out-below-in-own-fixture").collect();
    let [one] = told[..] else { panic!("{:?}", plan.findings) };
    assert_eq!((one.severity, one.hole.as_deref()), (Severity::Doubtful, Some("A")));
    let (_, said) = figures(&plan, "out-below-in-own-fixture", &["below"]);
    let below: f64 = said[0].parse().unwrap();
    assert!((4.7..=6.7).contains(&below), "2.7 and an overrun of 2 to 4 mm: {below}");
}

/// The collar of a short slot mill, Ø97.5, comes down to 50 mm over the face where a slot ends at [-60, -30]; a clamp begins 20 mm
/// along X and 40 mm along Y from there: 44.7 mm < 97.5/2. The mill itself, of 14 mm, stays far from it.
#[test]
fn a_holder_in_a_clamp_of_the_file_is_an_error_of_the_plan() {
    let clamped = |height: i64| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 300, width: 200, thickness: 25}}\n\
             fixture: {{height: 40, clamps: [{{at: [-25, -85], height: {height}, outline: [[-40, -100], [-10, -70]]}}, \
             {{at: [130, 85], height: 30}}]}}\nslots:\n  \
             - {{name: S, from: [-100, -60], to: [-60, -30], width: 14H12, through: true, roughness: Ra 6.3, centre_tolerance: 0.4}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    let (severity, said) = figures(&clamped(57), "holder-in-clamp", &["clamp", "height", "low"]);
    assert_eq!((severity, &said[..2]), (Severity::Error, &["[-25; -85]".to_owned(), "57".to_owned()][..]));
    assert!((said[2].parse::<f64>().unwrap() - 50.0).abs() < 0.5, "{said:?}");
    assert!(found(&clamped(49), "holder-in-clamp").is_none());
}

/// The chuck of the centre drill is of unknown thickness, at most that of its collar, Ø97.5: 48.75 mm > 15 mm to a clamp that begins
/// there. What the program of a plan finds wrong the plan finds wrong, too; a strap of the plan's own may be chosen lower.
#[test]
fn a_holder_of_unknown_thickness_beside_a_clamp_is_as_wrong_in_the_plan_as_in_its_program() {
    let plate = |fixture: &str, size: &str, at: &str| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, {size}}}\n{fixture}holes:\n  \
             - {{name: A, diameter: 12H9, through: true, roughness: Ra 2.5, centre_tolerance: 0.3, at: {at}}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    let clamp = "outline: [[-75, -15], [-45, 15]], height: 60, screw: M10";
    let given = format!(
        "fixture: {{height: 60, clamps: [{{at: [-60, 0], {clamp}}}, {{at: [60, 0], height: 20, screw: M10}}]}}\n"
    );
    let given = plate(&given, "length: 150, width: 100, thickness: 40", "[[-30, 0], [30, 0]]");
    assert_eq!(figures(&given, "holder-may-meet-clamp", &["tool"]).0, Severity::Wrong);
    let own = plate("", "length: 84, width: 97, thickness: 80", "[[-21, -19.4], [21, 19.4]]");
    assert_eq!(figures(&own, "holders-may-meet-straps", &["tools"]).0, Severity::Doubtful);
}

/// Tools go over a clamp that the file gives, unless it says itself how high they go.
#[test]
fn a_height_of_the_file_below_its_clamp_sends_tools_through_it() {
    let over = |retract: &str| {
        let clamps = "clamps: [{at: [0, 0], height: 30}, {at: [0, 80], height: 30}]";
        plan([300, 200, 25], &format!("fixture: {{height: 40, {clamps}{retract}}}"), "[[-60, 0], [60, 0]]")
    };
    let (severity, said) = figures(&over(", retract: 20"), "rapid-through-clamp", &["at", "low", "height"]);
    assert_eq!((severity, said), (Severity::Error, ["[0; 0]", "20", "30"].map(String::from).to_vec()));
    for enough in ["", ", retract: 40"] {
        assert!(found(&over(enough), "rapid-through-clamp").is_none(), "{enough}");
    }
}

/// Parallels are in the way of what comes out below the part: blind holes lie over them as they please.
#[test]
fn blind_holes_are_in_nobodys_way_in_a_vice() {
    let hole = |bottom: &str| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\n\
             blank: {{kind: plate, length: 60, width: 50, thickness: 30}}\nholes:\n  - {{name: A, diameter: 6H12, {bottom}, \
             roughness: Ra 12.5, centre_tolerance: 0.4, at: [[-23.5, -18.5], [23.5, 18.5], [-23.5, 18.5], [23.5, -18.5]]}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    let blind = hole("depth: 10");
    assert!(blind.setup.vice.is_some(), "{:?}", blind.findings);
    // Of 25 − 18.5 − 3 = 3.5 mm beside a hole the thinnest parallels leave none.
    assert!(hole("through: true").setup.vice.is_none());
}

/// A screw that the file names is one that the shop has, and M24 bears 23510 N: no slot is its business.
#[test]
fn a_screw_of_the_file_is_not_held_against_the_slot() {
    let text = "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {kind: plate, length: 300, width: 200, thickness: 40}\n\
                fixture: {height: 60, clamps: [{at: [-130, 0], screw: M24}, {at: [130, 0], screw: M24}]}\nholes:\n  \
                - {name: A, diameter: 60H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[0, 0]]}\n";
    let plan = planned(&read(text), CuttingMethod::Formula);
    let clamping = plan.clamping.as_ref().unwrap();
    assert_eq!((clamping.screw.as_str(), clamping.proposed), ("M24", false));
    assert!(clamping.screw_bears_n.0 > clamping.force_per_clamp_n.0);
    assert!(found(&plan, "no-screw-for-slot").is_none(), "{:?}", plan.findings);
}

/// Tools of 30H7 × 100 are 135 to 249 mm long. With the ram up the longest clears the straps by 5 mm: over M16 straps, 57 mm high, the
/// reamer has 114 + 62 + 103 = 279 mm to go, and the quill goes 260; over M10 straps, 35 mm high, 257.
#[test]
fn straps_of_our_own_never_take_the_travel_that_a_tool_needs() {
    let deep = |length: u32, width: u32| {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\n\
             blank: {{kind: plate, length: {length}, width: {width}, thickness: 100}}\nholes:\n  \
             - {{name: A, diameter: 30H7, through: true, roughness: Ra 1.6, centre_tolerance: 0.3, at: [[0, 0], [40, 0]]}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    };
    for (length, width) in [(200, 150), (500, 300)] {
        let plan = deep(length, width);
        assert!(!plan.has_errors(), "{length}: {:?}", plan.findings);
        let height = plan.clamping.as_ref().and_then(|clamping| clamping.strap).map(|strap| strap.height_mm.to_mm());
        assert!(height.is_some_and(|height| height <= 35.0) || plan.setup.vice.is_some(), "{length}: {height:?}");
        assert!(found(&plan, "straps-in-the-way").is_none());
    }
}

/// The Ø97.5 collar of a short slot mill comes down to 50 mm over the face along a slot that ends 46 mm from the corner of an M16 strap,
/// 57 mm high, at the middle of the front side: the straps go elsewhere, or lower ones are taken.
#[test]
fn straps_of_our_own_are_not_where_a_holder_comes_down() {
    let text = "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {kind: plate, length: 300, width: 200, thickness: 25}\n\
                fixture: {height: 40}\nslots:\n  \
                - {name: S, from: [-100, -60], to: [-60, -30], width: 14H12, through: true, roughness: Ra 6.3, centre_tolerance: 0.4}\n  \
                - {name: W, centre: [0, 0], length: 120, angle: -15, width: 36H11, depth: 20, roughness: Ra 3.2, centre_tolerance: 0.2}\n";
    let plan = planned(&read(text), CuttingMethod::Formula);
    assert!(!plan.has_errors(), "{:?}", plan.findings);
    let strap =
        plan.clamping.as_ref().and_then(|clamping| clamping.strap.map(|strap| (strap, clamping.clamps.clone())));
    let (strap, clamps) = strap.expect("straps find places");
    let middle = clamps.iter().any(|at| at.x.to_mm().abs() < 1.0 && at.y.to_mm() < 0.0);
    assert!(strap.height_mm.to_mm() < 50.0 || !middle, "{clamps:?}, {} mm", strap.height_mm);
}

/// At the lowest the nose of a VF-5/50 is 737 − 635 = 102 mm over the table, the tip of a bar of 85 mm 17: 0.2 mm over the floor of a
/// hole 15 deep in 25 mm it must be at 10.2, so that 6.8 mm are missing.
#[test]
fn supports_bring_the_part_up_to_a_short_tool() {
    let text = "part: P\nmaterial: steel-45\nmachine: haas-vf5-50\nblank: {kind: plate, length: 300, width: 200, thickness: 25}\n\
                holes:\n  - {name: s, diameter: 20H7, depth: 15, bottom: flat, roughness: Ra 1.6, centre_tolerance: 0.1, at: [[0, 0]]}\n";
    let plan = planned(&read(text), CuttingMethod::Formula);
    assert_eq!(plan.setup.stands[0].height_mm, Micrometres::from_mm(7));
    assert!(found(&plan, "quill-too-short").is_none());
    let given = text.replace("holes:", "fixture: {height: 5}\nholes:");
    assert!(found(&planned(&read(&given), CuttingMethod::Formula), "quill-too-short").is_some());
}
