//! The blocks of a page.

use crate::Inlines;

/// A page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// The language as BCP 47 has it: `uk`, `en`.
    pub lang: String,
    /// The title: the first heading, and the name of the page in a browser.
    pub title: Inlines,
    /// What it says.
    pub blocks: Vec<Block>,
}

impl Document {
    /// A page without blocks.
    pub fn new(lang: impl Into<String>, title: impl Into<Inlines>) -> Self {
        Self { lang: lang.into(), title: title.into(), blocks: Vec::new() }
    }

    /// Adds a block.
    pub fn push(&mut self, block: impl Into<Block>) {
        self.blocks.push(block.into());
    }

    /// Adds a heading of a section, 2, or of a part of one, 3 and more.
    pub fn heading(&mut self, level: u8, words: impl Into<Inlines>) {
        self.blocks.push(Block::Heading { level, words: words.into() });
    }

    /// Adds a paragraph; none for no words.
    pub fn paragraph(&mut self, words: impl Into<Inlines>) {
        let words = words.into();
        if !words.is_empty() {
            self.blocks.push(Block::Paragraph(words));
        }
    }
}

/// A part of a page, from its margin to its margin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// A heading. The title of the page is level 1, its sections are 2, their parts 3 and more.
    Heading {
        /// 1 to 6; what is more is written as 6.
        level: u8,
        /// What it says.
        words: Inlines,
    },
    /// A paragraph.
    Paragraph(Inlines),
    /// A list without an order.
    List(Vec<Item>),
    /// A table.
    Table(Table),
    /// Something found wrong, or worth knowing. Findings one after the other are written as a list.
    Finding(FindingBlock),
    /// A drawing.
    Drawing(Drawing),
    /// Lines that are never broken, such as a program.
    Code(String),
    /// Labels, each with its value.
    Fields(Vec<Field>),
}

/// A line of a list, and lines under it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Item {
    /// What it says.
    pub words: Inlines,
    /// What it rests on, or is made of.
    pub items: Vec<Item>,
}

impl<T: Into<Inlines>> From<T> for Item {
    fn from(words: T) -> Self {
        Self { words: words.into(), items: Vec::new() }
    }
}

/// A label with its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// What it is; writers put the colon.
    pub label: Inlines,
    /// What is to be said of it.
    pub value: Inlines,
}

impl Field {
    /// A label with its value.
    pub fn new(label: impl Into<Inlines>, value: impl Into<Inlines>) -> Self {
        Self { label: label.into(), value: value.into() }
    }
}

/// How bad a finding is. It decides the colour only: pages say the word, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// It cannot be made, or breaks something.
    Error,
    /// A figure or a choice is wrong.
    Wrong,
    /// It may be wrong, or rests on something unconfirmed.
    Doubtful,
    /// Only worth knowing.
    Note,
}

impl Severity {
    /// The name of its class in HTML.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Wrong => "wrong",
            Self::Doubtful => "doubtful",
            Self::Note => "note",
        }
    }
}

/// Something found wrong, or worth knowing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FindingBlock {
    /// How bad it is.
    pub severity: Severity,
    /// The word for that in the language of the page, without a colon, or a mark such as `*`.
    pub word: String,
    /// Where in a file it is: `13:47`.
    pub place: Option<String>,
    /// What is found.
    pub words: Inlines,
    /// What it rests on and what follows, a line each.
    pub details: Vec<Inlines>,
    /// What helps against it.
    pub help: Option<Inlines>,
}

impl FindingBlock {
    /// What stands before it on every page: a word with a colon, or the mark alone.
    pub(crate) fn label(&self) -> String {
        let colon = if self.word.ends_with(char::is_alphanumeric) { ":" } else { "" };
        format!("{}{colon}", self.word)
    }

    /// A finding with nothing but what is found.
    pub fn new(severity: Severity, word: impl Into<String>, words: impl Into<Inlines>) -> Self {
        let (word, words) = (word.into(), words.into());
        Self { severity, word, place: None, words, details: Vec::new(), help: None }
    }
}

