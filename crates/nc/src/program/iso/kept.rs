//! M70 to M73 of LinuxCNC: modes that are kept and brought back. The function of motion and the cycle are not among them.

use super::block::Maker;
use super::control::{Action, Group};
use super::state::{ControlState, Modes};
use crate::motion::{Motion, Turning};
use crate::program::TextSpan;

/// What M70 and M73 keep.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    modes: Modes,
    feed: f64,
    speed: f64,
    turning: Turning,
    coolant: bool,
    /// Whether the shift of G52 and G92 acted; its values are not kept.
    shifted: bool,
    /// Whether the end of the subprogram brings it back.
    at_return: bool,
}

/// The groups that are brought back.
const GROUPS: [Group; 10] = [
    Group::Plane,
    Group::Units,
    Group::Radius,
    Group::System,
    Group::Path,
    Group::Distance,
    Group::ArcDistance,
    Group::FeedMode,
    Group::Retract,
    Group::Diameter,
];

impl ControlState {
    /// Whether the subprogram at that depth asked for its caller's modes at its end.
    pub(super) fn brings_back(&self, depth: usize) -> bool {
        self.kept.get(depth).and_then(Option::as_ref).is_some_and(|kept| kept.at_return)
    }
}

impl Maker<'_> {
    /// M70, M71, M72 or M73 in a block at that depth of calls.
    pub(super) fn keep(&mut self, action: Action, span: TextSpan) {
        let at_return = action == Action::KeepForReturn;
        let depth = self.depth;
        self.state.kept.resize(depth + 1, None);
        match action {
            Action::KeepModes | Action::KeepForReturn => {
                let state = &self.state;
                self.state.kept[depth] = Some(Kept {
                    modes: state.modes(),
                    feed: state.feed,
                    speed: state.speed,
                    turning: state.turning,
                    coolant: state.coolant,
                    shifted: state.shifted,
                    at_return,
                });
            }
            Action::BringModes if self.state.kept[depth].is_none() => {
                self.fault("modes-not-kept", span);
            }
            Action::BringModes => self.bring_back(),
            _ => self.state.kept[depth] = None,
        }
    }

    /// Brings back what was kept at this depth.
    pub(super) fn bring_back(&mut self) {
        let Some(kept) = self.state.kept.get(self.depth).cloned().flatten() else { return };
        if let (before, Some(430 | 490)) = (self.state.mode(Group::Length), kept.modes[Group::Length as usize]) {
            let now = kept.modes[Group::Length as usize];
            if now != before {
                // G49, or G43 without H.
                let tool = (now == Some(430)).then(|| self.state.correctors.get(&self.state.tool).copied()).flatten();
                self.state.length = tool.unwrap_or_default();
                self.state.set(Group::Length, now);
            }
        }
        for group in GROUPS {
            self.state.set(group, kept.modes[group as usize]);
        }
        if self.state.shifted != kept.shifted {
            // G92.3 or G92.2.
            self.state.shifted = kept.shifted;
            self.state.shift = if kept.shifted { self.state.shift_kept } else { Default::default() };
        }
        self.state.feed = kept.feed;
        self.state.speed = kept.speed;
        if self.state.turning != kept.turning || kept.turning != Turning::Stopped {
            self.spindle(kept.turning);
        }
        if self.state.coolant != kept.coolant {
            self.state.coolant = kept.coolant;
            self.push(Motion::Coolant { on: kept.coolant });
        }
    }
}
