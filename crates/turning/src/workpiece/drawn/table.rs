//! Tables of points: CSV with a heading.

use std::sync::Arc;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Key, Node};
use crate::turning::reading::{Reader, mistake};
use crate::units::Micrometres;

use super::{Waypoint, scalar};
use crate::turning::workpiece::item_file::{ArcItem, FaceItem, Surface};

/// A column of a table of points.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Column {
    /// `d` or `x`: the diameter, as X of lathes is.
    Diameter,
    /// `r`: the radius.
    Radius,
    Z,
    /// `radius` and `bulge` of the arc that leads to the point.
    ArcRadius,
    Bulge,
    /// An attribute of the surface that leads to the point.
    Attribute(&'static str),
}

/// The columns that a table may have.
fn columns() -> Vec<(&'static str, Column)> {
    let attributes = FaceItem::ATTRIBUTES.map(|key| (key.name(), Column::Attribute(key.name())));
    let own = [
        ("d", Column::Diameter),
        ("x", Column::Diameter),
        ("r", Column::Radius),
        ("z", Column::Z),
        (ArcItem::radius.name(), Column::ArcRadius),
        (ArcItem::bulge.name(), Column::Bulge),
    ];
    own.into_iter().chain(attributes).collect()
}

/// A cell with its place.
struct Cell<'t> {
    text: &'t str,
    place: Place,
}

/// The cells of a line; its number is from 1.
fn cells<'t>(line: &'t str, separator: char, number: usize, file: &Arc<str>) -> Vec<Cell<'t>> {
    let mut column = 1;
    let mut cells = Vec::new();
    for raw in line.split(separator) {
        let before = raw.chars().take_while(|letter| letter.is_whitespace()).count();
        let text = raw.trim().trim_matches('"').trim();
        let width = u32::try_from(raw.trim().chars().count()).unwrap_or(u32::MAX).max(1);
        let at = u32::try_from(column + before).unwrap_or(u32::MAX);
        let line = u32::try_from(number).unwrap_or(u32::MAX);
        cells.push(Cell { text, place: Place { file: file.clone(), line, column: at, width } });
        column += raw.chars().count() + 1;
    }
    cells
}

impl Reader<'_> {
    /// The points of a table; its first line names the columns.
    pub(super) fn table(&mut self, file: &Arc<str>, text: &str, named: &Place) -> Option<Vec<Waypoint>> {
        let text = text.trim_start_matches('\u{feff}');
        let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
        let Some((number, heading)) = lines.next() else { return self.fault(mistake!("points-empty"), named) };
        let separator = [';', '\t'].into_iter().find(|one| heading.contains(*one)).unwrap_or(',');
        let known = columns();
        let mut order = Vec::new();
        for cell in cells(heading, separator, number, file) {
            let name = cell.text.to_lowercase();
            match known.iter().find(|(known, _)| *known == name) {
                Some((_, column)) if order.contains(column) => {
                    return self.fault(mistake!("points-column-twice", column = name), &cell.place);
                }
                Some((_, column)) => order.push(*column),
                None => {
                    let known = known.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ");
                    return self.fault(mistake!("points-column-unknown", column = name, known = known), &cell.place);
                }
            }
        }
        let across = order.iter().filter(|one| matches!(one, Column::Diameter | Column::Radius)).count();
        if across != 1 || !order.contains(&Column::Z) {
            let place = Place { file: file.clone(), line: u32::try_from(number).unwrap_or(1), column: 1, width: 1 };
            return self.fault(mistake!("points-columns-lack"), &place);
        }
        let mut points = Vec::new();
        for (number, line) in lines {
            points.push(self.row(&order, cells(line, separator, number, file), separator)?);
        }
        let of_way = |first: &Waypoint| match (&first.arc, first.attributes.first()) {
            (Some((radius, _)), _) => Some(radius.place.clone()),
            (None, Some((key, _))) => Some(key.place.clone()),
            (None, None) => None,
        };
        if let Some(place) = points.first().and_then(of_way) {
            return self.fault(mistake!("points-first-of-nothing"), &place);
        }
        Some(points)
    }

    fn row(&mut self, order: &[Column], cells: Vec<Cell<'_>>, separator: char) -> Option<Waypoint> {
        let place = cells.first().map(|cell| cell.place.clone())?;
        if cells.len() != order.len() {
            return self.fault(mistake!("points-row-length", has = cells.len(), wants = order.len()), &place);
        }
        let (mut d, mut z, mut radius, mut bulge, mut attributes) = (None, None, None, None, Vec::new());
        for (column, cell) in order.iter().zip(cells) {
            // Where cells are parted by semicolons, spreadsheets write a decimal comma.
            let number = || if separator == ',' { cell.text.to_owned() } else { cell.text.replace(',', ".") };
            let number = || scalar(number(), &cell.place);
            match column {
                Column::Diameter => d = Some(number()),
                Column::Radius => {
                    let node = number();
                    let doubled = self.problems.scalar::<Micrometres>(&node)?;
                    let doubled = Micrometres::new(doubled.micrometres().saturating_mul(2));
                    d = Some(scalar(doubled.to_string(), &cell.place));
                }
                Column::Z => z = Some(number()),
                _ if cell.text.is_empty() => {}
                Column::ArcRadius => radius = Some(number()),
                Column::Bulge => bulge = Some(scalar(cell.text.to_lowercase(), &cell.place)),
                Column::Attribute(name) => {
                    let key = Key { text: (*name).to_owned(), place: cell.place.clone() };
                    attributes.push((key, scalar(cell.text.to_owned(), &cell.place)));
                }
            }
        }
        let arc = match (radius, bulge) {
            (Some(radius), Some(bulge)) => Some((radius, bulge)),
            (None, None) => None,
            (Some(one), None) | (None, Some(one)) => return self.fault(mistake!("points-arc-half"), &one.place),
        };
        let (d, z): (Node, Node) = (d?, z?);
        Some(Waypoint { place, d, z, arc, attributes })
    }
}