/// A drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawing {
    /// The drawing itself, a whole SVG file.
    pub svg: String,
    /// What stands below it.
    pub caption: Inlines,
    /// What it shows, for those who do not see it: text on a terminal shows nothing else.
    pub alternative: String,
}

/// Where the cells of a column stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Words.
    Left,
    /// Figures, so that units stand under units.
    Right,
}

/// Whether a column may be left out where a table is too wide. What may be left out longest stands first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Keep {
    /// Never: the row means nothing without it.
    Always,
    /// Last, when all columns of `Optional` are gone.
    Useful,
    /// First.
    Optional,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// What its cells are.
    pub heading: Inlines,
    /// The unit of its cells, written after the heading; empty for none.
    pub unit: String,
    /// Where its cells stand.
    pub align: Align,
    /// Whether it may be left out where the table is too wide.
    pub keep: Keep,
    /// Narrower than this, in columns of a terminal, it is not made by wrapping its cells.
    pub least: usize,
}

impl Column {
    /// A column of words. Its cells are wrapped to no less than 12 columns of a terminal.
    pub fn text(heading: impl Into<Inlines>) -> Self {
        Self { heading: heading.into(), unit: String::new(), align: Align::Left, keep: Keep::Always, least: 12 }
    }

    /// A column of figures in a unit, which may be empty. Only its heading is wrapped.
    pub fn number(heading: impl Into<Inlines>, unit: impl Into<String>) -> Self {
        Self { unit: unit.into(), align: Align::Right, least: 0, ..Self::text(heading) }
    }

    /// It may be left out.
    #[must_use]
    pub fn keep(self, keep: Keep) -> Self {
        Self { keep, ..self }
    }

    /// It is not made narrower than this by wrapping.
    #[must_use]
    pub fn least(self, least: usize) -> Self {
        Self { least, ..self }
    }

    /// Heading and unit.
    pub(crate) fn head(&self) -> Inlines {
        let unit = &self.unit;
        match (self.heading.is_empty(), unit.is_empty()) {
            (_, true) => self.heading.clone(),
            (true, false) => unit.as_str().into(),
            (false, false) => self.heading.clone().text(format!(", {unit}")),
        }
    }
}

/// A table. Without any heading it is only rows in columns.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    columns: Vec<Column>,
    rows: Vec<Vec<Inlines>>,
    /// What is to be said under it, a paragraph each.
    pub notes: Vec<Inlines>,
}

impl Table {
    /// A table without rows.
    pub fn new(columns: impl IntoIterator<Item = Column>) -> Self {
        Self { columns: columns.into_iter().collect(), ..Self::default() }
    }

    /// Adds a row. Missing cells are empty; cells beyond the last column get columns without headings.
    pub fn row<T: Into<Inlines>>(&mut self, cells: impl IntoIterator<Item = T>) {
        let mut row: Vec<Inlines> = cells.into_iter().map(Into::into).collect();
        while self.columns.len() < row.len() {
            self.columns.push(Column::text(""));
            self.rows.iter_mut().for_each(|row| row.push(Inlines::default()));
        }
        row.resize(self.columns.len(), Inlines::default());
        self.rows.push(row);
    }

    /// Its columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Its rows, each with a cell for every column.
    pub fn rows(&self) -> &[Vec<Inlines>] {
        &self.rows
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Whether any column has a heading.
    pub(crate) fn has_head(&self) -> bool {
        self.columns.iter().any(|column| !column.head().is_empty())
    }
}

macro_rules! blocks {
    ($($variant:ident($kind:ident)),*) => {$(
        impl From<$kind> for Block {
            fn from(block: $kind) -> Self {
                Self::$variant(block)
            }
        }
    )*};
}

blocks!(Table(Table), Finding(FindingBlock), Drawing(Drawing));
