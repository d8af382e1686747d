//! What counts as the same when people ask: numbers as numbers, texts up to letters that look alike in both alphabets.

use crate::column::Column;
use crate::table::Cell;
use crate::value::Value;

/// Whether a cell has the value; a list has each of its items.
pub fn has(column: &Column, cell: &Cell, wanted: &Value) -> bool {
    match cell {
        Cell::Value(value) => value.items().iter().any(|item| same(column, item, wanted)),
        // A truth value left out is no, as everywhere.
        Cell::Empty => *wanted == Value::Bool(false),
        Cell::Test(..) => false,
    }
}

fn same(column: &Column, value: &Value, wanted: &Value) -> bool {
    match (value, wanted) {
        (Value::Text(value), Value::Text(wanted)) => value == wanted || latin(value) == latin(wanted),
        _ => column.rank(value).is_some() && column.rank(value) == column.rank(wanted),
    }
}

/// A text with Cyrillic letters that look like Latin ones written as those: on many keyboards nobody
/// can tell `А.8` from `A.8`.
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
