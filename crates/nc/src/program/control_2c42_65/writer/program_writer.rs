//! The program under construction: the main blocks and the subprograms that they call.

use crate::program::written::{Form, LineRole, ProgramLine, WorkRef, WrittenProgram};

use crate::program::block::Block;

/// The purpose of a block, and the work it serves.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockPurpose {
    pub role: LineRole,
    pub work: Option<WorkRef>,
    pub cycle: Option<usize>,
}

impl BlockPurpose {
    pub(super) const fn of(role: LineRole) -> Self {
        Self { role, work: None, cycle: None }
    }
}

/// A group of blocks: a subprogram or, where the numbers are used up, the blocks themselves.
#[derive(Clone, Debug)]
pub(super) enum BlockGroup {
    Subprogram(u32),
    Blocks(Vec<Block>),
}

impl BlockGroup {
    pub(super) const fn number(&self) -> Option<u32> {
        match self {
            Self::Subprogram(number) => Some(*number),
            Self::Blocks(_) => None,
        }
    }
}

/// The number of the main program where its user gives none; subprograms follow it.
const MAIN: u32 = 1;
/// The last number of a program (3.6).
const LAST: u32 = 99;
/// The last number of a block (3.7).
const LAST_BLOCK: usize = 9999;

/// The program so far.
pub(super) struct ProgramWriter {
    pub form: Form,
    main: Vec<(Block, BlockPurpose)>,
    subprograms: Vec<(Vec<Block>, BlockPurpose)>,
}

impl ProgramWriter {
    pub(super) const fn new(form: Form) -> Self {
        Self { form, main: Vec::new(), subprograms: Vec::new() }
    }

    /// One more block of the main program.
    pub(super) fn push_block(&mut self, block: Block, place: BlockPurpose) {
        self.main.push((block, place));
    }

    fn main_number(&self) -> u32 {
        self.form.program.unwrap_or(MAIN)
    }

    /// Blocks as a subprogram; equal ones are one. It belongs to the work of its only caller, or to none when several
    /// works call it.
    pub(super) fn subprogram(&mut self, blocks: Vec<Block>, place: BlockPurpose) -> BlockGroup {
        let known = self.subprograms.iter().position(|(known, _)| *known == blocks);
        let index = known.unwrap_or(self.subprograms.len());
        let number = u32::try_from(index).unwrap_or(u32::MAX).saturating_add(self.main_number() + 1);
        if number > LAST || !self.form.subprograms {
            return BlockGroup::Blocks(blocks);
        }
        match self.subprograms.get_mut(index) {
            Some((_, served)) if served.work != place.work => {
                *served = BlockPurpose { work: None, cycle: None, ..*served }
            }
            Some(_) => {}
            None => self.subprograms.push((blocks, place)),
        }
        BlockGroup::Subprogram(number)
    }

    /// Calls a group once, after the motion of a block if one is given.
    pub(super) fn call(&mut self, group: &BlockGroup, motion: Option<Block>, place: BlockPurpose) {
        match group {
            BlockGroup::Subprogram(number) => self.push_block(motion.unwrap_or_default().calls(*number, 1), place),
            BlockGroup::Blocks(blocks) => {
                for block in motion.into_iter().chain(blocks.iter().cloned()) {
                    self.push_block(block, place);
                }
            }
        }
    }

    /// The whole program: main program, then subprograms, with block numbers.
    pub(super) fn finish(self) -> WrittenProgram {
        let main = self.main_number();
        let mut lines = vec![frame("%".to_owned()), frame(format!(":{main:02}"))];
        let mut numbers = vec![main];
        let step = (self.form.number_step as usize).max(1);
        // A long program has smaller number steps, so that its numbers stay within four digits.
        let step = if self.main.len() * step > LAST_BLOCK { 1 } else { step };
        for (index, (block, place)) in self.main.iter().enumerate() {
            lines.push(line((index + 1) * step, block, *place));
        }
        for (number, (blocks, place)) in (main + 1..).zip(&self.subprograms) {
            numbers.push(number);
            let at = BlockPurpose { role: LineRole::Frame, ..*place };
            lines.push(ProgramLine { text: format!(":{number:02}"), role: at.role, work: at.work, cycle: at.cycle });
            for (block, index) in blocks.iter().zip(1..) {
                lines.push(line(index, block, *place));
            }
            lines.push(line(blocks.len() + 1, &Block::new().m(99), BlockPurpose { role: LineRole::End, ..*place }));
        }
        // It has no remarks that could stand behind a number.
        WrittenProgram { lines, numbers, head: None }
    }
}

fn frame(text: String) -> ProgramLine {
    ProgramLine { text, role: LineRole::Frame, work: None, cycle: None }
}

fn line(number: usize, block: &Block, place: BlockPurpose) -> ProgramLine {
    let text = format!("N{} {}", number % (LAST_BLOCK + 1), block.text());
    ProgramLine { text, role: place.role, work: place.work, cycle: place.cycle }
}
