//! Contours by points, by tables of points and by polylines of drawings.

use technolog::turning::contour::{Curve, Profile, Turn};
use technolog::turning::shaft::Mistake;
use technolog::turning::workpiece::{Drawings, Workpiece, files_named, read_turned_with};
use technolog_testing::KNOWLEDGE;

const HEAD: &str =
    "shaft: P\nmaterial: steel-45\nblank: {kind: bar, diameter: 45, length: 115, face: 1.5}\nmachine: 16k20f3\n";

fn read(text: &str, files: &[(&str, &str)]) -> Result<Workpiece, Vec<String>> {
    let mut drawings = Drawings::default();
    for (name, text) in files {
        drawings.add(name, Ok((*text).to_owned()));
    }
    read_turned_with("part.yaml", text, &drawings, &KNOWLEDGE).map_err(|mistakes| {
        let place = |one: &Mistake| one.place().map(ToString::to_string).unwrap_or_default();
        mistakes.iter().map(|one| format!("{} {}", one.code(), place(one))).collect()
    })
}

fn example(name: &str) -> String {
    std::fs::read_to_string(format!("{}/examples/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The end of a piece, half micrometres of the radius and Z, and the radius and the sense of its arc.
type Seen = (i64, i64, Option<(i64, bool)>);

/// Corners and arcs of a contour.
fn seen(profile: &Profile) -> Vec<Seen> {
    let pieces = profile.contour().pieces;
    let of = |curve| match curve {
        Curve::Line => None,
        Curve::Arc { radius, turn } => Some((radius.halves(), turn == Turn::Right)),
    };
    pieces.iter().map(|piece| (piece.to.radius.halves(), piece.to.z.halves(), of(piece.curve))).collect()
}

/// The pin item by item: the others must be the same, to half a micrometre.
const ITEMS: &str = "outer:
  - {from: {d: 0, z: 0}}
  - {face: 20}
  - {arc: {d: 26, z: -3}, radius: 3, bulge: out}
  - {cylinder: -25, name: A, grade: h9, roughness: Ra 3.2}
  - {cone: {d: 40, z: -60}}
  - {cylinder: -80}
";

#[test]
fn one_contour_is_written_in_four_ways() {
    let items = read(&format!("{HEAD}{ITEMS}"), &[]).unwrap();
    let (table, drawing) = (example("turned-points.csv"), example("turned-drawing.dxf"));
    let by_table = read(&example("turned-points.yaml"), &[("turned-points.csv", &table)]).unwrap();
    assert_eq!(by_table.outer, items.outer);
    let by_drawing = read(&example("turned-drawing.yaml"), &[("turned-drawing.dxf", &drawing)]).unwrap();
    assert_eq!(seen(&by_drawing.outer), seen(&items.outer));
    let straight = "outer: {points: [[0, 0], [20, 0], [20, -25], [40, -60], [40, -80]]}\n";
    let by_points = read(&format!("{HEAD}{straight}"), &[]).unwrap();
    let corners: Vec<_> = seen(&by_points.outer).iter().map(|one| (one.0, one.1)).collect();
    assert_eq!(corners, [(20_000, 0), (20_000, 50_000), (40_000, 120_000), (40_000, 160_000)]);
    assert_eq!(files_named("part.yaml", &example("turned-drawing.yaml")), ["turned-drawing.dxf"]);
}

/// A spreadsheet of this country parts cells by semicolons and decimals by commas; radii are half of diameters.
#[test]
fn tables_come_with_semicolons_and_radii() {
    let text = format!("{HEAD}outer: {{points: t.csv}}\n");
    let comma = read(&text, &[("t.csv", "d,z\n0,0\n20.5,0\n20.5,-80\n")]).unwrap();
    let semicolon = read(&text, &[("t.csv", "\u{feff}r;z\n0;0\n10,25;0\n10,25;-80\n\n")]).unwrap();
    assert_eq!(comma.outer, semicolon.outer);
}

/// The outside is drawn from the chuck to the free end, too. The bore has a fillet of 2 before its bottom: a quarter of a circle about
/// X -18 Y 8 from its top at Y 10 to its left at X -20, which is counterclockwise, with the bulge tan(90°/4).
#[test]
fn polylines_are_turned_the_right_way() {
    let polyline = |layer: &str, points: &[(f64, f64, f64)]| {
        let vertices: String = points.iter().map(|(x, y, bulge)| format!("10\n{x}\n20\n{y}\n42\n{bulge}\n")).collect();
        format!("0\nLWPOLYLINE\n8\n{layer}\n70\n0\n{vertices}")
    };
    let b = (std::f64::consts::PI / 8.0).tan();
    let outer = [(0.0, 10.0, 0.0), (0.0, 20.0, 0.0), (-80.0, 20.0, 0.0)];
    let back: Vec<_> = outer.iter().rev().copied().collect();
    let inner = [(0.0, 10.0, 0.0), (-18.0, 10.0, b), (-20.0, 8.0, 0.0), (-20.0, 0.0, 0.0)];
    let text = format!("{HEAD}outer: {{dxf: d.dxf, layer: O}}\ninner: {{dxf: d.dxf, layer: I}}\n");
    let of = |outer: &[_]| {
        let file =
            format!("0\nSECTION\n2\nENTITIES\n{}{}0\nENDSEC\n0\nEOF\n", polyline("O", outer), polyline("I", &inner));
        read(&text, &[("d.dxf", &file)]).unwrap()
    };
    let (one, other) = (of(&outer), of(&back));
    assert_eq!(seen(&one.outer), seen(&other.outer));
    let written = "outer:\n  - {from: {d: 20, z: 0}}\n  - {face: 40}\n  - {cylinder: -80}\ninner:\n  - {from: {d: 20, z: 0}}\n  - {cylinder: -18}\n  - {arc: {d: 16, z: -20}, radius: 2, bulge: in}\n  - {face: 0}\n";
    let written = read(&format!("{HEAD}{written}"), &[]).unwrap();
    assert_eq!(seen(one.inner.as_ref().unwrap()), seen(written.inner.as_ref().unwrap()));
}

#[test]
fn mistakes_of_points_have_a_place_in_their_own_file() {
    let table = |csv: &str| read(&format!("{HEAD}outer: {{points: t.csv}}\n"), &[("t.csv", csv)]).unwrap_err();
    assert_eq!(table("d,z\n0,0\n20,0\n20,-1,5\n"), ["points-row-length t.csv:4:1"]);
    assert_eq!(table("d;y\n0;0\n"), ["points-column-unknown t.csv:1:3"]);
    assert_eq!(table("d,x,z\n0,0,0\n"), ["points-column-twice t.csv:1:3"]);
    assert_eq!(table("z\n0\n"), ["points-columns-lack t.csv:1:1"]);
    assert_eq!(table("d,z\n0,0\n20,0\n20,minus\n"), ["bad-value t.csv:4:4"]);
    assert_eq!(table("d,z,radius\n0,0,\n20,0,5\n"), ["points-arc-half t.csv:3:6"]);
    assert_eq!(table("d,z,radius,bulge\n0,0,5,out\n20,0,,\n20,-80,,\n"), ["points-first-of-nothing t.csv:2:5"]);
    assert_eq!(table("d,z,grade\n0,0,h6\n20,0,\n20,-80,h6\n"), ["points-first-of-nothing t.csv:2:5"]);
    assert_eq!(table("d,z\n0,0\n20,0\n20,-30\n25,-20\n"), ["runs-back t.csv:5:1"]);
    assert_eq!(table(""), ["points-empty part.yaml:5:17"]);
    let drawing =
        |dxf: &str, more: &str| read(&format!("{HEAD}outer: {{dxf: d.dxf{more}}}\n"), &[("d.dxf", dxf)]).unwrap_err();
    let one = "0\nLWPOLYLINE\n8\nA\n70\n0\n10\n0\n20\n0\n10\n0\n20\n9\n10\n-80\n20\n9\n";
    assert_eq!(drawing(&format!("{one}{one}"), ""), ["dxf-many-polylines part.yaml:5:14"]);
    let round = "0\nLWPOLYLINE\n8\nA\n70\n0\n10\n0\n20\n0\n10\n0\n20\n9\n42\n1.5\n10\n-80\n20\n9\n";
    assert_eq!(drawing(round, ""), ["dxf-arc-over-half d.dxf:18:1"]);
    assert_eq!(drawing(one, ", layer: B"), ["dxf-no-polyline part.yaml:5:14"]);
    assert_eq!(drawing(&one.replace("70\n0", "70\n1"), ""), ["dxf-closed part.yaml:5:14"]);
    assert_eq!(drawing("0\nSECTION\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n", ""), ["dxf-other-units part.yaml:5:14"]);
    assert_eq!(drawing("hello\n", ""), ["dxf-not-read d.dxf:1:1"]);
    assert_eq!(drawing(one, ", zero: [1]"), ["dxf-zero-not-two part.yaml:5:27"]);
    let nobody = read(&format!("{HEAD}outer: {{points: t.csv}}\n"), &[]).unwrap_err();
    assert_eq!(nobody, ["contour-file-not-given part.yaml:5:17"]);
}
