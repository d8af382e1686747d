//! Threads of real parts. Figures are those of ISO 724 and of makers' tables of passes.

use super::*;
use crate::shipped;
use crate::turning::contour::SurfaceKind;
use crate::turning::jobs::tests::{at_bench, part};
use crate::turning::workpiece::Workpiece;

fn job(workpiece: &Workpiece, side: Side, passes: Passes) -> Result<Job, NoJob> {
    let profile = match side {
        Side::Outer => &workpiece.outer,
        Side::Inner => workpiece.inner.as_ref().unwrap(),
    };
    let surface = profile.surfaces.iter().find(|one| one.kind == SurfaceKind::Thread).unwrap();
    let thread = workpiece.thread_on(&surface.name).unwrap();
    let radius = if side == Side::Outer { 62.0 } else { 12.0 };
    let site = Site { profile, clear: Point { radius: Half::from(radius), z: Half::from(-2.0) }, off: Half::from(0.5) };
    at_bench(workpiece, |bench| Refusal::split(super::thread(site, surface, thread, passes, bench)).unwrap())
}

/// A thread from a chamfer to a relief before a shoulder.
fn bolt(thread: &str, to: &str, relief: &str) -> String {
    let d: f64 = thread[1..].split('x').next().unwrap().parse().unwrap();
    format!(
        "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: {}}}\n  - {{chamfer: 2}}\n  - {{thread: {thread}, to: {to}}}\n{relief}  - {{face: 90}}\n  - {{cylinder: -100}}\n",
        d - 4.0
    )
}

const RELIEF: &str = "  - {groove: thread-relief}\n";

fn mm(half: Half) -> f64 {
    half.to_mm()
}

/// ISO 965-2: d2 of M36x2-6g is 34.493 to 34.663, 34.578 in the middle; its roots lie 2/3 H = 1.1547 below, at Ø33.4233. Its
/// crests are 35.682 to 35.962: from Ø35.822 h = 1.1994, in 8 passes by area, the first 1.1994/√8 = 0.4240. 60 m/min on Ø36 are 530 1/min, of the
/// spindle's steps 500: the run-out is 2·500/1800 = 0.556, the entry the greater of 3.615 times that, 2.01, and two pitches.
#[test]
fn a_bolt_is_cut_to_the_middle_of_its_pitch_diameter() {
    let made = job(&part(&bolt("M36x2", "-30", RELIEF), "", "steel-45"), Side::Outer, Passes::Area).unwrap();
    let cut = made.thread.clone().unwrap();
    assert!((2.0 * mm(cut.root_radius_mm) - 33.4233).abs() < 0.001, "{}", cut.root_radius_mm);
    assert_eq!(cut.crest_radius_mm, Half::from(17.911));
    let depths: Vec<f64> = cut.depths_mm.iter().map(|depth| mm(*depth)).collect();
    assert_eq!(depths.len(), 9, "eight passes and one more at the last depth: {depths:?}");
    assert!((depths[0] - 0.4240).abs() < 0.001 && (depths[3] - 0.8481).abs() < 0.001, "{depths:?}");
    assert!((depths[7] - 1.1994).abs() < 0.001 && depths[7] == depths[8], "{depths:?}");
    assert_eq!(made.pace.speed().unwrap(), Speed::Spindle(RevsPerMinute(500.0)));
    assert!((made.pace.feeds().unwrap().thread.0 - 2.0).abs() < 1e-12);
    assert!((mm(cut.from_z_mm) - (2.0 - 4.0)).abs() < 0.001, "two pitches before the thread at Z 2");
    // The relief is 1.5 deep with 45°: below the roots from 1.288 behind the thread on.
    assert!((mm(cut.to_z_mm) - 31.288).abs() < 0.001, "{}", cut.to_z_mm);
    assert!((cut.infeed_angle_deg.0 - 29.5).abs() < 1e-9);
    // The way: nine passes, each at the depth of its pass, to the same end.
    let passes: Vec<_> = made.path.moves.iter().filter(|one| one.purpose == Purpose::Thread).collect();
    assert_eq!(passes.len(), 9);
    for (one, depth) in passes.iter().zip(&cut.depths_mm) {
        assert_eq!(one.to, Point { radius: cut.crest_radius_mm - *depth, z: cut.to_z_mm });
    }
    // By the flank: the first pass begins (1.1994 − 0.4240)·tan 29.5° = 0.4387 before the last.
    let starts: Vec<f64> = made
        .path
        .pieces()
        .filter(|(_, purpose)| *purpose == Purpose::Thread)
        .map(|(piece, _)| mm(piece.from.z))
        .collect();
    assert!((starts[0] + 2.0 + 0.4387).abs() < 0.001 && (starts[8] + 2.0).abs() < 0.001, "{starts:?}");
}

