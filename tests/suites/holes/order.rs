//! `technolog order`, through the whole command, and laws of the order in every plan.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use technolog::machine::Rapid;
use technolog::plan::CuttingMethod;
use technolog::report::Lang;
use technolog::sequence::bound::{lower_bound, rounds};
use technolog::sequence::list::read_list;
use technolog::sequence::metric::Metric;
use technolog::sequence::tour::{Effort, Space, nearest_rule, path, path_while};
use technolog::units::MillimetresPerMinute;
use technolog::{part, planner};
use technolog_testing::{KNOWLEDGE, kinds, patterns};

fn run(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).env_remove("LANG").args(["--lang", "en", "order"]).args(args);
    command.output().unwrap()
}

fn text(args: &[&str]) -> String {
    let output = run(args);
    assert_eq!((output.status.code(), &*String::from_utf8_lossy(&output.stderr)), (Some(0), ""), "{args:?}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&text(&[args, &["--format", "json"]].concat())).unwrap()
}

/// A file of that name with that text, in a folder of this test run.
fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn the_order_of_the_worked_example() {
    insta::assert_snapshot!("order_plate", text(&["examples/plate.yaml"]));
    let answer = json(&["examples/plate.yaml"]);
    for visit in answer["sequence"].as_array().unwrap() {
        let figure = |key: &str| visit[key].as_f64().unwrap();
        assert!(figure("bound_min") <= figure("rapid_min") && figure("rapid_min") <= figure("nearest_rapid_min"));
    }
    let drawing = text(&["examples/plate.yaml", "--format", "svg"]);
    assert_eq!(drawing.matches("<polyline").count(), 3, "one path for each tool");
    assert!(drawing.starts_with("<svg ") && drawing.ends_with("</svg>\n"));
}

#[test]
fn lists_of_points_are_ordered() {
    let square = file("square.csv", "x,y\n0,0\n10,10\n0,10\n10,0\n");
    let square = square.to_str().unwrap();
    let closed = json(&[square, "--closed"]);
    assert_eq!((closed["length_mm"].as_f64(), closed["bound_mm"].as_f64()), (Some(40.0), Some(40.0)));
    assert_eq!(closed["order"], serde_json::json!([1, 3, 2, 4]));
    assert_eq!(json(&[square])["length_mm"].as_f64(), Some(30.0), "an open path does not return");
    let rapid = json(&[square, "--metric", "rapid"]);
    assert_eq!(rapid["time_min"].as_f64(), Some(0.0043), "30 mm at 7000 mm/min");
    assert_eq!(rapid["bound_min"].as_f64(), Some(0.0042), "the same, rounded down");
    let nodes = "1 0 0\n2 3 4\n3 3 0\nEOF\n";
    let tsplib =
        file("three.tsp", &format!("NAME: t\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n{nodes}"));
    assert_eq!(json(&[tsplib.to_str().unwrap(), "--closed"])["length_mm"].as_f64(), Some(12.0));
}

#[test]
fn a_bad_list_is_told_with_line_and_column_and_every_slip() {
    let bad = file("bad.csv", "x,y\n1,two\n3\n");
    let output = run(&[bad.to_str().unwrap()]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("bad.csv:2:3") && stderr.contains("bad.csv:3:1") && stderr.contains("help"), "{stderr}");
}

#[test]
fn a_bad_list_is_told_in_ukrainian_too() {
    let bad = file("bad-uk.csv", "x;y\n1,5;2\n1;дві\n3\n");
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    let output = command.args(["--lang", "uk", "order"]).arg(bad).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    for expected in ["bad-uk.csv:3:3", "`дві` не є числом", "bad-uk.csv:4:1", "дві координати", "підказка"]
    {
        assert!(stderr.contains(expected), "{expected}: {stderr}");
    }
}

#[test]
fn the_effort_acts_on_a_part_and_options_of_lists_are_refused_there() {
    // The plate has few points for each tool: its paths are the shortest already.
    let (plan, again) = (json(&["examples/plate.yaml"]), json(&["examples/plate.yaml", "--effort", "50"]));
    assert_eq!(plan["sequence"], again["sequence"]);
    // Where there are many, more effort is no longer. (Some kinds of holes cannot be made: exit code 1.)
    let part = file("many.yaml", &kinds::part_of_kinds(4));
    let part = part.to_str().unwrap();
    let rapids = |args: &[&str]| -> f64 {
        let answer: Value = serde_json::from_slice(&run(&[args, &["--format", "json"]].concat()).stdout).unwrap();
        answer["time"]["rapid_min"].as_f64().unwrap()
    };
    let (quick, hard) = (rapids(&[part]), rapids(&[part, "--effort", "5"]));
    assert!(hard <= quick, "{hard} > {quick}");
    for option in
        [&["--closed"][..], &["--metric", "rapid"], &["--machine", "gf2171"], &["--tries", "9"], &["--time", "1s"]]
    {
        let output = run(&[&["examples/plate.yaml"], option].concat());
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(option[0]) && stderr.contains("lists of points"), "{stderr}");
    }
}

