//! The schemes of rough transitions: the lecture's orders of points, figures by hand, and laws compared with a section
//! of columns that knows nothing of how the ways are made (`crates/testing/src/section.rs`).

use proptest::prelude::*;
use technolog::error::{Refusal, Tried};
use technolog::turning::contour::{Contour, Curve, Piece, Side, Turn};
use technolog::turning::length::Half;
use technolog::turning::toolpath::{Purpose, Toolpath};
use technolog::turning::transitions::builder::SupportPointRole;
use technolog::turning::transitions::check::Unsuited;
use technolog::turning::transitions::measures::best;
use technolog::turning::transitions::{PreparedZone, Scheme, Settings, Stock, Transition, finishing_must_follow, work};
use technolog_testing::section::{ROUNDING, at, mm, settings, simulate, steps, steps_beside, tool, valleys, zones};
use technolog_testing::{KNOWLEDGE, section};

fn tried(stock: &Stock, settings: &Settings, scheme: Scheme, nose: f64) -> Tried<Transition, Unsuited> {
    work(stock, &tool(nose), settings, scheme, &steps_beside, &KNOWLEDGE)
}

/// The surface that a transition leaves; tool and depth do not change it.
fn left(stock: &Stock, found: &Transition) -> Contour {
    PreparedZone::of(stock, &tool(0.8), &settings(1.0)).unwrap().left(found)
}

fn made(stock: &Stock, depth: f64, scheme: Scheme, nose: f64) -> Transition {
    tried(stock, &settings(depth), scheme, nose).unwrap_or_else(|refusal| panic!("{refusal:?}"))
}

fn names(transition: &Transition) -> String {
    transition.points.iter().map(|point| point.name.as_str()).collect::<Vec<_>>().join("-")
}

fn under_bar(rough: Contour, radius: f64) -> Stock {
    let (from, to) = (rough.start().unwrap(), rough.end().unwrap());
    let blank = Contour::through(Side::Outer, &[at(radius, from.z.to_mm()), at(radius, to.z.to_mm())]);
    Stock { rough, blank, from: from.z, to: to.z }
}

/// The half-open zone that fig. 12.4 a must show, so that the levels 28, 26, 24 and 22 of a bar of radius 30 give the
/// points of the lecture: the fourth level only touches the beginning of a cone, the third ends on that cone (9), behind
/// it come its end and a cylinder (10, 11), the second level ends on the next cone (6), which ends at 7, the first on the
/// last cone (2), which comes out of the bar at 3.
fn figure_a() -> Stock {
    let points = [at(22.0, 0.0), at(25.0, 6.0), at(25.0, 12.0), at(27.0, 16.0), at(30.0, 19.0)];
    under_bar(Contour::through(Side::Outer, &points), 30.0)
}

/// 12.4-14 (l. 372-376): 0–1–2–3–4–5–6–7–2–1–8–9–10–11–6–5–12–9–0. Ours has one point more: 12 lies before the metal by
/// the approach, and the beginning of the contour (13) comes before 9.
#[test]
fn pick_up_visits_the_points_of_the_lecture() {
    let found = made(&figure_a(), 2.0, Scheme::PickUp, 0.0);
    assert_eq!(names(&found), "0-1-2-3-4-5-6-7-2-1-8-9-10-11-6-5-12-13-9-0");
}

/// 12.4-15 (l. 376-390): the main feed on 1–2, 5–6, 8–9, the feed of picking up on 2–3, 6–7–2, 9–10–11–6.
#[test]
fn pick_up_has_the_two_feeds_of_the_lecture() {
    let found = made(&figure_a(), 2.0, Scheme::PickUp, 0.0);
    let of = |purpose: Purpose| -> Vec<String> {
        let ends = found.points.iter().zip(found.points.iter().skip(1)).filter(|(_, to)| to.purpose == Some(purpose));
        ends.map(|(from, to)| format!("{}-{}", from.name, to.name)).collect()
    };
    assert_eq!(of(Purpose::Cut), ["1-2", "5-6", "8-9"]);
    assert_eq!(of(Purpose::PickUp), ["2-3", "6-7", "7-2", "9-10", "10-11", "11-6", "12-13", "13-9"]);
    assert!(found.uniform, "12.4-16 (l. 354-356): what is left is even");
}

/// 12.4-17 (l. 394-404): beyond 2, 6 and 9 by half the nose radius along the contour: 0.8 / 2 = 0.4 mm. At 3 the contour
/// ends. On the cone of 45° from 28 that is 0.4·√½ = 0.2828 both ways.
#[test]
fn pick_up_goes_on_by_half_the_nose_radius() {
    let found = made(&figure_a(), 2.0, Scheme::PickUp, 0.8);
    let over: Vec<f64> = found
        .path
        .pieces()
        .zip(found.points.iter().skip(1))
        .filter(|(_, to)| to.role == SupportPointRole::Overrun)
        .map(|((piece, _), _)| piece.length_mm())
        .collect();
    assert_eq!(over.len(), 3);
    assert!(over.iter().all(|length| (length - 0.4).abs() < 0.001), "{over:?}");
    let first = found.points.iter().find(|point| point.role == SupportPointRole::Overrun).unwrap();
    assert_eq!((first.diameter_mm.to_string().as_str(), first.z_mm), ("56.566", mm(-17.283)));
}

