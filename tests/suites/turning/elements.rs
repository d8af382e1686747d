//! Main and additional elements and the main contour (lecture 12.1). The numbers 12.1-… are those of
//! docs/turning-lecture.md. Contours are written down by hand as radius and Z, mm, Z growing from the free end towards the chuck.

use proptest::prelude::*;
use technolog::knowledge::Knowledge;
use technolog::report::Lang;
use technolog::turning::contour::{Contour, Curve, Piece, Profile, Side, Surface, SurfaceKind, SurfaceName, Turn};
use technolog::turning::elements::{Angles, Class, Element, ElementReason, Hand, Main, classify, main_contour, split};
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::units::Degrees;
use technolog_testing::KNOWLEDGE;

use SurfaceKind::{Ball, Chamfer, Cone, Cylinder, Face, FaceGroove, Fillet, GrindingRelief, RectangularGroove, Thread};

fn at(radius: f64, z: f64) -> Point {
    Point { radius: Half::from(radius), z: Half::from(z) }
}

/// Read once: the laws below judge many contours.
fn knowledge() -> &'static Knowledge {
    &KNOWLEDGE
}

/// A profile as it is written down: surface after surface, each through its points.
struct Drawn {
    here: Point,
    profile: Profile,
}

impl Drawn {
    fn from(radius: f64, z: f64) -> Self {
        Self { here: at(radius, z), profile: Profile { side: Side::Outer, surfaces: Vec::new() } }
    }

    fn surface(mut self, kind: SurfaceKind, points: &[(f64, f64)], curve: Curve) -> Self {
        let mut pieces = Vec::new();
        for (radius, z) in points {
            pieces.push(Piece { from: self.here, to: at(*radius, *z), curve });
            self.here = at(*radius, *z);
        }
        let name = SurfaceName::Place(Side::Outer, self.profile.surfaces.len() + 1);
        let surface = Surface::plain(name, kind, pieces);
        self.profile.surfaces.push(surface);
        self
    }

    fn to(self, kind: SurfaceKind, radius: f64, z: f64) -> Self {
        self.surface(kind, &[(radius, z)], Curve::Line)
    }

    fn arc(self, kind: SurfaceKind, to: (f64, f64), radius: f64, turn: Turn) -> Self {
        self.surface(kind, &[to], Curve::Arc { radius: Half::from(radius), turn })
    }

    fn groove(self, kind: SurfaceKind, points: &[(f64, f64)]) -> Self {
        self.surface(kind, points, Curve::Line)
    }
}

/// The classes for the contouring tool of the lecture, and the main contour.
fn judged(drawn: &Drawn) -> (Vec<Class>, Main) {
    let classes = classify(&drawn.profile, Angles::CONTOURING, knowledge()).unwrap();
    let main = main_contour(&drawn.profile, &classes, Angles::CONTOURING);
    (classes, main)
}

fn grounds(classes: &[Class]) -> Vec<ElementReason> {
    classes.iter().map(|class| class.ground).collect()
}

fn corners(main: &Main) -> Vec<Point> {
    main.contour.corners()
}

/// A cylinder Ø40, `fall` degrees down by 2 mm, a cylinder Ø36 and a face up to Ø50: what falls rises again.
fn falling(degrees: f64) -> Drawn {
    let z = 20.0 + 2.0 / libm::tan(degrees.to_radians());
    let drawn = Drawn::from(20.0, 0.0).to(Cylinder, 20.0, 20.0).to(Cone, 18.0, z).to(Cylinder, 18.0, z + 30.0);
    drawn.to(Face, 25.0, z + 30.0).to(Cylinder, 25.0, z + 40.0)
}

/// A cylinder Ø20 and a face that leans back by so many degrees, up to Ø40.
fn leaning(degrees: f64) -> Drawn {
    let z = 20.0 - 10.0 * libm::tan(degrees.to_radians());
    Drawn::from(10.0, 0.0).to(Cylinder, 10.0, 20.0).to(Face, 20.0, z).to(Cylinder, 20.0, 40.0)
}

/// 12.1-4: main is what φ = 95° and φ1 = 30° make: chamfers, cylinders, upright faces, fillets up to upright, rising cones.
#[test]
fn what_the_contouring_tool_makes_is_main() {
    let drawn = Drawn::from(0.0, 0.0).to(Face, 10.0, 0.0).to(Chamfer, 12.0, 2.0).to(Cylinder, 12.0, 20.0);
    let drawn = drawn.arc(Fillet, (15.0, 23.0), 3.0, Turn::Left).to(Face, 20.0, 23.0).to(Cone, 25.0, 40.0);
    let (classes, main) = judged(&drawn.to(Cylinder, 25.0, 50.0));
    assert!(classes.iter().all(|class| class.element == Element::Main && class.tool == "contouring"), "{classes:?}");
    assert!(main.valleys.is_empty());
    assert_eq!(main.contour.pieces.len(), 7);
}

