//! The expectation of a case: a tree as written, each node with its place.
//!
//! A scalar is a value, a list is the whole list, a mapping is some keys of an object. A mapping with the words of
//! [`WORDS`] is a matcher: a tolerance, a range, some items of a list. A key `a.b` is the key `b` in `a`.

use crate::knowledge::Word;
use crate::knowledge::diagnostic::{Place, nearest};
use crate::knowledge::form::AnyKeys;
use crate::knowledge::yaml::{Fields, Key, Node, NodeKind, Problems};
use crate::note::Severity;
use technolog_note::note;

use super::limits;
use super::written::node;

/// The words of matchers.
pub const WORDS: &[&str] = &[
    "is",
    "within",
    "from",
    "to",
    "one_of",
    "not",
    "starts",
    "ends",
    "contains",
    "lacks",
    "how_many",
    "every",
    "none_from",
    "optional",
];

/// An expectation with its place and as it is written, on one line.
#[derive(Clone, Debug)]
pub struct Expected {
    /// The expectation itself.
    pub kind: ExpectedKind,
    /// Where it stands.
    pub place: Place,
    /// As written.
    pub written: String,
}

/// The kinds of expectations.
#[derive(Clone, Debug)]
pub enum ExpectedKind {
    /// Nothing yet: an empty value.
    Open,
    /// There must be no value.
    Absent,
    /// There must be a value.
    Present,
    /// This value: a text, a number, a truth value; for an object its name.
    Is(String),
    /// A number near this one.
    Near {
        /// The number.
        is: f64,
        /// The largest difference, in its own unit.
        by: f64,
    },
    /// A number within limits.
    Range {
        /// The least.
        from: Option<f64>,
        /// The greatest.
        to: Option<f64>,
        /// The two as keys of an object, in case that is meant.
        keys: Vec<(Key, Expected)>,
    },
    /// Any of these.
    OneOf(Vec<Expected>),
    /// Anything else.
    Not(Box<Expected>),
    /// This whole list.
    List(Vec<Item>),
    /// Some items of a list; `contains` also applies to a text.
    Some(Box<ListRequirements>),
    /// These keys of an object, or these items of a list by their names.
    Map(Vec<(Key, Expected)>),
}

/// An item of a list.
#[derive(Clone, Debug)]
pub struct Item {
    /// What it is.
    pub expected: Expected,
    /// Whether it may be missing.
    pub optional: bool,
}

/// Requirements for some items of a list.
#[derive(Clone, Debug, Default)]
pub struct ListRequirements {
    /// It begins with these.
    pub starts: Option<Vec<Item>>,
    /// It ends with these.
    pub ends: Option<Vec<Item>>,
    /// It contains each of these, in any place.
    pub contains: Vec<Expected>,
    /// It has none of these.
    pub excluded: Vec<Expected>,
    /// The number of its items.
    pub how_many: Option<Expected>,
    /// Each item.
    pub every: Option<Expected>,
    /// No finding of this severity or a higher one, with the place of this requirement.
    pub none_from: Option<(Severity, Place)>,
}

impl Expected {
    /// An expectation of another kind at the same place.
    fn at(from: &Node, kind: ExpectedKind) -> Self {
        Self { kind, place: from.place.clone(), written: node(from) }
    }

    /// The expectation under a key, where it is a mapping.
    pub fn get(&self, key: &str) -> Option<&Self> {
        match &self.kind {
            ExpectedKind::Map(entries) => {
                entries.iter().find(|(known, _)| known.text == key).map(|(_, expected)| expected)
            }
            _ => None,
        }
    }
}

impl ListRequirements {
    /// All requirements for items.
    pub fn all(&self) -> Vec<&Expected> {
        let items = self.starts.iter().chain(&self.ends).flatten().map(|item| &item.expected);
        items.chain(&self.contains).chain(&self.excluded).chain(&self.how_many).chain(&self.every).collect()
    }
}

