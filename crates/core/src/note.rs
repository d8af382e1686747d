//! Sentences as data: a code and its parameters. The words stand in one place, `sentences` of the
//! crate `pages`.
//!
//! A note is written and told, never read: what planning, checks and audits go by are types, such as
//! [`crate::reason::Reason`], of which a note is made last. Code and figures are private, and `clippy.toml` forbids the
//! methods that read them everywhere but where words are made of them.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub use crate::knowledge::vocabulary::Severity;

use crate::knowledge::{Answer, RowRef, Source, Table};

/// A sentence of the program in no language: what it says, and its figures.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
pub struct Note {
    /// Stable id, kebab-case.
    code: Cow<'static, str>,
    /// Its figures and names, each with its unit where it has one.
    #[serde(default, skip_serializing_if = "Params::is_empty")]
    #[schemars(with = "BTreeMap<String, String>")]
    params: Params,
}

/// Figures by their names, in the order of the names: a map whose names are for the most part those of the code.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Params(Vec<(Cow<'static, str>, String)>);

impl Params {
    const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn at(&self, name: &str) -> Result<usize, usize> {
        self.0.binary_search_by(|(known, _)| (**known).cmp(name))
    }

    fn get(&self, name: &str) -> Option<&String> {
        self.at(name).ok().map(|at| &self.0[at].1)
    }

    fn get_mut(&mut self, name: &str) -> Option<&mut String> {
        self.at(name).ok().map(|at| &mut self.0[at].1)
    }

    fn insert(&mut self, name: Cow<'static, str>, value: String) {
        match self.at(&name) {
            Ok(at) => self.0[at].1 = value,
            Err(at) => self.0.insert(at, (name, value)),
        }
    }

    fn remove(&mut self, name: &str) {
        if let Ok(at) = self.at(name) {
            self.0.remove(at);
        }
    }

    fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(name, value)| (&**name, value.as_str()))
    }
}

impl Serialize for Params {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter())
    }
}

impl<'de> Deserialize<'de> for Params {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let map = BTreeMap::<String, String>::deserialize(deserializer)?;
        Ok(Self(map.into_iter().map(|(name, value)| (Cow::Owned(name), value)).collect()))
    }
}

impl Note {
    /// A sentence without figures.
    pub fn new(code: impl Into<Cow<'static, str>>) -> Self {
        Self { code: code.into(), params: Params::default() }
    }

    /// Whether it says nothing: in the answer of a command that names only a row.
    pub fn is_empty(&self) -> bool {
        self.code.is_empty()
    }

    /// With one more figure.
    #[must_use]
    pub fn with(mut self, name: impl Into<Cow<'static, str>>, value: impl ToString) -> Self {
        self.params.insert(name.into(), value.to_string());
        self
    }

    /// Without a figure: what is left is the same of several.
    #[must_use]
    pub fn without(mut self, name: &str) -> Self {
        self.params.remove(name);
        self
    }

    /// Takes in another note that differs in nothing but the figures of these names: each becomes a list of both. Whether
    /// it does.
    pub fn join(&mut self, other: &Self, listed: &[&str]) -> bool {
        let unlisted = |(name, _): &(&str, &str)| !listed.contains(name);
        let alike = self.params.iter().filter(unlisted).eq(other.params.iter().filter(unlisted));
        if self.code != other.code || !alike {
            return false;
        }
        for name in listed {
            if let (Some(values), Some(value)) = (self.params.get_mut(name), other.params.get(name))
                && !values.split(", ").any(|known| known == value)
            {
                values.push_str(", ");
                values.push_str(value);
            }
        }
        true
    }

    /// Its code, for the words of it; nothing may be decided by it.
    pub fn code(&self) -> &str {
        &self.code
    }

    /// A figure of it, for the words of it; nothing may be decided by it.
    pub fn figure(&self, name: &str) -> Option<&str> {
        self.params.get(name).map(String::as_str)
    }

    /// Its figures by their names, for the words of it; nothing may be decided by them.
    pub fn figures(&self) -> impl Iterator<Item = (&str, &str)> {
        self.params.iter()
    }
}

/// That a row is not confirmed, as a finding about the whole part; none where it is.
pub fn doubtful_row(row: RowRef<'_>) -> Option<Finding> {
    let doubt = Because::row(row, Note::new("unconfirmed")).doubt()?;
    Some(Finding::of_part(Severity::Doubtful, doubt))
}

