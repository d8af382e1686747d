//! Audits of many plans as a table: a line for each, where to begin in it.

use technolog_audit::{Audit, Audited, Counts, Mistake, total};

use super::super::{Lang, grid};
use super::words::whereabouts;
use super::{comma, counts, marked_table, place, said};

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
    format!("# {}\n\n{}\n{}\n", title(lang), marked_table(&head, &rows), summary(audited, lang))
}

/// What the table is of.
pub(super) fn title(lang: Lang) -> &'static str {
    lang.pick("Перевірка планів", "Audit of plans")
}

/// Head and rows.
pub(super) fn table(audited: &[Audited], lang: Lang) -> (Vec<String>, Vec<Vec<String>>) {
    let mut head = vec![lang.pick("файл", "file").to_owned()];
    head.extend(counts::severities(lang).map(str::to_owned));
    head.push(lang.pick("перша причина", "first root").to_owned());
    let marked = audited.iter().filter_map(Audited::audit).any(|audit| audit.marks.is_some());
    if marked {
        head.push(lang.pick("бали", "marks").to_owned());
    }
    let rows = audited.iter().map(|one| match one {
        Audited::Plan(audit) => row(audit, lang),
        Audited::Unreadable(unread) => {
            let why =
                unread.unreadable.first().map(|mistake| mistaken(mistake, &unread.file, lang)).unwrap_or_default();
            let mut row = [unread.file.as_str(), "-", "-", "-", "-", &why].map(str::to_owned).to_vec();
            row.extend(marked.then(|| "-".to_owned()));
            row
        }
    });
    let rows = rows.collect();
    (head, rows)
}

fn row(audit: &Audit, lang: Lang) -> Vec<String> {
    let mut row = vec![audit.file.clone()];
    row.extend(counts::by_severity(audit.summary.all).map(|count| count.to_string()));
    row.push(root(audit, lang));
    row.extend(audit.marks.as_ref().map(|marks| {
        let failed = if marks.passed == Some(false) { " !" } else { "" };
        comma(&format!("{}{failed}", marks.points), lang)
    }));
    row
}

/// Why a file cannot be read. Readers of files speak English; other languages have the kind of the mistake, the name
/// that it is about and the place, and the whole of it where the file is audited alone.
fn mistaken(mistake: &Mistake, file: &str, lang: Lang) -> String {
    let place = mistake.place.as_deref().map(|place| place.strip_prefix(&format!("{file}:")).unwrap_or(place));
    let at = place.map(|place| format!("{place} ")).unwrap_or_default();
    if lang == Lang::EN {
        return format!("{at}cannot be read: {}", mistake.message);
    }
    let kind = match mistake.code {
        "yaml" => "файл записано не за правилами YAML",
        "missing-key" => "бракує ключа",
        "unknown-key" => "незнайомий ключ",
        "duplicate-key" | "duplicate-name" | "duplicate-row" | "duplicate-tool" => "двічі те саме",
        "unreadable" => "немає файлу",
        code if code.starts_with("unknown-") => "незнайоме ім'я",
        _ => "негодне значення",
    };
    // What stands in backticks is written in the file.
    let named = mistake.message.split('`').nth(1).filter(|_| mistake.code != "yaml");
    let named = named.map(|name| format!(" `{name}`")).unwrap_or_default();
    format!("{at}не читається: {kind}{named}")
}

/// Where to begin: `31:5 свердління A: подача S 0,25 → 0,325`.
fn root(audit: &Audit, lang: Lang) -> String {
    let Some(root) = audit.first_root() else { return String::new() };
    let at = place(root, &audit.file).map(|place| format!("{place} ")).unwrap_or_default();
    let whereabouts = whereabouts(root, lang);
    match (root.quantity, &root.stated, &root.right) {
        (Some(_), Some(stated), Some(right)) => {
            format!("{at}{whereabouts} {}", comma(&format!("{stated} → {right}"), lang))
        }
        _ => format!("{at}{whereabouts}: {}", said(root, lang)),
    }
}

/// One line under the table.
pub(super) fn summary(audited: &[Audited], lang: Lang) -> String {
    let unread = audited.iter().filter(|one| one.audit().is_none()).count();
    let (plans, Counts { error, wrong, doubtful, note, .. }) = (audited.len(), total(audited));
    match lang {
        _ if lang == Lang::UK => format!(
            "планів {plans}, з них не читається {unread}; помилок {error}, хибного {wrong}, сумнівного {doubtful}, зауважень {note}"
        ),
        _ => format!(
            "{plans} plans, {unread} of them unreadable; {error} errors, {wrong} wrong, {doubtful} doubtful, {note} notes"
        ),
    }
}
