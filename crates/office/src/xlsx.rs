//! Workbooks: a sheet for each table, figures as numbers with the places that paper has, units in the heads, filters; no
//! formulas. The first sheet has what stands around the tables, so that no warning is lost; `form` is a sheet of a form.

use std::collections::BTreeSet;

use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, FormatAlign, Url, Workbook, Worksheet};
use technolog_document::{Align, Block, Decimal, Document, FindingBlock, Inlines, Item, Table, Words, cleaned};

use crate::OfficeError;

mod form;

/// The longest name of a sheet, in characters, and what it may not contain.
const NAME: usize = 31;
const FORBIDDEN: &[char] = &['[', ']', ':', '*', '?', '/', '\\'];
/// The widest column, in characters.
const WIDEST: f64 = 60.0;
/// The width of the first sheet, in characters.
const FRONT: f64 = 110.0;
/// The height of a line, in points.
const LINE: f64 = 15.0;
/// The mark behind a figure that nothing confirms.
const MARK: &str = "*";
/// The longest text of a cell, in characters.
const CELL: usize = 32_767;

/// The document as a workbook.
///
/// # Errors
/// The file cannot be put together.
pub fn xlsx(document: &Document, words: &Words) -> Result<Vec<u8>, OfficeError> {
    let mut book = Workbook::new();
    let title = document.title.plain();
    // Without the time of the clock: the same page is the same file.
    let properties =
        DocProperties::new().set_title(&title).set_creation_datetime(&ExcelDateTime::from_ymd(2000, 1, 1)?);
    book.set_properties(&properties);
    let mut names = Names(BTreeSet::new());
    let front_name = names.take(&title);
    let mut front = Front { sheet: Worksheet::new(), row: 0, words };
    front.sheet.set_name(&front_name)?.set_print_fit_to_pages(1, 0).set_column_width(0, FRONT)?;
    let bold = Format::new().set_bold().set_font_size(14).set_text_wrap();
    front.line(&title, 0, Some(&bold))?;
    let mut heading = title;
    let mut sheets = Vec::new();
    for block in &document.blocks {
        match block {
            Block::Heading { level, words } => {
                heading = words.plain();
                let format = Format::new().set_bold().set_font_size(if *level > 2 { 11 } else { 12 }).set_text_wrap();
                front.line(&heading, 0, Some(&format))?;
            }
            Block::Table(table) if !table.columns().is_empty() => {
                let name = names.take(&heading);
                front.link(&name)?;
                sheets.push(sheet(table, &name)?);
            }
            Block::Form(own) => {
                let name = names.take(&heading);
                front.link(&name)?;
                sheets.push(form::sheet(own, &name)?);
            }
            other => front.block(other)?,
        }
    }
    book.push_worksheet(front.sheet);
    sheets.into_iter().for_each(|sheet| {
        book.push_worksheet(sheet);
    });
    Ok(book.save_to_buffer()?)
}

/// The names of the sheets, of which no two may be alike.
struct Names(BTreeSet<String>);

impl Names {
    fn take(&mut self, wanted: &str) -> String {
        let plain = cleaned(wanted).replace(FORBIDDEN, " ");
        let plain = plain.trim().trim_matches('\'');
        let plain = if plain.is_empty() { "1" } else { plain };
        for number in 1_usize.. {
            let end = if number == 1 { String::new() } else { format!(" ({number})") };
            let name = format!("{}{end}", begin(plain, NAME - end.chars().count()).trim_end_matches('\''));
            // Excel does not tell capitals from small letters.
            if self.0.insert(name.to_lowercase()) {
                return name;
            }
        }
        wanted.to_owned()
    }
}

/// The whole words of a text that fit; of a single long word its begin.
fn begin(text: &str, room: usize) -> &str {
    let Some((cut, next)) = text.char_indices().nth(room) else { return text };
    let whole = &text[..cut];
    let end = if next == ' ' { cut } else { whole.rfind(' ').unwrap_or(cut) };
    whole[..end].trim_end()
}

/// The sheet of what is no table.
struct Front<'d> {
    sheet: Worksheet,
    row: u32,
    words: &'d Words<'d>,
}

impl Front<'_> {
    fn block(&mut self, block: &Block) -> Result<(), OfficeError> {
        match block {
            Block::Paragraph(words) => self.line(&words.plain(), 0, None),
            Block::List(items) => self.items(items, 1),
            Block::Finding(finding) => self.finding(finding),
            Block::Drawing(drawing) => {
                self.line(&format!("[{}] {}", self.words.figure, drawing.caption.plain()), 0, None)
            }
            Block::Code(code) => code.lines().try_for_each(|own| self.line(own, 0, None)),
            Block::Fields(fields) => fields
                .iter()
                .try_for_each(|field| self.line(&format!("{}: {}", field.label.plain(), field.value.plain()), 0, None)),
            // On sheets of their own.
            Block::Heading { .. } | Block::Table(_) | Block::Form(_) => Ok(()),
        }
    }

    /// A line that leads to another sheet.
    fn link(&mut self, name: &str) -> Result<(), OfficeError> {
        let url = Url::new(format!("internal:'{}'!A1", name.replace('\'', "''"))).set_text(name);
        self.sheet.write_url(self.row, 0, url)?;
        self.row += 1;
        Ok(())
    }

    fn items(&mut self, items: &[Item], depth: u8) -> Result<(), OfficeError> {
        items.iter().try_for_each(|item| {
            self.line(&item.words.plain(), depth, None)?;
            self.items(&item.items, depth + 1)
        })
    }

    fn finding(&mut self, finding: &FindingBlock) -> Result<(), OfficeError> {
        let place = finding.place.iter().map(|place| format!("{place} ")).collect::<String>();
        let told = format!("{} {place}{}", finding.label(), finding.words.plain());
        self.line(&told, 0, Some(&Format::new().set_bold().set_text_wrap()))?;
        finding.details.iter().try_for_each(|detail| self.line(&detail.plain(), 1, None))?;
        let help = finding.help.iter();
        help.map(|help| format!("{}: {}", self.words.help, help.plain())).try_for_each(|help| self.line(&help, 1, None))
    }

    fn line(&mut self, text: &str, indent: u8, format: Option<&Format>) -> Result<(), OfficeError> {
        let plain = Format::new().set_text_wrap().set_indent(indent);
        let room = FRONT - 3.0 * f64::from(indent) - if format.is_some() { FRONT / 4.0 } else { 0.0 };
        tall(&mut self.sheet, self.row, lines(text, room))?;
        self.sheet.write_string_with_format(self.row, 0, text_of(text), format.unwrap_or(&plain))?;
        self.row += 1;
        Ok(())
    }
}

