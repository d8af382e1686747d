//! Splits the text of a program into words and blocks with their places. Nothing is interpreted here. Reading
//! recovers from errors: a word that cannot be read is reported and skipped.

use super::control::{ActiveComment, Characteristic as Q, CommentAct, Control, Written};
use super::owords::{self, Flow};
use super::rules::{fault, word_fault};
use crate::program::control_2c42_65::{comma_places, decimal_comma, latin};
use crate::program::expression::{Expression, Reader};
use crate::program::setting::DecimalInput;
use crate::program::{Fault, TextSpan};
use crate::units::Micrometres;

/// An address with its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word {
    pub address: char,
    /// The number in millionths: fine enough for inches.
    pub millionths: i64,
    /// Whether it counts least increments, because it has no point and the control is set so.
    pub increments: bool,
    /// Whether it is written with a point.
    pub point: bool,
    pub span: TextSpan,
}

/// The label of a line: what it says about subprograms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Label {
    /// A number that begins a program: `O1001`.
    Number(String),
    /// `o… sub`.
    Sub(String),
    /// `o… endsub`.
    EndSub(String),
    /// `o… return`.
    Return(String),
    /// `o… call`.
    Call(String),
    /// A line of a branch or a loop.
    Flow(Flow, String),
}

/// A line of the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Block {
    /// The whole of it.
    pub span: TextSpan,
    /// Its number.
    pub number: Option<u32>,
    /// Whether it begins with `/`.
    pub skipped: bool,
    pub label: Option<Label>,
    /// Its other words, in the order of the text.
    pub words: Vec<Word>,
    /// Whether a word of it could not be read: a missing word may be that one.
    pub unread: bool,
    /// Words whose numbers depend on parameters, known when the block is run.
    pub expressions: Vec<(char, Expression, TextSpan)>,
    /// Parameters that it sets.
    pub sets: Vec<(Expression, Expression)>,
    /// What stands behind an o-word: handed to a called subprogram (`o100 call [1] [2]`), or decided by, or given back.
    pub arguments: Vec<Expression>,
}

/// The most blocks of a program: a check of so many takes a second and a third of a gigabyte.
pub const MOST_BLOCKS: usize = 200_000;

/// All blocks of the text, whether a second `%` closes it, and the faults of reading.
pub(super) fn blocks(text: &str, control: &Control, decimal: Option<DecimalInput>) -> (Vec<Block>, bool, Vec<Fault>) {
    let mut points = Points::new(decimal);
    let (blocks, closed, mut faults) = blocks_within(MOST_BLOCKS, text, control, &mut points);
    if control.is(Q::DecimalOfSetting) {
        faults.extend(points.fault());
    }
    (blocks, closed, faults)
}

/// Lengths with and without a decimal point, of a program whose control is set to count them.
struct Points {
    /// What a length without a point counts, where the owner of the control has said so.
    decimal: Option<DecimalInput>,
    /// The first length without one: its address, place and block.
    pointless: Option<(char, TextSpan, Option<u32>)>,
    /// Whether some length has one.
    pointed: bool,
}

impl Points {
    const fn new(decimal: Option<DecimalInput>) -> Self {
        Self { decimal, pointless: None, pointed: false }
    }

    /// A program that writes points has forgotten one, and the axis goes a thousandth of the way, or a thousand times
    /// as far. One without points counts as its control is set, which is not known unless the setting says so.
    fn fault(self) -> Option<Fault> {
        let (address, span, block) = self.pointless?;
        let code = match self.decimal {
            Some(DecimalInput::Calculator) => return None,
            _ if self.pointed => "point-missing",
            Some(DecimalInput::Increment) => return None,
            None => "number-without-point",
        };
        Some(fault(code, span, block).with("address", address))
    }
}

fn blocks_within(most: usize, text: &str, control: &Control, points: &mut Points) -> (Vec<Block>, bool, Vec<Fault>) {
    let mut faults = Vec::new();
    let mut blocks = Vec::new();
    let mut opened = false;
    let leads = control.is(Q::ReadsFromSign);
    let sign = |line: &str| control.is(Q::Signs) && line.trim_start().starts_with('%');
    let signs = text.lines().filter(|line| sign(line)).take(2).count();
    let leader = text.lines().position(sign).filter(|_| leads && signs == 2).unwrap_or_default();
    for (index, line) in text.lines().enumerate().skip(leader) {
        let line_number = u32::try_from(index + 1).unwrap_or(u32::MAX);
        if sign(line) {
            if opened || (leads && !blocks.is_empty()) {
                return (blocks, true, faults);
            }
            if blocks.is_empty() {
                opened = true;
                continue;
            }
        }
        let mut reader = SourceLine { control, faults: &mut faults, line: line_number, points };
        let block = reader.block(line);
        if let Some(beyond) = block.as_ref().filter(|_| blocks.len() == most) {
            faults.push(fault("too-many-blocks", beyond.span, beyond.number).with("most", most));
            return (blocks, false, faults);
        }
        blocks.extend(block);
    }
    (blocks, false, faults)
}

