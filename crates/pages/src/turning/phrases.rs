//! Phrases for all pages of turning: reasons with their rows, findings, lengths along the axis.

use crate::document::{Column, FindingBlock, Inlines, Severity};
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::{self, Because, Note};
use technolog_turning::length::Half;
use technolog_words::say;

use super::super::Lang;
use super::super::sheet::MARK;
use super::cells::figure;

/// A note as a line.
pub(super) fn note_line(note: &Note, lang: Lang) -> Inlines {
    Inlines::sentence(&lang.say(note))
}

/// A decision with its row.
pub(super) fn reasoned(because: &Because, lang: Lang) -> Inlines {
    rests_on(&lang.say(&because.note), because, lang)
}

/// A sentence with its row.
pub(super) fn rests_on(text: &str, because: &Because, lang: Lang) -> Inlines {
    let (table, place) = (because.table.as_str(), lang.place(&because.place));
    Inlines::sentence(&match because.row {
        Some(row) => say!(lang, "turn-by-row", said = text, table = table, row = row, place = place),
        None => say!(lang, "turn-by-table", said = text, table = table, place = place),
    })
}

pub(super) fn finding(finding: &note::Finding, lang: Lang) -> FindingBlock {
    let severity = match finding.severity {
        note::Severity::Error => Severity::Error,
        note::Severity::Wrong => Severity::Wrong,
        note::Severity::Doubtful => Severity::Doubtful,
        note::Severity::Note => Severity::Note,
    };
    FindingBlock::new(severity, lang.term("word", finding.severity.name()), note_line(&finding.note, lang))
}

/// What is said of rows that nothing confirms, under the mark that their figures have.
pub(super) fn unconfirmed(note: &Note, lang: Lang) -> FindingBlock {
    FindingBlock::new(Severity::Doubtful, MARK, note_line(note, lang))
}

/// A word of the general vocabulary, as a figure of a sentence.
pub(super) fn word(id: &'static str) -> note::Figure {
    note::Figure::word(id)
}

/// A length along the axis as printed: negative towards the chuck.
pub(super) fn z(value: Half, lang: Lang) -> String {
    figure(Half::ZERO - value, lang)
}

/// The designation of a material; its id where the knowledge base does not have it.
pub(super) fn material(id: &str, knowledge: &Knowledge) -> String {
    Material::find(knowledge, id).map_or_else(|_| id.to_owned(), |material| material.designation().to_owned())
}

/// Words of the general vocabulary with a separator.
pub(super) fn terms<'i>(ids: impl Iterator<Item = &'i str>, between: &str, lang: Lang) -> String {
    ids.map(|id| lang.term("word", id)).collect::<Vec<_>>().join(between)
}

/// A column with the names of schemes; the headings of figures are wrapped before these names.
pub(super) fn schemes_column(heading: &str) -> Column {
    Column::text(heading).min_width(24)
}
