//! A page as a text of Typst. Every word of the page stands in it as a quoted string, so that none is read as markup.

use technolog_document::{
    Align, Block, CellKind, Column, Document, Drawing, FORM_LINE_MM, FORM_STEP_MM, FindingBlock, Form, Inline, Inlines,
    Item, Table, Words, capital, cleaned, cleaned_lines,
};

/// What every page has: margins, spacing, and the functions that the blocks below call.
const PAGE: &str = include_str!("page.typ");
/// Between the margins, mm.
const WIDTH: f64 = 180.0;
/// The tallest drawing that leaves its caption room on the page, mm.
const TALLEST: f64 = 225.0;
/// A CSS pixel, mm.
const PIXEL: f64 = 25.4 / 96.0;

/// The text of the page, and its drawings.
pub fn of(document: &Document, words: &Words) -> (String, Vec<String>) {
    let mut page = Page { text: String::from(PAGE), drawings: Vec::new(), words };
    let title = quoted(&document.title.plain());
    page.text.push_str(&format!("#set document(title: {title})\n#set text(lang: {})\n", quoted(&document.lang)));
    // A form has its own name at its bottom, and its own page.
    if !document.title.is_empty() && !matches!(document.blocks.first(), Some(Block::Form(_))) {
        page.text.push_str(&format!("#heading(level: 1, {})\n", line(&document.title)));
    }
    document.blocks.iter().for_each(|block| page.block(block));
    (page.text, page.drawings)
}

struct Page<'w> {
    text: String,
    drawings: Vec<String>,
    words: &'w Words<'w>,
}

impl Page<'_> {
    fn block(&mut self, block: &Block) {
        match block {
            Block::Heading { level, words } => {
                self.push(format!("heading(level: {}, {})", (*level).clamp(1, 6), line(words)));
            }
            Block::Paragraph(words) => self.push(format!("par({})", line(words))),
            Block::List(items) => self.push(list(items)),
            Block::Table(table) => self.table(table),
            Block::Finding(own) => self.finding(own),
            Block::Drawing(drawing) => self.drawing(drawing),
            Block::Code(code) => self.push(format!(
                "block(text(font: \"DejaVu Sans Mono\", size: 8pt, par(leading: .5em, {})))",
                cleaned_lines(code).lines().map(quoted).collect::<Vec<_>>().join(" + linebreak() + ")
            )),
            Block::Fields(fields) => {
                for field in fields {
                    let words = Inlines::default().strong(format!("{}: ", field.label.plain()));
                    self.push(format!("par({})", line(&words.append(field.value.clone()))));
                }
            }
            Block::Form(form) => self.form(form),
        }
    }

    fn push(&mut self, call: String) {
        self.text.push('#');
        self.text.push_str(&call);
        self.text.push_str("\n\n");
    }

    fn table(&mut self, table: &Table) {
        if table.columns().is_empty() {
            return;
        }
        let size = match table.columns().len() {
            0..=6 => 10,
            7..=9 => 9,
            _ => 8,
        };
        let sides = table.columns().iter().map(|column| match column.align {
            Align::Left => "left",
            Align::Right => "right",
        });
        let sides: String = sides.map(|side| format!("{side}, ")).collect();
        let heads: Vec<Inlines> = table.columns().iter().map(Column::head).collect();
        let head = match heads.iter().all(Inlines::is_empty) {
            true => "none".to_owned(),
            false => format!(
                "({},)",
                heads.iter().map(|head| format!("strong({})", line(head))).collect::<Vec<_>>().join(", ")
            ),
        };
        let cells: String = table.rows().iter().flatten().map(|cell| format!(", {}", line(cell))).collect();
        let columns = table.columns().len();
        self.push(format!("rows({size}pt, ({}), ({sides}), {head}{cells})", "auto, ".repeat(columns)));
        for note in &table.notes {
            self.push(format!("under({})", line(note)));
        }
    }

    fn finding(&mut self, own: &FindingBlock) {
        let colour = format!("rgb({})", quoted(own.severity.colour()));
        let mut words = Inlines::default().strong(own.label());
        if let Some(place) = &own.place {
            words = words.text(" ").code(place);
        }
        let help = own
            .help
            .iter()
            .map(|help| Inlines::default().strong(format!("{}: ", self.words.help)).append(help.clone()));
        let more: String =
            own.details.iter().cloned().chain(help).map(|own| format!(" + linebreak() + {}", line(&own))).collect();
        self.push(format!("finding({colour}, {}{more})", line(&words.text(" ").append(own.words.clone()))));
    }

    fn drawing(&mut self, own: &Drawing) {
        let [across, tall] = ["width", "height"].map(|side| pixels(&own.svg, side).unwrap_or(1.0) * PIXEL);
        let width = WIDTH.min(across).min(TALLEST * across / tall);
        let caption = match own.caption.is_empty() {
            true => "none".to_owned(),
            false => {
                let numbered = format!("{} {} — ", capital(self.words.figure), self.drawings.len() + 1);
                line(&Inlines::from(numbered).append(own.caption.clone()))
            }
        };
        let file = format!("{}.svg", self.drawings.len());
        self.drawings.push(own.svg.clone());
        self.push(format!("drawing({}, {width:.1}mm, {}, {caption})", quoted(&file), quoted(&own.alternative)));
    }

    fn form(&mut self, form: &Form) {
        let (widths, rows) = form.columns();
        let list = |all: Vec<String>| all.into_iter().map(|one| one + ", ").collect::<String>();
        let columns = list(widths.iter().map(|width| format!("{:.1}mm", f64::from(*width) * FORM_STEP_MM)).collect());
        let heights =
            list(form.rows.iter().map(|row| format!("{:.2}mm", f64::from(row.lines) * FORM_LINE_MM)).collect());
        let mut cells = String::new();
        for row in rows {
            let last = row.len().saturating_sub(1);
            for (at, (cell, span)) in row.into_iter().enumerate() {
                let (down, words) = (cell.rows, line(&cell.words));
                let call = match cell.kind {
                    CellKind::Name => format!("named({span}, {down}, {words})"),
                    CellKind::Value if cell.width <= 6 => format!("narrow({span}, {down}, {words})"),
                    CellKind::Value => format!("value({span}, {down}, {words})"),
                    CellKind::Gap => format!("gap({span}, {down})"),
                    CellKind::Line => format!("written({span}, {}, {}, {words})", at == 0, at == last),
                };
                cells.push_str(&format!(", {call}"));
            }
        }
        self.push(format!("sheet({}, ({columns}), ({heights}){cells})", quoted(&form.mark)));
    }
}