/// 12.1-4, the limits themselves: a fall of 30° is main and one of 30.5° is not; a face that leans back by 5° is main and one
/// by 6° is not. By hand: φ1 = 30°, φ − 90° = 5°.
#[test]
fn the_angles_of_the_tool_are_the_limits() {
    for (drawn, surface, ground, element) in [
        (falling(20.0), 1, ElementReason::Reach, Element::Main),
        (falling(30.0), 1, ElementReason::Reach, Element::Main),
        (falling(30.5), 1, ElementReason::Fall, Element::Additional),
        (falling(45.0), 1, ElementReason::Fall, Element::Additional),
        (leaning(0.0), 1, ElementReason::Reach, Element::Main),
        (leaning(4.9), 1, ElementReason::Reach, Element::Main),
        (leaning(6.0), 1, ElementReason::Back, Element::Additional),
    ] {
        let (classes, _) = judged(&drawn);
        assert_eq!((classes[surface].ground, classes[surface].element), (ground, element), "{:?}", classes[surface]);
    }
}

/// 12.1-4 for other tools by theirs: φ = 45° makes neither an upright face nor the cylinder before it; φ1 = 50° falls by 45°,
/// φ1 = 44° does not.
#[test]
fn another_tool_has_other_main_elements() {
    let tool = |main, secondary| Angles { main: Degrees(main), secondary: Degrees(secondary), hand: Hand::Right };
    let classes = classify(&leaning(0.0).profile, tool(45.0, 45.0), knowledge()).unwrap();
    assert_eq!(grounds(&classes), [ElementReason::Corner, ElementReason::Rise, ElementReason::Reach]);
    assert!(classes[0].partly && classes[1].tool == "other-main-angle");
    let classes = classify(&falling(45.0).profile, tool(95.0, 50.0), knowledge()).unwrap();
    assert!(classes.iter().all(|class| class.element == Element::Main));
    let narrow = tool(95.0, 44.0);
    assert_eq!(classify(&falling(45.0).profile, narrow, knowledge()).unwrap()[1].ground, ElementReason::Fall);
}

/// The reason names the angle of the element and that of the tool.
#[test]
fn a_class_says_which_angle_stands_against_which() {
    let (classes, _) = judged(&falling(45.0));
    let text = Lang::EN.say(&classes[1].because.note);
    assert_eq!(text, "outer 2: it falls 45°, steeper than φ1 = 30°; tool: contouring tool with a larger φ1");
    let text = Lang::UK.say(&classes[1].because.note);
    assert_eq!(text, "зовн. 2: спад 45° крутіший за φ1 = 30°; інструмент: контурний різець з більшим φ1");
    assert_eq!(classes[1].because.table, "turning-element");
}

/// 12.1-12: grooves, reliefs and threads are additional by kind, and what tool they require. 12.1-14: they are bridged:
/// a groove in a cylinder by the cylinder, a relief at a shoulder by cylinder and face to their corner, a face groove
/// by the face; a thread stays.
#[test]
fn additional_kinds_are_bridged_as_the_lips_go_on() {
    let drawn = Drawn::from(20.0, 0.0).to(Thread, 20.0, 10.0).to(Cylinder, 20.0, 15.0);
    let drawn = drawn.groove(RectangularGroove, &[(17.0, 15.0), (17.0, 19.0), (20.0, 19.0)]).to(Cylinder, 20.0, 29.0);
    let relief = [(19.5, 29.5), (19.5, 30.5), (20.5, 30.5), (21.0, 30.0)];
    let drawn = drawn.groove(GrindingRelief, &relief).to(Face, 30.0, 30.0);
    let drawn = drawn.groove(FaceGroove, &[(30.0, 34.0), (35.0, 34.0), (35.0, 30.0)]).to(Face, 40.0, 30.0);
    let (classes, main) = judged(&drawn.to(Cylinder, 40.0, 50.0));
    let tools: Vec<&str> =
        classes.iter().filter(|one| one.ground == ElementReason::Kind).map(|one| one.tool.as_str()).collect();
    assert_eq!(tools, ["threading", "grooving", "relief-grooving", "face-grooving"]);
    assert_eq!(corners(&main), [at(20.0, 0.0), at(20.0, 30.0), at(40.0, 30.0), at(40.0, 50.0)]);
    let lips: Vec<(Point, Point)> = main.valleys.iter().map(|valley| valley.lips).collect();
    let wanted = [(at(20.0, 15.0), at(20.0, 19.0)), (at(20.0, 29.0), at(21.0, 30.0)), (at(30.0, 30.0), at(35.0, 30.0))];
    assert_eq!(lips, wanted);
    assert_eq!(main.valleys[1].bridge.len(), 2, "cylinder and face to their corner");
    assert_eq!(main.valleys[0].surfaces, [2]);
}

