//! The fixed cycles G81…G86 (textbook 3.12.1).
//!
//! Every cycle moves along the cycle axis of the active plane through the points 0 to 4 of figure 3.3:
//!
//! ```text
//! 0  where the tool is when the cycle begins
//! 1  level U: the feed begins            0-1 at rapid
//! 2  level Z: the feed ends, dwell E     1-2 at feed, at once or in steps
//! 3  way out                             2-3 at rapid, in G82 and G84 at feed
//! 4  level I, else point 3               3-4 at rapid
//! ```
//!
//! The diagrams are lost. The place of point 3 is given for a cycle without I only: there 0, 3 and 4 are one point
//! (l. 2805). With I the program assumes level U, or I itself if that is reached first: the tool leaves the hole at
//! the rate of 2-3, and the rest is rapid.

use super::block::Maker;
use super::state::{CYCLE, PLANE, SYSTEM};
use super::words::{BlockWords, WordValue, letter};
use crate::note::IntoFigure;
use crate::program::limits::Floating;
use std::collections::BTreeMap;

use crate::motion::{Axis, BlockRef, Motion, Position, Turning};
use crate::program::{Call, TextSpan, path};
use crate::units::Micrometres;

/// The levels of a cycle along its axis, machine coordinates without corrections.
#[derive(Clone, Copy, Debug)]
struct CycleLevels {
    axis: Axis,
    one: Micrometres,
    two: Micrometres,
    three: Micrometres,
    four: Micrometres,
}

/// A hole as a cycle makes it: the tool, the manner, and the position of its bottom on the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Hole {
    tool: u32,
    cycle: u8,
    axis: Axis,
    bottom: Position,
    floating: [Floating; 3],
    /// Level U.
    from: Micrometres,
}

/// The block that made each hole first, and the calls that led to it.
pub(super) type Holes = BTreeMap<Hole, (Vec<Call>, BlockRef)>;

