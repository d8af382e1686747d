//! Programs for lathes: arcs in all directions with words worked out by hand, whole programs as snapshots, a law over
//! random ways, and every reason for not writing. What LinuxCNC itself makes of them is held by tests/oracles/lathe.py.

use proptest::prelude::*;
use technolog::report::Lang;
use technolog::turning::contour::{Contour, Curve, Piece, Side, Turn};
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::turning::program::{
    Allowance, Control, CycleProgram, Direction, Feeds, NotWritten, Roughing, Setting, Speed, cycle, plain,
};
use technolog::turning::toolpath::{Purpose, Toolpath};
use technolog::units::{MetresPerMinute, MillimetresPerRev, RevsPerMinute};
use technolog_testing::KNOWLEDGE;

fn at(radius: f64, z: f64) -> Point {
    Point::new(Half::from(radius), Half::from(z))
}

fn mm(length: f64) -> Half {
    Half::from(length)
}

fn control(name: &str) -> Control {
    Control::read(name, &KNOWLEDGE).unwrap()
}

fn feeds() -> Feeds {
    let feed = MillimetresPerRev;
    let (cut, infeed, pick_up) = (feed(0.3), feed(0.15), feed(0.2));
    Feeds {
        cut,
        infeed,
        pick_up,
        semi_finish: feed(0.25),
        finish: feed(0.1),
        back: feed(0.6),
        plunge: feed(0.05),
        thread: feed(1.5),
    }
}

fn setting() -> Setting {
    let speed = Speed::Cutting { speed: MetresPerMinute(120.0), limit: RevsPerMinute(2500.0) };
    Setting { name: "Вал ступінчастий".to_owned(), tool: 1, speed, feeds: feeds(), coolant: true }
}

fn roughing(direction: Direction) -> Roughing {
    Roughing { direction, depth: mm(4.0), clearance: mm(2.0), retract: mm(0.5), allowance: Allowance::default() }
}

/// Ø40 to 16 mm, Ø50 to 34 mm, from the axis: the shaft of the paper.
fn stepped() -> Contour {
    let corners = [at(0.0, 0.0), at(20.0, 0.0), at(20.0, 16.0), at(25.0, 16.0), at(25.0, 34.0)];
    Contour::through(Side::Outer, &corners)
}

/// A ball of 10 on the end, a cylinder with a fillet of 5, a chamfer of 2 on the flange.
fn rounded() -> Contour {
    let pieces = vec![
        Piece::arc(at(0.0, 0.0), at(10.0, 10.0), mm(10.0), Turn::Right),
        Piece::line(at(10.0, 10.0), at(10.0, 25.0)),
        Piece::arc(at(10.0, 25.0), at(15.0, 30.0), mm(5.0), Turn::Left),
        Piece::line(at(15.0, 30.0), at(28.0, 30.0)),
        Piece::line(at(28.0, 30.0), at(30.0, 32.0)),
        Piece::line(at(30.0, 32.0), at(30.0, 40.0)),
    ];
    Contour { side: Side::Outer, pieces }
}

/// A bore of Ø60 to 10 mm with a fillet of 3 down to Ø40, through a hole of Ø30.
fn bore() -> Contour {
    let pieces = vec![
        Piece::line(at(30.0, 0.0), at(30.0, 7.0)),
        Piece::arc(at(30.0, 7.0), at(27.0, 10.0), mm(3.0), Turn::Right),
        Piece::line(at(27.0, 10.0), at(20.0, 10.0)),
        Piece::line(at(20.0, 10.0), at(20.0, 25.0)),
    ];
    Contour { side: Side::Inner, pieces }
}

