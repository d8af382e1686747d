//! The duration of a lathe program.

use std::f64::consts::{PI, TAU};

use serde::Serialize;

use super::motion::{LatheAct, LatheFeed, LatheModes, LatheMotion, LathePoint, LatheSpeed};
use crate::motion::Sense;
use crate::units::{MillimetresPerMinute, Minutes};

/// The rates of a lathe used for times.
#[derive(Clone, Copy, Debug)]
pub struct LatheRates {
    /// Rapid along Z.
    pub rapid_z: MillimetresPerMinute,
    /// Rapid across, on the radius; that along Z where it is not known.
    pub rapid_x: Option<MillimetresPerMinute>,
}

/// The times of a program, to the thousandth of a minute.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LatheTimes {
    /// Lines, arcs and threads.
    pub feed_min: Minutes,
    /// Rapids; none where the rates of the lathe are not known.
    pub rapid_min: Option<Minutes>,
    /// Waiting.
    pub dwell_min: Minutes,
    /// The sum; tool changes are not counted.
    pub total_min: Minutes,
    /// Rapids from or to an unknown place, which are not counted.
    pub rapids_not_counted: usize,
}

/// The number of pieces of a path along which the spindle changes its speed.
const PIECES: usize = 64;

/// The times of motions.
///
/// Feeds act along the path; with constant cutting speed v the spindle turns at min(limit, 1000·v / (2π·r)) at radius
/// r, r in mm, v in m/min. Acceleration and deceleration are not counted.
pub fn times(motions: &[LatheMotion], rates: Option<LatheRates>) -> LatheTimes {
    let (mut feed, mut rapid, mut dwell, mut unknown) = (0.0, 0.0, 0.0, 0_usize);
    for motion in motions {
        let ends = motion.from.point().zip(motion.to.point());
        match (motion.act, ends) {
            (LatheAct::Rapid, Some((from, to))) => {
                if let Some(rates) = rates {
                    let x = (to.radius_mm - from.radius_mm).abs() / rates.rapid_x.unwrap_or(rates.rapid_z).0;
                    let z = (to.z_mm - from.z_mm).abs() / rates.rapid_z.0;
                    rapid += x.max(z);
                }
            }
            (LatheAct::Rapid | LatheAct::Away, _) => unknown += 1,
            (LatheAct::Feed { feed: at }, Some((from, to))) => {
                feed += along(&motion.modes, at, &|share| line(from, to, share))
            }
            (LatheAct::Thread { lead, .. }, Some((from, to))) => {
                feed += along(&motion.modes, LatheFeed::PerRevolution(lead), &|share| line(from, to, share));
            }
            (LatheAct::Arc { feed: at, centre, sense }, Some((from, to))) => {
                feed += along(&motion.modes, at, &|share| arc(from, to, centre, sense, share));
            }
            (LatheAct::Dwell { seconds }, _) => dwell += seconds.0 / 60.0,
            _ => {}
        }
    }
    let minutes = |value: f64| Minutes(value).rounded(3);
    LatheTimes {
        feed_min: minutes(feed),
        rapid_min: rates.map(|_| minutes(rapid)),
        dwell_min: minutes(dwell),
        total_min: minutes(feed + rapid + dwell),
        rapids_not_counted: unknown,
    }
}

fn line(from: LathePoint, to: LathePoint, share: f64) -> LathePoint {
    LathePoint {
        radius_mm: from.radius_mm + (to.radius_mm - from.radius_mm) * share,
        z_mm: from.z_mm + (to.z_mm - from.z_mm) * share,
    }
}

fn arc(from: LathePoint, to: LathePoint, centre: LathePoint, sense: Sense, share: f64) -> LathePoint {
    let angle = |at: LathePoint| libm::atan2(at.radius_mm - centre.radius_mm, at.z_mm - centre.z_mm);
    let sign = if sense == Sense::Counterclockwise { 1.0 } else { -1.0 };
    let swept = (angle(to) - angle(from)) * sign;
    let swept = if swept <= 1e-12 { swept + TAU } else { swept };
    let radius = libm::hypot(from.radius_mm - centre.radius_mm, from.z_mm - centre.z_mm);
    let here = angle(from) + sign * swept * share;
    LathePoint { radius_mm: centre.radius_mm + radius * libm::sin(here), z_mm: centre.z_mm + radius * libm::cos(here) }
}

/// The time along a path, min.
fn along(modes: &LatheModes, feed: LatheFeed, point_at: &dyn Fn(f64) -> LathePoint) -> f64 {
    let mut minutes = 0.0;
    for piece in 0..PIECES {
        let (a, b) = (point_at(piece as f64 / PIECES as f64), point_at((piece + 1) as f64 / PIECES as f64));
        let length = libm::hypot(b.radius_mm - a.radius_mm, b.z_mm - a.z_mm);
        let rate = match feed {
            LatheFeed::PerMinute(rate) => rate.0,
            LatheFeed::PerRevolution(per_rev) => {
                per_rev.0 * turns(modes.speed, f64::midpoint(a.radius_mm, b.radius_mm).abs())
            }
        };
        if length > 0.0 && rate > 0.0 {
            minutes += length / rate;
        }
    }
    minutes
}

/// The speed of the spindle at a radius, 1/min.
fn turns(speed: Option<LatheSpeed>, radius: f64) -> f64 {
    match speed {
        None => 0.0,
        Some(LatheSpeed::Spindle(speed)) => speed.0,
        Some(LatheSpeed::Cutting { speed, limit }) => {
            let turns = 1000.0 * speed.0 / (2.0 * PI * radius.max(1e-6));
            limit.map_or(turns, |limit| turns.min(limit.0))
        }
    }
}
