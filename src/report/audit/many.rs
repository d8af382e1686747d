//! Audits of many plans as a table: a line for each, where to begin in it.

use crate::audit::{Audit, Audited, Summary, total};

use super::super::{Lang, grid, sentence};
use super::{comma, place};

/// The table for people.
pub fn page(audited: &[Audited], lang: Lang) -> String {
    let (head, rows) = table(audited, lang);
    // A table that is too wide is columns without rules.
    let table = grid::table(&head, &rows, 0);
    format!("{table}\n{}\n", summary(audited, lang))
}

/// The same for documents.
pub fn markdown(audited: &[Audited], lang: Lang) -> String {
    let (head, rows) = table(audited, lang);
    let line = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    let rows: String = rows.iter().map(|row| line(row)).collect();
    format!("# {}\n\n{}{rule}{rows}\n{}\n", title(lang), line(&head), summary(audited, lang))
}

/// What the table is of.
pub(super) fn title(lang: Lang) -> &'static str {
    lang.pick("Перевірка планів", "Audit of plans")
}

/// Head and rows.
pub(super) fn table(audited: &[Audited], lang: Lang) -> (Vec<String>, Vec<Vec<String>>) {
    let mut head = match lang {
        Lang::Uk => ["файл", "помилки", "хибне", "сумнівне", "зауваження", "перша причина"],
        Lang::En => ["file", "errors", "wrong", "doubtful", "notes", "first root"],
    }
    .map(str::to_owned)
    .to_vec();
    let marked = audited.iter().filter_map(Audited::audit).any(|audit| audit.marks.is_some());
    if marked {
        head.push(lang.pick("бали", "marks").to_owned());
    }
    let rows = audited.iter().map(|one| match one {
        Audited::Plan(audit) => row(audit, lang),
        Audited::Unreadable(unread) => {
            let why = unread.unreadable.first().map(|mistake| mistake.message.as_str()).unwrap_or_default();
            let said = format!("{}: {why}", lang.pick("не читається", "cannot be read"));
            let mut row = [unread.file.as_str(), "-", "-", "-", "-", &said].map(str::to_owned).to_vec();
            row.extend(marked.then(|| "-".to_owned()));
            row
        }
    });
    let rows = rows.collect();
    (head, rows)
}

fn row(audit: &Audit, lang: Lang) -> Vec<String> {
    let Summary { error, wrong, doubtful, note, .. } = audit.summary;
    let mut row = vec![audit.file.clone()];
    row.extend([error, wrong, doubtful, note].map(|count| count.to_string()));
    row.push(root(audit, lang));
    row.extend(audit.marks.as_ref().map(|marks| {
        let failed = if marks.passed == Some(false) { " !" } else { "" };
        comma(&format!("{}{failed}", marks.points), lang)
    }));
    row
}

/// Where to begin: `31:5 conditions.2.feed: 0.25 → 0.325`.
fn root(audit: &Audit, lang: Lang) -> String {
    let Some(root) = audit.first_root() else { return String::new() };
    let at = place(root, &audit.file).map(|place| format!("{place} ")).unwrap_or_default();
    let said = match (&root.stated, &root.right) {
        (Some(stated), Some(right)) => comma(&format!("{stated} → {right}"), lang),
        _ => sentence(&root.note, lang),
    };
    format!("{at}{}: {said}", root.field)
}

/// One line under the table.
pub(super) fn summary(audited: &[Audited], lang: Lang) -> String {
    let unread = audited.iter().filter(|one| one.audit().is_none()).count();
    let (plans, Summary { error, wrong, doubtful, note, .. }) = (audited.len(), total(audited));
    match lang {
        Lang::Uk => format!(
            "планів {plans}, з них не читається {unread}; помилок {error}, хибного {wrong}, сумнівного {doubtful}, зауважень {note}"
        ),
        Lang::En => format!(
            "{plans} plans, {unread} of them unreadable; {error} errors, {wrong} wrong, {doubtful} doubtful, {note} notes"
        ),
    }
}
