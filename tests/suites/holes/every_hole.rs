//! Patterns of holes. All kinds of holes of the textbook's section 1.1 are in tests/holes, which `cases.rs` runs.

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
