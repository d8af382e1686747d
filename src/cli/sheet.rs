//! A table as text: its rows under their columns, and below them everything that no cell can say.

use std::collections::BTreeMap;

use technolog::knowledge::{Column, Role, Row, RowRef, Table};

use super::words;
use super::{Context, grid, record};

/// One table: title, source, rows, then everything the rows cannot say in their cells.
pub fn whole(table: &Table, context: &Context) -> String {
    let all: Vec<RowRef<'_>> = table.all_rows().collect();
    let mut text = title(table, context);
    let standard = table.standard.as_deref().map(|standard| format!("; {standard}")).unwrap_or_default();
    text.push_str(&grid::paragraph(&format!("{}: {}{standard}", context.word("cli-source"), table.place), 0));
    text.push('\n');
    let (drawn, numbered) = rows(table, &all, context);
    text.push_str(&drawn);
    text.push_str(&columns(table, numbered, context));
    text.push_str(&said(&all, context));
    text.push_str(&section("cli-gaps", context, table.uncovered.iter().map(|gap| gap.reason.as_str())));
    text.push_str(&section("cli-notes", context, table.notes.iter().map(String::as_str)));
    text
}

/// The line with the id and the title.
pub fn title(table: &Table, context: &Context) -> String {
    grid::paragraph(&format!("{}  {}", table.id, record::title(context.lang, table)), 0)
}

/// The rows: under the names of the columns, or where those are too wide together under numbers, as
/// the source does; or one row under the other. Says whether the columns have numbers.
pub fn rows(table: &Table, rows: &[RowRef<'_>], context: &Context) -> (String, bool) {
    let one_source = rows.windows(2).all(|pair| pair[0].row().source == pair[1].row().source);
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            let content = row.row();
            let mut cells = vec![format!("{}{}", row.number(), marks(content))];
            cells.extend(table.columns.iter().zip(&content.cells).map(|(column, cell)| record::cell(column, cell)));
            if !one_source {
                cells.push(record::source(context.lang, content.source).to_owned());
            }
            cells
        })
        .collect();
    let head = |name: &dyn Fn(usize, &Column) -> String| {
        let mut head = vec![context.word("cli-row-number").to_owned()];
        head.extend(table.columns.iter().enumerate().map(|(index, column)| name(index, column)));
        if !one_source {
            head.push(context.word("cli-row-source").to_owned());
        }
        head
    };
    let named = head(&|_, column| {
        let arrow = if column.role == Role::Output { "→ " } else { "" };
        let below = record::symbol_and_unit(context.lang, column);
        format!("{arrow}{}\n{below}", column.name).trim_end().to_owned()
    });
    let numbers = head(&|index, _| (index + 1).to_string());
    let (mut text, numbered) = match (grid::ruled(&named, &cells), grid::ruled(&numbers, &cells)) {
        (Some(text), _) => (text, false),
        (None, Some(text)) => (text, true),
        (None, None) => (one_by_one(table, &cells, context), false),
    };
    if one_source && let Some(first) = rows.first() {
        text.push('\n');
        text.push_str(&words::all_rows_of_one_source(context.lang, record::source(context.lang, first.row().source)));
        text.push('\n');
    }
    (text, numbered)
}

/// The marks beside the number of a row: `*` for a correction, `?` for a figure that is not confirmed.
fn marks(row: &Row) -> String {
    let corrected = if row.corrections.is_empty() { "" } else { "*" };
    let unconfirmed = if row.unconfirmed.is_some() { "?" } else { "" };
    format!("{corrected}{unconfirmed}")
}

fn one_by_one(table: &Table, rows: &[Vec<String>], context: &Context) -> String {
    let mut text = String::new();
    for row in rows {
        let mut cells = row.iter();
        text.push_str(&format!("{} {}\n", context.word("cli-row-number"), cells.next().map_or("", String::as_str)));
        let lines: Vec<Vec<String>> = table
            .columns
            .iter()
            .zip(cells)
            .filter(|(_, cell)| !cell.is_empty())
            .map(|(column, cell)| vec![column.name.clone(), cell.clone()])
            .collect();
        text.push_str(&grid::columns(&lines, 2));
    }
    text
}

/// What each column is, and what a lookup may ask of it.
pub fn columns(table: &Table, numbered: bool, context: &Context) -> String {
    let lang = context.lang;
    let rows: Vec<Vec<String>> = table
        .columns
        .iter()
        .enumerate()
        .map(|(index, column)| {
            let number = if numbered { (index + 1).to_string() } else { String::new() };
            let mut about = Vec::new();
            about.extend(record::label(lang, column).map(str::to_owned));
            match column.role {
                Role::Field => {}
                Role::Input => about.push(context.word("cli-input").to_owned()),
                Role::Output => about.push(context.word("cli-output").to_owned()),
            }
            about.push(words::expected(lang, column));
            about.extend(column.domain_text.clone());
            if column.list {
                about.push(context.word("cli-list").to_owned());
            }
            if column.optional {
                about.push(context.word("cli-optional").to_owned());
            }
            about.extend(column.default.as_ref().map(|value| words::default_is(lang, record::bare(column, value))));
            about.extend(column.refers.as_ref().map(|(table, column)| words::refers_to(lang, table, column)));
            let symbol = record::symbol_and_unit(lang, column);
            let mut cells = vec![number, column.name.clone(), symbol, about.join("; ")];
            if !numbered {
                cells.remove(0);
            }
            cells
        })
        .collect();
    format!("\n{}\n{}", context.word("cli-columns"), grid::columns(&rows, 2))
}

/// What these rows say beside their cells: corrections, doubts, reasons, places, notes. Rows that say
/// the same stand together.
pub fn said(rows: &[RowRef<'_>], context: &Context) -> String {
    let lang = context.lang;
    let corrections = |row: &Row| -> Vec<String> {
        let said = row.corrections.iter();
        said.map(|it| words::printed_otherwise(lang, &it.column, &it.printed, &it.reason)).collect()
    };
    let one = |text: &Option<String>| -> Vec<String> { text.iter().cloned().collect() };
    [
        said_by_rows(rows, "cli-corrections", context, &corrections),
        said_by_rows(rows, "cli-unconfirmed", context, &|row| one(&row.unconfirmed)),
        said_by_rows(rows, "cli-reasons", context, &|row| one(&row.reason)),
        said_by_rows(rows, "cli-places", context, &|row| one(&row.place)),
        said_by_rows(rows, "cli-row-notes", context, &|row| one(&row.note)),
    ]
    .concat()
}

fn said_by_rows(rows: &[RowRef<'_>], word: &str, context: &Context, said: &dyn Fn(&Row) -> Vec<String>) -> String {
    let mut rows_of: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for row in rows {
        for sentence in said(row.row()) {
            rows_of.entry(sentence).or_default().push(row.number());
        }
    }
    let mut said: Vec<(Vec<usize>, String)> = rows_of.into_iter().map(|(sentence, rows)| (rows, sentence)).collect();
    said.sort();
    let lines: Vec<String> =
        said.iter().map(|(rows, sentence)| format!("{}: {sentence}", words::rows_named(context.lang, rows))).collect();
    section(word, context, lines.iter().map(String::as_str))
}

/// A heading with its lines; nothing without lines.
pub fn section<'a>(word: &str, context: &Context, lines: impl Iterator<Item = &'a str>) -> String {
    let lines: Vec<String> = lines.map(|line| grid::paragraph(line, 2)).collect();
    if lines.is_empty() { String::new() } else { format!("\n{}\n{}", context.word(word), lines.concat()) }
}
