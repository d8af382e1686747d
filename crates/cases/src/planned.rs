//! The plan of a part as an answer: its own JSON with a few short keys.
//!
//! - `scheme` of a hole is `route.scheme`;
//! - `by_tables` of a hole is the route that the scheme tables give, whether it was taken or another was quicker;
//! - if the part has one group of holes, the keys of that group are at the top too.

use std::sync::LazyLock;
use technolog_note::note;

use schemars::{JsonSchema, SchemaGenerator};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::knowledge::diagnostic::nearest;
use crate::knowledge::input::show_invisible;
use crate::knowledge::yaml::{Key, Problems};
use crate::plan::{AlternativeStep, HolePlan, Plan, RouteSource, Transition};

use super::called::Pattern;
use super::expected::{Expected, ExpectedKind};

/// The short keys of a group of holes.
#[derive(Serialize, JsonSchema)]
struct Short {
    scheme: Option<String>,
    by_tables: Option<ByTables>,
}

/// The route of the scheme tables A.6 to A.10, if it can be carried out.
#[derive(Serialize, JsonSchema)]
struct ByTables {
    /// Its scheme.
    scheme: String,
    /// Its transitions.
    operations: Vec<AlternativeStep>,
    /// Whether it is finished on another machine.
    finish_elsewhere: bool,
    /// Whether it was taken.
    taken: bool,
}

impl Short {
    /// For a hole as planned, and as planned by the tables.
    fn of(hole: &HolePlan, by_tables: &HolePlan) -> Self {
        let made = |step: &Transition| AlternativeStep {
            operation: step.operation,
            diameter_mm: step.diameter_mm,
            elsewhere: step.elsewhere,
        };
        let here = |step: &&Transition| step.operation.is_of_scheme(step.elsewhere);
        let of_tables = by_tables.route.as_ref().filter(|route| route.source == RouteSource::Tables);
        let taken = |scheme: &str| {
            let own = hole.route.as_ref();
            own.is_some_and(|route| route.source == RouteSource::Tables && route.scheme == scheme)
        };
        let by_tables = of_tables.map(|route| ByTables {
            scheme: route.scheme.clone(),
            operations: by_tables.transitions.iter().filter(here).map(made).collect(),
            finish_elsewhere: route.finish_elsewhere,
            taken: taken(&route.scheme),
        });
        Self { scheme: hole.route.as_ref().map(|route| route.scheme.clone()), by_tables }
    }
}

/// The plan as a value, with the plan by the tables.
pub fn json(plan: &Plan, by_tables: &Plan) -> Value {
    let mut value = serde_json::to_value(plan).unwrap_or_default();
    let Some(holes) = value.get_mut("holes").and_then(Value::as_array_mut) else { return value };
    for ((hole, planned), by_tables) in holes.iter_mut().zip(&plan.holes).zip(&by_tables.holes) {
        let short = serde_json::to_value(Short::of(planned, by_tables));
        if let (Some(hole), Ok(Value::Object(short))) = (hole.as_object_mut(), short) {
            hole.extend(short);
        }
    }
    if let ([Value::Object(hole)], [_]) = (holes.as_slice(), plan.holes.as_slice()) {
        let hole = hole.clone();
        if let Some(plan) = value.as_object_mut() {
            for (key, inner) in hole {
                plan.entry(key).or_insert(inner);
            }
        }
    }
    value
}

/// The form of such answers: a JSON schema, and the place of a group's keys in it.
static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let mut generator = SchemaGenerator::default();
    let _ = generator.subschema_for::<Short>();
    serde_json::to_value(generator.into_root_schema_for::<Plan>()).unwrap_or_default()
});

/// Checks the keys of an expectation against those of a plan, so that a misspelt one is reported before anything is
/// planned. `groups` is the number of groups of holes.
pub fn fit(expected: &Expected, groups: usize, problems: &mut Problems) {
    let definition = |name: &str| SCHEMA.get("$defs").and_then(|all| all.get(name));
    let holes: Vec<&Value> = ["HolePlan", "Short"].into_iter().filter_map(definition).collect();
    let mut top = vec![&*SCHEMA];
    if groups == 1 {
        top.extend(&holes);
    }
    KeyCheck { holes, problems }.fit(expected, &top);
}

struct KeyCheck<'s, 'p> {
    /// What describes a group of holes.
    holes: Vec<&'s Value>,
    problems: &'p mut Problems,
}

