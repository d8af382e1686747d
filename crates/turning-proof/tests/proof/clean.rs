//! Correct work without faults, and its volumes.

use technolog_turning_proof::MotionKind::{Feed, Rapid, Thread as Pass};
use technolog_turning_proof::{
    At, Cutter, Degrees, Fault, Hand, Holder, Mm, Motion, MotionKind, Piece, Profile, ProfilePiece, Sense, SetUp, Side,
    Stock, Thread, Tool, What, Whose, prove,
};

use crate::made::{at, bar_work, bare, chain, insert, is, joined, line, pclnr, program, proven, stock, wrong};

/// Ø40 and Ø60 with a sharp corner between; the contour goes on behind Z−70.
pub fn shaft() -> Vec<ProfilePiece> {
    chain(&[(0.0, 0.0), (0.0, 20.0), (-30.0, 20.0), (-30.0, 30.0), (-70.0, 30.0)])
}

/// Faced to X−2r, roughed in four passes, finished.
pub const SHAFT: [(MotionKind, f64, f64); 25] = [
    (Rapid, 0.0, 34.0),
    (Feed, 0.0, -0.8),
    (Feed, 1.0, -0.8),
    (Rapid, 2.0, 34.0),
    (Rapid, 2.0, 30.3),
    (Feed, -72.0, 30.3),
    (Feed, -72.0, 33.0),
    (Rapid, 2.0, 33.0),
    (Rapid, 2.0, 26.0),
    (Feed, -29.7, 26.0),
    (Feed, -29.7, 31.0),
    (Rapid, 2.0, 31.0),
    (Rapid, 2.0, 22.0),
    (Feed, -29.7, 22.0),
    (Feed, -29.7, 27.0),
    (Rapid, 2.0, 27.0),
    (Rapid, 2.0, 20.3),
    (Feed, -29.7, 20.3),
    (Feed, -29.7, 23.0),
    (Rapid, 2.0, 23.0),
    (Rapid, 2.0, 20.0),
    (Feed, -30.0, 20.0),
    (Feed, -30.0, 30.0),
    (Feed, -72.0, 30.0),
    (Rapid, -72.0, 40.0),
];

pub fn shaft_work(moves: &[(MotionKind, f64, f64)]) -> SetUp {
    bar_work(shaft(), 32.0, (-100.0, 2.0), pclnr(0.8), program(0, (5.0, 40.0), moves))
}

/// The corner keeps a fillet of 0.8, whose middle is 0.8 · (1 − 1/√2) = 0.2343 from both sides.
#[test]
fn a_stepped_shaft_turned_clean_leaves_the_fillet_of_the_nose() {
    let proof = proven(&shaft_work(&SHAFT));
    let [Fault { what: What::Corner { radius, left }, count: 1, .. }] = proof.faults.as_slice() else {
        panic!("{:?}", proof.faults)
    };
    assert!(is(*radius, 0.8) && is(*left, 0.2343), "{radius:?} {left:?}");
}

/// Over Ø40 to Z−30 and Ø60 to Z−70, of Ø64 from Z2: π(32² · 72 − 20² · 30 − 30² · 40) = 80 814 mm³. What the fillet keeps is
/// its area 0.8²(1 − π/4) = 0.1373 on a circle of about 2π · 20.18 = 126.8: 17.4 mm³.
#[test]
fn what_is_removed_is_what_was_to_be_removed() {
    let volumes = proven(&shaft_work(&SHAFT)).volumes;
    let to_remove = std::f64::consts::PI * (1024.0 * 72.0 - 400.0 * 30.0 - 900.0 * 40.0);
    assert!((volumes.to_remove.0 - to_remove).abs() < 1.0, "{volumes:?} {to_remove}");
    assert!((volumes.to_remove.0 - volumes.removed.0 - 17.4).abs() < 0.5, "{volumes:?}");
    assert!((volumes.before.0 - volumes.left.0 - volumes.removed.0).abs() < 1e-6);
}

