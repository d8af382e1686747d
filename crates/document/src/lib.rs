//! Pages as a tree, and its three writers: text for a terminal, Markdown, HTML.
//!
//! A page says what it shows (a heading, a table of typed cells, a finding); how that looks is decided by the writers
//! alone. They make the same bytes on every run. A writer adds no words of its own: the few it needs are [`Words`].
//!
//! - `tree` the blocks of a page, `inline` what stands in a line of it;
//! - `text`, `markdown`, `html` a writer each, with one escaping function each;
//! - `format` which writer an ending of a file means.

mod clean;
mod format;
mod html;
mod inline;
mod markdown;
mod text;
mod tree;
mod words;

pub use clean::{line as cleaned, lines as cleaned_lines};
pub use format::{Contradiction, Format, agreed};
pub use html::html;
pub use inline::{Inline, Inlines};
pub use markdown::markdown;
pub use text::text;
pub use tree::{Align, Block, Column, Document, Drawing, Field, FindingBlock, Item, Keep, Severity, Table};
pub use words::{WIDTH, Words};

/// A document in one of the formats; width and colour are of text only.
pub fn write(document: &Document, format: Format, width: usize, colour: bool, words: &Words) -> String {
    match format {
        Format::Text => text(document, width, colour, words),
        Format::Markdown => markdown(document, words),
        Format::Html => html(document, words),
    }
}
