//! Set-ups whose figures are worked by hand.

use technolog_turning_proof::MotionKind::{Feed, Rapid};
use technolog_turning_proof::{At, Fault, Mm, What, Whose};

use crate::made::{at, bar_work, chain, is, pclnr, program, proven, wrong, insert, bare};
use technolog_turning_proof::{Hand, Side};

/// A cone falling 28.6° towards the chuck, led by the theoretical point 0.2 mm above it: the nose of 0.8 lies
/// r(1 − cos α + sin α) − 0.2 = 0.8 · (1 − 0.87798 + 0.47869) − 0.2 = 0.281 mm below it.
#[test]
fn a_falling_cone_is_gouged_by_its_nose() {
    let (z, fall) = (-40.0, 40.0 * 28.6_f64.to_radians().tan());
    let part = chain(&[(0.0, 0.0), (0.0, 40.0), (-5.0, 40.0), (-5.0 + z, 40.0 - fall), (-60.0, 40.0 - fall)]);
    let cosine = 28.6_f64.to_radians().cos();
    let up = 0.2 / cosine;
    let path = program(0, (5.0, 45.0), &[(Rapid, 2.0, 40.0 + up), (Feed, -5.0, 40.0 + up), (Feed, -5.0 + z, 40.0 - fall + up)]);
    let tool = bare(insert(95.0, 52.0, 0.8, Hand::Right, Side::Outside));
    let faults = wrong(&bar_work(part, 45.0, (-80.0, 0.0), tool, path));
    let gouge = faults.iter().find(|fault| matches!(fault.what, What::Gouge { .. }));
    let Some(Fault { what: What::Gouge { depth }, whose: Whose::Surface(surface), block, .. }) = gouge else { panic!("{faults:?}") };
    assert!((depth.0 - 0.2806).abs() < 0.001, "{depth:?}");
    println!("{surface:?} {block:?} {faults:?}");
}
