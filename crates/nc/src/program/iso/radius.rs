//! G41 and G42 of controls that go beside a contour themselves: the ways are traced as they are written, and what is written is
//! held to what the control can do with it. And what is done below the zero.

use super::block::Maker;
use super::control::{Characteristic as Q, Effect, Group};
use super::words::BlockWords;
use crate::motion::{Axis, Motion, MotionStep, Position};
use crate::note::Severity;
use crate::program::TextSpan;
use crate::program::alone::Radius;
use crate::program::below::Seen;
use crate::program::contour::ToldOfContour;
use crate::units::Micrometres;

impl Maker<'_> {
    /// G40, G41, G42 of the block.
    pub(super) fn radius(&mut self, words: &BlockWords) {
        self.state.radius_register = words.register.or(self.state.radius_register);
        let told = match words.radius {
            Some((left, register)) => {
                let known = register.filter(|register| !self.state.registers.is_length(*register));
                let known = known.and_then(|register| self.state.correctors.get(&register)).map(|value| value.to_mm());
                let radius = self.watched.names.radius(self.state.tool).or(known);
                self.radius_register(register);
                self.watched.contour.begins(left, radius)
            }
            None if words.function(Group::Radius).is_some() => {
                let on_arc = matches!(self.state.mode(Group::Motion), Some(20 | 30))
                    && words.function(Group::Motion).is_none()
                    || words.function(Group::Motion).is_some_and(|function| matches!(function.code, 20 | 30));
                if self.watched.contour.is_active() && on_arc && words.names_any() && self.control.is(Q::RadiusOnALine)
                {
                    self.fault("correction-by-arc", self.span);
                }
                self.watched.contour.ends()
            }
            None => return,
        };
        self.tell_of_contour(told);
    }

    /// G41 or G42 begins: the register that acts, where the control goes by one that of a block before, too.
    fn radius_register(&mut self, register: Option<u32>) {
        let by_register = self.control.is(Q::RadiusByRegister);
        match register.or(self.state.radius_register.filter(|_| by_register)) {
            Some(register @ 1..) => {
                let radius = Radius { tool: self.state.tool, register, block: self.block };
                let is_known = |known: &Radius| (known.tool, known.register) == (radius.tool, register);
                if !self.watched.radii.iter().any(is_known) {
                    self.watched.radii.push(radius);
                }
            }
            _ if by_register => self.fault("radius-register-missing", self.span).of_program_alone = true,
            _ => {}
        }
    }

    fn tell_of_contour(&mut self, told: Vec<ToldOfContour>) {
        for (code, span, block, note) in told {
            let mut fault = super::rules::fault(code, span, block);
            (fault.note, fault.of_program_alone) = (note, true);
            self.faults.push(fault);
        }
    }

    /// A tool change or the end while G41 or G42 acts: the next tool or the next program goes beside its path.
    pub(super) fn radius_left_on(&mut self, span: TextSpan) {
        if self.watched.contour.is_active() {
            self.fault("radius-not-cancelled", span).of_program_alone = true;
            let told = self.watched.contour.ends();
            self.tell_of_contour(told);
        }
    }

    /// The end of the program, which of some controls turns it off.
    pub(super) fn radius_at_end(&mut self, span: TextSpan) {
        if self.control.is(Q::EndCancelsRadius) {
            let told = self.watched.contour.ends();
            return self.tell_of_contour(told);
        }
        self.radius_left_on(span);
    }

    /// A motion as the contour and the zero see it.
    pub(super) fn along_contour(&mut self, step: &MotionStep, from: Position, span: TextSpan) {
        let first = self.watched.contour.is_active() && self.watched.contour.is_empty();
        if first && matches!(step.motion, Motion::Arc { .. }) && self.control.is(Q::RadiusOnALine) {
            self.fault("correction-by-arc", span);
        }
        self.watched.contour.takes(step, from, span);
        let zero = self.state.origin(Axis::Z, self.setting).0;
        let in_cycle = self.state.mode(Group::Cycle).is_some();
        // Heights by a zero of the machine, or across another plane, say nothing of the face.
        if self.state.mode(Group::Plane) == Some(170) && !self.state.z_on_machine {
            self.watched.below.takes(step, from, self.seen(zero, in_cycle));
        }
    }

    /// By what a motion is seen.
    pub(super) fn seen(&self, zero: Micrometres, in_cycle: bool) -> Seen {
        let system = u8::try_from(self.state.system_index()).unwrap_or_default();
        Seen { zero, system, tool: self.state.tool, in_cycle }
    }

    /// G91 that a subprogram has left: the program that called it goes on in distances.
    pub(super) fn distances_of_a_call(&mut self, words: &BlockWords) {
        if words.function(Group::Distance).is_some() || self.state.absolute() {
            self.state.left_by_call = None;
            return;
        }
        let returns = words.one_shot(Effect::Return, self.control).is_some();
        let sets = self.offset_by_value(words) || self.sets_zero(words).is_some();
        let deepest = self.state.left_by_call.filter(|_| words.names_any() && !returns && !sets);
        if deepest.is_some_and(|deepest| self.depth <= deepest) {
            self.state.left_by_call = None;
            // A return with G91 is told by itself.
            if self.state.left_by_return.is_none() {
                self.fault("distances-of-call", self.span);
            }
        }
    }

    /// G91 of a return, such as `G91 G28 Z0`, that nobody takes back: the next positions are distances. Behind a tool change, or
    /// beside a system or a length offset, positions are meant.
    pub(super) fn return_left_over(&mut self, words: &BlockWords) {
        let returns = words.one_shot(Effect::Return, self.control).is_some();
        match words.function(Group::Distance).map(|function| function.code) {
            Some(910) if returns => {
                if self.state.absolute() {
                    self.state.left_by_return = Some(false);
                }
                return;
            }
            Some(_) => self.state.left_by_return = None,
            None => {}
        }
        let sets = self.offset_by_value(words) || self.sets_zero(words).is_some();
        let Some(changed) = self.state.left_by_return.filter(|_| words.names_any() && !returns && !sets) else {
            return;
        };
        self.state.left_by_return = None;
        if self.state.absolute() {
            return;
        }
        let positions = changed || words.function(Group::System).is_some() || words.function(Group::Length).is_some();
        let fault = self.fault("distances-left-over", self.span);
        fault.severity = if positions { Severity::Wrong } else { Severity::Doubtful };
    }
}
