//! Splits the text of a program into words and blocks with their places (textbook 3.1 to 3.7). Nothing is interpreted
//! here: `block.rs` does that, and `check.rs` checks what a block may have.
//!
//! Reading recovers from errors: a word that cannot be read is reported and skipped.

use super::control::Control;
use super::rules::fault;
use crate::program::{Fault, TextSpan};

/// An address with its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word {
    /// The letter, or `:`.
    pub address: char,
    /// The number in thousandths.
    pub thousandths: i64,
    /// Digits before the point, as written.
    pub digits: usize,
    /// Its place.
    pub span: TextSpan,
    /// Whether it follows the G function of a cycle and so is a parameter of it (3.12.1).
    pub in_cycle: bool,
    /// Whether it is left out when the operator has switched the block skip on (4.2.4.3).
    pub skipped: bool,
}

impl Word {
    /// The number as a whole number.
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
    pub span: TextSpan,
    /// Its number.
    pub number: Option<u32>,
    /// The number of the program that begins with it.
    pub program: Option<u8>,
    /// Its other words, in the order of the text.
    pub words: Vec<Word>,
    /// Whether a word of it could not be read: a missing word may be that one.
    pub unread: bool,
    /// Whether that is its first word, perhaps its number or that of a program.
    pub headless: bool,
}

/// Every block of the text, and what could not be read.
pub(super) fn blocks(text: &str, control: &Control) -> (Vec<Block>, Vec<Fault>) {
    if text.len() > control.memory_bytes {
        // The rest is not read: thousands of faults for a file that is no program help nobody.
        let whole = TextSpan { line: 1, column: 1, width: 1 };
        let memory = control.memory_bytes;
        return (Vec::new(), vec![fault("memory-full", whole, None).with("bytes", text.len()).with("memory", memory)]);
    }
    let mut faults = Vec::new();
    let mut blocks = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let number = u32::try_from(index + 1).unwrap_or(u32::MAX);
        let mut reader = SourceLine {
            control,
            faults: &mut faults,
            text: line,
            ascii: line.is_ascii(),
            number,
            in_cycle: false,
            skipped: false,
        };
        blocks.extend(reader.block());
    }
    // Reported once: an author who leaves numbers out usually leaves all of them out.
    let mut unnumbered =
        blocks.iter().filter(|block| block.number.is_none() && block.program.is_none() && !block.headless);
    if let Some(first) = unnumbered.next() {
        faults.push(fault("no-block-number", first.span, None).with("count", unnumbered.count() + 1));
    }
    (blocks, faults)
}

/// A line being read; places are counted in bytes and reported in characters.
struct SourceLine<'a> {
    control: &'a Control,
    faults: &'a mut Vec<Fault>,
    text: &'a str,
    /// Whether every character of it is one byte.
    ascii: bool,
    number: u32,
    in_cycle: bool,
    skipped: bool,
}

