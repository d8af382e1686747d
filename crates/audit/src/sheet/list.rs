//! A list of tools alone: in each row what is made, with what, at which conditions. It becomes a plan of tools and conditions, with the
//! part that is given, or with one that is made of the list: then nothing is judged that depends on what the list does not say.

use technolog_note::{Note, note};
use technolog_sheets::Row;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Key, Node, Problems};
use crate::part::Part;
use crate::plan::Operation;
use technolog_core::lang::Lang;
use technolog_core::words::operation_named;

use super::cells::{self, hole, of_size, size};
use super::columns::{Column, Of};
use super::made::{self, MadeHole};
use super::sections::{Cells, Kind, Section, line, lines, nested, table};
use super::{Book, Tabled, Unsaid, entry, list_of, map, scalar};

/// A row of the list, taken apart.
struct Entry {
    place: Place,
    route: Vec<(Key, Node)>,
    tool: Cells,
    number: Option<Node>,
    conditions: Cells,
}

/// The plan of a list.
pub(super) fn read(
    book: &Book,
    sections: &[Section],
    part: Option<&Part>,
    problems: &mut Problems,
    remarks: &mut Vec<(Place, Note)>,
) -> Option<Tabled> {
    let place = sections.first().map(|section| section.place.clone())?;
    let mut root: Vec<(Key, Node)> = Vec::new();
    let mut said: Vec<(Column, Node)> = Vec::new();
    let mut entries: Vec<Entry> = Vec::new();
    for section in sections {
        if section.kind == Kind::Plan {
            said.extend(lines(book, section, remarks));
            continue;
        }
        said.extend(above(book, section));
        let rows = table(book, section, problems, remarks);
        if without_operation(book, section, &rows, problems) {
            return None;
        }
        entries.extend(rows.into_iter().map(|(place, cells)| apart(place, cells)));
    }
    let mut holes = Holes { part, made: Vec::new(), last: None };
    let (mut rows, mut tools, mut conditions) = (Vec::new(), Tools::default(), Vec::new());
    for one in entries {
        let number = tools.place_of(&one, problems);
        let is_row = one.route.iter().any(|(key, _)| key.text == "operation");
        if !is_row {
            // A row of sums or of words under the table has no operation, and none of its figures is of a tool.
            if one.tool.is_empty() || !one.conditions.is_empty() {
                let message = note!("sheet-row-without-operation");
                problems.error_help::<()>(
                    "missing-key",
                    message,
                    &one.place,
                    note!("sheet-row-without-operation-help"),
                );
            }
            continue;
        }
        let number_of_row = rows.len() + 1;
        let mut route = holes.with_hole(one.route);
        if let Some(tool) = &number {
            route.push(entry("tool", tool.clone()));
        }
        rows.push(map(route, &one.place));
        if !one.conditions.is_empty() {
            let mut own = one.conditions;
            own.insert(0, (Column { of: Of::Conditions, key: "for" }, scalar(&number_of_row.to_string(), &one.place)));
            conditions.push(nested(own, &one.place));
        }
    }
    let scope: Vec<Node> = [("tools", !tools.0.is_empty()), ("conditions", !conditions.is_empty())]
        .into_iter()
        .filter(|(_, covered)| *covered)
        .map(|(name, _)| scalar(name, &place))
        .collect();
    let mut unsaid = None;
    // What has no ending is the name of the part and no file.
    let is_named = |(column, node): &(Column, Node)| {
        column.key == "part" && node.text().is_some_and(|text| !text.contains(['.', '/', '\\']))
    };
    said.retain(|own| !is_named(own));
    if part.is_none() && !said.iter().any(|(column, _)| column.key == "part") {
        let has = |key: &str| said.iter().any(|(column, _)| column.of == Of::Part && column.key == key);
        unsaid = Some(Unsaid { material: !has("material"), machine: !has("machine") });
        root.push(entry("part", holes.part(&said, &place)));
    }
    let of_plan =
        said.into_iter().filter(|(column, _)| column.of == Of::Plan && !["scope", "route"].contains(&column.key));
    root.extend(
        of_plan.filter(|(column, _)| part.is_none() || column.key != "part").map(|(own, node)| entry(own.key, node)),
    );
    if !scope.is_empty() {
        root.push(entry("scope", list_of(scope, &place)));
    }
    if !rows.is_empty() {
        root.push(entry("route", list_of(rows, &place)));
    }
    root.push(entry(
        "tools",
        map(tools.0.into_iter().map(|(key, cells, place)| (key, nested(cells, &place))).collect(), &place),
    ));
    if !conditions.is_empty() {
        root.push(entry("conditions", list_of(conditions, &place)));
    }
    Some(Tabled { root: map(root, &place), is_list: true, unsaid, remarks: std::mem::take(remarks) })
}

