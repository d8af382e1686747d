//! YAML as a tree with a place at every node, and a reader over it that collects every problem
//! instead of stopping at the first.

use std::sync::Arc;
use technolog_note::{Note, note};

use saphyr_parser::{Event, Marker, Parser, ScalarStyle, Span};

use crate::diagnostic::{Diagnostic, Place};
use crate::form::{AnyKeys, Form};

pub use crate::form::{Fields, missing_key};

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
    /// A scalar; `quoted` tells `"07"` from `07`.
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

/// The text of a file's bytes.
///
/// # Errors
/// They are not UTF-8: the place is that of the first wrong byte.
#[expect(clippy::result_large_err, reason = "a file is read once")]
pub fn text_of(file: &str, bytes: Vec<u8>) -> Result<String, Diagnostic> {
    String::from_utf8(bytes).map_err(|error| {
        let sound = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let sound = String::from_utf8_lossy(sound);
        let last = sound.rsplit('\n').next().unwrap_or_default();
        let place = Place {
            file: Arc::from(file),
            line: u32::try_from(sound.matches('\n').count() + 1).unwrap_or(u32::MAX),
            column: u32::try_from(last.chars().count() + 1).unwrap_or(u32::MAX),
            width: 1,
        };
        Diagnostic::error("not-utf8", note!("yaml-from-here-on-utf-text"), place).help(note!("yaml-save-file-utf"))
    })
}

/// Reads one YAML document. The tree is there unless the text is broken beyond reading or empty;
/// duplicate keys are reported. Aliases are refused: their targets have other places.
pub fn parse(file: &str, text: &str) -> (Option<Node>, Vec<Diagnostic>) {
    let mut builder = Builder {
        file: Arc::from(file),
        lines: text.lines().collect(),
        stack: Vec::new(),
        root: None,
        broken: false,
        problems: vec![],
    };
    let mut documents = 0;
    for event in Parser::new_from_str(text) {
        match event {
            Ok((Event::DocumentStart(_), span)) => {
                documents += 1;
                if documents > 1 {
                    let place = builder.place(span);
                    builder.problems.push(
                        Diagnostic::error("yaml", note!("yaml-second-document-one-file"), place)
                            .help(note!("yaml-remove-line-make-two-files")),
                    );
                    break;
                }
            }
            Ok((event, span)) => {
                builder.event(event, span);
                if builder.broken {
                    return (None, builder.problems);
                }
            }
            Err(error) => {
                let place = builder.broken_at(*error.marker());
                let message = note!("yaml-broken", error = error.info());
                builder.problems.push(
                    Diagnostic::error("yaml", message, place).help(note!("yaml-indent-with-spaces-quote-values")),
                );
                return (None, builder.problems);
            }
        }
    }
    if builder.root.is_none() {
        let place = Place { file: builder.file.clone(), line: 1, column: 1, width: 1 };
        builder.problems.push(Diagnostic::error("yaml", note!("yaml-file-empty"), place));
    }
    (builder.root, builder.problems)
}

/// An open sequence or mapping.
enum Frame {
    Seq(Vec<Node>, Place),
    Map(Vec<(Key, Node)>, Option<Key>, Place),
}

struct Builder<'a> {
    file: Arc<str>,
    lines: Vec<&'a str>,
    stack: Vec<Frame>,
    root: Option<Node>,
    /// Whether what follows cannot be understood.
    broken: bool,
    problems: Vec<Diagnostic>,
}

