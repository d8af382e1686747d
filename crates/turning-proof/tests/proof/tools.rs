//! Tools of every kind: the metal that one plunge of each removes.

use technolog_turning_proof::MotionKind::Feed;
use technolog_turning_proof::{Cutter, Degrees, Hand, Mm, SetUp, Side, Stock};

use crate::made::{at, bar_work, bare, chain, insert, program, proven};

/// What is left of a bar of Ø100 with its face at Z0, after one feed of a tool.
fn left(cutter: Cutter, bore: Option<f64>, from: (f64, f64), to: (f64, f64)) -> Stock {
    let part = chain(&[(-90.0, 0.0), (-90.0, 1.0), (-95.0, 1.0)]);
    let work = bar_work(part, 50.0, (-100.0, 0.0), bare(cutter), program(0, from, &[(Feed, to.0, to.1)]));
    let stock = Stock::cylinder(Mm(50.0), bore.map(Mm), Mm(-100.0), Mm(0.0));
    proven(&SetUp { stock, ..work }).left
}

/// Where there is metal, and where not.
fn holds(stock: &Stock, metal: &[(f64, f64)], air: &[(f64, f64)]) {
    for &(z, radius) in metal {
        assert!(stock.holds(at(z, radius)), "no metal at Z{z} radius {radius}");
    }
    for &(z, radius) in air {
        assert!(!stock.holds(at(z, radius)), "metal at Z{z} radius {radius}");
    }
}

/// φ = 45° leaves a cone of 45° before it, φ1 = 45° behind it; the point is at Z−50, radius 45.
#[test]
fn edges_lean_as_their_angles_say() {
    let square = |hand, side| insert(45.0, 45.0, 0.0, hand, side);
    let stock = left(square(Hand::Right, Side::Outside), None, (-50.0, 60.0), (-50.0, 45.0));
    holds(&stock, &[(-50.0, 44.9), (-54.0, 48.9), (-46.0, 48.9)], &[(-50.0, 45.1), (-54.0, 49.1), (-46.0, 49.1)]);
    // A right hand with φ = 95°, φ1 = 5°: all of it lies on the side of the free end; a left hand the other way round.
    let corner = |hand| left(insert(95.0, 5.0, 0.0, hand, Side::Outside), None, (-50.0, 60.0), (-50.0, 45.0));
    holds(&corner(Hand::Right), &[(-50.1, 46.0), (-45.0, 45.3)], &[(-49.8, 46.0), (-45.0, 45.6)]);
    holds(&corner(Hand::Left), &[(-49.9, 46.0), (-55.0, 45.3)], &[(-50.2, 46.0), (-55.0, 45.6)]);
    // Inside it is the same outwards.
    let stock = left(insert(95.0, 5.0, 0.0, Hand::Right, Side::Inside), Some(20.0), (-50.0, 10.0), (-50.0, 25.0));
    holds(&stock, &[(-50.1, 24.0), (-45.0, 24.7)], &[(-49.8, 24.0), (-45.0, 24.4)]);
}

/// The nose of 2: a right hand's theoretical point is 2 beside its lowest point, a neutral one's is below it.
#[test]
fn the_reference_point_is_where_the_table_says() {
    let stock = left(insert(95.0, 5.0, 2.0, Hand::Right, Side::Outside), None, (-50.0, 60.0), (-50.0, 45.0));
    holds(&stock, &[(-50.0, 45.2), (-48.0, 44.9), (-50.1, 47.0)], &[(-48.0, 45.1), (-49.9, 47.0)]);
    let stock = left(insert(60.0, 60.0, 2.0, Hand::Neutral, Side::Outside), None, (-50.0, 60.0), (-50.0, 45.0));
    holds(&stock, &[(-50.0, 44.9), (-51.0, 45.2), (-49.0, 45.2)], &[(-50.0, 45.1), (-51.0, 45.4), (-49.0, 45.4)]);
}

#[test]
fn blades_begin_at_their_corner() {
    let (width, corner_radius, depth) = (Mm(4.0), Mm(1.0), Mm(20.0));
    let stock =
        left(Cutter::Blade { width, corner_radius, depth, side: Side::Outside }, None, (-50.0, 60.0), (-50.0, 45.0));
    holds(
        &stock,
        &[(-50.1, 47.0), (-45.9, 47.0), (-48.0, 44.9), (-49.8, 45.2)],
        &[(-49.9, 47.0), (-46.1, 47.0), (-48.0, 45.1)],
    );
    let stock = left(
        Cutter::Blade { width, corner_radius, depth, side: Side::Inside },
        Some(20.0),
        (-50.0, 10.0),
        (-50.0, 25.0),
    );
    holds(&stock, &[(-50.1, 23.0), (-45.9, 23.0), (-48.0, 25.1)], &[(-49.9, 23.0), (-46.1, 23.0), (-48.0, 24.9)]);
    let stock = left(Cutter::FaceBlade { width, corner_radius, depth }, None, (5.0, 30.0), (-5.0, 30.0));
    holds(
        &stock,
        &[(-3.0, 29.9), (-3.0, 34.1), (-5.1, 32.0), (-4.8, 30.2)],
        &[(-3.0, 30.1), (-3.0, 33.9), (-4.9, 32.0)],
    );
}

/// A pilot of Ø4 by 5 with a point of 120°, a cone of 60° up to the body of Ø10: 3/tan 30° = 5.196 long.
#[test]
fn a_centre_drill_makes_pilot_and_cone() {
    let cutter = Cutter::CentreDrill { pilot: Mm(4.0), pilot_length: Mm(5.0), body: Mm(10.0) };
    let stock = left(cutter, None, (5.0, 0.0), (-9.0, 0.0));
    holds(
        &stock,
        &[(-9.1, 0.0), (-8.0, 1.8), (-5.0, 2.1), (-2.0, 3.2)],
        &[(-8.9, 0.0), (-8.0, 1.7), (-5.0, 1.9), (-2.0, 3.1)],
    );
    let drill = Cutter::Drill { diameter: Mm(10.0), point_angle: Degrees(90.0), flute: Mm(60.0) };
    let stock = left(drill, None, (5.0, 0.0), (-20.0, 0.0));
    holds(&stock, &[(-10.0, 5.1), (-17.0, 3.1)], &[(-10.0, 4.9), (-17.0, 2.9)]);
}
