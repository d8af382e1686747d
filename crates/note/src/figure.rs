//! The figures of a sentence. Each figure knows its kind, so that no printer must guess from its text.

use std::borrow::Cow;
use std::cmp::Ordering;

use super::Note;

/// A figure of a [`Note`].
#[derive(Clone, Debug)]
pub enum Figure {
    /// A designation, the name of a table, text of the user: the same in every language.
    Text(Cow<'static, str>),
    /// A decimal number with a point; each language has its own separator.
    Number(Cow<'static, str>),
    /// A word of the program, translated.
    Word(Word),
    /// Several figures, with a separator.
    List(Vec<Figure>, &'static str),
    /// A sentence within the sentence.
    Note(Box<Note>),
    /// A name from a table, such as that of a column.
    Named(Named),
    /// A name that the user gave, such as that of a group of holes: in a sentence it could be taken for a word of it.
    Called(String),
    /// A remark of a table row, in English; languages have translations.
    Remark(String),
    /// Read back from JSON, which does not tell the kind of a figure.
    Stored(String),
}

/// A word of the program: the vocabulary it belongs to, and its id there.
#[derive(Clone, Debug)]
pub struct Word {
    /// The first part of the message's name: `operation`, `word`.
    pub vocabulary: &'static str,
    /// The id, as plans and tables write it.
    pub id: Cow<'static, str>,
}

/// A name from a table, given in the languages of the table.
#[derive(Clone, Debug)]
pub struct Named {
    /// The vocabulary and id for a language that the table lacks.
    pub word: Word,
    /// The name by language tag. The last one serves all other languages.
    pub names: Vec<(&'static str, String)>,
}

impl Figure {
    /// A number with `decimals` decimal places.
    pub fn fixed(value: f64, decimals: usize) -> Self {
        Self::Number(format!("{value:.decimals$}").into())
    }

    /// A number that is already written.
    pub fn number(written: impl Into<Cow<'static, str>>) -> Self {
        Self::Number(written.into())
    }

    /// A word of the general vocabulary, such as the name of a bound or of a scheme.
    pub fn word(id: impl Into<Cow<'static, str>>) -> Self {
        Self::word_of("word", id)
    }

    /// A word of another vocabulary.
    pub fn word_of(vocabulary: &'static str, id: impl Into<Cow<'static, str>>) -> Self {
        Self::Word(Word { vocabulary, id: id.into() })
    }

    /// The name of an operation.
    pub fn operation(id: impl Into<Cow<'static, str>>) -> Self {
        Self::word_of("operation", id)
    }

    /// The name of a scheme: a designation of a table, or the transitions that a search found.
    pub fn scheme(name: &str) -> Self {
        Self::List(name.split(" + ").map(|part| Self::operation(part.to_owned())).collect(), " + ")
    }

    /// A name that the user gave.
    pub fn called(name: &str) -> Self {
        Self::Called(name.to_owned())
    }

    /// Names of operations with a comma between them.
    pub fn operations<'o>(ids: impl IntoIterator<Item = &'o str>) -> Self {
        Self::list(ids.into_iter().map(|id| Self::operation(id.to_owned())))
    }

    /// Words of the general vocabulary with a plus between them.
    pub fn sum_of_words<'w>(ids: impl IntoIterator<Item = &'w str>) -> Self {
        Self::List(ids.into_iter().map(|id| Self::word(id.to_owned())).collect(), " + ")
    }

    /// Several with a comma between them.
    pub fn list(parts: impl IntoIterator<Item = Self>) -> Self {
        Self::List(parts.into_iter().collect(), ", ")
    }

    /// As machines read it: ids of words, numbers with a point.
    pub fn text(&self) -> Cow<'_, str> {
        match self {
            Self::Text(text) | Self::Number(text) | Self::Word(Word { id: text, .. }) => Cow::Borrowed(text),
            Self::Named(named) => Cow::Borrowed(&named.word.id),
            Self::List(parts, between) => {
                parts.iter().map(|part| part.text().into_owned()).collect::<Vec<_>>().join(between).into()
            }
            Self::Note(note) => note.to_string().into(),
            Self::Stored(text) | Self::Remark(text) | Self::Called(text) => Cow::Borrowed(text),
        }
    }
}

// Two figures are equal if machines read the same.
impl PartialEq for Figure {
    fn eq(&self, other: &Self) -> bool {
        self.text() == other.text()
    }
}

impl Eq for Figure {}

impl PartialOrd for Figure {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Figure {
    fn cmp(&self, other: &Self) -> Ordering {
        self.text().cmp(&other.text())
    }
}

/// A value that can be a figure of a sentence.
pub trait IntoFigure {
    /// The figure.
    fn into_figure(self) -> Figure;
}

impl IntoFigure for Figure {
    fn into_figure(self) -> Figure {
        self
    }
}

impl<T: IntoFigure + Clone> IntoFigure for &T {
    fn into_figure(self) -> Figure {
        self.clone().into_figure()
    }
}

impl IntoFigure for &str {
    fn into_figure(self) -> Figure {
        Figure::Text(self.to_owned().into())
    }
}

impl IntoFigure for String {
    fn into_figure(self) -> Figure {
        Figure::Text(self.into())
    }
}

impl IntoFigure for Cow<'static, str> {
    fn into_figure(self) -> Figure {
        Figure::Text(self)
    }
}

impl IntoFigure for std::sync::Arc<str> {
    fn into_figure(self) -> Figure {
        (&*self).into_figure()
    }
}

impl IntoFigure for std::path::Display<'_> {
    fn into_figure(self) -> Figure {
        self.to_string().into_figure()
    }
}

impl IntoFigure for Note {
    fn into_figure(self) -> Figure {
        Figure::Note(Box::new(self))
    }
}

/// Types whose text is a decimal number.
#[macro_export]
macro_rules! told_as_number {
    ($($number:ty),+) => {
        $(impl $crate::IntoFigure for $number {
            fn into_figure(self) -> $crate::Figure {
                $crate::Figure::Number(self.to_string().into())
            }
        })+
    };
}

/// Types whose text is the same in every language.
#[macro_export]
macro_rules! told_as_text {
    ($($text:ty),+) => {
        $(impl $crate::IntoFigure for $text {
            fn into_figure(self) -> $crate::Figure {
                $crate::Figure::Text(self.to_string().into())
            }
        })+
    };
}

told_as_number!(u8, u16, u32, u64, usize, i32, i64, f64);
told_as_text!(char);