impl Builder<'_> {
    fn place(&self, span: Span) -> Place {
        let (start, end) = (span.start, span.end);
        let width = if end.line() == start.line() {
            end.col().saturating_sub(start.col())
        } else {
            self.lines
                .get(start.line().saturating_sub(1))
                .map_or(1, |line| line.chars().count().saturating_sub(start.col()))
        };
        Place {
            file: self.file.clone(),
            line: u32::try_from(start.line()).unwrap_or(u32::MAX),
            column: u32::try_from(start.col() + 1).unwrap_or(u32::MAX),
            width: u32::try_from(width.max(1)).unwrap_or(1),
        }
    }

    /// Where broken text is to be mended: where reading stopped, but for what is still open at the end
    /// of the file, where it was opened.
    fn broken_at(&self, marker: Marker) -> Place {
        match self.stack.last() {
            Some(Frame::Seq(_, opened) | Frame::Map(_, _, opened)) if marker.line() > self.lines.len() => {
                opened.clone()
            }
            _ => self.place(Span::empty(marker)),
        }
    }

    fn event(&mut self, event: Event<'_>, span: Span) {
        let place = self.place(span);
        match event {
            Event::Scalar(text, style, ..) => {
                let quoted = style != ScalarStyle::Plain;
                let text = text.into_owned();
                if let Some(Frame::Map(_, key @ None, _)) = self.stack.last_mut() {
                    *key = Some(Key { text, place });
                } else {
                    self.add(Node { kind: NodeKind::Scalar { text, quoted }, place });
                }
            }
            Event::SequenceStart(..) => self.stack.push(Frame::Seq(Vec::new(), place)),
            Event::MappingStart(..) => self.stack.push(Frame::Map(Vec::new(), None, place)),
            Event::SequenceEnd | Event::MappingEnd => match self.stack.pop() {
                Some(Frame::Seq(items, place)) => self.add(Node { kind: NodeKind::Seq(items), place }),
                Some(Frame::Map(entries, _, place)) => self.add(Node { kind: NodeKind::Map(entries), place }),
                None => {}
            },
            Event::Alias(_) => {
                self.broken = true;
                self.problems.push(
                    Diagnostic::error("yaml", note!("yaml-aliases-used-these-files"), place)
                        .help(note!("yaml-write-value-out-quote-text")),
                );
            }
            _ => {}
        }
    }

    fn add(&mut self, node: Node) {
        match self.stack.last_mut() {
            None => self.root = Some(node),
            Some(Frame::Seq(items, _)) => items.push(node),
            Some(Frame::Map(entries, key, _)) => match key.take() {
                None => {
                    self.broken = true;
                    self.problems.push(
                        Diagnostic::error("yaml", note!("yaml-key-must-plain-word"), node.place)
                            .help(note!("yaml-quote-text-begins-with")),
                    );
                }
                Some(key) => match entries.iter().find(|(known, _)| known.text == key.text) {
                    Some((first, _)) => self.problems.push(
                        Diagnostic::error("duplicate-key", note!("yaml-key-stands-twice", key = key.text), key.place)
                            .help(note!("yaml-already-stands-at-line-keep", line = first.place.line)),
                    ),
                    None => entries.push((key, node)),
                },
            },
        }
    }
}

/// Collects problems while a tree is turned into values.
#[derive(Default, Debug)]
pub struct Problems(pub Vec<Diagnostic>);

impl Problems {
    /// Notes an error and yields nothing, so that reading can go on.
    pub fn error<T>(&mut self, code: &'static str, message: impl Into<Note>, place: &Place) -> Option<T> {
        self.0.push(Diagnostic::error(code, message, place.clone()));
        None
    }

    /// Notes an error with its remedy and yields nothing.
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

    /// The value of a scalar through its parser; a failure is noted at the scalar.
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

    /// The text of a scalar.
    pub fn text<'n>(&mut self, node: &'n Node) -> Option<&'n str> {
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
            NodeKind::Map(entries) => Some(Fields::new(entries, &node.place)),
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
    fn a_duplicate_key_is_found_with_its_place() {
        let (_, problems) = parse("t.yaml", "a: 1\nb: {c: 2, c: 3}\n");
        assert_eq!(problems.len(), 1);
        assert_eq!(problems[0].place.as_ref().unwrap().to_string(), "t.yaml:2:11");
    }

    #[test]
    fn broken_text_names_its_line() {
        let (root, problems) = parse("t.yaml", "a: 1\nb: [1, 2\n");
        assert!(root.is_none());
        assert!(problems[0].place.is_some(), "{problems:?}");
    }

    #[test]
    fn what_is_left_open_is_shown_where_it_opens() {
        for (text, place) in [("a: 1\nb: [1, 2\n", "t.yaml:2:4"), ("a: [1\nb: 2\n", "t.yaml:2:2")] {
            assert_eq!(parse("t.yaml", text).1[0].place.as_ref().unwrap().to_string(), place, "{text}");
        }
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
            assert_eq!(problems.0.iter().map(|one| one.code).collect::<Vec<_>>(), [code], "{text}");
        }
    }

    #[test]
    fn the_first_byte_that_is_not_utf8_has_a_place() {
        let problem = text_of("t.yaml", b"a: 1\nb: \xd0\xb0\xcf\xeb\n".to_vec()).unwrap_err();
        assert_eq!(problem.place.unwrap().to_string(), "t.yaml:2:5");
        assert_eq!(text_of("t.yaml", b"a: 1".to_vec()).unwrap(), "a: 1");
    }

    #[test]
    fn quoting_is_kept_and_null_is_absent() {
        let (root, problems) = parse("t.yaml", "a: \"07\"\nb: ~\n");
        assert!(problems.is_empty());
        let root = root.unwrap();
        assert!(matches!(root.get("a").unwrap().kind, NodeKind::Scalar { quoted: true, .. }));
        assert!(root.get("b").unwrap().is_null());
    }
}