/// The flank-true depths are those of the makers' tables: Mitsubishi's outer 0.61 P, inner 0.577 P.
#[test]
fn depths_are_those_of_the_makers_tables() {
    for (pitch, outer, inner) in [(1.0, 0.61, 0.58), (1.5, 0.92, 0.87), (2.0, 1.23, 1.15), (3.0, 1.84, 1.73)] {
        let triangle = TRIANGLE * pitch;
        assert!((7.0_f64 / 8.0 * triangle - triangle / 6.0 - outer).abs() < 0.006, "{pitch}");
        assert!((3.0_f64 / 4.0 * triangle - triangle / 12.0 - inner).abs() < 0.006, "{pitch}");
        // Sumitomo's partial profile of r 0.06 in a bore: 0.59, 0.92, 1.24 with 0.06 of reserve at most.
        let partial = 3.0 / 4.0 * triangle - 0.06;
        assert!(
            (partial - [0.59, 0.92, 1.24, 1.89][[1.0, 1.5, 2.0, 3.0].iter().position(|one| *one == pitch).unwrap()])
                .abs()
                < 0.011
        );
    }
}

/// ISO 965-2: D2 of M36x2-6H is 34.701 to 34.925, 34.813 in the middle. The drill leaves Ø34; the roots lie 5/6 H = 1.4434
/// outside of D2.
#[test]
fn a_nut_is_cut_from_its_bore_outwards() {
    let outer = "  - {from: {d: 34, z: 0}}\n  - {face: 90}\n  - {cylinder: -100}\n";
    let inner = "  - {from: {d: 34, z: 0}}\n  - {thread: M36x2, to: -100}\n";
    let made = job(&part(outer, inner, "steel-45"), Side::Inner, Passes::Area);
    let why = made.unwrap_err();
    assert_eq!(why.note().code(), "job-bar-too-short", "100 mm with a bar of 20: {why:?}");
    let outer = "  - {from: {d: 34, z: 0}}\n  - {face: 90}\n  - {cylinder: -40}\n";
    let inner = "  - {from: {d: 34, z: 0}}\n  - {thread: M36x2, to: -40}\n";
    let made = job(&part(outer, inner, "steel-45"), Side::Inner, Passes::Depth).unwrap();
    let cut = made.thread.unwrap();
    assert!((2.0 * mm(cut.root_radius_mm) - (34.813 + 1.4434)).abs() < 0.001, "{}", cut.root_radius_mm);
    let crest = mm(cut.crest_radius_mm);
    let depths: Vec<f64> = cut.depths_mm.iter().map(|depth| mm(*depth)).collect();
    assert!((crest + depths[depths.len() - 1] - mm(cut.root_radius_mm)).abs() < 0.001);
    // By equal depths.
    let first = depths[0];
    assert!(depths.windows(2).take(6).all(|pair| (pair[1] - pair[0] - first).abs() < 0.0015), "{depths:?}");
    assert!(made.path.moves.iter().all(|one| one.to.radius <= cut.root_radius_mm), "nothing beyond the roots");
}

/// Refusals with their inequalities: a shoulder right behind the thread, a collar before it, a relief too shallow, a
/// pitch of which there is no insert.
#[test]
fn a_thread_without_room_is_refused() {
    let refused = |outer: &str| job(&part(outer, "", "steel-45"), Side::Outer, Passes::Area).unwrap_err();
    let shoulder = refused(&bolt("M36x2", "-30", ""));
    assert_eq!(shoulder.note().code(), "thread-no-run-out", "{shoulder:?}");
    let shallow = refused(&bolt("M36x2", "-30", "  - {groove: thread-relief, width: 5, depth: 1}\n"));
    assert_eq!(shallow.note().code(), "thread-relief-shallow", "{shallow:?}");
    let narrow = refused(&bolt("M36x2", "-30", "  - {groove: rectangular, width: 1.8, depth: 1.5}\n"));
    assert_eq!(narrow.note().code(), "thread-no-run-out", "{narrow:?}");
    let collar = "  - {from: {d: 0, z: 0}}\n  - {face: 50}\n  - {cylinder: -10}\n  - {face: 30}\n  - {cylinder: -13}\n  - {face: 36}\n  - {thread: M36x2, to: -40}\n  - {groove: thread-relief}\n  - {face: 90}\n  - {cylinder: -100}\n";
    let collar = refused(collar);
    assert_eq!(collar.note().code(), "thread-no-entry", "{collar:?}");
    assert_eq!(collar.note().figure_text("room").unwrap(), "3");
    let coarse = refused(&bolt("M48", "-30", "  - {groove: rectangular, width: 12, depth: 4}\n"));
    assert_eq!(coarse.note().code(), "thread-no-insert", "M48 has 5 mm: {coarse:?}");
}