/// Two plunges make a groove of 5 by 3; its corners keep the corners of the blade.
#[test]
fn a_groove_is_as_wide_as_two_plunges() {
    let part =
        chain(&[(0.0, 0.0), (0.0, 20.0), (-20.0, 20.0), (-20.0, 17.0), (-25.0, 17.0), (-25.0, 20.0), (-40.0, 20.0)]);
    let moves = [
        (Rapid, -25.0, 21.0),
        (Feed, -25.0, 17.0),
        (Feed, -25.0, 21.0),
        (Rapid, -23.0, 21.0),
        (Feed, -23.0, 17.0),
        (Feed, -23.0, 21.0),
        (Rapid, 5.0, 40.0),
    ];
    let work = bar_work(part, 20.0, (-60.0, 0.0), blade(10.0), program(0, (-25.0, 40.0), &moves));
    let faults = proven(&work).faults;
    let corners = faults.iter().map(|fault| match fault {
        Fault { what: What::Corner { radius, left }, count, .. } if is(*radius, 0.2) && is(*left, 0.0586) => *count,
        other => panic!("{other:?}"),
    });
    assert_eq!(corners.sum::<usize>(), 2);
}

pub fn blade(depth: f64) -> Tool {
    let cutter = Cutter::Blade { width: Mm(3.0), corner_radius: Mm(0.2), depth: Mm(depth), side: Side::Outside };
    Tool { designation: "blade".into(), cutter, holder: Holder::shank_of_blade(Mm(25.0)) }
}

/// A fillet of 5 as an arc, led so that the nose of 0.8 goes round it: its centre on a circle of 4.2. The theoretical point is
/// 0.8 beside the centre in both directions.
#[test]
fn an_arc_is_followed_by_an_arc() {
    let fillet =
        Piece::Arc { from: at(-20.0, 15.0), to: at(-25.0, 20.0), centre: at(-20.0, 20.0), sense: Sense::Clockwise };
    let mut part = chain(&[(0.0, 0.0), (0.0, 15.0), (-20.0, 15.0)]);
    part.push(ProfilePiece::new(fillet, None));
    part.push(line("flange", (-25.0, 20.0), (-25.0, 25.0)));
    part.push(line("rim", (-25.0, 25.0), (-40.0, 25.0)));
    let mut motions = program(0, (5.0, 40.0), &[(Rapid, 2.0, 15.0), (Feed, -20.8, 15.0)]);
    let arc =
        Piece::Arc { from: at(-20.8, 15.0), to: at(-25.0, 19.2), centre: at(-20.8, 19.2), sense: Sense::Clockwise };
    motions.push(Motion { path: arc, ..*motions.last().unwrap() });
    for (z, radius) in [(-25.0, 25.0), (-42.0, 25.0)] {
        motions.push(joined(&motions, Feed, at(z, radius)));
    }
    let tool = bare(insert(95.0, 5.0, 0.8, Hand::Right, Side::Outside));
    let blank = [(0.0, 0.0), (0.0, 16.0), (-18.0, 16.0), (-24.0, 26.0), (-60.0, 26.0)];
    let mut work = bar_work(part, 1.0, (0.0, 1.0), tool, motions);
    work.stock = stock(&blank, &[]);
    assert_eq!(proven(&work).faults, []);
}

/// M20: crests at Ø19.8, roots at Ø17.55 to Ø17.65, relief behind it; four passes.
pub fn thread(last: f64) -> SetUp {
    let mut part =
        chain(&[(0.0, 0.0), (0.0, 8.5), (-1.5, 10.0), (-20.0, 10.0), (-20.0, 8.5), (-24.0, 8.5), (-24.0, 12.0)]);
    part.push(line("rest", (-24.0, 12.0), (-40.0, 12.0)));
    let (crest, shallow, root) = (Mm(9.9), Mm(8.825), Mm(8.775));
    part[2].thread = Some(Thread { crest, shallow, root, pitch: Mm(2.5), run_out: Mm(0.0), tap: None });
    let mut moves = vec![];
    for radius in [9.5, 9.1, 8.9, last] {
        moves.extend([(Rapid, 4.0, radius), (Pass, -22.0, radius), (Rapid, -22.0, 13.0), (Rapid, 4.0, 13.0)]);
    }
    let cutter = Cutter::Thread { angle: Degrees(60.0), reach: Mm(3.0), beside: Mm(3.0), side: Side::Outside };
    let motions = program(0, (4.0, 13.0), &moves);
    let mut work = bar_work(part, 1.0, (0.0, 1.0), bare(cutter), motions);
    let crests =
        [(0.0, 0.0), (0.0, 8.4), (-1.5, 9.9), (-20.0, 9.9), (-20.0, 8.5), (-24.0, 8.5), (-24.0, 12.0), (-60.0, 12.0)];
    work.stock = stock(&crests, &[]);
    work
}

