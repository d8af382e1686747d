//! Every filled cell of the scheme tables A.8, A.9 and A.10 and every row of A.4, compared with the planner.
//!
//! The cells are those of the second readings in tests/readings, which were taken from the text and not from the
//! catalogs. For each cell holes inside it are planned; the scheme of the cell must be among the routes and, if it
//! was carried out, its operations must be those of A.7 (A.5 for A.4) with the substitutions that section 1.2
//! permits:
//!
//! - a hole is centred first where section 1.2.1 requires it (the centred twin of a scheme, or `NN + centre`);
//! - above Ø30 the first boring is milling on a contouring control; a hole is drilled in two passes there,
//!   and from Ø15 where that is better;
//! - where no boring bar enters, semi-finish boring is core drilling and rough boring cannot be carried out;
//! - rough boring of 2-3 mm a pass takes as many passes as the stock requires;
//! - counterbores, countersinks and chamfers belong to the openings of the hole and have their place in its order of
//!   transitions.

use std::collections::{BTreeMap, BTreeSet};

use technolog::plan::{Operation, Plan, RouteSource};
use technolog_testing::{RouteSummary, operations, plan_of_hole_by_tables, reading, routes};

/// Schemes that differ only by the centring in front (the source's notes under A.7).
const TWINS: [(&str, &str); 8] =
    [("01", "07"), ("08", "18"), ("09", "16"), ("10", "17"), ("11", "28"), ("12", "30"), ("21", "29"), ("22", "32")];

/// No boring bar enters a hole up to this before it is finished, mm: the bars of the catalogs begin at 15.
const NOT_BORED: f64 = 15.0;

/// Of a test of an interval: diameters inside it, the last at its closed end.
fn diameters(interval: &str) -> &'static [f64] {
    match interval {
        "<= 6" => &[5.0, 6.0],
        "(6..10]" => &[8.0, 10.0],
        "(6..15]" => &[8.0, 15.0],
        "(10..15]" => &[12.0, 15.0],
        "<= 15" => &[10.0, 15.0],
        "(15..25]" => &[18.0, 25.0],
        "(15..30]" => &[20.0, 30.0],
        "(30..50]" => &[40.0, 50.0],
        "> 50" => &[60.0, 80.0],
        // A hole that is there already has no interval.
        "-" => &[40.0, 60.0],
        other => panic!("no diameter for {other}"),
    }
}

fn grade(interval: &str) -> u8 {
    match interval {
        "[9..10]" => 9,
        "[7..8]" => 7,
        "6" => 6,
        "11" => 11,
        ">= 13" => 13,
        other => panic!("no grade for {other}"),
    }
}

fn centre_tolerance(interval: &str) -> &'static str {
    match interval {
        "<= 0.05" => "0.05",
        "(0.05..0.3]" => "0.2",
        "> 0.3" => "0.46",
        "[0.1..0.2]" => "0.15",
        "> 0.2" => "0.25",
        other => panic!("no centre tolerance for {other}"),
    }
}

/// The transitions of a scheme of A.7 or a complex of A.5, by the second reading.
fn transitions(table: &str, column: &str) -> BTreeMap<String, Vec<Operation>> {
    let rows = reading(table);
    rows.iter().map(|row| (row[column].clone(), operations(&row["transitions"]))).collect()
}

/// Whether the operations of a route are the transitions of a scheme with the substitutions above.
fn same(expected: &[Operation], found: &[Operation], diameter: f64) -> bool {
    let Some((first, rest)) = expected.split_first() else { return found.is_empty() };
    let starts: &[&[Operation]] = match first {
        Operation::Drill => &[&[Operation::Drill], &[Operation::Drill, Operation::DrillOut]],
        // A mill that finishes roughs first.
        Operation::RoughBore if diameter > 30.0 => {
            &[&[Operation::Mill, Operation::Mill], &[Operation::Mill], &[Operation::RoughBore]]
        }
        Operation::Mill => &[&[Operation::Mill, Operation::Mill], &[Operation::Mill]],
        Operation::SemiFinishBore if diameter <= NOT_BORED => &[&[Operation::CoreDrill]],
        other => &[&[*other]],
    };
    let mut ways = starts.iter().filter_map(|start| found.strip_prefix(*start));
    ways.any(|tail| {
        let again = *first == Operation::RoughBore && tail.first() == Some(&Operation::RoughBore);
        same(rest, tail, diameter) || (again && same(expected, tail, diameter))
    })
}

/// Without what belongs to the openings of the hole.
fn of_cylinder(all: &[Operation]) -> Vec<Operation> {
    let opening = |operation: &&Operation| {
        matches!(operation, Operation::Counterbore | Operation::Countersink | Operation::Chamfer)
    };
    all.iter().filter(|operation| !opening(operation)).copied().collect()
}

