//! What a program does at each point, told without a part: which tool went down there, how deep, in how many steps, at which feed
//! and speed. From this the choices of a program can be read where nothing but the program is known.
//!
//! Positions are those of the steps: machine coordinates, which are those of the program where its zeros and length offsets are 0.

use crate::motion::{BlockRef, Motion, MotionStep, Plane, Turning};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute};

/// Everything that a tool did at a point between the motion to it and the motion away.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenCut {
    /// The number of the tool change before it, from 1; 0 before the first.
    pub section: usize,
    /// The tool in the spindle, 0 before the first change.
    pub tool: u32,
    /// The point; of circles their centre.
    pub at: [Micrometres; 2],
    /// Z where its first feed downwards began.
    pub begin: Micrometres,
    /// Z of its deepest point.
    pub deepest: Micrometres,
    /// How many times it fed downwards from another height.
    pub steps: usize,
    /// The feed downwards; of circles that of the circles.
    pub feed: MillimetresPerMinute,
    /// The speed at which it cut.
    pub speed: RevsPerMinute,
    /// Whether the spindle turned round while it was down: a tap.
    pub turned_round: bool,
    /// Whether it left its deepest point at feed, as a reamer does.
    pub out_at_feed: bool,
    /// Whether it went round or across below the beginning of its feed: a mill.
    pub mills: bool,
    /// The block of its first feed downwards.
    pub block: BlockRef,
}

/// What is known at a step of a run.
struct Walk {
    section: usize,
    tool: u32,
    turning: Turning,
    speed: RevsPerMinute,
    cuts: Vec<SeenCut>,
    /// Whether the last cut goes on.
    open: bool,
    /// Whether the last motion was a feed downwards.
    feeds_down: bool,
}

/// The cuts of a run that begins there, in their order.
pub fn cuts(steps: &[MotionStep], start: crate::motion::Position) -> Vec<SeenCut> {
    let mut walk = Walk {
        section: 0,
        tool: 0,
        turning: Turning::Stopped,
        speed: RevsPerMinute(0.0),
        cuts: Vec::new(),
        open: false,
        feeds_down: false,
    };
    let mut from = start;
    for step in steps {
        match &step.motion {
            Motion::ToolChange { tool } => {
                (walk.section, walk.tool, walk.open) = (walk.section + 1, *tool, false);
            }
            Motion::Spindle { turning, speed_rpm } => {
                let round = *turning != Turning::Stopped && *turning == walk.turning.reversed();
                if let Some(cut) = walk.last().filter(|_| round) {
                    cut.turned_round = true;
                }
                // A tap stops before it turns back.
                if *turning != Turning::Stopped || walk.last().is_none() {
                    walk.turning = *turning;
                }
                walk.speed = *speed_rpm;
            }
            Motion::Rapid => {
                if from.x != step.at.x || from.y != step.at.y {
                    walk.open = false;
                }
                walk.feeds_down = false;
            }
            Motion::Feed { feed_mm_per_min } => walk.feed(from, step, *feed_mm_per_min),
            Motion::Arc { plane, centre, feed_mm_per_min, .. } => {
                walk.feeds_down = false;
                let (speed, feed) = (walk.speed, *feed_mm_per_min);
                let centre = (*plane == Plane::Xy).then_some(*centre);
                let deepest = step.at.z;
                match walk.last() {
                    Some(cut) if deepest < cut.begin => {
                        cut.at = centre.unwrap_or(cut.at);
                        (cut.mills, cut.feed, cut.speed) = (true, feed, speed);
                        cut.deepest = cut.deepest.min(deepest);
                    }
                    _ => walk.open = false,
                }
            }
            _ => {}
        }
        from = step.at;
    }
    walk.cuts
}

impl Walk {
    /// The cut that goes on.
    fn last(&mut self) -> Option<&mut SeenCut> {
        let open = self.open;
        self.cuts.last_mut().filter(|_| open)
    }

    /// A straight feed.
    fn feed(&mut self, from: crate::motion::Position, step: &MotionStep, feed: MillimetresPerMinute) {
        let upright = from.x == step.at.x && from.y == step.at.y;
        let down = step.at.z < from.z;
        let speed = self.speed;
        if !upright {
            self.feeds_down = false;
            match self.last() {
                Some(cut) if from.z < cut.begin || step.at.z < cut.begin => {
                    (cut.mills, cut.feed, cut.speed) = (true, feed, speed);
                    cut.deepest = cut.deepest.min(step.at.z);
                }
                _ => self.open = false,
            }
            return;
        }
        let goes_on = std::mem::replace(&mut self.feeds_down, down);
        match self.last() {
            Some(cut) if down => {
                // A feed in the air, to the height where the cycle begins, is no part of the cut.
                if feed.0 < cut.feed.0 && step.at.z < cut.deepest {
                    (cut.feed, cut.begin, cut.steps) = (feed, from.z, 0);
                    cut.block = step.block;
                }
                cut.steps += usize::from(!goes_on);
                if step.at.z < cut.deepest {
                    (cut.deepest, cut.out_at_feed, cut.speed) = (step.at.z, false, speed);
                    cut.begin = cut.begin.max(from.z);
                }
            }
            Some(cut) => cut.out_at_feed |= from.z == cut.deepest,
            None if down => {
                self.cuts.push(SeenCut {
                    section: self.section,
                    tool: self.tool,
                    at: [step.at.x, step.at.y],
                    begin: from.z,
                    deepest: step.at.z,
                    steps: 1,
                    feed,
                    speed,
                    turned_round: false,
                    out_at_feed: false,
                    mills: false,
                    block: step.block,
                });
                self.open = true;
            }
            None => {}
        }
    }
}
