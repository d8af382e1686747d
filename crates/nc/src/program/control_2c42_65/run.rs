//! The way through a program: its blocks, calls and repeats (textbook 3.12.2, 3.14).

use std::collections::BTreeSet;
use std::ops::Range;

use super::block::{After, Maker};
use super::check::{self, Programs};
use super::control::Control;
use super::cycles::Holes;
use super::rules::fault;
use super::state::State;
use super::text::{self, Block};
use super::words::Words;
use crate::machine::Machine;
use crate::motion::{BlockRef, Sink, Step};
use crate::program::limits::{Spans, without_zero};
use crate::program::{Call, Fault, Setting};

/// Blocks and steps that a check carries out: 65535 repeats of 65535 repeats would never end.
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
    check_within(BUDGET, text, control, machine, setting, sink)
}

/// The same with another budget: a run ends, with an error, after so many blocks and motions.
pub fn check_within<S: Sink>(
    budget: usize,
    text: &str,
    control: &Control,
    machine: &Machine<'_>,
    setting: &Setting,
    sink: &mut S,
) -> Vec<Fault> {
    let (blocks, mut faults) = text::blocks(text, control);
    let programs = check::programs(&blocks, control, &mut faults);
    check::blocks(&blocks, &programs, control, &mut faults);
    if !faults.iter().any(Fault::is_error) {
        let mut run = Run {
            blocks: &blocks,
            programs: &programs,
            control,
            machine,
            setting,
            state: State::power_on(control, setting),
            sink,
            told: BTreeSet::new(),
            calls: Vec::new(),
            holes: Holes::new(),
            faults: Vec::new(),
            spans: Spans::new(),
            steps: Vec::new(),
            budget,
            left: budget,
        };
        run.main();
        faults.append(&mut run.faults);
    }
    faults.sort_by_key(|fault| fault.span);
    faults
}

struct Run<'a, S> {
    blocks: &'a [Block],
    programs: &'a Programs,
    control: &'a Control,
    machine: &'a Machine<'a>,
    setting: &'a Setting,
    state: State,
    sink: &'a mut S,
    /// What has been told of a word already: a block may run many times.
    told: BTreeSet<(u32, u32, &'static str)>,
    /// The calls that led to the block that runs.
    calls: Vec<Call>,
    holes: Holes,
    faults: Vec<Fault>,
    spans: Spans,
    /// The room for the steps of a block, empty between them: taken and given back, so that no block allocates its own.
    steps: Vec<Step>,
    budget: usize,
    left: usize,
}

/// How a program or a block went on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    On,
    /// M99.
    Back,
    /// M02, M30, or nothing more to carry out.
    Out,
}

impl<S: Sink> Run<'_, S> {
    fn main(&mut self) {
        let main = self.programs.main.clone();
        self.program(main, 0);
        for (system, axes) in without_zero(&self.spans) {
            let span = self.blocks.first().map(|block| block.span).unwrap_or_default();
            self.tell(fault("zero-not-set", span, None).with("system", system).with("axes", axes));
        }
    }

    fn program(&mut self, range: Range<usize>, depth: usize) -> Way {
        let blocks = self.blocks;
        for block in &blocks[range] {
            match self.block(block, depth) {
                Way::On => {}
                way => return way,
            }
        }
        Way::Out
    }

    fn block(&mut self, block: &Block, depth: usize) -> Way {
        if self.left == 0 {
            let fault = fault("run-too-long", block.span, block.number).with("budget", self.budget);
            self.tell(fault);
            return Way::Out;
        }
        self.left -= 1;
        // 1. Read the words and check their groups.
        let words = Words::read(block, self.control, self.setting.skip);
        // 2. Check everything: make the steps.
        let mut maker = Maker {
            control: self.control,
            machine: self.machine,
            setting: self.setting,
            state: &mut self.state,
            steps: std::mem::take(&mut self.steps),
            faults: Vec::new(),
            block: BlockRef { line: block.span.line, number: block.number },
            span: block.span,
            spans: &mut self.spans,
            holes: &mut self.holes,
            calls: &self.calls,
            made: 0,
            budget: self.left,
        };
        maker.finer_than_machine(&words);
        let after = maker.make(&words);
        let Maker { mut steps, faults, made, .. } = maker;
        // 3. Carry it out: nothing of a block that is not good.
        let good = !faults.iter().any(Fault::is_error);
        if good {
            for step in &steps {
                self.sink.take(step);
            }
        }
        steps.clear();
        self.steps = steps;
        self.left = self.left.saturating_sub(made);
        for fault in faults {
            self.tell(fault);
        }
        match after {
            After::End => Way::Out,
            After::Return if depth == 0 => {
                let span = words.m.iter().find(|it| it.code == 99).map_or(block.span, |it| it.span);
                self.tell(fault("return-without-call", span, block.number));
                Way::Out
            }
            After::Return => Way::Back,
            After::Next => self.calls(block, &words, depth),
        }
    }

    /// L P: the subprogram, so many times (3.14.2).
    fn calls(&mut self, block: &Block, words: &Words, depth: usize) -> Way {
        let Some(call) = words.get('P') else { return Way::On };
        let number = u8::try_from(call.number()).unwrap_or(u8::MAX);
        let Some(range) = self.programs.numbered.get(&number).cloned() else { return Way::On };
        if depth >= self.control.depth {
            let fault = fault("calls-too-deep", call.span, block.number).with("limit", self.control.depth);
            self.tell(fault);
            return Way::Out;
        }
        let from = BlockRef { line: block.span.line, number: block.number };
        self.calls.push(Call { from, program: number });
        let mut way = Way::On;
        for _ in 0..words.get('L').map_or(1, super::words::Given::number) {
            if self.program(range.clone(), depth + 1) == Way::Out {
                way = Way::Out;
                break;
            }
        }
        self.calls.pop();
        way
    }

    fn tell(&mut self, mut fault: Fault) {
        if self.told.insert((fault.span.line, fault.span.column, fault.code)) {
            fault.calls.clone_from(&self.calls);
            self.faults.push(fault);
        }
    }
}

impl Maker<'_> {
    /// The control counts thousandths, the machine may not (3.8.2).
    fn finer_than_machine(&mut self, words: &Words) {
        let step = self.machine.resolution.micrometres().max(1);
        let finer = words.axes.iter().flatten().find(|word| word.thousandths % step != 0);
        if let Some(word) = finer {
            self.tell("finer-than-machine", word.span, &[("step", self.machine.resolution.to_string())]);
        }
    }
}
