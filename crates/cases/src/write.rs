//! Fills open expectations of cases in the text of their file; nothing else in the file changes.

use serde_json::Value;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::diagnostic::{Diagnostic, Place};
use crate::knowledge::yaml::{Key, Node, NodeKind, parse};

use super::hold::ActualValue;
use super::{Asker, Case, CaseFile, Failure, ReadContext, digest, read_cases, written};

/// The most that a line of written YAML holds.
const WIDTH: usize = 110;

/// A file with its open expectations filled in.
#[derive(Debug, Default)]
pub struct Filled {
    /// The new text; absent if nothing was open.
    pub text: Option<String>,
    /// The numbers of the cases that were filled in.
    pub cases: Vec<usize>,
    /// Cases that cannot be filled in at their place.
    pub problems: Vec<Diagnostic>,
}

/// Fills in the open expectations of cases with the actual values. The new text is read and its cases are run before
/// it is returned: filled cases pass, and every other case is as before.
///
/// # Errors
/// The knowledge base lacks what a case asks of it.
pub fn fill(
    text: &str,
    file: &CaseFile,
    failures: &[Vec<Failure>],
    around: ReadContext<'_>,
    asker: &Asker<'_>,
) -> Result<Filled, KnowledgeError> {
    let mut filled = Filled::default();
    let (Some(root), _) = parse(&file.file, text) else { return Ok(filled) };
    let Some(NodeKind::Seq(tests)) = root.get("tests").map(|tests| &tests.kind) else { return Ok(filled) };
    let writer = Writer { text, lines: text.split_inclusive('\n').collect() };
    let mut made: Vec<(usize, Vec<Edit>)> = Vec::new();
    for (case, failures) in file.cases.iter().zip(failures) {
        let Some(own) = case.number.checked_sub(1).and_then(|index| tests.get(index)) else { continue };
        match writer.edits(own, case, failures) {
            Some(edits) if edits.is_empty() => {}
            Some(edits) => made.push((case.number, edits)),
            None => filled.problems.push(unfilled(case)),
        }
    }
    // What does not read back as intended is left out, and the rest is tried again.
    while !made.is_empty() {
        let new = writer.apply(made.iter().flat_map(|(_, edits)| edits));
        let numbers: Vec<usize> = made.iter().map(|(number, _)| *number).collect();
        let again = read_cases(&file.file, &new, around);
        let mut wrong = Vec::new();
        for (case, failures) in file.cases.iter().zip(failures) {
            if !is_right(case, failures, &again, numbers.contains(&case.number), asker)? {
                wrong.push(case);
            }
        }
        if wrong.is_empty() {
            filled.cases = numbers;
            filled.text = Some(new);
            return Ok(filled);
        }
        let before = made.len();
        made.retain(|(number, _)| !wrong.iter().any(|case| case.number == *number));
        filled.problems.extend(wrong.into_iter().map(unfilled));
        if made.len() == before {
            break;
        }
    }
    Ok(filled)
}

/// Whether a case is right in the new text: a filled one fails only where it did before; any other is unchanged.
fn is_right(
    case: &Case,
    failures: &[Failure],
    again: &CaseFile,
    filled: bool,
    asker: &Asker<'_>,
) -> Result<bool, KnowledgeError> {
    let Some(new) = again.cases.iter().find(|new| new.number == case.number) else { return Ok(false) };
    if !filled {
        let written = |case: &Case| case.expected.as_ref().map(|expected| expected.written.clone());
        return Ok(written(new) == written(case));
    }
    let standing = failures.iter().filter(|failure| !failure.is_open()).count();
    let now = new.run(asker)?;
    Ok(now.len() == standing && !now.iter().any(Failure::is_open))
}

fn unfilled(case: &Case) -> Diagnostic {
    let message = note!("case-case-cannot-filled-where-stands", case = case.number);
    Diagnostic::error("not-filled", message, case.place.clone()).help(note!("case-write-expect-on-line-own"))
}