#[test]
fn a_thread_goes_down_to_its_root_and_leaves_its_crests() {
    let mut work = thread(8.775);
    // The chamfer of the blank is that of the crests.
    work.profile.outside[0] = line("face", (0.0, 0.0), (0.0, 8.4));
    work.profile.outside[1] = line("chamfer", (0.0, 8.4), (-1.5, 9.9));
    let Piece::Line { to, .. } = work.profile.outside[2].path else { panic!() };
    work.profile.outside[2].path = Piece::Line { from: at(-1.5, 9.9), to: At::new(to.z, Mm(9.9)) };
    work.profile.outside[3] = line("relief", (-20.0, 9.9), (-20.0, 8.5));
    let proof = proven(&work);
    assert_eq!(proof.faults, []);
    assert_eq!(proof.left.volume(), work.stock.volume(), "the crests stay");
    // Drawn at its nominal diameter it is turned down to the crests all the same.
    assert_eq!(wrong(&thread(8.775)).len(), 0, "{:?}", wrong(&thread(8.775)));
}

/// A thread may run out 6 mm into the cylinder behind it; its crests, 0.1 mm lower than that, are turned 1 mm past its end.
#[test]
fn the_crests_of_a_thread_may_be_turned_into_its_run_out() {
    let cut_to = |end: f64, run_out: f64| {
        let mut part = chain(&[(0.0, 0.0), (0.0, 10.0), (-20.0, 10.0), (-40.0, 10.0)]);
        let (crest, shallow, root) = (Mm(9.9), Mm(8.825), Mm(8.775));
        part[1].thread = Some(Thread { crest, shallow, root, pitch: Mm(2.5), run_out: Mm(run_out), tap: None });
        let moves = [(Feed, end, 9.9), (Rapid, end, 13.0), (Rapid, 4.0, 13.0)];
        let tool = shaft_work(&SHAFT).tools.remove(0);
        let motions = program(0, (1.0, 9.9), &moves);
        let mut work = bar_work(part, 1.0, (0.0, 1.0), tool, motions);
        let blank = [(0.0, 0.0), (0.0, 10.0), (-60.0, 10.0)];
        work.stock = stock(&blank, &[]);
        wrong(&work).into_iter().any(|fault| matches!(fault.what, What::Gouge { .. }))
    };
    assert!(!cut_to(-21.0, 6.0));
    assert!(cut_to(-28.0, 6.0));
    assert!(cut_to(-21.0, 0.0));
}

/// Four passes at 2.5 mm per turn make its thread; one at 2.4 spoils it.
#[test]
fn a_pass_of_a_thread_is_fed_by_its_pitch() {
    let mut work = thread(8.775);
    for motion in &mut work.motions {
        motion.lead = (motion.kind == Pass).then_some(Mm(2.5));
    }
    assert_eq!(wrong(&work), []);
    let second = work.motions.iter_mut().filter(|motion| motion.kind == Pass).nth(1).unwrap();
    second.lead = Some(Mm(2.4));
    let block = second.block;
    let faults = wrong(&work);
    let [Fault { what: What::ThreadLead { pitch, lead }, block: of, count: 1, .. }] = &faults[..] else {
        panic!("{faults:?}")
    };
    assert_eq!((pitch.0, lead.0, *of), (2.5, 2.4, Some(block)));
}

