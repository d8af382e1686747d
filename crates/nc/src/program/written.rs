//! The output of a writer: program lines, each with the part of the job that it serves.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::part::Point;
use crate::shop::Shop;
use crate::tables::controls::Convention;
use crate::units::Micrometres;

/// What a program needs from the machine and the conventions.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// The least step of the axes: coordinates are multiples of it.
    pub resolution: Micrometres,
    /// The increment of block numbers.
    pub number_step: u32,
    /// The number of the program, where its user gives one: subprograms have those that follow.
    pub program: Option<u32>,
    /// Whether it may have subprograms.
    pub subprograms: bool,
}

impl Form {
    /// The form for the machine at hand.
    ///
    /// # Errors
    /// The table of conventions lacks a figure.
    pub fn read(shop: &Shop<'_>) -> Result<Self, KnowledgeError> {
        let (step, _) = crate::job::convention(Convention::BlockNumberStep, shop.knowledge)?;
        Ok(Self { resolution: shop.machine.resolution, number_step: step as u32, program: None, subprograms: true })
    }

    /// A length rounded to the machine's grid.
    pub fn grid(self, value: Micrometres) -> Micrometres {
        value.on_grid(self.resolution)
    }

    /// A point rounded to the machine's grid.
    pub fn point(self, at: Point) -> Point {
        Point { x: self.grid(at.x), y: self.grid(at.y) }
    }
}

/// A program in the language of a control.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct WrittenProgram {
    /// Its lines, in order.
    pub lines: Vec<ProgramLine>,
    /// The numbers of the programs in it, of the main one first where it has one.
    #[serde(skip)]
    pub numbers: Vec<u32>,
    /// The line with the number of the main program, where a remark may stand behind it.
    #[serde(skip)]
    pub head: Option<usize>,
}

impl WrittenProgram {
    /// The same program with a first line that says why it must not be run. LinuxCNC reads its text from the first
    /// sign `%` on only where that is the first line, so there the signs go.
    #[must_use]
    pub(super) fn warned(mut self, line: String, keeps_signs: bool) -> Self {
        let told = ProgramLine { text: line, role: LineRole::Frame, work: None, cycle: None };
        // What stands before the first sign a control does not keep: a remark stands behind the number, too.
        if let Some(head) = self.head.take() {
            self.lines.insert(head + 1, told.clone());
        }
        self.lines.retain(|line| keeps_signs || line.text != "%");
        self.lines.insert(0, told);
        self
    }

    /// The text of the program file.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in &self.lines {
            text.push_str(&line.text);
            text.push('\n');
        }
        text
    }
}

/// A line of a program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ProgramLine {
    /// As it stands in the file, without its end.
    pub text: String,
    /// Its purpose.
    pub role: LineRole,
    /// The work it belongs to; absent if it serves several or none.
    pub work: Option<WorkRef>,
    /// The cycle of that work, where it is for one.
    pub cycle: Option<usize>,
}

/// A work of a job: the places of its set-up and of itself, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct WorkRef {
    /// Place in [`crate::job::Job::setups`].
    pub setup: usize,
    /// Place in [`crate::job::SetUp::works`].
    pub work: usize,
}

/// The purpose of a program line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineRole {
    /// The frame of a program or subprogram: its number, its functions of the beginning.
    Frame,
    /// The operator does something.
    Pause,
    /// A tool comes.
    ToolChange,
    /// The spindle and the coolant.
    Spindle,
    /// To the first point and down to it.
    Approach,
    /// A cycle is set up, or a contour run.
    Cycle,
    /// To a further point.
    Point,
    /// The retract to the tool change.
    Withdrawal,
    /// The end of a program or subprogram.
    End,
}
