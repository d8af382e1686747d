//! What the program before may have left: modes that this one relies on and has never set, and the height of the quill.

use super::block::Maker;
use super::control::{Effect, Group};
use super::words::BlockWords;
use crate::motion::Axis;
use crate::note::IntoFigure;

impl Maker<'_> {
    /// Groups that the block relies on and that the program has never set: there what the program before has left
    /// acts. Each is told once.
    pub(super) fn modes_left_over(&mut self, words: &BlockWords) {
        for &(_, group) in Group::NAMES {
            self.state.own[group as usize] |= words.function(group).is_some();
        }
        // A function of motion ends a cycle.
        self.state.own[Group::Cycle as usize] |= words.function(Group::Motion).is_some();
        let names = |axis: Axis| words.get(axis.letter()).is_some();
        let moves = Axis::ALL.into_iter().any(names) && words.one_shot(Effect::Dwell, self.control).is_none();
        if !moves {
            return;
        }
        self.height_of_way(names(Axis::Z), names(Axis::X) || names(Axis::Y));
        let on_machine = words.one_shot(Effect::MachinePosition, self.control).is_some();
        let motion = words.function(Group::Motion).map(|function| function.code).or(self.state.mode(Group::Motion));
        let cycle = words.function(Group::Cycle).map(|function| function.code).or(self.state.mode(Group::Cycle));
        let cycle = cycle.is_some_and(|code| self.control.cycles.contains_key(&code));
        let relied_on = [
            (Group::Units, "G21", true),
            (Group::Distance, "G90", true),
            (Group::Cycle, "G80", true),
            (Group::Plane, "G17", cycle || matches!(motion, Some(20 | 30))),
            (Group::Radius, "G40", names(Axis::X) || names(Axis::Y)),
            // A position of the machine contains no length offset, and no zero of the operator.
            (Group::Length, "G49", names(Axis::Z) && !on_machine),
            (Group::System, "G54", !on_machine && words.one_shot(Effect::Return, self.control).is_none()),
        ];
        let unset: Vec<(Group, &str)> = relied_on
            .into_iter()
            .filter(|(group, _, used)| *used && !self.state.own[*group as usize])
            .map(|(group, word, _)| (group, word))
            .collect();
        for (group, _) in &unset {
            self.state.own[*group as usize] = true;
        }
        let wanted: Vec<&str> = unset.into_iter().map(|(_, word)| word).collect();
        if !wanted.is_empty() {
            self.report("mode-left-over", self.span, &[("words", wanted.join(", ").into_figure())]);
        }
    }

    /// A way along X or Y before the program has brought Z anywhere: the quill may be down.
    fn height_of_way(&mut self, lifts: bool, goes: bool) {
        self.state.height_known |= lifts;
        if goes && !std::mem::replace(&mut self.state.height_known, true) {
            self.fault("height-unknown", self.span);
        }
    }
}
