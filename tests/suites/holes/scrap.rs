//! Plans that would have spoilt a part without a word: what an inspector found by geometry and by makers' pages.

use technolog::job::{self, CycleKind};
use technolog::note::Severity;
use technolog::plan::{Feature, Operation, Plan, Transition};
use technolog::proof::{Fault, prove_hole};
use technolog::shop::Shop;
use technolog::units::Micrometres;
use technolog_testing::{KNOWLEDGE, plan_of_hole, plan_of_hole_by_tables};

use crate::given::{mm, steps, without_errors};

fn plan(material: &str, thickness: &str, keys: &str) -> Plan {
    let at = if keys.contains("at: ") { "" } else { ", at: [[0, 0]]" };
    plan_of_hole(material, "gf2171", thickness, &format!("{keys}{at}"))
}

#[track_caller]
fn honest(material: &str, thickness: &str, keys: &str) -> Plan {
    without_errors(plan(material, thickness, keys), keys)
}

fn faults(plan: &Plan) -> Vec<Fault> {
    let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
    prove_hole(&plan.part.holes[0], steps(plan), &plan.part, &shop).unwrap()
}

/// A point of 118° is d/2·tan 31° high: what of it reaches below a shoulder must go into the hole there.
#[test]
fn no_point_leaves_a_crater_in_a_shoulder() {
    let slope = (59.0_f64).to_radians().tan();
    for (hole, wide, depth) in
        [("9H14", 30.0, 4.0), ("8H14", 24.0, 3.0), ("6.6H14", 26.0, 3.0), ("9H14", 36.0, 5.0), ("9H14", 45.0, 4.0)]
    {
        let below: f64 = hole.trim_end_matches("H14").parse().unwrap();
        for opening in [
            format!("counterbore: {{diameter: {wide}, depth: {depth}}}"),
            format!("steps: [{{diameter: {wide}H14, depth: {depth}, bottom: flat, roughness: Ra 12.5}}]"),
        ] {
            let keys = format!("diameter: {hole}, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, {opening}");
            let plan = plan("steel-45", "25", &keys);
            for step in steps(&plan).iter().filter(|step| step.operation == Operation::DrillOut) {
                let crater = 2.0 * (step.end().to_mm() - depth) * slope;
                assert!(crater <= below + 0.36, "{keys}: Ø{crater} at the shoulder: {step:?}");
            }
        }
    }
    // The plan that was given: Ø28 to 0.001 mm, its point at 8.41, is 2·4.41·1.664 = Ø14.7 wide at the shoulder.
    let mut plan = honest(
        "steel-45",
        "25",
        "diameter: 9H14, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, counterbore: {diameter: 30, depth: 4}",
    );
    assert!(!faults(&plan).iter().any(|fault| matches!(fault, Fault::Gouges { .. })));
    let drill = plan.holes[0].transitions.iter_mut().find(|step| step.operation == Operation::DrillOut).unwrap();
    drill.diameter_mm = mm(28.0);
    drill.travel_mm = drill.approach_mm + mm(8.413);
    let found = faults(&plan);
    let crater = found.iter().find_map(|fault| match fault {
        Fault::Gouges { crater, .. } => Some(*crater),
        _ => None,
    });
    assert!(crater.is_some_and(|crater| (crater.to_mm() - 14.69).abs() < 0.05), "{found:?}");
}