/// One hole inside a cell.
struct CellQuestion<'a> {
    what: String,
    plan: &'a Plan,
    source: RouteSource,
    /// The schemes of the cell.
    schemes: Vec<&'a str>,
    diameter: f64,
    /// Whether section 1.2.1 centres it first.
    centred: bool,
}

/// Compares one hole with its cell; what could not be carried out goes to `refused` with its reason.
fn check(
    cell: &CellQuestion<'_>,
    known: &BTreeMap<String, Vec<Operation>>,
    refused: &mut BTreeSet<String>,
    wrong: &mut Vec<String>,
) {
    let all = routes(cell.plan);
    let of_way: Vec<&RouteSummary> =
        all.iter().filter(|found| found.source.is_none_or(|source| source == cell.source)).collect();
    for scheme in &cell.schemes {
        let mut own = known[*scheme].clone();
        let mut names = vec![(*scheme).to_owned()];
        if cell.centred && own.first() != Some(&Operation::CentreDrill) {
            own.insert(0, Operation::CentreDrill);
            let twin = TWINS.iter().find(|(plain, _)| plain == scheme).filter(|_| cell.source == RouteSource::Tables);
            names = vec![twin.map_or(format!("{scheme} + centre"), |(_, twin)| (*twin).to_owned())];
        }
        let Some(found) = of_way.iter().find(|found| names.contains(&found.scheme)) else {
            let there: Vec<_> = of_way.iter().map(|found| (&found.scheme, &found.why)).collect();
            wrong.push(format!("{}: no {names:?} among {there:?}", cell.what));
            continue;
        };
        if !found.carried_out {
            if !matches!(found.why.as_str(), "ranked-later" | "same-as") {
                refused.insert(format!("{} scheme {scheme}: {}", cell.what, found.why));
            }
            continue;
        }
        let operations: Vec<Operation> = found.operations.iter().map(|(operation, _)| *operation).collect();
        if !same(&of_cylinder(&own), &of_cylinder(&operations), cell.diameter) {
            wrong.push(format!("{}: scheme {scheme} is {own:?}, planned {operations:?}", cell.what));
        }
    }
}

/// What holes that are there already leave to be cut on the diameter: enough for every stage of schemes 25, 26.
const STOCK: f64 = 6.0;

/// The holes of A.8 or A.9: in solid metal, cast, and pre-machined in an outer wall.
fn main_holes(table: &str) -> (usize, usize, BTreeSet<String>, Vec<String>) {
    let schemes = transitions("A.7", "scheme");
    let (mut cells, mut holes) = (0, 0);
    let (mut refused, mut wrong) = (BTreeSet::new(), Vec::new());
    for row in reading(table) {
        cells += 1;
        let it = grade(&row["it"]);
        let solid = row["state"] == "solid";
        let elsewhere = row.get("finish_elsewhere").is_some_and(|own| own == "true");
        for roughness in row["roughness"].split(" | ") {
            for &diameter in diameters(&row["diameter"]) {
                holes += 1;
                let state = match row["outer_wall"].as_str() {
                    "-" => String::new(),
                    "false" => format!(", state: cast, state_diameter: {}", diameter - STOCK),
                    _ => format!(", state: pre-machined, state_diameter: {}, outer_wall: true", diameter - STOCK),
                };
                let keys = format!(
                    "diameter: {diameter}H{it}, through: true, roughness: {roughness}, centre_tolerance: {}{state}, \
                     at: [[0, 0]]",
                    centre_tolerance(&row["centre_tolerance"])
                );
                let plan = plan_of_hole_by_tables("steel-45", "gf2171", "30", &keys);
                let cell = CellQuestion {
                    what: format!(
                        "{table} Ø{diameter} IT{it} {roughness} {} {}",
                        row["centre_tolerance"], row["state"]
                    ),
                    plan: &plan,
                    source: RouteSource::Tables,
                    schemes: row["schemes"].split(' ').collect(),
                    diameter,
                    // Short holes of grade 13 and coarser under Ø25 are not centred; short is up to two diameters.
                    centred: solid && (it < 13 || diameter >= 25.0 || 30.0 / diameter > 2.0),
                };
                let before = refused.len();
                check(&cell, &schemes, &mut refused, &mut wrong);
                // The text prints 25*1*2 here; the second reading takes the *1 for a slip, the catalog keeps it
                // (tests/readings/settled.yaml).
                let settled = row["it"] == "[7..8]"
                    && row["centre_tolerance"] == "(0.05..0.3]"
                    && (row["state"].as_str(), row["outer_wall"].as_str()) == ("cast-or-pre-machined", "false");
                let taken = plan.holes[0].route.as_ref().filter(|route| route.source == RouteSource::Tables);
                let ends_elsewhere = taken.is_some_and(|route| route.finish_elsewhere);
                let is_reported = plan.findings.iter().any(|finding| finding.note.code() == "finish-elsewhere");
                if refused.len() == before && ends_elsewhere != (elsewhere || settled) {
                    wrong.push(format!("{}: finished on another machine: {ends_elsewhere}", cell.what));
                }
                if ends_elsewhere && !is_reported {
                    wrong.push(format!("{}: is finished on another machine, and nothing says so", cell.what));
                }
            }
        }
    }
    (cells, holes, refused, wrong)
}

