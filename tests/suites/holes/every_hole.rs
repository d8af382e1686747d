//! Patterns of holes. All kinds of holes of the textbook's section 1.1 are in tests/holes, which `cases.rs` runs.

use technolog::job::{self, CycleKind};
use technolog::shop::Shop;
use technolog_testing::KNOWLEDGE;

use crate::given::{steps, without_errors};

#[test]
fn a_pattern_of_holes_is_planned_as_the_list_of_its_points() {
    let keys = "diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46";
    // Each pattern with its points worked out by hand, in the order of docs/part-format.md.
    let cases = [
        (
            "grid: {start: [-50, -20], columns: 3, rows: 2, step: [25, 40]}",
            "[-50, -20], [-25, -20], [0, -20], [-50, 20], [-25, 20], [0, 20]",
        ),
        ("line: {start: [-50, 0], count: 4, step: 20, angle: 90}", "[-50, 0], [-50, 20], [-50, 40], [-50, 60]"),
        ("circle: {centre: [10, 0], diameter: 60, count: 4}", "[40, 0], [10, 30], [-20, 0], [10, -30]"),
    ];
    for (pattern, points) in cases {
        let plan =
            |places: &str| technolog_testing::plan_of_hole("steel-45", "gf2171", "20", &format!("{keys}, {places}"));
        let (one, other) = (plan(&format!("pattern: {{{pattern}}}")), plan(&format!("at: [{points}]")));
        assert_eq!(one, other, "{pattern}");
        let stops: usize = one.sequence.iter().map(|visit| visit.stops.len()).sum();
        assert_eq!(stops, 2 * one.holes[0].count, "{pattern}: each point is centred and drilled once");
    }
}

/// The flutes of А.11 are 75 mm long at Ø8 and 90 at Ø10, those of А.12 120 at Ø16; the long series of ГОСТ 886-77 has 109,
/// 121 and 149. What the textbook's drills are too short for is drilled with these, out of the hole after each step.
#[test]
fn a_deep_hole_gets_a_long_drill_and_pecks() {
    let plan = |diameter: &str, depth: &str| {
        let keys = format!(
            "diameter: {diameter}, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[-60, 0], [60, 0]]"
        );
        without_errors(technolog_testing::plan_of_hole("steel-45", "gf2171", depth, &keys), &keys)
    };
    for (diameter, depth, drill) in [
        ("8H12", "99", "ГОСТ 886-77 Ø8"),
        ("10H12", "105", "ГОСТ 886-77 Ø10"),
        ("16H12", "130", "ГОСТ 886-77 Ø16"),
        ("10H12", "70", "035-2300-1273"),
    ] {
        let plan = plan(diameter, depth);
        assert_eq!(steps(&plan).last().unwrap().tool.designation, drill, "{diameter} × {depth}");
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        let job = job::make(&plan, &shop).unwrap();
        let mut cycles = job.setups.iter().flat_map(|setup| &setup.works).flat_map(|work| &work.cycles);
        assert!(cycles.any(|cycle| matches!(cycle.kind, CycleKind::Peck { .. })), "{diameter} × {depth}");
    }
}

/// A reamer bought for H7 leaves 10.000 to 10.015: 10K7 ends at 10.005, 30JS7 at 30.0105. Each has a reamer of its own, even where
/// an H7 of the same size stands beside it; 25G7 (25.007 to 25.028) is what a bought one for H7 makes. 12F8 (12.016 to 12.043) begins
/// above the holes of H7 (to 12.018) by half of them, and of H8 (to 12.027) too: it takes one for H9 (to 12.043).
#[test]
fn a_hole_of_another_field_is_not_reamed_with_a_reamer_for_h() {
    let group = |name: &str, diameter: &str, x: i32| {
        format!(
            "  - {{name: {name}, diameter: {diameter}, through: true, roughness: Ra 1.6, centre_tolerance: 0.5, at: [[{x}, 0]]}}\n"
        )
    };
    let fields = [("A", "10K7"), ("B", "10H7"), ("C", "30JS7"), ("D", "20P7"), ("E", "25G7"), ("F", "12F8")];
    let holes: String = fields.iter().zip(-2..).map(|((name, field), at)| group(name, field, 60 * at)).collect();
    let text = format!(
        "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 400, width: 200, thickness: 25}}\nholes:\n{holes}"
    );
    let read = technolog_testing::read(&text);
    let plan = without_errors(technolog_testing::planned(&read, technolog::plan::CuttingMethod::Formula), &text);
    let last = |hole: usize| {
        let number = plan.holes[hole].transitions.last().unwrap().tool.number;
        let tool = plan.tools.iter().find(|tool| tool.number == number).unwrap();
        (number, tool.diameter_mm.micrometres(), tool.ground_from_mm.map(|from| from.micrometres()))
    };
    assert_ne!(last(0).0, last(1).0, "10K7 and 10H7");
    let made: Vec<_> = (0..5).map(|hole| (last(hole).1, last(hole).2)).collect();
    assert!((9_990..=10_005).contains(&made[0].0) && made[0].1 == Some(10_000), "{made:?}");
    assert_eq!(made[1], (10_000, None));
    assert_eq!(made[2], (30_000, Some(30_000)));
    assert!((19_965..=19_986).contains(&made[3].0) && made[3].1 == Some(20_000), "{made:?}");
    assert!((25_007..=25_028).contains(&made[4].0) && made[4].1.is_none(), "{made:?}");

    let bought = plan.findings.iter().filter(|finding| finding.note.code() == "bought-for");
    let bought: Vec<_> = bought.map(|one| (one.hole.clone().unwrap(), one.note.figure_text("it").unwrap())).collect();
    assert_eq!(bought, [("E".to_owned(), "7".to_owned()), ("F".to_owned(), "9".to_owned())]);

    let mut careless = plan.clone();
    careless.tools.iter_mut().for_each(|tool| tool.ground_from_mm = None);
    let shop = Shop::new(&careless.part, careless.cutting, &KNOWLEDGE).unwrap();
    let found = technolog::proof::prove(&careless, &shop).unwrap();
    assert!(found.iter().any(|finding| finding.note.code() == "proof-too-wide"), "{found:?}");
}
