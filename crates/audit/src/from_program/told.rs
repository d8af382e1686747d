//! What a program says of its tools: comments beside the tool change or in a list at its head, and a list of tools in a file of its own.
//! The table `audit-program-words` says what the words mean.

use std::collections::BTreeMap;

use technolog_core::ascii::{ascii, says};

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::motion::{Motion, MotionStep};
use crate::plan::Operation;
use crate::tables::audit::{ProgramWords, ToolKind, ToolStage};

use super::super::quantity::Quantity as Q;
use super::super::stated::{Figures, Stated};

/// What is told of a tool.
#[derive(Clone, Debug, Default)]
pub(super) struct Told {
    /// Where.
    pub line: u32,
    pub kind: Option<ToolKind>,
    pub stage: Option<ToolStage>,
    /// What a list says it does.
    pub operation: Option<Operation>,
    /// Its diameter, mm; of a tap that of its thread.
    pub diameter: Option<f64>,
    /// The wide diameter of a step drill, mm.
    pub also: Option<f64>,
    pub designation: Option<String>,
    pub standard: Option<String>,
    pub holder: Option<String>,
    pub figures: Figures,
}

impl Told {
    /// The diameter that it makes of a hole, where its own is that.
    pub(super) fn cuts(&self, operation: Operation) -> Option<f64> {
        self.diameter.filter(|_| is_of_size(operation))
    }

    /// Whether neither a diameter nor a designation is told.
    pub(super) fn has_no_size(&self) -> bool {
        self.diameter.is_none() && self.designation.is_none()
    }
}

/// All tools.
#[derive(Debug, Default)]
pub(super) struct ToldTools(BTreeMap<u32, Told>);

impl ToldTools {
    /// Reads comments, where the control has them, and the list.
    ///
    /// # Errors
    /// The table of words cannot be read.
    pub fn read(
        text: &str,
        steps: &[MotionStep],
        list: Option<&Stated>,
        has_comments: bool,
        knowledge: &Knowledge,
    ) -> Result<Self, KnowledgeError> {
        let words = knowledge.rows::<ProgramWords<'_>>()?;
        let mut tools = Self::default();
        let changes: Vec<(u32, u32)> = steps
            .iter()
            .filter_map(|step| match step.motion {
                Motion::ToolChange { tool } => Some((step.block.line, tool)),
                _ => None,
            })
            .collect();
        for (line, comment) in comments(text).into_iter().filter(|_| has_comments) {
            let comment = ascii(&comment);
            let named = number_of(&comment);
            // Beside the change, in the line before it or in the one behind.
            let at = [line, line + 1, line.saturating_sub(1)];
            let beside = at.iter().find_map(|at| changes.iter().find(|(of, _)| of == at)).map(|(_, tool)| *tool);
            let Some(tool) = named.or(beside) else { continue };
            tools.0.entry(tool).or_default().takes(&comment, line, &words);
        }
        for tool in list.into_iter().flat_map(|list| &list.tools) {
            let own = tools.0.entry(tool.number).or_default();
            own.line = tool.place.line;
            let value = |text: &Option<super::Text>| text.as_ref().map(|text| text.value.clone());
            own.designation = value(&tool.designation).or(own.designation.take());
            own.standard = value(&tool.standard);
            own.holder = value(&tool.holder);
            own.figures = tool.figures.clone();
            own.figures.remove(&Q::Corrector);
            own.figures.remove(&Q::Correction);
        }
        for row in list.into_iter().flat_map(|list| &list.rows) {
            let Some(tool) = &row.tool else { continue };
            let own = tools.0.entry(tool.value).or_default();
            // A tool that does several things says none of them.
            own.operation = match own.operation {
                Some(other) if other != row.operation.value => None,
                _ => Some(row.operation.value),
            };
            // Of a spot, a chamfer or a bored hole the list has the size that is made, which is not the tool's.
            let made = row.figures.get(&Q::Diameter).filter(|_| is_of_size(row.operation.value));
            own.diameter = made.map(|figure| figure.value).or(own.diameter);
        }
        Ok(tools)
    }

    /// What is told of a tool.
    pub fn of(&self, tool: u32) -> Option<&Told> {
        self.0.get(&tool)
    }
}

impl Told {
    /// One more comment on it. The first that says something counts.
    fn takes(&mut self, comment: &str, line: u32, words: &[ProgramWords<'_>]) {
        let found = words.iter().filter(|row| says(comment, row.word));
        for row in found {
            if self.kind.is_none() && row.kind.is_some() {
                (self.kind, self.line) = (row.kind, line);
            }
            if self.stage.is_none() {
                self.stage = row.stage;
            }
        }
        if self.diameter.is_none() {
            (self.diameter, self.also) = sizes(comment);
        }
        if self.designation.is_none() {
            self.designation = designation(comment);
        }
    }
}

/// Whether the tool of an operation makes holes of its own diameter.
const fn is_of_size(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::Drill
            | Operation::DrillOut
            | Operation::CoreDrill
            | Operation::RoughReam
            | Operation::FinishReam
            | Operation::Counterbore
            | Operation::Tap
    )
}

