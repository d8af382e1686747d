//! The fixed cycles G73 and G81 to G89, along the axis across the plane; Z stands for it here.
//!
//! ```text
//! initial  where Z was when the first of a row of cycles began
//!    |     rapid: to the hole, then down
//!    R     the feed begins
//!    |     feed, at once or in steps of Q
//!    Z     the bottom: dwell P, the spindle goes on, stops or turns back
//!    |     rapid or feed
//!    R     the end with G99; with G98 the initial level
//! ```
//!
//! With G91 R is relative to the initial level and Z to R, and every repeat moves on by X and Y.
//!
//! LinuxCNC chooses the path to the hole (`cycle-rises`): from an initial level below R it first goes up to R, and from R
//! or below it crosses at the level where this hole will end. Others cross at their present level.

use super::block::Maker;
use super::control::{Bottom, Characteristic as Q, Cycle, Group, Inwards, Outwards};
use super::programs::calls;
use super::words::{BlockWords, Function, place};
use crate::motion::{Axis, Motion, Position, Turning};
use crate::note::IntoFigure;
use crate::program::TextSpan;
use crate::units::{Micrometres, round_to};

/// The levels of a cycle along Z, machine coordinates.
#[derive(Clone, Copy, Debug)]
struct CycleLevels {
    r: Micrometres,
    bottom: Micrometres,
    /// The level where it ends.
    clear: Micrometres,
}

