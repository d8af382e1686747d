//! The words of an audit: a plan's parts, figures and keys as people call them. Paths of a plan file are for programs.

use crate::note::{Figure, Note, Severity};
use technolog_audit::quantity::Quantity;
use technolog_audit::{Audit, Finding, Lack, Section, Subject};

use super::super::sentences::term;
use super::super::{Lang, operation_noun, sentence};
use super::keys;

/// The heading of a section.
pub(super) fn heading(section: Section, lang: Lang) -> &'static str {
    match section {
        Section::Route => lang.pick("Маршрут", "Route"),
        Section::Tools => lang.pick("Різальний інструмент", "Cutters"),
        Section::Holders => lang.pick("Допоміжний інструмент", "Holders"),
        Section::Conditions => lang.pick("Режими різання", "Cutting conditions"),
        Section::Clamping => lang.pick("Закріплення", "Clamping"),
        Section::Lengths => lang.pick("Довжини і корекції", "Lengths and corrections"),
        Section::Program => lang.pick("Керуюча програма", "Program"),
        Section::Times => lang.pick("Час", "Times"),
        Section::Missing => lang.pick("Не вказано", "Not stated"),
    }
}

/// How grave a finding is, in a word.
pub fn severity(severity: Severity, lang: Lang) -> &'static str {
    match severity {
        Severity::Error => lang.pick("помилка", "error"),
        Severity::Wrong => lang.pick("хибно", "wrong"),
        Severity::Doubtful => lang.pick("сумнівно", "doubtful"),
        Severity::Note => lang.pick("зауваження", "note"),
    }
}

/// `12:5`, with the file where it is another than the plan's.
pub(super) fn place(finding: &Finding, file: &str) -> Option<String> {
    let at = format!("{}:{}", finding.line?, finding.column?);
    match &finding.file {
        Some(own) if own != file => Some(format!("{own}:{at}")),
        _ => Some(at),
    }
}

/// `подача S`.
pub(super) fn name(quantity: Quantity, lang: Lang) -> String {
    let (uk, en) = quantity.name();
    format!("{} {}", lang.pick(uk, en), quantity.symbol())
}

/// `свердління A, B`, `T2`.
pub(super) fn subject(subject: &Subject, lang: Lang) -> String {
    let mut parts = Vec::new();
    parts.extend(subject.operation.map(|operation| operation_noun(operation.name(), lang).to_owned()));
    if !subject.holes.is_empty() {
        parts.push(subject.holes.join(", "));
    }
    parts.extend(subject.tool.map(|tool| format!("T{tool}")));
    parts.join(" ")
}

/// The block of the program that a finding is about: in a program people look for that.
pub(super) fn block(finding: &Finding) -> Option<&str> {
    let block = finding.field.strip_prefix("program.").filter(|_| finding.section == Section::Program);
    block.filter(|block| !block.starts_with("setting."))
}

/// Whom a finding is about: `свердління A`, `T2`, else its section.
fn about(finding: &Finding, lang: Lang) -> String {
    let said = block(finding).map_or_else(|| subject(&finding.subject, lang), str::to_owned);
    if !said.is_empty() {
        return said;
    }
    // A tool whose name was exchanged is told by its place alone.
    let tool = finding.field.strip_prefix("tools.").and_then(|rest| rest.split('.').next());
    match tool.filter(|tool| tool.starts_with('T')) {
        Some(tool) => tool.to_owned(),
        None => heading(finding.section, lang).to_lowercase(),
    }
}

/// What of it: `подача S`, `позначення`; nothing where it is about the whole.
pub(super) fn what(finding: &Finding, lang: Lang) -> String {
    match finding.quantity {
        Some(quantity) => {
            // conditions.2.factors.speed.material: the last is the factor's name.
            let inner = finding.field.splitn(3, '.').nth(2).unwrap_or_default();
            let factor = inner.strip_prefix(quantity.key()).and_then(|rest| rest.strip_prefix('.'));
            factor.map_or_else(|| name(quantity, lang), |factor| self::factor(quantity, factor, lang))
        }
        // About a section as a whole, which is said already; what is not stated says of which.
        None if finding.section == Section::Program => String::new(),
        None if finding.section != Section::Missing && !finding.field.contains('.') => String::new(),
        None => keys::words(&finding.field, lang).unwrap_or_default(),
    }
}

/// `коефіцієнт швидкості Kv (матеріал)`.
pub(super) fn factor(quantity: Quantity, factor: &str, lang: Lang) -> String {
    format!("{} ({})", name(quantity, lang), keys::factor(factor, lang))
}

/// Where a finding is, in words: `T1: довжина комплекту Lк`.
pub(super) fn whereabouts(finding: &Finding, lang: Lang) -> String {
    let (about, what) = (about(finding, lang), what(finding, lang));
    if what.is_empty() { about } else { format!("{about}: {what}") }
}

