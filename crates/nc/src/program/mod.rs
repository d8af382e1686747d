//! Programs of controls: writers and interpreters. There are two rooms for milling machines, [`control_2c42_65`], and
//! [`iso`] for all that read ISO 6983, which differ in their records; [`Language`] is one of them. [`proof`] compares the
//! motions of a program with a job.
//!
//! An interpreter turns the text of a program into steps of [`crate::motion`]; a writer does the opposite. An
//! interpreter reports [`Fault`]s: data, independent of language. [`setting`] is what the operator sets before a run.

mod alone;
mod below;
mod block;
mod brought;
mod contour;
pub mod control_2c42_65;
mod drilled;
mod expression;
pub mod iso;
pub mod lathe;
mod left_over;
mod limits;
mod named;
pub mod proof;
mod running;
pub mod seen;
pub mod setting;
mod stay;
mod walls;
mod widths;
pub mod written;

use serde::Serialize;
use technolog_note::note;

pub use expression::MOST_OPERATIONS;
pub use setting::Setting;

use crate::error::KnowledgeError;
use crate::job::Job;
use crate::knowledge::diagnostic::Diagnostic;
use crate::knowledge::{Knowledge, RowRef};
use crate::machine::Machine;
use crate::motion::{BlockRef, MotionStep, Sink};
use crate::note::{IntoFigure, Note, Severity};
use crate::plan::{Operation, Plan};
use crate::tables::controls::Letter;
use running::BUDGET;
use written::{Form, WrittenProgram};

/// The name of 2С42-65.
const OLD: &str = "2c42-65";

/// The language of a control, read from its tables.
#[derive(Clone, Debug)]
pub enum Language {
    /// 2С42-65.
    Control2c42(control_2c42_65::Control),
    /// A control that reads ISO 6983, by its record.
    Iso(iso::Control),
}

impl Language {
    /// The control that is meant where neither it nor a machine is named.
    pub const UNLESS_NAMED: &str = OLD;

    /// The controls, as a user names them: 2С42-65, then those that have a record.
    pub fn names(knowledge: &Knowledge) -> Vec<&str> {
        std::iter::once(OLD).chain(iso::Control::names(knowledge)).collect()
    }

    /// Reads the language of a control.
    ///
    /// # Errors
    /// There is no such control, or a table of it is missing or lacks what is required of it.
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        match control {
            OLD => control_2c42_65::Control::read(knowledge).map(Self::Control2c42),
            other => iso::Control::read(other, knowledge).map(Self::Iso),
        }
    }

    /// Reads a setting of this control.
    ///
    /// # Errors
    /// Every mistake of the file, each with its place and what to do.
    pub fn setting(&self, file: &str, text: &str) -> Result<Setting, Vec<Diagnostic>> {
        let limits = match self {
            Self::Control2c42(control) => control.setting(),
            Self::Iso(control) => control.setting(),
        };
        setting::read_setting(file, text, limits)
    }

    /// Leaves to another machine what the control cannot do of a plan: taps, where its spindle does not go with the feed.
    /// Returns whether anything was left.
    pub fn leave(&self, plan: &mut Plan) -> bool {
        match self {
            Self::Iso(control) if !control.taps() => plan.leave(Operation::Tap),
            _ => false,
        }
    }

    /// The machine function that a tapping cycle needs before it, if the control has one.
    pub fn tap_word(&self) -> Option<String> {
        let Self::Iso(control) = self else { return None };
        control.tap_word()
    }

    /// How grave a tool change is to which the spindle turns: by its record the change may stop it itself.
    pub fn turning_at_change(&self) -> Severity {
        match self {
            Self::Control2c42(_) => Severity::Wrong,
            Self::Iso(control) => control.turning_at_change(),
        }
    }

    /// The program of a job.
    pub fn write(&self, job: &Job, form: Form) -> WrittenProgram {
        match self {
            Self::Control2c42(_) => control_2c42_65::write(job, form),
            Self::Iso(control) => iso::write(job, control, form),
        }
    }

    /// A program that must not be run, with the reason in its first line. 2С42-65 has no remarks: there it is a line
    /// before the program, which the control passes over.
    pub fn warned(&self, written: WrittenProgram, reason: &str) -> WrittenProgram {
        let reason = format!("DO NOT RUN: {}", technolog_core::ascii::ascii(reason));
        match self {
            Self::Control2c42(control) => written.warned(format!("{} {reason}", control.tape_start()), true),
            Self::Iso(control) => written.warned(format!("({reason})"), control.reads_from_sign()),
        }
    }

    /// The machine that is meant where nobody names one: of 2С42-65 that on which its description has it. The other controls
    /// stand on machines of every kind, so none is meant.
    pub fn own_machine(&self) -> Option<&str> {
        match self {
            Self::Control2c42(control) => Some(control.described_on()),
            Self::Iso(_) => None,
        }
    }

    /// Checks a program: its text, then its run. The steps of the run are output to the sink; the faults are
    /// returned, sorted by place. Without a machine what depends on one is not checked, and a note says so; 2С42-65 is not
    /// run without one, because its description is that of a machine.
    pub fn check<'m, S: Sink>(
        &self,
        text: &str,
        machine: impl Into<Option<&'m Machine<'m>>>,
        setting: &Setting,
        sink: &mut S,
    ) -> Vec<Fault> {
        let machine = machine.into();
        match self {
            Self::Control2c42(control) => match machine {
                Some(machine) => control_2c42_65::check_within(BUDGET, text, control, machine, setting, sink),
                None => vec![control_2c42_65::without_machine()],
            },
            Self::Iso(control) => iso::check_within(BUDGET, text, control, machine, setting, sink),
        }
    }
}

