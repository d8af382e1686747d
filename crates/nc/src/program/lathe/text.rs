//! Splits the text of a lathe program into blocks, for the three controls. Words are interpreted elsewhere; a word
//! that cannot be read is reported and skipped.

use super::LatheReader;
use super::expression::{Expression, Reader};
use super::rules::fault;
use crate::program::control_2c42_65::latin;
use crate::program::{Fault, TextSpan};

/// An address with its value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Word {
    /// `X`, `G`, `CR`, `LIMS`.
    pub name: String,
    pub value: Expression,
    /// Whether its number has a point: Fanuc counts one without in other units.
    pub point: bool,
    pub span: TextSpan,
}

/// The addresses of lengths.
pub(super) const LENGTHS: [&str; 10] = ["X", "Z", "U", "W", "I", "K", "R", "C", ",C", ",R"];

impl Word {
    /// Whether it is a length whose number has a point.
    pub fn is_pointed_length(&self) -> bool {
        self.point && matches!(self.value, Expression::Number(_)) && LENGTHS.contains(&self.name.as_str())
    }
}

/// An argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Argument {
    Nothing,
    Text(String),
    Number(Expression),
}

/// What a line says about programs and calls, besides its words.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Head {
    /// `O1234`, `%_N_NAME_SPF`, `PROC NAME`: a program begins.
    Program(String),
    /// `o… sub`.
    Sub(String),
    /// `o… endsub`, `o… return`.
    EndSub(String),
    /// `o… call [1] [2]`.
    Call(String, Vec<Expression>),
    /// `NAME:`.
    Mark(String),
}

/// A line of a program.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Block {
    pub span: TextSpan,
    pub number: Option<u32>,
    pub skipped: bool,
    pub head: Option<Head>,
    pub words: Vec<Word>,
    /// Words without a number: DIAMON, M-less names of subprograms.
    pub names: Vec<(String, TextSpan)>,
    /// `T="NAME"`.
    pub tool: Option<(String, TextSpan)>,
    /// A call with arguments in parentheses: `CYCLE95(…)`.
    pub call: Option<(String, Vec<Argument>, TextSpan)>,
    /// `#5=…`, `R5=…`.
    pub sets: Vec<(String, Expression, TextSpan)>,
}

/// The most blocks that are read.
pub(super) const MOST_BLOCKS: usize = crate::program::iso::MOST_BLOCKS;

/// The blocks of a text and the faults of reading.
pub(super) fn blocks(text: &str, control: LatheReader) -> (Vec<Block>, Vec<Fault>) {
    let (mut blocks, mut faults, mut signs) = (Vec::new(), Vec::new(), 0);
    for (index, line) in text.lines().enumerate() {
        let number = u32::try_from(index + 1).unwrap_or(u32::MAX);
        let trimmed = line.trim();
        if control != LatheReader::Sinumerik && trimmed.starts_with('%') {
            signs += 1;
            if signs == 2 || (signs == 1 && !blocks.is_empty()) {
                break;
            }
            continue;
        }
        if blocks.len() >= MOST_BLOCKS {
            let span = TextSpan { line: number, column: 1, width: 1 };
            faults.push(fault("too-many-blocks", span, None).with("most", MOST_BLOCKS));
            break;
        }
        let mut source = Line { control, line: number, faults: &mut faults };
        blocks.extend(source.block(line));
    }
    (blocks, faults)
}

struct Line<'a> {
    control: LatheReader,
    line: u32,
    faults: &'a mut Vec<Fault>,
}

