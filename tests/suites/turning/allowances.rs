//! Lecture 12.2 on allowances: each statement that docs/turning-lecture.md numbers is held by a test that cites its number.

use technolog::turning::allowances::{
    Errors, LatheAccuracy, Method, Place, areas, between, elsewhere, equidistant, finishing, least,
};
use technolog::turning::contour::{Contour, Piece, Profile, Side, Surface, SurfaceKind};
use technolog::turning::length::Half;
use technolog::turning::operation::plan;
use technolog::turning::point::Point;
use technolog::turning::workpiece::read_turned;
use technolog::units::{ItGrade, Micrometres, Roughness};
use technolog_testing::KNOWLEDGE;

fn at(radius: f64, z: f64) -> Point {
    Point::new(Half::from(radius), Half::from(z))
}

fn mm(length: i64) -> Micrometres {
    Micrometres::from_mm(length)
}

/// A surface of one line.
fn surface(name: &str, kind: SurfaceKind, from: Point, to: Point) -> Surface {
    let pieces = vec![Piece::line(from, to)];
    Surface::plain(name.into(), kind, pieces)
}

/// Ø36 × 30 to grade 6 and Ra 1.25 with a relief behind it, a shoulder, Ø50 × 30 to grade 12.
fn shaft() -> Profile {
    let fine = surface("A", SurfaceKind::Cylinder, at(18.0, 0.0), at(18.0, 30.0));
    let relief = [at(18.0, 30.0), at(17.7, 30.0), at(17.7, 33.0), at(18.0, 33.0)];
    let mut groove = surface("relief", SurfaceKind::GrindingRelief, relief[0], relief[3]);
    groove.pieces = Contour::through(Side::Outer, &relief).pieces;
    let coarse = surface("C", SurfaceKind::Cylinder, at(25.0, 33.0), at(25.0, 63.0));
    Profile {
        side: Side::Outer,
        surfaces: vec![
            surface("front", SurfaceKind::Face, at(0.0, 0.0), at(18.0, 0.0)),
            Surface { grade: ItGrade::new(6), roughness: Some("Ra 1.25".parse().unwrap()), ..fine },
            groove,
            surface("shoulder", SurfaceKind::Face, at(18.0, 33.0), at(25.0, 33.0)),
            Surface { grade: ItGrade::new(12), ..coarse },
        ],
    }
}

fn holds() -> LatheAccuracy {
    let [outer, inner, face] = [8, 9, 11].map(|grade| ItGrade::new(grade).unwrap());
    LatheAccuracy { outer, inner, face, finest: "Ra 1.25".parse::<Roughness>().unwrap() }
}

/// 12.2-1: accuracy and roughness are compared with the passport of the lathe.
#[test]
fn what_the_lathe_cannot_finish_is_found() {
    let found = |holds: &LatheAccuracy| {
        let (found, _) = elsewhere(&shaft(), Some(holds), "steel", mm(63), &KNOWLEDGE).unwrap();
        found.iter().map(|one| (one.surface.clone(), one.operation.name())).collect::<Vec<_>>()
    };
    let ground = [("A".into(), "outer-grinding")];
    assert_eq!(found(&holds()), ground);
    let better = ItGrade::new(6).unwrap();
    assert_eq!(found(&LatheAccuracy { outer: better, ..holds() }), []);
    // The grade is held, the roughness is not.
    assert_eq!(found(&LatheAccuracy { outer: better, finest: "Ra 2.5".parse().unwrap(), ..holds() }), ground);
    // Without a lathe nothing is decided, and that is said.
    let (nothing, findings) = elsewhere(&shaft(), None, "steel", mm(63), &KNOWLEDGE).unwrap();
    assert_eq!(nothing, []);
    assert_eq!(findings[0].note.code(), "no-lathe-to-compare");
}

/// 12.2-2: an intermediate allowance for what is finished elsewhere.
#[test]
fn what_is_finished_elsewhere_gets_an_intermediate_allowance() {
    let (found, findings) = elsewhere(&shaft(), Some(&holds()), "steel", mm(63), &KNOWLEDGE).unwrap();
    // ОСТ 1.41512-86, above 30 up to 50 mm: 0.4 on the diameter.
    assert_eq!(found[0].allowance_mm, Half::from(0.2));
    let codes: Vec<&str> = findings.iter().map(|finding| finding.note.code()).collect();
    assert_eq!(codes, ["no-grade-to-compare", "no-grade-to-compare"]);
}

/// 12.2-2: new elements instead of the primary ones, in the contour that the lathe leaves: the same shaft from its
/// file.
#[test]
fn new_elements_replace_those_finished_elsewhere() {
    let text = "shaft: S\nmaterial: steel-45\nmachine: 16k20f3\n\
        blank: {kind: bar, diameter: 56, length: 100, face: 2}\n\
        outer: [{from: {d: 0, z: 0}}, {face: 36}, {cylinder: -30, grade: h6, roughness: Ra 1.25}, \
        {groove: rectangular, width: 3, depth: 0.3}, {face: 50}, {cylinder: -63, grade: h12}]\n\
        roughing: {limiting_depth: 3}\n";
    let workpiece = read_turned("shaft", text, &KNOWLEDGE).unwrap();
    let operation = plan(&workpiece, &KNOWLEDGE).unwrap();
    assert_eq!(operation.elsewhere[0].allowance_mm, Half::from(0.2));
    let layers = &operation.set_ups[0].sides[0].layers;
    // Its neighbours reach up to it, over the bridged groove too; the rest is as it was.
    // At its end the tool runs on by the approach of 2 mm.
    let left = [(0.0, 0.0), (18.2, 0.0), (18.2, 33.0), (25.0, 33.0), (25.0, 65.0)];
    let left: Vec<Point> = left.into_iter().map(|(radius, z)| at(radius, z)).collect();
    assert_eq!(layers.left, Contour::through(Side::Outer, &left));
    // The finishing allowance of the table, 1.0 on the diameter, comes over the new element.
    assert_eq!(layers.rough.radii_at(Half::from(15.0)).unwrap().1, Half::from(18.2 + 0.5));
}

