//! Writes a job as a program for 2С42-65, in the style of Appendix Г.
//!
//! ```text
//! :01   the main program: for each tool its change, the spindle, the approach, its cycles and points
//! :02   the quill up, cycle and correction off, the spindle stopped
//! :03   the table to the place of the tool change
//! :04…  cycles, contours of mills, rows of points that several tools go over
//! ```
//!
//! - `cycle` the blocks of one cycle or contour;
//! - `points` the blocks of the path over points, as rows where that is shorter;
//! - `program_writer` the program under construction: main blocks and subprograms.

mod cycle;
mod points;
mod program_writer;

use std::collections::BTreeMap;

use crate::job::{Cycle, CycleKind, Job, Pause, ToolWork};
use crate::program::written::{Form, LineRole, WorkRef, WrittenProgram};

use crate::program::block::Block;
use points::PointRun;
use program_writer::{BlockGroup, BlockPurpose, ProgramWriter};

/// The program of a job.
pub fn write(job: &Job, form: Form) -> WrittenProgram {
    let mut sheet = ProgramWriter::new(form);
    let up = Block::new().g(90).g(80).g(49).g(53).g(0).axis('Z', job.change_at.z).m(5).m(9);
    let aside = Block::new().g(53).g(0).axis('X', job.change_at.x).axis('Y', job.change_at.y);
    let withdrawal = [
        sheet.subprogram(vec![up], BlockPurpose::of(LineRole::Withdrawal)),
        sheet.subprogram(vec![aside], BlockPurpose::of(LineRole::Withdrawal)),
    ];
    let away = |sheet: &mut ProgramWriter, place: BlockPurpose| {
        for call in &withdrawal {
            sheet.call(call, None, BlockPurpose { role: LineRole::Withdrawal, ..place });
        }
    };
    sheet.push_block(Block::new().g(17).g(40).g(49).g(80).g(90), BlockPurpose::of(LineRole::Frame));
    away(&mut sheet, BlockPurpose::of(LineRole::Withdrawal));
    let runs: Runs =
        job.setups.iter().map(|setup| setup.works.iter().map(|work| points::runs(work, form)).collect()).collect();
    let shared = shared_points(job, &runs);
    let mut in_spindle = None;
    for (setup_index, setup) in job.setups.iter().enumerate() {
        for (work_index, work) in setup.works.iter().enumerate() {
            let work_ref = WorkRef { setup: setup_index, work: work_index };
            let place = |role| BlockPurpose { role, work: Some(work_ref), cycle: None };
            for pause in &work.pauses {
                sheet.push_block(Block::new().m(0), place(LineRole::Pause));
                if matches!(pause, Pause::LoadTool { .. }) {
                    in_spindle = None;
                }
            }
            if in_spindle != Some(work.place) {
                sheet.push_block(Block::new().word('T', work.place).m(6), place(LineRole::ToolChange));
                in_spindle = Some(work.place);
            }
            one_tool(&mut sheet, work, work_ref, &runs[setup_index][work_index], &shared);
            away(&mut sheet, place(LineRole::Withdrawal));
        }
    }
    sheet.push_block(Block::new().m(2), BlockPurpose::of(LineRole::End));
    sheet.finish()
}

/// The runs of every work, by set-up.
type Runs = Vec<Vec<Vec<PointRun>>>;

/// How often each list of blocks over points occurs. The contour of a mill is called at each of its points, so its
/// list cannot be shared with another tool.
fn shared_points(job: &Job, runs: &Runs) -> BTreeMap<Vec<Block>, usize> {
    let mut counts = BTreeMap::new();
    for (work, runs) in job.setups.iter().flat_map(|setup| &setup.works).zip(runs.iter().flatten()) {
        for run in runs.iter().filter(|run| work.cycles.get(run.cycle).is_some_and(points::is_fixed)) {
            *counts.entry(run.blocks.clone()).or_insert(0) += 1;
        }
    }
    counts
}

