//! Pages as a terminal shows them, without what a reader's own screen adds.

use technolog::document::{Document, Words, markdown, text};

const WORDS: Words<'static> = Words { left_out: "left out", see_all: "", help: "help", figure: "figure" };

/// A page as text, 120 columns wide, without colours.
pub fn shown(page: &Document) -> String {
    text(page, 120, false, &WORDS)
}

/// A page as text, so many columns wide, without colours.
pub fn shown_at(width: usize, page: &Document) -> String {
    text(page, width, false, &WORDS)
}

/// A page in Markdown.
pub fn in_markdown(page: &Document) -> String {
    markdown(page, &WORDS)
}
