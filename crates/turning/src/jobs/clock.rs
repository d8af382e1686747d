//! The time of a toolpath.

use crate::turning::program::{Feeds, Speed};
use crate::turning::toolpath::Toolpath;
use crate::units::{MillimetresPerMinute, Minutes, RevsPerMinute};
use technolog_cutting::rpm_at;

use crate::turning::contour::Piece;
use crate::turning::length::Half;

/// The time of a toolpath, min: path over feed times spindle speed, rapids at one rate. At a constant cutting speed
/// the spindle follows the radius up to its limit.
pub fn time(path: &Toolpath, speed: Speed, feeds: &Feeds, rapid: MillimetresPerMinute) -> Minutes {
    let times = path.paced().map(|(piece, purpose, own)| match own.or_else(|| feeds.of(purpose)) {
        None => piece.length_mm() / rapid.0,
        Some(feed) => piece.length_mm() / feed.0 * minutes_per_turn(piece, speed),
    });
    Minutes(times.sum())
}

/// The mean time of a spindle revolution over a piece, min.
fn minutes_per_turn(piece: Piece, speed: Speed) -> f64 {
    /// Enough for a thousandth of a facing cut, whose middle is at the limit of the spindle.
    const PARTS: u32 = 64;
    match speed {
        Speed::Spindle(rpm) => 1.0 / rpm.0,
        Speed::Cutting { speed, limit } => {
            let (from, to) = (piece.from.radius.to_mm(), piece.to.radius.to_mm());
            let at = |part: u32| {
                let share = (f64::from(part) + 0.5) / f64::from(PARTS);
                let radius = Half::from((from + (to - from) * share).abs());
                let rpm = if radius > Half::ZERO { rpm_at(speed, radius.diameter()) } else { limit };
                1.0 / RevsPerMinute(rpm.0.min(limit.0)).0
            };
            (0..PARTS).map(at).sum::<f64>() / f64::from(PARTS)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::Point;
    use crate::turning::toolpath::Purpose;
    use crate::units::{MetresPerMinute, MillimetresPerRev};

    /// By hand, a cut from Ø100 to the axis at 100 m/min, at most 1000 1/min, 0.1 mm/rev. Above r0 = 100000/(2π·1000) =
    /// 15.915 mm: 2π/(1000·100)·(50² − 15.915²)/2/0.1 = 0.7058 min; below it 15.915/(0.1·1000) = 0.1592 min.
    #[test]
    fn at_a_constant_cutting_speed_the_spindle_follows_the_radius() {
        let at = |radius: f64| Point { radius: Half::from(radius), z: Half::ZERO };
        let mut path = Toolpath::at(at(50.0));
        path.go(at(0.0), Purpose::Plunge);
        let feeds = Feeds::all(MillimetresPerRev(0.1));
        let rapid = MillimetresPerMinute(5000.0);
        let cutting = Speed::Cutting { speed: MetresPerMinute(100.0), limit: RevsPerMinute(1000.0) };
        assert!((time(&path, cutting, &feeds, rapid).0 - 0.8650).abs() < 0.001);
        assert!((time(&path, Speed::Spindle(RevsPerMinute(500.0)), &feeds, rapid).0 - 1.0).abs() < 1e-9);
        path.go(at(50.0), Purpose::Rapid);
        assert!((time(&path, Speed::Spindle(RevsPerMinute(500.0)), &feeds, rapid).0 - 1.01).abs() < 1e-9);
    }
}