impl Maker<'_> {
    /// Runs the active cycle: in its own block and in every later one that moves an axis, after everything else.
    pub(super) fn cycle(&mut self, words: &BlockWords) {
        let code = self.state.groups[CYCLE];
        let Some(cycle) = self.control.cycles.get(code) else { return };
        let moved = words.any_axis() && words.function(SYSTEM) != Some(92);
        let span = words.g[CYCLE].map_or(self.span, |function| function.span);
        if let Some(given) = &words.cycle {
            self.take_parameters(given);
        } else if !moved {
            return;
        }
        if code == 84 && !self.machine.can_tap {
            self.fault("cannot-tap", span);
            return;
        }
        let missing: Vec<String> =
            cycle.required.iter().filter(|sign| self.parameter(**sign).is_none()).map(ToString::to_string).collect();
        if !missing.is_empty() {
            self.report(
                "cycle-parameter-missing",
                span,
                &[("cycle", format!("G{code}").into_figure()), ("words", missing.join(", ").into_figure())],
            );
            return;
        }
        let axis = self.control.plane(self.state.groups[PLANE]).cycle_axis;
        if !self.may_move(axis, span) {
            return;
        }
        let levels = self.levels(axis);
        if !self.levels_lead_in_and_out(levels, span) {
            return;
        }
        let (in_steps, out_at_feed) = (cycle.in_steps, cycle.out_at_feed);
        if words.cycle.is_none() && self.on_the_way_to_the_change() {
            self.report("cycle-at-tool-change", span, &[("cycle", format!("G{code}").into_figure())]);
        }
        self.run_cycle(code, levels, in_steps, out_at_feed, span);
        if !self.broken() {
            self.drilled(code, levels, span);
        }
    }

    /// Whether the block moves away from the part: in the machine's system, or to the tool-change position. A cycle
    /// that runs there was forgotten.
    fn on_the_way_to_the_change(&self) -> bool {
        let (x, y) = self.machine.tool_change_at;
        let known = self.state.floating[..2].iter().all(Option::is_none);
        self.state.groups[SYSTEM] == 53 || (known && (self.state.base.x, self.state.base.y) == (x, y))
    }

    /// Remembers a hole; reports a fault if the same cycle has made it before with the same tool at the same levels.
    fn drilled(&mut self, cycle: u8, levels: CycleLevels, span: TextSpan) {
        let bottom = self.state.corrected(self.state.base.with(levels.axis, levels.two));
        let floating = self.state.floating;
        let hole = Hole { tool: self.state.tool, cycle, axis: levels.axis, bottom, floating, from: levels.one };
        match self.holes.get(&hole) {
            Some((calls, block)) => {
                let first = path(calls, *block);
                self.report(
                    "hole-twice",
                    span,
                    &[("cycle", format!("G{cycle}").into_figure()), ("first", first.into_figure())],
                );
            }
            None => {
                self.holes.insert(hole, (self.calls.to_vec(), self.block));
            }
        }
    }

    /// Required parameters keep their last value when left out; optional ones become none (l. 2672-2713). F is also
    /// the feed of every later block.
    fn take_parameters(&mut self, given: &[Option<WordValue>; 26]) {
        for address in ['I', 'E', 'H', 'M'] {
            self.state.parameters[letter(address)] = None;
        }
        for address in ['U', 'Z', 'I', 'V', 'W', 'E', 'H', 'M'] {
            if let Some(value) = given[letter(address)] {
                self.state.parameters[letter(address)] = Some(value.thousandths);
            }
        }
        if let Some(feed) = given[letter('F')] {
            self.take_feed(feed);
        }
    }

    /// Absolute parameters are levels; incremental ones are the travels 0-1, 1-2 and 2-4 (tables 3.10, 3.11).
    fn levels(&mut self, axis: Axis) -> CycleLevels {
        let zero = self.state.base.get(axis);
        let level = |maker: &Self, address: char, from: Micrometres| {
            maker.parameter(address).map(|value| maker.level(axis, value, from))
        };
        let (one, floating) = level(self, 'U', zero).unwrap_or((zero, None));
        let two = level(self, 'Z', one).map_or(one, |(value, _)| value);
        let four = level(self, 'I', two).map(|(value, _)| value);
        self.state.floating[axis.index()] = floating;
        let (three, four) = match four {
            None => (zero, zero),
            // Of U and I, the one nearer to point 2.
            Some(four) if (four - two).abs() < (one - two).abs() => (four, four),
            Some(four) => (one, four),
        };
        CycleLevels { axis, one, two, three, four }
    }

    /// Whether the feed goes into the metal and the way out comes back from it. Along X and Y nobody knows where the
    /// metal is.
    fn levels_lead_in_and_out(&mut self, levels: CycleLevels, span: TextSpan) -> bool {
        let CycleLevels { axis, one, two, four, .. } = levels;
        let sign = self.state.sign(axis, self.setting);
        let origin = self.state.origin_of(axis, self.setting).0;
        let shown = |level: Micrometres| Micrometres::new((level - origin).micrometres() * sign).into_figure();
        // Along a mirrored axis the part is mirrored with it.
        let inwards = |from: Micrometres, to: Micrometres| (to - from).micrometres() * sign <= 0;
        if axis == Axis::Z && !inwards(one, two) {
            self.report("cycle-upside-down", span, &[("u", shown(one)), ("z", shown(two))]);
        } else if axis == Axis::Z && self.parameter('I').is_some() && four != two && inwards(two, four) {
            self.report("cycle-ends-deeper", span, &[("i", shown(four)), ("z", shown(two))]);
        }
        !self.broken()
    }

    fn run_cycle(&mut self, code: u8, levels: CycleLevels, in_steps: bool, out_at_feed: bool, span: TextSpan) {
        let before = self.state.turning;
        let dwell = self.parameter('E').map_or(0, |value| value / 1000);
        let kept = self.parameter('M').is_some();
        let feed = Motion::Feed { feed_mm_per_min: self.feed(span) };
        let out = match self.parameter('H').filter(|_| code == 82) {
            Some(own) => Motion::Feed { feed_mm_per_min: self.feed_of(own, span) },
            None => feed.clone(),
        };
        if self.broken() {
            return;
        }
        self.along(levels.axis, levels.one, Motion::Rapid, span);
        if in_steps {
            self.steps_inwards(code, levels, &feed, span);
        } else {
            self.along(levels.axis, levels.two, feed, span);
        }
        self.wait_if(dwell);
        match code {
            // G85: the spindle is stopped while the tool leaves, so that it does not scratch the bore.
            85 => self.spindle(Turning::Stopped),
            // G84: the tap turns out of the thread.
            84 => self.spindle(reversed(before)),
            _ => {}
        }
        self.along(levels.axis, levels.three, if out_at_feed { out } else { Motion::Rapid }, span);
        if code == 84 {
            self.wait_if(dwell);
        }
        self.along(levels.axis, levels.four, Motion::Rapid, span);
        // Table 3.13, 3.15: with M the spindle stays as at point 2.
        if matches!(code, 84 | 85) && !kept {
            self.spindle(before);
        }
    }

    /// G83 and G86: the travel 1-2 in steps of V, so that chips break or are removed.
    ///
    /// G83: after every step the drill leaves the hole at rapid to point 1, which clears the flutes, and returns at
    /// rapid to the distance W above the metal. G86: after every step it retracts by W at rapid, which breaks the
    /// chip, and stays in the hole. That G83 leaves to point 1 is reconstructed, because its diagram is lost.
    fn steps_inwards(&mut self, code: u8, levels: CycleLevels, feed: &Motion, span: TextSpan) {
        let [step, clearance] = ['V', 'W'].map(|address| self.parameter(address).unwrap_or_default());
        for (address, value) in [('V', step), ('W', clearance)] {
            if value <= 0 {
                self.report("cycle-step-not-positive", span, &[("address", address.into_figure())]);
            }
        }
        if clearance > step {
            self.fault("cycle-clearance-over-step", span);
        }
        if self.broken() {
            return;
        }
        let axis = levels.axis;
        let whole = (levels.two - levels.one).micrometres();
        let inwards = whole.signum();
        let mut done = 0;
        loop {
            done = (done + step).min(whole.abs());
            self.along(axis, levels.one + Micrometres::new(done * inwards), feed.clone(), span);
            if done >= whole.abs() || self.step_count > self.budget || self.broken() {
                return;
            }
            let back = (done - clearance).max(0);
            if code == 83 {
                self.along(axis, levels.one, Motion::Rapid, span);
            }
            self.along(axis, levels.one + Micrometres::new(back * inwards), Motion::Rapid, span);
        }
    }

    /// A motion to a level of the cycle axis; none if the tool is there.
    fn along(&mut self, axis: Axis, level: Micrometres, motion: Motion, span: TextSpan) {
        if self.state.base.get(axis) == level {
            return;
        }
        let from = self.state.corrected(self.state.base);
        self.state.base = self.state.base.with(axis, level);
        self.push_from(motion, from, span);
    }

    fn wait_if(&mut self, steps: i64) {
        if steps > 0 {
            self.wait(steps);
        }
    }
}

const fn reversed(turning: Turning) -> Turning {
    match turning {
        Turning::Clockwise => Turning::Counterclockwise,
        Turning::Counterclockwise => Turning::Clockwise,
        Turning::Stopped => Turning::Stopped,
    }
}
