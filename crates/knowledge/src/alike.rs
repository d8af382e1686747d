//! Equality in queries: numbers as numbers, texts up to letters that look alike in both alphabets.

use crate::column::Column;
use crate::table::Cell;
use crate::value::Value;

/// Whether a cell has the value; a list matches each of its items.
pub fn matches(column: &Column, cell: &Cell, wanted: &Value) -> bool {
    match cell {
        Cell::Value(value) => value.items().iter().any(|item| same_value(column, item, wanted)),
        // A missing truth value is false, as everywhere.
        Cell::Empty => *wanted == Value::Bool(false),
        Cell::Test(..) => false,
    }
}

fn same_value(column: &Column, value: &Value, wanted: &Value) -> bool {
    match (value, wanted) {
        (Value::Text(value), Value::Text(wanted)) => value == wanted || latin(value) == latin(wanted),
        _ => column.rank(value).is_some() && column.rank(value) == column.rank(wanted),
    }
}

/// A text with Cyrillic letters replaced by the Latin ones that look the same: on many keyboards `А.8` and `A.8`
/// cannot be told apart.
pub fn latin(text: &str) -> String {
    text.chars()
        .map(|letter| match letter {
            'А' => 'A',
            'В' => 'B',
            'Е' => 'E',
            'І' => 'I',
            'К' => 'K',
            'М' => 'M',
            'Н' => 'H',
            'О' => 'O',
            'Р' => 'P',
            'С' => 'C',
            'Т' => 'T',
            'Х' => 'X',
            'а' => 'a',
            'е' => 'e',
            'і' => 'i',
            'о' => 'o',
            'р' => 'p',
            'с' => 'c',
            'у' => 'y',
            'х' => 'x',
            other => other,
        })
        .collect()
}