/// The zone that fig. 12.4 b must show: the fourth level is the first cylinder (13-14), the third ends on its shoulder
/// (10), below the corner 15; the second is the second cylinder and ends at the foot of the wall (6), the first ends on
/// the wall (2), which comes out of the bar at 16. 12.4-18 (l. 418-420):
/// 0–1–2–3–4–5–6–7–8–9–10–11–12–13–14–10–15–6–2–16–0.
#[test]
fn semi_finishing_visits_the_points_of_the_lecture() {
    let points = [at(22.0, 0.0), at(22.0, 10.0), at(26.0, 10.0), at(26.0, 20.0), at(30.0, 20.0)];
    let found = made(&under_bar(Contour::through(Side::Outer, &points), 30.0), 2.0, Scheme::SemiFinishing, 0.8);
    assert_eq!(names(&found), "0-1-2-3-4-5-6-7-8-9-10-11-12-13-14-10-15-6-2-16-0");
    let last: Vec<_> = found.points.iter().filter(|point| point.purpose == Some(Purpose::SemiFinish)).collect();
    assert_eq!(last.iter().map(|point| point.name.as_str()).collect::<Vec<_>>(), ["10", "15", "6", "2", "16"]);
}

/// 12.4-20 (l. 438-440): 0–1–2–3–4–5–6–7–4–8–9–10–0: three passes of two pieces, each return to one point. The contour is
/// a cylinder of 20 and a hollow of radius 15 about (35, 20); beside it by d that is a cylinder of 20 + d and a hollow of
/// 15 − d. A bar of radius 35: the passes are at 10, 5 and 0.
#[test]
fn equidistant_visits_the_points_of_the_lecture() {
    let hollow = |by: f64| {
        let mut contour = Contour::through(Side::Outer, &[at(20.0 + by, 0.0), at(20.0 + by, 20.0)]);
        contour.pieces.push(Piece::arc(at(20.0 + by, 20.0), at(35.0, 35.0 - by), mm(15.0 - by), Turn::Left));
        contour
    };
    let offset = |_: &Contour, distance: Half| Some(hollow(distance.to_mm())).filter(|_| distance.to_mm() < 15.0);
    let stock = under_bar(hollow(0.0), 35.0);
    // At 15 the hollow is a point: the pass lies on the surface of the bar.
    let offset = |contour: &Contour, distance: Half| {
        offset(contour, distance).or_else(|| Some(Contour::through(Side::Outer, &[at(35.0, 0.0), at(35.0, 20.0)])))
    };
    let found = work(&stock, &tool(0.8), &settings(5.0), Scheme::Equidistant, &offset, &KNOWLEDGE).unwrap();
    assert_eq!(names(&found), "0-1-2-3-4-5-6-7-4-8-9-10-0");
    let arcs: Vec<Half> = found.path.moves.iter().filter_map(|one| radius_of(one.curve)).collect();
    assert_eq!(arcs, [mm(5.0), mm(10.0), mm(15.0)], "arcs stay arcs");
    assert!(found.uniform);
}

/// 12.4-21 (l. 442-458): 0–1–…–20–0: four closed cycles of five points. The forging stands 8 mm over a cylinder of 20
/// and a cone to 28; each cycle is start, corner, end, up, back over the start.
#[test]
fn contour_visits_the_points_of_the_lecture() {
    let line = |by: f64| Contour::through(Side::Outer, &[at(20.0 + by, 0.0), at(20.0 + by, 20.0), at(28.0 + by, 36.0)]);
    let stock = Stock { rough: line(0.0), blank: line(8.0), from: mm(0.0), to: mm(36.0) };
    let found = made(&stock, 2.0, Scheme::Contour, 0.8);
    let expected: Vec<String> = (0..=20).chain([0]).map(|number| number.to_string()).collect();
    assert_eq!(names(&found), expected.join("-"));
    let cycle: Vec<SupportPointRole> = found.points.iter().skip(1).take(5).map(|point| point.role).collect();
    assert_eq!(
        cycle,
        [
            SupportPointRole::Start,
            SupportPointRole::Corner,
            SupportPointRole::ContourEnd,
            SupportPointRole::Clear,
            SupportPointRole::Returned
        ]
    );
}

