//! The time for finding the shortest sequence of passes, compared with trying every order and with petgraph's
//! Dijkstra; the time of the schemes of a zone; and how the time of a whole operation grows with the length of a
//! contour.
//!
//! `cargo bench --bench turning` prints a line for each shaft; the clock is read here, never by the search.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::hint::black_box;
use std::time::Instant;

use technolog::turning::contour::{Contour, Piece, Side, Turn};
use technolog::turning::length::Half;
use technolog::turning::operation::plan;
use technolog::turning::passes::cost::Objective;
use technolog::turning::passes::enumeration::enumerate;
use technolog::turning::passes::grid::Grid;
use technolog::turning::passes::optimum::CostToGo;
use technolog::turning::point::Point;
use technolog::turning::shaft::{Division, Shaft};
use technolog::turning::transitions::{Feeds, Scheme, Settings, Stock, Tool, work};
use technolog::turning::workpiece::read_turned;
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
    long_contours();
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

/// The toolpaths of the schemes of transitions over a zone of 50 pieces with 30 levels.
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
            made.path.moves.len(),
            made.measures.passes,
            microseconds(make)
        );
    }
}

/// Long contours, each of four sizes: what reading, planning and writing take, and with which power of the size they grow.
fn long_contours() {
    let knowledge = technolog::shipped::knowledge().unwrap();
    println!(
        "\n{:<12} {:>8} {:>6} {:>9} {:>9} {:>9} {:>8}",
        "contour", "elements", "works", "read ms", "plan ms", "json ms", "json MB"
    );
    for (name, shape, bore) in [
        ("steps", Shape::Steps, false),
        ("steps, bore", Shape::Steps, true),
        ("waves", Shape::Waves, false),
        ("waves, bore", Shape::Waves, true),
    ] {
        let mut times = Vec::new();
        for size in [125, 250, 500, 1000] {
            let text = long(shape, size, bore);
            let elements = text.lines().filter(|line| line.starts_with("  - ")).count();
            let workpiece = read_turned("long", &text, &knowledge).unwrap();
            let operation = plan(&workpiece, &knowledge).unwrap();
            let works: usize = operation.zones().map(|(_, _, zone)| zone.works.len()).sum();
            let json = serde_json::to_string(&operation).unwrap().len() as f64 / 1e6;
            let read = milliseconds(|| read_turned("long", &text, &knowledge).unwrap().threads.len());
            let planned = milliseconds(|| plan(&workpiece, &knowledge).unwrap().findings.len());
            let written = milliseconds(|| serde_json::to_string(&operation).unwrap().len());
            println!("{name:<12} {elements:>8} {works:>6} {read:>9.1} {planned:>9.1} {written:>9.1} {json:>8.1}");
            times.push((elements as f64, read + planned + written));
        }
        println!("{name:<12} grows with the power {:.2}", power(&times));
    }
}

/// The least time of a few runs.
fn milliseconds<T>(mut work: impl FnMut() -> T) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..3 {
        let start = Instant::now();
        black_box(work());
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
    }
    least
}

/// The power of the size with which a time grows: the slope of the straight line through their logarithms.
fn power(times: &[(f64, f64)]) -> f64 {
    let logarithms: Vec<(f64, f64)> = times.iter().map(|(size, time)| (libm::log(*size), libm::log(*time))).collect();
    let count = logarithms.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| logarithms.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|one| one.0), mean(|one| one.1));
    let slope = logarithms.iter().map(|one| (one.0 - x) * (one.1 - y)).sum::<f64>();
    slope / logarithms.iter().map(|one| (one.0 - x) * (one.0 - x)).sum::<f64>()
}

/// A repeated element of a long contour.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    /// It widens step by step.
    Steps,
    /// It widens by a fillet, a face and a chamfer and narrows again by a cone: each wave leaves a closed part.
    Waves,
}

/// A contour under construction; lengths and diameters are micrometres.
struct Pen {
    items: Vec<String>,
    diameter: i64,
    z: i64,
    /// 1 where the contour widens towards the chuck, −1 in a bore, which narrows.
    sign: i64,
}

