//! The values in the cells of a table.

use std::fmt;

use serde::{Deserialize, Serialize};

use technolog_note::{Figure, IntoFigure};

use crate::units::{Decimal, ItGrade, Micrometres, Roughness, Unit};

/// A typed value of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// A text, or one of the values of an enum.
    Text(String),
    /// Yes or no.
    Bool(bool),
    /// A whole number.
    Int(i64),
    /// A decimal with the unit of its column.
    Number(Decimal, Unit),
    /// A length.
    Length(Micrometres),
    /// A tolerance grade.
    Grade(ItGrade),
    /// A roughness limit.
    Roughness(Roughness),
    /// Several of them.
    List(Vec<Value>),
}

impl Value {
    /// The text of a text value.
    pub fn as_text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The items of a list; for any other value, the value itself.
    pub fn items(&self) -> &[Value] {
        match self {
            Self::List(items) => items,
            single => std::slice::from_ref(single),
        }
    }
}

impl IntoFigure for Value {
    fn into_figure(self) -> Figure {
        match self {
            Self::Int(_) | Self::Number(..) | Self::Length(_) | Self::Grade(_) => Figure::number(self.to_string()),
            Self::List(items) => Figure::list(items.into_iter().map(IntoFigure::into_figure)),
            Self::Text(_) | Self::Bool(_) | Self::Roughness(_) => self.to_string().into_figure(),
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Bool(value) => value.fmt(f),
            Self::Int(value) => value.fmt(f),
            Self::Number(value, _) => value.fmt(f),
            Self::Length(value) => value.fmt(f),
            Self::Grade(value) => value.fmt(f),
            Self::Roughness(value) => value.fmt(f),
            Self::List(items) => {
                for (index, item) in items.iter().enumerate() {
                    if index > 0 {
                        f.write_str(", ")?;
                    }
                    item.fmt(f)?;
                }
                Ok(())
            }
        }
    }
}

/// For people and other programs: texts, numbers and lists directly.
impl Serialize for Value {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if !serializer.is_human_readable() {
            return Compact::from(self).serialize(serializer);
        }
        match self {
            Self::Text(text) => serializer.serialize_str(text),
            Self::Bool(value) => serializer.serialize_bool(*value),
            Self::Int(value) => serializer.serialize_i64(*value),
            Self::Number(value, _) => match value.to_int() {
                Some(whole) => serializer.serialize_i64(whole),
                None => serializer.serialize_f64(value.to_f64()),
            },
            Self::Length(value) => value.serialize(serializer),
            Self::Grade(value) => value.serialize(serializer),
            Self::Roughness(value) => value.serialize(serializer),
            Self::List(items) => items.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        if deserializer.is_human_readable() {
            return Err(serde::de::Error::custom("a table value is read from a table file, not from text"));
        }
        Compact::deserialize(deserializer).map(Self::from)
    }
}

/// The form of the compiled tables.
#[derive(Serialize, Deserialize)]
enum Compact {
    Text(String),
    Bool(bool),
    Int(i64),
    Number(Decimal, Unit),
    Length(i64),
    Grade(ItGrade),
    Roughness(String),
    List(Vec<Compact>),
}

impl From<&Value> for Compact {
    fn from(value: &Value) -> Self {
        match value {
            Value::Text(text) => Self::Text(text.clone()),
            Value::Bool(value) => Self::Bool(*value),
            Value::Int(value) => Self::Int(*value),
            Value::Number(value, unit) => Self::Number(*value, *unit),
            Value::Length(value) => Self::Length(value.micrometres()),
            Value::Grade(value) => Self::Grade(*value),
            Value::Roughness(value) => Self::Roughness(value.to_string()),
            Value::List(items) => Self::List(items.iter().map(Self::from).collect()),
        }
    }
}

impl From<Compact> for Value {
    fn from(value: Compact) -> Self {
        match value {
            Compact::Text(text) => Self::Text(text),
            Compact::Bool(value) => Self::Bool(value),
            Compact::Int(value) => Self::Int(value),
            Compact::Number(value, unit) => Self::Number(value, unit),
            Compact::Length(value) => Self::Length(Micrometres::new(value)),
            Compact::Grade(value) => Self::Grade(value),
            Compact::Roughness(text) => match text.parse() {
                Ok(roughness) => Self::Roughness(roughness),
                Err(_) => Self::Text(text),
            },
            Compact::List(items) => Self::List(items.into_iter().map(Self::from).collect()),
        }
    }
}
