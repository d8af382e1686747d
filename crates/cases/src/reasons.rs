//! The reasons of an answer, taken from the answer itself, as near as possible to the unexpected figure.

use serde_json::Value;

use crate::note::{Because, Finding, Note};

use super::called::same_letters;
use super::expected::{Expected, ExpectedKind};

/// A reason, as data.
#[derive(Clone, Debug, PartialEq)]
pub enum Why {
    /// A decision with its row.
    Because(Box<Because>),
    /// Why the expected scheme was not taken.
    NotTaken {
        /// The scheme.
        scheme: String,
        /// Why.
        why: Note,
    },
    /// The finding about a hole without a route.
    Finding(Finding),
    /// A row of a table that gives the expected value but does not match.
    OtherRow {
        /// Its number, from 1.
        row: usize,
        /// The first column that failed.
        column: String,
        /// The requirement of that column.
        cell: String,
    },
}

/// Keys of a group of holes that its route decides.
const OF_ROUTE: [&str; 4] = ["route", "scheme", "by_tables", "transitions"];

/// The reasons nearest to the value at `path`; `trail` has the values along the path, the innermost last, one for
/// each key.
pub fn reasons(trail: &[&Value], path: &[String], expected: &Expected) -> Vec<Why> {
    for (value, key) in trail.iter().zip(path).rev() {
        let Some(object) = value.as_object() else { continue };
        let own = because(object.get("because"));
        if !own.is_empty() {
            return own;
        }
        if !OF_ROUTE.contains(&key.as_str()) || !object.contains_key("transitions") {
            continue;
        }
        let Some(route) = object.get("route").filter(|route| !route.is_null()) else {
            return findings(trail.first().copied(), object.get("name"));
        };
        let mut reasons = Vec::new();
        if let ("scheme", ExpectedKind::Is(scheme)) = (key.as_str(), &expected.kind) {
            reasons.extend(not_taken(route, scheme));
        }
        reasons.extend(because(route.get("because")));
        return reasons;
    }
    Vec::new()
}

fn because(reasons: Option<&Value>) -> Vec<Why> {
    let reasons = reasons.and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let read = reasons.iter().filter_map(|value| serde_json::from_value::<Because>(value.clone()).ok());
    read.map(|reason| Why::Because(Box::new(reason))).collect()
}

fn findings(answer: Option<&Value>, hole: Option<&Value>) -> Vec<Why> {
    let all = answer.and_then(|answer| answer.get("findings")).and_then(Value::as_array);
    let of_hole = all.into_iter().flatten().filter(|finding| finding.get("hole") == hole);
    of_hole.filter_map(|finding| serde_json::from_value(finding.clone()).ok()).map(Why::Finding).collect()
}

fn not_taken(route: &Value, scheme: &str) -> Option<Why> {
    let others = route.get("alternatives").and_then(Value::as_array)?;
    let own = |other: &&Value| other.get("scheme").and_then(Value::as_str).is_some_and(|own| same_letters(own, scheme));
    let why = others.iter().find(own)?.get("why")?;
    Some(Why::NotTaken { scheme: scheme.to_owned(), why: serde_json::from_value(why.clone()).ok()? })
}