/// A change of the text at a byte.
struct Edit {
    at: usize,
    removed: usize,
    put: String,
}

struct Writer<'t> {
    text: &'t str,
    lines: Vec<&'t str>,
}

impl Writer<'_> {
    /// The edits for a case; none if one of its open places cannot be found.
    fn edits(&self, own: &Node, case: &Case, failures: &[Failure]) -> Option<Vec<Edit>> {
        if let (None, [Failure { actual: ActualValue::Open(Some(digest)), .. }]) = (&case.expected, failures) {
            return Some(vec![self.whole_expectation(own, digest)]);
        }
        let open = failures.iter().filter_map(|failure| match &failure.actual {
            ActualValue::Open(came) => Some((&failure.place, came.as_ref().map(digest::bare).unwrap_or_default())),
            _ => None,
        });
        open.map(|(place, came)| self.empty(place, &written::value(&came))).collect()
    }

    /// The byte position of a line and a column, from 1.
    fn byte(&self, line: u32, column: u32) -> usize {
        let (line, column) = (line as usize, column as usize);
        let before: usize = self.lines.iter().take(line.saturating_sub(1)).map(|line| line.len()).sum();
        let inside = self.lines.get(line.saturating_sub(1)).copied().unwrap_or_default();
        let inside: usize = inside.chars().take(column.saturating_sub(1)).map(char::len_utf8).sum();
        before + inside
    }

    fn at(&self, place: &Place) -> usize {
        self.byte(place.line, place.column)
    }

    fn text_from(&self, at: usize) -> &str {
        self.text.get(at..).unwrap_or_default()
    }

    /// The whole expectation of a case.
    fn whole_expectation(&self, case: &Node, value: &Value) -> Edit {
        let flow = self.text_from(self.at(&case.place)).starts_with('{');
        let indent = case.place.column as usize - 1;
        let text = |flow: bool| if flow { format!(" {}", written::value(value)) } else { block(value, indent + 2) };
        let NodeKind::Map(entries) = &case.kind else { return Edit { at: 0, removed: 0, put: String::new() } };
        let find = |name: &str| entries.iter().find(|(key, _)| key.text == name);
        if let Some((key, node)) = find("expect") {
            if let Some(edit) = self.explicit(&node.place, text(flow).trim_start()) {
                return edit;
            }
            let end = self.at(&key.place) + key_length(self.text_from(self.at(&key.place)), key);
            return self.behind_colon(end, text(flow));
        }
        // Before the keys of its origin, otherwise at the end.
        let first = entries.iter().find(|(key, _)| ["source", "because"].contains(&key.text.as_str()));
        if let Some((key, _)) = first {
            let then = if flow { ", ".to_owned() } else { format!("\n{}", " ".repeat(indent)) };
            return Edit {
                at: self.at(&key.place),
                removed: 0,
                put: self.lined(format!("expect:{}{then}", text(flow))),
            };
        }
        if flow {
            let at = self.at(&case.place) + last_of_flow(self.text_from(self.at(&case.place))).unwrap_or_default();
            let comma = if self.text.get(..at).is_some_and(|head| head.ends_with(',')) { " " } else { ", " };
            return Edit { at, removed: 0, put: self.lined(format!("{comma}expect:{}", text(true))) };
        }
        let put = format!("\n{}expect:{}", " ".repeat(indent), text(false));
        Edit { at: self.end_of_block(case.place.line as usize, indent), removed: 0, put: self.lined(put) }
    }

    /// An empty value inside an expectation.
    fn empty(&self, place: &Place, value: &str) -> Option<Edit> {
        let at = self.at(place);
        self.explicit(place, value).or_else(|| {
            let is_key = self.text_from(at).trim_start_matches(' ').starts_with(':');
            is_key.then(|| self.behind_colon(at, format!(" {value}")))
        })
    }

    /// A `~` or `null` at that place.
    fn explicit(&self, place: &Place, value: &str) -> Option<Edit> {
        let at = self.at(place);
        let word = ["~", "null"].into_iter().find(|word| self.text_from(at).starts_with(word))?;
        Some(Edit { at, removed: word.len(), put: self.lined(value.to_owned()) })
    }

    fn behind_colon(&self, at: usize, value: String) -> Edit {
        let colon = self.text_from(at).find(|letter: char| letter != ' ').map_or(at, |spaces| at + spaces);
        let mut at = if self.text_from(colon).starts_with(':') { colon + 1 } else { colon };
        let line = self.text_from(at).lines().next().unwrap_or_default();
        if value.starts_with('\n') && line.trim_start().starts_with('#') {
            // A comment stays beside its key.
            at += line.len();
        }
        Edit { at, removed: 0, put: self.lined(value) }
    }

    /// The end of the last line of a mapping in block style.
    fn end_of_block(&self, line: usize, indent: usize) -> usize {
        let mut last = line;
        for (index, text) in self.lines.iter().enumerate().skip(line) {
            let content = text.trim();
            let own = text.len() - text.trim_start_matches(' ').len();
            if content.is_empty() || own < indent && content.starts_with('#') {
                continue;
            }
            if own < indent {
                break;
            }
            last = index + 1;
        }
        let before: usize = self.lines.iter().take(last.saturating_sub(1)).map(|line| line.len()).sum();
        before + self.lines.get(last.saturating_sub(1)).map_or(0, |line| line.trim_end_matches(['\n', '\r']).len())
    }

    /// With the line ends of the file.
    fn lined(&self, text: String) -> String {
        if self.text.contains("\r\n") { text.replace('\n', "\r\n") } else { text }
    }

    fn apply<'e>(&self, edits: impl Iterator<Item = &'e Edit>) -> String {
        let mut edits: Vec<&Edit> = edits.collect();
        edits.sort_by_key(|edit| edit.at);
        let mut text = self.text.to_owned();
        for edit in edits.iter().rev() {
            text.replace_range(edit.at..edit.at + edit.removed, &edit.put);
        }
        text
    }
}

