//! Threads between the limits of their pitch diameter.

use technolog::turning::operation::proof::{motions, prove_set_up, rejects};
use technolog::turning::workpiece::{Workpiece, read_workpiece};
use technolog_testing::KNOWLEDGE;
use technolog_turning_proof::{At, Fault, Mm, Motion, Piece};

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
    let proven = prove_set_up(&operation, &operation.proven, set_up, motions.collect());
    let of_thread = |fault: &Fault| matches!(fault, Fault::ThreadShallow { .. } | Fault::Gouge { .. });
    proven.proof.unwrap().faults.into_iter().filter(of_thread).collect()
}

/// d2 of M30x2-6g may lie 0.085 above and below its middle, D2 of M36x2-6H 0.112: an offset by half of that is still good, one
/// that is 0.02 more is not, whichever way. The tip of an insert is rounded, in a bore by H/12: its root lies beyond Ø36.
#[test]
fn a_thread_is_good_within_the_limits_of_its_pitch_diameter() {
    const NUT: &str = "shaft: Nut\nmaterial: steel-45\nblank: {kind: bar, diameter: 60, length: 90, face: 1}\n\
         machine: 16k20f3\nouter:\n  - {from: {d: 34, z: 0}}\n  - {face: 56}\n  - {cylinder: -40}\n\
         inner:\n  - {from: {d: 34, z: 0}}\n  - {thread: M36x2-6H, to: -40}\n";
    let nut = read_workpiece("part", NUT, &KNOWLEDGE).unwrap();
    for (part, half, inwards) in [(&example("turned-stepped"), 0.0425, -1.0), (&nut, 0.056, 1.0)] {
        for out in [0.0, 0.04, -0.04] {
            assert_eq!(thread_faults(part, out), [], "{}: {out}", part.name);
        }
        let deep = thread_faults(part, inwards * (half + 0.02));
        assert!(matches!(&deep[..], [Fault::Gouge { .. }]), "{}: {deep:?}", part.name);
        let shallow = thread_faults(part, -inwards * (half + 0.02));
        let [Fault::ThreadShallow { left, .. }] = &shallow[..] else { panic!("{}: {shallow:?}", part.name) };
        assert!((left.0 - 0.018).abs() < 0.001, "{}: {left:?}", part.name);
    }
    let operation = planned(&nut);
    assert!(operation.set_ups.iter().all(|work| rejects(&operation, work.set_up.number).is_none()));
}
