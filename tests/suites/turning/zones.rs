//! Set-ups and zones (lecture 12.3, and the conclusions of 12.4). The numbers are those of docs/turning-lecture.md.
//! Contours are written down by hand as radius and Z, mm, Z growing from the free end towards the chuck.

use proptest::prelude::*;
use technolog::report::Lang;
use technolog::turning::contour::{Contour, Piece, Profile, Side, Surface, SurfaceKind, SurfaceName, Turn};
use technolog::turning::elements::{Angles, Hand};
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::turning::shaft::{Division, Holding};
use technolog::turning::workpiece::{Allowances, Blank, Scheme, StockKind, Workpiece};
use technolog::turning::zones::{
    Feed, Hold, Returns, SetUp, Stock, ToolAngles, Zone, ZoneKind, find, fit, idle_returns, set_ups,
};
use technolog::units::Degrees;
use technolog_testing::KNOWLEDGE;
use technolog_testing::shafts::{shaft, workpiece};

/// Read once: the laws below ask often.
fn mm(length: f64) -> Half {
    Half::from(length)
}

fn at(radius: f64, z: f64) -> Point {
    Point { radius: mm(radius), z: mm(z) }
}

fn through(side: Side, points: &[(f64, f64)]) -> Contour {
    let points: Vec<Point> = points.iter().map(|(radius, z)| at(*radius, *z)).collect();
    Contour::through(side, &points)
}

fn outer(points: &[(f64, f64)]) -> Contour {
    through(Side::Outer, points)
}

/// Zones with one tool for all; φ1 is large enough for every fall here.
fn zones(rough: &Contour, blank: &Contour) -> Vec<Zone> {
    find(stock(rough, blank), &[tool("V", 95.0, 80.0)], &KNOWLEDGE).unwrap()
}

fn stock<'a>(rough: &'a Contour, blank: &'a Contour) -> Stock<'a> {
    Stock { rough, blank, near_part: false, against_stop: false }
}

fn tool(name: &str, main: f64, secondary: f64) -> ToolAngles {
    let angles = Angles { main: Degrees(main), secondary: Degrees(secondary), hand: Hand::Right };
    ToolAngles { name: name.to_owned(), angles, least_bore: None, reach: None, width: None }
}

fn kinds(zone: &Zone) -> Vec<ZoneKind> {
    zone.parts.iter().map(|part| part.kind).collect()
}

fn scheme_names(schemes: &[Scheme]) -> Vec<&'static str> {
    schemes.iter().map(|scheme| scheme.name()).collect()
}

/// Three cylinders, radii 20, 25 and 30, on a bar of radius 40.
const THREE: [(f64, f64); 6] = [(20.0, 0.0), (20.0, 10.0), (25.0, 10.0), (25.0, 30.0), (30.0, 30.0), (30.0, 50.0)];
/// A groove between a cone that falls by 45° and a face, with a floor of 10, in a cylinder of radius 30.
const VALLEY: [(f64, f64); 6] = [(30.0, 0.0), (30.0, 10.0), (25.0, 15.0), (25.0, 25.0), (30.0, 25.0), (30.0, 40.0)];

/// 12.3-1, 12.4-13 and 12.4-28: over a stepped shaft that runs out two half-open parts and an open one are one combined
/// zone: loop over the open part, then the rest with a semi-finishing pass. The same as for a stepped shaft file.
#[test]
fn a_stepped_shaft_is_one_combined_zone() {
    let blank = outer(&[(40.0, 0.0), (40.0, 50.0)]);
    let zones = zones(&outer(&THREE), &blank);
    assert_eq!(zones.len(), 1);
    assert_eq!((zones[0].kind, zones[0].feed), (ZoneKind::Combined, Feed::Along));
    // In the order of fig. 12.3 г: 1 open, 2 half-open.
    assert_eq!(kinds(&zones[0]), [ZoneKind::Open, ZoneKind::HalfOpen, ZoneKind::HalfOpen]);
    assert_eq!(scheme_names(&zones[0].scheme.schemes), ["loop", "semi-finishing"]);
    assert_eq!(zones[0].scheme.parts_worked.name(), "each");
    assert_eq!((zones[0].least_radius, zones[0].greatest_radius), (mm(20.0), mm(40.0)));
    assert_eq!(zones[0].needs.main, Degrees(90.0));
    let part = &zones[0].parts[1];
    assert_eq!(
        (part.from_z, part.to_z, part.least_radius, part.greatest_radius),
        (mm(0.0), mm(10.0), mm(20.0), mm(40.0))
    );
    assert_eq!(part.because.table, "turning-zone");
}

