//! Writes a job as a program in ISO 6983, as the record of its control says.
//!
//! The main program has for each tool its change, the spindle, the approach, its cycles and points. Subprograms are
//! the retract to the tool change, the contours of mills, and points that several tools visit. Positions are
//! absolute.
//!
//! - `dialect` what differs from control to control;
//! - `tool` one tool from its change to its retract; `expand` a cycle in single motions.

mod dialect;
mod expand;
mod tool;

use std::collections::BTreeMap;

use crate::job::{Job, Pause, ToolWork, Unfinished};
use crate::program::block::Block;
use crate::program::iso::control::{Characteristic as Q, Control};
use crate::program::written::{Form, LineRole, ProgramLine, WorkRef, WrittenProgram};
use technolog_core::ascii::ascii;

use dialect::{Dialect, Numbered};

/// Blocks of subprograms with the work they belong to.
type Subprograms = Vec<(Vec<Block>, Option<WorkRef>)>;

/// The numbers of the program and of its first subprogram, where its user gives none.
const MAIN: u32 = 1;
const FIRST_SUBPROGRAM: u32 = 101;
/// The last number of a program.
const LAST: u32 = 9999;

/// The program under construction.
struct ProgramWriter<'c> {
    form: Form,
    dialect: Dialect<'c>,
    main: Vec<PlacedLine>,
    subprograms: Subprograms,
}

/// A line of the main program with what it serves.
type PlacedLine = (MainLine, LineRole, Option<WorkRef>, Option<usize>);

/// A line of the main program.
#[derive(Clone, Debug)]
enum MainLine {
    Block(Block),
    /// A block with a comment after it.
    Remarked(Block, String),
    /// The call of a subprogram.
    Call(u32),
}

/// The program of a job.
pub fn write(job: &Job, control: &Control, form: Form) -> WrittenProgram {
    let dialect = Dialect(control);
    let form = Form { subprograms: form.subprograms && dialect.subprograms(), ..form };
    let mut sheet = ProgramWriter { form, dialect, main: Vec::new(), subprograms: Vec::new() };
    let axis = |value| sheet.dialect.length(form.grid(value));
    let (up, across) = (axis(job.change_at.z), [axis(job.change_at.x), axis(job.change_at.y)]);
    let withdrawal = dialect.withdrawal(up, across);
    let away = sheet.subprogram(withdrawal, None);
    for block in dialect.beginning() {
        sheet.push_block(block, LineRole::Frame, None, None);
    }
    sheet.call(away, LineRole::Withdrawal, None, None);
    let shared = tool::shared_points(job, form, dialect);
    let mut in_spindle = None;
    for (setup_index, setup) in job.setups.iter().enumerate() {
        for (work_index, work) in setup.works.iter().enumerate() {
            let work_ref = WorkRef { setup: setup_index, work: work_index };
            let place = Some(work_ref);
            for pause in &work.pauses {
                sheet.main.push((
                    MainLine::Remarked(Block::new().m(0), remark(*pause, work)),
                    LineRole::Pause,
                    place,
                    None,
                ));
                if matches!(pause, Pause::LoadTool { .. }) {
                    in_spindle = None;
                }
            }
            if in_spindle != Some(work.place) {
                let change = dialect.change(work.place);
                sheet.main.push((MainLine::Remarked(change, named(work)), LineRole::ToolChange, place, None));
                in_spindle = Some(work.place);
            }
            sheet.one_tool(work, work_ref, job, &shared);
            sheet.call(away, LineRole::Withdrawal, place, None);
        }
    }
    sheet.push_block(Block::new().m(30), LineRole::End, None, None);
    let unfinished: Vec<String> = job.unfinished.iter().map(Unfinished::remark).collect();
    sheet.finish(&ascii(&job.part), unfinished)
}

/// A tool for people: its number, name, diameter, offset register and designation, and what it is ground from.
fn named(work: &ToolWork) -> String {
    let name = work.operation.name().to_ascii_uppercase().replace('-', " ");
    let ToolWork { tool, diameter_mm, corrector, .. } = work;
    // A step drill makes two diameters with one stroke.
    let (step, also) = match work.also_diameter_mm {
        Some(also) => ("STEP ", format!("/D{also}")),
        None => ("", String::new()),
    };
    let ground = work.ground_from_mm.map(|from| format!(" GROUND FROM D{from}")).unwrap_or_default();
    format!("T{tool} {step}{name} D{diameter_mm}{also} H{corrector} {}{ground}", ascii(&work.designation))
}

/// What the operator does, in letters that every control can show.
fn remark(pause: Pause, work: &ToolWork) -> String {
    let designation = ascii(&work.designation);
    match pause {
        Pause::LoadTool { tool, place } => format!("LOAD TOOL {tool} INTO PLACE {place}: {designation}"),
        Pause::TurnOver => "TURN THE PART OVER ABOUT Y".to_owned(),
        Pause::SetBar { diameter_mm } => format!("SET THE BAR OF T{}, {designation}, TO D{diameter_mm}", work.tool),
    }
}

