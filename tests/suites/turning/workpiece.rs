//! The contour form of the shaft file: what lecture 12.1 states, each test with the number of its statement
//! (docs/turning-lecture.md), the examples, and the laws of the reader.

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use technolog::note::Severity;
use technolog::report::Lang;
use technolog::turning::contour::{Curve, Piece, Side, SurfaceKind, SurfaceName, Turn};
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::turning::workpiece::{Allowances, HeatTreatment, JawKind, Workpiece, blank, read_turned};
use technolog::units::Micrometres;
use technolog_testing::{KNOWLEDGE, shafts};

fn text(example: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{example}.yaml"))).unwrap()
}

fn read(text: &str) -> Workpiece {
    read_turned("part", text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{mistakes:?}"))
}

fn example(name: &str) -> Workpiece {
    read(&text(name))
}

fn at(diameter: f64, z: f64) -> Point {
    Point { radius: Half::from(diameter / 2.0), z: Half::from(-z) }
}

/// A workpiece surface by surface: diameters, and Z as files write it.
fn listed(workpiece: &Workpiece) -> String {
    let shown = |point: Point| format!("{},{}", point.radius.diameter(), Half::ZERO - point.z);
    let piece = |piece: &Piece| match piece.curve {
        Curve::Line => format!(" - {}", shown(piece.to)),
        Curve::Arc { radius, turn } => format!(" R{radius} {turn:?} {}", shown(piece.to)),
    };
    let pieces = |pieces: &[Piece]| -> String {
        pieces.first().map(|first| shown(first.from)).into_iter().chain(pieces.iter().map(piece)).collect()
    };
    let mut lines = vec![format!("blank {}: {}", workpiece.blank.kind.name(), pieces(&workpiece.blank.outer.pieces))];
    lines.extend(workpiece.blank.inner.iter().map(|inner| format!("its bore: {}", pieces(&inner.pieces))));
    for surface in std::iter::once(&workpiece.outer).chain(&workpiece.inner).flat_map(|profile| &profile.surfaces) {
        lines.push(format!("{} ({}): {}", surface.name, surface.kind.name(), pieces(&surface.pieces)));
    }
    for advice in blank::advice(workpiece, &KNOWLEDGE).unwrap() {
        lines.push(format!("{:?}: {}", advice.finding.severity, Lang::UK.say(&advice.finding.note)));
    }
    let mut rest = workpiece.clone();
    rest.outer.surfaces.clear();
    rest.inner = None;
    rest.blank.inner = None;
    rest.blank.outer.pieces.clear();
    lines.push(serde_json::to_string_pretty(&rest).unwrap());
    lines.join("\n")
}

#[test]
fn the_examples_read() {
    for name in ["turned-pin", "turned-ball", "turned-bushing", "turned-forging"] {
        let workpiece = example(name);
        assert!(workpiece.outer.contour().hangs_together(), "{name}");
        insta::assert_snapshot!(name.replace('-', "_"), listed(&workpiece));
    }
}

/// 12.1-1: Z is the axis of rotation, X lies in a face.
/// A material in a state, as in files of plates: hardness and strength as said, of either form of the file.
#[test]
fn a_material_may_be_in_a_state() {
    let of = |material: &str| text("turned-pin").replace("material: steel-45", &format!("material: {material}"));
    let state = read(&of("{grade: steel-45, hardness: 250}")).material_state.unwrap();
    assert_eq!((state.hardness, state.strength), (Some(250.0), None));
    assert_eq!(read(&of("steel-45")).material_state, None);
    for wrong in ["{grade: steel-45}", "{grade: steel-45, hardness: 2500}", "{hardness: 250}"] {
        assert!(read_turned("part", &of(wrong), &KNOWLEDGE).is_err(), "{wrong}");
    }
    let stepped = text("shaft").replace("material: ", "material: {grade: ");
    let stepped: Vec<String> = stepped
        .lines()
        .map(|line| if line.starts_with("material: ") { format!("{line}, strength: 900}}") } else { line.to_owned() })
        .collect();
    assert_eq!(read(&stepped.join("\n")).material_state.unwrap().strength, Some(900.0));
}

#[test]
fn statement_12_1_1_the_origin_lies_on_the_axis_in_the_finished_face() {
    let ball = example("turned-ball");
    assert_eq!(ball.outer.contour().start(), Some(at(0.0, 0.0)));
    assert_eq!(ball.outer.contour().end(), Some(at(40.0, -95.0)), "towards the chuck Z is negative in files");
    assert_eq!(ball.length(), Half::from(95.0));
    let moved = text("turned-ball").replace("{from: {d: 0, z: 0}}", "{from: {d: 0, z: -1}}");
    let mistakes = read_turned("part", &moved, &KNOWLEDGE).unwrap_err();
    assert_eq!(mistakes[0].code(), "does-not-begin-at-zero");
}

/// 12.1-2: generators are straight lines and circles.
#[test]
fn statement_12_1_2_contours_are_lines_and_arcs() {
    let ball = example("turned-ball");
    let pieces = ball.outer.contour().pieces;
    let arc = |from, to, radius, turn| Piece::arc(from, to, Half::from(radius), turn);
    assert_eq!(pieces[0], arc(at(0.0, 0.0), at(24.0, -36.0), 20.0, Turn::Right));
    // The centre of the ball of 40 lies 20 behind its pole: 16-12-20.
    assert_eq!(Point::at(pieces[0].centre().unwrap()), at(0.0, -20.0));
    assert_eq!(pieces[1], arc(at(24.0, -36.0), at(18.0, -45.0), 15.0, Turn::Left));
    assert_eq!(pieces[2], Piece::line(at(18.0, -45.0), at(30.0, -70.0)));
    assert_eq!(ball.largest_diameter().to_string(), "40");
}

/// 12.1-3: all surfaces of fig. 12.1, main ones (1 to 6) and additional ones (7 to 13), can be written.
#[test]
fn statement_12_1_3_every_surface_of_the_figure_can_be_written() {
    use SurfaceKind as K;
    let pin = example("turned-pin");
    let kinds = |surfaces: &[technolog::turning::contour::Surface]| -> Vec<K> {
        surfaces.iter().map(|surface| surface.kind).collect()
    };
    let outer = kinds(&pin.outer.surfaces);
    let inner = kinds(&pin.inner.as_ref().unwrap().surfaces);
    for (number, kind, on) in [
        (1, K::Face, &outer),
        (2, K::Ball, &outer),
        (3, K::Cylinder, &outer),
        (4, K::Cone, &outer),
        (5, K::Chamfer, &outer),
        (6, K::Cylinder, &inner),
        (7, K::ThreadRelief, &outer),
        (8, K::Thread, &outer),
        (9, K::TrapezoidGroove, &inner),
        (10, K::GrindingRelief, &outer),
        (11, K::RectangularGroove, &inner),
        (12, K::FaceGroove, &outer),
        (13, K::PulleyGroove, &outer),
    ] {
        assert!(on.contains(&kind), "{number}: {kind:?}");
    }
}

/// What the drawing says of a surface arrives, and sizes that the file leaves out come from tables.
#[test]
fn surfaces_carry_what_the_drawing_says() {
    let pin = example("turned-pin");
    let neck = pin.outer.surfaces.iter().find(|surface| surface.name == "neck".into()).unwrap();
    assert_eq!(neck.grade.unwrap().number(), 6);
    assert_eq!(neck.roughness.unwrap().to_string(), "Ra 1.25");
    assert_eq!(neck.stated_allowance, Some(Half::from(0.3)));
    assert_eq!(pin.outer.surfaces[0].name, SurfaceName::Place(Side::Outer, 1));
    let thread = &pin.threads[0];
    assert_eq!((thread.written.as_str(), &*thread.surface.to_string()), ("M36x2-6g", "outer 3"));
    assert_eq!((thread.size.to_string(), thread.pitch.to_string()), ("36".to_owned(), "2".to_owned()));
    // GOST 10549-80 for the pitch 2: 5 wide, 3 off the diameter; 45° on the side of the thread.
    let relief = &pin.outer.surfaces[3];
    let corners: Vec<Point> = relief.pieces.iter().map(|piece| piece.to).collect();
    assert_eq!(corners, [at(33.0, -23.5), at(33.0, -27.0), at(36.0, -27.0)]);
    // The row of that pitch is confirmed, so nothing is to be said of it.
    assert_eq!(pin.findings, []);
}

/// A bore counts its metal outwards: what is hollow bends the other way, grooves go outwards.
#[test]
fn a_bore_is_mirrored() {
    let pin = example("turned-pin");
    let bore = pin.inner.unwrap();
    assert_eq!(bore.side, Side::Inner);
    let groove = bore.surfaces.iter().find(|surface| surface.kind == SurfaceKind::RectangularGroove).unwrap();
    let radii = groove.pieces.iter().map(|piece| piece.to.radius.diameter().to_string()).collect::<Vec<_>>();
    assert_eq!(radii, ["23", "23", "20"]);
    let text = "shaft: a\nmaterial: steel-45\nblank: {kind: tube, diameter: 60, bore: 10, length: 40}\n\
        outer: [{from: {d: 20, z: 0}}, {face: 60}, {cylinder: -40}]\n\
        inner: [{from: {d: 20, z: 0}}, {arc: {d: 12, z: -4}, radius: 4, bulge: in}, {cylinder: -40}]\n";
    let hollow = read(text).inner.unwrap().contour().pieces[0];
    assert!(matches!(hollow.curve, Curve::Arc { turn: Turn::Right, .. }));
    // Hollow: its centre lies in the bore.
    assert_eq!(Point::at(hollow.centre().unwrap()), at(12.0, 0.0));
}

fn advised(workpiece: &Workpiece) -> Vec<(Severity, String)> {
    let advice = blank::advice(workpiece, &KNOWLEDGE).unwrap();
    assert!(advice.iter().all(|one| one.because.row.is_some() && one.because.place.starts_with("lecture 12.1")));
    advice.into_iter().map(|one| (one.finding.severity, one.finding.note.code().to_owned())).collect()
}

fn pin(blank: &str, more: &str) -> Workpiece {
    read(&format!(
        "shaft: a\nmaterial: steel-45\nblank: {blank}\n{more}\nouter: [{{from: {{d: 0, z: 0}}}}, {{face: 20}}, {{cylinder: -30}}]\n"
    ))
}

/// 12.1-5 and 12.1-6: from Ø50 on one part to a blank, below it one blank may serve for several.
#[test]
fn statements_12_1_5_and_12_1_6_how_many_parts_a_blank_is_for() {
    for (diameter, code) in [("50", "blank-for-one-part"), ("49.999", "blank-for-several-parts")] {
        let workpiece = pin(&format!("{{kind: bar, diameter: {diameter}, length: 40}}"), "");
        assert!(advised(&workpiece).contains(&(Severity::Note, code.to_owned())), "{diameter}");
    }
}

/// 12.1-7: between centres a blank is centred at both ends and one face is cut; in a chuck nothing is said of it.
#[test]
fn statement_12_1_7_blanks_between_centres() {
    let bar = "{kind: bar, diameter: 30, length: 40}";
    let advice = advised(&pin(bar, "holding: centres"));
    for code in ["blank-centre-both-ends", "blank-cut-one-face"] {
        assert!(advice.contains(&(Severity::Note, code.to_owned())), "{advice:?}");
        assert!(!advised(&pin(bar, "")).iter().any(|(_, other)| other == code));
    }
}

/// 12.1-8: the length may deviate by at most 0.6 mm.
#[test]
fn statement_12_1_8_how_exact_the_length_is() {
    for (given, severity, code) in [
        ("0.6", Severity::Note, "blank-length-deviation"),
        ("0.601", Severity::Wrong, "blank-length-too-coarse"),
        ("0", Severity::Note, "blank-length-deviation"),
    ] {
        let workpiece = pin(&format!("{{kind: bar, diameter: 30, length: 40, length_tolerance: {given}}}"), "");
        assert!(advised(&workpiece).contains(&(severity, code.to_owned())), "{given}");
    }
}

/// 12.1-9: forgings are turned beforehand where they are held; bars are not.
#[test]
fn statement_12_1_9_forgings_are_turned_where_they_are_held() {
    let code = (Severity::Note, "blank-pre-turn-where-held".to_owned());
    assert!(advised(&example("turned-forging")).contains(&code));
    assert!(!advised(&example("turned-pin")).contains(&code));
}

/// 12.1-10: heat treatment comes before the lathe.
#[test]
fn statement_12_1_10_heat_treatment_comes_before() {
    let bar = "{kind: bar, diameter: 30, length: 40}";
    let severities = |heat: &str| -> Vec<Severity> {
        let all = advised(&pin(bar, &format!("heat_treatment: {heat}")));
        all.into_iter().filter(|(_, code)| code == "blank-heat-treat-before").map(|(severity, _)| severity).collect()
    };
    assert_eq!(severities("before"), [Severity::Note]);
    assert_eq!(severities("after"), [Severity::Wrong]);
    assert_eq!(severities("none"), []);
}

/// 12.1-11: the contour of a blank is mostly a rectangle, of castings and forgings shaped: lines and arcs.
#[test]
fn statement_12_1_11_contours_of_blanks() {
    let bar = example("turned-pin").blank;
    assert_eq!(bar.outer.corners(), [at(0.0, 2.0), at(105.0, 2.0), at(105.0, -123.0)]);
    let tube = example("turned-bushing").blank;
    assert_eq!(tube.outer.corners(), [at(45.0, 1.5), at(83.0, 1.5), at(83.0, -88.5)]);
    assert_eq!(tube.inner.unwrap().corners(), [at(45.0, 1.5), at(45.0, -88.5)]);
    let forging = example("turned-forging").blank;
    assert!(forging.outer.pieces.iter().any(|piece| piece.curve != Curve::Line));
    assert_eq!((forging.face(), forging.length()), (Half::ZERO, Half::from(115.0)));
    let stepped =
        pin("{kind: casting, diameter: 40, length: 40, face: 2, steps: [{diameter: 24, length: 20}]}", "").blank;
    assert_eq!(
        stepped.outer.corners(),
        [at(0.0, 2.0), at(24.0, 2.0), at(24.0, -18.0), at(40.0, -18.0), at(40.0, -38.0)]
    );
}

/// A blank without stock over an arc of the part is taken; one that is two micrometres smaller in radius is not.
#[test]
fn a_blank_may_have_the_contour_of_the_part() {
    let items = |d: &str| {
        format!(
            "[{{from: {{d: 0, z: 0}}}}, {{arc: {{d: {d}, z: -20}}, radius: 21, bulge: out}}, {{cylinder: -40}}, \
             {{arc: {{d: 60, z: -50}}, radius: 30, bulge: in}}, {{cylinder: -60}}]"
        )
    };
    let text = |blank: &str| {
        format!(
            "shaft: a\nmaterial: steel-45\nblank: {{kind: casting, outer: {}}}\nouter: {}\n",
            items(blank),
            items("40")
        )
    };
    assert_eq!(read(&text("40")).blank.outer, read(&text("40")).outer.contour());
    let mistakes = read_turned("part", &text("39.996"), &KNOWLEDGE).unwrap_err();
    assert!(mistakes.iter().all(|one| one.code() == "part-beyond-blank"), "{mistakes:?}");
}

/// The short form is a workpiece whose diameters are those after roughing, and keeps its steps for the search of the paper.
#[test]
fn a_stepped_shaft_is_a_workpiece() {
    for name in ["shaft", "shaft-six-steps", "shaft-three-cylinders", "shaft-forging"] {
        let workpiece = example(name);
        let shaft = workpiece.shaft.as_ref().unwrap();
        let contour = workpiece.outer.contour();
        assert!(contour.hangs_together() && contour.is_stepped() && contour.is_monotone());
        let mut z = Half::ZERO;
        for step in &shaft.steps {
            let middle = z + Half::new(Half::of(step.length).halves() / 2);
            let radius = Half::radius_of(step.diameter);
            assert_eq!(contour.radii_at(middle), Some((radius, radius)), "{name}");
            z = z + Half::of(step.length);
        }
        assert_eq!(workpiece.length(), z);
        assert_eq!(workpiece.roughing.limiting_depth, Some(shaft.roughing.longitudinal_depth));
        let zero = technolog::units::Micrometres::ZERO;
        assert_eq!(workpiece.allowances, Allowances::Stated { on_diameter: zero, on_face: zero });
        assert_eq!(workpiece.blank.length(), Half::of(shaft.blank.length));
    }
    let forging = example("shaft-forging");
    assert_eq!(
        forging.blank.outer.corners(),
        [at(0.0, 0.0), at(56.0, 0.0), at(56.0, -48.0), at(80.0, -48.0), at(80.0, -110.0)]
    );
}

/// A stepped shaft is held and treated like any part; what its diameters after roughing leave no room for is an unknown key, as are
/// the limits of roughing of a contour.
#[test]
fn steps_are_a_part_like_any() {
    let text = text("shaft-six-steps");
    let more = format!("{text}jaws: full-grip\nheat_treatment: after\n");
    let workpiece = read(&more);
    assert_eq!((workpiece.jaws, workpiece.heat_treatment), (JawKind::FullGrip, HeatTreatment::After));
    for wrong in ["allowances: {method: table}\n", "inner: [{from: {d: 0, z: 0}}]\n", "outre: []\n"] {
        let mistakes = read_turned("part", &format!("{text}{wrong}"), &KNOWLEDGE).unwrap_err();
        let codes: Vec<&str> = mistakes.iter().map(|one| one.code()).collect();
        assert_eq!(codes, ["unknown-key"], "{wrong}");
    }
    let wrong = text.replace("roughing: {", "roughing: {limiting_depth: 2, ");
    assert_ne!(wrong, text);
    let mistakes = read_turned("part", &wrong, &KNOWLEDGE).unwrap_err();
    assert_eq!(mistakes.iter().map(|one| one.code()).collect::<Vec<_>>(), ["unknown-key"]);
}

/// A well-formed outer contour: its items as they are written, and the pieces that they mean.
#[derive(Clone, Debug)]
struct Written {
    items: Vec<String>,
    pieces: Vec<Piece>,
    grooved: bool,
}

/// The next item after those before, from four numbers: which it is, whether the radius rises, and two sizes in
/// micrometres. `radius` and `z` are where the contour stands, micrometres.
fn next(written: &mut Written, (which, rises, size, length): (u8, bool, i64, i64), place: &mut (i64, i64)) {
    let mm = |um: i64| technolog::units::Micrometres::new(um).to_string();
    let point = |(radius, z): (i64, i64)| Point { radius: Half::new(2 * radius), z: Half::new(2 * z) };
    let to = |(radius, z): (i64, i64)| format!("{{d: {}, z: {}}}", mm(2 * radius), mm(-z));
    let (radius, z) = *place;
    // A contour stays off the axis.
    let rises = rises || radius <= size + 1000;
    let other = if rises { radius + size } else { radius - size };
    let after_cylinder = written.items.last().is_some_and(|item| item.contains("cylinder"));
    let mut line = |written: &mut Written, item: String, end: (i64, i64)| {
        written.pieces.push(Piece::line(point(*place), point(end)));
        written.items.push(item);
        *place = end;
    };
    match which {
        0 if after_cylinder => line(written, format!("{{face: {}}}", mm(2 * other)), (other, z)),
        1 => line(written, format!("{{cone: {}}}", to((other, z + length))), (other, z + length)),
        2 | 3 => {
            // A quarter of a circle.
            let end = (other, z + size);
            let bulge = if which == 2 { "in" } else { "out" };
            let turn = if which == 2 { Turn::Left } else { Turn::Right };
            written.pieces.push(Piece::arc(point(*place), point(end), Half::new(2 * size), turn));
            written.items.push(format!("{{arc: {}, radius: {}, bulge: {bulge}}}", to(end), mm(size)));
            *place = end;
        }
        4 if after_cylinder && radius > 2 * size => {
            let (floor, end) = (radius - size, z + length);
            written.grooved = true;
            written.items.push(format!("{{groove: rectangular, width: {}, depth: {}}}", mm(length), mm(size)));
            let corners = [(radius, z), (floor, z), (floor, end), (radius, end)].map(point);
            written.pieces.extend(corners.windows(2).map(|pair| Piece::line(pair[0], pair[1])));
            *place = (radius, end);
        }
        5 => line(written, format!("{{cylinder: {{length: {}}}}}", mm(length)), (radius, z + length)),
        _ => line(written, format!("{{cylinder: {}}}", mm(-z - length)), (radius, z + length)),
    }
}

fn contours() -> impl Strategy<Value = Written> {
    let item = (0_u8..7, any::<bool>(), 100_i64..20_000, 100_i64..20_000);
    (2_000_i64..30_000, prop::collection::vec(item, 1..12)).prop_map(|(radius, items)| {
        let mut place = (radius, 0);
        let face = Piece::line(Point::default(), Point { radius: Half::new(2 * radius), z: Half::ZERO });
        let from = "{from: {d: 0, z: 0}}".to_owned();
        let face_item = format!("{{face: {}}}", technolog::units::Micrometres::new(2 * radius));
        let mut written = Written { items: vec![from, face_item], pieces: vec![face], grooved: false };
        next(&mut written, (6, true, 1_000, 1_000), &mut place);
        for item in items {
            next(&mut written, item, &mut place);
        }
        written
    })
}

proptest! {
    #![proptest_config(technolog_laws::cases!(150))]

    #[test]
    fn what_is_written_is_what_is_read(written in contours()) {
        let items: String = written.items.iter().map(|item| format!("  - {item}\n")).collect();
        let blank = "blank: {kind: bar, diameter: 1000, length: 1000, face: 1}";
        let workpiece = read(&format!("shaft: a\nmaterial: steel-45\n{blank}\nouter:\n{items}"));
        let contour = workpiece.outer.contour();
        prop_assert_eq!(&contour.pieces, &written.pieces);
        prop_assert!(contour.hangs_together() && (written.grooved || contour.is_monotone()));
        prop_assert_eq!(workpiece.outer.surfaces.len() + 1, written.items.len());
    }

    #[test]
    fn a_bar_that_is_a_micrometre_too_thin_is_told(written in contours(), short in any::<bool>()) {
        let items: String = written.items.iter().map(|item| format!("  - {item}\n")).collect();
        let contour = technolog::turning::contour::Contour { side: Side::Outer, pieces: written.pieces };
        let (_, most) = contour.radii().unwrap();
        let length = contour.end().unwrap().z.diameter().micrometres() / 2;
        // Points of arcs are rounded, so that a micrometre of radius is let pass.
        let (thin, less) = if short { (0, 1) } else { (4, 0) };
        let diameter = technolog::units::Micrometres::new(most.diameter().micrometres() - thin);
        let length = technolog::units::Micrometres::new(length - less);
        let text = format!("shaft: a\nmaterial: steel-45\nblank: {{kind: bar, diameter: {diameter}, length: {length}}}\nouter:\n{items}");
        let mistakes = read_turned("part", &text, &KNOWLEDGE).unwrap_err();
        let code = if short { "part-longer-than-blank" } else { "part-beyond-blank" };
        prop_assert!(mistakes.iter().all(|one| one.code() == code && one.place().is_some()), "{mistakes:?}");
    }

    /// The contour of a stepped shaft written out is the same part.
    #[test]
    fn steps_are_short_for_a_contour(shaft in shafts::shafts(60)) {
        let mut cylinders: Vec<(Micrometres, Micrometres)> = Vec::new();
        for step in &shaft.steps {
            match cylinders.last_mut() {
                Some((diameter, length)) if *diameter == step.diameter => *length = *length + step.length,
                _ => cylinders.push((step.diameter, step.length)),
            }
        }
        let item = |(diameter, length): &(Micrometres, Micrometres)| {
            format!("  - {{face: {diameter}}}\n  - {{cylinder: {{length: {length}}}}}\n")
        };
        let text = format!(
            "shaft: shaft\nmaterial: steel-45\nblank: {{kind: bar, diameter: {}, length: {}}}\nouter:\n  - {{from: {{d: 0, z: 0}}}}\n{}\
             roughing: {{limiting_depth: {}}}\nallowances: {{method: stated, on_diameter: 0, on_face: 0}}\n",
            shaft.blank.diameter,
            shaft.blank.length,
            cylinders.iter().map(item).collect::<String>(),
            shaft.roughing.longitudinal_depth
        );
        prop_assert_eq!(Workpiece { shaft: None, ..shafts::workpiece(&shaft) }, read(&text));
    }

    #[test]
    fn no_file_makes_the_reader_panic_and_none_is_refused_without_a_place(
        name in prop::sample::select(vec!["turned-pin", "turned-ball", "turned-bushing", "turned-forging"]),
        from in 0_usize..1600, long in 0_usize..12, put in "[-0-9.,:{}\\[\\] a-zа-я\n\"']{0,6}"
    ) {
        let text = text(name);
        let letters: Vec<char> = text.lines().filter(|line| !line.starts_with('#')).collect::<Vec<_>>().join("\n").chars().collect();
        let from = from.min(letters.len());
        let rest = letters.iter().skip(from + long);
        let spoilt: String = letters.iter().take(from).copied().chain(put.chars()).chain(rest.copied()).collect();
        match read_turned("part", &spoilt, &KNOWLEDGE) {
            Err(mistakes) => {
                prop_assert!(!mistakes.is_empty(), "{spoilt}");
                prop_assert!(mistakes.iter().all(|one| one.place().is_some()), "{mistakes:?}");
            }
            Ok(workpiece) => prop_assert!(workpiece.outer.contour().hangs_together()),
        }
    }
}
