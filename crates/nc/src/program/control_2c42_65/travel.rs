//! Outputs steps: through the radius correction, checked against the travels of the machine.

use super::block::Maker;
use super::correction::Trouble;
use crate::motion::{Axis, Motion, MotionStep, Position, geometry};
use crate::program::TextSpan;
use crate::program::limits::{AxisRanges, beyond_travel};

impl Maker<'_> {
    /// Adds a step at the position of the axes.
    pub(super) fn push(&mut self, motion: Motion) {
        let from = self.state.corrected(self.state.base);
        self.push_from(motion, from, self.span);
    }

    /// Adds a step from a point of the programmed path to the position of the state.
    pub(super) fn push_from(&mut self, motion: Motion, from: Position, span: TextSpan) {
        self.step_count += 1;
        let step = MotionStep { motion, at: self.state.corrected(self.state.base), block: self.block };
        let begin = self.steps.len();
        let taken = self.state.compensator.take(step, from, span, &mut self.steps);
        self.emit(begin, taken, span);
    }

    /// Outputs the steps that the radius correction still delays.
    pub(super) fn flush(&mut self) {
        let begin = self.steps.len();
        let flushed = self.state.compensator.flush(&mut self.steps);
        self.emit(begin, flushed, self.span);
    }

    /// Checks the output of the radius correction, from an index of the steps on, against the travels.
    pub(super) fn emit(&mut self, begin: usize, given: Result<(), Trouble>, span: TextSpan) {
        if let Err((code, at)) = given {
            self.fault(code, at);
            return;
        }
        for index in begin..self.steps.len() {
            let step = &self.steps[index];
            let at = step.at;
            if matches!(step.motion, Motion::Rapid | Motion::Feed { .. } | Motion::Arc { .. }) {
                let reached = geometry::reach(&step.motion, self.state.actual, at);
                self.hold_in_travel(reached, span);
                let (ways, ends) = ((self.state.actual, at), self.state.floating[Axis::Z.index()]);
                let told = self.state.stay.moves(&self.steps[index].motion, ways, ends, self.state.turning);
                if let Some(code) = told {
                    self.program_alone(code, span);
                }
            }
            self.state.actual = at;
        }
    }

    /// An axis may not leave its travel (3.8.3).
    fn hold_in_travel(&mut self, reached: AxisRanges, span: TextSpan) {
        let (from, floating) = (self.state.actual, self.state.floating);
        for (code, note) in beyond_travel(Some(self.machine), reached, from, floating, self.spans) {
            self.tell_note(code, span, note);
        }
    }
}
