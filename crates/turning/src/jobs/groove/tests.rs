//! Grooves of real parts; their toolpaths are proven.

use super::*;
use crate::turning::contour::{Contour, Piece, Profile, Side};
use crate::turning::jobs::tests::{at_bench, part};
use crate::turning::operation::proof::{chain, motions, tool};
use crate::turning::workpiece::Workpiece;
use technolog_turning_proof as proof;

/// The job of the first groove of a part, and that groove.
fn job(workpiece: &Workpiece, side: Side) -> (Result<Job, NoJob>, Surface) {
    let profile = match side {
        Side::Outer => &workpiece.outer,
        Side::Inner => workpiece.inner.as_ref().unwrap(),
    };
    let surface = profile.surfaces.iter().find(|surface| surface.is_groove()).unwrap().clone();
    let radius = if side == Side::Outer { 62.0 } else { 15.0 };
    let site = Site { profile, clear: Point { radius: Half::from(radius), z: Half::from(-2.0) }, off: Half::from(0.5) };
    (at_bench(workpiece, |bench| Refusal::split(groove(site, &surface, bench)).unwrap()), surface)
}

/// Proves the job of a groove on the part with the groove still full: it cuts nothing of the part, meets no metal at rapid, and leaves
/// nothing but the rounding of its corners. The proof shares nothing with the planner, not even geometry.
fn is_clean(part: &Workpiece, job: &Job, groove: &Surface, what: &str) {
    let filled = |profile: &Profile| -> Vec<proof::Piece> {
        let fill = |one: &Surface| match one.pieces.as_slice() {
            [first, .., last] if one == groove => vec![Piece::line(first.from, last.to)],
            pieces => pieces.to_vec(),
        };
        let contour = Contour { side: profile.side, pieces: profile.surfaces.iter().flat_map(fill).collect() };
        chain(&contour)
    };
    let drawn = |profile: &Profile| -> Vec<proof::ProfilePiece> {
        chain(&profile.contour()).into_iter().map(|piece| proof::ProfilePiece::new(piece, None)).collect()
    };
    let (outer, inner) = (&part.outer, part.inner.as_ref());
    let set_up = proof::SetUp {
        profile: proof::Profile { outside: drawn(outer), bore: inner.map(drawn).unwrap_or_default() },
        stock: proof::Stock::between(&filled(outer), &inner.map(filled).unwrap_or_default()),
        tools: vec![tool(&job.tool)],
        motions: motions(&job.path, 0),
        ..proof::SetUp::default()
    };
    let faults = proof::prove(&set_up).unwrap().faults;
    let graves: Vec<_> = faults.iter().filter(|fault| !fault.is_mild()).collect();
    assert!(graves.is_empty(), "{what}: {graves:?}");
}

/// The groove between two cylinders of Ø60, with the mouth at Z 20.
fn outside(groove: &str) -> String {
    format!(
        "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 60}}\n  - {{cylinder: -20}}\n  - {{groove: {groove}}}\n  - {{cylinder: -100}}\n"
    )
}

fn plunges(job: &Job) -> Vec<String> {
    let mut places: Vec<String> =
        job.path.moves.iter().filter(|one| one.purpose == Purpose::Plunge).map(|one| one.to.z.to_string()).collect();
    places.dedup();
    places
}

/// By hand: with blades of 2 to 5 mm the widest is 5, r 0.8: it leaves 0.8 on sides and floor. Its leading corner goes
/// from 20 + 0.8 + 5 to 28 - 0.8: 25.8 to 27.2, 1.4 apart, which is one step of at most 0.75 · 5.
#[test]
fn a_rectangular_groove_is_plunged_with_the_widest_blade() {
    let own = part(&outside("rectangular, width: 8, depth: 5"), "", "steel-45");
    let (made, surface) = job(&own, Side::Outer);
    let made = made.unwrap();
    assert_eq!(made.tool.designation, "MGEHR 2525-5");
    assert_eq!(plunges(&made), ["25.8", "27.2"]);
    is_clean(&own, &made, &surface, "8 wide");
    let kept = made.notes.iter().find(|note| note.code() == "groove-corner-kept").unwrap();
    assert_eq!(kept.figure_text("radius").unwrap(), "0.8");
    assert!(made.time_min.0 > 0.1 && made.time_min.0 < 3.0, "{:?}", made.time_min);
}

