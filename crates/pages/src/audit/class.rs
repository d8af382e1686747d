//! A class for its lecturer: the grade book, the mistakes it makes most, and works with the same unusual figures.

use technolog_audit::class::{Alike, Common, common};
use technolog_audit::{Audit, Audited, Section};
use technolog_document::{Column, Document, Inlines, Table};
use technolog_words::say;

use super::super::Lang;
use super::words::{figure, whereabouts};
use super::{finding_text, heading};

/// A table of the grade book: its name, its head, and its rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GradeTable {
    /// What it holds.
    pub name: String,
    /// The head and the rows; figures have a decimal point.
    pub rows: Vec<Vec<String>>,
}

/// The sections whose marks have a column each.
const SECTIONS: [Section; 9] = [
    Section::Route,
    Section::Tools,
    Section::Holders,
    Section::Conditions,
    Section::Clamping,
    Section::Lengths,
    Section::Program,
    Section::Times,
    Section::Missing,
];

/// The grade book: a row for each work, the mistakes of the class, and `alike`, the works alike.
pub fn grade_book(audited: &[Audited], alike: &[Alike], lang: Lang) -> Vec<GradeTable> {
    let mut tables = vec![grades(audited, lang)];
    let mistakes: Vec<Vec<String>> = common(audited).iter().map(|one| mistake(one, audited, lang).to_vec()).collect();
    tables.extend(table(
        "audit-class-mistakes",
        ["audit-column-mistake", "audit-column-works", "audit-column-where"],
        mistakes,
        lang,
    ));
    let pairs: Vec<Vec<String>> = alike.iter().map(|one| pair(one, audited, lang).to_vec()).collect();
    tables.extend(table(
        "audit-class-alike",
        ["audit-column-work", "audit-column-other-work", "audit-column-same"],
        pairs,
        lang,
    ));
    tables
}

fn table(name: &str, head: [&str; 3], rows: Vec<Vec<String>>, lang: Lang) -> Option<GradeTable> {
    let head = head.iter().map(|key| lang.word(key).to_owned()).collect();
    let name = lang.word(name).to_owned();
    (!rows.is_empty()).then(|| GradeTable { name, rows: std::iter::once(head).chain(rows).collect() })
}

fn grades(audited: &[Audited], lang: Lang) -> GradeTable {
    let marked = audited.iter().filter_map(Audited::audit).any(|audit| audit.marks.is_some());
    let word = |key: &str| lang.word(key).to_owned();
    let mut head: Vec<String> =
        ["column-student", "column-group", "column-variant", "audit-column-file"].map(word).to_vec();
    head.extend(["audit-column-error", "audit-column-wrong", "audit-column-doubtful"].map(word));
    if marked {
        head.extend(["audit-column-marks", "audit-column-of", "audit-column-passed"].map(word));
        head.extend(
            SECTIONS.iter().map(|section| say!(lang, "audit-column-taken-by", section = heading(*section, lang))),
        );
    }
    head.push(word("audit-column-remark"));
    let rows = audited.iter().map(|one| match one {
        Audited::Plan(audit) => grade(audit, marked, lang),
        Audited::Unreadable(unread) => {
            let author = technolog_audit::stated::Author::default().or_by_file(&unread.file);
            let mut row: Vec<String> =
                [author.student, author.group, author.variant].map(Option::unwrap_or_default).to_vec();
            row.push(unread.file.clone());
            row.resize(head.len() - 1, String::new());
            row.push(unread.unreadable.first().map(|mistake| mistake.message.clone()).unwrap_or_default());
            row
        }
    });
    let rows: Vec<Vec<String>> = rows.collect();
    GradeTable { name: lang.word("audit-class-grades").to_owned(), rows: std::iter::once(head).chain(rows).collect() }
}