/// 12.3-3: an open zone asks no angle: a cylinder, and a cone that both ends of the passes run out of.
#[test]
fn an_open_zone_asks_no_angles() {
    for (rough, blank) in [
        (outer(&[(20.0, 0.0), (20.0, 30.0)]), outer(&[(25.0, 0.0), (25.0, 30.0)])),
        (outer(&[(20.0, 0.0), (25.0, 30.0)]), outer(&[(25.0, 0.0), (25.0, 30.0)])),
    ] {
        let zones = zones(&rough, &blank);
        assert_eq!((zones.len(), zones[0].kind), (1, ZoneKind::Open));
        assert_eq!((zones[0].needs.main, zones[0].needs.secondary), (Degrees(0.0), Degrees(0.0)));
        assert_eq!(scheme_names(&zones[0].scheme.schemes), ["loop"]);
        let any = fit(&zones[0], &[tool("45", 45.0, 5.0)]);
        assert_eq!(any.fitting, ["45"]);
    }
    // With more stock than the cone is high, passes along the axis end at it.
    let zones = zones(&outer(&[(20.0, 0.0), (25.0, 30.0), (25.0, 40.0)]), &outer(&[(30.0, 0.0), (30.0, 40.0)]));
    assert_eq!(kinds(&zones[0]), [ZoneKind::Open, ZoneKind::HalfOpen]);
}

/// 12.3-4: a half-open zone rules φ: 90° before a face, the angle of the cone before a cone. 12.3-5: a closed one both, and
/// the tool returns along its contour.
#[test]
fn what_bounds_a_zone_rules_the_angles() {
    let bar = outer(&[(40.0, 0.0), (40.0, 60.0)]);
    for (points, kind, main, secondary) in [
        (vec![(20.0, 0.0), (20.0, 10.0), (40.0, 10.0)], ZoneKind::HalfOpen, 90.0, 0.0),
        (vec![(20.0, 0.0), (20.0, 10.0), (40.0, 30.0)], ZoneKind::HalfOpen, 45.0, 0.0),
        (vec![(40.0, 0.0), (20.0, 20.0), (20.0, 30.0), (40.0, 30.0)], ZoneKind::Closed, 90.0, 45.0),
        (vec![(40.0, 0.0), (20.0, 20.0), (20.0, 60.0)], ZoneKind::HalfOpen, 0.0, 45.0),
    ] {
        let zones = zones(&outer(&points), &bar);
        let [zone] = zones.as_slice() else { panic!("{zones:?}") };
        assert_eq!((zone.kind, zone.needs.main, zone.needs.secondary), (kind, Degrees(main), Degrees(secondary)));
        assert_eq!(zone.scheme.return_way == "along-contour", kind == ZoneKind::Closed);
        assert_eq!(scheme_names(&zone.scheme.schemes), ["semi-finishing"]);
        assert_eq!(scheme_names(&zone.scheme.also).contains(&"descent"), kind == ZoneKind::Closed);
    }
    // A fillet rises to upright, so that φ must be 90°.
    let mut pin = outer(&[(20.0, 0.0), (20.0, 10.0)]);
    pin.pieces.push(Piece::arc(at(20.0, 10.0), at(40.0, 30.0), mm(20.0), Turn::Left));
    assert!((zones(&pin, &bar)[0].needs.main.0 - 90.0).abs() < 0.01);
}

/// 12.3-6 and 12.4-29: all three kinds make a combined zone, the first two joined, the closed one by itself.
#[test]
fn open_half_open_and_closed_are_combined() {
    let mut points = vec![(20.0, 0.0), (20.0, 5.0)];
    points.extend(VALLEY.iter().map(|(radius, z)| (*radius, z + 5.0)));
    let zones = zones(&outer(&points), &outer(&[(40.0, 0.0), (40.0, 45.0)]));
    assert_eq!((zones.len(), zones[0].kind), (1, ZoneKind::Combined));
    assert_eq!(kinds(&zones[0]), [ZoneKind::Open, ZoneKind::Open, ZoneKind::HalfOpen, ZoneKind::Closed]);
    assert_eq!(zones[0].scheme.parts_worked.name(), "joined");
    assert_eq!(scheme_names(&zones[0].scheme.schemes), ["semi-finishing", "semi-finishing"]);
    assert_eq!((zones[0].needs.main, zones[0].needs.secondary), (Degrees(90.0), Degrees(45.0)));
}