/// 12.1-14: a groove in a cone that falls by 20° is bridged by the cone, though the far lip lies lower.
#[test]
fn a_groove_in_a_falling_cone_is_bridged_by_the_cone() {
    // tan = 0.4: 21.8°. Down by 4 over 10, groove of 5 long, then down by 4 over 10 again.
    let drawn = Drawn::from(20.0, 0.0).to(Cone, 16.0, 10.0);
    let drawn = drawn.groove(RectangularGroove, &[(10.0, 10.0), (10.0, 15.0), (14.0, 15.0)]).to(Cone, 10.0, 25.0);
    let (classes, main) = judged(&drawn.to(Face, 30.0, 25.0));
    assert_eq!(
        grounds(&classes),
        [ElementReason::Reach, ElementReason::Kind, ElementReason::Reach, ElementReason::Reach]
    );
    assert_eq!(corners(&main), [at(20.0, 0.0), at(16.0, 10.0), at(14.0, 15.0), at(10.0, 25.0), at(30.0, 25.0)]);
}

/// 12.1-13: a valley drawn as plain surfaces is additional with its floor and its walls. Ø50, down to Ø40: the shadow of the
/// wall is 5 / tan 30° = 8.66 mm long, so a floor of 3 mm is grooved and one of 30 mm is not.
#[test]
fn a_valley_in_whose_shadow_the_tool_cannot_come_is_additional_with_its_walls() {
    let neck = |length: f64| {
        let drawn = Drawn::from(25.0, 0.0).to(Cylinder, 25.0, 10.0).to(Face, 20.0, 10.0);
        drawn.to(Cylinder, 20.0, 10.0 + length).to(Face, 25.0, 10.0 + length).to(Cylinder, 25.0, 60.0)
    };
    for (length, grounds_wanted, tool) in [
        (
            3.0,
            [
                ElementReason::Reach,
                ElementReason::Fall,
                ElementReason::Shadow,
                ElementReason::Shadow,
                ElementReason::Reach,
            ],
            "grooving",
        ),
        (
            30.0,
            [
                ElementReason::Reach,
                ElementReason::Fall,
                ElementReason::Shadow,
                ElementReason::Valley,
                ElementReason::Reach,
            ],
            "other-hand",
        ),
    ] {
        let (classes, main) = judged(&neck(length));
        assert_eq!(grounds(&classes), grounds_wanted);
        assert!(classes[1..4].iter().all(|class| class.tool == tool && class.element == Element::Additional));
        assert_eq!(classes[2].partly, length > 8.67);
        assert_eq!(corners(&main), [at(25.0, 0.0), at(25.0, 60.0)], "one cylinder");
        assert_eq!(main.valleys[0].under.len(), 3);
    }
}

/// 12.1-13: an arc may be main in one part only; then the whole of it is additional, and a note says so. A ball of radius 10
/// falls away from level to upright: up to 30° it would be main.
#[test]
fn an_arc_that_is_main_in_part_is_additional_as_a_whole() {
    let drawn = Drawn::from(20.0, 0.0).to(Cylinder, 20.0, 10.0).arc(Ball, (10.0, 20.0), 10.0, Turn::Right);
    let (classes, main) = judged(&drawn.to(Cylinder, 10.0, 40.0).to(Face, 30.0, 40.0).to(Cylinder, 30.0, 50.0));
    assert_eq!((classes[1].ground, classes[1].partly), (ElementReason::Fall, true));
    assert!((classes[1].fall.0 - 90.0).abs() < 0.01);
    assert_eq!(classes[1].notes[0].code(), "element-partly");
    assert_eq!(corners(&main), [at(20.0, 0.0), at(20.0, 40.0), at(30.0, 40.0), at(30.0, 50.0)]);
}