impl SourceLine<'_> {
    /// The number of characters before a place.
    fn characters(&self, to: usize) -> usize {
        if self.ascii { to } else { self.text[..to].chars().count() }
    }

    fn span(&self, from: usize, to: usize) -> TextSpan {
        let number = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        let (from, to) = (self.characters(from), self.characters(to));
        TextSpan { line: self.number, column: number(from + 1), width: number(to.saturating_sub(from).max(1)) }
    }

    /// One line; none for an empty one and of the sign `%` that begins a tape.
    fn block(&mut self) -> Option<Block> {
        let before = self.faults.len();
        let end = self.text.trim_end().len();
        // Editors may put a byte order mark before the text; it is no part of the program.
        let mark = if self.number == 1 && self.text.starts_with(MARK) { MARK.len_utf8() } else { 0 };
        let content = self.text.get(mark..end)?;
        let first = end - content.trim_start().len();
        if first == end || self.text[first..].starts_with('%') {
            return None;
        }
        let length = self.characters(end);
        let mut block = Block { span: self.span(first, end), ..Block::default() };
        // The end of the block counts as one character (3.4).
        if length + 1 > self.control.block_length {
            self.faults.push(
                fault("block-too-long", block.span, None)
                    .with("length", length + 1)
                    .with("limit", self.control.block_length),
            );
        }
        let mut at = first;
        while let Some(character) = self.text[at..end].chars().next() {
            let behind = at + character.len_utf8();
            if blank(character) {
                at = behind;
            } else if character == '/' {
                self.skipped = true;
                at = behind;
            } else {
                let written = number(&self.text[behind..end]);
                let next = behind + written.len();
                let places = comma_places(&self.text[next..end], written);
                let word = written.trim_start_matches(blank);
                match (places, self.control.addresses.for_address(character)) {
                    (Some(places), Some(known)) => {
                        let span = self.span(at, next + 1 + places.len());
                        self.faults.push(decimal_comma(character, word, places, known.decimal, span, fault));
                        block.unread = true;
                        at = next + 1 + places.len();
                    }
                    _ => {
                        match self.word(character, word, self.span(at, next)) {
                            Some(word) => self.place(word, &mut block),
                            None => {
                                block.unread = true;
                                block.headless |= at == first;
                            }
                        }
                        at = next;
                    }
                }
            }
        }
        for fault in &mut self.faults[before..] {
            fault.block = block.number;
        }
        Some(block)
    }

    /// Stores a word: the numbers of block and program separately, the others in order.
    fn place(&mut self, word: Word, block: &mut Block) {
        match word.address {
            'N' if !word.in_cycle => {
                let number = u32::try_from(word.number()).ok();
                self.once(word, block.number.replace(number.unwrap_or_default()).is_some());
            }
            ':' => {
                self.once(word, block.program.replace(word.code()).is_some());
                if word.digits != 2 {
                    self.faults.push(fault("program-one-digit", word.span, None));
                }
            }
            _ => block.words.push(word),
        }
        if word.address == 'G' && self.control.cycles.contains(word.code()) {
            self.in_cycle = true;
        }
    }

    /// Reports a second number of the block or the program.
    fn once(&mut self, word: Word, again: bool) {
        if again {
            self.faults.push(fault("word-twice", word.span, None).with("address", word.address));
        }
    }

    fn word(&mut self, address: char, written: &str, span: TextSpan) -> Option<Word> {
        let Some(&known) = self.control.addresses.for_address(address) else {
            self.faults.push(match latin(address) {
                Some(latin) => fault("cyrillic-letter", span, None).with("letter", address).with("latin", latin),
                None if address.is_ascii_uppercase() => fault("unknown-address", span, None).with("letter", address),
                None => fault("unknown-character", span, None).with("letter", shown(address)),
            });
            return None;
        };
        let (thousandths, digits) = self.number(written, address, span)?;
        let word = Word { address, thousandths, digits, span, in_cycle: self.in_cycle, skipped: self.skipped };
        if !known.decimal && written.contains('.') && !(address == 'H' && self.in_cycle) {
            self.faults.push(fault("number-not-whole", span, None).with("address", address));
            return None;
        }
        // In a cycle H is a feed (table 3.13).
        let limited = if address == 'H' && self.in_cycle { 'F' } else { address };
        let limits = self.control.addresses.for_address(limited).and_then(|it| it.limits).or_else(|| {
            // U, V and W are in no table of limits: they are lengths like X.
            self.control.addresses.for_address('X').and_then(|it| it.limits).filter(|_| known.length)
        });
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

    /// A number as written: its thousandths, and the number of digits before the point.
    fn number(&mut self, written: &str, address: char, span: TextSpan) -> Option<(i64, usize)> {
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
        // Three decimal places; a number too large for any range is reported by the range check.
        let places = part.bytes().chain(std::iter::repeat(b'0')).take(3);
        let value = whole.bytes().chain(places).fold(0_i64, |value, digit| {
            value.saturating_mul(10).saturating_add(i64::from(digit.wrapping_sub(b'0'))).min(i64::MAX / 4)
        });
        Some((if negative { -value } else { value }, whole.len()))
    }
}

/// The digits after a decimal comma that follows a number without a point.
pub(in crate::program) fn comma_places<'t>(behind: &'t str, number: &str) -> Option<&'t str> {
    let rest = behind.strip_prefix(',').filter(|_| !number.contains('.'))?;
    let end = rest.find(|sign: char| !sign.is_ascii_digit()).unwrap_or(rest.len());
    rest.get(..end).filter(|places| !places.is_empty())
}