/// 12.4-30: a zone takes in as many surfaces as the tool reaches. With φ1 = 30° the valley that falls by 45° is a zone of its
/// own, with 80° all is one.
#[test]
fn neighbours_are_joined_as_far_as_a_tool_reaches() {
    let (rough, blank) = (outer(&VALLEY), outer(&[(40.0, 0.0), (40.0, 40.0)]));
    let count = |tools: &[ToolAngles]| find(stock(&rough, &blank), tools, &KNOWLEDGE).unwrap().len();
    assert_eq!(count(&[]), 3, "the contouring tool of the lecture has φ1 = 30°");
    assert_eq!(count(&[tool("30", 95.0, 30.0), tool("50", 95.0, 50.0)]), 1);
    // A grooving tool has no angles to fail by, but reaches nothing beside its groove.
    let groover = ToolAngles { width: Some(mm(3.0)), ..tool("groover", 0.0, 0.0) };
    assert_eq!(count(&[tool("30", 95.0, 30.0), groover]), 3);
}

/// 12.4-30, fig. 12.5 by hand: stocks of 20, 15 and 10 in levels of 5: split at every face 4 + 3 + 2 passes. Joined, the first
/// two levels go over all three, the third over two, the fourth over one: 4.
#[test]
fn joining_saves_returns() {
    let zones = zones(&outer(&THREE), &outer(&[(40.0, 0.0), (40.0, 50.0)]));
    assert_eq!(idle_returns(&zones[0], mm(5.0)), Returns { depth_mm: mm(5.0), split: 9, joined: 4, saved: 5 });
    // With levels of 8: 3 + 2 + 2 split. Joined: down to 32 over all; down to 24 ends before the second cylinder of 25 and
    // the third of 30, each of which takes a pass of its own; then the first to 20.
    assert_eq!(idle_returns(&zones[0], mm(8.0)), Returns { depth_mm: mm(8.0), split: 7, joined: 5, saved: 2 });
    assert_eq!(idle_returns(&zones[0], Half::ZERO).split, 0);
}

/// The face of the free end is a zone of its own, across.
#[test]
fn stock_before_the_free_end_is_faced() {
    let rough = outer(&[(0.0, 0.0), (20.0, 0.0), (20.0, 30.0)]);
    let zones = zones(&rough, &outer(&[(0.0, -1.5), (25.0, -1.5), (25.0, 30.0)]));
    let shown: Vec<_> = zones.iter().map(|zone| (zone.number, zone.feed, zone.from_z, zone.to_z)).collect();
    assert_eq!(shown, [(1, Feed::Across, mm(-1.5), mm(0.0)), (2, Feed::Along, mm(0.0), mm(30.0))]);
    assert_eq!((zones[0].least_radius, zones[0].greatest_radius), (mm(0.0), mm(25.0)));
}

/// 12.4-12 and 12.3-1 for a stepped blank: the step of the blank is stock ahead.
#[test]
fn a_step_of_the_blank_divides_the_stock() {
    let rough = outer(&[(20.0, 0.0), (20.0, 60.0)]);
    let blank = outer(&[(25.0, 0.0), (25.0, 30.0), (40.0, 30.0), (40.0, 60.0)]);
    let zones = zones(&rough, &blank);
    let shown: Vec<_> = zones[0].parts.iter().map(|part| (part.kind, part.from_z, part.greatest_radius)).collect();
    assert_eq!(shown, [(ZoneKind::Open, mm(30.0), mm(40.0)), (ZoneKind::HalfOpen, mm(0.0), mm(25.0))]);
    // A bar that goes on thicker behind the end is a wall, which must stay upright.
    let longer = outer(&[(40.0, 0.0), (40.0, 90.0)]);
    let zone = &find(stock(&rough, &longer), &[], &KNOWLEDGE).unwrap()[0];
    assert_eq!((zone.kind, zone.needs.main), (ZoneKind::HalfOpen, Degrees(90.0)));
}