/// Whether a program was run. A program with an error in its text is not, so missing holes are no findings then.
pub fn is_run(faults: &[Fault], steps: &[MotionStep]) -> bool {
    !steps.is_empty() || !faults.iter().any(Fault::is_error)
}

/// A stretch of one line of a program. Line and column count from one, in characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct TextSpan {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
    /// Characters, at least 1.
    pub width: u32,
}

/// A call of a subprogram that led to a block.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Call {
    /// The block that calls.
    #[serde(flatten)]
    pub from: BlockRef,
    /// The number of the subprogram.
    pub program: u8,
}

/// The chain of calls that leads to a block: `N5 → :02 N1`. A block without number is named by its line, `(12)`.
pub fn path(calls: &[Call], block: BlockRef) -> String {
    let name =
        |block: BlockRef| block.number.map_or_else(|| format!("({})", block.line), |number| format!("N{number}"));
    let mut path = String::new();
    for call in calls {
        path.push_str(&format!("{} → :{:02} ", name(call.from), call.program));
    }
    path + &name(block)
}

/// A fault or remark about a program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// The stable id of the rule that is broken; the note has it too.
    #[serde(skip)]
    pub code: &'static str,
    /// How grave: a program with an error is not run as written.
    pub severity: Severity,
    /// The rule: a section of the control's description, or of this project's reading of it.
    pub rule: &'static str,
    /// The number of the block, where it has one.
    pub block: Option<u32>,
    /// The calls through which the run first reached it, the outermost first; empty in the main program.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub calls: Vec<Call>,
    /// Where it stands.
    #[serde(flatten)]
    pub span: TextSpan,
    /// Its subject, where that distinguishes it from others of the same code.
    #[serde(skip)]
    pub subject: Option<Subject>,
    /// What is wrong.
    #[serde(flatten)]
    pub note: Note,
    /// Whether it is seen in a program by itself and a proof with the part says it better: offsets, dwells, which way the
    /// spindle turns, whose feed and speed act; the proof compares all of them with the plan. A tool that no change has
    /// brought is not of these: the proof tells what follows from it, and this the word that is missing.
    #[serde(skip)]
    pub of_program_alone: bool,
}

/// What a fault is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A tool, by its number.
    Tool(usize),
    /// A function, such as `G77`.
    Function(String),
    /// Functions that the program lacks.
    Missing(Vec<String>),
}

impl Fault {
    /// The path to its block, if known: the calls that lead there, then the number.
    pub fn path(&self) -> Option<String> {
        let block = BlockRef { line: self.span.line, number: self.block };
        (self.block.is_some() || !self.calls.is_empty()).then(|| path(&self.calls, block))
    }

    /// Whether the program is not carried out as written.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }

    /// Whether nobody may run the program: it is not carried out as written, or what it relies on is not so.
    pub fn is_grave(&self) -> bool {
        self.severity <= Severity::Wrong
    }

    /// A fault by a list of rules. A code that is not listed gives an error without a section; tests exclude that.
    fn of(rules: &[Rule], code: &'static str, span: TextSpan, block: Option<u32>) -> Self {
        let rule = rules.iter().find(|(known, ..)| *known == code);
        let (severity, rule) = rule.map_or((Severity::Error, ""), |(_, severity, section)| (*severity, *section));
        let (calls, note) = (Vec::new(), Note::new(code));
        Self { code, severity, rule, block, calls, span, subject: None, note, of_program_alone: false }
    }

    /// About that.
    #[must_use]
    fn about(mut self, subject: Subject) -> Self {
        self.subject = Some(subject);
        self
    }

    /// With one more figure.
    #[must_use]
    fn with(mut self, name: &'static str, value: impl IntoFigure) -> Self {
        self.note = self.note.with(name, value);
        self
    }
}

/// A rule for programs: its code, its severity, and the section that gives it.
type Rule = (&'static str, Severity, &'static str);

/// The figures of a row of a control's record, of which there must be some, in that unit; the first and all.
fn in_unit(
    figures: Option<&[f64]>,
    stated: Option<&str>,
    unit: &str,
    row: RowRef<'_>,
) -> Result<(f64, Vec<f64>), KnowledgeError> {
    match figures {
        Some(all @ [first, ..]) if stated == Some(unit) => Ok((*first, all.to_vec())),
        _ => Err(KnowledgeError::missing(
            &row.table.id,
            note!("nc-row-must-hold-figures", row = row.number(), unit = unit),
        )),
    }
}

fn letters(cells: Vec<Letter>) -> Vec<char> {
    cells.into_iter().map(|letter| letter.0).collect()
}
