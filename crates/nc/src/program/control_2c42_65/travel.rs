//! Outputs steps: through the radius correction, checked against the travels of the machine.

use super::block::Maker;
use super::correction::Trouble;
use super::state::{PLANE, SYSTEM};
use crate::motion::{Axis, Motion, MotionStep, Position, geometry};
use crate::program::TextSpan;
use crate::program::below::Seen;
use crate::program::limits::{AxisRanges, beyond_travel};
use crate::program::stay::Stay;
use crate::units::Micrometres;

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
                self.stays(index, span);
            } else if matches!(step.motion, Motion::Spindle { .. } | Motion::ToolChange { .. } | Motion::End) {
                let seen = Seen { zero: Micrometres::ZERO, system: 0, tool: self.state.tool, in_cycle: false };
                self.watched.below.takes(step, at, seen);
            }
            self.state.actual = at;
        }
    }

    /// What a step shows of the heights of the tool. In another plane a tool stands across Z.
    fn stays(&mut self, index: usize, span: TextSpan) {
        let (from, to) = (self.state.actual, self.steps[index].at);
        let ends = self.state.floating[Axis::Z.index()];
        if self.state.groups[PLANE] != 17 {
            self.state.stay = Stay::comes(to, ends);
            return;
        }
        let zero =
            self.state.corrected(Position::default().with(Axis::Z, self.state.origin_of(Axis::Z, self.setting).0)).z;
        let (tool, in_cycle) = (self.state.tool, self.cycle_in_force());
        if ends.is_some() || self.state.groups[SYSTEM] != 53 {
            let seen = Seen { zero, system: self.state.groups[SYSTEM], tool, in_cycle };
            self.watched.below.takes(&self.steps[index], from, seen);
        }
        let motion = &self.steps[index].motion;
        if let Some(code) = self.state.stay.moves(motion, (from, to), (ends, zero), self.state.turning) {
            self.program_alone(code, span);
        }
    }

    /// An axis may not leave its travel (3.8.3).
    fn hold_in_travel(&mut self, reached: AxisRanges, span: TextSpan) {
        let (from, floating) = (self.state.actual, self.state.floating);
        let with = (&mut *self.spans, self.setting.assumed);
        for (code, note) in beyond_travel(Some(self.machine), reached, from, floating, with) {
            self.tell_note(code, span, note);
        }
    }
}