/// Beside a shoulder of Ø40 the flanks of a large point would open into the metal, at 15.6 mm over the root by 9 mm to each side;
/// the side of a real insert stands 1.7 mm ahead of its point and clears a shoulder 2 mm ahead.
#[test]
fn the_side_of_a_threading_insert_clears_a_shoulder() {
    let beside = |beside: f64| {
        let mut work = thread(8.775);
        let part = [(0.0, 0.0), (0.0, 8.5), (-1.5, 10.0), (-20.0, 10.0), (-20.0, 8.5), (-24.0, 8.5), (-24.0, 20.0)];
        let mut part = chain(&part);
        part.push(line("rest", (-24.0, 20.0), (-40.0, 20.0)));
        part[2].thread = work.profile.outside[2].thread;
        work.profile.outside = part;
        let crests = [
            (0.0, 0.0),
            (0.0, 8.4),
            (-1.5, 9.9),
            (-20.0, 9.9),
            (-20.0, 8.5),
            (-24.0, 8.5),
            (-24.0, 20.0),
            (-60.0, 20.0),
        ];
        work.stock = stock(&crests, &[]);
        let motions: Vec<(MotionKind, f64, f64)> = [9.5, 9.1, 8.9, 8.775]
            .into_iter()
            .flat_map(|radius| [(Pass, -22.0, radius), (Rapid, -22.0, 22.0), (Rapid, 4.0, 22.0), (Rapid, 4.0, radius)])
            .collect();
        let mut moves = vec![(Rapid, 4.0, 9.5)];
        moves.extend(motions);
        work.motions = program(0, (4.0, 22.0), &moves);
        work.tools[0].cutter =
            Cutter::Thread { angle: Degrees(60.0), reach: Mm(16.0), beside: Mm(beside), side: Side::Outside };
        wrong(&work)
    };
    let into = |fault: &Fault| matches!(fault.what, What::Gouge { .. } | What::RapidCut { .. });
    assert!(!beside(1.7).iter().any(into), "{:?}", beside(1.7));
    assert!(beside(16.0).iter().any(into));
}

/// 0.3 mm stay on Ø40 for the grinder, with nothing on the face and 0.1 on the shoulder.
#[test]
fn what_is_left_for_the_grinder_is_no_fault() {
    let mut work = shaft_work(&SHAFT);
    for motion in &mut work.motions[20..22] {
        let Piece::Line { from, to } = motion.path else { continue };
        let up = |at: At, z: f64| At::new(Mm(at.z.0 + z), Mm(at.radius.0 + 0.3));
        motion.path = Piece::Line { from: up(from, 0.0), to: up(to, if motion.block.0 == 22 { 0.1 } else { 0.0 }) };
    }
    work.motions[22].path = Piece::Line { from: at(-29.9, 20.3), to: at(-29.9, 30.0) };
    work.motions[23].path = Piece::Line { from: at(-29.9, 30.0), to: at(-72.0, 30.0) };
    work.profile.outside[1].allowance = Mm(0.3);
    work.profile.outside[2].allowance = Mm(0.1);
    assert_eq!(wrong(&work), []);
    work.profile.outside[1].allowance = Mm(0.25);
    let faults = wrong(&work);
    // The fillet is 0.05 higher too, and where it runs into the shoulder that is some micrometres thick.
    assert!(
        matches!(&faults[..], [Fault { what: What::Stands { thickness, .. }, .. }, ..] if is(*thickness, 0.05)),
        "{faults:?}"
    );
    assert!(
        faults[1..]
            .iter()
            .all(|fault| matches!(fault, Fault { what: What::Stands { thickness, .. }, .. } if thickness.0 < 0.01))
    );
    work.profile.outside[1].allowance = Mm(0.4);
    let faults = wrong(&work);
    assert!(matches!(&faults[..], [Fault { what: What::Gouge { depth }, .. }, ..] if is(*depth, 0.1)), "{faults:?}");
}

