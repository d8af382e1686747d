//! Worked problems of public pages: our formulas with the inputs as published against the results as published.
//!
//! `tests/data/worked-problems.yaml` says what each page got wrong by itself; then the right figure stands beside it.

use std::path::Path;

use serde_yaml::Value;
use technolog::cutting::laws::{LoadLaw, SpeedLaw};
use technolog::cutting::{rpm_at, speed_at};
use technolog::units::{MetresPerMinute, Micrometres, RevsPerMinute};

fn problems() -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/worked-problems.yaml");
    let file: Value = serde_yaml::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    file["problems"].as_sequence().unwrap().clone()
}

fn number(problem: &Value, key: &str) -> Option<f64> {
    let changed = problem.get("with").and_then(|with| with.get(key));
    changed.or_else(|| problem.get(key)).or_else(|| problem.get("inputs")?.get(key)).and_then(Value::as_f64)
}

/// The result of a problem: as published, or as the formula gives it where the page slipped.
fn expected(problem: &Value, key: &str) -> Option<f64> {
    let of = if problem.get("slip").is_some() { "recomputed" } else { "results" };
    problem[of].get(key).or_else(|| problem["recomputed"].get(key)).and_then(Value::as_f64)
}

#[test]
fn published_problems_come_out_as_published() {
    let mut compared = Vec::new();
    for problem in problems() {
        let id = problem["id"].as_str().unwrap();
        let get = |key: &str| number(&problem, key);
        let coefficient = |key: &str| problem.get("coefficients").and_then(|all| all.get(key)).and_then(Value::as_f64);
        let factor = problem.get("factors").and_then(|all| all.get("k")).and_then(Value::as_f64).unwrap_or(1.0);
        let turned = || get("diameter_mm").map(Micrometres::from_mm_rounded);
        let ours = match problem["formula"].as_str().unwrap_or_default() {
            "drilling-speed" => {
                let [cv, q, y, m] = ["cv", "q", "y", "m"].map(|name| coefficient(name).unwrap());
                let law = SpeedLaw { cv, q, x: 0.0, y, m };
                let speed = law.at(
                    get("diameter_mm").unwrap(),
                    1.0,
                    get("feed_mm_per_rev").unwrap(),
                    get("tool_life_min").unwrap(),
                );
                ("speed_m_per_min", speed * factor)
            }
            "drilling-torque" => {
                let [cm, q, y] = ["cm", "q", "y"].map(|name| coefficient(name).unwrap());
                let law = LoadLaw { factor: 10.0 * cm, q, x: 0.0, y };
                let (diameter, feed) = (get("diameter_mm").unwrap(), get("feed_mm_per_rev").unwrap());
                ("torque_n_m", law.at(diameter, 1.0, feed) * factor)
            }
            "spindle" => match (get("speed_m_per_min"), get("spindle_rpm"), turned()) {
                (Some(speed), _, Some(diameter)) => ("spindle_rpm", rpm_at(MetresPerMinute(speed), diameter).0),
                (None, Some(rpm), Some(diameter)) => ("speed_m_per_min", speed_at(RevsPerMinute(rpm), diameter).0),
                _ => continue,
            },
            "time" => match (get("spindle_rpm"), turned(), get("feed_mm_per_rev")) {
                (Some(rpm), Some(diameter), _) => ("speed_m_per_min", speed_at(RevsPerMinute(rpm), diameter).0),
                _ => continue,
            },
            _ => continue,
        };
        let (key, found) = ours;
        let Some(expected) = expected(&problem, key) else { continue };
        assert!((found / expected - 1.0).abs() < 0.05, "{id}: {key} {found}, published {expected}");
        compared.push(id.to_owned());
    }
    assert!(compared.len() >= 5, "{compared:?}");
}
