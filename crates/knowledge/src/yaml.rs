//! YAML as a tree with a place at every node, and a reader that collects all problems instead of stopping at the
//! first.

mod faults;
mod tree;

use technolog_note::{Note, note};

use crate::diagnostic::{Diagnostic, Place};
use crate::form::{AnyKeys, Form};
use crate::input::has_no_width;

pub use crate::form::{Fields, missing_key};
pub use tree::{MOST_DEPTH, MOST_VALUES, parse};

/// The most characters of a name.
pub const LONGEST_NAME: usize = 200;

/// A value of a YAML file and where it stands.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// Where it stands.
    pub place: Place,
}

/// The three kinds of YAML values.
#[derive(Clone, Debug)]
pub enum NodeKind {
    /// A scalar; `quoted` distinguishes `"07"` from `07`.
    Scalar {
        /// The text without quotes.
        text: String,
        /// Whether it stood in quotes.
        quoted: bool,
    },
    /// A sequence.
    Seq(Vec<Node>),
    /// A mapping, in order, keys with their places.
    Map(Vec<(Key, Node)>),
}

/// A key of a mapping.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its text.
    pub text: String,
    /// Where it stands.
    pub place: Place,
}

impl Node {
    /// The text of a scalar.
    pub fn text(&self) -> Option<&str> {
        match &self.kind {
            NodeKind::Scalar { text, .. } => Some(text),
            _ => None,
        }
    }

    /// Whether it is an unquoted empty value, `~` or `null`.
    pub fn is_null(&self) -> bool {
        matches!(&self.kind, NodeKind::Scalar { text, quoted: false } if matches!(text.as_str(), "" | "~" | "null"))
    }

    /// What it is, for messages.
    pub fn kind_name(&self) -> Note {
        match self.kind {
            NodeKind::Scalar { .. } if self.is_null() => note!("yaml-nothing"),
            NodeKind::Scalar { .. } => note!("yaml-single-value"),
            NodeKind::Seq(_) => note!("yaml-a-list"),
            NodeKind::Map(_) => note!("yaml-a-mapping"),
        }
    }

    /// The value of a key, if this is a mapping that has it.
    pub fn get(&self, key: &str) -> Option<&Node> {
        match &self.kind {
            NodeKind::Map(entries) => entries.iter().find(|(k, _)| k.text == key).map(|(_, node)| node),
            _ => None,
        }
    }
}

/// Collects problems while a tree is turned into values.
#[derive(Default, Debug)]
pub struct Problems(pub Vec<Diagnostic>);

impl Problems {
    /// Reports an error and returns nothing, so that reading can continue.
    pub fn error<T>(&mut self, code: &'static str, message: impl Into<Note>, place: &Place) -> Option<T> {
        self.0.push(Diagnostic::error(code, message, place.clone()));
        None
    }

    /// Reports an error with its remedy and returns nothing.
    pub fn error_help<T>(
        &mut self,
        code: &'static str,
        message: impl Into<Note>,
        place: &Place,
        help: impl Into<Note>,
    ) -> Option<T> {
        self.0.push(Diagnostic::error(code, message, place.clone()).help(help));
        None
    }

    /// The value of a scalar by its parser; a failure is reported at the scalar.
    pub fn scalar<T: std::str::FromStr>(&mut self, node: &Node) -> Option<T>
    where
        T::Err: Into<Note>,
    {
        let text = self.text(node)?.to_owned();
        match text.parse() {
            Ok(value) => Some(value),
            Err(error) => self.error("bad-value", error, &node.place),
        }
    }