/// Where the blank has stock on its faces too, the line of the cycles leads aslant (l. 446-450): the forging stands 3 mm
/// over the cylinders and 1.5 mm before the face, so each cycle of 1 mm is 0.5 mm nearer to the free end.
#[test]
fn the_line_of_the_cycles_is_that_of_the_allowance() {
    let rough = Contour::through(Side::Outer, &[at(20.0, 0.0), at(20.0, 30.0), at(30.0, 30.0), at(30.0, 50.0)]);
    let blank = Contour::through(Side::Outer, &[at(23.0, 0.0), at(23.0, 28.5), at(33.0, 28.5), at(33.0, 50.0)]);
    let stock = Stock { rough, blank, from: mm(0.0), to: mm(50.0) };
    let found = made(&stock, 1.0, Scheme::Contour, 0.8);
    assert_eq!(found.measures.passes, 3);
    let corners: Vec<_> = found
        .points
        .iter()
        .filter(|point| {
            point.role == SupportPointRole::Corner && point.diameter_mm < technolog::units::Micrometres::from_mm(50)
        })
        .collect();
    let z: Vec<Half> = corners.iter().map(|point| point.z_mm).collect();
    assert_eq!(z, [mm(-29.0), mm(-29.5), mm(-30.0)]);
    assert!(found.uniform);
}

/// 12.4-22 (l. 314-318), by hand: a bar of radius 30 over a cylinder of 26 and 40 mm, t_p 2: cut, off by 0.5 on both axes,
/// back to 2 mm before the metal, down, cut, off, home.
#[test]
fn the_loop_draws_back_half_a_millimetre() {
    let found =
        made(&under_bar(Contour::through(Side::Outer, &[at(26.0, 0.0), at(26.0, 40.0)]), 30.0), 2.0, Scheme::Loop, 0.8);
    let shown: Vec<_> =
        found.points.iter().map(|point| (point.role, point.diameter_mm.to_string(), point.z_mm.to_mm())).collect();
    let of = |role, diameter: &str, z| (role, diameter.to_owned(), z);
    let expected = [
        of(SupportPointRole::Home, "64", 2.0),
        of(SupportPointRole::Start, "56", 2.0),
        of(SupportPointRole::End, "56", -40.0),
        of(SupportPointRole::Retracted, "57", -39.5),
        of(SupportPointRole::Returned, "57", 2.0),
        of(SupportPointRole::Start, "52", 2.0),
        of(SupportPointRole::End, "52", -40.0),
        of(SupportPointRole::Retracted, "53", -39.5),
        of(SupportPointRole::Home, "64", 2.0),
    ];
    assert_eq!(shown, expected);
    assert!(found.uniform, "12.4-23 (l. 490-494): over an open zone the loop leaves it even");
    // By hand: 2·40 in metal, 2·2 before it; rapids 4, √½, 41.5, 2.5, √½, and 41.5 along and 5.5 across at once.
    let measures = found.measures;
    assert_eq!((measures.cutting_mm, measures.beside_mm, measures.passes, measures.returns), (80.0, 4.0, 2, 1));
    let rapids = 4.0 + 0.5_f64.sqrt() * 2.0 + 41.5 + 2.5 + 41.5_f64.hypot(5.5);
    assert!((measures.rapid_mm - rapids).abs() < 0.001, "{measures:?}");
    let minutes = 84.0 / 180.0 + (4.0 + 0.5 + 41.5 + 2.5 + 0.5 + 41.5) / 6000.0;
    assert!((measures.time_min.0 - minutes).abs() < 0.0001, "{measures:?}");
}

/// 12.4-24 (l. 320-324): against a stop each pass goes at the full depth to the shoulder of a step. Steps 20, 25, 29 under
/// a bar of 30, t_p 2: 29 over all, then 27 and 25 to the second shoulder, then 23, 21 and 20 to the first.
#[test]
fn against_a_stop_each_step_is_finished_at_its_shoulder() {
    let points = [at(20.0, 0.0), at(20.0, 10.0), at(25.0, 10.0), at(25.0, 25.0), at(29.0, 25.0), at(29.0, 45.0)];
    let stock = under_bar(Contour::through(Side::Outer, &points), 30.0);
    let found = made(&stock, 2.0, Scheme::LoopAgainstStop, 0.8);
    let ends = found.points.iter().filter(|point| point.role == SupportPointRole::End);
    let shown: Vec<_> = ends.map(|point| (point.diameter_mm.to_string(), point.z_mm.to_mm())).collect();
    let expected = [("58", -45.0), ("54", -25.0), ("50", -25.0), ("46", -10.0), ("42", -10.0), ("40", -10.0)];
    assert_eq!(shown, expected.map(|(diameter, z)| (diameter.to_owned(), z)));
    assert!(found.uniform);
    let loose = made(&stock, 2.0, Scheme::Loop, 0.8);
    assert_eq!(loose.ridges_mm, mm(1.0), "without stops 26 - 25 = 1 mm stays over the second step");
    // And all of the bar over the third, whose 1 mm no level reaches.
    let stands = [at(20.0, 0.0), at(20.0, 10.0), at(26.0, 10.0), at(26.0, 25.0), at(30.0, 25.0), at(30.0, 45.0)];
    assert_eq!(left(&stock, &loose).corners(), stands);
}

