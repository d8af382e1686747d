//! Threads between the limits of their pitch diameter.

use std::collections::BTreeSet;

use technolog::audit::turned::{read_back, reader};
use technolog::note::Note;
use technolog::program::lathe::{LatheAct, LatheLanguage, Subprogram, read};
use technolog::turning::contour::Side;
use technolog::turning::jobs::ThreadCut;
use technolog::turning::length::Half;
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::proof::{motions, prove_set_up, rejects};
use technolog::turning::operation::setting::setting;
use technolog::turning::program::{Control, NotCycled};
use technolog::turning::toolpath::Purpose;
use technolog::turning::workpiece::{Workpiece, read_turned};
use technolog_testing::KNOWLEDGE;
use technolog_turning_proof::{At, Fault, Mm, Motion, Piece, What};

use super::operation::{example, planned};

/// Faults of the threads of a part whose threading tool stands so much further out, mm on the radius.
fn thread_faults(workpiece: &Workpiece, out: f64) -> Vec<Fault> {
    let operation = planned(workpiece);
    let works = &operation.set_ups;
    let set_up = works.iter().find(|work| work.jobs.iter().any(|job| job.thread.is_some())).unwrap();
    let further = |at: At| At { radius: Mm(at.radius.0 + out), ..at };
    let jobs = set_up.jobs.iter().enumerate();
    let motions = jobs.flat_map(|(index, job)| {
        let of_thread = job.thread.is_some();
        motions(&job.path, index).into_iter().map(move |motion| match motion.path {
            Piece::Line { from, to } if of_thread => {
                Motion { path: Piece::Line { from: further(from), to: further(to) }, ..motion }
            }
            _ => motion,
        })
    });
    let proven = prove_set_up(&operation, &operation.proven, set_up, motions.collect(), None);
    let of_thread = |fault: &Fault| matches!(fault.what, What::ThreadShallow { .. } | What::Gouge { .. });
    proven.proof.unwrap().faults.into_iter().filter(of_thread).collect()
}

/// d2 of M30x2-6g may lie 0.085 above and below its middle, D2 of M36x2-6H 0.112: an offset by half of that is still good, one
/// that is 0.02 more is not, whichever way. The tip of an insert is rounded, in a bore by H/12: its root lies beyond Ø36.
#[test]
fn a_thread_is_good_within_the_limits_of_its_pitch_diameter() {
    const NUT: &str = "shaft: Nut\nmaterial: steel-45\nblank: {kind: bar, diameter: 60, length: 90, face: 1}\n\
         machine: 16k20f3\nouter:\n  - {from: {d: 34, z: 0}}\n  - {face: 56}\n  - {cylinder: -40}\n\
         inner:\n  - {from: {d: 34, z: 0}}\n  - {thread: M36x2-6H, to: -40}\n";
    let nut = read_turned("part", NUT, &KNOWLEDGE).unwrap();
    for (part, half, inwards) in [(&example("turned-stepped"), 0.0425, -1.0), (&nut, 0.056, 1.0)] {
        for out in [0.0, 0.04, -0.04] {
            assert_eq!(thread_faults(part, out), [], "{}: {out}", part.name);
        }
        let deep = thread_faults(part, inwards * (half + 0.02));
        assert!(matches!(&deep[..], [Fault { what: What::Gouge { .. }, .. }]), "{}: {deep:?}", part.name);
        let shallow = thread_faults(part, -inwards * (half + 0.02));
        let [Fault { what: What::ThreadShallow { left }, .. }] = &shallow[..] else {
            panic!("{}: {shallow:?}", part.name)
        };
        assert!((left.0 - 0.018).abs() < 0.001, "{}: {left:?}", part.name);
    }
    let operation = planned(&nut);
    assert!(operation.set_ups.iter().all(|work| rejects(&operation, work.set_up.number).is_none()));
}

