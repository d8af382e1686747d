//! A sheet of a form: one table whose columns are the edges of all its cells, which span them.

use technolog_document::{CellKind, FORM_LINE_MM, FORM_STEP_MM, Form, FormCell, escaped};

use super::{Body, line, paragraph};

/// A step of a form and the height of one of its lines, in twentieths of a point.
const STEP: f64 = FORM_STEP_MM * 1440.0 / 25.4;
const LINE: f64 = FORM_LINE_MM * 1440.0 / 25.4;

/// Writes a sheet; the next one begins a page.
pub fn write(body: &mut Body<'_>, form: &Form) {
    let (widths, rows) = form.columns();
    let twips =
        |from: usize, span: usize| -> f64 { widths[from..from + span].iter().map(|own| f64::from(*own) * STEP).sum() };
    let mark = format!("<w:r><w:t xml:space=\"preserve\">{}</w:t></w:r>", escaped(&form.mark));
    let begins = if body.has_form { "<w:pageBreakBefore/>" } else { "" };
    body.has_form = true;
    body.xml.push_str(&paragraph("FormMark", begins, &mark));
    let mut xml = format!(
        "<w:tbl><w:tblPr><w:tblW w:w=\"{:.0}\" w:type=\"dxa\"/><w:tblLayout w:type=\"fixed\"/><w:tblCellMar>\
         <w:left w:w=\"28\" w:type=\"dxa\"/><w:right w:w=\"28\" w:type=\"dxa\"/></w:tblCellMar></w:tblPr><w:tblGrid>",
        twips(0, widths.len())
    );
    (0..widths.len()).for_each(|at| xml.push_str(&format!("<w:gridCol w:w=\"{:.0}\"/>", twips(at, 1))));
    xml.push_str("</w:tblGrid>");
    // The columns of the body have no full rules between them, only the frame around them.
    let last = widths.len();
    let edges = |kind: CellKind, at: usize, span: usize| -> &'static [&'static str] {
        match (kind, at == 0, at + span == last) {
            (CellKind::Gap, ..) => &[],
            (CellKind::Line, false, false) => &["top", "bottom"],
            (CellKind::Line, true, false) => &["top", "left", "bottom"],
            (CellKind::Line, false, true) => &["top", "bottom", "right"],
            (CellKind::Line, true, true) | (CellKind::Name | CellKind::Value, ..) => {
                &["top", "left", "bottom", "right"]
            }
        }
    };
    // Cells that reach down: their first column, how many they span, the rows that are left, and their edges.
    let mut held: Vec<(usize, usize, u16, CellKind)> = Vec::new();
    for (row, cells) in form.rows.iter().zip(rows) {
        let height = format!("{:.0}", f64::from(row.lines) * LINE);
        // A line of the body holds what was broken to its width; were it taller in other letters, the sheet would need two pages.
        let rule = if row.cells.iter().any(|cell| cell.kind == CellKind::Line) { "exact" } else { "atLeast" };
        xml.push_str(&format!(
            "<w:tr><w:trPr><w:cantSplit/><w:trHeight w:val=\"{height}\" w:hRule=\"{rule}\"/></w:trPr>"
        ));
        let (mut at, mut begun) = (0, Vec::new());
        let mut cells = cells.into_iter().peekable();
        while at < widths.len() {
            if let Some((_, span, _, kind)) = held.iter().find(|(first, ..)| *first == at) {
                xml.push_str(&cell("<w:vMerge/>", edges(*kind, at, *span), *kind, *span, twips(at, *span), ""));
                at += span;
                continue;
            }
            let Some((own, span)) = cells.next() else { break };
            if own.rows > 1 {
                begun.push((at, span, own.rows - 1, own.kind));
            }
            let merge = if own.rows > 1 { "<w:vMerge w:val=\"restart\"/>" } else { "" };
            xml.push_str(&cell(merge, edges(own.kind, at, span), own.kind, span, twips(at, span), &words(own)));
            at += span;
        }
        held.iter_mut().for_each(|own| own.2 -= 1);
        held.retain(|own| own.2 > 0);
        held.extend(begun);
        xml.push_str("</w:tr>");
    }
    xml.push_str("</w:tbl>");
    body.xml.push_str(&xml);
    body.xml.push_str(&paragraph("Nothing", "", ""));
}

fn words(cell: &FormCell) -> String {
    line(&cell.words)
}

fn cell(merge: &str, edges: &[&str], kind: CellKind, span: usize, width: f64, runs: &str) -> String {
    let edge = |side: &&str| format!("<w:{side} w:val=\"single\" w:sz=\"4\" w:space=\"0\" w:color=\"auto\"/>");
    let edges: String = edges.iter().map(edge).collect();
    let edges = if edges.is_empty() { edges } else { format!("<w:tcBorders>{edges}</w:tcBorders>") };
    let spans = if span > 1 { format!("<w:gridSpan w:val=\"{span}\"/>") } else { String::new() };
    let side = if kind == CellKind::Name { "<w:jc w:val=\"center\"/>" } else { "" };
    let words = paragraph("FormText", side, runs);
    format!("<w:tc><w:tcPr><w:tcW w:w=\"{width:.0}\" w:type=\"dxa\"/>{spans}{merge}{edges}</w:tcPr>{words}</w:tc>")
}
