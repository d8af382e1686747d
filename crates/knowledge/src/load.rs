//! From a YAML file to a table, collecting every problem of the file with its place.

use crate::cell::{TestError, parse_test};
use crate::column::{Column, ColumnRole, ColumnType, Label};
use crate::contract::Word;
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::form::AnyKeys;
use crate::set::Set;
use crate::table::{Cell, Correction, HitPolicy, Law, Row, Source, Table, TableKind, ToolHead, Uncovered};
use crate::units::Unit;
use crate::value::Value;
use crate::vocabulary::{Operation, Shank, ToolMaterial, Vocabularies, Words};
use crate::yaml::{Fields, Node, NodeKind, Problems, parse};
use technolog_note::note;

const HEAD: &[&str] = &[
    "table",
    "title",
    "kind",
    "hit",
    "place",
    "standard",
    "note",
    "result",
    "key",
    "columns",
    "rows",
    "uncovered",
    "laws",
    "tool",
];
const COLUMN: &[&str] = &[
    "name", "type", "unit", "symbol", "label", "role", "list", "optional", "values", "of", "domain", "default",
    "refers",
];
/// The keys of a row that are not columns.
const ROW: &[&str] = &["source", "place", "reason", "unconfirmed", "choice", "corrections", "note", "priority"];

/// Reads a table from the text of its file.
///
/// # Errors
/// Every problem found, each with its place.
pub fn table_from_text(file: &str, text: &str) -> Result<Table, Vec<Diagnostic>> {
    table_with(file, text, &Vocabularies::of_code())
}

/// As [`table_from_text`], with the vocabularies that enum columns may name.
///
/// # Errors
/// Every problem found, each with its place.
pub fn table_with(file: &str, text: &str, vocabularies: &Vocabularies) -> Result<Table, Vec<Diagnostic>> {
    let (root, diagnostics) = parse(file, text);
    let mut problems = Problems(diagnostics);
    let table = root.and_then(|root| Loader { file, vocabularies, problems: &mut problems }.table(&root));
    let broken = problems.0.iter().any(|problem| problem.severity == Severity::Error);
    match table {
        Some(table) if !broken => Ok(table),
        _ => Err(problems.0),
    }
}

struct Loader<'a> {
    file: &'a str,
    vocabularies: &'a Vocabularies,
    problems: &'a mut Problems,
}

