//! Text with separated columns: semicolons, tabs or commas, as programs for tables write it in any country.

use encoding_rs::{Encoding, WINDOWS_1251};
use technolog_note::note;

use crate::{MOST_CELLS, Row, Sheet, Unreadable, too_large};

/// The table of a text. Without a mark of bytes it is UTF-8, or else the code page 1251 that older programs write.
pub(crate) fn read(bytes: &[u8]) -> Result<Sheet, Unreadable> {
    let text = decoded(bytes)
        .ok_or_else(|| Unreadable { message: note!("sheet-no-text"), help: note!("sheet-no-text-help") })?;
    let (separator, text, skipped) = match said(&text) {
        Some((separator, rest)) => (separator, rest, 1),
        None => (separator(&text), text.as_str(), 0),
    };
    let mut rows: Vec<Row> = Vec::new();
    let mut cells = 0_usize;
    for (line, mut fields) in records(text, separator)? {
        while fields.last().is_some_and(String::is_empty) {
            fields.pop();
        }
        cells = cells.saturating_add(fields.len());
        if cells > MOST_CELLS {
            return Err(too_large());
        }
        if !fields.is_empty() {
            rows.push(Row { line: line.saturating_add(skipped), cells: fields });
        }
    }
    Ok(Sheet { name: String::new(), rows })
}

/// The text of bytes; none where they are no text of a code page in use.
fn decoded(bytes: &[u8]) -> Option<String> {
    if let Some((encoding, mark)) = Encoding::for_bom(bytes) {
        let text = encoding.decode_without_bom_handling_and_without_replacement(bytes.get(mark..)?)?;
        return Some(text.into_owned());
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => WINDOWS_1251.decode_without_bom_handling_and_without_replacement(bytes)?.into_owned(),
    };
    let is_text = |sign: char| !sign.is_control() || matches!(sign, '\n' | '\r' | '\t');
    text.chars().all(is_text).then_some(text)
}

/// The separator that the first line says, as Excel reads it: `sep=;`, and what follows that line.
fn said(text: &str) -> Option<(char, &str)> {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let separator = first.trim().strip_prefix("sep=")?.chars().next()?;
    Some((separator, rest))
}

/// The separator of a text: the semicolon wherever one stands, because commas are then decimal; else the tab, else the comma.
fn separator(text: &str) -> char {
    let mut quoted = false;
    let mut has_tab = false;
    for sign in text.chars() {
        match sign {
            '"' => quoted = !quoted,
            ';' if !quoted => return ';',
            '\t' if !quoted => has_tab = true,
            _ => {}
        }
    }
    if has_tab { '\t' } else { ',' }
}

/// The records with the lines they begin at. In quotes a text may hold separators, line breaks and doubled quotes.
fn records(text: &str, separator: char) -> Result<Vec<(u32, Vec<String>)>, Unreadable> {
    let mut records: Vec<(u32, Vec<String>)> = Vec::new();
    let (mut line, mut began) = (1_u32, 1_u32);
    let (mut fields, mut field, mut quoted) = (Vec::new(), String::new(), None);
    let mut signs = text.chars().peekable();
    let trimmed = |field: &mut String| unmarked(std::mem::take(field).split_whitespace().collect::<Vec<_>>().join(" "));
    while let Some(sign) = signs.next() {
        line = line.saturating_add(u32::from(sign == '\n'));
        match sign {
            '"' if quoted.is_some() && signs.peek() == Some(&'"') => {
                signs.next();
                field.push('"');
            }
            '"' if quoted.is_some() => quoted = None,
            '"' if field.trim().is_empty() => quoted = Some(line),
            sign if quoted.is_some() => field.push(sign),
            '\n' => {
                fields.push(trimmed(&mut field));
                records.push((began, std::mem::take(&mut fields)));
                began = line;
            }
            sign if sign == separator => fields.push(trimmed(&mut field)),
            sign => field.push(sign),
        }
    }
    if let Some(line) = quoted {
        return Err(Unreadable {
            message: note!("sheet-open-quote", line = line),
            help: note!("sheet-open-quote-help"),
        });
    }
    fields.push(trimmed(&mut field));
    records.push((began, fields));
    Ok(records)
}

/// Tables as text with semicolons, each under a line with its name, with the mark of bytes that Excel goes by. `sign` is the decimal sign
/// of the reader's country: Excel takes 10.5 for a day where it is a comma.
///
/// # Errors
/// The library cannot write it; its reason.
pub fn written(sheets: &[Sheet], sign: char) -> Result<String, String> {
    let mut tables = Vec::new();
    for sheet in sheets {
        let name = (!sheet.name.is_empty()).then(|| vec![sheet.name.clone()]);
        let rows = sheet.rows.iter().map(|row| row.cells.iter().map(|cell| with_sign(cell, sign)).collect());
        tables.push(lines(name.into_iter().chain(rows), b';', "\r\n")?);
    }
    Ok(format!("\u{feff}{}", tables.join("\r\n")))
}

