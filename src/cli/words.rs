//! What the command line says, each sentence as a function of what fills its gaps; the words stand in the message catalogue.

use std::fmt::Display;

use technolog::knowledge::{Column, ColumnType};
use technolog::note::Note;
pub use technolog::report::Lang;
use technolog::units::Unit;
use technolog::words::say;

macro_rules! phrases {
    ($($name:ident($($arg:ident),*): $key:literal;)*) => {$(
        #[doc = concat!("The message `", $key, "`.")]
        pub fn $name(lang: Lang, $($arg: impl Display),*) -> String {
            lang.say(&Note::new($key)$(.with(stringify!($arg).replace('_', "-"), $arg.to_string()))*)
        }
    )*};
}

phrases! {
    unknown_table(id): "cli-unknown-table";
    did_you_mean(name): "cli-did-you-mean";
    list_tables(): "cli-list-tables";
    no_format(command, format): "cli-no-format";
    formats(known): "cli-formats";
    format_contradiction(file, meant, asked): "cli-format-contradiction";
    format_contradiction_help(): "cli-format-contradiction-help";
    cannot_write(path, error): "cli-cannot-write";
    check_folder(): "cli-check-folder";
    cannot_print(error): "cli-cannot-print";
    print_to_file(): "cli-print-to-file";
    broken_build(error): "cli-broken-build";
    rebuild(): "cli-rebuild";
    cannot_read(path, error): "cli-cannot-read";
    check_path(): "cli-check-path";
    no_hole(path, name): "cli-no-hole";
    known(names): "cli-known";
    name_machine(): "cli-name-machine";
    option_of_lists(option): "cli-option-of-lists";
    leave_out(option): "cli-leave-out";
    not_a_pair(text): "cli-not-a-pair";
    write_pair(example): "cli-write-pair";
    no_such_key(table, key): "cli-no-such-key";
    is_output(table, key): "cli-is-output";
    no_such_key_but(near, known): "cli-no-such-key-but";
    the_keys_are(known): "cli-the-keys-are";
    key_twice(key): "cli-key-twice";
    keep_one(): "cli-keep-one";
    bad_value(key, value): "cli-bad-value";
    bad_value_because(key, why): "cli-bad-value-because";
    expected_is(expected): "cli-expected-is";
    out_of_domain(key, value, domain): "cli-out-of-domain";
    missing_keys(table, keys): "cli-missing-keys";
    give_keys(example): "cli-give-keys";
    other_machine(asked, own): "cli-other-machine";
    leave_machine(): "cli-leave-machine";
    no_control(machine): "cli-no-control";
    alien_control(machine, control): "cli-alien-control";
    name_control(known): "cli-name-control";
    no_machine(id): "cli-no-machine";
    by_rule(what, section): "cli-by-rule";
    times(total, feed, rapid, dwell, change): "cli-times";
    run_lint(): "cli-run-lint";
    printed_otherwise(column, printed, reason): "cli-printed-otherwise";
    all_rows_of_one_source(source): "cli-all-rows-of-one-source";
    default_is(value): "cli-default-is";
    refers_to(table, column): "cli-refers-to";
    one_of(values): "cli-one-of";
    and_more(count): "cli-and-more";
}

/// What the system says of a file; that there is none in the language of the answers.
pub fn of_system(lang: Lang, error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => lang.word("file-not-there").to_owned(),
        _ => error.to_string(),
    }
}

/// `5 рядків`, `5 rows`.
pub fn rows(lang: Lang, count: usize) -> String {
    say!(lang, "cli-rows-counted", count = count)
}

/// `5 таблиць`, `5 tables`.
pub fn tables(lang: Lang, count: usize) -> String {
    say!(lang, "cli-tables-counted", count = count)
}

/// `5 зауважень`, `5 findings`.
pub fn findings(lang: Lang, count: usize) -> String {
    say!(lang, "cli-findings-counted", count = count)
}

/// `рядок 3`, `рядки 3, 5-8`: rows by their numbers.
pub fn rows_named(lang: Lang, numbers: &[usize]) -> String {
    let mut spans: Vec<(usize, usize)> = Vec::new();
    for &number in numbers {
        match spans.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => spans.push((number, number)),
        }
    }
    let shown: Vec<String> = spans
        .iter()
        .map(|&(first, last)| match last - first {
            0 => first.to_string(),
            1 => format!("{first}, {last}"),
            _ => format!("{first}-{last}"),
        })
        .collect();
    say!(lang, "cli-rows-named", count = numbers.len(), rows = shown.join(", "))
}

/// A unit as people write it; nothing for a pure number.
pub fn unit(lang: Lang, unit: Unit) -> &'static str {
    lang.find(&format!("unit-{}", unit.text().replace(['*', '/'], "-"))).unwrap_or(match unit {
        Unit::None => "",
        // The same in every language.
        _ => unit.text(),
    })
}

/// What a value of a column looks like: `довжина в мм`, `a length in mm`.
pub fn expected(lang: Lang, column: &Column) -> String {
    let what = match column.ty {
        ColumnType::Text => "cli-expected-text",
        ColumnType::Enum => return one_of(lang, column.values.join(", ")),
        ColumnType::Bool => "cli-expected-bool",
        ColumnType::Int => "cli-expected-int",
        ColumnType::Number => "cli-expected-number",
        ColumnType::Length => "cli-expected-length",
        ColumnType::Angle => "cli-expected-angle",
        ColumnType::It => return lang.word("cli-expected-it").to_owned(),
        ColumnType::Roughness => return lang.word("cli-expected-roughness").to_owned(),
    };
    match unit(lang, column.unit) {
        "" => lang.word(what).to_owned(),
        unit => say!(lang, "cli-expected-in-unit", what = lang.word(what), unit = unit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_language_comes_from_the_first_part_of_lang() {
        for (variable, lang) in [
            (None, Lang::UK),
            (Some(""), Lang::UK),
            (Some("C"), Lang::UK),
            (Some("uk_UA.UTF-8"), Lang::UK),
            (Some("en_US.UTF-8"), Lang::EN),
            (Some("en"), Lang::EN),
            (Some("enm_XX"), Lang::UK),
        ] {
            assert_eq!(Lang::of_environment(variable), lang, "{variable:?}");
        }
    }

    #[test]
    fn ukrainian_nouns_follow_their_number() {
        for (count, text) in
            [(0, "0 рядків"), (1, "1 рядок"), (3, "3 рядки"), (12, "12 рядків"), (21, "21 рядок"), (104, "104 рядки")]
        {
            assert_eq!(rows(Lang::UK, count), text);
        }
    }

    #[test]
    fn row_numbers_are_drawn_together() {
        assert_eq!(rows_named(Lang::EN, &[1, 2, 3, 5, 7, 8]), "rows 1-3, 5, 7, 8");
        assert_eq!(rows_named(Lang::UK, &[4]), "рядок 4");
    }
}
