//! Cells, columns and rows for people: names instead of ids, with the signs and separators of the language. For
//! programs there is `record`.

use std::collections::BTreeSet;

use technolog::document::{Align, Column as Head, Inlines, Keep, capital};
use technolog::knowledge::table::Cell;
use technolog::knowledge::{Column, ColumnRole, ColumnType, RowRef, Source, Table, Value};
use technolog::note::Figure;
use technolog::plan::Operation;
use technolog::report::{operation_noun, unit, with_unit};
use technolog::words::{LANGUAGES, joined_list, say};

use super::Lang;
use super::record::{bare, results};

/// The title of a table.
pub fn title(lang: Lang, table: &Table) -> &str {
    table.title.text(lang.tag())
}

/// The name of a column, if it has one besides its key.
pub fn label(lang: Lang, column: &Column) -> Option<&str> {
    let usual = || lang.find(&format!("table-column-{}", column.name));
    column.label.as_ref().map(|label| label.text(lang.tag())).or_else(usual)
}

/// The column of a page: its name with symbol and unit, figures to the right.
pub fn head(lang: Lang, column: &Column, keep: Keep) -> Head {
    let name = Inlines::from(label(lang, column).map_or_else(|| column.name.clone(), capital));
    let name = match &column.symbol {
        Some(symbol) => name.text(format!(" {symbol}")),
        None => name,
    };
    // A scale such as HB is its own unit.
    let unit = Some(unit(column.unit, lang)).filter(|unit| column.symbol.as_deref() != Some(*unit)).unwrap_or_default();
    // The cells of an input are tests, which are text.
    let is_figure = !column.list
        && column.role != ColumnRole::Input
        && column.ty.is_ordered()
        && column.ty != ColumnType::Roughness;
    let head = if is_figure { Head::number(name, unit) } else { Head { unit: unit.to_owned(), ..Head::text(name) } };
    // Tables have many columns of short cells.
    head.keep(keep).min_width(6)
}

/// Whether the cells of a column are aligned to the right.
pub fn is_right(head: &Head) -> bool {
    head.align == Align::Right
}

/// A cell without its unit.
pub fn cell(lang: Lang, column: &Column, cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Test(_, text) => test(lang, column, text),
        Cell::Value(value) => self::value(lang, column, value),
    }
}

/// A value without its unit.
pub fn value(lang: Lang, column: &Column, value: &Value) -> String {
    match value {
        Value::List(items) => {
            joined_list(&items.iter().map(|item| self::value(lang, column, item)).collect::<Vec<_>>())
        }
        other => figure(lang, column, &bare(column, other)),
    }
}

/// One figure or id of a column, as written in a table.
fn figure(lang: Lang, column: &Column, written: &str) -> String {
    match column.ty {
        // Tables of machines and controls have the unit of each figure in a separate column.
        ColumnType::Unit => match written.parse() {
            Ok(parsed) => unit(parsed, lang).to_owned(),
            Err(_) => written.to_owned(),
        },
        ColumnType::Text => match column.name.as_str() {
            "name" => characteristic(lang, written),
            // Addresses with a word or two between them.
            "page" => lang.place(&lang.remark(written)),
            _ => lang.remark(written).into_owned(),
        },
        ColumnType::Bool => lang.find(&format!("table-value-{written}")).unwrap_or(written).to_owned(),
        ColumnType::Enum => word(lang, column, written).to_owned(),
        _ => lang.figure(&Figure::number(written.to_owned())),
    }
}

/// A characteristic of a machine or a control with its key, which queries ask for; the key alone where its name says
/// no more.
fn characteristic(lang: Lang, key: &str) -> String {
    match lang.find(&format!("characteristic-{key}")).or_else(|| lang.find(&format!("word-{key}"))) {
        Some(name) if name != key.replace('-', " ") => say!(lang, "table-characteristic", name = name, key = key),
        _ => lang.remark(key).into_owned(),
    }
}

/// The name of a word: by its vocabulary, by this column, as a transition, or by any column; the word itself if it
/// has no name, as designations and ids of tables.
fn word<'v>(lang: Lang, column: &'v Column, id: &'v str) -> &'v str {
    let of_column = || lang.find(&format!("table-value-{}-{id}", column.name));
    let of_quantity = || if column.name == "quantity" { lang.find(&format!("quantity-{id}")) } else { None };
    let of_transition = || Operation::from_name(id).map(|_| operation_noun(id, lang));
    column
        .name_of(id, lang.tag())
        .or_else(of_column)
        .or_else(of_quantity)
        .or_else(of_transition)
        .or_else(|| lang.find(&format!("table-value-{id}")))
        .unwrap_or(id)
}