/// One pass of a loop, a rest cut along an arc, and the way back.
fn toolpath() -> Toolpath {
    let mut toolpath = Toolpath::at(at(35.0, -2.0));
    toolpath.go(at(28.5, -2.0), Purpose::Rapid);
    toolpath.go(at(28.5, 30.0), Purpose::Cut);
    toolpath.go(at(29.0, 29.5), Purpose::Rapid);
    toolpath.go(at(29.0, -2.0), Purpose::Rapid);
    toolpath.go(at(20.0, -2.0), Purpose::Rapid);
    toolpath.go(at(20.0, 25.0), Purpose::Cut);
    toolpath.follow(Piece::arc(at(20.0, 25.0), at(25.0, 30.0), mm(5.0), Turn::Left), Purpose::PickUp);
    toolpath.go(at(28.5, 30.0), Purpose::PickUp);
    toolpath.go(at(30.0, 30.0), Purpose::Return);
    toolpath.go(at(35.0, -2.0), Purpose::Rapid);
    toolpath
}

fn files(program: &CycleProgram) -> String {
    program.files.iter().map(|file| format!("=== {}\n{}", file.name, file.text)).collect()
}

/// Quarters of 10 between Ø20 at Z0 and Ø40 at Z−10, drawn with Z to the right and X upwards as a program sees them, so
/// the chuck is on the left. The ball has its centre on the same radius as its thin end (radius 10, Z−10), the fillet
/// over it (radius 20, Z0). From the free end the ball begins to the right of its centre and ends above it:
/// counterclockwise, G3; the fillet begins below its centre and ends left of it: clockwise, G2. I and K lead from the
/// beginning to the centre.
#[test]
fn arcs_have_the_words_that_were_worked_out_by_hand() {
    let (thin, thick) = (at(10.0, 0.0), at(20.0, 10.0));
    for (from, to, turn, words) in [
        (thin, thick, Turn::Right, "G3 X40 Z-10 I0 K-10"),
        (thin, thick, Turn::Left, "G2 X40 Z-10 I10 K0"),
        (thick, thin, Turn::Left, "G2 X20 Z0 I-10 K0"),
        (thick, thin, Turn::Right, "G3 X20 Z0 I0 K10"),
    ] {
        let mut toolpath = Toolpath::at(from);
        toolpath.follow(Piece::arc(from, to, mm(10.0), turn), Purpose::Cut);
        for name in ["linuxcnc", "sinumerik"] {
            let text = plain(&control(name), &toolpath, &setting()).unwrap();
            assert!(text.lines().any(|line| line == format!("{words} F0.3")), "{words} is not in\n{text}");
        }
    }
}

/// A diameter of whole micrometres and a Z of half a micrometre are written exactly; a spindle speed needs no limit.
#[test]
fn lengths_are_exact_and_words_are_not_repeated() {
    let mut toolpath = Toolpath::at(Point::new(Half::new(39_985), Half::new(-3)));
    toolpath.go(Point::new(Half::new(39_985), Half::new(20_001)), Purpose::Cut);
    toolpath.go(Point::new(Half::new(40_001), Half::new(20_001)), Purpose::Cut);
    let setting =
        Setting { speed: Speed::Spindle(RevsPerMinute(800.0)), coolant: false, name: "A(1)".to_owned(), ..setting() };
    let text = plain(&control("linuxcnc"), &toolpath, &setting).unwrap();
    let expected = "(A 1 )\nG18 G21 G7 G40 G90 G95\nG54 G61\nT1 M6 G43\nG97 S800 M3\nG0 X39.985 Z0.0015\nG1 Z-10.0005 F0.3\n\
                    X40.001\nM5\nM9\nM2\n";
    assert_eq!(text, expected);
}

#[test]
fn programs_of_single_moves() {
    insta::assert_snapshot!(
        "turning-program-linuxcnc-plain",
        plain(&control("linuxcnc"), &toolpath(), &setting()).unwrap()
    );
    insta::assert_snapshot!(
        "turning-program-sinumerik-plain",
        plain(&control("sinumerik"), &toolpath(), &setting()).unwrap()
    );
}

