//! The lecture's splitting into levels and its schemes of removal: by hand, by the lecture's own orders of points, and
//! by laws.

use std::fs;
use std::path::Path as File;
use std::process::Command;

use proptest::prelude::*;
use technolog::error::KnowledgeError;
use technolog::tables::turning::part::StockKind;
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::turning::schemes::levels::Levels;
use technolog::turning::schemes::path::{Motion, Vertex, VertexRole};
use technolog::turning::schemes::removal::{self, Scheme};
use technolog::turning::schemes::report::{measure, points};
use technolog::turning::schemes::zones::SchemeZone;
use technolog::turning::schemes::{Schemes, find};
use technolog::turning::shaft::{Division, Shaft, Step};
use technolog::turning::workpiece::{Workpiece, read_turned};
use technolog::units::Micrometres;
use technolog_testing::KNOWLEDGE;
use technolog_testing::shafts::{rates, shaft, shafts, workpiece};

fn mm(value: f64) -> Half {
    Half::from(value)
}

fn path(scheme: Scheme, levels: &Levels) -> Vec<Vertex> {
    removal::path(scheme, levels, mm(2.0), mm(0.5))
}

fn levels(workpiece: &Workpiece) -> Levels {
    Levels::of(workpiece, workpiece.shaft.as_ref().unwrap().roughing.longitudinal_depth)
}

fn schemes(name: &str) -> Result<Schemes, KnowledgeError> {
    let read = example(name);
    find(&read, read.shaft.as_ref().unwrap(), &KNOWLEDGE)
}