/// What stands above the head of a list: its material, its machine, whose it is. Other lines are titles.
fn above(book: &Book, section: &Section) -> Vec<(Column, Node)> {
    let is_head = |row: &&Row| super::heads::count(row, section.kind.forms()) > 1;
    let at = section.rows.iter().position(|row| is_head(&row)).unwrap_or_default();
    let said = |row: &Row| {
        let (column, key, value) = line(row, &[Of::Part, Of::Plan])?;
        Some((key, scalar(&value, &book.place(row.line, column, &value))))
    };
    section.rows.iter().take(at).filter_map(said).collect()
}

/// Whether nothing of a table says what is done although its rows tell of holes or conditions: told once, at its head, with the columns
/// that were not read. A table of tools alone says nothing of it, and need not.
fn without_operation(book: &Book, section: &Section, rows: &[(Place, Cells)], problems: &mut Problems) -> bool {
    let is_said = |of: &Of, key: &str| match of {
        Of::Row => ["hole", "feature", "step", "depth"].contains(&key),
        Of::Conditions | Of::Card | Of::Factors => true,
        _ => false,
    };
    let mut cells = rows.iter().flat_map(|(_, cells)| cells);
    if !cells.any(|(own, _)| is_said(&own.of, own.key)) {
        return false;
    }
    let forms = section.kind.forms();
    let Some(head) = section.rows.iter().find(|row| super::heads::count(row, forms) > 1) else { return false };
    if super::heads::has_operation(head, forms) {
        return false;
    }
    let unread = super::heads::unread(head, forms);
    let help = match unread.is_empty() {
        true => note!("sheet-list-without-operation-help"),
        false => note!("sheet-list-without-operation-unread", columns = unread.join(", ")),
    };
    let place = book.place(head.line, 1, "");
    problems.error_help::<()>("missing-key", note!("sheet-list-without-operation"), &place, help);
    true
}

fn apart(place: Place, cells: Cells) -> Entry {
    let mut one = Entry { place, route: Vec::new(), tool: Vec::new(), number: None, conditions: Vec::new() };
    for (column, node) in cells {
        match (column.of, column.key) {
            (Of::Row, "tool") => one.number = Some(node),
            // The number of a line means nothing in a list.
            (Of::Row, "row") => {}
            (Of::Row, key) => one.route.push(entry(key, node)),
            (Of::Tool | Of::Holder, _) => one.tool.push((column, node)),
            _ => one.conditions.push((column, node)),
        }
    }
    sized(&mut one);
    one
}

