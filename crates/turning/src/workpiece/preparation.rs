//! The preparation of a blank before it comes to the lathe, and contradictions to it in the file (lecture 12.1, l.
//! 105-125): the rules `turning-blank` and `turning-blank-preparation`.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::turning::part::{PartsOfBlank, TurningBlankFor, TurningBlankPreparationFor};

use super::Workpiece;

/// Advice on the blank, with its row.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Advice {
    /// A required preparation (a note), or a contradiction of the file to the rules (wrong).
    #[serde(flatten)]
    pub finding: Finding,
    /// The row.
    pub because: Because,
}

/// The advice of the rules on the blank of a workpiece: the number of its parts, the accuracy of its length, and its
/// preparation.
///
/// # Errors
/// The knowledge base lacks a rule, or a row for this blank.
pub fn advice(workpiece: &Workpiece, knowledge: &Knowledge) -> Result<Vec<Advice>, KnowledgeError> {
    let stock = workpiece.blank.kind;
    let diameter = workpiece.blank.largest_diameter();
    let mut all = Vec::new();
    let mut say = |severity, note: Note, because: Because| {
        all.push(Advice { finding: Finding::of_part(severity, note), because });
    };

    let asked = knowledge.ask(&TurningBlankFor { stock, diameter })?;
    let rule = asked.need(stock.name())?;
    let parts = Note::new(match rule.parts {
        PartsOfBlank::Several => "blank-for-several-parts",
        PartsOfBlank::One => "blank-for-one-part",
    });
    let parts = parts.with("diameter", diameter);
    say(Severity::Note, parts.clone(), Because::answer(&asked.answer, parts));

    let most = rule.length_deviation;
    let (severity, note) = match workpiece.blank.length_tolerance {
        Some(given) if given > most => (Severity::Wrong, Note::new("blank-length-too-coarse").with("given", given)),
        _ => (Severity::Note, Note::new("blank-length-deviation")),
    };
    let note = note.with("most", most);
    say(severity, note.clone(), Because::answer(&asked.answer, note));

    let (holding, heat_treatment) = (workpiece.holding, workpiece.heat_treatment);
    for rule in knowledge.ask(&TurningBlankPreparationFor { stock, holding, heat_treatment })?.winners()? {
        let severity = if rule.contradicts { Severity::Wrong } else { Severity::Note };
        let note = Note::new(format!("blank-{}", rule.action));
        say(severity, note.clone(), Because::row(rule.row, note));
    }
    Ok(all)
}
