//! The encoding sheet of a program (карта кодування інформації, GOST 3.1404-86, form 5a): transition, block, meaning.
//!
//! The textbook's sheet (Appendix Г, l. 10380-10505) has two columns, the content of the transition and that of the
//! block, under a head of equipment and special instructions. The columns of tool and offset register and of the
//! meaning in words are additions, and marked.
//!
//! - `blocks` a line as words; `dictionary` their meaning, from the tables of the control; `print` the sheet as a
//!   page.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::job::{Job, ToolWork};
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::plan::Plan;
use crate::program::written::{LineRole, WorkRef, WrittenProgram};
use crate::tables::controls::iso::{Characteristic, Record};

use super::sheet::mm;
use super::words::say;
use super::{Lang, transitions};

mod blocks;
mod dictionary;
mod print;

pub use dictionary::Dictionary;

/// The sheet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct EncodingSheet {
    /// The form it follows.
    pub form: &'static str,
    /// The part; absent for a program without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// Machine and control.
    pub equipment: String,
    /// The operator's setting before the start: zeros, offset registers.
    pub instructions: Vec<String>,
    /// One row for each block.
    pub rows: Vec<SheetRow>,
    /// The fields that the textbook's sheet does not have.
    pub supplied: [&'static str; 3],
    /// The language of its words.
    #[serde(skip)]
    lang: Lang,
}

/// A block on the sheet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SheetRow {
    /// The line of the program, from 1.
    pub line: usize,
    /// The transition that begins here, or the operator's task.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transition: Option<String>,
    /// The tool and the offset registers in the block: `T1`, `H01`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<String>,
    /// The block as written, with its end.
    pub code: String,
    /// Its meaning, word by word.
    pub meaning: String,
}

/// The name of the form in JSON, the same in every language.
const FORM: &str = "ГОСТ 3.1404-86, форма 5а";
const SUPPLIED: [&str; 3] = ["instructions", "tool", "meaning"];

/// The sheet of a program that was written for a job.
///
/// # Errors
/// There are no tables of words for the control, or they lack a meaning.
pub fn encoding_sheet(
    written: &WrittenProgram,
    job: &Job,
    plan: &Plan,
    control: &str,
    knowledge: &Knowledge,
    lang: Lang,
) -> Result<EncodingSheet, KnowledgeError> {
    let mut sheet = sheet_of_text(&written.text(), &job.machine, control, knowledge, lang)?;
    sheet.part = Some(job.part.clone());
    sheet.instructions = instructions(job, lang);
    let named = written.lines.iter().filter_map(|line| Some((line.work?, line.cycle?))).collect();
    let mut seen = SeenTransitions { named, ..SeenTransitions::default() };
    for row in &mut sheet.rows {
        let Some(line) = written.lines.get(row.line - 1) else { continue };
        let Some((at, work)) = line.work.and_then(|at| Some((at, work_of(job, at)?))) else { continue };
        row.transition = match line.role {
            LineRole::Pause => seen.pause(at, work, plan, lang),
            _ => seen.transition(at, work, line.cycle, plan, lang),
        };
    }
    Ok(sheet)
}

/// The sheet of any program: its blocks and their meaning.
///
/// # Errors
/// There are no tables of words for the control, or they lack a meaning; the machine is not known.
pub fn sheet_of_text(
    text: &str,
    machine: &str,
    control: &str,
    knowledge: &Knowledge,
    lang: Lang,
) -> Result<EncodingSheet, KnowledgeError> {
    let dictionary = Dictionary::read(control, knowledge)?;
    let mut modes = dictionary::Modes::default();
    let mut rows = Vec::new();
    let end = end(control, knowledge)?;
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let found = blocks::words_of_line(line);
        let tool = dictionary.tool(&found);
        let meaning = dictionary.meaning(&found, &mut modes, lang);
        // The sign of a tape is no block and has no end.
        let end = if found == [blocks::Word::Tape] { "" } else { end };
        let code = format!("{} {end}", line.trim()).trim_end().to_owned();
        rows.push(SheetRow { line: index + 1, transition: None, tool, code, meaning });
    }
    // A machine without a record is an error, so that nobody reads a sheet of another one.
    let named = &Machine::find(knowledge, machine)?.table.title;
    // The title of a table stands in the table, in both languages.
    let machine = named.text(lang.tag());
    let equipment = say!(lang, "encoding-equipment-is", machine = machine, control = name(control, lang));
    Ok(EncodingSheet { form: FORM, part: None, equipment, instructions: Vec::new(), rows, supplied: SUPPLIED, lang })
}

/// The name of a control for people; without one, that of the command line.
fn name(control: &str, lang: Lang) -> &str {
    lang.term("control", control)
}

/// The end of a block on paper: LF on the textbook's sheet, else what the record of the control says.
fn end<'k>(control: &str, knowledge: &'k Knowledge) -> Result<&'k str, KnowledgeError> {
    if control == "2c42-65" {
        return Ok("LF");
    }
    Ok(Record::text(control, Characteristic::BlockEnd, knowledge)?.unwrap_or_default())
}

fn work_of(job: &Job, at: WorkRef) -> Option<&ToolWork> {
    job.setups.get(at.setup)?.works.get(at.work)
}

/// The zero of the part, and the values of the offset registers.
fn instructions(job: &Job, lang: Lang) -> Vec<String> {
    let mut lines = Vec::new();
    for setup in &job.setups {
        let zero = setup.zero;
        lines.push(say!(lang, "encoding-zero", setup = setup.number, x = zero.x, y = zero.y, z = zero.z));
    }
    let registers: Vec<String> =
        job.correctors.iter().map(|(number, value)| format!("H{number:02} = {}", mm(*value, lang))).collect();
    if !registers.is_empty() {
        lines.push(say!(lang, "encoding-correctors", held = registers.join("; ")));
    }
    lines
}

/// The transitions already on the sheet: each is printed at its first block only.
#[derive(Debug, Default)]
struct SeenTransitions {
    /// The cycles that have blocks of their own.
    named: Vec<(WorkRef, usize)>,
    works: Vec<WorkRef>,
    cycles: Vec<(WorkRef, usize)>,
    pauses: Vec<WorkRef>,
}

impl SeenTransitions {
    /// The transitions that begin at a block: at the first block of a work, all that have no block of their own, or
    /// all if there is one cycle only; at the first block of a cycle, those of that cycle.
    fn transition(
        &mut self,
        at: WorkRef,
        work: &ToolWork,
        cycle: Option<usize>,
        plan: &Plan,
        lang: Lang,
    ) -> Option<String> {
        let mut begin: Vec<usize> = cycle.into_iter().collect();
        if !self.works.contains(&at) {
            self.works.push(at);
            let alone = work.cycles.len() == 1;
            begin.extend((0..work.cycles.len()).filter(|own| alone || !self.named.contains(&(at, *own))));
        }
        begin.retain(|own| !self.cycles.contains(&(at, *own)));
        self.cycles.extend(begin.iter().map(|own| (at, *own)));
        Some(transitions::sentence(plan, work, &begin, lang)).filter(|text| !text.is_empty())
    }

    /// The pauses of a work in order, one at each of its pause blocks.
    fn pause(&mut self, at: WorkRef, work: &ToolWork, plan: &Plan, lang: Lang) -> Option<String> {
        let before = self.pauses.iter().filter(|known| **known == at).count();
        self.pauses.push(at);
        let pause = work.pauses.get(before)?;
        Some(transitions::pause(*pause, &plan.part, lang))
    }
}
