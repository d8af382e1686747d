//! The execution of a program: its blocks, calls and repeats.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::block::{After, Maker};
use super::control::{Characteristic as Q, Control, Group};
use super::owords::{Flow, Jump};
use super::programs::{self, Programs};
use super::rules::{fault, word_fault};
use super::state::ControlState;
use super::text::{self, Block, Label, UNREAD, Word};
use super::values::{self, Seen, Values};
use super::words::{ADDRESSES, BlockWords};
use crate::machine::Machine;
use crate::motion::{BlockRef, Motion, MotionStep, Sink};
use crate::note::Severity;
use crate::program::expression::Expression;
use crate::program::running::{BlockOutcome, Running};
use crate::program::setting::Before;
use crate::program::{Fault, Setting, Subject, TextSpan};

/// Checks a program: its text, then its run. The steps of the run are output to the sink; the faults are returned,
/// sorted by place; the run ends with an error after so many blocks and motions as `budget` says.
///
/// A text with errors is not run. A block with an error makes no steps, but its modal functions take effect and the
/// run continues, so that all mistakes are reported at once.
pub fn check_within<S: Sink>(
    budget: usize,
    text: &str,
    control: &Control,
    machine: Option<&Machine<'_>>,
    setting: &Setting,
    sink: &mut S,
) -> Vec<Fault> {
    let (blocks, closed, mut faults) = text::blocks(text, control, setting.decimal);
    let words: Vec<BlockWords> = blocks.iter().map(|block| BlockWords::read(block, control, &mut faults)).collect();
    let programs = programs::programs(&blocks, &words, control, &mut faults);
    if faults.iter().any(Fault::is_error) {
        // The run would tell it of the blocks it comes to.
        faults.extend(words.iter().flat_map(|words| words.told.iter().cloned()));
    } else {
        let habits = control.habits.clone().with_changes(!control.changes_tools());
        let mut run = ProgramRun {
            blocks: &blocks,
            words: &words,
            programs: &programs,
            control,
            machine,
            setting,
            closed,
            state: ControlState::power_on(control, setting),
            values: Values::new(control),
            broke: false,
            running: Running::new(sink, fault, habits.under(setting), text, budget),
        };
        run.main();
        let first = blocks.first().map(|block| block.span).unwrap_or_default();
        if machine.is_none() {
            run.running.report(fault("machine-not-named", first, None));
        }
        faults.extend(run.running.finish(first, setting.assumed));
    }
    faults.sort_by_key(|fault| fault.span);
    once(faults)
}

/// What is not carried out is told at its first place, with how often it stands in the program.
fn once(faults: Vec<Fault>) -> Vec<Fault> {
    let key = |fault: &Fault| {
        let known = matches!(fault.code, "not-carried-out" | "traced-as-written" | "passed-over" | "macro-not-run");
        let word = match &fault.subject {
            // Of a macro every word says the same.
            Some(Subject::Function(word)) if fault.code != "macro-not-run" => word.clone(),
            _ => String::new(),
        };
        known.then_some((fault.code, word))
    };
    let mut counts: BTreeMap<(&'static str, String), usize> = BTreeMap::new();
    for key in faults.iter().filter_map(key) {
        *counts.entry(key).or_default() += 1;
    }
    let told = |fault: Fault| match key(&fault) {
        Some(key) => counts.remove(&key).map(|count| fault.with("count", count)),
        None => Some(fault),
    };
    faults.into_iter().filter_map(told).collect()
}

struct ProgramRun<'a, S> {
    blocks: &'a [Block],
    words: &'a [BlockWords],
    programs: &'a Programs,
    control: &'a Control,
    machine: Option<&'a Machine<'a>>,
    setting: &'a Setting,
    /// Whether a second `%` closes the text, which also ends a LinuxCNC program.
    closed: bool,
    state: ControlState,
    values: Values,
    /// Whether a `while` was left by `break`: LinuxCNC 2.9 (seen in rs274) then leaves the next `do` after its first round.
    broke: bool,
    running: Running<'a, S>,
}

