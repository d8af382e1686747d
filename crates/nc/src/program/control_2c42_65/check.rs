//! Checks of a program without running it: programs and their numbers, and the words a block may have. Every block is
//! checked, also those that no call reaches.

use std::collections::BTreeMap;
use std::ops::Range;

use super::control::{Action, Control, GROUPS};
use super::rules::fault;
use super::state::RADIUS;
use super::text::{Block, Word};
use super::words::letter;
use crate::program::{Fault, Subject, TextSpan};

/// The programs of a text.
#[derive(Clone, Debug, Default)]
pub(super) struct Programs {
    /// The blocks of each, by its number.
    pub numbered: BTreeMap<u8, Range<usize>>,
    /// The blocks of the main program.
    pub main: Range<usize>,
}

/// Finds the programs. The main program is the first that ends with M02 or M30 (3.6); blocks before the first number
/// are a program without number.
pub(super) fn programs(blocks: &[Block], control: &Control, faults: &mut Vec<Fault>) -> Programs {
    let mut starts: Vec<usize> = (0..blocks.len()).filter(|&index| blocks[index].program.is_some()).collect();
    if starts.first() != Some(&0) && !blocks.is_empty() {
        starts.insert(0, 0);
    }
    if blocks.is_empty() && faults.is_empty() {
        faults.push(fault("empty-program", TextSpan { line: 1, column: 1, width: 1 }, None));
    }
    let mut programs = Programs::default();
    let mut main = None;
    for (index, &start) in starts.iter().enumerate() {
        let range = start..starts.get(index + 1).copied().unwrap_or(blocks.len());
        let head = &blocks[start];
        let ends = |wanted: &[Action]| {
            blocks[range.clone()].iter().flat_map(functions).any(|word| {
                control.m_functions.get(word.code()).is_some_and(|function| wanted.contains(&function.action))
            })
        };
        if main.is_none() && ends(&[Action::End]) {
            main = Some(range.clone());
        } else if !ends(&[Action::End, Action::Return]) && !blocks[range.clone()].iter().any(|block| block.unread) {
            // A word that could not be read may be the end.
            faults.push(fault("program-without-end", head.span, head.number));
        }
        gaps(&blocks[range.clone()], faults);
        if let Some(number) = head.program
            && let Some(first) = programs.numbered.insert(number, range)
        {
            let line = blocks[first.start].span.line;
            faults.push(fault("program-number-twice", head.span, head.number).with("line", line));
        }
    }
    if starts.len() > control.programs {
        let last = blocks.last().map(|block| block.span).unwrap_or_default();
        faults.push(fault("too-many-programs", last, None).with("count", starts.len()).with("limit", control.programs));
    }
    programs.main = main.unwrap_or(0..starts.get(1).copied().unwrap_or(blocks.len()));
    programs
}

/// Reports missing block numbers in a program with otherwise equal steps: a block may have been lost there.
fn gaps(blocks: &[Block], faults: &mut Vec<Fault>) {
    // The number that could not be read is the missing one.
    if blocks.iter().any(|block| block.headless) {
        return;
    }
    let numbered: Vec<(u32, TextSpan)> = blocks.iter().filter_map(|block| Some((block.number?, block.span))).collect();
    let step_of = |pair: &[(u32, TextSpan)]| pair[1].0.saturating_sub(pair[0].0);
    let mut steps: BTreeMap<u32, usize> = BTreeMap::new();
    for pair in numbered.windows(2) {
        *steps.entry(step_of(pair)).or_default() += 1;
    }
    let Some((&step, &often)) = steps.iter().max_by_key(|(_, often)| **often) else { return };
    // Nine in ten steps are equal, and there are more than a few: otherwise the numbers follow no rule.
    if step == 0 || often < 10 || often * 10 < (numbered.len() - 1) * 9 {
        return;
    }
    for pair in numbered.windows(2) {
        let wide = step_of(pair);
        if wide > step && wide % step == 0 {
            let ((before, _), (after, span)) = (pair[0], pair[1]);
            let (first, last) = (before + step, after - step);
            let missing = if first == last { format!("N{first}") } else { format!("N{first} … N{last}") };
            faults.push(
                fault("block-number-gap", span, Some(after))
                    .with("before", format!("N{before}"))
                    .with("missing", missing)
                    .with("step", step),
            );
        }
    }
}

/// The M functions of a block, without parameters of a cycle.
fn functions(block: &Block) -> impl Iterator<Item = &Word> {
    block.words.iter().filter(|word| word.address == 'M' && !word.in_cycle)
}

/// Checks every block against the rules on what may be combined.
pub(super) fn blocks(blocks: &[Block], programs: &Programs, control: &Control, faults: &mut Vec<Fault>) {
    // A program number that could not be read may be the called one.
    let headless = blocks.iter().any(|block| block.headless);
    for block in blocks {
        let before = faults.len();
        words(block, control, faults);
        m_functions(block, control, faults);
        groups(block, control, faults);
        calls(block, programs, headless, faults);
        for fault in &mut faults[before..] {
            fault.block = block.number;
        }
    }
}

