//! Routes of bored, reamed and milled holes: what a technologist would take, held against the tables of the book and the names
//! of the bars.

use proptest::prelude::*;

use technolog::note::Severity;
use technolog::plan::{Operation, Plan, Transition};
use technolog::program::Setting;
use technolog::program::proof::PlannedJob;
use technolog::program::written::Form;
use technolog::proof::{Fault, prove_hole};
use technolog::shop::Shop;
use technolog_testing::{KNOWLEDGE, plan_of_hole, plan_of_hole_by_tables};

use crate::given::{mm, steps, without_errors};

fn plan(material: &str, thickness: f64, keys: &str) -> Plan {
    plan_of_hole(material, "gf2171", &thickness.to_string(), &format!("{keys}, at: [[0, 0]]"))
}

/// A plan of exit code 0: nothing in it is an error or wrong.
#[track_caller]
fn honest(material: &str, thickness: f64, keys: &str) -> Plan {
    without_errors(plan(material, thickness, keys), keys)
}

/// The range of a bar by its name: BB-R-34-48 is for Ø34 to 48.
fn range(bar: &str) -> Option<(f64, f64)> {
    let (low, high) = bar.strip_prefix("BB-").or(bar.strip_prefix("BC-"))?.get(2..)?.split_once('-')?;
    Some((low.parse().ok()?, high.parse().ok()?))
}

/// The first pass of equal ones, and the last.
fn settings(step: &Transition) -> [f64; 2] {
    let (from, to) = (step.from_diameter_mm.to_mm(), step.diameter_mm.to_mm());
    [from + (to - from) / f64::from(step.passes.max(1)), to]
}

#[track_caller]
fn bars_are_set_inside_their_range(plan: &Plan, keys: &str) {
    for step in steps(plan).iter().filter(|step| step.operation.is_boring()) {
        let (low, high) = range(&step.tool.designation).unwrap();
        for set in settings(step) {
            assert!(set >= low - 0.001 && set <= high + 0.001, "{keys}: Ø{set} by {}", step.tool.designation);
        }
        // 1.2.1: rough boring takes up to 3 mm on the diameter, semi-finish up to 1, finish up to 0.3; of a hole made beforehand
        // up to 1.
        let [first, _] = settings(step);
        let most = match step.operation {
            Operation::RoughBore => 3.0,
            Operation::FinishBore
                if step.from_diameter_mm != plan.part.holes[0].state.diameter().unwrap_or_default() =>
            {
                0.3
            }
            _ => 1.0,
        };
        let stock = first - step.from_diameter_mm.to_mm();
        assert!(stock <= most + 0.001, "{keys}: {stock} mm by {}", step.tool.designation);
    }
}

/// Ø50 through 80 mm: BB-R-25-36 reaches 75 mm, and BB-R-34-48 is not set to the 33 mm of a first pass after the largest drill
/// of the machine, Ø30. BC-R-32-48, whose shank of carbide reaches 150 mm, is.
#[test]
fn a_bar_is_set_inside_its_range() {
    let keys = "diameter: 50H14, through: true, roughness: Ra 12.5, centre_tolerance: 0.4";
    let plan = honest("steel-45", 80.0, keys);
    bars_are_set_inside_their_range(&plan, keys);
    let tools: Vec<&str> = steps(&plan).iter().map(|step| step.tool.designation.as_str()).collect();
    assert!(tools.contains(&"BC-R-32-48"), "{tools:?}");
    for (material, thickness) in
        [("steel-45", 40.0), ("СЧ20", 70.0), ("Д16", 80.0), ("steel-45", 95.0), ("СЧ20", 110.0)]
    {
        for diameter in ["32H9", "40H11", "45H12", "50H9", "63H12", "70H7"] {
            for before in
                ["", ", state: pre-machined, state_diameter: 28.5", ", state: pre-machined, state_diameter: 31"]
            {
                let keys =
                    format!("diameter: {diameter}, through: true, roughness: Ra 6.3, centre_tolerance: 0.05{before}");
                bars_are_set_inside_their_range(&self::plan(material, thickness, &keys), &keys);
            }
        }
    }
}

