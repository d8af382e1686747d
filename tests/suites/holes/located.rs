//! How a part is located and told to the setter: pins, stops, bars, the part turned over, the spindle while it is loaded.

use technolog::note::Severity;
use technolog::part::{Along, Point};
use technolog::plan::{CuttingMethod, FixtureKind, PartLocating, PinKind, Plan};
use technolog::report::{Doubts, Lang, sheet};
use technolog::units::Micrometres;
use technolog_testing::{KNOWLEDGE, planned, read};

/// A plate of steel 45 on the ГФ2171, 300 by 200 by 30 mm about the zero: more lines of the file, and its holes.
fn plan(more: &str, holes: &[&str]) -> Plan {
    planned(&read(&text(more, holes)), CuttingMethod::Formula)
}

fn text(more: &str, holes: &[&str]) -> String {
    let holes: String = holes.iter().map(|hole| format!("  - {{{hole}}}\n")).collect();
    format!(
        "part: P\nmaterial: steel-45\nmachine: gf2171\n\
         blank: {{kind: plate, length: 300, width: 200, thickness: 30}}\n{more}\nholes:\n{holes}"
    )
}

const HOLE: &str =
    "name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[100, -80]]";

fn um(all: [Micrometres; 2]) -> [i64; 2] {
    all.map(Micrometres::micrometres)
}

