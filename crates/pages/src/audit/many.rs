//! Audits of many plans as a table: one line for each, with its first finding.

use technolog_audit::class::Alike;
use technolog_audit::{Audit, Audited, Counts, Unread, total};
use technolog_document::{Column, Document, Inlines, Keep, Table};
use technolog_words::say;

use super::super::Lang;
use super::words::{change, figure, whereabouts};
use super::{counts, finding_text, place};

/// The page.
///
/// `alike` are the works alike, for the lecturer. `sheets` are the paths of the students' sheets from the page, one for each work; none where there are no sheets.
pub fn page(audited: &[Audited], alike: &[Alike], sheets: &[String], lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), lang.word("audit-folder"));
    page.push(table(audited, sheets, lang));
    let unread = audited.iter().filter(|one| one.audit().is_none()).count();
    let Counts { error, wrong, doubtful, note, .. } = total(audited);
    page.paragraph(say!(
        lang,
        "audit-folder-summary",
        plans = audited.len(),
        unread = unread,
        error = error,
        wrong = wrong,
        doubtful = doubtful,
        note = note
    ));
    super::class::push(&mut page, audited, alike, lang);
    page
}

fn table(audited: &[Audited], sheets: &[String], lang: Lang) -> Table {
    let marked = audited.iter().filter_map(Audited::audit).any(|audit| audit.marks.is_some());
    let mut columns = vec![Column::text(lang.word("audit-column-file"))];
    // The columns that decide whether a plan passes are kept longest.
    let keeps = [Keep::Always, Keep::Always, Keep::Useful, Keep::Optional];
    columns.extend(counts::severities(lang).zip(keeps).map(|(column, keep)| column.keep(keep)));
    columns.push(Column::text(lang.word("audit-column-root")).min_width(24));
    columns.extend(marked.then(|| Column::number(lang.word("audit-column-marks"), "")));
    let mut table = Table::new(columns);
    for (at, one) in audited.iter().enumerate() {
        table.row(match one {
            Audited::Plan(audit) => row(audit, sheets.get(at), lang),
            Audited::Unreadable(unread) => {
                let mut row = vec![Inlines::from(unread.file.as_str())];
                row.extend(std::iter::repeat_n(Inlines::from("–"), 4));
                row.push(Inlines::sentence(&unreadable(unread, lang)));
                row
            }
        });
    }
    table
}

fn row(audit: &Audit, sheet: Option<&String>, lang: Lang) -> Vec<Inlines> {
    let mut row = vec![match sheet {
        Some(sheet) => Inlines::default().link(audit.file.as_str(), sheet.as_str()),
        None => Inlines::from(audit.file.as_str()),
    }];
    row.extend(counts::by_severity(audit.summary.all).map(counts::number));
    row.push(Inlines::sentence(&root(audit, lang)));
    row.extend(audit.marks.as_ref().map(|marks| {
        let points = figure(&marks.points.to_string(), lang);
        let failed = marks.passed == Some(false);
        Inlines::number(if failed { say!(lang, "audit-failed-mark", points = points) } else { points })
    }));
    row
}

/// Why a file cannot be read: its first mistake.
fn unreadable(unread: &Unread, lang: Lang) -> String {
    let Some(mistake) = unread.unreadable.first() else { return String::new() };
    let place = mistake.place.as_deref().unwrap_or_default();
    let place = place.strip_prefix(&format!("{}:", unread.file)).unwrap_or(place);
    match mistake.code {
        // The parser's message is shown only when the file is audited alone.
        "yaml" => say!(lang, "audit-no-yaml", place = place),
        _ => say!(lang, "audit-unreadable", place = place, message = &mistake.message).trim_start().to_owned(),
    }
}

/// The first finding to look at: `31:5 свердління A: подача S 0,25 → 0,325`.
fn root(audit: &Audit, lang: Lang) -> String {
    let Some(root) = audit.first_root() else { return String::new() };
    let whereabouts = whereabouts(root, lang);
    let text = match (root.quantity, &root.stated, &root.right) {
        (Some(_), Some(stated), Some(right)) => {
            say!(lang, "audit-root", whereabouts = whereabouts, change = change(stated, right, lang))
        }
        _ => say!(lang, "audit-about", about = whereabouts, said = finding_text(root, lang)),
    };
    place(root, &audit.file).map_or_else(|| text.clone(), |place| format!("{place}: {text}"))
}