/// The proof knows the ranges by itself.
#[test]
fn the_proof_finds_a_bar_outside_its_range() {
    let faults = |plan: &Plan| {
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        prove_hole(&plan.part.holes[0], steps(plan), &plan.part, &shop).unwrap()
    };
    let outside = |fault: &Fault| matches!(fault, Fault::BarOutOfRange { .. });
    let keys = "diameter: 50H14, through: true, roughness: Ra 12.5, centre_tolerance: 0.4";
    let mut plan = honest("steel-45", 80.0, keys);
    assert!(!faults(&plan).iter().any(outside));
    // The route that was planned once with a bar of steel: Ø30 at once to 48 in six passes, the first at 33.
    let steps = &mut plan.holes[0].transitions;
    let bored = steps.iter_mut().find(|step| step.operation == Operation::RoughBore).unwrap();
    assert_eq!((bored.tool.designation.as_str(), bored.diameter_mm, bored.passes), ("BC-R-32-48", mm(48.0), 6));
    (bored.tool.designation, bored.tool.table) = ("BB-R-34-48".to_owned(), "boring-bars".to_owned());
    let found = faults(&plan);
    let set = found.iter().find_map(|fault| match fault {
        Fault::BarOutOfRange { set, .. } => Some(*set),
        _ => None,
    });
    assert_eq!(set, Some(mm(33.0)), "{found:?}");
    // A bar of 36 mm in a hole of 32.
    let bored = plan.holes[0].transitions.iter_mut().find(|step| step.operation == Operation::RoughBore).unwrap();
    bored.tool.designation = "BB-R-46-66".to_owned();
    assert!(faults(&plan).iter().any(|fault| matches!(fault, Fault::BarEnters { .. })));
}

/// Outer rings of bearings 608 to 6204: the seat is finished down to where the ring has its chamfer, 0.3 mm and more (ISO 15).
#[test]
fn no_seat_over_a_shoulder_is_lost() {
    for material in ["steel-45", "СЧ20", "Д16"] {
        for (seat, depth) in [(22, 7), (26, 8), (28, 8), (30, 9), (32, 10), (35, 11), (40, 12), (42, 13), (47, 14)] {
            let keys = format!(
                "diameter: {}H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.4, \
                 steps: [{{diameter: {seat}H7, depth: {depth}, roughness: Ra 1.6}}]",
                seat - 8
            );
            let plan = honest(material, 40.0, &keys);
            let wrong: Vec<_> = plan.findings.iter().filter(|one| one.severity <= Severity::Wrong).collect();
            assert!(wrong.is_empty(), "{material} {keys}: {wrong:?}");
            let last = steps(&plan).iter().rfind(|step| step.step == Some(1) && !step.elsewhere).unwrap();
            assert!(last.depth_mm >= mm(f64::from(depth) - 0.3), "{material} {keys}: {last:?}");
            assert!(last.depth_mm < mm(f64::from(depth)), "{material} {keys}: runs into the shoulder");
            assert!(!steps(&plan).iter().any(|step| step.elsewhere), "{material} {keys}");
        }
    }
}

