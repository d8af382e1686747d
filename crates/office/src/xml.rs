//! Texts in XML.

use technolog_document::{cleaned, cleaned_lines};

/// One line of text, escaped for contents and quoted attributes.
pub fn escaped(text: &str) -> String {
    marks(&cleaned(text))
}

/// Lines of text, each escaped.
pub fn escaped_lines(text: &str) -> Vec<String> {
    cleaned_lines(text).lines().map(marks).collect()
}

fn marks(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
