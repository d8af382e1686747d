//! An audit as a page: by sections of the plan, the most severe first, each finding with what it rests on and what else
//! changes because of it.

pub mod against;
mod counts;
pub mod html;
mod keys;
pub mod many;
mod marks;
mod words;

use crate::note::Because;
use technolog_audit::{Audit, Finding, Section};

use super::{Lang, grid, sentence};
pub use words::severity;
use words::{comma, heading, name, place, said, subject};

/// The page for people.
pub fn page(audit: &Audit, lang: Lang) -> String {
    let mut page = format!("{} ({})\n{}\n", title(audit, lang), audit.file, summary(audit, lang));
    let (head, rows) = counts::table(audit, lang);
    if !rows.is_empty() {
        page.push_str(&format!("\n{}", grid::table(&head, &rows, 0)));
    }
    for (section, findings) in by_section(audit) {
        page.push_str(&format!("\n{}\n", heading(section, lang)));
        for finding in findings {
            let at = place(finding, &audit.file).map(|place| format!(" {place}")).unwrap_or_default();
            let head = format!("{}{at} {}", severity(finding.severity, lang), headline(finding, lang));
            page.push_str(&grid::paragraph(&head, 2));
            for line in details(finding, audit, lang) {
                page.push_str(&grid::paragraph(&line, 6));
            }
        }
    }
    if let Some(marks) = &audit.marks {
        page.push_str(&format!("\n{}\n", marks::headline(marks, lang)));
        for line in marks::lines(marks, audit, lang) {
            page.push_str(&grid::paragraph(&line, 2));
        }
    }
    page
}

/// The same for documents.
pub fn markdown(audit: &Audit, lang: Lang) -> String {
    let mut page = format!("# {}\n\n`{}`\n\n{}\n", title(audit, lang), audit.file, summary(audit, lang));
    let (head, rows) = counts::table(audit, lang);
    if !rows.is_empty() {
        page.push_str(&format!("\n{}", marked_table(&head, &rows)));
    }
    for (section, findings) in by_section(audit) {
        page.push_str(&format!("\n## {}\n\n", heading(section, lang)));
        for finding in findings {
            let at = place(finding, &audit.file).map(|place| format!(" `{place}`")).unwrap_or_default();
            let said = headline(finding, lang);
            page.push_str(&format!("- **{}**{at} {said}\n", severity(finding.severity, lang)));
            for line in details(finding, audit, lang) {
                page.push_str(&format!("  - {line}\n"));
            }
        }
    }
    if let Some(marks) = &audit.marks {
        page.push_str(&format!("\n## {}\n\n", marks::headline(marks, lang)));
        for line in marks::lines(marks, audit, lang) {
            page.push_str(&format!("- {line}\n"));
        }
    }
    page
}

fn title(audit: &Audit, lang: Lang) -> String {
    format!("{} «{}»", lang.pick("Перевірка плану", "Audit of the plan"), audit.plan)
}

fn summary(audit: &Audit, lang: Lang) -> String {
    let own = audit.summary.all;
    match lang {
        _ if lang == Lang::UK => format!(
            "помилок {}, хибного {}, сумнівного {}, зауважень {}; з них наслідків інших {}",
            own.error, own.wrong, own.doubtful, own.note, own.follow
        ),
        _ => format!(
            "{} errors, {} wrong, {} doubtful, {} notes; of these {} follow from others",
            own.error, own.wrong, own.doubtful, own.note, own.follow
        ),
    }
}

/// The findings of each section that has some; an audit has them in order.
fn by_section(audit: &Audit) -> impl Iterator<Item = (Section, Vec<&Finding>)> {
    let mut sections: Vec<Section> = audit.findings.iter().map(|finding| finding.section).collect();
    sections.sort_unstable();
    sections.dedup();
    let of = |section: Section| audit.findings.iter().filter(|finding| finding.section == section).collect();
    let whole: Vec<(Section, Vec<&Finding>)> = sections.into_iter().map(|section| (section, of(section))).collect();
    whole.into_iter()
}

