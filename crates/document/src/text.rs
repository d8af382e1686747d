//! Text for a terminal of a given width.
//!
//! No line is wider, except for a single long word or lines that are never broken (a program). The contents of a
//! section and the continuation of a line are indented by two columns.

mod table;
mod wrap;

use crate::{Block, Document, FindingBlock, Inlines, Item, Words, clean};
use wrap::{Line, Style, Word, wrap};

/// The indent of a section's blocks and of continued lines.
const STEP: usize = 2;

/// The document as text, `width` columns wide, with the colours of ANSI terminals where `colour` is set.
pub fn text(document: &Document, width: usize, colour: bool, words: &Words) -> String {
    let mut page = Page { text: String::new(), width, colour, words, indent: 0, before: Before::Heading };
    page.heading(1, &document.title);
    for block in &document.blocks {
        page.block(block);
    }
    page.text
}

/// The block above, if it decides about an empty line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    /// A heading, or nothing.
    Heading,
    Lines,
    /// A block with empty lines around it.
    Apart,
}

struct Page<'p> {
    text: String,
    width: usize,
    colour: bool,
    words: &'p Words<'p>,
    indent: usize,
    before: Before,
}

impl Page<'_> {
    fn block(&mut self, block: &Block) {
        match block {
            Block::Heading { level, words } => return self.heading(*level, words),
            Block::Table(table) => return self.apart(|page| table::write(page, table)),
            Block::Code(code) => return self.apart(|page| page.code(code)),
            _ => {}
        }
        if self.before == Before::Apart {
            self.text.push('\n');
        }
        self.before = Before::Lines;
        match block {
            Block::Paragraph(words) => self.paragraph(&wrap::words(words), self.indent),
            Block::List(items) => self.items(items, self.indent),
            Block::Finding(finding) => self.finding(finding),
            Block::Fields(fields) => {
                for field in fields {
                    self.field(&field.label, &field.value, self.indent);
                }
            }
            Block::Drawing(figure) => {
                let mark = format!("[{}]", self.words.figure);
                let mut line = wrap::words(&mark.into());
                line.extend(wrap::words(&figure.caption));
                self.paragraph(&line, self.indent);
                self.paragraph(&wrap::words(&figure.alternative.as_str().into()), self.indent + STEP);
            }
            Block::Form(form) => {
                self.paragraph(&wrap::styled(&form.mark.as_str().into(), Style::Strong), self.indent);
                form.lines().iter().for_each(|line| self.paragraph(&wrap::words(line), self.indent + STEP));
            }
            Block::Heading { .. } | Block::Table(_) | Block::Code(_) => {}
        }
    }

    /// A section begins with an empty line; its contents are indented.
    fn heading(&mut self, level: u8, words: &Inlines) {
        if words.is_empty() {
            return;
        }
        let apart = if level <= 2 { !self.text.is_empty() } else { self.before == Before::Apart };
        if apart {
            self.text.push('\n');
        }
        self.paragraph(&wrap::styled(words, Style::Strong), 0);
        self.indent = if level > 1 { STEP } else { 0 };
        self.before = if level > 1 { Before::Heading } else { Before::Lines };
    }

    fn apart(&mut self, write: impl FnOnce(&mut Self)) {
        if self.before != Before::Heading {
            self.text.push('\n');
        }
        write(self);
        self.before = Before::Apart;
    }

    fn code(&mut self, code: &str) {
        for line in clean::lines(code).lines() {
            self.text.push_str(line);
            self.text.push('\n');
        }
    }

    fn items(&mut self, items: &[Item], indent: usize) {
        for item in items {
            let mut line = wrap::words(&"-".into());
            line.extend(wrap::words(&item.words));
            self.paragraph(&line, indent);
            self.items(&item.items, indent + STEP);
        }
    }

    fn finding(&mut self, finding: &FindingBlock) {
        let mut line = wrap::styled(&finding.label().as_str().into(), Style::Of(finding.severity));
        if let Some(place) = &finding.place {
            line.extend(wrap::styled(&format!("{place}:").as_str().into(), Style::Code));
        }
        line.extend(wrap::words(&finding.words));
        self.paragraph(&line, self.indent);
        for detail in &finding.details {
            self.paragraph(&wrap::words(detail), self.indent + 2 * STEP);
        }
        if let Some(help) = &finding.help {
            self.field(&self.words.help.into(), help, self.indent + 2 * STEP);
        }
    }

    fn field(&mut self, label: &Inlines, value: &Inlines, indent: usize) {
        let mut line = wrap::words(&label.clone().text(":"));
        line.extend(wrap::words(value));
        self.paragraph(&line, indent);
    }

    /// Words at an indent, continued two columns further in.
    fn paragraph(&mut self, words: &[Word], indent: usize) {
        let first = self.width.saturating_sub(indent);
        let lines = wrap(words, first, first.saturating_sub(STEP));
        for (number, line) in lines.iter().enumerate() {
            let indent = if number == 0 { indent } else { indent + STEP };
            // A word as wide as the page leaves no room for an indent.
            self.line(line, indent.min(self.width.saturating_sub(line.width)));
        }
    }

    fn line(&mut self, line: &Line, indent: usize) {
        let mut text = " ".repeat(indent);
        text.push_str(&line.shown(self.colour));
        self.text.push_str(text.trim_end());
        self.text.push('\n');
    }
}

#[cfg(test)]
mod tests;
