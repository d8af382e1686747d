//! What the program before may have left: modes that this one relies on and has never set, and the height of the quill.

use super::super::left_over::{ReliedOn, height_unknown, never_set};
use super::block::Maker;
use super::control::{Characteristic as Q, Effect, Group};
use super::words::BlockWords;
use crate::motion::Axis;

impl Maker<'_> {
    /// Tells of the groups that the block relies on and that the program has never set.
    pub(super) fn modes_left_over(&mut self, words: &BlockWords) {
        for &(_, group) in Group::NAMES {
            self.state.own[group as usize] |= words.function(group).is_some();
        }
        // A function of motion ends a cycle.
        self.state.own[Group::Cycle as usize] |= words.function(Group::Motion).is_some();
        let names = |axis: Axis| words.names(axis);
        let motion = words.function(Group::Motion).map(|function| function.code).or(self.state.mode(Group::Motion));
        let cycle = words.function(Group::Cycle).map(|function| function.code).or(self.state.mode(Group::Cycle));
        let cycle = cycle.is_some_and(|code| self.control.cycles.contains_key(&code));
        let arc = !cycle && matches!(motion, Some(20 | 30));
        let time = words.one_shot(Effect::Dwell, self.control).is_some();
        // A full circle may name no axis.
        let circle = arc && ['I', 'J', 'K'].into_iter().any(|address| words.get(address).is_some());
        let moves = (words.names_any() || circle) && !time && !self.offset_by_value(words);
        let moves = moves && self.sets_zero(words).is_none();
        if !moves {
            return;
        }
        if height_unknown(&mut self.state.height_known, names(Axis::Z), names(Axis::X) || names(Axis::Y)) {
            self.fault("height-unknown", self.span).severity = self.setting.before.of_habit();
        }
        let on_machine = words.one_shot(Effect::MachinePosition, self.control).is_some();
        let relied_on = [
            (Group::Units, "G21", true),
            (Group::Distance, "G90", true),
            (Group::Cycle, "G80", true),
            (Group::Plane, "G17", cycle || arc),
            (Group::ArcDistance, "G91.1", arc && self.control.is(Q::ArcCentresAsSet)),
            (Group::Radius, "G40", (names(Axis::X) || names(Axis::Y)) && self.control.corrects_radius()),
            // A position of the machine contains no length offset, and no zero of the operator.
            (Group::Length, "G49", names(Axis::Z) && !on_machine),
            (Group::System, "G54", !on_machine && words.one_shot(Effect::Return, self.control).is_none()),
        ];
        let tool = self.state.tool;
        let relied_on = relied_on.map(|(group, word, used)| {
            let by_habit = group == Group::System || (matches!(group, Group::Length | Group::Radius) && tool == 0);
            ReliedOn { group: group as usize, word: word.to_owned(), used, by_habit }
        });
        for (code, note, subject) in never_set(&mut self.state.own, self.setting.before, relied_on) {
            let fault = self.fault(code, self.span);
            (fault.note, fault.subject) = (note, Some(subject));
        }
    }
}
