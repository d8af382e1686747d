//! One block, in three steps, with the same numbers here and in `run.rs`:
//!
//! 1. The words are read, each in its group (`words.rs`).
//! 2. Everything is checked: the steps are made, and every broken rule is reported (here, `moves.rs`, `cycles.rs`,
//!    `travel.rs`).
//! 3. Only without errors the steps are output (`run.rs`). The state after the block is kept in both cases, so the
//!    run continues as if the block had been executed, and nothing is undone.
//!
//! The order within a block, whatever the order of its words (3.5): modal functions and F, S, T, D, H; functions of
//! the start of a block, M06 among them; G92; length and radius correction; the motion and the cycle, L times; the
//! dwell; functions of the end of a block; the call of a subprogram.

use super::control::{Action, Control};
use super::cycles::Holes;
use super::rules::fault;
use super::state::{CYCLE, ControlState, LENGTH, MOTION, ONE_SHOT, PLANE, RADIUS, SYSTEM};
use super::words::{BlockWords, Function, WordValue, letter};
use crate::machine::Machine;
use crate::motion::{Axis, BlockRef, Motion, MotionStep, Position, Side, Turning};
use crate::note::{Figure, IntoFigure, Note};
use crate::program::brought::{Named, Open, User};
use crate::program::limits::{NOT_CHECKED, Spans, not_checked, of_machine, speed_off_steps};
use crate::program::running::Watched;
use crate::program::stay::Stay;
use crate::program::{Call, Fault, Setting, Subject, TextSpan};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute};

/// Step 2 in progress: the steps of one block so far, and the state after them.
pub(super) struct Maker<'a> {
    pub control: &'a Control,
    pub machine: &'a Machine<'a>,
    pub setting: &'a Setting,
    pub state: &'a mut ControlState,
    pub steps: Vec<MotionStep>,
    pub faults: Vec<Fault>,
    pub block: BlockRef,
    /// The whole block, for faults that belong to no single word.
    pub span: TextSpan,
    pub spans: &'a mut Spans,
    pub watched: &'a mut Watched,
    /// The holes that cycles have drilled so far.
    pub holes: &'a mut Holes,
    /// The calls that led to the block.
    pub calls: &'a [Call],
    /// The number of steps so far, including those that the radius correction delays.
    pub step_count: usize,
    /// The most steps that may be made.
    pub budget: usize,
}

/// What a block requests besides its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum After {
    /// The next block.
    Next,
    /// M99.
    Return,
    /// M02, M30.
    End,
}

