//! Conditions and clamping.

use std::collections::{BTreeMap, BTreeSet};
use technolog_note::note;

use crate::knowledge::form::Form;
use crate::knowledge::yaml::{Node, NodeKind};

use crate::units::Micrometres;

use super::Reader;
use crate::audit::file::{self, Card, Factors};
use crate::audit::finding::Section;
use crate::audit::limits;
use crate::audit::quantity::Quantity;
use crate::audit::stated::{Clamping, Conditions, Factor, Row, StatedValue};
use crate::part::{Part, Point};
use crate::plan::Limit;

impl Reader<'_> {
    pub(super) fn conditions(&mut self, node: &Node, rows: &[Row]) -> Vec<Conditions> {
        let items = self.problems.list(node).unwrap_or_default();
        let (mut all, mut named): (Vec<Conditions>, BTreeSet<usize>) = (Vec::new(), BTreeSet::new());
        for node in limits::rows(items, |own| &own.place, &mut self.problems) {
            let Some(conditions) = self.read_entry(node, rows) else { continue };
            let twice = conditions.rows.iter().find(|row| named.contains(*row));
            if let Some(row) = twice.and_then(|row| rows.get(*row)) {
                let message = note!("planfile-row-has-conditions-already", row = row.number);
                let _ = self.problems.error_help::<()>(
                    "duplicate-row",
                    message,
                    &conditions.place,
                    note!("planfile-name-every-row-once"),
                );
            }
            named.extend(&conditions.rows);
            all.push(conditions);
        }
        all
    }

    fn read_entry(&mut self, node: &Node, rows: &[Row]) -> Option<Conditions> {
        let mut fields = self.problems.map(node)?;
        let named = fields.need(file::Conditions::r#for, &mut self.problems).map(|node| self.rows_named(node, rows));
        let card = fields.take(file::Conditions::card);
        let factors_node = fields.take(file::Conditions::factors);
        let limited_by = fields.take(file::Conditions::limited_by).and_then(|node| self.choice(node, &Limit::NAMES));
        let mut figures = self.figures(Section::Conditions, &mut fields);
        fields.finish(&mut self.problems);
        if let Some(mut fields) = card.and_then(|node| self.problems.map::<Card>(node)) {
            figures.extend(self.figures_under(Section::Conditions, "card.", &mut fields));
            fields.finish(&mut self.problems);
        }
        let mut factors = BTreeMap::new();
        if let Some(mut fields) = factors_node.and_then(|node| self.problems.map(node)) {
            for key in Factors::KEYS {
                let quantity = Quantity::of_key(&format!("factors.{}", key.name()));
                if let Some((quantity, node)) = quantity.zip(fields.take(*key)) {
                    factors.insert(quantity, self.factors(node));
                }
            }
            fields.finish(&mut self.problems);
        }
        let place = node.place.clone();
        let is_limited = limited_by.is_some_and(|limit| limit != Limit::CuttingSpeed);
        Some(Conditions { place, rows: named?, is_limited, rounds: false, factors, figures })
    }

    /// Points in the coordinates of the part: `[[0, -130], [0, 130]]`, mm.
    fn points(&mut self, node: &Node) -> Vec<Point> {
        let items = self.problems.list(node).unwrap_or_default();
        let mut points = Vec::new();
        for item in items {
            let two = match &item.kind {
                NodeKind::Seq(two) if two.len() == 2 => two.as_slice(),
                _ => &[],
            };
            let [x, y] = two else {
                let help = note!("part-give-each-point-brackets-own");
                self.problems.error_help::<()>("bad-value", note!("planfile-point-expected-here"), &item.place, help);
                continue;
            };
            let mut length = |node: &Node| self.figure(node).map(|figure| Micrometres::from_mm_rounded(figure.value));
            points.extend(length(x).zip(length(y)).map(|(x, y)| Point { x, y }));
        }
        points
    }

    /// Factors by name; one without a value is only named.
    fn factors(&mut self, node: &Node) -> Vec<Factor> {
        let NodeKind::Map(entries) = &node.kind else {
            let message = note!("yaml-mapping-expected-here", kind_name = node.kind_name());
            let _ = self.problems.error_help::<()>(
                "bad-value",
                message,
                &node.place,
                note!("planfile-name-factors-material"),
            );
            return Vec::new();
        };
        let mut factors = Vec::new();
        for (key, node) in limits::factors(entries, |(key, _)| &key.place, &mut self.problems) {
            let name = StatedValue { value: key.text.clone(), place: key.place.clone() };
            let value = if node.is_null() { None } else { self.figure(node) };
            factors.push(Factor { name, value });
        }
        factors
    }

    pub(super) fn clamping(&mut self, node: &Node, rows: &[Row], part: &Part) -> Option<Clamping> {
        let mut fields = self.problems.map(node)?;
        let row = fields.take(file::Clamping::r#for).and_then(|node| match self.rows_named(node, rows).as_slice() {
            [value] => Some(StatedValue { value: *value, place: node.place.clone() }),
            [] => None,
            _ => {
                let help = note!("planfile-name-one-whose-torque-largest");
                self.problems.error_help("bad-value", note!("planfile-part-clamped-for-one-row"), &node.place, help)
            }
        });
        let hole = self.hole(&mut fields, file::Clamping::hole, part);
        let at = fields.take(file::Clamping::at).map(|node| self.points(node)).unwrap_or_default();
        let screw = self.text_of(&mut fields, file::Clamping::screw).map(|text| {
            // Cyrillic М is typed as often as the Latin letter.
            StatedValue { value: text.value.replace('М', "M"), ..text }
        });
        let designation = self.text_of(&mut fields, file::Clamping::designation);
        let standard = self.text_of(&mut fields, file::Clamping::standard);
        let force = fields.take(file::Clamping::force).and_then(|node| self.figure(node));
        let mut figures = self.figures(Section::Clamping, &mut fields);
        figures.extend(force.map(|force| (Quantity::ClampForce, force)));
        fields.finish(&mut self.problems);
        Some(Clamping { place: node.place.clone(), row, hole, screw, designation, standard, at, figures })
    }
}