/// For each control: the stepped shaft of a bar Ø65 with 1 mm on its face, along and across; the rounded one of a bar Ø70;
/// the bore.
#[test]
fn programs_of_cycles() {
    let tasks = [
        ("stepped-longitudinal", stepped(), at(32.5, -1.0), Direction::Longitudinal),
        ("stepped-facing", stepped(), at(32.5, -1.0), Direction::Facing),
        ("rounded-longitudinal", rounded(), at(35.0, 0.0), Direction::Longitudinal),
        ("bore-longitudinal", bore(), at(15.0, 0.0), Direction::Longitudinal),
        ("bore-facing", bore(), at(15.0, 0.0), Direction::Facing),
    ];
    for name in ["linuxcnc", "sinumerik"] {
        for (task, contour, corner, direction) in &tasks {
            let written = cycle(&control(name), contour, *corner, roughing(*direction), &setting()).unwrap();
            insta::assert_snapshot!(format!("turning-program-{name}-{task}"), files(&written));
        }
    }
}

/// The allowance of CYCLE95 stands in FALZ and FALX, its fourth and third field, and the depth in MID: all on the radius.
#[test]
fn cycle95_is_told_its_allowance() {
    let allowance = Allowance { radius: mm(0.5), z: mm(0.2) };
    let roughing_task = Roughing { allowance, ..roughing(Direction::Longitudinal) };
    let written = cycle(&control("sinumerik"), &stepped(), at(32.5, 0.0), roughing_task, &setting()).unwrap();
    let call = "CYCLE95(\"VAL_STUPINCHAS_K\", 4, 0.2, 0.5, 0, 0.3, 0.15, 0.1, 1, , , 0.5)";
    let text = files(&written);
    assert!(text.lines().any(|line| line == call), "{text}");
}

#[test]
fn what_is_known_of_nc_201_are_names() {
    let nc = control("nc-201");
    let refused = cycle(&nc, &stepped(), at(32.5, 0.0), roughing(Direction::Longitudinal), &setting()).unwrap_err();
    let words: Vec<String> = ["DFP", "EPF", "SPA", "SPF", "SPP", "CLP"].map(str::to_owned).to_vec();
    assert_eq!(refused, NotWritten::NotDocumented { control: "nc-201".to_owned(), words });
    assert_eq!(plain(&nc, &toolpath(), &setting()).unwrap_err(), refused);
    assert!(Control::read("nc-500", &KNOWLEDGE).is_err());
}

/// Every control that a user can name is a row of the table, and no other.
#[test]
fn the_controls_are_those_of_the_table() {
    let table = KNOWLEDGE.table("lathe-controls").unwrap();
    let rows: Vec<&str> = table.all_rows().map(|row| technolog_testing::text(row, "control")).collect();
    assert_eq!(rows, Control::NAMES);
    assert!(Control::NAMES.iter().all(|name| Control::read(name, &KNOWLEDGE).is_ok()));
}

