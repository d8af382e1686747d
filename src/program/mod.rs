//! Programs of controls: today one interpreter, [`control_2c42_65`].
//!
//! An interpreter reads the text of a program and makes the steps of [`crate::motion`] of it. A writer is the same way
//! backwards. What an interpreter has to say about a program are [`Fault`]s: data, without a language.

pub mod control_2c42_65;

use serde::Serialize;

use crate::motion::BlockRef;
use crate::note::{Note, Severity};

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

/// A call of a subprogram, on the way to a block.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Call {
    /// The block that calls.
    #[serde(flatten)]
    pub from: BlockRef,
    /// The number of the subprogram.
    pub program: u8,
}

/// The way to a block through the calls: `N5 → :02 N1`. A block without number is named by its line, `(12)`.
pub fn path(calls: &[Call], block: BlockRef) -> String {
    let name =
        |block: BlockRef| block.number.map_or_else(|| format!("({})", block.line), |number| format!("N{number}"));
    let mut path = String::new();
    for call in calls {
        path.push_str(&format!("{} → :{:02} ", name(call.from), call.program));
    }
    path + &name(block)
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
    /// The calls by which the run came there for the first time, the outermost first; none in the main program.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub calls: Vec<Call>,
    /// Where it stands.
    #[serde(flatten)]
    pub span: Span,
    /// What is wrong.
    #[serde(flatten)]
    pub note: Note,
}

impl Fault {
    /// The way to its block, where it is known: the number, behind the calls that led there.
    pub fn path(&self) -> Option<String> {
        let block = BlockRef { line: self.span.line, number: self.block };
        (self.block.is_some() || !self.calls.is_empty()).then(|| path(&self.calls, block))
    }

    /// Whether the program is not carried out as written.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