/// A tool that is named by its kind and standard alone is of the size that it makes: two of other sizes are two tools.
fn sized(one: &mut Entry) {
    let key = |key: &'static str| Column { of: Of::Tool, key };
    let of_route = |wanted: &str| one.route.iter().find(|(key, _)| key.text == wanted).map(|(_, node)| node.clone());
    let has = |wanted: Column| one.tool.iter().any(|(column, _)| *column == wanted);
    let has_number = |node: &Node| node.text().is_some_and(|text| text.chars().any(|sign| sign.is_ascii_digit()));
    let named = one.tool.iter().any(|(column, node)| *column == key("designation") && !has_number(node));
    let operation = of_route("operation").and_then(|node| {
        let text = node.text()?.to_owned();
        Lang::all().find_map(|lang| operation_named(&text, lang)).or_else(|| Operation::from_name(&text))
    });
    let makes_its_size = matches!(
        operation,
        Some(
            Operation::Drill
                | Operation::DrillOut
                | Operation::CoreDrill
                | Operation::RoughReam
                | Operation::FinishReam
        )
    );
    if named && makes_its_size && !has(key("diameter")) && has(key("standard")) {
        one.tool.extend(of_route("diameter").map(|node| (key("diameter"), node)));
    }
}

/// The tools of a list by their places: as its column says, else in their order, equal ones once.
#[derive(Default)]
struct Tools(Vec<(Key, Cells, Place)>);

impl Tools {
    /// The place of the tool of a row; none if the row names no tool.
    fn place_of(&mut self, one: &Entry, problems: &mut Problems) -> Option<Node> {
        if one.number.is_none() && one.tool.is_empty() {
            return None;
        }
        let place =
            one.number.as_ref().or(one.tool.first().map(|(_, node)| node)).map_or(&one.place, |node| &node.place);
        let same = |own: &Cells| {
            own.len() == one.tool.len()
                && own.iter().zip(&one.tool).all(|(a, b)| a.0 == b.0 && a.1.text() == b.1.text())
        };
        let text = match &one.number {
            Some(number) => {
                let text = number.text().unwrap_or_default().trim();
                format!("T{}", text.trim_start_matches(['T', 'Т', 't', 'т']))
            }
            None => match self.0.iter().find(|(_, own, _)| same(own)) {
                Some((key, ..)) => key.text.clone(),
                None => self.free(),
            },
        };
        match self.0.iter_mut().find(|(key, ..)| key.text == text) {
            None => {
                self.0.push((Key { text: text.clone(), place: place.clone() }, one.tool.clone(), one.place.clone()))
            }
            Some((_, own, _)) => {
                for (column, node) in &one.tool {
                    match own.iter().find(|(known, _)| known == column) {
                        None => own.push((*column, node.clone())),
                        Some((_, known)) if known.text() == node.text() => {}
                        Some((_, known)) => {
                            let message = note!("sheet-tool-differs", tool = text, line = known.place.line);
                            problems.error_help::<()>(
                                "duplicate-tool",
                                message,
                                &node.place,
                                note!("sheet-tool-differs-help"),
                            );
                        }
                    }
                }
            }
        }
        Some(scalar(&text, place))
    }

    fn free(&self) -> String {
        let is_free = |text: &String| !self.0.iter().any(|(key, ..)| key.text == *text);
        (1..).map(|number: u32| format!("T{number}")).find(is_free).unwrap_or_default()
    }
}

/// The holes of a list.
struct Holes<'p> {
    /// Of the part, where there is one.
    part: Option<&'p Part>,
    /// Else of the list: name, diameter as a part has it, the largest depth.
    made: Vec<(String, String, f64)>,
    /// The hole of the row above, which a merged cell leaves out.
    last: Option<Node>,
}