/// Figures and choices of a plan by their paths, each with what is said of it; those of one tool or of one transition
/// stand together: `T1: виліт lв, довжина lопр; закріплення: nпр 500 → 315`.
pub(super) fn fields<'a>(fields: impl Iterator<Item = (&'a str, String)>, audit: &Audit, lang: Lang) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for (field, said) in fields {
        // What another finding follows from or changes is a finding itself.
        let Some(finding) = audit.findings.iter().find(|one| one.field == field) else { continue };
        let what =
            [what(finding, lang), said].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ");
        let about = about(finding, lang);
        match groups.last_mut() {
            Some((known, list)) if *known == about => list.push(what),
            _ => groups.push((about, vec![what])),
        }
    }
    let group = |(about, list): &(String, Vec<String>)| {
        let list = list.iter().filter(|text| !text.is_empty()).map(String::as_str).collect::<Vec<_>>().join(", ");
        if list.is_empty() { about.clone() } else { format!("{about}: {list}") }
    };
    groups.iter().map(group).collect::<Vec<_>>().join("; ")
}

/// What a finding says, with what its note has for programs put into words.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
pub(super) fn said(finding: &Finding, lang: Lang) -> String {
    let note = match finding.note.code() {
        "audit-missing" => Note::new("audit-missing")
            .with("section", keys::words(&finding.field, lang).unwrap_or_default())
            .with("what", missing(&finding.missing, &finding.field, lang)),
        "audit-not-ours" => {
            let of = |name: &str| figure_value(finding.note.figure(name), lang);
            let field = keys::words(&finding.field, lang).unwrap_or_else(|| lang.pick("число", "a figure").to_owned());
            Note::new("audit-not-ours").with("field", field).with("stated", of("stated")).with("right", of("right"))
        }
        "audit-beyond-machine" => {
            let bound = finding.note.figure("quantity");
            finding.note.clone().with("quantity", figure_value(bound, lang))
        }
        _ => finding.note.clone(),
    };
    sentence(&note, lang)
}

/// What is not stated, by what lacks the same: `рядки 2, 3 - діаметр D; T1, T2 - виліт lв`.
fn missing(missing: &[Lack], section: &str, lang: Lang) -> String {
    let mut groups: Vec<(&[&str], Vec<String>)> = Vec::new();
    for lack in missing {
        let whose = if section == "route" { lack.of.clone() } else { subject(&lack.subject, lang) };
        match groups.iter_mut().find(|(keys, _)| *keys == lack.keys) {
            Some((_, known)) => known.push(whose),
            None => groups.push((&lack.keys, vec![whose])),
        }
    }
    if matches!(missing, [lack] if lack.keys == [section]) {
        return lang.pick("увесь розділ", "the whole section").to_owned();
    }
    let whole = missing.iter().all(|lack| lack.of.is_empty());
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
            ("route", 1) => format!("{} {}", lang.pick("рядок", "row"), whose.join(", ")),
            ("route", _) => format!("{} {}", lang.pick("рядки", "rows"), whose.join(", ")),
            // A transition has commas of its own: `свердління A, B`.
            ("conditions", _) => whose.join("; "),
            _ => whose.join(", "),
        };
        format!("{whose} - {names}")
    };
    groups.iter().map(group).collect::<Vec<_>>().join(if whole { ", " } else { "; " })
}

/// A figure of a note, of which a text may be an id.
fn figure_value(figure: Option<&Figure>, lang: Lang) -> String {
    match figure {
        Some(Figure::Text(text)) => value(text, lang),
        Some(figure) => lang.figure(figure),
        None => String::new(),
    }
}

/// A value that a file has as an id: `drill`, `morse`, `true`; anything else is as it is.
pub(super) fn value(text: &str, lang: Lang) -> String {
    let known = match text {
        "true" => Some(lang.pick("так", "yes")),
        "false" | "null" => Some(lang.pick("ні", "no")),
        _ => None,
    };
    known
        .unwrap_or_else(|| {
            let noun = operation_noun(text, lang);
            if noun == text { keys::value(text, lang).unwrap_or_else(|| term(text, lang)) } else { noun }
        })
        .to_owned()
}

/// Decimal points as the language writes them: a point between two digits.
pub(super) fn comma(text: &str, lang: Lang) -> String {
    if lang == Lang::EN {
        return text.to_owned();
    }
    let letters: Vec<char> = text.chars().collect();
    let digit = |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(char::is_ascii_digit);
    let shown = |(at, letter): (usize, &char)| match letter {
        '.' if digit(at.checked_sub(1)) && digit(at.checked_add(1)) => ',',
        other => *other,
    };
    letters.iter().enumerate().map(shown).collect()
}
