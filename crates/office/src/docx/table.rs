//! A table: its columns as wide as their words need, on a page across where they need more than a page upright has.

use technolog_document::{Align, Inlines, Table};

use super::parts::{LONG_MM, WIDTH_MM};
use super::{Body, line, paragraph, sized};

/// The height of letters in a table, in points: the usual one, and one for tables that are too wide even for a page across.
const SIZES: [f64; 3] = [10.0, 9.0, 7.5];
/// The mean width of a letter as a part of its height, in Times New Roman.
const LETTER: f64 = 0.53;
/// What the edges of a cell need, mm.
const EDGES_MM: f64 = 2.6;
/// The most that a column is made wider for its longest cell, mm, where its cells are not all that long.
const MOST_MM: f64 = 70.0;
const POINT_MM: f64 = 25.4 / 72.0;

/// How a table fits.
pub struct Fit {
    /// Whether it stands on a page across.
    pub landscape: bool,
    /// The height of its letters, points.
    size: f64,
    /// The widths of its columns, mm.
    widths: Vec<f64>,
}

impl Fit {
    /// The largest letters with which no word is broken, upright if possible.
    pub fn of(table: &Table) -> Self {
        let upright = SIZES[..2].iter().map(|size| (*size, WIDTH_MM, false));
        let across = SIZES.iter().map(|size| (*size, LONG_MM, true));
        let tries: Vec<(f64, f64, bool)> = upright.chain(across).collect();
        let least = |size: f64| -> f64 { needs(table, size).iter().map(|(least, _)| least).sum() };
        let fits = tries.iter().find(|(size, room, _)| least(*size) <= *room);
        let (size, room, landscape) = fits.or(tries.last()).copied().unwrap_or((SIZES[0], WIDTH_MM, false));
        Self { landscape, size, widths: widths(&needs(table, size), room) }
    }
}

/// For each column what its longest word needs, and what its longest cell would like, mm.
fn needs(table: &Table, size: f64) -> Vec<(f64, f64)> {
    let wide = |letters: usize| letters as f64 * size * LETTER * POINT_MM + EDGES_MM;
    let cells = |at: usize| table.rows().iter().map(move |row| &row[at]);
    let of = |at: usize| {
        let head = table.columns()[at].head();
        // Heads are bold, which is wider.
        let word = longest_word(&head).saturating_add(longest_word(&head) / 8);
        let word = cells(at).map(longest_word).max().unwrap_or(0).max(word);
        let letters: Vec<usize> = cells(at).map(|cell| cell.plain().chars().count()).collect();
        let whole = letters.iter().copied().max().unwrap_or(0);
        // A column of sentences takes more of the page than one that has a single long cell.
        let mean = letters.iter().sum::<usize>() / letters.len().max(1);
        let least = wide(word);
        (least, wide(whole).min(MOST_MM.max(wide(2 * mean))).max(least))
    };
    (0..table.columns().len()).map(of).collect()
}

/// The letters of the longest word that Word does not break: it breaks at spaces and behind dashes.
fn longest_word(cell: &Inlines) -> usize {
    let plain = cell.plain();
    let words = plain.split([' ', '-', '–', '…']).map(|word| word.chars().count() + 1);
    words.max().unwrap_or(0)
}

/// What each needs, and of the rest a share of what it would like; a table with little in it is narrower than its page.
fn widths(needs: &[(f64, f64)], room: f64) -> Vec<f64> {
    let least: f64 = needs.iter().map(|(least, _)| least).sum();
    let more: f64 = needs.iter().map(|(least, like)| like - least).sum();
    if least > room {
        return needs.iter().map(|(own, _)| own * room / least).collect();
    }
    let share = if more > 0.0 { ((room - least) / more).min(1.0) } else { 0.0 };
    needs.iter().map(|(least, like)| least + (like - least) * share).collect()
}

/// Writes a table with its notes.
pub fn write(body: &mut Body<'_>, table: &Table, fit: &Fit) {
    if table.columns().is_empty() {
        return;
    }
    let twips: Vec<String> = fit.widths.iter().map(|mm| format!("{:.0}", mm * 1440.0 / 25.4)).collect();
    let whole: f64 = fit.widths.iter().sum();
    let edge = |side: &str| format!("<w:{side} w:val=\"single\" w:sz=\"4\" w:space=\"0\" w:color=\"auto\"/>");
    let edges: String = ["top", "left", "bottom", "right", "insideH", "insideV"].map(edge).concat();
    let mut xml = format!(
        "<w:tbl><w:tblPr><w:tblW w:w=\"{:.0}\" w:type=\"dxa\"/><w:tblBorders>{edges}</w:tblBorders>\
         <w:tblLayout w:type=\"fixed\"/><w:tblCellMar><w:left w:w=\"60\" w:type=\"dxa\"/>\
         <w:right w:w=\"60\" w:type=\"dxa\"/></w:tblCellMar><w:tblLook w:firstRow=\"1\"/></w:tblPr><w:tblGrid>",
        whole * 1440.0 / 25.4
    );
    twips.iter().for_each(|width| xml.push_str(&format!("<w:gridCol w:w=\"{width}\"/>")));
    xml.push_str("</w:tblGrid>");
    let size = format!("<w:sz w:val=\"{:.0}\"/>", fit.size * 2.0);
    let row = |cells: &mut dyn Iterator<Item = (Inlines, Align)>, head: bool| {
        let repeats = if head { "<w:tblHeader/>" } else { "" };
        let mut xml = format!("<w:tr><w:trPr><w:cantSplit/>{repeats}</w:trPr>");
        for ((cell, align), width) in cells.zip(&twips) {
            let side = if align == Align::Right && !head { "<w:jc w:val=\"right\"/>" } else { "" };
            let style = if head { "TableHead" } else { "TableText" };
            let words = paragraph(style, side, &sized(&cell, &size));
            xml.push_str(&format!("<w:tc><w:tcPr><w:tcW w:w=\"{width}\" w:type=\"dxa\"/></w:tcPr>{words}</w:tc>"));
        }
        xml.push_str("</w:tr>");
        xml
    };
    if table.has_head() {
        xml.push_str(&row(&mut table.columns().iter().map(|column| (column.head(), column.align)), true));
    }
    for cells in table.rows() {
        let aligned = table.columns().iter().map(|column| column.align);
        xml.push_str(&row(&mut cells.iter().cloned().zip(aligned), false));
    }
    xml.push_str("</w:tbl>");
    body.xml.push_str(&xml);
    // Two tables in a row would be one without something between them.
    if table.notes.is_empty() {
        body.paragraph("Break", "", "");
    }
    for note in &table.notes {
        body.paragraph("Note", "", &line(note));
    }
}