/// 12.4-31: against a stop the loop serves for half-open zones; a shaped contour in a forging is worked at equal distances,
/// in bar it is not.
#[test]
fn circumstances_choose_the_scheme() {
    let (rough, blank) = (outer(&[(20.0, 0.0), (20.0, 10.0), (40.0, 30.0)]), outer(&[(40.0, 0.0), (40.0, 30.0)]));
    let step = outer(&[(20.0, 0.0), (20.0, 10.0), (40.0, 10.0)]);
    for (rough, near_part, against_stop, scheme) in [
        (&step, false, true, "loop"),
        (&step, false, false, "semi-finishing"),
        (&rough, true, false, "equidistant"),
        (&rough, false, false, "semi-finishing"),
    ] {
        let zones = find(Stock { rough, blank: &blank, near_part, against_stop }, &[], &KNOWLEDGE).unwrap();
        assert_eq!(scheme_names(&zones[0].scheme.schemes), [scheme]);
    }
}

/// A tool that does not fit is refused with every inequality that fails; one of the other hand meets the fall first.
#[test]
fn a_tool_fits_or_the_inequality_says_why_not() {
    let zone =
        &zones(&outer(&[(40.0, 0.0), (20.0, 20.0), (20.0, 30.0), (40.0, 30.0)]), &outer(&[(40.0, 0.0), (40.0, 60.0)]))
            [0];
    let groover = |width| ToolAngles { width: Some(mm(width)), ..tool("groover", 0.0, 0.0) };
    let mut left = tool("left", 60.0, 90.0);
    left.angles.hand = Hand::Left;
    let tools =
        [tool("V", 95.0, 50.0), tool("45", 45.0, 45.0), tool("55", 93.0, 32.0), left, groover(10.0), groover(12.0)];
    let fit = fit(zone, &tools);
    assert_eq!(fit.fitting, ["V", "left", "groover"]);
    let texts: Vec<String> = fit.refused.iter().flat_map(|one| &one.why).map(|why| Lang::EN.say(why)).collect();
    assert_eq!(
        texts,
        ["φ = 45° is less than 90°", "φ1 = 32° is less than 45°", "the tool is 12 mm wide, the floor 10 mm"]
    );
}

/// A bore: judged inside out, told in its own radii, and the bar must pass what is drilled.
#[test]
fn a_bar_must_enter_the_bore() {
    let rough = through(Side::Inner, &[(20.0, 0.0), (20.0, 30.0), (15.0, 30.0), (15.0, 50.0)]);
    let hole = through(Side::Inner, &[(10.0, 0.0), (10.0, 50.0)]);
    let zone = &zones(&rough, &hole)[0];
    assert_eq!(kinds(zone), [ZoneKind::Open, ZoneKind::HalfOpen]);
    assert_eq!((zone.least_radius, zone.greatest_radius), (mm(10.0), mm(20.0)));
    assert_eq!(zone.parts[1].contour[0].from, at(20.0, 0.0));
    assert_eq!(zone.passage, Some(mm(10.0).diameter()));
    let bar =
        |name: &str, least: &str| ToolAngles { least_bore: Some(least.parse().unwrap()), ..tool(name, 95.0, 30.0) };
    let fit = fit(zone, &[bar("S16", "20"), bar("S20", "25")]);
    assert_eq!(fit.fitting, ["S16"]);
    assert_eq!(Lang::EN.say(&fit.refused[0].why[0]), "the bore of Ø20 is smaller than the least for the tool, Ø25");
}

// Set-ups.

fn profile(side: Side, start: (f64, f64), items: &[(SurfaceKind, f64, f64)]) -> Profile {
    let mut here = at(start.0, start.1);
    let mut surfaces = Vec::new();
    for (kind, radius, z) in items {
        let pieces = vec![Piece::line(here, at(*radius, *z))];
        here = at(*radius, *z);
        let name = SurfaceName::Place(side, surfaces.len() + 1);
        surfaces.push(Surface::plain(name, *kind, pieces));
    }
    Profile { side, surfaces }
}

use SurfaceKind::{Chamfer, Cone, Cylinder, Face};

