//! Building blocks of the tests.

use technolog_note::Figure;
use technolog_turning_proof::{
    At, Block, Cutter, Degrees, Fault, Hand, Holder, Mm, Motion, MotionKind, Piece, Profile, ProfilePiece, Proof,
    SetUp, Side, Stock, Tool, prove,
};

pub fn at(z: f64, radius: f64) -> At {
    At::new(Mm(z), Mm(radius))
}

/// A piece from place to place, with a name.
pub fn line(name: &str, from: (f64, f64), to: (f64, f64)) -> ProfilePiece {
    ProfilePiece::new(Piece::Line { from: at(from.0, from.1), to: at(to.0, to.1) }, Some(Figure::from_name(name)))
}

/// A name as a figure.
pub trait Named {
    fn from_name(name: &str) -> Self;
}

impl Named for Figure {
    fn from_name(name: &str) -> Self {
        Self::Text(name.to_owned().into())
    }
}

/// Lines through places, named s1, s2 and so on.
pub fn chain(places: &[(f64, f64)]) -> Vec<ProfilePiece> {
    let named = places.windows(2).enumerate();
    named.map(|(index, pair)| line(&format!("s{}", index + 1), pair[0], pair[1])).collect()
}

pub fn insert(lead: f64, trail: f64, nose: f64, hand: Hand, side: Side) -> Cutter {
    Cutter::Insert {
        lead_angle: Degrees(lead),
        trail_angle: Degrees(trail),
        nose_radius: Mm(nose),
        edge_length: Mm(12.0),
        hand,
        side,
    }
}

/// PCLNR 2525 with a nose.
pub fn pclnr(nose: f64) -> Tool {
    let cutter = insert(95.0, 5.0, nose, Hand::Right, Side::Outside);
    Tool { designation: "PCLNR".into(), cutter, holder: Holder::shank(Mm(25.0), Hand::Right) }
}

/// A tool without a holder.
pub fn bare(cutter: Cutter) -> Tool {
    Tool { designation: "bare".into(), cutter, holder: Holder::None }
}

/// A program of one tool: ways from place to place, each with its kind; its blocks count from 1.
pub fn program(tool: usize, start: (f64, f64), moves: &[(MotionKind, f64, f64)]) -> Vec<Motion> {
    let mut here = at(start.0, start.1);
    let mut motion = |(index, &(kind, z, radius)): (usize, &(MotionKind, f64, f64))| {
        let path = Piece::Line { from: here, to: at(z, radius) };
        here = at(z, radius);
        Motion { kind, path, tool, lead: None, start: Degrees(0.0), block: Block(index + 1) }
    };
    moves.iter().enumerate().map(&mut motion).collect()
}

/// The metal between two chains of places, or between one and the axis.
pub fn stock(outer: &[(f64, f64)], bore: &[(f64, f64)]) -> Stock {
    let lines = |places: &[(f64, f64)]| Piece::lines(&places.iter().map(|&(z, r)| at(z, r)).collect::<Vec<_>>());
    Stock::between(&lines(outer), &lines(bore))
}

/// Outside only, one tool, a bar.
pub fn bar_work(outside: Vec<ProfilePiece>, radius: f64, ends: (f64, f64), tool: Tool, motions: Vec<Motion>) -> SetUp {
    SetUp {
        profile: Profile { outside, bore: Vec::new() },
        stock: Stock::cylinder(Mm(radius), None, Mm(ends.0), Mm(ends.1)),
        tools: vec![tool],
        motions,
        ..SetUp::default()
    }
}

pub fn proven(set_up: &SetUp) -> Proof {
    prove(set_up).unwrap()
}

/// The faults that are not mild.
pub fn wrong(set_up: &SetUp) -> Vec<Fault> {
    proven(set_up).faults.into_iter().filter(|fault| !fault.is_mild()).collect()
}

/// Within a micrometre.
pub fn is(length: Mm, expected: f64) -> bool {
    (length.0 - expected).abs() < 0.001
}

/// A straight motion from where the last one ends, in the next block.
pub fn joined(motions: &[Motion], kind: MotionKind, to: At) -> Motion {
    let last = motions.last().unwrap();
    let path = Piece::Line { from: last.path.to(), to };
    Motion { kind, path, tool: last.tool, lead: None, start: Degrees(0.0), block: Block(last.block.0 + 1) }
}