/// A face groove drawn as plain surfaces, and an undercut face: what leads back is additional, and roughing goes upright.
#[test]
fn what_leads_back_is_bridged_upright() {
    let drawn = Drawn::from(10.0, 0.0).to(Cylinder, 10.0, 20.0).to(Face, 15.0, 20.0).to(Cylinder, 15.0, 24.0);
    let drawn = drawn.to(Face, 20.0, 24.0).to(Cylinder, 20.0, 20.0).to(Face, 30.0, 20.0).to(Cylinder, 30.0, 40.0);
    let (classes, main) = judged(&drawn);
    assert_eq!(
        grounds(&classes),
        [
            ElementReason::Reach,
            ElementReason::Reach,
            ElementReason::Back,
            ElementReason::Back,
            ElementReason::Back,
            ElementReason::Reach,
            ElementReason::Reach
        ]
    );
    assert!(classes[2..5].iter().all(|class| class.tool == "face-grooving"));
    assert_eq!(corners(&main), [at(10.0, 0.0), at(10.0, 20.0), at(30.0, 20.0), at(30.0, 40.0)]);
    // Leaning back by 4.9° is main, but roughing goes upright from the lip.
    let (_, main) = judged(&leaning(4.9));
    let lip = leaning(4.9).profile.surfaces[1].pieces[0].to;
    assert_eq!(corners(&main), [at(10.0, 0.0), Point::new(at(10.0, 0.0).radius, lip.z), lip, at(20.0, 40.0)]);
}

/// 12.3-2: what falls behind the largest diameter and never rises again is for the other side; the ball is divided at its
/// equator.
#[test]
fn behind_the_largest_radius_the_other_set_up_begins() {
    let drawn = Drawn::from(10.0, 0.0).to(Cylinder, 10.0, 20.0).to(Face, 30.0, 20.0).to(Cylinder, 30.0, 30.0);
    let drawn = drawn.to(Face, 15.0, 30.0).to(Cylinder, 15.0, 50.0).to(Face, 0.0, 50.0);
    let (classes, main) = judged(&drawn);
    assert!(classes[3..].iter().all(|class| class.element == Element::OtherSide && class.tool == "other-set-up"));
    assert_eq!(corners(&main), [at(10.0, 0.0), at(10.0, 20.0), at(30.0, 20.0), at(30.0, 50.0)]);
    let (near, far) = split(&drawn.profile, &classes, Angles::CONTOURING).unwrap();
    assert_eq!((near.surfaces.len(), far.surfaces.len()), (3, 3));
    let ball = Drawn::from(0.0, 0.0).arc(Ball, (0.0, 40.0), 20.0, Turn::Right);
    let classes = classify(&ball.profile, Angles::CONTOURING, knowledge()).unwrap();
    let (near, far) = split(&ball.profile, &classes, Angles::CONTOURING).unwrap();
    assert_eq!(near.contour().end(), Some(at(20.0, 20.0)));
    assert_eq!(far.contour().start(), Some(at(20.0, 20.0)));
}

/// One item of a random contour: what, how far out, how far on.
fn items() -> impl Strategy<Value = Vec<(u8, i32, u32)>> {
    prop::collection::vec((0_u8..7, 1..12_i32, 1..12_u32), 1..12)
}

/// A contour that does not cross itself: items one behind the other.
fn drawn(items: &[(u8, i32, u32)]) -> Drawn {
    let mut drawn = Drawn::from(30.0, 0.0);
    for (kind, out, on) in items {
        let (radius, z) = (drawn.here.radius.to_mm(), drawn.here.z.to_mm());
        let (out, on) = (f64::from(*out), f64::from(*on));
        let down = (radius - out).max(2.0);
        drawn = match kind {
            0 => drawn.to(Cylinder, radius, z + on),
            1 => drawn.to(Face, radius + out, z),
            2 if down < radius => drawn.to(Face, down, z),
            3 => drawn.to(Cone, radius + out, z + on),
            4 if down < radius => drawn.to(Cone, down, z + on),
            5 => drawn.arc(Fillet, (radius + out, z + out), out, Turn::Left),
            6 if down < radius => {
                let by = radius - down;
                drawn.arc(Ball, (down, z + by), by, Turn::Right)
            }
            _ => drawn.groove(RectangularGroove, &[(radius - 1.5, z), (radius - 1.5, z + on), (radius, z + on)]),
        };
    }
    drawn
}

/// The same contour as a bore: radii count inwards from `top`.
fn as_bore(profile: &Profile, top: Half) -> Profile {
    let surfaces = profile.surfaces.iter().map(|surface| {
        let contour = Contour { side: Side::Outer, pieces: surface.pieces.clone() }.inside_out(top);
        Surface { pieces: contour.pieces, ..surface.clone() }
    });
    Profile { side: Side::Inner, surfaces: surfaces.collect() }
}

