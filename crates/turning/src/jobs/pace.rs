//! Speed and feeds of a job, and its time.

use crate::turning::program::{Feeds, Speed};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::transitions;
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerMinute, Minutes, RevsPerMinute, round_to};
use technolog_cutting::speed_at;

/// Speed and feeds of a job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// By cutting conditions: the spindle, and feeds per revolution.
    PerRev {
        /// The rotation of the spindle.
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
    /// Its feeds per revolution, if it has them.
    pub const fn feeds(&self) -> Option<Feeds> {
        match self {
            Self::PerRev { feeds, .. } => Some(*feeds),
            Self::PerMinute { .. } => None,
        }
    }

    /// The rotation of its spindle, if conditions give it.
    pub const fn speed(&self) -> Option<Speed> {
        match self {
            Self::PerRev { speed, .. } => Some(*speed),
            Self::PerMinute { spindle, .. } => match spindle {
                Some(rpm) => Some(Speed::Spindle(*rpm)),
                None => None,
            },
        }
    }

    /// The cutting speed, m/min: the constant one, or that of the spindle at the largest diameter of the cut. None if
    /// neither is known.
    pub fn cutting_speed(&self, largest: Option<Micrometres>) -> Option<MetresPerMinute> {
        match self.speed()? {
            Speed::Cutting { speed, .. } => Some(speed),
            Speed::Spindle(rpm) => largest.map(|diameter| speed_at(rpm, diameter)),
        }
    }

    /// The time of a toolpath; a rapid moves both axes at once, so its time is that of the longer motion.
    pub fn time(&self, path: &Toolpath, rapid: MillimetresPerMinute) -> Minutes {
        let rates = match self {
            Self::PerRev { speed, feeds } => return super::clock::time(path, *speed, feeds, rapid),
            Self::PerMinute { rates, .. } => rates,
        };
        let each = path.pieces().map(|(piece, purpose)| {
            let chord = piece.chord();
            let length =
                if purpose == Purpose::Rapid { chord.z.abs().max(chord.radius.abs()) } else { piece.length_mm() };
            length / if purpose == Purpose::Rapid { rapid.0 } else { rates.rate(purpose).0 }
        });
        Minutes(round_to(each.sum(), 4))
    }
}
