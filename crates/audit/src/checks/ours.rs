//! A plan that `technolog plan` made and somebody changed: what no formula explains is compared with a new plan of
//! the same part. A difference alone is no fault.

use serde_json::Value;

use crate::error::KnowledgeError;
use crate::knowledge::yaml::{Node, NodeKind};
use crate::note::{Figure, IntoFigure as _, Note, Severity, Word};
use crate::plan::Operation;

use super::super::context::Context;
use super::super::finding::{AuditFinding, FindingKind, Section, Subject};
use super::super::graph::Graph;
use super::super::own::items;

/// The parts of a plan that are not decisions.
const OUTSIDE: [&str; 5] = ["because", "alternatives", "findings", "visiting", "part"];

/// The largest difference between two prints of the same figure.
const SAME: f64 = 1e-9;

pub(super) fn check<'a>(
    context: &Context<'a>,
    _: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(tree) = &context.stated.tree else { return Ok(()) };
    tools_of_transitions(tree, findings);
    follow(context, findings);
    let Ok(ours) = serde_json::to_value(context.plan) else { return Ok(()) };
    let mut known = PlanComparer { found: Vec::new() };
    for (key, section) in [
        ("holes", Section::Route),
        ("tools", Section::Tools),
        ("clamping", Section::Clamping),
        ("setup", Section::Clamping),
        ("sequence", Section::Route),
        ("time", Section::Times),
    ] {
        if let (Some(node), Some(value)) = (tree.get(key), ours.get(key)) {
            known.compare(node, value, key, (section, &Subject::default()));
        }
    }
    // What a formula or another check reported is not repeated.
    let is_reported = |finding: &AuditFinding| {
        findings
            .iter()
            .any(|other| other.line.is_some() && other.line == finding.line && other.column == finding.column)
    };
    let new: Vec<AuditFinding> = known.found.into_iter().filter(|finding| !is_reported(finding)).collect();
    findings.extend(new);
    Ok(())
}

/// Checks that the cutter of a transition is that of its tool in the magazine.
fn tools_of_transitions(tree: &Node, findings: &mut Vec<AuditFinding>) {
    let tools = items(tree.get("tools"));
    for hole in items(tree.get("holes")) {
        for transition in items(hole.get("transitions")) {
            for (part, name) in [("tool", "designation"), ("holder", "holder")] {
                let number = transition.get("tool").and_then(|tool| tool.get("number")).and_then(Node::text);
                let Some(stated) = transition.get(part).and_then(|own| own.get("designation")) else { continue };
                let place_of = |tool: &&Node| tool.get("number").and_then(Node::text) == number;
                let Some(own) = tools.iter().find(place_of).and_then(|tool| tool.get(name)) else { continue };
                if own.text() == stated.text() || number == Some("0") {
                    continue;
                }
                let text = |node: &Node| node.text().unwrap_or_default().to_owned();
                let note = Note::new("audit-tool-of-transition")
                    .with("tool", text(stated))
                    .with("number", number.unwrap_or_default())
                    .with("other", text(own));
                let field = format!("tools.T{}.{name}", number.unwrap_or_default());
                let finding = AuditFinding::new(Severity::Error, Section::Tools, field, note).at(&own.place);
                let finding = finding.of_kind(FindingKind::ToolOfTransition);
                if !findings.iter().any(|known| known.note == finding.note) {
                    findings.push(finding);
                }
            }
        }
    }
}

/// Other disagreements about a tool whose name was changed are consequences of that change.
fn follow(context: &Context<'_>, findings: &mut [AuditFinding]) {
    let exchanged: Vec<String> = findings
        .iter()
        .filter(|finding| finding.kind == FindingKind::ToolOfTransition)
        .map(|finding| finding.field.clone())
        .collect();
    for field in exchanged {
        let Some(number) = context
            .stated
            .tools
            .iter()
            .map(|tool| tool.number)
            .find(|number| field.starts_with(&format!("tools.T{number}.")))
        else {
            continue;
        };
        let own = findings.iter_mut().filter(|finding| finding.subject.tool == Some(number));
        for finding in own.filter(|finding| finding.follows_from.is_empty()) {
            finding.follows_from = vec![field.clone()];
        }
    }
}

