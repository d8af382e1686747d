//! No figure that the reader of parts accepts is outside a table that planning queries with it.

use std::collections::BTreeMap;
use std::panic::catch_unwind;

use technolog::part::read_part;
use technolog::plan::CuttingMethod;
use technolog::shop::Shop;
use technolog::{job, planner};
use technolog_laws::share;
use technolog_testing::KNOWLEDGE;
use technolog_testing::extremes::{admitted, figures};

/// Every key of the format that holds a figure, in holes of one group each.
const HOLES: [&str; 11] = [
    "diameter: 10H12, depth: 20, roughness: Ra 12.5, centre_tolerance: 0.46, chamfer: 1",
    "diameter: 20H9, through: true, roughness: Rz 20, centre_tolerance: IT9",
    "diameter: 40H7, through: true, roughness: Ra 1.25, centre_tolerance: 0.05",
    "diameter: {nominal: 12, upper: 0.15, lower: 0}, depth: 25, roughness: Ra 6.3, centre_tolerance: 0.2, bottom: flat",
    "thread: M8x1-6H, depth: 20, centre_tolerance: 0.3, chamfer: 1",
    "thread: K1/2, depth: 20, centre_tolerance: 0.3",
    "diameter: 12H11, depth: 30, roughness: Ra 6.3, centre_tolerance: 0.3, counterbore: {diameter: 20, depth: 9}, \
     groove: {diameter: 14, width: 2, depth: 12}",
    "diameter: 12H11, depth: 30, roughness: Ra 6.3, centre_tolerance: 0.3, countersink: {diameter: 17, angle: 90}, face: {diameter: 24}",
    "diameter: 20H9, through: true, roughness: Rz 20, centre_tolerance: 0.3, state: cast, state_diameter: 12, outer_wall: true, skin: true",
    "diameter: 20H9, through: true, roughness: Rz 20, centre_tolerance: 0.3, state: pre-machined, state_diameter: 18.5, \
     cone: {diameter: 20.6, taper: 0.02}",
    "through: true, centre_tolerance: 0.46, steps: [{diameter: 16, depth: 5, roughness: Ra 6.3, chamfer: 0.5}, \
     {thread: M12, length: 10}, {diameter: 8H9, roughness: Ra 2.5}]",
];

const PLACES: [&str; 4] = [
    "at: [[50, 0], [100, 0]]",
    "pattern: {line: {start: [150, 0], count: 3, step: 30.5, angle: 30}}",
    "pattern: {grid: {start: [50, 50], columns: 2, rows: 2, step: [60, 70], angle: 1}}",
    "pattern: {circle: {centre: [0, 80], diameter: 60, count: 3, start_angle: 15}}",
];

/// As the machine bears it.
const PLATE: &str = "length: 800, width: 400, thickness: 40";

/// So large that nothing of it bounds a hole.
const FIELD: &str = "length: 900000000, width: 900000000, thickness: 900000";

fn part(blank: &str, hole: &str, places: &str) -> String {
    format!(
        "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, {blank}}}\n\
         datum: {{x: 300, y: 150, z: 10}}\nposition_tolerance: 0.1\nmass: 46.5\n\
         fixture: {{height: 60, clamps: [{{at: [-250, -130], screw: M10}}, {{at: [250, 130]}}]}}\n\
         holes:\n  - {{name: A, {hole}, {places}}}\n"
    )
}

fn faults(text: &str) -> Vec<String> {
    let Ok(part) = read_part("part.yaml", text, &KNOWLEDGE) else { return Vec::new() };
    let mut faults = Vec::new();
    for method in [CuttingMethod::Formula, CuttingMethod::Card] {
        match planner::plan(&part, method, &KNOWLEDGE) {
            Err(error) => faults.push(format!("{error}")),
            Ok(plan) => {
                let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
                if let Err(error) = job::make(&plan, &shop) {
                    faults.push(format!("job: {error}"));
                }
            }
        }
    }
    faults
}

/// A share of the figures below.
#[test]
fn figures_that_are_admitted_can_be_planned() {
    for blank in [PLATE, FIELD] {
        can_be_planned(blank, 60);
    }
}

#[test]
#[ignore = "takes minutes: every figure as far as it goes"]
fn every_figure_of_a_plate_that_is_admitted_can_be_planned() {
    can_be_planned(PLATE, 1);
}

#[test]
#[ignore = "takes minutes: every figure as far as it goes"]
fn every_figure_of_a_field_that_is_admitted_can_be_planned() {
    can_be_planned(FIELD, 1);
}

fn can_be_planned(blank: &str, usual: usize) {
    let admits = |text: &str| read_part("part.yaml", text, &KNOWLEDGE).is_ok();
    let mut all = Vec::new();
    for (at, hole) in HOLES.iter().enumerate() {
        let text = part(blank, hole, PLACES[at % PLACES.len()]);
        assert!(admits(&text), "{:?}\n{text}", read_part("part.yaml", &text, &KNOWLEDGE).err());
        // What stands before the holes is the same of all.
        let holes = if at == 0 { 0 } else { text.find("holes:").unwrap() };
        let own = figures(&text).into_iter().filter(|figure| figure.from >= holes);
        all.extend(own.map(|figure| (figure, text.clone())));
    }
    // By each fault, how often it came and a part that shows it.
    let mut found = BTreeMap::<String, (usize, String)>::new();
    for (figure, text) in share(all, usual, |_| ()) {
        for changed in admitted(figure, &text, admits) {
            let made = catch_unwind(|| faults(&changed)).unwrap_or_else(|_| vec!["panic".to_owned()]);
            for fault in made {
                found.entry(fault).or_insert_with(|| (0, changed.clone())).0 += 1;
            }
        }
    }
    let reported: Vec<String> =
        found.iter().map(|(fault, (count, text))| format!("{count} times {fault}, as of\n{text}")).collect();
    assert!(reported.is_empty(), "{}", reported.join("\n"));
}