/// Reads an expectation; faults are reported, and then nothing is returned.
pub fn read(from: &Node, problems: &mut Problems) -> Option<Expected> {
    let what = match &from.kind {
        NodeKind::Scalar { .. } if from.is_null() => ExpectedKind::Open,
        NodeKind::Scalar { text, quoted: false } if text == "absent" => ExpectedKind::Absent,
        NodeKind::Scalar { text, quoted: false } if text == "present" => ExpectedKind::Present,
        NodeKind::Scalar { text, .. } => ExpectedKind::Is(text.clone()),
        NodeKind::Seq(nodes) => ExpectedKind::List(items(nodes, problems)?),
        NodeKind::Map(entries) => {
            let ends = entries.iter().all(|(key, node)| ["from", "to"].contains(&key.text.as_str()) && is_value(node));
            let own = |key: &str| !["from", "to"].contains(&key) && WORDS.contains(&key);
            if ends && !entries.is_empty() {
                range(from, problems)?
            } else if entries.iter().any(|(key, _)| own(&key.text)) {
                matcher(from, problems)?
            } else {
                ExpectedKind::Map(keys(from, problems)?)
            }
        }
    };
    Some(Expected::at(from, what))
}

fn is_value(node: &Node) -> bool {
    matches!(node.kind, NodeKind::Scalar { .. }) && !node.is_null()
}

fn all(nodes: &[Node], problems: &mut Problems) -> Option<Vec<Expected>> {
    // Every item is read, even after a fault.
    nodes.iter().map(|node| read(node, problems)).collect::<Vec<_>>().into_iter().collect()
}

/// Items of a list: `{optional: …}`, or a text that ends in ` *`, may be missing.
fn items(nodes: &[Node], problems: &mut Problems) -> Option<Vec<Item>> {
    let read_item = |node: &Node, problems: &mut Problems| {
        if let Some(inner) = node.get("optional") {
            let mut fields = problems.open_map(node)?;
            let _ = fields.take("optional");
            fields.finish(&["optional"], problems);
            return Some(Item { expected: read(inner, problems)?, optional: true });
        }
        let mut expected = read(node, problems)?;
        let short = match &expected.kind {
            ExpectedKind::Is(text) => text.strip_suffix(" *").map(str::to_owned),
            _ => None,
        };
        let optional = short.is_some();
        expected.kind = short.map_or(expected.kind, ExpectedKind::Is);
        Some(Item { expected, optional })
    };
    nodes.iter().map(|node| read_item(node, problems)).collect::<Vec<_>>().into_iter().collect()
}

fn keys(from: &Node, problems: &mut Problems) -> Option<Vec<(Key, Expected)>> {
    let NodeKind::Map(entries) = &from.kind else { return None };
    let read_key = |(key, node): &(Key, Node), problems: &mut Problems| {
        let (key, node) = limits::segments(key, problems).then(|| spelt_out(key, node))?;
        Some((key, read(&node, problems)?))
    };
    entries.iter().map(|entry| read_key(entry, problems)).collect::<Vec<_>>().into_iter().collect()
}

/// A key `a.b` with its value, as the key `a` with `b` inside; several keys may concern the same object.
fn spelt_out(key: &Key, node: &Node) -> (Key, Node) {
    let at = |text: &str| Key { text: text.to_owned(), place: key.place.clone() };
    match key.text.split_once('.') {
        Some((first, rest)) if !first.is_empty() && !rest.is_empty() => {
            let inner = spelt_out(&at(rest), node);
            (at(first), Node { kind: NodeKind::Map(vec![inner]), place: key.place.clone() })
        }
        _ => (key.clone(), node.clone()),
    }
}

fn range(from: &Node, problems: &mut Problems) -> Option<ExpectedKind> {
    let mut fields = problems.open_map(from)?;
    let mut end = |key: &str, problems: &mut Problems| match fields.take(key) {
        Some(node) => number(node, problems).map(Some),
        None => Some(None),
    };
    let (least, greatest) = (end("from", problems), end("to", problems));
    let (least, greatest) = (least?, greatest?);
    if let (Some(low), Some(high)) = (least, greatest)
        && low > high
    {
        let message = note!("case-no-number-from", low = low, high = high);
        return problems.error_help("bad-value", message, &from.place, note!("case-write-smaller-one-first"));
    }
    Some(ExpectedKind::Range { from: least, to: greatest, keys: keys(from, problems)? })
}