/// The comments of a program with their lines: in brackets, or behind a semicolon.
fn comments(text: &str) -> Vec<(u32, String)> {
    let mut found = Vec::new();
    for (line, own) in (1..).zip(text.lines()) {
        let mut rest = own;
        while let Some((_, inside)) = rest.split_once('(') {
            let (comment, behind) = inside.split_once(')').unwrap_or((inside, ""));
            found.push((line, comment.to_owned()));
            rest = behind;
        }
        if let Some((_, comment)) = rest.split_once(';') {
            found.push((line, comment.to_owned()));
        }
    }
    found
}

/// The number of the tool that a comment begins with: `T1 DRILL D10`, `TOOL 1: …`.
fn number_of(comment: &str) -> Option<u32> {
    let rest = comment.trim_start();
    let rest = rest.strip_prefix("TOOL").unwrap_or_else(|| rest.strip_prefix('T').unwrap_or("-")).trim_start();
    let digits: String = rest.trim_start_matches(['#', '-', ' ']).chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok().filter(|number| *number > 0 && !rest.starts_with('-'))
}

/// The diameter that a comment names, mm, and the wide one of a step drill: `D10`, `D=10.`, `DIA 10`, `10MM`, `D7/D11`, `M8`.
fn sizes(comment: &str) -> (Option<f64>, Option<f64>) {
    let spaced: String =
        comment.chars().map(|sign| if matches!(sign, '=' | ':' | ',' | ';') { ' ' } else { sign }).collect();
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let number = |text: &str| -> Option<f64> {
        let end = text.find(|sign: char| !sign.is_ascii_digit() && sign != '.').unwrap_or(text.len());
        text.get(..end)?.trim_end_matches('.').parse().ok().filter(|value: &f64| *value > 0.0)
    };
    for (at, word) in words.iter().enumerate() {
        let next = words.get(at + 1).copied().unwrap_or_default();
        if let Some(rest) =
            ["DIAMETER", "DIAM", "DIA", "DIAM.", "DIA.", "D"].iter().find_map(|sign| word.strip_prefix(sign))
        {
            let rest = rest.trim_start_matches('.');
            let own = number(rest).or_else(|| number(next).filter(|_| rest.is_empty()));
            if let Some(own) = own {
                let also = rest.split_once('/').and_then(|(_, wide)| number(wide.trim_start_matches('D')));
                return (Some(own), also);
            }
        }
        if let Some(own) = word.strip_prefix('M').and_then(number) {
            return (Some(own), None);
        }
        if word.ends_with("MM") || next == "MM" {
            let bare = word.trim_end_matches("MM");
            if bare.bytes().all(|sign| sign.is_ascii_digit() || sign == b'.')
                && let Some(own) = number(bare)
            {
                return (Some(own), None);
            }
        }
    }
    (None, None)
}

/// A number of a catalog in a comment: digits with dashes, or a long row of digits.
fn designation(comment: &str) -> Option<String> {
    let is_number = |word: &&str| {
        let digits = word.bytes().filter(u8::is_ascii_digit).count();
        digits >= 6 && word.bytes().all(|sign| sign.is_ascii_digit() || sign == b'-')
    };
    comment.split_whitespace().find(is_number).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comment_tells_number_size_and_designation() {
        for (comment, tool, size, also, name) in [
            ("T1 CENTRE DRILL D16 H1 035-2317-0103", Some(1), Some(16.0), None, Some("035-2317-0103")),
            ("T3  D=10. CR=0. TAPER=118DEG - ZMIN=-25. - DRILL", Some(3), Some(10.0), None, None),
            ("TOOL 2 - DIA 8.5 DRILL", Some(2), Some(8.5), None, None),
            ("T2 STEP DRILL D7/D11 H2 2310-0383", Some(2), Some(7.0), Some(11.0), Some("2310-0383")),
            ("M8X1.25 TAP", None, Some(8.0), None, None),
            ("10MM DRILL", None, Some(10.0), None, None),
            ("DRILL ALL HOLES", None, None, None, None),
            ("TAP", None, None, None, None),
        ] {
            assert_eq!(number_of(comment), tool, "{comment}");
            assert_eq!(sizes(comment), (size, also), "{comment}");
            assert_eq!(designation(comment).as_deref(), name, "{comment}");
        }
    }

    #[test]
    fn comments_stand_in_brackets_or_behind_a_semicolon() {
        let text = "T1 M6 (DRILL) (D10)\nG0 X1 ; spot\n";
        let found: Vec<(u32, String)> = comments(text);
        assert_eq!(found, [(1, "DRILL".to_owned()), (1, "D10".to_owned()), (2, " spot".to_owned())]);
    }
}