/// 12.4-25 (l. 326-330): the zigzag cuts there and back, and goes down along the contour at both ends.
#[test]
fn the_zigzag_cuts_both_ways() {
    let points = [at(30.0, 0.0), at(26.0, 8.0), at(26.0, 20.0), at(30.0, 28.0)];
    let found = made(&under_bar(Contour::through(Side::Outer, &points), 30.0), 2.0, Scheme::Zigzag, 0.8);
    let shown: Vec<_> = found
        .points
        .iter()
        .skip(1)
        .map(|point| (point.purpose.unwrap(), point.diameter_mm.to_string(), point.z_mm.to_mm()))
        .collect();
    let of = |purpose, diameter: &str, z| (purpose, diameter.to_owned(), z);
    let expected = [
        of(Purpose::Rapid, "64", 0.0),
        of(Purpose::Rapid, "61", 0.0),
        of(Purpose::Infeed, "60", 0.0),
        of(Purpose::Infeed, "56", -4.0),
        of(Purpose::Cut, "56", -24.0),
        of(Purpose::Infeed, "52", -20.0),
        of(Purpose::Cut, "52", -8.0),
        of(Purpose::Rapid, "64", -8.0),
        of(Purpose::Rapid, "64", 2.0),
    ];
    assert_eq!(shown, expected);
    // The ridge of the second level is gone, that of the first stays on the far flank: 30 - 28.
    assert_eq!(found.ridges_mm, mm(2.0));
}

/// 12.4-26 (l. 330-334): the descent goes down across the axis, slice by slice, here in a closed zone of upright walls
/// 10 mm apart with slices of 4 mm: at 4, at 7 and at 10 mm of it.
#[test]
fn the_descent_goes_down_slice_by_slice() {
    let points = [at(30.0, 0.0), at(30.0, 5.0), at(22.0, 5.0), at(22.0, 15.0), at(30.0, 15.0), at(30.0, 20.0)];
    let found = made(&under_bar(Contour::through(Side::Outer, &points), 30.0), 4.0, Scheme::Descent, 0.0);
    let cuts: Vec<_> =
        found.path.pieces().filter(|(_, purpose)| *purpose == Purpose::Cut).map(|(piece, _)| piece).collect();
    assert!(cuts.iter().all(|cut| cut.is_face() && cut.to.radius == mm(22.0)), "{cuts:?}");
    assert_eq!(cuts.iter().map(|cut| cut.to.z.to_mm()).collect::<Vec<_>>(), [9.0, 12.0, 15.0]);
    assert_eq!((found.ridges_mm, found.edge), (Half::ZERO, Some(mm(4.0))));
}

/// 12.4-19 (l. 468-478): in a closed zone the tool returns along its contour, at the feed of cutting in, to where the pass
/// began; no rapid goes before the last pass is done.
#[test]
fn in_closed_zones_the_tool_returns_along_the_contour() {
    let points = [at(30.0, 0.0), at(24.0, 12.0), at(24.0, 20.0), at(30.0, 32.0)];
    let stock = under_bar(Contour::through(Side::Outer, &points), 30.0);
    for scheme in [Scheme::PickUp, Scheme::SemiFinishing] {
        let found = made(&stock, 2.0, scheme, 0.0);
        let purposes: Vec<Purpose> = found.path.moves.iter().map(|one| one.purpose).collect();
        let fed = purposes.iter().position(|purpose| *purpose != Purpose::Rapid).unwrap();
        let last = purposes.iter().rposition(|purpose| *purpose != Purpose::Rapid).unwrap();
        assert!(!purposes[fed..=last].contains(&Purpose::Rapid), "{scheme:?} {purposes:?}");
        let cuts: Vec<usize> = (0..purposes.len()).filter(|index| purposes[*index] == Purpose::Cut).collect();
        assert_eq!(cuts.len(), 3);
        for pair in cuts.windows(2) {
            let began = found.path.pieces().nth(pair[0]).unwrap().0.from;
            let back = (pair[0]..pair[1]).rfind(|index| purposes[*index] == Purpose::Return).unwrap();
            assert_eq!(found.path.moves[back].to, began, "{scheme:?}");
            assert!(purposes[back + 1..pair[1]].iter().all(|purpose| *purpose == Purpose::Infeed));
        }
        assert!(found.uniform);
    }
}

