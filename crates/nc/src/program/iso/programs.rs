//! Subprograms: finds them, and checks that every called one exists.

use std::collections::BTreeMap;
use std::ops::Range;

use super::control::{Action, Characteristic as Q, Control};
use super::owords::{self, Jump};
use super::rules::fault;
use super::text::{Block, Label};
use super::words::{BlockWords, Function};
use crate::program::{Fault, TextSpan};

/// The programs of a text.
#[derive(Clone, Debug, Default)]
pub(super) struct Programs {
    /// The blocks of each subprogram, by its name or number.
    pub named: BTreeMap<String, Range<usize>>,
    /// The blocks of the main program.
    pub main: Range<usize>,
    /// For every `o… sub`, the block after its `o… endsub`, where the main program continues.
    pub passed: BTreeMap<usize, usize>,
    /// Where branches and loops go on, by the places of their lines.
    pub jumps: BTreeMap<usize, Jump>,
}

/// The arguments of a call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Call {
    pub name: String,
    pub repeats: i64,
    pub span: TextSpan,
}

/// Finds the programs and checks every call.
pub(super) fn programs(blocks: &[Block], words: &[BlockWords], control: &Control, faults: &mut Vec<Fault>) -> Programs {
    let mut programs = Programs::default();
    if blocks.is_empty() && faults.is_empty() {
        faults.push(fault("empty-program", TextSpan { line: 1, column: 1, width: 1 }, None));
    }
    let number = |block: &Block| match &block.label {
        Some(Label::Number(name)) => Some(name.clone()),
        _ => None,
    };
    let starts: Vec<usize> = (0..blocks.len()).filter(|&index| number(&blocks[index]).is_some()).collect();
    for (index, &start) in starts.iter().enumerate() {
        let end = starts.get(index + 1).copied().unwrap_or(blocks.len());
        if let Some(name) = number(&blocks[start]) {
            insert_program(&mut programs, name, start..end, blocks, faults);
        }
    }
    // Fanuc runs the first program of the text. In LinuxCNC a number alone does not separate programs: the run
    // continues.
    let second = starts.iter().copied().find(|start| *start > 0);
    programs.main = 0..second.filter(|_| !control.is(Q::OWords)).unwrap_or(blocks.len());
    subs(blocks, &mut programs, faults);
    programs.jumps = owords::jumps(blocks, faults);
    for (block, words) in blocks.iter().zip(words) {
        let Some(call) = call(block, words, control).filter(|call| call.name.starts_with('N')) else { continue };
        let begins = |other: &Block| other.number.is_some_and(|number| local_name(number) == call.name);
        if let Some(start) = blocks.iter().position(begins) {
            let end = starts.iter().copied().find(|next| *next > start).unwrap_or(blocks.len());
            programs.named.entry(call.name).or_insert(start..end);
        }
    }
    // A name that could not be read may be the called one; a number may be that of the call.
    let headless = blocks.iter().any(|block| block.unread && block.words.is_empty() && block.label.is_none());
    for (block, words) in blocks.iter().zip(words) {
        let called = call(block, words, control);
        if let Some(function) = calls(words, control).filter(|_| called.is_none() && !block.unread) {
            faults.push(fault("call-without-number", function.span, block.number));
        }
        // O-words are looked for when the run comes to them.
        if let Some(call) = called.filter(|_| !matches!(block.label, Some(Label::Call(_))))
            && !headless
            && !programs.named.contains_key(&call.name)
        {
            faults.push(fault("subprogram-missing", call.span, block.number).with("number", call.name));
        }
    }
    programs
}

fn insert_program(
    programs: &mut Programs,
    name: String,
    range: Range<usize>,
    blocks: &[Block],
    faults: &mut Vec<Fault>,
) {
    let head = &blocks[range.start];
    if let Some(first) = programs.named.insert(name, range) {
        let line = blocks[first.start].span.line;
        faults.push(fault("program-number-twice", head.span, head.number).with("line", line));
    }
}

/// The subprograms between `o… sub` and `o… endsub`.
fn subs(blocks: &[Block], programs: &mut Programs, faults: &mut Vec<Fault>) {
    let mut open: Option<(usize, &String)> = None;
    for (index, block) in blocks.iter().enumerate() {
        match (&block.label, open) {
            (Some(Label::Sub(name)), None) => open = Some((index, name)),
            (Some(Label::EndSub(name)), Some((start, opened))) if name == opened => {
                programs.passed.insert(start, index + 1);
                insert_program(programs, name.clone(), start + 1..index + 1, blocks, faults);
                open = None;
            }
            // The label of a return is not looked at.
            (Some(Label::Return(_)), Some(_)) => {}
            (Some(Label::Sub(_) | Label::EndSub(_) | Label::Return(_)), _) => {
                faults.push(fault("sub-without-pair", block.span, block.number));
            }
            _ => {}
        }
    }
    if let Some((start, _)) = open {
        let block = &blocks[start];
        faults.push(fault("sub-without-pair", block.span, block.number));
    }
}

/// M98 or M97 of a block.
pub(super) fn calls(words: &BlockWords, control: &Control) -> Option<Function> {
    let call = |function: &&Function| {
        control.m.get(&function.code).is_some_and(|it| matches!(it.action, Action::Call | Action::CallLocal))
    };
    words.m.iter().find(call).copied()
}

/// The name of what M97 calls: the blocks from that number on.
fn local_name(number: impl std::fmt::Display) -> String {
    format!("N{number}")
}

/// What a block calls: `o… call`, or M98 with P and L.
///
/// Of some controls a P of more than four digits has the repeats before the number: `M98 P31001` calls O1001 three times.
pub(super) fn call(block: &Block, words: &BlockWords, control: &Control) -> Option<Call> {
    if let Some(Label::Call(name)) = &block.label {
        return Some(Call { name: name.clone(), repeats: 1, span: block.span });
    }
    let function = calls(words, control)?;
    let local = control.m.get(&function.code).is_some_and(|it| it.action == Action::CallLocal);
    let program = words.get('P')?;
    let number = program.millionths / 1_000_000;
    let times = words.get('L').map(|given| given.millionths / 1_000_000);
    let (number, packed) = if control.is(Q::RepeatsInP) && !local && number > 9999 {
        (number % 10_000, number / 10_000)
    } else {
        (number, 1)
    };
    let name = if local { local_name(number) } else { number.to_string() };
    Some(Call { name, repeats: times.unwrap_or(packed), span: program.span })
}
