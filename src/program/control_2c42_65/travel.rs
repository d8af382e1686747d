//! The way of a step to the sink: through the radius correction, held against the travels of the machine.

use std::collections::BTreeMap;

use super::block::Maker;
use super::correction::Trouble;
use crate::motion::{Axis, Motion, Position, Step, geometry};
use crate::program::Span;
use crate::units::Micrometres;

/// How far the axes of each system without a zero have gone, least and greatest.
pub(super) type Spans = BTreeMap<(u8, usize), (Micrometres, Micrometres)>;

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
        let begin = self.steps.len();
        let taken = self.state.compensator.take(step, from, span, &mut self.steps);
        self.emit(begin, taken, span);
    }

    /// What the radius correction still holds back.
    pub(super) fn flush(&mut self) {
        let begin = self.steps.len();
        let flushed = self.state.compensator.flush(&mut self.steps);
        self.emit(begin, flushed, self.span);
    }

    /// Holds what the radius correction has given out, from a place in the steps, against the travels.
    pub(super) fn emit(&mut self, begin: usize, given: Result<(), Trouble>, span: Span) {
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
            }
            self.state.actual = at;
        }
    }

    /// An axis may not leave its travel (3.8.3). Where its zero is set, its place on the machine is known: X and Y have
    /// their zero in the middle, Z at the upper end (textbook, l. 4719-4728). Where it is not, what it needs of travel is.
    fn hold_in_travel(&mut self, reached: [(Micrometres, Micrometres); 3], span: Span) {
        let from = self.state.actual;
        for axis in Axis::ALL {
            let (low, high) = reached[axis.index()];
            let here = from.get(axis);
            if low == here && high == here {
                continue;
            }
            let (least, most) = self.travel(axis);
            match self.state.floating[axis.index()] {
                None => {
                    let beyond = if low < least { Some(low) } else { Some(high).filter(|high| *high > most) };
                    if let Some(value) = beyond {
                        let figures = [
                            ("axis", axis.letter().to_string()),
                            ("value", value.to_string()),
                            ("low", least.to_string()),
                            ("high", most.to_string()),
                        ];
                        self.tell("beyond-travel-of", span, &figures);
                    }
                }
                Some(system) => {
                    let entry = self.spans.entry((system, axis.index())).or_insert((low, high));
                    *entry = (entry.0.min(low), entry.1.max(high));
                    let needed = entry.1 - entry.0;
                    let travel = most - least;
                    if needed > travel {
                        let figures = [
                            ("axis", axis.letter().to_string()),
                            ("system", format!("G{system}")),
                            ("needed", needed.to_string()),
                            ("travel", travel.to_string()),
                        ];
                        self.tell("span-beyond-travel", span, &figures);
                    }
                }
            }
        }
    }

    /// Where an axis can go, machine coordinates.
    fn travel(&self, axis: Axis) -> (Micrometres, Micrometres) {
        match axis {
            Axis::X => (-self.machine.travel_x.half(), self.machine.travel_x.half()),
            Axis::Y => (-self.machine.travel_y.half(), self.machine.travel_y.half()),
            Axis::Z => (-self.machine.travel_z, Micrometres::ZERO),
        }
    }
}
