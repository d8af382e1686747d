//! Polylines of drawings in ASCII DXF: `LWPOLYLINE`, and `POLYLINE` with its `VERTEX`es. Of the format nothing else is read: pairs of
//! lines, a group code and its value (Autodesk's DXF reference: 8 is the layer, 10 and 20 are X and Y, 42 is the bulge, 70 has flags,
//! of which 1 closes a polyline; `$INSUNITS` 4 is millimetres, 0 nothing said).

use std::sync::Arc;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Node;
use crate::turning::contour::Side;
use crate::turning::reading::{Reader, mistake};
use crate::units::{Micrometres, round_to};

use super::{Waypoint, scalar};
use crate::turning::workpiece::file::DrawnFile;

/// A vertex, mm as drawn, with the bulge of what leads on from it: the tangent of a quarter of the angle of the arc, positive
/// counterclockwise.
#[derive(Clone, Copy, Debug, Default)]
struct Vertex {
    x: f64,
    y: f64,
    bulge: f64,
    line: u32,
}

#[derive(Debug, Default)]
struct Polyline {
    layer: String,
    closed: bool,
    vertices: Vec<Vertex>,
}

#[derive(Debug, Default)]
struct Drawing {
    /// Whether its unit is said, and is not the millimetre.
    other_units: bool,
    polylines: Vec<Polyline>,
}

/// The polylines of a drawing.
///
/// # Errors
/// The line that is no group code.
fn read(text: &str) -> Result<Drawing, u32> {
    let mut drawing = Drawing::default();
    let (mut entity, mut variable, mut at_vertex) = (String::new(), String::new(), false);
    let mut lines = (1_u32..).zip(text.lines());
    while let Some((number, code)) = lines.next() {
        let code: i32 = code.trim().parse().map_err(|_| number)?;
        let Some((line, value)) = lines.next() else { break };
        let value = value.trim();
        if code == 0 {
            value.clone_into(&mut entity);
            at_vertex = value == "VERTEX";
            if matches!(value, "LWPOLYLINE" | "POLYLINE") {
                drawing.polylines.push(Polyline::default());
            }
            continue;
        }
        if code == 9 {
            value.clone_into(&mut variable);
        }
        if code == 70 && entity == "SECTION" && variable == "$INSUNITS" {
            drawing.other_units = !matches!(value, "0" | "4");
        }
        let light = entity == "LWPOLYLINE";
        let Some(polyline) = drawing.polylines.last_mut().filter(|_| light || at_vertex || entity == "POLYLINE") else {
            continue;
        };
        let number = || value.parse::<f64>().ok().filter(|number| number.is_finite()).ok_or(line);
        match code {
            8 if !at_vertex => value.clone_into(&mut polyline.layer),
            70 if !at_vertex => polyline.closed = value.parse::<i64>().is_ok_and(|flags| flags % 2 == 1),
            10 if light || at_vertex => polyline.vertices.push(Vertex { x: number()?, line, ..Vertex::default() }),
            20 | 42 if light || at_vertex => {
                if let Some(vertex) = polyline.vertices.last_mut() {
                    *(if code == 20 { &mut vertex.y } else { &mut vertex.bulge }) = number()?;
                }
            }
            _ => {}
        }
    }
    drawing.polylines.retain(|polyline| polyline.vertices.len() > 1);
    Ok(drawing)
}

/// From the other end: what led to a vertex leads on from it, the other way round.
fn reversed(vertices: &[Vertex]) -> Vec<Vertex> {
    let before = vertices.iter().rev().skip(1).map(|vertex| -vertex.bulge).chain([0.0]);
    vertices.iter().rev().zip(before).map(|(vertex, bulge)| Vertex { bulge, ..*vertex }).collect()
}

