//! Flat floors and shallow recesses: a small drill, then a mill that goes down and round.

use technolog::job::{self, CycleKind};
use technolog::plan::{Operation, Plan};
use technolog::proof::{Fault, prove_hole};
use technolog::shop::Shop;
use technolog_testing::{KNOWLEDGE, plan_of_hole};

use crate::given::{mm, steps, without_errors};

fn plan(material: &str, thickness: &str, keys: &str) -> Plan {
    plan_of_hole(material, "gf2171", thickness, &format!("{keys}, centre_tolerance: 0.5, at: [[0, 0]]"))
}

/// The plan of a blind hole with a flat floor, without errors.
#[track_caller]
fn flat(material: &str, diameter: &str, roughness: &str, depth: f64) -> Plan {
    // Thinner, it would spring between the straps.
    let thickness = (depth + 20.0).to_string();
    let keys = format!("diameter: {diameter}, roughness: {roughness}, depth: {depth}, bottom: flat");
    without_errors(plan(material, &thickness, &keys), &keys)
}

/// Floors that were refused although a mill plunges a flat counterbore of that diameter, and recesses whose depth is less than the
/// point of their drill. By hand: a point of 118° is d/2·tan 31° = 0.3004·d high, so it stays above the floor; a mill of Ø D in the
/// middle covers D/2, on a circle of radius r from r - D/2 to r + D/2, and together they must cover the whole floor.
#[test]
fn a_flat_floor_is_milled_over_all_of_it() {
    let slope = 59.0_f64.to_radians().tan();
    for (material, diameter, roughness, depth) in [
        ("steel-45", "30H14", "Ra 12.5", 8.0),
        ("aluminium-d16", "25H14", "Ra 12.5", 6.0),
        ("steel-45", "20H14", "Ra 12.5", 3.0),
        ("steel-45", "40H14", "Ra 12.5", 3.0),
        ("steel-45", "22H11", "Ra 6.3", 5.0),
        ("cast-iron-sch20", "26H9", "Ra 3.2", 6.0),
        ("steel-45", "10H14", "Ra 12.5", 10.0),
        ("steel-45", "8H14", "Ra 12.5", 8.0),
        ("steel-45", "6H14", "Ra 12.5", 6.0),
        ("steel-45", "16H14", "Ra 12.5", 20.0),
        ("steel-45", "60H14", "Ra 12.5", 5.0),
        ("stainless-12h18n10t", "18H14", "Ra 12.5", 6.0),
    ] {
        let plan = flat(material, diameter, roughness, depth);
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        let mut covered = false;
        for step in steps(&plan) {
            if step.operation == Operation::Drill {
                let tip = step.depth_mm.to_mm() + step.diameter_mm.to_mm() / 2.0 / slope;
                assert!(tip <= depth + 0.001, "{diameter}: the point reaches {tip}: {step:?}");
            }
            if step.operation != Operation::Mill {
                continue;
            }
            let cycle = job::cycle(&job::Feeding::of(step, None), mm(0.0), &shop).unwrap();
            let CycleKind::Circles { levels, radii, plunge_mm_per_min, .. } = &cycle.kind else { panic!("{step:?}") };
            assert_eq!(levels.last().copied(), Some(mm(-depth)), "{step:?}");
            // Slot mills alone go straight down: ГОСТ 9140-78 has them to 40 mm.
            assert!(step.tool.table.starts_with("slot-mills"), "{step:?}");
            let down = plunge_mm_per_min.unwrap_or(cycle.feed_mm_per_min);
            let per_tooth = down.0 / cycle.speed_rpm.0 / 2.0;
            assert!(per_tooth <= 0.05, "it goes down by {per_tooth} mm a tooth: {cycle:?}");
            let half = step.tool.diameter_mm.to_mm() / 2.0;
            let mut reached = half;
            for radius in radii {
                let radius = radius.to_mm();
                assert!(radius - half <= reached, "{diameter}: a ring stays between {reached} and {}", radius - half);
                reached = radius + half;
            }
            covered |= reached + 0.003 >= step.diameter_mm.to_mm() / 2.0;
        }
        assert!(covered, "{diameter}");
        assert_eq!(
            prove_hole(&plan.part.holes[0], steps(&plan), &plan.part, &shop)
                .unwrap()
                .iter()
                .filter(|fault| matches!(fault, Fault::MiddleInMetal { .. }))
                .count(),
            0
        );
    }
}