#[test]
fn every_cell_of_a8_gives_its_scheme() {
    let (cells, holes, refused, wrong) = main_holes("A.8");
    assert!(wrong.is_empty(), "{wrong:#?}\nrefused {refused:#?}");
    assert_eq!((cells, holes), (79, 188));
    assert!(refused.is_empty(), "{refused:#?}");
}

#[test]
fn every_cell_of_a9_gives_its_scheme() {
    let (cells, holes, refused, wrong) = main_holes("A.9");
    assert!(wrong.is_empty(), "{wrong:#?}\nrefused {refused:#?}");
    assert_eq!((cells, holes), (60, 120));
    // Scheme 04 bores, and no bar enters Ø12 (section 1.2: only diameters that let a boring tool in).
    let expected = ["A.9 Ø12 IT13 Rz 40 (0.05..0.3] solid", "A.9 Ø12 IT13 Rz 40 > 0.3 solid"];
    assert_eq!(refused, expected.map(|cell| format!("{cell} scheme 04: too-small-to-bore")).into());
}

/// A hole of grade 13 with a counterbore: its keys and its diameter.
fn counterbored(diameter: f64, wide: u32) -> (String, f64) {
    let keys = format!("diameter: {diameter}H13, roughness: Ra 12.5, counterbore: {{diameter: {wide}, depth: 8}}");
    (keys, diameter)
}

/// Holes inside a row of A.10: the keys of the part file, the hole's own diameter, and the grade.
fn auxiliary(hole: &str, diameter: &str) -> Vec<(String, f64)> {
    let plain = |diameter: f64| format!("diameter: {diameter}H13, roughness: Ra 12.5");
    let thread = |thread: &str, hole: f64| (format!("thread: {thread}"), hole);
    match (hole, diameter) {
        // Under a thread the drill of GOST 19257.
        ("thread-cylindrical", "<= 16") => vec![thread("M10", 8.5), thread("M16", 14.0)],
        ("thread-cylindrical", "(16..27]") => vec![thread("M20", 17.5), thread("M27", 24.0)],
        ("thread-cylindrical", "> 27") => vec![thread("M30", 26.5), thread("M36", 32.0)],
        // The outside diameter of K3/4 in the gauge plane is 26.568: the row's own end.
        ("thread-conical", "<= 26.568") => vec![thread("K1/2", 18.5), thread("K3/4", 24.0)],
        ("thread-conical", "> 26.568") => vec![thread("K1", 30.0)],
        // Under the screw heads of A.13, and with the counterbores of A.22.
        ("counterbore", "<= 6") => vec![counterbored(5.8, 10), counterbored(6.0, 15)],
        ("counterbore", "(6..15]") => vec![counterbored(9.0, 15), counterbored(14.0, 20)],
        ("counterbore", "(15..25]") => vec![counterbored(18.0, 26), counterbored(22.0, 34)],
        _ => diameters(diameter)
            .iter()
            .map(|&diameter| {
                let wide = diameter + 8.0;
                let opening = match hole {
                    "countersink-90" => format!("countersink: {{diameter: {wide}}}"),
                    "countersink-other" => format!("countersink: {{diameter: {wide}, angle: 120}}"),
                    other => panic!("no hole {other}"),
                };
                (format!("{}, {opening}", plain(diameter)), diameter)
            })
            .collect(),
    }
}