fn flange() -> Profile {
    let items = [
        (Face, 15.0, 0.0),
        (Cylinder, 15.0, 30.0),
        (Face, 40.0, 30.0),
        (Cylinder, 40.0, 50.0),
        (Face, 20.0, 50.0),
        (Cylinder, 20.0, 60.0),
        (Face, 0.0, 60.0),
    ];
    profile(Side::Outer, (0.0, 0.0), &items)
}

/// A part in a chuck that is finished, too.
fn part(outer: &Profile, inner: Option<&Profile>, blank: &Contour) -> Workpiece {
    let bar = Blank { kind: StockKind::Bar, outer: blank.clone(), inner: None, length_tolerance: None };
    let (outer, inner, allowances) = (outer.clone(), inner.cloned(), Allowances::Table);
    let other = workpiece(&shaft(40_000, &[(30_000, 10_000)], 4_000, 4_000, Division::Full));
    Workpiece { outer, inner, blank: bar, allowances, ..other }
}

fn made(outer: &Profile, inner: Option<&Profile>, blank: &Contour, length: f64) -> Vec<SetUp> {
    let part = part(outer, inner, blank);
    assert_eq!(part.length(), mm(length));
    set_ups(&part, None, Angles::CONTOURING, &KNOWLEDGE).unwrap()
}

fn names(stretch: Option<&technolog::turning::zones::TurnedSide>) -> Vec<String> {
    stretch.iter().flat_map(|one| &one.profile.surfaces).map(|surface| surface.name.to_string()).collect()
}

/// 12.3-2: most parts take two set-ups: split at the largest diameter; the second, turned over, begins at the far face. It is
/// held by the thickest cylinder that is long enough: Ø80, 20 mm long (15 are needed), and not Ø30.
#[test]
fn a_flange_takes_two_set_ups() {
    let blank = outer(&[(0.0, -1.0), (42.0, -1.0), (42.0, 75.0)]);
    let found = made(&flange(), None, &blank, 60.0);
    let [first, second] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(names(first.outer.as_ref()), ["outer 1", "outer 2", "outer 3", "outer 4"]);
    assert_eq!(names(second.outer.as_ref()), ["outer 7", "outer 6", "outer 5"]);
    let over = second.outer.as_ref().unwrap();
    assert_eq!(over.profile.contour().corners(), [at(0.0, 0.0), at(20.0, 0.0), at(20.0, 10.0), at(40.0, 10.0)]);
    assert_eq!(over.main.contour.corners(), over.profile.contour().corners());
    assert!(first.faces && second.faces && second.turned_over);
    let hold = Hold::Surface {
        threaded: false,
        name: "outer 4".into(),
        diameter_mm: mm(40.0).diameter(),
        length_mm: mm(20.0),
        over: (mm(30.0), mm(50.0)),
    };
    assert_eq!(second.holds_at, Some(hold));
    // 25 mm of Ø84 are left to hold the blank by, and 20 are needed.
    assert_eq!(first.because.note.code(), "hold-blank");
    let texts: Vec<String> = second.notes.iter().map(|note| Lang::EN.say(note)).collect();
    assert_eq!(texts.len(), 2);
    assert_eq!(
        texts[0],
        "from Z -50, Ø80 the contour falls towards the chuck more steeply than φ1 = 30° and never rises again"
    );
}

/// With 11 mm of Ø84 behind Ø80 (10 are the very least, and 3 more up to the tool) a turner holds the flange itself: Ø80 is turned in the
/// second set-up, when the part is held by Ø30 (30 mm long, 10 are needed).
#[test]
fn a_flange_too_near_to_the_end_is_turned_from_there() {
    let blank = outer(&[(0.0, -1.0), (42.0, -1.0), (42.0, 61.0)]);
    let found = made(&flange(), None, &blank, 60.0);
    let [first, second] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(names(first.outer.as_ref()), ["outer 1", "outer 2", "outer 3"]);
    assert_eq!(names(second.outer.as_ref()), ["outer 7", "outer 6", "outer 5", "outer 4"]);
    let Some(Hold::Blank { length_mm, .. }) = &first.holds_at else { panic!("{:?}", first.holds_at) };
    assert_eq!(*length_mm, mm(31.0));
    assert!(matches!(&second.holds_at, Some(Hold::Surface { name, .. }) if name == "outer 2"));
    assert!(second.notes.iter().any(|note| note.code() == "setup-lends"));
}

