//! A plan as tables: a sheet, or a part of one under a line with its name, for each part of the plan.

use technolog_core::lang::Lang;
use technolog_note::{Note, note};
use technolog_sheets::{Row, Sheet};

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Key, Node, Problems};

use super::cells::{designation, figure, is_empty};
use super::columns::{Column, Of, head, norm};
use super::heads::{self, Heads};
use super::{Book, entry, list_of, map, no_head, scalar};

/// What a section holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Name, part and method of the plan, a line each.
    Plan,
    /// The rows of the route.
    Route,
    /// The tools.
    Tools,
    /// The conditions.
    Conditions,
    /// The clamping, a line each.
    Clamping,
    /// The program, a line each.
    Program,
    /// The times, a line each.
    Times,
    /// A list of tools with all that is known of each in its row.
    List,
}

impl Kind {
    pub const NAMED: [(Self, &'static str); 7] = [
        (Self::Plan, "plan"),
        (Self::Route, "route"),
        (Self::Tools, "tools"),
        (Self::Conditions, "conditions"),
        (Self::Clamping, "clamping"),
        (Self::Program, "program"),
        (Self::Times, "times"),
    ];

    /// The mappings whose keys are its columns or lines.
    pub const fn forms(self) -> &'static [Of] {
        match self {
            Self::Plan => &[Of::Plan, Of::Part],
            Self::Route => &[Of::Row],
            Self::Tools => &[Of::Place, Of::Tool, Of::Holder],
            Self::Conditions => &[Of::Conditions, Of::Card],
            Self::Clamping => &[Of::Clamping],
            Self::Program => &[Of::Program],
            Self::Times => &[Of::Times],
            Self::List => &[Of::Row, Of::Tool, Of::Holder, Of::Conditions, Of::Card],
        }
    }
}

/// A section: its rows with their head.
#[derive(Debug)]
pub(crate) struct Section {
    pub kind: Kind,
    pub rows: Vec<Row>,
    /// Where it begins.
    pub place: Place,
}

impl Section {
    /// Whether a row of it is the head of a list of tools.
    pub(super) fn has_head(&self) -> bool {
        self.rows.iter().any(|row| heads::count(row, Kind::List.forms()) > 1)
    }
}

/// The section of a name, if it is one.
fn named(text: &str) -> Option<Kind> {
    let wanted = norm(text);
    let is_called = |key: &'static str| Column { of: Of::Plan, key }.is_called(&wanted, true);
    Kind::NAMED.iter().find(|(_, key)| is_called(key)).map(|(kind, _)| *kind)
}

/// The sections of a file. A sheet whose rows no line with the name of a section parts is one; without any name it is a list of tools.
pub(crate) fn of(book: &Book, sheets: &[Sheet]) -> Vec<Section> {
    let titled = |row: &Row| {
        let mut filled = row.filled();
        let only = filled.next().map(|(_, text)| text).filter(|_| filled.next().is_none())?;
        named(only.trim_matches(['[', ']', '#', ' ']))
    };
    let mut sections = Vec::new();
    for sheet in sheets {
        let start = book.place(1, 1, "");
        let mut own: Vec<Section> = Vec::new();
        for row in &sheet.rows {
            if let Some(kind) = titled(row) {
                own.push(Section { kind, rows: Vec::new(), place: book.place(row.line, 1, "") });
            } else if let Some(section) = own.last_mut() {
                section.rows.push(row.clone());
            } else {
                let kind = named(&sheet.name).unwrap_or(Kind::List);
                own.push(Section { kind, rows: vec![row.clone()], place: start.clone() });
            }
        }
        sections.extend(own);
    }
    let parts = sections.iter().filter(|section| section.kind != Kind::Plan && section.kind != Kind::List);
    if parts.clone().any(|section| section.kind != Kind::Tools) {
        // Beside a plan by sections a sheet without a name of one is something else: notes, a drawing, a sum.
        sections.retain(|section| section.kind != Kind::List);
        return sections;
    }
    // Tools alone are a list, whatever their sheet is called.
    for section in sections.iter_mut().filter(|section| section.kind == Kind::Tools) {
        section.kind = Kind::List;
    }
    if sections.iter().any(|section| section.kind == Kind::List && section.has_head()) {
        sections.retain(|section| section.kind == Kind::Plan || section.has_head());
    }
    sections
}