/// Spindle, approach, and the runs of one tool.
fn one_tool(
    sheet: &mut ProgramWriter,
    work: &ToolWork,
    work_ref: WorkRef,
    runs: &[PointRun],
    shared: &BTreeMap<Vec<Block>, usize>,
) {
    let form = sheet.form;
    let mut before: Option<(&PointRun, &Cycle)> = None;
    for run in runs {
        let Some(cycle) = work.cycles.get(run.cycle) else { continue };
        let place = |role| BlockPurpose { role, work: Some(work_ref), cycle: Some(run.cycle) };
        let to = |block: Block| block.axis('X', run.first.x).axis('Y', run.first.y);
        let down = Block::new().g(0).axis('Z', form.grid(cycle.out));
        match &before {
            None => {
                let turning = Block::new().word('S', cycle.speed_rpm.0).m(3);
                let turning = if work.coolant { turning.m(8) } else { turning };
                sheet.push_block(turning, place(LineRole::Spindle));
                sheet.push_block(to(Block::new().g(0).g(work.frame.into())), place(LineRole::Approach));
                sheet.push_block(down.g(43).word('H', work.corrector), place(LineRole::Approach));
            }
            Some((last, known)) => {
                let mut block = Block::new();
                if last.incremental {
                    block = block.g(90);
                }
                // Cancelled in the block of the motion, so that the cycle before does not run at its end.
                if points::is_fixed(known) {
                    block = block.g(80);
                }
                if last.last != run.first {
                    block = to(block.g(0));
                }
                if known.speed_rpm != cycle.speed_rpm {
                    block = block.word('S', cycle.speed_rpm.0);
                }
                if block != Block::new() {
                    sheet.push_block(block, place(LineRole::Point));
                }
                if known.out != cycle.out {
                    sheet.push_block(down, place(LineRole::Approach));
                }
            }
        }
        put_run(sheet, work, run, place(LineRole::Cycle), shared);
        before = Some((run, cycle));
    }
}

/// The cycle at the first point, and the path over the others.
fn put_run(
    sheet: &mut ProgramWriter,
    work: &ToolWork,
    run: &PointRun,
    place: BlockPurpose,
    shared: &BTreeMap<Vec<Block>, usize>,
) {
    let Some(cycle) = work.cycles.get(run.cycle) else { return };
    let form = sheet.form;
    let contour = match &cycle.kind {
        CycleKind::Circles { plunge_mm_per_min, levels, radii, sense } => {
            Some(cycle::contour(cycle, (levels, radii, *sense), *plunge_mm_per_min, sheet, place))
        }
        CycleKind::Slot(slot) => Some(cycle::slot(cycle, slot, sheet, place)),
        _ => None,
    };
    if let Some(contour) = contour {
        sheet.call(&contour, None, place);
        for block in &run.blocks {
            sheet.call(&contour, Some(block.clone()), BlockPurpose { role: LineRole::Point, ..place });
        }
        return;
    }
    let fixed = sheet.subprogram(vec![cycle::fixed(cycle, run.incremental, form)], place);
    sheet.call(&fixed, None, place);
    let point = BlockPurpose { role: LineRole::Point, ..place };
    let blocks = drawn_together(sheet, &run.blocks);
    let again = shared.get(&run.blocks).copied().unwrap_or(1);
    if points::worth_sharing(&blocks, again) {
        let points = sheet.subprogram(blocks, BlockPurpose::of(LineRole::Point));
        sheet.call(&points, None, point);
    } else {
        for block in blocks {
            sheet.push_block(block, point);
        }
    }
}

/// Blocks, with repeated groups as a subprogram with L.
fn drawn_together(sheet: &mut ProgramWriter, blocks: &[Block]) -> Vec<Block> {
    let mut drawn = Vec::new();
    for piece in points::repeats(blocks) {
        match piece {
            points::Repeat::Once(block) => drawn.push(block),
            points::Repeat::Times(group, times) => {
                match sheet.subprogram(group.clone(), BlockPurpose::of(LineRole::Point)) {
                    BlockGroup::Subprogram(number) => drawn.push(Block::new().calls(number, times)),
                    BlockGroup::Blocks(_) => drawn.extend(std::iter::repeat_n(group, times).flatten()),
                }
            }
        }
    }
    drawn
}