fn over(profile: &Profile, length: Half) -> Profile {
    let surfaces = profile.surfaces.iter().rev().map(|surface| {
        let contour = Contour { side: profile.side, pieces: surface.pieces.clone() }.turned_over(length);
        Surface { pieces: contour.pieces, ..surface.clone() }
    });
    Profile { side: profile.side, surfaces: surfaces.collect() }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(256))]

    /// 12.1-14. The main contour hangs together, is monotone, begins where the part begins, and is nowhere below it; along it
    /// nothing falls more steeply than φ1.
    #[test]
    fn the_main_contour_is_monotone_and_never_below_the_part(items in items(), flat in 10..60_u32) {
        let drawn = drawn(&items);
        let tool = Angles { secondary: Degrees(f64::from(flat)), ..Angles::CONTOURING };
        let classes = classify(&drawn.profile, tool, knowledge()).unwrap();
        let main = main_contour(&drawn.profile, &classes, tool);
        prop_assert!(main.contour.hangs_together(), "{:?}", main.contour);
        prop_assert!(main.contour.is_monotone(), "{:?}", main.contour);
        let part = drawn.profile.contour();
        // What only falls away upright has no main contour.
        prop_assume!(part.start().unwrap().z < part.end().unwrap().z);
        prop_assert_eq!(main.contour.start(), part.start());
        let (from, to) = (part.start().unwrap().z.halves(), part.end().unwrap().z.halves());
        for step in 0..=200 {
            let z = Half::new(from + (to - from) * step / 200);
            if let (Some((_, part)), Some((_, main))) = (part.radii_at(z), main.contour.radii_at(z)) {
                prop_assert!(main + Half::new(4) >= part, "at {z}: {main} < {part}");
            } else {
                prop_assert!(part.radii_at(z).is_none(), "no main contour at {z}");
            }
        }
        let steep = libm::tan(f64::from(flat).to_radians());
        for piece in main.contour.pieces.iter().filter(|piece| piece.curve == Curve::Line) {
            let chord = piece.chord();
            prop_assert!(-chord.radius <= chord.z * steep + 0.002, "{piece:?}");
        }
    }

    /// 12.1-14: a bore is judged as the same contour inside out.
    #[test]
    fn a_bore_is_judged_like_the_same_contour_outside(items in items()) {
        let outside = drawn(&items).profile;
        let top = outside.contour().radii().unwrap().1 + Half::from(5.0);
        let bore = as_bore(&outside, top);
        let judge = |profile: &Profile| classify(profile, Angles::CONTOURING, knowledge()).unwrap();
        let shown = |classes: Vec<Class>| -> Vec<_> {
            classes.into_iter().map(|one| (one.ground, one.element, one.partly, one.tool)).collect()
        };
        prop_assert_eq!(shown(judge(&outside)), shown(judge(&bore)));
        let main = |profile: &Profile| main_contour(profile, &judge(profile), Angles::CONTOURING).contour;
        prop_assert_eq!(main(&outside), main(&bore).inside_out(top));
    }

    /// A tool of the other hand judges the part as its own hand judges it turned over.
    #[test]
    fn the_other_hand_sees_the_mirror_image(items in items()) {
        let profile = drawn(&items).profile;
        let length = profile.contour().end().unwrap().z;
        let left = Angles { hand: Hand::Left, ..Angles::CONTOURING };
        let mut mirrored = classify(&over(&profile, length), Angles::CONTOURING, knowledge()).unwrap();
        mirrored.reverse();
        let direct = classify(&profile, left, knowledge()).unwrap();
        prop_assert_eq!(grounds(&direct), grounds(&mirrored));
    }

    /// A split divides the pieces and loses none; what is for the other set-up begins no lower than it goes on.
    #[test]
    fn a_split_loses_nothing(items in items()) {
        let profile = drawn(&items).profile;
        let classes = classify(&profile, Angles::CONTOURING, knowledge()).unwrap();
        let length = |profile: &Profile| -> f64 { profile.contour().pieces.iter().map(|piece| piece.length_mm()).sum() };
        if let Some((near, far)) = split(&profile, &classes, Angles::CONTOURING) {
            prop_assert!((length(&near) + length(&far) - length(&profile)).abs() < 0.02);
            let lip = far.contour().start().unwrap();
            prop_assert!(far.contour().radii().unwrap().1 <= lip.radius + Half::new(2));
            if let Some(end) = near.contour().end() {
                prop_assert_eq!(end, lip);
            }
        }
    }
}
