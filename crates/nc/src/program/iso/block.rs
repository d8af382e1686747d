//! One block, on a copy of the state: its steps are made and every broken rule is reported. Only without errors the
//! steps are output and the copy becomes the state (`run.rs`).
//!
//! The order within a block, whatever the order of its words: units; F, S, T; functions of the start of a block, M6
//! first; the dwell; modal functions; length correction; the motion or the cycle; functions of the end of a block;
//! the call of a subprogram. It is that of LinuxCNC; Fanuc's manual leaves most of it to the machine.

use super::control::{Action, Characteristic as Q, Control, Effect, Group};
use super::rules::fault;
use super::state::{ControlState, User};
use super::words::{ADDRESSES, BlockWords, Function, WordValue, place};
use crate::machine::Machine;
use crate::motion::{Axis, BlockRef, Motion, MotionStep, Position, Turning, geometry};
use crate::note::{Figure, IntoFigure, Note, Severity};
use crate::program::brought::{Named, Open};
use crate::program::limits::{Floating, Spans, beyond_travel, speed_off_steps};
use crate::program::running::Watched;
use crate::program::stay::Stay;
use crate::program::{Fault, Setting, Subject, TextSpan};
use crate::units::{Decimal, Micrometres, MillimetresPerMinute, RevsPerMinute, round_to};

/// A block during its execution: its steps, made on a copy of the state.
pub(super) struct Maker<'a> {
    pub control: &'a Control,
    /// None where nobody has named one: its limits are not checked then.
    pub machine: Option<&'a Machine<'a>>,
    pub setting: &'a Setting,
    /// The copy.
    pub state: ControlState,
    pub steps: Vec<MotionStep>,
    pub faults: Vec<Fault>,
    pub block: BlockRef,
    /// How deep it is in calls.
    pub depth: usize,
    /// The whole block, for faults that belong to no single word.
    pub span: TextSpan,
    pub spans: &'a mut Spans,
    pub watched: &'a mut Watched,
    /// The most steps that may be made.
    pub budget: usize,
    /// The letters of used words. Other words would be ignored silently, so they are reported.
    pub used: [bool; ADDRESSES],
}

/// What a block requests besides its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum After {
    /// The next block.
    Next,
    /// M99.
    Return(TextSpan),
    /// M2, M30.
    End,
}

