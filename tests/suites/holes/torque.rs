//! Torque and thrust of twist drills beside two published formulas.
//!
//! The formulas of facts 1.4 (Косилова/Мещеряков т.2 table 32) are what the program computes with; here they
//! stand beside
//!
//! - **Machinery's Handbook**, 31st edition, pages 1152-1153 (Machining Power, tables 7-9):
//!   T = 0.05·Kd·Ff·FT·B·W + 0.007·Kd·D²·J·W, N; M = 0.000025·Kd·Ff·FM·A·W, N·m. Standard point, c/d = 0.18:
//!   A = 1.085, B = 1.355, J = 0.030; a sharp drill, W = 1. Kd = 24 000 for steel of HB 200 is from memory of
//!   table 6 (the number of the inch formula, and with it both formulas give the same load at Ø22.2 mm); Shaw and Oxford (1957), on whose formula it rests, have 23 300 for alloy steel of HB 200
//!   (Fundamentals of Tool Design, chapter 3);
//! - **Tungaloy**, general catalogue 2020-2021, page L068, twist drill: Mc = K·D²·(0.630 + 16.84·f)/100, N·m;
//!   Tc = 570·K·D·f^0.85, N, with K = 1.45 for a steel of 630 MPa, HB 197 (SMn438).
//!
//! None of them is a measurement of ours; what is held is the spread between them. Where it is widest, the
//! thrust of the Handbook, its drill has the full chisel edge, which a thinned web takes a good part of.

use technolog::cutting;
use technolog::machine::Machine;
use technolog::material::Material;
use technolog::plan::{CuttingMethod, Operation};
use technolog::shop::Shop;
use technolog::units::Micrometres;
use technolog_testing::KNOWLEDGE;
use technolog_testing::cuts::plain_cut;

/// A drill in steel at the upper feed of facts 1.6, with the Handbook's factors: table 8 for the feed, and
/// table 9 for the diameter, between its rows (5.6 and 6.4, 9.5 and 11, 17.5 and 22 mm) by D^0.8 and D^1.8.
struct Drill {
    /// mm.
    diameter: f64,
    /// mm/rev.
    feed: f64,
    ff: f64,
    ft: f64,
    fm: f64,
}

const DRILLS: [Drill; 3] = [
    Drill { diameter: 6.0, feed: 0.15, ff: 0.219, ft: 4.20, fm: 25.2 },
    Drill { diameter: 10.0, feed: 0.25, ff: 0.330, ft: 6.31, fm: 63.1 },
    Drill { diameter: 20.0, feed: 0.38, ff: 0.461, ft: 10.98, fm: 219.7 },
];

const KD: f64 = 24_000.0;
const K: f64 = 1.45;

/// Torque, N·m, and thrust, N.
fn handbook(drill: &Drill) -> (f64, f64) {
    let (a, b, j, w) = (1.085, 1.355, 0.030, 1.0);
    let thrust = 0.05 * KD * drill.ff * drill.ft * b * w + 0.007 * KD * drill.diameter * drill.diameter * j * w;
    (0.000_025 * KD * drill.ff * drill.fm * a * w, thrust)
}

fn tungaloy(drill: &Drill) -> (f64, f64) {
    let torque = K * drill.diameter * drill.diameter * (0.630 + 16.84 * drill.feed) / 100.0;
    (torque, 570.0 * K * drill.diameter * libm::pow(drill.feed, 0.85))
}

/// The program's own, for steel 45 (600 MPa, HB 229), at the feed of the table, which is the one above.
fn ours(drill: &Drill) -> (f64, f64) {
    let shop = Shop::with(
        Machine::find(&KNOWLEDGE, "gf2171").unwrap(),
        Material::find(&KNOWLEDGE, "steel-45").unwrap(),
        CuttingMethod::Formula,
        &KNOWLEDGE,
    );
    let diameter = Micrometres::from_mm_rounded(drill.diameter);
    let cut = plain_cut(Operation::Drill, Micrometres::ZERO, diameter);
    let found = cutting::conditions(&cut, &shop).unwrap();
    assert!((found.feed_mm_per_rev.0 - drill.feed).abs() < 1e-9, "Ø{}", drill.diameter);
    (found.torque_n_m.unwrap().0, found.axial_force_n.unwrap().0)
}

/// The formula of facts 1.4 by hand: M = 10·0.0345·D²·s^0.8·0.8459, P = 10·68·D·s^0.7·0.8459.
#[test]
fn ours_is_facts_1_4() {
    for (drill, (torque, thrust)) in DRILLS.iter().zip([(2.30, 915.0), (9.63, 2180.0), (53.8, 5844.0)]) {
        let found = ours(drill);
        assert!((found.0 / torque - 1.0).abs() < 0.005, "Ø{}: {found:?}", drill.diameter);
        assert!((found.1 / thrust - 1.0).abs() < 0.005, "Ø{}: {found:?}", drill.diameter);
    }
}

/// Torque lies between the two: the Handbook's is 1.22 (Ø20) to 1.57 (Ø6) times ours, Tungaloy's 0.71 (Ø6) to
/// 0.76 (Ø20). Thrust is the lowest of the three: the Handbook's is 1.75 to 1.84 times ours, Tungaloy's 1.08
/// to 1.25.
#[test]
fn the_spread_of_three_sources_is_known() {
    for drill in &DRILLS {
        let (torque, thrust) = ours(drill);
        let (high, low) = (handbook(drill), tungaloy(drill));
        let ratios = [high.0 / torque, low.0 / torque, high.1 / thrust, low.1 / thrust];
        let bounds = [1.20..1.60, 0.70..0.80, 1.70..1.85, 1.05..1.27];
        for (ratio, bound) in ratios.iter().zip(&bounds) {
            assert!(bound.contains(ratio), "Ø{}: {ratio} is outside {bound:?} ({ratios:?})", drill.diameter);
        }
    }
}
