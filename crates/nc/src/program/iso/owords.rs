//! O-words of LinuxCNC: subprograms, branches and loops, and how their lines belong together.

use std::collections::BTreeMap;

use super::rules::fault;
use super::text::{Block, Label};
use crate::program::Fault;
use crate::program::expression::{Expression, Reader};

/// A line of a branch or a loop; `while` also ends a `do`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flow {
    If,
    ElseIf,
    Else,
    EndIf,
    While,
    EndWhile,
    Do,
    Repeat,
    EndRepeat,
    Break,
    Continue,
}

impl Flow {
    /// The keyword, and whether a value follows it.
    const WORDS: [(&'static str, Self, bool); 11] = [
        ("IF", Self::If, true),
        ("ELSEIF", Self::ElseIf, true),
        ("ELSE", Self::Else, false),
        ("ENDIF", Self::EndIf, false),
        ("WHILE", Self::While, true),
        ("ENDWHILE", Self::EndWhile, false),
        ("DO", Self::Do, false),
        ("REPEAT", Self::Repeat, true),
        ("ENDREPEAT", Self::EndRepeat, false),
        ("BREAK", Self::Break, false),
        ("CONTINUE", Self::Continue, false),
    ];

    /// The keyword as people write it.
    pub(super) fn word(self) -> String {
        let known = Self::WORDS.iter().find(|(_, flow, _)| *flow == self);
        known.map_or_else(String::new, |(word, ..)| word.to_ascii_lowercase())
    }
}

/// An o-word: its label and the values behind it.
pub(super) fn label(characters: &[(usize, char)]) -> Option<(Label, Vec<Expression>)> {
    let text: String = characters.iter().skip(1).map(|(_, c)| *c).collect();
    let (name, rest) = match text.strip_prefix('<').and_then(|text| text.split_once('>')) {
        Some((name, rest)) => (name.to_owned(), rest),
        None => {
            let digits = text.chars().take_while(char::is_ascii_digit).count();
            // Digits are one byte each.
            let (number, rest) = text.split_at(digits);
            (number.trim_start_matches('0').to_owned(), rest)
        }
    };
    if name.is_empty() && !text.starts_with('0') {
        return None;
    }
    let letters = rest.chars().take_while(char::is_ascii_uppercase).count();
    let (word, values) = rest.split_at(letters);
    let mut reader = Reader::new(characters, characters.len() - values.chars().count(), false);
    reader.functions = true;
    let mut read = Vec::new();
    while reader.at < characters.len() {
        read.push(reader.operand(0)?);
    }
    let flow = Flow::WORDS.iter().find(|(known, ..)| *known == word);
    let label = match (word, flow, read.len()) {
        ("", _, 0) => Label::Number(name),
        ("SUB", _, 0) => Label::Sub(name),
        ("ENDSUB", _, 0 | 1) => Label::EndSub(name),
        ("RETURN", _, 0 | 1) => Label::Return(name),
        ("CALL", ..) => Label::Call(name),
        (_, Some((_, flow, valued)), count) if count == usize::from(*valued) => Label::Flow(*flow, name),
        _ => return None,
    };
    Some((label, read))
}

/// Where the run goes on from a line of a branch or a loop: places of blocks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Jump {
    /// The line that begins it.
    pub start: usize,
    /// Of `if`, `elseif` and `else`: the next of them, or `endif`.
    pub next: usize,
    /// The line that ends it.
    pub end: usize,
    /// Whether the `while` ends a `do`.
    pub closes: bool,
}

/// A branch or a loop whose end has not been found.
struct Open<'a> {
    flow: Flow,
    name: &'a str,
    start: usize,
    /// Its lines so far.
    lines: Vec<usize>,
}

/// The jumps of every line of a branch or a loop; what has no pair is reported.
pub(super) fn jumps(blocks: &[Block], faults: &mut Vec<Fault>) -> BTreeMap<usize, Jump> {
    let mut jumps = BTreeMap::new();
    let mut open: Vec<Open<'_>> = Vec::new();
    let mut unpaired = |index: usize| {
        let block: &Block = &blocks[index];
        faults.push(fault("sub-without-pair", block.span, block.number));
    };
    for (index, block) in blocks.iter().enumerate() {
        let (flow, name) = match &block.label {
            Some(Label::Flow(flow, name)) => (*flow, name),
            // Nothing of a subprogram is open before it or behind it.
            Some(Label::Sub(_) | Label::EndSub(_)) => {
                open.drain(..).for_each(|one| unpaired(one.start));
                continue;
            }
            _ => continue,
        };
        let top = open.last().filter(|top| top.name == name).map(|top| top.flow);
        match (flow, top) {
            (Flow::While, Some(Flow::Do))
            | (Flow::EndIf, Some(Flow::If))
            | (Flow::EndWhile, Some(Flow::While))
            | (Flow::EndRepeat, Some(Flow::Repeat)) => {
                let Some(mut whole) = open.pop() else { continue };
                whole.lines.push(index);
                let next = whole.lines.iter().skip(1).chain(Some(&index)).copied();
                let branch = |line: usize| !matches!(label_flow(&blocks[line]), Some(Flow::Break | Flow::Continue));
                for (line, next) in whole.lines.iter().copied().zip(next) {
                    let closes = flow == Flow::While && line == index;
                    let next = if branch(line) { next } else { index };
                    jumps.insert(line, Jump { start: whole.start, next, end: index, closes });
                }
            }
            (Flow::If | Flow::While | Flow::Do | Flow::Repeat, _) => {
                open.push(Open { flow, name, start: index, lines: vec![index] });
            }
            (Flow::ElseIf | Flow::Else, Some(Flow::If)) => {
                if let Some(top) = open.last_mut() {
                    top.lines.push(index);
                }
            }
            (Flow::Break | Flow::Continue, _) => {
                // LinuxCNC knows them in `while` and `do` only: in a `repeat` it stops.
                let around = |one: &&mut Open<'_>| one.name == name && matches!(one.flow, Flow::While | Flow::Do);
                match open.iter_mut().rev().find(around) {
                    Some(around) => around.lines.push(index),
                    None => unpaired(index),
                }
            }
            _ => unpaired(index),
        }
    }
    open.iter().for_each(|one| unpaired(one.start));
    jumps
}

fn label_flow(block: &Block) -> Option<Flow> {
    match &block.label {
        Some(Label::Flow(flow, _)) => Some(*flow),
        _ => None,
    }
}