/// By hand, with the blade of 5 mm and r 0.8: in a groove of 7 the leading corner may lie from 25.8 to 26.2. One plunge at 26
/// leaves 0.2 + 0.8 = 1 mm on each side, which finishing takes (1 mm), so a second one would cut a sliver of 0.2 at each. In one
/// of 7.2 it would leave 1.1.
#[test]
fn no_plunge_cuts_a_sliver() {
    let made = |width: f64| {
        let own = part(&outside(&format!("rectangular, width: {width}, depth: 5")), "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap();
        assert_eq!(made.tool.designation, "MGEHR 2525-5");
        is_clean(&own, &made, &surface, &width.to_string());
        plunges(&made)
    };
    assert_eq!(made(7.0), ["26"]);
    assert_eq!(made(7.2), ["25.8", "26.4"]);
}

/// By hand, with the blade of 3 mm and r 0.4: from 20 + 0.4 + 3 = 23.4 to 28 - 0.4 = 27.6; 4.2 are two steps of at most
/// 2.25, the middle first.
#[test]
fn a_blade_of_three_plunges_three_times_in_a_groove_of_eight() {
    let own = part(&outside("rectangular, width: 8, depth: 5"), "", "steel-45");
    let (_, surface) = job(&own, Side::Outer);
    let valley = Valley::of(&surface, Side::Outer).map_err(|_| ()).unwrap();
    let division = Division {
        step: 0.75,
        allowance: 0.4,
        finish: 1.0,
        peck: (9.0, 1.0, 0.5),
        approach: Half::from(2.0),
        layer: None,
    };
    let ways = ways::blade(&valley, ways::CuttingEdge { width: 3.0, corner: 0.4 }, division).unwrap();
    let places: Vec<String> = ways.plunges.iter().map(Half::to_string).collect();
    assert_eq!(places, ["25.5", "23.4", "27.6"]);
    let lowest = ways.path.moves.iter().filter(|one| one.purpose == Purpose::Plunge).map(|one| one.to.radius).min();
    assert_eq!(lowest, Some(Half::from(25.4)), "0.4 over the floor");
}

/// Every kind outside, inside and in a face: nothing below the profile, no rapid through metal, nothing left that the
/// edge reaches.
#[test]
fn grooves_are_cut_to_their_profile_and_not_below() {
    let outer = [
        "rectangular, width: 3, depth: 2",
        "rectangular, width: 6, depth: 9, radius: 1",
        "rectangular, width: 20, depth: 4",
        "trapezoid, width: 12, depth: 4, angle: 60",
        "trapezoid, width: 20, depth: 5, angle: 120",
        "pulley, width: 13, depth: 10.8, angle: 34, radius: 1",
        "pulley, width: 22, depth: 14, angle: 38, radius: 0.3",
        "pulley, width: 31, depth: 20, angle: 34, radius: 2",
    ];
    for kind in outer {
        let own = part(&outside(kind), "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        is_clean(&own, &made, &surface, kind);
    }
    let plain = "  - {from: {d: 50, z: 0}}\n  - {face: 90}\n  - {cylinder: -100}\n";
    for kind in [
        "rectangular, width: 4, depth: 3",
        "rectangular, width: 10, depth: 4.5",
        "trapezoid, width: 9, depth: 3, angle: 40",
    ] {
        let bore = format!(
            "  - {{from: {{d: 50, z: 0}}}}\n  - {{cylinder: -30}}\n  - {{groove: {kind}}}\n  - {{cylinder: -100}}\n"
        );
        let own = part(plain, &bore, "steel-45");
        let (made, surface) = job(&own, Side::Inner);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        is_clean(&own, &made, &surface, kind);
    }
    // At the bottom of a blind bore, whose face goes to the axis.
    let bore = "  - {from: {d: 50, z: 0}}\n  - {cylinder: -30}\n  - {groove: grinding-relief, width: 5, depth: 0.5}\n  - {face: 0}\n";
    let own = part(plain, bore, "steel-45");
    let (made, surface) = job(&own, Side::Inner);
    let made = made.unwrap_or_else(|why| panic!("at the bottom: {why:?}"));
    is_clean(&own, &made, &surface, "at the bottom");
    for kind in ["face, width: 4, depth: 5", "face, width: 12, depth: 6"] {
        let face = format!(
            "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 60}}\n  - {{groove: {kind}}}\n  - {{face: 110}}\n  - {{cylinder: -100}}\n"
        );
        let own = part(&face, "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        is_clean(&own, &made, &surface, kind);
    }
}

/// Reliefs before a shoulder: by a blade where one goes in, otherwise along their contour by a tool of 35°, whose 52°
/// behind the tip clear the 45° of the relief.
#[test]
fn reliefs_before_a_shoulder_are_cut() {
    let before = |groove: &str| {
        format!(
            "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 40}}\n  - {{cylinder: -30}}\n  - {{groove: {groove}}}\n  - {{face: 70}}\n  - {{cylinder: -100}}\n"
        )
    };
    for (kind, tool) in [
        ("grinding-relief, width: 3, depth: 0.25", "MGEHR 2525-2"),
        ("grinding-relief, width: 5, depth: 0.5", "MGEHR 2525-4"),
        ("thread-relief, width: 5, depth: 1.5", "MGEHR 2525-3"),
        ("grinding-relief, width: 1.6, depth: 0.25", "CGR-1.3"),
        ("grinding-relief, width: 1.1, depth: 0.25", "SVJBR 2525M16"),
    ] {
        let own = part(&before(kind), "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        assert_eq!(made.tool.designation, tool, "{kind}: {:?}", made.notes);
        is_clean(&own, &made, &surface, kind);
    }
}

/// A groove that no tool can make is refused with the inequality that fails.
#[test]
fn what_no_tool_makes_is_refused() {
    let refused = |outer: &str, inner: &str, side| job(&part(outer, inner, "steel-45"), side).0.unwrap_err();
    let narrow = refused(&outside("rectangular, width: 0.9, depth: 1"), "", Side::Outer);
    assert_eq!(narrow.note().code(), "groove-too-narrow", "{narrow:?}");
    assert_eq!(narrow.note().figure_text("width").unwrap(), "1");
    // A blade of 1.3 mm enters 1.9 mm deep.
    let slot = refused(&outside("rectangular, width: 1.5, depth: 4"), "", Side::Outer);
    assert_eq!(slot.note().code(), "groove-beyond-blade", "{slot:?}");
    let deep = refused(&outside("rectangular, width: 6, depth: 21"), "", Side::Outer);
    assert_eq!(deep.note().code(), "groove-beyond-blade", "{deep:?}");
    // Both mouths of a corner relief lead under the metal: 135° and 45° with the angle of any insert are over 180°.
    let corner = "  - {from: {d: 0, z: 0}}\n  - {face: 40}\n  - {cylinder: -30}\n  - {groove: corner, width: 2, depth: 0.5}\n  - {face: 70}\n  - {cylinder: -100}\n";
    let under = refused(corner, "", Side::Outer);
    let NoJob::Undercut { main, secondary, .. } = under else { panic!("{under:?}") };
    assert!((main - 135.0).abs() < 0.1 && (secondary - 45.0).abs() < 0.1);
    let bore = "  - {from: {d: 18, z: 0}}\n  - {cylinder: -30}\n  - {groove: rectangular, width: 3, depth: 1}\n  - {cylinder: -100}\n";
    let outer = "  - {from: {d: 18, z: 0}}\n  - {face: 60}\n  - {cylinder: -100}\n";
    assert_eq!(refused(outer, bore, Side::Inner).note().code(), "job-bore-too-small");
    let face = "  - {from: {d: 0, z: 0}}\n  - {face: 20}\n  - {groove: face, width: 4, depth: 5}\n  - {face: 110}\n  - {cylinder: -100}\n";
    assert_eq!(refused(face, "", Side::Outer).note().code(), "groove-face-too-small");
}

/// A groove with a tolerance is not left to the width of a blade, if a narrower one goes in.
#[test]
fn a_groove_with_a_tolerance_is_turned_on_both_walls() {
    let (plain, _) = job(&part(&outside("rectangular, width: 4, depth: 3"), "", "steel-45"), Side::Outer);
    assert_eq!(plain.unwrap().tool.designation, "MGEHR 2525-4");
    let (fine, _) = job(&part(&outside("rectangular, width: 4, depth: 3, grade: h10"), "", "steel-45"), Side::Outer);
    assert_eq!(fine.unwrap().tool.designation, "MGEHR 2525-3");
}

/// Kyocera 2016, p. 461: aluminium, a blade of 5 mm: 200 m/min and 0.10 mm/rev at the least. On Ø60 1061 1/min, of the
/// spindle's steps 1000.
#[test]
fn a_light_alloy_is_grooved_by_the_maker() {
    let (made, _) = job(&part(&outside("rectangular, width: 8, depth: 5"), "", "aluminium-d16"), Side::Outer);
    let made = made.unwrap();
    assert_eq!(
        made.pace.speed().unwrap(),
        crate::turning::program::Speed::Spindle(crate::units::RevsPerMinute(1000.0))
    );
    assert!((made.pace.feeds().unwrap().plunge.0 - 0.1).abs() < 1e-9);
}

/// Deeper than one and a half widths the blade is drawn back: 9 mm with a blade of 4 are three steps.
#[test]
fn a_deep_groove_is_cut_in_steps() {
    let (made, _) = job(&part(&outside("rectangular, width: 6, depth: 9, radius: 1"), "", "steel-45"), Side::Outer);
    let made = made.unwrap();
    let pecked = made.notes.iter().find(|note| note.code() == "groove-pecked");
    assert!(pecked.is_some(), "{:?} {:?}", made.tool.designation, made.notes);
}

/// The groove of a V-belt, 31 at its mouth and 20 deep, was once cut by 63 plunges 0.2 mm apart. By hand: floor 31 − 40·tan 17° = 18.8,
/// five plunges of 5 mm, and the blade may take layers of 0.04·W²/(0.075·W) = 2.67 mm at 0.075·W, so 20 mm take eight.
#[test]
fn wide_walls_are_turned_in_layers() {
    let own = part(&outside("pulley, width: 31, depth: 20, angle: 34, radius: 2"), "", "steel-45");
    let made = job(&own, Side::Outer).0.unwrap();
    assert_eq!(plunges(&made).len(), 5, "{:?}", made.notes);
    let layers =
        made.notes.iter().find(|note| note.code() == "groove-layers").and_then(|note| note.figure_text("layers"));
    assert_eq!(layers.as_deref(), Some("8"), "{:?}", made.notes);
    let feeds = made.pace.feeds().unwrap();
    assert!(feeds.cut.0 <= 0.075 * 5.0 + 1e-9 && feeds.cut.0 * 8.0 / 3.0 <= feeds.plunge.0 * 5.0 + 0.001, "{feeds:?}");
    // Between upright walls plunges leave nothing to the sides.
    let own = part(&outside("rectangular, width: 20, depth: 4"), "", "steel-45");
    let made = job(&own, Side::Outer).0.unwrap();
    assert!(made.notes.iter().all(|note| note.code() != "groove-layers"), "{:?}", made.notes);
}