impl Line<'_> {
    fn span(&self, from: usize, to: usize) -> TextSpan {
        let number = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        TextSpan { line: self.line, column: number(from + 1), width: number(to.saturating_sub(from).max(1)) }
    }

    /// The significant characters: no comments, and spaces only where they end a name.
    fn characters(&mut self, line: &str) -> Vec<(usize, char)> {
        let siemens = self.control == LatheReader::Sinumerik;
        let (mut kept, mut comment, mut quoted) = (Vec::new(), None, false);
        for (column, character) in line.chars().enumerate() {
            match character {
                ')' if comment.is_some() => comment = None,
                _ if comment.is_some() => {}
                '"' if siemens => {
                    quoted = !quoted;
                    kept.push((column, character));
                }
                _ if quoted => kept.push((column, character)),
                ';' => break,
                '(' if !siemens => comment = Some(column),
                c if c.is_whitespace() && !siemens => {}
                c if c.is_whitespace() => kept.push((column, ' ')),
                c => kept.push((column, c.to_ascii_uppercase())),
            }
        }
        if let Some(column) = comment {
            self.faults.push(fault("comment-open", self.span(column, column + 1), None));
        }
        while kept.last().is_some_and(|(_, c)| *c == ' ') {
            kept.pop();
        }
        let blank = kept.iter().take_while(|(_, c)| *c == ' ').count();
        kept.split_off(blank)
    }

    fn block(&mut self, line: &str) -> Option<Block> {
        let before = self.faults.len();
        let characters = self.characters(line);
        let (first, last) = (characters.first()?.0, characters.last()?.0);
        let span = self.span(first, last + 1);
        let (number, skipped, head) = (None, false, None);
        let (words, names, sets) = (vec![], vec![], vec![]);
        let mut block = Block { span, number, skipped, head, words, names, tool: None, call: None, sets };
        let mut at = 0;
        if characters.first().is_some_and(|(_, c)| *c == '/') {
            block.skipped = true;
            at = 1;
        }
        let text: String = characters.iter().map(|(_, c)| *c).collect();
        if self.control == LatheReader::Sinumerik && self.siemens_head(&text, &mut block) {
            return Some(block);
        }
        while let Some(&(column, character)) = characters.get(at) {
            let o_word = character == 'O' && self.control == LatheReader::LinuxCnc;
            at = match character {
                ' ' => at + 1,
                _ if o_word => {
                    self.o_word(&characters, at, &mut block);
                    break;
                }
                ',' if self.is_corner(&characters, at) => self.corner(&characters, at, &mut block),
                '#' => self.set(&characters, at, "#", &mut block),
                'R' if self.is_r_set(&characters, at) => self.set(&characters, at, "R", &mut block),
                c if c.is_ascii_uppercase() => self.word(&characters, at, &mut block),
                c => {
                    let problem = match latin(c) {
                        Some(latin) => fault("cyrillic-letter", self.span(column, column + 1), None)
                            .with("letter", c)
                            .with("latin", latin),
                        None => fault("unknown-character", self.span(column, column + 1), None).with("letter", c),
                    };
                    self.faults.push(problem);
                    // The rest after it is no separate word.
                    characters.iter().skip(at + 1).take_while(|(_, c)| !c.is_ascii_uppercase()).count() + at + 1
                }
            };
        }
        for fault in &mut self.faults[before..] {
            fault.block = block.number;
        }
        Some(block)
    }

    /// `%_N_NAME_MPF`, `PROC NAME`, `NAME:`; true where the line is nothing else.
    fn siemens_head(&mut self, text: &str, block: &mut Block) -> bool {
        if let Some(rest) = text.strip_prefix("%_N_") {
            let name = rest.trim_end_matches("_MPF").trim_end_matches("_SPF");
            block.head = Some(Head::Program(name.to_owned()));
            return true;
        }
        if let Some(rest) = text.strip_prefix("PROC ") {
            let name: String = rest.trim().chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
            block.head = Some(Head::Program(name));
            return true;
        }
        if let Some(name) = text.strip_suffix(':')
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && name.chars().next().is_some_and(|c| c.is_ascii_uppercase())
        {
            block.head = Some(Head::Mark(name.to_owned()));
            return true;
        }
        false
    }

    /// `,C2` and `,R2` of Fanuc.
    fn is_corner(&self, characters: &[(usize, char)], at: usize) -> bool {
        let is_letter = characters.get(at + 1).is_some_and(|(_, c)| matches!(c, 'C' | 'R'));
        self.control == LatheReader::Fanuc && is_letter
    }

    /// A word with its comma; returns where it ends.
    fn corner(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) -> usize {
        let known = block.words.len();
        let end = self.word(characters, at + 1, block);
        if let Some(word) = block.words.get_mut(known) {
            word.name.insert(0, ',');
            word.span.column -= 1;
            word.span.width += 1;
        }
        end
    }

    fn is_r_set(&self, characters: &[(usize, char)], at: usize) -> bool {
        let digits = characters.iter().skip(at + 1).take_while(|(_, c)| c.is_ascii_digit()).count();
        self.control == LatheReader::Sinumerik
            && digits > 0
            && characters.get(at + 1 + digits).is_some_and(|(_, c)| *c == '=')
    }

    /// `#5=…`, `R5=…`; returns where it ends.
    fn set(&mut self, characters: &[(usize, char)], at: usize, sign: &str, block: &mut Block) -> usize {
        let siemens = self.control == LatheReader::Sinumerik;
        let mut reader = Reader::new(characters, at + 1, siemens);
        let name = reader.parameter(sign);
        let equals = characters.get(reader.at).is_some_and(|(_, c)| *c == '=');
        reader.at += 1;
        let value = if equals { reader.sum(0) } else { None };
        let end = reader.at.min(characters.len());
        let column = |at: usize| characters.get(at).map_or(0, |(column, _)| *column);
        let span = self.span(column(at), column(end.saturating_sub(1)) + 1);
        match (name, value) {
            (Some(name), Some(value)) => block.sets.push((name, value, span)),
            _ => {
                self.faults.push(fault("lathe-expression", span, None));
                return characters.len();
            }
        }
        end
    }

    /// A word of one letter or a name; returns where it ends.
    fn word(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) -> usize {
        let siemens = self.control == LatheReader::Sinumerik;
        let column = |at: usize| characters.get(at).map_or(0, |(column, _)| *column);
        let letters = characters.iter().skip(at).take_while(|(_, c)| c.is_ascii_uppercase() || (siemens && *c == '_'));
        let count = if siemens { letters.count() } else { 1 };
        if count > 1 {
            return self.name(characters, at, block);
        }
        let name = characters.get(at).map(|(_, c)| c.to_string()).unwrap_or_default();
        let mut reader = Reader::new(characters, at + 1, siemens);
        let equals = siemens && characters.get(at + 1).is_some_and(|(_, c)| *c == '=');
        if equals && name == "T" && characters.get(at + 2).is_some_and(|(_, c)| *c == '"') {
            return self.tool(characters, at, block);
        }
        let value = if equals {
            reader.at += 1;
            reader.sum(0)
        } else {
            reader.operand(0)
        };
        let end = reader.at.max(at + 1).min(characters.len());
        let span = self.span(column(at), column(end - 1) + 1);
        if characters.get(end).is_some_and(|(_, c)| *c == ',')
            && characters.get(end + 1).is_some_and(|(_, c)| c.is_ascii_digit())
        {
            self.faults.push(fault("lathe-decimal-comma", span, None).with("address", name));
            return end + 1 + characters.iter().skip(end + 1).take_while(|(_, c)| c.is_ascii_digit()).count();
        }
        let Some(value) = value else {
            self.faults.push(fault("number-missing", span, None).with("address", name));
            return end;
        };
        let point = characters.get(at..end).is_some_and(|it| it.iter().any(|(_, c)| matches!(c, '.' | '[' | '#')));
        let whole = |value: &Expression| match value {
            Expression::Number(number) if *number >= 0.0 => Some(*number as u32),
            _ => None,
        };
        match name.as_str() {
            "N" if block.words.is_empty() && block.number.is_none() => block.number = whole(&value),
            "O" if block.words.is_empty() && block.head.is_none() => {
                block.head = Some(Head::Program(whole(&value).unwrap_or_default().to_string()));
            }
            _ => block.words.push(Word { name, value, point, span }),
        }
        end
    }

    /// `T="NAME"`; returns where it ends.
    fn tool(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) -> usize {
        let column = |at: usize| characters.get(at).map_or(0, |(column, _)| *column);
        let name: String = characters.iter().skip(at + 3).take_while(|(_, c)| *c != '"').map(|(_, c)| *c).collect();
        let end = (at + 3 + name.chars().count() + 1).min(characters.len());
        block.tool = Some((name.to_uppercase(), self.span(column(at), column(end - 1) + 1)));
        end
    }

    /// A name of Sinumerik: `CR=5`, `DIAMON`, `CYCLE95(…)`, `MSG("…")`; returns where it ends.
    fn name(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) -> usize {
        let column = |at: usize| characters.get(at).map_or(0, |(column, _)| *column);
        let count = characters.iter().skip(at).take_while(|(_, c)| c.is_ascii_alphanumeric() || *c == '_').count();
        let name: String = characters.iter().skip(at).take(count).map(|(_, c)| *c).collect();
        let mut end = at + count;
        while characters.get(end).is_some_and(|(_, c)| *c == ' ')
            && characters.get(end + 1).is_some_and(|(_, c)| matches!(c, '=' | '('))
        {
            end += 1;
        }
        match characters.get(end).map(|(_, c)| *c) {
            Some('=') => {
                let mut reader = Reader::new(characters, end + 1, true);
                let value = reader.sum(0);
                let end = reader.at.min(characters.len());
                let span = self.span(column(at), column(end.saturating_sub(1)) + 1);
                match value {
                    Some(value) => block.words.push(Word { name, value, point: true, span }),
                    None => self.faults.push(fault("number-missing", span, None).with("address", name)),
                }
                end.max(at + count)
            }
            Some('(') => {
                let (arguments, end) = self.arguments(characters, end + 1);
                let span = self.span(column(at), column(end.saturating_sub(1)) + 1);
                if block.call.replace((name, arguments, span)).is_some() {
                    self.faults.push(fault("lathe-two-calls", span, None));
                }
                end
            }
            _ => {
                let span = self.span(column(at), column(end.saturating_sub(1)) + 1);
                block.names.push((name, span));
                end
            }
        }
    }

    /// The arguments of a call, and where they end.
    fn arguments(&mut self, characters: &[(usize, char)], mut at: usize) -> (Vec<Argument>, usize) {
        let mut arguments = Vec::new();
        loop {
            while characters.get(at).is_some_and(|(_, c)| *c == ' ') {
                at += 1;
            }
            let argument = match characters.get(at).map(|(_, c)| *c) {
                Some(',' | ')') => Argument::Nothing,
                Some('"') => {
                    let text: String =
                        characters.iter().skip(at + 1).take_while(|(_, c)| *c != '"').map(|(_, c)| *c).collect();
                    at += text.chars().count() + 2;
                    Argument::Text(text.to_ascii_uppercase())
                }
                _ => {
                    let mut reader = Reader::new(characters, at, true);
                    let value = reader.sum(0);
                    at = reader.at;
                    value.map_or(Argument::Nothing, Argument::Number)
                }
            };
            arguments.push(argument);
            while characters.get(at).is_some_and(|(_, c)| *c == ' ') {
                at += 1;
            }
            match characters.get(at).map(|(_, c)| *c) {
                Some(',') => at += 1,
                Some(')') => return (arguments, at + 1),
                _ => {
                    let column = characters.get(at.min(characters.len().saturating_sub(1))).map_or(0, |it| it.0);
                    self.faults.push(fault("lathe-call-open", self.span(column, column + 1), None));
                    return (arguments, characters.len());
                }
            }
        }
    }

    /// An o-word of LinuxCNC.
    fn o_word(&mut self, characters: &[(usize, char)], at: usize, block: &mut Block) {
        let text: String = characters.iter().skip(at + 1).map(|(_, c)| *c).collect();
        let (name, rest, skip) = match text.strip_prefix('<').and_then(|text| text.split_once('>')) {
            Some((name, rest)) => (name.to_owned(), rest.to_owned(), name.chars().count() + 2),
            None => {
                let digits: String = text.chars().take_while(char::is_ascii_digit).collect();
                let rest = text.chars().skip(digits.len()).collect();
                (digits.trim_start_matches('0').to_owned(), rest, digits.len())
            }
        };
        block.head = match rest.as_str() {
            _ if name.is_empty() => None,
            "SUB" => Some(Head::Sub(name)),
            "ENDSUB" | "RETURN" => Some(Head::EndSub(name)),
            rest if rest.starts_with("CALL") => {
                let mut reader = Reader::new(characters, at + 1 + skip + 4, false);
                let (mut values, mut good) = (Vec::new(), true);
                while good && reader.at < characters.len() {
                    let value = reader.operand(0);
                    good = value.is_some();
                    values.extend(value);
                }
                good.then_some(Head::Call(name, values))
            }
            _ => None,
        };
        if block.head.is_none() {
            let word = format!("o{}", text.to_ascii_lowercase());
            self.faults.push(fault("unknown-word", block.span, None).with("word", word));
        }
    }
}
