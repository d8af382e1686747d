//! The words of a control as data: table lathe-words.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, Table};

/// What a word is for: the column `use` of table lathe-words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Use {
    Plane,
    Millimetres,
    Diameters,
    RadiusCorrectionOff,
    Absolute,
    FeedPerRevolution,
    System,
    ExactPath,
    Tool,
    CuttingSpeed,
    SpindleSpeed,
    CoolantOn,
    Rapid,
    Line,
    Clockwise,
    Counterclockwise,
    SpindleStop,
    CoolantOff,
    End,
    ContourBegins,
    ContourEnds,
}

/// Each use with its name, and whether every control must have it.
const USES: [(&str, Use, bool); 21] = [
    ("plane", Use::Plane, true),
    ("millimetres", Use::Millimetres, true),
    ("diameters", Use::Diameters, true),
    ("radius-correction-off", Use::RadiusCorrectionOff, true),
    ("absolute", Use::Absolute, true),
    ("feed-per-revolution", Use::FeedPerRevolution, true),
    ("system", Use::System, true),
    ("exact-path", Use::ExactPath, false),
    ("tool", Use::Tool, true),
    ("cutting-speed", Use::CuttingSpeed, true),
    ("spindle-speed", Use::SpindleSpeed, true),
    ("coolant-on", Use::CoolantOn, true),
    ("rapid", Use::Rapid, true),
    ("line", Use::Line, true),
    ("clockwise", Use::Clockwise, true),
    ("counterclockwise", Use::Counterclockwise, true),
    ("spindle-stop", Use::SpindleStop, true),
    ("coolant-off", Use::CoolantOff, true),
    ("end", Use::End, true),
    ("contour-begins", Use::ContourBegins, false),
    ("contour-ends", Use::ContourEnds, false),
];

/// The words of one control.
#[derive(Clone, Debug, Default)]
pub(super) struct Words {
    words: BTreeMap<Use, String>,
    /// How a remark is written, with `{text}` in it.
    comment: String,
}

impl Words {
    /// The rows of a control.
    ///
    /// # Errors
    /// The table lacks a word that every control must have.
    pub fn read(control: &str, comment: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let table = knowledge.table("lathe-words")?;
        let mut words = BTreeMap::new();
        for row in table.all_rows().filter(|row| row.text("control") == Ok(control)) {
            let name = row.text("use")?;
            if let Some((_, known, _)) = USES.iter().find(|(known, ..)| *known == name) {
                words.insert(*known, row.text("word")?.to_owned());
            }
        }
        for (name, needed, required) in USES {
            if required && !words.contains_key(&needed) {
                return Err(lacking(table, control, name));
            }
        }
        Ok(Self { words, comment: comment.to_owned() })
    }

    /// A word; empty where the control has none.
    pub fn get(&self, wanted: Use) -> &str {
        self.words.get(&wanted).map(String::as_str).unwrap_or_default()
    }

    /// A word with what stands in it in braces filled in.
    pub fn filled(&self, wanted: Use, values: &[(&str, String)]) -> String {
        values
            .iter()
            .fold(self.get(wanted).to_owned(), |word, (name, value)| word.replace(&format!("{{{name}}}"), value))
    }

    /// A remark.
    pub fn comment(&self, text: &str) -> String {
        self.comment.replace("{text}", text)
    }
}

/// A table has no such row for a control.
fn lacking(table: &Table, control: &str, name: &str) -> KnowledgeError {
    KnowledgeError::no_row(table, &format!("control {control}, use {name}"))
}
