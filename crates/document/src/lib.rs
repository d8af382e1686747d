//! Pages as a tree, with three writers: text for a terminal, Markdown, HTML.
//!
//! A page gives its contents (a heading, a table of typed cells, a finding); only the writers decide how they look.
//! They write the same bytes on every run. A writer adds no words of its own: the few it needs are [`Words`].
//!
//! - `tree` the blocks of a page, `form` one that is a sheet of a form, `inline` the contents of a line, `decimal` its typed
//!   figures;
//! - `text`, `markdown`, `html` one writer each, with one escaping function each;
//! - `format` the choice of a writer by a file extension.

mod clean;
mod decimal;
mod form;
mod format;
mod html;
mod inline;
mod markdown;
mod reworded;
mod text;
mod tree;
mod words;

pub use clean::{capital, escaped, escaped_lines, line as cleaned, lines as cleaned_lines};
pub use decimal::{Decimal, NotDecimal};
pub use form::{CellKind, FORM_LINE_MM, FORM_STEP_MM, FORM_WIDTH, Form, FormCell, FormRow, Spanning};
pub use format::{Contradiction, Format, agreed};
pub use html::html;
pub use inline::{Inline, Inlines};
pub use markdown::markdown;
pub use reworded::Reword;
pub use text::text;
pub use tree::{Align, Block, Column, Document, Drawing, Field, FindingBlock, Item, Keep, Severity, Table};
pub use words::{WIDTH, Words};

/// Writes a document in one of the formats; width and colour apply only to text.
pub fn write(document: &Document, format: Format, width: usize, colour: bool, words: &Words) -> String {
    match format {
        Format::Text => text(document, width, colour, words),
        Format::Markdown => markdown(document, words),
        Format::Html => html(document, words),
    }
}