impl Maker<'_> {
    /// Reports a broken rule.
    pub(super) fn fault(&mut self, code: &'static str, span: TextSpan) -> &mut Fault {
        self.faults.push(fault(code, span, self.block.number));
        let last = self.faults.len() - 1;
        &mut self.faults[last]
    }

    /// Reports a broken rule with its figures.
    pub(super) fn report(&mut self, code: &'static str, span: TextSpan, figures: &[(&'static str, Figure)]) {
        let note = figures.iter().fold(Note::new(code), |note, (name, value)| note.with(*name, value));
        self.fault(code, span).note = note;
    }

    /// Whether the block has an error.
    pub(super) fn broken(&self) -> bool {
        self.faults.iter().any(Fault::is_error)
    }

    /// A word that is needed; it is marked as used.
    pub(super) fn take(&mut self, words: &BlockWords, address: char) -> Option<WordValue> {
        self.used[place(address)] = true;
        words.get(address)
    }

    /// The steps of a block.
    pub(super) fn make(&mut self, words: &BlockWords) -> After {
        if let Some(units) = words.function(Group::Units) {
            self.state.set(Group::Units, Some(units.code));
        }
        if self.is_passed(words) {
            return self.pass(words);
        }
        self.modes_left_over(words);
        self.numbers(words);
        self.start_functions(words);
        if let Some(function) = words.one_shot(Effect::Dwell, self.control) {
            self.dwell(function, words);
        }
        self.distances_of_a_call(words);
        self.return_left_over(words);
        self.modes(words);
        self.length_correction(words);
        self.radius(words);
        self.motion(words);
        let after = self.end_functions(words);
        // After another mistake it would only be a consequence.
        let unused = if self.broken() { None } else { Some(words.all()) };
        for (letter, given) in
            unused.into_iter().flatten().filter(|(letter, _)| !self.used[place(*letter)]).collect::<Vec<_>>()
        {
            self.report("word-unused", given.span, &[("word", letter.into_figure())]);
        }
        after
    }

    /// Whether the block moves in a way that is not carried out here.
    fn is_passed(&mut self, words: &BlockWords) -> bool {
        if words.function(Group::Motion).or(words.function(Group::Cycle)).is_some() {
            self.state.passes = false;
        }
        self.state.passes |= words.passes_on;
        let moves = words.names_any();
        words.passed || (self.state.passes && moves && words.function(Group::OneShot).is_none())
    }

    /// What remains of a block that is not carried out: speeds, tools, machine functions and modes.
    fn pass(&mut self, words: &BlockWords) -> After {
        for &(_, group) in Group::NAMES {
            self.state.own[group as usize] |= words.function(group).is_some();
        }
        self.numbers(words);
        self.start_functions(words);
        self.modes(words);
        if let Some(function) = words.function(Group::Motion) {
            self.cycle_off();
            self.state.set(Group::Motion, Some(function.code));
        }
        // Where the axis goes is not known; that it goes somewhere is. A zero that is set moves nothing.
        let moves = self.state.passes || words.function(Group::Motion).is_some();
        self.state.height_known |= moves && words.get('Z').is_some();
        self.end_functions(words)
    }

    /// F, S, T, compared with the machine.
    fn numbers(&mut self, words: &BlockWords) {
        self.feed_mode(words);
        let per_minute = self.state.mode(Group::FeedMode).is_none_or(|mode| mode == 940);
        let by_time = self.state.mode(Group::FeedMode) == Some(930);
        if let Some(feed) = self.take(words, 'F') {
            self.state.feed_user = User::Nobody;
            self.state.feed = feed.value() * if self.state.inches() && !by_time { 25.4 } else { 1.0 };
            let limit = self.feed_most();
            if let Some(limit) = limit.filter(|limit| per_minute && self.state.feed > *limit) {
                self.report("feed-beyond-machine", feed.span, &[("limit", limit.into_figure())]);
            }
        }
        if let Some(speed) = self.take(words, 'S') {
            self.state.speed_user = User::Nobody;
            self.state.speed = speed.value();
            if let Some((code, note)) = self.machine.and_then(|machine| speed_off_steps(machine, self.state.speed)) {
                self.fault(code, speed.span).note = note;
            }
            let starts = words.m.iter().any(|function| self.starts_spindle(*function));
            if self.state.turning != Turning::Stopped && !starts {
                self.spindle(self.state.turning);
            }
        }
        if let Some(tool) = self.take(words, 'T') {
            let number = tool.millionths / 1_000_000;
            self.state.wanted = u32::try_from(number).unwrap_or_default();
            let open = self.state.registers.names(self.state.wanted);
            self.never_came(open);
            self.state.tool_named = number != 0 || self.control.is(Q::ToolTakenOut);
            if let Some(places) = self.machine.map(|it| it.magazine).filter(|places| number > *places as i64) {
                let fault = fault("tool-beyond-magazine", tool.span, self.block.number).with("tool", number);
                let subject = Subject::Tool(usize::try_from(number).unwrap_or_default());
                self.faults.push(fault.with("places", places).about(subject));
            }
        }
    }

    /// The feed of one mode means nothing in another; G93 needs it in every block.
    fn feed_mode(&mut self, words: &BlockWords) {
        let before = self.state.mode(Group::FeedMode);
        if let Some(function) = words.function(Group::FeedMode) {
            self.state.set(Group::FeedMode, Some(function.code));
        }
        let now = self.state.mode(Group::FeedMode);
        if now != before || now == Some(930) {
            self.state.feed = 0.0;
        }
    }

    fn starts_spindle(&self, function: Function) -> bool {
        let action = self.control.m.get(&function.code).map(|known| known.action);
        matches!(action, Some(Action::SpindleClockwise | Action::SpindleCounterclockwise))
    }

    /// The spindle from this block on, its speed by S and the operator's switch.
    pub(super) fn spindle(&mut self, turning: Turning) {
        self.state.turning = turning;
        if turning != Turning::Stopped && self.state.speed_user == User::Nobody {
            self.state.speed_user = User::ToolInSpindle;
        }
        let speed = self.state.speed * self.setting.speed_override as f64 / 100.0;
        self.push(Motion::Spindle { turning, speed_rpm: RevsPerMinute(speed) });
    }

    /// The program starts the spindle, by M3, M4 or a tap that does: with an S, and that of the tool in it.
    pub(super) fn start_spindle(&mut self, turning: Turning, span: TextSpan) {
        if self.state.speed == 0.0 {
            self.fault("spindle-without-speed", span);
        } else if self.state.speed_user.uses() {
            self.fault("speed-of-tool-before", span).of_program_alone = true;
        }
        self.spindle(turning);
    }

    /// Functions of the start of a block, the tool change first.
    fn start_functions(&mut self, words: &BlockWords) {
        let mut functions = words.m.clone();
        functions.sort_by_key(|function| {
            self.control.m.get(&function.code).is_none_or(|known| known.action != Action::ToolChange)
        });
        for function in functions {
            if let Some(known) = self.control.m.get(&function.code).filter(|known| known.at_start) {
                self.machine_function(known.action, function, words);
            }
        }
    }

    fn end_functions(&mut self, words: &BlockWords) -> After {
        let mut after = After::Next;
        for &function in &words.m {
            let Some(known) = self.control.m.get(&function.code).filter(|known| !known.at_start) else { continue };
            match known.action {
                Action::Return => after = After::Return(function.span),
                Action::End => {
                    let open = self.state.registers.ends();
                    self.never_came(open);
                    if self.state.stay.is_in_cut(self.state.at.z) {
                        self.fault("ends-in-cut", function.span).of_program_alone = true;
                    }
                    self.radius_at_end(function.span);
                    self.no_tap_came();
                    self.push(Motion::End);
                    after = After::End;
                }
                action => self.machine_function(action, function, words),
            }
        }
        after
    }

    fn machine_function(&mut self, action: Action, function: Function, words: &BlockWords) {
        match action {
            Action::SpindleClockwise | Action::SpindleCounterclockwise => {
                let clockwise = action == Action::SpindleClockwise;
                let turning = if clockwise { Turning::Clockwise } else { Turning::Counterclockwise };
                self.start_spindle(turning, function.span);
            }
            Action::SpindleStop => self.spindle(Turning::Stopped),
            Action::CoolantOn | Action::CoolantOff => {
                self.state.coolant = action == Action::CoolantOn;
                self.push(Motion::Coolant { on: self.state.coolant });
            }
            Action::KeepModes | Action::ForgetModes | Action::BringModes | Action::KeepForReturn => {
                self.keep(action, function.span);
            }
            // Where there is no M6, the operator changes the tool that T names at the stop, or has named before it.
            Action::Stop
                if !self.control.changes_tools()
                    && (words.get('T').is_some() || self.state.wanted != self.state.tool) =>
            {
                self.change_by_hand(function);
            }
            Action::Stop => self.stop(false, function.span),
            Action::OptionalStop if self.setting.optional_stop => self.stop(true, function.span),
            Action::ToolChange => self.tool_change(function),
            // The run looks up what is called; the words are used here.
            Action::Call | Action::CallLocal => {
                self.take(words, 'P');
                self.take(words, 'L');
            }
            Action::ToolNamed => {
                let Some(given) = self.take(words, 'Q') else {
                    self.fault("no-tool", function.span);
                    return;
                };
                self.state.tool = u32::try_from(given.millionths / 1_000_000).unwrap_or_default();
                self.state.tool_named = true;
                self.push(Motion::Auxiliary { word: format!("M61 Q{}", self.state.tool) });
            }
            Action::Auxiliary => {
                // The angle of M19, at which the spindle stops.
                if function.code == 19 {
                    self.take(words, 'R');
                    self.state.turning = Turning::Stopped;
                }
                if self.control.tap_preparation.map(i64::from) == Some(function.code) {
                    self.state.tap_prepared = true;
                    self.state.tap_expected = Some(function.span);
                }
                self.push(Motion::Auxiliary { word: format!("M{}", function.code) });
            }
            Action::OptionalStop | Action::End | Action::Return => {}
        }
    }

    /// M0 and M1: the program holds, and hands may come near the spindle.
    fn stop(&mut self, optional: bool, span: TextSpan) {
        if self.control.is(Q::StopStopsSpindle) {
            if self.state.turning != Turning::Stopped {
                self.spindle(Turning::Stopped);
            }
            if std::mem::take(&mut self.state.coolant) {
                self.push(Motion::Coolant { on: false });
            }
        } else if self.state.turning != Turning::Stopped {
            let leaves = self.control.is(Q::StopLeavesSpindle);
            self.fault(if leaves { "stop-turning" } else { "stop-turning-maybe" }, span);
        }
        self.other_tool_by_hand(span);
        self.push(Motion::Stop { optional });
    }

    /// A stop behind another T, in a program that has brought no tool by M6: the operator changes it.
    fn other_tool_by_hand(&mut self, span: TextSpan) {
        let wanted = self.state.wanted;
        if self.state.tool != 0 || wanted == 0 || wanted == self.state.by_hand {
            return;
        }
        // The first one stands there already, for all that is known.
        if std::mem::replace(&mut self.state.by_hand, wanted) == 0 {
            return;
        }
        let floating = self.state.floating[Axis::Z.index()];
        let low = self.state.stay.at_change(self.state.at.z, floating).filter(|_| !self.state.z_on_machine);
        if let Some(code) = low {
            self.fault(code, span).of_program_alone = true;
        }
        self.state.stay = Stay::comes(self.state.at, floating);
    }

    /// T and M0: the operator changes the tool, and a spindle that the control does not stop would meet the hand.
    fn change_by_hand(&mut self, function: Function) {
        if self.state.turning != Turning::Stopped {
            self.fault("change-turning", function.span);
        }
        self.tool_change(function);
    }

    /// M6: the tool of T is put into the spindle, which stops for that time.
    fn tool_change(&mut self, function: Function) {
        if !self.state.tool_named {
            self.fault("no-tool", function.span);
        }
        self.radius_left_on(function.span);
        self.no_tap_came();
        self.withdraws();
        let floating = self.state.floating[Axis::Z.index()];
        let low = self.state.stay.at_change(self.state.at.z, floating).filter(|_| !self.state.z_on_machine);
        if let Some(code) = low {
            self.fault(code, function.span).of_program_alone = true;
        } else if self.state.changed_on_machine && !self.state.z_on_machine {
            // The program shows by its other changes where they must be.
            self.fault("change-not-withdrawn", function.span).of_program_alone = true;
        }
        self.state.changed_on_machine |= self.state.z_on_machine;
        self.state.stay = Stay::comes(self.state.at, floating);
        self.change_elsewhere(function);
        if self.state.turning != Turning::Stopped {
            // By hand it is told as that.
            if self.control.changes_tools() {
                let code = match self.control.turning_at_change() {
                    Severity::Note => "change-stops-spindle",
                    _ if self.control.change_by_builder() => "change-turning-maybe",
                    _ => "turning-at-change",
                };
                self.fault(code, function.span);
            }
            self.spindle(Turning::Stopped);
        }
        self.state.height_known = true;
        self.state.left_by_return = self.state.left_by_return.map(|_| true);
        // The tool that stands in the spindle already keeps its own.
        if self.state.wanted != self.state.tool {
            self.state.feed_user.changes();
            self.state.speed_user.changes();
        }
        self.state.tool = self.state.wanted;
        self.state.registers.brings(self.state.wanted);
        self.push(Motion::ToolChange { tool: self.state.wanted });
    }

    /// Where M6 brings Z to its place itself it does so first; where it does not, the tool must not stand where it cuts.
    fn withdraws(&mut self) {
        if self.control.is(Q::ChangeWithdraws) {
            let up = self.machine.map_or(Micrometres::ZERO, |machine| machine.tool_change_z);
            let (mut to, mut floating) = (self.state.at, self.state.floating);
            to = to.with(Axis::Z, up);
            floating[Axis::Z.index()] = None;
            // Where the zero of Z is not known this is no way that can be measured.
            if self.state.floating[Axis::Z.index()].is_none() {
                self.go(Motion::Rapid, to, floating, self.span);
            } else {
                (self.state.at, self.state.floating) = (to, floating);
                self.push(Motion::Rapid);
            }
            self.state.z_on_machine = true;
        }
    }

    /// A change at another place than the machine asks for.
    fn change_elsewhere(&mut self, function: Function) {
        let Some(machine) = self.machine else { return };
        let (at, place) = (self.state.at, machine.change_place());
        let asked = machine.change_axes();
        let known = asked.iter().all(|axis| self.state.floating[axis.index()].is_none());
        if self.state.moved && known && asked.iter().any(|axis| at.get(*axis) != place[axis.index()]) {
            let said = |position: &dyn Fn(Axis) -> Micrometres| {
                asked.iter().map(|axis| format!("{}{}", axis.letter(), position(*axis))).collect::<Vec<_>>().join(" ")
            };
            let figures = [
                ("at", said(&|axis| at.get(axis)).into_figure()),
                ("place", said(&|axis| place[axis.index()]).into_figure()),
            ];
            self.report("change-elsewhere", function.span, &figures);
        }
    }

    /// The greatest feed of the machine, mm/min, where one is named.
    fn feed_most(&self) -> Option<f64> {
        self.machine.map(|machine| machine.feed_max.0)
    }

    /// G4: P in the unit of the control; of some also X in seconds.
    fn dwell(&mut self, function: Function, words: &BlockWords) {
        let pause = self.take(words, 'P').map(|given| given.dwell_s(self.control));
        let pause = match pause {
            None if self.control.is(Q::DwellInX) => self.take(words, 'X').map(WordValue::seconds),
            other => other,
        };
        match pause.filter(|seconds| *seconds >= 0.0) {
            Some(seconds) => self.wait(seconds),
            None => {
                let address = if self.control.is(Q::DwellInX) { "P, X" } else { "P" };
                self.report("dwell-time-missing", function.span, &[("words", address.to_owned().into_figure())]);
            }
        }
    }

    pub(super) fn wait(&mut self, seconds: f64) {
        self.push(Motion::Dwell { seconds: Decimal::from_f64_rounded(seconds).to_f64() });
    }

    /// The function of each group; one-shot functions act in this block only, motions and cycles are handled
    /// elsewhere.
    fn modes(&mut self, words: &BlockWords) {
        for &(_, group) in Group::NAMES {
            let Some(function) = words.function(group) else { continue };
            match self.control.g.get(&function.code).map(|known| known.effect) {
                Some(Effect::Mode) => self.state.set(group, Some(function.code)),
                Some(Effect::Noted) => {
                    // The tolerances of G64: of the path, and of ways that are taken together.
                    if function.code == 640 && self.control.is(Q::PathTolerance) {
                        self.take(words, 'P');
                        self.take(words, 'Q');
                    }
                    self.push(Motion::Auxiliary { word: function.name() });
                }
                _ => {}
            }
        }
    }

    /// G43 H and G49. The axis does not move by itself: the value shows in its next position.
    fn length_correction(&mut self, words: &BlockWords) {
        let Some(function) = words.function(Group::Length) else { return };
        let mut corrector = 0;
        let mut value = Micrometres::ZERO;
        if self.offset_by_value(words) {
            self.offset_of(function, words);
            return;
        }
        if function.code == 490 && words.get('H').is_some_and(|given| given.millionths == 0) {
            self.take(words, 'H');
        }
        if self.control.g.get(&function.code).is_some_and(|known| known.effect == Effect::OffsetAdded) {
            return self.add_length(function, words);
        }
        if function.code == 430 {
            let given =
                self.take(words, 'H').map(|given| u32::try_from(given.millionths / 1_000_000).unwrap_or_default());
            let named = self.state.tool > 0 || self.state.tool_named;
            let tool = Some(self.state.tool).filter(|_| self.control.is(Q::LengthOfToolInSpindle) && named);
            let Some(number) = given.or(tool) else {
                self.fault("corrector-missing", function.span);
                return;
            };
            corrector = number;
            value = self.corrector(number, function).unwrap_or_default();
            let named = self.named();
            if self.control.changes_tools()
                && self.state.registers.takes(number, named, function.span, self.block.number)
            {
                self.report("tool-not-brought", function.span, &[("tool", named.wanted.into_figure())]);
            }
        }
        self.state.length = value;
        self.push(Motion::LengthCorrection { axis: Axis::Z, corrector: Some(corrector), value });
    }

    /// The tool in the spindle and that of T.
    const fn named(&self) -> Named {
        Named { tool: self.state.tool, wanted: self.state.wanted }
    }

    /// A tool that never came, and whose length may have acted.
    fn never_came(&mut self, open: Option<Open>) {
        if let Some(Open { tool, span, block }) = open {
            let fault = fault("tool-not-brought", span, block).with("tool", tool);
            self.faults.push(fault);
        }
    }

    /// The length of a tool; none, and told, where it is not given.
    pub(super) fn corrector(&mut self, number: u32, function: Function) -> Option<Micrometres> {
        let known = self.state.correctors.get(&number).copied().or((number == 0).then_some(Micrometres::ZERO));
        if known.is_none() {
            self.report("corrector-unknown", function.span, &[("number", number.into_figure())]);
        }
        known
    }

    /// Whether the block sets the length offset by a value: Z is no way then.
    pub(super) fn offset_by_value(&self, words: &BlockWords) -> bool {
        let known = words.function(Group::Length).and_then(|function| self.control.g.get(&function.code));
        known.is_some_and(|known| known.effect == Effect::OffsetValue)
    }

    /// G43.1 Z: the offset is the value of Z. GRBL takes it only while a function of motion acts. Where the lengths of the
    /// tools are known, it must be that of one of them: which one the program does not say.
    fn offset_of(&mut self, function: Function, words: &BlockWords) {
        // LinuxCNC has offsets along X and Y, too.
        let sideways = self.control.is(Q::OWords);
        if sideways && ['X', 'Y'].into_iter().any(|axis| self.take(words, axis).is_some_and(|it| it.millionths != 0)) {
            self.not_carried_out(function, "G43.1 X, Y");
        }
        let Some(given) = self.take(words, 'Z') else {
            self.report("axes-missing", function.span, &[("function", function.name().into_figure())]);
            return;
        };
        if !self.control.is(Q::OWords)
            && self.state.mode(Group::Motion).is_none()
            && words.function(Group::Motion).is_none()
        {
            self.fault("motion-missing", function.span);
        }
        // T alone names the tool that the operator brings at the next stop.
        let Named { tool, wanted } = self.named();
        if wanted != tool && tool > 0 && !self.control.changes_tools() {
            self.report("tool-not-brought", function.span, &[("tool", wanted.into_figure())]);
        }
        let value = given.length(self.state.inches());
        let known = &self.setting.correctors;
        if !known.is_empty() && !known.values().any(|own| *own == value) {
            let fault = self.fault("offset-of-no-tool", given.span);
            fault.note = Note::new("offset-of-no-tool").with("value", value);
            fault.of_program_alone = true;
        }
        self.state.length = value;
        self.push(Motion::LengthCorrection { axis: Axis::Z, corrector: None, value });
    }

    /// The feed of a cycle, which cannot have it as the inverse of time.
    pub(super) fn feed(&mut self, span: TextSpan) -> MillimetresPerMinute {
        self.feed_along(None, span)
    }

    /// The feed by F and the operator's switch along a way, mm; reported when there is none, or when the spindle does not
    /// turn. G93: F ways in a minute; G95: F for each turn.
    pub(super) fn feed_along(&mut self, length: Option<f64>, span: TextSpan) -> MillimetresPerMinute {
        if self.state.turning == Turning::Stopped {
            self.fault("feed-without-spindle", span);
        }
        self.feed_by_word(length, span)
    }

    /// The same of a cycle that starts the spindle itself.
    pub(super) fn feed_by_word(&mut self, length: Option<f64>, span: TextSpan) -> MillimetresPerMinute {
        let times = match self.state.mode(Group::FeedMode) {
            Some(930) => length.unwrap_or_default(),
            Some(950) => self.state.speed * self.setting.speed_override as f64 / 100.0,
            _ => 1.0,
        };
        if self.state.feed_user.uses() {
            self.fault("feed-of-tool-before", span).of_program_alone = true;
        }
        let of_turn = self.state.mode(Group::FeedMode) == Some(950);
        let written = self.state.feed;
        if of_turn && written > self.control.habits.feed_of_turn {
            self.report("feed-of-turn", span, &[("feed", round_to(written, 3).into_figure())]);
            self.faults.last_mut().into_iter().for_each(|fault| fault.of_program_alone = true);
        } else if times == 1.0 && written > 0.0 && written < self.control.habits.feed_of_minute {
            self.report("feed-of-minute", span, &[("feed", round_to(written, 3).into_figure())]);
            self.faults.last_mut().into_iter().for_each(|fault| fault.of_program_alone = true);
        }
        let feed = self.state.feed * times * self.setting.feed_override as f64 / 100.0;
        // A way that goes nowhere has no feed by time, and needs none.
        let nowhere = times == 0.0 && length == Some(0.0) && self.state.feed > 0.0;
        if feed <= 0.0 && !nowhere {
            self.fault("feed-zero", span);
        }
        let by_mode = self.state.mode(Group::FeedMode).is_some_and(|mode| mode != 940);
        if let Some(limit) = self.feed_most().filter(|limit| by_mode && feed > *limit) {
            self.report("feed-beyond-machine", span, &[("limit", limit.into_figure())]);
        }
        MillimetresPerMinute(feed)
    }

    /// Adds a step at the position of the axes.
    pub(super) fn push(&mut self, motion: Motion) {
        let step = MotionStep { motion, at: self.state.at, block: self.block };
        let seen = self.seen(Micrometres::ZERO, false);
        self.watched.below.takes(&step, step.at, seen);
        self.steps.push(step);
    }

    /// Adds a step to a position; none if a straight motion would not move.
    pub(super) fn go(&mut self, motion: Motion, to: Position, floating: [Floating; 3], span: TextSpan) {
        let from = std::mem::replace(&mut self.state.at, to);
        // A level of a cycle or a return is a whole micrometre; who goes to written words says what they lost.
        for axis in Axis::ALL.into_iter().filter(|axis| from.get(*axis) != to.get(*axis)) {
            self.state.lost[axis.index()] = 0.0;
        }
        self.state.floating = floating;
        if from == to && !matches!(motion, Motion::Arc { .. }) {
            return;
        }
        let step = MotionStep { motion, at: to, block: self.block };
        let with = (&mut *self.spans, self.setting.assumed);
        for (code, note) in
            beyond_travel(self.machine, geometry::reach(&step.motion, from, step.at), from, floating, with)
        {
            self.fault(code, span).note = note;
        }
        self.state.z_on_machine &= from.z == to.z;
        self.state.moved = true;
        self.stays(&step.motion, from, span);
        self.along_contour(&step, from, span);
        self.steps.push(step);
    }

    /// What a motion to where the axes are now shows of the heights of the tool. A cycle along another axis says nothing of them.
    fn stays(&mut self, motion: &Motion, from: Position, span: TextSpan) {
        let (to, ends) = (self.state.at, self.state.floating[Axis::Z.index()]);
        if self.state.mode(Group::Cycle).is_some() && self.state.mode(Group::Plane) != Some(170) {
            self.state.stay = Stay::comes(to, ends);
            return;
        }
        let zero = self.state.origin(Axis::Z, self.setting).0;
        if let Some(code) = self.state.stay.moves(motion, (from, to), (ends, zero), self.state.turning) {
            self.fault(code, span).of_program_alone = true;
        }
    }

    /// A motion across the plane to a level.
    pub(super) fn climb(&mut self, motion: Motion, level: Micrometres, span: TextSpan) {
        let across = self.state.plane().axes()[2];
        let (at, floating) = (self.state.at.with(across, level), self.state.floating);
        self.go(motion, at, floating, span);
    }
}
