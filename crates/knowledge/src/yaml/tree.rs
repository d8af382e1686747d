//! Builds the tree of a text from the events of the parser, within limits.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use technolog_note::{Note, note};

use saphyr_parser::{Event, Marker, Parser, ScalarStyle, Span};

use super::{Key, Node, NodeKind, faults};
use crate::diagnostic::{Diagnostic, Place};
use crate::input::{MOST_BYTES, too_large, unseen};

/// The deepest nesting of lists and mappings. Files of the program have at most ten levels; code that walks a tree
/// recurses once per level.
pub const MOST_DEPTH: usize = 64;
/// The most values of a file, with keys and lists. A plan of 20,000 points in JSON has half a million for each tool.
pub const MOST_VALUES: usize = 2_000_000;

/// The beginning of the parser's message about too deep nesting. The parser reads ahead of the events that it
/// returns.
const TOO_DEEP: &str = "recursion";

/// Reads one YAML document. There is a tree unless the text is unreadable or empty; duplicate keys are reported.
/// Aliases are refused, because their targets have other places.
pub fn parse(file: &str, text: &str) -> (Option<Node>, Vec<Diagnostic>) {
    parse_within(MOST_VALUES, file, text)
}

fn parse_within(most_values: usize, file: &str, text: &str) -> (Option<Node>, Vec<Diagnostic>) {
    if text.len() > MOST_BYTES {
        return (None, vec![too_large(file)]);
    }
    let mut builder = Builder {
        file: Arc::from(file),
        lines: text.lines().collect(),
        stack: Vec::new(),
        root: None,
        values: 0,
        most_values,
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
                builder.problems.push(if error.info().starts_with(TOO_DEEP) {
                    too_deep(place)
                } else {
                    let of_line = OF_LINE.iter().any(|words| error.info().contains(words));
                    let open = !of_line && builder.is_in_open_bracket(*error.marker());
                    broken(if open { OPEN_BRACKET } else { error.info() }, place)
                });
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

/// The message for a bracket left open above the line where reading stopped; it replaces the parser's message about
/// that line.
const OPEN_BRACKET: &str = "flow";
/// The words for faults in the line itself.
const OF_LINE: [&str; 5] = ["quoted", "tab", "escape", "anchor", "trailing"];

fn broken(message: &str, place: Place) -> Diagnostic {
    let known = faults::FAULTS.iter().find(|(words, ..)| words.iter().any(|word| message.contains(word)));
    let (what, mend) = known
        .map_or(("yaml-broken-otherwise", "yaml-indent-with-spaces-quote-values"), |(_, what, mend)| (*what, *mend));
    Diagnostic::error("yaml", note!("yaml-broken", error = Note::new(what)), place).help(Note::new(mend))
}

fn too_deep(place: Place) -> Diagnostic {
    let message = note!("yaml-too-deep", most = MOST_DEPTH);
    Diagnostic::error("too-deep", message, place).help(note!("yaml-check-brackets-and-indents"))
}

/// The fault of a text with several lines where one is permitted.
pub(super) fn several_lines(place: &Place) -> Diagnostic {
    Diagnostic::error("line-break", note!("yaml-one-line-expected"), place.clone())
        .help(note!("yaml-write-in-one-line"))
}

/// The fault of a text with a forbidden character.
pub(super) fn unseen_sign(sign: char, place: &Place) -> Diagnostic {
    let message = note!("yaml-sign-nobody-sees", sign = format!("U+{:04X}", u32::from(sign)));
    Diagnostic::error("control-character", message, place.clone()).help(note!("yaml-remove-the-sign"))
}

/// Joins a number to what a decimal comma has cut off it: `{feed: 0,1}` is `0` and a key `1` for the parser. Its reader
/// then names the comma, instead of judging the half.
fn joined(last: &mut Node, key: &Key) -> bool {
    let place = &mut last.place;
    let NodeKind::Scalar { text, quoted: false } = &mut last.kind else { return false };
    let next = key.place.line == place.line && key.place.column == place.column + place.width + 1;
    let digits =
        text.ends_with(|last: char| last.is_ascii_digit()) && key.text.starts_with(|c: char| c.is_ascii_digit());
    if !next || !digits {
        return false;
    }
    text.push(',');
    text.push_str(&key.text);
    place.width += key.place.width + 1;
    true
}

/// An open sequence or mapping.
enum OpenNode {
    Seq(Vec<Node>, Place),
    Map(Vec<(Key, Node)>, Option<Key>, Place),
}

struct Builder<'a> {
    file: Arc<str>,
    lines: Vec<&'a str>,
    stack: Vec<OpenNode>,
    root: Option<Node>,
    /// The number of values so far.
    values: usize,
    most_values: usize,
    /// Whether the rest cannot be understood.
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

    /// The place to correct: where reading stopped or, for anything still open at the end of the file, where it was
    /// opened.
    fn broken_at(&self, marker: Marker) -> Place {
        match self.stack.last() {
            Some(OpenNode::Seq(_, opened) | OpenNode::Map(_, _, opened)) if marker.line() > self.lines.len() => {
                opened.clone()
            }
            _ => self.place(Span::empty(marker)),
        }
    }

    /// Whether a bracket of an earlier line is still open. Lines inside brackets usually end with a comma.
    fn is_in_open_bracket(&self, marker: Marker) -> bool {
        let Some(OpenNode::Seq(_, opened) | OpenNode::Map(_, _, opened)) = self.stack.last() else { return false };
        let (line, column) = (opened.line as usize, opened.column as usize);
        let sign = self.lines.get(line.saturating_sub(1)).and_then(|line| line.chars().nth(column.saturating_sub(1)));
        line < marker.line() && matches!(sign, Some('[' | '{'))
    }

    fn event(&mut self, event: Event<'_>, span: Span) {
        let place = self.place(span);
        if let Some(problem) = self.beyond_bounds(&event, &place) {
            self.broken = true;
            self.problems.push(problem);
            return;
        }
        match event {
            Event::Scalar(text, style, ..) => {
                let quoted = style != ScalarStyle::Plain;
                let text = text.into_owned();
                if let Some(sign) = unseen(&text) {
                    self.problems.push(unseen_sign(sign, &place));
                }
                if let Some(OpenNode::Map(_, key @ None, _)) = self.stack.last_mut() {
                    if text.contains(['\n', '\t']) {
                        self.problems.push(several_lines(&place));
                    }
                    *key = Some(Key { text, place });
                } else {
                    self.add(Node { kind: NodeKind::Scalar { text, quoted }, place });
                }
            }
            Event::SequenceStart(..) => self.stack.push(OpenNode::Seq(Vec::new(), place)),
            Event::MappingStart(..) => self.stack.push(OpenNode::Map(Vec::new(), None, place)),
            Event::SequenceEnd | Event::MappingEnd => match self.stack.pop() {
                Some(OpenNode::Seq(items, place)) => self.add(Node { kind: NodeKind::Seq(items), place }),
                Some(OpenNode::Map(entries, _, place)) => {
                    let kind = NodeKind::Map(self.each_once(entries));
                    self.add(Node { kind, place });
                }
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

    /// The fault of a value that exceeds the limits of number or depth.
    fn beyond_bounds(&mut self, event: &Event<'_>, place: &Place) -> Option<Diagnostic> {
        let opens = matches!(event, Event::SequenceStart(..) | Event::MappingStart(..));
        self.values += usize::from(opens || matches!(event, Event::Scalar(..)));
        if opens && self.stack.len() == MOST_DEPTH {
            return Some(too_deep(place.clone()));
        }
        (self.values > self.most_values).then(|| {
            let message = note!("yaml-too-many-values", most = self.most_values);
            Diagnostic::error("too-many-values", message, place.clone()).help(note!("yaml-make-several-files"))
        })
    }

    fn add(&mut self, node: Node) {
        match self.stack.last_mut() {
            None => self.root = Some(node),
            Some(OpenNode::Seq(items, _)) => items.push(node),
            Some(OpenNode::Map(entries, key, _)) => match key.take() {
                None => {
                    self.broken = true;
                    self.problems.push(
                        Diagnostic::error("yaml", note!("yaml-key-must-plain-word"), node.place)
                            .help(note!("yaml-quote-text-begins-with")),
                    );
                }
                Some(key) => {
                    let cut = entries.last_mut().filter(|_| node.is_null()).is_some_and(|(_, last)| joined(last, &key));
                    if !cut {
                        entries.push((key, node));
                    }
                }
            },
        }
    }

    /// The entries of a mapping. Of duplicate keys the first is kept and the others are reported.
    fn each_once(&mut self, entries: Vec<(Key, Node)>) -> Vec<(Key, Node)> {
        let mut firsts = BTreeMap::new();
        for (index, (key, _)) in entries.iter().enumerate() {
            let first = *firsts.entry(key.text.as_str()).or_insert(index);
            if first != index {
                let message = note!("yaml-key-stands-twice", key = key.text);
                let help = note!("yaml-already-stands-at-line-keep", line = entries[first].0.place.line);
                self.problems.push(Diagnostic::error("duplicate-key", message, key.place.clone()).help(help));
            }
        }
        if firsts.len() == entries.len() {
            return entries;
        }
        let kept: BTreeSet<usize> = firsts.into_values().collect();
        let entries = entries.into_iter().enumerate().filter(|(index, _)| kept.contains(index));
        entries.map(|(_, entry)| entry).collect()
    }
}

#[cfg(test)]
mod tests {
    use technolog_words::Lang;

    use super::*;

    fn refused(text: &str) -> String {
        let (root, problems) = parse("t.yaml", text);
        assert!(root.is_none());
        assert_eq!(problems.len(), 1, "{problems:?}");
        problems[0].text(|note| Lang::EN.say(note))
    }

    #[test]
    fn a_duplicate_key_is_found_with_its_place() {
        let (root, problems) = parse("t.yaml", "a: 1\nb: {c: 2, c: 3, d: 4, c: 5}\n");
        let places: Vec<String> = problems.iter().map(|problem| problem.place.as_ref().unwrap().to_string()).collect();
        assert_eq!(places, ["t.yaml:2:11", "t.yaml:2:23"]);
        let root = root.unwrap();
        let kept = ["c", "d"].map(|key| root.get("b").unwrap().get(key).unwrap().text());
        assert_eq!(kept, [Some("2"), Some("4")]);
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
    fn signs_that_nobody_sees_are_refused_at_their_text() {
        for (sign, shown) in
            [("\u{1b}", "U+001B"), ("\u{202e}", "U+202E"), ("\u{2066}", "U+2066"), ("\u{7f}", "U+007F")]
        {
            for text in
                [format!("a: 1\nb: x{sign}y\n"), format!("a: 1\nb: \"x{sign}y\"\n"), format!("a: 1\nb{sign}: 1\n")]
            {
                let (_, problems) = parse("t.yaml", &text);
                let texts: Vec<String> =
                    problems.iter().map(|problem| problem.text(|note| Lang::EN.say(note))).collect();
                assert!(
                    texts[0].starts_with("t.yaml:2:") && texts[0].contains("[control-character]"),
                    "{text:?}: {texts:?}"
                );
                assert!(texts[0].contains(shown) && texts.len() == 1, "{texts:?}");
            }
        }
        let (_, problems) = parse("t.yaml", "\"a\\nb\": 1\n\"c\\e\": 1\n");
        assert_eq!(problems.iter().map(|one| one.code).collect::<Vec<_>>(), ["line-break", "control-character"]);
        assert!(parse("t.yaml", "a: |\n  N1 X1\tY1\n  N2\nb: х\u{301}🙂\n").1.is_empty());
    }

    #[test]
    fn quoting_is_kept_and_null_is_absent() {
        let (root, problems) = parse("t.yaml", "a: \"07\"\nb: ~\n");
        assert!(problems.is_empty());
        let root = root.unwrap();
        assert!(matches!(root.get("a").unwrap().kind, NodeKind::Scalar { quoted: true, .. }));
        assert!(root.get("b").unwrap().is_null());
    }

    /// A list in a list and so on, `depth` of them, or mappings.
    fn nested(open: &str, inside: &str, close: &str, depth: usize) -> String {
        open.repeat(depth) + inside + &close.repeat(depth)
    }

    #[test]
    fn as_deep_as_the_bound_is_read_and_deeper_is_refused_where_it_begins() {
        for (open, close) in [("[", "]"), ("{a: ", "}"), ("- ", ""), ("[{a: ", "}]")] {
            let each = open.matches(['[', '{', '-']).count();
            let (root, problems) = parse("t.yaml", &nested(open, "1", close, MOST_DEPTH / each));
            assert!(root.is_some() && problems.is_empty(), "{open}: {problems:?}");
            let column = (MOST_DEPTH / each) * open.len() + 1;
            assert_eq!(
                refused(&nested(open, "1", close, MOST_DEPTH / each + 1)),
                format!(
                    "t.yaml:1:{column}: lists and mappings stand more than 64 deep within each other [too-deep]; \
                     check the brackets and the indents: no file of the program is so deep"
                )
            );
        }
        let indented: String = (0..=MOST_DEPTH).map(|depth| format!("{}a:\n", " ".repeat(depth))).collect();
        assert!(refused(&indented).starts_with("t.yaml:65:65: "), "{}", refused(&indented));
    }

    #[test]
    fn a_hundred_thousand_within_each_other_are_refused_like_any() {
        for (open, close) in
            [("- ", ""), ("[", ""), ("[", "]"), ("{a: ", ""), ("{a: ", "}"), ("? ", ""), ("{\"a\":", "")]
        {
            assert!(refused(&nested(open, "1", close, 100_000)).contains("[too-deep]"), "{open}");
        }
    }

    #[test]
    fn more_values_than_the_bound_are_refused_where_the_first_of_them_stands() {
        // The list itself is one, and keys are.
        for text in ["- 1\n".repeat(99), "a: [1, 1, 1]\n".to_owned() + &"b: {c: 1}\n".repeat(23) + "d:\n"] {
            let (root, problems) = parse_within(100, "t.yaml", &text);
            assert!(root.is_some() && problems.iter().all(|problem| problem.code == "duplicate-key"), "{text}");
            let (root, problems) = parse_within(99, "t.yaml", &text);
            assert!(root.is_none());
            let message = problems.last().unwrap().text(|note| Lang::EN.say(note));
            assert!(message.contains("the file has more than 99 values [too-many-values]; "), "{message}");
            let line = text.lines().count();
            assert!(message.starts_with(&format!("t.yaml:{line}:")), "{message}");
        }
    }

    #[test]
    fn a_text_beyond_the_bound_is_not_parsed() {
        let problems = refused(&" ".repeat(MOST_BYTES + 1));
        assert!(problems.starts_with("t.yaml:1:1: the file is larger than 32 MB [too-large]; "), "{problems}");
    }
}
