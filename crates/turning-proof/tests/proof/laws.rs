//! A law: a nose moved exactly along any contour cuts nothing that must stay, and 0.02 mm deeper it always does. The
//! path of its centre and the remaining metal are found by brute force, from samples of the contour.

use proptest::prelude::*;
use technolog_turning_proof::MotionKind::Feed;
use technolog_turning_proof::{Fault, Hand, Motion, SetUp, Side, What};

use crate::made::{bar_work, bare, chain, insert, program, proven, stock};

pub const NOSE: f64 = 0.8;
/// Distance of the samples of a contour, mm: between two of them a circle of the nose sinks by 0.01²/(8 · 0.8) mm, 16 nm.
const SAMPLE: f64 = 0.01;

/// A contour from Z0 towards the chuck: cylinders, shoulders, cones that rise and fall.
#[derive(Debug, Clone)]
pub struct Contour(pub Vec<(f64, f64)>);

impl Contour {
    fn end(&self) -> (f64, f64) {
        *self.0.last().unwrap()
    }

    /// Its samples, and of what is led along before and behind it: steeply up to its beginning, and 4 mm on as it ends.
    pub fn samples(&self) -> Vec<(f64, f64)> {
        let (begin, end) = (self.0[0], self.end());
        let before = self.0[self.0.len() - 2];
        let slope = (end.1 - before.1) / (end.0 - before.0);
        let ways = [vec![(0.5, begin.1 - 4.0)], self.0.clone(), vec![(end.0 - 4.0, end.1 - 4.0 * slope)]].concat();
        let between = |pair: &[(f64, f64)]| {
            let ((z, r), (to_z, to_r)) = (pair[0], pair[1]);
            let parts = ((to_z - z).hypot(to_r - r) / SAMPLE).ceil().max(1.0);
            let place =
                move |part| (z + (to_z - z) * f64::from(part) / parts, r + (to_r - r) * f64::from(part) / parts);
            (0..=parts as u32).map(place).collect::<Vec<_>>()
        };
        ways.windows(2).flat_map(between).collect()
    }
}

/// The lowest radius at which the centre of a nose over a place touches nothing; samples run towards the chuck.
fn centre(samples: &[(f64, f64)], z: f64) -> f64 {
    let begin = samples.partition_point(|sample| sample.0 > z + NOSE);
    let near = samples[begin..].iter().take_while(|sample| sample.0 >= z - NOSE);
    near.map(|&(at, r)| r + (NOSE * NOSE - (at - z) * (at - z)).max(0.0).sqrt()).fold(0.0, f64::max)
}

/// Places from one to another, a step apart, and where a shoulder first touches the nose: there the centre jumps.
fn places(contour: &Contour, from: f64, to: f64, step: f64) -> Vec<f64> {
    let steps = ((from - to) / step).ceil();
    let even = (0..=steps as u32).map(|index| from + (to - from) * f64::from(index) / steps);
    let jumps = contour.0.iter().map(|place| place.0 + NOSE + 1e-6).filter(|z| (to..from).contains(z));
    let mut all: Vec<f64> = even.chain(jumps).collect();
    all.sort_by(|a, b| b.total_cmp(a));
    all
}

/// The way of the centre, as chords that are nowhere more than 0.3 µm from it.
pub fn path(contour: &Contour, samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    fn halve(samples: &[(f64, f64)], a: (f64, f64), b: (f64, f64), all: &mut Vec<(f64, f64)>) {
        let part = |share: f64| a.0 + (b.0 - a.0) * share;
        let off = |share: f64| (centre(samples, part(share)) - a.1 - (b.1 - a.1) * share).abs();
        if a.0 - b.0 > 0.001 && [0.25, 0.5, 0.75].into_iter().any(|share| off(share) > 0.0003) {
            let middle = (part(0.5), centre(samples, part(0.5)));
            halve(samples, a, middle, all);
            halve(samples, middle, b, all);
        } else {
            all.push(b);
        }
    }
    let places = places(contour, 1.0, contour.end().0 - 3.0, 0.37);
    let mut all = vec![(places[0], centre(samples, places[0]))];
    for &z in &places[1..] {
        let before = *all.last().unwrap();
        halve(samples, before, (z, centre(samples, z)), &mut all);
    }
    all
}

