//! Tests which motions are merged into one cut, cycle by cycle, with the motions that an interpreter makes of the
//! cycle.

use super::cuts::{Descent, cuts};
use super::walk::{SetUpFrame, walk};
use crate::motion::{BlockRef, Motion, MotionStep, Plane, Position, Sense, Turning};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute};

/// Steps, written short: `r` rapid, `f` feed, with X, Y, Z in mm; `w` waits; `s` stops the spindle, `c` and `a` start it.
fn steps(text: &str) -> Vec<MotionStep> {
    let mut at = [0, 0, 100_i64];
    let mut steps = vec![step(Motion::ToolChange { tool: 1 }, at), step(spindle(Turning::Clockwise), at)];
    for word in text.split_whitespace() {
        let (kind, rest) = word.split_at(1);
        let mut numbers = rest.split(',').filter_map(|number| number.parse::<i64>().ok());
        let mut place = || {
            let all: Vec<i64> = numbers.by_ref().collect();
            match all[..] {
                [z] => at[2] = z,
                [x, y] => (at[0], at[1]) = (x, y),
                [x, y, z] => at = [x, y, z],
                _ => {}
            }
            at
        };
        let feed_mm_per_min = MillimetresPerMinute(100.0);
        let motion = match kind {
            "r" => Motion::Rapid,
            "f" => Motion::Feed { feed_mm_per_min },
            "w" => Motion::Dwell { seconds: 1.0 },
            "s" => spindle(Turning::Stopped),
            "c" => spindle(Turning::Clockwise),
            "a" => spindle(Turning::Counterclockwise),
            // A whole circle about the point that lies so far in X.
            "o" => Motion::Arc {
                plane: Plane::Xy,
                sense: Sense::Counterclockwise,
                centre: [Micrometres::ZERO, Micrometres::ZERO],
                turns: 0,
                feed_mm_per_min,
            },
            other => unreachable!("{other}"),
        };
        let to = if matches!(kind, "r" | "f") { place() } else { at };
        steps.push(step(motion, to));
    }
    steps
}

fn spindle(turning: Turning) -> Motion {
    Motion::Spindle { turning, speed_rpm: RevsPerMinute(500.0) }
}

fn step(motion: Motion, at: [i64; 3]) -> MotionStep {
    MotionStep { motion, at: Position::of(at.map(Micrometres::from_mm)), block: BlockRef::default() }
}

fn cut(text: &str) -> Vec<Descent> {
    let frame = SetUpFrame { zero: Position::default(), top: Micrometres::ZERO };
    let steps = steps(text);
    let start = Position::of([0, 0, 100].map(Micrometres::from_mm));
    let walk = walk(&steps, start, &[frame], steps.len(), &Default::default(), &[]);
    walk.visits.iter().enumerate().flat_map(|(number, stay)| cuts(number, stay, frame.top).0).collect()
}

fn mm(value: Micrometres) -> f64 {
    value.to_mm()
}

fn downs(cut: &Descent) -> Vec<(f64, f64)> {
    cut.downs().into_iter().map(|(from, to)| (mm(from), mm(to))).collect()
}

#[test]
fn a_drilled_hole_is_one_cut() {
    let cuts = cut("r10,0 r15 r3 f-20 r3 r15 r20,0 r3 f-20 r3 r15");
    assert_eq!(cuts.len(), 2);
    assert_eq!(cuts[1].at.map(mm), [20.0, 0.0]);
    assert_eq!((cuts[0].begin().map(mm), mm(cuts[0].deepest()), mm(cuts[0].retracted_to)), (Some(3.0), -20.0, 15.0));
    assert_eq!(downs(&cuts[0]), [(3.0, -20.0)]);
}

