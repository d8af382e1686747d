//! A blind hole with a tapped thread, and each way to spoil it.

use technolog_turning_proof::MotionKind::{Feed, Rapid, Thread as InStep};
use technolog_turning_proof::{Cutter, Fault, Mm, Motion, MotionKind, Profile, SetUp, TapLimits, Thread, What};

use crate::made::{bare, chain, is, line, program, stock, wrong};

/// M12 by hand: pitch 1.75, hole Ø10.2 of Ø10.106 to Ø10.441, thread 20 deep, hole 28 deep, lead of three pitches 5.25: the front goes
/// to 25.25.
const TIP: f64 = -25.25;

struct Made {
    hole: f64,
    deep: f64,
    tip: f64,
    kinds: [MotionKind; 2],
    lead: f64,
    beside: f64,
}

const GOOD: Made = Made { hole: 10.2, deep: -28.0, tip: TIP, kinds: [InStep, InStep], lead: 1.75, beside: 0.0 };

fn made(made: &Made) -> SetUp {
    let outside = chain(&[(0.0, 6.6), (0.0, 15.0), (-40.0, 15.0)]);
    let mut bore = vec![
        line("chamfer", (0.0, 6.6), (-1.5, 5.1)),
        line("thread", (-1.5, 5.1), (-20.0, 5.1)),
        line("hole", (-20.0, 5.1), (-28.0, 5.1)),
        line("bottom", (-28.0, 5.1), (-28.0, 0.0)),
    ];
    let tap = TapLimits { diameter: Mm(12.0), pitch: Mm(1.75), largest_hole: Mm(10.441), run_out: Mm(7.0) };
    bore[1].thread = Some(Thread {
        crest: Mm(5.1),
        shallow: Mm(5.8),
        root: Mm(6.0),
        pitch: tap.pitch,
        run_out: Mm(0.0),
        tap: Some(tap),
    });
    let radius = made.hole / 2.0;
    let chamfer = 6.6 - radius;
    let inner = [(0.0, 6.6), (-chamfer, radius), (made.deep, radius), (made.deep, 0.0)];
    let outer = [(0.0, 6.6), (0.0, 15.0), (-40.0, 15.0)];
    let cutter = Cutter::Tap {
        diameter: Mm(12.0),
        pitch: Mm(1.75),
        core: Mm(10.106),
        lead: Mm(5.25),
        thread: Mm(29.0),
        neck: Mm(29.0),
        shank: Mm(9.0),
        free: Mm(71.0),
    };
    let moves = [(made.kinds[0], made.tip, made.beside), (made.kinds[1], 5.0, made.beside)];
    let motions = program(0, (5.0, made.beside), &moves);
    let motions = motions.into_iter().map(|one| Motion { lead: Some(Mm(made.lead)), ..one }).collect();
    SetUp {
        profile: Profile { outside, bore },
        stock: stock(&outer, &inner),
        tools: vec![bare(cutter)],
        motions,
        ..SetUp::default()
    }
}

fn codes(one: &Made) -> Vec<&'static str> {
    wrong(&made(one)).iter().map(Fault::code).collect()
}

#[test]
fn a_thread_is_tapped_in_its_hole() {
    assert_eq!(wrong(&made(&GOOD)), []);
    // A chuck with compensation follows a feed of its pitch per turn.
    assert_eq!(wrong(&made(&Made { kinds: [Feed, Feed], ..GOOD })), []);
    // A feed by time is none.
    let mut work = made(&Made { kinds: [Feed, Feed], ..GOOD });
    work.motions.iter_mut().for_each(|motion| motion.lead = None);
    assert_eq!(wrong(&work).iter().map(Fault::code).collect::<Vec<_>>(), ["swept-tap-out-of-step"]);
}

#[test]
fn what_spoils_a_tapped_thread_is_told() {
    for (what, one, code) in [
        ("no hole", Made { deep: -2.0, ..GOOD }, "swept-tap-blocked"),
        ("a narrow hole", Made { hole: 9.9, ..GOOD }, "swept-tap-blocked"),
        ("a wide hole", Made { hole: 10.5, ..GOOD }, "swept-tap-hole-wide"),
        ("against the bottom", Made { tip: -28.5, ..GOOD }, "swept-tap-blocked"),
        ("another lead", Made { lead: 1.5, ..GOOD }, "swept-tap-out-of-step"),
        ("at another feed", Made { kinds: [Feed, Feed], lead: 0.3, ..GOOD }, "swept-tap-out-of-step"),
        ("out at rapid", Made { kinds: [InStep, Rapid], ..GOOD }, "swept-rapid"),
        ("beside the axis", Made { beside: 0.5, ..GOOD }, "swept-off-axis"),
        ("too short", Made { tip: -22.0, ..GOOD }, "swept-thread-short"),
    ] {
        let found = codes(&one);
        assert!(found.contains(&code), "{what}: {found:?}");
    }
}

/// 22 less the lead is full to 16.75, 3.25 less than 20. Without a tap the whole of it lacks.
#[test]
fn the_missing_length_is_told() {
    let left = |one: &Made| {
        wrong(&made(one)).into_iter().find_map(|fault| match fault {
            Fault { what: What::ThreadShort { left }, .. } => Some(left),
            _ => None,
        })
    };
    assert!(is(left(&Made { tip: -22.0, ..GOOD }).unwrap(), 3.25));
    let mut none = made(&GOOD);
    none.motions.clear();
    assert_eq!(wrong(&none).iter().map(Fault::code).collect::<Vec<_>>(), ["swept-thread-shallow"]);
}

/// The thread of another pitch is not this thread.
#[test]
fn a_tap_of_another_thread_makes_none() {
    let mut work = made(&Made { lead: 1.5, ..GOOD });
    if let Cutter::Tap { pitch, .. } = &mut work.tools[0].cutter {
        *pitch = Mm(1.5);
    }
    assert_eq!(wrong(&work).iter().map(Fault::code).collect::<Vec<_>>(), ["swept-thread-shallow"]);
}

/// A hole of Ø6.8 that is drilled 8.25 behind the end of its thread: the bar around it is of the next set-up, though its wall is as far
/// from the thread as from that set-up's metal, to the last digit.
#[test]
fn the_bar_behind_a_thread_is_of_the_next_set_up() {
    let outside = chain(&[(0.0, 12.0), (0.0, 23.0), (-24.882, 23.0)]);
    let bore = vec![
        line("seat", (0.0, 12.0), (-5.682, 12.0)),
        line("bottom", (-5.682, 12.0), (-5.682, 3.4)),
        line("hole", (-5.682, 3.4), (-24.882, 3.4)),
    ];
    let outer = [(0.0, 12.0), (0.0, 23.0), (-24.882, 23.0), (-24.882, 26.0), (-68.882, 26.0)];
    let inner = [(0.0, 12.0), (-5.682, 12.0), (-5.682, 3.4), (-33.132, 3.4), (-35.175, 0.0)];
    let work = SetUp { profile: Profile { outside, bore }, stock: stock(&outer, &inner), ..SetUp::default() };
    assert_eq!(wrong(&work), []);
}