/// The length of a key as written, with its quotes.
fn key_length(text: &str, key: &Key) -> usize {
    match text.chars().next() {
        Some(quote @ ('"' | '\'')) => text[1..].find(quote).map_or(key.text.len(), |end| end + 2),
        _ => key.text.len(),
    }
}

/// The end of the last value in the flow mapping that begins a text, with a comma that may follow it.
fn last_of_flow(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    let mut last = 0;
    let mut before = ' ';
    let mut letters = text.char_indices();
    while let Some((at, letter)) = letters.next() {
        match letter {
            '{' | '[' => depth += 1,
            '}' | ']' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(last);
                }
            }
            // A quote opens a text only at the beginning of a value.
            '"' | '\'' if "{[,:".contains(before) || before.is_whitespace() => {
                while let Some((end, inner)) = letters.next() {
                    if inner == '\\' && letter == '"' {
                        letters.next();
                    } else if inner == letter {
                        last = end + 1;
                        break;
                    }
                }
            }
            '#' if before.is_whitespace() => {
                letters.by_ref().find(|(_, inner)| *inner == '\n');
                before = '\n';
                continue;
            }
            _ => {}
        }
        if !letter.is_whitespace() {
            last = last.max(at + letter.len_utf8());
        }
        before = letter;
    }
    None
}

/// A value after a colon: on the same line if it fits, otherwise on lines of its own.
fn block(value: &Value, indent: usize) -> String {
    let flow = written::value(value);
    if indent + flow.chars().count() <= WIDTH {
        return format!(" {flow}");
    }
    let margin = " ".repeat(indent);
    match value {
        Value::Object(entries) => {
            let line = |(key, inner): (&String, &Value)| {
                format!("\n{margin}{}:{}", written::scalar(key), block(inner, indent + 2))
            };
            written::in_order(entries).into_iter().map(line).collect()
        }
        Value::Array(items) => items.iter().map(|item| format!("\n{margin}- {}", written::value(item))).collect(),
        _ => format!(" {flow}"),
    }
}
