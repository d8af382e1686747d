//! The distance between points: straight-line length, or the time of the machine's rapids.
//!
//! Every cost is a whole number, so that the last digit of a floating-point sum never decides between paths:
//! micrometres of distance or, where axes have an acceleration, microseconds of time.

use crate::machine::Rapid;
use crate::part::Point;
use crate::units::{Micrometres, Minutes};

/// What makes one path shorter than another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Metric {
    /// Straight distance, rounded to the micrometre.
    Euclid,
    /// Straight distance rounded to whole units of the list, as `EUC_2D` of TSPLIB defines it.
    EuclidWhole,
    /// Time of a rapid.
    Rapid(Rapid),
}

/// Time of a rapid from point to point, min.
pub(super) fn between(rapid: Rapid, from: Point, to: Point) -> Minutes {
    rapid.time(slower_axis(from, to))
}

/// The travel of the axis that goes farther: both axes have the same rate, so it arrives last.
fn slower_axis(from: Point, to: Point) -> Micrometres {
    (from.x - to.x).abs().max((from.y - to.y).abs())
}

/// One thousandth of a unit of the list to a micrometre.
const WHOLE: f64 = 1000.0;
const MICROSECONDS: f64 = 60.0e6;

impl Metric {
    /// The cost of going from one point to another; never negative, and the same back.
    #[inline]
    pub fn cost(&self, from: Point, to: Point) -> i64 {
        match self {
            Self::Euclid => (straight(from, to) + 0.5) as i64,
            Self::EuclidWhole => ((straight(from, to) / WHOLE + 0.5) as i64) * WHOLE as i64,
            Self::Rapid(rapid) if rapid.acceleration.is_some() => {
                (between(*rapid, from, to).0 * MICROSECONDS).round() as i64
            }
            Self::Rapid(_) => slower_axis(from, to).micrometres(),
        }
    }

    /// The time of a cost, min; none for a plain distance.
    pub fn minutes(&self, cost: i64) -> Option<Minutes> {
        match self {
            Self::Euclid | Self::EuclidWhole => None,
            Self::Rapid(rapid) if rapid.acceleration.is_some() => Some(Minutes(cost as f64 / MICROSECONDS)),
            // A sum of distances at one rate.
            Self::Rapid(rapid) => Some(Minutes(cost as f64 / 1000.0 / rapid.rate.0)),
        }
    }
}

/// Straight distance, micrometres: exact products and one correctly rounded root, the same everywhere.
#[inline]
fn straight(from: Point, to: Point) -> f64 {
    let (x, y) = ((from.x - to.x).micrometres() as f64, (from.y - to.y).micrometres() as f64);
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{MillimetresPerMinute, MillimetresPerSecondSquared};

    fn point(x: i64, y: i64) -> Point {
        Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) }
    }

    const SLOW: Rapid = Rapid { rate: MillimetresPerMinute(6000.0), acceleration: None };

    #[test]
    fn the_slower_axis_decides_a_rapid() {
        let metric = Metric::Rapid(SLOW);
        assert_eq!(metric.cost(point(0, 0), point(30, -40)), 40_000);
        assert_eq!(metric.minutes(40_000), Some(Minutes(40.0 / 6000.0)));
        assert_eq!(Metric::Euclid.cost(point(0, 0), point(30, -40)), 50_000);
        assert_eq!(Metric::EuclidWhole.cost(point(0, 0), point(1, 1)), 1000, "nint(1.414)");
        assert_eq!(Metric::Euclid.minutes(50_000), None);
    }

    #[test]
    fn an_axis_that_speeds_up_takes_longer() {
        // 100 mm/s with 1000 mm/s²: 0.1 s and 5 mm to speed up, as much to slow down.
        let rapid = Rapid { acceleration: Some(MillimetresPerSecondSquared(1000.0)), ..SLOW };
        let seconds = |mm| rapid.time(Micrometres::from_mm(mm)).0 * 60.0;
        assert!((seconds(100) - 1.1).abs() < 1e-12);
        assert!((seconds(10) - 0.2).abs() < 1e-12, "the triangle and the trapezium meet at v²/a");
        assert!((seconds(5) - 2.0 * 0.005_f64.sqrt()).abs() < 1e-12);
        assert_eq!(rapid.time(Micrometres::ZERO), Minutes(0.0));
        assert_eq!(Metric::Rapid(rapid).cost(point(0, 0), point(100, 3)), 1_100_000);
    }
}