/// The tree of a plan by sections.
pub(super) fn plan(
    book: &Book,
    sections: &[Section],
    has_part: bool,
    problems: &mut Problems,
    remarks: &mut Vec<(Place, Note)>,
) -> Option<Node> {
    let place = sections.first().map(|section| section.place.clone())?;
    let mut root: Vec<(Key, Node)> = Vec::new();
    for section in sections {
        let key = Kind::NAMED.iter().find(|(kind, _)| *kind == section.kind).map(|(_, key)| *key);
        let Some(key) = key else { continue };
        match section.kind {
            Kind::Plan => {
                let lines = lines(book, section, remarks);
                root.extend(
                    lines
                        .into_iter()
                        .filter(|(column, _)| column.of == Of::Plan)
                        .map(|(own, node)| entry(own.key, node)),
                );
            }
            Kind::Clamping | Kind::Program | Kind::Times => {
                let entries =
                    lines(book, section, remarks).into_iter().map(|(own, node)| entry(own.key, node)).collect();
                root.push(entry(key, map(entries, &section.place)));
            }
            _ => {
                let rows = table(book, section, problems, remarks);
                let node = match section.kind {
                    Kind::Tools => tools(rows, &section.place, problems),
                    _ => {
                        list_of(rows.into_iter().map(|(place, cells)| nested(cells, &place)).collect(), &section.place)
                    }
                };
                root.push(entry(key, node));
            }
        }
    }
    if has_part {
        root.retain(|(key, _)| key.text != "part");
    }
    Some(map(root, &place))
}

/// The lines of a section: a name and a value each. A line of no known name is a remark.
pub(super) fn lines(book: &Book, section: &Section, remarks: &mut Vec<(Place, Note)>) -> Vec<(Column, Node)> {
    let mut found = Vec::new();
    for row in &section.rows {
        let Some((column, key, value)) = line(row, section.kind.forms()) else {
            // A name without a value is a line that nobody filled in.
            let is_bare = |text: &str| {
                section.kind.forms().iter().flat_map(|of| of.columns()).any(|own| own.is_called(head(text).0, true))
            };
            if row.filled().count() == 1 && row.filled().all(|(_, text)| is_bare(text)) {
                continue;
            }
            if let Some((column, text)) = row.filled().next() {
                remarks.push((book.place(row.line, column, text), note!("audit-column-unread", column = text)));
            }
            continue;
        };
        if is_empty(&value) {
            continue;
        }
        let value = key.unit().map_or_else(|| value.clone(), |unit| figure(&value, unit));
        let node = scalar(&value, &book.place(row.line, column, &value));
        let listed = matches!(key.key, "scope" | "at");
        found.push((key, if listed { several(&node) } else { node }));
    }
    found
}

/// A line as a key and its value, with the column of the value: in two cells, or in one with a colon.
pub(super) fn line(row: &Row, forms: &[Of]) -> Option<(u32, Column, String)> {
    let mut filled = row.filled();
    let (at, first) = filled.next()?;
    let second = filled.next();
    let (name, value, column) = match second {
        Some((column, value)) => (first, value, column),
        None => {
            let (name, value) = first.split_once(':')?;
            (name, value.trim(), at)
        }
    };
    let (name, unit) = head(name);
    let of_unit = |column: &Column| unit.is_none_or(|unit| column.unit() == Some(unit));
    let known = forms.iter().flat_map(|of| of.columns()).filter(of_unit);
    let mut known: Vec<Column> =
        known.filter(|column| column.is_called(name, true) || column.has_symbol(&norm(name))).collect();
    known.sort_by_key(|column| !column.is_called(name, true));
    Some((column, *known.first()?, value.to_owned()))
}

/// Several values in one cell: `0; -130 / 0; 130` are two points, `1; 2` two rows.
fn several(node: &Node) -> Node {
    let text = node.text().unwrap_or_default().to_owned();
    let items = |text: &str| -> Vec<Node> {
        text.split([';', ' '])
            .map(str::trim)
            .filter(|part| !part.is_empty())
            .map(|part| scalar(part, &node.place))
            .collect()
    };
    if text.contains('/') {
        return list_of(text.split('/').map(|point| list_of(items(point), &node.place)).collect(), &node.place);
    }
    list_of(items(&text.replace(", ", "; ")), &node.place)
}