/// Every reason has its sentence and remedy.
#[test]
fn what_cannot_be_written_is_refused_with_its_reason() {
    let linuxcnc = control("linuxcnc");
    let bad_way = |moves: &dyn Fn(&mut Toolpath), change: &dyn Fn(&mut Setting)| {
        let (mut toolpath, mut setting) = (Toolpath::at(at(20.0, 0.0)), setting());
        moves(&mut toolpath);
        change(&mut setting);
        plain(&linuxcnc, &toolpath, &setting).unwrap_err()
    };
    let cut = |path: &mut Toolpath| path.go(at(20.0, 5.0), Purpose::Cut);
    let arc = |radius: f64, purpose: Purpose| {
        move |path: &mut Toolpath| {
            path.follow(Piece::arc(at(20.0, 0.0), at(20.0, 10.0), mm(radius), Turn::Left), purpose)
        }
    };
    let as_is = |_: &mut Setting| {};
    let bad_task = |contour: &Contour, corner: Point, roughing: Roughing| {
        cycle(&linuxcnc, contour, corner, roughing, &setting()).unwrap_err()
    };
    let (along, across) = (roughing(Direction::Longitudinal), roughing(Direction::Facing));
    let corner = at(32.5, -1.0);
    let back =
        Contour::through(Side::Outer, &[at(0.0, 0.0), at(10.0, 0.0), at(12.0, 9.0), at(14.0, 5.0), at(20.0, 5.0)]);
    let hollow = Contour::through(Side::Outer, &[at(20.0, 0.0), at(20.0, 9.0), at(15.0, 9.0), at(15.0, 20.0)]);
    let mut apart = stepped();
    apart.pieces.remove(1);
    let empty = Contour { side: Side::Outer, pieces: Vec::new() };
    let pointless =
        Contour { side: Side::Outer, pieces: vec![Piece::arc(at(10.0, 0.0), at(20.0, 10.0), Half::ZERO, Turn::Left)] };
    let long = Half::from(5.0);
    for (refused, code) in [
        (bad_way(&|_| {}, &as_is), "lathe-way-empty"),
        (bad_way(&arc(0.0, Purpose::Cut), &as_is), "lathe-arc-without-radius"),
        (bad_way(&arc(4.9, Purpose::Cut), &as_is), "lathe-arc-too-small"),
        (bad_way(&arc(5.0, Purpose::Rapid), &as_is), "lathe-rapid-arc"),
        (bad_way(&cut, &|setting| setting.tool = 0), "lathe-no-tool"),
        (bad_way(&cut, &|setting| setting.speed = Speed::Spindle(RevsPerMinute(f64::NAN))), "lathe-no-speed"),
        (bad_way(&cut, &|setting| setting.feeds.finish = MillimetresPerRev(0.00001)), "lathe-no-feed"),
        (bad_task(&empty, corner, along), "lathe-contour-empty"),
        (bad_task(&apart, corner, along), "lathe-contour-apart"),
        (bad_task(&pointless, corner, along), "lathe-arc-without-radius"),
        (bad_task(&back, corner, along), "lathe-contour-turns-back"),
        (bad_task(&hollow, corner, across), "lathe-contour-falls"),
        (bad_task(&stepped(), at(24.9, 0.0), along), "lathe-contour-beyond-blank"),
        (bad_task(&bore(), at(20.1, 0.0), along), "lathe-contour-beyond-blank"),
        (bad_task(&stepped(), at(32.5, 1.0), along), "lathe-contour-before-face"),
        (bad_task(&hollow, at(20.0, 0.0), along), "lathe-nothing-to-cut"),
        (bad_task(&stepped(), corner, Roughing { depth: Half::ZERO, ..along }), "lathe-not-above-zero"),
        (bad_task(&stepped(), corner, Roughing { retract: long, ..along }), "lathe-retract-beyond-clearance"),
        (bad_task(&bore(), at(3.0, 0.0), Roughing { clearance: long, ..along }), "lathe-bore-too-narrow"),
        (
            bad_task(&stepped(), corner, Roughing { allowance: Allowance { radius: long, z: long }, ..along }),
            "lathe-allowance",
        ),
    ] {
        let note = refused.note();
        assert_eq!(note.code(), code, "{refused:?}");
        for lang in [Lang::UK, Lang::EN] {
            assert!(!lang.say(&note).contains('{'), "{}", lang.say(&note));
            assert!(lang.remedy(&note).is_some(), "{code}");
        }
    }
    // The same hollow is no obstacle along the axis: G71 and CYCLE95 clear it.
    assert!(cycle(&linuxcnc, &hollow, corner, along, &setting()).is_ok());
    let text = Lang::EN.say(&bad_way(&arc(4.9, Purpose::Cut), &as_is).note());
    assert_eq!(text, "the radius of arc 1 is 4.9 mm, but its end needs at least 5 mm");
}

