//! Where no row applies: the rows that come nearest, and what fails in them.

use serde::Serialize;
use technolog::knowledge::{Column, RowRef};

use crate::cli::words;
use crate::cli::{Context, grid, record};

/// More rows than this are counted, not listed.
const LISTED: usize = 5;

/// A row with the columns that fail in it.
#[derive(Debug)]
pub struct Near<'t> {
    row: RowRef<'t>,
    failed: Vec<usize>,
}

/// The rows with the fewest failing columns; none when in every row all that is asked fails.
pub fn rows<'t>(
    all: impl Iterator<Item = RowRef<'t>>,
    asked: usize,
    failed: impl Fn(RowRef<'t>) -> Vec<usize>,
) -> Vec<Near<'t>> {
    let all: Vec<Near<'t>> = all.map(|row| Near { row, failed: failed(row) }).collect();
    let fewest = all.iter().map(|near| near.failed.len()).min().unwrap_or(asked);
    all.into_iter().filter(|near| near.failed.len() == fewest && fewest < asked).collect()
}

fn failed<'n>(near: &'n Near<'_>) -> impl Iterator<Item = (&'n Column, String)> {
    near.failed.iter().map(|&index| {
        let column = &near.row.table.columns[index];
        (column, record::cell(column, &near.row.row().cells[index]))
    })
}

/// For people; nothing without such rows.
pub fn text(near: &[Near<'_>], context: &Context) -> String {
    let lang = context.lang;
    if near.is_empty() {
        return String::new();
    }
    let rows: Vec<Vec<String>> = near
        .iter()
        .take(LISTED)
        .map(|near| {
            let failed: Vec<String> = failed(near)
                .map(|(column, cell)| {
                    let cell = if cell.is_empty() { context.word("cli-empty-cell").to_owned() } else { cell };
                    format!("{} {cell}", column.name)
                })
                .collect();
            let result = record::results_text(lang, near.row);
            vec![words::rows_named(lang, &[near.row.number()]), failed.join(", "), format!("→ {result}")]
        })
        .collect();
    let mut text = format!("\n{}\n{}", context.word("cli-nearest"), grid::columns(&rows, 2));
    if near.len() > LISTED {
        text.push_str(&grid::paragraph(&words::and_more(lang, near.len() - LISTED), 2));
    }
    text
}

#[derive(Debug, Serialize)]
struct Failed<'t> {
    column: &'t str,
    cell: String,
}

/// For programs.
#[derive(Debug, Serialize)]
pub struct Json<'t> {
    row: usize,
    failed: Vec<Failed<'t>>,
}

/// For programs: as many as people see.
pub fn json<'t>(near: &'t [Near<'_>]) -> Vec<Json<'t>> {
    near.iter()
        .take(LISTED)
        .map(|near| Json {
            row: near.row.number(),
            failed: failed(near).map(|(column, cell)| Failed { column: &column.name, cell }).collect(),
        })
        .collect()
}
