//! Typed columns: the content of a cell, its unit, and its order.

use serde::{Deserialize, Serialize};
use technolog_note::{Figure, Named, Note, Word, note};

use crate::diagnostic::Place;
use crate::set::Set;
use crate::units::{Decimal, ItGrade, Micrometres, Roughness, Unit};
use crate::value::Value;

/// The type of the cells of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ColumnType {
    /// Any text.
    Text,
    /// A unit of measurement, for another value in the row.
    Unit,
    /// One of the column's values.
    Enum,
    /// Yes or no.
    Bool,
    /// A whole number.
    Int,
    /// A decimal.
    Number,
    /// A length, exact to the micrometre.
    Length,
    /// An angle in degrees.
    Angle,
    /// A tolerance grade.
    It,
    /// A roughness limit.
    Roughness,
}

impl ColumnType {
    /// Every type with its name in a table file.
    pub const NAMES: [(&'static str, Self); 10] = [
        ("text", Self::Text),
        ("unit", Self::Unit),
        ("enum", Self::Enum),
        ("bool", Self::Bool),
        ("int", Self::Int),
        ("number", Self::Number),
        ("length", Self::Length),
        ("angle", Self::Angle),
        ("it", Self::It),
        ("roughness", Self::Roughness),
    ];

    /// Its name in a table file.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, ty)| *ty == self).map_or("", |(name, _)| name)
    }

    /// Whether cells are ordered, so that intervals make sense.
    pub const fn is_ordered(self) -> bool {
        matches!(self, Self::Int | Self::Number | Self::Length | Self::Angle | Self::It | Self::Roughness)
    }

    /// The unit of a column that names none; `None` if the column must name one.
    pub const fn default_unit(self) -> Option<Unit> {
        match self {
            Self::Number | Self::Length => None,
            Self::Angle => Some(Unit::Degree),
            Self::Roughness => Some(Unit::Micrometre),
            _ => Some(Unit::None),
        }
    }

    /// Whether a column of this type may be written in that unit.
    pub const fn accepts(self, unit: Unit) -> bool {
        match self {
            Self::Length => matches!(unit, Unit::Millimetre | Unit::Micrometre),
            Self::Angle => matches!(unit, Unit::Degree),
            Self::Roughness => matches!(unit, Unit::Micrometre),
            Self::Number | Self::Int => true,
            _ => matches!(unit, Unit::None),
        }
    }
}

/// What a column is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ColumnRole {
    /// A field of a catalog.
    Field,
    /// An input of a decision table; its cells are tests.
    Input,
    /// An output of a decision table.
    Output,
}

/// A name in both languages.
#[derive(Clone, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Label {
    /// Ukrainian.
    pub uk: String,
    /// English.
    pub en: String,
}

impl Label {
    /// The name in the language of that tag; English for languages that tables do not have.
    pub fn text(&self, tag: &str) -> &str {
        if tag == "uk" { &self.uk } else { &self.en }
    }
}

/// One column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Its name in queries, snake_case.
    pub name: String,
    /// The type of its cells.
    pub ty: ColumnType,
    /// The unit of its cells.
    pub unit: Unit,
    /// The letter that the source uses.
    pub symbol: Option<String>,
    /// Its name for people, where the plain name is not enough.
    pub label: Option<Label>,
    /// Field, input or output.
    pub role: ColumnRole,
    /// Whether a cell holds a list.
    pub list: bool,
    /// Whether a row may leave it out.
    pub optional: bool,
    /// The values of an enum, in order; those of its vocabulary first.
    pub values: Vec<String>,
    /// The names of the first values for people, where they are of a vocabulary that names its words.
    pub names: Vec<Label>,
    /// The vocabulary its values are of, where the column names one.
    pub vocabulary: Option<String>,
    /// The permitted values of a cell or an input.
    pub domain: Option<Set>,
    /// The domain as written.
    pub domain_text: Option<String>,
    /// The value of an input that a query does not name.
    pub default: Option<Value>,
    /// The table and column whose values these must be.
    pub refers: Option<(String, String)>,
    /// Where it is declared; only when read from YAML.
    #[serde(skip)]
    pub place: Option<Place>,
}

impl Column {
    /// Its name in sentences: the one from its table, otherwise the one from the message catalogue.
    pub fn named(&self) -> Figure {
        let names = self.label.as_ref().map(|label| vec![("uk", label.uk.clone()), ("en", label.en.clone())]);
        let word = Word { vocabulary: "table-column", id: self.name.clone().into() };
        Figure::Named(Named { word, names: names.unwrap_or_default() })
    }

    /// Every rank a cell of this column can have: the values of an enum, both truth values, or all numbers.
    pub fn universe(&self) -> Set {
        match self.ty {
            ColumnType::Enum => Set::interval(0, self.values.len() as i64 - 1),
            ColumnType::Bool => Set::interval(0, 1),
            ColumnType::It => Set::interval(1, 18),
            _ => Set::all(),
        }
    }

    /// The name of one of its values in the language of that tag, where a vocabulary names it.
    pub fn name_of(&self, value: &str, tag: &str) -> Option<&str> {
        let mut named = self.values.iter().zip(&self.names);
        named.find(|(word, _)| *word == value).map(|(_, name)| name.text(tag))
    }