impl Loader<'_> {
    fn table(&mut self, root: &Node) -> Option<Table> {
        let mut head = self.problems.open_map(root)?;
        let id = head.need("table", self.problems).and_then(|node| self.owned(node));
        let title = head.need("title", self.problems).and_then(|node| self.label(node));
        let kind = match head.need("kind", self.problems) {
            Some(node) => self.named(node, &[("catalog", TableKind::Catalog), ("decision", TableKind::Decision)]),
            None => None,
        };
        let hit_node = head.take("hit");
        let hit = match hit_node {
            Some(node) => self.named(node, &HitPolicy::NAMES),
            None => Some(HitPolicy::Unique),
        };
        let place = head.need("place", self.problems).and_then(|node| self.owned(node));
        let standard = head.take("standard").and_then(|node| self.owned(node));
        let notes = head.take("note").map(|node| self.texts(node)).unwrap_or_default();
        let result_node = head.take("result");
        let key_node = head.take("key");
        let columns_node = head.need("columns", self.problems);
        let rows_node = head.need("rows", self.problems);
        let uncovered_node = head.take("uncovered");
        let laws = head.take("laws").map(|node| self.laws(node)).unwrap_or_default();
        let tool = head.take("tool").and_then(|node| self.tool(node));
        head.finish(HEAD, self.problems);

        let kind = kind?;
        let columns = self.columns(columns_node?, kind)?;
        let result = result_node.map(|node| self.column_names(node, &columns)).unwrap_or_default();
        let key = key_node.map(|node| self.column_names(node, &columns)).unwrap_or_default();
        let rows = self.rows(rows_node?, &columns, hit.unwrap_or(HitPolicy::Unique));
        let uncovered = uncovered_node.map(|node| self.uncovered(node, &columns)).unwrap_or_default();
        if kind == TableKind::Catalog && (hit_node.is_some() || uncovered_node.is_some()) {
            self.problems.error::<()>("bad-head", note!("table-catalog-has-neither-hit-nor"), &root.place);
        }
        Some(Table {
            id: id?,
            title: title?,
            kind,
            hit: hit?,
            place: place?,
            standard,
            notes,
            result,
            key,
            columns,
            rows,
            uncovered,
            laws,
            tool,
            file: self.file.to_owned(),
            columns_line: columns_node.map_or(1, |node| node.place.line),
            index: std::sync::OnceLock::new(),
            layout: std::sync::OnceLock::new(),
        })
    }

    fn owned(&mut self, node: &Node) -> Option<String> {
        self.problems.text(node).map(str::to_owned)
    }

    fn named<T: Copy>(&mut self, node: &Node, names: &[(&str, T)]) -> Option<T> {
        let text = self.problems.text(node)?;
        if let Some((_, value)) = names.iter().find(|(name, _)| *name == text) {
            return Some(*value);
        }
        let known: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        let message = note!("table-none", text = text, known = known.join(", "));
        self.problems.error("bad-value", message, &node.place)
    }

    fn label(&mut self, node: &Node) -> Option<Label> {
        let mut fields = self.problems.open_map(node)?;
        let uk = fields.need("uk", self.problems).and_then(|node| self.owned(node));
        let en = fields.need("en", self.problems).and_then(|node| self.owned(node));
        fields.finish(&["uk", "en"], self.problems);
        Some(Label { uk: uk?, en: en? })
    }

    /// A text, or a list of texts.
    fn texts(&mut self, node: &Node) -> Vec<String> {
        match &node.kind {
            NodeKind::Seq(items) => items.iter().filter_map(|item| self.owned(item)).collect(),
            _ => self.owned(node).into_iter().collect(),
        }
    }

    fn column_names(&mut self, node: &Node, columns: &[Column]) -> Vec<String> {
        let names = self.texts(node);
        for name in &names {
            if !columns.iter().any(|column| column.name == *name) {
                let known: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
                self.problems.error_help::<()>(
                    "unknown-column",
                    note!("table-no-column", name = name),
                    &node.place,
                    note!("table-columns", known = known.join(", ")),
                );
            }
        }
        names
    }

    fn tool(&mut self, node: &Node) -> Option<ToolHead> {
        let mut fields = self.problems.open_map(node)?;
        let operations = fields.need("operations", self.problems).map(|node| self.operations(node));
        let shank: Option<Shank> = fields.need("shank", self.problems).and_then(|node| self.word(node));
        let material: Option<ToolMaterial> = fields.need("material", self.problems).and_then(|node| self.word(node));
        let point_angle = fields.take("point_angle").and_then(|node| self.problems.scalar(node));
        let teeth = fields.take("teeth").and_then(|node| self.problems.scalar(node));
        let centre_cutting =
            fields.take("centre_cutting").and_then(|node| self.problems.boolean(node)).unwrap_or(false);
        let known = ["operations", "shank", "material", "point_angle", "teeth", "centre_cutting"];
        fields.finish(&known, self.problems);
        let (operations, shank, material) = (operations?, shank?, material?);
        Some(ToolHead { operations, shank, material, point_angle, teeth, centre_cutting })
    }

    fn operations(&mut self, node: &Node) -> Vec<Operation> {
        let items = self.problems.list(node).unwrap_or_default();
        items.iter().filter_map(|item| self.word(item)).collect()
    }

    fn word<W: Word>(&mut self, node: &Node) -> Option<W> {
        let names: Vec<(&str, W)> = W::WORDS.iter().filter_map(|word| Some((*word, W::from_word(word)?))).collect();
        self.named(node, &names)
    }

    fn laws(&mut self, node: &Node) -> Vec<Law> {
        let mut laws = Vec::new();
        for item in self.problems.list(node).unwrap_or_default() {
            let Some(mut fields) = self.problems.open_map(item) else { continue };
            let name = fields.need("law", self.problems).and_then(|node| self.owned(node));
            let parameters = fields
                .remaining()
                .into_iter()
                .map(|(key, node)| (key.text.clone(), self.texts(node).join(" ")))
                .collect();
            if let Some(name) = name {
                laws.push(Law { name, parameters, place: Some(item.place.clone()) });
            }
        }
        laws
    }

    fn columns(&mut self, node: &Node, kind: TableKind) -> Option<Vec<Column>> {
        let mut columns: Vec<Column> = Vec::new();
        let mut sound = true;
        for item in self.problems.list(node)? {
            match self.column(item, kind) {
                Some(column) if columns.iter().any(|known| known.name == column.name) => {
                    let message = note!("table-column-stands-twice", column = column.name);
                    self.problems.error::<()>("duplicate-column", message, &item.place);
                }
                Some(column) => columns.push(column),
                None => sound = false,
            }
        }
        // Rows are read only if the columns are sound: otherwise one mistake would appear as hundreds.
        sound.then_some(columns)
    }

    fn column(&mut self, node: &Node, kind: TableKind) -> Option<Column> {
        let mut fields = self.problems.open_map(node)?;
        let name = fields.need("name", self.problems).and_then(|node| self.owned(node));
        if let Some(reserved) = name.as_deref().filter(|name| ROW.contains(name)) {
            let message = note!("table-key-every-row-cannot-name", reserved = reserved);
            self.problems.error::<()>("bad-value", message, fields.place);
        }
        let ty = match fields.need("type", self.problems) {
            Some(node) => self.named(node, &ColumnType::NAMES),
            None => None,
        };
        let unit_node = fields.take("unit");
        let symbol = fields.take("symbol").and_then(|node| self.owned(node));
        let label = fields.take("label").and_then(|node| self.label(node));
        let role_node = fields.take("role");
        let role = match (kind, role_node) {
            (TableKind::Decision, Some(node)) => {
                self.named(node, &[("input", ColumnRole::Input), ("output", ColumnRole::Output)])
            }
            (TableKind::Decision, None) => {
                self.problems.error("missing-key", note!("table-column-decision-table-needs-role"), fields.place)
            }
            (TableKind::Catalog, Some(node)) => {
                self.problems.error("bad-value", note!("table-catalogs-columns-have-no-role"), &node.place)
            }
            (TableKind::Catalog, None) => Some(ColumnRole::Field),
        };
        let list = fields.take("list").and_then(|node| self.problems.boolean(node)).unwrap_or(false);
        let optional = fields.take("optional").and_then(|node| self.problems.boolean(node)).unwrap_or(false);
        let vocabulary_node = fields.take("of");
        let vocabulary = vocabulary_node.and_then(|node| self.owned(node));
        let Words { words: mut values, names } = match (vocabulary_node, &vocabulary) {
            (Some(node), Some(name)) => self.vocabulary(node, name)?,
            _ => Words::default(),
        };
        values.extend(fields.take("values").map(|node| self.texts(node)).unwrap_or_default());
        let domain_node = fields.take("domain");
        let default_node = fields.take("default");
        let refers = fields.take("refers").and_then(|node| self.refers(node));
        let place = fields.place;
        fields.finish(COLUMN, self.problems);

        let (name, ty, role) = (name?, ty?, role?);
        let unit = self.unit(unit_node, ty, &name, place)?;
        if (ty == ColumnType::Enum) == values.is_empty() {
            let message = note!("table-column-values-belong-enum-enum", name = name);
            return self.problems.error("bad-value", message, place);
        }
        if matches!(ty, ColumnType::Text | ColumnType::Unit) && role == ColumnRole::Input {
            let message = note!("table-input-cannot-free-text", name = name);
            return self.problems.error_help("bad-value", message, place, note!("table-make-enum-with-values"));
        }
        let mut column = Column {
            name,
            ty,
            unit,
            symbol,
            label,
            role,
            list,
            optional,
            values,
            names,
            vocabulary,
            domain: None,
            domain_text: None,
            default: None,
            refers,
            place: Some(place.clone()),
        };
        if let Some(node) = domain_node {
            let (domain, text) = self.domain(node, &column)?;
            column.domain = Some(domain);
            column.domain_text = Some(text);
        }
        if let Some(node) = default_node {
            let text = self.problems.text(node)?;
            match column.parse_value(text) {
                Ok(value) => column.default = Some(value),
                Err(message) => return self.problems.error("bad-value", message, &node.place),
            }
        }
        Some(column)
    }

    /// The words of a vocabulary.
    fn vocabulary(&mut self, node: &Node, name: &str) -> Option<Words> {
        if let Some(words) = self.vocabularies.words(name) {
            return Some(words.clone());
        }
        let known: Vec<&str> = self.vocabularies.names().collect();
        self.problems.error_help(
            "unknown-vocabulary",
            note!("table-there-no-vocabulary", name = name),
            &node.place,
            note!("table-vocabularies", known = known.join(", ")),
        )
    }

    fn unit(&mut self, node: Option<&Node>, ty: ColumnType, name: &str, place: &Place) -> Option<Unit> {
        let Some(node) = node else {
            let default = ty.default_unit();
            if default.is_none() {
                let message = note!("table-column-type-needs-unit", name = name, kind = ty.name());
                self.problems.error::<()>("missing-unit", message, place);
            }
            return default;
        };
        let unit: Unit = self.problems.scalar(node)?;
        if ty.accepts(unit) {
            return Some(unit);
        }
        let fitting: Vec<&str> = Unit::ALL.iter().filter(|unit| ty.accepts(**unit)).map(|unit| unit.text()).collect();
        self.problems.error_help(
            "wrong-unit",
            note!("table-column-type-cannot", name = name, kind = ty.name(), unit = unit),
            &node.place,
            note!("table-unit", fitting = fitting.join(" or ")),
        )
    }

    fn domain(&mut self, node: &Node, column: &Column) -> Option<(Set, String)> {
        let text = match &node.kind {
            NodeKind::Seq(_) => self.texts(node).join(" | "),
            _ => self.owned(node)?,
        };
        match parse_test(&text, column) {
            Ok(set) => Some((set, text)),
            Err(error) => self.test_error(&error, node),
        }
    }

    fn refers(&mut self, node: &Node) -> Option<(String, String)> {
        let mut fields = self.problems.open_map(node)?;
        let table = fields.need("table", self.problems).and_then(|node| self.owned(node));
        let column = fields.need("column", self.problems).and_then(|node| self.owned(node));
        fields.finish(&["table", "column"], self.problems);
        Some((table?, column?))
    }

    fn rows(&mut self, node: &Node, columns: &[Column], hit: HitPolicy) -> Vec<Row> {
        let items = self.problems.list(node).unwrap_or_default();
        items.iter().filter_map(|item| self.row(item, columns, hit)).collect()
    }

    fn row(&mut self, node: &Node, columns: &[Column], hit: HitPolicy) -> Option<Row> {
        let mut fields = self.problems.open_map(node)?;
        let mut cells = Vec::with_capacity(columns.len());
        let mut places = Vec::with_capacity(columns.len());
        let mut sound = true;
        for column in columns {
            let node = fields.take(column.name.as_str());
            places.push(node.map(|node| node.place.clone()));
            match self.cell(node, column, fields.place) {
                Some(cell) => cells.push(cell),
                None => sound = false,
            }
        }
        let source = match fields.take("source") {
            Some(node) => self.named(node, &Source::NAMES),
            None => self.problems.error_help(
                "no-source",
                note!("table-row-has-no-source"),
                fields.place,
                note!("table-say-source-seed-standard-reconstructed"),
            ),
        };
        let place = fields.take("place").and_then(|node| self.owned(node));
        let reason = fields.take("reason").and_then(|node| self.owned(node));
        let unconfirmed = fields.take("unconfirmed").and_then(|node| self.owned(node));
        let choice = fields.take("choice").and_then(|node| self.owned(node));
        // A figure of a source was not chosen here, and what the world could prove wrong is no choice.
        if choice.is_some() && (unconfirmed.is_some() || source.is_some_and(|source| source != Source::Reconstructed)) {
            let message = note!("table-choice-is-reconstructed-alone");
            self.problems.error::<()>("bad-value", message, fields.place);
        }
        let is_choice = choice.is_some();
        let unconfirmed = unconfirmed.or(choice);
        let corrections = fields.take("corrections").map(|node| self.corrections(node, columns)).unwrap_or_default();
        let note = fields.take("note").and_then(|node| self.owned(node));
        let priority_node = fields.take("priority");
        let priority: Option<i64> = priority_node.and_then(|node| self.problems.scalar(node));
        if (hit == HitPolicy::Priority) != priority_node.is_some() {
            let message = note!("table-priority-belongs-every-row-table");
            self.problems.error::<()>("bad-value", message, fields.place);
        }
        if source == Some(Source::Reconstructed) && reason.is_none() {
            let message = note!("table-reconstructed-row-must-say-from");
            self.problems.error::<()>("no-reason", message, fields.place);
        }
        let line = fields.place.line;
        let known: Vec<&str> = columns.iter().map(|column| column.name.as_str()).chain(ROW.iter().copied()).collect();
        fields.finish(&known, self.problems);
        if !sound {
            return None;
        }
        Some(Row {
            cells,
            source: source?,
            place,
            reason,
            unconfirmed,
            is_choice,
            corrections,
            note,
            priority,
            line,
            places,
        })
    }

    fn cell(&mut self, node: Option<&Node>, column: &Column, row: &Place) -> Option<Cell> {
        let Some(node) = node else {
            if column.role == ColumnRole::Input {
                return Some(Cell::Test(column.allowed(), "-".to_owned()));
            }
            if column.optional {
                return Some(Cell::Empty);
            }
            return self.problems.error("missing-cell", note!("table-row-has-no", column = column.name), row);
        };
        if column.role == ColumnRole::Input {
            let text = self.problems.text(node)?.to_owned();
            return match parse_test(&text, column) {
                Ok(set) => Some(Cell::Test(set, text)),
                Err(error) => self.test_error(&error, node),
            };
        }
        if column.list {
            let items = self.problems.list(node)?;
            let values: Vec<Value> = items.iter().filter_map(|item| self.value(item, column)).collect();
            return (values.len() == items.len()).then_some(Cell::Value(Value::List(values)));
        }
        self.value(node, column).map(Cell::Value)
    }

    fn value(&mut self, node: &Node, column: &Column) -> Option<Value> {
        let text = self.problems.text(node)?;
        let value = match column.parse_value(text) {
            Ok(value) => value,
            Err(message) => {
                let message = note!("table-column", column = column.name, message = message);
                return self.problems.error("bad-value", message, &node.place);
            }
        };
        if let (Some(domain), Some(rank)) = (&column.domain, column.rank(&value))
            && !domain.contains(rank)
        {
            let domain = column.domain_text.as_deref().unwrap_or_default();
            let message =
                note!("table-column-outside-columns-domain", column = column.name, text = text, domain = domain);
            return self.problems.error("out-of-domain", message, &node.place);
        }
        Some(value)
    }

    fn corrections(&mut self, node: &Node, columns: &[Column]) -> Vec<Correction> {
        let Some(mut fields) = self.problems.open_map(node) else { return Vec::new() };
        let mut corrections = Vec::new();
        for (key, node) in fields.remaining() {
            if !columns.iter().any(|column| column.name == key.text) {
                self.problems.error::<()>("unknown-column", note!("table-no-column", name = key.text), &key.place);
            }
            let Some(mut fields) = self.problems.open_map(node) else { continue };
            let printed = fields.need("printed", self.problems).and_then(|node| self.owned(node));
            let reason = fields.need("reason", self.problems).and_then(|node| self.owned(node));
            fields.finish(&["printed", "reason"], self.problems);
            if let (Some(printed), Some(reason)) = (printed, reason) {
                corrections.push(Correction { column: key.text.clone(), printed, reason });
            }
        }
        corrections
    }

    fn uncovered(&mut self, node: &Node, columns: &[Column]) -> Vec<Uncovered> {
        let mut gaps = Vec::new();
        for item in self.problems.list(node).unwrap_or_default() {
            let Some(mut fields) = self.problems.open_map(item) else { continue };
            let when = fields.need("when", self.problems);
            let reason = fields.need("reason", self.problems).and_then(|node| self.owned(node));
            fields.finish(&["when", "reason"], self.problems);
            let sets = when.and_then(|node| self.problems.open_map(node)).map(|when| self.when(when, columns));
            if let (Some(sets), Some(reason)) = (sets, reason) {
                gaps.push(Uncovered { sets, reason, place: Some(item.place.clone()) });
            }
        }
        gaps
    }

    fn when(&mut self, mut when: Fields<'_, AnyKeys>, columns: &[Column]) -> Vec<Set> {
        let inputs: Vec<&Column> = columns.iter().filter(|column| column.role == ColumnRole::Input).collect();
        let sets = inputs
            .iter()
            .map(|column| match when.take(column.name.as_str()) {
                None => column.allowed(),
                Some(node) => match self.problems.text(node).map(|text| parse_test(text, column)) {
                    Some(Ok(set)) => set.intersection(&column.allowed()),
                    Some(Err(error)) => {
                        self.test_error::<()>(&error, node);
                        Set::empty()
                    }
                    None => Set::empty(),
                },
            })
            .collect();
        let known: Vec<&str> = inputs.iter().map(|column| column.name.as_str()).collect();
        when.finish(&known, self.problems);
        sets
    }

    /// Reports a faulty test, with the caret at its wrong characters.
    fn test_error<T>(&mut self, error: &TestError, node: &Node) -> Option<T> {
        let quote = u32::from(matches!(node.kind, NodeKind::Scalar { quoted: true, .. }));
        let place = Place {
            column: node.place.column + quote + u32::try_from(error.offset).unwrap_or(0),
            width: u32::try_from(error.width).unwrap_or(1),
            ..node.place.clone()
        };
        self.problems.error("bad-test", error.message.clone(), &place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = r#"table: x
title: {uk: х, en: x}
kind: catalog
place: nowhere
key: [name]
columns:
  - {name: name, type: text}
  - {name: diameter, type: length, unit: mm, domain: "(0..20]"}
rows:
  - {name: a, diameter: 3.15, source: seed}
  - {name: b, diameter: 20, source: reconstructed, reason: between its neighbours}
"#;

    fn first_problem(text: &str) -> (String, String) {
        let problems = table_from_text("x.yaml", text).unwrap_err();
        let first = &problems[0];
        (first.code.to_owned(), first.place.as_ref().map(ToString::to_string).unwrap_or_default())
    }

    #[test]
    fn a_good_table_loads() {
        let table = table_from_text("x.yaml", GOOD).unwrap();
        assert_eq!(table.rows.len(), 2);
        assert_eq!(
            table.find("name", "a").unwrap().value("diameter"),
            Some(&Value::Length(crate::units::Micrometres::new(3150)))
        );
    }

    #[test]
    fn every_fault_is_found_where_it_stands() {
        for (from, to, code, at) in [
            ("unit: mm", "unit: kg", "wrong-unit", "kg"),
            ("diameter: 3.15", "diameter: 3,15", "bad-value", "3,15"),
            ("diameter: 3.15", "diameter: 3.l5", "bad-value", "3.l5"),
            ("diameter: 20,", "diameter: 21,", "out-of-domain", "21,"),
            ("source: seed", "sorce: seed", "no-source", "name: a"),
            ("source: seed", "source: seed, name: c", "duplicate-key", "name: c"),
            (", reason: between its neighbours", "", "no-reason", "name: b"),
            ("(0..20]", "(0..2O]", "bad-test", "2O"),
            ("key: [name]", "key: [nme]", "unknown-column", "[nme"),
        ] {
            let text = GOOD.replacen(from, to, 1);
            assert_ne!(text, GOOD, "{from}");
            let before = &text[..text.find(at).unwrap()];
            let (line, start) = (before.lines().count(), before.rfind('\n').map_or(0, |newline| newline + 1));
            // A flow mapping begins at its brace, a block mapping before its first key.
            let brace = usize::from(at.starts_with("name: ") && code != "duplicate-key");
            let place = format!("x.yaml:{line}:{}", before.len() - start + 1 - brace);
            let (found, found_place) = first_problem(&text);
            assert_eq!((found.as_str(), found_place), (code, place), "{from} -> {to}");
        }
    }

    #[test]
    fn all_problems_of_a_file_are_reported_at_once() {
        let text = GOOD.replace("diameter: 3.15", "diameter: x").replace("diameter: 20,", "diameter: y,");
        assert_eq!(table_from_text("x.yaml", &text).unwrap_err().len(), 2);
    }
}