#[test]
fn every_row_of_a10_gives_its_scheme() {
    let schemes = transitions("A.7", "scheme");
    let (mut cells, mut holes) = (0, 0);
    let (mut refused, mut wrong) = (BTreeSet::new(), Vec::new());
    for row in reading("A.10") {
        cells += 1;
        for (keys, diameter) in auxiliary(&row["hole"], &row["diameter"]) {
            holes += 1;
            let threaded = row["hole"].starts_with("thread");
            let keys = format!(
                "{keys}, through: true, centre_tolerance: {}, at: [[0, 0]]",
                centre_tolerance(&row["centre_tolerance"])
            );
            let plan = plan_of_hole_by_tables("steel-45", "gf2171", "20", &keys);
            // A scheme with a star is only for holes that no drill has the size of: all of these have one.
            let starred: Vec<&str> = row["if_drill_differs"].split(' ').collect();
            let cell = CellQuestion {
                what: format!("A.10 {} Ø{diameter} {}", row["hole"], row["centre_tolerance"]),
                plan: &plan,
                source: RouteSource::Tables,
                schemes: row["schemes"].split(' ').filter(|scheme| !starred.contains(scheme)).collect(),
                diameter,
                centred: threaded || diameter >= 25.0 || 20.0 / diameter > 2.0,
            };
            check(&cell, &schemes, &mut refused, &mut wrong);
            let opening = plan.holes[0].transitions.iter().any(|step| {
                matches!(step.operation, Operation::Counterbore | Operation::Countersink | Operation::CentreDrill)
                    || step.also_diameter_mm.is_some()
            });
            if !threaded && plan.holes[0].route.is_some() && !opening {
                wrong.push(format!("{}: nothing opens it", cell.what));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}\nrefused {refused:#?}");
    assert_eq!((cells, holes), (24, 46));
    assert!(refused.is_empty(), "{refused:#?}");
}

/// Holes inside a row of A.4.
fn of_group(hole: &str, diameter: &str) -> Vec<(String, f64)> {
    let plain = |diameter: f64| format!("diameter: {diameter}H13, roughness: Ra 12.5");
    let thread = |thread: &str, hole: f64| (format!("thread: {thread}"), hole);
    match (hole, diameter) {
        ("threaded", "<= 16") => vec![thread("M10", 8.5), thread("M16", 14.0)],
        ("threaded", "(16..24]") => vec![thread("M20", 17.5), thread("M24", 21.0)],
        ("counterbored", "<= 15") => vec![counterbored(9.0, 15), counterbored(14.0, 20)],
        ("counterbored", "(15..30]") => vec![counterbored(18.0, 26), counterbored(26.0, 40)],
        _ => diameters(diameter)
            .iter()
            .map(|&diameter| match hole {
                "smooth" => (plain(diameter), diameter),
                "countersunk" => {
                    (format!("{}, countersink: {{diameter: {}}}", plain(diameter), diameter + 6.0), diameter)
                }
                "precise" => (format!("diameter: {diameter}H7, roughness: Ra 2.5"), diameter),
                other => panic!("no hole {other}"),
            })
            .collect(),
    }
}

#[test]
fn every_row_of_a4_gives_its_complex() {
    let complexes = transitions("A.5", "complex");
    let (mut rows, mut holes, mut used) = (0, 0, BTreeSet::new());
    let (mut refused, mut wrong) = (BTreeSet::new(), Vec::new());
    for row in reading("A.4") {
        rows += 1;
        used.insert(row["complex"].clone());
        for (keys, diameter) in of_group(&row["hole"], &row["diameter"]) {
            holes += 1;
            let keys = format!(
                "{keys}, through: true, centre_tolerance: {}, at: [[0, 0]]",
                centre_tolerance(&row["centre_tolerance"])
            );
            let plan = plan_of_hole_by_tables("steel-45", "gf2171", "20", &keys);
            let coarse = keys.contains("H13");
            let cell = CellQuestion {
                what: format!("A.4 {} Ø{diameter} {}", row["hole"], row["centre_tolerance"]),
                plan: &plan,
                source: RouteSource::Complexes,
                schemes: vec![&row["complex"]],
                diameter,
                centred: !coarse || diameter >= 25.0 || 20.0 / diameter > 2.0,
            };
            check(&cell, &complexes, &mut refused, &mut wrong);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}\nrefused {refused:#?}");
    assert_eq!((rows, holes, used.len()), (22, 44, 13), "A.4 leads to every complex of A.5");
    assert!(refused.is_empty(), "{refused:#?}");
}

/// The comparison itself.
#[test]
fn the_comparison_of_operations_tells_schemes_apart() {
    let ream = operations("centre-drill drill core-drill rough-ream finish-ream");
    let bored = operations("centre-drill drill semi-finish-bore rough-ream finish-ream");
    assert!(same(&bored, &ream, 15.0), "no bar enters");
    assert!(!same(&bored, &ream, 25.0), "a bar enters");
    assert!(same(&operations("drill rough-bore"), &operations("drill drill-out rough-bore rough-bore"), 25.0));
    assert!(!same(&operations("drill rough-bore"), &operations("drill mill"), 25.0), "milled only above 30");
    assert!(same(&operations("drill rough-bore"), &operations("drill mill"), 40.0));
    assert!(!same(&operations("drill"), &operations("drill rough-bore"), 40.0));
}