/// What a stretch of a line is that may depend on parameters.
enum Calculated {
    /// A plain word.
    Not,
    /// It was read up to here.
    To(usize),
    /// The rest of the line is not read.
    Unread,
}

/// The address of what could not be read and whose value is not known therefore.
pub(super) const UNREAD: char = '#';

/// What decides which blocks are run in macros of Fanuc.
const MACRO_WORDS: [&str; 5] = ["IF", "WHILE", "GOTO", "DO", "END"];

/// The letters of the longest name of a macro word or function.
const LONGEST_NAME: usize = 6;

struct SourceLine<'a> {
    control: &'a Control,
    faults: &'a mut Vec<Fault>,
    line: u32,
    points: &'a mut Points,
}

impl SourceLine<'_> {
    fn span(&self, from: usize, to: usize) -> TextSpan {
        let number = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        TextSpan { line: self.line, column: number(from + 1), width: number(to.saturating_sub(from).max(1)) }
    }

    /// One line; none if it is empty or only a comment.
    fn block(&mut self, line: &str) -> Option<Block> {
        let before = self.faults.len();
        let characters = self.characters(line);
        let (first, last) = (characters.first()?.0, characters.last()?.0);
        let mut block = Block { span: self.span(first, last + 1), ..Block::default() };
        let mut at = 0;
        if characters.first().is_some_and(|(_, c)| *c == '/') {
            block.skipped = true;
            at = 1;
            // The number of the switch: there is one switch here.
            while self.control.is(Q::SkipNumbers) && characters.get(at).is_some_and(|(_, c)| c.is_ascii_digit()) {
                at += 1;
            }
        }
        while let Some(&(column, character)) = characters.get(at) {
            if let Some(end) = self.program_name(&characters, at, &mut block) {
                at = end;
                continue;
            }
            if let Some(end) = self.called_name(&characters, at, &mut block) {
                at = end;
                continue;
            }
            if character == 'O' && self.control.is(Q::OWords) && block.words.is_empty() {
                self.label(&characters[at..], &mut block);
                break;
            }
            match self.calculated(&characters, at, &mut block) {
                Calculated::To(end) => {
                    at = end;
                    continue;
                }
                Calculated::Unread => break,
                Calculated::Not => {}
            }
            let end = number_end(&characters, at + 1);
            let until = characters.get(end - 1).map_or(column, |(column, _)| *column) + 1;
            let written: String = characters[at + 1..end].iter().map(|(_, c)| *c).collect();
            let comma = characters[end..].iter().map(|(_, c)| *c).enumerate();
            let comma = comma.take_while(|(at, c)| if *at == 0 { *c == ',' } else { c.is_ascii_digit() });
            let behind: String = comma.map(|(_, c)| c).collect();
            if let (Some(places), Some(known)) =
                (comma_places(&behind, &written), self.control.addresses.get(&character))
            {
                at = end + 1 + places.len();
                let until = characters.get(at - 1).map_or(until, |(column, _)| *column + 1);
                let (decimal, span) = (*known != Written::Whole, self.span(column, until));
                self.faults.push(decimal_comma(character, &written, places, decimal, span, fault));
                block.unread = true;
                continue;
            }
            let word = self.word(character, &written, self.span(column, until), &block);
            block.unread |= word.is_none();
            if let Some(word) = word {
                match character {
                    'N' if block.number.is_none() && block.words.is_empty() => {
                        block.number = u32::try_from(word.millionths / 1_000_000).ok();
                    }
                    'N' => self.faults.push(fault("word-twice", word.span, None).with("address", 'N')),
                    'O' if block.words.is_empty() && block.label.is_none() => {
                        block.label = Some(Label::Number((word.millionths / 1_000_000).to_string()));
                    }
                    'O' => self.faults.push(fault("unknown-word", word.span, None).with("word", "O")),
                    _ => block.words.push(word),
                }
            }
            at = end;
        }
        for fault in &mut self.faults[before..] {
            fault.block = block.number;
        }
        if let Some((_, _, number)) = self.points.pointless.as_mut().filter(|(_, span, _)| span.line == self.line) {
            *number = block.number;
        }
        Some(block)
    }

    /// The significant characters with their columns: without blanks and comments, with small letters as capitals
    /// where the control permits them.
    fn characters(&mut self, line: &str) -> Vec<(usize, char)> {
        let mut kept = Vec::new();
        let small = self.control.is(Q::WordsInSmallLetters);
        let mut comment = None;
        let mut text = String::new();
        for (column, character) in line.chars().enumerate() {
            match (comment, character) {
                (Some(from), ')') => {
                    self.active_comment(&text, false, from, column + 1);
                    comment = None;
                }
                (Some(_), character) => text.push(character),
                (None, '(') => {
                    comment = Some(column);
                    text.clear();
                }
                (None, ';') => {
                    let text: String = line.chars().skip(column + 1).collect();
                    self.active_comment(&text, true, column, line.chars().count());
                    break;
                }
                (None, c) if c.is_whitespace() => {}
                (None, c) if small => kept.push((column, c.to_ascii_uppercase())),
                (None, c) => kept.push((column, c)),
            }
        }
        if let Some(column) = comment {
            self.faults.push(fault("comment-open", self.span(column, column + 1), None));
        }
        kept
    }

    /// A comment that the control carries out.
    fn active_comment(&mut self, text: &str, after_semicolon: bool, from: usize, to: usize) {
        let text = text.trim_start().to_ascii_uppercase();
        let acts = |one: &&ActiveComment| {
            let rest = text.strip_prefix(&one.begins);
            (one.after_semicolon || !after_semicolon)
                && rest.is_some_and(|rest| rest.is_empty() || !one.nothing_follows)
        };
        let Some(active) = self.control.active_comments.iter().find(acts) else { return };
        let code = if active.act == CommentAct::Shows { "message-comment" } else { "active-comment" };
        let begins = active.begins.trim_end_matches(',').to_owned();
        self.faults.push(word_fault(code, self.span(from, to), None, begins));
    }

    /// A program name in place of a number, `O<PLATE>`, of controls without o-words; where it ends.
    fn program_name(&self, characters: &[(usize, char)], at: usize, block: &mut Block) -> Option<usize> {
        let first = block.words.is_empty() && block.label.is_none() && !self.control.is(Q::OWords);
        let named = matches!(characters.get(at..at + 2), Some([(_, 'O'), (_, '<')]));
        let name = characters.get(at + 2..).filter(|_| first && named)?;
        let length = name.iter().position(|(_, c)| *c == '>').filter(|length| *length > 0)?;
        block.label = Some(Label::Number(name.iter().take(length).map(|(_, c)| *c).collect()));
        Some(at + length + 3)
    }

    /// A name in place of the number of a call, `M98 <PLATE>`: which program it is nobody looks up here. Where it ends.
    fn called_name(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) -> Option<usize> {
        let called = block.words.iter().any(|word| word.address == 'M') && self.control.is(Q::MacroWords);
        let rest = characters.get(at..).filter(|rest| called && rest.first().is_some_and(|(_, c)| *c == '<'))?;
        let length = rest.iter().position(|(_, c)| *c == '>')?;
        let name: String = rest[..=length].iter().map(|(_, c)| *c).collect();
        let span = self.span(rest[0].0, rest[length].0 + 1);
        self.faults.push(word_fault("not-carried-out", span, None, name));
        block.unread = true;
        Some(at + length + 1)
    }

    /// An o-word of LinuxCNC: its name or number, then its keyword.
    fn label(&mut self, characters: &[(usize, char)], block: &mut Block) {
        match owords::label(characters) {
            Some((label, values)) => (block.label, block.arguments) = (Some(label), values),
            None => {
                let text: String = characters.iter().map(|(_, c)| c.to_ascii_lowercase()).collect();
                self.faults.push(fault("unknown-word", block.span, None).with("word", text));
            }
        }
    }

    /// What depends on parameters: `#1=2`, `X#1`, `X[#1+2]`, or a word of a macro, `IF [#1 GT 0] GOTO 10`.
    fn calculated(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) -> Calculated {
        let fanuc = self.control.is(Q::MacroWords);
        let here = characters.get(at).map_or(0, |(column, _)| *column);
        // No more is looked at than a function has letters and a number signs, so that long lines are read once.
        let near: String = characters[at..].iter().take(LONGEST_NAME + 2).map(|(_, c)| *c).collect();
        let numbered = |word: &&&str| {
            let behind = near.strip_prefix(**word).and_then(|behind| behind.chars().next());
            behind.is_some_and(|c| c.is_ascii_digit() || matches!(c, '[' | '#'))
        };
        if let Some(word) = MACRO_WORDS.iter().find(numbered).filter(|_| fanuc) {
            self.faults.push(word_fault("macro-not-run", self.span(here, here + word.len()), None, *word));
            block.unread = true;
            return Calculated::Unread;
        }
        let sets = near.starts_with('#');
        let sign = usize::from(!sets);
        let behind = &near[near.chars().take(sign).map(char::len_utf8).sum::<usize>()..];
        let behind = behind.trim_start_matches(['+', '-']);
        let first = behind.chars().next();
        let letters = behind.chars().take_while(char::is_ascii_uppercase).count();
        let function = !sets && letters > 1 && behind[letters..].starts_with('[') && !near.starts_with('O');
        if !sets && !function && !matches!(first, Some('#' | '[')) {
            return Calculated::Not;
        }
        let mut reader = Reader::new(characters, at + sign, false);
        reader.functions = true;
        let read = reader.operand(0).and_then(|first| match sets {
            false => Some((first, None)),
            true if characters.get(reader.at).is_some_and(|(_, c)| *c == '=') => {
                reader.at += 1;
                // LinuxCNC writes sums in brackets, Fanuc does not.
                let value = if fanuc { reader.sum(0) } else { reader.operand(0) };
                value.map(|value| (first, Some(value)))
            }
            true => None,
        });
        let until = characters.get(reader.at.max(at + 1) - 1).map_or(here, |(column, _)| *column) + 1;
        let span = self.span(here, until);
        let Some((first, value)) = read else { return self.unread("#".to_owned(), span, block) };
        // What rounds below 0 another way gives a number that is not known; the rest of the line is.
        let written: String = characters[at..reader.at].iter().map(|(_, c)| *c).collect();
        let rounding = self.control.rounds_unlike.iter().any(|function| written.contains(function));
        if rounding {
            self.unread("#".to_owned(), span, block);
        }
        match value {
            Some(value) => block.sets.push((first, if rounding { Expression::unread() } else { value })),
            None if rounding => {}
            None => {
                let address = characters.get(at).map_or(' ', |(_, c)| *c);
                if !self.control.knows_address(address) {
                    self.faults.push(fault("unknown-word", span, None).with("word", address));
                }
                block.expressions.push((address, first, span));
                block.unread = true;
            }
        }
        Calculated::To(reader.at)
    }

    /// Says that something of a line is not carried out, and that the block lacks a value therefore.
    fn unread(&mut self, word: String, span: TextSpan, block: &mut Block) -> Calculated {
        self.faults.push(word_fault("not-carried-out", span, None, word));
        block.expressions.push((UNREAD, Expression::unread(), span));
        Calculated::Unread
    }

    /// Whether a word belongs to a function that changes no motion, and is no length therefore: `G5.1 Q1`.
    fn of_harmless(&self, address: char, block: &Block) -> bool {
        block.words.iter().any(|word| {
            let passed = match word.address {
                'G' if word.millionths % 100_000 == 0 => self.control.passed_g.get(&(word.millionths / 100_000)),
                'M' => self.control.passed_m.get(&(word.millionths / 1_000_000)),
                _ => None,
            };
            passed.is_some_and(|passed| passed.harmless && passed.takes.contains(&address))
        })
    }

    fn word(&mut self, address: char, written: &str, span: TextSpan, block: &Block) -> Option<Word> {
        if let Some(latin) = latin(address) {
            self.faults.push(fault("cyrillic-letter", span, None).with("letter", address).with("latin", latin));
            return None;
        }
        let known = self.control.addresses.get(&address).copied();
        let known = known.or_else(|| self.control.knows_address(address).then_some(Written::Number));
        let Some(known) = known else {
            let problem = if address.is_ascii_uppercase() {
                fault("unknown-word", span, None).with("word", format!("{address}{written}"))
            } else {
                fault("unknown-character", span, None).with("letter", address)
            };
            self.faults.push(problem);
            return None;
        };
        let millionths = self.number(written, address, span)?;
        // rs274 takes `N10.5`.
        let counted = address == 'N' && self.control.is(Q::OWords);
        if known == Written::Whole && millionths % 1_000_000 != 0 && !counted {
            self.faults.push(fault("number-not-whole", span, None).with("address", address));
            return None;
        }
        // How far a further axis turns nobody here knows.
        let (low, high) = limits(address, known);
        if !self.control.passes_address(address) && !(low..=high).contains(&millionths) {
            let shown = |value: i64| Micrometres::new(value / 1000);
            let problem = fault("number-out-of-range", span, None).with("address", address);
            self.faults.push(problem.with("low", shown(low)).with("high", shown(high)));
            return None;
        }
        // K may be a number of repeats, and 0 is 0 in every unit.
        let length = known == Written::Length && !matches!(address, 'K' | 'F') && millionths != 0;
        let length = length && !self.of_harmless(address, block);
        // A peck is never so long: without a point it counts increments, as the control always reads it.
        let peck = length && address == 'Q' && !written.contains('.') && self.control.is(Q::DecimalOfSetting);
        let peck = peck && self.points.decimal.is_none() && millionths >= self.control.habits.peck_most();
        if peck {
            self.faults
                .push(fault("peck-in-increments", span, None).with("step", Micrometres::new(millionths / 1_000_000)));
            return Some(Word { address, millionths, increments: true, point: false, span });
        }
        let pointless = length && !written.contains('.');
        self.points.pointed |= length && !pointless;
        if pointless {
            self.points.pointless.get_or_insert((address, span, None));
        }
        // K may be a length, too: which it is the block decides.
        let increments = known == Written::Length && address != 'F' && !written.contains('.');
        let increments = increments && self.points.decimal == Some(DecimalInput::Increment);
        Some(Word { address, millionths, increments, point: written.contains('.'), span })
    }

    /// A number as written, in millionths.
    fn number(&mut self, written: &str, address: char, span: TextSpan) -> Option<i64> {
        let unsigned = written.trim_start_matches(['+', '-']);
        let (whole, part) = unsigned.split_once('.').unwrap_or((unsigned, ""));
        let code = if whole.is_empty() && part.is_empty() {
            "number-missing"
        } else if part.trim_end_matches('0').len() > 6 {
            "number-too-long"
        } else {
            ""
        };
        if !code.is_empty() {
            self.faults.push(fault(code, span, None).with("address", address));
            return None;
        }
        let places = part.bytes().chain(std::iter::repeat(b'0')).take(6);
        let value = whole.bytes().chain(places).fold(0_i64, |value, digit| {
            value.saturating_mul(10).saturating_add(i64::from(digit.wrapping_sub(b'0'))).min(i64::MAX / 4)
        });
        Some(if written.starts_with('-') { -value } else { value })
    }
}