fn list(items: &[Item]) -> String {
    let item = |item: &Item| match item.items.as_slice() {
        [] => line(&item.words),
        inner => format!("{} + {}", line(&item.words), list(inner)),
    };
    format!("list({})", items.iter().map(item).collect::<Vec<_>>().join(", "))
}

/// A line as a sum of contents.
fn line(inlines: &Inlines) -> String {
    let piece = |piece: &Inline| match piece {
        Inline::Strong(text) => format!("strong({})", quoted(text)),
        Inline::Code(text) => block_of_program(text),
        Inline::Quantity { .. } => quoted(&piece.plain().replace(' ', "\u{a0}")),
        Inline::Text(_) | Inline::Link { .. } => quoted(&piece.plain()),
    };
    let pieces: Vec<String> = inlines.pieces().iter().map(piece).collect();
    // A sum of strings alone would be a string, which not every function takes.
    format!("[] + {}", if pieces.is_empty() { "[]".to_owned() } else { pieces.join(" + ") })
}

/// Code in a line: it may be broken between its words, but not at a minus, `X-200`.
fn block_of_program(text: &str) -> String {
    let word = |word: &str| match word.chars().count() {
        1..=24 => format!("box(code({}))", quoted(word)),
        _ => format!("code({})", quoted(word)),
    };
    text.split(' ').map(word).collect::<Vec<_>>().join(" + [ ] + ")
}

/// A text as a string of Typst.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for sign in cleaned(text).chars() {
        if matches!(sign, '"' | '\\') {
            quoted.push('\\');
        }
        quoted.push(sign);
    }
    quoted + "\""
}

/// A side of a drawing as its root says, in CSS pixels.
fn pixels(svg: &str, side: &str) -> Option<f64> {
    let root = svg.get(svg.find("<svg")?..)?;
    let root = root.get(..root.find('>')?)?;
    let value = root.get(root.find(&format!(" {side}=\""))? + side.len() + 3..)?;
    value.get(..value.find('"')?)?.trim_end_matches("px").parse().ok()
}
