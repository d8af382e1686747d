//! Routes found by hand in the source's tables, held against the planner: every file of tests/routes.

use std::fs;
use std::path::Path;

use serde::Deserialize;
use technolog::part::read_part;
use technolog::plan::CuttingMethod;
use technolog::{planner, shipped};

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

#[test]
fn the_planner_finds_the_routes_that_the_tables_give() {
    let knowledge = shipped::knowledge().unwrap();
    let mut cases = 0;
    for file in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/routes")).unwrap() {
        let text = fs::read_to_string(file.unwrap().path()).unwrap();
        for case in serde_yaml::from_str::<Vec<Case>>(&text).unwrap() {
            let what = format!(
                "Ø{} {} {}: {}",
                case.hole.diameter, case.hole.roughness, case.hole.centre_tolerance, case.because
            );
            let part = read_part("case", &case.hole.part(), &knowledge).unwrap();
            let plan = planner::plan(&part, CuttingMethod::Formula, &knowledge).unwrap();
            let hole = &plan.holes[0];
            let scheme = hole.route.as_ref().map_or("none", |route| route.scheme.as_str());
            let operations: Vec<&str> = hole.transitions.iter().map(|step| step.operation.name()).collect();
            assert_eq!(scheme, case.scheme, "{what}");
            assert_eq!(operations, case.operations, "{what}");
            let elsewhere = hole.route.as_ref().is_some_and(|route| route.finish_elsewhere);
            assert_eq!(elsewhere, case.elsewhere, "{what}");
            assert_eq!(plan.has_errors(), case.scheme == "none", "{what}: {:?}", plan.findings);
            cases += 1;
        }
    }
    assert!(cases > 30, "only {cases} cases");
}
