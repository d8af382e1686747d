//! How a tool has stood since it came: how high, where it cut and how deep. It tells a rapid sideways out of metal, and a tool
//! change where the tool still cuts, of a program by itself; with a part the proof knows where metal is.

use crate::motion::{Motion, Position, Turning};
use crate::program::limits::Floating;
use crate::units::Micrometres;

/// What is told of the heights. A run with an error has left out what that block says, and the tool stands elsewhere then.
pub(super) const TOLD: [&str; 7] = [
    "rapid-from-hole",
    "rapid-at-depth",
    "home-in-cut",
    "change-low",
    "change-low-maybe",
    "change-not-withdrawn",
    "ends-in-cut",
];

/// How far below the zero a tool stands in its hole.
const IN_HOLE: Micrometres = Micrometres::new(200);

/// A cut that the tool has not yet left upwards.
#[derive(Clone, Copy, Debug)]
struct Cut {
    /// Below this level it is in the cut: where the feed down began, or just over a feed across.
    below: Micrometres,
    /// How deep it went.
    bottom: Micrometres,
    /// The highest level at which it went across, else the bottom.
    level: Micrometres,
    /// Whether it has gone across at feed: it may have left the metal at its side.
    across: bool,
    /// Whether it has gone down at feed: what only goes across at one height may be a torch or a laser.
    down: bool,
}

/// The heights of the tool in the spindle since it came.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stay {
    /// By which zero the heights count: heights by different ones cannot be compared.
    floating: Floating,
    highest: Micrometres,
    /// Whether it has come down to the work: its first way down is that, at feed too.
    arrived: bool,
    cut: Option<Cut>,
    /// The highest level below which it has cut.
    cuts_below: Option<Micrometres>,
}

impl Stay {
    /// A tool that comes into the spindle.
    pub const fn comes(at: Position, floating: Floating) -> Self {
        Self { floating, highest: at.z, arrived: false, cut: None, cuts_below: None }
    }

    /// A motion; `floating` is by which zero its end counts along Z, and `zero` that height. Returns the code of what is wrong
    /// with it, if anything.
    pub fn moves(
        &mut self,
        motion: &Motion,
        (from, to): (Position, Position),
        (floating, zero): (Floating, Micrometres),
        turning: Turning,
    ) -> Option<&'static str> {
        let sideways = from.x != to.x || from.y != to.y;
        let told = match self.cut.filter(|_| sideways && *motion == Motion::Rapid) {
            // A token lift leaves it in the hole.
            Some(cut) if !cut.across && (from.z <= cut.bottom || (from.z < cut.below && from.z < zero - IN_HOLE)) => {
                Some("rapid-from-hole")
            }
            Some(cut) if from.z == to.z && turning != Turning::Stopped => {
                // Where it only went across at one height, as a torch does, and never stood higher, that height is free.
                let low = from.z <= cut.level && (cut.down || cut.level < self.highest);
                // A sign may be missing: the feed began over the zero, and the way back ended under it.
                let under = !cut.across && from.z < zero && zero < cut.below;
                (low || under).then_some("rapid-at-depth")
            }
            _ => None,
        };
        if floating != self.floating {
            *self = Self { arrived: true, ..Self::comes(to, floating) };
            return told;
        }
        match motion {
            Motion::Feed { .. } | Motion::Arc { .. } => {
                self.cuts(from, to, sideways || matches!(motion, Motion::Arc { .. }))
            }
            Motion::Rapid => {
                self.highest = self.highest.max(to.z);
                self.arrived |= from.z != to.z;
                self.cut = self.cut.filter(|cut| to.z < cut.below);
            }
            _ => {}
        }
        told
    }

    /// A feed down or across.
    fn cuts(&mut self, from: Position, to: Position, across: bool) {
        let just_over = to.z + Micrometres::new(1);
        let below = if to.z < from.z { from.z } else { just_over };
        self.arrived |= across && from.z != to.z;
        let arrives = !across && !std::mem::replace(&mut self.arrived, true);
        if (to.z < from.z && !arrives) || across {
            let before = self.cut;
            // Straight down and deeper it makes a hole in the floor that it has cut.
            let hole = !across && before.is_none_or(|cut| to.z < cut.bottom);
            let level = if across { from.z.max(to.z) } else { to.z };
            let cut = Cut {
                below: before.map_or(below, |cut| cut.below.max(below)),
                bottom: before.map_or(to.z, |cut| cut.bottom.min(to.z)),
                level: before.filter(|cut| cut.across && !hole).map_or(level, |cut| cut.level.max(level)),
                across: !hole && (across || before.is_some_and(|cut| cut.across)),
                down: to.z < from.z || before.is_some_and(|cut| cut.down),
            };
            self.cut = Some(cut);
            self.cuts_below = Some(self.cuts_below.map_or(cut.below, |level| level.max(cut.below)));
        } else {
            self.cut = self.cut.filter(|cut| to.z < cut.below);
        }
        self.highest = self.highest.max(to.z);
    }

    /// Whether its heights count by a zero that is not known.
    pub const fn floats(&self) -> bool {
        self.floating.is_some()
    }

    /// Whether the tool at that height still stands in its cut.
    pub fn is_in_cut(&self, z: Micrometres) -> bool {
        self.cut.is_some_and(|cut| cut.down && z <= cut.level)
    }

    /// What is wrong with a tool change at that height: the tool stands no higher than where its feed began. Where it has
    /// never stood higher in this program, that level may lie far over the part.
    pub fn at_change(&self, z: Micrometres, floating: Floating) -> Option<&'static str> {
        let low = self.floating == floating && self.cuts_below.is_some_and(|level| z <= level);
        low.then_some(if self.highest > z { "change-low" } else { "change-low-maybe" })
    }
}
