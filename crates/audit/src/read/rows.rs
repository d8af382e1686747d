//! The route.

use std::collections::BTreeMap;

use crate::knowledge::diagnostic::{Diagnostic, nearest};
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node};
use crate::part::Part;
use crate::plan::{Feature, Operation};
use technolog_core::lang::Lang;
use technolog_core::words::{operation_named, operations_like};
use technolog_note::{Figure, note};

use super::Reader;
use crate::audit::finding::Section;
use crate::audit::near::plain;
use crate::audit::sheet::cells;
use crate::audit::stated::{Row, StatedValue, Text};
use crate::audit::{file, limits};

impl Reader<'_> {
    pub(super) fn rows(&mut self, node: &Node, part: &Part) -> Vec<Row> {
        let items = self.problems.list(node).unwrap_or_default();
        let (mut rows, mut lines): (Vec<Row>, BTreeMap<u32, u32>) = (Vec::new(), BTreeMap::new());
        for (at, node) in limits::rows(items, |row| &row.place, &mut self.problems).iter().enumerate() {
            let number = u32::try_from(at + 1).unwrap_or(u32::MAX);
            let Some(row) = self.row(node, number, part) else { continue };
            if let Some(line) = lines.get(&row.number) {
                let message = note!("planfile-two-rows-number", row = row.number);
                let help = note!("planfile-other-stands-at-line", line = line);
                self.problems.error_help::<()>("duplicate-row", message, &row.place, help);
            } else {
                lines.insert(row.number, row.place.line);
            }
            rows.push(row);
        }
        rows
    }

    fn row(&mut self, node: &Node, number: u32, part: &Part) -> Option<Row> {
        let mut fields = self.problems.map(node)?;
        let own = fields.take(file::Row::row).and_then(|node| self.problems.scalar::<u32>(node));
        let operation = fields.need(file::Row::operation, &mut self.problems).and_then(|node| {
            // By its name in tables, or by the Ukrainian name of the report: `drill`, `свердління`, `свердлити`.
            let id =
                |text: &str| Operation::NAMES.iter().find(|(name, _)| *name == text).map(|(_, operation)| *operation);
            let named = node
                .text()
                .and_then(|text| id(text).or_else(|| Lang::all().find_map(|lang| operation_named(text, lang))));
            let value = named.or_else(|| self.no_operation(node))?;
            Some(StatedValue { value, place: node.place.clone() })
        });
        let hole = self.hole(&mut fields, file::Row::hole, part);
        let feature = fields.take(file::Row::feature).and_then(|node| self.choice(node, &Feature::NAMES));
        let step = fields.take(file::Row::step).and_then(|node| self.problems.scalar::<usize>(node));
        let setup = fields.take(file::Row::setup).and_then(|node| self.problems.scalar::<u32>(node));
        let elsewhere = fields.take(file::Row::elsewhere).and_then(|node| self.problems.boolean(node));
        let tool = fields.take(file::Row::tool).and_then(|node| self.tool_number(node));
        let scheme = self.text_of(&mut fields, file::Row::scheme);
        let table = self.text_of(&mut fields, file::Row::table);
        let figures = self.figures(Section::Route, &mut fields);
        fields.finish(&mut self.problems);
        let number = own.unwrap_or(number);
        if operation.is_none() {
            self.unread_rows.push((number, tool.as_ref().map(|tool| tool.value)));
        }
        Some(Row {
            number,
            place: node.place.clone(),
            operation: operation?,
            hole,
            feature,
            step,
            setup,
            elsewhere: elsewhere.unwrap_or_default(),
            tool,
            scheme,
            table,
            figures,
        })
    }

    /// The group of holes that a field names.
    pub(super) fn hole<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>, part: &Part) -> Option<Text> {
        let mut hole = self.text_of(fields, key)?;
        // A Cyrillic letter that looks like the Latin one in the part means that letter.
        let alike: Vec<&str> = part
            .holes
            .iter()
            .map(|known| known.name.as_str())
            .filter(|name| plain(name) == plain(&hole.value))
            .collect();
        if let ([one], false) = (alike.as_slice(), alike.contains(&hole.value.as_str())) {
            hole.value = (*one).to_owned();
        }
        let is_known = |name: &str| part.holes.iter().any(|known| known.name == name);
        if !is_known(&hole.value)
            && let Some(name) = cells::by_size(&hole.value, part)
        {
            hole.value = name;
        }
        // The rows below an empty cell name the hole of that one place, too.
        let told = |one: &Diagnostic| one.code == "unknown-hole" && one.place.as_ref() == Some(&hole.place);
        if !is_known(&hole.value) && !self.problems.0.iter().any(told) {
            let names = || part.holes.iter().map(|hole| hole.name.as_str());
            let help = match nearest(&hole.value, names()) {
                Some(near) => note!("cli-did-you-mean", name = near),
                None => note!("planfile-part-has", names = limits::listed(names())),
            };
            let message = note!("planfile-part-has-no-group-holes", value = hole.value);
            self.problems.error_help::<()>("unknown-hole", message, &hole.place, help);
        }
        Some(hole)
    }

    /// The refusal of what is no operation, with those it may mean.
    fn no_operation(&mut self, node: &Node) -> Option<Operation> {
        let text = self.problems.text(node)?;
        if text.is_ascii() {
            return self.choice(node, Operation::NAMES);
        }
        let like = operations_like(text, Lang::UK);
        let message = note!("planfile-no-operation", name = text);
        let help = if like.is_empty() {
            let all = Operation::NAMES.iter().map(|(name, _)| *name);
            note!("planfile-operations", known = Figure::operations(all))
        } else {
            note!("planfile-operations-like", known = Figure::operations(like))
        };
        self.problems.error_help("bad-value", message, &node.place, help)
    }

    /// `T2`, or `2`; also with the Cyrillic letter, which is typed as often.
    pub(super) fn tool_number(&mut self, node: &Node) -> Option<StatedValue<u32>> {
        let text = self.problems.text(node)?;
        match number_of_tool(text) {
            Some(value) => Some(StatedValue { value, place: node.place.clone() }),
            None => {
                let message = note!("planfile-no-tool", text = text);
                self.problems.error_help("bad-value", message, &node.place, note!("planfile-name-by-place-t-t"))
            }
        }
    }

    /// The rows that a key `for` names: by their numbers, or by their tool, `T2`.
    pub(super) fn rows_named(&mut self, node: &Node, rows: &[Row]) -> Vec<usize> {
        let list = if node.text().is_some() {
            std::slice::from_ref(node)
        } else {
            self.problems.list(node).unwrap_or_default()
        };
        let mut named = Vec::new();
        for node in limits::rows(list, |row| &row.place, &mut self.problems) {
            let tool = node.text().filter(|text| text.starts_with(['T', 'Т'])).and_then(number_of_tool);
            let (found, unread): (Vec<usize>, bool) = if let Some(tool) = tool {
                let own = |row: &Row| row.tool.as_ref().is_some_and(|known| known.value == tool);
                let found = (0..rows.len()).filter(|at| own(&rows[*at])).collect();
                (found, self.unread_rows.iter().any(|(_, own)| *own == Some(tool)))
            } else {
                let Some(number) = self.problems.scalar::<u32>(node) else { continue };
                let found = rows.iter().position(|row| row.number == number).into_iter().collect();
                (found, self.unread_rows.iter().any(|(own, _)| *own == number))
            };
            // A reference to a row with a fault of its own is not reported.
            if found.is_empty() && !unread {
                let (message, help) = match tool {
                    Some(tool) => (
                        note!("planfile-no-row-route-has-tool", tool = tool),
                        note!("planfile-name-rows-by-their-numbers"),
                    ),
                    None => {
                        let number = node.text().unwrap_or_default();
                        (
                            note!("planfile-route-has-no-row", number = number),
                            note!("planfile-rows", known = limits::listed(rows.iter().map(|row| row.number))),
                        )
                    }
                };
                self.problems.error_help::<()>("unknown-row", message, &node.place, help);
            }
            named.extend(found);
        }
        named
    }
}

/// The number of a tool: `T2`, `Т2`, `2`.
pub(super) fn number_of_tool(text: &str) -> Option<u32> {
    text.strip_prefix(['T', 'Т']).unwrap_or(text).parse().ok().filter(|number| *number > 0)
}