/// 12.2-3: the statistical method is a table by size; what it lacks is said.
#[test]
fn the_table_gives_allowances_by_diameter_and_length() {
    let (found, findings) = finishing(&shaft(), Method::Table, mm(63), &KNOWLEDGE).unwrap();
    let sides: Vec<Option<Half>> = found.iter().map(|allowance| allowance.allowance_mm).collect();
    // Faces (50..120] long: 0.7 up to Ø50; cylinders Ø(30..50] up to 100: 1.0 on the diameter; the relief is bridged.
    assert_eq!(sides, [Some(0.7), Some(0.5), None, Some(0.7), Some(0.5)].map(|side| side.map(Half::from)));
    assert!(findings.iter().all(|finding| finding.note.code() == "unconfirmed"));
    let (found, findings) = finishing(&shaft(), Method::Table, mm(1300), &KNOWLEDGE).unwrap();
    assert!(found.iter().all(|allowance| allowance.allowance_mm.is_none()));
    assert_eq!(findings.iter().filter(|finding| finding.note.code() == "no-finishing-allowance").count(), 4);
    // What a surface states goes before.
    let mut stated = shaft();
    stated.surfaces[1].stated_allowance = Some(Half::from(0.3));
    let method = Method::Stated { on_diameter: None, on_face: Some(mm(1)) };
    let (found, findings) = finishing(&stated, method, mm(63), &KNOWLEDGE).unwrap();
    assert_eq!((found[0].allowance_mm, found[1].allowance_mm), (Some(Half::from(1.0)), Some(Half::from(0.3))));
    assert_eq!(findings.len(), 1, "C states nothing");
}

/// 12.2-4: the analytic method adds up errors.
#[test]
fn the_analytic_method_covers_the_errors_of_the_pass_before() {
    let um = |micrometres: f64| Half::from(micrometres / 1000.0);
    // A published course project (shaft, second pass): Rz 50, h 50, ρ 7.5, ε 0: 2·107.5 = 215 µm on the diameter.
    assert_eq!(least(Place::Outer, um(50.0), um(50.0), um(7.5), um(0.0)), um(107.5));
    // 3-4-5 by hand: √(30² + 40²) = 50, and 30 + 40 = 70 on a face.
    assert_eq!(least(Place::Inner, um(60.0), um(40.0), um(30.0), um(40.0)), um(150.0));
    assert_eq!(least(Place::Face, um(60.0), um(40.0), um(30.0), um(40.0)), um(170.0));
    // √2 µm is rounded up to 1.5.
    assert_eq!(least(Place::Outer, um(0.0), um(0.0), um(1.0), um(1.0)), um(1.5));
    let errors = Errors { roughness_height: None, damaged_layer: None, deviation: um(7.5), setting: um(0.0) };
    let (found, findings) = finishing(&shaft(), Method::Analytic(errors), mm(63), &KNOWLEDGE).unwrap();
    assert_eq!(found[1].allowance_mm, Some(um(107.5)), "Rz and T of the table");
    assert_eq!(findings.len(), 1, "the table's row is not confirmed, and told once");
    let known = Errors { roughness_height: Some(um(20.0)), damaged_layer: Some(um(30.0)), ..errors };
    let (found, findings) = finishing(&shaft(), Method::Analytic(known), mm(63), &KNOWLEDGE).unwrap();
    assert_eq!((found[1].allowance_mm, findings.len()), (Some(um(57.5)), 0));
}

/// 12.2-5: the rough contour is equidistant to each main element at its own allowance. Its laws: tests/suites/turning/equidistant.rs.
/// 12.2-6, 12.2-7, 12.2-8: the areas 1, 2 and 3, which together are all that is turned off.
#[test]
fn the_allowance_is_split_by_the_rough_contour() {
    let main =
        Contour::through(Side::Outer, &[at(0.0, 0.0), at(18.0, 0.0), at(18.0, 33.0), at(25.0, 33.0), at(25.0, 63.0)]);
    let rough = equidistant(&main, &[0.7, 0.5, 0.7, 0.5].map(Half::from)).unwrap();
    assert_eq!(rough.corners(), [at(0.0, -0.7), at(18.5, -0.7), at(18.5, 32.3), at(25.5, 32.3), at(25.5, 63.0)]);
    let blank = Contour::through(Side::Outer, &[at(0.0, -2.0), at(30.0, -2.0), at(30.0, 63.0)]);
    let part = shaft().contour();
    let found = areas(&blank, &rough, &main, &part);
    // By hand, rectangles: 1 and 3 along the cylinders and before the faces, 2 the relief of 3 × 0.3.
    let close = |is: f64, must: f64| assert!((is - must).abs() < 1e-6, "{is}, not {must}");
    close(found.rough_main.area_mm2.0, 30.0 * 65.0 - 18.5 * 33.0 - 25.5 * 30.7);
    close(found.additional.area_mm2.0, 0.9);
    close(found.finish.area_mm2.0, 18.5 * 33.0 + 25.5 * 30.7 - 18.0 * 33.0 - 25.0 * 30.0);
    close(found.additional.volume_mm3.0, std::f64::consts::PI * (18.0 * 18.0 - 17.7 * 17.7) * 3.0);
    let whole = between(&blank, &part);
    let parts = [&found.rough_main, &found.additional, &found.finish].map(|area| area.volume_mm3.0);
    close(parts.iter().sum::<f64>(), whole.volume_mm3.0);
}