/// A bush of Ø40/Ø20, bored through with a bar of 16 that enters Ø20.
#[test]
fn a_bush_is_bored_through() {
    let bore = chain(&[(0.0, 10.0), (-30.0, 10.0)]);
    let outside = chain(&[(0.0, 10.0), (0.0, 20.0), (-30.0, 20.0)]);
    let cutter = insert(95.0, 5.0, 0.4, Hand::Right, Side::Inside);
    let holder = Holder::bar(Mm(16.0), Mm(20.0));
    let tool = Tool { designation: "S16".into(), cutter, holder };
    let moves = [(Rapid, 2.0, 10.0), (Feed, -32.0, 10.0), (Feed, -32.0, 9.5), (Rapid, 2.0, 9.5), (Rapid, 30.0, 9.5)];
    let mut work = bar_work(outside, 20.0, (-30.0, 0.0), tool, program(0, (30.0, 9.5), &moves));
    work.profile = Profile { bore, ..work.profile };
    work.stock = Stock::cylinder(Mm(20.0), Some(Mm(9.5)), Mm(-30.0), Mm(0.0));
    let proof = proven(&work);
    assert_eq!(proof.faults, []);
    let removed = std::f64::consts::PI * 30.0 * (100.0 - 9.5 * 9.5);
    assert!((proof.volumes.removed.0 - removed).abs() < 0.01, "{:?} {removed}", proof.volumes);
}

/// What the first set-up left is the second one's stock: a cone of Ø20 at the free end stands at the chuck.
#[test]
fn the_stock_is_turned_over_with_the_part() {
    let stock = stock(&[(0.0, 0.0), (0.0, 10.0), (-50.0, 20.0)], &[]);
    let over = stock.turned_over(Mm(50.0));
    assert!(stock.holds(at(-49.0, 19.0)) && !stock.holds(at(-1.0, 19.0)));
    assert!(over.holds(at(-1.0, 19.0)) && !over.holds(at(-49.0, 19.0)));
    // A frustum: π/3 · 50 · (10² + 10 · 20 + 20²).
    let volume = std::f64::consts::PI / 3.0 * 50.0 * 700.0;
    assert!((over.volume().0 - volume).abs() < 0.01 && (stock.volume().0 - volume).abs() < 0.01);
    assert_eq!(over.turned_over(Mm(50.0)).volume(), stock.volume());
    assert!(prove(&SetUp::default()).is_err());
}

/// A set-up that makes the face only: 1 mm of a bar of Ø40 stands over it, π·20² mm³. The pin of Ø30 behind the face is made in a later
/// set-up, which cannot put back what a pass at Ø29 cuts away, half a millimetre a side.
#[test]
fn what_a_later_set_up_makes_is_not_cut_before() {
    let face = vec![line("face", (0.0, 0.0), (0.0, 15.0))];
    let tool = || bare(insert(95.0, 5.0, 0.0, Hand::Right, Side::Outside));
    let faced = program(0, (5.0, 25.0), &[(Rapid, 0.0, 25.0), (Feed, 0.0, -0.5), (Rapid, 5.0, -0.5)]);
    let mut work = bar_work(face, 20.0, (-60.0, 1.0), tool(), faced);
    let mut whole = chain(&[(0.0, 0.0), (0.0, 15.0)]);
    whole.extend([line("pin", (0.0, 15.0), (-30.0, 15.0)), line("end", (-30.0, 15.0), (-30.0, 0.0))]);
    work.finished = Some(Profile { outside: whole, bore: Vec::new() });
    let proof = proven(&work);
    assert_eq!(proof.faults, []);
    let over = std::f64::consts::PI * 400.0;
    for volume in [proof.volumes.to_remove, proof.volumes.removed] {
        assert!((volume.0 - over).abs() < 0.1, "{volume:?}");
    }
    let turned = [(Rapid, 0.0, 25.0), (Feed, 0.0, -0.5), (Rapid, 2.0, -0.5), (Rapid, 2.0, 14.5), (Feed, -10.0, 14.5)];
    work.motions = program(0, (5.0, 25.0), &turned);
    let faults = wrong(&work);
    let [Fault { what: What::Gouge { depth }, whose: Whose::Surface(surface), .. }] = &faults[..] else {
        panic!("{faults:?}")
    };
    assert_eq!(surface.as_ref().map(|one| one.text().into_owned()), Some("pin".to_owned()));
    assert!((depth.0 - 0.5).abs() < 0.001, "{depth:?}");
}

