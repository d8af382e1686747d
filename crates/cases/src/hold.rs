//! Compares an answer, a JSON value, with its expectation.

use std::collections::BTreeSet;

use serde_json::{Map, Value};

use crate::knowledge::Word;
use crate::knowledge::diagnostic::{Place, nearest};
use crate::knowledge::yaml::Key;
use crate::note::Severity;

use super::called::{self, NAMES, UnknownWord};
use super::expected::{Expected, ExpectedKind, Item, ListRequirements, number_of};
use super::reasons::{Why, reasons};

/// The relative difference of two floating numbers that count as equal: less than any tolerance an author writes.
const HAIR: f64 = 1e-12;

/// An expectation that does not hold.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The place of the expectation.
    pub place: Place,
    /// Its path in the answer: keys with dots.
    pub path: String,
    /// The expectation as written.
    pub expected: String,
    /// The actual value.
    pub actual: ActualValue,
    /// The reasons in the answer.
    pub reasons: Vec<Why>,
}

impl Failure {
    /// Whether nothing is expected yet.
    pub const fn is_open(&self) -> bool {
        matches!(self.actual, ActualValue::Open(_))
    }
}

/// What was found instead of the expected value.
#[derive(Clone, Debug, PartialEq)]
pub enum ActualValue {
    /// This value.
    Value(Value),
    /// No value.
    Nothing,
    /// A list without such an item: the list.
    Without(Value),
    /// Something that must not be there.
    Unwanted(Value),
    /// This value, where nothing is expected yet.
    Open(Option<Value>),
    /// The answer has no such key or item.
    NoSuch {
        /// The key.
        key: String,
        /// The key that was perhaps meant.
        near: Option<String>,
        /// The existing keys.
        known: Vec<String>,
    },
    /// A word that names nothing of this kind.
    NoSuchWord {
        /// The word.
        word: String,
        /// The one that was perhaps meant.
        near: Option<String>,
    },
}

/// An answer, and whether the keys of the expectation were already checked.
#[derive(Clone, Copy, Debug)]
pub struct Answer<'v> {
    /// The answer.
    pub value: &'v Value,
    /// Whether all expected keys are known to be possible in such an answer.
    pub vouched: bool,
}

/// All differences between an answer and its expectation, in the order of the expectation.
pub fn hold(expected: &Expected, answer: Answer<'_>) -> Vec<Failure> {
    let mut keys = BTreeSet::new();
    if !answer.vouched {
        all_keys(answer.value, &mut keys);
    }
    let scope = Scope { answer, keys: &keys };
    let mut holder = Holder { scope, trail: Vec::new(), path: Vec::new(), failures: Vec::new() };
    holder.hold(expected, Some(answer.value));
    holder.failures
}

fn all_keys<'v>(value: &'v Value, keys: &mut BTreeSet<&'v str>) {
    match value {
        Value::Object(object) => {
            for (key, inner) in object {
                keys.insert(key);
                all_keys(inner, keys);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| all_keys(item, keys)),
        _ => {}
    }
}

#[derive(Clone, Copy)]
struct Scope<'v, 'k> {
    answer: Answer<'v>,
    /// Every key of the answer, if the expected keys were not checked before.
    keys: &'k BTreeSet<&'v str>,
}

struct Holder<'v, 'k> {
    scope: Scope<'v, 'k>,
    /// The values around the current one, the answer first.
    trail: Vec<&'v Value>,
    path: Vec<String>,
    failures: Vec<Failure>,
}

