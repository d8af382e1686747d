//! Workbooks of Excel and of whatever writes their format.

use std::io::Cursor;

use calamine::{DataRef, Reader as _, Xlsx, XlsxError};
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, FormatAlign, Workbook};
use technolog_note::note;

use crate::{MOST_CELLS, Row, Sheet, Unreadable, too_large};

/// The most columns of a row: what stands farther right is a slip of a hand.
const MOST_COLUMNS: u32 = 1000;

/// The tables of a workbook.
pub(crate) fn read(bytes: &[u8]) -> Result<Vec<Sheet>, Unreadable> {
    let mut book: Xlsx<_> = calamine::open_workbook_from_rs(Cursor::new(bytes)).map_err(|error| broken(&error))?;
    let mut sheets = Vec::new();
    let mut cells = 0_usize;
    for name in book.sheet_names() {
        let mut sheet = Sheet { name: name.clone(), rows: Vec::new() };
        // Cell by cell: one cell in the last row and column would make a range of the whole sheet.
        let mut reader = match book.worksheet_cells_reader(&name) {
            Ok(reader) => reader,
            // A sheet that only holds a drawing.
            Err(XlsxError::NotAWorksheet(_)) => continue,
            Err(error) => return Err(broken(&error)),
        };
        while let Some(cell) = reader.next_cell().map_err(|error| broken(&error))? {
            let (row, column) = cell.get_position();
            let text = text(cell.get_value());
            if text.is_empty() || column >= MOST_COLUMNS {
                continue;
            }
            cells = cells.saturating_add(1);
            if cells > MOST_CELLS {
                return Err(too_large());
            }
            put(&mut sheet, row.saturating_add(1), column, text);
        }
        sheets.push(sheet);
    }
    Ok(sheets)
}

/// A cell at its place; rows come in order.
fn put(sheet: &mut Sheet, line: u32, column: u32, text: String) {
    if sheet.rows.last().is_none_or(|row| row.line != line) {
        sheet.rows.push(Row { line, cells: Vec::new() });
    }
    let Some(row) = sheet.rows.last_mut() else { return };
    let column = usize::try_from(column).unwrap_or(usize::MAX);
    if row.cells.len() <= column {
        row.cells.resize(column.saturating_add(1), String::new());
    }
    if let Some(cell) = row.cells.get_mut(column) {
        *cell = text;
    }
}

/// A value as people read it. A computed figure has as many places as a figure of a plan can mean; that of a date is no figure.
fn text(value: &DataRef<'_>) -> String {
    let one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    match value {
        DataRef::Empty => String::new(),
        DataRef::String(text) => one_line(text),
        DataRef::SharedString(text) => one_line(text),
        DataRef::Int(value) => value.to_string(),
        DataRef::Float(value) => number(*value),
        DataRef::Bool(value) => value.to_string(),
        DataRef::DateTime(date) => {
            let (year, month, day, ..) = date.to_ymd_hms_milli();
            format!("{year:04}-{month:02}-{day:02}")
        }
        DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => text.clone(),
        DataRef::Error(error) => error.to_string(),
    }
}

/// A figure without the noise of its last binary places: 0.1 + 0.2 is 0.3.
fn number(value: f64) -> String {
    let text = format!("{value:.9}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

fn broken(error: &XlsxError) -> Unreadable {
    let help = match error {
        XlsxError::Password => note!("sheet-password-help"),
        _ => note!("sheet-no-workbook-help"),
    };
    Unreadable { message: note!("sheet-no-workbook", why = error.to_string()), help }
}

/// Tables as a workbook, a sheet each: figures as figures, columns as wide as what stands in them. The first row of a sheet is its head.
///
/// # Errors
/// The library cannot write it; its reason.
pub fn written(sheets: &[Sheet]) -> Result<Vec<u8>, String> {
    let mut book = Workbook::new();
    // Without the time of the clock: the same tables are the same file.
    let made = ExcelDateTime::from_ymd(2000, 1, 1).map_err(|error| error.to_string())?;
    book.set_properties(&DocProperties::new().set_creation_datetime(&made));
    let head = Format::new().set_bold().set_text_wrap().set_align(FormatAlign::Top);
    for sheet in sheets {
        let page = book.add_worksheet();
        page.set_name(name(&sheet.name)).map_err(|error| error.to_string())?;
        let first = sheet.rows.first().map(|row| row.line);
        for row in &sheet.rows {
            let line = row.line.saturating_sub(1);
            for (column, text) in row.filled() {
                let column = u16::try_from(column.saturating_sub(1)).map_err(|error| error.to_string())?;
                let is_head = Some(row.line) == first;
                let written = match figure(text).filter(|_| !is_head) {
                    Some(value) => page.write_number(line, column, value),
                    None if is_head => page.write_string_with_format(line, column, text, &head),
                    None => page.write_string(line, column, text),
                };
                written.map_err(|error| error.to_string())?;
            }
        }
        page.autofit();
        if first.is_some() {
            page.set_freeze_panes(1, 0).map_err(|error| error.to_string())?;
        }
    }
    book.save_to_buffer().map_err(|error| error.to_string())
}

/// A name as a sheet may have it: 31 characters, without those that mean something in formulas.
fn name(text: &str) -> String {
    text.chars().filter(|sign| !matches!(sign, '[' | ']' | ':' | '*' | '?' | '/' | '\\')).take(31).collect()
}

/// The value of a text that is a figure and nothing else: `07` is the name of a scheme.
fn figure(text: &str) -> Option<f64> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    let name = digits.len() > 1 && digits.starts_with('0') && !digits.starts_with("0.");
    let value: f64 = text.parse().ok().filter(|_| plain && !name && digits.len() < 9)?;
    // Figures whose last places are printed noughts keep them as a text.
    (number(value) == text).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_back() {
        let cells = |cells: &[&str]| cells.iter().map(|&cell| cell.to_owned()).collect();
        let sheet = Sheet {
            name: "Маршрут".to_owned(),
            rows: vec![
                Row { line: 1, cells: cells(&["Отвір", "схема", "S, мм/об"]) },
                Row { line: 2, cells: cells(&["A", "07", "0.325"]) },
                Row { line: 4, cells: cells(&["", "035-2300-1273", "26.50"]) },
            ],
        };
        assert_eq!(read(&written(std::slice::from_ref(&sheet)).unwrap()).unwrap(), vec![sheet]);
    }

    #[test]
    fn figures_lose_binary_noise_only() {
        assert_eq!(number(0.1 + 0.2), "0.3");
        assert_eq!(number(27.457_534_246_6), "27.457534247");
        assert_eq!((number(800.0), number(-60.4)), ("800".to_owned(), "-60.4".to_owned()));
    }

    #[test]
    fn what_is_no_workbook_says_so() {
        for bytes in [b"".as_slice(), b"PK\x03\x04", "Отвір;S".as_bytes()] {
            assert!(read(bytes).is_err());
        }
    }
}
