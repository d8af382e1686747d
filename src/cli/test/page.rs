//! Cases that were run, for people.

use technolog::cases::{Came, Failure, Why, brief};
use technolog::note::{Because, Note};
use technolog::report::{grid, sentence};

use super::super::Context;
use super::super::words::Lang;
use super::{Ran, Run, words};

/// The most letters of a value that are shown.
const LONG: usize = 400;
/// The most reasons that are shown; JSON has all.
const REASONS: usize = 4;

/// A line for each file, what of its cases is not as expected, and the sum.
pub fn page(runs: &[Run], context: &Context) -> String {
    let lang = context.lang;
    let lines: Vec<Vec<String>> = runs.iter().map(|run| line(run, lang)).collect();
    let mut page = grid::columns(&lines, 0);
    for run in runs {
        for ran in run.cases.iter().filter(|ran| !ran.passed()) {
            page.push('\n');
            page.push_str(&grid::paragraph(&format!("{} «{}»", ran.case.place, cut(&ran.case.name)), 0));
            for failure in &ran.failures {
                page.push_str(&told(failure, lang));
            }
            for (head, text) in origin(ran, lang) {
                page.push_str(&pair(head, &text));
            }
        }
    }
    let written: usize = runs.iter().map(Run::written).sum();
    if written > 0 {
        page.push_str(&format!("\n{}: {}\n", words::cases(lang, written), words::review(lang)));
    }
    page + "\n" + &sum(runs, lang) + "\n"
}

fn line(run: &Run, lang: Lang) -> Vec<String> {
    let state = match (run.mistakes.is_empty(), run.failed()) {
        (false, _) => words::unusable(lang),
        (true, 0) => words::passed(lang),
        (true, _) => words::failed(lang),
    };
    let failed = run.failed();
    let share = if failed == 0 { run.cases.len().to_string() } else { format!("{failed}/{}", run.cases.len()) };
    vec![state.to_owned(), run.file.clone(), share]
}

fn sum(runs: &[Run], lang: Lang) -> String {
    let cases: usize = runs.iter().map(|run| run.cases.len()).sum();
    let failed: usize = runs.iter().map(Run::failed).sum();
    let unusable = runs.iter().filter(|run| !run.mistakes.is_empty()).count();
    words::summary(lang, words::files(lang, runs.len()), words::cases(lang, cases), failed, unusable)
}

/// Where the expectation comes from.
pub fn origin(ran: &Ran, lang: Lang) -> Vec<(&'static str, String)> {
    let source = ran.case.source.clone().map(|text| (words::source(lang), text));
    let because = ran.case.because.clone().map(|text| (words::because(lang), text));
    source.into_iter().chain(because).collect()
}

/// A failure: where it stands, what of the answer it is about, and the two values with the reasons.
pub fn told(failure: &Failure, lang: Lang) -> String {
    let place = &failure.place;
    let mut text = grid::paragraph(&format!("{}:{} {}", place.line, place.column, failure.path), 2);
    text.push_str(&pair(words::expected(lang), &cut(&expected(failure, lang))));
    text.push_str(&pair(words::came(lang), &cut(&came(failure, lang))));
    for reason in failure.why.iter().take(REASONS) {
        text.push_str(&pair(words::why(lang), &why(reason, lang)));
    }
    text
}

/// The failure in one line.
pub fn short(failure: &Failure, lang: Lang) -> String {
    let (expected, came) = (cut(&expected(failure, lang)), cut(&came(failure, lang)));
    format!("{}: {} {expected}; {} {came}", failure.path, words::expected(lang), words::came(lang))
}

/// What was expected.
pub fn expected(failure: &Failure, lang: Lang) -> String {
    match (&failure.came, failure.expected.as_str()) {
        (Came::Open(_), _) => words::nothing_yet(lang).to_owned(),
        (Came::Unwanted(_), written) => format!("{}: {written}", words::not_there(lang)),
        (_, written) => written.to_owned(),
    }
}

/// What came.
pub fn came(failure: &Failure, lang: Lang) -> String {
    match &failure.came {
        Came::Value(value) | Came::Open(Some(value)) => brief(value),
        Came::Nothing | Came::Open(None) => words::nothing(lang).to_owned(),
        Came::Without(list) => words::without(lang, brief(list)),
        Came::Unwanted(value) => match serde_json::from_value::<Note>(value.clone()) {
            // A finding of an audit says its figures itself.
            Ok(note) if value.get("field").is_none() => format!("{}: {}", brief(value), sentence(&note, lang)),
            _ => brief(value),
        },
        Came::NoSuch { key, near, known } => words::no_such_key(lang, key, near.as_deref(), known),
        Came::NoSuchWord { word, near } => words::no_such_word(lang, word, near.as_deref()),
    }
}

/// A reason in words.
pub fn why(reason: &Why, lang: Lang) -> String {
    match reason {
        Why::Because(because) => decision(because, lang),
        Why::NotTaken { scheme, why } => words::not_taken(lang, scheme, sentence(why, lang)),
        Why::Finding(finding) => sentence(&finding.note, lang),
        Why::OtherRow { row, column, cell } => words::other_row(lang, *row, column, cell),
    }
}

fn decision(because: &Because, lang: Lang) -> String {
    let row = words::row(lang, &because.table, because.row);
    let said = if because.note.is_empty() { because.place.clone() } else { sentence(&because.note, lang) };
    format!("{row}: {said}")
}

fn pair(head: &str, text: &str) -> String {
    grid::paragraph(&format!("{head}: {text}"), 4)
}

fn cut(text: &str) -> String {
    match text.char_indices().nth(LONG) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
