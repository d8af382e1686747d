//! Results of cases for people.

use technolog::cases::{ActualValue, Failure, Why, brief};
use technolog::document::{Column, Document, FindingBlock, Inlines, Severity, Table};
use technolog::note::{Because, Figure, Note};
use technolog::words::say;

use super::super::Lang;
use super::{CaseFileRun, CaseRun};

/// The most letters of a value that are shown.
const LONG: usize = 400;
/// The most reasons that are shown; JSON has all.
const REASONS: usize = 4;

/// A line for each file, the differences of its cases, and the sum.
pub fn page(runs: &[CaseFileRun], lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), lang.word("test-title"));
    let mut files = Table::new([Column::text(""), Column::text(""), Column::number("", "")]);
    runs.iter().for_each(|run| files.row(line(run, lang)));
    page.push(files);
    for run in runs {
        for ran in run.cases.iter().filter(|ran| !ran.passed()) {
            let words = say!(lang, "test-case", name = cut(&ran.case.name));
            let lines = ran.failures.iter().flat_map(|failure| failure_lines(failure, lang)).chain(origin(ran, lang));
            page.push(FindingBlock {
                place: Some(ran.case.place.to_string()),
                details: lines.map(|line| Inlines::from(line.as_str())).collect(),
                ..FindingBlock::new(Severity::Wrong, lang.word("test-failed"), words)
            });
        }
    }
    let written: usize = runs.iter().map(CaseFileRun::written).sum();
    if written > 0 {
        page.paragraph(say!(lang, "test-review", cases = say!(lang, "test-cases-counted", count = written)));
    }
    page.paragraph(sum(runs, lang));
    page
}

fn line(run: &CaseFileRun, lang: Lang) -> [Inlines; 3] {
    let state = match (run.mistakes.is_empty(), run.failed()) {
        (false, _) => "test-unusable",
        (true, 0) => "test-passed",
        (true, _) => "test-failed",
    };
    let failed = run.failed();
    let share = if failed == 0 { run.cases.len().to_string() } else { format!("{failed}/{}", run.cases.len()) };
    [lang.word(state).into(), run.file.as_str().into(), Inlines::number(share)]
}

fn sum(runs: &[CaseFileRun], lang: Lang) -> String {
    let cases: usize = runs.iter().map(|run| run.cases.len()).sum();
    let failed: usize = runs.iter().map(CaseFileRun::failed).sum();
    let unusable = runs.iter().filter(|run| !run.mistakes.is_empty()).count();
    let (files, cases) =
        (say!(lang, "test-files-counted", count = runs.len()), say!(lang, "test-cases-counted", count = cases));
    let mut text = match failed {
        // In a file that was not read, no case passed.
        0 if unusable > 0 => say!(lang, "test-none-failed", files = files, cases = cases),
        0 => say!(lang, "test-all-as-expected", files = files, cases = cases),
        _ => say!(lang, "test-some-failed", files = files, cases = cases, failed = failed),
    };
    if unusable > 0 {
        text.push_str(&say!(lang, "test-unusable-files", count = unusable));
    }
    text
}

/// The origin of the expectation.
pub fn origin(ran: &CaseRun, lang: Lang) -> impl Iterator<Item = String> {
    let source = ran.case.source.as_ref().map(|text| say!(lang, "test-source", text = text));
    let because = ran.case.because.as_ref().map(|text| say!(lang, "test-because", text = text));
    source.into_iter().chain(because)
}

/// A failure: its place, its path in the answer, and the two values with the reasons.
pub fn failure_lines(failure: &Failure, lang: Lang) -> Vec<String> {
    let place = &failure.place;
    let mut lines = vec![format!("{}:{} {}", place.line, place.column, failure.path)];
    lines.push(say!(lang, "test-expected", value = cut(&expected(failure, lang))));
    lines.push(say!(lang, "test-came", value = cut(&actual_value(failure, lang))));
    lines.extend(failure.reasons.iter().take(REASONS).map(|reason| say!(lang, "test-why", reason = why(reason, lang))));
    lines
}

/// The failure in one line.
pub fn short(failure: &Failure, lang: Lang) -> String {
    let (expected, came) = (cut(&expected(failure, lang)), cut(&actual_value(failure, lang)));
    say!(lang, "test-short", path = &failure.path, expected = expected, came = came)
}

/// The expected value.
pub fn expected(failure: &Failure, lang: Lang) -> String {
    match (&failure.actual, failure.expected.as_str()) {
        (ActualValue::Open(_), _) => say!(lang, "test-nothing-yet").to_owned(),
        (ActualValue::Unwanted(_), written) => say!(lang, "test-not-there", written = written),
        (_, written) => written.to_owned(),
    }
}

/// The actual value.
pub fn actual_value(failure: &Failure, lang: Lang) -> String {
    match &failure.actual {
        ActualValue::Value(value) | ActualValue::Open(Some(value)) => brief(value),
        ActualValue::Nothing | ActualValue::Open(None) => say!(lang, "test-nothing").to_owned(),
        ActualValue::Without(list) => say!(lang, "test-without", list = brief(list)),
        ActualValue::Unwanted(value) => match serde_json::from_value::<Note>(value.clone()) {
            // A finding of an audit contains its figures itself.
            Ok(note) if value.get("field").is_none() => format!("{}: {}", brief(value), lang.say(&note)),
            _ => brief(value),
        },
        ActualValue::NoSuch { key, near: Some(near), .. } => {
            say!(lang, "test-no-such-key-near", key = key, near = near)
        }
        ActualValue::NoSuch { key, known, .. } => say!(lang, "test-no-such-key", key = key, known = known.join(", ")),
        ActualValue::NoSuchWord { word, near: Some(near) } => {
            say!(lang, "test-no-such-word-near", word = word, near = near)
        }
        ActualValue::NoSuchWord { word, near: None } => say!(lang, "test-no-such-word", word = word),
    }
}

/// A reason in words.
pub fn why(reason: &Why, lang: Lang) -> String {
    match reason {
        Why::Because(because) => decision(because, lang),
        Why::NotTaken { scheme, why } => {
            say!(lang, "test-not-taken", scheme = Figure::scheme(scheme), why = lang.say(why))
        }
        Why::Finding(finding) => lang.say(&finding.note),
        Why::OtherRow { row, column, cell } => say!(lang, "test-other-row", row = *row, column = column, cell = cell),
    }
}

fn decision(because: &Because, lang: Lang) -> String {
    let text = if because.note.is_empty() { lang.place(&because.place) } else { lang.say(&because.note) };
    match because.row {
        Some(row) => say!(lang, "test-row", table = &because.table, row = row, said = text),
        None => say!(lang, "test-table", table = &because.table, said = text),
    }
}

fn cut(text: &str) -> String {
    match text.char_indices().nth(LONG) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