impl Maker<'_> {
    /// Cancels the cycle and forgets the parameters; LinuxCNC keeps P for a cycle where it is optional.
    pub(super) fn cycle_off(&mut self) {
        self.state.set(Group::Cycle, None);
        self.state.initial = None;
        self.state.tap_prepared = false;
        self.forget();
    }

    /// M29 was given, and no tapping cycle has come.
    pub(super) fn no_tap_came(&mut self) {
        if let Some(span) = self.state.tap_expected.take() {
            self.fault("rigid-without-tap", span);
        }
    }

    fn forget(&mut self) {
        let kept = self.state.parameters[place('P')].filter(|_| self.control.is(Q::CycleBeginsAnew));
        self.state.parameters = [None; 26];
        self.state.parameters[place('P')] = kept;
    }

    /// Runs a cycle: in its own block, and in every later one that gives a position.
    pub(super) fn cycle(&mut self, code: i64, given: Option<Function>, words: &BlockWords) {
        let Some(cycle) = self.control.cycles.get(&code).cloned() else { return };
        let span = given.map_or(self.span, |function| function.span);
        if cycle.bottom == Bottom::Reversed {
            self.state.tap_expected = None;
        } else {
            self.no_tap_came();
        }
        if self.control.is(Q::CycleBeginsAnew) && self.state.mode(Group::Cycle) != Some(code) {
            self.forget();
            if cycle.required.contains(&'P') {
                self.state.parameters[place('P')] = None;
            }
        }
        if self.control.is(Q::CyclesAreMotions) {
            self.state.set(Group::Motion, None);
        }
        self.state.set(Group::Cycle, Some(code));
        let hole = words.names_any();
        if !hole && self.control.is(Q::CycleNeedsAxes) {
            if given.is_some() {
                self.report("axes-missing", span, &[("function", format!("G{}", code / 10).into_figure())]);
            }
            return;
        }
        let named = hole || words.get('R').is_some();
        let initial = self.initial();
        self.parameters(&cycle, words);
        let repeats = self.repeats(words, named);
        if !named {
            return;
        }
        let starts = self.starts_by_tap(&cycle);
        // Before what else may be wrong with it: a cycle without a feed must not be overlooked.
        if starts {
            self.feed_by_word(None, span);
        } else {
            self.feed(span);
        }
        let missing = cycle.required.iter().copied().filter(|sign| self.parameter(*sign).is_none());
        let missing: Vec<String> = missing.map(|sign| self.written(sign).to_string()).collect();
        if !missing.is_empty() {
            let figures =
                [("cycle", format!("G{}", code / 10).into_figure()), ("words", missing.join(", ").into_figure())];
            self.report("cycle-parameter-missing", span, &figures);
            return;
        }
        // LinuxCNC 2.9 taps outside G17 with its axes exchanged, as rs274 shows: nothing to be traced as right.
        let every = self.control.is(Q::CyclesInEveryPlane) && cycle.bottom != Bottom::Reversed;
        if self.state.mode(Group::Plane) != Some(170) && !every {
            self.fault("cycle-plane", span);
            return;
        }
        let Some(levels) = self.levels(initial, span).filter(|_| self.may_run(&cycle, span)) else { return };
        // Only a cycle that is run starts the spindle, and then it stops it: after another mistake it stands as before.
        if starts {
            self.start_spindle(Turning::Clockwise, span);
        }
        self.holes(&cycle, levels, words, repeats, span);
        if starts {
            self.spindle(Turning::Stopped);
        }
    }

    /// Whether the cycle starts the spindle: some tap without M3, where the spindle follows the feed, and stand again behind
    /// it.
    fn starts_by_tap(&self, cycle: &Cycle) -> bool {
        cycle.bottom == Bottom::Reversed
            && self.state.turning == Turning::Stopped
            && (self.state.tap_prepared || self.control.tap_preparation.is_none())
            && self.control.is(Q::TapStartsSpindle)
    }

    /// The axis along which the cycles of the plane drill.
    fn along(&self) -> Axis {
        self.state.plane().axes()[2]
    }

    /// The address that a parameter of a cycle has in the plane: of the depth the letter of the axis.
    fn written(&self, address: char) -> char {
        if address == 'Z' { self.along().letter() } else { address }
    }

    /// Z at the start of the first cycle of the row, machine coordinates.
    fn initial(&mut self) -> Micrometres {
        let origin = self.state.origin(self.along(), self.setting).0;
        let here = self.state.at.get(self.along()) - origin;
        origin + *self.state.initial.get_or_insert(here)
    }

    /// The parameters of the cycle in the block; missing ones keep their last value.
    fn parameters(&mut self, cycle: &Cycle, words: &BlockWords) {
        let inches = self.state.inches();
        // P and L beside M98 belong to the subprogram.
        let called = calls(words, self.control).is_some();
        for address in cycle.required.iter().chain(&cycle.optional).copied() {
            if called && matches!(address, 'P' | 'L') {
                continue;
            }
            if let Some(given) = self.take(words, self.written(address)) {
                let value = if address == 'P' {
                    libm::round(given.dwell_s(self.control) * 1e6) as i64
                } else {
                    given.length(inches).micrometres()
                };
                self.state.parameters[place(address)] = Some(value);
                if address == 'Q' && value <= 0 {
                    self.report("cycle-step-not-positive", given.span, &[("address", "Q".to_owned().into_figure())]);
                }
            }
        }
    }

    fn parameter(&self, address: char) -> Option<i64> {
        self.state.parameters[place(address)]
    }

    /// L or K; of some controls 0 only stores the parameters.
    fn repeats(&mut self, words: &BlockWords, named: bool) -> i64 {
        let address = if self.control.is(Q::RepeatsInL) { 'L' } else { 'K' };
        let Some(given) = words.get(address).filter(|_| named) else { return 1 };
        self.take(words, address);
        if given.millionths % 1_000_000 != 0 {
            self.report("number-not-whole", given.span, &[("address", address.into_figure())]);
        }
        let repeats = given.millionths / 1_000_000;
        if repeats < i64::from(!self.control.is(Q::RepeatsNone)) {
            self.report("cycle-step-not-positive", given.span, &[("address", address.into_figure())]);
        }
        repeats
    }

    fn levels(&mut self, initial: Micrometres, span: TextSpan) -> Option<CycleLevels> {
        let [r, z] = ['R', 'Z'].map(|address| Micrometres::new(self.parameter(address).unwrap_or_default()));
        let origin = self.state.origin(self.along(), self.setting).0;
        let (r, bottom) = if self.state.absolute() { (origin + r, origin + z) } else { (initial + r, initial + r + z) };
        if bottom > r {
            let shown = |level: Micrometres| (level - origin).to_string();
            self.report("cycle-levels", span, &[("z", shown(bottom).into_figure()), ("r", shown(r).into_figure())]);
            return None;
        }
        let clear = match self.state.to_initial_level() {
            false => r,
            true if self.control.is(Q::CycleRises) => initial.max(r),
            true => initial,
        };
        Some(CycleLevels { r, bottom, clear })
    }

    /// Whether the machine and its spindle permit the cycle.
    fn may_run(&mut self, cycle: &Cycle, span: TextSpan) -> bool {
        if cycle.bottom == Bottom::Reversed {
            if self.machine.is_some_and(|machine| !machine.can_tap) {
                self.fault("cannot-tap", span);
            }
            if self.state.turning == Turning::Counterclockwise {
                self.fault("tap-counterclockwise", span);
            }
            if self.state.turning == Turning::Stopped && !self.control.is(Q::TapStartsSpindle) {
                self.fault("tap-without-spindle", span);
            }
            if let Some(code) = self.control.tap_preparation.filter(|_| !self.state.tap_prepared) {
                self.report("tap-not-rigid", span, &[("word", format!("M{code}").into_figure())]);
            }
        }
        !self.broken()
    }

    fn holes(&mut self, cycle: &Cycle, levels: CycleLevels, words: &BlockWords, repeats: i64, span: TextSpan) {
        let feed = Motion::Feed { feed_mm_per_min: self.feed(span) };
        if self.control.is(Q::CycleRises) && self.initial() < levels.r {
            self.set_floating();
            self.climb(Motion::Rapid, levels.r, span);
        }
        if repeats == 0 {
            // The words of the position are taken with the others, and nothing moves.
            self.target(words, false);
        }
        for _ in 0..repeats {
            let along = self.along();
            let here = self.state.at.get(along);
            let low = self.control.is(Q::CycleRises) && here <= levels.r;
            let crossing = if low { levels.clear } else { here };
            let target = self.target(words, false);
            self.set_floating();
            let mut floating = target.floating;
            floating[along.index()] = self.state.floating[along.index()];
            let over: Position = target.at.with(along, crossing);
            self.go(Motion::Rapid, over, floating, target.span.unwrap_or(span));
            self.state.lost = target.lost;
            self.state.lost[along.index()] = 0.0;
            self.climb(Motion::Rapid, levels.r, span);
            self.hole(cycle, levels, &feed, span);
            // A block with an error makes no steps, and the budget ends endless repeats.
            if self.broken() || self.steps.len() > self.budget {
                break;
            }
        }
    }

    /// With G90 the levels of a cycle are relative to the zero of the system.
    fn set_floating(&mut self) {
        if self.state.absolute() {
            let along = self.along();
            self.state.floating[along.index()] = self.state.origin(along, self.setting).1;
        }
    }

    /// From R to the bottom and out again.
    fn hole(&mut self, cycle: &Cycle, levels: CycleLevels, feed: &Motion, span: TextSpan) {
        self.steps_inwards(cycle.inwards, levels, feed, span);
        self.climb(feed.clone(), levels.bottom, span);
        let before = self.state.turning;
        let waits = cycle.required.contains(&'P') || cycle.optional.contains(&'P');
        let pause = self.parameter('P').filter(|_| waits).map(|millionths| millionths as f64 / 1e6);
        let pause = pause.filter(|seconds| *seconds > 0.0);

        let back_first = cycle.bottom == Bottom::Reversed && self.control.is(Q::TapTurnsBeforeDwell);
        if back_first {
            self.spindle(Turning::Counterclockwise);
        }
        if let Some(seconds) = pause {
            self.wait(seconds);
        }
        match cycle.bottom {
            Bottom::Turning => {}
            Bottom::Stopped => self.spindle(Turning::Stopped),
            Bottom::Oriented => {
                self.spindle(Turning::Stopped);
                self.drawn_off(span);
            }
            Bottom::Reversed if !back_first => self.spindle(Turning::Counterclockwise),
            Bottom::Reversed => {}
        }
        if cycle.outwards == Outwards::Feed {
            self.climb(feed.clone(), levels.r, span);
            // Fanuc turns the tap forward as soon as it is out; a boring bar keeps turning all the time.
            if cycle.bottom == Bottom::Reversed {
                self.spindle(before);
            }
        }
        let rest = if cycle.outwards == Outwards::FeedToTheEnd { feed.clone() } else { Motion::Rapid };
        self.climb(rest, levels.clear, span);
        if self.state.turning != before {
            self.spindle(before);
        }
    }

    /// The edge of a bar is drawn off the wall before the way out, by Q in a direction that is set in the control, or by I
    /// and J; these ways of a few tenths and back are not traced. Without any the edge goes out along the wall.
    fn drawn_off(&mut self, span: TextSpan) {
        let by = ['Q', 'I', 'J'].into_iter().filter_map(|address| self.parameter(address)).find(|way| *way != 0);
        let Some(way) = by.map(|way| Micrometres::new(way).to_mm().abs()) else {
            self.fault("shift-missing", span);
            return;
        };
        if way > self.control.habits.shift {
            self.report("shift-too-large", span, &[("shift", round_to(way, 3).into_figure())]);
        } else {
            self.fault("shift-not-traced", span);
        }
    }

    /// The travel to the bottom in steps of Q, without the last one.
    ///
    /// G83: after every step out to R at rapid, which clears the flutes, and back at rapid to a clearance above the
    /// metal. G73: after every step a small retract at rapid, which breaks the chip, then further down.
    fn steps_inwards(&mut self, inwards: Inwards, levels: CycleLevels, feed: &Motion, span: TextSpan) {
        let step = Micrometres::new(self.parameter('Q').unwrap_or_default());
        if inwards == Inwards::Feed || step <= Micrometres::ZERO {
            return;
        }
        let back = if inwards == Inwards::StepsLeaving {
            self.setting.g83_clearance.unwrap_or(self.control.pecks.0)
        } else {
            self.setting.g73_retract.unwrap_or(self.control.pecks.1)
        };
        let mut depth = levels.r - step;
        while depth > levels.bottom && self.steps.len() <= self.budget && !self.broken() {
            self.climb(feed.clone(), depth, span);
            if inwards == Inwards::StepsLeaving {
                self.climb(Motion::Rapid, levels.r, span);
            }
            self.climb(Motion::Rapid, depth + back, span);
            depth = depth - step;
        }
    }
}
