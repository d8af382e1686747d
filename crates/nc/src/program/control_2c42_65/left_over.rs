//! What the program before may have left: modes that this one relies on and has never set, and the height of the quill.

use super::super::left_over::{ReliedOn, height_unknown, never_set};
use super::block::Maker;
use super::rules::fault;
use super::state::{CYCLE, DISTANCE, LENGTH, PLANE, RADIUS, SYSTEM};
use super::words::BlockWords;
use crate::motion::Axis;
use crate::program::Fault;

impl Maker<'_> {
    /// Tells of the groups that the block relies on and that the program has never set.
    pub(super) fn modes_left_over(&mut self, words: &BlockWords) {
        for (own, _) in self.state.own.iter_mut().zip(&words.g).filter(|(_, function)| function.is_some()) {
            *own = true;
        }
        self.state.own[LENGTH] |= words.get('H').is_some();
        let names = |axis: Axis| words.axis(axis).is_some() && words.function(SYSTEM) != Some(92);
        let moves = Axis::ALL.into_iter().any(names);
        let cycle = words.cycle.is_some();
        let arc = matches!(self.motion_function(), 2 | 3) && (moves || words.centre.iter().any(Option::is_some));
        if height_unknown(&mut self.state.height_known, names(Axis::Z), names(Axis::X) || names(Axis::Y)) {
            let severity = self.setting.before.of_habit();
            self.tell_fault(Fault { severity, ..fault("height-unknown", self.span, self.block.number) });
        }
        // A position of the machine is one in increments, too.
        let positions = cycle || (moves && self.state.groups[SYSTEM] != 53);
        let relied_on = [
            (PLANE, cycle || arc),
            (RADIUS, names(Axis::X) || names(Axis::Y)),
            (LENGTH, cycle || names(Axis::Z)),
            (CYCLE, moves),
            (DISTANCE, positions),
            (SYSTEM, positions),
        ];
        // G49 is what a safe start says of the length, though G43 acts after power-on.
        let safe = |group: usize| if group == LENGTH { 49 } else { self.control.power_on[group] };
        let tool = self.state.tool;
        let relied_on = relied_on.map(|(group, used)| {
            let by_habit = group == SYSTEM || (matches!(group, LENGTH | RADIUS) && tool == 0);
            ReliedOn { group, word: format!("G{}", safe(group)), used, by_habit }
        });
        for (code, note, subject) in never_set(&mut self.state.own, self.setting.before, relied_on) {
            self.tell_fault(Fault { note, ..fault(code, self.span, self.block.number) }.about(subject));
        }
    }
}