/// 12.4-27 (l. 392-394): pick-up may be the last scheme up to Rz 40; for a finer surface finishing must follow.
#[test]
fn pick_up_is_the_last_up_to_rz_40() {
    let follows =
        |scheme, roughness: &str| finishing_must_follow(scheme, roughness.parse().unwrap(), &KNOWLEDGE).unwrap();
    assert_eq!(follows(Scheme::PickUp, "Rz 40"), None);
    assert_eq!(follows(Scheme::PickUp, "Rz 80"), None);
    assert_eq!(follows(Scheme::PickUp, "Rz 20").unwrap().note.code(), "finishing-must-follow");
    assert_eq!(follows(Scheme::SemiFinishing, "Rz 20"), None, "the lecture gives no limit");
}

/// What the room refuses, and by which reason.
#[test]
fn what_cannot_be_worked_is_refused() {
    let stock = figure_a();
    let code = |stock: &Stock, settings: &Settings, scheme| match tried(stock, settings, scheme, 0.8) {
        Err(Refusal::Not(why)) => why.note().code().to_owned(),
        other => panic!("{other:?}"),
    };
    let good = settings(2.0);
    assert_eq!(code(&stock, &Settings { depth: Half::ZERO, ..good }, Scheme::Loop), "zone-settings-not-positive");
    assert_eq!(code(&stock, &good, Scheme::LoopAgainstStop), "stop-needs-steps");
    assert_eq!(code(&Stock { to: mm(18.0), ..stock.clone() }, &good, Scheme::Loop), "zone-contours-differ");
    let low = Contour::through(Side::Outer, &[at(26.0, 0.0), at(26.0, 19.0)]);
    assert_eq!(code(&Stock { blank: low, ..stock.clone() }, &good, Scheme::Loop), "rough-above-blank");
    let back = Contour::through(Side::Outer, &[at(20.0, 0.0), at(20.0, 12.0), at(21.0, 11.0), at(21.0, 19.0)]);
    assert_eq!(code(&Stock { rough: back, ..stock.clone() }, &good, Scheme::Loop), "zone-contour-not-monotone");
    let falls = Contour::through(Side::Outer, &[at(30.0, 0.0), at(24.0, 5.0), at(24.0, 19.0)]);
    let fallen = under_bar(falls, 30.0);
    let mut narrow = tool(0.8);
    narrow.secondary = technolog::units::Degrees(30.0);
    let refused = work(&fallen, &narrow, &good, Scheme::Loop, &steps_beside, &KNOWLEDGE);
    // atan(6/5) = 50.19°.
    let Err(Refusal::Not(why)) = refused else { panic!() };
    let note = why.note();
    assert_eq!((note.code(), note.figure_text("angle").as_deref()), ("flank-too-steep", Some("50.19")));
    let none = |_: &Contour, _: Half| None;
    let refused = work(&stock, &tool(0.8), &good, Scheme::Equidistant, &none, &KNOWLEDGE);
    assert!(matches!(refused, Err(Refusal::Not(Unsuited::NoEquidistant { .. }))));
}

fn radius_of(curve: Curve) -> Option<Half> {
    match curve {
        Curve::Arc { radius, .. } => Some(radius),
        Curve::Line => None,
    }
}

/// The schemes that leave nothing, whatever the zone.
const CLEAN: [Scheme; 2] = [Scheme::PickUp, Scheme::SemiFinishing];

/// What every way must keep: nothing below the rough contour, no rapid through metal, home again, no more left than is
/// told, arcs of the contour's radii only.
fn keeps_the_laws(stock: &Stock, found: &Transition) -> Result<section::Worked, TestCaseError> {
    let scheme = found.scheme;
    prop_assert_eq!(found.path.end(), found.path.from, "{:?} ends at home", scheme);
    prop_assert_eq!(found.points.len(), found.path.moves.len() + 1);
    let worked = simulate(stock, &found.path, found.edge);
    prop_assert!(worked.below < ROUNDING, "{:?} cuts {} mm below the contour", scheme, worked.below);
    prop_assert!(worked.hit < ROUNDING, "{:?}: a rapid goes {} mm into metal", scheme, worked.hit);
    let ridges = found.ridges_mm.to_mm();
    prop_assert!(worked.left < ridges + 2.0 * ROUNDING, "{:?} leaves {} mm, not {}", scheme, worked.left, ridges);
    let left = left(stock, found);
    // What is told to stand is what the columns say, to a hundredth. Near where an arc is upright rounding is more across.
    for ((z, height), (least, most)) in
        worked.columns.places.iter().zip(&worked.columns.heights).zip(&worked.columns.around)
    {
        // On a face it has more than one radius.
        if left.pieces.iter().any(|piece| piece.is_face() && (piece.from.z - *z).halves().abs() <= 1) {
            continue;
        }
        let stands = section::radius_at(&left, *z).unwrap_or(f64::NAN);
        let slack = 0.01 + 3.0 * (most - least);
        prop_assert!((stands - height).abs() <= slack, "{:?}: {} stands at {}, told {}", scheme, height, z, stands);
    }
    prop_assert!(left.hangs_together() && left.is_monotone());
    let radii: Vec<Half> = stock.rough.pieces.iter().filter_map(|piece| radius_of(piece.curve)).collect();
    if scheme != Scheme::Equidistant {
        let mut arcs = found.path.moves.iter().filter_map(|one| radius_of(one.curve));
        prop_assert!(arcs.all(|radius| radii.contains(&radius)), "{:?}: arcs stay arcs", scheme);
    }
    prop_assert!(found.path.pieces().all(|(piece, purpose)| purpose != Purpose::Rapid || piece.curve == Curve::Line));
    Ok(worked)
}