/// The sheet as people read it, on one line.
fn shown(plan: &Plan) -> String {
    let page = sheet::page(plan, &KNOWLEDGE, Doubts::Counted, Lang::EN);
    technolog_testing::pages::shown(&page).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// ISO 286: 12H7 is 0 to 18 µm, 12g6 is -17 to -6 µm, so that the clearance is 6 to 35 µm. The pins stand 260 and 160 mm apart,
/// 305.287 mm; the hole is 230 mm from the round one: 230 · (35 + 35) / (2 · 305.287) = 26.4 µm.
#[test]
fn two_finished_holes_take_a_round_and_a_cut_pin() {
    let pins = "fixture: {height: 40, pins: [{at: [-130, -80], diameter: 12H7}, {at: [130, 80], diameter: 12H7}]}";
    let plan = plan(pins, &[HOLE]);
    assert!(!plan.has_errors(), "{:?}", plan.findings);
    let fixture = plan.setup.fixture.as_ref().unwrap();
    assert_eq!((fixture.fixture_kind, fixture.locating), (FixtureKind::Special, PartLocating::PlaneAndTwoHoles));
    let kinds: Vec<PinKind> = fixture.pins.iter().map(|pin| pin.kind).collect();
    assert_eq!(kinds, [PinKind::Round, PinKind::Cut]);
    for pin in &fixture.pins {
        assert_eq!((um([pin.lower_mm, pin.upper_mm]), um(pin.clearance_mm)), ([-17, -6], [6, 35]));
    }
    assert_eq!(fixture.locating_error_mm.map(um), Some([6, 35]));
    let pair = fixture.pair.unwrap();
    assert_eq!((pair.apart_mm.micrometres(), pair.turned_mm.micrometres()), (305_287, 26));
    // The smallest holes on the largest pins: the round one lets the part off by 3 µm to one side. How far the land of the cut pin,
    // 2 mm to each side of its middle on a radius of 5.997 mm, goes along the line of centres in a hole of 6 mm, is tried by steps.
    let corner = (5.997_f64 * 5.997 - 4.0).sqrt();
    let enters = |off: f64| (2.0 + off).hypot(corner) <= 6.0;
    let most = (0..100).map(|step| f64::from(step) / 10_000.0).take_while(|off| enters(*off)).last().unwrap();
    let together = pair.distance_tolerances_mm.to_mm();
    assert!((together - 2.0 * (0.003 + most)).abs() < 0.0005, "{together} {most}");
    // X and Y are found at the round pin, because sides differ from part to part.
    let page = shown(&plan);
    assert!(page.contains("X = xM + 130, Y = yM + 80"), "{page}");
    assert!(page.contains("in the hole Ø12H7, clearance 0.006 to 0.035 mm"), "{page}");
    assert!(!page.contains("Push it against stops") && !page.contains("with an arbor"), "{page}");
    assert_eq!(serde_json::from_str::<Plan>(&serde_json::to_string(&plan).unwrap()).unwrap(), plan);
}

/// Sizes from a side need the side: one hole is left for a pin, cut so that the stops at the longer side are not held twice.
#[test]
fn a_part_dimensioned_from_a_side_lies_against_it_and_on_one_pin() {
    let pins = "fixture: {height: 40, pins: [{at: [-130, -80], diameter: 12H7}, {at: [130, 80], diameter: 12H7}]}\n\
                dimensions: [{from: front, to: A, tolerance: 0.5}]";
    let plan = plan(pins, &[HOLE]);
    let fixture = plan.setup.fixture.as_ref().unwrap();
    assert_eq!(fixture.locating, PartLocating::TwoPlanesAndHole);
    assert_eq!((fixture.pins.len(), fixture.pins[0].kind, fixture.pair), (1, PinKind::Cut, None));
    // The side errs more than the pin: 0.07 mm of the table `setting-errors`.
    assert_eq!(fixture.locating_error_mm.map(um), Some([25, 70]));
    let page = shown(&plan);
    assert!(page.contains("hold along X") && page.contains("two stops at its front side"), "{page}");
}

/// 12K7 is -12 to +6 µm: its smallest diameter is 11.988 mm, and a pin 12g6 may have 11.994.
#[test]
fn a_pin_that_does_not_enter_its_hole_is_told() {
    let tight = plan("fixture: {height: 40, pins: [{at: [-130, -80], diameter: 12K7}]}", &[HOLE]);
    let finding = tight.findings.iter().find(|own| own.note.code() == "pin-does-not-enter").unwrap();
    let figure = |name| finding.note.figure(name).unwrap().text().into_owned();
    assert_eq!(finding.severity, Severity::Wrong);
    assert_eq!([figure("smallest"), figure("largest")], ["11.988", "11.994"]);
    let wide = plan("fixture: {height: 40, pins: [{at: [-100, -60], diameter: 60H7}]}", &[HOLE]);
    assert!(wide.findings.iter().any(|own| own.note.code() == "no-locating-pin"), "{:?}", wide.findings);
}

/// A wrench of M10 and a hand need 157 mm. The clamp behind stands 20 mm before the back side: √(157² − 20²) = 155.7 mm to the left
/// of it; the left side is 150 mm away. Clamps of 480 mm beside the middle want 636 mm, and the axis reaches 500.
#[test]
fn the_spindle_stands_at_the_far_left_while_the_part_is_loaded() {
    let near = plan("fixture: {clamps: [{at: [0, -80], screw: M10}, {at: [0, 80], screw: M10}]}", &[HOLE]);
    let loading = near.setup.stands[0].loading.unwrap();
    assert_eq!(loading.at, Point { x: Micrometres::from_mm(-156), y: Micrometres::from_mm(100) });
    assert_eq!((loading.safe_mm, loading.beyond_mm), (Micrometres::from_mm(157), None));
    let long = text("fixture: {clamps: [{at: [-480, 80], screw: M10}, {at: [480, 80], screw: M10}]}", &[HOLE]);
    let long = planned(&read(&long.replace("length: 300", "length: 1000")), CuttingMethod::Formula);
    let loading = long.setup.stands[0].loading.unwrap();
    // The place of the tool change, X0 Y196, is far from both: no stops are asked for.
    assert_eq!((loading.beyond_mm, loading.start_is_safe), (Some(Micrometres::from_mm(136)), true));
    assert!(shown(&long).contains("136 mm beyond the travel along X: while the part is loaded"), "{}", shown(&long));
    assert!(!shown(&long).contains("fixed stops"), "{}", shown(&long));
}

/// What a setter cannot guess: where the stops stand, which jaw is fixed, about which line the part is turned, what is made already.
#[test]
fn the_sheet_says_what_the_part_lies_against() {
    let page = shown(&plan("", &[HOLE]));
    assert!(page.contains("stops: two at its back side, one at its right side"), "{page}");
    assert!(page.contains("found once"), "{page}");
    let both = "name: A, through: true, roughness: Ra 12.5, centre_tolerance: 0.4, at: [[-80, -50]], \
                steps: [{diameter: 12H12, depth: 20}, {diameter: 18H12}]";
    let both = plan("datum: {x: left, y: front}", &[&both.replace("[[-80, -50]]", "[[80, 50]]")]);
    let page = shown(&both);
    assert!(page.contains("about its line along Y: left and right change places"), "{page}");
    assert!(page.contains("Made already: A; now from the other face: A"), "{page}");
    // The left side of the drawing lies on the right then.
    assert!(page.contains("stops: two at its front side, one at its left side"), "{page}");
    assert!(page.contains("stops: two at its front side, one at its right side"), "{page}");
    let small =
        text("", &["name: A, diameter: 10H12, depth: 15, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 0]]"]);
    let small = small.replace("length: 300, width: 200", "length: 60, width: 50");
    let small = planned(&read(&small), CuttingMethod::Formula);
    assert_eq!(small.setup.vice.as_ref().unwrap().jaws_along, Along::X);
    assert!(shown(&small).contains("Its back side lies against the fixed jaw, its right side against an end stop"));
}

/// Bars are set before the program, or at its stops where one bar bores several diameters: every stop of the program has its line.
#[test]
fn every_setting_of_a_bar_is_on_the_sheet() {
    let bored = "name: A, diameter: 70H8, through: true, roughness: Ra 2.5, centre_tolerance: 0.05, state: cast, \
                 state_diameter: 40, outer_wall: true, at: [[-60, 0]]";
    let deep = text("", &[bored]).replace("thickness: 30", "thickness: 120").replace("steel-45", "cast-iron-sch20");
    let deep = planned(&read(&deep), CuttingMethod::Formula);
    let bars = &deep.setup.stands[0].bars;
    let boring: Vec<_> = deep.holes[0].transitions.iter().filter(|one| one.operation.is_boring()).collect();
    let passes: u32 = boring.iter().filter(|one| !one.elsewhere).map(|one| one.passes).sum();
    assert!(passes as usize > boring.len(), "{boring:?}");
    assert_eq!(bars.len(), passes as usize, "{bars:?}");
    for one in boring {
        let own: Vec<_> = bars.iter().filter(|bar| bar.tool == one.tool.number).collect();
        assert_eq!(own.iter().map(|bar| bar.at_stop).collect::<Vec<_>>(), vec![one.passes > 1; own.len()]);
        assert_eq!(own.last().unwrap().diameter_mm, one.diameter_mm);
    }
    assert!(shown(&deep).contains("where the program stops before A, set its bar to"), "{}", shown(&deep));
}
