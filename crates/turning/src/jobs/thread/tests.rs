//! Threads of real parts. Figures are those of ISO 724 and of makers' tables of passes.

use super::*;
use crate::material::Material;
use crate::shipped;
use crate::turning::contour::SurfaceKind;
use crate::turning::workpiece::{Workpiece, read_workpiece};

fn part(outer: &str, inner: &str, material: &str) -> Workpiece {
    let inner = if inner.is_empty() { String::new() } else { format!("inner:\n{inner}") };
    let text = format!(
        "shaft: P\nmaterial: {material}\nblank: {{kind: bar, diameter: 120, length: 130, face: 1}}\nmachine: 16k20f3\n\
         outer:\n{outer}{inner}"
    );
    read_workpiece("part", &text, &shipped::knowledge().unwrap()).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn job(workpiece: &Workpiece, side: Side, passes: Passes) -> Result<Job, NoJob> {
    let knowledge = shipped::knowledge().unwrap();
    let lathe = Lathe::find(&knowledge, "16k20f3").unwrap();
    let material = Material::find(&knowledge, &workpiece.material).unwrap();
    let bench = Bench {
        workpiece,
        lathe: Some(&lathe),
        material,
        elsewhere: &[],
        held: None,
        barred: Vec::new(),
        knowledge: &knowledge,
    };
    let profile = match side {
        Side::Outer => &workpiece.outer,
        Side::Inner => workpiece.inner.as_ref().unwrap(),
    };
    let surface = profile.surfaces.iter().find(|one| one.kind == SurfaceKind::Thread).unwrap();
    let thread = workpiece.threads.iter().find(|one| one.surface == surface.name.to_string()).unwrap();
    let radius = if side == Side::Outer { 62.0 } else { 12.0 };
    let site = Site { profile, clear: Point { radius: Half::from(radius), z: Half::from(-2.0) } };
    Refusal::split(super::thread(site, surface, thread, passes, &bench)).unwrap()
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

/// ISO 724: d3 of M36x2 is 33.546. By hand: h = 17/24·0.866·2 = 1.2269; 8 passes by area, the first 1.2269/√8 = 0.4338.
/// 45 m/min on Ø36 are 398 1/min, of the spindle's steps 355: the run-out is 2·355/1800 = 0.394, the entry the greater
/// of 3.605 times that, 1.42, and two pitches.
#[test]
fn a_bolt_is_cut_to_the_minor_diameter_of_iso_724() {
    let made = job(&part(&bolt("M36x2", "-30", RELIEF), "", "steel-45"), Side::Outer, Passes::Area).unwrap();
    let cut = made.thread.clone().unwrap();
    assert!((2.0 * mm(cut.root_radius_mm) - 33.546).abs() < 0.001, "{}", cut.root_radius_mm);
    assert_eq!(cut.crest_radius_mm, Half::from(18.0));
    let depths: Vec<f64> = cut.depths_mm.iter().map(|depth| mm(*depth)).collect();
    assert_eq!(depths.len(), 9, "eight passes and one more at the last depth: {depths:?}");
    assert!((depths[0] - 0.4338).abs() < 0.001 && (depths[3] - 0.8676).abs() < 0.001, "{depths:?}");
    assert!((depths[7] - 1.2269).abs() < 0.001 && depths[7] == depths[8], "{depths:?}");
    assert_eq!(made.pace.speed().unwrap(), Speed::Spindle(RevsPerMinute(355.0)));
    assert!((made.pace.feeds().unwrap().thread.0 - 2.0).abs() < 1e-12);
    assert!((mm(cut.from_z_mm) - (2.0 - 4.0)).abs() < 0.001, "two pitches before the thread at Z 2");
    // The relief is 1.5 deep with 45°: below the roots from 1.227 behind the thread on.
    assert!((mm(cut.to_z_mm) - 31.227).abs() < 0.001, "{}", cut.to_z_mm);
    assert!((cut.infeed_angle_deg.0 - 29.5).abs() < 1e-9);
    // The way: nine passes, each at the depth of its pass, to the same end.
    let passes: Vec<_> = made.path.moves.iter().filter(|one| one.purpose == Purpose::Thread).collect();
    assert_eq!(passes.len(), 9);
    for (one, depth) in passes.iter().zip(&cut.depths_mm) {
        assert_eq!(one.to, Point { radius: cut.crest_radius_mm - *depth, z: cut.to_z_mm });
    }
    // By the flank: the first pass begins (1.2269 − 0.4338)·tan 29.5° = 0.4487 before the last.
    let starts: Vec<f64> = made
        .path
        .pieces()
        .filter(|(_, purpose)| *purpose == Purpose::Thread)
        .map(|(piece, _)| mm(piece.from.z))
        .collect();
    assert!((starts[0] + 2.0 + 0.4487).abs() < 0.001 && (starts[8] + 2.0).abs() < 0.001, "{starts:?}");
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

/// ISO 724: D1 of M36x2 is 33.835. The drill leaves Ø34; the roots lie 2/3 H = 1.1547 outside of D1.
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
    assert!((2.0 * mm(cut.root_radius_mm) - (33.835 + 2.0 * 1.1547)).abs() < 0.002, "{}", cut.root_radius_mm);
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
    let coarse = refused(&bolt("M36", "-30", "  - {groove: rectangular, width: 9, depth: 3}\n"));
    assert_eq!(coarse.note().code(), "thread-no-insert", "M36 has 4 mm: {coarse:?}");
}

/// A thread that ends on a longer cylinder is pulled out of the metal.
#[test]
fn a_thread_without_relief_is_pulled_out() {
    let outer = "  - {from: {d: 0, z: 0}}\n  - {face: 33}\n  - {chamfer: 1.5}\n  - {thread: M36x1.5, to: -30}\n  - {cylinder: -60}\n  - {face: 90}\n  - {cylinder: -100}\n";
    let made = job(&part(outer, "", "steel-45"), Side::Outer, Passes::Area).unwrap();
    let cut = made.thread.unwrap();
    // h = 0.9202 and 1 mm of lift at 45°.
    assert!((mm(cut.to_z_mm) - 31.920).abs() < 0.001, "{}", cut.to_z_mm);
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

/// An insert is for one pitch or for a range; the table cannot say that its least is not above its largest.
#[test]
fn ranges_of_pitches_are_ranges() {
    let knowledge = shipped::knowledge().unwrap();
    let pitches: Vec<_> = TurningTool::all(&knowledge).unwrap().iter().filter_map(|tool| tool.pitch).collect();
    assert!(pitches.len() > 10 && pitches.iter().all(|(least, most)| least <= most), "{pitches:?}");
}