/// Every scheme for any zone over one: what every way must keep, and what each scheme promises.
fn the_laws_hold_over(stock: &Stock, depth: f64, nose: f64) -> Result<(), TestCaseError> {
    for scheme in
        [Scheme::Loop, Scheme::Zigzag, Scheme::Descent, Scheme::PickUp, Scheme::SemiFinishing, Scheme::Contour]
    {
        let found = made(stock, depth, scheme, nose);
        let worked = keeps_the_laws(stock, &found)?;
        if CLEAN.contains(&scheme) || scheme == Scheme::Contour {
            prop_assert!(found.uniform && worked.left < 2.0 * ROUNDING, "{:?} leaves {} mm", scheme, worked.left);
        }
        // A descent takes all of a slice at once; its slices are no wider than the depth. The line of contour passes
        // may lead aslant, then a face is cut by slices.
        if scheme != Scheme::Descent && scheme != Scheme::Contour {
            prop_assert!(worked.depth < depth + 2.0 * ROUNDING, "{:?} takes {} mm of {}", scheme, worked.depth, depth);
            prop_assert!(worked.left < depth + 2.0 * ROUNDING, "{:?} leaves {} mm of {}", scheme, worked.left, depth);
            // Where an arc ends upright, half a micrometre along the axis is √(2·r·0.0005) across it: 0.1 for 10 mm.
            prop_assert!(found.ridges_mm.to_mm() < depth + 0.1, "{:?} tells {} of {}", scheme, found.ridges_mm, depth);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(technolog_laws::cases!(150))]

    #[test]
    fn over_any_zone_the_ways_keep_the_laws(stock in zones(), depth in 0.7_f64..6.0, nose in 0.0_f64..2.0) {
        the_laws_hold_over(&stock, depth, nose)?;
    }

    /// The depth of an equidistant pass is measured square to the contour: no metal that it takes is farther from its way.
    #[test]
    fn equidistant_passes_take_no_more_than_the_depth(stock in steps(), depth in 0.7_f64..4.0) {
        let found = made(&stock, depth, Scheme::Equidistant, 0.8);
        let worked = keeps_the_laws(&stock, &found)?;
        prop_assert!(found.uniform && worked.left < 2.0 * ROUNDING);
        let mut columns = section::Columns::of(&stock, &found.path);
        let pieces: Vec<(Piece, Purpose)> = found.path.pieces().collect();
        for pass in pieces.split(|(_, purpose)| *purpose == Purpose::Rapid) {
            let points: Vec<(f64, f64)> = pass.iter().flat_map(|(piece, _)| sampled(piece)).collect();
            for (piece, _) in pass {
                for (index, was, _) in columns.cut(piece, None) {
                    let z = columns.places[index].to_mm();
                    let far = points.iter().map(|(x, r)| (x - z).hypot(r - was)).fold(f64::INFINITY, f64::min);
                    prop_assert!(far < depth + 0.03, "{} mm from the way of a pass of {}", far, depth);
                }
            }
        }
    }

    /// A bore is worked as an outer contour inside out.
    #[test]
    fn inner_ways_are_outer_ones_inside_out(stock in zones(), depth in 1.0_f64..6.0) {
        let top = stock.rough.radii().unwrap().0.min(stock.rough.radii().unwrap().0) + mm(200.0);
        let inner = Stock { rough: stock.rough.inside_out(top), blank: stock.blank.inside_out(top), ..stock.clone() };
        for scheme in [Scheme::Loop, Scheme::Zigzag, Scheme::Descent, Scheme::PickUp, Scheme::SemiFinishing, Scheme::Contour] {
            let (outer, bored) = (made(&stock, depth, scheme, 0.8), made(&inner, depth, scheme, 0.8));
            let place = |point: technolog::turning::point::Point| technolog::turning::point::Point { radius: top - point.radius, ..point };
            let mut turned = Toolpath::at(place(outer.path.from));
            for (piece, purpose) in outer.path.pieces() {
                turned.follow(piece.mapped(true, place), purpose);
            }
            prop_assert_eq!(bored.path.from, turned.from);
            prop_assert_eq!(bored.path.moves.len(), turned.moves.len(), "{:?}", scheme);
            for (one, other) in bored.path.moves.iter().zip(&turned.moves) {
                // A point of an arc that lies between two halves of a micrometre may be rounded to either.
                let near = |a: Half, b: Half| (a - b).halves().abs() <= 1;
                prop_assert!(near(one.to.radius, other.to.radius) && near(one.to.z, other.to.z), "{:?}", scheme);
                prop_assert_eq!((one.curve, one.purpose), (other.curve, other.purpose), "{:?}", scheme);
            }
            prop_assert!((bored.measures.time_min.0 - outer.measures.time_min.0).abs() < 0.001);
        }
    }

    /// 12.4-19 over any closed zone: between the first and the last motion at a feed there is no rapid, unless the last
    /// motion along the contour begins again.
    #[test]
    fn a_closed_zone_is_not_left_between_passes(stock in valleys(), depth in 0.7_f64..4.0) {
        for scheme in [Scheme::PickUp, Scheme::SemiFinishing] {
            let found = made(&stock, depth, scheme, 0.0);
            keeps_the_laws(&stock, &found)?;
            let purposes: Vec<Purpose> = found.path.moves.iter().map(|one| one.purpose).collect();
            let cut = |purpose: &Purpose| *purpose == Purpose::Cut;
            let (first, last) = (purposes.iter().position(cut), purposes.iter().rposition(cut));
            if let (Some(first), Some(last)) = (first, last) {
                let ways = &purposes[first..=last];
                prop_assert!(!ways.contains(&Purpose::Rapid), "{:?} {:?}", scheme, ways);
            }
        }
    }

    /// Against a stop nothing is left over rising steps.
    #[test]
    fn against_a_stop_nothing_is_left(stock in steps(), depth in 0.7_f64..4.0) {
        let found = made(&stock, depth, Scheme::LoopAgainstStop, 0.8);
        let worked = keeps_the_laws(&stock, &found)?;
        prop_assert!(found.uniform && worked.left < ROUNDING && worked.depth < depth + ROUNDING);
    }
}

fn sampled(piece: &Piece) -> Vec<(f64, f64)> {
    let count = (piece.length_mm() / 0.05).ceil().max(1.0) as usize;
    let centre = piece.centre();
    let at = |step: usize| {
        let share = step as f64 / count as f64;
        let (from, to) = (piece.from.vector(), piece.to.vector());
        match (centre, radius_of(piece.curve)) {
            (Some(centre), Some(radius)) => {
                let mut angles = [from, to].map(|end| (end.radius - centre.radius).atan2(end.z - centre.z));
                if angles[1] - angles[0] > std::f64::consts::PI {
                    angles[1] -= std::f64::consts::TAU;
                } else if angles[0] - angles[1] > std::f64::consts::PI {
                    angles[1] += std::f64::consts::TAU;
                }
                let angle = angles[0] + (angles[1] - angles[0]) * share;
                (centre.z + radius.to_mm() * libm::cos(angle), centre.radius + radius.to_mm() * libm::sin(angle))
            }
            _ => (from.z + (to.z - from.z) * share, from.radius + (to.radius - from.radius) * share),
        }
    };
    (0..=count).map(at).collect()
}

/// A bore whose axis leaves little room: the tool never goes beyond the axis.
#[test]
fn a_bore_is_not_left_beyond_its_axis() {
    let rough = Contour::through(Side::Inner, &[at(12.0, 0.0), at(12.0, 20.0), at(6.0, 20.0), at(6.0, 30.0)]);
    let blank = Contour::through(Side::Inner, &[at(1.0, 0.0), at(1.0, 30.0)]);
    let stock = Stock { rough, blank, from: mm(0.0), to: mm(30.0) };
    for scheme in Scheme::ALL.into_iter().filter(|scheme| *scheme != Scheme::Equidistant) {
        let found = made(&stock, 1.5, scheme, 0.4);
        assert!(found.path.moves.iter().all(|one| one.to.radius >= Half::ZERO), "{scheme:?}");
    }
}

/// What the lecture concludes on productivity (l. 486-502), over the typical zones that docs/turning-lecture.md lists.
#[test]
fn the_best_of_the_schemes_is_told_with_its_margin() {
    let stock = figure_a();
    let ways = [Scheme::Loop, Scheme::PickUp, Scheme::SemiFinishing].map(|scheme| made(&stock, 2.0, scheme, 0.8));
    let found = best(&ways).unwrap();
    assert_eq!(found.scheme, "loop");
    let even = best(ways.iter().filter(|variant| variant.uniform)).unwrap();
    let (pick_up, semi) = (ways[1].measures.time_min.0, ways[2].measures.time_min.0);
    assert!((even.margin_min.0 - (pick_up - semi).abs()).abs() < 1e-9);
    assert!(best(&ways[..1]).is_none());
}

/// Prints the figures that docs/turning-lecture.md tells:
/// `FIGURES=1 cargo test --test turning transitions::figures -- --ignored --nocapture`.
#[test]
#[ignore = "prints a table for docs/turning-lecture.md where FIGURES is set"]
fn figures() {
    if std::env::var_os("FIGURES").is_none() {
        return;
    }
    let steps = under_bar(
        Contour::through(Side::Outer, &[at(22.0, 0.0), at(22.0, 30.0), at(27.0, 30.0), at(27.0, 60.0), at(32.0, 60.0)]),
        32.0,
    );
    let valley = under_bar(
        Contour::through(Side::Outer, &[at(30.0, 0.0), at(24.0, 12.0), at(24.0, 40.0), at(30.0, 52.0)]),
        30.0,
    );
    let open = under_bar(Contour::through(Side::Outer, &[at(26.0, 0.0), at(26.0, 60.0)]), 32.0);
    for (name, stock) in
        [("open", open), ("half-open, fig. a", figure_a()), ("half-open, steps", steps), ("closed, cones", valley)]
    {
        for scheme in
            [Scheme::Loop, Scheme::Zigzag, Scheme::Descent, Scheme::PickUp, Scheme::SemiFinishing, Scheme::Contour]
        {
            let found = made(&stock, 2.0, scheme, 0.8);
            let measures = found.measures;
            println!(
                "{name} | {} | {} | {} | {} | {} | {}",
                scheme.name(),
                measures.cutting_mm,
                measures.beside_mm,
                measures.rapid_mm,
                measures.time_min.0,
                found.ridges_mm
            );
        }
    }
}

/// Zones over which a law has failed once, each shrunk: what it is, its contour, how far the bar stands above it, the
/// second diameter of the blank, and the depth.
#[test]
fn slots_as_narrow_as_rounding_are_wall() {
    use section::Part::{Ball, BallDown, Cone, Cylinder, Face, Fillet, FilletDown};
    use section::{Part, contour, zone};
    type Case<'c> = (&'c str, i64, &'c [Part], i64, Option<(i64, i64)>, f64);
    let cases: [Case<'_>; 11] = [
        (
            "a level of half a micrometre between a face of the blank and an upright arc",
            28_748,
            &[BallDown(2049), BallDown(4276), Face(-8151), Ball(3289)],
            9613,
            Some((6698, 66)),
            0.760_564_801_092_694_4,
        ),
        (
            "the zigzag back over half a micrometre, between an upright arc and a face of the blank",
            10_000,
            &[Cone(9250, 17_852), BallDown(1825), Ball(914), BallDown(9839), Fillet(5697)],
            2083,
            Some((1000, 84)),
            2.886_581_685_889_993_8,
        ),
        (
            "the zigzag back over 1.5 µm, between an arc that falls upright and a face at its end",
            10_000,
            &[Ball(5299), Cone(1729, 1500), BallDown(876), Face(7842), Ball(7705)],
            6927,
            None,
            0.7,
        ),
        (
            "the same where the arc begins at the free end",
            16_115,
            &[BallDown(6342), Face(13_263), Ball(9812), Fillet(8397)],
            2681,
            None,
            1.310_728_447_900_730_8,
        ),
        (
            "the loop behind a face that falls to an upright arc",
            10_000,
            &[Fillet(8937), Face(-10_910), Ball(600)],
            9193,
            None,
            5.019_549_834_780_349,
        ),
        (
            "the same under a low face",
            16_000,
            &[Fillet(600), Face(-237), Ball(8915)],
            2729,
            None,
            5.774_392_322_029_333,
        ),
        (
            "a face of the blank 11.5 µm behind an upright arc",
            10_000,
            &[Fillet(1162), Fillet(1993), Ball(6193)],
            8606,
            Some((2911, 34)),
            0.780_445_878_497_998_7,
        ),
        (
            "a face of the blank over a hollow between arcs",
            20_815,
            &[Cylinder(9647), BallDown(9162), Fillet(6265), Ball(1230), BallDown(7619)],
            10_218,
            Some((11_282, 72)),
            2.264_735_515_065_359_6,
        ),
        (
            "pick-up goes down a cone of half a micrometre, not the arc behind it",
            18_511,
            &[Cone(-1, 1500), Face(1), FilletDown(600)],
            0,
            Some((1000, 10)),
            0.7,
        ),
        ("the same under 1.5 µm of stock", 14_940, &[Cone(-1, 1500), Face(1), FilletDown(600)], 3, None, 0.7),
        (
            "pick-up leaves a sliver of 3 µm behind a face of the blank, which is no ridge",
            11_846,
            &[BallDown(3845), Fillet(3864), Face(2364), Fillet(5149), FilletDown(1412), FilletDown(8840)],
            25,
            Some((4805, 31)),
            3.578_047_659_412_874_7,
        ),
    ];
    let failed = cases.into_iter().filter_map(|(name, start, parts, above, second, depth)| {
        let stock = zone(contour(start, parts), above, second, false);
        Some(format!("{name}: {}", the_laws_hold_over(&stock, depth, 0.0).err()?))
    });
    assert_eq!(failed.collect::<Vec<_>>(), Vec::<String>::new());
}
