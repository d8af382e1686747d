//! The way through a program: its blocks, calls and repeats.

use std::collections::BTreeSet;
use std::ops::Range;

use super::block::{After, Maker};
use super::control::Control;
use super::programs::{self, Programs};
use super::rules::fault;
use super::state::State;
use super::text::{self, Block, Label};
use super::words::Words;
use crate::machine::Machine;
use crate::motion::{BlockRef, Motion, Sink, Step};
use crate::program::limits::{Spans, without_zero};
use crate::program::{Fault, Setting, Span};

/// Blocks and steps that a check carries out: repeats of repeats would never end.
const BUDGET: usize = 500_000;

/// Checks a program: its text, then its run. The steps of the run go to the sink; what is wrong comes back, by place.
///
/// A text with errors is not run. A block with an error makes no steps, its modal functions hold all the same, and the
/// run goes on, so that every mistake is told at once.
pub fn check<S: Sink>(
    text: &str,
    control: &Control,
    machine: &Machine<'_>,
    setting: &Setting,
    sink: &mut S,
) -> Vec<Fault> {
    let (blocks, closed, mut faults) = text::blocks(text, control);
    let words: Vec<Words> = blocks.iter().map(|block| Words::read(block, control, &mut faults)).collect();
    let programs = programs::programs(&blocks, &words, control, &mut faults);
    if !faults.iter().any(Fault::is_error) {
        let mut run = Run {
            blocks: &blocks,
            words: &words,
            programs: &programs,
            control,
            machine,
            setting,
            closed,
            state: State::power_on(control, setting),
            sink,
            told: BTreeSet::new(),
            faults: Vec::new(),
            spans: Spans::new(),
            left: BUDGET,
        };
        run.main();
        faults.append(&mut run.faults);
    }
    faults.sort_by_key(|fault| fault.span);
    faults
}

struct Run<'a, S> {
    blocks: &'a [Block],
    words: &'a [Words],
    programs: &'a Programs,
    control: &'a Control,
    machine: &'a Machine<'a>,
    setting: &'a Setting,
    /// Whether a second `%` closes the text: an end of LinuxCNC too.
    closed: bool,
    state: State,
    sink: &'a mut S,
    /// What has been told of a word already: a block may run many times.
    told: BTreeSet<(u32, u32, &'static str)>,
    faults: Vec<Fault>,
    spans: Spans,
    left: usize,
}

/// How a program or a block went on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    On,
    /// M99, `o… endsub`, `o… return`.
    Back,
    /// M2, M30, or nothing more to carry out.
    Out,
}

impl<S: Sink> Run<'_, S> {
    fn main(&mut self) {
        if self.program(self.programs.main.clone(), 0) == Way::On {
            self.open_end();
        }
        for (system, axes) in without_zero(&self.spans) {
            let span = self.blocks.first().map(|block| block.span).unwrap_or_default();
            self.tell(fault("zero-not-set", span, None).with("system", system).with("axes", axes));
        }
    }

    /// The main program has run out of blocks without M2 or M30.
    fn open_end(&mut self) {
        let last = self.programs.main.clone().last().and_then(|index| self.blocks.get(index));
        let (span, number) = last.map_or((Span::default(), None), |block| (block.span, block.number));
        if self.closed && self.control.o_words {
            let block = BlockRef { line: span.line, number };
            self.sink.take(&Step { motion: Motion::End, at: self.state.at, block });
        } else {
            self.tell(fault("program-without-end", span, number));
        }
    }

    fn program(&mut self, range: Range<usize>, depth: usize) -> Way {
        let mut index = range.start;
        while index < range.end {
            // A subprogram that stands in the way is passed by.
            if let Some(behind) = self.programs.passed.get(&index) {
                index = *behind;
                continue;
            }
            match self.block(index, depth) {
                Way::On => index += 1,
                way => return way,
            }
        }
        Way::On
    }

    fn block(&mut self, index: usize, depth: usize) -> Way {
        let (Some(block), Some(words)) = (self.blocks.get(index), self.words.get(index)) else { return Way::Out };
        if block.skipped && self.setting.skip {
            return Way::On;
        }
        if self.left == 0 {
            self.tell(fault("run-too-long", block.span, block.number).with("budget", BUDGET));
            return Way::Out;
        }
        self.left -= 1;
        let mut maker = Maker {
            control: self.control,
            machine: self.machine,
            setting: self.setting,
            state: self.state.clone(),
            steps: Vec::new(),
            faults: Vec::new(),
            block: BlockRef { line: block.span.line, number: block.number },
            span: block.span,
            spans: &mut self.spans,
            budget: self.left,
            used: [false; 26],
        };
        let after = maker.make(words);
        let Maker { state, steps, faults, .. } = maker;
        // Nothing of a block that is not good, but its modes.
        if !faults.iter().any(Fault::is_error) {
            for step in &steps {
                self.sink.take(step);
            }
        }
        self.left = self.left.saturating_sub(steps.len());
        self.state = state;
        for fault in faults {
            self.tell(fault);
        }
        match (after, &block.label) {
            (After::End, _) => Way::Out,
            (After::Return(span), _) if depth == 0 => {
                self.tell(fault("return-without-call", span, block.number));
                Way::Out
            }
            (After::Return(_), _) | (_, Some(Label::EndSub(_) | Label::Return(_))) => Way::Back,
            (After::Next, _) => self.call(block, words, depth),
        }
    }

    fn call(&mut self, block: &Block, words: &Words, depth: usize) -> Way {
        let Some(call) = programs::call(block, words, self.control) else { return Way::On };
        let Some(range) = self.programs.named.get(&call.name).cloned() else { return Way::On };
        if depth >= self.control.depth {
            self.tell(fault("calls-too-deep", call.span, block.number).with("limit", self.control.depth));
            return Way::Out;
        }
        for _ in 0..call.repeats {
            match self.program(range.clone(), depth + 1) {
                Way::Back => {}
                Way::On => {
                    // It ran into the next program, or out of the text.
                    let head = self.blocks.get(range.start).map_or((call.span, None), |it| (it.span, it.number));
                    self.tell(fault("program-without-end", head.0, head.1));
                    return Way::Out;
                }
                Way::Out => return Way::Out,
            }
        }
        Way::On
    }

    fn tell(&mut self, fault: Fault) {
        if self.told.insert((fault.span.line, fault.span.column, fault.code)) {
            self.faults.push(fault);
        }
    }
}