impl ProgramWriter<'_> {
    fn push_block(&mut self, block: Block, role: LineRole, work: Option<WorkRef>, cycle: Option<usize>) {
        self.main.push((MainLine::Block(block), role, work, cycle));
    }

    fn call(&mut self, number: u32, role: LineRole, work: Option<WorkRef>, cycle: Option<usize>) {
        self.main.push((MainLine::Call(number), role, work, cycle));
    }

    /// The number of a subprogram with these blocks; equal ones are one.
    fn subprogram(&mut self, blocks: Vec<Block>, work: Option<WorkRef>) -> u32 {
        let known = self.subprograms.iter().position(|(known, _)| *known == blocks);
        let index = known.unwrap_or_else(|| {
            self.subprograms.push((blocks, work));
            self.subprograms.len() - 1
        });
        self.form.subprogram(index)
    }

    fn finish(self, part: &str, remarks: Vec<String>) -> WrittenProgram {
        let Self { form, dialect, main, subprograms } = self;
        let plain = |text: String, role| ProgramLine { text, role, work: None, cycle: None };
        let mut before = Vec::new();
        let mut after = Vec::new();
        let number = form.program.unwrap_or(MAIN);
        // An o-word program has no number of its own, only its subprograms have.
        let mut numbers: Vec<u32> = dialect.numbers_programs().then_some(number).into_iter().collect();
        // An o-word must stand before its call, a program of its own behind the main one.
        let place = if dialect.0.is(Q::OWords) { &mut before } else { &mut after };
        let kept = if form.subprograms { subprograms.as_slice() } else { &[] };
        for (index, (blocks, work)) in kept.iter().enumerate() {
            let number = form.subprogram(index);
            numbers.push(number);
            let line = |text: String, role| ProgramLine { text, role, work: *work, cycle: None };
            place.push(line(dialect.subprogram_begins(number), LineRole::Frame));
            for (block, index) in blocks.iter().zip(1..) {
                place.push(line(Numbered(index, block.text()).to_string(), LineRole::Cycle));
            }
            place.push(line(dialect.subprogram_ends(number), LineRole::End));
        }
        let sign = || dialect.0.is(Q::Signs).then(|| plain("%".to_owned(), LineRole::Frame));
        let mut lines: Vec<ProgramLine> = sign().into_iter().collect();
        let head = dialect.numbers_programs().then_some(lines.len());
        let remarks = dialect.notice().into_iter().chain(remarks).map(|remark| format!("({remark})"));
        lines.extend(dialect.head(part, number).into_iter().chain(remarks).map(|text| plain(text, LineRole::Frame)));
        lines.append(&mut before);
        let main = if form.subprograms { main } else { inlined(main, &subprograms, form) };
        let step = if main.len() * form.number_step as usize > 9999 { 1 } else { form.number_step as usize };
        let of_blocks = (1..).map(|index: usize| index * step.max(1) % 10_000);
        for ((piece, role, work, cycle), number) in main.into_iter().zip(of_blocks) {
            let text = match piece {
                MainLine::Block(block) => Numbered(number, block.text()).to_string(),
                MainLine::Remarked(block, remark) => format!("{} ({remark})", Numbered(number, block.text())),
                MainLine::Call(called) => dialect.call(number, called),
            };
            lines.push(ProgramLine { text, role, work, cycle });
        }
        lines.append(&mut after);
        lines.extend(sign());
        WrittenProgram { lines, numbers, head }
    }
}

/// The main program with the blocks of its subprograms where it calls them.
fn inlined(main: Vec<PlacedLine>, subprograms: &Subprograms, form: Form) -> Vec<PlacedLine> {
    let numbers: BTreeMap<u32, &[Block]> = subprograms
        .iter()
        .enumerate()
        .map(|(index, (blocks, _))| (form.subprogram(index), blocks.as_slice()))
        .collect();
    let mut lines = Vec::new();
    for (line, role, work, cycle) in main {
        match line {
            MainLine::Call(number) => {
                let blocks = numbers.get(&number).copied().unwrap_or_default();
                lines.extend(blocks.iter().map(|block| (MainLine::Block(block.clone()), role, work, cycle)));
            }
            line => lines.push((line, role, work, cycle)),
        }
    }
    lines
}

impl Form {
    /// The number of a subprogram by its place: behind that of the program, and from the first one on behind the last.
    fn subprogram(self, index: usize) -> u32 {
        let index = u32::try_from(index).unwrap_or_default();
        let number = self.program.map_or(FIRST_SUBPROGRAM, |program| program + 1) + index;
        if number > LAST { number - LAST } else { number }
    }
}

/// How often each list of points occurs.
type Shared = BTreeMap<Vec<Block>, usize>;
