//! The blocks of a page.

use crate::{Form, Inlines};

/// A page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// The language as a BCP 47 tag: `uk`, `en`.
    pub lang: String,
    /// The title: the first heading, and the name of the page in a browser.
    pub title: Inlines,
    /// Its contents.
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

    /// Adds a paragraph, unless it is empty.
    pub fn paragraph(&mut self, words: impl Into<Inlines>) {
        let words = words.into();
        if !words.is_empty() {
            self.blocks.push(Block::Paragraph(words));
        }
    }
}

/// A block of a page, over its full width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// A heading. The title of the page is level 1, its sections are 2, their parts 3 and more.
    Heading {
        /// 1 to 6; what is more is written as 6.
        level: u8,
        /// Its text.
        words: Inlines,
    },
    /// A paragraph.
    Paragraph(Inlines),
    /// An unordered list.
    List(Vec<Item>),
    /// A table.
    Table(Table),
    /// A finding. Successive findings are written as a list.
    Finding(FindingBlock),
    /// A drawing.
    Drawing(Drawing),
    /// Lines that are never broken, such as a program.
    Code(String),
    /// Labels, each with its value.
    Fields(Vec<Field>),
    /// A sheet of a form, on a page of its own.
    Form(Form),
}

/// A line of a list, with lines under it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Item {
    /// Its text.
    pub words: Inlines,
    /// Its details.
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
    /// The label; writers add the colon.
    pub label: Inlines,
    /// The value.
    pub value: Inlines,
}

impl Field {
    /// A label with its value.
    pub fn new(label: impl Into<Inlines>, value: impl Into<Inlines>) -> Self {
        Self { label: label.into(), value: value.into() }
    }
}

/// The severity of a finding. It decides only the colour: pages also write the word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Impossible to make, or dangerous.
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

    /// Its colour on paper, as `#rrggbb`: dark enough to be read on white.
    pub const fn colour(self) -> &'static str {
        match self {
            Self::Error => "#b3261e",
            Self::Wrong => "#b45309",
            Self::Doubtful => "#52606d",
            Self::Note => "#2f6f4f",
        }
    }
}

/// A finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FindingBlock {
    /// How bad it is.
    pub severity: Severity,
    /// The word for the severity in the language of the page, without a colon, or a mark such as `*`.
    pub word: String,
    /// Its place in a file: `13:47`.
    pub place: Option<String>,
    /// Its text.
    pub words: Inlines,
    /// Its basis and its consequences, a line each.
    pub details: Vec<Inlines>,
    /// The remedy.
    pub help: Option<Inlines>,
}

impl FindingBlock {
    /// The prefix on every page: a word with a colon, or the mark alone.
    pub fn label(&self) -> String {
        let colon = if self.word.ends_with(char::is_alphanumeric) { ":" } else { "" };
        format!("{}{colon}", self.word)
    }

    /// A finding with only its text.
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
    /// The caption below it.
    pub caption: Inlines,
    /// A description for people who cannot see it: text on a terminal shows nothing else.
    pub alternative: String,
}

/// The alignment of a column's cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// For words.
    Left,
    /// For figures, so that units are under units.
    Right,
}

/// Whether a column may be left out of a table that is too wide; in the order of importance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Keep {
    /// Never left out: the row means nothing without it.
    Always,
    /// Left out last, when all `Optional` columns are gone.
    Useful,
    /// Left out first.
    Optional,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// The heading of its cells.
    pub heading: Inlines,
    /// The unit of its cells, written after the heading; empty for none.
    pub unit: String,
    /// The alignment of its cells.
    pub align: Align,
    /// Whether it may be left out where the table is too wide.
    pub keep: Keep,
    /// The least width after wrapping, in terminal columns.
    pub min_width: usize,
}

impl Column {
    /// A column of words. Its cells are wrapped to no less than 12 columns of a terminal.
    pub fn text(heading: impl Into<Inlines>) -> Self {
        Self { heading: heading.into(), unit: String::new(), align: Align::Left, keep: Keep::Always, min_width: 12 }
    }

    /// A column of figures in a unit, which may be empty. Only its heading is wrapped.
    pub fn number(heading: impl Into<Inlines>, unit: impl Into<String>) -> Self {
        Self { unit: unit.into(), align: Align::Right, min_width: 0, ..Self::text(heading) }
    }

    /// It may be left out.
    #[must_use]
    pub fn keep(self, keep: Keep) -> Self {
        Self { keep, ..self }
    }

    /// It is not made narrower than this by wrapping.
    #[must_use]
    pub fn min_width(self, least: usize) -> Self {
        Self { min_width: least, ..self }
    }

    /// Heading and unit.
    pub fn head(&self) -> Inlines {
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
    /// Notes under it, a paragraph each.
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

    /// Columns and rows, to be worded anew.
    pub(crate) fn parts_mut(&mut self) -> (&mut [Column], &mut [Vec<Inlines>]) {
        (&mut self.columns, &mut self.rows)
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Whether any column has a heading.
    pub fn has_head(&self) -> bool {
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

blocks!(Form(Form), Table(Table), Finding(FindingBlock), Drawing(Drawing));
