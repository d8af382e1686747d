//! Compares two plans: where they differ, and what that costs.
//!
//! Rows are matched by hole and operation, tools and conditions by the rows they belong to. The same choice under
//! another number or at another place of the file is no difference.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::note;
use crate::plan::Operation;

use super::auditor::Auditor;
use super::context::Context;
use super::finding::{Section, Subject};
use super::graph::Graph;
use super::near::plain;
use super::quantity::{Id, Quantity, Scope};
use super::rules;
use super::stated::{Clamping, Factor, Figures, Row, Stated, StatedFigure, Text, Tool};

/// A name that a clamping states.
type NameOf = fn(&Clamping) -> &Option<Text>;

/// Two plans beside each other.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// The file of the first.
    pub a: String,
    /// The file of the second.
    pub b: String,
    /// Where they differ, by sections.
    pub differences: Vec<Difference>,
    /// The costs of both; a cost that is neither stated nor computable is left out.
    pub costs: Vec<Cost>,
}

/// A difference between the values that two plans state.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Where in the report.
    pub section: Section,
    /// The subject; tools by their place in the first plan, or in the second where only that has them.
    pub subject: Subject,
    /// The key of the figure, or `row`, `order`, `designation`, … for other things.
    #[serde(rename = "what")]
    pub key: String,
    /// The quantity of the figure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quantity: Option<Quantity>,
    /// The name of the factor, if the figure is one.
    #[serde(skip)]
    pub factor: Option<note::Figure>,
    /// In the first plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub a: Option<String>,
    /// In the second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub b: Option<String>,
}

/// A cost in both plans.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// `machine`, `rapid`, `tool_change`, `total` in min; `changes` and `places` in numbers.
    #[serde(rename = "what")]
    pub kind: &'static str,
    /// In the first plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub a: Option<f64>,
    /// In the second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub b: Option<f64>,
    /// The second minus the first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub more: Option<f64>,
}

impl Auditor<'_> {
    /// Compares two plans.
    ///
    /// # Errors
    /// The knowledge base has no answer.
    pub fn compare(&self, a: &Stated, b: &Stated) -> Result<Comparison, KnowledgeError> {
        let mut found = PlanComparison { a, b, differences: Vec::new() };
        found.rows();
        found.clamping();
        found.figures(Section::Times, &Subject::default(), &a.times, &b.times);
        let mut differences = found.differences;
        differences.sort_by_key(|difference| difference.section);
        let costs = costs(&self.expenses(a)?, &self.expenses(b)?);
        Ok(Comparison { a: a.file.clone(), b: b.file.clone(), differences, costs })
    }

    /// The costs of a plan, as stated or else computed from its own figures.
    fn expenses(&self, stated: &Stated) -> Result<Vec<(&'static str, Option<f64>)>, KnowledgeError> {
        let ours = self.own_plan(stated)?;
        let context = Context::new(stated, &ours, self)?;
        let mut graph = Graph::new(stated, self.tolerances());
        rules::add(&context, &mut graph)?;
        let times = [Quantity::MachineTime, Quantity::RapidTime, Quantity::ChangeTime, Quantity::TotalTime];
        let time = |quantity: Quantity| (quantity.key(), graph.written(Id::new(Scope::Times, quantity)));
        let mut all: Vec<(&str, Option<f64>)> = times.into_iter().map(time).collect();
        let changes = context.changes();
        let places: BTreeSet<u32> = changes.iter().copied().collect();
        let counted = |count: usize| (count > 0).then_some(count as f64);
        all.push(("changes", counted(changes.len())));
        all.push(("places", counted(places.len())));
        Ok(all)
    }
}

fn costs(a: &[(&'static str, Option<f64>)], b: &[(&'static str, Option<f64>)]) -> Vec<Cost> {
    let both = a.iter().zip(b).filter(|(a, b)| a.1.is_some() || b.1.is_some());
    let rounded = |value: f64| crate::units::round_to(value, 4);
    both.map(|((kind, a), (_, b))| Cost {
        kind,
        a: a.map(rounded),
        b: b.map(rounded),
        more: a.zip(*b).map(|(a, b)| rounded(b - a)),
    })
    .collect()
}

