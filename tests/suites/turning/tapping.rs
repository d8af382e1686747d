//! Threads that are drilled and tapped on the axis. Drills are those of ГОСТ 19257 (ISO 2306): M10 8.5, M12 10.2, M16x1.5 14.5, M30
//! 26.5; leads are three pitches, and one turn is left for the spindle to stop in (`hole-defaults`, `turning-job-limits`).

use technolog::audit::turned::{compare_with_part, read_back};
use technolog::note::{Note, Severity};
use technolog::program::lathe::{LatheLanguage, Subprogram, read};
use technolog::turning::contour::Side;
use technolog::turning::jobs::{Body, Job, Work};
use technolog::turning::length::Half;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::setting::setting;
use technolog::turning::operation::{Operation, SetUpWork, plan};
use technolog::turning::program::Speed;
use technolog::turning::workpiece::read_turned;
use technolog::units::RevsPerMinute;
use technolog_testing::KNOWLEDGE;

fn read_part(path: &str, text: &str) -> Operation {
    plan(&read_turned(path, text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap()
}

fn text(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/everyday/{name}.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn planned(name: &str) -> Operation {
    read_part(name, &text(name))
}

fn wrong(operation: &Operation) -> Vec<&str> {
    let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    wrong.map(|finding| finding.note.code()).collect()
}

fn drills(set_up: &SetUpWork) -> Vec<String> {
    let drilled = set_up.jobs.iter().filter(|job| job.work == Work::Drill);
    drilled.map(|job| job.tool.diameter().unwrap().to_string()).collect()
}

fn tap_of(set_up: &SetUpWork) -> &Job {
    set_up.jobs.iter().find(|job| job.work == Work::Tap).unwrap()
}

fn deepest(job: &Job) -> f64 {
    job.path.moves.iter().map(|one| one.to.z.to_mm()).fold(f64::MIN, f64::max)
}

#[test]
fn everyday_threads_are_tapped_whole() {
    for name in ["tapped-through", "tapped-blind", "tapped-far", "tapped-m30"] {
        let operation = planned(name);
        assert_eq!(wrong(&operation), [""; 0], "{name}: {:?}", operation.findings);
        let taps = operation.set_ups.iter().flat_map(|one| &one.jobs).filter(|job| job.work == Work::Tap);
        assert_eq!(taps.count(), 1, "{name}");
    }
}

/// The thread ends at 19: the front goes 4.5 of lead and a turn further, to 25. The drill of 8.5 is full to 19 + 7.5, a pitch more, and
/// goes on with its point of 118° and 2 beyond. The chamfer at the far end is countersunk when the part is turned over.
#[test]
fn a_tap_goes_through_with_its_lead() {
    let operation = planned("tapped-through");
    let [first, second] = operation.set_ups.as_slice() else { panic!("{}", operation.set_ups.len()) };
    assert_eq!(drills(first), ["8.5"]);
    let drill = first.jobs.iter().find(|job| job.work == Work::Drill).unwrap();
    assert!((deepest(drill) - (19.0 + 7.5 + 4.25 / 59_f64.to_radians().tan() + 2.0)).abs() < 0.001);
    let tap = tap_of(first);
    assert_eq!(tap.tool.designation, "DIN 371 M10");
    assert_eq!(deepest(tap), 25.0);
    // Behind the drill and the countersink, before the part is cut off.
    let order: Vec<Work> = first.jobs.iter().map(|job| job.work).collect();
    let at = |work| order.iter().position(|one| *one == work).unwrap();
    assert!(at(Work::Drill) < at(Work::Countersink) && at(Work::Countersink) < at(Work::Tap), "{order:?}");
    assert!(at(Work::Tap) < at(Work::PartOff), "{order:?}");
    assert_eq!(second.jobs.iter().filter(|job| job.work == Work::Countersink).count(), 1);
}

/// Handbook: V = 64.8·10^1.2 / (90^0.9·1.5^0.5) = 14.6 m/min, times 1.2 for steel of 600 MPa; shops tap it at 7 to 20 m/min, so the
/// middle of these is taken, 13.5, which is 430 1/min, and the step below is 400. In and back by 25 of depth, 0.5 of allowance on the
/// face and 4.5 of entry: 60 mm at 600 mm/min.
#[test]
fn speed_and_time_of_a_tap_are_those_of_its_formula() {
    let operation = planned("tapped-through");
    let tap = tap_of(&operation.set_ups[0]);
    let pace = tap.pace.feeds().unwrap();
    assert_eq!(pace.thread.0, 1.5);
    assert!(matches!(tap.pace.speed(), Some(Speed::Spindle(RevsPerMinute(rpm))) if rpm == 400.0), "{:?}", tap.pace);
    assert!((tap.time_min.0 - 60.0 / 600.0).abs() < 0.001, "{:?}", tap.time_min);
}

/// Drawn at the least minor diameter of 10.106 it is drilled to 10.2 all the same. Full to 20, the front goes 5.25 deeper and leaves
/// 2.75 to the end of the cylinder.
#[test]
fn a_blind_hole_keeps_its_bottom() {
    let operation = planned("tapped-blind");
    assert_eq!(drills(&operation.set_ups[0]), ["10.2"]);
    assert_eq!(deepest(tap_of(&operation.set_ups[0])), 25.25);
    let inner = operation.workpiece.inner.as_ref().unwrap();
    let radii: Vec<Half> = inner.surfaces[1..3].iter().map(|surface| surface.pieces[0].from.radius).collect();
    assert_eq!(radii, [Half::from(5.1); 2]);
    let thread = &operation.workpiece.threads[0];
    let tapped = thread.tapped.as_ref().unwrap();
    assert_eq!(tapped.hole_mm.to_mm(), 10.2);
    assert!((tapped.largest_hole_mm.to_mm() - 10.441).abs() < 0.006, "ISO 965-2 has 10.441");
}

/// From the far end, 48 - 33 = 15 of full thread: 4.5 deeper. The shoulder around Ø10 is made flat before.
#[test]
fn a_thread_of_the_far_end_is_tapped_in_the_second_set_up() {
    let operation = planned("tapped-far");
    let second = &operation.set_ups[1];
    assert!(second.set_up.turned_over);
    assert_eq!(drills(second), ["14.5"]);
    assert_eq!(deepest(tap_of(second)), 19.5);
    assert!(matches!(tap_of(second).tool.body, Body::Tap { pitch_mm, .. } if pitch_mm.to_mm() == 1.5));
    assert!(second.jobs.iter().any(|job| job.work == Work::Flatten));
}

/// A tap that came through the plain hole would thread it as well: the far thread waits for the second set-up. Both fronts go 3.75 of
/// lead behind 16 and 50 - 34 of full thread.
#[test]
fn threads_of_both_ends_are_tapped_each_from_its_own() {
    let operation = planned("tapped-both-ends");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    let fronts: Vec<f64> = operation.set_ups.iter().map(|one| deepest(tap_of(one))).collect();
    assert_eq!(fronts, [19.75; 2]);
    let surfaces: Vec<String> = operation.set_ups.iter().map(|one| tap_of(one).surfaces[0].to_string()).collect();
    assert_eq!(surfaces, ["inner 2", "inner 4"]);
    assert_eq!((drills(&operation.set_ups[0]), drills(&operation.set_ups[1])), (vec!["6.8".to_owned()], vec![]));
}

/// The bar makes the seat down to the hole, a countersink of 90° goes through it: the point of its cone would end 6.5 below the bottom
/// at 12, its flat front of Ø3.2 (А.21) 1.6 before that.
#[test]
fn a_chamfer_behind_a_seat_is_countersunk() {
    let operation = planned("tapped-in-seat");
    assert_eq!(wrong(&operation), [""; 0], "{:?}", operation.findings);
    let jobs = &operation.set_ups[0].jobs;
    let countersink = jobs.iter().find(|job| job.work == Work::Countersink).unwrap();
    assert!((deepest(countersink) - 16.9).abs() < 0.001, "{}", deepest(countersink));
    assert!(jobs.iter().any(|job| job.work == Work::Finish && job.side == Side::Inner));
    assert_eq!(deepest(tap_of(&operation.set_ups[0])), 40.0 + 7.0);
}

/// M4: six tenths of its drill of 3.3 are 1.98, which the cone of the smallest centre drill of 1 mm opens 0.849 deep behind its pilot of
/// 1.3 (60°, ГОСТ 14034).
#[test]
fn the_spot_of_a_small_thread_is_as_wide_as_its_drill_allows() {
    let text =
        text("tapped-blind").replace("M12-6H", "M4").replace("13.106", "4.6").replace("chamfer: 1.5", "chamfer: 0.65");
    let text =
        text.replace("to: -20", "to: -8").replace("cylinder: -28", "cylinder: -12").replace("-30.917", "-12.991");
    let operation = read_part("m4", &text);
    assert_eq!(wrong(&operation), [""; 0], "{:?}\n{text}", operation.findings);
    let set_up = &operation.set_ups[0];
    let spot = set_up.jobs.iter().find(|job| job.work == Work::Centre).unwrap();
    assert_eq!(spot.spot_diameter(set_up.rough_face()).map(|wide| wide.to_string()), Some("1.98".to_owned()));
}

/// M16x1.5 in steel 45: 10·0.027·16^1.4·1.5^1.5 = 24.1 N·m, times (600/750)^0.75 = 0.85 for its strength. Soft jaws on Ø28 hold it with at
/// least 2·2·20.4/0.028/0.1 = 29 kN.
#[test]
fn the_jaws_hold_against_a_tap() {
    let operation = planned("tapped-far");
    let torque = tap_of(&operation.set_ups[1]).torque_n_m.unwrap().0;
    assert!((torque - 20.4).abs() < 0.2, "{torque}");
    let grip = operation.set_ups[1].grip.as_ref().unwrap();
    assert!(grip.pull_n.0 >= 2.0 * torque / 0.028 - 1.0, "{grip:?}");
}

/// No tap, a tap too short, no room behind the thread: each is told, and the thread is not there.
#[test]
fn what_cannot_be_tapped_is_told() {
    for (name, codes) in [
        ("tapped-no-tap", &["job-bore-too-small", "thread-turned-no-tap", "thread-not-cut"][..]),
        ("tapped-too-deep", &["job-tap-too-short", "thread-not-cut"]),
        ("tapped-no-run-out", &["job-tap-no-run-out", "thread-not-cut"]),
    ] {
        assert_eq!(wrong(&planned(name)), codes, "{name}");
    }
    // The room that it needs: 5.25 of lead and a turn.
    let operation = planned("tapped-no-run-out");
    let told = operation.findings.iter().find(|one| one.note.code() == "job-tap-no-run-out").unwrap();
    let figure = |note: &Note, name: &str| note.figure(name).map(|figure| figure.text().into_owned()).unwrap();
    assert_eq!((figure(&told.note, "needs"), figure(&told.note, "room")), ("7".into(), "2".into()));
    // A plain hole of the drill's diameter before a blind thread would be threaded too, and from the other end there is no hole.
    let plain = text("tapped-blind").replace("  - {thread:", "  - {cylinder: -6}\n  - {thread:");
    assert_eq!(wrong(&read_part("plain", &plain)), ["job-plain-before-tap", "thread-not-cut"]);
}

/// The program of each control is read back and its tap followed through the stock.
#[test]
fn programs_tap_as_the_plan_does() {
    for name in ["tapped-through", "tapped-blind", "tapped-far", "tapped-both-ends", "tapped-in-seat"] {
        let operation = planned(name);
        for control in ["linuxcnc", "fanuc", "sinumerik"] {
            for written in programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap() {
                let files = written.files.unwrap();
                let why = read_back(&operation, written.set_up, control, &files, &KNOWLEDGE).unwrap();
                assert!(why.is_none(), "{name} {control} {}: {why:?}", written.set_up);
            }
        }
    }
}

/// The blocks by hand: M12 at 13.5 m/min is 358 1/min, and a stepless spindle takes it. The tap begins three pitches before the face, which
/// has 0.6 of allowance. A speed that the user states does not drive it faster.
#[test]
fn each_control_has_its_own_words_for_a_tap() {
    let operation = planned("tapped-blind");
    let text = |control: &str, spindle: Option<f64>| {
        let written = programs(&operation, control, Form::Motions, spindle.map(RevsPerMinute), &KNOWLEDGE).unwrap();
        written[0].files.as_ref().unwrap()[0].text.clone()
    };
    for (control, blocks) in [
        ("linuxcnc", "G97 S358 M3\nM8\nG0 X0 Z5.85\nG33.1 Z-25.25 K1.75\nG28\n"),
        ("fanuc", "G0 X0. Z5.85\nM29 S358\nG84 Z-25.25 F1.75\nG80\nG28 U0. W0.\n"),
        ("sinumerik", "G0 X0 Z5.85\nCYCLE84(5.85, 4.85, 1, -25.25, , , 5, , 1.75, 0, 358,358, 1)\nG75 X0 Z0\n"),
    ] {
        assert!(text(control, None).contains(blocks), "{control}\n{}", text(control, None));
    }
    assert!(text("fanuc", Some(900.0)).contains("M29 S358\n"));
    assert!(text("fanuc", Some(200.0)).contains("M29 S200\n"));
}

/// A hand that spoils the program is found out: another pitch, too deep, too short, a feed that is not the pitch, out at rapid, a tap
/// where no drill was.
#[test]
fn a_spoilt_tapping_program_is_found_out() {
    let operation = planned("tapped-blind");
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let good = written[0].files.as_ref().unwrap()[0].text.clone();
    let block = "G33.1 Z-25.25 K1.75";
    assert!(good.contains(block), "{good}");
    let language = LatheLanguage::read("linuxcnc-lathe", &KNOWLEDGE).unwrap();
    let found = |text: &str| {
        let run = read(text, &language, &[] as &[Subprogram<'_>]);
        let faults = compare_with_part(&operation, 1, text, &run, &KNOWLEDGE).unwrap();
        let grave = faults.into_iter().filter(|fault| fault.severity <= Severity::Wrong);
        grave.map(|fault| fault.code).collect::<Vec<_>>()
    };
    assert_eq!(found(&good), [""; 0]);
    for (to, code) in [
        ("G33.1 Z-25.25 K1.5", "swept-tap-out-of-step"),
        ("G33.1 Z-28.5 K1.75", "swept-tap-blocked"),
        ("G33.1 Z-21 K1.75", "swept-thread-short"),
        ("G1 Z-25.25 F1.5", "swept-tap-out-of-step"),
        ("G1 Z-25.25 F1.75", "swept-rapid"),
    ] {
        let codes = found(&good.replace(block, to));
        assert!(codes.contains(&code), "{to}: {codes:?}");
    }
    // The drill stops 10 above its depth.
    let line = good.lines().find(|line| line.starts_with("G1 Z-31.")).unwrap();
    let codes = found(&good.replace(line, "G1 Z-15 F0.1"));
    assert!(codes.contains(&"swept-tap-blocked"), "{codes:?}");
}

/// A tap that is drawn out of its thread while the spindle turns on tears it out, in step or not; turned backwards it leaves it whole,
/// and so it does in the cycles of our own programs.
#[test]
fn a_tap_that_is_drawn_out_without_reversing_is_told() {
    let operation = planned("tapped-blind");
    let (fanuc, sinumerik) =
        ("M29 S358\nG84 Z-25.25 F1.75\nG80\n", "CYCLE84(5.85, 4.85, 1, -25.25, , , 5, , 1.75, 0, 358,358, 1)\n");
    for (control, reader, cycle, enter, out) in [
        ("linuxcnc", "linuxcnc-lathe", "G33.1 Z-25.25 K1.75\n", "G33 Z-25.25 K1.75\n", "G33 Z5.85 K1.75\n"),
        ("linuxcnc", "linuxcnc-lathe", "G33.1 Z-25.25 K1.75\n", "G1 Z-25.25 F1.75\n", "G1 Z5.85\n"),
        ("fanuc", "fanuc-lathe", fanuc, "G97 S358 M3\nG32 Z-25.25 F1.75\n", "G32 Z5.85 F1.75\n"),
        ("sinumerik", "sinumerik", sinumerik, "G97 S358 M3\nG1 Z-25.25 F1.75\n", "G1 Z5.85\n"),
    ] {
        let written = programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap();
        let good = written[0].files.as_ref().unwrap()[0].text.clone();
        let language = LatheLanguage::read(reader, &KNOWLEDGE).unwrap();
        let told = |text: &str| {
            let run = read(text, &language, &[] as &[Subprogram<'_>]);
            let faults = compare_with_part(&operation, 1, text, &run, &KNOWLEDGE).unwrap();
            assert!(faults.iter().any(|fault| fault.code == "turned-held"), "{control} {faults:?}");
            let grave = faults.into_iter().filter(|fault| fault.severity <= Severity::Wrong);
            grave.map(|fault| fault.code).collect::<Vec<_>>()
        };
        assert!(good.contains(cycle), "{good}");
        assert_eq!(told(&good), [""; 0], "{control}");
        for (between, codes) in [("", vec!["turned-tap-torn-out"]), ("M4\n", vec![])] {
            assert_eq!(told(&good.replace(cycle, &format!("{enter}{between}{out}"))), codes, "{control} {between}");
        }
    }
}

/// The setting sheet has the thread with the limits of its pitch diameter, and its tap on the axis.
#[test]
fn a_tap_is_on_the_setting_sheet() {
    let operation = planned("tapped-blind");
    let sheet = setting(&operation, "fanuc", &KNOWLEDGE).unwrap();
    let [thread] = sheet.threads.as_slice() else { panic!("{:?}", sheet.threads) };
    assert_eq!((thread.thread.as_str(), thread.set_up), ("M12-6H", 1));
    assert!(thread.pitch_diameter.is_some() && thread.wire_mm.is_none());
    let tool = sheet.tools.iter().find(|tool| tool.works == [Work::Tap]).unwrap();
    assert_eq!((tool.x.code(), tool.z.code()), ("set-x-axis", "set-z-front"));
}
