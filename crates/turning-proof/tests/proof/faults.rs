//! One planted error of every kind; its figures are worked by hand.

use technolog_note::Figure;
use technolog_turning_proof::MotionKind::{Feed, Rapid};
use technolog_turning_proof::{
    Block, Body, Cutter, Degrees, Fault, Hand, Holder, Mm, MotionKind, Piece, Profile, ProfilePiece, Refused, SetUp,
    Side, Stock, Tool, What, Whose, prove,
};

use crate::clean::{SHAFT, blade, shaft_work, thread};
use crate::made::{Named, at, bar_work, bare, chain, insert, is, pclnr, program, proven, stock, wrong};

fn named(name: &str) -> Option<Figure> {
    Some(Figure::from_name(name))
}

/// A cone falling 28.6° towards the chuck, led by the theoretical point 0.2 mm above it: the nose of 0.8 lies
/// r(1 − cos α + sin α) − 0.2 = 0.8 · (1 − 0.87798 + 0.47869) − 0.2 = 0.2806 mm below it.
#[test]
fn a_falling_cone_led_by_the_theoretical_point_is_gouged() {
    let angle = 28.6_f64.to_radians();
    let (fall, up) = (20.0 * libm::tan(angle), 0.2 / libm::cos(angle));
    let part = chain(&[(0.0, 0.0), (0.0, 40.0), (-5.0, 40.0), (-25.0, 40.0 - fall), (-40.0, 40.0 - fall)]);
    let moves = [(Rapid, 2.0, 40.0 + up), (Feed, -5.0, 40.0 + up), (Feed, -25.0, 40.0 - fall + up)];
    let tool = bare(insert(95.0, 52.0, 0.8, Hand::Right, Side::Outside));
    let faults = wrong(&bar_work(part, 45.0, (-80.0, 0.0), tool, program(0, (5.0, 50.0), &moves)));
    let [Fault { what: What::Gouge { depth }, whose: Whose::Surface(surface), block, .. }, ..] = &faults[..] else {
        panic!("{faults:?}")
    };
    assert!(is(*depth, 0.2806), "{depth:?}");
    assert_eq!((surface, *block), (&named("s3"), Some(Block(3))));
}

/// Steeper than φ1 = 5° by 5°, so that the edge behind the nose cuts. From where it would meet the main one it is 12 long; the nose
/// of 0.8 touches it 0.8 · tan 50° = 0.953 from there, and 0.8 · tan 2.5° = 0.035 further it crosses the cone: 11.012 · sin 5°.
#[test]
fn the_edge_behind_the_nose_gouges_what_falls_steeper() {
    let angle = 10_f64.to_radians();
    let fall = 30.0 * libm::tan(angle);
    let part = chain(&[(0.0, 0.0), (0.0, 30.0), (-10.0, 30.0), (-40.0, 30.0 - fall), (-50.0, 30.0 - fall)]);
    // The nose touches the cone where the theoretical point is r(1 − cos α + sin α)/cos α over it.
    let up = 0.8 * (1.0 - libm::cos(angle) + libm::sin(angle)) / libm::cos(angle);
    let moves = [(Rapid, -9.0, 32.0), (Feed, -10.0, 30.0 + up), (Feed, -35.0, 30.0 + up - 25.0 * libm::tan(angle))];
    let tool = bare(insert(95.0, 5.0, 0.8, Hand::Right, Side::Outside));
    let faults = wrong(&bar_work(part, 30.5, (-80.0, 0.0), tool, program(0, (-9.0, 40.0), &moves)));
    let [Fault { what: What::Gouge { depth }, whose: Whose::Surface(surface), .. }, ..] = &faults[..] else {
        panic!("{faults:?}")
    };
    assert!(is(*depth, 0.9597), "{depth:?}");
    assert_eq!(*surface, named("s3"));
}

/// From the small diameter straight up behind the shoulder.
#[test]
fn a_rapid_through_the_shoulder_is_found() {
    let mut moves = SHAFT.to_vec();
    moves.extend([(Rapid, 2.0, 40.0), (Rapid, 2.0, 21.0), (Rapid, -60.0, 31.0)]);
    let faults = wrong(&shaft_work(&moves));
    let [Fault { what: What::RapidCut { width }, whose: Whose::Tool(tool), block, count: 1, .. }, ..] = &faults[..]
    else {
        panic!("{faults:?}")
    };
    assert_eq!((tool.as_str(), *block), ("PCLNR", Some(Block(28))));
    assert!(width.0 > 1.0, "{width:?}");
    // Before anything is cut the whole bar is in the way: the first pass at rapid.
    let mut moves = SHAFT.to_vec();
    moves[5].0 = Rapid;
    let faults = wrong(&shaft_work(&moves));
    // 1.7 mm of the radius.
    let Fault { what: What::RapidCut { width }, block: Some(Block(6)), .. } = &faults[0] else { panic!("{faults:?}") };
    assert!(is(*width, 1.7), "{width:?}");
}

