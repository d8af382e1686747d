//! Markdown: CommonMark with GitHub tables. Whatever a text contains, a Markdown reader shows the same text.

mod escape;

use crate::html::image;
use crate::{Align, Block, Document, Drawing, Field, FindingBlock, Inline, Inlines, Item, Table, Words, clean};
use escape::{code, escaped, started, strong};

/// The document as Markdown.
pub fn markdown(document: &Document, words: &Words) -> String {
    let mut page = Page { text: String::new(), list: None, words };
    page.heading(1, &document.title);
    for block in &document.blocks {
        page.block(block);
    }
    page.text
}

/// A kind of list. Two successive lists of a kind need different marks to be two lists.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ListKind {
    Items,
    Findings,
}

struct Page<'p> {
    text: String,
    /// The last list, and its mark.
    list: Option<(ListKind, char)>,
    words: &'p Words<'p>,
}

impl Page<'_> {
    fn block(&mut self, block: &Block) {
        match block {
            Block::Heading { level, words } => self.heading(*level, words),
            Block::Paragraph(words) => self.paragraph(words),
            Block::List(items) => {
                let mark = self.list(ListKind::Items);
                self.items(items, mark, 0);
            }
            Block::Fields(fields) => {
                let mark = self.list(ListKind::Items);
                for field in fields {
                    self.text.push_str(&format!("{mark} {}\n", labelled(field)));
                }
            }
            Block::Finding(finding) => self.finding(finding),
            Block::Table(table) => self.table(table),
            Block::Drawing(figure) => self.figure(figure),
            Block::Code(code) => self.code(code),
            Block::Form(form) => {
                self.paragraph(&Inlines::default().strong(&form.mark));
                let mark = self.list(ListKind::Items);
                let items: Vec<Item> = form.lines().into_iter().map(Item::from).collect();
                self.items(&items, mark, 0);
            }
        }
    }

    /// Separates blocks.
    fn apart(&mut self) {
        self.list = None;
        if !self.text.is_empty() {
            self.text.push('\n');
        }
    }

    fn heading(&mut self, level: u8, words: &Inlines) {
        self.apart();
        let marks = "#".repeat(level.clamp(1, 6).into());
        self.text.push_str(format!("{marks} {}", line(words)).trim_end());
        self.text.push('\n');
    }

    fn paragraph(&mut self, words: &Inlines) {
        self.apart();
        self.text.push_str(&started(line(words)));
        self.text.push('\n');
    }

    /// Begins a list and returns its mark.
    fn list(&mut self, kind: ListKind) -> char {
        let mark = if matches!(self.list, Some((_, '-'))) { '*' } else { '-' };
        self.apart();
        self.list = Some((kind, mark));
        mark
    }

    fn items(&mut self, items: &[Item], mark: char, depth: usize) {
        for item in items {
            self.text.push_str(format!("{}{mark} {}", "  ".repeat(depth), started(line(&item.words))).trim_end());
            self.text.push('\n');
            self.items(&item.items, mark, depth + 1);
        }
    }

    /// An item of the preceding list of findings, or of a new one.
    fn finding(&mut self, finding: &FindingBlock) {
        let mark = match self.list {
            Some((ListKind::Findings, mark)) => mark,
            _ => self.list(ListKind::Findings),
        };
        let mut words = Inlines::default().strong(finding.label());
        if let Some(place) = &finding.place {
            words = words.text(" ").code(place);
        }
        self.text.push_str(&format!("{mark} {}\n", started(line(&words.text(" ").append(finding.words.clone())))));
        let help = finding.help.iter().map(|help| labelled(&Field::new(self.words.help, help.clone())));
        for detail in finding.details.iter().map(|detail| started(line(detail))).chain(help) {
            self.text.push_str(&format!("  {mark} {detail}\n"));
        }
    }

    fn table(&mut self, table: &Table) {
        if table.columns().is_empty() {
            return;
        }
        self.apart();
        let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        self.text.push_str(&row(table.columns().iter().map(|column| cell(&column.head())).collect()));
        let rule = |align: Align| if align == Align::Right { "---:" } else { "---" }.to_owned();
        self.text.push_str(&row(table.columns().iter().map(|column| rule(column.align)).collect()));
        for cells in table.rows() {
            self.text.push_str(&row(cells.iter().map(cell).collect()));
        }
        for note in &table.notes {
            self.paragraph(note);
        }
    }

    fn figure(&mut self, figure: &Drawing) {
        self.apart();
        self.text.push_str(&format!("![{}](<{}>)\n", escaped(&figure.alternative), image(&figure.svg)));
        if !figure.caption.is_empty() {
            self.paragraph(&figure.caption);
        }
    }

    /// Lines in a fence longer than any run of backticks in them.
    fn code(&mut self, code: &str) {
        self.apart();
        let code = clean::lines(code);
        let fence = "`".repeat(escape::longest_run(&code).max(2) + 1);
        self.text.push_str(&format!("{fence}\n{code}{}{fence}\n", if code.ends_with('\n') { "" } else { "\n" }));
    }
}

/// `**label:** value`.
fn labelled(field: &Field) -> String {
    let mut label = field.label.plain();
    label.push(':');
    started(line(&Inlines::default().strong(label).text(" ").append(field.value.clone())))
}

/// A line within a block. Spaces at its ends have no meaning in Markdown.
fn line(inlines: &Inlines) -> String {
    in_place(inlines, false)
}

/// A line in a table cell, where a vertical bar in code would end the cell.
fn cell(inlines: &Inlines) -> String {
    in_place(inlines, true)
}

fn in_place(inlines: &Inlines, cell: bool) -> String {
    let mut shown = String::new();
    let pieces = inlines.pieces();
    for (number, piece) in pieces.iter().enumerate() {
        match piece {
            Inline::Text(_) | Inline::Quantity { .. } => shown.push_str(&escaped(&piece.plain())),
            Inline::Strong(text) => strong(&mut shown, text, pieces.get(number + 1)),
            Inline::Code(text) => code(&mut shown, text, cell),
            Inline::Link { text, to } => match clean::address(to) {
                Some(to) => escape::link(&mut shown, text, &to),
                None => shown.push_str(&escaped(text)),
            },
        }
    }
    shown.trim_matches(' ').to_owned()
}
