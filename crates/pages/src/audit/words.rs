//! The words of an audit: the names of a plan's parts, figures and keys. Paths of a plan file are for programs.

use crate::note::{Figure, Note, Severity};
use technolog_audit::quantity::Quantity;
use technolog_audit::{Audit, AuditFinding, MissingKeys, Section, Subject};
use technolog_core::words::quantity_noun;
use technolog_document as document;
use technolog_words::say;

use super::super::{Lang, operation_noun};
use super::keys;

/// The heading of a section.
pub(super) fn heading(section: Section, lang: Lang) -> &'static str {
    lang.word(match section {
        Section::Route => "audit-section-route",
        Section::Tools => "audit-section-tools",
        Section::Holders => "audit-section-holders",
        Section::Conditions => "audit-section-conditions",
        Section::Clamping => "audit-section-clamping",
        Section::Lengths => "audit-section-lengths",
        Section::Program => "audit-section-program",
        Section::Times => "audit-section-times",
        Section::Missing => "audit-section-missing",
    })
}

/// The severity of a finding as a word.
pub fn severity(severity: Severity, lang: Lang) -> &'static str {
    lang.word(match severity {
        Severity::Error => "audit-severity-error",
        Severity::Wrong => "audit-severity-wrong",
        Severity::Doubtful => "audit-severity-doubtful",
        Severity::Note => "audit-severity-note",
    })
}

/// The severity of a finding as a colour.
pub(super) const fn colour(severity: Severity) -> document::Severity {
    match severity {
        Severity::Error => document::Severity::Error,
        Severity::Wrong => document::Severity::Wrong,
        Severity::Doubtful => document::Severity::Doubtful,
        Severity::Note => document::Severity::Note,
    }
}

/// A figure that is already written, or a formula with its figures, with typographic signs.
pub(super) fn figure(written: &str, lang: Lang) -> String {
    let (mut printed, mut before) = (String::with_capacity(written.len()), ' ');
    for sign in written.replace("<=", "≤").replace(">=", "≥").chars() {
        // A minus precedes a number; inside a name it is a hyphen.
        printed.push(if sign == '-' && !before.is_alphanumeric() { '−' } else { sign });
        before = sign;
    }
    lang.figure(&Figure::number(printed))
}

/// A figure unchanged.
pub(super) fn number(value: f64) -> Figure {
    Figure::number(value.to_string())
}

/// `0,25 → 0,325`.
pub(super) fn change(stated: &str, right: &str, lang: Lang) -> String {
    say!(lang, "audit-change", stated = figure(stated, lang), right = figure(right, lang))
}

/// `12:5`, with the file if it is not the plan's.
pub(super) fn place(finding: &AuditFinding, file: &str) -> Option<String> {
    let at = format!("{}:{}", finding.line?, finding.column?);
    match &finding.file {
        Some(own) if own != file => Some(format!("{own}:{at}")),
        _ => Some(at),
    }
}

/// `подача S`.
pub(super) fn name(quantity: Quantity, lang: Lang) -> String {
    say!(
        lang,
        "audit-quantity",
        name = quantity_noun(quantity, lang),
        symbol = super::symbols::written(quantity.symbol(), lang)
    )
}

/// `свердління A, B`, `T2`.
pub(super) fn subject(subject: &Subject, lang: Lang) -> String {
    let mut parts = Vec::new();
    parts.extend(subject.operation.map(|operation| operation_noun(operation.name(), lang).to_owned()));
    if !subject.holes.is_empty() {
        parts.push(subject.holes.iter().map(|hole| lang.called(hole)).collect::<Vec<_>>().join(", "));
    }
    parts.extend(subject.tool.map(|tool| say!(lang, "audit-tool", number = tool)));
    parts.join(" ")
}

/// The block of the program for a finding: readers of a program look for it.
pub(super) fn block(finding: &AuditFinding) -> Option<&str> {
    let block = finding.field.strip_prefix("program.").filter(|_| finding.section == Section::Program);
    block.filter(|block| !block.starts_with("setting."))
}

/// The subject of a finding: `свердління A`, `T2`, otherwise its section.
fn about(finding: &AuditFinding, lang: Lang) -> String {
    let text = block(finding).map_or_else(|| subject(&finding.subject, lang), str::to_owned);
    if !text.is_empty() {
        return text;
    }
    // A tool whose name was changed is identified by its place only.
    let tool = finding.field.strip_prefix("tools.").and_then(|rest| rest.split('.').next());
    match tool.filter(|tool| tool.starts_with('T')) {
        Some(tool) => tool.to_owned(),
        None => heading(finding.section, lang).to_lowercase(),
    }
}

