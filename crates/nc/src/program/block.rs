//! A block as writers make it: its words in the order that ГОСТ 20999 recommends (textbook l. 1220, 1415), the cycle
//! with its parameters last (3.12.1).

use std::fmt::Display;

use crate::units::Micrometres;

/// A block without its number.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Block {
    /// The words, each with its place in the order.
    words: Vec<(u8, String)>,
    /// The function of a cycle with its parameters.
    cycle: String,
}

/// G, then travels, centres, feed, speed, tool, offset registers, M, and the call of a subprogram.
const ORDER: [&str; 13] = ["G", "X", "Y", "Z", "I", "J", "K", "F", "S", "T", "DH", "M", "LP"];

impl Block {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    #[must_use]
    pub(crate) fn word(mut self, letter: char, value: impl Display) -> Self {
        let rank = ORDER.iter().position(|letters| letters.contains(letter)).unwrap_or(ORDER.len());
        let rank = u8::try_from(rank).unwrap_or(u8::MAX);
        let at = self.words.partition_point(|(known, _)| *known <= rank);
        self.words.insert(at, (rank, format!("{letter}{value}")));
        self
    }

    #[must_use]
    pub(crate) fn g(self, code: u32) -> Self {
        self.word('G', code)
    }

    #[must_use]
    pub(crate) fn m(self, code: u32) -> Self {
        self.word('M', code)
    }

    /// A dimension word, mm; a number without a point counts millimetres.
    #[must_use]
    pub(crate) fn axis(self, letter: char, value: Micrometres) -> Self {
        self.word(letter, value)
    }

    /// L and P: a subprogram and the number of its repeats. Its number keeps its leading zero.
    #[must_use]
    pub(crate) fn calls(self, number: u32, times: usize) -> Self {
        let block = if times > 1 { self.word('L', times) } else { self };
        block.word('P', format_args!("{number:02}"))
    }

    /// The function of a cycle with its parameters; it stands last.
    #[must_use]
    pub(crate) fn cycle(mut self, text: String) -> Self {
        self.cycle = text;
        self
    }

    /// This block with the words of another one in their places.
    #[must_use]
    pub(crate) fn with(self, other: &Self) -> Self {
        other.words.iter().fold(self, |block, (_, word)| {
            let mut letters = word.chars();
            let letter = letters.next().unwrap_or_default();
            block.word(letter, letters.as_str())
        })
    }

    pub(crate) fn text(&self) -> String {
        let words: Vec<&str> = self.words.iter().map(|(_, word)| word.as_str()).collect();
        let cycle = Some(self.cycle.as_str()).filter(|cycle| !cycle.is_empty());
        words.into_iter().chain(cycle).collect::<Vec<_>>().join(" ")
    }
}