/// A tool as bought is no larger than it is. Of a hole H7 it is at most 0.85 of the field wider than its size, and 0.5 at least
/// (Dormer's page on reamers): a field that lies above needs the next larger tool, ground down, or another way.
#[test]
fn no_cutter_is_made_larger_than_it_is_bought() {
    let keys = |nominal: f64, upper: f64, lower: f64, roughness: &str| {
        format!(
            "diameter: {{nominal: {nominal}, upper: {upper}, lower: {lower}}}, through: true, roughness: {roughness}, \
             centre_tolerance: 0.5"
        )
    };
    for (nominal, upper, lower, roughness) in [
        (10.0, 0.5, 0.3, "Ra 12.5"),
        (20.0, 0.24, 0.11, "Ra 6.3"),
        (16.0, 0.3, 0.15, "Ra 6.3"),
        (12.0, 0.2, 0.05, "Ra 6.3"),
        (10.0, 0.098, 0.04, "Ra 3.2"),
        (35.0, 0.25, 0.15, "Ra 6.3"),
    ] {
        let plan = plan("steel-45", "20", &keys(nominal, upper, lower, roughness));
        for tool in &plan.tools {
            let fixed = ["A.18", "A.25", "A.26"].iter().any(|table| tool.table.starts_with(table));
            let bought = tool.ground_from_mm.unwrap_or(mm(nominal)).max(tool.diameter_mm);
            assert!(!fixed || tool.diameter_mm <= mm(nominal) || tool.ground_from_mm == Some(bought), "{tool:?}");
        }
    }
    // 8G7 is +0.020 +0.005, and a reamer for 8H7 is 8.0075 to 8.0128; 20F8 is +0.053 +0.020, one for 20H9 is 20.026 to 20.044.
    for (nominal, upper, lower) in [(8.0, 0.02, 0.005), (20.0, 0.053, 0.02)] {
        let plan = honest("steel-45", "20", &keys(nominal, upper, lower, "Ra 1.6"));
        let last = plan.tools.last().unwrap();
        assert_eq!(last.ground_from_mm, None, "{last:?}");
    }
}

/// What is left of a wall where the drawing lets its holes lie: nothing is an error, little is doubtful.
#[test]
fn holes_that_run_into_each_other_are_an_error() {
    let found = |at: &str| {
        let keys = format!("diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: {at}");
        let plan = plan("steel-45", "20", &keys);
        let walls = plan.findings.iter().filter(|finding| finding.note.code().contains("wall"));
        walls.map(|finding| (finding.severity, finding.note.code().to_owned())).collect::<Vec<_>>()
    };
    let error = |code: &str| vec![(Severity::Error, code.to_owned())];
    // 10 - 10.15 < 0; the plate is 400 × 200.
    assert_eq!(found("[[0, 0], [10, 0]]"), error("proof-no-wall-among"));
    assert_eq!(found("[[-194.9, 0]]"), error("proof-no-wall-to-edge"));
    // 0.5 less half of the tolerance is 0.25.
    assert_eq!(found("[[0, 0], [10.65, 0]]"), [(Severity::Doubtful, "proof-wall-among".to_owned())]);
    assert_eq!(found("[[0, 0], [12, 0]]"), []);
}

/// A rough round holds grade 12 at best (`reach-of-transition`): a mill that finishes to 11 takes a thin last round.
#[test]
fn a_mill_finishes_fine_holes_with_a_thin_round() {
    let milled = |keys: &str| {
        let plan = plan_of_hole_by_tables("steel-45", "gf2171", "25", &format!("{keys}, at: [[0, 0]]"));
        let plan = without_errors(plan, keys);
        let milled: Vec<Transition> =
            steps(&plan).iter().filter(|step| step.operation == Operation::Mill).cloned().collect();
        assert!(steps(&plan).last().is_some_and(|last| last.operation == Operation::Mill), "{keys}");
        (plan, milled)
    };
    for (diameter, nominal) in [("65H11", 65.0), ("80H11", 80.0), ("65H12", 65.0)] {
        let keys = format!("diameter: {diameter}, through: true, roughness: Ra 6.3, centre_tolerance: 0.5");
        let (plan, milled) = milled(&keys);
        let [rough, last] = &milled[..] else { panic!("{milled:?}") };
        assert_eq!((last.diameter_mm - last.from_diameter_mm, last.from_diameter_mm), (mm(1.0), rough.diameter_mm));
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        let cycle = job::cycle(&job::Feeding::of(last, None), Micrometres::ZERO, &shop).unwrap();
        let CycleKind::Circles { radii, .. } = cycle.kind else { panic!("{:?}", cycle.kind) };
        let reached = radii.last().unwrap().to_mm() * 2.0 + last.tool.diameter_mm.to_mm();
        assert!((reached - nominal - 0.08).abs() < 0.1, "{diameter}: {reached}");
    }
    // What roughing leaves needs no other round, and its passes are equal.
    let (plan, milled) = milled("diameter: 65H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5");
    let [only] = &milled[..] else { panic!("{milled:?}") };
    let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
    let cycle = job::cycle(&job::Feeding::of(only, None), Micrometres::ZERO, &shop).unwrap();
    let CycleKind::Circles { radii, .. } = cycle.kind else { panic!("{:?}", cycle.kind) };
    assert!(radii.windows(2).all(|pair| pair[1] - pair[0] > mm(1.0)), "{radii:?}");
}