impl<S: Sink> ProgramRun<'_, S> {
    fn main(&mut self) {
        if self.program(self.programs.main.clone(), 0) == BlockOutcome::On {
            self.open_end();
        }
    }

    /// The main program has run out of blocks without M2 or M30.
    fn open_end(&mut self) {
        let last = self.programs.main.clone().last().and_then(|index| self.blocks.get(index));
        let (span, number) = last.map_or((TextSpan::default(), None), |block| (block.span, block.number));
        if self.closed && self.control.is(Q::OWords) {
            let block = BlockRef { line: span.line, number };
            self.running.take(&MotionStep { motion: Motion::End, at: self.state.at, block });
        } else {
            self.running.report(fault("program-without-end", span, number));
        }
    }

    fn program(&mut self, range: Range<usize>, depth: usize) -> BlockOutcome {
        let mut index = range.start;
        // How often each `repeat` still goes on.
        let mut rounds = BTreeMap::new();
        while index < range.end {
            // A subprogram between the blocks is skipped.
            if let Some(behind) = self.programs.passed.get(&index) {
                index = *behind;
                continue;
            }
            if let (Some(jump), Some(block)) = (self.programs.jumps.get(&index), self.blocks.get(index)) {
                if !self.running.spend(block.span, block.number) {
                    return BlockOutcome::Out;
                }
                match self.flow(index, *jump, depth, &mut rounds) {
                    Some(next) => index = next,
                    None => return BlockOutcome::Out,
                }
                continue;
            }
            match self.block(index, depth) {
                BlockOutcome::On => index += 1,
                outcome => return outcome,
            }
        }
        BlockOutcome::On
    }

    fn block(&mut self, index: usize, depth: usize) -> BlockOutcome {
        let (Some(block), Some(words)) = (self.blocks.get(index), self.words.get(index)) else {
            return BlockOutcome::Out;
        };
        if block.skipped && self.setting.skip {
            return BlockOutcome::On;
        }
        if !self.running.spend(block.span, block.number) {
            return BlockOutcome::Out;
        }
        let calculated = self.calculated(block, depth);
        let words = calculated.as_ref().unwrap_or(words);
        for mut fault in words.told.iter().cloned() {
            // A proof holds the motions of the axes, and these are not known then.
            if fault.code == "traced-as-written" && self.setting.before == Before::OtherPrograms {
                fault.severity = Severity::Wrong;
            }
            self.running.report(fault);
        }
        let mut maker = self.maker(block, depth);
        let after = maker.make(words);
        let Maker { state, steps, faults, .. } = maker;
        // Of a block with an error only the modal functions are kept.
        self.running.carry_out(&steps, faults, steps.len());
        self.state = state;
        if words.function(Group::Motion).is_some_and(|function| (382..=385).contains(&function.code)) {
            self.values.forget_probe();
        }
        match (after, &block.label) {
            (After::End, _) => BlockOutcome::Out,
            (After::Return(span), _) if depth == 0 && self.control.is(Q::OWords) => {
                self.running.nowhere_to_return(span, block.number)
            }
            (After::Return(span), _) if depth == 0 => {
                // The main program begins anew: the operator stops it, once it is traced.
                self.running.report(fault("main-begins-anew", span, block.number));
                let block = BlockRef { line: block.span.line, number: block.number };
                self.running.take(&MotionStep { motion: Motion::End, at: self.state.at, block });
                BlockOutcome::Out
            }
            (After::Return(_), _) => BlockOutcome::Back,
            (_, Some(Label::EndSub(_) | Label::Return(_))) => {
                let given = block.arguments.first().map(|value| value.value(&self.seen(block, depth)));
                self.values.set("#_VALUE_RETURNED".to_owned(), Some(f64::from(u8::from(given.is_some()))));
                self.values.set("#_VALUE".to_owned(), given.unwrap_or(Some(0.0)));
                BlockOutcome::Back
            }
            (After::Next, _) => self.call(block, words, depth),
        }
    }

    fn maker(&mut self, block: &Block, depth: usize) -> Maker<'_> {
        Maker {
            control: self.control,
            machine: self.machine,
            setting: self.setting,
            state: self.state.clone(),
            steps: Vec::new(),
            faults: Vec::new(),
            block: BlockRef { line: block.span.line, number: block.number },
            depth,
            span: block.span,
            spans: &mut self.running.spans,
            watched: &mut self.running.watched,
            budget: self.running.left,
            used: [false; ADDRESSES],
        }
    }

    /// The words of a block with numbers that depend on parameters, none if it has none; and the parameters it sets.
    fn calculated(&mut self, block: &Block, depth: usize) -> Option<BlockWords> {
        if block.expressions.is_empty() && block.sets.is_empty() {
            return None;
        }
        let mut faults = Vec::new();
        let mut read = None;
        let unknown = |span| word_fault("not-carried-out", span, block.number, "#");
        if !block.expressions.is_empty() {
            let mut words = Block { words: block.words.clone(), number: block.number, ..Block::default() };
            let mut known = true;
            for (address, expression, span) in &block.expressions {
                let value = expression.value(&self.seen(block, depth)).filter(|value| value.abs() < 1e9);
                known &= value.is_some();
                let Some(value) = value else {
                    // What could not be read has been told.
                    faults.extend(Some(unknown(*span)).filter(|_| *address != UNREAD));
                    continue;
                };
                let millionths = libm::round(value * 1e6) as i64;
                words.words.push(Word { address: *address, millionths, increments: false, point: true, span: *span });
            }
            // What is wrong with the other words has been told.
            let mut told = Vec::new();
            let mut carried = BlockWords::read(&words, self.control, &mut told);
            let own: BTreeSet<TextSpan> = block.expressions.iter().map(|(.., span)| *span).collect();
            faults.extend(told.into_iter().filter(|fault| own.contains(&fault.span)));
            if !known {
                carried.passed = true;
                carried.passes_on |= carried.function(Group::Cycle).is_some();
            }
            read = Some(carried);
        }
        // LinuxCNC sets parameters when the whole block is read.
        let seen = self.seen(block, depth);
        let set: Vec<_> = block.sets.iter().map(|(name, value)| (target(name, &seen), value.value(&seen))).collect();
        for ((name, value), (_, written)) in set.into_iter().zip(&block.sets) {
            // What could not be read has been told.
            if name.is_none() || (value.is_none() && *written != Expression::unread()) {
                faults.push(unknown(block.span));
            }
            // LinuxCNC would take it for a zero or a point of return, but not at once.
            if let Some(place) = name.as_deref().filter(|name| values::is_place(name)) {
                faults.push(word_fault("not-carried-out", block.span, block.number, place));
            }
            if let Some(name) = name {
                self.values.set(name, value);
            }
        }
        faults.into_iter().for_each(|fault| self.running.report(fault));
        read
    }

    /// The parameters as a block sees them.
    fn seen(&self, block: &Block, depth: usize) -> Seen<'_> {
        let (values, state, setting) = (&self.values, &self.state, self.setting);
        Seen { values, state, setting, line: block.span.line, depth }
    }

    /// The block behind a line of a branch or a loop; none where what decides it is not known.
    fn flow(&mut self, index: usize, jump: Jump, depth: usize, rounds: &mut BTreeMap<usize, i64>) -> Option<usize> {
        let block = self.blocks.get(index)?;
        let Some(Label::Flow(flow, _)) = &block.label else { return Some(index + 1) };
        Some(match flow {
            Flow::If => return self.branch(index, depth),
            // Reached from the blocks before it: another branch was run.
            Flow::ElseIf | Flow::Else => jump.end + 1,
            Flow::Break => {
                self.broke = self.loops_back(jump.start);
                jump.end + 1
            }
            Flow::EndIf | Flow::Do => index + 1,
            Flow::While if jump.closes && std::mem::take(&mut self.broke) => index + 1,
            Flow::While if jump.closes => {
                if self.decided(block, *flow, depth)? != 0.0 {
                    jump.start + 1
                } else {
                    index + 1
                }
            }
            Flow::While => {
                if self.decided(block, *flow, depth)? != 0.0 {
                    index + 1
                } else {
                    jump.end + 1
                }
            }
            Flow::EndWhile => jump.start,
            Flow::Repeat => {
                let times = libm::round(self.decided(block, *flow, depth)?) as i64;
                rounds.insert(index, times);
                if times > 0 { index + 1 } else { jump.end + 1 }
            }
            Flow::EndRepeat => {
                let left = rounds.entry(jump.start).or_default();
                *left -= 1;
                if *left > 0 { jump.start + 1 } else { index + 1 }
            }
            // At the first line of a `while` or at the last one of a `do`.
            Flow::Continue if self.loops_back(jump.start) => jump.start,
            Flow::Continue => jump.end,
        })
    }

    /// Whether a loop asks its question at its first line.
    fn loops_back(&self, start: usize) -> bool {
        matches!(self.blocks.get(start).map(|block| &block.label), Some(Some(Label::Flow(Flow::While, _))))
    }

    /// The first block of the branch that is run.
    fn branch(&mut self, first: usize, depth: usize) -> Option<usize> {
        let mut at = first;
        loop {
            let (block, jump) = (self.blocks.get(at)?, self.programs.jumps.get(&at)?);
            match &block.label {
                Some(Label::Flow(flow @ (Flow::If | Flow::ElseIf), _)) => {
                    if self.decided(block, *flow, depth)? != 0.0 {
                        return Some(at + 1);
                    }
                    at = jump.next;
                }
                _ => return Some(at + 1),
            }
        }
    }

    /// The value behind a line of a branch or a loop. What the check does not know ends the run: which blocks come is not
    /// known either.
    fn decided(&mut self, block: &Block, flow: Flow, depth: usize) -> Option<f64> {
        let value = block.arguments.first().and_then(|value| value.value(&self.seen(block, depth)));
        if value.is_none() {
            self.running.report(word_fault("branch-unknown", block.span, block.number, flow.word()));
        }
        value
    }

    fn call(&mut self, block: &Block, words: &BlockWords, depth: usize) -> BlockOutcome {
        let Some(call) = programs::call(block, words, self.control) else { return BlockOutcome::On };
        let Some(range) = self.programs.named.get(&call.name).cloned() else {
            // An o-word may be the file of another subprogram; only a call that the run comes to is wrong.
            self.running.report(fault("subprogram-missing", call.span, block.number).with("number", call.name));
            return BlockOutcome::Out;
        };
        if self.running.too_deep(depth, self.control.depth, call.span, block.number) {
            return BlockOutcome::Out;
        }
        // A called o-word has the parameters 1 to 30 for itself, its arguments among them.
        let own = matches!(block.label, Some(Label::Call(_)));
        let before = own.then(|| {
            let seen = self.seen(block, depth);
            let given: Vec<_> = block.arguments.iter().map(|given| given.value(&seen)).collect();
            self.values.enter(given.into_iter())
        });
        let positions = self.state.absolute();
        for round in 1..=call.repeats {
            self.state.kept.truncate(depth + 1);
            match self.program(range.clone(), depth + 1) {
                BlockOutcome::Back if self.state.brings_back(depth + 1) => {
                    let mut maker = self.maker(block, depth + 1);
                    maker.bring_back();
                    let Maker { state, steps, faults, .. } = maker;
                    self.running.carry_out(&steps, faults, steps.len());
                    self.state = state;
                }
                BlockOutcome::Back => {}
                BlockOutcome::On => {
                    // The run reached the next program or the end of the text.
                    let head = self.blocks.get(range.start).map_or((call.span, None), |it| (it.span, it.number));
                    self.running.report(fault("program-without-end", head.0, head.1));
                    return BlockOutcome::Out;
                }
                BlockOutcome::Out => return BlockOutcome::Out,
            }
            let left = positions && !self.state.absolute();
            self.state.left_by_call = left.then_some(depth + usize::from(round < call.repeats));
        }
        if let Some(before) = before {
            self.values.leave(before);
        }
        BlockOutcome::On
    }
}

/// The name of a parameter that a block sets.
fn target(name: &Expression, seen: &Seen<'_>) -> Option<String> {
    match name {
        Expression::Parameter(name) => Some(name.clone()),
        Expression::Indirect(number) => number.value(seen).map(|number| format!("#{}", libm::round(number))),
        _ => None,
    }
}
