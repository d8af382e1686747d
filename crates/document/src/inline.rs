//! The contents of a line.

use crate::Decimal;

/// A piece of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inline {
    /// Words.
    Text(String),
    /// Words to be emphasised.
    Strong(String),
    /// Text to be copied exactly: a key, a path, a block of a program.
    Code(String),
    /// A figure and its unit, which stay on one line.
    Quantity {
        /// The figure as written in that language: `0,25`.
        number: String,
        /// Its unit; empty where a column has it, or where there is none.
        unit: String,
        /// The same figure, typed; none where it is several, such as `3/5`.
        value: Option<Decimal>,
    },
    /// A link to another page.
    Link {
        /// The visible text.
        text: String,
        /// The target: an address or a path.
        to: String,
    },
}

impl Inline {
    /// The text without formatting.
    pub fn plain(&self) -> String {
        match self {
            Self::Text(text) | Self::Strong(text) | Self::Code(text) | Self::Link { text, .. } => text.clone(),
            Self::Quantity { number, unit, .. } if unit.is_empty() => number.clone(),
            Self::Quantity { number, unit, .. } => format!("{number} {unit}"),
        }
    }
}

/// A line, a paragraph or a table cell: a sequence of pieces. Spaces between pieces are part of them.
///
/// Built from a text and further pieces: `Inlines::from("feed ").quantity("0.25", "mm/rev").text(", see
/// ").code("feed-choice")`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inlines(Vec<Inline>);

impl Inlines {
    /// A sentence of the message catalogue, in which pairs of backticks mark code.
    pub fn sentence(text: &str) -> Self {
        let pieces: Vec<&str> = text.split('`').collect();
        if pieces.len().is_multiple_of(2) {
            return Self::from(text);
        }
        let piece = |(at, piece): (usize, &&str)| match at % 2 {
            0 => Inline::Text((*piece).to_owned()),
            _ => Inline::Code((*piece).to_owned()),
        };
        pieces.iter().enumerate().map(piece).collect()
    }

    /// A figure whose unit is in the column.
    pub fn number(number: impl Into<String>) -> Self {
        Self::default().quantity(number, "")
    }

    /// The figure that is all of the line, typed; none for words, and where more stands beside it.
    pub fn figure(&self) -> Option<(Decimal, &str)> {
        match self.0.as_slice() {
            [Inline::Quantity { value: Some(value), unit, .. }] => Some((*value, unit)),
            _ => None,
        }
    }

    /// Adds words.
    #[must_use]
    pub fn text(self, text: impl Into<String>) -> Self {
        self.with(Inline::Text(text.into()))
    }

    /// Adds emphasised words.
    #[must_use]
    pub fn strong(self, text: impl Into<String>) -> Self {
        self.with(Inline::Strong(text.into()))
    }

    /// Adds text to be copied exactly.
    #[must_use]
    pub fn code(self, text: impl Into<String>) -> Self {
        self.with(Inline::Code(text.into()))
    }

    /// Adds a figure with its unit.
    #[must_use]
    pub fn quantity(self, number: impl Into<String>, unit: impl Into<String>) -> Self {
        let number = number.into();
        // Typed by what is printed, so that no other figure can stand in a spreadsheet than on paper.
        let value = number.parse().ok();
        self.with(Inline::Quantity { number, unit: unit.into(), value })
    }

    /// Adds a link.
    #[must_use]
    pub fn link(self, text: impl Into<String>, to: impl Into<String>) -> Self {
        self.with(Inline::Link { text: text.into(), to: to.into() })
    }

    /// Adds all pieces of another line.
    #[must_use]
    pub fn append(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    /// Joins lines with a separator.
    pub fn joined(all: impl IntoIterator<Item = Self>, between: &str) -> Self {
        let mut joined = Self::default();
        for (at, line) in all.into_iter().enumerate() {
            joined = if at > 0 { joined.text(between).append(line) } else { line };
        }
        joined
    }

    /// The pieces, none of them empty.
    pub fn pieces(&self) -> &[Inline] {
        &self.0
    }

    /// The same, to be worded anew.
    pub(crate) fn pieces_mut(&mut self) -> &mut [Inline] {
        &mut self.0
    }

    /// Whether it has no text.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The text without formatting.
    pub fn plain(&self) -> String {
        self.0.iter().map(Inline::plain).collect()
    }

    fn with(mut self, piece: Inline) -> Self {
        // An empty piece has no text, and not every writer can mark it.
        if !piece.plain().is_empty() {
            self.0.push(piece);
        }
        self
    }
}

impl From<&str> for Inlines {
    fn from(text: &str) -> Self {
        Self::default().text(text)
    }
}

impl From<String> for Inlines {
    fn from(text: String) -> Self {
        Self::default().text(text)
    }
}

impl From<Inline> for Inlines {
    fn from(piece: Inline) -> Self {
        Self::default().with(piece)
    }
}

impl FromIterator<Inline> for Inlines {
    fn from_iter<T: IntoIterator<Item = Inline>>(pieces: T) -> Self {
        pieces.into_iter().fold(Self::default(), Self::with)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn backticks_of_a_sentence_mark_code() {
        let marked = Inlines::sentence("unknown key `rout`, maybe `route`?");
        assert_eq!(marked, Inlines::from("unknown key ").code("rout").text(", maybe ").code("route").text("?"));
        assert_eq!(Inlines::sentence("a ` b"), Inlines::from("a ` b"));
    }

    #[test]
    fn the_words_alone_are_read() {
        let line = Inlines::from("t = ").quantity("0,5", "мм").text("; ").strong("!").append("").link(" here", "a.md");
        assert_eq!(line.plain(), "t = 0,5 мм; ! here");
        assert_eq!(line.pieces().len(), 5);
        assert_eq!(Inlines::joined(["a".into(), "b".into()], ", ").plain(), "a, b");
    }
}