#[test]
fn a_small_effort_is_close_to_what_is_best_known() {
    // Five seconds of fast-tsp give 3060.8 mm, and so does our default effort (docs/order.md).
    let points = patterns::circles(200);
    let found = path(&Space::closed(&points, Metric::Euclid), Effort(20)).cost;
    assert!(found as f64 <= 3_060_800.0 * 1.002, "{found}");
    let bound = lower_bound(&Space::closed(&points, Metric::Euclid), found, rounds(200));
    assert!(found as f64 <= bound as f64 * 1.02, "{found}, at least {bound}");
}

/// The marks of the drilling problems of TSPLIB, in tries: a clock would not be the same everywhere.
#[test]
fn drilling_problems_come_near_to_their_shortest_tours() {
    for (name, shortest, share, tries) in [("d198", 15_780, 0.0, 2_000), ("d1291", 50_801, 0.003, 10_000)] {
        let file = format!("{}/tests/tours/{name}.tsp", env!("CARGO_MANIFEST_DIR"));
        let list = read_list(name, &std::fs::read_to_string(file).unwrap()).unwrap();
        let closed = Space::closed(&list.points, Metric::EuclidWhole);
        let found = path_while(&closed, &mut |made| made < tries);
        let over = found.cost as f64 / 1000.0 / f64::from(shortest) - 1.0;
        assert!((0.0..=share).contains(&over), "{name}: {} is {over} over the shortest", found.cost);
        let bound = lower_bound(&closed, found.cost, rounds(list.points.len()));
        assert!(bound <= shortest as i64 * 1000 && bound as f64 >= f64::from(shortest) * 985.0, "{name}: {bound}");
        // An open path is the tour without an edge, or better.
        let longest = (0..found.order.len())
            .map(|at| closed.cost(found.order[at], found.order[(at + 1) % found.order.len()]))
            .max();
        let open = path_while(&Space::open(&list.points, Metric::EuclidWhole), &mut |made| made < 2_000);
        assert!(open.cost <= found.cost - longest.unwrap_or(0), "{name}: {} open", open.cost);
    }
}

#[test]
fn many_points_are_near_their_bound() {
    let points = patterns::random(5_000);
    let rapid = Metric::Rapid(Rapid { rate: MillimetresPerMinute(7000.0), acceleration: None });
    for space in [Space::closed(&points, Metric::Euclid), Space::open(&points, rapid)] {
        let found = path_while(&space, &mut |made| made < 200);
        let bound = lower_bound(&space, found.cost, 60);
        assert!(bound <= found.cost && found.cost as f64 <= bound as f64 * 1.05, "{} {bound}", found.cost);
    }
}

#[test]
fn as_many_tries_give_the_path_of_a_clock_again() {
    let file =
        file("clock.csv", &patterns::random(60).iter().map(|at| format!("{},{}\n", at.x, at.y)).collect::<String>());
    let file = file.to_str().unwrap();
    let timed = json(&[file, "--time", "30ms"]);
    let tries = timed["tries"].as_u64().unwrap().to_string();
    assert_eq!(timed["order"], json(&[file, "--tries", &tries])["order"]);
    let stderr = String::from_utf8(run(&[file, "--time", "1"]).stderr).unwrap();
    assert!(stderr.contains("`1`") && stderr.contains("1ms … 3600s"), "{stderr}");
}

/// Centring for four sizes of drill: a speed of its own for each, which the spindle takes once.
#[test]
fn points_of_one_speed_follow_each_other() {
    let part = "part: P\nmaterial: steel-45\nblank: {kind: plate, length: 400, width: 300, thickness: 30}\nmachine: gf2171\n\
                holes:\n";
    let hole = |name: &str, diameter: &str, at: &str| {
        format!(
            "  - {{name: {name}, diameter: {diameter}, depth: 30, through: true, roughness: Ra 12.5, \
             centre_tolerance: 0.3, at: [{at}]}}\n"
        )
    };
    let holes = [
        hole("A", "10H12", "[-150, -100], [-50, -100], [50, -100], [150, -100]"),
        hole("B", "14H12", "[-150, 0], [-50, 0], [50, 0], [150, 0]"),
        hole("C", "8H12", "[-100, -50], [0, -50], [100, -50]"),
    ];
    let part = part::read_part("speeds.yaml", &(part.to_owned() + &holes.concat()), &KNOWLEDGE).unwrap();
    let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
    for visit in &plan.sequence {
        let speed = |stop: &technolog::plan::Stop| {
            let hole = plan.holes.iter().find(|hole| hole.name == stop.hole).unwrap();
            hole.transitions[stop.transition].conditions.spindle_rpm.0.to_bits()
        };
        let speeds: Vec<u64> = visit.stops.iter().map(speed).collect();
        let changes = speeds.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let distinct: std::collections::BTreeSet<u64> = speeds.iter().copied().collect();
        assert_eq!(changes + 1, distinct.len(), "T{}: {speeds:?}", visit.tool);
        assert!(visit.rapid_min.0 <= visit.nearest_rapid_min.0, "T{}", visit.tool);
    }
    let most = plan.sequence.iter().map(|visit| visit.stops.len()).max();
    assert_eq!(most, Some(11), "one centre drill for all");
}

