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
    // The pin has a flat blind bottom and a corner relief, which nothing here makes; turned over, nothing holds the ball.
    let all =
        [("turned-pin", "uk", 1), ("turned-ball", "en", 1), ("turned-bushing", "uk", 0), ("turned-forging", "en", 0)];
    for (name, lang, expected) in all {
        let (code, page) = turn(&[&format!("examples/{name}.yaml"), "--lang", lang]);
        assert_eq!(code, expected, "{name}");
        insta::assert_snapshot!(format!("page_{name}_{lang}"), page);
    }
    let (_, page) = turn(&["examples/shaft-forging.yaml", "--show", "operation", "--lang", "en"]);
    insta::assert_snapshot!("page_shaft_forging_operation_en", page);
}

/// A row of a groove has its feed and its speed. By hand: 1400 1/min on Ø30 is π·30·1.4 = 131.9 m/min; its program feeds
/// F0.1.
#[test]
fn grooves_tell_feed_and_speed() {
    let (_, page) = turn(&["examples/turned-stepped.yaml", "--lang", "en"]);
    let row = |work: &str| -> Vec<&str> {
        let line = page.lines().find(|line| line.split('|').nth(1).is_some_and(|cell| cell.trim() == work));
        line.map(|line| line.split('|').map(str::trim).collect()).unwrap_or_default()
    };
    assert_eq!(row("groove").get(5..8), Some(&["0.100", "131.9", "1400"][..]), "{page}");
}

/// Eight parts of every day are made whole, and their programs are written for three controls.
#[test]
fn parts_of_every_day_are_made() {
    for name in ["stepped", "sleeve", "cone", "neck", "nose", "dowel", "disc", "slender"] {
        let file = format!("examples/turned-{name}.yaml");
        let (code, json) = turn(&[&file, "--format", "json"]);
        let answer: serde_json::Value = serde_json::from_str(&json).unwrap();
        let findings = answer["findings"].as_array().unwrap().iter();
        let wrong = findings.filter(|one| one["severity"] == "wrong").map(|one| one["code"].as_str().unwrap());
        let wrong: Vec<&str> = wrong.collect();
        assert_eq!((wrong, code), (vec![], 0), "{name}");
        for control in ["linuxcnc", "fanuc", "sinumerik"] {
            let (code, program) = turn(&[&file, "--show", "program", "--control", control]);
            assert_eq!((code, program.is_empty()), (0, false), "{name} {control}");
        }
    }
}

/// By hand, between centres 375 mm, Ø25: I = π·25⁴/64 = 19175 mm⁴, c = 375³/(48·E·I). A negative insert presses twice as hard as
/// a positive one (`turning-force-rake`: 2 at −6°, 1 at 0°), so it bends the shaft by more than a fifth of h9 (0.0104 mm) even at
/// the least feed of finishing; the positive one does not.
#[test]
fn a_slender_shaft_is_finished_by_what_presses_least() {
    let (_, json) = turn(&["examples/turned-slender.yaml", "--format", "json"]);
    let answer: serde_json::Value = serde_json::from_str(&json).unwrap();
    let jobs = answer["set_ups"][0]["jobs"].as_array().unwrap();
    let finish = jobs.iter().find(|job| job["work"] == "finish").unwrap();
    assert_eq!(finish["tool"]["designation"], "SVJBR 2020K16");
    let conditions = &finish["conditions"];
    let (force, feed) =
        (conditions["radial_force_n"].as_f64().unwrap(), conditions["feed_mm_per_rev"].as_f64().unwrap());
    // The heaviest stretch is told; that of the body has the least feed.
    let feeds = finish["path"]["moves"].as_array().unwrap().iter().filter_map(|one| one["feed_mm_per_rev"].as_f64());
    let body = feeds.fold(feed, f64::min);
    let exponent = 0.6;
    let on_body = force * libm::pow(body / feed, exponent);
    let bends = on_body * 375.0_f64.powi(3) / (48.0 * 200_000.0 * 19_175.0);
    assert!(body >= 0.08 && bends < 0.2 * 0.052 * 1.05, "{body} {bends}");
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

/// The cup has 9 mm of bar behind its one cylinder, less than jaws need (15, `turning-hold`): nothing that goes to the machine
/// is given out as done.
#[test]
fn what_goes_to_the_machine_for_an_unheld_part_is_not_done() {
    for show in ["program", "setting", "tool-table"] {
        assert_eq!(turn(&["examples/turned-dowel.yaml", "--show", show]).0, 0, "{show}");
        assert_eq!(turn(&["tests/everyday/cup.yaml", "--show", show]).0, 1, "{show}");
    }
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