/// The thread with passes in step, each starting so far from the others along the axis and as the spindle turns.
fn started(starts: [(f64, f64); 4]) -> SetUp {
    let mut work = thread(8.8);
    let passes = work.motions.iter_mut().filter(|motion| motion.kind == Pass);
    for (motion, (off, angle)) in passes.zip(starts) {
        let Piece::Line { from, .. } = &mut motion.path else { panic!() };
        from.z.0 += off;
        (motion.lead, motion.start) = (Some(Mm(2.5)), Degrees(angle));
    }
    work
}

/// Depths below the crests 0.4, 0.8, 1.0 and 1.1 mm: the flanks of 30° leave (1.1 − d) · tan 30°, 0.404, 0.173 and 0.058 mm beside
/// the last groove. At Ø17.6, 0.025 over the deepest that is allowed, it may be widened by 2 · 0.030 · tan 30° = 0.035 mm in all.
#[test]
fn passes_of_a_thread_run_in_one_groove() {
    let still = |off: [f64; 4]| off.map(|off| (off, 0.0));
    let good = [
        still([0.0; 4]),
        // Along one flank, along both in turn, by whole pitches, and shifted both ways at once.
        still([-0.40, -0.17, -0.057, 0.0]),
        still([0.40, -0.17, 0.057, 0.0]),
        still([0.0, 2.5, 5.0, 0.0]),
        still([0.0, 0.0, 0.09, 0.0]),
        [(0.0, 0.0), (0.0, 360.0), (1.25, 180.0), (0.0, 0.0)],
    ];
    for starts in good {
        assert_eq!(wrong(&started(starts)), [], "{starts:?}");
    }
    let bad = [
        (still([0.0, 0.0, 0.1, 0.0]), 0.1),
        (still([0.0, 1.0, 0.0, 0.0]), 1.0),
        (still([0.0, 0.0, 0.0, 1.0]), 1.0),
        (still([0.0, 4.0, 0.0, 0.0]), 1.0),
        ([(0.0, 0.0), (0.0, 0.0), (0.0, 180.0), (0.0, 0.0)], 1.25),
    ];
    for (starts, expected) in bad {
        let faults = wrong(&started(starts));
        let [Fault { what: What::ThreadPhase { shift, pitch }, .. }] = &faults[..] else {
            panic!("{starts:?}: {faults:?}")
        };
        assert!(is(*shift, expected) && pitch.0 == 2.5, "{starts:?}: {faults:?}");
    }
}

/// A bar that cuts a thread in a bore passes under the thread outside: its point, 5 mm under those crests, is no pass of that thread,
/// neither its deepest one, beside which others would have no groove, nor one of a wrong lead.
#[test]
fn passes_in_a_bore_are_none_of_the_thread_outside() {
    let cutter = Cutter::Thread { angle: Degrees(60.0), reach: Mm(3.0), beside: Mm(3.0), side: Side::Inside };
    for lead in [2.5, 1.5] {
        let mut work = started([(0.0, 0.0), (1.0, 0.0), (0.0, 0.0), (0.0, 0.0)]);
        work.profile.bore = chain(&[(0.0, 5.0), (-40.0, 5.0)]);
        let outside = [(0.0, 8.4), (-1.5, 9.9), (-20.0, 9.9), (-20.0, 8.5), (-24.0, 8.5), (-24.0, 12.0), (-60.0, 12.0)];
        work.stock = stock(&outside, &[(0.0, 5.0), (-60.0, 5.0)]);
        work.tools.push(bare(cutter));
        let inside = [(Rapid, 4.0, 4.9), (Pass, -22.0, 4.9), (Rapid, -22.0, 4.0), (Rapid, 4.0, 4.0)];
        work.motions.extend(program(1, (4.0, 4.0), &inside).into_iter().map(|mut motion| {
            motion.lead = (motion.kind == Pass).then_some(Mm(lead));
            motion
        }));
        let faults = wrong(&work);
        let [Fault { what: What::ThreadPhase { shift, .. }, .. }] = &faults[..] else { panic!("{lead}: {faults:?}") };
        assert!(is(*shift, 1.0), "{lead}: {faults:?}");
        // Without a pass outside nothing is cut there, whatever the bar does.
        work.motions.retain(|motion| motion.tool == 1);
        let faults = wrong(&work);
        assert!(matches!(&faults[..], [Fault { what: What::ThreadShallow { .. }, .. }]), "{lead}: {faults:?}");
    }
}

