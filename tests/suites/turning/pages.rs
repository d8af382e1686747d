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

/// Eight parts of every day: seven are made whole, and their programs are written for three controls. The slender shaft
/// bends, which its page says.
#[test]
fn parts_of_every_day_are_made_or_say_why_not() {
    let (whole, bent) = (vec![], vec!["bounds-exceeded"]);
    let parts = [
        ("stepped", &whole, 0),
        ("sleeve", &whole, 0),
        ("cone", &whole, 0),
        ("neck", &whole, 0),
        ("nose", &whole, 0),
        ("dowel", &whole, 0),
        ("disc", &whole, 0),
        ("slender", &bent, 1),
    ];
    for (name, expected, written) in parts {
        let file = format!("examples/turned-{name}.yaml");
        let (code, json) = turn(&[&file, "--format", "json"]);
        let answer: serde_json::Value = serde_json::from_str(&json).unwrap();
        let findings = answer["findings"].as_array().unwrap().iter();
        let wrong = findings.filter(|one| one["severity"] == "wrong").map(|one| one["code"].as_str().unwrap());
        let mut wrong: Vec<&str> = wrong.collect();
        wrong.dedup();
        assert_eq!((&wrong, code), (expected, i32::from(!expected.is_empty())), "{name}");
        for control in ["linuxcnc", "fanuc", "sinumerik"] {
            let (code, program) = turn(&[&file, "--show", "program", "--control", control]);
            assert_eq!((code, program.is_empty()), (written, written == 2), "{name} {control}");
        }
    }
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
/// The cup has 9 mm of bar behind its one cylinder, less than jaws need (15, `turning-hold`): its program is not given out as
/// done.
#[test]
fn a_program_for_what_nothing_holds_is_not_done() {
    assert_eq!(turn(&["examples/turned-dowel.yaml", "--show", "program"]).0, 0);
    assert_eq!(turn(&["tests/everyday/cup.yaml", "--show", "program"]).0, 1);
}

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
