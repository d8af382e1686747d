//! Short names of things in an answer: `drill 9.8`, `doubtful unconfirmed`, the designation of a tool.

use serde_json::{Map, Value};

use crate::knowledge::alike::latin;
use crate::knowledge::diagnostic::nearest;
use crate::part::Face;
use crate::plan::{Feature, Operation};

use super::expected::number_of;
use super::written;

type Object = Map<String, Value>;

/// A word that names nothing of this kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownWord {
    /// The word.
    pub word: String,
    /// The word that was perhaps meant.
    pub likely: Option<String>,
}

/// The fields by which a finding may be named, in any order.
const OF_FINDING: [&str; 5] = ["severity", "rule", "code", "field", "hole"];

/// Whether an object has that name.
///
/// # Errors
/// No object of this kind has such a name.
pub fn is_called(object: &Object, text: &str) -> Result<bool, UnknownWord> {
    let has =
        |key: &str, text: &str| object.get(key).and_then(Value::as_str).is_some_and(|own| same_letters(own, text));
    if is_transition(object) {
        return Ok(Pattern::read(text)?.fits(object));
    }
    if object.contains_key("designation") {
        let is_designation = |(designation, table): (&str, &str)| same_letters(&format!("{designation} {table}"), text);
        let both = texts(object, "designation").zip(texts(object, "table"));
        return Ok(has("designation", text) || both.is_some_and(is_designation));
    }
    if object.contains_key("code") {
        // Its full name may contain a field with spaces.
        let is_name = name(object).is_some_and(|name| same_letters(&name, text));
        return Ok(is_name || text.split_whitespace().all(|word| OF_FINDING.iter().any(|key| has(key, word))));
    }
    Ok(NAMES.iter().any(|key| has(key, text)))
}

/// Turning has other operations.
fn is_transition(object: &Object) -> bool {
    object.contains_key("diameter_mm") && texts(object, "operation").and_then(Operation::from_name).is_some()
}

/// The keys whose values name the items of a list: the first one that an item has.
pub const NAMES: [&str; 5] = ["name", "number", "surface", "side", "motion"];

/// Whether two texts are the same up to letters that look alike in both alphabets.
pub fn same_letters(one: &str, other: &str) -> bool {
    one == other || latin(one) == latin(other)
}

fn texts<'o>(object: &'o Object, key: &str) -> Option<&'o str> {
    object.get(key).and_then(Value::as_str)
}

/// A transition in short: `drill 9.8`, `chamfer chamfer 22`, `counterbore step step:1 14 back`, `drill 12 also:18`,
/// `finish-bore|finish-ream 25`. Missing words mean the usual: the main cylinder, from the entry face, on this
/// machine; only the diameter may be any.
pub struct Pattern<'t> {
    operations: Vec<&'t str>,
    diameter: Option<f64>,
    feature: &'static str,
    step: Option<f64>,
    also: Option<f64>,
    back: bool,
    elsewhere: bool,
}

impl<'t> Pattern<'t> {
    /// Reads a short name of a transition.
    ///
    /// # Errors
    /// A word without a meaning.
    pub fn read(text: &'t str) -> Result<Self, UnknownWord> {
        let mut words = text.split_whitespace();
        let operations: Vec<&str> = words.next().unwrap_or_default().split('|').collect();
        let known = || Operation::NAMES.iter().map(|(name, _)| *name);
        if let Some(word) = operations.iter().find(|word| Operation::from_name(word).is_none()) {
            let near = nearest(word, known()).map(str::to_owned);
            return Err(UnknownWord { word: (*word).to_owned(), likely: near });
        }
        let mut own = Self {
            operations,
            diameter: None,
            feature: Feature::Bore.name(),
            step: None,
            also: None,
            back: false,
            elsewhere: false,
        };
        for word in words {
            let number_after = |prefix: &str| word.strip_prefix(prefix).and_then(number_of);
            if let Some(diameter) = number_of(word) {
                own.diameter = Some(diameter);
            } else if let Some(step) = number_after("step:") {
                own.step = Some(step);
            } else if let Some(also) = number_after("also:") {
                own.also = Some(also);
            } else if let Some((name, _)) = Feature::NAMES.iter().find(|(name, _)| *name == word) {
                own.feature = name;
            } else {
                match word {
                    "back" => own.back = true,
                    "elsewhere" => own.elsewhere = true,
                    _ => {
                        let features = Feature::NAMES.iter().map(|(name, _)| *name);
                        let near = nearest(word, features.chain(["back", "elsewhere"])).map(str::to_owned);
                        return Err(UnknownWord { word: word.to_owned(), likely: near });
                    }
                }
            }
        }
        Ok(own)
    }

