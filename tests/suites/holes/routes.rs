//! Routes found by hand in the source's tables, held against the planner: every file of tests/routes.

use std::fs;
use std::path::Path;

use serde::Deserialize;
use technolog::part::read_part;
use technolog::plan::{CuttingMethod, HolePlan, Way};
use technolog::planner;
use technolog_testing::KNOWLEDGE;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    hole: Hole,
    scheme: String,
    #[serde(default)]
    operations: Vec<String>,
    #[serde(default)]
    elsewhere: bool,
    because: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Hole {
    diameter: String,
    roughness: String,
    centre_tolerance: f64,
}

impl Hole {
    fn part(&self) -> String {
        format!(
            "part: p\nmaterial: steel-45\nblank: {{kind: plate, length: 400, width: 200, thickness: 30}}\nmachine: \
             gf2171\nholes:\n  - {{name: A, diameter: {}, through: true, roughness: {}, centre_tolerance: {}, at: [[0, 0]]}}\n",
            self.diameter, self.roughness, self.centre_tolerance
        )
    }
}

/// The route that the scheme tables give, whether it was taken or another was quicker: its scheme, its
/// transitions, and whether the hole is finished elsewhere.
fn table_route(hole: &HolePlan) -> Option<(String, Vec<&'static str>, bool)> {
    let route = hole.route.as_ref()?;
    if route.way == Way::Tables {
        let operations = hole.transitions.iter().map(|step| step.operation.name()).collect();
        return Some((route.scheme.clone(), operations, route.finish_elsewhere));
    }
    let other = route.alternatives.iter().find(|other| other.way == Way::Tables && other.time_min.is_some())?;
    let operations = other.operations.iter().map(|made| made.operation.name()).collect();
    Some((other.scheme.clone(), operations, false))
}

#[test]
fn the_planner_finds_the_routes_that_the_tables_give() {
    let mut cases = 0;
    for file in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/routes")).unwrap() {
        let text = fs::read_to_string(file.unwrap().path()).unwrap();
        for case in serde_yaml::from_str::<Vec<Case>>(&text).unwrap() {
            let what = format!(
                "Ø{} {} {}: {}",
                case.hole.diameter, case.hole.roughness, case.hole.centre_tolerance, case.because
            );
            let part = read_part("case", &case.hole.part(), &KNOWLEDGE).unwrap();
            let plan = planner::plan(&part, CuttingMethod::Formula, &KNOWLEDGE).unwrap();
            let found = table_route(&plan.holes[0]);
            let (scheme, operations, elsewhere) = found.unwrap_or_else(|| ("none".to_owned(), Vec::new(), false));
            assert_eq!(scheme, case.scheme, "{what}");
            assert_eq!(operations, case.operations, "{what}");
            assert_eq!(elsewhere, case.elsewhere, "{what}");
            cases += 1;
        }
    }
    assert!(cases > 30, "only {cases} cases");
}