/// A table on a sheet of its own: the head stays in sight and filters.
fn sheet(table: &Table, name: &str) -> Result<Worksheet, OfficeError> {
    let mut sheet = Worksheet::new();
    // On paper it is as wide as a page, and as long as it needs.
    sheet.set_name(name)?.set_landscape().set_paper_size(9).set_print_fit_to_pages(1, 0);
    let head = Format::new().set_bold().set_text_wrap().set_align(FormatAlign::Top);
    let columns: Vec<u16> = (0..).take(table.columns().len()).collect();
    let first = u32::from(table.has_head());
    let wrapped = Format::new().set_text_wrap().set_align(FormatAlign::Top);
    let mut rooms = Vec::new();
    for (&at, column) in columns.iter().zip(table.columns()) {
        if table.has_head() {
            sheet.write_string_with_format(0, at, text_of(&column.head().plain()), &head)?;
        }
        let cells = table.rows().iter().map(|row| row[usize::from(at)].plain().chars().count());
        let longest = cells.chain(column.head().plain().split(' ').map(|word| word.chars().count() + 2)).max();
        let width = (longest.unwrap_or(0) as f64 + 2.0).min(WIDEST);
        sheet.set_column_width(at, width)?;
        rooms.push(width - 1.0);
    }
    let of_row = |texts: &mut dyn Iterator<Item = String>| -> usize {
        texts.zip(&rooms).map(|(text, room)| lines(&text, *room)).max().unwrap_or(1)
    };
    if table.has_head() {
        tall(&mut sheet, 0, of_row(&mut table.columns().iter().map(|column| column.head().plain())))?;
    }
    let mut row = first;
    for cells in table.rows() {
        tall(&mut sheet, row, of_row(&mut cells.iter().map(Inlines::plain)))?;
        for ((&at, cell), column) in columns.iter().zip(cells).zip(table.columns()) {
            match figure(cell, column.align) {
                Some((value, unit)) => {
                    let format = Format::new().set_num_format(shown(value, unit)).set_align(FormatAlign::Top);
                    sheet.write_number_with_format(row, at, value.value(), &format)?;
                }
                None if cell.is_empty() => {}
                None => {
                    sheet.write_string_with_format(row, at, text_of(&cell.plain()), &wrapped)?;
                }
            }
        }
        row += 1;
    }
    if let (true, Some(last), true) = (table.has_head(), columns.last(), row > first) {
        sheet.autofilter(0, 0, row - 1, *last)?;
        sheet.set_freeze_panes(1, 0)?;
    }
    // Apart from the rows, so that no filter takes them for one.
    for note in &table.notes {
        row += 1;
        sheet.write_string(row, 0, text_of(&note.plain()))?;
    }
    Ok(sheet)
}

/// How many lines a text takes in a cell of so many characters, broken at spaces.
fn lines(text: &str, room: f64) -> usize {
    let mut taken = 1;
    let mut long = 0.0;
    for word in text.split(' ').map(|word| word.chars().count() as f64) {
        if long > 0.0 && long + 1.0 + word > room {
            (taken, long) = (taken + 1, 0.0);
        }
        // A word that no cell holds is broken.
        taken += ((word / room).ceil() as usize).saturating_sub(1);
        long += word + if long > 0.0 { 1.0 } else { 0.0 };
    }
    taken
}

/// Makes a row as tall as its lines: not every program for tables does it by itself.
fn tall(sheet: &mut Worksheet, row: u32, lines: usize) -> Result<(), OfficeError> {
    if lines > 1 {
        sheet.set_row_height(row, LINE * lines as f64)?;
    }
    Ok(())
}

/// A cell that is one figure; in a column of figures that is so whatever it was made of.
fn figure(cell: &Inlines, align: Align) -> Option<(Decimal, &str)> {
    let written = || (align == Align::Right).then(|| cell.plain().parse().ok()).flatten().map(|value| (value, ""));
    cell.figure().or_else(written).or_else(|| (align == Align::Right).then(|| marked(cell)).flatten())
}

/// A figure with the mark of what nothing confirms: a number, whose format shows the mark.
fn marked(cell: &Inlines) -> Option<(Decimal, &'static str)> {
    cell.plain().strip_suffix(MARK)?.parse().ok().map(|value| (value, MARK))
}

/// The format of a figure: the places that it is printed with, and its unit where the head has none.
fn shown(value: Decimal, unit: &str) -> String {
    let places = usize::from(value.places());
    let number = if places > 0 { format!("0.{}", "0".repeat(places)) } else { "0".to_owned() };
    if unit == MARK {
        return format!("{number}\"{MARK}\"");
    }
    if unit.is_empty() { number } else { format!("{number}\" {}\"", unit.replace('"', "")) }
}

fn text_of(text: &str) -> String {
    cleaned(text).chars().take(CELL).collect()
}