/// Reads a program of single moves for LinuxCNC back. It knows what `plain` writes and no more; the purpose of a move is
/// that whose feed it has.
fn read_way(text: &str, feeds: &Feeds) -> Toolpath {
    let mut toolpath: Option<Toolpath> = None;
    let (mut motion, mut feed) = (String::new(), String::new());
    let moves = text.lines().skip_while(|line| !line.starts_with("G0 ")).take_while(|line| *line != "M5");
    for line in moves {
        let from = toolpath.as_ref().map(Toolpath::end).unwrap_or_default();
        let (mut to, mut centre) = (from, None);
        for word in line.split(' ') {
            let (letter, number) = word.split_at(1);
            let value: f64 = number.parse().unwrap();
            match letter {
                "G" => motion = word.to_owned(),
                "F" => feed = number.to_owned(),
                "X" => to.radius = mm(value / 2.0),
                "Z" => to.z = mm(-value),
                "I" => centre = Some((value, 0.0)),
                "K" => centre = centre.map(|(i, _)| (i, value)),
                _ => panic!("`{word}` is no word of a plain program"),
            }
        }
        let all =
            [Purpose::Cut, Purpose::Infeed, Purpose::PickUp, Purpose::SemiFinish, Purpose::Finish, Purpose::Return];
        let of_feed = all.into_iter().find(|one| feeds.of(*one).unwrap().0.to_string() == feed);
        let purpose = if motion == "G0" { Purpose::Rapid } else { of_feed.unwrap() };
        let curve = match (motion.as_str(), centre) {
            ("G2", Some((i, k))) => Curve::Arc { radius: mm(libm::hypot(i, k)), turn: Turn::Left },
            ("G3", Some((i, k))) => Curve::Arc { radius: mm(libm::hypot(i, k)), turn: Turn::Right },
            _ => Curve::Line,
        };
        match &mut toolpath {
            None => toolpath = Some(Toolpath::at(to)),
            Some(path) => path.follow(Piece { from, to, curve }, purpose),
        }
    }
    toolpath.unwrap()
}

/// A move: its end in half micrometres, its purpose, and for an arc how much larger its radius is than half its chord, and
/// whether it bends left.
type AnyMove = ((i64, i64), usize, Option<(f64, bool)>);

fn moves() -> impl Strategy<Value = Vec<AnyMove>> {
    let length = || prop_oneof![(-5_i64..120).prop_map(|whole| whole * 2000), -10_000_i64..240_000];
    let arc = proptest::option::of((1.0..3.0_f64, any::<bool>()));
    proptest::collection::vec(((length(), length()), 0..7_usize, arc), 1..20)
}

proptest! {
    #![proptest_config(technolog_laws::cases!(256))]

    /// Written and read back, a way is the same to the half micrometre, arcs with their radius and side.
    #[test]
    fn a_way_written_and_read_back_is_the_same(start in (0_i64..200_000, -10_000_i64..200_000), moves in moves()) {
        let purposes = [
            Purpose::Rapid,
            Purpose::Cut,
            Purpose::Infeed,
            Purpose::PickUp,
            Purpose::SemiFinish,
            Purpose::Finish,
            Purpose::Return,
        ];
        let mut toolpath = Toolpath::at(Point::new(Half::new(start.0), Half::new(start.1)));
        for ((radius, z), purpose, arc) in moves {
            let to = Point::new(Half::new(radius), Half::new(z));
            let purpose = purposes[purpose];
            match arc {
                Some((share, left)) if purpose != Purpose::Rapid && to != toolpath.end() => {
                    let radius = Half::new((toolpath.end().to(to).length() * share * 1000.0).ceil() as i64 + 1);
                    let turn = if left { Turn::Left } else { Turn::Right };
                    toolpath.follow(Piece::arc(toolpath.end(), to, radius, turn), purpose);
                }
                _ => toolpath.go(to, purpose),
            }
        }
        prop_assume!(!toolpath.moves.is_empty());
        let text = plain(&control("linuxcnc"), &toolpath, &setting()).unwrap();
        prop_assert_eq!(read_way(&text, &feeds()), toolpath, "{}", text);
    }
}
