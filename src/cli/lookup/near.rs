//! If no row applies: the nearest rows, and the columns that fail in them.

use serde::Serialize;
use technolog::document::{Column as Head, Document, Inlines, Table as Grid};
use technolog::knowledge::{Column, RowRef};
use technolog::words::say;

use crate::cli::{Lang, record, shown};

/// If there are more rows, they are counted, not listed.
const LISTED: usize = 5;

/// A row with the columns that fail in it.
#[derive(Debug)]
pub struct NearRow<'t> {
    row: RowRef<'t>,
    failed: Vec<usize>,
}

/// The rows with the fewest failing columns; none if every required column fails in all rows.
pub fn rows<'t>(
    all: impl Iterator<Item = RowRef<'t>>,
    wanted: usize,
    failed: impl Fn(RowRef<'t>) -> Vec<usize>,
) -> Vec<NearRow<'t>> {
    let all: Vec<NearRow<'t>> = all.map(|row| NearRow { row, failed: failed(row) }).collect();
    let fewest = all.iter().map(|near| near.failed.len()).min().unwrap_or(wanted);
    all.into_iter().filter(|near| near.failed.len() == fewest && fewest < wanted).collect()
}

fn failed<'n>(near: &'n NearRow<'_>) -> impl Iterator<Item = (&'n Column, String)> {
    near.failed.iter().map(|&index| {
        let column = &near.row.table.columns[index];
        (column, record::cell(column, &near.row.row().cells[index]))
    })
}

/// For people; nothing without such rows.
pub fn section(page: &mut Document, near: &[NearRow<'_>], lang: Lang) {
    if near.is_empty() {
        return;
    }
    page.heading(2, lang.word("cli-nearest"));
    let mut rows = Grid::new(["cli-row", "table-failed", "table-answer"].map(|head| Head::text(lang.word(head))));
    for near in near.iter().take(LISTED) {
        let failed = near.failed.iter().map(|&index| {
            let column = &near.row.table.columns[index];
            let cell = shown::cell(lang, column, &near.row.row().cells[index]);
            let cell = if cell.is_empty() { lang.word("cli-empty-cell") } else { &cell };
            Inlines::default().code(&column.name).text(format!(" {cell}"))
        });
        let number = Inlines::number(near.row.number().to_string());
        rows.row([number, Inlines::joined(failed, ", "), shown::result(lang, near.row).into()]);
    }
    if near.len() > LISTED {
        rows.notes.push(say!(lang, "cli-and-more", count = near.len() - LISTED).into());
    }
    page.push(rows);
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
pub fn json<'t>(near: &'t [NearRow<'_>]) -> Vec<Json<'t>> {
    near.iter()
        .take(LISTED)
        .map(|near| Json {
            row: near.row.number(),
            failed: failed(near).map(|(column, cell)| Failed { column: &column.name, cell }).collect(),
        })
        .collect()
}