/// Reamers end above a flat floor by their lead: in a shallow hole a bar goes deeper.
#[test]
fn a_flat_floor_is_not_left_to_a_reamer() {
    let open = "state: pre-machined, state_diameter: 36";
    for (material, keys) in [
        ("steel-45", "diameter: 16H10, depth: 5, bottom: flat, roughness: Ra 3.2, centre_tolerance: 0.4".to_owned()),
        ("steel-45", "diameter: 16H10, depth: 7, bottom: flat, roughness: Ra 3.2, centre_tolerance: 0.4".to_owned()),
        ("СЧ20", "diameter: 20H9, depth: 8, bottom: flat, roughness: Ra 3.2, centre_tolerance: 0.4".to_owned()),
        ("СЧ20", format!("diameter: 47H9, depth: 20, bottom: flat, roughness: Ra 3.2, centre_tolerance: 0.4, {open}")),
        (
            "steel-45",
            format!("diameter: 47H8, depth: 20, bottom: flat, roughness: Ra 1.6, centre_tolerance: 0.4, {open}"),
        ),
    ] {
        let plan = honest(material, 40.0, &keys);
        let wrong: Vec<_> = plan.findings.iter().filter(|one| one.severity <= Severity::Wrong).collect();
        assert!(wrong.is_empty(), "{material} {keys}: {wrong:?}");
    }
}

/// A hole with a millimetre of stock, or with eleven, is bored: 1.2.1 leaves 0.5 to 1 mm to semi-finish and 0.2 to 0.3 to finish
/// boring, and A.1 row 14 has grade 7 for it.
#[test]
fn a_hole_made_beforehand_is_bored_to_size() {
    for (diameter, before, roughness) in [
        ("72H7", 71.0, "Ra 1.6"),
        ("47H9", 36.0, "Ra 3.2"),
        ("47H8", 36.0, "Ra 1.6"),
        ("62H7", 60.0, "Ra 1.6"),
        ("25H7", 24.0, "Ra 1.6"),
    ] {
        for material in ["steel-45", "СЧ20", "12Х18Н10Т"] {
            for (thickness, position) in [(20.0, 0.4), (60.0, 0.4), (60.0, 0.06)] {
                if thickness > 50.0 && diameter == "25H7" {
                    continue;
                }
                let keys = format!(
                    "diameter: {diameter}, through: true, roughness: {roughness}, centre_tolerance: {position}, \
                     state: pre-machined, state_diameter: {before}"
                );
                let plan = honest(material, thickness, &keys);
                assert!(!steps(&plan).iter().any(|step| step.elsewhere), "{material} {thickness} {keys}");
                bars_are_set_inside_their_range(&plan, &keys);
            }
        }
    }
}

/// The commonest seats of bearings, in solid metal: two borings and a finishing one hold H7 (A.1 row 14, A.8 schemes 24 to 26), with
/// the Ra 1.6 of finish boring (1.2.1).
#[test]
fn seats_above_50_are_bored_here() {
    for material in ["steel-45", "СЧ20", "Д16"] {
        for diameter in [52, 55, 62, 68, 72, 80] {
            for thickness in [20.0, 40.0, 60.0] {
                let keys = format!("diameter: {diameter}H7, through: true, roughness: Ra 1.6, centre_tolerance: 0.4");
                let plan = honest(material, thickness, &keys);
                let [.., before, last] = steps(&plan) else { panic!("{keys}") };
                assert_eq!(
                    (before.operation, last.operation, last.elsewhere),
                    (Operation::SemiFinishBore, Operation::FinishBore, false),
                    "{material} {thickness} {keys}"
                );
                // The middle of 30 µm (ISO 286, IT7 of 50 to 80 mm).
                let nominal = f64::from(diameter);
                assert!((nominal..=nominal + 0.03).contains(&last.diameter_mm.to_mm()), "{last:?}");
                bars_are_set_inside_their_range(&plan, &keys);
            }
        }
    }
}

/// What a later transition of the cylinder leaves is never coarser than what the table said before.
#[test]
fn no_surface_gets_coarser_from_row_to_row() {
    for keys in [
        "diameter: 50H14, through: true, roughness: Ra 12.5, centre_tolerance: 0.4",
        "diameter: 52H7, through: true, roughness: Ra 1.6, centre_tolerance: 0.4",
        "diameter: 40H9, through: true, roughness: Ra 2.5, centre_tolerance: 0.05",
        "diameter: 75H11, through: true, roughness: Ra 6.3, centre_tolerance: 0.4",
        "diameter: 60H7, through: true, roughness: Ra 2.5, centre_tolerance: 0.1, state: cast, state_diameter: 52",
    ] {
        let plan = plan("СЧ20", 45.0, keys);
        let achieved: Vec<_> = steps(&plan).iter().filter_map(|step| step.achieved).collect();
        for pair in achieved.windows(2) {
            assert!(pair[1].it <= pair[0].it && pair[1].roughness <= pair[0].roughness, "{keys}: {achieved:?}");
        }
    }
}

