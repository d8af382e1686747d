//! The words of a control as data: table lathe-words.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::tables::controls::lathe::{LatheControls, LatheWords, LeadAlong};
use crate::turning::contour::Piece;
use crate::units::MillimetresPerRev;

use super::whole::Seat;

pub(super) use crate::tables::controls::lathe::Use;

/// The words of one control.
#[derive(Clone, Debug, Default)]
pub(super) struct ControlWords {
    words: BTreeMap<Use, String>,
    /// The form of a comment, with `{text}` in it.
    comment: String,
    /// Whether a whole number needs a point: without one it is in least increments.
    pointed: bool,
    /// Whether the lead of a thread is the way of the tool in a turn, not that along the longer axis.
    lead_of_path: bool,
}

impl ControlWords {
    /// The rows of a control.
    ///
    /// # Errors
    /// The table lacks a word that every control must have.
    pub fn read(of: &LatheControls<'_>, comment: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let control = of.control;
        let rows = knowledge.rows::<LatheWords<'_>>()?.into_iter().filter(|row| row.control == control);
        let words: BTreeMap<Use, String> = rows.map(|row| (row.use_, row.word.to_owned())).collect();
        let lacking = |(_, wanted): &&(&str, Use)| wanted.is_required() && !words.contains_key(wanted);
        if let Some((name, _)) = Use::NAMES.iter().find(lacking) {
            let wanted = format!("control {}, use {name}", control.name());
            return Err(KnowledgeError::no_row(knowledge.table_of::<LatheWords<'_>>()?, &wanted));
        }
        let (pointed, lead_of_path) = (of.point.unwrap_or(false), of.lead_along == Some(LeadAlong::Path));
        Ok(Self { words, comment: comment.to_owned(), pointed, lead_of_path })
    }

    /// A word; empty if the control has none.
    pub fn get(&self, wanted: Use) -> &str {
        self.words.get(&wanted).map(String::as_str).unwrap_or_default()
    }

    /// A word with its names in braces replaced by values.
    pub fn filled(&self, wanted: Use, values: &[(&str, String)]) -> String {
        values
            .iter()
            .fold(self.get(wanted).to_owned(), |word, (name, value)| word.replace(&format!("{{{name}}}"), value))
    }

    /// The change to a tool; some controls use two digits each for place and offset.
    pub fn tool(&self, seat: Seat) -> String {
        let wanted = if seat == Seat::only(seat.place) { Use::Tool } else { Use::ToolOfOffset };
        let Seat { place, offset, edge } = seat;
        let values = [
            ("tool", place.to_string()),
            ("two", format!("{place:02}")),
            ("offset", offset.to_string()),
            ("two-of-offset", format!("{offset:02}")),
            ("edge", edge.to_string()),
        ];
        self.filled(wanted, &values)
    }

    /// The number of the offset of a tool, as the control counts it.
    pub fn offset(&self, seat: Seat) -> u32 {
        if self.get(Use::ToolOfOffset).contains("{edge}") { seat.edge } else { seat.offset }
    }

    /// A length or a feed as the control takes it.
    pub fn figure(&self, number: String) -> String {
        if self.pointed && !number.contains('.') { format!("{number}.") } else { number }
    }

    /// The lead that the control must be told for a thread of this lead along the longer axis of a line: where it is the
    /// way of the tool in a turn, K = P·√(Δz² + Δr²)/max(Δz, Δr).
    pub fn lead(&self, piece: Piece, lead: MillimetresPerRev) -> f64 {
        let along = piece.from.to(piece.to);
        let longer = along.z.abs().max(along.radius.abs());
        if self.lead_of_path && longer > 0.0 { lead.0 * along.length() / longer } else { lead.0 }
    }

    /// A comment.
    pub fn comment(&self, text: &str) -> String {
        self.comment.replace("{text}", text)
    }
}
