//! Trees and values as YAML on one line.

use serde_json::{Map, Value};

use crate::knowledge::yaml::{Node, NodeKind};

/// A node as it is written, on one line.
pub fn node(from: &Node) -> String {
    match &from.kind {
        NodeKind::Scalar { text, quoted: true } => quoted(text),
        NodeKind::Scalar { text, .. } if text.contains('\n') => quoted(text),
        NodeKind::Scalar { text, .. } => text.clone(),
        NodeKind::Seq(items) => format!("[{}]", joined(items.iter().map(node))),
        NodeKind::Map(entries) => {
            format!(
                "{{{}}}",
                joined(entries.iter().map(|(key, inner)| format!("{}: {}", scalar(&key.text), node(inner))))
            )
        }
    }
}

/// A value on one line.
pub fn value(from: &Value) -> String {
    match from {
        Value::Null => "absent".to_owned(),
        Value::String(text) => scalar(text),
        Value::Array(items) => format!("[{}]", joined(items.iter().map(value))),
        Value::Object(entries) => {
            let pairs = in_order(entries).into_iter();
            format!("{{{}}}", joined(pairs.map(|(key, inner)| format!("{}: {}", scalar(key), value(inner)))))
        }
        // 800, not 800.0.
        Value::Number(number) if number.is_f64() => number.as_f64().unwrap_or_default().to_string(),
        other => other.to_string(),
    }
}

/// What people read first; all other keys stand behind, by the alphabet.
const FIRST: [&str; 10] = [
    "name",
    "operation",
    "feature",
    "diameter_mm",
    "tool.designation",
    "holes",
    "scheme",
    "transitions",
    "variants",
    "contains",
];

/// The keys of an object in the order in which people read them.
pub fn in_order(object: &Map<String, Value>) -> Vec<(&String, &Value)> {
    let mut entries: Vec<(&String, &Value)> = object.iter().collect();
    entries.sort_by_key(|(key, _)| FIRST.iter().position(|first| key == first).unwrap_or(FIRST.len()));
    entries
}

/// A text as a YAML scalar: in quotes, unless it is a word that cannot be taken for anything else.
pub fn scalar(text: &str) -> String {
    let first = text.chars().next().is_some_and(|letter| letter.is_alphabetic() || letter.is_ascii_digit());
    let plain = |letter: char| letter.is_alphanumeric() || " -_./|*".contains(letter);
    let word = ["true", "false", "null", "absent", "present", "yes", "no", "on", "off"];
    let taken = text.parse::<f64>().is_ok() || word.contains(&text.to_lowercase().as_str());
    if first && text.chars().all(plain) && text.trim() == text && !taken { text.to_owned() } else { quoted(text) }
}

fn quoted(text: &str) -> String {
    // A JSON string is a YAML one.
    Value::String(text.to_owned()).to_string()
}

fn joined(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join(", ")
}
