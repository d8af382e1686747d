//! An audit as a page: by sections of the plan, the most severe findings first, each with its basis and its
//! consequences.

pub mod against;
pub mod class;
mod counts;
mod keys;
pub mod many;
mod marks;
pub mod student;
mod symbols;
mod words;

use std::collections::BTreeSet;

use crate::note::{Because, Figure};
use technolog_audit::{Audit, AuditFinding, Section};
use technolog_core::words::with_unit;
use technolog_document::{self as document, Document, Inlines};
use technolog_words::say;

use super::Lang;
pub use words::severity;
use words::{figure, finding_text, heading, name, place, subject};

/// The page.
pub fn page(audit: &Audit, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "audit-title", plan = &audit.plan));
    page.paragraph(Inlines::default().code(&audit.file));
    let own = audit.summary.all;
    page.paragraph(say!(
        lang,
        "audit-summary",
        error = own.error,
        wrong = own.wrong,
        doubtful = own.doubtful,
        note = own.note,
        follow = own.follow
    ));
    if let Some(line) = unconfirmed(audit, lang) {
        page.paragraph(Inlines::sentence(&line));
    }
    if !audit.summary.sections.is_empty() {
        page.push(counts::table(audit, lang));
    }
    for (section, findings) in by_section(audit) {
        page.heading(2, heading(section, lang));
        findings.into_iter().for_each(|finding| page.push(block(finding, audit, lang)));
    }
    if let Some(marks) = &audit.marks {
        page.heading(2, marks::headline(marks, lang));
        page.push(marks::table(marks, audit, lang));
    }
    page
}

fn block(finding: &AuditFinding, audit: &Audit, lang: Lang) -> document::FindingBlock {
    let words = Inlines::sentence(&headline(finding, lang));
    document::FindingBlock {
        place: place(finding, &audit.file),
        details: details(finding, audit, lang).iter().map(|line| Inlines::sentence(line)).collect(),
        ..document::FindingBlock::new(words::colour(finding.severity), severity(finding.severity, lang), words)
    }
}

/// The findings of each section that has any; an audit already has them in order.
fn by_section(audit: &Audit) -> impl Iterator<Item = (Section, Vec<&AuditFinding>)> {
    let mut sections: Vec<Section> = audit.findings.iter().map(|finding| finding.section).collect();
    sections.sort_unstable();
    sections.dedup();
    let findings_of = |section: Section| audit.findings.iter().filter(|finding| finding.section == section).collect();
    let by_section: Vec<(Section, Vec<&AuditFinding>)> =
        sections.into_iter().map(|section| (section, findings_of(section))).collect();
    by_section.into_iter()
}

/// The fault in one sentence.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
fn headline(finding: &AuditFinding, lang: Lang) -> String {
    let about = words::block(finding).map_or_else(|| subject(&finding.subject, lang), str::to_owned);
    let text = finding_text(finding, lang);
    let text = match (finding.quantity, &finding.stated, &finding.right) {
        (Some(quantity), Some(stated), Some(right)) => {
            let right = with_unit(&figure(right, lang), quantity.unit(), lang);
            let off = finding.deviation_percent.filter(|off| off.abs() >= 0.1);
            let figures = match off.map(|off| figure(&format!("{off:+}"), lang)) {
                Some(off) => say!(lang, "audit-beside-off", stated = figure(stated, lang), right = right, off = off),
                None => say!(lang, "audit-beside", stated = figure(stated, lang), right = right),
            };
            let figures = say!(lang, "audit-of-figure", what = words::quantity_text(finding, lang), said = figures);
            match finding.note.code() {
                // These notes contain only figures.
                "audit-figure" | "audit-follows" => figures,
                _ => say!(lang, "audit-and-so", figures = figures, said = text),
            }
        }
        (Some(_), Some(stated), None) => {
            let figures = say!(lang, "audit-is-stated", stated = figure(stated, lang));
            let figures = say!(lang, "audit-of-figure", what = words::quantity_text(finding, lang), said = figures);
            say!(lang, "audit-and-so", figures = figures, said = text)
        }
        _ => text,
    };
    if about.is_empty() { text } else { say!(lang, "audit-about", about = about, said = text) }
}

/// The basis of a finding and its consequences.
fn details(finding: &AuditFinding, audit: &Audit, lang: Lang) -> Vec<String> {
    let mut lines = Vec::new();
    if !finding.formula.is_empty() {
        lines.push(figure(&symbols::written(&finding.formula, lang), lang));
    }
    if let Some(by_stated) = &finding.by_stated {
        lines.push(say!(lang, "audit-by-stated", value = figure(by_stated, lang)));
    }
    lines.extend(finding.mistake.iter().map(|mistake| lang.say(mistake)));
    if finding.is_slip {
        lines.push(say!(lang, "audit-is-slip").to_owned());
    }
    if !finding.supplied.is_empty() {
        let taken = finding.supplied.iter().map(|shown| {
            let value = with_unit(&figure(&shown.value, lang), shown.quantity.unit(), lang);
            Figure::Text(say!(lang, "audit-supplied-one", what = name(shown.quantity, lang), value = value).into())
        });
        lines.push(say!(lang, "audit-supplied", taken = Figure::list(taken)));
    }
    lines.extend(finding.reasons.iter().map(|why| lang.say(why)));
    let mut rests: Vec<String> = finding.source.iter().map(|source| lang.say(source)).collect();
    for row in finding.because.iter().map(|because| row(because, lang)) {
        if !rests.contains(&row) {
            rests.push(row);
        }
    }
    if !rests.is_empty() {
        lines.push(say!(lang, "audit-rests-on", reasons = rests.join("; ")));
    }
    if !finding.follows_from.is_empty() {
        let roots = finding.follows_from.iter().map(|root| (root.as_str(), String::new()));
        lines.push(say!(lang, "audit-follows-from", fields = words::fields(roots, audit, lang)));
    }
    if !finding.changes.is_empty() {
        let changes = finding.changes.iter();
        let changes = changes.map(|change| (change.field.as_str(), words::change(&change.stated, &change.right, lang)));
        lines.push(say!(lang, "audit-changes", fields = words::fields(changes, audit, lang)));
    }
    lines
}

/// How many findings rest on rows that nothing confirms, and where such rows are told; none if there are none.
fn unconfirmed(audit: &Audit, lang: Lang) -> Option<String> {
    let doubtful = |finding: &&AuditFinding| finding.because.iter().any(|because| because.unconfirmed.is_some());
    let findings: Vec<&AuditFinding> = audit.findings.iter().filter(doubtful).collect();
    let rows = findings.iter().flat_map(|finding| &finding.because).filter(|because| because.unconfirmed.is_some());
    let tables: BTreeSet<&str> = rows.map(|because| because.table.as_str()).collect();
    let tables = Figure::list(tables.into_iter().map(|table| Figure::Text(table.to_owned().into())));
    (!findings.is_empty()).then(|| say!(lang, "audit-unconfirmed", count = findings.len(), tables = tables))
}

/// A row for the reader: table, number, and whether it is unconfirmed.
fn row(because: &Because, lang: Lang) -> String {
    let table = &because.table;
    match (because.row, because.unconfirmed.is_some()) {
        (Some(row), false) => say!(lang, "audit-row", table = table, row = row),
        (Some(row), true) => say!(lang, "audit-row-unconfirmed", table = table, row = row),
        (None, false) => say!(lang, "audit-table", table = table),
        (None, true) => say!(lang, "audit-table-unconfirmed", table = table),
    }
}
