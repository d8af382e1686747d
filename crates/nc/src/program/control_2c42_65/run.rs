//! The execution of a program: its blocks, calls and repeats (textbook 3.12.2, 3.14).

use std::ops::Range;

use super::block::{After, Maker};
use super::check::{self, Programs};
use super::control::Control;
use super::cycles::Holes;
use super::rules::fault;
use super::state::ControlState;
use super::text::{self, Block};
use super::words::BlockWords;
use crate::machine::Machine;
use crate::motion::{BlockRef, MotionStep, Sink};
use crate::note::IntoFigure;

use crate::program::running::{BlockOutcome, Running};
use crate::program::{Call, Fault, Setting, TextSpan};

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
    let (blocks, mut faults) = text::blocks(text, control);
    let programs = check::programs(&blocks, control, &mut faults);
    check::blocks(&blocks, &programs, control, &mut faults);
    if !faults.iter().any(Fault::is_error) {
        let mut run = ProgramRun {
            blocks: &blocks,
            programs: &programs,
            control,
            machine,
            setting,
            state: ControlState::power_on(control, setting),
            holes: Holes::new(),
            steps: Vec::new(),
            running: Running::new(sink, fault, control.habits.clone().under(setting), text, budget),
        };
        run.program(programs.main.clone(), 0);
        let first = blocks.first().map(|block| block.span).unwrap_or_default();
        faults.extend(run.running.finish(first, setting.assumed));
    }
    faults.sort_by_key(|fault| fault.span);
    faults
}

/// What a program is told without a machine: limits, tool change and step of this language are those of one.
pub fn without_machine() -> Fault {
    fault("machine-needed", TextSpan { line: 1, column: 1, width: 1 }, None)
}

struct ProgramRun<'a, S> {
    blocks: &'a [Block],
    programs: &'a Programs,
    control: &'a Control,
    machine: &'a Machine<'a>,
    setting: &'a Setting,
    state: ControlState,
    holes: Holes,
    /// The buffer for the steps of a block, empty between blocks, so that no block allocates its own.
    steps: Vec<MotionStep>,
    running: Running<'a, S>,
}

impl<S: Sink> ProgramRun<'_, S> {
    fn program(&mut self, range: Range<usize>, depth: usize) -> BlockOutcome {
        let blocks = self.blocks;
        for block in &blocks[range] {
            match self.block(block, depth) {
                BlockOutcome::On => {}
                outcome => return outcome,
            }
        }
        BlockOutcome::Out
    }

    fn block(&mut self, block: &Block, depth: usize) -> BlockOutcome {
        if !self.running.spend(block.span, block.number) {
            return BlockOutcome::Out;
        }
        // 1. Read the words and check their groups.
        let words = BlockWords::read(block, self.control, self.setting.skip);
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
            spans: &mut self.running.spans,
            watched: &mut self.running.watched,
            holes: &mut self.holes,
            calls: &self.running.calls,
            step_count: 0,
            budget: self.running.left,
        };
        maker.finer_than_machine(&words);
        let after = maker.make(&words);
        let Maker { mut steps, faults, step_count: made, .. } = maker;
        // 3. Execute: nothing of a block with an error.
        self.running.carry_out(&steps, faults, made);
        steps.clear();
        self.steps = steps;
        match after {
            After::End => BlockOutcome::Out,
            After::Return if depth == 0 => {
                let span = words.m.iter().find(|it| it.code == 99).map_or(block.span, |function| function.span);
                self.running.nowhere_to_return(span, block.number)
            }
            After::Return => BlockOutcome::Back,
            After::Next => self.calls(block, &words, depth),
        }
    }

    /// L P: the subprogram, L times (3.14.2).
    fn calls(&mut self, block: &Block, words: &BlockWords, depth: usize) -> BlockOutcome {
        let Some(call) = words.get('P') else { return BlockOutcome::On };
        let number = u8::try_from(call.number()).unwrap_or(u8::MAX);
        let Some(range) = self.programs.numbered.get(&number).cloned() else { return BlockOutcome::On };
        if self.running.too_deep(depth, self.control.depth, call.span, block.number) {
            return BlockOutcome::Out;
        }
        let from = BlockRef { line: block.span.line, number: block.number };
        self.running.calls.push(Call { from, program: number });
        let mut outcome = BlockOutcome::On;
        for _ in 0..words.get('L').map_or(1, super::words::WordValue::number) {
            if self.program(range.clone(), depth + 1) == BlockOutcome::Out {
                outcome = BlockOutcome::Out;
                break;
            }
        }
        self.running.calls.pop();
        outcome
    }
}

impl Maker<'_> {
    /// The control counts thousandths, the machine may not (3.8.2).
    fn finer_than_machine(&mut self, words: &BlockWords) {
        let step = self.machine.resolution.micrometres().max(1);
        let finer = words.axes.iter().flatten().find(|word| word.thousandths % step != 0);
        if let Some(word) = finer {
            self.report("finer-than-machine", word.span, &[("step", self.machine.resolution.into_figure())]);
        }
    }
}