/// The turned parts whose threads the cycles of all controls are tried on.
fn threaded() -> Vec<Workpiece> {
    // P 1.5 is fed straight in, P 2 along the flank; the nut is cut from inside.
    let shaft = |thread: &str| {
        let text = format!(
            "shaft: Pin\nmaterial: steel-45\nblank: {{kind: bar, diameter: 45, length: 120}}\nmachine: 16k20f3\n\
             outer:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 20}}\n  - {{thread: {thread}, to: -30}}\n  \
             - {{groove: thread-relief}}\n  - {{face: 40}}\n  - {{cylinder: -60}}\n"
        );
        read_turned("part", &text, &KNOWLEDGE).unwrap()
    };
    vec![shaft("M20x1.5-6g"), shaft("M20x2.5-6g"), shaft("M20x1-6g"), example("turned-stepped")]
}

/// The beginning of each pass of the threads of a set-up as they are planned: radius, and Z of the program.
pub(super) fn of_path(operation: &Operation, set_up: u8) -> Vec<(f64, f64)> {
    let work = operation.set_ups.iter().find(|work| work.set_up.number == set_up).unwrap();
    let jobs = work.jobs.iter().filter(|job| job.thread.is_some());
    let pieces = jobs.flat_map(|job| job.path.pieces().collect::<Vec<_>>());
    let threads = pieces.filter(|(_, purpose)| *purpose == Purpose::Thread);
    threads.map(|(piece, _)| (piece.from.radius.to_mm(), -piece.from.z.to_mm())).collect()
}

/// The beginning of each pass of a cycle by equal areas, h·√(n/N), and once more at the last depth: radius, and Z of the program.
pub(super) fn by_areas(operation: &Operation, set_up: u8) -> Vec<(f64, f64)> {
    let work = operation.set_ups.iter().find(|work| work.set_up.number == set_up).unwrap();
    let jobs = work.jobs.iter().filter_map(|job| Some((job.side, job.thread.as_ref()?)));
    let passes = jobs.flat_map(|(side, cut)| {
        let out = if side == Side::Outer { -1.0 } else { 1.0 };
        let (count, whole) = (cut.cycle_depths_mm.len() - 1, cut.depths_mm[cut.depths_mm.len() - 1].to_mm());
        let depths = (1..=count).chain([count]).map(move |n| whole * libm::sqrt(n as f64 / count as f64));
        let slope = libm::tan(cut.infeed_angle_deg.0.to_radians());
        let (crest, from) = (cut.crest_radius_mm.to_mm(), cut.from_z_mm.to_mm());
        depths.map(move |depth| (crest + out * depth, -(from - (whole - depth) * slope))).collect::<Vec<_>>()
    });
    passes.collect()
}

/// What the controls make of their cycles, as the readers know it from the manuals, is what was planned, to 0.005 mm; a
/// thread that no cycle makes so is cut by single passes, and it is said why.
#[test]
fn the_cycles_of_the_controls_make_the_planned_passes() {
    let mut cycled = BTreeSet::new();
    for part in threaded() {
        let operation = planned(&part);
        for control in ["linuxcnc", "fanuc", "sinumerik"] {
            for written in programs(&operation, control, Form::Cycles, None, &KNOWLEDGE).unwrap() {
                let planned = of_path(&operation, written.set_up);
                let Ok(files) = &written.files else { panic!("{} {control}: {written:?}", part.name) };
                let text = &files[0].text;
                let has_cycle = text.contains("G76") || text.contains("CYCLE97");
                assert_eq!(has_cycle, !planned.is_empty() && written.remarks.is_empty(), "{control}\n{text}");
                assert_eq!(text.contains("NOT-CYCLED"), !written.remarks.is_empty());
                let planned = if has_cycle { by_areas(&operation, written.set_up) } else { planned };
                assert!(read_back(&operation, written.set_up, control, files, &KNOWLEDGE).unwrap().is_none(), "{text}");
                let language = LatheLanguage::read(reader(control, &KNOWLEDGE).unwrap().unwrap(), &KNOWLEDGE).unwrap();
                let beside: Vec<Subprogram<'_>> = files[1..]
                    .iter()
                    .map(|file| Subprogram { name: file.name.trim_end_matches(".SPF"), text: &file.text })
                    .collect();
                let run = read(text, &language, &beside);
                let threads = run.motions.iter().filter(|motion| matches!(motion.act, LatheAct::Thread { .. }));
                let made: Vec<(f64, f64)> =
                    threads.map(|motion| motion.from.point().unwrap()).map(|at| (at.radius_mm, at.z_mm)).collect();
                assert_eq!(made.len(), planned.len(), "{control}\n{text}");
                for (made, planned) in made.iter().zip(&planned) {
                    let off = (made.0 - planned.0).abs().max((made.1 - planned.1).abs());
                    assert!(off <= 0.005, "{control}: {made:?} {planned:?}\n{text}");
                }
                if has_cycle {
                    cycled.insert(control);
                }
            }
        }
    }
    assert_eq!(cycled.into_iter().collect::<Vec<_>>(), ["fanuc", "linuxcnc", "sinumerik"]);
}

