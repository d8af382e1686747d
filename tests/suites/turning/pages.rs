//! The pages, drawings and programs of turned parts, whole.

use std::process::Command;

fn turn(arguments: &[&str]) -> (i32, String) {
    let root = env!("CARGO_MANIFEST_DIR");
    let run =
        Command::new(env!("CARGO_BIN_EXE_technolog")).current_dir(root).arg("turn").args(arguments).output().unwrap();
    (run.status.code().unwrap(), String::from_utf8(run.stdout).unwrap())
}

#[test]
fn every_example_has_its_page() {
    // Only the pin has a flat blind bottom and a corner relief, which nothing here makes.
    let all =
        [("turned-pin", "uk", 1), ("turned-ball", "en", 0), ("turned-bushing", "uk", 0), ("turned-forging", "en", 0)];
    for (name, lang, expected) in all {
        let (code, page) = turn(&[&format!("examples/{name}.yaml"), "--lang", lang]);
        assert_eq!(code, expected, "{name}");
        insta::assert_snapshot!(format!("page_{name}_{lang}"), page);
    }
    let (_, page) = turn(&["examples/shaft-forging.yaml", "--show", "operation", "--lang", "en"]);
    insta::assert_snapshot!("page_shaft_forging_operation_en", page);
}

/// Each way is drawn under its own title, each arc as an arc, and JSON tells every zone with its ways.
#[test]
fn the_drawing_and_the_answer_have_every_zone() {
    let (_, json) = turn(&["examples/turned-pin.yaml", "--format", "json"]);
    let answer: serde_json::Value = serde_json::from_str(&json).unwrap();
    let sides = || answer["set_ups"].as_array().unwrap().iter().flat_map(|one| one["sides"].as_array().unwrap());
    let works: usize = sides()
        .flat_map(|side| side["zones"].as_array().unwrap())
        .map(|zone| zone["works"].as_array().unwrap().len())
        .sum();
    let (code, drawing) = turn(&["examples/turned-pin.yaml", "--format", "svg", "--lang", "en"]);
    assert_eq!(code, 1);
    // Every text stands twice, first as its own white edge.
    assert_eq!(drawing.matches("t_p = ").count(), 2 * works);
    assert_eq!(drawing.matches("allowances and zones").count(), 2 * sides().count());
    assert!(drawing.lines().any(|line| line.starts_with("<path") && line.contains(" 0 0 ")), "no arcs");
    let (_, all) = turn(&["examples/turned-pin.yaml", "--show", "schemes", "--format", "svg", "--lang", "en"]);
    let ways: usize = sides()
        .flat_map(|side| side["zones"].as_array().unwrap())
        .flat_map(|zone| zone["works"].as_array().unwrap())
        .map(|work| work["transitions"].as_array().unwrap().len())
        .sum();
    assert!(ways > 3 * works);
    assert_eq!(all.matches("t_p = ").count(), 2 * ways);
    assert!(drawing.starts_with("<svg ") && drawing.ends_with("</svg>\n"));
}

/// The zones of the forging are planned for different spindle speeds: one program has them all, in the order of work.
#[test]
fn programs_have_the_speed_of_their_zone() {
    let (code, text) = turn(&["examples/turned-forging.yaml", "--show", "program"]);
    assert_eq!(code, 0);
    let rpm: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("G97 S")).collect();
    let (_, json) = turn(&["examples/turned-forging.yaml", "--format", "json"]);
    let answer: serde_json::Value = serde_json::from_str(&json).unwrap();
    let jobs = answer["set_ups"][0]["jobs"].as_array().unwrap();
    let mut planned: Vec<String> =
        jobs.iter().map(|job| format!("{} M3", job["conditions"]["spindle_rpm"].as_f64().unwrap())).collect();
    planned.dedup();
    assert_eq!(rpm, planned);
    let (_, cycle) = turn(&["examples/turned-forging.yaml", "--show", "cycle"]);
    assert!(cycle.contains("\nG71 Q"), "{cycle}");
    insta::assert_snapshot!("program_turned_forging", text);
    // Without a lathe no speed is known.
    assert_eq!(turn(&["examples/shaft.yaml", "--show", "program"]), (2, String::new()));
    assert_eq!(turn(&["examples/turned-forging.yaml", "--show", "program", "--number", "9"]).0, 2);
    assert_eq!(turn(&["examples/turned-forging.yaml", "--show", "map"]).0, 2);
}