/// 12Х18Н10Т, Ø75H11 Ra 6.3 in 40 mm took 71 minutes while every round of the mill had the feed of the last one: the rough rounds
/// have the feed that they have under a bar.
#[test]
fn rough_rounds_have_the_feed_of_roughing() {
    let keys = |grade: &str| {
        format!("diameter: 75{grade}, through: true, roughness: Ra 6.3, centre_tolerance: 0.4, at: [[0, 0]]")
    };
    let tables = plan_of_hole_by_tables("12Х18Н10Т", "gf2171", "40", &keys("H11"));
    let milled: Vec<_> = steps(&tables).iter().filter(|step| step.operation == Operation::Mill).collect();
    let bored = honest("12Х18Н10Т", 40.0, &keys("H9").replace(", at: [[0, 0]]", ""));
    let under_bar = steps(&bored).iter().find(|step| step.operation == Operation::Mill).unwrap();
    assert_eq!(milled.len(), 2);
    assert_eq!(milled[0].conditions.feed_mm_per_min, under_bar.conditions.feed_mm_per_min);
}

/// The times of one hole in falling grades, as far as its plans are sure and finish it here, min.
fn times(material: &str, thickness: f64, keys: &dyn Fn(&str) -> String) -> Vec<(&'static str, f64)> {
    let grades = ["H14", "H13", "H12", "H11", "H10", "H9", "H8", "H7"];
    let sure = grades.into_iter().filter_map(|grade| {
        let plan = plan(material, thickness, &keys(grade));
        let doubtful = plan.findings.iter().any(|one| one.note.code().starts_with("proof-"));
        let route = plan.holes[0].route.as_ref()?;
        let elsewhere = steps(&plan).iter().any(|step| step.elsewhere);
        (!doubtful && !plan.has_errors() && !elsewhere).then_some((grade, route.time_min.0))
    });
    sure.collect()
}

fn never_slower(material: &str, thickness: f64, keys: &dyn Fn(&str) -> String) -> Result<(), String> {
    let times = times(material, thickness, keys);
    for (at, (coarse, own)) in times.iter().enumerate() {
        for (fine, other) in &times[at + 1..] {
            // The handbook's drills and targets in the middle of another field make a few per cent, a near tie two.
            if *own > other * 1.05 + 0.05 {
                return Err(format!("{material} {thickness} {}: {own:.2} min, as {fine} {other:.2} min", keys(coarse)));
            }
        }
    }
    Ok(())
}

#[test]
fn a_coarse_hole_is_never_slower_than_a_fine_one() {
    let stainless =
        |grade: &str| format!("diameter: 75{grade}, through: true, roughness: Ra 6.3, centre_tolerance: 0.4");
    never_slower("12Х18Н10Т", 40.0, &stainless).unwrap();
    let iron = |grade: &str| format!("diameter: 40{grade}, through: true, roughness: Ra 12.5, centre_tolerance: 0.4");
    never_slower("СЧ20", 30.0, &iron).unwrap();
}

