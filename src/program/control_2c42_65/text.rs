//! The text of a program as words and blocks, each with its place (textbook 3.1 to 3.7). Nothing is understood here:
//! what a block means stands in `block.rs`, what it may hold in `check.rs`.
//!
//! Reading recovers: a word that cannot be read is told and left out, and the reading goes on behind it.

use super::control::Control;
use super::rules::fault;
use crate::program::{Fault, Span};

/// An address with its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word {
    /// The letter, or `:`.
    pub address: char,
    /// The number in thousandths.
    pub thousandths: i64,
    /// Digits before the point, as written.
    pub digits: usize,
    /// Where it stands.
    pub span: Span,
    /// Whether it stands behind the G function of a cycle and so is a parameter of it (3.12.1).
    pub in_cycle: bool,
    /// Whether it is left out when the operator asked for the skip (4.2.4.3).
    pub skipped: bool,
}

impl Word {
    /// The number, whole.
    pub(super) const fn number(self) -> i64 {
        self.thousandths / 1000
    }

    /// The code of a function, when it can be one.
    pub(super) fn code(self) -> u8 {
        u8::try_from(self.number()).unwrap_or(u8::MAX)
    }
}

/// A line of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    /// The whole of it.
    pub span: Span,
    /// Its number.
    pub number: Option<u32>,
    /// The number of the program that begins with it.
    pub program: Option<u8>,
    /// Its other words, as they stand.
    pub words: Vec<Word>,
}

/// Every block of the text, and what could not be read.
pub(super) fn blocks(text: &str, control: &Control) -> (Vec<Block>, Vec<Fault>) {
    if text.len() > control.memory_bytes {
        // What does not fit is not read: thousands of mistakes of a file that is no program help nobody.
        let whole = Span { line: 1, column: 1, width: 1 };
        let memory = control.memory_bytes;
        return (Vec::new(), vec![fault("memory-full", whole, None).with("bytes", text.len()).with("memory", memory)]);
    }
    let mut faults = Vec::new();
    let mut blocks = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line_number = u32::try_from(index + 1).unwrap_or(u32::MAX);
        let mut reader = Line { control, faults: &mut faults, line: line_number, in_cycle: false, skipped: false };
        blocks.extend(reader.block(line));
    }
    (blocks, faults)
}

struct Line<'a> {
    control: &'a Control,
    faults: &'a mut Vec<Fault>,
    line: u32,
    in_cycle: bool,
    skipped: bool,
}