/// M20x1.5-6g in steel, by hand. d2 lies between 18.854 and 18.994, d between 19.732 and 19.968 (ISO 965-1): the middles are
/// 18.924 and 19.85. H = 1.29904; an insert of full profile has r = H/6, so that its root is H/3 = 0.43301 below the pitch line:
/// r 9.029, X18.058, and h = 9.925 − 9.029 = 0.896. Six passes and a spring pass, fed straight in, 1 mm over the crests.
///
/// - LinuxCNC manual, G76: I −2 and K 1.792 as diameters; R2 means J·√n, so J = 1.792/√6 = 0.73158, a little more: 0.7316.
/// - Fanuc: P 896 and Q 0.896/√6 = 365.79 µm, a little more: 366. The thinnest pass is the last, 0.896·(1 − √(5/6)) = 0.07806: 78.
///   Two passes at the whole depth, no chamfer, the tip as one that is fed straight in: P020000.
/// - Sinumerik: TDEP 0.896, IANG 0, NRC 6, NID 1, VARI 3 (outside, equal areas), _VRT 1.
#[test]
fn the_arguments_of_the_cycles_are_those_worked_out_by_hand() {
    let operation = planned(&threaded()[0]);
    for (control, parts) in [
        ("linuxcnc", ["G76 P1.5 Z-30.", " I-2 J0.7316 K1.792 R2 Q0 H1\n"].as_slice()),
        ("fanuc", &["\nG76 P020000 Q78 R0\nG76 X18.058 Z-30.", " P896 Q366 F1.5\n"]),
        ("sinumerik", &["CYCLE97(1.5, , 0, -30, 19.85, 19.85, 3, 0.", ", 0.896, 0, 0, 0, 6, 1, 3, 1, 1)\n"]),
    ] {
        let written = programs(&operation, control, Form::Cycles, None, &KNOWLEDGE).unwrap();
        let text = &written[0].files.as_ref().unwrap()[0].text;
        let after = parts.iter().try_fold(text.as_str(), |rest, part| rest.split_once(part).map(|(_, rest)| rest));
        assert!(after.is_some(), "{control}\n{text}");
    }
}