    fn fits(&self, object: &Object) -> bool {
        let number = |key: &str| object.get(key).and_then(Value::as_f64);
        let operation = texts(object, "operation").is_some_and(|own| self.operations.contains(&own));
        let diameter = self.diameter.is_none_or(|diameter| number("diameter_mm") == Some(diameter));
        // A transition of a rejected route has only these two.
        let rest = match texts(object, "feature") {
            None => self.is_plain(),
            Some(feature) => {
                feature == self.feature
                    && number("step") == self.step
                    && number("also_diameter_mm") == self.also
                    && is_back(object) == self.back
                    && is_elsewhere(object) == self.elsewhere
            }
        };
        operation && diameter && rest
    }

    fn is_plain(&self) -> bool {
        let usual = self.feature == Feature::Bore.name() && !self.back && !self.elsewhere;
        usual && self.step.is_none() && self.also.is_none()
    }
}

fn is_back(object: &Object) -> bool {
    serde_json::to_value(Face::Back).is_ok_and(|back| object.get("face") == Some(&back))
}

fn is_elsewhere(object: &Object) -> bool {
    object.get("elsewhere") == Some(&Value::Bool(true))
}

/// A value in short, for people: its name, if it has one.
pub fn brief(value: &Value) -> String {
    match value {
        Value::Array(items) => format!("[{}]", items.iter().map(brief).collect::<Vec<_>>().join(", ")),
        Value::Object(object) => name(object).unwrap_or_else(|| {
            let pair = |(key, value): (&String, &Value)| format!("{key}: {}", brief(value));
            let fields = object.iter().filter(|(key, _)| !key.starts_with("because"));
            format!("{{{}}}", fields.map(pair).collect::<Vec<_>>().join(", "))
        }),
        other => written::value(other),
    }
}

/// The name of an object.
pub fn name(object: &Object) -> Option<String> {
    let number = |key: &str| object.get(key).filter(|value| value.is_number()).map(Value::to_string);
    if let Some(operation) = texts(object, "operation").filter(|_| is_transition(object)) {
        let feature = texts(object, "feature").filter(|feature| *feature != Feature::Bore.name());
        let words = [
            Some(operation.to_owned()),
            feature.map(str::to_owned),
            number("step").map(|step| format!("step:{step}")),
            number("diameter_mm"),
            number("also_diameter_mm").map(|also| format!("also:{also}")),
            is_back(object).then(|| "back".to_owned()),
            is_elsewhere(object).then(|| "elsewhere".to_owned()),
        ];
        return Some(words.into_iter().flatten().collect::<Vec<_>>().join(" "));
    }
    if let Some(designation) = texts(object, "designation") {
        return Some(designation.to_owned());
    }
    if let (Some(severity), Some(code)) = (texts(object, "severity"), texts(object, "code")) {
        let what = texts(object, "rule").filter(|_| object.contains_key("field")).unwrap_or(code);
        let words = [Some(severity), Some(what), texts(object, "field")];
        return Some(words.into_iter().flatten().collect::<Vec<_>>().join(" "));
    }
    texts(object, "code").map(str::to_owned)
}
