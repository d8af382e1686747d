//! An audit as a page: by sections of the plan, the most severe first, each finding with what it rests on and what else
//! changes because of it.

pub mod against;
pub mod html;
pub mod many;
mod marks;

use crate::audit::quantity::Quantity;
use crate::audit::{Audit, Finding, Section, Subject};
use crate::note::{Because, Severity};

use super::{Lang, grid, operation_noun, sentence};

/// The page for people.
pub fn page(audit: &Audit, lang: Lang) -> String {
    let mut page = format!("{}\n{}\n", title(audit, lang), summary(audit, lang));
    for (section, findings) in by_section(audit) {
        page.push_str(&format!("\n{}\n", heading(section, lang)));
        for finding in findings {
            let at = place(finding, &audit.file).map(|place| format!(" {place}")).unwrap_or_default();
            let head = format!("{}{at} {}", severity(finding.severity, lang), headline(finding, lang));
            page.push_str(&grid::paragraph(&head, 2));
            for line in details(finding, lang) {
                page.push_str(&grid::paragraph(&line, 6));
            }
        }
    }
    if let Some(marks) = &audit.marks {
        page.push_str(&format!("\n{}\n", marks::headline(marks, lang)));
        for line in marks::lines(marks, lang) {
            page.push_str(&grid::paragraph(&line, 2));
        }
    }
    page
}

/// The same for documents.
pub fn markdown(audit: &Audit, lang: Lang) -> String {
    let mut page = format!("# {}\n\n{}\n", title(audit, lang), summary(audit, lang));
    for (section, findings) in by_section(audit) {
        page.push_str(&format!("\n## {}\n\n", heading(section, lang)));
        for finding in findings {
            let at = place(finding, &audit.file).map(|place| format!(" `{place}`")).unwrap_or_default();
            let said = headline(finding, lang);
            page.push_str(&format!("- **{}**{at} {said}\n", severity(finding.severity, lang)));
            for line in details(finding, lang) {
                page.push_str(&format!("  - {line}\n"));
            }
        }
    }
    if let Some(marks) = &audit.marks {
        page.push_str(&format!("\n## {}\n\n", marks::headline(marks, lang)));
        for line in marks::lines(marks, lang) {
            page.push_str(&format!("- {line}\n"));
        }
    }
    page
}

fn title(audit: &Audit, lang: Lang) -> String {
    format!("{} «{}» ({})", lang.pick("Перевірка плану", "Audit of the plan"), audit.plan, audit.file)
}

fn summary(audit: &Audit, lang: Lang) -> String {
    let own = audit.summary;
    match lang {
        Lang::Uk => format!(
            "помилок {}, хибного {}, сумнівного {}, зауважень {}; з них наслідків інших {}",
            own.error, own.wrong, own.doubtful, own.note, own.follow
        ),
        Lang::En => format!(
            "{} errors, {} wrong, {} doubtful, {} notes; of these {} follow from others",
            own.error, own.wrong, own.doubtful, own.note, own.follow
        ),
    }
}

/// The findings of each section that has some; an audit has them in order.
fn by_section(audit: &Audit) -> impl Iterator<Item = (Section, &[Finding])> {
    let chunks = audit.findings.chunk_by(|a, b| a.section == b.section);
    chunks.filter_map(|chunk| chunk.first().map(|first| (first.section, chunk)))
}

fn heading(section: Section, lang: Lang) -> &'static str {
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
fn place(finding: &Finding, file: &str) -> Option<String> {
    let at = format!("{}:{}", finding.line?, finding.column?);
    match &finding.file {
        Some(own) if own != file => Some(format!("{own}:{at}")),
        _ => Some(at),
    }
}

/// What is wrong, in one sentence.
fn headline(finding: &Finding, lang: Lang) -> String {
    // In a program people look for the block.
    let about = match finding.field.strip_prefix("program.").filter(|_| finding.section == Section::Program) {
        Some(block) => block.to_owned(),
        None => subject(&finding.subject, lang),
    };
    let said = sentence(&finding.note, lang);
    let said = match (finding.quantity, &finding.stated, &finding.right) {
        (Some(quantity), Some(stated), Some(right)) => {
            let figure = figure(quantity, stated, right, finding.deviation_percent, lang);
            if finding.note.code == "audit-figure" || finding.note.code == "audit-follows" {
                figure
            } else {
                format!("{figure}; {said}")
            }
        }
        (Some(quantity), Some(stated), None) => {
            format!("{}: {} {}; {said}", name(quantity, lang), lang.pick("написано", "stated"), comma(stated, lang))
        }
        _ => said,
    };
    if about.is_empty() { said } else { format!("{about}: {said}") }
}

