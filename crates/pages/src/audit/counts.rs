//! How many findings each section of a plan has, by severity.

use technolog_audit::{Audit, Counts};

use super::super::Lang;
use super::heading;

/// Head and rows; no row for a section without a finding.
pub(super) fn table(audit: &Audit, lang: Lang) -> (Vec<String>, Vec<Vec<String>>) {
    let mut head = vec![lang.pick("розділ", "section").to_owned()];
    head.extend(severities(lang).map(str::to_owned));
    head.push(lang.pick("з них наслідки", "of these follow").to_owned());
    let rows = audit.summary.sections.iter().map(|(section, counts)| {
        let mut row = vec![heading(*section, lang).to_owned()];
        row.extend(by_severity(*counts).into_iter().chain([counts.follow]).map(|count| count.to_string()));
        row
    });
    (head, rows.collect())
}

/// Heads of columns of counts.
pub(super) fn severities(lang: Lang) -> [&'static str; 4] {
    match lang {
        _ if lang == Lang::UK => ["помилки", "хибне", "сумнівне", "зауваження"],
        _ => ["errors", "wrong", "doubtful", "notes"],
    }
}

/// The counts of those columns.
pub(super) const fn by_severity(counts: Counts) -> [usize; 4] {
    [counts.error, counts.wrong, counts.doubtful, counts.note]
}