/// The quantity of a finding: `подача S`, `позначення`; none if it concerns the whole subject.
pub(super) fn quantity_text(finding: &AuditFinding, lang: Lang) -> String {
    match finding.quantity {
        Some(quantity) => {
            finding.factor.as_ref().map_or_else(|| name(quantity, lang), |figure| factor(quantity, figure, lang))
        }
        // About a section as a whole, which is named already; for missing figures, which of them.
        None if finding.section == Section::Program => String::new(),
        None if finding.section != Section::Missing && !finding.field.contains('.') => String::new(),
        None => keys::words(&finding.field, lang).unwrap_or_default(),
    }
}

/// `коефіцієнт швидкості Kv (матеріал)`.
pub(super) fn factor(quantity: Quantity, factor: &Figure, lang: Lang) -> String {
    say!(lang, "audit-factor", quantity = name(quantity, lang), factor = factor)
}

/// The place of a finding in words: `T1: довжина комплекту Lк`.
pub(super) fn whereabouts(finding: &AuditFinding, lang: Lang) -> String {
    let (about, what) = (about(finding, lang), quantity_text(finding, lang));
    if what.is_empty() { about } else { say!(lang, "audit-about", about = about, said = what) }
}

/// Figures and choices of a plan by their paths, each with a remark; those of one tool or transition are joined: `T1:
/// виліт lв, довжина lопр; закріплення: nпр 500 → 315`.
pub(super) fn fields<'a>(fields: impl Iterator<Item = (&'a str, String)>, audit: &Audit, lang: Lang) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for (field, words) in fields {
        // Causes and consequences of a finding are findings themselves.
        let Some(finding) = audit.findings.iter().find(|one| one.field == field) else { continue };
        let what = [quantity_text(finding, lang), words]
            .into_iter()
            .filter(|text| !text.is_empty())
            .collect::<Vec<_>>()
            .join(" ");
        let about = about(finding, lang);
        match groups.last_mut() {
            Some((known, list)) if *known == about => list.push(what),
            _ => groups.push((about, vec![what])),
        }
    }
    let group = |(about, list): &(String, Vec<String>)| {
        let list = list.iter().filter(|text| !text.is_empty()).map(String::as_str).collect::<Vec<_>>().join(", ");
        if list.is_empty() { about.clone() } else { say!(lang, "audit-about", about = about, said = list) }
    };
    groups.iter().map(group).collect::<Vec<_>>().join("; ")
}

/// The text of a finding; figures of its note that are meant for programs are put into words.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
pub(super) fn finding_text(finding: &AuditFinding, lang: Lang) -> String {
    let note = match finding.note.code() {
        "audit-missing" => Note::new("audit-missing")
            .with("section", keys::words(&finding.field, lang).unwrap_or_default())
            .with("what", missing(&finding.missing, &finding.field, lang)),
        "audit-not-ours" => {
            let field = keys::words(&finding.field, lang);
            finding.note.clone().with("field", field.unwrap_or_else(|| lang.word("audit-some-figure").to_owned()))
        }
        _ => finding.note.clone(),
    };
    lang.say(&note)
}

/// Missing keys, grouped by those that lack the same: `рядки 2, 3 - діаметр D; T1, T2 - виліт lв`.
fn missing(missing: &[MissingKeys], section: &str, lang: Lang) -> String {
    let mut groups: Vec<(&[&str], Vec<String>)> = Vec::new();
    for lack in missing {
        let whose = if section == "route" { lack.part.clone() } else { subject(&lack.subject, lang) };
        match groups.iter_mut().find(|(keys, _)| *keys == lack.keys) {
            Some((_, known)) => known.push(whose),
            None => groups.push((&lack.keys, vec![whose])),
        }
    }
    if matches!(missing, [lack] if lack.keys == [section]) {
        return lang.word("audit-whole-section").to_owned();
    }
    let whole = missing.iter().all(|lack| lack.part.is_empty());
    let group = |(keys, whose): &(&[&str], Vec<String>)| {
        let names: Vec<String> = keys
            .iter()
            .map(|key| keys::words(&format!("{section}.{key}"), lang).unwrap_or_else(|| (*key).to_owned()))
            .collect();
        let names = names.join(", ");
        if whole {
            return names;
        }
        let whose = match (section, whose.len()) {
            ("route", count) => say!(lang, "audit-lacking-rows", count = count, rows = whose.join(", ")),
            // A transition contains commas itself: `свердління A, B`.
            ("conditions", _) => whose.join("; "),
            _ => whose.join(", "),
        };
        say!(lang, "audit-lacks", whose = whose, what = names)
    };
    groups.iter().map(group).collect::<Vec<_>>().join(if whole { ", " } else { "; " })
}