struct PlanComparison<'s> {
    a: &'s Stated,
    b: &'s Stated,
    differences: Vec<Difference>,
}

/// The key of a row: its hole, its operation, and its count among rows with both the same, from 0.
fn names(stated: &Stated) -> Vec<(Option<&str>, Operation, usize)> {
    let mut names: Vec<(Option<&str>, Operation, usize)> = Vec::new();
    for row in &stated.rows {
        let (hole, operation) = (row.hole.as_ref().map(|hole| hole.value.as_str()), row.operation.value);
        let before = names.iter().filter(|(known, other, _)| *known == hole && *other == operation).count();
        names.push((hole, operation, before));
    }
    names
}

impl PlanComparison<'_> {
    fn rows(&mut self) {
        let (a, b) = (self.a, self.b);
        let (names_a, names_b) = (names(a), names(b));
        let pairs: Vec<(usize, usize)> = names_a
            .iter()
            .enumerate()
            .filter_map(|(at, name)| Some((at, names_b.iter().position(|other| other == name)?)))
            .collect();
        if !pairs.is_sorted_by_key(|(_, b)| *b) {
            let order = |stated: &Stated, rows: Vec<usize>| {
                let number = |at: usize| stated.rows.get(at).map_or(0, |row| row.number).to_string();
                rows.into_iter().map(number).collect::<Vec<_>>().join(", ")
            };
            let of_a = order(a, pairs.iter().map(|(at, _)| *at).collect());
            let of_b = order(b, pairs.iter().map(|(_, at)| *at).collect());
            self.push_difference(Section::Route, &Subject::default(), "order", Some(of_a), Some(of_b));
        }
        for (_, row) in a.rows.iter().enumerate().filter(|(at, _)| !pairs.iter().any(|(own, _)| own == at)) {
            self.push_difference(Section::Route, &of_row(row), "row", Some(row.number.to_string()), None);
        }
        for (_, row) in b.rows.iter().enumerate().filter(|(at, _)| !pairs.iter().any(|(_, own)| own == at)) {
            self.push_difference(Section::Route, &of_row(row), "row", None, Some(row.number.to_string()));
        }
        // The same tool serves several rows, and so do the same conditions.
        let (mut tools, mut conditions) = (BTreeSet::new(), BTreeSet::new());
        for (at, other) in pairs {
            let (Some(one), Some(two)) = (a.rows.get(at), b.rows.get(other)) else { continue };
            let subject = of_row(one);
            self.text(Section::Route, &subject, "scheme", &one.scheme, &two.scheme);
            self.text(Section::Route, &subject, "table", &one.table, &two.table);
            self.figures(Section::Route, &subject, &one.figures, &two.figures);
            let number = |row: &Row| row.tool.as_ref().map(|tool| format!("T{}", tool.value));
            if number(one) != number(two) {
                self.push_difference(Section::Route, &subject, "tool", number(one), number(two));
            }
            if let (Some(one), Some(two)) = (a.tool_of(one), b.tool_of(two))
                && tools.insert((one, two))
                && let (Some(one), Some(two)) = (a.tools.get(one), b.tools.get(two))
            {
                self.tool(one, two);
            }
            let pair = (a.conditions_of(at), b.conditions_of(other));
            if conditions.insert(pair) {
                self.conditions(&subject, pair);
            }
        }
    }

    fn tool(&mut self, a: &Tool, b: &Tool) {
        let subject = Subject { tool: Some(a.number), ..Subject::default() };
        self.text(Section::Tools, &subject, "designation", &a.designation, &b.designation);
        self.text(Section::Tools, &subject, "standard", &a.standard, &b.standard);
        self.text(Section::Tools, &subject, "table", &a.table, &b.table);
        self.text(Section::Tools, &subject, "shank", &a.shank, &b.shank);
        self.text(Section::Holders, &subject, "holder", &a.holder, &b.holder);
        self.text(Section::Holders, &subject, "standard", &a.holder_standard, &b.holder_standard);
        self.text(Section::Lengths, &subject, "with", &a.correction_word, &b.correction_word);
        self.figures(Section::Lengths, &subject, &a.figures, &b.figures);
    }

    fn conditions(&mut self, subject: &Subject, (a, b): (Option<usize>, Option<usize>)) {
        let none = Figures::new();
        let (a, b) = (a.and_then(|at| self.a.conditions.get(at)), b.and_then(|at| self.b.conditions.get(at)));
        let [one, two] = [a, b].map(|own| own.map_or(&none, |conditions| &conditions.figures));
        self.figures(Section::Conditions, subject, one, two);
        // Factors of conditions that only one plan has are not listed: their results are.
        let (Some(a), Some(b)) = (a, b) else { return };
        let quantities: BTreeSet<Quantity> = a.factors.keys().chain(b.factors.keys()).copied().collect();
        for quantity in quantities {
            let [a, b] = [a, b].map(|own| own.factors.get(&quantity).map(Vec::as_slice).unwrap_or_default());
            let names: BTreeSet<&str> = a.iter().chain(b).map(|factor| factor.name.value.as_str()).collect();
            for name in names {
                let value = |own: &[Factor]| {
                    own.iter().find(|factor| factor.name.value == name).and_then(|factor| factor.value.clone())
                };
                self.figure(Section::Conditions, subject, quantity, Some(name), value(a).as_ref(), value(b).as_ref());
            }
        }
    }

    fn clamping(&mut self) {
        let (a, b) = (self.a.clamping.as_ref(), self.b.clamping.as_ref());
        let subject = Subject::default();
        let none = Figures::new();
        let [one, two] = [a, b].map(|own| own.map_or(&none, |clamping| &clamping.figures));
        self.figures(Section::Clamping, &subject, one, two);
        let names: [(&str, NameOf); 3] =
            [("screw", |own| &own.screw), ("designation", |own| &own.designation), ("standard", |own| &own.standard)];
        for (key, name) in names {
            let [one, two] = [a, b].map(|own| own.map_or(&None, name));
            self.text(Section::Clamping, &subject, key, one, two);
        }
    }

    fn figures(&mut self, section: Section, subject: &Subject, a: &Figures, b: &Figures) {
        let quantities: BTreeSet<Quantity> = a.keys().chain(b.keys()).copied().collect();
        for quantity in quantities {
            self.figure(section, subject, quantity, None, a.get(&quantity), b.get(&quantity));
        }
    }

    fn figure(
        &mut self,
        section: Section,
        subject: &Subject,
        quantity: Quantity,
        name: Option<&str>,
        a: Option<&StatedFigure>,
        b: Option<&StatedFigure>,
    ) {
        let same = match (a, b) {
            // 26.5 and 26.50 are the same figure.
            (Some(a), Some(b)) => (a.value - b.value).abs() <= 1e-9 * b.value.abs().max(1.0),
            (a, b) => a.is_none() && b.is_none(),
        };
        if !same {
            let text = |figure: Option<&StatedFigure>| figure.map(|figure| figure.text.clone());
            let key = quantity.key();
            let what = name.map_or_else(|| key.to_owned(), |name| format!("{key}.{name}"));
            self.push_difference(section, subject, &what, text(a), text(b));
            if let Some(last) = self.differences.last_mut() {
                last.quantity = Some(quantity);
                last.factor = name.map(|name| self.a.factor(name));
            }
        }
    }

    fn text(&mut self, section: Section, subject: &Subject, what: &str, a: &Option<Text>, b: &Option<Text>) {
        let [one, two] = [a, b].map(|text| text.as_ref().map(|text| text.value.clone()));
        // The same name with another dash or space is the same.
        if one.as_deref().map(plain) != two.as_deref().map(plain) {
            self.push_difference(section, subject, what, one, two);
        }
    }

    fn push_difference(
        &mut self,
        section: Section,
        subject: &Subject,
        what: &str,
        a: Option<String>,
        b: Option<String>,
    ) {
        let (subject, what) = (subject.clone(), what.to_owned());
        self.differences.push(Difference { section, subject, key: what, quantity: None, factor: None, a, b });
    }
}

fn of_row(row: &Row) -> Subject {
    let holes = row.hole.iter().map(|hole| hole.value.clone()).collect();
    Subject { operation: Some(row.operation.value), holes, tool: None }
}