/// The cells of a row by their columns.
pub(super) type Cells = Vec<(Column, Node)>;

/// The rows under the head of a section.
pub(super) fn table(
    book: &Book,
    section: &Section,
    problems: &mut Problems,
    remarks: &mut Vec<(Place, Note)>,
) -> Vec<(Place, Cells)> {
    let forms = section.kind.forms();
    let Some(at) = section.rows.iter().position(|row| heads::count(row, forms) > 1) else {
        no_head(problems, &section.place);
        return Vec::new();
    };
    let Some((first, below)) = section.rows.get(at..).and_then(<[Row]>::split_first) else { return Vec::new() };
    let heads = heads::read(book, first, below, forms, problems, remarks);
    below
        .iter()
        .map(|row| (book.place(row.line, 1, ""), cells(book, row, &heads)))
        .filter(|(_, cells)| !cells.is_empty())
        .collect()
}

/// The cells of a row that say something.
fn cells(book: &Book, row: &Row, heads: &Heads) -> Cells {
    let mut cells: Cells = Vec::new();
    for (column, own) in heads {
        let text = row.cell(*column);
        if is_empty(text) {
            continue;
        }
        let place = book.place(row.line, *column, text);
        let text = match own.unit() {
            Some(unit) => figure(text, unit),
            None => text.to_owned(),
        };
        match (own.of, own.key) {
            (Of::Tool | Of::Holder, "designation") | (Of::Tool, "holder") => {
                let (name, standard) = designation(&text);
                cells.push((*own, scalar(&name, &place)));
                let stated = heads.iter().any(|(_, other)| other.of == own.of && other.key == "standard");
                if let Some(standard) = standard.filter(|_| !stated) {
                    let of = if own.key == "holder" { Of::Holder } else { own.of };
                    cells.push((Column { of, key: "standard" }, scalar(&standard, &place)));
                }
            }
            (Of::Conditions, "for") => cells.push((*own, several(&scalar(&text, &place)))),
            _ => cells.push((*own, scalar(&text, &place))),
        }
    }
    cells
}

/// The mapping of a row, with the mappings in it. A holder's cell holds its designation.
pub(super) fn nested(cells: Cells, place: &Place) -> Node {
    let (mut own, mut holder, mut card) = (Vec::new(), Vec::new(), Vec::new());
    for (column, node) in cells {
        match (column.of, column.key) {
            (Of::Tool, "holder") if is_place(&node) => own.push(entry("holder", node)),
            (Of::Tool, "holder") => holder.push(entry("designation", node)),
            (Of::Holder, key) => holder.push(entry(key, node)),
            (Of::Card, key) => card.push(entry(key, node)),
            (_, key) => own.push(entry(key, node)),
        }
    }
    for (key, entries) in [("holder", holder), ("card", card)] {
        if let Some((_, first)) = entries.first() {
            let place = first.place.clone();
            own.push(entry(key, map(entries, &place)));
        }
    }
    map(own, place)
}

/// Whether a cell names the place of a tool: `T1`.
fn is_place(node: &Node) -> bool {
    let text = node.text().unwrap_or_default();
    text.strip_prefix(['T', 'Т']).is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit()))
}

/// The tools by their places, which a column of the table says.
fn tools(rows: Vec<(Place, Cells)>, place: &Place, problems: &mut Problems) -> Node {
    let mut tools = Vec::new();
    for (place, mut cells) in rows {
        let Some(at) = cells.iter().position(|(column, _)| column.key == "tool") else {
            problems.error_help::<()>(
                "missing-key",
                note!("sheet-tool-without-place"),
                &place,
                note!("planfile-name-by-place-t-t"),
            );
            continue;
        };
        let (_, node) = cells.remove(at);
        let text = node.text().unwrap_or_default().to_owned();
        let tool = nested(cells, &place);
        tools.push((Key { text, place: node.place }, tool));
    }
    map(tools, place)
}

/// The name that the program writes over a section.
pub(crate) fn title(kind: Kind, lang: Lang) -> &'static str {
    let key = Kind::NAMED.iter().find(|(known, _)| *known == kind).map_or("plan", |(_, key)| key);
    Column { of: Of::Plan, key }.name(lang)
}
