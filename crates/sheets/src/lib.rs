//! Tables as people keep them: files of CSV and XLSX as cells with their places, and back.
//!
//! What the cells mean is told by who asks. A place is row and column as the editor of tables counts them, from one.

mod separated;
mod workbook;

use technolog_note::{Note, note};

pub use separated::{lines, written as csv};
pub use workbook::written as xlsx;

/// The most cells of a file that are not empty.
pub const MOST_CELLS: usize = 200_000;

/// A table: a sheet of a workbook, or a whole file of CSV.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sheet {
    /// Its name; that of a CSV file is empty.
    pub name: String,
    /// The rows that have a cell, from the top.
    pub rows: Vec<Row>,
}

/// A row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// Its number in the file, from 1.
    pub line: u32,
    /// Its cells from the left, trimmed; those that are empty are empty texts.
    pub cells: Vec<String>,
}

impl Row {
    /// The cells that are not empty, with their columns, from 1.
    pub fn filled(&self) -> impl Iterator<Item = (u32, &str)> {
        let cells = (1..).zip(self.cells.iter().map(String::as_str));
        cells.filter(|(_, text)| !text.is_empty())
    }

    /// The text of a column, from 1; empty where it has none.
    pub fn cell(&self, column: u32) -> &str {
        let at = usize::try_from(column).ok().and_then(|column| column.checked_sub(1));
        at.and_then(|at| self.cells.get(at)).map_or("", String::as_str)
    }
}

/// The form of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Text with separated columns.
    Csv,
    /// A workbook.
    Xlsx,
}

impl Kind {
    /// By the end of a file's name; none for any other.
    pub fn of(file: &str) -> Option<Self> {
        let (_, end) = file.rsplit_once('.')?;
        match end.to_ascii_lowercase().as_str() {
            "csv" | "tsv" => Some(Self::Csv),
            "xlsx" | "xlsm" => Some(Self::Xlsx),
            _ => None,
        }
    }
}

/// Why a file could not be read.
#[derive(Clone, Debug, PartialEq)]
pub struct Unreadable {
    /// What is wrong.
    pub message: Note,
    /// What to do.
    pub help: Note,
}

/// The tables of a file.
///
/// # Errors
/// It is no table of its kind, has none, or is too large.
pub fn read(kind: Kind, bytes: &[u8]) -> Result<Vec<Sheet>, Unreadable> {
    let sheets = match kind {
        Kind::Csv => vec![separated::read(bytes)?],
        Kind::Xlsx => workbook::read(bytes)?,
    };
    if sheets.iter().all(|sheet| sheet.rows.is_empty()) {
        return Err(Unreadable { message: note!("sheet-empty"), help: note!("sheet-empty-help") });
    }
    Ok(sheets)
}

fn too_large() -> Unreadable {
    Unreadable { message: note!("sheet-too-large", most = MOST_CELLS), help: note!("sheet-too-large-help") }
}