/// A neck of Ø50 between flanges of Ø100. The shank's far side lies 25 · 5/4 = 31.25 behind the point: at Z−40 it is at Z−8.75, and
/// the flange begins at Z−10.
#[test]
fn a_shank_hits_the_flange_behind_it() {
    let spool = [(0.0, 0.0), (0.0, 50.0), (-10.0, 50.0), (-10.0, 24.0), (-60.0, 24.0), (-60.0, 50.0), (-80.0, 50.0)];
    let blank = [(0.0, 0.0), (0.0, 50.0), (-10.0, 50.0), (-10.0, 24.8), (-60.0, 24.8), (-60.0, 50.0), (-80.0, 50.0)];
    let path = |begin: f64| {
        program(
            0,
            (begin, 80.0),
            &[
                (Rapid, begin, 26.0),
                (Feed, begin, 24.0),
                (Feed, -58.0, 24.0),
                (Feed, -57.0, 26.0),
                (Rapid, -57.0, 80.0),
            ],
        )
    };
    let mut work = bar_work(chain(&spool), 1.0, (0.0, 1.0), pclnr(0.8), path(-40.0));
    work.stock = stock(&blank, &[]);
    let hits = |work: &SetUp| -> Vec<Fault> {
        wrong(work).into_iter().filter(|fault| !matches!(fault.what, What::Stands { .. })).collect()
    };
    let faults = hits(&work);
    let [Fault { what: What::Holder { width, .. }, whose: Whose::Tool(tool), count: 3, .. }] = &faults[..] else {
        panic!("{faults:?}")
    };
    assert_eq!(tool, "PCLNR");
    assert!(is(*width, 1.25), "{width:?}");
    work.motions = path(-42.0);
    assert_eq!(hits(&work), []);
}

/// A groove 12 deep with a blade of 10: its holder is 2 in the metal, 22 of its 25 mm beside the groove of 3.
#[test]
fn a_blade_is_no_deeper_than_it_is() {
    let part =
        chain(&[(0.0, 0.0), (0.0, 20.0), (-20.0, 20.0), (-20.0, 8.0), (-23.0, 8.0), (-23.0, 20.0), (-40.0, 20.0)]);
    let moves = [(Rapid, -23.0, 21.0), (Feed, -23.0, 8.0), (Feed, -23.0, 21.0)];
    let work = |depth| bar_work(part.clone(), 20.0, (-60.0, 30.0), blade(depth), program(0, (-23.0, 40.0), &moves));
    let of_holder = |depth| wrong(&work(depth)).into_iter().find(|fault| matches!(fault.what, What::Holder { .. }));
    let fault = of_holder(10.0);
    assert!(
        matches!(&fault, Some(Fault { what: What::Holder { kind: MotionKind::Feed, width }, .. }) if is(*width, 2.0)),
        "{fault:?}"
    );
    assert_eq!(of_holder(12.0), None);
}

/// Bored to Ø20 with a bar of 18 whose point stands out 3: its far side is 11 beyond the axis.
#[test]
fn a_bar_touches_the_far_wall() {
    let cutter = insert(95.0, 5.0, 0.4, Hand::Right, Side::Inside);
    let holder = Holder::Bar { diameter: Mm(18.0), stands_out: Mm(3.0) };
    let tool = Tool { designation: "S18".into(), cutter, holder };
    let moves = [(Rapid, 2.0, 10.0), (Feed, -31.0, 10.0)];
    let outside = chain(&[(0.0, 10.0), (0.0, 30.0), (-30.0, 30.0)]);
    let mut work = bar_work(outside, 30.0, (-30.0, 0.0), tool, program(0, (40.0, 10.0), &moves));
    work.profile = Profile { bore: chain(&[(0.0, 10.0), (-30.0, 10.0)]), ..work.profile };
    work.stock = Stock::cylinder(Mm(30.0), Some(Mm(9.9)), Mm(-30.0), Mm(0.0));
    let faults = wrong(&work);
    let [Fault { what: What::Holder { width, .. }, whose: Whose::Tool(tool), .. }] = &faults[..] else {
        panic!("{faults:?}")
    };
    assert_eq!(tool, "S18");
    assert!(is(*width, 1.0), "{width:?}");
}

