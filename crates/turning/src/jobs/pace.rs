//! How fast a job goes, and how long it takes.

use crate::turning::point::Point;
use crate::turning::program::{Feeds, Speed};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::transitions;
use crate::units::{MillimetresPerMinute, Minutes, RevsPerMinute, round_to};

/// How fast a job goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// By cutting conditions: the spindle, and feeds per revolution.
    PerRev {
        /// How the spindle turns.
        speed: Speed,
        /// The feed of each purpose.
        feeds: Feeds,
    },
    /// By the file, or by the table of motions where no lathe is named: rates of the axes.
    PerMinute {
        /// The rate of each purpose.
        rates: transitions::Feeds,
        /// The spindle speed, if the conditions have one.
        spindle: Option<RevsPerMinute>,
    },
}

impl Pace {
    /// The rate of a move that ends at a point; none for a rapid. At a constant cutting speed the spindle turns by the
    /// radius at the end of the move, up to its limit.
    fn rate(&self, purpose: Purpose, at: Point) -> Option<MillimetresPerMinute> {
        if purpose == Purpose::Rapid {
            return None;
        }
        Some(match self {
            Self::PerMinute { rates, .. } => rates.rate(purpose),
            Self::PerRev { speed, feeds } => {
                let rpm = match speed {
                    Speed::Spindle(rpm) => rpm.0,
                    Speed::Cutting { speed, limit } => {
                        let around = std::f64::consts::PI * 2.0 * at.radius.to_mm().abs();
                        if around > 0.0 { limit.0.min(speed.0 * 1000.0 / around) } else { limit.0 }
                    }
                };
                MillimetresPerMinute(feeds.of(purpose)?.0 * rpm)
            }
        })
    }

    /// The time of a toolpath; a rapid moves both axes at once, so its time is that of the longer motion.
    pub fn time(&self, path: &Toolpath, rapid: MillimetresPerMinute) -> Minutes {
        let each = path.pieces().map(|(piece, purpose)| match self.rate(purpose, piece.to) {
            Some(rate) => piece.length_mm() / rate.0,
            None => {
                let chord = piece.chord();
                chord.z.abs().max(chord.radius.abs()) / rapid.0
            }
        });
        Minutes(round_to(each.sum(), 4))
    }
}
