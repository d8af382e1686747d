//! The number of findings in each section of a plan, by severity.

use technolog_audit::{Audit, Counts};
use technolog_document::{Column, Inlines, Keep, Table};

use super::super::Lang;
use super::heading;

/// No row for a section without a finding.
pub(super) fn table(audit: &Audit, lang: Lang) -> Table {
    let mut columns = vec![Column::text(lang.word("audit-column-section"))];
    columns.extend(severities(lang));
    columns.push(Column::number(lang.word("audit-column-follow"), "").keep(Keep::Useful));
    let mut table = Table::new(columns);
    for (section, counts) in &audit.summary.sections {
        let counts = by_severity(*counts).into_iter().chain([counts.follow]);
        table.row([Inlines::from(heading(*section, lang))].into_iter().chain(counts.map(number)));
    }
    table
}

/// Columns of counts.
pub(super) fn severities(lang: Lang) -> impl Iterator<Item = Column> {
    let heads = ["audit-column-error", "audit-column-wrong", "audit-column-doubtful", "audit-column-note"];
    heads.into_iter().map(move |head| Column::number(lang.word(head), ""))
}

/// The counts of those columns.
pub(super) const fn by_severity(counts: Counts) -> [usize; 4] {
    [counts.error, counts.wrong, counts.doubtful, counts.note]
}

pub(super) fn number(count: usize) -> Inlines {
    Inlines::number(count.to_string())
}
