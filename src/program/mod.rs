//! Programs of controls: today [`control_2c42_65`], written and read back.
//!
//! An interpreter reads the text of a program and makes the steps of [`crate::motion`] of it. A writer is the same way
//! backwards. What an interpreter has to say about a program are [`Fault`]s: data, without a language.

mod block;
pub mod control_2c42_65;
pub mod iso_writer;
pub mod written;

use serde::Serialize;

use crate::job::Job;
use crate::motion::Axis;
use crate::note::{Note, Severity};
use control_2c42_65::Setting;

/// A stretch of one line of a program. Line and column count from one, in characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Span {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
    /// Characters, at least 1.
    pub width: u32,
}

/// Something about a program that its reader must know.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// The stable id of the rule that is broken; the note has it too.
    #[serde(skip)]
    pub code: &'static str,
    /// How grave: a program with an error is not carried out as written.
    pub severity: Severity,
    /// The rule: a section of the control's description, or of this project's reading of it.
    pub rule: &'static str,
    /// The number of the block, where it has one.
    pub block: Option<u32>,
    /// Where it stands.
    #[serde(flatten)]
    pub span: Span,
    /// What is wrong.
    #[serde(flatten)]
    pub note: Note,
}

impl Fault {
    /// Whether the program is not carried out as written.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// What the operator sets for a job: the zeros of its set-ups in G54, G55, and the correctors.
pub fn job_setting(job: &Job) -> Setting {
    let mut setting = Setting::default();
    for setup in &job.setups {
        let system = usize::try_from(setup.number).unwrap_or(1).saturating_sub(1);
        if let Some(zero) = setting.zeros.get_mut(system) {
            *zero = Axis::ALL.map(|axis| Some(setup.zero.get(axis)));
        }
    }
    setting.correctors = job.correctors.iter().copied().collect();
    setting
}