/// Least and greatest number of an address, in millionths: wide enough for every machine, and narrow enough that no
/// sum overflows. Only positions, distances, angles and the radius of an arc may be negative.
const fn limits(address: char, written: Written) -> (i64, i64) {
    const MANY: i64 = 99_999_999_999;
    match address {
        // A call of Fanuc has eight digits.
        'P' => (0, 99_999_999_000_000),
        'F' => (0, MANY),
        '^' => (-MANY, MANY),
        _ if matches!(written, Written::Length) => (-MANY, MANY),
        _ => (0, MANY),
    }
}

/// The end of a number that may begin here: a sign, digits, one point.
fn number_end(characters: &[(usize, char)], mut at: usize) -> usize {
    if characters.get(at).is_some_and(|(_, c)| matches!(c, '+' | '-')) {
        at += 1;
    }
    let mut point = false;
    while let Some((_, c)) = characters.get(at) {
        match c {
            '.' if !point => point = true,
            c if c.is_ascii_digit() => {}
            _ => break,
        }
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_blocks_than_the_bound_are_refused_at_the_first_of_them() {
        let knowledge = crate::shipped::knowledge().unwrap();
        for control in ["linuxcnc", "fanuc"] {
            let control = Control::read(control, &knowledge).unwrap();
            let text = "G21\n\n(nothing)\nN7 M30\n";
            assert_eq!(blocks_within(2, text, &control, &mut Points::new(None)).2, []);
            let (blocks, _, faults) = blocks_within(1, text, &control, &mut Points::new(None));
            assert_eq!((blocks.len(), faults.len()), (1, 1));
            assert_eq!((faults[0].code, faults[0].span.line, faults[0].block), ("too-many-blocks", 4, Some(7)));
            assert!(faults[0].is_error(), "nothing is run");
        }
    }
}
