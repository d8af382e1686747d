//! The way of a mill through a slot, motion by motion: what programs write and clocks count.

use crate::motion::Sense;
use crate::units::{Micrometres, MillimetresPerMinute};

use super::{Cycle, SlotArc, SlotCycle};

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
    /// Round about that centre, from the point of the slot.
    Arc([Micrometres; 2], Turn),
}

/// How far an arc goes round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Onto a wall or off it.
    Quarter,
    /// Round an end.
    Half,
}

impl Turn {
    /// The length of the arc over that of its chord: an angle α over 2·sin(α/2).
    pub fn over_chord(self) -> f64 {
        match self {
            Self::Quarter => std::f64::consts::FRAC_PI_2 / std::f64::consts::SQRT_2,
            Self::Half => std::f64::consts::FRAC_PI_2,
        }
    }
}

impl Cycle {
    /// The motions in a slot on the grid of a machine, from its point and back to it: at every level
    ///
    /// 1. down, where the level above ended;
    /// 2. along the middle to the other end;
    /// 3. for each radius r to where a quarter of r, or of the radius of the mill if that is less, leads onto the wall at this end;
    ///    round this end, along the wall, round the other end, back along the other wall, a quarter half as large off it, and to the
    ///    middle. So no wall is met or left square, where a mill that stands still digs in. Round an end is half a circle, and of a
    ///    pocket a quarter in each corner.
    ///
    /// After the last level back along the middle, where that ended at the other end.
    pub fn slot_path(slot: &SlotCycle, resolution: Micrometres) -> Vec<SlotMove> {
        let grid = |value: f64| Micrometres::from_mm_rounded(value).on_grid(resolution);
        let ends = [[0.0, 0.0], [slot.run.x.to_mm(), slot.run.y.to_mm()]];
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
            // Across the slot, to the left of the way from here to the other end; a clockwise way keeps to the right.
            let aside = slot.aside(at == 0);
            for radius in slot.radii.iter().map(|radius| radius.to_mm()) {
                moves.extend(slot.round(aside, radius, (middle(at), middle(other)), resolution));
            }
        }
        if at == 1 {
            moves.push(SlotMove { to: middle(0), motion: SlotMotion::Across });
        }
        moves
    }
}

impl SlotCycle {
    /// The side on which a wall is begun, from the first end or from the other.
    fn aside(&self, first: bool) -> [f64; 2] {
        let [dx, dy] = self.run.direction();
        let left = [-dy, dx];
        if first == (self.sense == Sense::Counterclockwise) { left } else { [dy, -dx] }
    }

    /// One way round, from the middle here and back to it.
    fn round(
        &self,
        aside: [f64; 2],
        radius: f64,
        (here, there): ([Micrometres; 2], [Micrometres; 2]),
        resolution: Micrometres,
    ) -> Vec<SlotMove> {
        // All arcs are turned out of rounded steps: each then ends as far from its centre as it begins.
        let step = |length: f64| aside.map(|share| Micrometres::from_mm_rounded(length * share).on_grid(resolution));
        let ahead = |[x, y]: [Micrometres; 2]| match self.sense {
            Sense::Counterclockwise => [y, Micrometres::ZERO - x],
            Sense::Clockwise => [Micrometres::ZERO - y, x],
        };
        let plus = |[x, y]: [Micrometres; 2], [dx, dy]: [Micrometres; 2]| [x + dx, y + dy];
        let minus = |[x, y]: [Micrometres; 2], [dx, dy]: [Micrometres; 2]| [x - dx, y - dy];
        let straight = |to| SlotMove { to, motion: SlotMotion::Across };
        let arc = |to, about, turn| SlotMove { to, motion: SlotMotion::Arc(about, turn) };
        let lead = radius.min(self.lead.to_mm());
        let (side, on, off) = (step(radius), step(lead), step(lead / 2.0));
        let wall = plus(here, side);
        let (about_on, about_off) = (minus(wall, on), minus(wall, off));
        let mut moves = vec![straight(plus(about_on, ahead(on))), arc(wall, about_on, Turn::Quarter)];
        match self.corner {
            None => moves.extend([
                arc(minus(here, side), here, Turn::Half),
                straight(minus(there, side)),
                arc(plus(there, side), there, Turn::Half),
            ]),
            Some(last) => {
                let corner = step((last.to_mm() - (self.widest().to_mm() - radius)).max(0.0));
                let (turn, inner) = (ahead(corner), minus(side, corner));
                // From the middle of an end to the middles of its corner radii, each with where its arc begins and ends.
                let beyond = ahead(inner);
                let corners = [
                    (plus(minus(here, beyond), inner), corner, minus([Micrometres::ZERO; 2], turn)),
                    (
                        minus(minus(here, beyond), inner),
                        minus([Micrometres::ZERO; 2], turn),
                        minus([Micrometres::ZERO; 2], corner),
                    ),
                    (minus(plus(there, beyond), inner), minus([Micrometres::ZERO; 2], corner), turn),
                    (plus(plus(there, beyond), inner), turn, corner),
                ];
                for (about, begin, end) in corners {
                    moves.push(straight(plus(about, begin)));
                    if corner != [Micrometres::ZERO; 2] {
                        moves.push(arc(plus(about, end), about, Turn::Quarter));
                    }
                }
            }
        }
        moves.extend([straight(wall), arc(minus(about_off, ahead(off)), about_off, Turn::Quarter), straight(here)]);
        moves
    }

    /// How far the mill's middle goes from the middle line at most, into the corners of a pocket, too: (r - c)·√2 + c.
    pub fn reach(&self) -> Micrometres {
        let widest = self.widest();
        self.corner.map_or(widest, |corner| {
            let corner = corner.to_mm().max(0.0);
            Micrometres::from_mm_rounded((widest.to_mm() - corner) * std::f64::consts::SQRT_2 + corner)
        })
    }

    /// The radii of the arcs of one way round so far from the middle line: in the corners or round the ends, onto the wall, off it.
    pub(super) fn turns(&self, radius: Micrometres) -> impl Iterator<Item = Micrometres> + use<> {
        let lead = radius.min(self.lead);
        let corner = self.corner.map_or(radius, |last| (last - (self.widest() - radius)).max(Micrometres::ZERO));
        [corner, lead, lead.half()].into_iter().filter(|radius| *radius > Micrometres::ZERO)
    }

    /// The feed of a motion, where that of the cycle is `along`.
    pub fn feed_of(&self, made: SlotMove, along: MillimetresPerMinute) -> MillimetresPerMinute {
        match made.motion {
            SlotMotion::Down(_) => self.plunge_mm_per_min.unwrap_or(along),
            SlotMotion::Across => along,
            SlotMotion::Arc([x, y], _) => {
                let radius = libm::hypot((made.to[0] - x).to_mm(), (made.to[1] - y).to_mm());
                self.arc_feed(radius, along)
            }
        }
    }

    /// The feed on an arc of the mill's middle of about that radius, mm: that of the nearest arc of the cycle.
    pub fn arc_feed(&self, radius: f64, along: MillimetresPerMinute) -> MillimetresPerMinute {
        let aside = |arc: &SlotArc| (arc.radius.to_mm() - radius).abs();
        let nearest = self.arcs.iter().min_by(|one, other| aside(one).total_cmp(&aside(other)));
        nearest.map_or(along, |arc| arc.mm_per_min)
    }

    /// How far the mill's middle goes from the middle line of the slot.
    pub fn widest(&self) -> Micrometres {
        self.radii.iter().copied().max().unwrap_or_default()
    }
}