/// A number with a decimal comma. Without the comma it would be another number, at least ten times as large, so the
/// message shows the whole corrected number.
pub(in crate::program) fn decimal_comma(
    address: char,
    number: &str,
    places: &str,
    decimal: bool,
    span: TextSpan,
    fault: impl Fn(&'static str, TextSpan, Option<u32>) -> Fault,
) -> Fault {
    if !decimal {
        return fault("number-not-whole", span, None).with("address", address);
    }
    let written = |sign: char| format!("{address}{number}{sign}{places}");
    fault("comma-for-point", span, None).with("written", written(',')).with("meant", written('.'))
}

/// The byte order mark at the beginning of a file.
const MARK: char = '\u{feff}';

/// Whether a character only separates words. A line end that is none here, such as a carriage return inside a line,
/// does not: two blocks would be joined unnoticed.
fn blank(c: char) -> bool {
    c.is_whitespace() && (c == '\t' || !c.is_control())
}

/// A character as a message shows it: by its code where it may be invisible or look like another.
fn shown(c: char) -> String {
    if c.is_ascii_graphic() || c.is_alphanumeric() { c.to_string() } else { format!("U+{:04X}", u32::from(c)) }
}

/// The number that may begin here: a sign, digits, one point; blanks before it are part of it.
fn number(text: &str) -> &str {
    let unsigned = text.trim_start_matches(blank);
    let begin = text.len() - unsigned.len();
    let mut end = begin + usize::from(unsigned.starts_with(['+', '-']));
    let mut point = false;
    for byte in text[end..].bytes() {
        match byte {
            b'.' if !point => point = true,
            b'0'..=b'9' => {}
            _ => break,
        }
        end += 1;
    }
    if end == begin { "" } else { &text[..end] }
}

/// The Latin letter that looks like a Cyrillic one.
pub(in crate::program) fn latin(letter: char) -> Option<char> {
    let pairs = "АAВBСCЕEНHІIЈJКKМMОOРPЅSТTХXУYЗ3";
    let found = pairs.chars().collect::<Vec<_>>();
    found.chunks(2).find(|pair| pair[0] == letter).and_then(|pair| pair.get(1).copied())
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
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

    /// What a text without any word of its own says, and how.
    #[test]
    fn characters_that_do_not_show_are_named_and_a_mark_of_encoding_is_none() {
        let faults_of = |text: &str| -> Vec<(String, u32)> {
            let figure = |fault: &Fault| {
                fault.note.figures().next().map(|(_, value)| value.text().into_owned()).unwrap_or_default()
            };
            read(text).1.iter().map(|fault| (format!("{} {}", fault.code, figure(fault)), fault.span.column)).collect()
        };
        assert_eq!(faults_of("\u{feff}%\r\nN1 X1\r\n"), []);
        assert_eq!(read("\u{feff}N1 X1").0[0].words[0].span.column, 5);
        for (text, says, column) in [
            ("N1 X1\0", "unknown-character U+0000", 6),
            ("N1 X1\n\u{feff}N2 X1", "unknown-character U+FEFF", 1),
            ("N1 X1\rX2", "unknown-character U+000D", 6),
            ("N1 X1,5", "comma-for-point X1.5", 4),
            ("N1 X-,5Y1", "comma-for-point X-.5", 4),
            ("N1 X1.5,5", "unknown-character ,", 8),
            ("N1 X1, Y5", "unknown-character ,", 6),
            ("N1 S800,5", "number-not-whole S", 4),
            ("N1 У5", "cyrillic-letter Y", 4),
            ("N1 N2 X1", "word-twice N", 4),
            (":01 :02", "word-twice :", 5),
            (":-01", "number-out-of-range :", 1),
        ] {
            assert!(faults_of(text).contains(&(says.to_owned(), column)), "{text:?}: {:?}", faults_of(text));
        }
    }

    #[test]
    fn reading_goes_on_behind_a_fault() {
        let (blocks, faults) = read("N1 Х10 X Y0.0001 G1.5 b2 S100000 Y7");
        let codes: Vec<&str> = faults.iter().map(|fault| fault.note.code()).collect();
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
