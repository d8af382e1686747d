//! The words of the command `test`.

use std::fmt::Display;

use super::super::words::{Lang, counted};

macro_rules! said {
    ($($name:ident: $uk:literal, $en:literal;)*) => {$(
        #[doc = $en]
        pub const fn $name(lang: Lang) -> &'static str {
            lang.pick($uk, $en)
        }
    )*};
}

said! {
    what_is_a_case: "у теці випадки - це файли, назва яких кінчається на .test.yaml; окремий файл можна назвати сам",
        "in a folder cases are the files that end in .test.yaml; a single file may be named itself";
    another_file: "назвіть інший файл", "name another file";
    one_copy: "копія з -o може бути лише одного файлу", "a copy with -o can be of one file only";
    one_by_one: "назвіть один файл, або приберіть -o", "name one file, or leave out -o";
    passed: "гаразд", "ok";
    failed: "не зійшлося", "FAILED";
    unusable: "не читається", "unusable";
    expected: "очікувалося", "expected";
    came: "вийшло", "came";
    why: "чому", "why";
    source: "звідки", "source";
    because: "бо", "because";
    nothing: "нічого", "nothing";
    nothing_yet: "ще нічого: `technolog test --write` впише те, що виходить",
        "nothing yet: `technolog test --write` fills in what comes";
    not_there: "щоб цього не було", "that it is not there";
    review: "вписано; перегляньте, перш ніж на них покладатися", "written; review them before you rely on them";
}

/// A folder without cases.
pub fn no_cases(lang: Lang, folder: impl Display) -> String {
    match lang {
        Lang::Uk => format!("у теці `{folder}` немає випадків"),
        Lang::En => format!("there are no cases in the folder `{folder}`"),
    }
}

/// An output that is an input.
pub fn would_replace(lang: Lang, file: impl Display) -> String {
    match lang {
        Lang::Uk => format!("{file}: -o замінило б файл випадків"),
        Lang::En => format!("{file}: -o would replace the file of cases"),
    }
}

/// A list that lacks something.
pub fn without(lang: Lang, list: impl Display) -> String {
    match lang {
        Lang::Uk => format!("серед цього немає: {list}"),
        Lang::En => format!("not among {list}"),
    }
}

/// A key that is nowhere.
pub fn no_such_key(lang: Lang, key: &str, near: Option<&str>, known: &[String]) -> String {
    let known = known.join(", ");
    match (lang, near) {
        (Lang::Uk, Some(near)) => format!("`{key}` тут немає; мабуть, `{near}`?"),
        (Lang::En, Some(near)) => format!("there is no `{key}` here; did you mean `{near}`?"),
        (Lang::Uk, None) => format!("`{key}` тут немає; є: {known}"),
        (Lang::En, None) => format!("there is no `{key}` here; there are: {known}"),
    }
}

/// A word that means nothing.
pub fn no_such_word(lang: Lang, word: &str, near: Option<&str>) -> String {
    let meant = near.map(|near| match lang {
        Lang::Uk => format!("; мабуть, `{near}`?"),
        Lang::En => format!("; did you mean `{near}`?"),
    });
    let said = match lang {
        Lang::Uk => format!("нічого тут не називається `{word}`"),
        Lang::En => format!("nothing here is called `{word}`"),
    };
    said + meant.unwrap_or_default().as_str()
}

/// A scheme that was passed over.
pub fn not_taken(lang: Lang, scheme: &str, why: impl Display) -> String {
    match lang {
        Lang::Uk => format!("схему {scheme} не взято: {why}"),
        Lang::En => format!("scheme {scheme} was not taken: {why}"),
    }
}

/// A row that would give what is expected.
pub fn other_row(lang: Lang, row: usize, column: &str, cell: &str) -> String {
    match lang {
        Lang::Uk => format!("рядок {row} дав би очікуване, але його графа {column} каже {cell}"),
        Lang::En => format!("row {row} would give what is expected, but its column {column} says {cell}"),
    }
}

/// A row of a table.
pub fn row(lang: Lang, table: &str, row: Option<usize>) -> String {
    match (lang, row) {
        (_, None) => table.to_owned(),
        (Lang::Uk, Some(row)) => format!("{table}, рядок {row}"),
        (Lang::En, Some(row)) => format!("{table}, row {row}"),
    }
}

/// `5 випадків`, `5 cases`.
pub fn cases(lang: Lang, count: usize) -> String {
    counted(lang, count, ["випадок", "випадки", "випадків"], ["case", "cases"])
}

/// `5 файлів`, `5 files`.
pub fn files(lang: Lang, count: usize) -> String {
    counted(lang, count, ["файл", "файли", "файлів"], ["file", "files"])
}

/// The last line.
pub fn summary(lang: Lang, files: String, cases: String, failed: usize, unusable: usize) -> String {
    let unusable = match (lang, unusable) {
        (_, 0) => String::new(),
        (Lang::Uk, count) => format!(", не читається файлів: {count}"),
        (Lang::En, count) => format!(", unusable files: {count}"),
    };
    match (lang, failed) {
        (Lang::Uk, 0) => format!("{files}, {cases}: усе зійшлося{unusable}"),
        (Lang::En, 0) => format!("{files}, {cases}: all as expected{unusable}"),
        (Lang::Uk, failed) => format!("{files}, {cases}: не зійшлося {failed}{unusable}"),
        (Lang::En, failed) => format!("{files}, {cases}: {failed} failed{unusable}"),
    }
}
