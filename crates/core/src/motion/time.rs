//! The time of a program: the sum of what the machine needs for every step.

use serde::Serialize;

use super::{Axis, Motion, MotionStep, Position, Sink, geometry};
use crate::machine::{Machine, Rapid};
use crate::units::Minutes;

/// The times of the steps so far, min.
///
/// Rapids at the machine's rate by the slower axis, since each axis moves independently (textbook 3.9.1, 3.10.2);
/// feeds along their path; dwells as programmed; tool changes by the machine's record. Rapids have an acceleration
/// where the record has one; feeds have none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Times {
    /// At feed.
    pub feed_min: Minutes,
    /// At rapid.
    pub rapid_min: Minutes,
    /// Waiting.
    pub dwell_min: Minutes,
    /// Changing tools.
    pub tool_change_min: Minutes,
    /// All of it.
    pub total_min: Minutes,
}

/// The times that are known of a program: without a machine only those of its own words, min.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum KnownTimes {
    /// On a machine.
    OfMachine(Times),
    /// Without one: nobody knows how long rapids and tool changes take.
    Alone {
        /// At feed.
        feed_min: Minutes,
        /// Waiting.
        dwell_min: Minutes,
    },
}

/// A sink that sums up times.
#[derive(Clone, Debug)]
pub struct Clock {
    rapid: Option<Rapid>,
    tool_change: Minutes,
    at: Position,
    times: Times,
}

impl Clock {
    /// A clock for a machine whose axes start at that position; without one, rapids and tool changes take no time.
    pub fn new<'m>(machine: impl Into<Option<&'m Machine<'m>>>, at: Position) -> Self {
        let (none, machine) = (Minutes(0.0), machine.into());
        Self {
            rapid: machine.map(Machine::rapids),
            tool_change: machine.map_or(none, |machine| machine.tool_change),
            at,
            times: Times { feed_min: none, rapid_min: none, dwell_min: none, tool_change_min: none, total_min: none },
        }
    }

    /// What is known of the times so far.
    pub fn known_times(&self) -> KnownTimes {
        let times = self.times();
        match self.rapid {
            Some(_) => KnownTimes::OfMachine(times),
            None => KnownTimes::Alone { feed_min: times.feed_min, dwell_min: times.dwell_min },
        }
    }

    /// The times so far, to the thousandth of a minute.
    pub fn times(&self) -> Times {
        let t = self.times;
        Times {
            feed_min: t.feed_min.rounded(3),
            rapid_min: t.rapid_min.rounded(3),
            dwell_min: t.dwell_min.rounded(3),
            tool_change_min: t.tool_change_min.rounded(3),
            total_min: (t.feed_min + t.rapid_min + t.dwell_min + t.tool_change_min).rounded(3),
        }
    }
}

impl Sink for Clock {
    fn take(&mut self, step: &MotionStep) {
        match &step.motion {
            Motion::Rapid => {
                let farthest = Axis::ALL.map(|axis| (step.at.get(axis) - self.at.get(axis)).abs()).into_iter().max();
                let time = self.rapid.map_or(Minutes(0.0), |rapid| rapid.time(farthest.unwrap_or_default()));
                self.times.rapid_min = self.times.rapid_min + time;
            }
            Motion::Feed { feed_mm_per_min } | Motion::Arc { feed_mm_per_min, .. } => {
                let length = geometry::length(&step.motion, self.at, step.at);
                if feed_mm_per_min.0 > 0.0 {
                    self.times.feed_min = self.times.feed_min + Minutes(length / feed_mm_per_min.0);
                }
            }
            Motion::Dwell { seconds } => self.times.dwell_min = self.times.dwell_min + Minutes(seconds / 60.0),
            Motion::ToolChange { .. } => self.times.tool_change_min = self.times.tool_change_min + self.tool_change,
            _ => {}
        }
        self.at = step.at;
    }
}