#[test]
fn steps_out_of_the_hole_are_one_cut_and_a_repetition_is_two() {
    let pecked = cut("r10,0 r3 f-7 r3 r-6 f-17 r3 r-16 f-20 r3 r15");
    assert_eq!(pecked.len(), 1);
    assert_eq!(downs(&pecked[0]), [(3.0, -7.0), (-6.0, -17.0), (-16.0, -20.0)]);
    assert_eq!(pecked[0].returns(Micrometres::ZERO).into_iter().map(mm).collect::<Vec<_>>(), [3.0, 3.0]);
    assert_eq!(cut("r10,0 r3 f-20 r3 r15 r3 f-20 r3 r15").len(), 2);
    // Not deeper, or from the beginning again, is no further step.
    assert_eq!(cut("r10,0 r3 f-20 r3 f-20 r3").len(), 2);
    assert_eq!(cut("r10,0 r3 f-10 r3 f-20 r3").len(), 2);
}

#[test]
fn broken_chips_stay_one_cut() {
    let broken = cut("r10,0 r3 f-7 r-6 f-17 r-16 f-20 r15");
    assert_eq!(broken.len(), 1);
    assert_eq!(downs(&broken[0]), [(3.0, -7.0), (-6.0, -17.0), (-16.0, -20.0)]);
    assert_eq!(broken[0].returns(Micrometres::ZERO).into_iter().map(mm).collect::<Vec<_>>(), [-6.0, -16.0]);
}

#[test]
fn the_way_out_is_what_follows_the_deepest_point() {
    let reamed = cut("r10,0 r3 f-20 w f3 r15");
    assert_eq!(reamed[0].dwell(), 1.0);
    assert!(reamed[0].way_out().iter().filter(|made| made.moves()).all(|made| made.feed().is_some()));
    let bored = cut("r10,0 r3 f-20 s r3 r15 c");
    let out: Vec<Turning> = bored[0].way_out().iter().filter(|made| made.moves()).map(|made| made.turning).collect();
    assert_eq!(out, [Turning::Stopped]);
    assert_eq!(bored[0].turning(), Turning::Clockwise);
    assert_eq!(cut("a r10,0 r3 f-20 r15")[0].turning(), Turning::Counterclockwise);
    assert_eq!(cut("s r10,0 r3 f-20 r15")[0].turning(), Turning::Stopped);
}

#[test]
fn a_feature_below_the_face_begins_below_it() {
    let deep = cut("r10,0 r15 r-7 f-20 f-7 r15");
    assert_eq!((deep.len(), deep[0].begin().map(mm)), (1, Some(-7.0)));
    assert_eq!(downs(&deep[0]), [(-7.0, -20.0)]);
}

#[test]
fn a_feed_to_the_face_and_on_from_there_is_one_way_in() {
    let fed_from = |text: &str| cut(text)[0].fed_from.map(mm);
    assert_eq!(fed_from("r10,0 r15 r3 f0 f-20 r15"), Some(3.0));
    assert_eq!(fed_from("r10,0 r15 f3 w f0 f-20 r15"), Some(15.0));
    // A rapid between them, or to the face.
    assert_eq!(fed_from("r10,0 r15 f3 r0 f-20 r15"), None);
    assert_eq!(fed_from("r10,0 r15 r0 f-20 r15"), None);
}

#[test]
fn circles_are_one_cut_with_the_hole() {
    let milled = cut("r0,0,15 r3 f-5 f7,0 o f9,0 o f0,0 f-10 f7,0 o f0,0 r15");
    assert_eq!(milled.len(), 1);
    let circles: Vec<(f64, f64)> = milled[0].circles().iter().map(|circle| (mm(circle.z), circle.radius)).collect();
    assert_eq!(circles, [(-5.0, 7.0), (-5.0, 9.0), (-10.0, 7.0)]);
    assert_eq!(downs(&milled[0]), [(3.0, -5.0), (-5.0, -10.0)]);
}

#[test]
fn what_stays_over_the_face_cuts_nothing_and_what_is_pushed_in_is_a_cut_without_a_feed() {
    assert_eq!(cut("r10,0 r3 f1 f0 r15"), []);
    let pushed = cut("r10,0 r3 r-5 r15");
    assert_eq!((pushed.len(), pushed[0].begin()), (1, None));
}
