//! Contours that are given by points: in the file itself, in a table (CSV), or as a polyline of a drawing (DXF). They become the items
//! of a contour, each with the place of its point, and are read and checked as those are.

mod dxf;
mod table;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Key, Node, NodeKind, parse};
use crate::turning::contour::Side;
use crate::turning::reading::{Reader, mistake};
use crate::units::Micrometres;

use super::file::{DrawnFile, PointsFile, WorkpieceFile};
use super::item_file::{ArcItem, ConeItem, CylinderItem, FaceItem, FromItem, PointFile};

/// The texts of the files that contours name, by their names there.
#[derive(Clone, Debug, Default)]
pub struct Drawings(BTreeMap<String, Result<String, String>>);

impl Drawings {
    /// None.
    pub const NONE: Self = Self(BTreeMap::new());

    /// Adds a file: its text, or why it cannot be read.
    pub fn add(&mut self, name: &str, text: Result<String, String>) {
        self.0.insert(name.to_owned(), text);
    }
}

/// The files that the contours of a part name: tables of points and drawings. The library reads no file; who has them gives them to
/// [`super::read_turned_with`].
pub fn files_named(file: &str, text: &str) -> Vec<String> {
    let (root, _) = parse(file, text);
    let Some(root) = root else { return Vec::new() };
    let owners = [Some(&root), root.get(WorkpieceFile::blank.name())].into_iter().flatten();
    let contours = owners.flat_map(|owner| {
        [WorkpieceFile::outer.name(), WorkpieceFile::inner.name()].into_iter().filter_map(|key| owner.get(key))
    });
    let named = contours.flat_map(|contour| {
        [PointsFile::points.name(), DrawnFile::dxf.name()].into_iter().filter_map(|key| contour.get(key)?.text())
    });
    let mut named: Vec<String> = named.map(str::to_owned).collect();
    named.sort();
    named.dedup();
    named
}

/// A point of a contour, with the way to it.
struct Waypoint {
    place: Place,
    /// Diameter and Z as the file writes them.
    d: Node,
    z: Node,
    /// The radius of an arc that leads to it, and `in` or `out`.
    arc: Option<(Node, Node)>,
    /// Attributes of the surface that leads to it.
    attributes: Vec<(Key, Node)>,
}

impl Reader<'_> {
    /// The items of a contour that is given by its points; the node itself where it is a list of items.
    pub(super) fn drawn(&mut self, node: &Node, side: Side) -> Option<Node> {
        let points = match &node.kind {
            NodeKind::Map(_) if node.get(DrawnFile::dxf.name()).is_some() => self.polyline(node, side)?,
            NodeKind::Map(_) if node.get(PointsFile::points.name()).is_some() => self.points(node)?,
            _ => return Some(node.clone()),
        };
        Some(Node { kind: NodeKind::Seq(items(points)), place: node.place.clone() })
    }

    /// The points of `points:`, a list or the name of a table.
    fn points(&mut self, node: &Node) -> Option<Vec<Waypoint>> {
        let mut fields = self.problems.map::<PointsFile>(node)?;
        let points = fields.need(PointsFile::points, &mut self.problems);
        fields.finish(&mut self.problems);
        let points = points?;
        if points.text().is_some() {
            let (file, text) = self.drawing(points)?;
            return self.table(&file, &text, &points.place);
        }
        let rows = self.problems.list(points)?;
        let mut all = Vec::new();
        for row in rows {
            let NodeKind::Seq(cells) = &row.kind else {
                return self.fault(mistake!("point-not-two"), &row.place);
            };
            let [d, z] = cells.as_slice() else { return self.fault(mistake!("point-not-two"), &row.place) };
            let (d, z) = (d.clone(), z.clone());
            all.push(Waypoint { place: row.place.clone(), d, z, arc: None, attributes: Vec::new() });
        }
        Some(all)
    }

    /// The text of a file that a contour names, and its name for places.
    fn drawing(&mut self, node: &Node) -> Option<(Arc<str>, String)> {
        let name = self.problems.text(node)?.to_owned();
        match self.drawings.0.get(&name) {
            Some(Ok(text)) => Some((Arc::from(name), text.clone())),
            Some(Err(why)) => self.fault(mistake!("contour-file-unreadable", file = name, why = why), &node.place),
            None => self.fault(mistake!("contour-file-not-given", file = name), &node.place),
        }
    }
}

/// The items that lead from point to point: a face, a cylinder, a cone, or an arc.
fn items(points: Vec<Waypoint>) -> Vec<Node> {
    let mut items = Vec::new();
    let mut before: Option<(Node, Node)> = None;
    for Waypoint { place, d, z, arc, attributes } in points {
        let same = |one: &Node, other: &Node| {
            let of = |node: &Node| node.text().and_then(|text| text.parse::<Micrometres>().ok());
            of(one).is_some() && of(one) == of(other)
        };
        let point = map(&place, vec![(PointFile::d.name(), d.clone()), (PointFile::z.name(), z.clone())]);
        let mut entries = match (&before, arc) {
            (None, _) => vec![(FromItem::from.name(), point)],
            (_, Some((radius, bulge))) => {
                vec![(ArcItem::arc.name(), point), (ArcItem::radius.name(), radius), (ArcItem::bulge.name(), bulge)]
            }
            (Some((_, z_before)), None) if same(z_before, &z) => vec![(FaceItem::face.name(), d.clone())],
            (Some((d_before, _)), None) if same(d_before, &d) => vec![(CylinderItem::cylinder.name(), z.clone())],
            _ => vec![(ConeItem::cone.name(), point)],
        };
        let item = map(&place, std::mem::take(&mut entries));
        items.push(match item.kind {
            NodeKind::Map(mut keys) => {
                keys.extend(attributes);
                Node { kind: NodeKind::Map(keys), place: item.place }
            }
            _ => item,
        });
        before = Some((d, z));
    }
    items
}

fn map(place: &Place, entries: Vec<(&str, Node)>) -> Node {
    let keyed = entries.into_iter().map(|(key, node)| (Key { text: key.to_owned(), place: place.clone() }, node));
    Node { kind: NodeKind::Map(keyed.collect()), place: place.clone() }
}

fn scalar(text: String, place: &Place) -> Node {
    Node { kind: NodeKind::Scalar { text, quoted: false }, place: place.clone() }
}