fn contours() -> impl Strategy<Value = Contour> {
    let piece = (2.0..9.0f64, -40.0..60.0f64, prop::bool::weighted(0.3), 0.5..6.0f64);
    (8.0..15.0f64, prop::collection::vec(piece, 2..6)).prop_map(|(begin, pieces)| {
        let mut places = vec![(0.0, begin)];
        for (length, slope, shoulder, height) in pieces {
            let (z, r) = *places.last().unwrap();
            if shoulder {
                places.extend([(z, r + height), (z - length, r + height)]);
            } else {
                let rise = length * libm::tan(slope.to_radians());
                places.push((z - length, (r + rise).max(4.0)));
            }
        }
        Contour(places)
    })
}

/// The contour finished in one pass from a blank that is 1 mm larger in radius; the tool is moved into the metal by so much.
fn work(contour: &Contour, samples: &[(f64, f64)], deeper: f64) -> SetUp {
    let end = contour.end();
    let centres = path(contour, samples);
    let point = |(z, r): (f64, f64)| (z - NOSE, r - NOSE - deeper);
    let moves: Vec<_> = centres[1..].iter().map(|&place| point(place)).map(|(z, r)| (Feed, z, r)).collect();
    let motions: Vec<Motion> = program(0, point(centres[0]), &moves);
    let tool = bare(insert(93.0, 52.0, NOSE, Hand::Right, Side::Outside));
    let part = chain(&[vec![(0.0, 0.0)], contour.0.clone()].concat());
    let blank: Vec<(f64, f64)> = contour.0.iter().map(|&(z, r)| (z, r + 1.0)).collect();
    let blank = [vec![(0.0, 0.0)], blank, vec![(end.0 - 5.0, end.1 + 1.0)]].concat();
    SetUp { stock: stock(&blank, &[]), ..bar_work(part, 1.0, (0.0, 1.0), tool, motions) }
}

/// The volume that the nose leaves between Z0 and the contour's end, from the way of its centre.
fn left(contour: &Contour, samples: &[(f64, f64)]) -> f64 {
    let end = contour.end().0;
    let places = places(contour, 1.0, end - 2.0, 0.02);
    let centres: Vec<(f64, f64)> = places.into_iter().map(|z| (z, centre(samples, z))).collect();
    let radius = |z: f64| {
        let begin = centres.partition_point(|centre| centre.0 > z + NOSE);
        let near = centres[begin..].iter().take_while(|centre| centre.0 >= z - NOSE);
        near.map(|&(at, r)| r - (NOSE * NOSE - (at - z) * (at - z)).max(0.0).sqrt()).fold(f64::INFINITY, f64::min)
    };
    // From corner to corner, so that no slice lies over a shoulder.
    let slices = contour.0.windows(2).flat_map(|pair| {
        let (from, to) = (pair[0].0, pair[1].0);
        let steps = ((from - to) / 0.02).ceil();
        let width = (from - to) / steps.max(1.0);
        (0..steps as u32).map(move |step| (from - (f64::from(step) + 0.5) * width, width))
    });
    slices.map(|(z, width)| std::f64::consts::PI * radius(z) * radius(z) * width).sum()
}

proptest! {
    #![proptest_config(technolog_laws::cases!(16))]

    #[test]
    fn a_nose_led_exactly_gouges_nothing_and_deeper_always(contour in contours()) {
        let samples = contour.samples();
        let proof = proven(&work(&contour, &samples, 0.0));
        let wrong: Vec<&Fault> = proof.faults.iter().filter(|fault| !fault.is_mild()).collect();
        prop_assert!(wrong.is_empty(), "{wrong:?}");
        let (mine, volumes) = (left(&contour, &samples), proof.volumes);
        prop_assert!((volumes.left.0 - mine).abs() < 0.001 * volumes.removed.0, "{volumes:?} {mine}");

        let faults = proven(&work(&contour, &samples, 0.02)).faults;
        let depth = faults.iter().filter_map(|fault| match fault {
            Fault { what: What::Gouge { depth }, .. } => Some(depth.0),
            _ => None,
        });
        // Along the normal: on the steepest piece, 60°, half of it.
        let depth = depth.fold(0.0, f64::max);
        prop_assert!((0.0095..0.021).contains(&depth), "{depth}");
    }
}