/// An end mill with a centre hole cannot be sunk (Mitsubishi's page on end cutting edges): the proof doubts one that is put on a floor,
/// or on a shoulder over a hole narrower than its middle.
#[test]
fn the_proof_doubts_a_mill_without_teeth_in_its_middle() {
    let doubts = |plan: &Plan| {
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        let faults = prove_hole(&plan.part.holes[0], steps(plan), &plan.part, &shop).unwrap();
        faults.iter().any(|fault| matches!(fault, Fault::MiddleInMetal { .. }))
    };
    let end_mill = |mut plan: Plan, operation: Operation| {
        let step = plan.holes[0].transitions.iter_mut().find(|step| step.operation == operation).unwrap();
        step.tool.table = "A.29".to_owned();
        doubts(&plan)
    };
    let floor = flat("steel-45", "16H14", "Ra 12.5", 20.0);
    assert!(!doubts(&floor));
    assert!(end_mill(floor, Operation::Mill));
    let over = |hole: &str| {
        let keys =
            format!("diameter: {hole}, roughness: Ra 12.5, through: true, counterbore: {{diameter: 16, depth: 5}}");
        without_errors(plan("steel-45", "20", &keys), &keys)
    };
    // Half of Ø16 is more than Ø5.5 and less than Ø9.
    let narrow = over("5.5H14");
    assert!(!doubts(&narrow));
    assert!(end_mill(narrow, Operation::Counterbore));
    assert!(!end_mill(over("9H14"), Operation::Counterbore));
}

/// A spotface for a screw head over its clearance hole, and the seats of screws: holes by ISO 273 (fine, medium, coarse), heads by
/// DIN 974-1 and engineersbible.com/counterbore-cheese-din. M3 and M4 were refused.
#[test]
fn heads_of_screws_are_sunk() {
    for (holes, head, depth) in [
        ([3.2, 3.4, 3.6], 6.5, 3.4),
        ([4.3, 4.5, 4.8], 8.0, 4.6),
        ([5.3, 5.5, 5.8], 10.0, 5.7),
        ([6.4, 6.6, 7.0], 11.0, 6.8),
        ([8.4, 9.0, 10.0], 15.0, 9.0),
        ([10.5, 11.0, 12.0], 18.0, 11.0),
    ] {
        for hole in holes {
            let keys = format!(
                "diameter: {hole}H14, roughness: Ra 12.5, through: true, counterbore: {{diameter: {head}, depth: {depth}}}"
            );
            without_errors(plan("steel-20", "25", &keys), &keys);
        }
    }
    for (hole, face) in [("6.6H14", 11), ("4.5H14", 9), ("9H14", 18), ("11H14", 24)] {
        let keys = format!("diameter: {hole}, roughness: Ra 12.5, through: true, face: {face}");
        without_errors(plan("steel-45", "20", &keys), &keys);
    }
}

/// A reamer that leaves more than a tenth of a blind hole over its flat floor stands back behind bars that end 0.2 mm above it.
#[test]
fn a_route_that_finishes_the_whole_hole_goes_first() {
    let plan = flat("steel-45", "20H7", "Ra 1.6", 12.0);
    assert!(
        plan.findings.iter().all(|finding| finding.severity != technolog::note::Severity::Wrong),
        "{:?}",
        plan.findings
    );
}

