//! The execution of a program: its blocks, calls and repeats.

use std::ops::Range;

use super::block::{After, Maker};
use super::control::{Characteristic as Q, Control};
use super::programs::{self, Programs};
use super::rules::fault;
use super::state::ControlState;
use super::text::{self, Block, Label};
use super::words::BlockWords;
use crate::machine::Machine;
use crate::motion::{BlockRef, Motion, MotionStep, Sink};
use crate::program::running::{BUDGET, BlockOutcome, Running};
use crate::program::{Fault, Setting, TextSpan};

/// Checks a program: its text, then its run. The steps of the run are output to the sink; the faults are returned,
/// sorted by place.
///
/// A text with errors is not run. A block with an error makes no steps, but its modal functions take effect and the
/// run continues, so that all mistakes are reported at once.
pub fn check<S: Sink>(
    text: &str,
    control: &Control,
    machine: &Machine<'_>,
    setting: &Setting,
    sink: &mut S,
) -> Vec<Fault> {
    check_within(BUDGET, text, control, machine, setting, sink)
}

/// The same with a limit on blocks and motions.
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
            running: Running::new(sink, fault, budget),
        };
        run.main();
        faults.extend(run.running.finish(blocks.first().map(|block| block.span).unwrap_or_default()));
    }
    faults.sort_by_key(|fault| fault.span);
    faults
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

    fn call(&mut self, block: &Block, words: &BlockWords, depth: usize) -> BlockOutcome {
        let Some(call) = programs::call(block, words, self.control) else { return BlockOutcome::On };
        let Some(range) = self.programs.named.get(&call.name).cloned() else { return BlockOutcome::On };
        if self.running.too_deep(depth, self.control.depth, call.span, block.number) {
            return BlockOutcome::Out;
        }
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
        BlockOutcome::On
    }
}
