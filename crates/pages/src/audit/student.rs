//! The sheet for a student: what is wrong by itself, the worst first, each with the figure as stated, the right one and why; what only
//! follows is counted under its root. A good work has half a page.

use technolog_audit::marks::Marks;
use technolog_audit::{Audit, AuditFinding};
use technolog_document::{self as document, Document, Field, Inlines};
use technolog_words::say;

use crate::note::Severity;

use super::super::Lang;
use super::{figure, headline, marks, place, severity, symbols, words};

/// The sheet.
pub fn page(audit: &Audit, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "audit-title", plan = &audit.plan));
    let author = audit.author.clone().or_by_file(&audit.file);
    let said = [("column-student", author.student), ("column-group", author.group), ("column-variant", author.variant)];
    let fields: Vec<Field> =
        said.into_iter().filter_map(|(label, value)| Some(Field::new(lang.word(label), value?))).collect();
    if !fields.is_empty() {
        page.push(document::Block::Fields(fields));
    }
    if let Some(marks) = &audit.marks {
        page.paragraph(Inlines::default().strong(marks::headline(marks, lang)));
    }
    let of = |severity: Severity| {
        audit.findings.iter().filter(move |one| one.severity == severity && one.follows_from.is_empty())
    };
    let roots: Vec<&AuditFinding> =
        [Severity::Error, Severity::Wrong, Severity::Doubtful].into_iter().flat_map(of).collect();
    if roots.is_empty() {
        page.paragraph(lang.word("audit-sheet-nothing"));
    }
    for root in roots {
        let words = Inlines::sentence(&headline(root, lang));
        page.push(document::FindingBlock {
            place: place(root, &audit.file),
            details: details(root, audit, lang).iter().map(|line| Inlines::sentence(line)).collect(),
            ..document::FindingBlock::new(words::colour(root.severity), severity(root.severity, lang), words)
        });
    }
    // Every point taken, with its finding and the entry of the scheme, of what only follows and of notes, too.
    let costs = |marks: &&Marks| !marks.missing.is_empty() || marks.deductions.iter().any(|one| one.points > 0.0);
    if let Some(marks) = audit.marks.as_ref().filter(costs) {
        page.heading(2, lang.word("audit-sheet-marks"));
        page.push(marks::table(marks, audit, lang));
    }
    let notes = of(Severity::Note).count();
    if notes > 0 {
        page.paragraph(say!(lang, "audit-sheet-notes", count = notes));
    }
    page
}

/// The place of the book without the lines of the extract that we read, which no student has.
fn without_lines(source: &str, lang: Lang) -> String {
    let begins = lang.word("audit-sheet-lines").trim_matches('"');
    match source.split_once(begins).map(|(before, rest)| (before, rest.split_once(')'))) {
        Some((before, Some((_, after)))) => format!("{}{after}", before.trim_end_matches([' ', '('])),
        _ => source.to_owned(),
    }
}

/// Why, and how much else is wrong because of it.
fn details(root: &AuditFinding, audit: &Audit, lang: Lang) -> Vec<String> {
    let mut lines = Vec::new();
    if !root.formula.is_empty() {
        lines.push(figure(&symbols::written(&root.formula, lang), lang));
    }
    lines.extend(root.mistake.iter().map(|mistake| lang.say(mistake)));
    lines.extend(root.source.iter().map(|source| without_lines(&lang.say(source), lang)));
    let follow = audit.findings.iter().filter(|one| one.follows_from.contains(&root.field)).count();
    if follow > 0 {
        lines.push(say!(lang, "audit-sheet-follow", count = follow));
    }
    lines
}
