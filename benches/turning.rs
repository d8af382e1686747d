//! How long the shortest sequence of passes takes to find, beside trying every order, and beside petgraph's Dijkstra.
//!
//! `cargo bench --bench turning` prints a line for each shaft; the clock is read here, never by the search.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::hint::black_box;
use std::time::Instant;

use technolog::turning::contour::{Contour, Piece, Side, Turn};
use technolog::turning::length::Half;
use technolog::turning::passes::cost::Objective;
use technolog::turning::passes::enumeration::enumerate;
use technolog::turning::passes::grid::Grid;
use technolog::turning::passes::optimum::CostToGo;
use technolog::turning::point::Point;
use technolog::turning::shaft::{Division, Shaft};
use technolog::turning::transitions::{Feeds, Scheme, Settings, Stock, Tool, work};
use technolog::units::{Degrees, MillimetresPerMinute};
use technolog_testing::shafts;
use technolog_testing::shafts::by_petgraph;

fn main() {
    let rates = shafts::rates();
    println!("steps  levels  slices   states  path us  time us  petgraph us           orders  enumeration us");
    for (steps, each_levels, each_slices) in
        [(2, 2, 2), (2, 3, 3), (3, 3, 3), (3, 4, 4), (3, 5, 5), (12, 5, 5), (12, 10, 10), (12, 60, 60)]
    {
        let shaft = stepped(steps, each_levels, each_slices);
        let grid = Grid::of(&shaft);
        let (levels, slices) = (grid.levels.len(), grid.slices.len());
        assert_eq!((levels, slices), ((steps * each_levels) as usize, (steps * each_slices) as usize));
        let path = microseconds(|| CostToGo::of(&grid, Objective::Path).passes().len());
        let time = microseconds(|| CostToGo::of(&grid, Objective::Time { rates }).passes().len());
        let petgraph_time = microseconds(|| by_petgraph(&grid, 0));
        let found = CostToGo::of(&grid, Objective::Path).optimum().main;
        assert_eq!(found, by_petgraph(&grid, 0));
        print!(
            "{steps:>5} {levels:>7} {slices:>7} {:>8} {path:>8.1} {time:>8.1} {petgraph_time:>12.1}",
            (levels + 1) * (slices + 1)
        );
        // Every order of 15 levels and 15 slices takes seconds already.
        if levels + slices <= 30 {
            let start = Instant::now();
            let (best, orders) = enumerate(&grid, Objective::Path);
            println!(" {orders:>16} {:>15.1}", start.elapsed().as_secs_f64() * 1e6);
            assert_eq!(best.unwrap().main, found);
        } else {
            println!(" {:>16} {:>15}", "-", "-");
        }
    }
    transitions();
}

/// The least time of many runs: what the work takes when nothing else disturbs it.
fn microseconds<T>(mut work: impl FnMut() -> T) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..30 {
        let start = Instant::now();
        black_box(work());
        least = least.min(start.elapsed().as_secs_f64() * 1e6);
    }
    least
}

/// A shaft of equal steps with so many levels and slices over each.
fn stepped(steps: i64, levels: i64, slices: i64) -> Shaft {
    // The last level and slice of each step are remainders.
    let (rise, length) = (2 * (levels * 4_000 - 1_500), slices * 3_500 - 1_200);
    let all: Vec<(i64, i64)> = (0..steps).map(|step| (20_000 + step * rise, length)).collect();
    shafts::shaft(20_000 + steps * rise, &all, 4_000, 3_500, Division::Full)
}

/// A zone of so many pieces, cones, cylinders, faces and fillets in turn, that rise under a bar by so many levels.
fn shaped(pieces: usize, levels: i64) -> (Stock, Half) {
    let depth = Half::from(2.0);
    let top = Half::from(10.0) + Half::new(depth.halves() * levels);
    let rise = (top - Half::from(10.0)).halves() / pieces as i64;
    let mut contour = Contour { side: Side::Outer, pieces: Vec::new() };
    let mut here = Point { radius: Half::from(10.0), z: Half::ZERO };
    for index in 0..pieces {
        let by = |radius: i64, z: i64| Point { radius: here.radius + Half::new(radius), z: here.z + Half::new(z) };
        let piece = match index % 4 {
            0 => Piece::line(here, by(0, 8_000)),
            1 => Piece::line(here, by(rise * 2, 6_000)),
            2 => Piece::arc(here, by(rise, rise), Half::new(rise), Turn::Left),
            _ => Piece::line(here, by(rise, 0)),
        };
        here = piece.to;
        contour.pieces.push(piece);
    }
    let blank =
        Contour::through(Side::Outer, &[Point { radius: top, z: Half::ZERO }, Point { radius: top, z: here.z }]);
    (Stock { rough: contour, blank, from: Half::ZERO, to: here.z }, depth)
}

/// The ways of the schemes of transitions over a zone of 50 pieces with 30 levels.
fn transitions() {
    let knowledge = technolog::shipped::knowledge().unwrap();
    let (stock, depth) = shaped(50, 30);
    let tool = Tool { nose_radius: Half::from(0.8), main: Degrees(95.0), secondary: Degrees(30.0) };
    let rate = MillimetresPerMinute;
    let feeds = Feeds {
        main: rate(180.0),
        infeed: rate(90.0),
        pick_up: rate(120.0),
        semi_finish: rate(150.0),
        finish: rate(60.0),
        rapid: rate(6000.0),
    };
    let settings = Settings { depth, approach: Half::from(2.0), retract: Half::from(0.5), feeds };
    // Shifted along both axes by the distance: for a contour that only rises that is outside its true equidistant.
    let offset = |contour: &Contour, distance: Half| {
        let place = |point: Point| Point { radius: point.radius + distance, z: point.z - distance };
        Some(Contour {
            side: contour.side,
            pieces: contour.pieces.iter().map(|piece| piece.mapped(false, place)).collect(),
        })
    };
    println!("\n{:<18} {:>7} {:>7} {:>10}", "scheme", "moves", "passes", "us");
    for scheme in Scheme::ALL.into_iter().filter(|scheme| *scheme != Scheme::LoopAgainstStop) {
        let make = || work(&stock, &tool, &settings, scheme, &offset, &knowledge).unwrap();
        let made = make();
        println!(
            "{:<18} {:>7} {:>7} {:>10.1}",
            scheme.name(),
            made.way.moves.len(),
            made.measures.passes,
            microseconds(make)
        );
    }
}