/// Whether a column gives in another language what a neighbouring one gives in this language, as `name_en` beside
/// `name_uk`.
pub fn is_of_other_language(lang: Lang, table: &Table, column: &Column) -> bool {
    let Some((name, tag)) = column.name.rsplit_once('_') else { return false };
    let has = |tag: &str| table.column_index(&format!("{name}_{tag}")).is_some();
    // Tables give names in English for languages that they lack.
    let own = if has(lang.tag()) { lang.tag() } else { Lang::EN.tag() };
    LANGUAGES.iter().any(|known| known.tag() == tag) && tag != own && has(own)
}

/// A test of a decision table: `(10..15]` is `понад 10 до 15`.
pub fn test(lang: Lang, column: &Column, written: &str) -> String {
    let written = written.trim();
    let figure = |text: &str| figure(lang, column, text.trim());
    if written == "-" {
        return "–".to_owned();
    }
    let each = |tests: &str, phrase: &dyn Fn(String) -> String, between: &str| {
        let tests: Vec<String> = tests.split('|').map(|one| phrase(test(lang, column, one))).collect();
        tests.join(&format!(" {} ", lang.word(between)))
    };
    if let Some(inner) = written.strip_prefix("not(").and_then(|rest| rest.strip_suffix(')')) {
        return each(inner, &|test| say!(lang, "table-test-not", test = test), "table-test-and");
    }
    if written.contains('|') {
        return each(written, &|test| test, "table-test-or");
    }
    for (sign, shown) in [("<=", "≤"), (">=", "≥"), ("<", "<"), (">", ">")] {
        if let Some(bound) = written.strip_prefix(sign) {
            return format!("{shown} {}", figure(bound));
        }
    }
    let ends = |open, close| written.strip_prefix(open)?.strip_suffix(close)?.split_once("..");
    for (open, close) in [('[', ']'), ('(', ']'), ('[', ')'), ('(', ')')] {
        let Some((low, high)) = ends(open, close) else { continue };
        if high.trim().is_empty() {
            return format!("{} {}", if open == '[' { "≥" } else { ">" }, figure(low));
        }
        let (low, high) = (figure(low), figure(high));
        return match (open, close) {
            ('[', ']') => say!(lang, "table-test-within", low = low, high = high),
            ('(', ']') => say!(lang, "table-test-over", low = low, high = high),
            ('[', _) => say!(lang, "table-test-below", low = low, high = high),
            _ => say!(lang, "table-test-between", low = low, high = high),
        };
    }
    figure(written)
}

/// A value with its unit.
pub fn full(lang: Lang, column: &Column, value: &Value) -> String {
    let shown = self::value(lang, column, value);
    match column.ty {
        // A roughness includes its parameter, and its unit is understood.
        ColumnType::Roughness => shown,
        _ => with_unit(&shown, column.unit, lang),
    }
}

/// The origin of a row's figures.
pub fn source(lang: Lang, source: Source) -> &'static str {
    lang.word(match source {
        Source::Seed => "table-source-seed",
        Source::Standard => "table-source-standard",
        Source::Reconstructed => "table-source-reconstructed",
    })
}

/// The values of the result columns: `32`, or `найменше 0,1 мм, найбільше 0,2 мм`.
pub fn result(lang: Lang, row: RowRef<'_>) -> String {
    let columns = results(row.table);
    let shown = columns.iter().filter_map(|&index| {
        let column = &row.table.columns[index];
        match &row.row().cells[index] {
            Cell::Value(value) if columns.len() == 1 => Some(full(lang, column, value)),
            Cell::Value(value) => {
                let name = label(lang, column).unwrap_or(&column.name);
                Some(say!(lang, "table-result-of", name = name, value = full(lang, column, value)))
            }
            _ => None,
        }
    });
    shown.collect::<Vec<_>>().join("; ")
}