/// Jaws reach over a groove: two stretches of 9 mm of Ø120 are 18, of which 10 are the least.
#[test]
fn jaws_reach_over_a_groove() {
    let groove = (SurfaceKind::PulleyGroove, 60.0, 36.0);
    let items = [
        (Face, 25.0, 0.0),
        (Cylinder, 25.0, 14.0),
        (Face, 60.0, 14.0),
        (Cylinder, 60.0, 23.0),
        groove,
        (Cylinder, 60.0, 45.0),
        (Face, 25.0, 45.0),
        (Cylinder, 25.0, 60.0),
    ];
    let part = profile(Side::Outer, (0.0, 0.0), &items);
    let found = made(&part, None, &outer(&[(0.0, -1.0), (64.0, -1.0), (64.0, 75.0)]), 60.0);
    let Some(Hold::Surface { length_mm, over, .. }) = &found[1].holds_at else { panic!("{:?}", found[1].holds_at) };
    assert_eq!((*length_mm, *over), (mm(18.0), (mm(23.0 - 9.0), mm(45.0))));
}

/// 12.3-2: a part that rises towards the chuck, with its far face ready, takes one.
#[test]
fn one_set_up_makes_what_it_reaches() {
    let part = profile(
        Side::Outer,
        (0.0, 0.0),
        &[(Face, 15.0, 0.0), (Cylinder, 15.0, 30.0), (Face, 20.0, 30.0), (Cylinder, 20.0, 50.0)],
    );
    let blank = outer(&[(0.0, 0.0), (25.0, 0.0), (25.0, 50.0)]);
    let none = Allowances::Stated { on_diameter: Default::default(), on_face: Default::default() };
    let whole = Workpiece { allowances: none, ..self::part(&part, None, &blank) };
    let found = set_ups(&whole, None, Angles::CONTOURING, &KNOWLEDGE).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].notes.last().unwrap().code(), "setup-only");
    // What falls gently behind the largest radius is reached too.
    let gentle = profile(Side::Outer, (10.0, 0.0), &[(Cone, 20.0, 20.0), (Cone, 10.0, 50.0)]);
    assert_eq!(made(&gentle, None, &outer(&[(25.0, 0.0), (25.0, 50.0)]), 50.0).len(), 1);
    // Between centres nothing is held by a cylinder.
    let blank = outer(&[(0.0, 0.0), (25.0, 0.0), (25.0, 50.0)]);
    let part = Workpiece { holding: Holding::Centres, ..self::part(&part, None, &blank) };
    assert_eq!(set_ups(&part, None, Angles::CONTOURING, &KNOWLEDGE).unwrap()[0].holds_at, Some(Hold::Centres));
}

/// 12.3-2 for bores: each side of a bore is bored from the end to which it widens.
#[test]
fn a_bore_is_bored_from_the_side_it_opens_to() {
    let outside = profile(Side::Outer, (20.0, 0.0), &[(Cylinder, 20.0, 50.0)]);
    let bore = profile(
        Side::Inner,
        (15.0, 0.0),
        &[
            (Cylinder, 15.0, 20.0),
            (Face, 10.0, 20.0),
            (Cylinder, 10.0, 40.0),
            (Face, 14.0, 40.0),
            (Cylinder, 14.0, 49.0),
            (Chamfer, 15.0, 50.0),
        ],
    );
    let found = made(&outside, Some(&bore), &outer(&[(20.0, 0.0), (20.0, 50.0)]), 50.0);
    assert_eq!(names(found[0].inner.as_ref()), ["inner 1", "inner 2", "inner 3"]);
    assert_eq!(names(found[1].inner.as_ref()), ["inner 6", "inner 5", "inner 4"]);
    assert!(found[1].outer.is_none());
    assert_eq!(found[1].notes[0].code(), "setup-bore-widens");
}

/// Monotone contours: how far out or in, how far on; 0 on is a face, in falls by a cone.
fn stairs() -> impl Strategy<Value = Vec<(i32, u32)>> {
    prop::collection::vec((-6..7_i32, 0..12_u32), 1..10)
}