impl Line<'_> {
    fn span(&self, from: usize, to: usize) -> Span {
        let number = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        Span { line: self.line, column: number(from + 1), width: number(to.saturating_sub(from).max(1)) }
    }

    /// One line; nothing of an empty one and of the sign `%` that begins a tape.
    fn block(&mut self, line: &str) -> Option<Block> {
        let before = self.faults.len();
        let characters: Vec<char> = line.chars().collect();
        let first = characters.iter().position(|c| !c.is_whitespace())?;
        if characters[first] == '%' {
            return None;
        }
        let length = line.trim_end().chars().count();
        let mut block = Block { span: self.span(first, length), ..Block::default() };
        // The end of the block counts as one character (3.4).
        if length + 1 > self.control.block_length {
            self.faults.push(
                fault("block-too-long", block.span, None)
                    .with("length", length + 1)
                    .with("limit", self.control.block_length),
            );
        }
        let mut at = first;
        while let Some(&character) = characters.get(at) {
            if character.is_whitespace() {
                at += 1;
            } else if character == '/' {
                self.skipped = true;
                at += 1;
            } else {
                let end = number_end(&characters, at + 1);
                if let Some(word) = self.word(&characters, at, end) {
                    self.place(word, &mut block);
                }
                at = end;
            }
        }
        if block.number.is_none() && block.program.is_none() {
            self.faults.push(fault("no-block-number", block.span, None));
        }
        for fault in &mut self.faults[before..] {
            fault.block = block.number;
        }
        Some(block)
    }

    /// Puts a word where it belongs: the numbers of block and program aside, the rest in its order.
    fn place(&mut self, word: Word, block: &mut Block) {
        match word.address {
            'N' if !word.in_cycle => block.number = u32::try_from(word.number()).ok(),
            ':' => {
                block.program = Some(word.code());
                if word.digits != 2 {
                    self.faults.push(fault("program-one-digit", word.span, None));
                }
            }
            _ => block.words.push(word),
        }
        if word.address == 'G' && self.control.cycles.contains_key(&word.code()) {
            self.in_cycle = true;
        }
    }

    fn word(&mut self, characters: &[char], at: usize, end: usize) -> Option<Word> {
        let address = characters[at];
        let span = self.span(at, end);
        if let Some(latin) = latin(address) {
            self.faults.push(fault("cyrillic-letter", span, None).with("letter", address).with("latin", latin));
            return None;
        }
        let Some(known) = self.control.addresses.get(&address).copied() else {
            let code = if address.is_ascii_uppercase() { "unknown-address" } else { "unknown-character" };
            self.faults.push(fault(code, span, None).with("letter", address));
            return None;
        };
        let written: String = characters[at + 1..end].iter().filter(|c| !c.is_whitespace()).collect();
        let (thousandths, digits) = self.number(&written, address, span)?;
        let word = Word { address, thousandths, digits, span, in_cycle: self.in_cycle, skipped: self.skipped };
        if !known.decimal && written.contains('.') && !(address == 'H' && self.in_cycle) {
            self.faults.push(fault("number-not-whole", span, None).with("address", address));
            return None;
        }
        // In a cycle H is a feed (table 3.13).
        let limited = if address == 'H' && self.in_cycle { 'F' } else { address };
        let limits = self.control.addresses.get(&limited).and_then(|it| it.limits).or(
            // U, V and W stand in no table of limits: they are lengths as X is.
            self.control.addresses.get(&'X').and_then(|it| it.limits).filter(|_| known.length),
        );
        if let Some((low, high)) = limits
            && !(low..=high).contains(&thousandths)
        {
            let shown = |value: i64| crate::units::Micrometres::new(value);
            self.faults.push(
                fault("number-out-of-range", span, None)
                    .with("address", address)
                    .with("low", shown(low))
                    .with("high", shown(high)),
            );
            return None;
        }
        Some(word)
    }

    /// A number as written: its thousandths, and how many digits stand before the point.
    fn number(&mut self, written: &str, address: char, span: Span) -> Option<(i64, usize)> {
        let (negative, unsigned) = match written.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, written.strip_prefix('+').unwrap_or(written)),
        };
        let (whole, part) = unsigned.split_once('.').unwrap_or((unsigned, ""));
        let code = if whole.is_empty() && part.is_empty() {
            "number-missing"
        } else if part.trim_end_matches('0').len() > 3 {
            "number-too-fine"
        } else {
            ""
        };
        if !code.is_empty() {
            self.faults.push(fault(code, span, None).with("address", address));
            return None;
        }
        // Three places behind the point, and whatever is too large for any range: the range check tells it.
        let places = part.bytes().chain(std::iter::repeat(b'0')).take(3);
        let value = whole.bytes().chain(places).fold(0_i64, |value, digit| {
            value.saturating_mul(10).saturating_add(i64::from(digit.wrapping_sub(b'0'))).min(i64::MAX / 4)
        });
        Some((if negative { -value } else { value }, whole.len()))
    }
}

/// Where a number that may begin here ends: a sign, digits, one point; blanks may stand before it.
fn number_end(characters: &[char], mut at: usize) -> usize {
    let begin = at;
    while characters.get(at).is_some_and(|c| c.is_whitespace()) {
        at += 1;
    }
    let number = at;
    if characters.get(at).is_some_and(|c| matches!(c, '+' | '-')) {
        at += 1;
    }
    let mut point = false;
    while let Some(c) = characters.get(at) {
        match c {
            '.' if !point => point = true,
            c if c.is_ascii_digit() => {}
            _ => break,
        }
        at += 1;
    }
    if at == number { begin } else { at }
}

/// The Latin letter that a Cyrillic one looks like.
pub(in crate::program) fn latin(letter: char) -> Option<char> {
    let pairs = "АAВBСCЕEНHІIКKМMОOРPТTХXУYЗ3";
    let found = pairs.chars().collect::<Vec<_>>();
    found.chunks(2).find(|pair| pair[0] == letter).and_then(|pair| pair.get(1).copied())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    fn read(text: &str) -> (Vec<Block>, Vec<Fault>) {
        blocks(text, &Control::read(&shipped::knowledge().unwrap()).unwrap())
    }

    #[test]
    fn a_word_is_an_address_and_a_number_with_its_place() {
        let (blocks, faults) = read("N10 G1 X-1.5Y+.25 F100\n");
        assert!(faults.is_empty(), "{faults:?}");
        assert_eq!(blocks[0].number, Some(10));
        let words: Vec<(char, i64, u32)> =
            blocks[0].words.iter().map(|word| (word.address, word.thousandths, word.span.column)).collect();
        assert_eq!(words, [('G', 1000, 5), ('X', -1500, 8), ('Y', 250, 13), ('F', 100_000, 19)]);
    }

    #[test]
    fn reading_goes_on_behind_a_fault() {
        let (blocks, faults) = read("N1 Х10 X Y0.0001 G1.5 b2 S100000 Y7");
        let codes: Vec<&str> = faults.iter().map(|fault| fault.note.code.as_str()).collect();
        assert_eq!(
            codes,
            [
                "cyrillic-letter",
                "number-missing",
                "number-too-fine",
                "number-not-whole",
                "unknown-character",
                "number-out-of-range"
            ]
        );
        assert_eq!(blocks[0].words.len(), 1);
        assert!(faults.iter().all(|fault| fault.block == Some(1)));
    }
}