/// `рядок 3`, `рядки 3, 5–8`: rows by their numbers.
pub fn rows_named(lang: Lang, numbers: &[usize]) -> String {
    // A lookup gives them in the order of nearness.
    let sorted: BTreeSet<usize> = numbers.iter().copied().collect();
    let mut spans: Vec<(usize, usize)> = Vec::new();
    let sorted_count = sorted.len();
    for number in sorted {
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
            _ => format!("{first}–{last}"),
        })
        .collect();
    say!(lang, "table-rows-named", count = sorted_count, rows = shown.join(", "))
}

/// What a query may give for a column: `довжина, мм`.
pub fn expected(lang: Lang, column: &Column) -> String {
    let what = match column.ty {
        ColumnType::Text => "lint-a-text",
        ColumnType::Unit => "cli-expected-unit",
        ColumnType::Enum => return one_of(lang, column),
        ColumnType::Bool => "lint-true-false",
        ColumnType::Int => "lint-whole-number",
        ColumnType::Number => "cli-expected-number",
        ColumnType::Length => "cli-expected-length",
        ColumnType::Angle => "cli-expected-angle",
        ColumnType::It => return lang.word("cli-expected-it").to_owned(),
        ColumnType::Roughness => return lang.word("cli-expected-roughness").to_owned(),
    };
    match unit(column.unit, lang) {
        "" => lang.word(what).to_owned(),
        unit => say!(lang, "cli-expected-in-unit", what = lang.word(what), unit = unit),
    }
}

/// The permitted words of an enum in a query, each with its meaning; a long vocabulary has a table of its own.
fn one_of(lang: Lang, column: &Column) -> String {
    const MANY: usize = 20;
    if let Some(table) = column.vocabulary.as_deref().filter(|_| column.names.len() > MANY) {
        return say!(lang, "cli-word-of", table = table);
    }
    let value = |id: &String| match word(lang, column, id) {
        name if name.replace(' ', "-") == *id => id.clone(),
        name => format!("{id} ({name})"),
    };
    say!(lang, "cli-one-of", values = joined_list(&column.values.iter().map(value).collect::<Vec<_>>()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn row_numbers_are_drawn_together() {
        assert_eq!(rows_named(Lang::EN, &[1, 2, 3, 5, 7, 8]), "rows 1–3, 5, 7, 8");
        assert_eq!(rows_named(Lang::EN, &[51, 11, 12, 10, 51]), "rows 10–12, 51");
        assert_eq!(rows_named(Lang::UK, &[4]), "рядок 4");
    }

    #[test]
    fn units_that_stand_in_cells_are_those_of_the_language() {
        let knowledge = technolog::shipped::knowledge().unwrap();
        let table = knowledge.tables().find(|table| table.id == "lathe-16b16t1").unwrap();
        let unit = &table.columns[table.column_index("unit").unwrap()];
        for (written, uk, en) in
            [("N*m", "Н·м", "N·m"), ("1/min", "об/хв", "rpm"), ("mm", "мм", "mm"), ("HB", "HB", "HB")]
        {
            let shown = |lang| value(lang, unit, &Value::Text(written.into()));
            assert_eq!((shown(Lang::UK), shown(Lang::EN)), (uk.to_owned(), en.to_owned()));
        }
    }

    #[test]
    fn tests_of_decision_tables_are_words() {
        let knowledge = technolog::shipped::knowledge().unwrap();
        let table = knowledge.tables().find(|table| table.id == "A.8").unwrap();
        let column = |name: &str| &table.columns[table.column_index(name).unwrap()];
        for (name, written, uk, en) in [
            ("diameter", "(10..15]", "понад 10 до 15", "over 10 to 15"),
            ("centre_tolerance", "(0.05..0.3]", "понад 0,05 до 0,3", "over 0.05 to 0.3"),
            ("it", "[9..10]", "9…10", "9–10"),
            ("diameter", "<= 6", "≤ 6", "≤ 6"),
            ("roughness", "Ra 2.5 | Ra 1.25", "Ra 2,5 або Ra 1,25", "Ra 2.5 or Ra 1.25"),
            ("roughness", "not(Ra 2.5 | Ra 1.25)", "не Ra 2,5 і не Ra 1,25", "not Ra 2.5 and not Ra 1.25"),
            ("state", "solid", "суцільний метал", "solid"),
            ("outer_wall", "-", "–", "–"),
        ] {
            assert_eq!(test(Lang::UK, column(name), written), uk);
            assert_eq!(test(Lang::EN, column(name), written), en);
        }
    }
}
