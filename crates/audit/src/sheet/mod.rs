//! Tables of CSV and XLSX as the tree that `read` reads: a plan by sections, or a list of tools alone. Their places are rows and columns
//! of the table.

pub(crate) mod cells;
pub(crate) mod columns;
mod heads;
mod list;
pub(crate) mod made;
mod sections;
pub(crate) mod translate;
mod write;

pub use write::by_tables;

use std::sync::Arc;

use technolog_note::{Note, note};
use technolog_sheets::Sheet;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Key, Node, NodeKind, Problems};
use crate::part::Part;

/// The material and the machine of a made part where nothing names them: nothing that depends on them is judged.
pub(crate) const STAND_INS: [(&str, &str); 2] = [("material", "steel-45"), ("machine", "gf2171")];

/// What a list of tools without a part leaves unsaid of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unsaid {
    /// The material.
    pub material: bool,
    /// The machine.
    pub machine: bool,
}

/// A table as a plan.
#[derive(Debug)]
pub(crate) struct Tabled {
    /// The plan, as a file of YAML would hold it.
    pub root: Node,
    /// Whether it is a list of tools and nothing else.
    pub is_list: bool,
    /// What it does not say of its part, where the part is made of the list itself.
    pub unsaid: Option<Unsaid>,
    /// How columns were read that could mean several things, and which were not read.
    pub remarks: Vec<(Place, Note)>,
}

/// Reads the tables of a file as a plan; `part` is the one that the command line names.
pub(crate) fn read(file: &str, sheets: &[Sheet], part: Option<&Part>, problems: &mut Problems) -> Option<Tabled> {
    let book = Book { file: file.into() };
    let sections = sections::of(&book, sheets);
    let mut remarks = Vec::new();
    if sections.iter().any(|section| section.kind == sections::Kind::List) {
        return list::read(&book, &sections, part, problems, &mut remarks);
    }
    let root = sections::plan(&book, &sections, part.is_some(), problems, &mut remarks)?;
    Some(Tabled { root, is_list: false, unsaid: None, remarks })
}

/// Whether tables are a plan by sections, or have the head of a list of tools; else they are something else.
pub fn is_plan_table(sheets: &[Sheet]) -> bool {
    let sections = sections::of(&Book { file: "".into() }, sheets);
    sections.iter().any(|section| section.kind != sections::Kind::List || section.has_head())
}

/// The file that places name.
pub(crate) struct Book {
    file: Arc<str>,
}

impl Book {
    /// The place of a cell: row and column of the table, from one.
    fn place(&self, line: u32, column: u32, text: &str) -> Place {
        let width = u32::try_from(text.chars().count()).unwrap_or(1).max(1);
        Place { file: self.file.clone(), line, column, width }
    }
}

/// A text with its place.
fn scalar(text: &str, place: &Place) -> Node {
    Node { kind: NodeKind::Scalar { text: text.to_owned(), quoted: true }, place: place.clone() }
}

/// An entry of a mapping.
fn entry(key: &str, node: Node) -> (Key, Node) {
    (Key { text: key.to_owned(), place: node.place.clone() }, node)
}

fn map(entries: Vec<(Key, Node)>, place: &Place) -> Node {
    Node { kind: NodeKind::Map(entries), place: place.clone() }
}

fn list_of(items: Vec<Node>, place: &Place) -> Node {
    Node { kind: NodeKind::Seq(items), place: place.clone() }
}

/// No head of a table was found in a section.
fn no_head(problems: &mut Problems, place: &Place) {
    let help = note!("sheet-no-head-help");
    problems.error_help::<()>("no-head", note!("sheet-no-head"), place, help);
}