fn grade(audit: &Audit, marked: bool, lang: Lang) -> Vec<String> {
    let author = audit.author.clone().or_by_file(&audit.file);
    let mut row: Vec<String> = [author.student, author.group, author.variant].map(Option::unwrap_or_default).to_vec();
    row.push(audit.file.clone());
    let own = audit.summary.all;
    row.extend([own.error, own.wrong, own.doubtful].map(|count| count.to_string()));
    if let Some(marks) = audit.marks.as_ref().filter(|_| marked) {
        let passed = marks.passed.map(|passed| lang.word(if passed { "written-true" } else { "written-false" }));
        row.extend([marks.points.to_string(), marks.maximum.to_string(), passed.unwrap_or_default().to_owned()]);
        for section in SECTIONS {
            let by_findings = marks.deductions.iter().filter(|one| one.section == section).map(|one| one.points);
            let missing = marks.missing.iter().filter(|_| section == Section::Missing).map(|one| one.points);
            // A sum of tenths has no more places than its parts.
            let taken: f64 = by_findings.chain(missing).sum();
            let taken = (taken * 1000.0).round() / 1000.0;
            row.push(if taken > 0.0 { taken.to_string() } else { "0".to_owned() });
        }
    }
    row.push(String::new());
    row
}

/// Who made a work, or its file.
fn who(audited: &[Audited], at: usize) -> String {
    let file = match audited.get(at) {
        Some(Audited::Plan(audit)) => {
            let author = audit.author.clone().or_by_file(&audit.file);
            return author.student.unwrap_or_else(|| audit.file.clone());
        }
        Some(Audited::Unreadable(unread)) => unread.file.as_str(),
        None => "",
    };
    file.to_owned()
}

fn mistake(one: &Common<'_>, audited: &[Audited], lang: Lang) -> [String; 3] {
    let finding = one.example;
    let what = match (finding.quantity, &finding.mistake) {
        (Some(_), Some(mistake)) => {
            say!(lang, "audit-about", about = super::words::quantity_text(finding, lang), said = lang.say(mistake))
        }
        (Some(_), None) => super::words::quantity_text(finding, lang),
        (None, _) => finding_text(finding, lang),
    };
    let works: Vec<String> = one.works.iter().map(|at| who(audited, *at)).collect();
    [what, one.works.len().to_string(), works.join(", ")]
}

fn pair(one: &Alike, audited: &[Audited], lang: Lang) -> [String; 3] {
    let audit = audited.get(one.works.0).and_then(Audited::audit);
    let shown = |(field, stated): &(String, String)| {
        let finding = audit.and_then(|audit| audit.findings.iter().find(|finding| finding.field == *field));
        let about = finding.map_or_else(|| field.clone(), |finding| whereabouts(finding, lang));
        say!(lang, "audit-same-figure", about = about, stated = figure(stated, lang))
    };
    let figures: Vec<String> = one.figures.iter().map(shown).collect();
    [who(audited, one.works.0), who(audited, one.works.1), figures.join("; ")]
}

/// What the page of a folder tells of the whole class, below its works.
pub(super) fn push(page: &mut Document, audited: &[Audited], alike: &[Alike], lang: Lang) {
    let mut add = |name: &str, note: &str, columns: [Column; 3], rows: Vec<[String; 3]>, number: Option<usize>| {
        if rows.is_empty() {
            return;
        }
        page.heading(2, lang.word(name));
        let mut table = Table::new(columns);
        for row in rows {
            let cells = row.iter().enumerate();
            table.row(cells.map(|(at, text)| {
                if Some(at) == number { Inlines::number(text.clone()) } else { Inlines::sentence(text) }
            }));
        }
        table.notes.push(lang.word(note).into());
        page.push(table);
    };
    let text = |head: &str| Column::text(lang.word(head));
    let columns = [
        text("audit-column-mistake").min_width(30),
        Column::number(lang.word("audit-column-works"), ""),
        text("audit-column-where"),
    ];
    let rows = common(audited).iter().map(|one| mistake(one, audited, lang)).collect();
    add("audit-class-mistakes", "audit-class-mistakes-note", columns, rows, Some(1));
    let columns = [text("audit-column-work"), text("audit-column-other-work"), text("audit-column-same").min_width(30)];
    let rows = alike.iter().map(|one| pair(one, audited, lang)).collect();
    add("audit-class-alike", "audit-class-alike-note", columns, rows, None);
}