/// A live centre of 60° in its hole: facing goes into it.
#[test]
fn facing_hits_the_tailstock_centre() {
    let half = libm::tan(30_f64.to_radians());
    let outline = [(-4.0, 0.0), (20.0, 24.0 * half), (60.0, 24.0 * half), (60.0, 0.0)].map(|(z, r)| at(z, r)).to_vec();
    let centre = Body { name: Figure::word("centre"), outline };
    // At Z0 the centre has a radius of 4 · tan 30° = 2.31, so facing ends at Ø6 or strikes.
    let face = |end: f64| {
        let path = program(0, (0.0, 40.0), &[(Rapid, 0.0, 34.0), (Feed, 0.0, end), (Rapid, 0.0, 40.0)]);
        let part = chain(&[(0.0, 3.0), (0.0, 30.0), (-70.0, 30.0)]);
        let tool = bare(insert(95.0, 60.0, 0.4, Hand::Right, Side::Outside));
        let mut work = bar_work(part, 32.0, (-100.0, 1.0), tool, path);
        work.bodies = vec![centre.clone()];
        wrong(&work).into_iter().find(|fault| matches!(fault.what, What::Struck { .. }))
    };
    let struck = face(0.0);
    let Some(Fault { what: What::Struck { body, .. }, block: Some(Block(2)), whose: Whose::Tool(tool), .. }) = &struck
    else {
        panic!("{struck:?}")
    };
    assert_eq!((body, tool.as_str()), (&Figure::word("centre"), "bare"));
    assert_eq!(face(2.6), None);
}

/// Drilled to 30 with a point of 118°, whose cone is 10/tan 59° = 6.009 high; the bore has a flat floor. A spot of the cone at the
/// radius x is 0.6009x over the floor and 10 − x from the wall: as far from both at x = 6.246, 3.754 mm.
#[test]
fn a_drill_leaves_its_cone_over_a_flat_floor() {
    let cutter = Cutter::Drill { diameter: Mm(20.0), point_angle: Degrees(118.0), flute: Mm(80.0) };
    let moves = [(Rapid, 3.0, 0.0), (Feed, -30.0, 0.0), (Rapid, 3.0, 0.0)];
    let outside = chain(&[(0.0, 10.0), (0.0, 25.0), (-50.0, 25.0)]);
    let mut work = bar_work(outside, 25.0, (-60.0, 0.0), bare(cutter), program(0, (50.0, 0.0), &moves));
    work.profile.bore = chain(&[(0.0, 10.0), (-30.0, 10.0), (-30.0, 0.0)]);
    let faults = proven(&work).faults;
    let thickest = faults.iter().map(|fault| match fault {
        Fault { what: What::Stands { thickness, .. }, .. } => thickness.0,
        other => panic!("{other:?}"),
    });
    let thickest = thickest.fold(0.0, f64::max);
    assert!((thickest - 3.754).abs() < 0.2 && thickest < 3.755, "{thickest} {faults:?}");
    // A floor drawn as the cone is finished.
    let cone = 10.0 / libm::tan(59_f64.to_radians());
    work.profile.bore = chain(&[(0.0, 10.0), (cone - 30.0, 10.0), (-30.0, 0.0)]);
    assert_eq!(proven(&work).faults, []);
    // Sideways a drill does not cut.
    work.motions = program(0, (50.0, 0.0), &[(Rapid, 3.0, 0.0), (Feed, -10.0, 0.0), (Feed, -10.0, 1.0)]);
    let faults = wrong(&work);
    assert!(
        faults.iter().any(|fault| matches!(fault, Fault { what: What::OffAxis, block: Some(Block(3)), .. })),
        "{faults:?}"
    );
}

/// A face with 0.5 mm on it. A nose of 0.8 whose theoretical point stops at X0 leaves a pip as high as that; at X−2r it leaves none.
#[test]
fn facing_to_the_axis_leaves_a_pip() {
    let face = |end: f64| {
        let path = program(0, (0.0, 40.0), &[(Rapid, 0.0, 34.0), (Feed, 0.0, end), (Rapid, 5.0, end)]);
        let part = chain(&[(0.0, 0.0), (0.0, 30.0), (-70.0, 30.0)]);
        wrong(&bar_work(part, 30.0, (-100.0, 0.5), pclnr(0.8), path))
    };
    let faults = face(0.0);
    let [Fault { what: What::Stands { thickness, .. }, whose: Whose::Surface(surface), at: Some(at), .. }] =
        &faults[..]
    else {
        panic!("{faults:?}")
    };
    assert_eq!(*surface, named("s1"));
    assert!(is(*thickness, 0.5) && at.radius.0 < 0.06, "{faults:?}");
    assert_eq!(face(-0.8), []);
}

