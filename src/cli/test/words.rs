//! The words of the command `test`.

use std::fmt::Display;

use technolog::words::say;

use super::super::words::Lang;

macro_rules! said {
    ($($name:ident: $key:literal;)*) => {$(
        #[doc = concat!("The message `", $key, "`.")]
        pub fn $name(lang: Lang) -> &'static str {
            lang.word($key)
        }
    )*};
}

said! {
    what_is_a_case: "test-what-is-a-case";
    another_file: "test-another-file";
    one_copy: "test-one-copy";
    one_by_one: "test-one-by-one";
    passed: "test-passed";
    failed: "test-failed";
    unusable: "test-unusable";
    expected: "test-expected";
    came: "test-came";
    why: "test-why";
    source: "test-source";
    because: "test-because";
    nothing: "test-nothing";
    nothing_yet: "test-nothing-yet";
    not_there: "test-not-there";
    review: "test-review";
}

/// A folder without cases.
pub fn no_cases(lang: Lang, folder: impl Display) -> String {
    say!(lang, "test-no-cases", folder = folder.to_string())
}

/// An output that is an input.
pub fn would_replace(lang: Lang, file: impl Display) -> String {
    say!(lang, "test-would-replace", file = file.to_string())
}

/// A list that lacks something.
pub fn without(lang: Lang, list: impl Display) -> String {
    say!(lang, "test-without", list = list.to_string())
}

/// A key that is nowhere.
pub fn no_such_key(lang: Lang, key: &str, near: Option<&str>, known: &[String]) -> String {
    match near {
        Some(near) => say!(lang, "test-no-such-key-near", key = key, near = near),
        None => say!(lang, "test-no-such-key", key = key, known = known.join(", ")),
    }
}

/// A word that means nothing.
pub fn no_such_word(lang: Lang, word: &str, near: Option<&str>) -> String {
    match near {
        Some(near) => say!(lang, "test-no-such-word-near", word = word, near = near),
        None => say!(lang, "test-no-such-word", word = word),
    }
}

/// A scheme that was passed over.
pub fn not_taken(lang: Lang, scheme: &str, why: impl Display) -> String {
    say!(lang, "test-not-taken", scheme = scheme, why = why.to_string())
}

/// A row that would give what is expected.
pub fn other_row(lang: Lang, row: usize, column: &str, cell: &str) -> String {
    say!(lang, "test-other-row", row = row, column = column, cell = cell)
}

/// A row of a table.
pub fn row(lang: Lang, table: &str, row: Option<usize>) -> String {
    match row {
        None => table.to_owned(),
        Some(row) => say!(lang, "test-row", table = table, row = row),
    }
}

/// `5 випадків`, `5 cases`.
pub fn cases(lang: Lang, count: usize) -> String {
    say!(lang, "test-cases-counted", count = count)
}

/// `5 файлів`, `5 files`.
pub fn files(lang: Lang, count: usize) -> String {
    say!(lang, "test-files-counted", count = count)
}

/// The last line.
pub fn summary(lang: Lang, files: String, cases: String, failed: usize, unusable: usize) -> String {
    let mut said = match failed {
        0 => say!(lang, "test-all-as-expected", files = files, cases = cases),
        _ => say!(lang, "test-some-failed", files = files, cases = cases, failed = failed),
    };
    if unusable > 0 {
        said.push_str(&say!(lang, "test-unusable-files", count = unusable));
    }
    said
}
