//! Programs for lathes: a toolpath as single moves, or a rough contour as the roughing cycle of a control.
//!
//! - [`Control`] is the language of a control, read from tables lathe-…; [`plain()`] and [`cycle()`] write programs;
//! - [`setting`] is the settings of a program besides its toolpath: tool, spindle, feeds, coolant;
//! - `words` are the words of a control, `text` the lines of a program with their modes;
//! - [`cycle`](mod@cycle) is a roughing task and its profile, `call` the call of a cycle with its fields;
//! - `linuxcnc` and `sinumerik` write a roughing cycle for their control; [`thread`] writes threading cycles; [`refused`] is why something is not written.
//!
//! docs/turning-programs.md has the fields with their sources, how arcs were decided, and how to add a control.

mod call;
pub mod cycle;
mod linuxcnc;
mod plain;
pub mod refused;
pub mod setting;
mod sinumerik;
mod text;
pub mod thread;
pub mod whole;
mod words;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::contract::Word;
use crate::tables::controls::lathe::{LatheControl, LatheControls};
use crate::turning::contour::{Contour, Side};
use crate::turning::jobs::ThreadCut;
use crate::turning::point::Point;
use technolog_core::ascii::ascii;
use technolog_note::note;

use call::Cycles;
use cycle::CycleCall;
pub use cycle::{Allowance, CycleProgram, Direction, ProgramFile, Roughing};
pub use plain::plain;
pub use refused::NotWritten;
pub use setting::{Feeds, Setting, Speed};
use text::ProgramWriter;
pub use thread::NotCycled;
use thread::ThreadWriter;
pub use whole::{CycleOf, FreeEnd, Seat, SectionCycle, SectionLoad, ToolSection, WholeProgram, warned, whole};
use words::ControlWords;

/// Writes the cycle of a task for a control.
type CycleWriter = fn(&Control, &Cycles, &cycle::CycleTask<'_>, &Setting, usize) -> Result<CycleCall, NotWritten>;

/// The controls with a writer of cycles: one line and one file each.
const WRITERS: [(LatheControl, CycleWriter); 2] =
    [(LatheControl::LinuxCnc, linuxcnc::write), (LatheControl::Sinumerik, sinumerik::write)];

/// The controls with a cycle for threads.
const THREADS: [(LatheControl, ThreadWriter); 3] = [
    (LatheControl::LinuxCnc, thread::linuxcnc),
    (LatheControl::Fanuc, thread::fanuc),
    (LatheControl::Sinumerik, thread::sinumerik),
];

/// The language of a lathe's control, as far as it is known.
#[derive(Clone, Debug)]
pub struct Control {
    /// Its name: `linuxcnc`, `sinumerik`, `nc-201`.
    pub name: String,
    /// None if no program is written for it.
    words: Option<ControlWords>,
    /// None if its roughing cycle cannot be written.
    cycles: Option<(Cycles, CycleWriter)>,
    /// None if its cycle for threads cannot be written.
    threads: Option<ThreadWriter>,
    /// Words that are known by name only.
    known_words: Vec<String>,
    /// The extension of its files.
    ending: String,
}

impl Control {
    /// The controls, as a user names them.
    pub const NAMES: &'static [&'static str] = LatheControl::WORDS;

    /// Reads the language of a control. A control of which little is known can be read, but no program is written for
    /// it.
    ///
    /// # Errors
    /// There is no such control, or one of its tables lacks a required row.
    pub fn read(name: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let table = knowledge.table_of::<LatheControls<'_>>()?;
        let control = LatheControl::from_word(name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
        let row = knowledge.need(name, |row: &LatheControls<'_>| row.control == control)?;
        let words = match (row.plain, row.comment) {
            (true, Some(comment)) => Some(ControlWords::read(&row, comment, knowledge)?),
            (true, None) => {
                return Err(KnowledgeError::missing(&table.id, note!("turned-comment-control-written-for")));
            }
            (false, _) => None,
        };
        let writer = WRITERS.iter().find(|(known, _)| *known == control).map(|(_, writer)| *writer);
        let cycles = match writer {
            Some(writer) if row.cycles => Some((Cycles::read(control, knowledge)?, writer)),
            _ => None,
        };
        let threads = THREADS.iter().find(|(known, _)| *known == control).map(|(_, writer)| *writer);
        let known_words = row.known_words.unwrap_or_default().into_iter().map(str::to_owned).collect();
        let ending = row.ending.unwrap_or_default().to_owned();
        Ok(Self { name: name.to_owned(), words, cycles, threads, known_words, ending })
    }

    /// The name of the cycle that cuts a thread.
    ///
    /// # Errors
    /// Why its passes are written one by one.
    pub fn thread_cycle(&self, cut: &ThreadCut, side: Side) -> Result<String, NotCycled> {
        let call = thread::call(self, cut, side)?;
        Ok(call.lines.chars().take_while(char::is_ascii_alphanumeric).collect())
    }

    /// The number of the offset of a tool, as the control counts it.
    pub fn offset(&self, seat: Seat) -> u32 {
        self.words.as_ref().map_or(seat.offset, |words| words.offset(seat))
    }

    fn words(&self) -> Result<&ControlWords, NotWritten> {
        self.words.as_ref().ok_or_else(|| self.not_documented())
    }

    fn not_documented(&self) -> NotWritten {
        NotWritten::NotDocumented { control: self.name.clone(), words: self.known_words.clone() }
    }
}

/// The stock over a rough contour as the roughing cycle of a control. `corner` is the corner of the blank before the
/// contour: the radius of its surface (for a bore: of the hole) and the Z of its free face.
///
/// # Errors
/// Why it cannot be written.
pub fn cycle(
    control: &Control,
    rough: &Contour,
    corner: Point,
    roughing: Roughing,
    setting: &Setting,
) -> Result<CycleProgram, NotWritten> {
    let Some((cycles, writer)) = &control.cycles else { return Err(control.not_documented()) };
    setting.check()?;
    let task = cycle::CycleTask::new(rough, corner, roughing)?;
    let call = writer(control, cycles, &task, setting, 0)?;
    let mut sheet = ProgramWriter::new(control.words()?);
    plain::begin(&mut sheet, control, setting)?;
    sheet.rapid(task.begins());
    sheet.lines(&call.before);
    sheet.lines(&call.call);
    plain::end(&mut sheet);
    let name = format!("{}{}", file_name(&setting.name), control.ending);
    let main = ProgramFile { name, text: sheet.finish() };
    Ok(CycleProgram { files: std::iter::once(main).chain(call.file).collect() })
}

/// The name of a part as a file name on a control: at most 14 Latin letters, digits and underscores, beginning with two
/// letters.
fn file_name(name: &str) -> String {
    let latin = ascii(name);
    let kept = latin.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' });
    let kept: String = kept.take(14).collect();
    let begins = kept.chars().take(2).filter(char::is_ascii_alphabetic).count() == 2;
    if begins { kept } else { format!("PT_{kept}").chars().take(14).collect() }
}