impl Maker<'_> {
    /// Reports a broken rule.
    pub(super) fn fault(&mut self, code: &'static str, span: TextSpan) {
        self.report(code, span, &[]);
    }

    /// Reports a broken rule with its figures.
    pub(super) fn report(&mut self, code: &'static str, span: TextSpan, figures: &[(&'static str, Figure)]) {
        let note = figures.iter().fold(Note::new(code), |note, (name, value)| note.with(*name, value));
        self.tell_note(code, span, note);
    }

    /// Reports a broken rule with its note.
    pub(super) fn tell_note(&mut self, code: &'static str, span: TextSpan, note: Note) {
        self.tell_fault(Fault { note, ..fault(code, span, self.block.number) });
    }

    /// Reports a fault, once however often the block is repeated.
    pub(super) fn tell_fault(&mut self, fault: Fault) {
        // A machine that nobody has named costs no block.
        let fault = match of_machine(fault.code).filter(|_| self.setting.assumed.machine) {
            Some(what) => Fault { note: not_checked(what), ..self::fault(NOT_CHECKED, fault.span, fault.block) },
            None => fault,
        };
        if !self.faults.iter().any(|reported| reported.code == fault.code && reported.span == fault.span) {
            self.faults.push(fault);
        }
    }

    /// Reports what is seen in a program by itself, and what a proof with the part says better.
    pub(super) fn program_alone(&mut self, code: &'static str, span: TextSpan) {
        self.tell_fault(Fault { of_program_alone: true, ..fault(code, span, self.block.number) });
    }

    /// Whether the block has an error, so that it is not carried out.
    pub(super) fn broken(&self) -> bool {
        self.faults.iter().any(Fault::is_error)
    }

    /// Makes all steps of the block.
    pub(super) fn make(&mut self, words: &BlockWords) -> After {
        self.take_modes(words);
        self.modes_left_over(words);
        self.take_numbers(words);
        self.start_functions(words);
        if words.function(SYSTEM) == Some(92) {
            self.set_system(words);
        }
        self.length_correction(words);
        self.radius_correction(words);
        // With P the repeats are those of the call (3.14.2), else those of the block (3.12.2).
        let repeats = if words.get('P').is_some() { 1 } else { words.get('L').map_or(1, WordValue::number) };
        for _ in 0..repeats {
            let before = self.step_count;
            self.motion(words);
            self.cycle(words);
            // A pass without motion would be the same 65535 times.
            if self.broken() || self.step_count > self.budget || self.step_count == before {
                break;
            }
        }
        self.dwell(words);
        self.end_functions(words)
    }

    /// Takes the last function of each group; one of group 00 acts in this block only.
    fn take_modes(&mut self, words: &BlockWords) {
        for (group, function) in words.g.iter().enumerate().filter(|(group, _)| *group != ONE_SHOT) {
            if let Some(function) = function {
                self.state.groups[group] = function.code;
            }
        }
    }

    /// F, S, T, D, H, R, Q, compared with the machine.
    fn take_numbers(&mut self, words: &BlockWords) {
        if let Some(feed) = words.get('F') {
            self.take_feed(feed);
        }
        if let Some(speed) = words.get('S') {
            self.take_speed(speed);
        }
        if let Some(tool) = words.get('T') {
            self.state.wanted = u32::try_from(tool.number()).unwrap_or_default();
            let open = self.state.registers.names(self.state.wanted);
            self.never_came(open);
            if tool.number() > self.machine.magazine as i64 {
                let number = tool.number();
                let fault = fault("tool-beyond-magazine", tool.span, self.block.number).with("tool", number);
                let subject = Subject::Tool(usize::try_from(number).unwrap_or_default());
                self.tell_fault(fault.with("places", self.machine.magazine).about(subject));
            }
        }
        if let Some(number) = words.get('D') {
            self.state.radius_corrector = u32::try_from(number.number()).unwrap_or_default();
        }
        if let Some(number) = words.get('H') {
            self.state.length_corrector = u32::try_from(number.number()).unwrap_or_default();
        }
        for address in ['R', 'Q'] {
            if let Some(given) = words.get(address) {
                self.push(Motion::Auxiliary { word: format!("{address}{}", given.number()) });
            }
        }
    }

    /// A feed, of F or of a cycle.
    pub(super) fn take_feed(&mut self, feed: WordValue) {
        let limit = self.machine.feed_max.0;
        if feed.thousandths as f64 / 1000.0 > limit {
            self.report("feed-beyond-machine", feed.span, &[("limit", limit.into_figure())]);
        }
        self.state.feed = feed.thousandths;
        self.state.feed_user = User::Nobody;
    }

    fn take_speed(&mut self, speed: WordValue) {
        let value = speed.number();
        self.state.speed = value;
        self.state.speed_user = User::Nobody;
        if let Some((code, note)) = speed_off_steps(self.machine, value as f64) {
            self.tell_note(code, speed.span, note);
        }
        if self.state.turning != Turning::Stopped {
            self.spindle(self.state.turning);
        }
    }

    /// The spindle from this block on, its speed by S and the operator's switch (3.13.1).
    pub(super) fn spindle(&mut self, turning: Turning) {
        self.state.turning = turning;
        if turning != Turning::Stopped && self.state.speed_user == User::Nobody {
            self.state.speed_user = User::ToolInSpindle;
        }
        let speed = self.state.speed as f64 * self.setting.speed_override as f64 / 100.0;
        self.push(Motion::Spindle { turning, speed_rpm: RevsPerMinute(speed) });
    }

    fn start_functions(&mut self, words: &BlockWords) {
        for &function in &words.m {
            match self.control.m_functions.get(function.code) {
                Some(known) if known.at_start => self.machine_function(known.action, function, words),
                Some(_) => {}
                None => self.push(Motion::Auxiliary { word: format!("M{:02}", function.code) }),
            }
        }
    }

    fn end_functions(&mut self, words: &BlockWords) -> After {
        let mut after = After::Next;
        for &function in &words.m {
            let Some(known) = self.control.m_functions.get(function.code) else { continue };
            match known.action {
                Action::Return => after = After::Return,
                Action::End => {
                    self.flush();
                    let open = self.state.registers.ends();
                    self.never_came(open);
                    if self.state.stay.is_in_cut(self.state.actual.z) {
                        self.program_alone("ends-in-cut", function.span);
                    }
                    self.radius_left_on(function.span);
                    self.push(Motion::End);
                    after = After::End;
                }
                action if !known.at_start => self.machine_function(action, function, words),
                _ => {}
            }
        }
        after
    }

    fn machine_function(&mut self, action: Action, function: Function, words: &BlockWords) {
        match action {
            Action::SpindleClockwise | Action::SpindleCounterclockwise => {
                if self.state.speed == 0 {
                    self.fault("spindle-without-speed", function.span);
                } else if self.state.speed_user.uses() {
                    self.program_alone("speed-of-tool-before", function.span);
                }
                let clockwise = action == Action::SpindleClockwise;
                self.spindle(if clockwise { Turning::Clockwise } else { Turning::Counterclockwise });
            }
            Action::SpindleStop => self.spindle(Turning::Stopped),
            Action::CoolantOn => self.push(Motion::Coolant { on: true }),
            Action::CoolantOff => self.push(Motion::Coolant { on: false }),
            Action::Stop => {
                // For the same holes the operator may change the setting of the tool, such as a boring bar.
                self.holes.clear();
                self.stop(false, function.span);
            }
            // Without the operator's SI it does not stop (4.2.4.2).
            Action::OptionalStop if self.setting.optional_stop => self.stop(true, function.span),
            Action::ToolChange => self.tool_change(function, words),
            Action::OptionalStop | Action::End | Action::Return => {}
        }
    }

    /// M00 and M01: the program holds, and hands may come near the spindle. Whether it stands then is a matter of the machine.
    fn stop(&mut self, optional: bool, span: TextSpan) {
        if self.state.turning != Turning::Stopped {
            self.fault("stop-turning-maybe", span);
        }
        self.push(Motion::Stop { optional });
    }

    /// M06: the tool of T is put into the spindle, which stops for that time.
    fn tool_change(&mut self, function: Function, words: &BlockWords) {
        if self.state.wanted == 0 {
            self.fault("no-tool", words.get('T').map_or(function.span, |tool| tool.span));
        }
        self.radius_left_on(function.span);
        let place = Position::of(self.machine.change_place());
        let actual = self.state.actual;
        if self.state.floating.iter().all(Option::is_none) && actual != place {
            let shown = |at: Position| crate::motion::trace::position(at);
            self.report(
                "change-elsewhere",
                function.span,
                &[("at", shown(actual).into_figure()), ("place", shown(place).into_figure())],
            );
        }
        if self.state.turning != Turning::Stopped {
            self.fault("turning-at-change", function.span);
            self.spindle(Turning::Stopped);
        }
        let floating = self.state.floating[Axis::Z.index()];
        let low = self.state.stay.at_change(actual.z, floating).filter(|_| actual.z != place.z || floating.is_some());
        if let Some(code) = low {
            self.program_alone(code, function.span);
        } else if self.state.changed_on_machine && floating.is_some() {
            // The program shows by its other changes where they must be.
            self.program_alone("change-not-withdrawn", function.span);
        } else if self.state.height_known && floating.is_some() {
            self.program_alone("change-by-zero", function.span);
        }
        self.state.changed_on_machine |= floating.is_none() && self.state.height_known;
        self.state.stay = Stay::comes(actual, floating);
        self.state.height_known = true;
        // The tool that stands in the spindle already keeps its own.
        if self.state.wanted != self.state.tool {
            self.state.feed_user.changes();
            self.state.speed_user.changes();
        }
        self.state.tool = self.state.wanted;
        self.state.registers.brings(self.state.wanted);
        self.push(Motion::ToolChange { tool: self.state.tool });
    }

    /// A tool change or the end while G41 or G42 acts.
    fn radius_left_on(&mut self, span: TextSpan) {
        if matches!(self.state.groups[RADIUS], 41 | 42) {
            self.program_alone("radius-not-cancelled", span);
        }
    }

    /// A tool that never came, and whose length may have acted.
    fn never_came(&mut self, open: Option<Open>) {
        if let Some(Open { tool, span, block }) = open {
            self.tell_fault(fault("tool-not-brought", span, block).with("tool", tool));
        }
    }

    /// G92: the words are the position of the tool in the new system; axes left out keep their zero (3.10.8.1).
    fn set_system(&mut self, words: &BlockWords) {
        for axis in Axis::ALL {
            match words.axis(axis) {
                Some(word) => {
                    let sign = self.state.sign(axis, self.setting);
                    let at = Micrometres::new(sign * word.thousandths);
                    self.state.origin = self.state.origin.with(axis, self.state.base.get(axis) - at);
                    self.state.origin_floating[axis.index()] = self.state.floating[axis.index()];
                }
                None => {
                    let (origin, floating) = self.state.origin_of(axis, self.setting);
                    self.state.origin = self.state.origin.with(axis, origin);
                    self.state.origin_floating[axis.index()] = floating;
                }
            }
        }
    }

    /// The value of an offset register; a register that nobody has set holds 0, as in the memory of the control.
    pub(super) fn corrector(&mut self, number: u32, span: TextSpan) -> Micrometres {
        if number == 0 {
            return Micrometres::ZERO;
        }
        match self.setting.correctors.get(&number) {
            Some(value) => *value,
            None => {
                self.report("corrector-unknown", span, &[("number", number.into_figure())]);
                Micrometres::ZERO
            }
        }
    }

    /// G43, G44, G49 and H (3.11.3): the value is added to the end point or subtracted from it; H00 is no correction.
    /// The axis is that of the plane when the correction begins. If the block does not move that axis, the axis moves
    /// by the correction at rapid.
    fn length_correction(&mut self, words: &BlockWords) {
        let given = words.g[LENGTH].map(|function| function.span).or(words.get('H').map(|word| word.span));
        let Some(span) = given else { return };
        let value = match self.state.groups[LENGTH] {
            43 => self.corrector(self.state.length_corrector, span),
            44 => -self.corrector(self.state.length_corrector, span),
            _ => Micrometres::ZERO,
        };
        let axis = self.control.plane(self.state.groups[PLANE]).length_axis;
        let corrector = if self.state.groups[LENGTH] == 49 { 0 } else { self.state.length_corrector };
        let old = self.state.length;
        let same = old == (axis, value) || (old.1 == value && value == Micrometres::ZERO);
        if same && corrector == self.state.length_in_force {
            return;
        }
        self.state.length_in_force = corrector;
        if let Some(sign) = [43, 44].iter().position(|code| *code == self.state.groups[LENGTH] && corrector > 0) {
            // By one of them the registers were measured.
            let other = self.state.lengths[1 - sign];
            if other && !std::mem::replace(&mut self.state.lengths[sign], true) {
                self.program_alone("both-length-signs", span);
            }
            self.state.lengths[sign] = true;
        }
        let named = Named { tool: self.state.tool, wanted: self.state.wanted };
        if self.state.registers.takes(corrector, named, span, self.block.number) {
            self.report("tool-not-brought", span, &[("tool", named.wanted.into_figure())]);
        }
        self.push(Motion::LengthCorrection { axis, corrector: Some(corrector), value });
        if same {
            return;
        }
        // The old axis first, if it is another one.
        let axes = if old.0 == axis { vec![axis] } else { vec![old.0, axis] };
        for moved in axes {
            let from = self.state.corrected(self.state.base);
            self.state.length = (moved, if moved == axis { value } else { Micrometres::ZERO });
            let moves = words.function(SYSTEM) != Some(92) && words.axis(moved).is_some();
            if !moves && self.may_move(moved, span) {
                self.push_from(Motion::Rapid, from, span);
            }
        }
    }

    /// G40, G41, G42 and D (3.11.1).
    fn radius_correction(&mut self, words: &BlockWords) {
        let function = self.state.groups[RADIUS];
        let active = matches!(function, 41 | 42);
        let changed = words.g[RADIUS].or(words.g[PLANE]).map(|function| function.span);
        let changed = changed.or(words.get('D').filter(|_| active).map(|word| word.span));
        let offset = words.g[ONE_SHOT].filter(|function| self.control.offsets.contains(function.code));
        if let Some(offset) = offset.filter(|_| active && words.g[RADIUS].is_none()) {
            self.report(
                "offset-with-radius-correction",
                offset.span,
                &[("function", format!("G{:02}", offset.code).into_figure())],
            );
        }
        let Some(span) = changed else { return };
        let plane = self.control.plane(self.state.groups[PLANE]).plane;
        let value = if active { self.corrector(self.state.radius_corrector, span) } else { Micrometres::ZERO };
        let [a, b, _] = plane.axes();
        // On a mirrored path the other side is meant.
        let mirrored = self.state.sign(a, self.setting) * self.state.sign(b, self.setting);
        let side = if function == 41 { mirrored } else { -mirrored };
        let offset = value.to_mm() * side as f64;
        let changes_side = active || self.state.compensator.active();
        let begin = self.steps.len();
        let flushed = self.state.compensator.set(plane, offset, &mut self.steps);
        self.emit(begin, flushed, span);
        if changes_side {
            let side = match (active, side > 0) {
                (false, _) => Side::Off,
                (true, true) => Side::Left,
                (true, false) => Side::Right,
            };
            self.push(Motion::RadiusCorrection { side, corrector: self.state.radius_corrector, value });
        }
    }

    /// G04 E: a wait of E tenths of a second after the motion of the block (3.10.6).
    fn dwell(&mut self, words: &BlockWords) {
        let Some(pause) = words.g[ONE_SHOT].filter(|function| function.code == 4) else {
            if let Some(time) = words.get('E') {
                self.fault("time-without-dwell", time.span);
            }
            return;
        };
        match words.get('E') {
            Some(time) => self.wait(time.number()),
            None => {
                self.fault("dwell-without-time", pause.span);
            }
        }
    }

    /// A wait, in the time steps of the control.
    pub(super) fn wait(&mut self, steps: i64) {
        let seconds = crate::units::Decimal::from_f64_rounded(steps as f64 * self.control.dwell_step_s).to_f64();
        self.push(Motion::Dwell { seconds });
    }

    /// The feed by F and the operator's switch; reported when there is none, or when the spindle does not turn.
    pub(super) fn feed(&mut self, span: TextSpan) -> MillimetresPerMinute {
        self.feed_of(self.state.feed, span)
    }

    /// A feed of so many thousandths.
    pub(super) fn feed_of(&mut self, thousandths: i64, span: TextSpan) -> MillimetresPerMinute {
        if self.state.turning == Turning::Stopped {
            self.fault("feed-without-spindle", span);
        }
        if self.state.feed_user.uses() {
            self.program_alone("feed-of-tool-before", span);
        }
        let feed = thousandths as f64 * self.setting.feed_override as f64 / 100_000.0;
        if feed <= 0.0 {
            self.fault("feed-zero", span);
        }
        MillimetresPerMinute(feed)
    }

    /// Whether a cycle is in force.
    pub(super) fn cycle_in_force(&self) -> bool {
        self.control.cycles.contains(self.state.groups[CYCLE])
    }

    /// The function of motion in force.
    pub(super) fn motion_function(&self) -> u8 {
        self.state.groups[MOTION]
    }

    /// A parameter of the cycle in force, in thousandths.
    pub(super) fn parameter(&self, address: char) -> Option<i64> {
        self.state.parameters[letter(address)]
    }
}
