//! What stands in a line.

/// A piece of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inline {
    /// Words.
    Text(String),
    /// Words that a reader should not overlook.
    Strong(String),
    /// What a user writes or reads letter by letter: a key, a path, a block of a program.
    Code(String),
    /// A figure and its unit, which stay on one line.
    Quantity {
        /// The figure as people of that language write it: `0,25`.
        number: String,
        /// Its unit; empty where a column has it, or where there is none.
        unit: String,
    },
    /// A way to another page.
    Link {
        /// What is read.
        text: String,
        /// Where it leads: an address or a path.
        to: String,
    },
}

impl Inline {
    /// The words alone.
    pub fn plain(&self) -> String {
        match self {
            Self::Text(text) | Self::Strong(text) | Self::Code(text) | Self::Link { text, .. } => text.clone(),
            Self::Quantity { number, unit } if unit.is_empty() => number.clone(),
            Self::Quantity { number, unit } => format!("{number} {unit}"),
        }
    }
}

/// A line, a paragraph or the cell of a table: pieces one after the other. Spaces between pieces are theirs.
///
/// It is made of a text, and goes on with what follows:
/// `Inlines::from("feed ").quantity("0.25", "mm/rev").text(", see ").code("feed-choice")`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inlines(Vec<Inline>);

impl Inlines {
    /// A sentence of the catalogue of words, in which pairs of backticks mark code.
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

    /// A figure in a column that has the unit.
    pub fn number(number: impl Into<String>) -> Self {
        Self::default().quantity(number, "")
    }

    /// And words.
    #[must_use]
    pub fn text(self, text: impl Into<String>) -> Self {
        self.with(Inline::Text(text.into()))
    }

    /// And words that should not be overlooked.
    #[must_use]
    pub fn strong(self, text: impl Into<String>) -> Self {
        self.with(Inline::Strong(text.into()))
    }

    /// And something written letter by letter.
    #[must_use]
    pub fn code(self, text: impl Into<String>) -> Self {
        self.with(Inline::Code(text.into()))
    }

    /// And a figure with its unit.
    #[must_use]
    pub fn quantity(self, number: impl Into<String>, unit: impl Into<String>) -> Self {
        self.with(Inline::Quantity { number: number.into(), unit: unit.into() })
    }

    /// And a way to another page.
    #[must_use]
    pub fn link(self, text: impl Into<String>, to: impl Into<String>) -> Self {
        self.with(Inline::Link { text: text.into(), to: to.into() })
    }

    /// And all of another line.
    #[must_use]
    pub fn then(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    /// Lines in one, with the same words between two.
    pub fn joined(all: impl IntoIterator<Item = Self>, between: &str) -> Self {
        let mut joined = Self::default();
        for (at, one) in all.into_iter().enumerate() {
            joined = if at > 0 { joined.text(between).then(one) } else { one };
        }
        joined
    }

    /// The pieces, none of them empty.
    pub fn pieces(&self) -> &[Inline] {
        &self.0
    }

    /// Whether there is nothing to read.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The words alone.
    pub fn plain(&self) -> String {
        self.0.iter().map(Inline::plain).collect()
    }

    fn with(mut self, piece: Inline) -> Self {
        // An empty piece is nothing to read, and not every writer can mark it.
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
        let line = Inlines::from("t = ").quantity("0,5", "мм").text("; ").strong("!").then("").link(" here", "a.md");
        assert_eq!(line.plain(), "t = 0,5 мм; ! here");
        assert_eq!(line.pieces().len(), 5);
        assert_eq!(Inlines::joined(["a".into(), "b".into()], ", ").plain(), "a, b");
    }
}
