//! The execution of a program: its blocks, calls and repeats.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::block::{After, Maker};
use super::control::{Characteristic as Q, Control, Group};
use super::programs::{self, Programs};
use super::rules::{fault, word_fault};
use super::state::ControlState;
use super::text::{self, Block, Label, UNREAD, Word};
use super::words::BlockWords;
use crate::machine::Machine;
use crate::motion::{BlockRef, Motion, MotionStep, Sink};
use crate::program::expression::{Expression, Parameters};
use crate::program::running::{BlockOutcome, Running};
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
    machine: &Machine<'_>,
    setting: &Setting,
    sink: &mut S,
) -> Vec<Fault> {
    let (blocks, closed, mut faults) = text::blocks(text, control, setting.decimal);
    let words: Vec<BlockWords> = blocks.iter().map(|block| BlockWords::read(block, control, &mut faults)).collect();
    let programs = programs::programs(&blocks, &words, control, &mut faults);
    if !faults.iter().any(Fault::is_error) {
        let mut run = ProgramRun {
            blocks: &blocks,
            words: &words,
            programs: &programs,
            control,
            machine,
            setting,
            closed,
            state: ControlState::power_on(control, setting),
            parameters: parameters(&blocks, control),
            running: Running::new(sink, fault, budget),
        };
        run.main();
        faults.extend(run.running.finish(blocks.first().map(|block| block.span).unwrap_or_default()));
    }
    faults.sort_by_key(|fault| fault.span);
    once(faults)
}

/// What is not carried out is told at its first place, with how often it stands in the program.
fn once(faults: Vec<Fault>) -> Vec<Fault> {
    let key = |fault: &Fault| {
        let known = matches!(fault.code, "not-carried-out" | "passed-over" | "macro-not-run");
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

/// The parameters before a run: those that a program of LinuxCNC has not set are 0, those of Fanuc are empty.
fn parameters(blocks: &[Block], control: &Control) -> Parameters {
    let calculates = |block: &Block| !block.expressions.is_empty() || !block.sets.is_empty();
    let used = blocks.iter().any(|block| calculates(block) || !block.arguments.is_empty());
    (1..=control.free_parameters).take_while(|_| used).map(|number| (format!("#{number}"), 0.0)).collect()
}

struct ProgramRun<'a, S> {
    blocks: &'a [Block],
    words: &'a [BlockWords],
    programs: &'a Programs,
    control: &'a Control,
    machine: &'a Machine<'a>,
    setting: &'a Setting,
    /// Whether a second `%` closes the text, which also ends a LinuxCNC program.
    closed: bool,
    state: ControlState,
    parameters: Parameters,
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
        while index < range.end {
            // A subprogram between the blocks is skipped.
            if let Some(behind) = self.programs.passed.get(&index) {
                index = *behind;
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
        let calculated = self.calculated(block);
        let words = calculated.as_ref().unwrap_or(words);
        let mut maker = Maker {
            control: self.control,
            machine: self.machine,
            setting: self.setting,
            state: self.state.clone(),
            steps: Vec::new(),
            faults: Vec::new(),
            block: BlockRef { line: block.span.line, number: block.number },
            span: block.span,
            spans: &mut self.running.spans,
            budget: self.running.left,
            used: [false; 26],
        };
        let after = maker.make(words);
        let Maker { state, steps, faults, .. } = maker;
        // Of a block with an error only the modal functions are kept.
        self.running.carry_out(&steps, faults, steps.len());
        self.state = state;
        match (after, &block.label) {
            (After::End, _) => BlockOutcome::Out,
            (After::Return(span), _) if depth == 0 => self.running.nowhere_to_return(span, block.number),
            (After::Return(_), _) | (_, Some(Label::EndSub(_) | Label::Return(_))) => BlockOutcome::Back,
            (After::Next, _) => self.call(block, words, depth),
        }
    }

    /// The words of a block with numbers that depend on parameters, none if it has none; and the parameters it sets.
    fn calculated(&mut self, block: &Block) -> Option<BlockWords> {
        let mut faults = Vec::new();
        let mut read = None;
        let unknown = |span| word_fault("not-carried-out", span, block.number, "#");
        if !block.expressions.is_empty() {
            let mut words = Block { words: block.words.clone(), number: block.number, ..Block::default() };
            let mut known = true;
            for (address, expression, span) in &block.expressions {
                let value = expression.value(&self.parameters).filter(|value| value.abs() < 1e9);
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
        let set: Vec<_> = block.sets.iter().map(|(name, value)| self.set(name, value)).collect();
        for ((name, value), (_, written)) in set.into_iter().zip(&block.sets) {
            match (name, value) {
                (Some(name), Some(value)) => {
                    self.parameters.insert(name, value);
                }
                (Some(name), None) => {
                    self.parameters.remove(&name);
                    // What could not be read has been told.
                    faults.extend(Some(unknown(block.span)).filter(|_| *written != Expression::unread()));
                }
                _ => faults.push(unknown(block.span)),
            }
        }
        faults.into_iter().for_each(|fault| self.running.report(fault));
        read
    }

    /// The name of a parameter that a block sets, and its value.
    fn set(&self, name: &Expression, value: &Expression) -> (Option<String>, Option<f64>) {
        let name = match name {
            Expression::Parameter(name) => Some(name.clone()),
            Expression::Indirect(number) => {
                number.value(&self.parameters).map(|number| format!("#{}", libm::round(number)))
            }
            _ => None,
        };
        (name, value.value(&self.parameters))
    }

    fn call(&mut self, block: &Block, words: &BlockWords, depth: usize) -> BlockOutcome {
        let Some(call) = programs::call(block, words, self.control) else { return BlockOutcome::On };
        let Some(range) = self.programs.named.get(&call.name).cloned() else { return BlockOutcome::On };
        if self.running.too_deep(depth, self.control.depth, call.span, block.number) {
            return BlockOutcome::Out;
        }
        let before = self.hand_over(block);
        for _ in 0..call.repeats {
            match self.program(range.clone(), depth + 1) {
                BlockOutcome::Back => {}
                BlockOutcome::On => {
                    // The run reached the next program or the end of the text.
                    let head = self.blocks.get(range.start).map_or((call.span, None), |it| (it.span, it.number));
                    self.running.report(fault("program-without-end", head.0, head.1));
                    return BlockOutcome::Out;
                }
                BlockOutcome::Out => return BlockOutcome::Out,
            }
        }
        for (name, value) in before {
            match value {
                Some(value) => self.parameters.insert(name, value),
                None => self.parameters.remove(&name),
            };
        }
        BlockOutcome::On
    }

    /// Gives the arguments of `o… call` to the parameters that a called o-word has for itself; what they were.
    fn hand_over(&mut self, block: &Block) -> Vec<(String, Option<f64>)> {
        if self.parameters.is_empty() || !matches!(block.label, Some(Label::Call(_))) {
            return Vec::new();
        }
        let given: Vec<Option<f64>> = block.arguments.iter().map(|given| given.value(&self.parameters)).collect();
        let names = (1..=self.control.local_parameters).map(|number| format!("#{number}"));
        let before: Vec<_> = names.map(|name| (name.clone(), self.parameters.remove(&name))).collect();
        for (index, (name, _)) in before.iter().enumerate() {
            if let Some(value) = given.get(index).copied().unwrap_or(Some(0.0)) {
                self.parameters.insert(name.clone(), value);
            }
        }
        before
    }
}