/// What is wrong, in one sentence.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
fn headline(finding: &Finding, lang: Lang) -> String {
    let about = words::block(finding).map_or_else(|| subject(&finding.subject, lang), str::to_owned);
    let said = said(finding, lang);
    let said = match (finding.quantity, &finding.stated, &finding.right) {
        (Some(_), Some(stated), Some(right)) => {
            let figure = figure(finding, stated, right, lang);
            if matches!(finding.note.code(), "audit-figure" | "audit-follows") {
                figure
            } else {
                format!("{figure}; {said}")
            }
        }
        (Some(_), Some(stated), None) => {
            let what = words::what(finding, lang);
            format!("{what}: {} {}; {said}", lang.pick("написано", "stated"), comma(stated, lang))
        }
        _ => said,
    };
    if about.is_empty() { said } else { format!("{about}: {said}") }
}

/// `подача S: написано 0,25, має бути 0,325 мм/об (-23,1 %)`.
fn figure(finding: &Finding, stated: &str, right: &str, lang: Lang) -> String {
    let unit = finding.quantity.map(|quantity| lang.pick(quantity.unit().0, quantity.unit().1)).unwrap_or_default();
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let off = finding.deviation_percent.filter(|off| off.abs() >= 0.1);
    let off = off.map(|off| format!(" ({off:+} %)")).unwrap_or_default();
    let [said, be] = [lang.pick("написано", "stated"), lang.pick("має бути", "should be")];
    let figures = comma(&format!("{said} {stated}, {be} {right}{unit}{off}"), lang);
    format!("{}: {figures}", words::what(finding, lang))
}

/// What the finding rests on and what follows from it.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
fn details(finding: &Finding, audit: &Audit, lang: Lang) -> Vec<String> {
    let mut lines = Vec::new();
    if !finding.formula.is_empty() {
        lines.push(comma(&finding.formula, lang));
    }
    if let Some(by_stated) = &finding.by_stated {
        let said = lang.pick("за написаними числами", "by the stated figures");
        lines.push(comma(&format!("{said}: {by_stated}"), lang));
    }
    if finding.note.figure("carried").is_some_and(|carried| carried.text() == "no") {
        let said = lang.pick(
            "далі рахували з правильним значенням: описка",
            "the sums after it were made with the right value: a slip of the pen",
        );
        lines.push(said.to_owned());
    }
    if !finding.supplied.is_empty() {
        let said = lang.pick("у плані немає, взято", "not in the plan, taken");
        let taken: Vec<String> = finding
            .supplied
            .iter()
            .map(|one| format!("{} = {}", name(one.quantity, lang), comma(&one.value, lang)))
            .collect();
        lines.push(format!("{said}: {}", taken.join(", ")));
    }
    lines.extend(finding.reasons.iter().map(|why| sentence(why, lang)));
    let rows: Vec<String> = finding.because.iter().map(|because| row(because, lang)).collect();
    let mut rests: Vec<String> = Vec::new();
    let source = lang.pick(finding.source.0, finding.source.1);
    rests.extend((!source.is_empty()).then(|| source.to_owned()));
    for row in rows {
        if !rests.contains(&row) {
            rests.push(row);
        }
    }
    if !rests.is_empty() {
        lines.push(format!("{}: {}", lang.pick("підстава", "rests on"), rests.join("; ")));
    }
    if !finding.follows_from.is_empty() {
        let roots = finding.follows_from.iter().map(|root| (root.as_str(), String::new()));
        lines.push(format!("{}: {}", lang.pick("наслідок", "follows from"), words::fields(roots, audit, lang)));
    }
    if !finding.changes.is_empty() {
        let change = |stated: &str, right: &str| comma(&format!("{stated} → {right}"), lang);
        let changes = finding.changes.iter().map(|one| (one.field.as_str(), change(&one.stated, &one.right)));
        let said = lang.pick("через це хибне", "wrong because of it");
        lines.push(format!("{said}: {}", words::fields(changes, audit, lang)));
    }
    lines
}

/// A table of a document, under a head.
fn marked_table(head: &[String], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rows: String = rows.iter().map(|row| line(row)).collect();
    format!("{}|{}\n{rows}", line(head), "---|".repeat(head.len()))
}

/// A row as a reader finds it: table, number, and whether it is unconfirmed.
fn row(because: &Because, lang: Lang) -> String {
    let number = because.row.map(|row| format!(", {} {row}", lang.pick("рядок", "row"))).unwrap_or_default();
    let doubt = if because.unconfirmed.is_some() {
        lang.pick(" (не підтверджено)", " (unconfirmed)")
    } else {
        ""
    };
    format!("{} {}{number}{doubt}", lang.pick("таблиця", "table"), because.table)
}