proptest! {
    #![proptest_config(technolog_laws::cases!(12))]

    #[test]
    fn coarse_holes_are_never_slower_than_fine_ones(
        diameter in prop::sample::select(vec![6, 8, 10, 12, 16, 20, 25, 28, 30, 32, 36, 40, 45, 50, 56, 63, 70, 75, 80]),
        depth in 0.5_f64..2.5,
        roughness in prop::sample::select(vec!["Ra 1.6", "Ra 3.2", "Ra 6.3", "Ra 12.5"]),
        material in prop::sample::select(vec!["steel-45", "СЧ20", "Д16", "12Х18Н10Т", "40Х"]),
        form in prop::sample::select(vec!["through: true", "bottom: free", "bottom: flat"]),
        before in prop::sample::select(vec!["", ", state: pre-machined", ", state: cast"]),
        centre in prop::sample::select(vec!["0.5", "0.15", "0.06"]),
    ) {
        let length = (depth * f64::from(diameter)).round().clamp(5.0, 90.0);
        let thickness = if form == "through: true" { length } else { length + 15.0 };
        let before = match before {
            _ if diameter < 25 => String::new(),
            "" => String::new(),
            state => format!("{state}, state_diameter: {}", diameter - diameter / 8),
        };
        let keys = |grade: &str| {
            let depth = if form == "through: true" { String::new() } else { format!("depth: {length}, ") };
            format!("diameter: {diameter}{grade}, {depth}{form}, roughness: {roughness}, centre_tolerance: {centre}{before}")
        };
        never_slower(material, thickness, &keys).map_err(TestCaseError::fail)?;
    }
}

/// Holes that the blank has, wider than the drills: every program of one reads back as its job, and its motions cut what the part
/// asks, on the machine that makes it.
#[test]
fn programs_of_wide_holes_are_proven_on_every_control() {
    for (machine, keys) in [
        ("gf2171", "diameter: 120H7, through: true, roughness: Ra 1.6, state: cast, state_diameter: 110"),
        (
            "haas-vf5-50",
            "diameter: 160H8, depth: 40, bottom: flat, roughness: Ra 3.2, state: cast, state_diameter: 150",
        ),
    ] {
        let keys = format!("{keys}, centre_tolerance: 0.3, at: [[0, 0]]");
        let plan = without_errors(plan_of_hole("СЧ20", machine, "60", &keys), &keys);
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        for (control, language) in technolog_testing::languages() {
            let mut planned = PlannedJob::of(plan.clone(), &language, &KNOWLEDGE).unwrap();
            let text = language.write(&planned.job, Form::read(&shop).unwrap()).text();
            let mut setting = Setting::of_job(&planned.job);
            planned.set(&mut setting);
            let mut moves = Vec::new();
            language.check(&text, &shop.machine, &setting, &mut moves);
            let findings = planned.prove(&moves, &setting).findings;
            assert!(findings.is_empty(), "{control} {machine}: {findings:?}\n{text}");
        }
    }
}

/// Textbook, l. 1071: the machine takes tools up to 125 mm. A bar is as wide as it is set, so Ø124 is bored here and Ø126 is not; the
/// proof finds it by itself in a plan that says otherwise.
#[test]
fn a_bar_is_as_wide_as_it_is_set() {
    let keys = |size: u32| {
        let opened = size - 8;
        format!(
            "diameter: {size}H7, through: true, roughness: Ra 1.6, state: cast, state_diameter: {opened}, centre_tolerance: 0.3"
        )
    };
    honest("СЧ20", 60.0, &keys(124));
    let wide = plan("СЧ20", 60.0, &keys(126));
    assert!(wide.holes[0].route.is_none());
    let there =
        without_errors(plan_of_hole("СЧ20", "haas-vf5-50", "60", &format!("{}, at: [[0, 0]]", keys(126))), "126");
    let shop = Shop::new(&wide.part, wide.cutting, &KNOWLEDGE).unwrap();
    let faults = prove_hole(&there.part.holes[0], &there.holes[0].transitions, &there.part, &shop).unwrap();
    let wider = faults.iter().filter(|fault| matches!(fault, Fault::BarBeyondMachine { .. })).count();
    assert_eq!(wider, steps(&there).iter().filter(|step| step.operation.is_boring()).count());
    assert!(wider > 0);
}