/// A thread that ends on a longer cylinder is pulled out of the metal.
#[test]
fn a_thread_without_relief_is_pulled_out() {
    let outer = "  - {from: {d: 0, z: 0}}\n  - {face: 33}\n  - {chamfer: 1.5}\n  - {thread: M36x1.5, to: -30}\n  - {cylinder: -60}\n  - {face: 90}\n  - {cylinder: -100}\n";
    let made = job(&part(outer, "", "steel-45"), Side::Outer, Passes::Area).unwrap();
    let cut = made.thread.unwrap();
    // d2 of 6g is 34.844 to 34.994, in the middle 34.919, 0.866 above the roots: 0.9735 below Ø36, where the cylinder behind
    // stays, and 1 mm of lift at 45°.
    assert!((mm(cut.to_z_mm) - 31.974).abs() < 0.001, "{}", cut.to_z_mm);
    assert!((cut.infeed_angle_deg.0).abs() < 1e-9, "a fine thread is fed straight in");
    let ends: Vec<Half> =
        made.path.moves.iter().filter(|one| one.purpose == Purpose::Thread).map(|one| one.to.z).collect();
    assert!(ends.chunks(2).all(|pair| pair == [Half::from(30.0), cut.to_z_mm]), "{ends:?}");
    assert!(made.notes.iter().any(|note| note.code() == "thread-pulled-out"));
}

/// Where the pitch is coarse and the diameter small, the feed of the lathe holds the spindle: 2000 mm/min at 3 mm are
/// 666 1/min; 16К20Ф3 has 560.
#[test]
fn the_spindle_is_held_by_the_feed_of_the_lathe() {
    let outer = bolt("M20x3", "-30", "  - {groove: rectangular, width: 7, depth: 2.5}\n");
    let made = job(&part(&outer, "", "steel-45"), Side::Outer, Passes::Area).unwrap();
    assert_eq!(made.pace.speed().unwrap(), Speed::Spindle(RevsPerMinute(560.0)));
    assert!(made.because.iter().any(|why| why.note.code() == "thread-feed-follows"));
}

/// d2 of M30x2-6g is 28.493 to 28.663: whatever the nose of the insert, its flanks go to 28.578. A sharp point would end
/// H = 1.7321 below, one of r 0.1 by 2 r less, full profile, r = H/6, by H/3 less. M20x3 has no limits: the basic profile
/// has d2 = 18.051 and, of full profile, d3 = 16.319 (ISO 724).
#[test]
fn the_flanks_are_the_same_for_any_nose() {
    let knowledge = shipped::knowledge().unwrap();
    let tools = TurningTool::all(&knowledge).unwrap();
    let of_pitch = |pitch: i64| {
        let pitch = Micrometres::new(pitch);
        let is_of = |tool: &&TurningTool<'_>| tool.works == Place::Outer && tool.pitch == Some((pitch, pitch));
        tools.iter().find(is_of).unwrap().clone()
    };
    let thread = |size: &str, relief: &str| part(&bolt(size, "-30", relief), "", "steel-45").threads[0].clone();
    let fine = thread("M30x2-6g", RELIEF);
    let root = |tool: &TurningTool<'_>, thread: &Thread| 2.0 * mm(root_radius(Side::Outer, thread, tool));
    let full = of_pitch(2_000);
    assert!((root(&full, &fine) - 27.4233).abs() < 0.001);
    let range = Some((Micrometres::new(500), Micrometres::new(3_000)));
    let partial = TurningTool { pitch: range, nose_radius: Some(Micrometres::new(100)), ..full.clone() };
    assert!((root(&partial, &fine) - (28.578 - 1.7321 + 0.2)).abs() < 0.001);
    let coarse = thread("M20x3", "  - {groove: rectangular, width: 7, depth: 2.5}\n");
    assert!((root(&of_pitch(3_000), &coarse) - 16.319).abs() < 0.001);
    let name = SurfaceName::Place(Side::Outer, 3);
    assert_eq!(flanks(&coarse, &name).code(), "thread-flanks-basic");
    let note = flanks(&fine, &name);
    let told = ["made", "least", "most"].map(|figure| note.figure_text(figure).unwrap());
    assert_eq!(
        (note.code(), told.map(|one| one.to_string())),
        ("thread-flanks", ["28.578", "28.493", "28.663"].map(str::to_owned))
    );
}

/// An insert is for one pitch or for a range; the table cannot say that its least is not above its largest.
#[test]
fn ranges_of_pitches_are_ranges() {
    let knowledge = shipped::knowledge().unwrap();
    let pitches: Vec<_> = TurningTool::all(&knowledge).unwrap().iter().filter_map(|tool| tool.pitch).collect();
    assert!(pitches.len() > 10 && pitches.iter().all(|(least, most)| least <= most), "{pitches:?}");
}