/// Drills of ±0.1: a hole is wider than its drill by up to 0.15 here, so that 9.9 makes 10 ±0.1 alone and 10 does not.
#[test]
fn a_drill_aims_so_that_its_oversize_stays_inside() {
    for (nominal, width, drill) in [(10.0, 0.1, 9.9), (8.0, 0.1, 7.9)] {
        let keys = format!(
            "diameter: {{nominal: {nominal}, upper: {width}, lower: -{width}}}, through: true, roughness: Ra 12.5, \
             centre_tolerance: 0.5"
        );
        let plan = honest("steel-45", "20", &keys);
        let made: Vec<(Operation, Micrometres)> =
            steps(&plan).iter().skip(1).map(|step| (step.operation, step.diameter_mm)).collect();
        assert_eq!(made, [(Operation::Drill, mm(drill))], "{keys}");
    }
}

/// An edge that stands still on its way out draws a line along the wall it has finished.
#[test]
fn a_finishing_bar_leaves_turning() {
    let plan =
        honest("cast-iron-sch20", "30", "diameter: 60H8, through: true, roughness: Ra 1.6, centre_tolerance: 0.05");
    let last = steps(&plan).last().unwrap();
    assert_eq!(last.operation, Operation::FinishBore);
    let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
    let cycle = job::cycle(&job::Feeding::of(last, None), Micrometres::ZERO, &shop).unwrap();
    assert_eq!(cycle.kind, CycleKind::FeedOut);
}

/// ГОСТ 10903 has a drill of Ø26.5: nothing is bored for it under M30, as nothing is under M27.
#[test]
fn a_drill_of_the_size_under_a_thread_does_it_alone() {
    for (thread, drill) in [("M27", 24.0), ("M30", 26.5)] {
        let plan = honest("steel-45", "40", &format!("thread: {thread}, through: true, centre_tolerance: 0.5"));
        let cut: Vec<&Transition> = steps(&plan).iter().filter(|step| step.feature == Feature::Bore).collect();
        assert!(cut.iter().all(|step| !step.operation.is_boring()), "{thread}: {cut:?}");
        assert_eq!(cut.last().map(|step| step.diameter_mm), Some(mm(drill)), "{thread}");
    }
}

/// Of a seat of 15 mm reamers leave 3 over its shoulder: that is finished by a bar, here or elsewhere, or it is wrong.
#[test]
fn a_seat_is_finished_down_to_its_shoulder() {
    for diameter in ["40H7", "35H7", "30H7"] {
        let keys = format!(
            "diameter: 22H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.2, steps: [{{diameter: {diameter}, depth: \
             15, bottom: flat, roughness: Ra 1.6}}]"
        );
        let plan = plan("cast-iron-sch20", "30", &keys);
        let last = steps(&plan).iter().rfind(|step| step.step == Some(1)).unwrap();
        let told = plan.findings.iter().any(|finding| finding.severity <= Severity::Wrong);
        assert!(last.end() >= mm(13.5) || told, "{diameter}: {last:?}, {:?}", plan.findings);
    }
}

/// Sentences that said nothing or the wrong thing.
#[test]
fn plans_say_why() {
    let said = |keys: &str| {
        let plan = plan("steel-45", "40", keys);
        plan.findings.iter().map(|finding| finding.note.clone()).collect::<Vec<_>>()
    };
    // A.21 has countersinks of 90° to Ø63, but from Ø22 on their fronts are Ø7 and more, and Ø7 does not enter Ø5.5.
    let sunk =
        said("diameter: 5.5H14, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, countersink: {diameter: 22}");
    assert!(sunk.iter().any(|note| note.code() == "no-cone-so-pointed"), "{sunk:?}");
    // The chain holds the grade of the drawing: no promise of a finer one is needed.
    let bored = said("diameter: 25H11, depth: 25, bottom: flat, roughness: Ra 6.3, centre_tolerance: 0.5");
    assert!(!bored.iter().any(|note| note.code() == "promised-finer"), "{bored:?}");
}
