//! What must be done to a blank before it comes to the lathe, and what in the file contradicts that (lecture 12.1,
//! l. 105-125): the rules `turning-blank` and `turning-blank-preparation`.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::{Input, Knowledge};
use crate::note::{Because, Finding, Note, Severity};

use super::{HeatTreatment, Workpiece};

/// A word on the blank, with the row that it rests on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Advice {
    /// What must be done (a note), or what in the file contradicts the rules (wrong).
    #[serde(flatten)]
    pub finding: Finding,
    /// The row.
    pub because: Because,
}

/// What the rules say of the blank of a workpiece: how many parts it is for, how exact its length must be, and what is
/// done to it beforehand.
///
/// # Errors
/// The knowledge base lacks a rule, or a row for this blank.
pub fn advice(workpiece: &Workpiece, knowledge: &Knowledge) -> Result<Vec<Advice>, KnowledgeError> {
    let stock = Input::Text(workpiece.blank.kind.name());
    let diameter = workpiece.blank.largest_diameter();
    let mut said = Vec::new();
    let mut say = |severity, note: Note, because: Because| {
        said.push(Advice { finding: Finding::of_part(severity, note), because });
    };

    let table = knowledge.table("turning-blank")?;
    let answer = table.decide(&[("stock", stock), ("diameter", Input::Length(diameter))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(table, workpiece.blank.kind.name()))?;
    let parts = match row.text("parts")? {
        "several" => Note::new("blank-for-several-parts"),
        _ => Note::new("blank-for-one-part"),
    };
    let parts = parts.with("diameter", diameter);
    say(Severity::Note, parts.clone(), Because::answer(&answer, parts));

    let most = row.length("length_deviation")?;
    let (severity, note) = match workpiece.blank.length_tolerance {
        Some(given) if given > most => (Severity::Wrong, Note::new("blank-length-too-coarse").with("given", given)),
        _ => (Severity::Note, Note::new("blank-length-deviation")),
    };
    let note = note.with("most", most);
    say(severity, note.clone(), Because::answer(&answer, note));

    let table = knowledge.table("turning-blank-preparation")?;
    let name = |heat| HeatTreatment::NAMES.iter().find(|(_, one)| *one == heat).map_or("none", |(name, _)| name);
    let answer = table.decide(&[
        ("stock", stock),
        ("holding", Input::Text(workpiece.holding.name())),
        ("heat_treatment", Input::Text(name(workpiece.heat_treatment))),
    ])?;
    for row in answer.winners() {
        let contradicted = row.flag("contradicts");
        let code = format!("blank-{}", row.text("action")?);
        let severity = if contradicted { Severity::Wrong } else { Severity::Note };
        let note = Note::new(&code);
        say(severity, note.clone(), Because::row(row, note));
    }
    Ok(said)
}