impl Pen {
    fn at(start: i64, sign: i64) -> Self {
        let items = vec![format!("{{from: {{d: {}, z: 0}}}}", mm(start))];
        Self { items, diameter: start, z: 0, sign }
    }

    fn item(&mut self, wider: i64, along: i64, text: impl Fn(String, String) -> String) {
        self.diameter += self.sign * wider;
        self.z -= along;
        self.items.push(text(mm(self.diameter), mm(self.z)));
    }

    fn cylinder(&mut self, along: i64) {
        self.item(0, along, |_, z| format!("{{cylinder: {z}}}"));
    }

    fn groove(&mut self, width: i64, depth: i64) {
        let (wide, deep) = (mm(width), mm(depth));
        self.item(0, width, |_, _| format!("{{groove: rectangular, width: {wide}, depth: {deep}}}"));
    }

    fn cone(&mut self, wider: i64, along: i64) {
        self.item(wider, along, |d, z| format!("{{cone: {{d: {d}, z: {z}}}}}"));
    }

    fn quarter(&mut self, radius: i64, bulge: &str) {
        let size = mm(radius);
        self.item(2 * radius, radius, |d, z| format!("{{arc: {{d: {d}, z: {z}}}, radius: {size}, bulge: {bulge}}}"));
    }

    fn face(&mut self, wider: i64) {
        self.item(wider, 0, |d, _| format!("{{face: {d}}}"));
    }

    fn chamfer(&mut self, size: i64) {
        self.item(2 * size, size, |_, _| format!("{{chamfer: {}}}", mm(size)));
    }

    /// Ten elements of a shape.
    fn draw(&mut self, shape: Shape) {
        let (groove, cone, fillet, face, chamfer) = match shape {
            Shape::Steps => (500, 100, 100, 100, 100),
            Shape::Waves => (800, 2000, 2000, 1000, 500),
        };
        self.cylinder(2000);
        self.groove(2000, groove);
        self.cylinder(1000);
        self.cone(cone, 2000);
        self.cylinder(1500);
        self.quarter(fillet, "in");
        self.face(face);
        self.chamfer(chamfer);
        self.cylinder(2000);
        match shape {
            Shape::Steps => self.quarter(100, "out"),
            Shape::Waves => self.cone(-8000, 12_000),
        }
    }

    /// A list of a file.
    fn list(&self, key: &str) -> String {
        format!("{key}:\n{}", self.items.iter().map(|item| format!("  - {item}\n")).collect::<String>())
    }
}

/// The file of a part with so many elements, half of them in its bore if it has one.
fn long(shape: Shape, size: usize, bore: bool) -> String {
    let periods = |size: usize| size / 10;
    let mut outer = Pen::at(if bore { 70_000 } else { 0 }, 1);
    outer.item(0, 0, |_, _| "{face: 80}".to_owned());
    outer.diameter = 80_000;
    for _ in 0..periods(if bore { size / 2 } else { size }) {
        outer.draw(shape);
    }
    let mut inner = Pen::at(70_000, -1);
    for _ in 0..periods(size / 2) {
        inner.draw(shape);
    }
    let end = outer.z.min(if bore { inner.z } else { 0 }) - 2000;
    outer.cylinder(outer.z - end);
    inner.cylinder(inner.z - end);
    let inner = if bore { inner.list("inner") } else { String::new() };
    let (diameter, length) = (mm(outer.diameter + 14_000), mm(61_000 - end));
    format!(
        "shaft: Long\nmaterial: steel-45\nblank: {{kind: bar, diameter: {diameter}, length: {length}, face: 1}}\n{}{inner}\
         roughing: {{limiting_depth: 3}}\nallowances: {{method: stated, on_diameter: 0.2, on_face: 0.1}}\n\
         rates: {{longitudinal_feed: 180, transverse_feed: 150, rapid: 6000}}\n",
        outer.list("outer")
    )
}

/// Micrometres as files write them.
fn mm(micrometres: i64) -> String {
    Half::new(2 * micrometres).to_string()
}