fn figure(quantity: Quantity, stated: &str, right: &str, off: Option<f64>, lang: Lang) -> String {
    let unit = lang.pick(quantity.unit().0, quantity.unit().1);
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let off = off.filter(|off| off.abs() >= 0.1).map(|off| format!(" ({off:+} %)")).unwrap_or_default();
    let [said, be] = [lang.pick("написано", "stated"), lang.pick("має бути", "should be")];
    comma(&format!("{}: {said} {stated}, {be} {right}{unit}{off}", name(quantity, lang)), lang)
}

/// `подача S`.
fn name(quantity: Quantity, lang: Lang) -> String {
    let (uk, en) = quantity.name();
    format!("{} {}", lang.pick(uk, en), quantity.symbol())
}

fn subject(subject: &Subject, lang: Lang) -> String {
    let mut parts = Vec::new();
    parts.extend(subject.operation.map(|operation| operation_noun(operation.name(), lang).to_owned()));
    if !subject.holes.is_empty() {
        parts.push(subject.holes.join(", "));
    }
    parts.extend(subject.tool.map(|tool| format!("T{tool}")));
    parts.join(" ")
}

/// What the finding rests on and what follows from it.
fn details(finding: &Finding, lang: Lang) -> Vec<String> {
    let mut lines = Vec::new();
    if !finding.formula.is_empty() {
        lines.push(comma(&finding.formula, lang));
    }
    if let Some(by_stated) = &finding.by_stated {
        let said = lang.pick("за написаними числами", "by the stated figures");
        lines.push(comma(&format!("{said}: {by_stated}"), lang));
    }
    if finding.note.params.get("carried").is_some_and(|carried| carried == "no") {
        let said = lang.pick(
            "далі рахували з правильним значенням: описка",
            "the sums after it were made with the right value: a slip of the pen",
        );
        lines.push(said.to_owned());
    }
    if !finding.supplied.is_empty() {
        let said = lang.pick("у плані немає, взято", "not in the plan, taken");
        let taken: Vec<String> =
            finding.supplied.iter().map(|one| format!("{} = {}", one.quantity.symbol(), one.value)).collect();
        lines.push(comma(&format!("{said}: {}", taken.join(", ")), lang));
    }
    lines.extend(finding.reasons.iter().map(|why| sentence(why, lang)));
    let rows: Vec<String> = finding.because.iter().map(|because| row(because, lang)).collect();
    let mut rests: Vec<String> = Vec::new();
    rests.extend((!finding.source.is_empty()).then(|| finding.source.to_owned()));
    for row in rows {
        if !rests.contains(&row) {
            rests.push(row);
        }
    }
    if !rests.is_empty() {
        lines.push(format!("{}: {}", lang.pick("підстава", "rests on"), rests.join("; ")));
    }
    if !finding.follows_from.is_empty() {
        let said = lang.pick("наслідок", "follows from");
        lines.push(format!("{said}: {}", finding.follows_from.join(", ")));
    }
    if !finding.changes.is_empty() {
        let said = lang.pick("через це хибне", "wrong because of it");
        let changes: Vec<String> = finding
            .changes
            .iter()
            .map(|change| comma(&format!("{} {} → {}", change.field, change.stated, change.right), lang))
            .collect();
        lines.push(format!("{said}: {}", changes.join(", ")));
    }
    lines
}

/// A row as a reader finds it: table, number, and whether it is unconfirmed.
fn row(because: &Because, lang: Lang) -> String {
    let number = because.row.map(|row| format!(", {} {row}", lang.pick("рядок", "row"))).unwrap_or_default();
    let doubt = if because.unconfirmed.is_some() {
        lang.pick(" (не підтверджено)", " (unconfirmed)")
    } else {
        ""
    };
    format!("{}{number}{doubt}", because.table)
}

/// Decimal points as the language writes them: a point between two digits.
fn comma(text: &str, lang: Lang) -> String {
    if lang == Lang::En {
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
