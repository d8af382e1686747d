//! Recognises the kind of a file by its contents: a file given to the wrong command is reported once, and not by
//! every key that the other kind lacks.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Node, NodeKind, parse};

/// A kind of file for a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A part with holes.
    Part,
    /// A turned part or a stepped shaft.
    Turned,
    /// A plan, by hand or by the program.
    Plan,
    /// Cases with expectations.
    Cases,
    /// The operator's setting.
    Setting,
    /// A marking scheme.
    Marks,
    /// A table of the knowledge.
    Table,
    /// A program of a control.
    Program,
    /// A list of points, which is never recognised.
    List,
    /// YAML or JSON of some other kind.
    Yaml,
}

/// Top-level keys that no file of an earlier kind has; any of them identifies the kind.
const KEYS: &[(FileKind, &[&str])] = &[
    (FileKind::Cases, &["tests"]),
    (FileKind::Table, &["columns"]),
    // A plan of the program also has the holes of its part.
    (FileKind::Plan, &["plan", "route", "sequence"]),
    (FileKind::Turned, &["shaft", "outer"]),
    (FileKind::Part, &["holes"]),
    (FileKind::Marks, &["scheme", "deduct"]),
    (FileKind::Setting, &["correctors", "zeros", "feed_override", "speed_override", "homed", "optional_stop"]),
];

impl FileKind {
    /// The key of its name in the message catalogue.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Part => "kind-part",
            Self::Turned => "kind-turned",
            Self::Plan => "kind-plan",
            Self::Cases => "kind-cases",
            Self::Setting => "kind-setting",
            Self::Marks => "kind-marks",
            Self::Table => "kind-table",
            Self::Program => "kind-program",
            Self::List => "kind-list",
            Self::Yaml => "kind-yaml",
        }
    }

    fn keys(self) -> &'static [&'static str] {
        KEYS.iter().find(|(kind, _)| *kind == self).map_or(&[], |(_, keys)| keys)
    }
}

/// The kind of a file that is not of the wanted kind, with the place that shows it; none if it may be of the wanted
/// kind with mistakes, or if the kind is unknown.
pub fn other_kind(file: &str, text: &str, wanted: FileKind) -> Option<(FileKind, Place)> {
    if wanted != FileKind::Program && is_program(text) {
        return Some((FileKind::Program, Place { file: file.into(), line: 1, column: 1, width: 1 }));
    }
    let root = parse(file, text).0?;
    let first = |keys: &[&str]| entries(&root).find(|(key, _)| keys.contains(key)).map(|(_, place)| place.clone());
    let ours = entries(&root).any(|(key, _)| key == "sequence") && root.get("holes").is_some();
    if first(wanted.keys()).is_some() && !(ours && wanted == FileKind::Part) {
        return None;
    }
    let known = KEYS.iter().find_map(|(kind, keys)| Some((*kind, first(keys)?)));
    known.or_else(|| {
        let any = entries(&root).next().filter(|_| wanted == FileKind::Program);
        any.map(|(_, place)| (FileKind::Yaml, place.clone()))
    })
}

fn entries(root: &Node) -> impl Iterator<Item = (&str, &Place)> {
    let entries = match &root.kind {
        NodeKind::Map(entries) => entries.as_slice(),
        _ => &[],
    };
    entries.iter().map(|(key, _)| (key.text.as_str(), &key.place))
}

/// The number of lines examined: enough to be sure, while a file may have millions.
const LINES: usize = 40;

/// Whether it is a program of a control: most of its lines begin with an address and a number.
fn is_program(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    let is_content = |line: &&str| !line.is_empty() && !line.starts_with(['(', ';', '#']);
    let lines: Vec<&str> = text.lines().map(str::trim).filter(is_content).take(LINES).collect();
    let of_program = lines.iter().filter(|line| line.starts_with('%') || begins_with_word(line)).count();
    of_program > 0 && of_program * 10 >= lines.len() * 8
}

fn begins_with_word(line: &str) -> bool {
    let mut signs = line.trim_start_matches('/').trim_start().chars();
    let address = signs.next().is_some_and(|sign| sign == ':' || sign.is_ascii_alphabetic());
    let number = signs.as_str().trim_start_matches(['+', '-', '.']);
    address && number.starts_with(|sign: char| sign.is_ascii_digit()) && !line.contains(": ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_told_by_its_keys_and_a_program_by_its_words() {
        for (text, wanted, kind) in [
            ("shaft: Вал\nsteps: []\n", FileKind::Part, Some(FileKind::Turned)),
            ("part: P\nholes: []\n", FileKind::Turned, Some(FileKind::Part)),
            ("plan: P\npart: p.yaml\n", FileKind::Part, Some(FileKind::Plan)),
            ("{\"part\": {}, \"holes\": [], \"sequence\": []}", FileKind::Part, Some(FileKind::Plan)),
            ("correctors: {1: 5}\n", FileKind::Part, Some(FileKind::Setting)),
            ("%\n:01\nN5 G17\nN10 P02\n", FileKind::Part, Some(FileKind::Program)),
            ("G21 G90\n(holes)\ng0 x1\nM2\n", FileKind::Plan, Some(FileKind::Program)),
            ("material: steel\n", FileKind::Program, Some(FileKind::Yaml)),
            ("tests: []\n", FileKind::Plan, Some(FileKind::Cases)),
            ("scheme: S\n", FileKind::Plan, Some(FileKind::Marks)),
            ("columns: []\n", FileKind::Part, Some(FileKind::Table)),
            // Of the wanted kind with mistakes, or of an unknown kind.
            ("part: P\nholes: []\nshaft: 1\n", FileKind::Part, None),
            ("part: P\nmaterial: steel-45\n", FileKind::Part, None),
            ("part: [\n", FileKind::Part, None),
            ("- 1\n", FileKind::Part, None),
            ("", FileKind::Part, None),
            ("N1 X80,5\nG1\n", FileKind::Program, None),
        ] {
            let message = other_kind("f", text, wanted);
            assert_eq!(message.map(|(kind, _)| kind), kind, "{text}");
        }
    }
}