impl<'v> Holder<'v, '_> {
    fn fail(&mut self, expected: &Expected, actual: ActualValue) {
        self.failures.push(Failure {
            place: expected.place.clone(),
            path: self.path.join("."),
            expected: expected.written.clone(),
            actual,
            reasons: reasons(&self.trail, &self.path, expected),
        });
    }

    /// Compares a value inside this one.
    fn inside(&mut self, step: &str, around: &'v Value, expected: &Expected, value: Option<&'v Value>) {
        self.trail.push(around);
        self.path.push(step.to_owned());
        self.hold(expected, value);
        self.path.pop();
        self.trail.pop();
    }

    /// The failures of an expectation for a single value.
    fn probe(&self, expected: &Expected, value: &'v Value) -> Vec<Failure> {
        let (trail, path) = (Vec::new(), Vec::new());
        let mut holder = Holder { scope: self.scope, trail, path, failures: Vec::new() };
        holder.hold(expected, Some(value));
        holder.failures
    }

    /// Whether a value meets an expectation. Something that no value can meet, such as a misspelt key or word, is a
    /// failure by itself: otherwise a forbidden item would never be found.
    fn fits(&mut self, expected: &Expected, value: &'v Value) -> bool {
        let failures = self.probe(expected, value);
        let fits = failures.is_empty();
        let slip =
            |failure: &Failure| matches!(failure.actual, ActualValue::NoSuchWord { .. } | ActualValue::NoSuch { .. });
        if let Some(slip) = failures.into_iter().find(slip)
            && !self.failures.iter().any(|known| known.place == slip.place && known.actual == slip.actual)
        {
            self.failures.push(slip);
        }
        fits
    }

    fn hold(&mut self, expected: &Expected, value: Option<&'v Value>) {
        let value = value.filter(|value| !value.is_null());
        let came = || value.map_or(ActualValue::Nothing, |value| ActualValue::Value(value.clone()));
        match (&expected.kind, value) {
            (ExpectedKind::Open, value) => self.fail(expected, ActualValue::Open(value.cloned())),
            (ExpectedKind::Absent, None) | (ExpectedKind::Present, Some(_)) | (ExpectedKind::Not(_), None) => {}
            (ExpectedKind::Absent | ExpectedKind::Present, _) | (_, None) => self.fail(expected, came()),
            (ExpectedKind::Not(other), Some(value)) => {
                if self.fits(other, value) {
                    self.fail(expected, came());
                }
            }
            (ExpectedKind::OneOf(several), Some(value)) => {
                // Each one is tried, so that a mistake in any of them is reported.
                let fitting = several.iter().filter(|item| self.fits(item, value)).count();
                if fitting == 0 {
                    self.fail(expected, came());
                }
            }
            (ExpectedKind::Is(text), Some(value)) => match is(text, value) {
                Ok(true) => {}
                Ok(false) => self.fail(expected, came()),
                Err(UnknownWord { word, likely: near }) => self.fail(expected, ActualValue::NoSuchWord { word, near }),
            },
            (ExpectedKind::Near { is, by }, Some(value)) => {
                let near = |number: f64| (number - is).abs() <= by + HAIR * number.abs().max(is.abs());
                if !number(value).is_some_and(near) {
                    self.fail(expected, came());
                }
            }
            (ExpectedKind::Range { keys, .. }, Some(Value::Object(object))) => self.object(keys, object, value),
            (ExpectedKind::Range { from, to, .. }, Some(value)) => {
                let inside = |number: f64| {
                    let hair = HAIR * number.abs();
                    from.is_none_or(|from| number >= from - hair) && to.is_none_or(|to| number <= to + hair)
                };
                if !number(value).is_some_and(inside) {
                    self.fail(expected, came());
                }
            }
            (ExpectedKind::List(items), Some(around @ Value::Array(values))) => {
                self.list(expected, items, values, around)
            }
            (ExpectedKind::Some(part), Some(around @ Value::Array(values))) => {
                self.part(expected, part, values, around)
            }
            (ExpectedKind::Some(part), Some(value @ Value::String(text))) => self.of_text(expected, part, text, value),
            (ExpectedKind::Map(keys), Some(Value::Object(object))) => self.object(keys, object, value),
            (ExpectedKind::Map(names), Some(around @ Value::Array(values))) => self.named(names, values, around),
            (ExpectedKind::List(_) | ExpectedKind::Some(_) | ExpectedKind::Map(_), Some(_)) => {
                self.fail(expected, came())
            }
        }
    }

    fn object(&mut self, keys: &[(Key, Expected)], object: &'v Map<String, Value>, around: Option<&'v Value>) {
        let Some(around) = around else { return };
        for (key, expected) in keys {
            let value = object.get(&key.text);
            // A key that occurs nowhere in the answer may be misspelt and not just missing here.
            if value.is_none() && !self.scope.answer.vouched && !self.scope.keys.contains(key.text.as_str()) {
                let known: Vec<String> = object.keys().cloned().collect();
                self.no_such(key, expected, known);
            } else {
                self.inside(&key.text, around, expected, value);
            }
        }
    }

    fn no_such(&mut self, key: &Key, expected: &Expected, known: Vec<String>) {
        let near = nearest(&key.text, known.iter().map(String::as_str)).map(str::to_owned);
        let at_key = Expected { place: key.place.clone(), ..expected.clone() };
        self.path.push(key.text.clone());
        self.fail(&at_key, ActualValue::NoSuch { key: key.text.clone(), near, known });
        self.path.pop();
    }

    /// Items by their names or, if they have none, by their numbers from 1.
    fn named(&mut self, names: &[(Key, Expected)], values: &'v [Value], around: &'v Value) {
        for (name, expected) in names {
            let key = NAMES.iter().find(|key| values.iter().any(|value| value.get(key).is_some()));
            let value = match key {
                Some(key) => {
                    values.iter().find(|value| value.get(key).is_some_and(|own| is(&name.text, own) == Ok(true)))
                }
                None => name.text.parse().ok().and_then(|number: usize| values.get(number.checked_sub(1)?)),
            };
            if value.is_some() || matches!(expected.kind, ExpectedKind::Absent) {
                self.inside(&name.text, around, expected, value);
                continue;
            }
            let known: Vec<String> = match key {
                Some(key) => values.iter().filter_map(|value| value.get(key).map(plain)).collect(),
                None => (1..=values.len()).map(|number| number.to_string()).collect(),
            };
            self.no_such(name, expected, known);
        }
    }

    fn list(&mut self, expected: &Expected, items: &[Item], values: &'v [Value], around: &'v Value) {
        if items.len() == values.len() && items.iter().all(|item| !item.optional) {
            for (number, (item, value)) in items.iter().zip(values).enumerate() {
                self.inside(&(number + 1).to_string(), around, &item.expected, Some(value));
            }
        } else if !self.begins(items, values, true) {
            self.fail(expected, ActualValue::Value(around.clone()));
        }
    }

    /// Whether values begin with the items; with `whole`, whether nothing follows them.
    fn begins(&mut self, items: &[Item], values: &'v [Value], whole: bool) -> bool {
        let Some((first, rest)) = items.split_first() else { return !whole || values.is_empty() };
        if let Some((value, tail)) = values.split_first()
            && self.fits(&first.expected, value)
            && self.begins(rest, tail, whole)
        {
            return true;
        }
        first.optional && self.begins(rest, values, whole)
    }

    fn part(&mut self, expected: &Expected, part: &ListRequirements, values: &'v [Value], around: &'v Value) {
        if let Some(items) = &part.starts
            && !self.begins(items, values, false)
        {
            self.fail(expected, ActualValue::Value(around.clone()));
        }
        if let Some(items) = &part.ends
            && !(0..=values.len()).any(|from| self.begins(items, &values[from..], true))
        {
            self.fail(expected, ActualValue::Value(around.clone()));
        }
        for item in &part.contains {
            let fitting = values.iter().filter(|value| self.fits(item, value)).count();
            if fitting == 0 {
                self.lacking(item, values, around);
            }
        }
        for one in &part.excluded {
            for value in values {
                if self.fits(one, value) {
                    self.fail(one, ActualValue::Unwanted(value.clone()));
                }
            }
        }
        if let Some(count) = &part.how_many {
            let found = Value::from(values.len());
            if !how_many(count, values.len()) {
                self.fail(count, ActualValue::Value(found));
            }
        }
        if let Some(every) = &part.every {
            // Nothing is said about no items.
            if values.is_empty() {
                self.fail(every, ActualValue::Value(around.clone()));
            }
            for (number, value) in values.iter().enumerate() {
                self.inside(&(number + 1).to_string(), around, every, Some(value));
            }
        }
        if let Some((severity, place)) = &part.none_from {
            let written = format!("none_from: {}", severity.name());
            let absent = Expected { place: place.clone(), written, kind: ExpectedKind::Absent };
            for value in values.iter().filter(|value| is_from(value, *severity)) {
                self.fail(&absent, ActualValue::Unwanted(value.clone()));
            }
        }
    }

    /// An item is missing in a list: the differences of the only item that nearly fits, otherwise that there is none.
    fn lacking(&mut self, expected: &Expected, values: &'v [Value], around: &'v Value) {
        let keys = match &expected.kind {
            ExpectedKind::Map(keys) => keys.len(),
            _ => 0,
        };
        let wrong = values.iter().enumerate().map(|(number, value)| (self.probe(expected, value).len(), number, value));
        let mut nearly: Vec<_> = wrong.filter(|(wrong, ..)| *wrong < keys).collect();
        nearly.sort_by_key(|(wrong, ..)| *wrong);
        match nearly.as_slice() {
            [(wrong, number, value), rest @ ..] if rest.first().is_none_or(|(next, ..)| next > wrong) => {
                self.inside(&(number + 1).to_string(), around, expected, Some(value));
            }
            _ => self.fail(expected, ActualValue::Without(around.clone())),
        }
    }

    /// `contains` and `lacks` of a text.
    fn of_text(&mut self, expected: &Expected, part: &ListRequirements, text: &str, value: &'v Value) {
        let has = |item: &Expected| matches!(&item.kind, ExpectedKind::Is(inner) if text.contains(inner.as_str()));
        let of_list = part.starts.is_some() || part.ends.is_some() || part.how_many.is_some() || part.every.is_some();
        if of_list || part.none_from.is_some() {
            self.fail(expected, ActualValue::Value(value.clone()));
        }
        for one in part.contains.iter().filter(|one| !has(one)) {
            self.fail(one, ActualValue::Value(value.clone()));
        }
        for one in part.excluded.iter().filter(|one| has(one) || !matches!(one.kind, ExpectedKind::Is(_))) {
            self.fail(one, ActualValue::Value(value.clone()));
        }
    }
}

fn how_many(expected: &Expected, found: usize) -> bool {
    let value = Value::from(found);
    let answer = Answer { value: &value, vouched: true };
    hold(expected, answer).is_empty()
}

/// Whether a value is a finding of that severity or a higher one.
pub fn is_from(finding: &Value, severity: Severity) -> bool {
    let own = finding.get("severity").and_then(Value::as_str).and_then(Severity::from_word);
    own.is_some_and(|own| own <= severity)
}

fn is(text: &str, value: &Value) -> Result<bool, UnknownWord> {
    Ok(match value {
        Value::String(own) => called::same_letters(own, text),
        Value::Number(number) => number.as_f64().is_some_and(|own| number_of(text) == Some(own)),
        Value::Bool(own) => text == own.to_string(),
        Value::Object(object) => called::is_called(object, text)?,
        Value::Null | Value::Array(_) => false,
    })
}

/// A number, even if the answer has it as a text.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => number_of(text),
        _ => None,
    }
}

fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