fn example(name: &str) -> Workpiece {
    let file = File::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.yaml"));
    let text = fs::read_to_string(file).unwrap();
    read_turned(name, &text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{mistakes:?}"))
}

/// 12.4-1, 12.4-2, 12.4-3, 12.4-4, 12.4-5: the lecture, 12.4 a-e (l. 608-650), for a bar Ø80 and a limiting depth of 4 mm:
///
/// - a: t1 = (80 − 51.2) / 2 = 14.4, t2 = (80 − 64.8) / 2 = 7.6, t3 = (80 − 73) / 2 = 3.5, so (t1, t2) > 4 > t3;
/// - b: 14.4 / 4 = 3.6 → 4, 7.6 / 4 = 1.9 → 2, 3.5 / 4 = 0.875 → 1;
/// - c: 14.4 / 4 = 3.6, 7.6 / 2 = 3.8, 3.5 / 1 = 3.5;
/// - d: the largest is that of the second cylinder, t_p = 3.8, as the lecture supposes;
/// - e: 40 − 3.8 = 36.2, 32.4, 28.6, and the last at the cylinder itself, 25.6: Ø72.4, 64.8, 57.2, 51.2.
#[test]
fn the_zone_is_split_as_the_lecture_does() {
    let levels = levels(&example("shaft-three-cylinders"));
    let stocks = &levels.cylinders;
    assert_eq!(stocks.iter().map(|one| one.stock).collect::<Vec<_>>(), [mm(14.4), mm(7.6), mm(3.5)]);
    assert_eq!(stocks.iter().map(|one| one.passes).collect::<Vec<_>>(), [4, 2, 1]);
    assert_eq!(stocks.iter().map(|one| one.mean).collect::<Vec<_>>(), [mm(3.6), mm(3.8), mm(3.5)]);
    assert_eq!((levels.limit, levels.depth), (mm(4.0), mm(3.8)));
    let found = schemes("shaft-three-cylinders").unwrap();
    let horizontals: Vec<String> =
        found.splitting.horizontals[0].diameters_mm.iter().map(ToString::to_string).collect();
    assert_eq!(horizontals, ["72.4", "64.8", "57.2", "51.2"]);
}

/// The shaft that the figures 12.7-12.9 must show: their tools visit a level over the third cylinder and then its
/// surface, so t_p < t3, though by step d no t_p is below the mean depth of a cylinder with one pass. Here t_p = 3.8,
/// t2 = 2·t_p (point 2 lies on the second level in fig. 12.7 and 12.9 a), 3·t_p < t1 < 4·t_p, t_p < t3 < 2·t_p.
fn figure() -> Levels {
    let shaft = shaft(80_000, &[(51_200, 30_000), (64_800, 25_000), (70_000, 20_000)], 4_000, 3_000, Division::Full);
    Levels { depth: mm(3.8), ..levels(&workpiece(&shaft)) }
}

fn names(scheme: Scheme, levels: &Levels) -> String {
    points(&path(scheme, levels), levels).into_iter().map(|point| point.name).collect::<Vec<_>>().join(" ")
}

/// 12.4-7. Lecture l. 687-697: A, 4, 5, 6, (7, 8), 2, 9-16, 5; then 5, 17, 18, 19, 20, 21, 3, 17, 22, 23, 24, 3, 25,
/// 26, A. Ours is the same up to 24, except for corner 2, which the tool passes between 16 and 5. Then we stop δ before
/// corner 3 at a point of its own (25), so that the end and the way off it count one more.
#[test]
fn verticals_visit_the_points_in_the_order_of_figure_12_7() {
    let found = names(Scheme::Verticals, &figure());
    let lecture = "A 4 5 6 7 8 2 9 10 11 12 13 14 15 16 (2) 5 17 18 19 20 21 3 17 22 23 24";
    let ours = lecture.replace("(2)", "2") + " 25 26 27 A";
    assert_eq!(found, ours);
}

/// 12.4-8. Lecture l. 712-727: A, 4, 5, 6, 7, 8, 9, 3, 10; after the return from 11 to 12; from 1 to 15; 15-2; A. The text
/// counts no points for the return after 10, and begins the last pass at the corner 1 itself; by roles it is the same.
#[test]
fn levels_visit_the_points_in_the_order_of_figure_12_8() {
    let levels = figure();
    let found = names(Scheme::Levels, &levels);
    assert!(found.starts_with("A 4 5 6 7 8 9 3 10 "), "{found}");
    assert_eq!(working(Scheme::Levels, &levels), "A 4 5 6 7 3 8 9 10 1 11 2 A");
}

/// The names of the points without drawing back and returning, counted by themselves; the beginning of a pass along
/// the first cylinder is its corner 1, as the lecture has it.
fn working(scheme: Scheme, levels: &Levels) -> String {
    let kept: Vec<Vertex> = path(scheme, levels)
        .into_iter()
        .filter(|vertex| !matches!(vertex.role, VertexRole::Retracted | VertexRole::Returned))
        .map(|mut vertex| {
            let first = levels.cylinders[0];
            if vertex.role == VertexRole::Start && vertex.at.radius == first.radius {
                vertex.at.z = first.from;
            }
            vertex
        })
        .collect();
    points(&kept, levels).into_iter().map(|point| point.name).collect::<Vec<_>>().join(" ")
}

/// 12.4-9. Lecture l. 739-750: A-4-5 over all zones, 4-6-2 and 6-7-8 over the first, then 1, 9, 2, 10, 3, 11, A. Point 2 ends
/// the second pass, so the second cylinder keeps a full t_p: "all but the second keep less than the limit" (l. 754).
#[test]
fn horizontals_a_visit_the_points_in_the_order_of_figure_12_9_a() {
    assert_eq!(working(Scheme::HorizontalsA, &figure()), "A 4 5 6 2 7 8 1 9 2 10 3 11 A");
}

/// 12.4-10. Lecture l. 778-786: layers 1, 2, 3, then the pass from 1 by 10, 2, 11, 3, 12 to A, with less than t_p
/// between 8 and 1 and between 9 and 10: so 8-9 is the third level, 9 its end at the face of 10. That 7 is not the
/// point 11 requires a second cylinder between two levels: t2 = 8 mm here.
#[test]
fn horizontals_b_visit_the_points_in_the_order_of_figure_12_9_b() {
    let shaft = shaft(80_000, &[(51_200, 30_000), (64_000, 25_000), (70_000, 20_000)], 4_000, 3_000, Division::Full);
    let levels = Levels { depth: mm(3.8), ..levels(&workpiece(&shaft)) };
    assert_eq!(working(Scheme::HorizontalsB, &levels), "A 4 5 6 7 8 9 1 10 2 11 3 12 A");
}

/// 12.4-6. One cylinder Ø30 × 10 of a bar Ø40, depth at most 4. By hand: t = 5, n = 2, t_p = 2.5; A is at radius 22, Z +2.
///
/// | motion | to (radius, Z in) | way | feed |
/// |---|---|---|---|
/// | rapid | 17.5, −2 | 4.5 | |
/// | along | 17.5, 10 | 2 + 10 | 100 |
/// | rapid | 18, 9.5 | √0.5 = 0.7071, longer axis 0.5 | |
/// | rapid | 18, −2 | 11.5 | |
/// | rapid | 15, −2 | 3 | |
/// | along | 15, 10 | 2 + 10 | 100 |
/// | across | 20, 10 | 5 | 80 |
/// | rapid | 20.5, 9.5 | 0.7071, 0.5 | |
/// | rapid | 22, −2 | √(1.5² + 11.5²) = 11.5974, 11.5 | |
///
/// Cutting 10 + 10 + 5 = 25; idle 4.5 + 0.7071 + 11.5 + 3 + 0.7071 + 11.5974 + 2·2 = 36.0116;
/// time 24/100 + 5/80 + (4.5 + 0.5 + 11.5 + 3 + 0.5 + 11.5)/5000 = 0.24 + 0.0625 + 0.0063 = 0.3088.
#[test]
fn lengths_and_time_of_a_path_are_those_of_its_motions() {
    let mut shaft = shaft(40_000, &[(30_000, 10_000)], 4_000, 4_000, Division::Full);
    shaft.blank.length = Micrometres::from_mm(20);
    let levels = levels(&workpiece(&shaft));
    for scheme in [Scheme::Verticals, Scheme::Levels, Scheme::HorizontalsA] {
        let measures = measure(&path(scheme, &levels), &rates());
        assert_eq!((measures.cutting_mm, measures.passes), (mm(25.0), 2), "{scheme:?}");
        assert_eq!((measures.idle_mm, measures.time_min.0), (36.012, 0.3088), "{scheme:?}");
    }
    // 5 is twice 2.5: form b takes both levels straight and goes along the contour once more, 12 mm at the feed and 5 up.
    let b = measure(&path(Scheme::HorizontalsB, &levels), &rates());
    assert_eq!((b.cutting_mm, b.passes), (mm(35.0), 3));
}

/// 12.3-1 and 12.4-13. The lecture's zones (l. 249-269) and conclusions (l. 500-512) for the three cylinders: faces ahead of the first two,
/// none ahead of the third, which runs out.
#[test]
fn zones_and_their_schemes_come_from_the_rules() {
    let found = schemes("shaft-three-cylinders").unwrap();
    let schemes = |zone: &SchemeZone| zone.schemes.iter().map(|scheme| scheme.name()).collect::<Vec<_>>().join("+");
    let zones: Vec<(&str, String)> = found.zones.iter().map(|zone| (zone.zone.name(), schemes(zone))).collect();
    let of = |zone, schemes: &str| (zone, schemes.to_owned());
    let half = || of("half-open", "semi-finishing");
    assert_eq!(zones, [half(), half(), of("open", "loop"), of("combined", "loop+semi-finishing")]);
}

/// 12.4-12. By hand: the forging has Ø56 up to Z 48 and Ø80 behind it; the second cylinder Ø50 lies under both. t = 7 and 3 in the
/// first section, 15 and 6 in the second; n = 2, 1, 4, 2; means 3.5, 3, 3.75, 3: t_p = 3.75 for both.
#[test]
fn a_stepped_blank_has_a_section_under_each_of_its_diameters() {
    let levels = levels(&example("shaft-forging"));
    let stocks = &levels.cylinders;
    assert_eq!(stocks.iter().map(|one| one.stock).collect::<Vec<_>>(), [mm(7.0), mm(3.0), mm(15.0), mm(6.0)]);
    assert_eq!(levels.depth, mm(3.75));
    let ends: Vec<Half> = stocks.iter().map(|one| one.to).collect();
    assert_eq!(ends, [mm(30.0), mm(48.0), mm(50.0), mm(90.0)]);
    assert_eq!(levels.sections().count(), 2);
}

/// The stock in columns between all Z where anything begins or ends: Z from, Z to, radius now, radius of the part.
struct Stock(Vec<(Half, Half, Half, Half)>);

impl Stock {
    fn of(shaft: &Shaft) -> Self {
        let runs = |steps: &[Step]| {
            let mut z = Half::ZERO;
            let run = |step: &Step| {
                z = z + Half::of(step.length);
                (z, Half::radius_of(step.diameter))
            };
            steps.iter().map(run).collect::<Vec<_>>()
        };
        let (part, mut blank) = (runs(&shaft.steps), runs(&shaft.blank_steps));
        blank.push((mm(1e9), Half::radius_of(shaft.blank.diameter)));
        let end = part.last().unwrap().0;
        let mut cuts: Vec<Half> = part.iter().chain(&blank).map(|(z, _)| *z).filter(|z| *z < end).collect();
        cuts.extend([Half::ZERO, end]);
        cuts.sort_unstable();
        cuts.dedup();
        let at = |runs: &[(Half, Half)], z: Half| runs.iter().find(|(end, _)| z < *end).unwrap().1;
        Self(cuts.windows(2).map(|two| (two[0], two[1], at(&blank, two[0]), at(&part, two[0]))).collect())
    }

    /// The area above the part, in squares of half a micrometre.
    fn area(&self) -> i128 {
        let of = |column: &(Half, Half, Half, Half)| {
            i128::from((column.1 - column.0).halves()) * i128::from((column.2 - column.3).halves())
        };
        self.0.iter().map(of).sum()
    }

    /// The largest radius strictly between two Z, or around one where they are equal.
    fn over(&self, a: Half, b: Half) -> Half {
        let (from, to) = (a.min(b), a.max(b));
        let inside = |column: &&(Half, Half, Half, Half)| {
            if from == to { column.0 < from && from < column.1 } else { column.0 < to && from < column.1 }
        };
        self.0.iter().filter(inside).map(|column| column.2).max().unwrap_or(Half::ZERO)
    }

    /// Moves the tool: it may go through metal only along the axis at the feed, no deeper than the depth, and never
    /// below the part. Tells the area that is gone.
    fn go(&mut self, from: Point, vertex: &Vertex, depth: Half) -> i128 {
        let to = vertex.at;
        if vertex.motion != Motion::Along {
            let low = from.radius.min(to.radius);
            assert!(low >= self.over(from.z, to.z), "{from:?} -> {vertex:?} through metal");
            return 0;
        }
        assert!(from.radius == to.radius && from.z < to.z, "{vertex:?}");
        let metal = from.z + vertex.air;
        assert!(vertex.air == Half::ZERO || self.over(from.z, metal) <= to.radius, "{vertex:?}: δ is in metal");
        let mut gone = 0;
        for column in self.0.iter_mut().filter(|column| metal <= column.0 && column.1 <= to.z) {
            assert!(to.radius >= column.3, "below the part: {vertex:?}");
            assert!(to.radius <= column.2, "through air: {vertex:?}");
            assert!(column.2 - to.radius <= depth, "too deep: {vertex:?}");
            gone += i128::from((column.2 - to.radius).halves()) * i128::from((column.1 - column.0).halves());
            column.2 = to.radius;
        }
        gone
    }
}

/// Every scheme takes all the stock and nothing else, no pass deeper than t_p and t_p not above the limit.
fn carry_out(workpiece: &Workpiece) {
    let (levels, shaft) = (levels(workpiece), workpiece.shaft.as_ref().unwrap());
    assert!(levels.depth <= levels.limit, "{:?}", levels.depth);
    for &(_, scheme) in Scheme::NAMES {
        let mut stock = Stock::of(shaft);
        let all = stock.area();
        let path = path(scheme, &levels);
        let gone: i128 = path.iter().zip(path.iter().skip(1)).map(|(a, b)| stock.go(a.at, b, levels.depth)).sum();
        assert_eq!((gone, stock.area()), (all, 0), "{scheme:?} leaves stock");
        assert!(path.len() == 1 || path.first().unwrap().at == path.last().unwrap().at, "{scheme:?} comes not home");
    }
}

/// Shafts whose blank is stepped too: cut anywhere, and everywhere as large as the part or larger.
fn forgings() -> impl Strategy<Value = Shaft> {
    (shafts(60), prop::collection::vec((0.05_f64..1.0, 0_i64..12_000), 1..4)).prop_map(|(mut shaft, pieces)| {
        let end: i64 = shaft.steps.iter().map(|step| step.length.micrometres()).sum();
        let (mut z, mut largest) = (0, Micrometres::ZERO);
        for (share, over) in pieces {
            let length = ((end - z) as f64 * share) as i64;
            if length == 0 {
                continue;
            }
            z += length;
            let mut at = 0;
            let part = shaft.steps.iter().take_while(|step| {
                let before = at;
                at += step.length.micrometres();
                before < z
            });
            let part = part.map(|step| step.diameter).max().unwrap();
            largest = largest.max(part + Micrometres::new(over));
            shaft.blank_steps.push(Step { diameter: largest, length: Micrometres::new(length) });
        }
        shaft.blank.kind = StockKind::Forging;
        shaft.blank.diameter = shaft.blank.diameter.max(largest);
        shaft
    })
}

fn turn(args: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    let output =
        command.current_dir(env!("CARGO_MANIFEST_DIR")).env_remove("LANG").arg("turn").args(args).output().unwrap();
    // 1: nothing holds some of these shafts.
    assert!(matches!(output.status.code(), Some(0 | 1)), "{args:?}");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{args:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The sections about levels and schemes; the others stand in tests/suites/turning/passes.rs.
fn sections(args: &[&str]) -> String {
    let page = turn(args);
    page[page.find("\n4. ").unwrap()..].to_owned()
}

#[test]
fn the_sections_of_the_page() {
    insta::assert_snapshot!("turn_three_uk", sections(&["examples/shaft-three-cylinders.yaml", "--lang", "uk"]));
    insta::assert_snapshot!("turn_three_en", sections(&["examples/shaft-three-cylinders.yaml", "--lang", "en"]));
    insta::assert_snapshot!("turn_forging_en", sections(&["examples/shaft-forging.yaml", "--lang", "en"]));
}

/// The keys that docs/turning-lecture.md names, the points with both coordinates, and a finding for each rate that is ours
/// alone: of the rapids a lathe of the tables has the same.
#[test]
fn json_has_schemes_with_their_points() {
    let answer = turn(&["examples/shaft-three-cylinders.yaml", "--format", "json"]);
    let answer: serde_json::Value = serde_json::from_str(&answer).unwrap();
    let schemes = answer["schemes"].as_array().unwrap();
    let names: Vec<&str> = schemes.iter().map(|scheme| scheme["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["verticals", "levels", "horizontals-a", "horizontals-b"]);
    for scheme in schemes {
        assert!(["cutting_mm", "idle_mm", "time_min"].iter().all(|key| scheme[key].as_f64().unwrap() > 0.0));
        assert_eq!(scheme["because"]["table"], "removal-scheme");
        let second = &scheme["points"][1];
        assert_eq!((&second["name"], &second["diameter_mm"], &second["z_mm"]), (&"4".into(), &72.4.into(), &2.into()));
    }
    assert_eq!(answer["splitting"]["depth_mm"], 3.8);
    let unconfirmed = answer["findings"].as_array().unwrap().iter().filter(|one| one["code"] == "unconfirmed").count();
    assert_eq!(unconfirmed, 2);
}

/// A solid line for each motion at the feed and a dashed one for each rapid, in every panel, and two in the legend.
#[test]
fn the_drawing_has_every_motion_of_every_scheme() {
    let drawing = turn(&["examples/shaft-forging.yaml", "--format", "svg"]);
    let found = schemes("shaft-forging").unwrap();
    let motions = found.schemes.iter().flat_map(|scheme| scheme.points.iter().map(|point| &point.vertex).skip(1));
    let (rapids, feeds): (Vec<&Vertex>, Vec<&Vertex>) = motions.partition(|vertex| vertex.motion == Motion::Rapid);
    assert_eq!(drawing.matches("stroke=\"#cc79a7\" stroke-width=\"0.9\"").count(), rapids.len() + 1);
    assert_eq!(drawing.matches("stroke=\"#009e73\" stroke-width=\"1.3\"").count(), feeds.len() + 1);
}

#[test]
fn a_shaft_as_large_as_its_blank_has_no_schemes() {
    let shaft = shaft(40_000, &[(40_000, 10_000)], 4_000, 4_000, Division::Full);
    let found = find(&workpiece(&shaft), &shaft, &KNOWLEDGE).unwrap();
    assert!(found.schemes.is_empty() && found.findings.is_empty());
}

#[test]
fn the_examples_are_cleared_by_every_scheme() {
    for name in ["shaft-three-cylinders", "shaft-forging", "shaft", "shaft-six-steps"] {
        carry_out(&example(name));
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(300))]

    #[test]
    fn every_scheme_takes_all_the_stock_and_nothing_else(shaft in shafts(80), longer in 0_i64..3) {
        let mut shaft = shaft;
        shaft.blank.length = shaft.blank.length + Micrometres::from_mm(longer);
        carry_out(&workpiece(&shaft));
    }

    #[test]
    fn every_scheme_clears_stepped_blanks_too(shaft in forgings()) {
        carry_out(&workpiece(&shaft));
    }
}