/// The widest countersink of A.21 is Ø63: round a wider edge a smaller one goes. By hand, for 2 × 45° at Ø60: its front, Ø3.2 of the
/// Ø16 one, is 3 mm below the face, where the tool is 3.2 + 2·3 = Ø9.2 wide; on a circle of (64 - 9.2)/2 = 27.4 mm it cuts Ø64 at the
/// face, (27.4 + 1.6 + 1)·2 = Ø60 two millimetres below it, and its front stays within 29 mm of the axis.
#[test]
fn a_wide_edge_is_gone_round_by_a_countersink() {
    let keys = "diameter: 60H9, roughness: Ra 3.2, through: true, chamfer: 2";
    let plan = without_errors(plan("steel-45", "40", keys), keys);
    let chamfer = steps(&plan).iter().find(|step| step.operation == Operation::Chamfer).unwrap();
    assert_eq!((chamfer.diameter_mm, chamfer.end()), (mm(64.0), mm(3.0)));
    let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
    let cycle = job::cycle(&job::Feeding::of(chamfer, None), mm(0.0), &shop).unwrap();
    let CycleKind::Circles { levels, radii, .. } = &cycle.kind else { panic!("{cycle:?}") };
    assert_eq!((&levels[..], &radii[..]), (&[mm(-3.0)][..], &[mm(27.4)][..]));
    // A narrower edge is sunk as before, and inside a step the tool must not touch the step.
    for keys in [
        "diameter: 40H9, roughness: Ra 3.2, through: true, chamfer: 2",
        "diameter: 70H11, roughness: Ra 6.3, through: true, chamfer: 1.6",
        "diameter: 80H12, roughness: Ra 12.5, through: true, chamfer: 3",
    ] {
        without_errors(self::plan("steel-45", "40", keys), keys);
    }
}

/// Over a flat floor a core drill ends where the cone of its drill begins: of Ø30 × 10 it makes 1.6 mm, and a mill that levels the
/// floor the rest, in one rough cut. That is IT12 at best, so that no wall of a finer grade may end with it.
#[test]
fn no_wall_of_a_fine_grade_ends_with_the_mill_that_levels_its_floor() {
    for (diameter, roughness, depth) in
        [("30H11", "Ra 6.3", 10.0), ("30H9", "Ra 3.2", 10.0), ("30H7", "Ra 1.6", 10.0), ("24H11", "Ra 6.3", 8.0)]
    {
        let plan = flat("steel-45", diameter, roughness, depth);
        let levels = |step: &technolog::plan::Transition| {
            step.operation == Operation::Mill && step.from_diameter_mm == step.diameter_mm
        };
        let last = steps(&plan).last().unwrap();
        assert!(!levels(last), "{diameter}: {:?}", steps(&plan));
    }
}

/// Recesses that were refused, and one of which a reamer left 0.7 of 2 mm: a slot mill goes down and round, and finishes them.
#[test]
fn shallow_recesses_are_milled_to_the_floor() {
    let short = flat("steel-45", "12H12", "Ra 6.3", 2.0);
    assert_eq!(steps(&short).last().unwrap().operation, Operation::Mill);
    flat("steel-45", "50H12", "Ra 6.3", 5.0);
}

/// Only where a bar goes down and a reamer does not has the floor decided; between two reamers time does.
#[test]
fn the_floor_is_named_only_where_it_decided() {
    let keys = "diameter: 14H11, depth: 15, bottom: flat, roughness: Ra 6.3, centre_tolerance: 0.3, at: [[0, 0]]";
    let plan = plan_of_hole("steel-45", "gf2171", "40", keys);
    let route = plan.holes[0].route.as_ref().unwrap();
    let gap = technolog::units::Micrometres::new(200);
    let stops = |finding: &&technolog::note::Finding| finding.note.code() == "ends-above-floor";
    let left = plan.findings.iter().find(stops).and_then(|finding| finding.note.figure("left")).map(|own| own.text());
    let high = left.is_some_and(|left| left.parse::<f64>().unwrap() > gap.to_mm());
    let by_floor = route.alternatives.iter().any(|other| other.why.code() == "lost-by-floor");
    assert!(!(high && by_floor), "{:?}", route.alternatives);
}
