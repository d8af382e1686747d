//! Sentences as data: a code and its figures. The words are in one place, the message catalogue of the crate `words`.
//!
//! A note is written and printed, never read by code: planning, checks and audits decide by types, and notes are made
//! of them at the end. `clippy.toml` forbids the methods that read code and figures, except where words are made of
//! them.

mod figure;

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub use figure::{Figure, IntoFigure, Named, Word};

/// A sentence of the program, independent of language: its code and its figures.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
pub struct Note {
    /// Stable id, kebab-case.
    code: Cow<'static, str>,
    /// Its figures and names, each with its unit where it has one.
    #[serde(default, skip_serializing_if = "Params::is_empty")]
    #[schemars(with = "BTreeMap<String, StoredFigure>")]
    params: Params,
}

/// Figures by name, in the order of the names; most names are static.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Params(Vec<(Cow<'static, str>, Figure)>);

impl Params {
    const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn at(&self, name: &str) -> Result<usize, usize> {
        self.0.binary_search_by(|(known, _)| (**known).cmp(name))
    }

    fn get(&self, name: &str) -> Option<&Figure> {
        self.at(name).ok().map(|at| &self.0[at].1)
    }

    fn insert(&mut self, name: Cow<'static, str>, value: Figure) {
        match self.at(&name) {
            Ok(at) => self.0[at].1 = value,
            Err(at) => self.0.insert(at, (name, value)),
        }
    }

    fn iter(&self) -> impl Iterator<Item = (&str, &Figure)> {
        self.0.iter().map(|(name, value)| (&**name, value))
    }
}

/// A figure in JSON: its text, or the sentence inside the sentence.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
enum StoredFigure<'n> {
    Text(Cow<'n, str>),
    Note(Cow<'n, Note>),
}

impl Serialize for Params {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter().map(|(name, figure)| {
            let stored = match figure {
                Figure::Note(note) => StoredFigure::Note(Cow::Borrowed(note)),
                figure => StoredFigure::Text(figure.text()),
            };
            (name, stored)
        }))
    }
}

impl<'de> Deserialize<'de> for Params {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let map = BTreeMap::<String, StoredFigure<'_>>::deserialize(deserializer)?;
        let figure = |stored| match stored {
            StoredFigure::Text(text) => Figure::Stored(text.into_owned()),
            StoredFigure::Note(note) => Figure::Note(Box::new(note.into_owned())),
        };
        Ok(Self(map.into_iter().map(|(name, stored)| (Cow::Owned(name), figure(stored))).collect()))
    }
}

/// A sentence with its figures: `note!("unknown-key", key = &key.text)`.
#[macro_export]
macro_rules! note {
    ($code:expr $(, $name:ident = $value:expr)* $(,)?) => {
        $crate::Note::new($code)$(.with(stringify!($name), &$value))*
    };
}

/// A message from outside, such as the system's about a file: it has no words in the catalogue.
impl From<String> for Note {
    fn from(text: String) -> Self {
        Self::new("verbatim").with("text", text)
    }
}

/// Text that is already in the language of the reader.
impl From<&str> for Note {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<std::num::ParseIntError> for Note {
    fn from(_: std::num::ParseIntError) -> Self {
        Self::new("unit-no-whole-number")
    }
}

/// For machines and builds: `code (name = value, …)`.
impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.code)?;
        for (index, (name, figure)) in self.params.iter().enumerate() {
            write!(f, "{}{name} = {}", if index == 0 { " (" } else { ", " }, figure.text())?;
        }
        if self.params.is_empty() { Ok(()) } else { f.write_str(")") }
    }
}

impl Note {
    /// A sentence without figures.
    pub fn new(code: impl Into<Cow<'static, str>>) -> Self {
        Self { code: code.into(), params: Params::default() }
    }

    /// Whether it says nothing, as in a command's answer that only names a row.
    pub fn is_empty(&self) -> bool {
        self.code.is_empty()
    }

    /// Adds a figure.
    #[must_use]
    pub fn with(mut self, name: impl Into<Cow<'static, str>>, value: impl IntoFigure) -> Self {
        self.params.insert(name.into(), value.into_figure());
        self
    }

    /// Removes a figure, so that several notes may become equal.
    #[must_use]
    pub fn without(mut self, name: &str) -> Self {
        if let Ok(at) = self.params.at(name) {
            self.params.0.remove(at);
        }
        self
    }

    /// Merges notes that differ only in the figures of these names: each becomes a list of all, each figure once.
    pub fn join(&mut self, others: &[Self], listed: &[&str]) {
        for name in listed {
            let Ok(at) = self.params.at(name) else { continue };
            let known = &mut self.params.0[at].1;
            let mut parts = match &*known {
                Figure::List(parts, ", ") => parts.clone(),
                one => vec![one.clone()],
            };
            let before = parts.len();
            let mut seen: BTreeSet<String> = parts.iter().map(|part| part.text().into_owned()).collect();
            let others = others.iter().filter_map(|other| other.params.get(name));
            parts.extend(others.filter(|part| seen.insert(part.text().into_owned())).cloned());
            if parts.len() > before {
                *known = Figure::list(parts);
            }
        }
    }

    /// The order of findings of one code: by their tables, then by rows.
    pub fn in_order(&self, other: &Self) -> std::cmp::Ordering {
        let table = |note: &Self| note.params.get("table").cloned();
        let row = |note: &Self| note.params.get("row").and_then(|row| row.text().parse::<usize>().ok());
        let place = |note: &Self| (table(note), row(note));
        self.code.cmp(&other.code).then_with(|| place(self).cmp(&place(other))).then_with(|| self.cmp(other))
    }

    /// Its code, for the words of it; nothing may be decided by it.
    pub fn code(&self) -> &str {
        &self.code
    }

    /// A figure of it, for the words of it; nothing may be decided by it.
    pub fn figure(&self, name: &str) -> Option<&Figure> {
        self.params.get(name)
    }

    /// A figure of it as machines read it; nothing may be decided by it.
    pub fn figure_text(&self, name: &str) -> Option<String> {
        self.params.get(name).map(|figure| figure.text().into_owned())
    }

    /// Its figures by their names, for the words of it; nothing may be decided by them.
    pub fn figures(&self) -> impl Iterator<Item = (&str, &Figure)> {
        self.params.iter()
    }
}
