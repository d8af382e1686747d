//! A sheet of a form: every cell of it a cell of the workbook, or several in one as its frame has them.

use rust_xlsxwriter::{Format, FormatAlign, FormatBorder, Worksheet};
use technolog_document::{Align, CellKind, FORM_LINE_MM, FORM_STEP_MM, Form, FormCell};

use super::{figure, marked, shown, text_of};
use crate::OfficeError;

/// A millimetre in pixels of a screen, by which workbooks measure, and in points.
const PIXELS: f64 = 96.0 / 25.4;
const POINTS: f64 = 72.0 / 25.4;

/// The sheet, A4 across; its mark stands above the frame at the right.
pub(super) fn sheet(form: &Form, name: &str) -> Result<Worksheet, OfficeError> {
    let mut sheet = Worksheet::new();
    sheet.set_name(name)?.set_landscape().set_paper_size(9).set_print_fit_to_pages(1, 1);
    let (widths, rows) = form.columns();
    for (at, width) in (0_u16..).zip(&widths) {
        sheet.set_column_width_pixels(at, (f64::from(*width) * FORM_STEP_MM * PIXELS).round() as u32)?;
    }
    let last = u16::try_from(widths.len().saturating_sub(1)).unwrap_or(u16::MAX);
    let right = Format::new().set_align(FormatAlign::Right).set_font_size(9);
    if last > 0 {
        sheet.merge_range(0, 0, 0, last, &text_of(&form.mark), &right)?;
    }
    // Cells that reach down: their first column, how many they span, and the rows that are left.
    let mut held: Vec<(u16, u16, u16)> = Vec::new();
    for (line, (row, cells)) in (1_u32..).zip(form.rows.iter().zip(rows)) {
        sheet.set_row_height(line, f64::from(row.lines) * FORM_LINE_MM * POINTS)?;
        let (mut at, mut begun) = (0, Vec::new());
        for (cell, span) in cells {
            while let Some((_, taken, _)) = held.iter().find(|(first, ..)| *first == at) {
                at += taken;
            }
            let span = u16::try_from(span).unwrap_or(1);
            if cell.rows > 1 {
                begun.push((at, span, cell.rows - 1));
            }
            write(&mut sheet, cell, (line, at), span)?;
            at += span;
        }
        held.iter_mut().for_each(|own| own.2 -= 1);
        held.retain(|own| own.2 > 0);
        held.extend(begun);
    }
    Ok(sheet)
}

/// A cell with its edges, as on paper; a figure is a number.
fn write(sheet: &mut Worksheet, cell: &FormCell, (row, at): (u32, u16), span: u16) -> Result<(), OfficeError> {
    let plain = Format::new().set_font_size(9).set_text_wrap().set_align(FormatAlign::VerticalCenter);
    let format = match cell.kind {
        CellKind::Gap => return Ok(()),
        CellKind::Name => plain.set_border(FormatBorder::Thin).set_align(FormatAlign::Center),
        CellKind::Value => plain.set_border(FormatBorder::Thin),
        CellKind::Line => plain.set_border_top(FormatBorder::Thin).set_border_bottom(FormatBorder::Thin),
    };
    let value = figure(&cell.words, Align::Left).or_else(|| marked(&cell.words));
    let format = match value {
        Some((value, unit)) => format.set_num_format(shown(value, unit)),
        None => format,
    };
    let (down, across) = (row + u32::from(cell.rows.saturating_sub(1)), at + span.saturating_sub(1));
    if (down, across) != (row, at) {
        sheet.merge_range(row, at, down, across, "", &format)?;
    }
    match value {
        Some((value, _)) => sheet.write_number_with_format(row, at, value.value(), &format)?,
        None => sheet.write_string_with_format(row, at, text_of(&cell.words.plain()), &format)?,
    };
    Ok(())
}