impl Holes<'_> {
    /// A row with its hole: as its cell names it, as the cell above, or by the one group of its diameter.
    fn with_hole(&mut self, mut route: Vec<(Key, Node)>) -> Vec<(Key, Node)> {
        let number = |route: &[(Key, Node)], key: &str| {
            let (_, node) = route.iter().find(|(own, _)| own.text == key)?;
            node.text()?.replace(',', ".").parse::<f64>().ok().filter(|value| *value > 0.0)
        };
        let own = route.iter().position(|(key, _)| key.text == "hole").map(|at| route.remove(at).1);
        let text = |node: &Node| node.text().unwrap_or_default().to_owned();
        let diameter = number(&route, "diameter");
        let depth = number(&route, "depth");
        if own.is_some() {
            self.last.clone_from(&own);
        }
        let named = own.or_else(|| self.last.clone());
        let node = match (self.part, named) {
            (Some(part), Some(node)) => Some(scalar(&hole(&text(&node), Some(part)), &node.place)),
            (Some(part), None) => {
                let only = part.holes.first().filter(|_| part.holes.len() == 1).map(|hole| hole.name.clone());
                let name = only.or_else(|| diameter.and_then(|size| of_size(size, part)));
                route.first().zip(name).map(|((_, first), name)| scalar(&name, &first.place))
            }
            (None, named) => {
                let place = named.as_ref().or(route.first().map(|(_, node)| node)).map(|node| node.place.clone());
                let name = named.map(|node| text(&node)).or_else(|| diameter.map(|size| format!("Ø{size}")));
                self.make(name.as_deref(), diameter, depth);
                place.zip(name).map(|(place, name)| scalar(&name, &place))
            }
        };
        // A diameter that only the cell of the hole names.
        let is_made = self.part.is_none() && diameter.is_none();
        if let Some((size, node)) = node.as_ref().and_then(|node| Some((size(node.text()?)?, node))).filter(|_| is_made)
        {
            route.push(entry("diameter", scalar(&size.to_string(), &node.place)));
        }
        route.extend(node.map(|node| entry("hole", node)));
        route
    }

    fn make(&mut self, name: Option<&str>, diameter: Option<f64>, depth: Option<f64>) {
        let Some(name) = name else { return };
        // A bare number beside a diameter numbers the hole.
        let is_number = name.bytes().all(|sign| sign.is_ascii_digit());
        let said = cells::diameter(name).filter(|_| diameter.is_none() || !is_number);
        let size_of = |text: &str| cells::size(text).unwrap_or_default();
        match self.made.iter_mut().find(|(known, ..)| known == name) {
            Some((_, own, deepest)) => {
                if let Some(wider) = diameter.filter(|size| said.is_none() && *size > size_of(own)) {
                    *own = format!("{wider}H14");
                }
                *deepest = deepest.max(depth.unwrap_or_default());
            }
            None => {
                let own =
                    said.or_else(|| diameter.map(|size| format!("{size}H14"))).unwrap_or_else(|| "10H14".to_owned());
                self.made.push((name.to_owned(), own, depth.unwrap_or_default()));
            }
        }
    }

    /// A part that has these holes and nothing else.
    fn part(&self, said: &[(Column, Node)], place: &Place) -> Node {
        let width = |own: &str| size(own).unwrap_or(10.0);
        let widest = self.made.iter().map(|(_, own, _)| width(own)).fold(10.0, f64::max);
        let deepest = self.made.iter().map(|(.., depth)| *depth).fold(10.0, f64::max);
        let pitch = (widest * 3.0).ceil();
        let length = pitch * (self.made.len().max(1) as f64 + 1.0);
        let hole = |(at, (name, own, depth)): (usize, &(String, String, f64))| MadeHole {
            name: name.clone(),
            diameter: own.clone(),
            depth: if *depth > 0.0 { *depth } else { width(own).min(deepest) },
            at: vec![[pitch * (at as f64 + 1.0) - length / 2.0, 0.0]],
        };
        let mut holes: Vec<MadeHole> = self.made.iter().enumerate().map(hole).collect();
        if holes.is_empty() {
            holes.push(hole((0, &("A".to_owned(), "10H14".to_owned(), 0.0))));
        }
        let blank = [length, pitch * 2.0, deepest.max(widest) * 2.0 + 20.0];
        let said = |key: &str| {
            let mut own = said.iter().filter(|(column, _)| column.of == Of::Part && column.key == key);
            own.next().map(|(_, node)| node.clone())
        };
        made::part(&place.file, &holes, blank, said, place)
    }
}