    /// The permitted inputs: the declared domain, or the universe.
    pub fn allowed(&self) -> Set {
        self.domain.clone().unwrap_or_else(|| self.universe())
    }

    /// The roughness limits in its domain, coarsest first: the printed roughness columns of the source tables.
    pub fn roughness_points(&self) -> Vec<Roughness> {
        let intervals = self.domain.as_ref().map(Set::intervals).unwrap_or_default();
        let points = intervals.iter().filter(|(low, high)| low == high);
        let points = points.filter_map(|(low, _)| u32::try_from(*low).ok().map(Roughness::from_ra_nanometres));
        let mut points: Vec<Roughness> = points.collect();
        points.reverse();
        points
    }

    /// Whether its inputs can be unbounded: an ordered or text column without a domain.
    pub fn is_unbounded(&self) -> bool {
        self.domain.is_none() && !matches!(self.ty, ColumnType::Enum | ColumnType::Bool | ColumnType::It)
    }

    /// Reads one value of this column (one item of a list column).
    ///
    /// # Errors
    /// A sentence saying what was read and what is expected.
    pub fn parse_value(&self, text: &str) -> Result<Value, Note> {
        let text = text.trim();
        match self.ty {
            ColumnType::Text => Ok(Value::Text(text.to_owned())),
            ColumnType::Unit => {
                text.parse::<Unit>().map(|unit| Value::Text(unit.text().to_owned())).map_err(|error| error.0)
            }
            ColumnType::Enum => {
                if self.values.iter().any(|value| value == text) {
                    Ok(Value::Text(text.to_owned()))
                } else {
                    Err(note!("table-none", text = text, known = self.values.join(", ")))
                }
            }
            ColumnType::Bool => match text {
                "true" => Ok(Value::Bool(true)),
                "false" => Ok(Value::Bool(false)),
                _ => Err(note!("yaml-neither-true-nor-false", other = text)),
            },
            ColumnType::Int => text
                .parse::<Decimal>()
                .map_err(|error| error.0)
                .and_then(|value| value.to_int().ok_or_else(|| note!("table-whole-number", text = text)))
                .map(Value::Int),
            ColumnType::Number | ColumnType::Angle => {
                text.parse::<Decimal>().map(|value| Value::Number(value, self.unit)).map_err(|error| error.0)
            }
            ColumnType::Length => self.parse_length(text).map(Value::Length),
            ColumnType::It => text.parse::<ItGrade>().map(Value::Grade).map_err(|error| error.0),
            ColumnType::Roughness => text.parse::<Roughness>().map(Value::Roughness).map_err(|error| error.0),
        }
    }

    fn parse_length(&self, text: &str) -> Result<Micrometres, Note> {
        if self.unit == Unit::Micrometre {
            let value = text.parse::<Decimal>().map_err(|error| error.0)?;
            return value
                .to_int()
                .map(Micrometres::new)
                .ok_or_else(|| note!("table-finer-than-micrometre", text = text));
        }
        text.parse::<Micrometres>().map_err(|error| error.0)
    }

    /// The rank of a value in the order of this column; none if it is not of the column's type.
    pub fn rank(&self, value: &Value) -> Option<i64> {
        match (self.ty, value) {
            (ColumnType::Enum, Value::Text(text)) => self.rank_of_text(text),
            (ColumnType::Bool, Value::Bool(value)) => Some(i64::from(*value)),
            (ColumnType::Int, Value::Int(value)) => Some(*value),
            (ColumnType::Number | ColumnType::Angle, Value::Number(value, unit)) if *unit == self.unit => {
                Some(value.millionths())
            }
            (ColumnType::Length, Value::Length(value)) => Some(value.micrometres()),
            (ColumnType::It, Value::Grade(value)) => Some(i64::from(value.number())),
            (ColumnType::Roughness, Value::Roughness(value)) => Some(i64::from(value.ra_nanometres())),
            _ => None,
        }
    }

    /// The position of an enum's value.
    pub fn rank_of_text(&self, text: &str) -> Option<i64> {
        self.values.iter().position(|value| value == text).and_then(|index| i64::try_from(index).ok())
    }

    /// A rank as a person would write it in a query.
    pub fn show_rank(&self, rank: i64) -> String {
        match self.ty {
            ColumnType::Enum => {
                usize::try_from(rank).ok().and_then(|index| self.values.get(index)).cloned().unwrap_or_default()
            }
            ColumnType::Bool => (rank == 1).to_string(),
            ColumnType::Length if self.unit == Unit::Micrometre => rank.to_string(),
            ColumnType::Length => Micrometres::new(rank).to_string(),
            ColumnType::Number | ColumnType::Angle => Decimal::from_millionths(rank).to_string(),
            ColumnType::Roughness => u32::try_from(rank)
                .map(|ra| Roughness::from_ra_nanometres(ra).to_string())
                .unwrap_or_else(|_| rank.to_string()),
            ColumnType::It | ColumnType::Int | ColumnType::Text | ColumnType::Unit => rank.to_string(),
        }
    }
}