    /// The text of a scalar, of one line.
    pub fn text<'n>(&mut self, node: &'n Node) -> Option<&'n str> {
        let text = self.lines(node)?;
        if text.trim().contains(['\n', '\t']) {
            self.0.push(tree::several_lines(&node.place));
            return None;
        }
        Some(text)
    }

    /// The text of a scalar that names something: trimmed, short enough for a table cell, and without zero-width
    /// characters, which would make different names look the same.
    pub fn name<'n>(&mut self, node: &'n Node) -> Option<&'n str> {
        let text = self.text(node)?.trim();
        if let Some(sign) = text.chars().find(|sign| has_no_width(*sign)) {
            self.0.push(tree::unseen_sign(sign, &node.place));
            return None;
        }
        let count = text.chars().count();
        if count > LONGEST_NAME {
            let message = note!("yaml-name-too-long", count = count, most = LONGEST_NAME);
            return self.error_help("too-long", message, &node.place, note!("yaml-shorten"));
        }
        Some(text)
    }

    /// The text of a scalar, of any number of lines.
    pub fn lines<'n>(&mut self, node: &'n Node) -> Option<&'n str> {
        match node.text() {
            Some(text) if !node.is_null() => Some(text),
            _ => self.error(
                "bad-value",
                note!("yaml-single-value-expected-here", kind_name = node.kind_name()),
                &node.place,
            ),
        }
    }

    /// `true` or `false`.
    pub fn boolean(&mut self, node: &Node) -> Option<bool> {
        match self.text(node)? {
            "true" => Some(true),
            "false" => Some(false),
            other => {
                let message = note!("yaml-neither-true-nor-false", other = other);
                self.error("bad-value", message, &node.place)
            }
        }
    }

    /// The items of a list.
    pub fn list<'n>(&mut self, node: &'n Node) -> Option<&'n [Node]> {
        match &node.kind {
            NodeKind::Seq(items) => Some(items),
            _ => self.error("bad-value", note!("yaml-list-expected-here", kind_name = node.kind_name()), &node.place),
        }
    }

    /// The fields of a mapping whose keys a description of the format lists.
    pub fn map<'n, F: Form>(&mut self, node: &'n Node) -> Option<Fields<'n, F>> {
        self.fields(node)
    }

    /// The fields of a mapping whose keys are data, such as the columns of a table.
    pub fn open_map<'n>(&mut self, node: &'n Node) -> Option<Fields<'n, AnyKeys>> {
        self.fields(node)
    }

    fn fields<'n, F>(&mut self, node: &'n Node) -> Option<Fields<'n, F>> {
        match &node.kind {
            NodeKind::Map(entries) => Some(Fields::new(entries, &node.place, self.0.len())),
            _ => {
                self.error("bad-value", note!("yaml-mapping-expected-here", kind_name = node.kind_name()), &node.place)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_short_line() {
        let read = |text: &str| {
            let (root, mut problems) = (parse("t.yaml", text).0.unwrap(), Problems::default());
            let name = problems.name(root.get("a").unwrap()).map(str::to_owned);
            (name, problems.0.iter().map(|problem| problem.code).collect::<Vec<_>>())
        };
        assert_eq!(read("a: ' Плита № 5 '\n"), (Some("Плита № 5".to_owned()), vec![]));
        assert_eq!(read("a: >\n  Плита\n  № 5\n"), (Some("Плита № 5".to_owned()), vec![]));
        for broken in ["a: |\n  Плита\n  № 5\n", "a: \"Плита\\t№ 5\"\n", "a: Плита\n\n  № 5\n"] {
            assert_eq!(read(broken), (None, vec!["line-break"]), "{broken}");
        }
        assert_eq!(read(&format!("a: {}\n", "я".repeat(LONGEST_NAME))).1, [""; 0]);
        assert_eq!(read(&format!("a: {}\n", "я".repeat(LONGEST_NAME + 1))), (None, vec!["too-long"]));
    }

    #[test]
    fn one_slip_is_one_problem() {
        for (text, code) in [
            ("nam: 1\ndepth: 2\n", "unknown-key"),
            ("name: {{x}}\ndepth: 2\n", "yaml"),
            ("name: &n 1\ndepth: *n\n", "yaml"),
            ("depth: 2\n", "missing-key"),
            ("назва: 1\ndepth: 2\n", "unknown-key"),
            ("name: 1\nglybyna: 2\ndepth: 2\n", "unknown-key"),
        ] {
            let (root, problems) = parse("t.yaml", text);
            let mut problems = Problems(problems);
            if let Some(root) = root {
                let mut fields = problems.open_map(&root).unwrap();
                let _ = (fields.need("name", &mut problems), fields.need("depth", &mut problems));
                fields.finish(&["name", "depth"], &mut problems);
            }
            assert_eq!(problems.0.iter().map(|problem| problem.code).collect::<Vec<_>>(), [code], "{text}");
        }
    }
}