fn climbed(start: f64, steps: &[(i32, u32)]) -> Contour {
    let (mut radius, mut z) = (start, 0.0);
    let mut points = vec![(radius, z)];
    for (out, on) in steps {
        let on = f64::from(*on);
        // A fall takes at least as long as it is deep: 45°.
        let on = if *out < 0 { on.max(f64::from(-*out)) } else { on };
        radius = (radius + f64::from(*out)).max(3.0);
        z += on;
        points.push((radius, z));
        z += 2.0;
        points.push((radius, z));
    }
    outer(&points)
}

proptest! {
    #![proptest_config(technolog_laws::cases!(256))]

    /// 12.3-1: zones cover the stock exactly once: at every Z where the blank stands over the contour there is one part of one
    /// zone, and its radii hold the stock.
    #[test]
    fn zones_cover_the_stock_exactly_once(rough in stairs(), blank in stairs(), inside in any::<bool>(), count in 0..4_usize) {
        let rough = climbed(30.0, &rough);
        let length = rough.end().unwrap().z;
        let mut blank = climbed(33.0, &blank);
        let last = blank.end().unwrap();
        if last.z < length {
            blank.pieces.push(Piece::line(last, Point::new(last.radius, length)));
        }
        let top = mm(150.0);
        let side = |contour: Contour| if inside { contour.inside_out(top) } else { contour };
        let (rough, blank) = (side(rough), side(blank));
        let tools = [tool("a", 95.0, 30.0), tool("b", 95.0, 60.0), tool("c", 60.0, 60.0)];
        let zones = find(stock(&rough, &blank), &tools[..count], &KNOWLEDGE).unwrap();
        for step in 0..400 {
            // Off the whole millimetres where parts meet.
            let z = Half::new(length.halves() * step / 400 + 1);
            let (Some(part), Some(raw)) = (rough.radii_at(z), blank.radii_at(z)) else { continue };
            let stock = if inside { (raw.0, part.1) } else { (part.0, raw.1) };
            let over: Vec<_> = zones.iter().flat_map(|zone| &zone.parts).filter(|one| one.from_z < z && z < one.to_z).collect();
            prop_assert!(over.len() <= 1, "{z}: {over:?}");
            if stock.0 < stock.1 {
                prop_assert_eq!(over.len(), 1, "{}", z);
                prop_assert!(over[0].least_radius <= stock.0 + Half::new(1) && stock.1 <= over[0].greatest_radius + Half::new(1));
            }
        }
        for zone in &zones {
            let returns = idle_returns(zone, mm(2.5));
            prop_assert!(returns.joined <= returns.split);
        }
    }

    /// 12.3-2: every piece of the part belongs to exactly one set-up, and in each the main contour is monotone and not below it.
    #[test]
    fn every_piece_belongs_to_one_set_up(steps in stairs()) {
        let contour = climbed(30.0, &steps);
        let length = contour.end().unwrap().z;
        let part = Profile {
            side: Side::Outer,
            surfaces: contour.pieces.iter().enumerate().map(|(index, piece)| {
                let kind = if piece.is_face() { Face } else if piece.is_cylinder() { Cylinder } else { Cone };
                Surface::plain(SurfaceName::Place(Side::Outer, index + 1), kind, vec![*piece])
            }).collect(),
        };
        let blank = outer(&[(120.0, 0.0), (120.0, length.to_mm())]);
        let found = set_ups(&self::part(&part, None, &blank), None, Angles::CONTOURING, &KNOWLEDGE).unwrap();
        let mut pieces: Vec<Piece> = Vec::new();
        for set_up in &found {
            let Some(stretch) = &set_up.outer else { continue };
            prop_assert!(stretch.main.contour.is_monotone());
            prop_assert!(stretch.main.valleys.iter().all(|valley| !valley.open), "{:?}", stretch.main.valleys);
            let own = stretch.profile.contour();
            for corner in own.corners() {
                let most = stretch.main.contour.radii_at(corner.z).map(|(_, most)| most);
                prop_assert!(most.is_none_or(|most| most + Half::new(2) >= corner.radius));
            }
            let back = if set_up.turned_over { own.turned_over(length) } else { own };
            pieces.extend(back.pieces);
        }
        prop_assert_eq!(pieces, contour.pieces);
    }
}
