//! The way of a step to the sink: through the radius correction, held against the travels of the machine.

use super::block::Maker;
use crate::motion::{Motion, Position, Step};
use crate::program::Span;
use crate::program::limits::beyond_travel;

impl Maker<'_> {
    /// One more step where the axes stand.
    pub(super) fn push(&mut self, motion: Motion) {
        let from = self.state.corrected(self.state.base);
        self.push_from(motion, from, self.span);
    }

    /// One more step from a point of the programmed path to where the state is now.
    pub(super) fn push_from(&mut self, motion: Motion, from: Position, span: Span) {
        self.made += 1;
        let step = Step { motion, at: self.state.corrected(self.state.base), block: self.block };
        match self.state.compensator.take(step, from, span) {
            Ok(steps) => self.emit_all(steps, span),
            Err((code, at)) => {
                self.fault(code, at);
            }
        }
    }

    /// What the radius correction still holds back.
    pub(super) fn flush(&mut self) {
        match self.state.compensator.flush() {
            Ok(steps) => self.emit_all(steps, self.span),
            Err((code, at)) => {
                self.fault(code, at);
            }
        }
    }

    pub(super) fn emit_all(&mut self, steps: Vec<Step>, span: Span) {
        for step in steps {
            if matches!(step.motion, Motion::Rapid | Motion::Feed { .. } | Motion::Arc { .. }) {
                self.hold_in_travel(&step, span);
            }
            self.state.actual = step.at;
            self.steps.push(step);
        }
    }

    /// An axis may not leave its travel (3.8.3).
    fn hold_in_travel(&mut self, step: &Step, span: Span) {
        let (from, floating) = (self.state.actual, self.state.floating);
        for note in beyond_travel(self.machine, step, from, floating, self.spans) {
            let fault = self.fault(note.0, span);
            fault.note = note.1;
        }
    }
}
