//! The part of an answer that is worth expecting, which `technolog test --write` writes for a person to review.

use serde_json::{Map, Value, json};

use crate::note::Severity;

use super::called::name;
use super::hold::is_from;
use super::question::Question;

/// The expectation that an answer would meet, without its reasons and its internal fields.
pub fn digest(question: &Question, answer: &Value) -> Value {
    match question {
        Question::Table(_) => table(answer),
        Question::Part { .. } => plan(answer),
        Question::Turned { .. } => turned(answer),
        Question::Program(_) => {
            let mut digest = picked(answer, &["time.total_min"]);
            digest.insert("findings".to_owned(), findings(answer));
            if let Some(proof) = answer.get("proof") {
                digest.insert("proof.findings".to_owned(), findings(proof));
            }
            Value::Object(digest)
        }
        Question::Audit(_) => json!({"findings": findings(answer)}),
    }
}

/// A value as an author would expect it: by its name if it has one, otherwise without its reasons.
pub fn bare(value: &Value) -> Value {
    match value {
        Value::Array(items) => items.iter().map(bare).collect(),
        Value::Object(object) => {
            if let Some(name) = name(object) {
                return name.into();
            }
            let fields = object.iter().filter(|(key, inner)| !key.starts_with("because") && !inner.is_null());
            Value::Object(fields.map(|(key, inner)| (key.clone(), bare(inner))).collect())
        }
        other => other.clone(),
    }
}

fn table(answer: &Value) -> Value {
    match answer {
        Value::Array(rows) => match rows.as_slice() {
            [] => Value::from("none"),
            [row] => table(row),
            rows => rows.iter().map(table).collect(),
        },
        Value::Object(row) => {
            let own = ["row", "source", "place", "reason", "unconfirmed"];
            let fields = row.iter().filter(|(key, value)| !own.contains(&key.as_str()) && !value.is_null());
            Value::Object(fields.map(|(key, value)| (key.clone(), value.clone())).collect())
        }
        other => other.clone(),
    }
}

fn plan(answer: &Value) -> Value {
    let mut digest = Map::new();
    let mut holes = Map::new();
    for hole in list(answer, "holes") {
        let mut own = Map::new();
        own.insert("scheme".to_owned(), hole.get("scheme").cloned().unwrap_or_default());
        own.insert("transitions".to_owned(), list(hole, "transitions").iter().map(transition).collect());
        if let Some(name) = hole.get("name").and_then(Value::as_str) {
            holes.insert(name.to_owned(), Value::Object(own));
        }
    }
    // The keys of a single group may be at the top.
    match (holes.len(), holes.values().next()) {
        (1, Some(Value::Object(only))) => digest.extend(only.clone()),
        _ => {
            digest.insert("holes".to_owned(), Value::Object(holes));
        }
    }
    digest.extend(picked(answer, &["clamping.screw", "time.total_min"]));
    digest.insert("findings".to_owned(), findings(answer));
    Value::Object(digest)
}

fn transition(step: &Value) -> Value {
    let mut digest = picked(step, &["operation", "feature", "step", "diameter_mm", "also_diameter_mm"]);
    digest.retain(|key, value| key != "feature" || value != "bore");
    if step.get("face").is_some_and(|face| face != "entry") {
        digest.insert("face".to_owned(), step["face"].clone());
    }
    if step.get("elsewhere") == Some(&Value::Bool(true)) {
        digest.insert("elsewhere".to_owned(), Value::Bool(true));
    } else {
        digest.extend(picked(step, &["tool.designation", "conditions.feed_mm_per_rev", "conditions.spindle_rpm"]));
    }
    Value::Object(digest)
}

fn turned(answer: &Value) -> Value {
    let mut digest = picked(answer, &["recommended.variant"]);
    let variants = list(answer, "variants").iter().filter_map(|variant| {
        Some((variant.get("name")?.as_str()?.to_owned(), Value::Object(picked(variant, &["cutting_path_mm"]))))
    });
    let variants: Map<String, Value> = variants.collect();
    if !variants.is_empty() {
        digest.insert("variants".to_owned(), Value::Object(variants));
    }
    digest.insert("findings".to_owned(), findings(answer));
    Value::Object(digest)
}

/// The largest number of findings that are listed one by one.
const FEW: usize = 6;

/// The findings by their names: all of them or, if there are many or several with one name, the set of names.
fn findings(answer: &Value) -> Value {
    let all = list(answer, "findings");
    let mut names: Vec<String> = Vec::new();
    for called in all.iter().filter_map(|finding| name(finding.as_object()?)) {
        if !names.contains(&called) {
            names.push(called);
        }
    }
    if names.len() == all.len() && names.len() <= FEW {
        return names.into();
    }
    let mut digest = Map::new();
    digest.insert("contains".to_owned(), names.into());
    digest.extend(free(all).map(|severity| ("none_from".to_owned(), severity.into())));
    Value::Object(digest)
}

/// The least severity such that no finding has it or a higher one.
fn free(findings: &[Value]) -> Option<&'static str> {
    let mut lightest_first = Severity::NAMES.iter().rev();
    lightest_first.find(|(_, severity)| !findings.iter().any(|value| is_from(value, *severity))).map(|(name, _)| *name)
}

fn list<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default()
}

/// The values of some keys; nested keys with a dot.
fn picked(value: &Value, keys: &[&str]) -> Map<String, Value> {
    let found = keys.iter().filter_map(|key| {
        let inner = key.split('.').try_fold(value, |value, step| value.get(step))?;
        (!inner.is_null()).then(|| ((*key).to_owned(), inner.clone()))
    });
    found.collect()
}