impl<'s> KeyCheck<'s, '_> {
    fn fit(&mut self, expected: &Expected, schemas: &[&'s Value]) {
        let forms = self.forms(schemas);
        match &expected.kind {
            ExpectedKind::Open | ExpectedKind::Absent | ExpectedKind::Present | ExpectedKind::Near { .. } => {}
            ExpectedKind::Is(text) => self.called(expected, text, &forms),
            ExpectedKind::Range { keys, .. } => {
                if is_object(&forms) {
                    self.keys(keys, &forms);
                }
            }
            ExpectedKind::OneOf(several) => several.iter().for_each(|one| self.fit(one, &forms)),
            ExpectedKind::Not(one) => self.fit(one, &forms),
            ExpectedKind::List(items) => {
                let inner = inner(&forms);
                items.iter().for_each(|item| self.fit(&item.expected, &inner));
            }
            ExpectedKind::Some(part) => {
                let inner = inner(&forms);
                for one in part.all() {
                    // The number of items is no item.
                    if part.how_many.as_ref().is_none_or(|count| !std::ptr::eq(count, one)) {
                        self.fit(one, &inner);
                    }
                }
            }
            ExpectedKind::Map(keys) if is_object(&forms) => self.keys(keys, &forms),
            // Items by their names.
            ExpectedKind::Map(names) => {
                let inner = inner(&forms);
                names.iter().for_each(|(_, one)| self.fit(one, &inner));
            }
        }
    }

    /// The schemas meant by these: references resolved, alternatives listed.
    fn forms(&self, schemas: &[&'s Value]) -> Vec<&'s Value> {
        let mut forms = Vec::new();
        let mut open: Vec<&Value> = schemas.to_vec();
        while let Some(schema) = open.pop() {
            if let Some(name) = schema.get("$ref").and_then(Value::as_str).and_then(|path| path.rsplit('/').next()) {
                open.extend(SCHEMA.get("$defs").and_then(|all| all.get(name)));
                if name == "HolePlan" {
                    open.extend(&self.holes);
                    continue;
                }
            }
            for key in ["allOf", "anyOf", "oneOf"] {
                open.extend(schema.get(key).and_then(Value::as_array).into_iter().flatten());
            }
            forms.push(schema);
        }
        forms
    }

    fn keys(&mut self, keys: &[(Key, Expected)], forms: &[&'s Value]) {
        let named = |form: &&'s Value| form.get("properties").and_then(Value::as_object);
        let properties: Vec<&'s Map<String, Value>> = forms.iter().filter_map(named).collect();
        for (key, expected) in keys {
            let of_key: Vec<&Value> = properties.iter().filter_map(|own| own.get(&key.text)).collect();
            // Figures of a note have names of their own.
            let free: Vec<&Value> = forms
                .iter()
                .filter_map(|form| form.get("additionalProperties"))
                .filter(|form| form.is_object())
                .collect();
            if !of_key.is_empty() {
                self.fit(expected, &of_key);
            } else if free.is_empty() {
                let known = || properties.iter().flat_map(|own| own.keys()).map(String::as_str);
                let help = match nearest(&key.text, known()) {
                    Some(near) => note!("cli-did-you-mean", name = near),
                    None => note!("case-known-here", names = known().collect::<Vec<_>>().join(", ")),
                };
                let message = note!("yaml-unknown-key", key = show_invisible(&key.text));
                self.problems.error_help::<()>("unknown-key", message, &key.place, help);
            } else {
                self.fit(expected, &free);
            }
        }
    }

    /// Checks the short name of a transition.
    fn called(&mut self, expected: &Expected, text: &str, forms: &[&'s Value]) {
        let is_transition = |form: &&Value| form.pointer("/properties/operation").is_some();
        if let (true, Err(slip)) = (forms.iter().any(is_transition), Pattern::read(text)) {
            let message = note!("case-no-word-transition", word = slip.word);
            let help = match slip.likely {
                Some(near) => note!("cli-did-you-mean", name = near),
                None => note!("case-write-operation-then-what-known"),
            };
            self.problems.error_help::<()>("bad-value", message, &expected.place, help);
        }
    }
}

fn is_object(forms: &[&Value]) -> bool {
    forms.iter().any(|form| form.get("properties").is_some() || form.get("additionalProperties").is_some())
}

fn inner<'s>(forms: &[&'s Value]) -> Vec<&'s Value> {
    forms.iter().filter_map(|form| form.get("items").or_else(|| form.get("prefixItems"))).collect()
}