struct PlanComparer {
    found: Vec<AuditFinding>,
}

impl PlanComparer {
    fn compare(&mut self, node: &Node, ours: &Value, path: &str, (section, subject): (Section, &Subject)) {
        match (&node.kind, ours) {
            (NodeKind::Map(entries), Value::Object(map)) => {
                // Another transition or another tool has other figures.
                let same = |key: &str| {
                    let text = map.get(key).and_then(Value::as_str);
                    text.is_none() || node.get(key).and_then(Node::text) == text
                };
                let other = !same("operation") || !same("designation") && path.starts_with("tools");
                if other {
                    return;
                }
                let subject = about(node, path, subject);
                for (key, value) in entries.iter().filter(|(key, _)| !OUTSIDE.contains(&key.text.as_str())) {
                    if let Some(ours) = map.get(&key.text) {
                        self.compare(value, ours, &format!("{path}.{}", key.text), (section, &subject));
                    }
                }
            }
            (NodeKind::Seq(items), Value::Array(ours)) => {
                if items.len() != ours.len() {
                    let note = Note::new("audit-not-ours").with("field", path);
                    let note = note.with("stated", items.len()).with("right", ours.len());
                    let finding = AuditFinding::new(Severity::Doubtful, section, path.to_owned(), note).at(&node.place);
                    self.found.push(finding.about(subject.clone()));
                    return;
                }
                for (at, (item, ours)) in items.iter().zip(ours).enumerate() {
                    self.compare(item, ours, &format!("{path}.{}", at + 1), (section, subject));
                }
            }
            (NodeKind::Scalar { text, .. }, ours) => {
                let shown = match ours {
                    Value::String(text) => text.clone(),
                    other => other.to_string(),
                };
                let alike = match (text.parse::<f64>(), shown.parse::<f64>()) {
                    (Ok(a), Ok(b)) => (a - b).abs() <= SAME * b.abs().max(1.0),
                    _ => *text == shown || (node.is_null() && ours.is_null()),
                };
                if !alike {
                    let note = Note::new("audit-not-ours").with("field", path);
                    let note = note.with("stated", value(path, text)).with("right", value(path, &shown));
                    let finding = AuditFinding::new(Severity::Doubtful, section, path.to_owned(), note).at(&node.place);
                    self.found.push(finding.about(subject.clone()));
                }
            }
            _ => {}
        }
    }
}

/// A value as people read it: an id of the program in that field becomes a word, a name given by the author stays.
fn value(path: &str, text: &str) -> Figure {
    let own = |vocabulary| Figure::Word(Word { vocabulary, id: text.to_owned().into() });
    let mut keys = path.split('.').rev().skip_while(|key| key.bytes().all(|letter| letter.is_ascii_digit()));
    match keys.next().unwrap_or_default() {
        _ if matches!(text, "true" | "false" | "null") => own("audit-value"),
        "operation" => Figure::operation(text.to_owned()),
        "scheme" => Figure::scheme(text),
        "name" | "hole" | "designation" | "standard" | "table" => text.into_figure(),
        "feature" | "face" | "way" | "kind" => own("audit-value"),
        "fixture_kind" | "held" | "keying" | "locating" => own("table-value"),
        "limited_by" | "shank" => Figure::word(text.to_owned()),
        _ if text.parse::<f64>().is_ok() => Figure::number(text.to_owned()),
        _ => text.into_figure(),
    }
}

/// The subject of a node: a group of holes, a transition of it or a tool; else the subject of the enclosing node.
fn about(node: &Node, path: &str, around: &Subject) -> Subject {
    let text = |key: &str| node.get(key).and_then(Node::text);
    let mut subject = around.clone();
    if path.starts_with("holes.") && subject.holes.is_empty() {
        subject.holes.extend(text("name").map(str::to_owned));
    }
    subject.operation = subject.operation.or_else(|| text("operation").and_then(Operation::from_name));
    let number = match path.split('.').next() {
        Some("tools") => text("number"),
        Some("sequence") => text("tool"),
        _ => None,
    };
    subject.tool = subject.tool.or_else(|| number?.parse().ok());
    subject
}