fn words(block: &Block, control: &Control, faults: &mut Vec<Fault>) {
    // A bit for every letter; separate bits for letters after a cycle.
    let mut seen = [0_u32; 2];
    let cycle = block.words.iter().find(|word| word.address == 'G' && control.cycles.contains(word.code()));
    for word in &block.words {
        let many = matches!(word.address, 'G' | 'M') && !word.in_cycle;
        let (seen, bit) = (&mut seen[usize::from(word.in_cycle)], 1 << letter(word.address));
        if !many && *seen & bit != 0 {
            faults.push(fault("word-twice", word.span, None).with("address", word.address));
        }
        *seen |= bit;
        match (word.address, cycle) {
            (address, Some(cycle)) if word.in_cycle => {
                let known = control.cycles.get(cycle.code());
                if !known.is_some_and(|it| it.required.contains(&address) || it.optional.contains(&address)) {
                    faults.push(
                        fault("word-after-cycle", word.span, None).with("address", address).with("cycle", cycle.code()),
                    );
                }
            }
            ('U' | 'V' | 'W', _) => {
                faults.push(fault("parameter-outside-cycle", word.span, None).with("address", word.address));
            }
            // The machines of this control in the catalog have three axes (3.8.1).
            ('A' | 'B' | 'C', _) => {
                faults.push(fault("fourth-axis", word.span, None).with("address", word.address));
            }
            _ => {}
        }
    }
}

/// 3.13.3, notes 1 and 2, and 3.14.2, note 5.
fn m_functions(block: &Block, control: &Control, faults: &mut Vec<Fault>) {
    let count = functions(block).count();
    if let Some(sixth) = functions(block).nth(control.m_per_block) {
        faults.push(fault("too-many-m", sixth.span, None).with("count", count).with("limit", control.m_per_block));
    }
    let mut exclusive: Option<&Word> = None;
    let mut spindle: Option<&Word> = None;
    for word in functions(block) {
        let Some(function) = control.m_functions.get(word.code()) else {
            let name = format!("M{:02}", word.code());
            let fault = fault("machine-function", word.span, None).with("code", &name);
            faults.push(fault.about(Subject::Function(name)));
            continue;
        };
        use Action::{SpindleClockwise, SpindleCounterclockwise, SpindleStop};
        let switches = matches!(function.action, SpindleClockwise | SpindleCounterclockwise | SpindleStop);
        let first = if function.exclusive { exclusive.replace(word) } else { None };
        // Which of two orders to the spindle acts nobody says.
        let first = first.or_else(|| if switches { spindle.replace(word) } else { None });
        if let Some(first) = first {
            let names = [first, word].map(|word| format!("M{:02}", word.code()));
            faults.push(fault("exclusive-m-twice", word.span, None).with("first", &names[0]).with("second", &names[1]));
        }
        if function.action == Action::Return
            && let Some(call) = block.words.iter().find(|it| matches!(it.address, 'P' | 'L') && !it.in_cycle)
        {
            faults.push(fault("return-with-call", call.span, None).with("address", call.address));
        }
    }
}

fn groups(block: &Block, control: &Control, faults: &mut Vec<Fault>) {
    let mut last: [Option<&Word>; GROUPS] = [None; GROUPS];
    let mut offset = None;
    let mut no_corrector = None;
    for word in block.words.iter().filter(|word| word.address == 'G' && !word.in_cycle) {
        let code = word.code();
        let Some(slot) = control.groups.get(code).and_then(|group| last.get_mut(*group)) else {
            let name = word.number().to_string();
            let fault = fault("unknown-function", word.span, None).with("code", &name);
            faults.push(fault.about(Subject::Function(name)));
            continue;
        };
        if control.offsets.contains(code) {
            offset = Some(word);
        }
        if control.offsets.contains(code) || (27..=31).contains(&code) {
            no_corrector = Some(word);
        }
        if let Some(dead) = slot.replace(word) {
            let names = [dead, word].map(|word| format!("G{:02}", word.code()));
            faults.push(fault("group-twice", dead.span, None).with("first", &names[0]).with("second", &names[1]));
        }
    }
    // 3.11.4, note 1.
    if let Some(function) = no_corrector
        && let Some(corrector) = block.words.iter().find(|word| word.address == 'H' && !word.in_cycle)
    {
        let name = format!("G{:02}", function.code());
        faults.push(fault("corrector-with-offset", corrector.span, None).with("function", name));
    }
    // Checked in the same block; the radius correction of an earlier block is reported when the block runs (note 3).
    if let Some(offset) = offset
        && last[RADIUS].is_some_and(|word| word.code() != 40)
    {
        let name = format!("G{:02}", offset.code());
        faults.push(fault("offset-with-radius-correction", offset.span, None).with("function", name));
    }
}

fn calls(block: &Block, programs: &Programs, headless: bool, faults: &mut Vec<Fault>) {
    for word in block.words.iter().filter(|word| word.address == 'P' && !word.in_cycle) {
        // 3.14.2, note 6: two digits, the leading zero stays.
        if word.digits != 2 {
            faults.push(fault("subprogram-one-digit", word.span, None).with("number", word.number()));
        } else if !headless && !programs.numbered.contains_key(&word.code()) {
            let number = format!("{:02}", word.number());
            faults.push(fault("subprogram-missing", word.span, None).with("number", number));
        }
    }
}