/// Rows as lines of separated fields (RFC 4180), quoted where they need it. A text that a program for tables would take for a formula
/// stands behind an apostrophe, which such programs do not show.
///
/// # Errors
/// The library cannot write it; its reason.
pub fn lines(rows: impl IntoIterator<Item = Vec<String>>, separator: u8, ending: &str) -> Result<String, String> {
    let ends = if ending == "\n" { csv::Terminator::Any(b'\n') } else { csv::Terminator::CRLF };
    let mut writer =
        csv::WriterBuilder::new().delimiter(separator).terminator(ends).flexible(true).from_writer(Vec::new());
    for row in rows {
        writer.write_record(row.iter().map(|cell| as_text(cell))).map_err(|error| error.to_string())?;
    }
    let bytes = writer.into_inner().map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

/// A cell that no program takes for a formula: a name such as `=HYPERLINK(…)` comes from files of other people.
fn as_text(cell: &str) -> String {
    let mark = if is_formula(cell) { "'" } else { "" };
    format!("{mark}{cell}")
}

/// Whether a program for tables would reckon with a text: it begins as a formula, and is neither a figure nor a sign alone.
fn is_formula(cell: &str) -> bool {
    let figure = |text: &str| text.bytes().all(|sign| sign.is_ascii_digit() || matches!(sign, b'.' | b','));
    match cell.chars().next() {
        Some('=' | '@') => true,
        Some('+' | '-') => !figure(cell.get(1..).unwrap_or_default()),
        _ => false,
    }
}

/// A field as it was before it was written: without the apostrophe before what begins as a formula.
fn unmarked(field: String) -> String {
    match field.strip_prefix('\'') {
        Some(rest) if is_formula(rest) => rest.to_owned(),
        _ => field,
    }
}

/// A figure with that decimal sign; any other text as it is.
fn with_sign(text: &str, sign: char) -> String {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let parts = digits.split_once('.').filter(|(whole, places)| {
        !whole.is_empty()
            && !places.is_empty()
            && whole.bytes().chain(places.bytes()).all(|digit| digit.is_ascii_digit())
    });
    if parts.is_some() { text.replace('.', &sign.to_string()) } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(bytes: &[u8]) -> Vec<(u32, Vec<String>)> {
        read(bytes).unwrap().rows.into_iter().map(|row| (row.line, row.cells)).collect()
    }

    fn row(line: u32, cells: &[&str]) -> (u32, Vec<String>) {
        (line, cells.iter().map(|&cell| cell.to_owned()).collect())
    }

    #[test]
    fn a_table_is_read_as_programs_of_any_country_write_it() {
        let expected = vec![row(1, &["Отвір", "S, мм/об"]), row(3, &["A", "0,25"])];
        let utf = "Отвір;S, мм/об\r\n;\r\nA;0,25\r\n";
        assert_eq!(cells(utf.as_bytes()), expected);
        assert_eq!(cells(format!("\u{feff}{utf}").as_bytes()), expected);
        assert_eq!(cells(&WINDOWS_1251.encode(utf).0), expected);
        let wide: Vec<u8> = std::iter::once(0xfeff).chain(utf.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        assert_eq!(cells(&wide), expected);
        assert_eq!(cells("Отвір\tS, мм/об\n\nA\t0,25".as_bytes()), expected);
        assert_eq!(cells("Отвір,\"S, мм/об\"\n\nA,\"0,25\"".as_bytes()), expected);
        assert_eq!(cells("sep=|\nОтвір|S; n\n".as_bytes()), vec![row(2, &["Отвір", "S; n"])]);
    }

    #[test]
    fn a_quoted_text_holds_quotes_and_lines() {
        assert_eq!(cells(b"a;\"b \"\"c\"\"\nd\"\ne\n"), vec![row(1, &["a", "b \"c\" d"]), row(3, &["e"])]);
        assert!(read(b"a;\"b\nc\n").is_err());
        assert!(read(&[0, 1, 2]).is_err());
    }

    #[test]
    fn what_is_written_is_read_back() {
        let rows = vec![Row { line: 2, cells: vec!["a;b".to_owned(), String::new(), "\"c\"".to_owned()] }];
        let text = written(&[Sheet { name: "Маршрут".to_owned(), rows }], ',').unwrap();
        assert_eq!(cells(text.as_bytes()), vec![row(1, &["Маршрут"]), row(2, &["a;b", "", "\"c\""])]);
    }

    #[test]
    fn no_name_is_a_formula() {
        let cells = ["=1+1", "+A1", "-A1", "@SUM(A1)", "=HYPERLINK(\"http://x\")", "-", "+5", "-0.5", "-200", "a=b"];
        let row = |cells: &[&str]| cells.iter().map(|&cell| cell.to_owned()).collect::<Vec<_>>();
        let sheet = Sheet { name: "=A".to_owned(), rows: vec![Row { line: 2, cells: row(&cells) }] };
        let text = written(&[sheet], '.').unwrap();
        let line = text.lines().last().unwrap();
        let expected = "'=1+1;'+A1;'-A1;'@SUM(A1);\"'=HYPERLINK(\"\"http://x\"\")\";-;+5;-0.5;-200;a=b";
        assert!(line == expected && text.lines().next().unwrap().ends_with("'=A"), "{text}");
        assert_eq!(
            read(text.as_bytes()).unwrap().rows.into_iter().map(|row| (row.line, row.cells)).collect::<Vec<_>>(),
            vec![(1, row(&["=A"])), (2, row(&cells))]
        );
    }
}
