//! The settings of a program besides its toolpath: the tool, the spindle, the feeds, the coolant.

use crate::turning::toolpath::Purpose;
use crate::units::{MetresPerMinute, MillimetresPerRev, RevsPerMinute};

use super::refused::NotWritten;
use super::text::number;

/// The speed of the spindle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// Constant cutting speed, and the spindle speed that must not be exceeded.
    Cutting {
        /// Cutting speed, above 0.
        speed: MetresPerMinute,
        /// The limit, above 0.
        limit: RevsPerMinute,
    },
    /// Constant spindle speed, above 0.
    Spindle(RevsPerMinute),
}

impl Speed {
    /// A constant cutting speed in whole metres per minute, as controls read it; rounded down.
    pub fn whole(speed: MetresPerMinute, limit: RevsPerMinute) -> Self {
        Self::Cutting { speed: MetresPerMinute(speed.0.floor().max(1.0)), limit }
    }
}

/// The feeds of a toolpath by the purpose of its moves, each above 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feeds {
    /// Of straight working passes.
    pub cut: MillimetresPerRev,
    /// Of infeed into the metal.
    pub infeed: MillimetresPerRev,
    /// Along the contour, cutting ridges.
    pub pick_up: MillimetresPerRev,
    /// Of the semi-finishing pass.
    pub semi_finish: MillimetresPerRev,
    /// Of finishing.
    pub finish: MillimetresPerRev,
    /// Of motions without metal, at a feed.
    pub back: MillimetresPerRev,
    /// Of plunges with the whole edge.
    pub plunge: MillimetresPerRev,
    /// The pitch of a thread.
    pub thread: MillimetresPerRev,
}

impl Feeds {
    /// The fastest of the feeds, threads left aside.
    pub fn fastest(&self) -> MillimetresPerRev {
        let all = [self.cut, self.infeed, self.pick_up, self.semi_finish, self.finish, self.back, self.plunge];
        MillimetresPerRev(all.iter().map(|feed| feed.0).fold(0.0, f64::max))
    }

    /// One feed for everything.
    pub const fn all(feed: MillimetresPerRev) -> Self {
        Self {
            cut: feed,
            infeed: feed,
            pick_up: feed,
            semi_finish: feed,
            finish: feed,
            back: feed,
            plunge: feed,
            thread: feed,
        }
    }

    /// The feed of a purpose; none for a rapid.
    pub const fn of(&self, purpose: Purpose) -> Option<MillimetresPerRev> {
        match purpose {
            Purpose::Rapid => None,
            Purpose::Cut => Some(self.cut),
            Purpose::Infeed => Some(self.infeed),
            Purpose::PickUp => Some(self.pick_up),
            Purpose::SemiFinish => Some(self.semi_finish),
            Purpose::Finish => Some(self.finish),
            Purpose::Return => Some(self.back),
            Purpose::Plunge => Some(self.plunge),
            Purpose::Thread => Some(self.thread),
        }
    }
}

/// Whether a figure is above 0 and is not written as 0.
pub(super) fn is_written(value: f64, places: u32) -> bool {
    value.is_finite() && value > 0.0 && number(value, places) != "0"
}

/// The settings of a program besides its toolpath.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The name of the part; it is written in Latin letters.
    pub name: String,
    /// The place of the tool, at least 1.
    pub tool: u32,
    /// The speed of the spindle; it always turns clockwise.
    pub speed: Speed,
    /// The feeds.
    pub feeds: Feeds,
    /// Whether coolant is on.
    pub coolant: bool,
}

impl Setting {
    /// Checks that every figure of it can be written.
    ///
    /// # Errors
    /// A tool, a speed or a feed that is not above 0, or so small that it is written as 0.
    pub(super) fn check(&self) -> Result<(), NotWritten> {
        let speeds = match self.speed {
            Speed::Cutting { speed, limit } => [speed.0, limit.0],
            Speed::Spindle(speed) => [speed.0, speed.0],
        };
        if self.tool == 0 {
            return Err(NotWritten::NoTool);
        }
        if !speeds.iter().all(|speed| is_written(*speed, 1)) {
            return Err(NotWritten::NoSpeed);
        }
        let feeds = &self.feeds;
        let rough = [feeds.cut, feeds.infeed, feeds.pick_up, feeds.semi_finish, feeds.finish, feeds.back];
        let all = rough.into_iter().chain([feeds.plunge, feeds.thread]);
        match all.into_iter().find(|feed| !is_written(feed.0, 4)) {
            Some(feed) => Err(NotWritten::NoFeed { feed }),
            None => Ok(()),
        }
    }
}
