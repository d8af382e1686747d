//! What the program before may have left: modes that this one relies on and has never set, and the height of the quill.

use super::super::left_over::{height_unknown, never_set};
use super::block::Maker;
use super::state::{CYCLE, DISTANCE, LENGTH, PLANE, RADIUS, SYSTEM};
use super::words::BlockWords;
use crate::motion::Axis;
use crate::note::IntoFigure;

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
            self.fault("height-unknown", self.span);
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
        let unset = never_set(&mut self.state.own, relied_on.map(|(group, used)| (group, group, used)));
        let wanted: Vec<String> = unset.into_iter().map(|group| format!("G{}", safe(group))).collect();
        if !wanted.is_empty() {
            self.report("mode-left-over", self.span, &[("words", wanted.join(", ").into_figure())]);
        }
    }
}
