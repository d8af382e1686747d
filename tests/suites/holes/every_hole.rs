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
        ("8H12", "100", "ГОСТ 886-77 Ø8"),
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