/// Motions in step that follow each other without another between them are one pass: two thirds of a turn of its beginning are left
/// out of step with nothing.
#[test]
fn a_pass_of_two_motions_goes_on_in_step() {
    let mut work = started([(0.0, 0.0); 4]);
    let at_pass = work.motions.iter().position(|motion| motion.kind == Pass).unwrap();
    let Piece::Line { from, to } = work.motions[at_pass].path else { panic!() };
    let between = at(-11.0, from.radius.0);
    let mut second = work.motions[at_pass];
    work.motions[at_pass].path = Piece::Line { from, to: between };
    second.path = Piece::Line { from: between, to };
    work.motions.insert(at_pass + 1, second);
    assert_eq!(wrong(&work), []);
}

/// A pass from the relief towards the free end winds the other way.
#[test]
fn a_pass_the_other_way_spoils_a_thread() {
    let mut work = started([(0.0, 0.0); 4]);
    let pass = work.motions.iter_mut().find(|motion| motion.kind == Pass).unwrap();
    let Piece::Line { from, to } = pass.path else { panic!() };
    pass.path = Piece::Line { from: to, to: from };
    let faults = wrong(&work);
    assert!(matches!(&faults[..], [Fault { what: What::ThreadPhase { .. }, .. }, ..]), "{faults:?}");
}

/// From the end of its pass straight back at rapid, without leaving the groove first: the crests are 0.8 mm higher there.
#[test]
fn a_point_dragged_back_through_its_thread_is_found() {
    let mut work = started([(0.0, 0.0); 4]);
    let second = work.motions.iter().filter(|motion| motion.kind == Pass).nth(1).copied().unwrap();
    let at_pass = work.motions.iter().position(|motion| motion.block == second.block).unwrap();
    let (Piece::Line { from, to }, block) = (second.path, second.block) else { panic!() };
    let back = Motion { kind: Rapid, path: Piece::Line { from: to, to: from }, lead: None, ..second };
    work.motions.splice(at_pass + 1..at_pass + 3, [back]);
    let faults = wrong(&work);
    assert!(
        matches!(&faults[..], [Fault { what: What::RapidCut { .. }, block: at, .. }] if *at == Some(block)),
        "{faults:?}"
    );
}

/// A drill of 10 with flutes of 40 goes 46 deep into solid metal: 6 mm of its shank are in the hole. A hole that is wider there
/// lets the chips out.
#[test]
fn a_drill_goes_no_deeper_than_its_flutes() {
    let part = || vec![line("face", (0.0, 0.0), (0.0, 20.0)), line("outside", (0.0, 20.0), (-60.0, 20.0))];
    let tool = || bare(Cutter::Drill { diameter: Mm(10.0), point_angle: Degrees(118.0), flute: Mm(40.0) });
    let drilled = |depth: f64| {
        let moves = [(Rapid, 2.0, 0.0), (Feed, -depth, 0.0), (Rapid, 2.0, 0.0)];
        let mut work = bar_work(part(), 20.0, (-80.0, 0.0), tool(), program(0, (5.0, 0.0), &moves));
        work.profile.bore = vec![line("bore", (0.0, 5.0), (-60.0, 5.0))];
        work.profile.outside[0] = line("face", (0.0, 5.0), (0.0, 20.0));
        work
    };
    let buried = |work: &SetUp| {
        let faults = proven(work).faults;
        faults.iter().find_map(|fault| match fault {
            Fault { what: What::Buried { depth }, block: Some(block), .. } => Some((depth.0, block.0)),
            _ => None,
        })
    };
    assert_eq!(buried(&drilled(39.0)), None);
    let (depth, block) = buried(&drilled(46.0)).unwrap();
    assert!((depth - 6.0).abs() < 0.001 && block == 2, "{depth} {block}");
    let mut wide = drilled(46.0);
    wide.stock = stock(&[(0.0, 8.0), (0.0, 20.0), (-80.0, 20.0)], &[(0.0, 8.0), (-10.0, 8.0), (-10.0, 0.0)]);
    assert_eq!(buried(&wide), None);
}
