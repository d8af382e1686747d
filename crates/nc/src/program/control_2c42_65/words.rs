//! Step 1 of a block: its words, and its functions by their groups.

use super::control::{Control, GROUPS};
use super::text::Block;
use crate::motion::Axis;
use crate::program::TextSpan;

/// A number in thousandths with its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct WordValue {
    pub thousandths: i64,
    pub span: TextSpan,
}

impl WordValue {
    pub(super) const fn number(self) -> i64 {
        self.thousandths / 1000
    }
}

/// A function with its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Function {
    pub code: u8,
    pub span: TextSpan,
}

/// The words of a block for its execution.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockWords {
    /// The last function of every group (3.10, note 3).
    pub g: [Option<Function>; GROUPS],
    /// X, Y, Z.
    pub axes: [Option<WordValue>; 3],
    /// I, J, K.
    pub centre: [Option<WordValue>; 3],
    /// Every other address, by its letter.
    pub other: [Option<WordValue>; 26],
    /// The M functions, as they stand.
    pub m: Vec<Function>,
    /// The parameters of the cycle, by their letters; absent if the block has no cycle function.
    pub cycle: Option<Box<[Option<WordValue>; 26]>>,
}

impl BlockWords {
    /// Reads a block; with `skip`, without the words after `/` (4.2.4.3).
    pub(super) fn read(block: &Block, control: &Control, skip: bool) -> Self {
        let mut words = Self::default();
        for word in block.words.iter().filter(|word| !(skip && word.skipped)) {
            let given = Some(WordValue { thousandths: word.thousandths, span: word.span });
            let function = Function { code: word.code(), span: word.span };
            let place = letter(word.address);
            if let Some(parameters) = words.cycle.as_mut().filter(|_| word.in_cycle) {
                parameters[place] = given;
                continue;
            }
            match word.address {
                'G' => {
                    if let Some(slot) = control.groups.get(function.code).and_then(|group| words.g.get_mut(*group)) {
                        *slot = Some(function);
                    }
                    if control.cycles.contains(function.code) {
                        words.cycle = Some(Box::new([None; 26]));
                    }
                }
                'M' => words.m.push(function),
                'X' | 'Y' | 'Z' => words.axes[place - letter('X')] = given,
                'I' | 'J' | 'K' => words.centre[place - letter('I')] = given,
                _ => words.other[place] = given,
            }
        }
        words
    }

    /// A word that is no axis, centre, G or M.
    pub(super) const fn get(&self, address: char) -> Option<WordValue> {
        self.other[letter(address)]
    }

    /// The function of a group.
    pub(super) fn function(&self, group: usize) -> Option<u8> {
        self.g[group].map(|function| function.code)
    }

    /// The word of an axis.
    pub(super) const fn axis(&self, axis: Axis) -> Option<WordValue> {
        self.axes[axis.index()]
    }

    /// Whether any axis is named.
    pub(super) fn any_axis(&self) -> bool {
        self.axes.iter().any(Option::is_some)
    }
}

/// The place of a letter in an array of 26.
pub(super) const fn letter(address: char) -> usize {
    let code = address as usize;
    if code >= 65 && code <= 90 { code - 65 } else { 0 }
}
