//! The way of a mill through a slot, motion by motion: what programs write and clocks count.

use crate::motion::Sense;
use crate::units::{Micrometres, MillimetresPerMinute};

use super::{Cycle, SlotCycle};

/// One motion in a slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlotMove {
    /// Where it ends, from the point of the slot, X and Y.
    pub to: [Micrometres; 2],
    /// What it is.
    pub motion: SlotMotion,
}

/// What a motion in a slot is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlotMotion {
    /// Straight down to that Z.
    Down(Micrometres),
    /// Straight across.
    Across,
    /// Half round, about that centre, from the point of the slot.
    Half([Micrometres; 2]),
}

impl Cycle {
    /// The motions in a slot on the grid of a machine, from its point and back to it: at every level
    ///
    /// 1. down, where the level above ended;
    /// 2. along the middle to the other end;
    /// 3. for each radius out to the wall, along it, round the other end, back, and round this end;
    /// 4. back to the middle.
    ///
    /// After the last level back along the middle, where that ended at the other end.
    pub fn slot_path(slot: &SlotCycle, resolution: Micrometres) -> Vec<SlotMove> {
        let grid = |value: f64| Micrometres::from_mm_rounded(value).on_grid(resolution);
        let ends = [[0.0, 0.0], [slot.run.x.to_mm(), slot.run.y.to_mm()]];
        let length = libm::hypot(ends[1][0], ends[1][1]);
        let middle = |end: usize| ends[end].map(grid);
        let mut moves = Vec::new();
        let mut at = 0;
        for level in &slot.levels {
            moves.push(SlotMove { to: middle(at), motion: SlotMotion::Down(level.on_grid(resolution)) });
            if slot.along_middle {
                at = 1 - at;
                moves.push(SlotMove { to: middle(at), motion: SlotMotion::Across });
            }
            let other = 1 - at;
            // Across the slot, to the right of the way from here to the other end; a clockwise way keeps to the left.
            let [dx, dy] = [0, 1].map(|axis| (ends[other][axis] - ends[at][axis]) / length);
            let right = match slot.sense {
                Sense::Counterclockwise => [dy, -dx],
                Sense::Clockwise => [-dy, dx],
            };
            for radius in slot.radii.iter().map(|radius| radius.to_mm()) {
                // Both sides from one rounded step: an arc then ends as far from its centre as it begins.
                let [x, y] = right.map(|share| grid(radius * share));
                let near =
                    |end: usize| SlotMove { to: [middle(end)[0] + x, middle(end)[1] + y], motion: SlotMotion::Across };
                let far =
                    |end: usize| SlotMove { to: [middle(end)[0] - x, middle(end)[1] - y], motion: SlotMotion::Across };
                let half = |made: SlotMove, end| SlotMove { motion: SlotMotion::Half(middle(end)), ..made };
                moves.extend([near(at), near(other), half(far(other), other), far(at), half(near(at), at)]);
            }
            if !slot.radii.is_empty() {
                moves.push(SlotMove { to: middle(at), motion: SlotMotion::Across });
            }
        }
        if at == 1 {
            moves.push(SlotMove { to: middle(0), motion: SlotMotion::Across });
        }
        moves
    }
}

impl SlotCycle {
    /// The feed of a motion, where that of the cycle is `along`.
    pub fn feed_of(&self, motion: SlotMotion, along: MillimetresPerMinute) -> MillimetresPerMinute {
        match motion {
            SlotMotion::Down(_) => self.plunge_mm_per_min.unwrap_or(along),
            SlotMotion::Across => along,
            SlotMotion::Half(_) => self.arc_mm_per_min,
        }
    }

    /// How far the mill's middle goes from the middle line of the slot.
    pub fn widest(&self) -> Micrometres {
        self.radii.iter().copied().max().unwrap_or_default()
    }
}