/// Something about a plan that its reader must know.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Finding {
    /// How grave.
    pub severity: Severity,
    /// The group of holes it is about; absent: the whole part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hole: Option<String>,
    /// What it says.
    #[serde(flatten)]
    pub note: Note,
}

impl Finding {
    /// A finding about a group of holes.
    pub fn of_hole(severity: Severity, hole: &str, note: Note) -> Self {
        Self { severity, hole: Some(hole.to_owned()), note }
    }

    /// A finding about the whole part.
    pub fn of_part(severity: Severity, note: Note) -> Self {
        Self { severity, hole: None, note }
    }

    /// Puts findings in the order in which they are told, each once: the gravest first, those of a hole together, those of
    /// one table by their rows.
    pub fn in_order(findings: &mut Vec<Self>) {
        findings.sort_by(|a, b| {
            let of = |name: &str| [a, b].map(|one| one.note.params.get(name));
            let ([table, other_table], rows) = (of("table"), of("row"));
            let [row, other_row] = rows.map(|row| row.and_then(|row| row.parse::<usize>().ok()));
            (a.severity, &a.hole, &a.note.code, table, row, &a.note).cmp(&(
                b.severity,
                &b.hole,
                &b.note.code,
                other_table,
                other_row,
                &b.note,
            ))
        });
        findings.dedup();
    }
}

/// Why something was decided: the row it rests on, and what was passed over.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Because {
    /// The table.
    pub table: String,
    /// The number of the row, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub row: Option<usize>,
    /// Where the row's figures come from: `seed`, `standard` or `reconstructed`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<Source>,
    /// Where it stands.
    pub place: String,
    /// From what the row was inferred, where it was.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// Why the row is not fully trusted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unconfirmed: Option<String>,
    /// What was decided.
    #[serde(flatten)]
    pub note: Note,
    /// What was considered and not taken, each with its reason.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rejected: Vec<Note>,
}

impl Because {
    /// A decision that rests on a row.
    pub fn row(row: RowRef<'_>, note: Note) -> Self {
        let content = row.row();
        Self {
            table: row.table.id.clone(),
            row: Some(row.number()),
            source: Some(content.source),
            place: row.place().to_owned(),
            reason: content.reason.clone(),
            unconfirmed: content.unconfirmed.clone(),
            note,
            rejected: Vec::new(),
        }
    }

    /// A decision that rests on the answer of a decision table: its winner, and the rejected rows by the
    /// first column that failed.
    pub fn answer(answer: &Answer<'_>, note: Note) -> Self {
        let mut by_column: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (row, column) in answer.rejected() {
            by_column.entry(&column.name).or_default().push(row.number());
        }
        let rejected = by_column
            .into_iter()
            .map(|(column, rows)| Note::new("rows-rejected").with("column", column).with("rows", runs(&rows)))
            .collect();
        match answer.winner() {
            Some(row) => Self::row(row, note).over(rejected),
            None => Self::table(answer.table(), note).over(rejected),
        }
    }

    /// A decision that rests on a whole table, such as that it has no row.
    pub fn table(table: &Table, note: Note) -> Self {
        Self {
            table: table.id.clone(),
            row: None,
            source: None,
            place: table.place.clone(),
            reason: None,
            unconfirmed: None,
            note,
            rejected: Vec::new(),
        }
    }

    /// With what was passed over.
    #[must_use]
    pub fn over(mut self, rejected: Vec<Note>) -> Self {
        self.rejected = rejected;
        self
    }

    /// That the row is not confirmed, and why; none where it is.
    pub fn doubt(&self) -> Option<Note> {
        let why = self.unconfirmed.as_ref()?;
        let row = self.row.map_or_else(|| "-".to_owned(), |row| row.to_string());
        Some(Note::new("unconfirmed").with("table", &self.table).with("row", row).with("why", why))
    }

    /// Whether the row was inferred or is not fully trusted.
    pub fn is_doubtful(&self) -> bool {
        self.unconfirmed.is_some() || self.source == Some(Source::Reconstructed)
    }
}

/// Row numbers with runs drawn together: `1-3, 5`.
fn runs(rows: &[usize]) -> String {
    let runs: Vec<String> = rows
        .chunk_by(|a, b| a + 1 == *b)
        .map(|run| match run {
            [one] => one.to_string(),
            _ => format!("{}-{}", run[0], run[run.len() - 1]),
        })
        .collect();
    runs.join(", ")
}
