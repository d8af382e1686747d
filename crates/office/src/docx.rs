//! Word files (ECMA-376, transitional): A4 by DSTU 3008, headings with styles, real tables whose head repeats, drawings as
//! SVG with a metafile for Words that know no SVG.
//!
//! - `parts` the files of the package that every page has; `table` a table and where it fits; `form` a sheet of a form;
//!   `figure` a drawing.

mod figure;
mod form;
mod parts;
mod table;

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use technolog_document::{Block, Document, FindingBlock, Inline, Inlines, Item, Words, escaped, escaped_lines};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::OfficeError;
use figure::Figure;
use parts::Paper;
use table::Fit;

/// The document as a Word file.
///
/// # Errors
/// The package cannot be put together.
pub fn docx(document: &Document, words: &Words) -> Result<Vec<u8>, OfficeError> {
    let mut body = Body { xml: String::new(), figures: Vec::new(), words, paper: Paper::Upright, has_form: false };
    // A form names itself in its frame.
    let is_form = matches!(document.blocks.first(), Some(Block::Form(_)));
    if !document.title.is_empty() && !is_form {
        body.paragraph("Title", "", &line(&document.title));
    }
    let fits = document.blocks.iter().map(|block| match block {
        Block::Table(table) => Some(Fit::of(table)),
        _ => None,
    });
    let blocks: Vec<(&Block, Option<Fit>)> = document.blocks.iter().zip(fits).collect();
    for (at, &(block, ref fit)) in blocks.iter().enumerate() {
        // A heading lies as its table does.
        let first = blocks[at..].iter().find(|(block, _)| !matches!(block, Block::Heading { .. }));
        body.turn(match first {
            Some((Block::Form(_), _)) => Paper::Form,
            Some((_, Some(fit))) if fit.landscape => Paper::Across,
            _ => Paper::Upright,
        });
        match (block, fit) {
            (Block::Table(table), Some(fit)) => table::write(&mut body, table, fit),
            _ => body.block(block),
        }
    }
    let Body { mut xml, figures, paper, .. } = body;
    xml.push_str(&parts::section(paper));
    let lang = escaped(&document.lang);
    let mut package = Package(ZipWriter::new(Cursor::new(Vec::new())));
    package.add("[Content_Types].xml", parts::CONTENT_TYPES.as_bytes())?;
    package.add("_rels/.rels", parts::RELATIONS.as_bytes())?;
    package.add("docProps/core.xml", parts::properties(&escaped(&document.title.plain()), &lang).as_bytes())?;
    package.add("word/document.xml", parts::document(&xml).as_bytes())?;
    package.add("word/_rels/document.xml.rels", figure::relations(&figures).as_bytes())?;
    package.add("word/styles.xml", parts::styles(&lang).as_bytes())?;
    package.add("word/numbering.xml", parts::numbering().as_bytes())?;
    package.add("word/settings.xml", parts::SETTINGS.as_bytes())?;
    package.add("word/header1.xml", parts::HEADER.as_bytes())?;
    package.add("word/header2.xml", parts::NO_HEADER.as_bytes())?;
    for figure in &figures {
        package.add(&format!("word/media/{}.svg", figure.name()), figure.svg.as_bytes())?;
        package.add(&format!("word/media/{}.emf", figure.name()), &figure.emf())?;
    }
    Ok(package.0.finish()?.into_inner())
}

struct Package(ZipWriter<Cursor<Vec<u8>>>);

impl Package {
    /// A file; without the time of the clock, so that the same page is the same file.
    fn add(&mut self, name: &str, contents: &[u8]) -> Result<(), OfficeError> {
        let options = SimpleFileOptions::default().last_modified_time(zip::DateTime::default());
        self.0.start_file(name, options)?;
        Ok(self.0.write_all(contents)?)
    }
}

struct Body<'d> {
    xml: String,
    figures: Vec<Figure<'d>>,
    words: &'d Words<'d>,
    /// The pages that what is written now stands on.
    paper: Paper,
    /// Whether a form was written, after which another begins a page.
    has_form: bool,
}

