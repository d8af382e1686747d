//! Marks as text.

use technolog_audit::Audit;
use technolog_audit::marks::{DeductedBy, Deduction, Marks};
use technolog_document::{Column, Inlines, Keep, Table};
use technolog_words::say;

use super::super::Lang;
use super::words::{figure, number, whereabouts};
use super::{place, severity};

/// `Курсовий проєкт: 71,5 з 100, зараховано`.
pub fn headline(marks: &Marks, lang: Lang) -> String {
    let name = if marks.scheme.is_empty() { lang.word("audit-marks") } else { &marks.scheme };
    let (points, maximum) = (number(marks.points), number(marks.maximum));
    match marks.passed {
        Some(true) => say!(lang, "audit-score-passed", name = name, points = points, of = maximum),
        Some(false) => say!(lang, "audit-score-failed", name = name, points = points, of = maximum),
        None => say!(lang, "audit-score", name = name, points = points, of = maximum),
    }
}

/// The findings that cost points, one row each; the others only as a number.
pub(super) fn table(marks: &Marks, audit: &Audit, lang: Lang) -> Table {
    let text = |head: &str| Column::text(lang.word(head));
    let mut table = Table::new([
        Column::number(lang.word("audit-column-taken"), ""),
        text("audit-column-severity").keep(Keep::Useful),
        text("audit-column-place"),
        text("audit-column-about"),
        text("audit-column-ground").keep(Keep::Optional),
    ]);
    for one in &marks.missing {
        table.row([
            Inlines::number(figure(&format!("-{}", one.points), lang)),
            Inlines::default(),
            Inlines::default(),
            Inlines::sentence(&say!(
                lang,
                "audit-part-missing",
                part = part(one.part, lang),
                percent = number(one.percent)
            )),
            lang.word("audit-by-missing").into(),
        ]);
    }
    // The deductions have the order of the findings, one for each.
    for (one, finding) in marks.deductions.iter().zip(&audit.findings).filter(|(deduction, _)| deduction.points > 0.0) {
        table.row([
            Inlines::number(figure(&format!("-{}", one.points), lang)),
            severity(one.severity, lang).into(),
            Inlines::default().code(place(finding, &audit.file).unwrap_or_default()),
            Inlines::sentence(&whereabouts(finding, lang)),
            ground(one, lang).into(),
        ]);
    }
    let free =
        |by: &dyn Fn(&Deduction) -> bool| marks.deductions.iter().filter(|one| one.points == 0.0 && by(one)).count();
    let (capped, follow) = (free(&|one| one.capped), free(&|one| one.by == DeductedBy::Consequence));
    let other = free(&|_| true) - capped - follow;
    let mut counts = Vec::new();
    counts.extend((follow > 0).then(|| say!(lang, "audit-free-follow", count = follow)));
    counts.extend((capped > 0).then(|| say!(lang, "audit-free-capped", count = capped)));
    counts.extend((other > 0).then(|| say!(lang, "audit-free-other", count = other)));
    table.notes.push(lang.word("audit-marks-legend").into());
    if !marks.uncovered.is_empty() {
        let parts = marks.uncovered.iter().map(|name| part(name, lang)).collect::<Vec<_>>();
        table.notes.push(say!(lang, "audit-not-covered", parts = parts.join(", ")).into());
    }
    if !counts.is_empty() {
        table.notes.push(say!(lang, "audit-free", counts = counts.join(", ")).into());
    }
    table
}

/// What a part of a plan is called.
fn part(name: &str, lang: Lang) -> &'static str {
    lang.word(match name {
        "holes" => "audit-part-holes",
        "tools" => "audit-part-tools",
        "conditions" => "audit-part-conditions",
        "clamping" => "audit-part-clamping",
        "program" => "audit-part-program",
        _ => "audit-part-times",
    })
}

/// The entry of the scheme that gives a deduction.
fn ground(deduction: &Deduction, lang: Lang) -> String {
    let by = match deduction.by {
        DeductedBy::Consequence => say!(lang, "audit-by-consequence").to_owned(),
        DeductedBy::Rule => say!(lang, "audit-by-rule", rule = &deduction.rule),
        DeductedBy::Section => say!(lang, "audit-by-section", section = super::heading(deduction.section, lang)),
        DeductedBy::Severity => say!(lang, "audit-by-severity").to_owned(),
    };
    if deduction.capped { say!(lang, "audit-by-capped", by = by) } else { by }
}