/// Nothing is cut from Ø64 over Ø60 and Ø40; the contour's end is another set-up's.
#[test]
fn what_is_not_machined_stands() {
    let faults = wrong(&shaft_work(&[(Rapid, 10.0, 50.0)]));
    let stands = |wanted: &str| {
        faults.iter().find_map(|fault| match fault {
            Fault { what: What::Stands { thickness, from_z, to_z }, whose: Whose::Surface(surface), .. }
                if *surface == named(wanted) =>
            {
                Some((thickness.0, from_z.0, to_z.0))
            }
            _ => None,
        })
    };
    let (rim, from, to) = stands("s4").unwrap();
    assert!((rim - 2.0).abs() < 0.001 && to < -67.0 && from > -33.0, "{rim} {from} {to}");
    assert!((stands("s1").unwrap().0 - 2.0).abs() < 0.001);
    assert!(faults.iter().all(|fault| matches!(fault.what, What::Stands { .. })));
}

/// Passes that end before the thread does, begin within it, or are drawn out too soon; half a pitch of 2.5 mm is the last turn's.
#[test]
fn a_thread_is_cut_to_its_depth_along_all_its_length() {
    let passes = |from: f64, to: f64| {
        let mut work = thread(8.775);
        for motion in &mut work.motions {
            let Piece::Line { from: begin, to: end } = &mut motion.path else { panic!() };
            for place in [begin, end] {
                let z = if place.z.0 < 0.0 { to } else { from };
                place.z = Mm(z);
            }
        }
        let parts = wrong(&work).into_iter().filter_map(|fault| match fault {
            Fault { what: What::ThreadPart { left, from_z, to_z }, .. } => Some((left, from_z, to_z)),
            _ => None,
        });
        parts.collect::<Vec<_>>()
    };
    assert_eq!(passes(4.0, -22.0), []);
    assert_eq!(passes(4.0, -19.0), []);
    let found = passes(4.0, -18.0);
    assert!(matches!(found[..], [(left, from, to)] if is(left, 2.0) && is(from, -18.0) && is(to, -20.0)), "{found:?}");
    let found = passes(4.0, -11.0);
    assert!(matches!(found[..], [(left, ..)] if is(left, 9.0)), "{found:?}");
    let found = passes(-6.5, -22.0);
    assert!(matches!(found[..], [(left, from, to)] if is(left, 5.0) && is(from, -1.5) && is(to, -6.5)), "{found:?}");
}

#[test]
fn a_thread_is_neither_too_deep_nor_too_shallow() {
    let faults = wrong(&thread(8.675));
    assert!(
        faults.iter().any(|fault| matches!(fault, Fault { what: What::Gouge { .. }, block: Some(Block(14)), .. })),
        "{faults:?}"
    );
    // The passes at 9.5, 9.1 and 8.9 are the deepest: the last must reach 8.825, so 0.075 are left.
    let faults = wrong(&thread(8.9));
    assert!(
        matches!(&faults[..], [Fault { what: What::ThreadShallow { left }, .. }] if is(*left, 0.075)),
        "{faults:?}"
    );
    let mut uncut = thread(8.775);
    uncut.motions.clear();
    let faults = wrong(&uncut);
    assert!(
        matches!(&faults[..], [Fault { what: What::ThreadShallow { left }, .. }] if is(*left, 1.075)),
        "{faults:?}"
    );
}

#[test]
fn what_cannot_be_proven_is_refused() {
    let work = shaft_work(&SHAFT);
    let refused = |change: fn(&mut SetUp)| {
        let mut work = work.clone();
        change(&mut work);
        prove(&work).unwrap_err()
    };
    assert_eq!(refused(|work| work.profile.outside.clear()), Refused::NoContour);
    assert_eq!(refused(|work| work.motions[3].tool = 1), Refused::NoTool { block: Block(4) });
    let far = |work: &mut SetUp| work.motions[3].path = Piece::Line { from: at(0.0, f64::NAN), to: at(0.0, 0.0) };
    assert_eq!(refused(far), Refused::Place { limit: Mm(5000.0) });
    let blunt = |work: &mut SetUp| work.tools[0] = bare(insert(120.0, 60.0, 0.8, Hand::Right, Side::Outside));
    assert_eq!(refused(blunt), Refused::Tool { tool: "bare".into() });
    let _: Vec<ProfilePiece> = work.profile.outside;
}
