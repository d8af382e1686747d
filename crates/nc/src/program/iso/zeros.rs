//! Zeros and length offsets that a program sets itself: G10, G52, G92 to G92.3 and G43.2. Nothing moves.
//!
//! ```text
//! position of the program = position of the machine − zero of its system (G10) − shift (G52, G92) − length (G43)
//! ```

use std::rc::Rc;

use super::block::Maker;
use super::control::{Effect, Group};
use super::rules::word_fault;
use super::words::{BlockWords, Function, WordValue};
use crate::motion::{Axis, Motion};
use crate::note::IntoFigure;
use crate::units::Micrometres;

/// The last system of LinuxCNC, G59.3.
pub(super) const SYSTEMS: usize = 9;

impl Maker<'_> {
    /// The function of the block that sets a zero, and what it does.
    pub(super) fn sets_zero(&self, words: &BlockWords) -> Option<(Function, Effect)> {
        let function = words.function(Group::OneShot)?;
        let effect = self.control.g.get(&function.code)?.effect;
        let sets = matches!(
            effect,
            Effect::Data
                | Effect::LocalZero
                | Effect::Shift
                | Effect::ShiftOff
                | Effect::ShiftWaits
                | Effect::ShiftAgain
        );
        sets.then_some((function, effect))
    }

    /// Carries it out.
    pub(super) fn set_zero(&mut self, function: Function, effect: Effect, words: &BlockWords) {
        match effect {
            Effect::ShiftOff | Effect::ShiftWaits => self.state.shifted = false,
            Effect::LocalZero | Effect::Shift | Effect::ShiftAgain => self.state.shifted = true,
            _ => {}
        }
        match effect {
            Effect::Data => self.data(function, words),
            Effect::ShiftOff => (self.state.shift, self.state.shift_kept) = Default::default(),
            Effect::ShiftWaits => self.state.shift = Default::default(),
            Effect::ShiftAgain => self.state.shift = self.state.shift_kept,
            _ => {
                for (axis, value) in self.axis_lengths(words) {
                    let zero = self.state.origin(axis, self.setting).0 - self.state.shift[axis.index()];
                    let here = self.state.at.get(axis) - zero;
                    self.state.shift[axis.index()] = if effect == Effect::LocalZero { value } else { here - value };
                }
                self.state.shift_kept = self.state.shift;
            }
        }
    }

    /// The words of the axes, as lengths.
    fn axis_lengths(&mut self, words: &BlockWords) -> Vec<(Axis, Micrometres)> {
        let inches = self.state.inches();
        let given = Axis::ALL.map(|axis| self.take_axis(words, axis).map(|word| (axis, word.length(inches))));
        given.into_iter().flatten().collect()
    }

    /// G10: L2 and L20 set the zero of a system, L1, L10 and L11 the length of a tool.
    fn data(&mut self, function: Function, words: &BlockWords) {
        let whole = |word: Option<WordValue>| word.map(|word| word.millionths / 1_000_000);
        let (table, number) = (whole(self.take(words, 'L')), self.take(words, 'P'));
        let Some(place) = whole(number).and_then(|number| usize::try_from(number).ok()) else {
            self.report(
                "cycle-parameter-missing",
                function.span,
                &[("cycle", "G10".into_figure()), ("words", "P".into_figure())],
            );
            return;
        };
        match table {
            Some(2 | 20) => self.zero_of(place, table == Some(20), function, words),
            Some(1 | 10 | 11) => self.length_of(place, table.unwrap_or_default(), function, words),
            _ => {
                let word = format!("G10 L{}", table.map_or_else(String::new, |table| table.to_string()));
                self.report("unknown-word", function.span, &[("word", word.into_figure())]);
            }
        }
    }

    /// The zero of a system: as a position of the machine, or so that the axis is where the words say.
    fn zero_of(&mut self, system: usize, here: bool, function: Function, words: &BlockWords) {
        if system > SYSTEMS {
            self.report(
                "number-out-of-range",
                function.span,
                &[("address", "P".into_figure()), ("low", 0_u32.into_figure()), ("high", SYSTEMS.into_figure())],
            );
            return;
        }
        if self.take(words, 'R').is_some_and(|turned| turned.millionths != 0) {
            self.not_carried_out(function, "G10 R");
        }
        let system = system.checked_sub(1).unwrap_or_else(|| self.state.system_index());
        for (axis, value) in self.axis_lengths(words) {
            let index = axis.index();
            let length = self.state.length_along(axis);
            let zero = if here {
                let at = self.state.at.get(axis) - self.state.shift[index] - length - value;
                (at, self.state.floating[index])
            } else {
                (value, None)
            };
            self.state.zeros[system][index] = Some(zero);
        }
    }

    /// The length of a tool: as it is, or so that the tip is where the words say, in the system or in G59.3.
    fn length_of(&mut self, tool: usize, table: i64, function: Function, words: &BlockWords) {
        for letter in ['I', 'J', 'Q', 'R'] {
            self.take(words, letter);
        }
        let system = if table == 11 { SYSTEMS - 1 } else { self.state.system_index() };
        for (axis, value) in self.axis_lengths(words) {
            if axis != Axis::Z {
                if value != Micrometres::ZERO {
                    self.not_carried_out(function, "G10 X, Y");
                }
                continue;
            }
            let zero = self.state.zero(system, axis, self.setting).map_or(Micrometres::ZERO, |(zero, _)| zero);
            let shift = if table == 11 { Micrometres::ZERO } else { self.state.shift[axis.index()] };
            let length = if table == 1 { value } else { self.state.at.get(axis) - zero - shift - value };
            Rc::make_mut(&mut self.state.correctors).insert(u32::try_from(tool).unwrap_or_default(), length);
        }
    }

    /// G43.2 H: adds the length of a tool to the offset.
    pub(super) fn add_length(&mut self, function: Function, words: &BlockWords) {
        let Some(given) = self.take(words, 'H') else {
            self.fault("corrector-missing", function.span);
            return;
        };
        let number = u32::try_from(given.millionths / 1_000_000).unwrap_or_default();
        let Some(more) = self.corrector(number, function) else { return };
        let value = self.state.length + more;
        self.state.length = value;
        self.push(Motion::LengthCorrection { axis: Axis::Z, corrector: Some(number), value });
    }

    /// What is told and not carried out.
    pub(super) fn not_carried_out(&mut self, function: Function, word: &str) {
        self.faults.push(word_fault("not-carried-out", function.span, self.block.number, word));
    }
}