impl<'d> Body<'d> {
    fn block(&mut self, block: &'d Block) {
        match block {
            Block::Heading { level, words } => {
                let level = level.clamp(&2, &6) - 1;
                self.paragraph(&format!("Heading{level}"), "", &line(words));
            }
            Block::Paragraph(words) => self.paragraph("BodyText", "", &line(words)),
            Block::List(items) => self.items(items, 0),
            Block::Finding(finding) => self.finding(finding),
            Block::Drawing(drawing) => {
                let figure = Figure::of(drawing, self.figures.len() + 1);
                let kept = if drawing.caption.is_empty() { "" } else { "<w:keepNext/>" };
                self.paragraph("Figure", kept, &figure.xml());
                self.figures.push(figure);
                if !drawing.caption.is_empty() {
                    self.paragraph("Caption", "", &line(&drawing.caption));
                }
            }
            Block::Code(code) => {
                for own in escaped_lines(code).lines() {
                    self.paragraph("Code", "", &run("", own));
                }
            }
            Block::Fields(fields) => {
                for field in fields {
                    let label = Inlines::default().strong(format!("{}:", field.label.plain())).text(" ");
                    self.paragraph("Field", "", &line(&label.append(field.value.clone())));
                }
            }
            Block::Form(own) => form::write(self, own),
            // Written with its fit.
            Block::Table(_) => {}
        }
    }

    /// Ends the pages before, if the next ones lie another way.
    fn turn(&mut self, paper: Paper) {
        if paper != self.paper {
            // Nothing stands before a form that begins the file.
            if !self.xml.is_empty() {
                let section = parts::section(self.paper);
                self.xml.push_str(&format!("<w:p><w:pPr><w:pStyle w:val=\"Break\"/>{section}</w:pPr></w:p>"));
            }
            self.paper = paper;
        }
    }

    fn paragraph(&mut self, style: &str, properties: &str, runs: &str) {
        self.xml.push_str(&paragraph(style, properties, runs));
    }

    fn items(&mut self, items: &[Item], depth: usize) {
        for item in items {
            self.bullet(depth, &line(&item.words));
            self.items(&item.items, depth + 1);
        }
    }

    fn bullet(&mut self, depth: usize, runs: &str) {
        let number = format!("<w:numPr><w:ilvl w:val=\"{}\"/><w:numId w:val=\"1\"/></w:numPr>", depth.min(8));
        self.paragraph("ListBullet", &number, runs);
    }

    /// A finding with its word, as a paragraph; its basis and remedy under it.
    fn finding(&mut self, finding: &FindingBlock) {
        let colour = finding.severity.colour().trim_start_matches('#').to_uppercase();
        let mut runs = run(&format!("<w:b/><w:color w:val=\"{colour}\"/>"), &escaped(&finding.label()));
        if let Some(place) = &finding.place {
            runs.push_str(&line(&Inlines::from(" ").code(place)));
        }
        runs.push_str(&line(&Inlines::from(" ").append(finding.words.clone())));
        self.paragraph("BodyText", "", &runs);
        for detail in &finding.details {
            self.bullet(0, &line(detail));
        }
        if let Some(help) = &finding.help {
            let label = Inlines::default().strong(format!("{}:", self.words.help)).text(" ");
            self.bullet(0, &line(&label.append(help.clone())));
        }
    }
}

/// A paragraph of a style.
fn paragraph(style: &str, properties: &str, runs: &str) -> String {
    format!("<w:p><w:pPr><w:pStyle w:val=\"{style}\"/>{properties}</w:pPr>{runs}</w:p>")
}

/// A run of escaped text.
fn run(properties: &str, text: &str) -> String {
    let properties = if properties.is_empty() { String::new() } else { format!("<w:rPr>{properties}</w:rPr>") };
    format!("<w:r>{properties}<w:t xml:space=\"preserve\">{text}</w:t></w:r>")
}

/// The pieces of a line as runs, in letters of the paragraph's size.
fn line(inlines: &Inlines) -> String {
    sized(inlines, "")
}

/// The same with a size of letters, which stands behind the other properties of a run.
fn sized(inlines: &Inlines, size: &str) -> String {
    let mut runs = String::new();
    for piece in inlines.pieces() {
        let text = escaped(&piece.plain());
        let (properties, text) = match piece {
            Inline::Strong(_) => ("<w:b/>", text),
            Inline::Code(_) => ("<w:rStyle w:val=\"CodeWords\"/>", text),
            // A figure and its unit stay on one line.
            Inline::Quantity { .. } => ("", text.replace(' ', "\u{a0}")),
            Inline::Text(_) | Inline::Link { .. } => ("", text),
        };
        // Writing to a text cannot fail.
        let _ = runs.write_str(&run(&format!("{properties}{size}"), &text));
    }
    runs
}