/// Why no cycle: along the flank Fanuc has 30 degrees, not 29.5, which over h − h/√8 of M30x2 is 0.7754·(tan 30° − tan 29.5°) =
/// 0.009 mm. Cycles do not draw the tool out as we do, and passes that follow no law of theirs are not theirs.
#[test]
fn a_thread_that_no_cycle_makes_as_planned_says_why() {
    let stepped = planned(&example("turned-stepped"));
    let remarks = |operation: &Operation, control: &str| -> Vec<Note> {
        let written = programs(operation, control, Form::Cycles, None, &KNOWLEDGE).unwrap();
        written.into_iter().flat_map(|one| one.remarks).collect()
    };
    let [fanuc] = &remarks(&stepped, "fanuc")[..] else { panic!("one remark") };
    let off: f64 = fanuc.figure_text("off").unwrap().parse().unwrap();
    assert!(fanuc.code() == "not-cycled-passes" && (off - 0.009).abs() < 0.0008, "{fanuc:?}");
    assert_eq!(remarks(&stepped, "linuxcnc"), []);
    let cuts = stepped.set_ups.iter().flat_map(|work| &work.jobs).filter_map(|job| job.thread.clone());
    let [cut] = &cuts.collect::<Vec<_>>()[..] else { panic!("one thread") };
    let changed = |change: fn(&mut ThreadCut)| {
        let mut cut = cut.clone();
        change(&mut cut);
        cut
    };
    let drawn_out = changed(|cut| cut.pulled_out = true);
    // A tenth of the first pass more in the second one; and without the fourth pass, which the one after it then takes too.
    let uneven = changed(|cut| cut.cycle_depths_mm[1] = cut.cycle_depths_mm[1] + Half::from(0.04));
    let fewer = changed(|cut| {
        cut.cycle_depths_mm.remove(3);
    });
    for control in ["linuxcnc", "sinumerik"] {
        let control = Control::read(control, &KNOWLEDGE).unwrap();
        let cycle = |cut: &ThreadCut| control.thread_cycle(cut, Side::Outer);
        assert_eq!(cycle(&drawn_out), Err(NotCycled::PulledOut));
        for other in [&uneven, &fewer] {
            assert!(
                matches!(cycle(other), Err(NotCycled::Passes { off }) if off > Half::from(0.03)),
                "{:?}",
                cycle(other)
            );
        }
        assert!(cycle(cut).is_ok());
    }
    let unknown = Control::read("nc-201", &KNOWLEDGE).unwrap();
    assert_eq!(unknown.thread_cycle(cut, Side::Outer), Err(NotCycled::Unknown));
    // The setting sheet of the control says it too.
    let sheet = setting(&stepped, "fanuc", &KNOWLEDGE).unwrap();
    assert_eq!(sheet.threads[0].cycle.as_ref().unwrap().code(), "thread-not-cycled");
    let sheet = setting(&stepped, "sinumerik", &KNOWLEDGE).unwrap();
    assert_eq!(sheet.threads[0].cycle.as_ref().unwrap().code(), "thread-cycled");
}

/// D1 of M36x2 is 33.835, of 6H up to 34.21 (TD1 0.375, ISO 965-1). On a bore of Ø34.1 the thread is whole; on Ø35 its crests are
/// (36 − 35)/(36 − 33.835) = 46 % of their height, which is told, and the passes begin at the wall: H = 1.732, D2 34.701 + 0.112,
/// a tip of H/12, so the roots are at 34.813 + 2·(H/2 − H/12) = 36.256, and the depth is (36.256 − 35)/2 = 0.628.
#[test]
fn a_thread_is_turned_in_any_bore_below_its_nominal_diameter() {
    let nut = |bore: &str| {
        let text = format!(
            "shaft: Nut\nmaterial: steel-45\nblank: {{kind: tube, diameter: 65, bore: 30, length: 90, face: 1}}\nmachine: \
             16k20f3\nouter:\n  - {{from: {{d: {bore}, z: 0}}}}\n  - {{face: 60}}\n  - {{cylinder: -40}}\ninner:\n  \
             - {{from: {{d: {bore}, z: 0}}}}\n  - {{thread: M36x2-6H, to: -40}}\n"
        );
        planned(&read_turned("part", &text, &KNOWLEDGE).unwrap())
    };
    let wide = |operation: &Operation| -> Option<String> {
        let told = operation.findings.iter().find(|finding| finding.note.code() == "thread-bored-wide")?;
        told.note.figure_text("share")
    };
    assert_eq!(wide(&nut("34.1")), None);
    let operation = nut("35");
    assert_eq!(wide(&operation).as_deref(), Some("46"));
    let cuts = operation.set_ups.iter().flat_map(|work| &work.jobs).filter_map(|job| job.thread.clone());
    let depth = cuts.flat_map(|cut| cut.depths_mm).max().unwrap();
    assert!((depth.to_mm() - 0.628).abs() < 0.001, "{depth:?}");
    assert!(operation.set_ups.iter().all(|work| rejects(&operation, work.set_up.number).is_none()));
}
