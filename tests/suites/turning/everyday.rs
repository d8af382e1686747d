//! Parts as they stand on everyday drawings: planned whole, or told why not.

use technolog::job::{GivenTimes, NormItem, NormedWork, norm_of};
use technolog::note::Severity;
use technolog::tables::practice::TimeNorm;
use technolog::turning::contour::Side;
use technolog::turning::jobs::{Body, Job, Pace, Work};
use technolog::turning::length::Half;
use technolog::turning::operation::gauging::gauges;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::proof::prove_set_up;
use technolog::turning::operation::{Operation, SetUpWork, plan};
use technolog::turning::program::Speed;
use technolog::turning::toolpath::Purpose;
use technolog::turning::workpiece::read_turned;
use technolog::turning::zones::Hold;
use technolog::units::Minutes;
use technolog_testing::KNOWLEDGE;
use technolog_turning_proof::{At, Block, Mm, Motion, MotionKind, Piece};

fn planned(name: &str) -> Operation {
    let path = format!("{}/tests/everyday/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    plan(&read_turned(&path, &text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap()
}

fn wrong(operation: &Operation) -> Vec<&str> {
    let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    wrong.map(|finding| finding.note.code()).collect()
}

/// A spool with a neck between two collars, a stud, a flanged bushing, a shaft with a collar in the middle between centres, a flange,
/// axles with grooves for retaining rings, the first example of the book, a waist before a wall whose other side is turned
/// in the second set-up, a rounding at the end of the second set-up, a belt pulley.
#[test]
fn everyday_parts_are_made_whole() {
    for name in [
        "spool", "bolt", "bushing", "shaft", "flange", "axle", "circlip", "stud", "capfa", "waist", "rounded", "pulley",
    ] {
        let operation = planned(name);
        assert_eq!(wrong(&operation), [""; 0], "{name}: {:?}", operation.findings);
        assert!(operation.set_ups.iter().all(|set_up| set_up.set_up.holds_at.is_some()), "{name}");
    }
}

/// A thread with a cylinder of its own diameter before it has no room to begin: it is cut from the other end. By hand for M20-6g
/// (ISO 965-1, P 2.5): es 0.042, Td 0.335, so the crests are turned to 20 − 0.042 − 0.1675 = 19.79. ГОСТ 10549-80 lets the run-out
/// be 4.5 long. The waisted stud has nothing but a thread for the jaws.
#[test]
fn threads_at_both_ends_are_cut_from_both_ends() {
    for (name, threads, held) in
        [("double-stud", [1, 1], "outer 4"), ("waisted-stud", [1, 1], "outer 3"), ("step-to-thread", [0, 1], "outer 3")]
    {
        let operation = planned(name);
        assert_eq!(wrong(&operation), [""; 0], "{name}: {:?}", operation.findings);
        let cuts = |set_up: &SetUpWork| set_up.jobs.iter().filter_map(|job| job.thread.clone()).collect::<Vec<_>>();
        assert_eq!(operation.set_ups.iter().map(|set_up| cuts(set_up).len()).collect::<Vec<_>>(), threads, "{name}");
        let Some(Hold::Surface { name: by, threaded, .. }) = &operation.set_ups[1].set_up.holds_at else {
            panic!("{name}")
        };
        assert_eq!((by.as_str(), *threaded), (held, name == "waisted-stud"));
        for cut in operation.set_ups.iter().flat_map(cuts) {
            assert!((cut.crest_radius_mm.diameter().to_mm() - 19.79).abs() < 0.0011, "{name}: {cut:?}");
            assert!(!cut.pulled_out || (cut.to_z_mm - cut.ends_z_mm).to_mm() <= 4.5, "{name}: {cut:?}");
        }
    }
}

/// A dowel of a bar of 18, turned to 16 past its end and parted there: for its second chamfer, 1 × 45°, nothing of the bar is left to
/// cut. Its 0.55 and what the chamfer takes are 1 mm and a little; of the bar it would be 2.3, and 38 kN of the jaws.
#[test]
fn what_the_first_set_up_has_turned_is_no_stock_of_the_second() {
    let operation = planned("../turned-whole/dowel-of-bar");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    let jobs = operation.set_ups[1].jobs.iter().filter(|job| job.work != Work::Face);
    let depths: Vec<f64> =
        jobs.filter_map(|job| job.conditions.as_ref()).map(|conditions| conditions.depth_mm.to_mm()).collect();
    assert!(!depths.is_empty() && depths.iter().all(|depth| *depth <= 1.4), "{depths:?}");
}

/// The nose of the tool that finishes the neck, r 1.2, meets the end of its second cone, which rises by 25°, when its reference
/// point is behind it: that goes on over the cylinder.
#[test]
fn a_neck_is_finished_up_to_its_lip() {
    let operation = planned("neck-of-cones");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
}

/// M30 has P 3.5: es 0.053, Td 0.425 for 6g, so its crests are turned to 30 − 0.053 − 0.2125 = 29.7345. The jaws of the second
/// set-up stand clear of the run-out, which ГОСТ 10549-80 lets be 6.3 long, and of the 5 mm beside it.
#[test]
fn coarse_threads_of_large_studs_are_cut() {
    let operation = planned("stud-m30");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    let cuts: Vec<_> =
        operation.set_ups.iter().flat_map(|set_up| &set_up.jobs).filter_map(|job| job.thread.as_ref()).collect();
    assert_eq!(cuts.len(), 2);
    assert!(cuts.iter().all(|cut| (cut.crest_radius_mm.diameter().to_mm() - 29.7345).abs() < 0.0011), "{cuts:?}");
    let jaws = operation.set_ups[1].jaws.unwrap();
    assert!((jaws.front_mm.to_mm() - (60.0 + 6.3 + 5.0)).abs() < 0.001, "{jaws:?}");
}

/// A pin of drawn bar keeps the surface of the bar: Ø40 is turned by no job, but for the chamfers. A bar of Ø40.4 leaves 0.2 for
/// one pass. A nut of a tube bored to the thread has its chamfer and its thread cut, and nothing else in the bore.
#[test]
fn what_the_blank_has_already_is_not_turned() {
    for name in ["drawn-bar", "little-stock", "nut-of-tube"] {
        let operation = planned(name);
        assert_eq!(wrong(&operation), [""; 0], "{name}: {:?}", operation.findings);
        let told = operation.findings.iter().any(|finding| finding.note.code() == "surface-of-blank");
        assert_eq!(told, name == "drawn-bar", "{name}");
    }
    let drawn = planned("drawn-bar");
    let along = drawn.set_ups.iter().flat_map(|set_up| &set_up.jobs).filter(|job| job.side == Side::Outer);
    let body = |job: &&Job| job.surfaces.iter().any(|surface| surface.to_string() == "body");
    assert_eq!(along.clone().filter(body).count(), 0);
    // No feed along Ø40: the chamfer is left along its own slope.
    let cuts = along.flat_map(|job| job.path.pieces().collect::<Vec<_>>());
    let flat = cuts.filter(|(piece, purpose)| *purpose != Purpose::Rapid && piece.is_cylinder());
    assert_eq!(flat.filter(|(piece, _)| piece.from.radius == Half::from(20.0)).count(), 0);
}

/// Chamfers at both ends of outside and bore, written as `chamfer` or as points; the bore is drilled and bored through in the first
/// set-up, and the second cuts nothing but its chamfer, without a drill. A taper before a cylinder is bored. Before a hole of Ø16 no
/// bar enters the taper, which is told as that, and not looked for among countersinks.
#[test]
fn both_ends_of_a_bore_are_broken() {
    for name in ["bore-chamfers", "bore-chamfers-small", "taper-bore"] {
        let operation = planned(name);
        assert_eq!(wrong(&operation), [""; 0], "{name}: {:?}", operation.findings);
        let second = operation.set_ups[1].jobs.iter().filter(|job| job.side == Side::Inner);
        let works: Vec<Work> = second.map(|job| job.work).collect();
        assert!(works.iter().all(|work| matches!(work, Work::Rough | Work::Finish)), "{name}: {works:?}");
        assert_eq!(works.is_empty(), name == "taper-bore", "{name}");
    }
    let narrow = planned("taper-before-ream");
    assert_eq!(wrong(&narrow), ["no-bar-for-bore", "surface-not-finished"], "{:?}", narrow.findings);
}

/// 150 mm beside a steady rest and 350 mm of bar behind it: without the rest the bar bends too far. No tool of the first set-up comes to
/// the rest, whose front is at Z -170; what is behind is turned from the other end; the rest is a body that a motion past it strikes.
#[test]
fn a_steady_rest_holds_the_free_end() {
    let operation = planned("rest");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    let [first, second] = operation.set_ups.as_slice() else { panic!() };
    let deepest = |set_up: &SetUpWork, side: Side| {
        let jobs = set_up.jobs.iter().filter(|job| job.side == side);
        jobs.flat_map(|job| &job.path.moves).map(|one| one.to.z).max().unwrap()
    };
    assert!(deepest(first, Side::Outer) < Half::from(170.0) && first.jaws.unwrap().front_mm > Half::from(210.0));
    assert!(second.set_up.rest.is_none() && deepest(second, Side::Outer) >= Half::from(350.0));
    let past = Motion {
        kind: MotionKind::Rapid,
        path: Piece::Line { from: At::new(Mm(5.0), Mm(45.0)), to: At::new(Mm(-250.0), Mm(45.0)) },
        tool: first.jobs.iter().position(|job| job.work == Work::Finish && job.side == Side::Outer).unwrap(),
        lead: None,
        start: technolog_turning_proof::Degrees(0.0),
        block: Block(1),
    };
    let proof = prove_set_up(&operation, &[], first, vec![past], None).proof.unwrap();
    let struck: Vec<_> = proof.faults.iter().filter(|fault| fault.code() == "swept-struck").collect();
    assert!(format!("{struck:?}").contains("body-rest"), "{struck:?}");
    let path = format!("{}/tests/everyday/rest.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let without: String =
        text.lines().filter(|line| !line.starts_with("steady_rest")).map(|line| format!("{line}\n")).collect();
    let alone = plan(&read_turned(&path, &without, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    assert!(wrong(&alone).contains(&"bounds-exceeded"), "{:?}", wrong(&alone));
}

/// The cup has one cylinder and 9 mm of bar behind it: nothing holds it. What can be cut is made whole. Turned over, the plug has
/// nothing but a thread and 7.5 mm of Ø45: it is held by the thread in a split bushing.
#[test]
fn a_part_that_nothing_holds_is_told() {
    let operation = planned("cup");
    assert_eq!(wrong(&operation), ["set-up-not-held"], "{:?}", operation.findings);
    let operation = planned("plug");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    assert!(matches!(operation.set_ups[1].set_up.holds_at, Some(Hold::Surface { threaded: true, .. })));
}

/// Holes that no bar enters, and flat bottoms: a reamed bushing, a hole behind a bored seat, a blind hole with the cone of its drill,
/// a pot, a sleeve bored from both ends.
#[test]
fn holes_on_the_axis_are_made_whole() {
    for name in ["reamed", "nozzle", "blind", "pot", "two-bores", "reamed-fine", "tube-drilled-out"] {
        let operation = planned(name);
        assert_eq!(wrong(&operation), [""; 0], "{name}: {:?}", operation.findings);
    }
}

/// The handbook's way to 12H7: drill 11, core drill 11.85, rough reamer 11.95, reamer 12. The drill goes past the blade that parts
/// the bushing off: 30 of the part, 1 of stock, 3 of blade, 3.3 of its point, 2 beyond.
#[test]
fn a_hole_is_reamed_by_the_handbook_and_parted() {
    let operation = planned("reamed");
    let jobs = &operation.set_ups[0].jobs;
    let sizes: Vec<(Work, String)> = jobs
        .iter()
        .filter_map(|job| match job.tool.body {
            Body::Drill { diameter_mm, .. } if job.work == Work::Drill => Some((job.work, diameter_mm.to_string())),
            Body::Reamer { diameter_mm, .. } if job.work != Work::Countersink => {
                Some((job.work, diameter_mm.to_string()))
            }
            _ => None,
        })
        .collect();
    let size = |work, size: &str| (work, size.to_owned());
    let expected =
        [size(Work::Drill, "11"), size(Work::CoreDrill, "11.85"), size(Work::Ream, "11.95"), size(Work::Ream, "12")];
    assert_eq!(sizes, expected);
    // Practice feeds the last reamer of a fine hole 0.002 inch a flute, 0.406 mm/rev with the 8 of Ø11 to 22, and no faster than the
    // rough one.
    let reamers: Vec<_> = jobs.iter().filter(|job| job.work == Work::Ream).map(|job| &job.pace).collect();
    let rpm = |pace: &Pace| match pace {
        Pace::PerRev { speed: Speed::Spindle(rpm), .. } => rpm.0,
        other => panic!("{other:?}"),
    };
    assert_eq!(reamers[1].feeds().unwrap().plunge.0, 0.406);
    assert!(rpm(reamers[1]) <= rpm(reamers[0]), "{reamers:?}");
    let drill = jobs.iter().find(|job| job.work == Work::Drill).unwrap();
    let tip = drill.path.moves.iter().map(|one| one.to.z.to_mm()).fold(0.0, f64::max);
    assert!((tip - (30.0 + 1.0 + 3.0 + 5.5 / 59_f64.to_radians().tan() + 2.0)).abs() < 0.001, "{tip}");
    assert_eq!(operation.set_ups[0].parted_mm.map(|z| z.to_mm()), Some(31.0));
}

/// Ø12H7 of Ra 0.8 is reamed twice here: nothing is left to a grinder.
#[test]
fn a_reamed_hole_is_not_ground_as_well() {
    let operation = planned("reamed-fine");
    assert!(operation.elsewhere.is_empty(), "{:?}", operation.elsewhere);
    let reamers = operation.set_ups[0].jobs.iter().filter(|job| job.work == Work::Ream);
    assert_eq!(reamers.count(), 2);
}

/// The Ø8 bore of a tube leads the first tool: no spot, and nothing narrower than the bore.
#[test]
fn a_tube_is_drilled_out_from_its_own_bore() {
    let operation = planned("tube-drilled-out");
    let jobs = &operation.set_ups[0].jobs;
    assert!(jobs.iter().all(|job| job.work != Work::Centre), "{jobs:?}");
    let first = jobs.iter().find(|job| job.side == Side::Inner).unwrap();
    assert!(matches!(first.tool.body, Body::Drill { diameter_mm, .. } if diameter_mm.to_mm() > 8.0), "{first:?}");
}

/// The handbook's core drill before 12H7 is of Ø11.85: it cuts nothing in a tube of Ø11.9, and that is said instead of programmed.
#[test]
fn a_cutter_no_wider_than_the_hole_is_told() {
    let operation = planned("tube-without-stock");
    assert!(wrong(&operation).contains(&"job-no-stock"), "{:?}", operation.findings);
    let jobs = operation.set_ups.iter().flat_map(|set_up| &set_up.jobs);
    assert!(jobs.map(|job| job.work).all(|work| work != Work::CoreDrill && work != Work::Ream));
}

/// A bore of Ø36: a drill of 30 to the bottom, then a flat one. What the bar faces of the bottom is left as thin as its edge takes:
/// half of 6·sin 5° = 0.26.
#[test]
fn a_flat_bottom_is_made_flat_before_it_is_bored() {
    let operation = planned("pot");
    let jobs = &operation.set_ups[0].jobs;
    let deepest = |work| {
        let job = jobs.iter().find(|job| job.work == work && job.side == Side::Inner).unwrap();
        job.path.moves.iter().map(|one| one.to.z.to_mm()).fold(0.0, f64::max)
    };
    let stock = 30.0 - deepest(Work::Flatten);
    assert!((stock - 0.5 * 6.0 * 5_f64.to_radians().sin()).abs() < 0.001, "{stock}");
    assert_eq!(deepest(Work::Drill), deepest(Work::Flatten));
    assert_eq!(deepest(Work::Finish), 30.0);
}

/// A bar of Ø28 with 49 mm behind the stud is parted with 1 mm for the face; one of Ø65 is too thick for any blade of the catalog.
#[test]
fn a_long_thin_bar_is_parted_off() {
    let stud = planned("stud");
    assert_eq!(stud.set_ups[0].parted_mm.map(|z| z.to_mm()), Some(42.0));
    assert!(stud.set_ups[0].jobs.last().is_some_and(|job| job.work == Work::PartOff));
    assert!(planned("spool").set_ups.iter().all(|set_up| set_up.parted_mm.is_none()));
}

/// The grooves for retaining rings are as wide as their blades: one plunge each.
#[test]
fn rings_have_blades_of_their_width() {
    let axle = planned("circlip");
    let blades: Vec<_> =
        axle.set_ups.iter().flat_map(|set_up| &set_up.jobs).filter(|job| job.work == Work::Groove).collect();
    let names: Vec<&str> = blades.iter().map(|job| job.tool.designation.as_str()).collect();
    assert_eq!(names, ["CGR-1.3", "CGR-2.15"]);
}

/// Nothing of the stub is long enough for jaws (4 mm of Ø34, 8 are the least): it is parted to length, and its rough face is told.
#[test]
fn what_nothing_holds_is_parted_to_length_and_told() {
    let stub = planned("stub");
    assert_eq!((stub.set_ups.len(), wrong(&stub)), (1, vec![]));
    assert_eq!(stub.set_ups[0].parted_mm.map(|z| z.to_mm()), Some(27.0));
    assert!(stub.findings.iter().any(|finding| finding.note.code() == "far-face-as-parted"));
}

/// The shaft of 238 mm comes as 244 mm of bar, of which 2 + 4 are faced off before; its page must not tell to saw it shorter.
#[test]
fn a_blank_between_centres_is_that_of_the_file() {
    let shaft = planned("shaft");
    assert_eq!(shaft.blank_before.map(|blank| blank.length().to_mm()), Some(244.0));
}

/// The rounding is not led on straight into the cone behind it, which rises from there (found at random, seed 29), but along it.
#[test]
fn a_rounding_does_not_run_into_a_cone() {
    let operation = planned("cone-and-rounding");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
}

/// By hand: the middle of the pitch diameter of M24x2-6g (22.493 to 22.663, ISO 965-2) puts the roots 2/3 H below it, at Ø21.4233;
/// from crests of Ø23.822 the tool leaves at 45° over 1.2 mm of metal. ГОСТ 10549-80 allows 3.5.
#[test]
fn a_thread_without_a_relief_runs_out_behind_it() {
    let operation = planned("run-out");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    let jobs = &operation.set_ups[0].jobs;
    let thread = jobs.iter().find(|job| job.work == Work::Thread).unwrap();
    let deepest = thread.path.moves.iter().filter(|one| one.to.radius.to_mm() < 10.72);
    let end = deepest.map(|one| one.to.z.to_mm()).fold(0.0, f64::max);
    assert!((end - 26.5).abs() < 0.001, "full depth ends at the drawn end: {end}");
    let behind = thread.path.moves.iter().filter(|one| one.to.z.to_mm() > 26.5);
    assert!(behind.clone().count() > 0);
    // 26.5 and 2.2 at 45° to 1 mm above the crests: 1.2 of them in the metal.
    assert!(behind.clone().all(|one| one.to.z.to_mm() < 28.8 && one.to.radius.to_mm() > 12.9), "{behind:?}");
}

/// The same on a seat of h7 would score it.
#[test]
fn a_thread_does_not_run_out_on_a_seat() {
    let operation = planned("run-out-on-seat");
    let codes: Vec<&str> = operation.findings.iter().map(|finding| finding.note.code()).collect();
    assert!(codes.contains(&"thread-run-out-on-seat"), "{codes:?}");
    assert!(!wrong(&operation).is_empty(), "{codes:?}");
}

/// A turner: neither h6 nor Ra 0.8 is on a raw bar, so nothing can be left there for grinding; drawn bars begin at h9 (ГОСТ 7417-75).
/// Of 26.2 the skin stays on under 0.15 a side. A bar of 27 is turned.
#[test]
fn a_raw_bar_is_no_fit() {
    let of = |bar: &str, asked: &str| {
        let text = format!(
            "shaft: P\nmaterial: steel-45\nmachine: 16k20f3\nblank: {{kind: bar, diameter: {bar}, length: 60, face: 1}}\n\
             outer:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 26}}\n  - {{cylinder: -35, name: seat, {asked}}}\n"
        );
        let operation = plan(&read_turned("P", &text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
        (wrong(&operation).iter().map(|code| code.to_string()).collect::<Vec<_>>(), operation.elsewhere.len())
    };
    let raw = |later| (vec!["surface-of-blank".to_owned()], later);
    assert_eq!(of("26", "grade: h6, roughness: Ra 0.8"), raw(0));
    assert_eq!(of("26", "grade: h8, roughness: Ra 3.2"), raw(0));
    assert_eq!(of("26", "grade: h9, roughness: Ra 3.2"), (vec![], 0));
    assert_eq!(of("26.2", "grade: h6, roughness: Ra 0.8"), (vec!["blank-thin-for-elsewhere".to_owned()], 1));
    assert_eq!(of("30", "grade: h6, roughness: Ra 0.8"), (vec![], 1));
}

/// A turner: 6.5 mm of Ø40 between the jaws and 38 kN are wrong, whatever the length of the collar.
#[test]
fn too_short_a_grip_is_wrong() {
    let text = "shaft: P\nmaterial: steel-45\nmachine: 16k20f3\nblank: {kind: bar, diameter: 45, length: 80, face: 1.5}\n\
                outer:\n  - {from: {d: 0, z: 0}}\n  - {face: 17.78}\n  - {cone: {d: 24, z: -50}}\n  - {cylinder: -54}\n  \
                - {face: 40}\n  - {chamfer: 1.5}\n  - {cylinder: -65}\n";
    let operation = plan(&read_turned("P", text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    assert_eq!(wrong(&operation), ["jaws-grip-too-little"], "{:?}", operation.findings);
}

/// Grey iron is cut dry (rule `coolant`, row 1): no program of it starts the coolant; one of steel does.
#[test]
fn grey_iron_has_no_coolant() {
    for (material, starts) in [("cast-iron-sch20", false), ("steel-45", true)] {
        let text = format!(
            "shaft: P\nmaterial: {material}\nmachine: 16k20f3\nblank: {{kind: bar, diameter: 50, length: 90, face: 1}}\n\
             outer:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 40}}\n  - {{cylinder: -30}}\n  - {{face: 46}}\n  - \
             {{cylinder: -50}}\n"
        );
        let operation = plan(&read_turned("P", &text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
        assert_eq!(operation.set_ups[0].jobs.iter().all(|job| !job.dry), starts);
        let programs = programs(&operation, "fanuc", Form::Motions, None, &KNOWLEDGE).unwrap();
        let files = programs[0].files.as_ref().unwrap();
        assert_eq!(files[0].text.lines().any(|line| line == "M8"), starts, "{}", files[0].text);
    }
}

/// LinuxCNC moves K along the way in a turn, so on a slope Z goes on by the pitch only with K = P·√(Δz² + Δr²)/Δz (manual of G33);
/// Fanuc takes the lead along Z. M24x2.
#[test]
fn the_lead_of_a_run_out_is_that_of_the_control() {
    let operation = planned("run-out");
    let text = |control| {
        let made = programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap();
        made[0].files.as_ref().unwrap()[0].text.clone()
    };
    let number = |line: &str, address| {
        line.split_whitespace().find_map(|word| word.strip_prefix(address)).and_then(|it: &str| it.parse::<f64>().ok())
    };
    let (mut at, mut slopes) = ((0.0, 0.0), 0);
    for line in text("linuxcnc").lines() {
        let to = (number(line, "X").unwrap_or(at.0), number(line, "Z").unwrap_or(at.1));
        let (dx, dz) = ((to.0 - at.0) / 2.0, to.1 - at.1);
        if let Some(lead) = number(line, "K").filter(|_| number(line, "I").is_none()) {
            let along = if dx == 0.0 { 2.0 } else { 2.0 * (dx * dx + dz * dz).sqrt() / dz.abs() };
            assert!((lead - along).abs() < 1e-3, "{line}: {along}");
            slopes += usize::from(dx != 0.0);
        }
        at = to;
    }
    assert!(slopes > 3, "{slopes}");
    let leads: Vec<f64> =
        text("fanuc").lines().filter(|line| line.contains("G32")).filter_map(|line| number(line, "F")).collect();
    assert!(!leads.is_empty() && leads.iter().all(|lead| *lead == 2.0), "{leads:?}");
}

/// By hand, with the rows of `time-norms`: (4 + 0.5 + 2·0.5)·1.08 = 5.94; 4 + 2 + 2 + 12 + 10 + 2·1 + 2·2.5 + 4.5 = 41.5, as three of the
/// five tools are in the setting. H7 and H8 of the bore are gauged, the cylinder without a grade is not.
#[test]
fn a_bushing_has_the_norm_of_time_by_hand() {
    let gauges = gauges(&planned("../../examples/turned-bushing"));
    assert_eq!(gauges, [TimeNorm::PlugFine; 2]);
    let work = NormedWork {
        cutting: Minutes(4.0),
        machine: Minutes(0.5),
        hands: Minutes(0.0),
        loading: vec![NormItem { key: "norm-loading", count: 2, each: Minutes(0.5), because: None }],
        gauges,
        settings: 1,
        soft_jaws: 1,
        tools: 5,
        zeros: 2,
    };
    let norm = norm_of(work, GivenTimes::default(), &KNOWLEDGE).unwrap();
    assert_eq!((norm.piece, norm.preparatory), (Some(Minutes(5.94)), Minutes(41.5)));
}