impl Reader<'_> {
    /// The points of `dxf:`: the one polyline of a layer, the half-section over the axis, with the free end at the right.
    pub(super) fn polyline(&mut self, node: &Node, side: Side) -> Option<Vec<Waypoint>> {
        let mut fields = self.problems.map::<DrawnFile>(node)?;
        let file = fields.need(DrawnFile::dxf, &mut self.problems);
        let layer = fields.take(DrawnFile::layer).and_then(|node| self.name(node));
        let zero = match fields.take(DrawnFile::zero) {
            Some(node) => self.zero(node),
            None => Some((0.0, 0.0)),
        };
        fields.finish(&mut self.problems);
        let named = file?;
        let (file, text) = self.drawing(named)?;
        let (x0, y0) = zero?;
        let drawing = match read(&text) {
            Ok(drawing) => drawing,
            Err(line) => {
                let place = Place { file, line, column: 1, width: 1 };
                return self.fault(mistake!("dxf-not-read"), &place);
            }
        };
        if drawing.other_units {
            return self.fault(mistake!("dxf-other-units"), &named.place);
        }
        let mut layers: Vec<&str> = drawing.polylines.iter().map(|polyline| polyline.layer.as_str()).collect();
        layers.sort_unstable();
        layers.dedup();
        let of_layer = |one: &&Polyline| layer.as_ref().is_none_or(|layer| one.layer == *layer);
        let own: Vec<&Polyline> = drawing.polylines.iter().filter(of_layer).collect();
        let layers = layers.join(", ");
        let [polyline] = own.as_slice() else {
            let code = if own.is_empty() { "dxf-no-polyline" } else { "dxf-many-polylines" };
            return self.fault(mistake!(code, count = own.len(), layers = layers), &named.place);
        };
        if polyline.closed {
            return self.fault(mistake!("dxf-closed"), &named.place);
        }
        let ends = polyline.vertices.first().zip(polyline.vertices.last());
        let turned = ends.is_some_and(|(first, last)| last.x > first.x);
        let vertices = if turned { reversed(&polyline.vertices) } else { polyline.vertices.clone() };
        let mut points: Vec<Waypoint> = Vec::new();
        let mut last: Option<(Micrometres, Micrometres, Vertex)> = None;
        for vertex in vertices {
            let place = Place { file: Arc::clone(&file), line: vertex.line, column: 1, width: 1 };
            let (d, z) =
                (Micrometres::from_mm_rounded(2.0 * (vertex.y - y0)), Micrometres::from_mm_rounded(vertex.x - x0));
            let arc = match last {
                // Nothing between them but rounding.
                Some((d_before, z_before, _)) if (d_before, z_before) == (d, z) => {
                    last = Some((d, z, vertex));
                    continue;
                }
                Some((.., from)) => self.arc_of(from, vertex, side, &place)?,
                None => None,
            };
            let (d_text, z_text) = (scalar(d.to_string(), &place), scalar(z.to_string(), &place));
            points.push(Waypoint { place, d: d_text, z: z_text, arc, attributes: Vec::new() });
            last = Some((d, z, vertex));
        }
        Some(points)
    }

    /// The point of the drawing that is the zero of the part.
    fn zero(&mut self, node: &Node) -> Option<(f64, f64)> {
        let cells = self.problems.list(node)?;
        let [x, y] = cells else { return self.fault(mistake!("dxf-zero-not-two"), &node.place) };
        let mut mm = |node: &Node| self.problems.scalar::<Micrometres>(node).map(Micrometres::to_mm);
        Some((mm(x)?, mm(y)?))
    }

    /// Radius and direction of the arc from a vertex to the next one: r = c·(1 + b²)/(4·|b|) with the chord c and the bulge b. From
    /// right to left a counterclockwise arc bulges upwards: out of the metal outside, into it in a bore. None for a line, and where
    /// the arc leaves it by less than half a micrometre.
    fn arc_of(&mut self, from: Vertex, to: Vertex, side: Side, place: &Place) -> Option<Option<(Node, Node)>> {
        let bulge = from.bulge;
        let chord = libm::hypot(to.x - from.x, to.y - from.y);
        if bulge.abs() * chord / 2.0 < 0.0005 {
            return Some(None);
        }
        let radius = Micrometres::from_mm_rounded(chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs()));
        if bulge.abs() > 1.000_001 {
            return self.fault(mistake!("dxf-arc-over-half", radius = radius, bulge = round_to(bulge, 3)), place);
        }
        let out = (bulge > 0.0) == (side == Side::Outer);
        let word = if out { "out" } else { "in" };
        Some(Some((scalar(radius.to_string(), place), scalar(word.to_owned(), place))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same polyline as R12 and as R2000, with another on its layer's neighbour.
    #[test]
    fn both_kinds_of_polylines_are_read() {
        let light = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nOUTER\n90\n3\n70\n0\n10\n0.0\n20\n0.0\n10\n0.0\n20\n10.0\n42\n0.5\n10\n-20.0\n20\n10.0\n0\nENDSEC\n0\nEOF\n";
        let heavy = "0\nPOLYLINE\n8\nOUTER\n66\n1\n70\n0\n10\n0.0\n20\n0.0\n0\nVERTEX\n8\nOUTER\n10\n0\n20\n0\n0\nVERTEX\n10\n0\n20\n10\n42\n0.5\n70\n0\n0\nVERTEX\n10\n-20\n20\n10\n0\nSEQEND\n";
        for text in [light, heavy] {
            let drawing = read(text).unwrap();
            let [polyline] = drawing.polylines.as_slice() else { panic!("{drawing:?}") };
            assert_eq!((polyline.layer.as_str(), polyline.closed, polyline.vertices.len()), ("OUTER", false, 3));
            let bulges: Vec<f64> = polyline.vertices.iter().map(|vertex| vertex.bulge).collect();
            assert_eq!(bulges, [0.0, 0.5, 0.0]);
            let back: Vec<f64> = reversed(&polyline.vertices).iter().map(|vertex| vertex.bulge).collect();
            assert_eq!(back, [-0.5, 0.0, 0.0]);
        }
        assert_eq!(read("AutoCAD Binary DXF\n").unwrap_err(), 1);
    }
}
