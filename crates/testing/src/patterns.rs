//! Drilling patterns, the same in every run: for the bench of the order and for its tests.

use technolog::part::Point;
use technolog::units::Micrometres;

/// Every pattern with its name: grids, bolt circles, scattered holes and mixtures of all.
pub fn all() -> Vec<(String, Vec<Point>)> {
    let mut all = vec![("mixed-13".to_owned(), mixed(13))];
    for count in [200, 650, 1300] {
        all.push((format!("grid-{count}"), grid(count)));
        all.push((format!("circles-{count}"), circles(count)));
        all.push((format!("mixed-{count}"), mixed(count)));
        all.push((format!("random-{count}"), random(count)));
    }
    all
}

fn at(x: f64, y: f64) -> Point {
    Point { x: Micrometres::from_mm_rounded(x), y: Micrometres::from_mm_rounded(y) }
}

/// A grid with a tenth of its holes left out.
pub fn grid(count: usize) -> Vec<Point> {
    let mut numbers = Random(11);
    let columns = (1..).find(|columns| columns * (columns * 2 / 5 + 1) * 9 / 10 > count).unwrap_or(1);
    let mut points = Vec::new();
    for row in 0.. {
        for column in 0..columns {
            if numbers.below(10) > 0 {
                points.push(at(column as f64 * 12.5, f64::from(row) * 12.5));
            }
            if points.len() == count {
                return points;
            }
        }
    }
    points
}

/// Bolt circles over a plate, each two of one middle.
pub fn circles(count: usize) -> Vec<Point> {
    let mut numbers = Random(12);
    let mut points = Vec::new();
    while points.len() < count {
        let (x, y) = (numbers.below(900) as f64, numbers.below(350) as f64);
        for diameter in [24.0, 40.0] {
            let holes = 6 + numbers.below(7);
            for hole in 0..holes {
                let angle = std::f64::consts::TAU * hole as f64 / holes as f64;
                points.push(at(x + diameter / 2.0 * libm::cos(angle), y + diameter / 2.0 * libm::sin(angle)));
            }
        }
    }
    points.truncate(count);
    points
}

/// Holes anywhere.
pub fn random(count: usize) -> Vec<Point> {
    let mut numbers = Random(13);
    (0..count).map(|_| at(numbers.below(1_000_000) as f64 / 1000.0, numbers.below(400_000) as f64 / 1000.0)).collect()
}

/// A third of each, over one another.
pub fn mixed(count: usize) -> Vec<Point> {
    let third = count / 3;
    [grid(third), circles(third), random(count - 2 * third)].concat()
}

struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }
}
