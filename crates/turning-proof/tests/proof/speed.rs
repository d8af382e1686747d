//! The time of a proof, for people: a contour of many elements, roughed in passes along the axis and finished twice.

use std::time::Instant;

use technolog_turning_proof::MotionKind::{Feed, Rapid};
use technolog_turning_proof::{Fault, Hand, Holder, Mm, Side, Tool};

use crate::laws::{Contour, NOSE, path};
use crate::made::{bar_work, chain, insert, program, proven};

/// Waves of Ø40 to Ø56 on a cone, of so many chords over 100 mm.
fn waves(elements: u32) -> Contour {
    let place = |index| {
        let part = f64::from(index) / f64::from(elements);
        (-100.0 * part, 20.0 + 4.0 * libm::sin(part * 18.0) + 10.0 * part)
    };
    Contour((0..=elements).map(place).collect())
}

#[test]
#[ignore = "prints how long it takes, for people"]
fn a_long_program_over_a_contour_of_many_elements() {
    for (elements, levels) in [(100, 40), (500, 300)] {
        let contour = waves(elements);
        let samples = contour.samples();
        let point = |over: f64| move |(z, r): (f64, f64)| (z - NOSE, r - NOSE + over);
        let finish: Vec<(f64, f64)> = path(&contour, &samples).into_iter().map(point(0.0)).collect();
        let rough: Vec<(f64, f64)> = path(&contour, &samples).into_iter().map(point(0.4)).collect();
        let mut moves = vec![];
        for level in (0..levels).map(|level| 37.0 - 21.0 * f64::from(level + 1) / f64::from(levels)) {
            // From the free end to where the metal of the part begins.
            let end = rough.iter().find(|place| place.1 > level).map_or(-103.0, |place| place.0 + 0.2);
            if end < -0.5 {
                moves.extend([(Rapid, 2.0, level), (Feed, end, level), (Feed, end + 0.5, level + 0.5)]);
                moves.push((Rapid, 2.0, level + 0.5));
            }
        }
        for (over, path) in [(0.4, &rough), (0.2, &finish), (0.0, &finish)] {
            let by = if over == 0.2 { 0.2 } else { 0.0 };
            moves.push((Rapid, 2.0, 45.0));
            moves.push((Rapid, path[0].0, path[0].1 + by));
            moves.extend(path[1..].iter().map(|&(z, r)| (Feed, z, r + by)));
            moves.push((Rapid, -102.0, 45.0));
        }
        let cutter = insert(93.0, 52.0, NOSE, Hand::Right, Side::Outside);
        let holder = Holder::shank(Mm(25.0), Hand::Right);
        let tool = Tool { designation: "SVJBR".into(), cutter, holder };
        let part = chain(&[vec![(0.0, 0.0)], contour.0.clone()].concat());
        let work = bar_work(part, 37.0, (-130.0, 0.0), tool, program(0, (2.0, 45.0), &moves));
        let begun = Instant::now();
        let proof = proven(&work);
        let took = begun.elapsed();
        println!("{elements} elements, {} motions: {took:?}, {:?}", work.motions.len(), proof.volumes);
        assert!(proof.faults.iter().all(Fault::is_mild), "{:?}", proof.faults);
    }
}