#[test]
fn every_stop_of_many_kinds_is_made_once_and_in_order() {
    let part = part::read_part("kinds.yaml", &kinds::part_of_kinds(10), &KNOWLEDGE).unwrap();
    let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
    let mut done: BTreeMap<(String, technolog::part::Point), Vec<usize>> = BTreeMap::new();
    for visit in &plan.sequence {
        assert!(visit.rapid_min.0 <= visit.nearest_rapid_min.0, "T{}", visit.tool);
        for stop in &visit.stops {
            done.entry((stop.hole.clone(), stop.at)).or_default().push(stop.transition);
        }
    }
    let mut expected = BTreeMap::new();
    for (hole, plan) in part.holes.iter().zip(&plan.holes) {
        let own: Vec<usize> =
            plan.transitions.iter().enumerate().filter(|(_, step)| !step.elsewhere).map(|(index, _)| index).collect();
        for &at in hole.at.iter().filter(|_| !own.is_empty()) {
            expected.insert((hole.name.clone(), at), own.clone());
        }
    }
    assert_eq!(done, expected);
}

#[test]
fn the_bound_is_close_under_the_path_on_drilling_patterns() {
    let rapid = Metric::Rapid(Rapid { rate: MillimetresPerMinute(7000.0), acceleration: None });
    for (name, points) in [("grid", patterns::grid(120)), ("random", patterns::random(120))] {
        for metric in [Metric::Euclid, rapid] {
            let space = Space::closed(&points, metric);
            let found = path(&space, Effort(5)).cost;
            let bound = lower_bound(&space, found, rounds(space.nodes()));
            assert!(bound <= found && found <= nearest_rule(&space).cost);
            assert!(found as f64 <= bound as f64 * 1.02, "{name} {metric:?}: {found}, at least {bound}");
        }
    }
}

/// What is wrong with a list and where; every slip has its words in both languages.
fn codes_of_list(text: &str) -> Vec<String> {
    let problems = read_list("list", text).unwrap_err();
    problems
        .iter()
        .map(|problem| {
            let at = problem.place.as_ref().map_or(String::new(), |at| format!(" {}:{}", at.line, at.column));
            for lang in [Lang::UK, Lang::EN] {
                assert!(lang.remedy(&problem.note).is_some(), "{problem:?}");
                assert!(!lang.say(&problem.note).contains(['{', '}']), "{problem:?}");
            }
            format!("{}{at}", problem.code)
        })
        .collect()
}

#[test]
fn every_slip_is_told_at_once_with_its_place() {
    assert_eq!(
        codes_of_list("x,y\n1,two\n3\n1e9,4\n"),
        ["not-a-number 2:3", "not-a-point 3:1", "coordinate-too-large 4:1"]
    );
    assert_eq!(codes_of_list(""), ["no-points 1:1"]);
    assert_eq!(codes_of_list("x,y\n"), ["no-points 1:1"]);
    assert_eq!(codes_of_list("1,2,3\n"), ["not-a-point 1:1"]);
    assert_eq!(codes_of_list("nan,inf\n"), ["not-a-number 1:1", "not-a-number 1:5"]);
    assert_eq!(
        codes_of_list("NAME: x\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: GEO\nNODE_COORD_SECTION\n1 2\nb 3 4\n"),
        ["distance-kind 3:19", "not-a-node 5:1", "not-a-node-number 6:1"]
    );
    assert_eq!(
        codes_of_list("DIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 2 3\n1 2 3\n"),
        ["node-twice 5:1"]
    );
    assert_eq!(
        codes_of_list("DIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 2 3\n2 2 3\n"),
        ["dimension 1:12"]
    );
    assert_eq!(codes_of_list("NODE_COORD_SECTION\n1 2 3\n"), ["distance-kind-missing 1:1"]);
    assert_eq!(codes_of_list("x;y\n1,5;2\n1,5,2\n"), ["not-a-point 3:1"], "a decimal comma needs another separator");
    assert_eq!(codes_of_list("1.000,5;2\n\"1,5\";\"two\"\n"), ["not-a-number 1:1", "not-a-number 2:8"]);
}