fn matcher(from: &Node, problems: &mut Problems) -> Option<ExpectedKind> {
    let mut fields = problems.open_map(from)?;
    if let Some(is) = fields.take("is") {
        let within = fields.take("within");
        fields.finish(&["is", "within"], problems);
        let Some(within) = within else { return Some(read(is, problems)?.kind) };
        let (value, by) = (number(is, problems), tolerance(within, problems));
        return value.zip(by).map(|(is, by)| ExpectedKind::Near { is, by: by.allowed_difference(is) });
    }
    if let Some(several) = fields.take("one_of") {
        fields.finish(&["one_of"], problems);
        return Some(ExpectedKind::OneOf(all(problems.list(several)?, problems)?));
    }
    if let Some(other) = fields.take("not") {
        fields.finish(&["not"], problems);
        return Some(ExpectedKind::Not(Box::new(read(other, problems)?)));
    }
    if fields.take("within").is_some() {
        return problems.error_help("missing-key", note!("case-within-what"), &from.place, note!("case-write-within"));
    }
    let part = part(&mut fields, problems);
    fields.finish(&["starts", "ends", "contains", "lacks", "how_many", "every", "none_from"], problems);
    Some(ExpectedKind::Some(Box::new(part?)))
}

fn part(fields: &mut Fields<'_, AnyKeys>, problems: &mut Problems) -> Option<ListRequirements> {
    // A single one needs no brackets.
    fn as_list(node: &Node) -> &[Node] {
        match &node.kind {
            NodeKind::Seq(nodes) => nodes,
            _ => std::slice::from_ref(node),
        }
    }
    let mut part = ListRequirements::default();
    let mut whole = true;
    if let Some(node) = fields.take("starts") {
        part.starts = items(as_list(node), problems);
        whole &= part.starts.is_some();
    }
    if let Some(node) = fields.take("ends") {
        part.ends = items(as_list(node), problems);
        whole &= part.ends.is_some();
    }
    for (key, list) in [("contains", &mut part.contains), ("lacks", &mut part.excluded)] {
        if let Some(node) = fields.take(key) {
            let found = all(as_list(node), problems);
            whole &= found.is_some();
            *list = found.unwrap_or_default();
        }
    }
    for (key, one) in [("how_many", &mut part.how_many), ("every", &mut part.every)] {
        if let Some(node) = fields.take(key) {
            *one = read(node, problems);
            whole &= one.is_some();
        }
    }
    if let Some(node) = fields.take("none_from") {
        part.none_from = severity(node, problems).map(|severity| (severity, node.place.clone()));
        whole &= part.none_from.is_some();
    }
    whole.then_some(part)
}

fn severity(node: &Node, problems: &mut Problems) -> Option<Severity> {
    let text = problems.text(node)?;
    if let Some(severity) = Severity::from_word(text) {
        return Some(severity);
    }
    let names = Severity::WORDS;
    let help = match nearest(text, names.iter().copied()) {
        Some(near) => note!("cli-did-you-mean", name = near),
        None => note!("case-known-here", names = names.join(", ")),
    };
    problems.error_help("bad-value", note!("case-no-severity", text = text), &node.place, help)
}

/// A finite number as written.
pub fn number_of(text: &str) -> Option<f64> {
    let plain = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    text.parse().ok().filter(|number: &f64| plain && number.is_finite())
}

fn number(node: &Node, problems: &mut Problems) -> Option<f64> {
    let text = problems.text(node)?;
    match number_of(text) {
        Some(number) => Some(number),
        None => problems.error("bad-value", note!("case-number", text = text), &node.place),
    }
}

/// How far a number may lie from the expected one.
enum Tolerance {
    By(f64),
    Share(f64),
}

impl Tolerance {
    fn allowed_difference(&self, is: f64) -> f64 {
        match self {
            Self::By(by) => *by,
            Self::Share(share) => is.abs() * share,
        }
    }
}

fn tolerance(node: &Node, problems: &mut Problems) -> Option<Tolerance> {
    let text = problems.text(node)?;
    let read = match text.strip_suffix('%') {
        Some(share) => number_of(share.trim()).map(|share| Tolerance::Share(share / 100.0)),
        None => number_of(text).map(Tolerance::By),
    };
    match read {
        Some(read @ (Tolerance::By(width) | Tolerance::Share(width))) if width > 0.0 => Some(read),
        _ => problems.error_help(
            "bad-value",
            note!("case-no-tolerance", text = text),
            &node.place,
            note!("case-write-share-such-number-above"),
        ),
    }
}
